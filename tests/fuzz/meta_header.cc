#include "image/meta_header.h"

#include "fuzz_target.h"
#include "image/meta_files.h"

namespace prosup::tests {

/// The text of a MetaImage header.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  Remarks remarks;
  parse_or_refuse([&] {
    const auto header = image::parse_meta_header(text, "image.mha", remarks);
    image::names_of_pattern(header.data_file);
  });
  require_sentences(remarks);
  return 0;
}

} // namespace prosup::tests
