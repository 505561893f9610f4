#ifndef PROSUP_CORE_TEXT_FILE_H
#define PROSUP_CORE_TEXT_FILE_H

#include <filesystem>
#include <string>

namespace prosup {

/// Writes `text` to `file`, replacing what was there. @throws Error if that fails.
void write_text_file(const std::string& text, const std::filesystem::path& file);

/// Throws the Error of a file that cannot be written.
[[noreturn]] void throw_cannot_write(const std::filesystem::path& file);

} // namespace prosup

#endif
