#include "prosup/pipeline/result_run.h"

#include <deal.II/base/mpi.h>

#include "prosup/core/collective.h"
#include "prosup/core/exception_text.h"
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
  std::string path;
  on_root(world_, [&] {
    result_ = std::make_unique<ResultFolder>(output, files_written(command, parameters));
    path = result_->path().string();
  });
  folder_ = Utilities::MPI::broadcast(world_, path);
  // If rank 0 was killed, the others clear away what it has left.
  if (result_ == nullptr)
    unfinished_ = std::make_unique<Unfinished>([this] { ResultFolder::clear_leftover(output_); });
  on_root(world_, [&] { log_file_ = std::make_unique<LogFile>(folder_ / log_txt); });
  if (std::error_code ignored; log_file_ == nullptr && std::filesystem::exists(folder_, ignored))
    log_file_ = std::make_unique<LogFile>(folder_ / log_txt); // other hosts need not see the folder
  log_.line(format("prosup %s, deal.II %s, %u rank%s", version(), dealii_version(), summary_.ranks,
                   summary_.ranks == 1 ? "" : "s"));
}

ResultRun::~ResultRun() {
  const auto lock = uninterrupted();
  if (unsaved_log_)
    save_log();
  unsaved_log_.reset();
}

void ResultRun::keep_log_of_failure(const std::filesystem::path& file) {
  log_of_failure_ = file;
  if (result_ != nullptr)
    unsaved_log_ = std::make_unique<Unfinished>([this] {
      LogFile::add("Error: The run was ended.");
      save_log();
    });
}

void ResultRun::save_log() const {
  std::error_code ignored;
  if (std::filesystem::is_directory(log_of_failure_.parent_path(), ignored))
    std::filesystem::copy_file(folder_ / log_txt, log_of_failure_,
                               std::filesystem::copy_options::overwrite_existing, ignored);
}

void ResultRun::stage(const std::string& name, const std::function<void()>& work) {
  try {
    timer_.run(name, work);
  } catch (const std::exception& error) {
    if (log_.speaks())
      LogFile::add("Error: " + text_of(error));
    throw;
  }
}

bool ResultRun::finish(const std::string& report, const std::function<void()>& write_last) {
  summary_.peak_memory = peak_memory(world_);
  on_root(world_, [&] {
    summary_.time.total = timer_.total();
    summary_.warnings = remarks_.all();
    write_parameters(parameters_, folder_ / "used.prm");
    output::write_summary(summary_, folder_ / "summary.json");
    write_last();
    log_.line("\n" + timer_.table());
    if (!report.empty())
      log_.line("\n" + report);
    log_file_->close();
    result_->commit();
    unsaved_log_.reset();
    log_.line("\nResults are in " + output_.string());
  });
  return Utilities::MPI::broadcast(world_, static_cast<int>(summary_.converged)) != 0;
}

} // namespace prosup::pipeline
