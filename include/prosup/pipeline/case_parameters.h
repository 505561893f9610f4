#ifndef PROSUP_PIPELINE_CASE_PARAMETERS_H
#define PROSUP_PIPELINE_CASE_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <filesystem>
#include <string>

#include "prosup/registration/case_files.h"

namespace prosup::pipeline {

/// What belongs to a case and not to the method, section "Case". File names are relative to the
/// folder of the parameter file.
class CaseParameters : public dealii::ParameterAcceptor {
public:
  CaseParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;
  /// @throws Error if a gravity has no direction.
  void parse_parameters(dealii::ParameterHandler& prm) override;

  /// Makes the file names absolute, here and in `prm`, so that what is written of it can be read
  /// from any folder. `folder` is that of the parameter file.
  void resolve(const std::filesystem::path& folder, dealii::ParameterHandler& prm);

  /// @throws Error if an input that `register` needs is not given.
  void require_pair() const;
  /// @throws Error if image or labels of a position are not given.
  void require(Position position) const;
  /// @throws Error if the labels of a position are not given.
  void require_labels(Position position) const;

  /// What a registration is told.
  const registration::CaseFiles& files() const { return files_; }
  /// What only the evaluation is told: the file of the landmarks, or empty.
  const std::string& landmarks() const { return landmarks_; }
  /// What the commands mesh, unload and load work on.
  Position position() const;

private:
  registration::CaseFiles files_;
  std::string landmarks_;
  std::string state_ = "prone";
  std::string chest_ = "sliding";
};

} // namespace prosup::pipeline

#endif
