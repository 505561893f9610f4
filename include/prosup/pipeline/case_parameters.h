#ifndef PROSUP_PIPELINE_CASE_PARAMETERS_H
#define PROSUP_PIPELINE_CASE_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <filesystem>
#include <string>

#include "prosup/unloading/support_parameters.h"

namespace prosup::pipeline {

/// What belongs to a case and not to the method, section "Case". File names
/// are relative to the folder of the parameter file.
class CaseParameters : public dealii::ParameterAcceptor {
public:
  CaseParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;
  /// @throws Error if a gravity has no direction.
  void parse_parameters(dealii::ParameterHandler& prm) override;

  /// Makes the file names absolute, here and in `prm`, so that what is written of
  /// it can be read from any folder. `folder` is that of the parameter file.
  void resolve(const std::filesystem::path& folder, dealii::ParameterHandler& prm);

  /// @throws Error if an input that `register` needs is not given.
  void require_pair() const;
  /// @throws Error if the labels of the chosen state are not given.
  void require_labels(unsigned state) const;

  /// 0 prone, 1 supine: what `mesh`, `unload` and `load` work on.
  unsigned state() const { return state_ == "prone" ? 0 : 1; }

  unloading::ChestCondition chest() const;
  /// Of method_names().
  const std::string& method() const { return method_; }

  std::array<std::string, 2> images; ///< prone, supine
  std::array<std::string, 2> labels;
  std::array<std::string, 2> excluded; ///< masks of what gives no image force, or empty
  std::array<dealii::Tensor<1, 3>, 2> gravity;
  dealii::Tensor<1, 3> supine_offset; ///< mm
  std::string landmarks;

private:
  std::string state_ = "prone";
  std::string chest_;
  std::string method_ = "fe";
};

} // namespace prosup::pipeline

#endif
