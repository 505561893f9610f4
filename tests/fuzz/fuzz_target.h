#ifndef PROSUP_TESTS_FUZZ_TARGET_H
#define PROSUP_TESTS_FUZZ_TARGET_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "prosup/core/error.h"
#include "prosup/core/remarks.h"
#include "temporary_folder.h"

namespace prosup::tests {

/// Ends the program, so that the input is kept, unless `message` is one sentence.
inline void require_sentence(const std::string& message) {
  const bool is_one = message.size() > 20 && message.back() == '.' &&
                      message.find('\n') == std::string::npos &&
                      message.find('\0') == std::string::npos;
  if (is_one)
    return;
  std::fprintf(stderr, "not one sentence: '%s'\n", message.c_str());
  std::abort();
}

/// Calls `parse`, which may refuse its input by an Error of one sentence; any other exception ends
/// the program.
template <typename Parse>
void parse_or_refuse(const Parse& parse) {
  try {
    parse();
  } catch (const Error& error) {
    require_sentence(error.what());
  } catch (const std::domain_error&) { // of a grid, which image::read_image() makes an Error of
  }
}

/// The same of all that was said.
inline void require_sentences(const Remarks& remarks) {
  for (const std::string& remark : remarks.all())
    require_sentence(remark);
}

/// A file with the bytes of the input, for parsers that read files; one for each name.
inline std::filesystem::path input_file(const std::string& name, const std::uint8_t* data,
                                        std::size_t size) {
  static const TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), std::streamsize(size));
  return folder / name;
}

} // namespace prosup::tests

#endif
