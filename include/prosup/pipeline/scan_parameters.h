#ifndef PROSUP_PIPELINE_SCAN_PARAMETERS_H
#define PROSUP_PIPELINE_SCAN_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/registration/case_files.h"

namespace prosup::pipeline {

/// The scans that prepare, or register without labels, starts from, and masks of the user for them;
/// section "Scans".
class ScanParameters : public dealii::ParameterAcceptor {
public:
  ScanParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;
  /// @throws Error if there are more than two numbers of series.
  void parse_parameters(dealii::ParameterHandler& prm) override;
  /// Makes the file names absolute, as CaseParameters::resolve().
  void resolve(const std::filesystem::path& folder, dealii::ParameterHandler& prm);

  /// @throws Error if no scan is given.
  void require_any() const;
  /// @throws Error if there is a mask for a scan that is not given, or a scan of a position of
  /// which `files` name an image or labels.
  void require_no_contradiction(const registration::CaseFiles& files = {}) const;
  bool gives(Position position) const { return !scans[position].empty(); }
  /// The number of the series that is wanted; 0: a rule decides.
  unsigned series(Position position) const;

  PerPosition<std::string> scans; ///< files, or folders of DICOM files; empty: not given
  PerPosition<std::string> chest, breast, gland; ///< files of masks; empty: not given

private:
  std::vector<unsigned> series_;
};

} // namespace prosup::pipeline

#endif
