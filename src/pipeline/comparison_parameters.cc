#include "prosup/pipeline/comparison_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::pipeline {

using namespace dealii;

ComparisonParameters::ComparisonParameters() : ParameterAcceptor("Comparison") {}

void ComparisonParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Title", title, "Heading of the table and the picture.");
  prm.add_parameter("Command", command, "Command of prosup that is run.",
                    Patterns::Selection("register|unload"));
  prm.add_parameter(
      "Runs", runs,
      "Runs of prosup: 'group/name: arguments', separated by semicolons. A group is one "
      "series of the picture. 'group/a, b: arguments' are two runs, a and b; a $ in "
      "the arguments is replaced by the name of the run. Arguments with blanks are "
      "put in double quotes.",
      Patterns::Anything());
  prm.add_parameter("Arguments", arguments, "Arguments that are added to all runs of prosup.",
                    Patterns::Anything());
  prm.add_parameter(
      "Peers", peers,
      "Other programs that register the same images: names of parameter files in 'Peer "
      "folder', without .txt. A name starts with that of the program, elastix or "
      "plastimatch.",
      Patterns::List(Patterns::Anything()));
  prm.add_parameter(
      "Peer folder", peer_folder,
      "Folder with the parameter files of the peers, relative to this parameter file. If "
      "empty, the files installed with prosup are used.",
      Patterns::Anything());
  prm.add_parameter("Ranks", ranks,
                    "Numbers of ranks on which each run is made; peers use as many threads. Units: "
                    "none.",
                    Patterns::List(Patterns::Integer(1, 100000), 1));
  prm.add_parameter("Repetitions", repetitions,
                    "Repetitions of each run, of which the median time is taken. Units: none.",
                    Patterns::Integer(1, 1000));
  prm.add_parameter("Time limit", time_limit,
                    "A run that takes longer is stopped and counts as failed. Units: s.",
                    Patterns::Double(1., 1e7));
  prm.add_parameter("Launcher", launcher,
                    "Command that starts several ranks; -np N and the program are appended.",
                    Patterns::Anything());
  prm.add_parameter("X axis", x_axis,
                    "Quantity on the x axis of the picture; name is the number at the start of the "
                    "name of a run. If it is a time, the runs that no other run beats in both "
                    "quantities are joined by a line (Pareto front).",
                    Patterns::Selection("time|solve time|mean|p95|max|cells|ranks|memory|name"));
  prm.add_parameter("X label", x_label,
                    "Label of the x axis. If empty, the name of its quantity is used.",
                    Patterns::Anything());
  prm.add_parameter(
      "Y axes", y_axes, "Quantities on the y axis, with one chart each.",
      Patterns::List(Patterns::Selection("time|solve time|mean|p95|max|cells|ranks|memory"), 1));
  prm.add_parameter(
      "All must succeed", all_must_succeed,
      "Whether the exit code is 2 if any run fails. If not, failed runs are only marked "
      "in the table; the exit code is 1 if all runs fail.");
}

void ComparisonParameters::resolve(const std::filesystem::path& folder, ParameterHandler& prm) {
  resolve_files(prm, get_section_name(), {"Peer folder"}, folder);
  peer_folder = prm.get({get_section_name()}, "Peer folder");
}

} // namespace prosup::pipeline
