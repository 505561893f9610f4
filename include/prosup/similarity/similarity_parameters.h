#ifndef PROSUP_SIMILARITY_SIMILARITY_PARAMETERS_H
#define PROSUP_SIMILARITY_SIMILARITY_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <memory>
#include <string>
#include <vector>

#include "prosup/similarity/metric.h"

namespace prosup::similarity {

/// All metrics of prosup, with their default parameters. This is the only list of them:
/// parameters, messages and the help of the command line are made from it.
std::vector<std::shared_ptr<Metric>> all_metrics();

/// Names of all_metrics(), or only of those for images of different contrast.
std::vector<std::string> metric_names(bool for_different_contrast = false);

/// Which metric compares the images, and on which voxels: section "Similarity". Each
/// metric has its parameters in a subsection with its name, such as "Similarity/lncc".
class SimilarityParameters : public dealii::ParameterAcceptor {
public:
  SimilarityParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// Adds a metric of the host program, which can be selected by its name from now on.
  /// To be called before the parameters are declared.
  /// @throws Error if there is a metric of this name.
  void add_metric(std::shared_ptr<Metric> new_metric);

  /// The selected metric, with its parameters; if it is automatic, the first one, or local
  /// correlation for images of `different_contrast`.
  /// @throws Error that lists the names if there is none of this name.
  std::shared_ptr<const Metric> make_metric(bool different_contrast = false) const;
  bool is_automatic() const;

  std::string metric;    ///< name of the selected metric, or automatic
  unsigned n_layers = 2; ///< layers of voxels added around each mesh
  double margin = 5.;    ///< of the grid around both meshes, voxels

private:
  std::vector<std::shared_ptr<Metric>> metrics_;
};

} // namespace prosup::similarity

#endif
