#include "report_slices.h"

#include <cmath>

#include "html.h"
#include "outlined_slice.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/output/displacement_fields.h"

namespace prosup::output {

namespace {

constexpr int picture_width = 520;
constexpr int tile = 40; // of the checkerboard, pixels
constexpr Colour outline_blue{90, 190, 255};

/// `values`, 0 to 1, in grey, and `other` on every second tile; with an outline, or none.
std::string picture(const OutlinedSlice& slice, const std::vector<float>& values,
                    const std::vector<float>& other, const std::vector<bool>& outline = {}) {
  return slice.picture([&](int column, int row) {
    const std::size_t at = slice.pixel(column, row);
    if (!outline.empty() && outline[at])
      return outline_blue;
    const float value = (column / tile + row / tile) % 2 == 0 ? values[at] : other[at];
    if (std::isnan(value))
      return no_data_colour;
    const auto grey = static_cast<std::uint8_t>(std::lround(255.f * value));
    return Colour{grey, grey, grey};
  });
}

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
std::string viewer(const OutlinedSlice& slice, const std::string& supine,
                   const std::vector<std::string>& over) {
  const std::string plane = slice.orientation().name;
  std::string text = "<div class=\"stack\">\n" +
                     image_tag("draggable=\"false\"", supine, plane + " slice of the supine image");
  for (std::size_t i = 0; i < over.size(); ++i)
    text += image_tag(std::string("draggable=\"false\" class=\"over") + (i == 0 ? " shown" : "") +
                          "\" data-kind=\"" + kinds[i].name + "\"",
                      over[i], plane + " slice: " + kinds[i].text);
  text += "</div>\n<input type=\"range\" class=\"slider\" min=\"0\" max=\"100\" value=\"50\" "
          "aria-label=\"" +
          plane + " slice: part of the width that shows the prone image\">\n";
  return html::figure(plane, slice.plane().width_mm(), text);
}

std::string choice() {
  std::string text = "<p class=\"controls\">Left of the line: ";
  for (const Kind& kind : kinds)
    text += std::string("<label><input type=\"radio\" name=\"over\" value=\"") + kind.name + "\"" +
            (&kind == kinds ? " checked" : "") + "> " + kind.text + "</label> ";
  return text + "<br>Right of it: supine. <span class=\"screen\">Drag the line, or "
                "move it with the arrow keys.</span></p>\n";
}

/// A mask of the prone breast as it looks in supine.
image::LabelImage carried_mask(const image::LabelImage& prone, const std::filesystem::path& field) {
  const image::VectorImage to_prone = image::read_displacement(field);
  const auto in_prone = voxels_with(prone, 1);
  image::LabelImage mask(to_prone.grid);
  const auto& size = mask.grid.size;
  std::size_t v = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i, ++v) {
        const auto& u = to_prone.values[v];
        const Point<3> x = mask.grid.physical(double(i), double(j), double(k));
        mask.values[v] = in_prone(x + dealii::Tensor<1, 3>({u[0], u[1], u[2]}));
      }
  return mask;
}

image::IntensityRange window(const image::ScalarImage& image, const image::LabelImage& breast) {
  image::IntensityRange range = image::robust_range(image, breast, 1., 99.);
  range.low -= 0.1 * (range.high - range.low);
  return range;
}

} // namespace

std::string report_slices(const ReportImages& images, const std::filesystem::path& result) {
  const image::LabelImage& mask = *images.masks.supine;
  const image::ScalarImage in_supine = image::read_image(result / prone_in_supine);
  const std::filesystem::path field = result / "supine_to_prone.nrrd";
  const image::LabelImage moved = std::filesystem::exists(field)
                                      ? carried_mask(*images.masks.prone, field)
                                      : image::LabelImage(mask.grid);
  const image::IntensityRange of_prone = window(*images.images.prone, *images.masks.prone);
  const ShownImage supine{images.images.supine, window(*images.images.supine, mask)},
      scanned{images.images.prone, of_prone}, carried{&in_supine, of_prone};
  const auto in_prone = voxels_with(*images.masks.prone, 1);
  const SliceBox box = slice_box({&mask});
  std::string text = choice() + "<div class=\"viewers\">\n";
  for (const Orientation& orientation : orientations()) {
    const OutlinedSlice slice(orientation, box, mask, picture_width);
    const auto values = [&](const ShownImage& shown) {
      return sample(Panel{"", shown, {}}, slice.plane());
    };
    const auto of_supine = values(supine), of_carried = values(carried),
               of_scanned = values(scanned);
    const std::vector<bool> outline = slice.outline(voxels_with(moved, 1));
    text += viewer(slice, picture(slice, of_supine, of_supine),
                   {picture(slice, of_carried, of_carried, outline),
                    picture(slice, of_scanned, of_scanned, slice.outline(in_prone)),
                    picture(slice, of_carried, of_supine, outline)});
  }
  return text + "</div>\n<p>The yellow line is the outline of the supine breast as labelled, the "
                "blue one that of the prone breast, carried along or as scanned, where it is not "
                "the same; outside of an image it is dark grey.</p>\n";
}

} // namespace prosup::output
