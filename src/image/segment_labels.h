#ifndef PROSUP_SRC_IMAGE_SEGMENT_LABELS_H
#define PROSUP_SRC_IMAGE_SEGMENT_LABELS_H

#include <cstdint>
#include <string>
#include <vector>

#include "prosup/core/labels.h"
#include "prosup/core/remarks.h"
#include "segments.h"

namespace prosup::image {

/// The label that each segment of a file gets, and how it stands to others where they overlap.
class SegmentLabels {
public:
  /// Says in `remarks` what is done about names that say nothing, and which numbers change.
  /// @throws Error if a number does not fit into a label image.
  SegmentLabels(const std::vector<Segment>& segments, const Labels& labels, const std::string& file,
                Remarks& remarks);

  /// The label of a voxel with these values, one for each layer.
  std::uint8_t label(const float* values, std::size_t n_layers);

  /// Says how many voxels had several labels, or values that belong to no segment.
  void say_what_was_met(const std::string& file, Remarks& remarks) const;

private:
  struct Meaning {
    Segment segment;
    SegmentKind kind;
    unsigned label;
  };

  void name_by_kind(const Labels& labels, const std::string& file, Remarks& remarks);
  void take_numbers(const std::string& file, Remarks& remarks);
  unsigned free_label(unsigned wanted, const Labels& labels) const;
  const Meaning* find(float value, std::size_t layer) const;

  std::vector<Meaning> meanings_;
  std::size_t n_overlapping_ = 0, n_without_segment_ = 0;
};

} // namespace prosup::image

#endif
