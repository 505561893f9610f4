#include "prosup/pipeline/result_run.h"

#include <deal.II/base/mpi.h>

#include "prosup/core/collective.h"
#include "prosup/core/parameters.h"
#include "prosup/core/version.h"
#include "run_files.h"

namespace prosup::pipeline {

using namespace dealii;

ResultRun::ResultRun(const std::string& command, const ParameterHandler& parameters,
                     const ResultTarget& output, MPI_Comm world)
    : world_(world), parameters_(parameters), output_(output.folder), log_(world), remarks_(log_),
      timer_(world, log_) {
  summary_.command = command;
  summary_.ranks = Utilities::MPI::n_mpi_processes(world);
  log_.line(format("prosup %s, deal.II %s, %u rank%s", version(), dealii_version(), summary_.ranks,
                   summary_.ranks == 1 ? "" : "s"));
  std::string path;
  on_root(world_, [&] {
    result_ = std::make_unique<ResultFolder>(output, files_written(command, parameters));
    path = result_->path().string();
  });
  folder_ = Utilities::MPI::broadcast(world_, path);
  // If rank 0 was killed, the others clear away what it has left.
  if (result_ == nullptr)
    unfinished_ = std::make_unique<Unfinished>([this] { ResultFolder::clear_leftover(output_); });
}

bool ResultRun::finish(const std::string& report, const std::function<void()>& write_last) {
  summary_.peak_memory = peak_memory(world_);
  on_root(world_, [&] {
    summary_.time.total = timer_.total();
    summary_.warnings = remarks_.all();
    write_parameters(parameters_, folder_ / "used.prm");
    output::write_summary(summary_, folder_ / "summary.json");
    write_last();
    result_->commit();
    log_.line("\n" + timer_.table());
    if (!report.empty())
      log_.line("\n" + report);
    log_.line("\nResults are in " + output_.string());
  });
  return Utilities::MPI::broadcast(world_, static_cast<int>(summary_.converged)) != 0;
}

} // namespace prosup::pipeline
