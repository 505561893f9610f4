#include "outlined_slice.h"

#include "html.h"
#include "prosup/output/displacement_fields.h"

namespace prosup::output {

namespace {

constexpr int letter_size = 16, letter_inset = 14;
constexpr Colour black{0, 0, 0}, white{255, 255, 255}, outline_yellow{255, 214, 64};

} // namespace

OutlinedSlice::OutlinedSlice(const Orientation& orientation, const SliceBox& box,
                             const image::LabelImage& mask, int width)
    : orientation_(orientation), plane_(orientation, box, common_scale(box, width)) {
  const auto in_mask = voxels_with(mask, 1);
  const int n_columns = plane_.width(), n_rows = plane_.height();
  is_breast_.resize(std::size_t(n_columns) * std::size_t(n_rows));
  for (int row = 0; row < n_rows; ++row)
    for (int column = 0; column < n_columns; ++column)
      is_breast_[pixel(column, row)] = in_mask(plane_.position(column, row));
  is_outline_.resize(is_breast_.size());
  for (int row = 0; row + 1 < n_rows; ++row)
    for (int column = 0; column + 1 < n_columns; ++column)
      is_outline_[pixel(column, row)] = is_breast(column, row) != is_breast(column + 1, row) ||
                                        is_breast(column, row) != is_breast(column, row + 1);
}

std::string OutlinedSlice::picture(const std::function<Colour(int, int)>& colour) const {
  Canvas canvas(plane_.width(), plane_.height(), black);
  for (int row = 0; row < plane_.height(); ++row)
    for (int column = 0; column < plane_.width(); ++column)
      canvas.set(column, row,
                 is_outline_[pixel(column, row)] ? outline_yellow : colour(column, row));
  const int middle_x = plane_.width() / 2, middle_y = plane_.height() / 2;
  const auto letter = [&](int x, int y, const char* word) {
    canvas.text(x + 1, y + 1, word, letter_size, black); // seen on white
    canvas.text(x, y, word, letter_size, white);
  };
  letter(letter_inset, middle_y, orientation_.left);
  letter(plane_.width() - letter_inset, middle_y, orientation_.right);
  letter(middle_x, letter_inset, orientation_.top);
  letter(middle_x, plane_.height() - letter_inset, orientation_.bottom);
  return html::data_uri(canvas.png(), "image/png");
}

} // namespace prosup::output
