#include "prosup/output/pictures.h"

#include <algorithm>
#include <cmath>

#include "canvas.h"
#include "colours.h"
#include "prosup/core/log.h"
#include "slice_plane.h"

namespace prosup::output {

namespace {

constexpr int picture_width = 1500, gap = 8, title_height = 34;
constexpr int title_size = 20, letter_size = 18, letter_inset = 16;
constexpr Colour black{0, 0, 0}, white{255, 255, 255}, yellow{255, 214, 64}, dark{40, 40, 40};
constexpr Colour no_data_grey{52, 52, 60}, no_data_difference{205, 205, 205};

using Rows = std::vector<std::vector<Panel>>;

std::size_t n_columns(const Rows& rows) {
  std::size_t n = 1;
  for (const auto& row : rows)
    n = std::max(n, row.size());
  return n;
}

Colour grey(float value) {
  if (std::isnan(value))
    return no_data_grey;
  const auto level = static_cast<std::uint8_t>(std::lround(255.f * value));
  return {level, level, level};
}

Colour of_difference(float value) {
  return std::isnan(value) ? no_data_difference : blue_white_red(double(value));
}

/// The magnitude that 98 of 100 differences stay below, so that a few voxels at
/// the skin do not make all others pale; at least 0.1 of the window, so that
/// noise is not shown as a difference.
float difference_scale(const Rows& rows, const SlicePlane& plane) {
  std::vector<float> magnitudes;
  for (const auto& row : rows)
    for (const Panel& panel : row)
      if (panel.subtract)
        for (const float value : sample(panel, plane))
          if (!std::isnan(value))
            magnitudes.push_back(std::abs(value));
  if (magnitudes.empty())
    return 1.f;
  const auto at =
      magnitudes.begin() + static_cast<std::ptrdiff_t>(0.98 * double(magnitudes.size() - 1));
  std::nth_element(magnitudes.begin(), at, magnitudes.end());
  return std::max(*at, 0.1f);
}

void draw_letters(Canvas& canvas, int x, int y, const SlicePlane& plane,
                  const Orientation& orientation, const Colour& colour) {
  const int middle_x = x + plane.width() / 2, middle_y = y + plane.height() / 2;
  canvas.text(x + letter_inset, middle_y, orientation.left, letter_size, colour);
  canvas.text(x + plane.width() - letter_inset, middle_y, orientation.right, letter_size, colour);
  canvas.text(middle_x, y + letter_inset, orientation.top, letter_size, colour);
  canvas.text(middle_x, y + plane.height() - letter_inset, orientation.bottom, letter_size, colour);
}

/// Draws a panel with the upper left corner of its title at (x, y).
void draw_panel(Canvas& canvas, int x, int y, const Panel& panel, const SlicePlane& plane,
                const Orientation& orientation, float scale) {
  const std::string range = format(" (-%.2f to +%.2f)", double(scale), double(scale));
  canvas.text(x + plane.width() / 2, y + title_height / 2,
              panel.title + (panel.subtract ? range : ""), title_size, white);
  y += title_height;
  const std::vector<float> values = sample(panel, plane);
  auto value = values.begin();
  for (int row = 0; row < plane.height(); ++row)
    for (int column = 0; column < plane.width(); ++column, ++value)
      canvas.set(x + column, y + row,
                 panel.subtract ? of_difference(*value / scale) : grey(*value));
  draw_letters(canvas, x, y, plane, orientation, panel.subtract ? dark : yellow);
}

void write_picture(const Rows& rows, const SliceBox& box, const Orientation& orientation,
                   const std::filesystem::path& file) {
  const auto columns = static_cast<int>(n_columns(rows));
  const int panel_width = (picture_width - (columns + 1) * gap) / columns;
  const unsigned across = orientation.across;
  const SlicePlane plane(orientation, box, panel_width / (box.high[across] - box.low[across]));
  const int row_height = title_height + plane.height() + gap;
  Canvas canvas(picture_width, static_cast<int>(rows.size()) * row_height, black);
  const float scale = difference_scale(rows, plane);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c)
      draw_panel(canvas, gap + static_cast<int>(c) * (panel_width + gap),
                 static_cast<int>(r) * row_height, rows[r][c], plane, orientation, scale);
  canvas.write_png(file);
}

image::IntensityRange window_of(const image::ScalarImage& image, const image::LabelImage& mask) {
  return image::robust_range(image, mask, 0.5, 99.5);
}

} // namespace

void write_slices(const Rows& rows, const SliceBox& box, const std::filesystem::path& folder) {
  for (const Orientation& orientation : orientations())
    write_picture(rows, box, orientation,
                  folder / (std::string("slices_") + orientation.name + ".png"));
}

void write_registration_slices(const RegistrationImages& images,
                               const std::filesystem::path& folder) {
  const auto prone_window = window_of(images.prone, images.prone_mask);
  const auto supine_window = window_of(images.supine, images.supine_mask);
  const ShownImage prone{&images.prone, prone_window}, supine{&images.supine, supine_window};
  const ShownImage unloaded_prone{&images.unloaded_prone, prone_window};
  const ShownImage unloaded_supine{&images.unloaded_supine, supine_window};
  write_slices(
      {{{"Prone", prone, {}}, {"Supine", supine, {}}, {"Prone - supine before", prone, supine}},
       {{"Prone, unloaded", unloaded_prone, {}},
        {"Supine, unloaded", unloaded_supine, {}},
        {"Prone - supine after", unloaded_prone, unloaded_supine}}},
      slice_box({&images.prone_mask, &images.supine_mask}), folder);
}

namespace {

/// Both in the window of the first, which the mask is of.
void write_two(const Panel& first, const image::LabelImage& mask, const Panel& second,
               const std::filesystem::path& folder) {
  Panel left = first, right = second;
  left.shown.window = right.shown.window = window_of(*first.shown.image, mask);
  write_slices({{left, right}}, slice_box({&mask}), folder);
}

} // namespace

void write_unloading_slices(const image::ScalarImage& loaded, const image::LabelImage& mask,
                            const image::ScalarImage& unloaded,
                            const std::filesystem::path& folder) {
  write_two({"Loaded", {&loaded, {}}, {}}, mask, {"Unloaded", {&unloaded, {}}, {}}, folder);
}

void write_loading_slices(const image::ScalarImage& unloaded, const image::LabelImage& mask,
                          const image::ScalarImage& loaded, const std::filesystem::path& folder) {
  write_two({"Unloaded", {&unloaded, {}}, {}}, mask, {"Loaded", {&loaded, {}}, {}}, folder);
}

} // namespace prosup::output
