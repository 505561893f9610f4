#include "checkpoints.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

#include "prosup/core/collective.h"
#include "prosup/core/exception_text.h"
#include "prosup/core/version.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;
using namespace dealii;

namespace {

constexpr double largest_part = 0.01; // of the time of a run, that checkpoints may take

const std::string advice = "run without --restart to begin from the start";

} // namespace

Checkpoints::Checkpoints(const std::string& command, const CheckpointParameters& parameters,
                         const ParameterHandler& all, const fs::path& output, MPI_Comm world,
                         const Log& log, Remarks& remarks)
    : kind_("checkpoint of " + command), parameters_(parameters), all_(all), output_(output),
      folder_(parameters.folder_for(output)), world_(world), log_(log), remarks_(remarks) {}

fs::path Checkpoints::file(unsigned slot) const {
  return folder_ / (slot == 0 ? "a.h5" : "b.h5");
}

std::unique_ptr<output::Hdf5Reader> Checkpoints::restart() {
  on_root(world_, [&] { identity_ = identity_of(all_); });
  identity_.inputs = Utilities::MPI::broadcast(world_, identity_.inputs);
  identity_.parameters = Utilities::MPI::broadcast(world_, identity_.parameters);
  bool exists[2] = {false, false};
  on_root(world_, [&] {
    exists[0] = fs::exists(file(0));
    exists[1] = fs::exists(file(1));
    if (parameters_.restart && !exists[0] && !exists[1] && fs::exists(output_ / "summary.json"))
      throw Error("The run into '" + output_.string() + "' has ended and left no checkpoint in '" +
                  folder_.string() + "'; run without --restart to repeat it.");
  });
  MPI_Bcast(exists, 2, MPI_CXX_BOOL, 0, world_);
  if (!parameters_.restart) {
    if (exists[0] || exists[1])
      log_.line("An earlier run left a checkpoint in " + folder_.string() +
                "; --restart would go on from there.");
    return nullptr;
  }
  int newest = -1;
  std::string damage;
  for (unsigned slot = 0; slot < 2; ++slot) {
    if (!exists[slot])
      continue;
    try {
      const output::Hdf5Reader reader(file(slot), kind_, world_, advice);
      const auto sequence = static_cast<unsigned>(reader.number("sequence"));
      if (newest < 0 || sequence > sequence_) {
        sequence_ = sequence;
        newest = static_cast<int>(slot);
      }
    } catch (const Error& error) {
      damage = error.what();
    }
  }
  if (newest < 0 && !damage.empty())
    throw Error(damage);
  if (!damage.empty())
    log_.line(damage.substr(0, damage.find(';')) + "; the other one is taken.");
  if (newest < 0) {
    log_.line("There is no checkpoint in " + folder_.string() + ": the run begins from the start.");
    return nullptr;
  }
  slot_ = 1 - static_cast<unsigned>(newest);
  auto reader = std::make_unique<output::Hdf5Reader>(file(1 - slot_), kind_, world_, advice);
  compare(*reader);
  log_.line("The run goes on from " + file(1 - slot_).string() + ".");
  return reader;
}

void Checkpoints::compare(const output::Hdf5Reader& checkpoint) const {
  const std::string where = "in the checkpoint '" + file(1 - slot_).string() + "'";
  if (const std::string written_by = checkpoint.text("version"); written_by != version())
    throw Error("This is version " + std::string(version()) + ", but " + written_by + " is named " +
                where + "; " + advice + ".");
  const std::string difference = first_difference(
      {checkpoint.text("parameters"), checkpoint.text("inputs")}, identity_, where);
  if (!difference.empty())
    throw Error(difference + ", or " + advice + ".");
}

bool Checkpoints::is_time() const {
  const double since = std::chrono::duration<double>(Clock::now() - last_).count();
  double wait = parameters_.interval;
  if (wait > 0. && n_kept_ > 0)
    wait = std::max(wait, seconds_ / n_kept_ / largest_part);
  return Utilities::MPI::broadcast(world_, int(parameters_.wanted && since >= wait)) != 0;
}

void Checkpoints::keep(const std::function<void(output::Hdf5Writer&)>& contents) {
  if (!is_time())
    return;
  const Clock::time_point start = Clock::now();
  try {
    write(contents);
  } catch (const Error& error) {
    if (Utilities::MPI::this_mpi_process(world_) == 0)
      remarks_.add("No checkpoint was written: " + text_of(error));
  }
  last_ = Clock::now();
  seconds_ += std::chrono::duration<double>(last_ - start).count();
  ++n_kept_;
}

void Checkpoints::write(const std::function<void(output::Hdf5Writer&)>& contents) {
  on_root(world_, [&] {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error)
      throw Error("The folder '" + folder_.string() + "' cannot be made: " + error.message() +
                  "; choose another with 'Checkpoint/Folder'.");
  });
  output::Hdf5Writer writer(file(slot_), kind_, world_);
  writer.text("version", version());
  writer.text("parameters", identity_.parameters);
  writer.text("inputs", identity_.inputs);
  writer.number("sequence", sequence_ + 1);
  contents(writer);
  writer.commit();
  // What is left of an earlier run, from which this one did not go on.
  std::error_code ignored;
  if (sequence_ == 0 && Utilities::MPI::this_mpi_process(world_) == 0)
    fs::remove(file(1 - slot_), ignored);
  ++sequence_;
  slot_ = 1 - slot_;
}

void Checkpoints::remove() {
  if (n_kept_ > 0)
    log_.line(format("%u checkpoint%s in %.2f s", n_kept_, n_kept_ == 1 ? "" : "s", seconds_));
  if (Utilities::MPI::this_mpi_process(world_) != 0)
    return;
  std::error_code ignored;
  for (const unsigned slot : {0u, 1u}) {
    fs::remove(file(slot), ignored);
    fs::remove(folder_ / ("." + file(slot).filename().string() + ".part"), ignored);
  }
  fs::remove(folder_ / log_of_failure, ignored);
  fs::remove(folder_, ignored); // if nothing else is in it
}

} // namespace prosup::pipeline
