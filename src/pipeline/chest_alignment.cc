#include "prosup/pipeline/chest_alignment.h"

#include <deal.II/base/numbers.h>

#include "prosup/core/collective.h"
#include "prosup/image/broadcast.h"

namespace prosup::pipeline {

using registration::Alignment;
using similarity::prone;
using similarity::supine;

namespace {

output::AlignmentSummary summary_of(const Alignment& alignment) {
  output::AlignmentSummary summary;
  summary.method = alignment.method;
  const dealii::Tensor<1, 3> rotation = alignment.transform.rotation_vector();
  for (unsigned d = 0; d < 3; ++d) {
    summary.translation[d] = alignment.transform.translation[d];
    summary.rotation_degrees[d] = 180. / dealii::numbers::PI * rotation[d];
  }
  summary.surface_before = alignment.surface.distance_before;
  summary.surface_after = alignment.surface.distance_after;
  if (alignment.intensities)
    summary.information = {alignment.intensities->information_before,
                           alignment.intensities->information_after};
  return summary;
}

} // namespace

std::optional<output::AlignmentSummary> align_chests(const registration::PreAlignment& method,
                                                     Inputs& inputs, const Log& log,
                                                     MPI_Comm communicator) {
  if (!method.wanted())
    return {};
  image::RigidTransform to_prone;
  std::optional<output::AlignmentSummary> summary;
  on_root(communicator, [&] {
    const Alignment alignment =
        method.run(inputs.originals[prone].image, inputs.originals[supine].image, inputs.scene);
    log.line(describe(alignment));
    to_prone = alignment.transform;
    summary = summary_of(alignment);
  });
  image::broadcast(to_prone, communicator);
  inputs.align_supine(to_prone);
  return summary;
}

} // namespace prosup::pipeline
