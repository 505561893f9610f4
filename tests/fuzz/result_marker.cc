#include "prosup/core/result_marker.h"

#include "fuzz_target.h"

namespace prosup::tests {

/// The list of the files that a result folder holds: it decides what may be removed.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto marker = ResultMarker::parse(text);
  if (!marker)
    return 0;
  for (const std::string& name : marker->names()) {
    const std::filesystem::path inside =
        ("/folder" / std::filesystem::path(name)).lexically_normal();
    if (inside.string().rfind("/folder/", 0) != 0)
      std::abort(); // a name that leads out of the folder
  }
  return 0;
}

} // namespace prosup::tests
