#include "segment_labels.h"

#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"

namespace prosup::image {

namespace {

constexpr unsigned largest_label = 255;

/// What `labels` calls a kind of tissue.
unsigned number_of(SegmentKind kind, const Labels& labels) {
  switch (kind) {
  case SegmentKind::chest:
    return labels.chest;
  case SegmentKind::gland:
    return labels.gland != 0 ? labels.gland : labels.fat();
  case SegmentKind::fat:
  case SegmentKind::skin:
  case SegmentKind::breast:
    return labels.fat();
  case SegmentKind::air:
  case SegmentKind::unknown:
    break;
  }
  return 0;
}

} // namespace

SegmentLabels::SegmentLabels(const std::vector<Segment>& segments, const Labels& labels,
                             const std::string& file, Remarks& remarks) {
  for (const Segment& segment : segments)
    meanings_.push_back({segment, kind_of_segment(segment.name), 0});
  const bool any_known = std::any_of(meanings_.begin(), meanings_.end(), [](const Meaning& m) {
    return m.kind != SegmentKind::unknown && m.kind != SegmentKind::air;
  });
  if (any_known)
    name_by_kind(labels, file, remarks);
  else
    take_numbers(file, remarks);
}

unsigned SegmentLabels::free_label(unsigned wanted, const Labels& labels) const {
  const auto is_used = [&](unsigned label) {
    return label == labels.chest ||
           std::count(labels.tissues.begin(), labels.tissues.end(), label) > 0 ||
           std::any_of(meanings_.begin(), meanings_.end(),
                       [&](const Meaning& m) { return m.label == label; });
  };
  for (unsigned label = wanted; label > 0 && label <= largest_label; ++label)
    if (!is_used(label))
      return label;
  for (unsigned label = largest_label; label > 0; --label)
    if (!is_used(label))
      return label;
  return 0;
}

void SegmentLabels::name_by_kind(const Labels& labels, const std::string& file, Remarks& remarks) {
  std::vector<std::string> taken, unknown;
  bool changed = false;
  for (Meaning& m : meanings_) {
    m.label = number_of(m.kind, labels);
    if (m.kind == SegmentKind::unknown)
      continue;
    changed = changed || m.label != m.segment.value;
    taken.push_back(format("'%s' (%u) as %u", m.segment.name.c_str(), m.segment.value, m.label));
  }
  for (Meaning& m : meanings_)
    if (m.kind == SegmentKind::unknown) {
      m.label = free_label(m.segment.value, labels);
      unknown.push_back(format("'%s' (label %u)", m.segment.name.c_str(), m.label));
    }
  if (changed)
    remarks.add("The segments of '" + file + "' were numbered by their names: " + joined(taken) +
                "; check that this is what they are.");
  if (!unknown.empty())
    remarks.add("The segments " + joined(unknown) + " of '" + file +
                "' are neither chest, fat nor gland by their names, so they are no part of the "
                "breast; rename, merge or delete them.");
}

void SegmentLabels::take_numbers(const std::string& file, Remarks& remarks) {
  std::vector<std::string> taken;
  for (Meaning& m : meanings_) {
    if (m.segment.value > largest_label)
      throw Error(format("The segment '%s' of '%s' has the label value %u, but labels are integers "
                         "from 0 to 255; name the segments chest, fat and gland, or renumber them.",
                         m.segment.name.c_str(), file.c_str(), m.segment.value));
    m.label = m.segment.value;
    taken.push_back(format("'%s' is %u", m.segment.name.c_str(), m.label));
  }
  remarks.add("The names of the segments of '" + file + "' do not say what they are, so their " +
              "label values were taken as the numbers of 'Labels' (" + joined(taken) +
              "); name them chest, fat and gland.");
}

const SegmentLabels::Meaning* SegmentLabels::find(float value, std::size_t layer) const {
  for (const Meaning& m : meanings_)
    if (m.segment.layer == layer && float(m.segment.value) == value)
      return &m;
  return nullptr;
}

std::uint8_t SegmentLabels::label(const float* values, std::size_t n_layers) {
  const Meaning* best = nullptr;
  bool overlaps = false;
  for (std::size_t layer = 0; layer < n_layers; ++layer) {
    if (values[layer] == 0.f)
      continue;
    const Meaning* found = find(values[layer], layer);
    n_without_segment_ += found == nullptr;
    if (found == nullptr)
      continue;
    overlaps = overlaps || (best != nullptr && best->label != found->label);
    // Segments whose names say nothing are of one kind: the later one counts, as in Slicer.
    if (best == nullptr || found->kind >= best->kind)
      best = found;
  }
  n_overlapping_ += overlaps;
  return best == nullptr ? std::uint8_t(0) : static_cast<std::uint8_t>(best->label);
}

void SegmentLabels::say_what_was_met(const std::string& file, Remarks& remarks) const {
  if (n_overlapping_ > 0)
    remarks.add(format("In '%s' segments overlap in %zu voxels; chest was taken before gland, fat, "
                       "skin and whole breast, and unnamed ones in their order.",
                       file.c_str(), n_overlapping_));
  if (n_without_segment_ > 0)
    remarks.add(
        format("In '%s' %zu voxels have a value that belongs to no segment; they were taken "
               "as air.",
               file.c_str(), n_without_segment_));
}

} // namespace prosup::image
