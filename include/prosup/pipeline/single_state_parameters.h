#ifndef PROSUP_PIPELINE_SINGLE_STATE_PARAMETERS_H
#define PROSUP_PIPELINE_SINGLE_STATE_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <filesystem>
#include <string>

namespace prosup::pipeline {

/// Parameters of the commands load and unload, section "Single state".
class SingleStateParameters : public dealii::ParameterAcceptor {
public:
  SingleStateParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  bool is_explicit() const { return solver_ == "explicit"; }
  /// Makes the file name absolute, as CaseParameters::resolve().
  void resolve(const std::filesystem::path& folder, dealii::ParameterHandler& prm);

  std::string mesh; ///< VTU file with an unloaded configuration; empty: mesh the labels

private:
  std::string solver_ = "explicit";
};

} // namespace prosup::pipeline

#endif
