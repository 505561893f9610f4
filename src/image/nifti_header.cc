#include "nifti_header.h"

#include <nifti1.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "nifti2_layout.h"
#include "nifti_values.h"
#include "prosup/core/error.h"

namespace prosup::image {

namespace {

/// A header of either kind as it is in the file, with its byte order.
template <typename Raw>
struct Fields {
  Fields(const unsigned char* bytes, bool in_other_order) : swapped(in_other_order) {
    std::memcpy(&raw, bytes, length);
  }

  /// A field in the order of this machine; by value, since fields may be unaligned.
  template <typename Number>
  Number operator()(Number value) const {
    unsigned char bytes[sizeof(Number)];
    std::memcpy(bytes, &value, sizeof(Number));
    if (swapped)
      std::reverse(bytes, bytes + sizeof(Number));
    std::memcpy(&value, bytes, sizeof(Number));
    return value;
  }

  static constexpr std::size_t length =
      std::is_same_v<Raw, nifti_1_header> ? sizeof(nifti_1_header) : nifti2_length;
  Raw raw{};
  bool swapped;
};

void set_offset(double offset, std::size_t length, NiftiHeader& header, const NiftiTeller& say) {
  constexpr double largest = 9e15; // up to which double holds integers
  if (!(offset >= 0.) || offset > largest || offset != std::floor(offset))
    say.refuse(format("says that the voxels begin at byte %g", offset));
  header.offset = static_cast<std::uint64_t>(offset);
  if (header.pair || header.offset >= length)
    return;
  const std::size_t usual = length + 4; // behind the flag that announces extensions
  if (header.offset != 0)
    say.refuse(format("says that the voxels begin at byte %ju, which is part of the header",
                      std::uintmax_t(header.offset)));
  say.doubt(format("does not say where the voxels begin; byte %zu was assumed", usual));
  header.offset = usual;
}

void set_unit(int units, NiftiHeader& header, const NiftiTeller& say) {
  switch (units & 7) { // the other bits are the unit of time
  case NIFTI_UNITS_METER:
    header.millimetres = 1e3;
    return;
  case NIFTI_UNITS_MICRON:
    header.millimetres = 1e-3;
    return;
  case NIFTI_UNITS_UNKNOWN: // usual, and mm is what everybody takes it for
  case NIFTI_UNITS_MM:
    return;
  default:
    say.doubt(format("has the unknown unit of length %d; mm was assumed", units & 7));
  }
}

/// The number that a field of NIfTI-1 stands for: the shortest one that the field could not hold
/// better. 0.7 is written as 0.699999988, of which a grid in other files knows nothing.
double meant(float value) {
  char digits[32];
  const auto [end, failure] = std::to_chars(digits, digits + sizeof(digits), value);
  double number = double(value);
  if (failure == std::errc() && std::isfinite(value))
    std::from_chars(digits, end, number);
  return number;
}
double meant(double value) {
  return value;
}

template <typename Raw>
void set_places(const Fields<Raw>& field, NiftiHeader& header) {
  const Raw& raw = field.raw;
  const auto number = [&](auto value) { return meant(field(value)); };
  header.qform_code = static_cast<int>(field(raw.qform_code));
  header.sform_code = static_cast<int>(field(raw.sform_code));
  header.qfac = number(raw.pixdim[0]) == -1. ? -1. : 1.;
  for (std::size_t d = 0; d < 3; ++d)
    header.pixdim[d] = number(raw.pixdim[d + 1]);
  header.quaternion = {number(raw.quatern_b), number(raw.quatern_c), number(raw.quatern_d)};
  header.qoffset = {number(raw.qoffset_x), number(raw.qoffset_y), number(raw.qoffset_z)};
  for (std::size_t d = 0; d < 4; ++d) {
    header.sform[0][d] = number(raw.srow_x[d]);
    header.sform[1][d] = number(raw.srow_y[d]);
    header.sform[2][d] = number(raw.srow_z[d]);
  }
}

template <typename Raw>
NiftiHeader header_of(const Fields<Raw>& field, bool pair, const NiftiTeller& say) {
  const Raw& raw = field.raw;
  NiftiHeader header;
  header.version = std::is_same_v<Raw, nifti_1_header> ? 1 : 2;
  header.pair = pair;
  header.values.swapped = field.swapped;
  std::array<std::int64_t, 8> dim{};
  for (std::size_t d = 0; d < 8; ++d)
    dim[d] = std::int64_t(field(raw.dim[d]));
  dim = checked_dimensions(dim, say);
  for (std::size_t d = 0; d < 3; ++d)
    header.size[d] = static_cast<std::size_t>(dim[d + 1]);
  set_type(field(raw.datatype), field(raw.bitpix), header.values, say);
  const std::uintmax_t n_components =
      saturated_product({header.values.n_components, std::uintmax_t(dim[5]), std::uintmax_t(dim[6]),
                         std::uintmax_t(dim[7])});
  header.values.n_components = unsigned(std::min<std::uintmax_t>(n_components, 1u << 20));
  set_scale(meant(field(raw.scl_slope)), meant(field(raw.scl_inter)), header.values, say);
  set_offset(double(field(raw.vox_offset)), field.length, header, say);
  set_unit(int(field(raw.xyzt_units)), header, say);
  set_places(field, header);
  return header;
}

std::int32_t first_number(const unsigned char* bytes, bool swapped) {
  std::int32_t number = 0;
  std::memcpy(&number, bytes, sizeof(number));
  return swapped ? static_cast<std::int32_t>(__builtin_bswap32(std::uint32_t(number))) : number;
}

constexpr std::size_t length_1 = sizeof(nifti_1_header), length_2 = nifti2_length;
static_assert(length_1 == 348 && length_2 == longest_nifti_header, "as the standard has them");

/// Whether the file says "ni1" or "n+1" where NIfTI-1 does.
bool has_magic_1(const unsigned char* bytes, std::size_t n_bytes) {
  if (n_bytes < length_1)
    return false;
  const unsigned char* magic = bytes + length_1 - 4;
  return magic[0] == 'n' && (magic[1] == 'i' || magic[1] == '+') && magic[2] == '1';
}

NiftiHeader parse_version_1(const unsigned char* bytes, const NiftiTeller& say) {
  bool swapped = first_number(bytes, true) == int(length_1);
  if (!swapped && first_number(bytes, false) != int(length_1)) {
    // The number of dimensions, 1 to 7, tells the byte order too.
    swapped = bytes[offsetof(nifti_1_header, dim)] == 0;
    say.doubt("has not the length of a header where it should begin with that; it was read as "
              "NIfTI-1");
  }
  const Fields<nifti_1_header> fields(bytes, swapped);
  return header_of(fields, fields.raw.magic[1] == 'i', say);
}

NiftiHeader parse_version_2(const unsigned char* bytes, std::size_t n_bytes,
                            const NiftiTeller& say) {
  if (n_bytes < length_2)
    throw Error("'" + say.file +
                "' is damaged or incomplete: it ends within its NIfTI header; "
                "copy it again.");
  const Fields<Nifti2Layout> fields(bytes, first_number(bytes, true) == int(length_2));
  const char* magic = fields.raw.magic;
  if (magic[0] != 'n' || (magic[1] != 'i' && magic[1] != '+') || magic[2] != '2')
    say.refuse("has the length of NIfTI-2, but is not marked as such");
  if (std::memcmp(magic + 4, "\r\n\032\n", 4) != 0)
    throw Error("'" + say.file +
                "' is damaged: it was copied as if it were text; copy it again, "
                "as it is.");
  return header_of(fields, magic[1] == 'i', say);
}

} // namespace

bool is_nifti(const unsigned char* bytes, std::size_t n_bytes) {
  if (n_bytes < 4)
    return false;
  if (has_magic_1(bytes, n_bytes))
    return true;
  for (const bool swapped : {false, true})
    for (const std::size_t length : {length_1, length_2})
      if (first_number(bytes, swapped) == int(length))
        return true;
  return false;
}

NiftiHeader parse_nifti_header(const unsigned char* bytes, std::size_t n_bytes,
                               const std::string& file, Remarks& remarks) {
  const NiftiTeller say{file, remarks};
  if (n_bytes < length_1)
    throw Error("'" + file +
                "' is damaged or incomplete: it ends within its NIfTI header; copy it "
                "again.");
  if (has_magic_1(bytes, n_bytes))
    return parse_version_1(bytes, say);
  for (const bool swapped : {false, true})
    if (first_number(bytes, swapped) == int(length_2))
      return parse_version_2(bytes, n_bytes, say);
  throw Error("'" + file +
              "' is an Analyze file, or NIfTI that is not marked as such, whose left "
              "and right may be exchanged; convert the image to NIfTI again.");
}

} // namespace prosup::image
