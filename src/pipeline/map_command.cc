#include <cstdio>
#include <map>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/evaluation/points.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/commands.h"

namespace prosup::pipeline {

using dealii::Point;
using evaluation::MappedPoint;
using evaluation::PointMapper;

namespace {

constexpr double far_outside = 2.; // mm: more than the mesh's own error at the skin

void require_file(const MapRequest& request, const std::string& name) {
  if (!std::filesystem::exists(request.result / name))
    throw Error("The folder '" + request.result.string() + "' holds no finished registration (no " +
                name + "); give the --output folder of prosup register.");
}

PointMapper mapper_of(const MapRequest& request, const std::string& state) {
  const std::string name = state + "_loaded.vtu";
  require_file(request, name);
  return PointMapper(output::read_mesh(request.result / name));
}

} // namespace

void run_map(const MapRequest& request) {
  require_file(request, "summary.json");
  std::vector<evaluation::NamedPoint> points = evaluation::read_points(request.points);
  std::size_t n_outside = 0;
  const auto apply = [&](const PointMapper& mapper, evaluation::State from) {
    for (evaluation::NamedPoint& point : points) {
      const MappedPoint mapped = mapper.map(point.position, from);
      n_outside += mapped.distance_outside > far_outside;
      point.position = mapped.position;
    }
  };
  if (request.from != "unloaded" && request.from != request.to)
    apply(mapper_of(request, request.from), evaluation::State::loaded);
  if (request.to != "unloaded" && request.from != request.to)
    apply(mapper_of(request, request.to), evaluation::State::unloaded);
  if (n_outside > 0)
    std::fprintf(stderr,
                 "prosup: %zu times a point lay more than %g mm outside the mesh; it was moved "
                 "with the closest point of the mesh.\n",
                 n_outside, far_outside);
  evaluation::write_points(points, request.output);
}

} // namespace prosup::pipeline
