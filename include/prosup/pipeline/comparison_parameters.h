#ifndef PROSUP_PIPELINE_COMPARISON_PARAMETERS_H
#define PROSUP_PIPELINE_COMPARISON_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <filesystem>
#include <string>
#include <vector>

namespace prosup::pipeline {

/// The runs and the output of `prosup compare`, section "Comparison".
class ComparisonParameters : public dealii::ParameterAcceptor {
public:
  ComparisonParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// Makes the name of the peer folder absolute, as CaseParameters::resolve().
  void resolve(const std::filesystem::path& folder, dealii::ParameterHandler& prm);

  bool is_registration() const { return command == "register"; }

  std::string title = "Speed against error";
  std::string command = "register";
  std::string runs;      ///< see planned_runs()
  std::string arguments; ///< of all runs
  std::vector<std::string> peers;
  std::string peer_folder;
  std::vector<unsigned> ranks{1};
  unsigned repetitions = 1;
  double time_limit = 3600.; ///< s
  std::string launcher = "mpirun --oversubscribe --bind-to none";
  std::string x_axis = "time";
  std::string x_label;
  std::vector<std::string> y_axes{"mean"};
  bool all_must_succeed = false;
};

} // namespace prosup::pipeline

#endif
