#ifndef PROSUP_SRC_PIPELINE_MANUAL_H
#define PROSUP_SRC_PIPELINE_MANUAL_H

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace prosup::pipeline {

/// The manual page (section 1, roff) of a command of `program`, or of `program` itself: what --help
/// tells.
std::string manual_page(const CLI::App& program, const CLI::App& command);

/// The name of that page, such as "prosup-map".
std::string page_name(const CLI::App& program, const CLI::App& command);

/// A completion for bash of all commands, their options and the choices of these.
std::string bash_completion(const CLI::App& program);

/// Writes all pages of prosup to man1/ in `folder`, and its completion to completions/prosup.
/// @throws Error if a file cannot be written.
void write_manual(const std::filesystem::path& folder);

} // namespace prosup::pipeline

#endif
