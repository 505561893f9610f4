#include "nifti_values.h"

#include <nifti1.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace prosup::image {

namespace {

struct Kind {
  int code;
  NumberType type;
  unsigned n_components;
};

constexpr Kind kinds[] = {
    {DT_UINT8, NumberType::uint8, 1},       {DT_INT8, NumberType::int8, 1},
    {DT_INT16, NumberType::int16, 1},       {DT_UINT16, NumberType::uint16, 1},
    {DT_INT32, NumberType::int32, 1},       {DT_UINT32, NumberType::uint32, 1},
    {DT_INT64, NumberType::int64, 1},       {DT_UINT64, NumberType::uint64, 1},
    {DT_FLOAT32, NumberType::float32, 1},   {DT_FLOAT64, NumberType::float64, 1},
    {DT_RGB24, NumberType::uint8, 3},       {DT_RGBA32, NumberType::uint8, 4},
    {DT_COMPLEX64, NumberType::float32, 2}, {DT_COMPLEX128, NumberType::float64, 2}};

} // namespace

void set_type(int datatype, int bits, StoredValues& values, const NiftiTeller& say) {
  const auto* kind = std::find_if(std::begin(kinds), std::end(kinds),
                                  [&](const Kind& k) { return k.code == datatype; });
  if (kind == std::end(kinds))
    say.refuse(format("names data type %d%s", datatype,
                      datatype == DT_FLOAT128 || datatype == DT_COMPLEX256
                          ? " (numbers of 128 bits), which cannot be read"
                      : datatype == DT_BINARY ? " (bits), which cannot be read"
                                              : ", which is none for voxels"),
               "save the image as numbers of 8 to 64 bits");
  values.type = kind->type;
  values.n_components = kind->n_components;
  const auto expected = static_cast<int>(8 * values.bytes_per_voxel());
  if (bits != expected)
    say.doubt(format("gives %d bits to a voxel, but its data type %d has %d; the data type was "
                     "believed",
                     bits, datatype, expected));
}

void set_scale(double slope, double intercept, StoredValues& values, const NiftiTeller& say) {
  if (slope == 0. || std::isnan(slope)) { // the standard: values are as they are stored
    if (std::isfinite(intercept) && intercept != 0.)
      say.doubt(format("has the intercept %g beside the slope %g, which stands for no scaling; the "
                       "intercept was ignored",
                       intercept, slope));
    return;
  }
  if (!std::isfinite(slope))
    say.refuse("has an infinite slope, with which no voxel has a value");
  values.slope = slope;
  if (std::isfinite(intercept))
    values.intercept = intercept;
  else
    say.doubt(
        format("has the intercept %g beside the slope %g; it was taken as 0", intercept, slope));
}

std::array<std::int64_t, 8> checked_dimensions(const std::array<std::int64_t, 8>& dim,
                                               const NiftiTeller& say) {
  std::array<std::int64_t, 8> n{};
  n.fill(1);
  if (dim[0] < 1 || dim[0] > 7)
    say.refuse(format("says that it has %lld dimensions, where 1 to 7 are possible",
                      static_cast<long long>(dim[0])));
  for (int d = 1; d <= dim[0]; ++d) {
    const auto axis = static_cast<std::size_t>(d);
    if (dim[axis] < 1 && d <= 3)
      say.refuse(format("says that there are %lld voxels along axis %d, which must be positive",
                        static_cast<long long>(dim[axis]), d));
    n[axis] = std::max<std::int64_t>(dim[axis], 1);
  }
  if (dim[0] < 3)
    throw Error(format("'%s' has %d dimension%s, but a three-dimensional image is needed; convert "
                       "it to one volume.",
                       say.file.c_str(), int(dim[0]), dim[0] == 1 ? "" : "s"));
  if (n[4] > 1)
    throw Error(format("'%s' has 4 dimensions, with %lld volumes one after the other, but a "
                       "three-dimensional image is needed; extract the volume that is meant.",
                       say.file.c_str(), static_cast<long long>(n[4])));
  return n;
}

} // namespace prosup::image
