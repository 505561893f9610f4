#include "comparison_runs.h"

#include <algorithm>
#include <cctype>

#include "prosup/core/error.h"
#include "prosup/evaluation/landmarks.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/pipeline/outcome.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;
using Row = output::ComparisonRow;

namespace {

/// A name of a file that tells which run it belongs to.
std::string file_name(const Row& row) {
  std::string name = row.group + "_" + row.name + "_" + std::to_string(row.ranks);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-')
      c = '_';
  return name;
}

/// Libraries with threads of their own take as many as they are given, so that the
/// number of ranks, or threads of a peer, is what a run has.
std::vector<std::string> with_threads(unsigned n) {
  std::vector<std::string> variables;
  for (const char* name : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "DEAL_II_NUM_THREADS",
                           "ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS"})
    variables.push_back(std::string(name) + "=" + std::to_string(n));
  // Without these mpirun does not start as root, as in containers.
  variables.insert(variables.end(),
                   {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"});
  return variables;
}

/// A message without the folder of results, which is a temporary one.
std::string without_folder(std::string message, const fs::path& folder) {
  for (std::size_t at; (at = message.find(folder.string() + "/")) != std::string::npos;)
    message.erase(at, folder.string().size() + 1);
  return message;
}

} // namespace

ComparisonRuns::ComparisonRuns(const ComparisonParameters& parameters,
                               const CaseParameters& case_files,
                               const std::vector<unsigned>& tissues, const fs::path& folder)
    : parameters_(parameters), case_files_(case_files), folder_(folder), work_(folder / "work"),
      program_(this_program()) {
  if (!case_files.landmarks().empty())
    yardstick_.landmarks = evaluation::read_landmarks(case_files.landmarks());
  if (parameters_.is_registration())
    yardstick_.breast =
        image::select_labels(image::read_labels(case_files.files().labels.prone), tissues);
  fs::create_directory(folder_ / "logs");
}

Command ComparisonRuns::prosup(const PlannedRun& run, unsigned n_ranks) const {
  Command command;
  if (n_ranks > 1) {
    command = words_of(parameters_.launcher);
    command.insert(command.end(), {"-np", std::to_string(n_ranks)});
  }
  command.insert(command.end(), {program_, parameters_.command, folder_ / "used.prm"});
  for (const auto& arguments : {words_of(parameters_.arguments), run.arguments})
    command.insert(command.end(), arguments.begin(), arguments.end());
  if (parameters_.is_registration()) // which sees no landmarks, nor spends time on them
    command.insert(command.end(), {"--set", "Case/Landmarks="});
  command.insert(command.end(), {"--output", work_ / "result"});
  return command;
}

ChildResult ComparisonRuns::run(const Command& command, unsigned threads,
                                const fs::path& log) const {
  Command limited{"timeout", "--kill-after=10", std::to_string(parameters_.time_limit)};
  limited.insert(limited.end(), command.begin(), command.end());
  return run_child(limited, log, with_threads(threads));
}

std::string ComparisonRuns::status(const Command& command, const ChildResult& child,
                                   const fs::path& log) const {
  if (child.exit_code == 0)
    return "ok";
  const bool is_prosup = std::find(command.begin(), command.end(), program_) != command.end();
  if (is_prosup && child.exit_code == static_cast<int>(Outcome::not_settled))
    return "not settled"; // but there are results
  if (is_prosup && child.exit_code == static_cast<int>(Outcome::failed))
    return "verdict: failed"; // the same
  throw Error(reason_of_failure(child, log));
}

void ComparisonRuns::repeat(const Command& command, unsigned threads, const Measure& measure,
                            Row& row) {
  const fs::path log = folder_ / "logs" / file_name(row);
  std::vector<double> seconds;
  try {
    for (unsigned i = 0; i < parameters_.repetitions; ++i) {
      const ChildResult child = run(command, threads, log);
      seconds.push_back(child.wall_seconds);
      row.memory = child.peak_memory;
      row.status = status(command, child, log);
    }
    measure(row, log);
  } catch (const std::exception& error) {
    row.status = "failed";
    row.message = without_folder(error.what(), folder_);
  }
  std::sort(seconds.begin(), seconds.end());
  if (!seconds.empty()) {
    row.seconds = 0.5 * (seconds[(seconds.size() - 1) / 2] + seconds[seconds.size() / 2]);
    row.least_seconds = seconds.front();
    row.most_seconds = seconds.back();
  }
  fs::remove_all(work_);
}

Row ComparisonRuns::make(const PlannedRun& run, unsigned n_ranks) {
  Row row;
  row.group = run.group;
  row.name = run.name;
  row.ranks = n_ranks;
  fs::create_directory(work_);
  repeat(
      prosup(run, n_ranks), 1,
      [&](Row& r, const fs::path&) {
        measure_result(work_ / "result", parameters_.is_registration(), yardstick_, r);
      },
      row);
  return row;
}

fs::path ComparisonRuns::peer_parameters(const std::string& name) const {
  // cmake/Install.cmake puts them there.
  const fs::path folder = parameters_.peer_folder.empty()
                              ? program_.parent_path().parent_path() / "share/prosup/peers"
                              : fs::path(parameters_.peer_folder);
  const fs::path file = folder / (name + ".txt");
  if (!fs::is_regular_file(file))
    throw Error("The peer '" + name + "' has no parameter file '" + file.string() +
                "'; name its folder in 'Comparison/Peer folder'.");
  return file;
}

Row ComparisonRuns::make(const Peer& peer, const std::string& name, unsigned n_threads) {
  Row row;
  row.group = peer.program();
  row.name = name.size() > row.group.size() ? name.substr(row.group.size() + 1) : "default";
  row.ranks = n_threads;
  fs::create_directory(work_);
  const auto& images = case_files_.files().images;
  const PeerTask task{images.prone, images.supine, peer_parameters(name), work_, n_threads};
  repeat(
      peer.registration(task), n_threads,
      [&](Row& r, const fs::path& log) {
        if (const Command field = peer.field(task); !field.empty())
          if (const ChildResult child = run(field, n_threads, log.string() + "_field");
              child.exit_code != 0)
            throw Error(reason_of_failure(child, log.string() + "_field"));
        measure_field(peer.displacement(task), yardstick_, r);
      },
      row);
  return row;
}

} // namespace prosup::pipeline
