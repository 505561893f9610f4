// What the files of one breast hold, and whether they fit each other.

#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/image/segmentation.h"
#include "prosup/registration/inputs.h"

namespace prosup::registration {

using image::LabelImage;
using image::ScalarImage;

namespace {

/// No scan of a breast is outside of these bounds, mm, but one whose header has another unit is.
/// @throws Error
void check_extent(const image::VoxelGrid& grid, const std::string& file) {
  constexpr double least = 20., most = 3000.;
  for (unsigned d = 0; d < 3; ++d) {
    const double extent = double(grid.size[d]) * grid.spacing[d];
    if (extent < least || extent > most)
      throw Error(
          format("'%s' is %g mm long along axis %u (%zu voxels of %g mm), but an image that "
                 "holds a breast has %g to %g mm; check the unit of its header, or give "
                 "the whole volume.",
                 file.c_str(), extent, d + 1, grid.size[d], grid.spacing[d], least, most));
  }
}

/// Moves what was read of the supine breast by the offset of the case.
template <typename T>
image::VoxelImage<T> placed(image::VoxelImage<T> image, const CaseFiles& files, Position position) {
  if (position == Position::supine)
    image.grid.origin += files.supine_offset;
  return image;
}

} // namespace

LabelImage InputReader::checked_labels(const CaseFiles& files, Position position,
                                       Remarks& remarks) const {
  const std::string& file = files.labels[position];
  LabelImage labels = image::read_tissues(file, labels_, remarks, nifti_transform());
  check_extent(labels.grid, file);
  labels = placed(std::move(labels), files, position);
  if (std::all_of(labels.values.begin(), labels.values.end(),
                  [](std::uint8_t label) { return label == 0; }))
    throw Error("The label image '" + file +
                "' is empty: all its voxels are 0; it has to mark the "
                "chest wall, fat and gland.");
  image::require_regions(labels, file);
  image::require_label(labels, labels_.chest, "the chest wall ('Labels/Chest')", file);
  const LabelImage tissue = image::select_labels(labels, labels_.tissues);
  if (std::none_of(tissue.values.begin(), tissue.values.end(), [](auto v) { return v != 0; }))
    image::require_label(labels, labels_.tissues.front(), "breast tissue ('Labels/Tissues')", file);
  return labels;
}

OriginalImage InputReader::read_original(const CaseFiles& files, Position position,
                                         LabelImage& labels, Remarks& remarks) const {
  const std::string& file = files.images[position];
  ScalarImage image = placed(image::read_image(file, remarks, nifti_transform()), files, position);
  labels = image::fit_labels(std::move(labels), image, files.labels[position], file, remarks);
  if (const auto padding = image::replace_padding(image, labels))
    remarks.add(
        format("The value %g in %.0f %% of the air of '%s' was taken for padding beyond the "
               "field of view and replaced by the intensity %g of the other air.",
               padding->value, 100. * padding->share, file.c_str(), padding->air));
  // Islands of tissue in the air are no breast; air among the tissue would be its darkest part.
  return {std::move(image),
          image::largest_component(image::select_labels(labels, labels_.tissues))};
}

SingleInput InputReader::read_breast(const CaseFiles& files, Position position,
                                     Remarks& remarks) const {
  SingleInput input;
  input.labels = checked_labels(files, position, remarks);
  // A cropped label image ends where the image does not.
  if (!files.images[position].empty())
    input.original = read_original(files, position, input.labels, remarks);
  const double edge = isotropic_edge(input.labels.grid);
  if (edge > 0.)
    input.labels = image::resample_isotropic(input.labels, edge);
  return input;
}

LabelImage InputReader::read_excluded(const CaseFiles& files, Position position,
                                      const ScalarImage& image, Remarks& remarks) const {
  const std::string& file = files.excluded[position];
  if (file.empty())
    return {};
  LabelImage mask = image::read_mask(file, remarks, nifti_transform());
  check_extent(mask.grid, file);
  mask = image::fit_labels(placed(std::move(mask), files, position), image, file,
                           files.images[position], remarks);
  const double edge = isotropic_edge(mask.grid);
  return edge > 0. ? image::resample_isotropic(mask, edge) : mask;
}

} // namespace prosup::registration
