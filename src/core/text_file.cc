#include "prosup/core/text_file.h"

#include <fstream>

#include "prosup/core/error.h"

namespace prosup {

void write_text_file(const std::string& text, const std::filesystem::path& file) {
  std::ofstream stream(file, std::ios::binary);
  stream << text << std::flush;
  stream.close(); // where some file systems notice that they are full
  if (!stream)
    throw_cannot_write(file);
}

void throw_cannot_write(const std::filesystem::path& file) {
  throw Error("The file '" + file.string() +
              "' cannot be written; check that its folder exists, may be written to and has "
              "space left.");
}

} // namespace prosup
