#include "image/meta_header.h"

#include "fuzz_target.h"
#include "image/meta_files.h"

/// The text of a MetaImage header.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace prosup;
  const std::string text(reinterpret_cast<const char*>(data), size);
  Remarks remarks;
  tests::parse_or_refuse([&] {
    const auto header = image::parse_meta_header(text, "image.mha", remarks);
    image::names_of_pattern(header.data_file);
  });
  tests::require_sentences(remarks);
  return 0;
}
