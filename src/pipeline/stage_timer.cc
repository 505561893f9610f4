#include "prosup/pipeline/stage_timer.h"

#include <sys/resource.h>

namespace prosup::pipeline {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

StageTimer::StageTimer(MPI_Comm communicator, const Log& log)
    : communicator_(communicator), log_(log), start_(Clock::now()) {}

void StageTimer::run(const std::string& name, const std::function<void()>& stage) {
  const Clock::time_point start = Clock::now();
  const double set_aside_before = set_aside_;
  log_.line(name);
  stage();
  MPI_Barrier(communicator_);
  stages_.push_back({name, since(start) - (set_aside_ - set_aside_before)});
  log_.line(format("  %.1f s", stages_.back().seconds));
}

void StageTimer::set_aside(const std::function<void()>& work) {
  const Clock::time_point start = Clock::now();
  work();
  set_aside_ += since(start);
}

double StageTimer::seconds(const std::string& name) const {
  double sum = 0.;
  for (const Stage& stage : stages_)
    if (stage.name == name)
      sum += stage.seconds;
  return sum;
}

double StageTimer::total() const {
  return since(start_) - set_aside_;
}

std::string StageTimer::table() const {
  const double all = total();
  std::string text = format("%-24s %9s %6s\n", "Stage", "time (s)", "part");
  for (const Stage& stage : stages_)
    text += format("%-24s %9.1f %5.0f%%\n", stage.name.c_str(), stage.seconds,
                   100. * stage.seconds / all);
  return text + format("%-24s %9.1f", "Total", all);
}

double peak_memory(MPI_Comm communicator) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  double mebibytes = static_cast<double>(usage.ru_maxrss) / 1024.;
  MPI_Allreduce(MPI_IN_PLACE, &mebibytes, 1, MPI_DOUBLE, MPI_SUM, communicator);
  return mebibytes;
}

} // namespace prosup::pipeline
