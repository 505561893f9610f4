#ifndef PROSUP_SRC_EVALUATION_TEXT_INPUT_H
#define PROSUP_SRC_EVALUATION_TEXT_INPUT_H

#include <filesystem>
#include <string>

#include "prosup/core/remarks.h"

namespace prosup::evaluation {

/// "file 'name', line 3": where a mistake is.
std::string where(const std::string& name, std::size_t line);

/// The contents of a file of points.
/// @throws Error if it cannot be read or is far too long to be a list of points.
std::string read_file(const std::filesystem::path& file);

/// `bytes` as UTF-8 without a byte order mark. Bytes that are not UTF-8 are taken as Latin-1, as
/// older spreadsheets write, and a remark is made.
/// @throws Error that names the file `name` if this is UTF-16 or no text.
std::string as_utf8(const std::string& bytes, const std::string& name, Remarks& remarks);

} // namespace prosup::evaluation

#endif
