#include <cstdio>

#include "prosup/core/output_file.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/evaluation/points.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/finished_result.h"
#include "table_output.h"

namespace prosup::pipeline {

using evaluation::MappedPoint;
using evaluation::PointMapper;

namespace {

constexpr double far_outside = 2.; // mm: more than the mesh's own error at the skin

} // namespace

void run_map(const MapRequest& request) {
  require_finished(request.result);
  require_csv(request.output);
  OutputFile output(request.output,
                    {{request.points}, request.overwrite, evaluation::points_header});
  std::vector<evaluation::NamedPoint> points = evaluation::read_points(request.points);
  std::size_t n_outside = 0;
  const auto apply = [&](const PointMapper& mapper, evaluation::Configuration from) {
    for (evaluation::NamedPoint& point : points) {
      const MappedPoint mapped = mapper.map(point.position, from);
      n_outside += mapped.distance_outside > far_outside;
      point.position = mapped.position;
    }
  };
  if (request.from != "unloaded" && request.from != request.to)
    apply(read_mapper(request.result, request.from), evaluation::Configuration::loaded);
  if (request.to != "unloaded" && request.from != request.to)
    apply(read_mapper(request.result, request.to), evaluation::Configuration::unloaded);
  if (n_outside > 0)
    std::fprintf(stderr,
                 "prosup: %zu times a point lay more than %g mm outside the mesh; it was moved "
                 "with the closest point of the mesh.\n",
                 n_outside, far_outside);
  evaluation::write_points(points, output.path());
  output.commit();
}

} // namespace prosup::pipeline
