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
  is_breast_ = inside(voxels_with(mask, 1));
  is_outline_ = border(is_breast_);
}

std::vector<bool>
OutlinedSlice::inside(const std::function<bool(const Point<3>&)>& is_inside) const {
  std::vector<bool> result;
  for (int row = 0; row < plane_.height(); ++row)
    for (int column = 0; column < plane_.width(); ++column)
      result.push_back(is_inside(plane_.position(column, row)));
  return result;
}

std::vector<bool> OutlinedSlice::border(const std::vector<bool>& inside) const {
  std::vector<bool> result(inside.size());
  for (int row = 0; row + 1 < plane_.height(); ++row)
    for (int column = 0; column + 1 < plane_.width(); ++column) {
      const bool here = inside[pixel(column, row)];
      result[pixel(column, row)] =
          here != inside[pixel(column + 1, row)] || here != inside[pixel(column, row + 1)];
    }
  return result;
}

std::vector<bool>
OutlinedSlice::outline(const std::function<bool(const Point<3>&)>& is_inside) const {
  return border(inside(is_inside));
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
