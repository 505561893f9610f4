#include "image/nrrd_header.h"

#include "fuzz_target.h"
#include "image/segments.h"

namespace prosup::tests {

/// The text of an NRRD header, with the segments that it may name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  Remarks remarks;
  parse_or_refuse([&] {
    const auto header = image::parse_nrrd_header(text, "image.nrrd");
    image::n_data_bytes(header, "image.nrrd");
    image::nrrd_place(header, "image.nrrd", remarks);
    for (const image::Segment& segment : image::parse_segments(header, "image.nrrd"))
      image::kind_of_segment(segment.name);
  });
  require_sentences(remarks);
  return 0;
}

} // namespace prosup::tests
