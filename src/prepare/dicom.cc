#include "prosup/prepare/dicom.h"

#include <itkGDCMImageIO.h>
#include <itkImageFileReader.h>

#include <algorithm>
#include <cmath>

#include "dicom_series.h"
#include "image/axis_order.h"
#include "image/itk_bridge.h"
#include "prosup/core/error.h"

namespace prosup::prepare {

namespace fs = std::filesystem;

namespace {

constexpr double whole_chest = 100.; // mm

bool shows_a_chest(const DicomSeries& series) {
  const DicomSlice& slice = series.slices.front();
  const double extent = double(series.one_per_height().size()) * series.slice_distance();
  return extent >= whole_chest && double(slice.size[0]) * slice.spacing[0] >= whole_chest &&
         double(slice.size[1]) * slice.spacing[1] >= whole_chest;
}

const DicomSeries& choose(const std::vector<DicomSeries>& all, unsigned number,
                          const std::string& folder) {
  const DicomSeries* best = nullptr;
  for (const DicomSeries& series : all)
    if (number != 0
            ? series.number == number
            : shows_a_chest(series) && (best == nullptr || series.one_per_height().size() >
                                                               best->one_per_height().size()))
      best = &series;
  if (best != nullptr)
    return *best;
  if (number != 0)
    throw Error(format("'%s' has no series %u; take a number from the list above.", folder.c_str(),
                       number));
  throw Error("'" + folder +
              "' has no series of slices that shows at least 100 mm along all axes; name another "
              "folder, or choose a series with --series.");
}

void check_position(const DicomSeries& series, Position position, const std::string& folder,
                    Remarks& remarks) {
  const std::string& told = series.patient_position;
  if (told.size() < 3 || (told[2] != 'P' && told[2] != 'S')) {
    remarks.add("'" + folder + "' does not say whether the patient lay prone or supine; taken as " +
                name_of(position) + ".");
    return;
  }
  const Position lay = told[2] == 'P' ? Position::prone : Position::supine;
  if (lay != position)
    throw Error("'" + folder + "' is given as " + name_of(position) +
                ", but its patient position is " + shown(told, 16) + ", which is " + name_of(lay) +
                "; give it as that, or the other folder.");
}

/// The slices of a series that follow each other at one distance.
std::vector<DicomSlice> regular_slices(const DicomSeries& series, const std::string& folder,
                                       Remarks& remarks) {
  const std::vector<DicomSlice> slices = series.one_per_height();
  if (slices.size() < series.slices.size())
    remarks.add(format("Series %u of '%s' has %zu images at %zu positions; the first at each is "
                       "taken.",
                       series.number, folder.c_str(), series.slices.size(), slices.size()));
  const double distance = series.slice_distance();
  for (std::size_t i = 1; i < slices.size(); ++i) {
    const DicomSlice &below = slices[i - 1], &above = slices[i];
    if (above.size != below.size || (above.normal - below.normal).norm() > 1e-3 ||
        (above.across - below.across).norm() > 1e-3)
      throw Error(format("Series %u of '%s' has slices of different size or direction; choose "
                         "another with --series.",
                         series.number, folder.c_str()));
    const double step = above.height() - below.height();
    if (std::abs(step - distance) > 0.1 * distance)
      throw Error(format("Series %u of '%s' has a gap: its slices %zu and %zu are %.2f mm apart, "
                         "the others %.2f mm; give a folder with all slices, or choose another "
                         "series with --series.",
                         series.number, folder.c_str(), i, i + 1, step, distance));
  }
  return slices;
}

image::VoxelGrid grid_of(const std::vector<DicomSlice>& slices, double distance) {
  const DicomSlice& first = slices.front();
  image::VoxelGrid grid;
  grid.size = {first.size[0], first.size[1], slices.size()};
  grid.origin = first.origin;
  for (unsigned d = 0; d < 3; ++d) {
    grid.direction[d][0] = first.across[d];
    grid.direction[d][1] = first.down[d];
    grid.direction[d][2] = first.normal[d];
  }
  grid.spacing[0] = first.spacing[0];
  grid.spacing[1] = first.spacing[1];
  grid.spacing[2] = distance;
  return grid;
}

void read_slice(const DicomSlice& slice, float* target) {
  auto reader = itk::ImageFileReader<image::ItkImage<float>>::New();
  reader->SetImageIO(itk::GDCMImageIO::New());
  reader->SetFileName(slice.file.string());
  try {
    reader->Update();
  } catch (const itk::ExceptionObject&) {
    throw Error("'" + slice.file.string() +
                "' is damaged or has voxels that cannot be read; give the file again.");
  }
  std::copy_n(reader->GetOutput()->GetBufferPointer(), slice.size[0] * slice.size[1], target);
}

} // namespace

image::ScalarImage read_dicom(const fs::path& folder, Position position, unsigned number,
                              const Log& log, Remarks& remarks) {
  const std::vector<DicomSeries> all = find_series(folder);
  const std::string name = folder.string();
  if (all.empty())
    throw Error("'" + name +
                "' holds no DICOM slices with a position; name a folder that does, or "
                "a file in NIfTI, NRRD or MetaImage.");
  for (const DicomSeries& series : all)
    log.line("  " + series.describe());
  const DicomSeries& series = choose(all, number, name);
  log.line(
      format("  taken: series %u, %s", series.number,
             number != 0 ? "as told" : "which has most slices of those that show 100 mm and more"));
  check_position(series, position, name, remarks);
  const std::vector<DicomSlice> slices = regular_slices(series, name, remarks);
  if (slices.size() < 2)
    throw Error(format("Series %u of '%s' has one slice only; choose another with --series.",
                       series.number, name.c_str()));
  image::ScalarImage image(grid_of(slices, series.slice_distance()));
  const std::size_t n = image.grid.size[0] * image.grid.size[1];
  for (std::size_t i = 0; i < slices.size(); ++i)
    read_slice(slices[i], image.values.data() + i * n);
  return image::in_usual_order(std::move(image));
}

} // namespace prosup::prepare
