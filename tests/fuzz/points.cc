#include "prosup/evaluation/points.h"
#include "fuzz_target.h"
#include "prosup/evaluation/landmarks.h"

namespace prosup::tests {

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
  });
  require_sentences(remarks);
  return 0;
}

} // namespace prosup::tests
