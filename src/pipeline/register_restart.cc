// How a registration is kept, and goes on from there.

#include <deal.II/base/mpi.h>

#include "checkpoints.h"
#include "prosup/pipeline/register_pipeline.h"
#include "run_record.h"
#include "state_hdf5.h"

namespace prosup::pipeline {

using namespace dealii;

void RegisterPipeline::stage(const char* name, registration::Stage done,
                             std::optional<double>& seconds, const std::function<void()>& work) {
  if (registration_.stage() >= done)
    return;
  run_.stage(name, work);
  seconds = seconds.value_or(0.) + run_.seconds(name);
  keep();
}

void RegisterPipeline::restart() {
  const auto checkpoint = checkpoints_ ? checkpoints_->restart() : nullptr;
  if (!checkpoint)
    return;
  registration_.resume(read_registration_state(*checkpoint));
  set_record(checkpoint->text("record"), run_.summary(), quality_, convergence_);
  note_properties();
  std::optional<evaluation::ErrorStatistics> known;
  evaluate(known);
}

void RegisterPipeline::keep() {
  if (checkpoints_)
    checkpoints_->keep([this](output::Hdf5Writer& file) {
      const MPI_Comm world = registration_.ranks().world();
      write_state(file, registration_.state(), world);
      file.text("record", Utilities::MPI::broadcast(
                              world, record_of(run_.summary(), quality_, convergence_)));
    });
}

} // namespace prosup::pipeline
