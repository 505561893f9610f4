#ifndef PROSUP_SRC_OUTPUT_HDF5_HANDLE_H
#define PROSUP_SRC_OUTPUT_HDF5_HANDLE_H

#include <deal.II/base/hdf5.h>

#include <filesystem>
#include <string>
#include <utility>

namespace prosup::output {

/// An open file for deal.II's interface, which it takes for a group. deal.II's own class opens
/// every file for writing, which a result that may not be written to does not allow and which
/// would cut off the checksum, and ends the program if it is destroyed while an exception is on
/// its way, though ours come on all ranks alike.
class Hdf5Handle : public dealii::HDF5::Group {
public:
  enum class Mode { create, read };

  /// Collective; so is the end of its life.
  Hdf5Handle(const std::filesystem::path& file, Mode mode, MPI_Comm communicator)
      : Group(file.string(), true) {
    hdf5_reference = std::shared_ptr<hid_t>(new hid_t(-1), [](hid_t* id) {
      if (*id >= 0)
        H5Fclose(*id);
      delete id;
    });
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fapl_mpio(access, communicator, MPI_INFO_NULL);
    *hdf5_reference = mode == Mode::create
                          ? H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)
                          : H5Fopen(file.c_str(), H5F_ACC_RDONLY, access);
    H5Pclose(access);
  }

  hid_t id() const { return *hdf5_reference; }
};

/// "a/b/c" as "a/b" and "c".
inline std::pair<std::string, std::string> split_path(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos)
    return {"", path};
  return {path.substr(0, slash), path.substr(slash + 1)};
}

} // namespace prosup::output

#endif
