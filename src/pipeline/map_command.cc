#include "nipples.h"
#include "prosup/core/output_file.h"
#include "prosup/core/remarks.h"
#include "prosup/evaluation/points.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/finished_result.h"
#include "state_map.h"

namespace prosup::pipeline {

using evaluation::NamedPoint;
using evaluation::PointFormat;

namespace {

/// The error bar that a point with this unloaded position has in the state it is mapped to.
evaluation::ErrorBar error_bar(const MapRequest& request,
                               const evaluation::Uncertainty& uncertainty,
                               const dealii::Point<3>& unloaded) {
  evaluation::Covariance covariance; // none where points stay
  if (request.from != request.to)
    covariance = request.to == unloaded_state
                     ? uncertainty.unloaded(unloaded)
                     : uncertainty.loaded(unloaded, request.to == name_of(Position::prone)
                                                        ? Position::prone
                                                        : Position::supine);
  return evaluation::error_bar(covariance);
}

std::optional<double> distance(const std::optional<dealii::Point<3>>& from,
                               const dealii::Point<3>& to) {
  return from ? std::optional<double>(from->distance(to)) : std::nullopt;
}

void map(const MapRequest& request, std::vector<NamedPoint>& points, Remarks& remarks) {
  const StateMap map(request.result, request.from, request.to);
  const auto covariances = read_covariances(request.result);
  std::optional<evaluation::Uncertainty> uncertainty;
  if (covariances)
    uncertainty.emplace(map.mapper(Position::prone), map.mapper(Position::supine), *covariances);
  const Nipples nipples = find_nipples(map, request.nipples, remarks);
  OutsideReport outside;
  for (NamedPoint& point : points) {
    const MappedState mapped = map(point.position);
    if (uncertainty && mapped.outside <= evaluation::far_outside)
      point.error = error_bar(request, *uncertainty, mapped.unloaded);
    point.figures = {
        map.volume_ratio(mapped.unloaded),        mapped.outside,
        map.depth_before(point.position),         map.depth_after(mapped.position),
        distance(nipples.before, point.position), distance(nipples.after, mapped.position)};
    point.position = mapped.position;
    outside.look_at(point.id, mapped.outside);
  }
  outside.say(remarks);
}

} // namespace

void run_map(const MapRequest& request) {
  require_finished(request.result);
  const PointFormat format = evaluation::output_format(request.output);
  Remarks remarks{Log(MPI_COMM_SELF)}; // standard output may be where the points go
  std::vector<NamedPoint> points = evaluation::read_points(request.points, remarks);
  OutputFileRules rules{{request.points}, request.overwrite, ""};
  if (format == PointFormat::csv)
    rules = {{request.points},
             request.overwrite,
             evaluation::points_header,
             evaluation::points_headers()};
  OutputFile output(request.output, rules);
  map(request, points, remarks);
  if (format == PointFormat::mrk_json &&
      evaluation::point_format(request.points) == PointFormat::mrk_json)
    evaluation::write_markups_like(request.points, points, output.path());
  else
    evaluation::write_points(points, output.path(), format);
  output.commit();
}

} // namespace prosup::pipeline
