#include "dicom_series.h"

#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <utility>

#include "prosup/core/log.h"
#include "prosup/core/quantile.h"
#include "prosup/core/text.h"

namespace prosup::prepare {

namespace fs = std::filesystem;

namespace {

std::string tag(const itk::MetaDataDictionary& header, const char* key) {
  std::string value;
  itk::ExposeMetaData<std::string>(header, key, value);
  // Values are padded to an even length, by blanks or by zeros.
  value.erase(std::find(value.begin(), value.end(), '\0'), value.end());
  return trimmed(value);
}

/// The numbers between backslashes.
std::vector<double> numbers(std::string text) {
  std::replace(text.begin(), text.end(), '\\', ' ');
  std::istringstream stream(text);
  std::vector<double> values;
  for (double value = 0.; stream >> value;)
    values.push_back(value);
  return values;
}

/// Fills in where the slice lies. False if the header does not say it.
bool set_place(const itk::MetaDataDictionary& header, DicomSlice& slice) {
  const std::vector<double> position = numbers(tag(header, "0020|0032"));
  const std::vector<double> orientation = numbers(tag(header, "0020|0037"));
  const std::vector<double> spacing = numbers(tag(header, "0028|0030"));
  if (position.size() != 3 || orientation.size() != 6 || spacing.size() != 2)
    return false;
  for (unsigned d = 0; d < 3; ++d) {
    slice.origin[d] = position[d];
    slice.across[d] = orientation[d];
    slice.down[d] = orientation[d + 3];
  }
  slice.normal = dealii::cross_product_3d(slice.across, slice.down);
  slice.spacing = {spacing[1], spacing[0]}; // the first is between rows
  return slice.spacing[0] > 0. && slice.spacing[1] > 0. &&
         std::abs(slice.normal.norm() - 1.) < 1e-3;
}

/// Adds the file to its series, if it is a slice.
void add(const fs::path& file, std::map<std::string, DicomSeries>& all) {
  auto io = itk::GDCMImageIO::New();
  if (!io->CanReadFile(file.c_str()))
    return;
  io->SetFileName(file.c_str());
  try {
    io->ReadImageInformation();
  } catch (const itk::ExceptionObject&) {
    return;
  }
  const itk::MetaDataDictionary& header = io->GetMetaDataDictionary();
  DicomSlice slice;
  slice.file = file;
  slice.size = {io->GetDimensions(0), io->GetDimensions(1)};
  slice.instance = std::strtol(tag(header, "0020|0013").c_str(), nullptr, 10);
  if (io->GetNumberOfComponents() != 1 ||
      (io->GetNumberOfDimensions() > 2 && io->GetDimensions(2) > 1) || !set_place(header, slice))
    return;
  const std::string uid = tag(header, "0020|000e");
  DicomSeries& series = all[uid];
  series.uid = uid;
  series.number =
      static_cast<unsigned>(std::strtoul(tag(header, "0020|0011").c_str(), nullptr, 10));
  series.description = tag(header, "0008|103e");
  series.modality = tag(header, "0008|0060");
  series.patient_position = tag(header, "0018|5100");
  series.slices.push_back(slice);
}

} // namespace

std::vector<DicomSlice> DicomSeries::one_per_height() const {
  std::vector<DicomSlice> result;
  for (const DicomSlice& slice : slices)
    if (result.empty() || slice.height() - result.back().height() > same_height)
      result.push_back(slice);
  return result;
}

double DicomSeries::slice_distance() const {
  const std::vector<DicomSlice> single = one_per_height();
  if (single.size() < 2)
    return 0.;
  std::vector<double> distances;
  for (std::size_t i = 1; i < single.size(); ++i)
    distances.push_back(single[i].height() - single[i - 1].height());
  return quantile(std::move(distances), 0.5);
}

std::string DicomSeries::describe() const {
  const std::size_t n = one_per_height().size();
  const std::string doubled =
      n < slices.size() ? format(" (%zu images)", slices.size()) : std::string();
  return format("series %u: %s, %s, %zu slices%s, %.2f x %.2f x %.2f mm", number,
                description.empty() ? "no description" : shown(description, 40).c_str(),
                modality.empty() ? "no modality" : shown(modality, 16).c_str(), n, doubled.c_str(),
                slices.front().spacing[0], slices.front().spacing[1], slice_distance());
}

std::vector<DicomSeries> find_series(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end()); // the same order on every file system
  std::map<std::string, DicomSeries> by_uid;
  for (const fs::path& file : files)
    add(file, by_uid);
  std::vector<DicomSeries> all;
  for (auto& [uid, series] : by_uid) {
    std::stable_sort(series.slices.begin(), series.slices.end(),
                     [](const DicomSlice& a, const DicomSlice& b) {
                       return std::abs(a.height() - b.height()) > DicomSeries::same_height
                                  ? a.height() < b.height()
                                  : a.instance < b.instance;
                     });
    all.push_back(std::move(series));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const DicomSeries& a, const DicomSeries& b) { return a.number < b.number; });
  return all;
}

} // namespace prosup::prepare
