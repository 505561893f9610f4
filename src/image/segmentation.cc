#include "prosup/image/segmentation.h"

#include <algorithm>

#include "axis_order.h"
#include "file_formats.h"
#include "in_words.h"
#include "nrrd_file.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"
#include "segment_labels.h"
#include "volume.h"

namespace prosup::image {

namespace {

/// The segments of `file` if it is a segmentation of 3D Slicer.
std::vector<Segment> segments_of(const std::filesystem::path& file) {
  if (format_of(file) != FileFormat::nrrd)
    return {};
  return parse_segments(read_nrrd_header(file), file.string());
}

/// Calls function(values of all layers) for each voxel of `file`; the results are its labels. They
/// get the order of axes that images have.
template <typename Function>
LabelImage label_voxels(const std::filesystem::path& file, Remarks& remarks,
                        const Function& function) {
  const Volume layers = in_words(file, [&] { return read_nrrd(file, 0, remarks); });
  LabelImage labels(layers.grid);
  const std::size_t n_layers = layers.values.size() / labels.values.size();
  const float* values = layers.values.data();
  for (std::uint8_t& label : labels.values) {
    label = function(values, n_layers);
    values += n_layers;
  }
  return in_usual_order(std::move(labels));
}

} // namespace

LabelImage read_tissues(const std::filesystem::path& file, const Labels& labels, Remarks& remarks,
                        NiftiTransform transform) {
  const std::vector<Segment> segments = segments_of(file);
  if (segments.empty())
    return read_labels(file, remarks, transform);
  SegmentLabels meaning(segments, labels, file.string(), remarks);
  LabelImage image = label_voxels(file, remarks, [&](const float* values, std::size_t n_layers) {
    return meaning.label(values, n_layers);
  });
  meaning.say_what_was_met(file.string(), remarks);
  return image;
}

LabelImage read_mask(const std::filesystem::path& file, Remarks& remarks,
                     NiftiTransform transform) {
  if (!segments_of(file).empty())
    return label_voxels(file, remarks, [](const float* values, std::size_t n_layers) {
      return std::uint8_t(
          std::any_of(values, values + n_layers, [](float value) { return value != 0.f; }));
    });
  LabelImage mask = read_labels(file, remarks, transform);
  for (std::uint8_t& value : mask.values)
    value = value != 0;
  return mask;
}

} // namespace prosup::image
