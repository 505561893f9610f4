#include "prosup/output/outlines.h"

#include <algorithm>
#include <cmath>

#include "canvas.h"
#include "prosup/core/log.h"
#include "prosup/image/filters.h"
#include "prosup/image/sampling.h"
#include "prosup/output/pictures.h"
#include "slice_plane.h"

namespace prosup::output {

namespace {

constexpr int n_columns = 3, n_rows = 2;
constexpr int panel_width = 500, gap = 6;
constexpr int letter_size = 16, letter_inset = 60;
constexpr Colour black{0, 0, 0}, white{255, 255, 255};
constexpr Colour skin_yellow{255, 214, 64}, chest_green{80, 230, 120}, gland_red{255, 80, 60};

/// What a pixel shows, in the order in which outlines cover each other.
enum class Region { air, chest, fat, gland };

class OutlinePanel {
public:
  OutlinePanel(const ShownImage& shown, const image::LabelImage& labels,
               const OutlinedLabels& names, const SlicePlane& plane)
      : plane_(plane), values_(sample({"", shown, {}}, plane)) {
    regions_.reserve(values_.size());
    for (int row = 0; row < plane.height(); ++row)
      for (int column = 0; column < plane.width(); ++column)
        regions_.push_back(
            region(image::nearest_label(labels, plane.position(column, row)), names));
  }

  void draw(Canvas& canvas, int x, int y) const {
    for (int row = 0; row < plane_.height(); ++row)
      for (int column = 0; column < plane_.width(); ++column)
        canvas.set(x + column, y + row, colour(column, row));
  }

private:
  static Region region(unsigned label, const OutlinedLabels& names) {
    return label == 0             ? Region::air
           : label == names.chest ? Region::chest
           : label == names.gland ? Region::gland
                                  : Region::fat;
  }

  std::size_t pixel(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(plane_.width()) +
           static_cast<std::size_t>(column);
  }

  Region at(int column, int row) const {
    column = std::min(column, plane_.width() - 1);
    row = std::min(row, plane_.height() - 1);
    return regions_[pixel(column, row)];
  }

  /// An outline lies between a pixel and the next one to the right or below.
  Colour colour(int column, int row) const {
    const Region here = at(column, row);
    for (const Region there : {at(column + 1, row), at(column, row + 1)}) {
      if (there == here)
        continue;
      const auto either = [&](Region region) { return here == region || there == region; };
      if (either(Region::air))
        return skin_yellow;
      return either(Region::chest) ? chest_green : gland_red;
    }
    const float value = values_[pixel(column, row)];
    const auto level =
        static_cast<std::uint8_t>(std::isnan(value) ? 52l : std::lround(255.f * value));
    return {level, level, level};
  }

  const SlicePlane& plane_;
  std::vector<float> values_;
  std::vector<Region> regions_;
};

void write_picture(const ShownImage& shown, const image::LabelImage& labels,
                   const OutlinedLabels& names, const SliceBox& box, const Orientation& orientation,
                   const std::filesystem::path& file) {
  const unsigned through = 3 - orientation.across - orientation.down;
  const double pixels_per_mm =
      panel_width / (box.high[orientation.across] - box.low[orientation.across]);
  const int row_height = SlicePlane(orientation, box, pixels_per_mm).height() + gap;
  Canvas canvas(n_columns * (panel_width + gap), n_rows * row_height, black);
  for (int i = 0; i < n_columns * n_rows; ++i) {
    SliceBox slice = box;
    slice.centre[through] = box.low[through] + (box.high[through] - box.low[through]) *
                                                   (double(i) + 1.) / (n_columns * n_rows + 1.);
    const SlicePlane plane(orientation, slice, pixels_per_mm);
    const int x = i % n_columns * (panel_width + gap), y = i / n_columns * row_height;
    OutlinePanel(shown, labels, names, plane).draw(canvas, x, y);
    canvas.text(x + letter_inset, y + letter_size,
                format("%c = %.0f mm", "xyz"[through], slice.centre[through]), letter_size, white);
  }
  canvas.write_png(file);
}

} // namespace

void write_outlines(const image::ScalarImage& image, const image::LabelImage& labels,
                    const OutlinedLabels& names, const std::string& name,
                    const std::filesystem::path& folder) {
  const image::LabelImage breast = image::select_labels(labels, {names.fat, names.gland});
  image::IntensityRange window = image::robust_range(image, breast, 1., 99.);
  window.low -= 0.1 * (window.high - window.low);
  const SliceBox box = slice_box({&breast});
  for (const Orientation& orientation : orientations())
    write_picture({&image, window}, labels, names, box, orientation,
                  folder / (name + "_" + orientation.name + ".png"));
}

} // namespace prosup::output
