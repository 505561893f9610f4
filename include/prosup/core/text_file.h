#ifndef PROSUP_CORE_TEXT_FILE_H
#define PROSUP_CORE_TEXT_FILE_H

#include <filesystem>
#include <string>

namespace prosup {

/// Writes `text` to `file` and replaces its contents.
/// @throws Error if the file cannot be written.
void write_text_file(const std::string& text, const std::filesystem::path& file);

/// @throws Error always, with the message for a file that cannot be written.
[[noreturn]] void throw_cannot_write(const std::filesystem::path& file);

} // namespace prosup

#endif
