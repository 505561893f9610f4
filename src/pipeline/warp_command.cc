#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/output_file.h"
#include "prosup/core/remarks.h"
#include "prosup/core/text.h"
#include "prosup/image/image_files.h"
#include "prosup/image/image_io.h"
#include "prosup/image/warp.h"
#include "prosup/output/surface_model.h"
#include "prosup/pipeline/commands.h"
#include "result_fields.h"
#include "state_map.h"

namespace prosup::pipeline {

using image::Interpolation;
using image::ScalarImage;

namespace {

/// The ending that tells the format of the output, an image in one file or a model.
std::string ending_of(const std::filesystem::path& file) {
  const std::string name = lower_case(file.filename().string());
  for (const char* ending : {".nii.gz", ".nii", ".nrrd", ".mha", ".vtp", ".stl", ".obj"})
    if (ends_with(name, ending))
      return ending;
  throw Error("The format of the output '" + file.string() +
              "' is not known; use .nii, .nii.gz, .nrrd or .mha for images and .vtp, .stl or .obj "
              "for models.");
}

void check(const WarpRequest& request) {
  if (request.from == request.to)
    throw Error("'--from' and '--to' are both '" + request.from +
                "', so that nothing would change; name two states.");
  const bool is_model = output::is_model(request.input);
  if (is_model != output::is_model(request.output))
    throw Error("'" + request.input.string() + "' and '" + request.output.string() +
                "' are a model and an image, which do not become each other; give two models or "
                "two images.");
  if (is_model && (request.labels || !request.like.empty() || !request.interpolation.empty()))
    throw Error("'--labels', '--like' and '--interpolation' are for images, but '" +
                request.input.string() + "' is a model; leave them out.");
  if (request.labels && !request.interpolation.empty() && request.interpolation != "nearest")
    throw Error("'--labels' takes the nearest voxel and not '--interpolation " +
                request.interpolation + "'; give one of the two.");
}

Interpolation interpolation(const WarpRequest& request, bool marks_regions, Remarks& remarks) {
  if (!request.interpolation.empty())
    return image::interpolation_of(request.interpolation);
  if (request.labels)
    return Interpolation::nearest;
  if (!marks_regions)
    return Interpolation::linear;
  remarks.add("The values of '" + request.input.string() +
              "' mark regions, so that it was carried as a label map, by the nearest voxel; give "
              "--interpolation if it is an image.");
  return Interpolation::nearest;
}

/// Labels are written as small integers if they are.
void write(const ScalarImage& image, bool are_labels, const std::filesystem::path& file) {
  const auto is_small_integer = [](float value) {
    return value >= 0.f && value <= 255.f && value == std::floor(value);
  };
  if (!are_labels || !std::all_of(image.values.begin(), image.values.end(), is_small_integer))
    return image::write_image(image, file);
  image::LabelImage labels(image.grid);
  std::transform(image.values.begin(), image.values.end(), labels.values.begin(),
                 [](float value) { return static_cast<std::uint8_t>(value); });
  image::write_labels(labels, file);
}

void warp_image(const WarpRequest& request, const std::filesystem::path& output, Remarks& remarks) {
  const ResultFields fields(request.result);
  const ScalarImage input = image::read_image(request.input, remarks);
  const bool marks_regions = request.labels || image::marks_regions(input);
  const Interpolation how = interpolation(request, marks_regions, remarks);
  const image::VectorImage back =
      request.like.empty() ? fields.field(request.to, request.from)
                           : fields.field_on(image::read_image(request.like, remarks).grid,
                                             request.to, request.from);
  const bool are_labels = how == Interpolation::nearest && marks_regions;
  // What was not imaged is air.
  const float outside =
      are_labels ? 0.f : *std::min_element(input.values.begin(), input.values.end());
  const ScalarImage warped = image::warp(input, back, how, outside);
  if (std::all_of(warped.values.begin(), warped.values.end(),
                  [&](float value) { return value == warped.values.front(); }))
    remarks.add("Nothing of '" + request.input.string() + "' is seen in the state '" + request.to +
                "': all voxels are alike; check that it lies in the space of the " + request.from +
                " image.");
  write(warped, are_labels, output);
}

/// In the mesh by its elements, as `map` does it, and outside by the field, with the chest at rest.
void warp_model(const WarpRequest& request, const std::filesystem::path& output, Remarks& remarks) {
  const ResultFields fields(request.result);
  const StateMap map(request.result, request.from, request.to);
  const image::VectorImage field = fields.field(request.from, request.to);
  const image::FieldSampler beside(field, fields.chest_motion(request.from, request.to));
  std::size_t n_outside = 0;
  const std::size_t n_points =
      output::move_model(request.input, output, [&](const dealii::Point<3>& point) {
        const MappedState mapped = map(point);
        n_outside += mapped.outside > evaluation::far_outside;
        return mapped.outside > 0. ? point + beside(point) : mapped.position;
      });
  if (n_outside > 0)
    remarks.add(format("%zu of %zu points of '%s' lie more than %g mm outside the mesh; they were "
                       "moved by the displacement field (docs/files.md).",
                       n_outside, n_points, request.input.string().c_str(),
                       evaluation::far_outside));
}

} // namespace

void run_warp(const WarpRequest& request) {
  OutputFileRules rules{{}, request.overwrite, "", {}, ending_of(request.output)};
  check(request);
  for (const auto& input : {request.input, request.like})
    for (const auto& part : image::files_of_image(input))
      rules.inputs.push_back(part);
  rules.inputs.push_back(request.input);
  Remarks remarks{Log(MPI_COMM_SELF)};
  OutputFile output(request.output, rules);
  if (output::is_model(request.input))
    warp_model(request, output.path(), remarks);
  else
    warp_image(request, output.path(), remarks);
  output.commit();
}

} // namespace prosup::pipeline
