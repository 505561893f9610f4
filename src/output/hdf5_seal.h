#ifndef PROSUP_SRC_OUTPUT_HDF5_SEAL_H
#define PROSUP_SRC_OUTPUT_HDF5_SEAL_H

#include <filesystem>

namespace prosup::output {

/// Version of the layout of all files; older ones are not read.
constexpr unsigned hdf5_layout = 1;

/// Adds the checksum of a closed file to its end, and waits until the disk has it.
/// @throws Error if that fails.
void seal(const std::filesystem::path& file);

/// Whether a file ends with the checksum of what comes before.
bool is_whole(const std::filesystem::path& file);

/// Waits until the disk has the names in a folder, where the system can do that.
void synchronize_folder(const std::filesystem::path& folder);

} // namespace prosup::output

#endif
