#include "report_deformation.h"

#include <algorithm>
#include <cmath>

#include "colours.h"
#include "html.h"
#include "outlined_slice.h"
#include "prosup/core/log.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/output/registration_file.h"
#include "svg.h"

namespace prosup::output {

namespace {

constexpr int picture_width = 400;
constexpr double grid_step = 10.; // mm
constexpr double largest_J = 1.5; // of the scale, which begins at its reciprocal
constexpr double n_colours = 24.; // of a scale; few, for small files
constexpr Colour line_colour{0, 0, 0};

/// What a pixel shows of the supine breast.
struct Tissue {
  bool is_inside = false;
  double volume_ratio = 1.; ///< J of supine over prone
  Point<3> prone;           ///< where it was, moved along with the chest to supine, LPS mm
  double distance = 0.;     ///< from there, mm
};

/// A finished registration, seen from supine.
class SupineTissue {
public:
  explicit SupineTissue(const std::filesystem::path& registration)
      : prone_(read_registration(registration, Position::prone)),
        supine_(read_registration(registration, Position::supine)),
        chest_to_supine_(read_alignment(registration).value_or(image::RigidTransform()).inverse()) {
  }

  Tissue operator()(const Point<3>& x) const {
    const auto found = supine_.map(x, evaluation::Configuration::loaded);
    if (found.distance_outside > 0.)
      return {};
    const Point<3>& X = found.position;
    const Point<3> prone = chest_to_supine_(prone_.to_loaded(X));
    return {true, supine_.place(X).volume_ratio / prone_.place(X).volume_ratio, prone,
            prone.distance(x)};
  }

private:
  const evaluation::PointMapper prone_, supine_;
  const image::RigidTransform chest_to_supine_;
};

/// One of three planes.
struct DeformedSlice {
  const Orientation* orientation;
  OutlinedSlice slice;
  std::vector<Tissue> tissue; ///< row by row

  /// Whether a line of the grid lies between this pixel and that below or right of it.
  bool is_line(int column, int row) const {
    const Tissue& here = tissue[slice.pixel(column, row)];
    const auto crosses = [&](int other_column, int other_row) {
      if (other_column >= slice.plane().width() || other_row >= slice.plane().height())
        return false;
      const Tissue& there = tissue[slice.pixel(other_column, other_row)];
      const auto differs = [&](unsigned axis) {
        return std::floor(here.prone[axis] / grid_step) !=
               std::floor(there.prone[axis] / grid_step);
      };
      return there.is_inside && (differs(orientation->across) || differs(orientation->down));
    };
    return here.is_inside && (crosses(column + 1, row) || crosses(column, row + 1));
  }
};

std::vector<DeformedSlice> deformed_slices(const SupineTissue& tissue_at,
                                           const image::LabelImage& mask) {
  const SliceBox box = slice_box({&mask});
  std::vector<DeformedSlice> slices;
  for (const Orientation& orientation : orientations()) {
    DeformedSlice& made = slices.emplace_back(
        DeformedSlice{&orientation, {orientation, box, mask, picture_width}, {}});
    const SlicePlane& plane = made.slice.plane();
    for (int row = 0; row < plane.height(); ++row)
      for (int column = 0; column < plane.width(); ++column)
        made.tissue.push_back(
            made.slice.is_breast(column, row) ? tissue_at(plane.position(column, row)) : Tissue());
  }
  return slices;
}

/// Values from `low` to `high` as colours.
struct ColourScale {
  double low, high;
  bool is_logarithmic; ///< from blue over white at 1 to red; else from dark to bright
  std::vector<double> ticks;

  /// Where a value lies, from 0 to 1.
  double place(double value) const {
    return is_logarithmic ? std::log(value / low) / std::log(high / low)
                          : (value - low) / (high - low);
  }

  Colour colour(double value) const { return colour_at(place(value)); }

  Colour colour_at(double place) const {
    const double step = std::round(std::clamp(place, 0., 1.) * n_colours) / n_colours;
    return is_logarithmic ? blue_white_red(2. * step - 1.) : dark_to_bright(step);
  }

