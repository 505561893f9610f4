#include "byte_source.h"
#include "nifti_grid.h"
#include "prosup/core/error.h"
#include "volume.h"
#include "voxel_checks.h"

namespace prosup::image {

namespace fs = std::filesystem;

namespace {

/// The file with the voxels of a pair, which is named like its header.
fs::path voxel_file(const fs::path& header) {
  fs::path stem = header;
  if (stem.extension() == ".gz")
    stem.replace_extension();
  fs::path plain = stem.replace_extension(".img"), packed = plain;
  packed += ".gz";
  const bool has_plain = fs::is_regular_file(plain), has_packed = fs::is_regular_file(packed);
  if (has_plain == has_packed)
    throw Error("The voxels of '" + header.string() + "' are in a file of their own, and " +
                (has_plain ? "both of '" : "neither of '") + plain.string() + "' and '" +
                packed.string() + "' are there; keep the one that belongs to it.");
  return has_plain ? plain : packed;
}

/// The bytes of `file` behind the offset, once it is sure that there can be enough.
std::unique_ptr<ByteSource> voxel_bytes(const NiftiHeader& header, const fs::path& file) {
  const std::uintmax_t n_bytes = saturated_product(
      {header.size[0], header.size[1], header.size[2], header.values.bytes_per_voxel()});
  const std::uintmax_t found = fs::file_size(file);
  const auto holds = [&](std::uintmax_t n) {
    return n >= header.offset && n - header.offset >= n_bytes;
  };
  // Voxels without a header before them may begin like a gzip file by chance.
  const bool is_plain_pair =
      header.pair && file.extension() != ".gz" && holds(found) && !holds(found - 1);
  const bool is_packed = is_gzip(file) && !is_plain_pair;
  if (!holds(most_bytes(found, is_packed)))
    throw Error(format("'%s' is damaged or incomplete: its header asks for %ju bytes of voxels "
                       "behind byte %ju, but the file has %ju bytes%s; copy it again.",
                       file.string().c_str(), n_bytes, std::uintmax_t(header.offset), found,
                       is_packed ? ", which cannot be unpacked to so many" : ""));
  auto source = is_packed ? unpacked_bytes(file) : plain_bytes(file);
  source->skip(header.offset);
  return source;
}

} // namespace

std::vector<fs::path> nifti_voxel_files(const fs::path& header) {
  unsigned char bytes[longest_nifti_header];
  const std::size_t n_bytes = unpacked_bytes(header)->read(bytes, sizeof(bytes));
  Remarks untold;
  const bool is_pair = parse_nifti_header(bytes, n_bytes, header.string(), untold).pair;
  return {is_pair ? voxel_file(header) : header};
}

Volume read_nifti(const fs::path& file, unsigned n_components, NiftiTransform transform,
                  Remarks& remarks) {
  unsigned char bytes[longest_nifti_header];
  const std::size_t n_bytes = unpacked_bytes(file)->read(bytes, sizeof(bytes));
  const NiftiHeader header = parse_nifti_header(bytes, n_bytes, file.string(), remarks);
  check_components(header.values.n_components, n_components, file);
  check_size(header.size, file);
  Volume volume;
  volume.grid = nifti_grid(header, transform, file.string(), remarks);
  const fs::path voxels = header.pair ? voxel_file(file) : file;
  const auto source = voxel_bytes(header, voxels);
  volume.values =
      read_values(*source, header.values, volume.grid.n_voxels() * n_components, voxels);
  volume.step = header.values.step();
  // This also lets zlib compare the checksum at the end.
  if (source->read(bytes, 1) != 0)
    remarks.add("'" + voxels.string() +
                "' goes on behind the voxels that its header accounts for; "
                "what follows was ignored.");
  return volume;
}

} // namespace prosup::image
