#ifndef PROSUP_CORE_FILE_SYSTEM_H
#define PROSUP_CORE_FILE_SYSTEM_H

#include <filesystem>
#include <string>
#include <vector>

// What std::filesystem lacks.
namespace prosup {

/// Waits until a file is on the disk, which is where a full one shows at the latest.
/// @throws Error if it is not.
void flush_to_disk(const std::filesystem::path& file);

/// @throws Error if a relative path is given and the current folder is gone.
std::filesystem::path absolute_path(const std::filesystem::path& path);

/// The absolute path that a name leads to, through all links; what it names need not exist.
/// @throws Error if the links lead in a circle, or if there is no current folder.
std::filesystem::path without_links(const std::filesystem::path& path);

/// Name of a hidden file or folder in `folder` that belongs to `name`: `.NAME.incomplete`,
/// shortened where the file system does not allow names of that length. `ending` comes behind it.
std::string unfinished_name(const std::filesystem::path& folder, const std::string& name,
                            const std::string& ending = "");

/// Whether both are one file, also through links. False if one does not exist.
bool same_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// The first of `inputs` that is the same file as `output`; empty if none is.
std::filesystem::path input_at(const std::filesystem::path& output,
                               const std::vector<std::filesystem::path>& inputs);

} // namespace prosup

#endif
