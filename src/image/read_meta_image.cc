#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "byte_source.h"
#include "meta_files.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "regular_grid.h"
#include "volume.h"
#include "voxel_checks.h"

namespace prosup::image {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_text = 1u << 24; // of a header with a list of files

std::string beginning(const fs::path& file) {
  std::string text(std::min<std::uintmax_t>(fs::file_size(file), longest_text), '\0');
  text.resize(plain_bytes(file)->read(reinterpret_cast<unsigned char*>(text.data()), text.size()));
  return text;
}

/// One of the files with voxels: what of it is read.
class VoxelFile {
public:
  VoxelFile(const MetaHeader& header, const fs::path& file, std::uintmax_t n_numbers)
      : header_(header), file_(file), n_numbers_(n_numbers), length_(fs::file_size(file)),
        n_bytes_(saturated_product({n_numbers, header.values.bytes_per_number()})),
        offset_(offset()) {}

  void append(std::vector<float>& values, Remarks& remarks) const {
    check_length();
    if (!header_.is_binary)
      return append_text(values);
    const auto source =
        header_.is_packed ? inflated_bytes(file_, offset_) : plain_bytes(file_, offset_);
    std::vector<float> found = read_values(*source, header_.values, n_numbers_, file_);
    if (values.empty())
      values = std::move(found);
    else
      std::copy(found.begin(), found.end(), std::back_inserter(values));
    // This also lets zlib compare the checksum at the end.
    unsigned char next;
    if (source->read(&next, 1) != 0)
      remarks.add("'" + file_.string() +
                  "' goes on behind the voxels that its header accounts "
                  "for; what follows was ignored.");
  }

private:
  /// Where the voxels begin, as MetaIO has it.
  std::uintmax_t offset() const {
    if (header_.skipped > 0)
      return std::uintmax_t(header_.skipped);
    if (header_.skipped == 0)
      return header_.is_local() ? header_.length : 0;
    if (header_.is_packed && !header_.packed_size)
      throw Error("'" + file_.string() +
                  "' has HeaderSize = -1 but no CompressedDataSize, so that "
                  "nobody knows where its voxels begin; add one of them.");
    const std::uintmax_t n_stored = header_.is_packed ? *header_.packed_size : n_bytes_;
    return length_ - std::min(n_stored, length_);
  }

  void check_length() const {
    const std::uintmax_t found = length_ - std::min(offset_, length_);
    if (header_.is_packed && header_.packed_size && found < *header_.packed_size)
      refuse_incomplete(file_, found, *header_.packed_size);
    const std::uintmax_t most =
        header_.is_binary ? most_bytes(found, header_.is_packed) : saturated_product({found, 8});
    if (most < n_bytes_)
      refuse_incomplete(file_, header_.is_packed ? most : found, n_bytes_);
  }

  void append_text(std::vector<float>& values) const {
    std::string text(length_ - std::min(offset_, length_), '\0');
    plain_bytes(file_, offset_)->read(reinterpret_cast<unsigned char*>(text.data()), text.size());
    const std::size_t n_wanted = values.size() + n_numbers_;
    const char* last = text.data() + text.size();
    for (const char* next = text.data(); values.size() < n_wanted;) {
      while (next != last && (*next == ' ' || *next == '\n' || *next == '\r' || *next == '\t'))
        ++next;
      double number = 0.;
      const auto [end, error] = std::from_chars(next, last, number);
      if (next == last || error != std::errc())
        throw Error(format("'%s' is damaged or incomplete: number %zu of its voxels is none; copy "
                           "it again.",
                           file_.string().c_str(), values.size() + 1));
      next = end;
      values.push_back(
          static_cast<float>(header_.values.slope * number + header_.values.intercept));
    }
  }

  const MetaHeader& header_;
  const fs::path& file_;
  const std::uintmax_t n_numbers_, length_, n_bytes_, offset_;
};

std::vector<fs::path> files_of(const MetaHeader& header, const std::string& text,
                               const fs::path& file) {
  return voxel_files(header, header.is_local() ? "" : text.substr(header.length), file);
}

} // namespace

std::vector<fs::path> meta_voxel_files(const fs::path& header) {
  const std::string text = beginning(header);
  Remarks untold;
  return files_of(parse_meta_header(text, header.string(), untold), text, header);
}

Volume read_meta_image(const fs::path& file, unsigned n_components, Remarks& remarks) {
  const std::string text = beginning(file);
  const MetaHeader header = parse_meta_header(text, file.string(), remarks);
  check_components(header.values.n_components, n_components, file);
  check_size(header.size, file);
  Volume volume;
  volume.grid.size = header.size;
  volume.grid.origin = header.origin;
  volume.grid.spacing = header.spacing;
  volume.grid.direction = header.direction;
  make_orthonormal(volume.grid.direction);
  volume.step = header.values.step();
  const std::vector<fs::path> files = files_of(header, text, file);
  const std::uintmax_t n_numbers = volume.grid.n_voxels() * n_components;
  for (const fs::path& data : files)
    VoxelFile(header, data, n_numbers / files.size()).append(volume.values, remarks);
  return volume;
}

} // namespace prosup::image
