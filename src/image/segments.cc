#include "segments.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "prosup/core/text.h"

namespace prosup::image {

namespace {

constexpr unsigned largest_value = 65535; // Slicer's label maps have at most 16 bits

std::string value_of(const NrrdHeader& header, std::size_t segment, const char* key) {
  const auto found = header.keys.find("Segment" + std::to_string(segment) + "_" + key);
  return found == header.keys.end() ? std::string() : trimmed(found->second);
}

unsigned number_of(const NrrdHeader& header, std::size_t segment, const char* key,
                   unsigned otherwise, const std::string& file) {
  const std::string text = value_of(header, segment, key);
  if (text.empty())
    return otherwise;
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value > largest_value)
    refuse_nrrd_header(file, "has '" + text.substr(0, 40) + "' in 'Segment" +
                                 std::to_string(segment) + "_" + key +
                                 "', which is no number from 0 to 65535");
  return value;
}

/// The words of a name in lower case, divided by all that is no letter of ASCII.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : lower_case(name))
    if (c >= 'a' && c <= 'z')
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  return words;
}

/// Whether a word is of something else in the breast, so that "breast implant" is no breast tissue.
bool is_foreign(const std::string& word) {
  for (const char* text : {"implant", "prosthe", "silicon", "tumo", "lesion", "cancer", "carcin",
                           "cyst", "clip", "lymph", "vessel", "vein", "arter", "marker", "scar"})
    if (word.rfind(text, 0) == 0)
      return true;
  return false;
}

/// What one word says. Beginnings, so that "gland", "glands" and "glandular" are the same.
SegmentKind kind_of_word(const std::string& word) {
  struct Beginning {
    const char* text;
    SegmentKind kind;
  };
  static constexpr Beginning beginnings[] = {
      {"chest", SegmentKind::chest},     {"thora", SegmentKind::chest},
      {"pector", SegmentKind::chest},    {"muscle", SegmentKind::chest},
      {"muscul", SegmentKind::chest},    {"rib", SegmentKind::chest},
      {"gland", SegmentKind::gland},     {"fibrogland", SegmentKind::gland},
      {"parenchym", SegmentKind::gland}, {"fgt", SegmentKind::gland},
      {"fat", SegmentKind::fat},         {"adipos", SegmentKind::fat},
      {"skin", SegmentKind::skin},       {"nipple", SegmentKind::skin},
      {"areola", SegmentKind::skin},     {"breast", SegmentKind::breast},
      {"mamma", SegmentKind::breast},    {"background", SegmentKind::air},
      {"air", SegmentKind::air},
  };
  for (const Beginning& beginning : beginnings)
    if (word.rfind(beginning.text, 0) == 0)
      return beginning.kind;
  return SegmentKind::unknown;
}

} // namespace

std::vector<Segment> parse_segments(const NrrdHeader& header, const std::string& file) {
  std::vector<Segment> segments;
  const auto n_layers =
      header.axes.size() > 3 && !header.axes[0].direction ? header.axes[0].size : 1;
  std::set<std::pair<unsigned, std::size_t>> seen;
  for (std::size_t s = 0;
       !value_of(header, s, "ID").empty() || !value_of(header, s, "Name").empty(); ++s) {
    const bool has_value = !value_of(header, s, "LabelValue").empty();
    const std::size_t own_layer = n_layers > 1 && !has_value ? s : 0;
    std::string name = value_of(header, s, "Name");
    if (name.empty())
      name = value_of(header, s, "ID");
    name = shown(name);
    const Segment segment{name, number_of(header, s, "LabelValue", 1, file),
                          number_of(header, s, "Layer", unsigned(own_layer), file)};
    if (segment.layer >= n_layers)
      refuse_nrrd_header(file, "puts the segment '" + name + "' into layer " +
                                   std::to_string(segment.layer) + ", but has " +
                                   std::to_string(n_layers));
    if (!seen.emplace(segment.value, segment.layer).second)
      refuse_nrrd_header(file, "gives two segments, one of them '" + name +
                                   "', the same value and layer");
    segments.push_back(segment);
  }
  return segments;
}

SegmentKind kind_of_segment(const std::string& name) {
  std::set<SegmentKind> said;
  for (const std::string& word : words_of(name)) {
    if (is_foreign(word))
      return SegmentKind::unknown;
    said.insert(kind_of_word(word));
  }
  said.erase(SegmentKind::unknown);
  // "breast fat" is fat, "breast gland" is gland.
  if (said.size() > 1)
    said.erase(SegmentKind::breast);
  return said.size() == 1 ? *said.begin() : SegmentKind::unknown;
}

} // namespace prosup::image
