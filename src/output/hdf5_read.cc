#include "hdf5_errors.h"
#include "hdf5_handle.h"
#include "hdf5_seal.h"
#include "prosup/core/collective.h"
#include "prosup/core/log.h"
#include "prosup/output/hdf5_file.h"

namespace prosup::output {

namespace fs = std::filesystem;
using namespace dealii;

namespace {

/// Whether the file has a group or data set of this path.
bool has(hid_t file, const std::string& path) {
  const std::string parent = split_path(path).first;
  return (parent.empty() || has(file, parent)) && H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
}

herr_t add_data_set(hid_t id, const char* name, const H5L_info_t*, void* list) {
  const hid_t object = H5Oopen(id, name, H5P_DEFAULT);
  if (H5Iget_type(object) == H5I_DATASET)
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
  return H5Oclose(object);
}

herr_t add_attribute(hid_t, const char* name, const H5A_info_t*, void* list) {
  static_cast<std::vector<std::string>*>(list)->emplace_back(name);
  return 0;
}

} // namespace

struct Hdf5Reader::File {
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error("The file '" + name.string() + "' " + why + "; " + advice + ".");
  }

  /// Throws on all ranks if HDF5 failed on one.
  void check() const {
    on_every_rank(communicator, [&] {
      if (!errors.first().empty())
        refuse("cannot be read (HDF5: " + errors.first() + ")");
    });
  }

  template <typename Number>
  std::vector<Number> array(const std::string& path) const {
    if (!has(file->id(), path))
      refuse("lacks '" + path + "'");
    std::vector<Number> values;
    { // closed before check() throws
      HDF5::DataSet data = file->open_dataset(path);
      if (data.get_size() > 0)
        values = data.read<std::vector<Number>>();
    }
    check();
    return values;
  }

  template <typename Value>
  Value attribute(const std::string& path) const {
    const auto [group, leaf] = split_path(path);
    const char* const place = group.empty() ? "." : group.c_str();
    if ((!group.empty() && !has(file->id(), group)) ||
        H5Aexists_by_name(file->id(), place, leaf.c_str(), H5P_DEFAULT) <= 0)
      refuse("lacks '" + path + "'");
    const Value value = group.empty() ? file->get_attribute<Value>(leaf)
                                      : file->open_group(group).get_attribute<Value>(leaf);
    check();
    return value;
  }

  const fs::path name;
  const std::string advice;
  MPI_Comm communicator;
  Hdf5Errors errors{};
  std::unique_ptr<Hdf5Handle> file{};
};

Hdf5Reader::Hdf5Reader(const fs::path& file, const std::string& kind, MPI_Comm communicator,
                       const std::string& advice)
    : file_(new File{file, advice, communicator}) {
  on_root(communicator, [&] {
    if (!fs::is_regular_file(file))
      file_->refuse("does not exist");
    if (!is_whole(file))
      file_->refuse("is damaged or was not written by prosup (its checksum does not fit)");
  });
  file_->file = std::make_unique<Hdf5Handle>(file, Hdf5Handle::Mode::read, communicator);
  file_->check();
  if (const double layout = number("layout"); layout != hdf5_layout)
    file_->refuse(
        format("has the layout %g, but this version reads layout %u", layout, hdf5_layout));
  if (const std::string found = text("kind"); found != kind)
    file_->refuse("holds a " + found + " and no " + kind);
}

Hdf5Reader::~Hdf5Reader() = default;

std::vector<double> Hdf5Reader::doubles(const std::string& name) const {
  return file_->array<double>(name);
}

std::vector<float> Hdf5Reader::floats(const std::string& name) const {
  return file_->array<float>(name);
}

std::vector<unsigned> Hdf5Reader::integers(const std::string& name) const {
  return file_->array<unsigned>(name);
}

double Hdf5Reader::number(const std::string& name) const {
  return file_->attribute<double>(name);
}

std::string Hdf5Reader::text(const std::string& name) const {
  return file_->attribute<std::string>(name);
}

std::vector<std::string> Hdf5Reader::data_sets(const std::string& group) const {
  std::vector<std::string> names;
  if (has(file_->file->id(), group))
    H5Literate_by_name(file_->file->id(), group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr,
                       add_data_set, &names, H5P_DEFAULT);
  return names;
}

std::vector<std::string> Hdf5Reader::attributes(const std::string& group) const {
  std::vector<std::string> names;
  if (has(file_->file->id(), group))
    H5Aiterate_by_name(file_->file->id(), group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr,
                       add_attribute, &names, H5P_DEFAULT);
  return names;
}

} // namespace prosup::output
