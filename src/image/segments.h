#ifndef PROSUP_SRC_IMAGE_SEGMENTS_H
#define PROSUP_SRC_IMAGE_SEGMENTS_H

#include <string>
#include <vector>

#include "nrrd_header.h"

namespace prosup::image {

/// A segment of a segmentation of 3D Slicer: the voxels that have `value` in `layer`.
struct Segment {
  std::string name;
  unsigned value;
  std::size_t layer;
};

/// The segments that the keys of an NRRD header name (Segment0_Name, Segment0_LabelValue,
/// Segment0_Layer, ...); none if this is another NRRD. Versions of Slicer before 4.11 wrote each
/// segment as a layer of its own with the value 1.
/// @throws Error that names `file` if a value or layer is no number, or two segments are the same.
std::vector<Segment> parse_segments(const NrrdHeader& header, const std::string& file);

/// What a segment is. Where segments overlap, the later one in this list counts.
enum class SegmentKind { unknown, air, breast, skin, fat, gland, chest };

/// What the name of a segment says, such as "Left breast", "FGT" or "pectoral muscle"; unknown if
/// it says nothing or two things.
SegmentKind kind_of_segment(const std::string& name);

} // namespace prosup::image

#endif
