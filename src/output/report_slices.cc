#include "report_slices.h"

#include <cmath>

#include "canvas.h"
#include "html.h"
#include "prosup/image/filters.h"
#include "prosup/output/displacement_fields.h"
#include "slice_plane.h"

namespace prosup::output {

namespace {

constexpr int picture_width = 520;
constexpr int tile = 40; // of the checkerboard, pixels
constexpr int letter_size = 16, letter_inset = 14;
constexpr Colour black{0, 0, 0}, white{255, 255, 255}, outline_yellow{255, 214, 64};
constexpr std::uint8_t no_data = 52;

/// One plane, with the pixels at which the outline of the breast is drawn.
class Slice {
public:
  Slice(const Orientation& orientation, const SliceBox& box, const image::LabelImage& mask)
      : orientation_(orientation),
        plane_(orientation, box,
               picture_width / (box.high[orientation.across] - box.low[orientation.across])) {
    const auto is_breast = voxels_with(mask, 1);
    const int width = plane_.width(), height = plane_.height();
    std::vector<bool> breast(std::size_t(width) * std::size_t(height));
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        breast[pixel(column, row)] = is_breast(plane_.position(column, row));
    is_outline_.resize(breast.size());
    for (int row = 0; row + 1 < height; ++row)
      for (int column = 0; column + 1 < width; ++column)
        is_outline_[pixel(column, row)] =
            breast[pixel(column, row)] != breast[pixel(column + 1, row)] ||
            breast[pixel(column, row)] != breast[pixel(column, row + 1)];
  }

  std::vector<float> values(const ShownImage& shown) const {
    return sample(Panel{"", shown, {}}, plane_);
  }

  /// PNG of `values`, 0 to 1, and of `other` on every second tile.
  std::string picture(const std::vector<float>& values, const std::vector<float>& other) const {
    Canvas canvas(plane_.width(), plane_.height(), black);
    for (int row = 0; row < plane_.height(); ++row)
      for (int column = 0; column < plane_.width(); ++column) {
        const std::size_t at = pixel(column, row);
        const float value = (column / tile + row / tile) % 2 == 0 ? values[at] : other[at];
        const auto grey =
            std::isnan(value) ? no_data : static_cast<std::uint8_t>(std::lround(255.f * value));
        canvas.set(column, row, is_outline_[at] ? outline_yellow : Colour{grey, grey, grey});
      }
    const int middle_x = plane_.width() / 2, middle_y = plane_.height() / 2;
    canvas.text(letter_inset, middle_y, orientation_.left, letter_size, white);
    canvas.text(plane_.width() - letter_inset, middle_y, orientation_.right, letter_size, white);
    canvas.text(middle_x, letter_inset, orientation_.top, letter_size, white);
    canvas.text(middle_x, plane_.height() - letter_inset, orientation_.bottom, letter_size, white);
    return html::data_uri(canvas.png(), "image/png");
  }

private:
  std::size_t pixel(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(plane_.width()) +
           static_cast<std::size_t>(column);
  }

  const Orientation& orientation_;
  SlicePlane plane_;
  std::vector<bool> is_outline_;
};

struct Kind {
  const char *name, *text;
};
constexpr Kind kinds[] = {{"carried", "prone, carried to supine"},
                          {"scanned", "prone, as scanned"},
                          {"checkerboard", "checkerboard of supine and carried prone"}};

std::string image_tag(const std::string& attributes, const std::string& source,
                      const std::string& what) {
  return "<img " + attributes + " alt=\"" + html::escaped(what) + "\" src=\"" + source + "\">\n";
}

/// The slider of one plane.
std::string viewer(const std::string& plane, const std::string& supine,
                   const std::vector<std::string>& over) {
  std::string text = "<figure class=\"viewer\"><div class=\"stack\">\n" +
                     image_tag("draggable=\"false\"", supine, plane + " slice of the supine image");
  for (std::size_t i = 0; i < over.size(); ++i)
    text += image_tag(std::string("draggable=\"false\" class=\"over") + (i == 0 ? " shown" : "") +
                          "\" data-kind=\"" + kinds[i].name + "\"",
                      over[i], plane + " slice: " + kinds[i].text);
  return text + "</div>\n<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"" +
         plane + " slice: part of the width that shows the prone image\">\n<figcaption>" + plane +
         "</figcaption></figure>\n";
}

std::string choice() {
  std::string text = "<p class=\"controls\">Left of the line: ";
  for (const Kind& kind : kinds)
    text += std::string("<label><input type=\"radio\" name=\"over\" value=\"") + kind.name + "\"" +
            (&kind == kinds ? " checked" : "") + "> " + kind.text + "</label> ";
  return text + "<br>Right of it: supine. Drag the line, or move it with the arrow keys.</p>\n";
}

} // namespace

std::string report_slices(const ReportImages& images, const image::ScalarImage& prone_in_supine) {
  const image::LabelImage& mask = *images.masks.supine;
  const auto window = [](const image::ScalarImage& image, const image::LabelImage& breast) {
    image::IntensityRange range = image::robust_range(image, breast, 1., 99.);
    range.low -= 0.1 * (range.high - range.low);
    return range;
  };
  const image::IntensityRange of_prone = window(*images.images.prone, *images.masks.prone);
  const ShownImage supine{images.images.supine, window(*images.images.supine, mask)},
      scanned{images.images.prone, of_prone}, carried{&prone_in_supine, of_prone};
  const SliceBox box = slice_box({&mask});
  std::string text = choice() + "<div class=\"viewers\">\n";
  for (const Orientation& orientation : orientations()) {
    const Slice slice(orientation, box, mask);
    const auto of_supine = slice.values(supine), of_carried = slice.values(carried),
               of_scanned = slice.values(scanned);
    std::string name = orientation.name;
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
    text += viewer(name, slice.picture(of_supine, of_supine),
                   {slice.picture(of_carried, of_carried), slice.picture(of_scanned, of_scanned),
                    slice.picture(of_carried, of_supine)});
  }
  return text +
         "</div>\n<p>The yellow line is the outline of the supine breast as labelled; outside "
         "of an image it is dark grey.</p>\n";
}

} // namespace prosup::output
