#ifndef PROSUP_IMAGE_SEGMENTATION_H
#define PROSUP_IMAGE_SEGMENTATION_H

#include <filesystem>

#include "prosup/core/labels.h"
#include "prosup/image/image_io.h"

namespace prosup::image {

/// Reads the labels of the tissues. In a segmentation of 3D Slicer (`.seg.nrrd`) the names of the
/// segments say what they are, and their voxels get the numbers that `labels` gives to chest, fat
/// and gland; skin becomes fat. Where segments overlap, chest comes before gland, fat, skin and
/// whole breast. If no name says anything, and in other files, the values are the numbers.
/// What was renumbered, overlaps or is not known goes to `remarks`.
/// @throws Error as read_labels(), or if the keys of the segmentation contradict each other.
LabelImage read_tissues(const std::filesystem::path& file, const Labels& labels, Remarks& remarks,
                        NiftiTransform transform = NiftiTransform::must_agree);

/// Reads a mask: 1 where a label image or any segment of a segmentation is not 0.
/// @throws Error as read_labels().
LabelImage read_mask(const std::filesystem::path& file, Remarks& remarks,
                     NiftiTransform transform = NiftiTransform::must_agree);

} // namespace prosup::image

#endif
