#include "prosup/evaluation/points.h"
#include "evaluation/slicer_markups.h"
#include "evaluation/text_input.h"
#include "fuzz_target.h"
#include "prosup/evaluation/landmarks.h"

namespace prosup::tests {

/// Reads markups and writes them in their own format, which must be read as the same points again.
void require_round_trip(const std::string& text, Remarks& remarks) {
  const std::string utf8 = evaluation::as_utf8(text, "points", remarks);
  const auto points = evaluation::parse_mrk_json(utf8, "points", remarks);
  const std::string written = evaluation::mrk_json_like(utf8, "points", points);
  const auto again = evaluation::parse_mrk_json(written, "points", remarks);
  if (again.size() != points.size())
    std::abort();
  for (std::size_t p = 0; p < points.size(); ++p)
    if (again[p].id != points[p].id || again[p].position != points[p].position)
      std::abort();
}

/// Points in all three formats, and landmarks: the first byte chooses one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using evaluation::PointFormat;
  if (size == 0)
    return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const PointFormat formats[] = {PointFormat::csv, PointFormat::fcsv, PointFormat::mrk_json};
  Remarks remarks;
  parse_or_refuse([&] {
    if (data[0] % 4 == 3)
      evaluation::parse_landmarks(text, "landmarks.csv", remarks);
    else
      evaluation::parse_points(text, formats[data[0] % 4], "points", remarks);
    if (data[0] % 4 == 2)
      require_round_trip(text, remarks);
  });
  require_sentences(remarks);
  return 0;
}

} // namespace prosup::tests
