#include <deal.II/base/mpi.h>
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <set>

#include "hdf5_errors.h"
#include "hdf5_handle.h"
#include "hdf5_seal.h"
#include "prosup/core/collective.h"
#include "prosup/core/temporary_name.h"
#include "prosup/output/hdf5_file.h"

namespace prosup::output {

namespace fs = std::filesystem;
using namespace dealii;

namespace {

constexpr std::uintmax_t room_for_names = 1 << 16; // bytes

/// Makes an empty file on a disk that has room for it: HDF5 and MPI say less about a full one, and
/// MPI prints it.
void make_room(const fs::path& file, std::uintmax_t n_bytes) {
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  int error = descriptor < 0 ? errno : posix_fallocate(descriptor, 0, static_cast<off_t>(n_bytes));
  if (error == 0 && ftruncate(descriptor, 0) != 0)
    error = errno;
  if (descriptor >= 0)
    close(descriptor);
  if (error != 0)
    throw Error("The file '" + file.string() + "' cannot be written (" + std::strerror(error) +
                "); check its folder and the free space of its disk.");
}

} // namespace

/// Everything is collected first, so that no file is open when something else fails.
struct Hdf5Writer::File {
  /// The group of a path, made if it is new.
  HDF5::Group group(const HDF5::Group& file, const std::string& path) {
    if (path.empty())
      return file;
    if (!groups.insert(path).second)
      return file.open_group(path);
    const auto [parent, leaf] = split_path(path);
    return group(file, parent).create_group(leaf);
  }

  template <typename Number>
  void rows(const std::string& name, const std::vector<Number>& mine, unsigned n_columns) {
    const unsigned long long n_mine = mine.size() / n_columns;
    unsigned long long n_before = 0;
    MPI_Exscan(&n_mine, &n_before, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, communicator);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      n_before = 0;
    const unsigned long long n_all = Utilities::MPI::sum(n_mine, communicator);
    n_bytes += n_all * n_columns * sizeof(Number);
    std::vector<hsize_t> all{n_all}, offset{n_before}, count{n_mine};
    if (n_columns > 1) {
      all.push_back(n_columns);
      offset.push_back(0);
      count.push_back(n_columns);
    }
    parts.push_back([=](const HDF5::Group& file) {
      const auto [parent, leaf] = split_path(name);
      HDF5::DataSet data = group(file, parent).create_dataset<Number>(leaf, all);
      if (n_all == 0)
        return;
      if (n_mine > 0)
        data.write_hyperslab(mine, offset, count);
      else
        data.write_none<Number>();
    });
  }

  template <typename Value>
  void attribute(const std::string& name, const Value& value) {
    n_bytes += 256;
    parts.push_back([=](const HDF5::Group& file) {
      const auto [parent, leaf] = split_path(name);
      group(file, parent).set_attribute(leaf, value);
    });
  }

  const fs::path target, temporary;
  MPI_Comm communicator;
  std::uintmax_t n_bytes = room_for_names;
  std::set<std::string> groups{};
  std::vector<std::function<void(const HDF5::Group&)>> parts{};
};

Hdf5Writer::Hdf5Writer(const fs::path& file, const std::string& kind, MPI_Comm communicator)
    : file_(new File{file, file.parent_path() / ("." + file.filename().string() + ".part"),
                     communicator}) {
  number("layout", hdf5_layout);
  text("kind", kind);
}

Hdf5Writer::~Hdf5Writer() = default;

void Hdf5Writer::rows(const std::string& name, const std::vector<double>& mine,
                      unsigned n_columns) {
  file_->rows(name, mine, n_columns);
}

void Hdf5Writer::rows(const std::string& name, const std::vector<float>& mine, unsigned n_columns) {
  file_->rows(name, mine, n_columns);
}

void Hdf5Writer::rows(const std::string& name, const std::vector<unsigned>& mine,
                      unsigned n_columns) {
  file_->rows(name, mine, n_columns);
}

void Hdf5Writer::number(const std::string& name, double value) {
  file_->attribute(name, value);
}

void Hdf5Writer::text(const std::string& name, const std::string& value) {
  file_->n_bytes += value.size();
  file_->attribute(name, value);
}

void Hdf5Writer::commit() {
  const fs::path &temporary = file_->temporary, &target = file_->target;
  const TemporaryName name(temporary, target);
  try {
    on_root(file_->communicator, [&] { make_room(temporary, file_->n_bytes); });
    Hdf5Errors errors;
    {
      const Hdf5Handle handle(temporary, Hdf5Handle::Mode::create, file_->communicator);
      for (const auto& write : file_->parts)
        write(handle);
    }
    on_every_rank(file_->communicator, [&] {
      if (!errors.first().empty())
        throw Error("The file '" + target.string() + "' cannot be written (HDF5: " +
                    errors.first() + "); check the free space of its disk.");
    });
    on_root(file_->communicator, [&] {
      seal(temporary);
      std::error_code error;
      fs::rename(temporary, target, error);
      if (error)
        throw Error("The file '" + target.string() + "' cannot be replaced: " + error.message() +
                    ".");
      synchronize_folder(target.parent_path());
    });
  } catch (const Error&) {
    std::error_code ignored;
    if (Utilities::MPI::this_mpi_process(file_->communicator) == 0)
      fs::remove(temporary, ignored);
    throw;
  }
}

} // namespace prosup::output
