#include <deal.II/base/mpi.h>

#include <algorithm>

#include "comparison_runs.h"
#include "machine.h"
#include "prosup/core/collective.h"
#include "prosup/core/log_file.h"
#include "prosup/core/parameters.h"
#include "prosup/core/result_folder.h"
#include "prosup/pipeline/commands.h"
#include "run_files.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;
using Row = output::ComparisonRow;

namespace {

/// The last part of a folder's path.
std::string name_of(const fs::path& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename();
}

std::vector<std::string> files_written(const std::string& name) {
  return {name + ".csv", name + ".md", name + ".svg", "summary.json", "used.prm", "logs/", log_txt};
}

/// All runs of a comparison, and what is written of them.
class CompareJob {
public:
  CompareJob(const ComparisonParameters& parameters, const CaseParameters& case_files,
             const Labels& labels, MPI_Comm world)
      : parameters_(parameters), case_files_(case_files), labels_(labels), log_(world),
        runs_(planned_runs(parameters_.runs)) {
    check();
  }

  /// @returns whether the runs succeeded as far as the parameters ask for it.
  bool run(const dealii::ParameterHandler& all, const ResultTarget& target) {
    const fs::path& output = target.folder;
    ResultFolder folder(target, files_written(name_of(output)));
    LogFile log_file(folder.path() / log_txt);
    write_parameters(all, folder.path() / "used.prm");
    comparison_ = {
        name_of(output),    parameters_.title,
        describe_machine(), {},
        parameters_.x_axis, parameters_.x_label,
        parameters_.y_axes, parameters_.x_axis == "time" || parameters_.x_axis == "solve time"};
    make_runs(folder.path());
    output::write_comparison(comparison_, folder.path());
    log_.line("\n" + output::comparison_table(comparison_.rows) + "\n" +
              output::cost_models(comparison_.rows));
    log_file.close();
    folder.commit();
    log_.line("Results are in " + output.string());
    return verdict(output);
  }

private:
  void check() const {
    if (runs_.empty() && parameters_.peers.empty())
      throw Error("There is nothing to compare; name runs in 'Comparison/Runs' of the parameter "
                  "file, as in prm/benchmarks.");
    if (parameters_.is_registration())
      case_files_.require_pair();
    else
      case_files_.require_labels(case_files_.position());
    if (parameters_.peers.empty())
      return;
    if (!parameters_.is_registration())
      throw Error("Peers register images and cannot unload; take 'Comparison/Peers' out or set "
                  "'Comparison/Command' to register.");
    if (case_files_.files().supine_offset.norm() > 0.)
      throw Error("Peers read the images as they are and know no 'Case/Supine offset'; set it to "
                  "0,0,0 where there are 'Comparison/Peers'.");
  }

  /// Peers are looked for before anything runs, so that nobody waits in vain.
  void make_runs(const fs::path& folder) {
    std::vector<std::unique_ptr<Peer>> peers;
    for (const std::string& name : parameters_.peers)
      peers.push_back(make_peer(name));
    ComparisonRuns runs(parameters_, case_files_, labels_.tissues, folder);
    for (const unsigned n_ranks : parameters_.ranks) {
      for (const PlannedRun& planned : runs_)
        add(runs.make(planned, n_ranks));
      for (std::size_t i = 0; i < peers.size(); ++i)
        add(runs.make(*peers[i], parameters_.peers[i], n_ranks));
    }
    for (const auto& peer : peers)
      note_version(*peer, folder / "logs");
  }

  void note_version(const Peer& peer, const fs::path& logs) {
    auto& machine = comparison_.machine;
    if (std::none_of(machine.begin(), machine.end(),
                     [&](const auto& entry) { return entry.first == peer.program(); }))
      machine.emplace_back(peer.program(), peer_version(peer, logs));
  }

  void add(const Row& row) {
    std::string line = format("%s/%s, %u rank%s: ", row.group.c_str(), row.name.c_str(), row.ranks,
                              row.ranks == 1 ? "" : "s");
    if (row.status == "failed")
      line += "failed: " + row.message;
    else
      line += format("%.1f s", row.seconds) +
              (row.error ? format(", %.3f mm mean, %.2f mm max", row.error->mean, row.error->max)
                         : "") +
              (row.status == "ok" ? "" : ", " + row.status);
    log_.line(line);
    comparison_.rows.push_back(row);
  }

  bool verdict(const fs::path& output) const {
    const auto failed =
        static_cast<std::size_t>(std::count_if(comparison_.rows.begin(), comparison_.rows.end(),
                                               [](const Row& r) { return r.status == "failed"; }));
    if (failed == comparison_.rows.size())
      throw Error(
          format("All %zu runs of the comparison failed; '%s' tells what each of them said.",
                 failed, (output / (comparison_.name + ".md")).c_str()));
    return failed == 0 || !parameters_.all_must_succeed;
  }

  const ComparisonParameters& parameters_;
  const CaseParameters& case_files_;
  const Labels& labels_;
  const Log log_;
  const std::vector<PlannedRun> runs_;
  output::Comparison comparison_;
};

/// Runs start their own ranks, which those of a running mpirun would not let them.
void require_no_mpirun(MPI_Comm world) {
  const bool launched =
      !started_with("OMPI_COMM_WORLD_SIZE").empty() || !started_with("PMI_SIZE").empty();
  if (launched || dealii::Utilities::MPI::n_mpi_processes(world) > 1)
    throw Error("prosup compare starts the ranks of its runs itself; call it without mpirun and "
                "set 'Comparison/Ranks'.");
}

} // namespace

bool run_compare(const AllParameters& parameters, const dealii::ParameterHandler& all,
                 const ResultTarget& output, MPI_Comm world) {
  require_no_mpirun(world);
  return CompareJob(parameters.comparison, parameters.case_files, parameters.registration.labels,
                    world)
      .run(all, output);
}

} // namespace prosup::pipeline
