#include "prosup/image/segmentation.h"

#include <itkImageFileReader.h>
#include <itkVectorImage.h>

#include <algorithm>
#include <stdexcept>

#include "file_formats.h"
#include "itk_bridge.h"
#include "nrrd_file.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"
#include "segment_labels.h"

namespace prosup::image {

namespace {

using Layers = itk::VectorImage<float, 3>;

/// The layers of a segmentation; one if it has no axis of layers.
Layers::Pointer read_layers(const std::filesystem::path& path, Remarks& remarks) {
  const std::string file = path.string();
  const QuietItk quiet;
  try {
    const auto io = nrrd_format();
    const std::optional<NrrdPlace> place = check_nrrd(path, remarks);
    auto reader = itk::ImageFileReader<Layers>::New();
    reader->SetImageIO(io);
    reader->SetFileName(file);
    reader->Update();
    Layers::Pointer layers = reader->GetOutput();
    put(place, *layers);
    return layers;
  } catch (const itk::ExceptionObject& exception) {
    throw Error(format("'%s' cannot be read (%s); it may be damaged or incomplete.", file.c_str(),
                       one_line(exception.GetDescription()).c_str()));
  } catch (const std::bad_alloc&) {
    throw Error(
        format("'%s' needs more memory for its layers than there is; export its segments to "
               "one label map.",
               file.c_str()));
  }
}

/// The segments of `file` if it is a segmentation of 3D Slicer.
std::vector<Segment> segments_of(const std::filesystem::path& file) {
  if (format_of(file) != FileFormat::nrrd)
    return {};
  return parse_segments(read_nrrd_header(file), file.string());
}

/// Calls function(values of all layers) for each voxel; the results are its labels.
template <typename Function>
LabelImage label_voxels(const Layers& layers, const std::string& file, const Function& function) {
  VoxelGrid grid;
  try {
    grid = geometry(layers);
  } catch (const std::domain_error& error) {
    throw Error(format("'%s' cannot be used: its %s; resample it to a regular grid.", file.c_str(),
                       error.what()));
  }
  LabelImage labels(grid);
  const std::size_t n_layers = layers.GetNumberOfComponentsPerPixel();
  const float* values = layers.GetBufferPointer();
  for (std::uint8_t& label : labels.values) {
    label = function(values, n_layers);
    values += n_layers;
  }
  return labels;
}

} // namespace

LabelImage read_tissues(const std::filesystem::path& file, const Labels& labels, Remarks& remarks,
                        NiftiTransform transform) {
  const std::vector<Segment> segments = segments_of(file);
  if (segments.empty())
    return read_labels(file, remarks, transform);
  SegmentLabels meaning(segments, labels, file.string(), remarks);
  const auto layers = read_layers(file, remarks);
  LabelImage image =
      label_voxels(*layers, file.string(), [&](const float* values, std::size_t n_layers) {
        return meaning.label(values, n_layers);
      });
  meaning.say_what_was_met(file.string(), remarks);
  return image;
}

LabelImage read_mask(const std::filesystem::path& file, Remarks& remarks,
                     NiftiTransform transform) {
  if (!segments_of(file).empty())
    return label_voxels(
        *read_layers(file, remarks), file.string(), [](const float* values, std::size_t n_layers) {
          return std::uint8_t(
              std::any_of(values, values + n_layers, [](float value) { return value != 0.f; }));
        });
  LabelImage mask = read_labels(file, remarks, transform);
  for (std::uint8_t& value : mask.values)
    value = value != 0;
  return mask;
}

} // namespace prosup::image
