#ifndef PROSUP_SRC_PREPARE_DICOM_SERIES_H
#define PROSUP_SRC_PREPARE_DICOM_SERIES_H

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// What the header of a DICOM file says of its slice.
struct DicomSlice {
  std::filesystem::path file;
  long instance = 0;
  std::array<std::size_t, 2> size{0, 0};
  std::array<double, 2> spacing{1., 1.}; ///< mm
  image::Point<3> origin;                ///< LPS, mm
  dealii::Tensor<1, 3> across, down, normal;

  double height() const { return normal * dealii::Tensor<1, 3>(origin); } ///< along the normal, mm
};

/// The slices of one series, in the order of their heights.
struct DicomSeries {
  unsigned number = 0;
  std::string uid, description, modality, patient_position;
  std::vector<DicomSlice> slices;

  /// Heights that differ by less than this are one, mm.
  static constexpr double same_height = 0.01;

  /// The first slice at each height.
  std::vector<DicomSlice> one_per_height() const;
  /// Distance of most neighbouring heights, mm; 0 with one slice.
  double slice_distance() const;
  /// One line: number, description, modality, slices and voxels.
  std::string describe() const;
};

/// The series in a folder, by their numbers.
std::vector<DicomSeries> find_series(const std::filesystem::path& folder);

} // namespace prosup::prepare

#endif
