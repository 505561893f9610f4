// How far prosup prepare is from labels that are known: one row of the table in docs/prepare.md for
// each scan.

#include <algorithm>
#include <cmath>

#include "prosup/core/quantile.h"
#include "prosup/prepare/preparation.h"
#include "setup.h"

using namespace prosup;
using image::LabelImage;
using image::ScalarImage;

namespace {

constexpr double widest = 50. * 3.14159265358979323846 / 180.; // from the front
constexpr double ends = 8.;                                    // mm, of the image

/// Where the labels are compared: in front, and not at the ends of the image.
class Region {
public:
  explicit Region(const LabelImage& truth)
      : grid_(truth.grid), axis_(prepare::find_trunk_axis(image::select_labels(truth, {1, 2, 3}))) {
  }

  bool contains(std::size_t i, std::size_t j, std::size_t k) const {
    const std::size_t at[3] = {i, j, k};
    for (unsigned d = 0; d < 3; ++d)
      if (double(std::min(at[d], grid_.size[d] - 1 - at[d])) * grid_.spacing[d] < ends)
        return false;
    return std::abs(axis_.angle(grid_.physical(double(i), double(j), double(k)))) < widest;
  }

private:
  const image::VoxelGrid& grid_;
  const prepare::TrunkAxis axis_;
};

/// Distances of a surface that was found to the true one, mm, positive to the outside.
struct Distances {
  std::vector<double> values;

  double signed_mean() const {
    double sum = 0.;
    for (const double value : values)
      sum += value;
    return sum / double(std::max<std::size_t>(1, values.size()));
  }
  std::string row() const {
    std::vector<double> sizes;
    double sum = 0.;
    for (const double value : values) {
      sizes.push_back(std::abs(value));
      sum += std::abs(value);
    }
    const double n = double(std::max<std::size_t>(1, sizes.size()));
    return format("%.2f (%.1f), %+.2f", sum / n, sizes.empty() ? 0. : quantile(sizes, 0.95),
                  signed_mean());
  }
};

/// Of the faces between voxels of `inner` and of `outer` labels of what was found, to the surface
/// of the true mask.
Distances distances(const LabelImage& found, const LabelImage& true_mask, const Region& region,
                    bool (*inner)(unsigned), bool (*outer)(unsigned)) {
  const ScalarImage distance = image::signed_distance(true_mask);
  const auto& size = found.grid.size;
  const std::size_t stride[3] = {1, size[0], size[0] * size[1]};
  Distances result;
  std::size_t v = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i, ++v) {
        if (!region.contains(i, j, k))
          continue;
        const std::size_t at[3] = {i, j, k};
        for (unsigned d = 0; d < 3; ++d) {
          if (at[d] + 1 == size[d])
            continue;
          const unsigned a = found.values[v], b = found.values[v + stride[d]];
          if ((inner(a) && outer(b)) || (inner(b) && outer(a)))
            result.values.push_back(0.5 *
                                    double(distance.values[v] + distance.values[v + stride[d]]));
        }
      }
  return result;
}

bool is_air(unsigned label) {
  return label == 0;
}
bool is_chest(unsigned label) {
  return label == 1;
}
bool is_breast(unsigned label) {
  return label >= 2;
}

/// Overlap of labels not below `least`, and the ratio of their volumes, found to true.
std::string overlap(const LabelImage& found, const LabelImage& truth, const Region& region,
                    unsigned least) {
  double both = 0., n_found = 0., n_true = 0.;
  std::size_t v = 0;
  const auto& size = found.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i, ++v) {
        const bool a = found.values[v] >= least, b = truth.values[v] >= least;
        if ((!a && !b) || !region.contains(i, j, k))
          continue;
        both += a && b;
        n_found += a;
        n_true += b;
      }
  return format("%.3f (%.2f)", 2. * both / std::max(1., n_found + n_true),
                n_found / std::max(1., n_true));
}

void measure(const std::string& scan, const std::string& labels,
             const prepare::Preparation& preparation) {
  const LabelImage truth = image::read_labels(labels);
  const prepare::PreparedScan prepared = preparation.run(image::read_image(scan), Log());
  const LabelImage& found = prepared.labels;
  if (!found.grid.coincides_with(truth.grid))
    throw Error(
        format("The labels '%s' do not lie on the voxels of '%s'.", labels.c_str(), scan.c_str()));
  const Region region(truth);
  std::printf(
      "| %s | %s | %s | %s | %s | %zu |\n", scan.c_str(),
      distances(found, image::select_labels(truth, {1}), region, is_chest, is_breast).row().c_str(),
      distances(found, image::select_labels(truth, {1, 2, 3}), region, is_breast, is_air)
          .row()
          .c_str(),
      overlap(found, truth, region, 2).c_str(), overlap(found, truth, region, 3).c_str(),
      prepared.confidence.doubts.size());
  const prepare::Confidence& confidence = prepared.confidence;
  std::fprintf(stderr,
               "%s: cut off %.2f of the largest section; solid part of radius %.1f mm, %.0f ml, "
               "deviation %.2f; unknown beyond %.1f cm^2\n",
               scan.c_str(), confidence.cut_share, confidence.solid.radius, confidence.solid.volume,
               confidence.solid.deviation, prepared.unknown_contact);
  std::fflush(stdout);
  for (const std::string& doubt : prepared.confidence.doubts)
    std::fprintf(stderr, "%s: %s\n", scan.c_str(), doubt.c_str());
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Distances and overlaps of prepared scans to labels that are known.",
               "benchmark_preparation");
  std::vector<std::string> files, overrides;
  app.add_option("FILES", files, "scans and their labels, in turns")->required();
  app.add_option("--set", overrides, "parameters, Section/Entry=value")->allow_extra_args(false);
  return benchmarks::run_program(argc, argv, app, [&] {
    if (files.size() % 2 != 0)
      throw Error("The files are scans and their labels, in turns; give an even number of them.");
    const Labels labels;
    const prepare::Preparation preparation(labels);
    dealii::ParameterHandler parameters;
    read_parameters(parameters, {}, overrides);
    std::printf("| scan | chest wall: mean (95th), signed | skin | breast: Dice (volumes) | gland "
                "| doubts |\n|---|---|---|---|---|---|\n");
    for (std::size_t i = 0; i < files.size(); i += 2)
      measure(files[i], files[i + 1], preparation);
  });
}
