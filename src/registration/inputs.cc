#include "prosup/registration/inputs.h"

#include <algorithm>

#include "prosup/core/collective.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/parameters.h"
#include "prosup/core/text.h"
#include "prosup/image/broadcast.h"
#include "prosup/image/contrast.h"
#include "prosup/image/filters.h"
#include "prosup/similarity/similarity_parameters.h"

namespace prosup::registration {

using namespace dealii;
using image::LabelImage;
using image::ScalarImage;

namespace {

constexpr double largest_anisotropy = 1.05; // of voxels that are used as they are

/// What can be done about images of different modalities.
namespace contrast {
constexpr const char* as_given = "as given";
constexpr const char* prone_as_supine = "prone as supine";
constexpr const char* supine_as_prone = "supine as prone";
} // namespace contrast

/// Which transform of a NIfTI header counts.
namespace transform {
constexpr const char* must_agree = "must agree";
constexpr const char* sform = "sform";
constexpr const char* qform = "qform";
} // namespace transform

/// Median intensity of the voxels labelled air; the darkest one if there are none.
float air_intensity(const ScalarImage& image, const LabelImage& labels) {
  if (std::find(labels.values.begin(), labels.values.end(), 0) == labels.values.end())
    return *std::min_element(image.values.begin(), image.values.end());
  return image::median_intensity(image, labels, 0);
}

/// Adds what the image does not show to what is excluded from the similarity.
void exclude_unknown(const LabelImage& labels, unsigned unknown, LabelImage& excluded) {
  if (unknown == 0 ||
      std::find(labels.values.begin(), labels.values.end(), unknown) == labels.values.end())
    return;
  if (excluded.values.empty())
    excluded = LabelImage(labels.grid);
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    if (labels.values[v] == unknown)
      excluded.values[v] = 1;
}

} // namespace

void Inputs::align_supine(const image::RigidTransform& to_prone) {
  alignment = to_prone;
  for (image::VoxelGrid* grid :
       {&images.supine.grid, &scene.labels.supine.grid, &scene.excluded.supine.grid})
    *grid = to_prone(*grid);
}

InputReader::InputReader(const Labels& labels) : ParameterAcceptor("Images"), labels_(labels) {}

void InputReader::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter(
      "Voxel edge", voxel_edge_,
      "Anisotropic images are resampled to cubic voxels of this edge, or of their own "
      "shortest edge if that is longer. Units: mm.",
      Patterns::Double(0.01, 100.));
  prm.add_parameter("Low percentile", low_percentile_,
                    "Intensity inside the breast that becomes 0. Units: percent.",
                    Patterns::Double(0., 100.));
  prm.add_parameter("High percentile", high_percentile_,
                    "Intensity inside the breast that becomes 1. Units: percent.",
                    Patterns::Double(0., 100.));
  prm.add_parameter(
      "Contrast", contrast_,
      "Whether one image takes the contrast of the other, such as MR that of CT, so that they can "
      "be compared by differences: its fat and gland, as labelled, get the other's intensities by "
      "a linear map "
      "(paper, Fig. 4).",
      one_of({contrast::as_given, contrast::prone_as_supine, contrast::supine_as_prone}));
  prm.add_parameter(
      "NIfTI transform", nifti_transform_,
      "What places the voxels of a NIfTI file whose two transforms, sform and qform, differ by "
      "more "
      "than a tenth of a voxel somewhere: one of them, or 'must agree', which refuses such files.",
      one_of({transform::must_agree, transform::sform, transform::qform}));
}

image::NiftiTransform InputReader::nifti_transform() const {
  if (nifti_transform_ == transform::sform)
    return image::NiftiTransform::sform;
  return nifti_transform_ == transform::qform ? image::NiftiTransform::qform
                                              : image::NiftiTransform::must_agree;
}

double InputReader::isotropic_edge(const image::VoxelGrid& grid) const {
  const auto [shortest, longest] = std::minmax({grid.spacing[0], grid.spacing[1], grid.spacing[2]});
  return longest <= largest_anisotropy * shortest ? 0. : std::max(voxel_edge_, shortest);
}

void InputReader::prepare(const CaseFiles& files, Position position, Inputs& inputs,
                          Remarks& remarks) const {
  LabelImage labels = checked_labels(files, position, remarks);
  inputs.originals[position] = read_original(files, position, labels, remarks);
  const auto& [original, breast] = inputs.originals[position];
  const image::IntensityRange range =
      image::robust_range(original, breast, low_percentile_, high_percentile_);
  ScalarImage& scaled = inputs.images[position];
  scaled = image::rescale(original, range);
  const double edge = isotropic_edge(original.grid);
  if (edge > 0.) {
    scaled = image::resample_isotropic(scaled, edge);
    labels = image::resample_isotropic(labels, edge);
  }
  inputs.scene.air[position] = air_intensity(scaled, labels);
  LabelImage& excluded = inputs.scene.excluded[position];
  excluded = read_excluded(files, position, original, remarks);
  exclude_unknown(labels, labels_.unknown, excluded);
  inputs.scene.labels[position] = std::move(labels);
}

void InputReader::convert_contrast(Inputs& inputs) const {
  if (contrast_ == contrast::as_given)
    return;
  if (labels_.tissues.size() != 2 || labels_.gland == 0)
    throw Error("'Images/Contrast = " + contrast_ +
                "' needs the labels of fat and of gland, two 'Labels/Tissues' and 'Labels/Gland'; "
                "give them, or set 'Similarity/Metric' to " +
                joined(similarity::metric_names(true), " or ") + ", which needs none.");
  PerPosition<image::TissueIntensities> tissue;
  for (const Position position : both_positions) {
    const auto median = [&](unsigned label) {
      return image::median_intensity(inputs.images[position], inputs.scene.labels[position], label);
    };
    tissue[position] = {inputs.scene.air[position], median(labels_.fat()), median(labels_.gland)};
  }
  const Position changed =
      contrast_ == contrast::prone_as_supine ? Position::prone : Position::supine;
  inputs.images[changed] =
      image::convert_contrast(inputs.images[changed], inputs.scene.labels[changed], tissue[changed],
                              tissue[other(changed)]);
  inputs.scene.air[changed] = inputs.scene.air[other(changed)];
}

Inputs InputReader::read_pair(const CaseFiles& files, MPI_Comm communicator,
                              Remarks& remarks) const {
  Inputs inputs;
  inputs.scene.chest_label = labels_.chest;
  inputs.scene.gland_label = labels_.gland;
  inputs.scene.unknown_label = labels_.unknown;
  on_root(communicator, [&] {
    for (const Position position : both_positions)
      prepare(files, position, inputs, remarks);
    convert_contrast(inputs);
  });
  for (const Position position : both_positions) {
    image::broadcast(inputs.originals[position].image, communicator);
    image::broadcast(inputs.images[position], communicator);
    image::broadcast(inputs.scene.labels[position], communicator);
    image::broadcast(inputs.scene.excluded[position], communicator);
  }
  for (float* air : {&inputs.scene.air.prone, &inputs.scene.air.supine})
    MPI_Bcast(air, 1, MPI_FLOAT, 0, communicator);
  return inputs;
}

} // namespace prosup::registration
