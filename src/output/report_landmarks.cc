#include "report_landmarks.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "html.h"
#include "point_labels.h"
#include "prosup/core/log.h"
#include "prosup/evaluation/landmarks_csv.h"
#include "prosup/output/registration_file.h"
#include "slice_plane.h"
#include "svg.h"

namespace prosup::output {

namespace {

using evaluation::LandmarkError;

constexpr double pixels_per_mm = 3.;
constexpr double margin = 22.;      // pixels, for the letters
constexpr double longest = 15.;     // mm on the picture, of most vectors
constexpr std::size_t n_labels = 5; // of the largest errors
constexpr const char *red = "#b2182b", *ink = "#1c2430", *tissue = "#e3e8ee";

/// The largest of 1, 2, 5, 10, 20... times `smallest` that is not above `value`, or `smallest`.
double round_number(double value, double smallest) {
  double found = smallest;
  for (unsigned i = 0; i < 12; ++i) {
    constexpr double steps[] = {1., 2., 5.};
    const double candidate = smallest * steps[i % 3] * std::pow(10., i / 3);
    if (candidate <= value)
      found = candidate;
  }
  return found;
}

/// Where the vector of a landmark ends.
Point<3> tip_of(const LandmarkError& landmark, double magnified) {
  const auto& [prone, supine] = *landmark.unloaded;
  return supine + magnified * (prone - supine);
}

/// One direction of view.
class View {
public:
  /// Shows all of these points.
  View(const Orientation& orientation, const std::vector<Point<3>>& points)
      : orientation_(orientation), low_(points.front()), high_(low_) {
    for (const Point<3>& point : points)
      for (unsigned d = 0; d < 3; ++d) {
        low_[d] = std::min(low_[d], point[d]);
        high_[d] = std::max(high_[d], point[d]);
      }
  }

  double width() const {
    return pixels_per_mm * (high_[orientation_.across] - low_[orientation_.across]) + 2. * margin;
  }
  double height() const {
    return pixels_per_mm * (high_[orientation_.down] - low_[orientation_.down]) + 2. * margin;
  }

  double x(const Point<3>& p) const {
    return margin + pixels_per_mm * (p[orientation_.across] - low_[orientation_.across]);
  }
  double y(const Point<3>& p) const {
    const unsigned down = orientation_.down;
    return margin + pixels_per_mm *
                        (orientation_.down_reversed ? high_[down] - p[down] : p[down] - low_[down]);
  }

  /// The faces that look at the reader, which together are the outline of the breast.
  std::string breast(const mesh::UnloadedMesh& mesh) const {
    std::string path = format("<path fill=\"%s\" d=\"", tissue);
    for (const mesh::BoundaryFace& face : mesh.mesh.boundary_faces) {
      const auto [a, b, c] = face.nodes;
      const Point<3>&A = mesh.unloaded[a], &B = mesh.unloaded[b], &C = mesh.unloaded[c];
      if ((x(B) - x(A)) * (y(C) - y(A)) - (x(C) - x(A)) * (y(B) - y(A)) > 0.)
        path += format("M%.0f %.0fL%.0f %.0fL%.0f %.0fz", x(A), y(A), x(B), y(B), x(C), y(C));
    }
    return path + "\"/>\n";
  }

  std::string letters() const {
    const double middle_x = width() / 2., middle_y = height() / 2.;
    return svg::text(2., middle_y, "start", orientation_.left) +
           svg::text(width() - 2., middle_y, "end", orientation_.right) +
           svg::text(middle_x, 12., "middle", orientation_.top) +
           svg::text(middle_x, height() - 4., "middle", orientation_.bottom);
  }

private:
  const Orientation& orientation_;
  Point<3> low_, high_;
};

/// `landmarks` with the largest error first.
std::string vectors(const View& view, const std::vector<LandmarkError>& landmarks,
                    double magnified) {
  std::string text;
  PointLabels labels(0., view.width());
  for (const LandmarkError& landmark : landmarks) {
    const Point<3>&supine = landmark.unloaded->supine, tip = tip_of(landmark, magnified);
    text += svg::line(view.x(supine), view.y(supine), view.x(tip), view.y(tip), red) +
            format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.5\" fill=\"%s\"/>\n", view.x(supine),
                   view.y(supine), ink);
  }
  for (std::size_t i = 0; i < std::min(landmarks.size(), n_labels); ++i) {
    const Point<3>& supine = landmarks[i].unloaded->supine;
    labels.occupy(view.x(supine), view.y(supine), 2.);
    text += labels.place(view.x(supine), view.y(supine), landmarks[i].id, ink);
  }
  return text;
}

/// What `error` mm look like, at the lower left.
std::string scale_bar(const View& view, double error, double magnified) {
  const double y = view.height() - 6.;
  return svg::line(margin, y, margin + pixels_per_mm * magnified * error, y, red) +
         svg::text(margin, y - 5., "start", format("%g mm", error), format(" fill=\"%s\"", red));
}

} // namespace

std::string landmark_vectors(const std::filesystem::path& landmarks,
                             const std::filesystem::path& registration) {
  if (!std::filesystem::exists(landmarks) || !std::filesystem::exists(registration))
    return "";
  std::vector<LandmarkError> shown = evaluation::read_errors(landmarks);
  if (shown.empty() || !shown.front().unloaded)
    return "";
  std::sort(shown.begin(), shown.end(),
            [](const auto& a, const auto& b) { return a.error > b.error; });
  const mesh::UnloadedMesh breast = read_registration(registration, Position::supine);
  // All but the largest twentieth are seen in full beside each other.
  const double most = shown[shown.size() / 20].error;
  const double magnified = round_number(longest / std::max(most, 1e-6), 1.);
  const double bar = round_number(most, 0.01);
  std::string text =
      format("<p>Each dot is a landmark of the supine image in the unloaded breast. "
             "The line leads to where the prone image has it%s; those with the "
             "largest errors have their names.</p>\n<div class=\"viewers\">\n",
             magnified > 1. ? format(", drawn %g times as long", magnified).c_str() : "");
  std::vector<Point<3>> points = breast.unloaded;
  for (const LandmarkError& landmark : shown)
    points.push_back(tip_of(landmark, magnified));
  for (const Orientation& orientation : orientations()) {
    const View view(orientation, points);
    const std::string attributes =
        format(" font-family=\"sans-serif\" font-size=\"12\" fill=\"%s\" role=\"img\" "
               "aria-label=\"%s view of the errors at landmarks\"",
               ink, orientation.name);
    const std::string drawn = view.breast(breast) + vectors(view, shown, magnified) +
                              view.letters() + scale_bar(view, bar, magnified);
    text += html::figure(orientation.name, view.width() / pixels_per_mm,
                         svg::start(int(view.width()), int(view.height()), attributes) + drawn +
                             "</svg>\n");
  }
  return text + "</div>\n";
}

} // namespace prosup::output