  std::string svg(const std::string& name) const {
    constexpr double width = 400., left = 30., bar = 14.;
    std::string text = svg::start(int(width + 2. * left), 36,
                                  " class=\"scale\" font-size=\"12\" fill=\"#1c2430\" role=\"img\" "
                                  "aria-label=\"" +
                                      html::escaped(name) + "\"");
    const double step = width / (n_colours + 1.);
    for (double i = 0.; i <= n_colours; ++i) {
      const Colour c = colour_at(i / n_colours);
      text += format("<rect x=\"%.1f\" width=\"%.1f\" height=\"%.0f\" fill=\"#%02x%02x%02x\"/>\n",
                     left + i * step, step + 0.5, bar, c[0], c[1], c[2]);
    }
    text += format("<rect x=\"%.1f\" width=\"%.1f\" height=\"%.0f\" fill=\"none\" "
                   "stroke=\"#888\"/>\n",
                   left, width, bar);
    for (const double tick : ticks)
      text += svg::text(left + place(tick) * width, bar + 16., "middle", format("%.3g", tick));
    return text + "</svg>\n";
  }
};

/// From 0 to a round number of mm beyond `farthest`.
ColourScale distance_scale(double farthest) {
  const double step = farthest <= 25. ? 5. : farthest <= 50. ? 10. : 20.;
  ColourScale scale{0., 0., false, {0.}};
  do {
    scale.high += step;
    scale.ticks.push_back(scale.high);
  } while (scale.high < farthest);
  return scale;
}

/// All that is in the breast, from small to large.
template <typename Get>
std::vector<double> sorted(const std::vector<DeformedSlice>& slices, Get get) {
  std::vector<double> values;
  for (const DeformedSlice& slice : slices)
    for (const Tissue& tissue : slice.tissue)
      if (tissue.is_inside)
        values.push_back(get(tissue));
  std::sort(values.begin(), values.end());
  return values;
}

double percentile(const std::vector<double>& sorted_values, double share) {
  return sorted_values[static_cast<std::size_t>(share * double(sorted_values.size() - 1))];
}

template <typename Get>
std::string row_of(const std::vector<DeformedSlice>& slices, const std::string& title,
                   const std::string& caption, const ColourScale& scale, bool with_grid, Get get) {
  std::string text = "<h3>" + html::escaped(title) + "</h3>\n<p>" + html::escaped(caption) +
                     "</p>\n" + scale.svg(title) + "<div class=\"viewers\">\n";
  for (const DeformedSlice& slice : slices) {
    const std::string plane = slice.orientation->name;
    const std::string picture = slice.slice.picture([&](int column, int row) {
      const Tissue& tissue = slice.tissue[slice.slice.pixel(column, row)];
      if (!tissue.is_inside)
        return no_data_colour;
      return with_grid && slice.is_line(column, row) ? line_colour : scale.colour(get(tissue));
    });
    text += html::figure(plane, slice.slice.plane().width_mm(),
                         "<img alt=\"" + plane + " slice: " + html::escaped(title) + "\" src=\"" +
                             picture + "\">");
  }
  return text + "</div>\n";
}

} // namespace

std::string report_deformation(const std::filesystem::path& registration,
                               const image::LabelImage& supine_mask) {
  const std::vector<DeformedSlice> slices =
      deformed_slices(SupineTissue(registration), supine_mask);
  const auto volume_ratio = [](const Tissue& tissue) { return tissue.volume_ratio; };
  const auto distance = [](const Tissue& tissue) { return tissue.distance; };
  const std::vector<double> ratios = sorted(slices, volume_ratio), moved = sorted(slices, distance);
  if (ratios.empty())
    return "<p>The supine mesh lies beside the breast as labelled: there is nothing to see.</p>\n";
  return row_of(slices, "Change of volume from prone to supine, J",
                format("Blue tissue is compressed in supine, red is expanded. In these slices J is "
                       "%.2f on the median, and 90 %% lie from %.2f to %.2f.",
                       percentile(ratios, 0.5), percentile(ratios, 0.05), percentile(ratios, 0.95)),
                {1. / largest_J, largest_J, true, {0.667, 0.8, 1., 1.25, 1.5}}, false,
                volume_ratio) +
         row_of(slices, "Displacement from prone to supine relative to the chest, mm",
                format("Lines were straight in prone, 10 mm apart. The median is %.1f mm, the "
                       "largest %.1f mm in these slices.",
                       percentile(moved, 0.5), moved.back()),
                distance_scale(percentile(moved, 0.98)), true, distance);
}

} // namespace prosup::output
