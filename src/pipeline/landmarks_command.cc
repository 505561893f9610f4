#include <cstdio>

#include "prosup/core/output_file.h"
#include "prosup/evaluation/observers.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/finished_result.h"
#include "table_output.h"

namespace prosup::pipeline {

using namespace evaluation;

namespace {

std::vector<LandmarkObserver> read_observers(const LandmarkRequest& request) {
  Remarks remarks{Log(MPI_COMM_SELF)};
  std::vector<LandmarkObserver> observers;
  for (const std::filesystem::path& file : request.observers)
    observers.push_back(read_observer(file, remarks));
  if (!request.control.empty())
    observers.push_back(read_control_observer(request.control, observers[0], remarks));
  // Files of one name in different folders must stay apart in the tables.
  for (std::size_t o = 0; o < observers.size(); ++o)
    for (std::size_t other = 0; other < o; ++other)
      if (observers[o].name == observers[other].name)
        observers[o].name += " (" + std::to_string(o + 1) + ")";
  return observers;
}

} // namespace

void run_landmarks(const LandmarkRequest& request) {
  require_finished(request.result);
  require_csv(request.output);
  std::vector<std::filesystem::path> inputs = request.observers;
  inputs.push_back(request.control);
  OutputFile output(request.output, {inputs, request.overwrite, observer_tables_header});
  const ObserverStudy study(read_observers(request), request.exclude_above);
  const auto rows =
      study.rows(read_mapper(request.result, "prone"), read_mapper(request.result, "supine"));
  const auto distances = study.distances();
  write_observer_tables(rows, distances, output.path());
  output.commit();
  std::printf("%s", observer_tables(rows, distances).c_str());
  if (study.n_incomplete() > 0)
    std::printf("\nNot marked by all observers and left out: %zu.\n", study.n_incomplete());
  if (!study.outliers().empty()) {
    std::printf("\nMore than %g mm apart and not reliable:", request.exclude_above);
    for (const std::string& id : study.outliers())
      std::printf(" %s", id.c_str());
    std::printf("\n");
  }
}

} // namespace prosup::pipeline
