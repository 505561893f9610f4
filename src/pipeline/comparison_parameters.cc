#include "prosup/pipeline/comparison_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::pipeline {

using namespace dealii;

ComparisonParameters::ComparisonParameters() : ParameterAcceptor("Comparison") {}

void ComparisonParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Title", title, "What is compared: heading of table and picture.");
  prm.add_parameter("Command", command, "The command of prosup that is run.",
                    Patterns::Selection("register|unload"));
  prm.add_parameter("Runs", runs,
                    "Runs of prosup, 'group/name: arguments' with semicolons between them. A group "
                    "is one series of the picture. 'group/a, b: arguments' stands for a run a and "
                    "a run b; a $ in the arguments is the name of the run. Arguments with blanks "
                    "stand in double quotes.",
                    Patterns::Anything());
  prm.add_parameter("Arguments", arguments, "Arguments of all runs of prosup.",
                    Patterns::Anything());
  prm.add_parameter("Peers", peers,
                    "Other programs that register the same images: names of files in 'Peer "
                    "folder', without .txt, that start with the name of the program: elastix or "
                    "plastimatch.",
                    Patterns::List(Patterns::Anything()));
  prm.add_parameter("Peer folder", peer_folder,
                    "Folder with the parameter files of the peers, relative to the parameter "
                    "file; empty: those installed with prosup.",
                    Patterns::Anything());
  prm.add_parameter("Ranks", ranks,
                    "Each run is made on each of these numbers of ranks; peers get as many "
                    "threads. Units: none.",
                    Patterns::List(Patterns::Integer(1, 100000), 1));
  prm.add_parameter("Repetitions", repetitions,
                    "How often each run is made; the median time counts. Units: none.",
                    Patterns::Integer(1, 1000));
  prm.add_parameter("Time limit", time_limit,
                    "A run that takes longer is ended and counts as failed. Units: s.",
                    Patterns::Double(1., 1e7));
  prm.add_parameter("Launcher", launcher, "Starts several ranks; -np N and the program are added.",
                    Patterns::Anything());
  prm.add_parameter("X axis", x_axis,
                    "Of the picture: time, solve time, mean, p95, max, cells, ranks, memory, or "
                    "name for the number at the start of the run's name. Over the time, the runs "
                    "that none beats in both are joined (Pareto front).",
                    Patterns::Selection("time|solve time|mean|p95|max|cells|ranks|memory|name"));
  prm.add_parameter("X label", x_label,
                    "What the picture writes below the x axis; empty: the name of its quantity.",
                    Patterns::Anything());
  prm.add_parameter(
      "Y axes", y_axes, "Of the picture, a chart each: as the x axis.",
      Patterns::List(Patterns::Selection("time|solve time|mean|p95|max|cells|ranks|memory"), 1));
  prm.add_parameter("All must succeed", all_must_succeed,
                    "Whether the exit code is 2 if any run fails. Otherwise the table says so, and "
                    "the exit code is 1 only if all runs fail.");
}

void ComparisonParameters::resolve(const std::filesystem::path& folder, ParameterHandler& prm) {
  resolve_files(prm, get_section_name(), {"Peer folder"}, folder);
  peer_folder = prm.get({get_section_name()}, "Peer folder");
}

} // namespace prosup::pipeline
