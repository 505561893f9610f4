#include <algorithm>

#include "prosup/core/output_file.h"
#include "prosup/core/remarks.h"
#include "prosup/core/text.h"
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

/// Says which points lay outside, once for each that did.
void say_outside(const std::vector<std::string>& ids, Remarks& remarks) {
  if (ids.empty())
    return;
  constexpr std::size_t n_named = 5;
  const std::vector<std::string> first(ids.begin(),
                                       ids.begin() + long(std::min(ids.size(), n_named)));
  remarks.add(format("%zu times a point lay more than %g mm outside the mesh (%s%s); it was moved "
                     "with the closest point of the mesh.",
                     ids.size(), far_outside, joined(first).c_str(),
                     ids.size() > n_named ? " and others" : ""));
}

/// Gives points that are in the unloaded state the error bars that they will have.
void add_error_bars(const MapRequest& request, const evaluation::Uncertainty& uncertainty,
                    std::vector<evaluation::NamedPoint>& points) {
  for (evaluation::NamedPoint& point : points) {
    evaluation::Covariance covariance; // none where points stay
    if (request.from != request.to)
      covariance = request.to == "unloaded"
                       ? uncertainty.unloaded(point.position)
                       : uncertainty.loaded(point.position, request.to == name_of(Position::prone)
                                                                ? Position::prone
                                                                : Position::supine);
    point.error = evaluation::error_bar(covariance);
  }
}

} // namespace

void run_map(const MapRequest& request) {
  require_finished(request.result);
  const evaluation::PointFormat format = evaluation::output_format(request.output);
  const bool is_csv = format == evaluation::PointFormat::csv;
  Remarks remarks{Log(MPI_COMM_SELF)}; // standard output may be where the points go
  std::vector<evaluation::NamedPoint> points = evaluation::read_points(request.points, remarks);
  const auto covariances = read_covariances(request.result);
  OutputFile output(request.output, {{request.points},
                                     request.overwrite,
                                     is_csv ? evaluation::points_header : "",
                                     is_csv ? evaluation::points_with_errors_header : ""});
  const PointMapper prone = read_mapper(request.result, name_of(Position::prone)),
                    supine = read_mapper(request.result, name_of(Position::supine));
  const auto mapper_of = [&](const std::string& state) -> const PointMapper& {
    return state == name_of(Position::prone) ? prone : supine;
  };
  std::vector<std::string> outside;
  const auto apply = [&](const PointMapper& mapper, evaluation::Configuration from) {
    for (evaluation::NamedPoint& point : points) {
      const MappedPoint mapped = mapper.map(point.position, from);
      if (mapped.distance_outside > far_outside)
        outside.push_back("'" + shown(point.id) + "'");
      point.position = mapped.position;
    }
  };
  if (request.from != "unloaded" && request.from != request.to)
    apply(mapper_of(request.from), evaluation::Configuration::loaded);
  if (covariances)
    add_error_bars(request, evaluation::Uncertainty(prone, supine, *covariances), points);
  if (request.to != "unloaded" && request.from != request.to)
    apply(mapper_of(request.to), evaluation::Configuration::unloaded);
  say_outside(outside, remarks);
  evaluation::write_points(points, output.path(), format);
  output.commit();
}

} // namespace prosup::pipeline
