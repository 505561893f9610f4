#ifndef PROSUP_PIPELINE_CHECKPOINT_PARAMETERS_H
#define PROSUP_PIPELINE_CHECKPOINT_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <filesystem>
#include <string>

namespace prosup::pipeline {

/// Whether and where a run is kept to go on from, section "Checkpoint".
class CheckpointParameters : public dealii::ParameterAcceptor {
public:
  CheckpointParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// The folder for a run into `output`.
  std::filesystem::path folder_for(const std::filesystem::path& output) const;

  bool wanted = true;
  double interval = 30.; ///< s
  bool restart = false;  ///< of the command line, and no parameter of a file: go on from there

private:
  std::string folder_;
};

} // namespace prosup::pipeline

#endif
