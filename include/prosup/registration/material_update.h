#ifndef PROSUP_REGISTRATION_MATERIAL_UPDATE_H
#define PROSUP_REGISTRATION_MATERIAL_UPDATE_H

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/registration/comparison.h"

namespace prosup::registration {

/// What finding the properties took, and how it ended.
struct MaterialUpdateResult {
  unsigned n_steps = 0;              ///< time steps of all trials
  unsigned n_trials = 0;             ///< pairs of unloadings
  bool converged = true;             ///< of the accepted state
  std::vector<std::string> at_bound; ///< searched properties that ended at the end of their range
};

/// How far a MaterialUpdate has come: it goes on from there with the pair as it is at such a point,
/// which is the best state found.
struct MaterialProgress {
  MaterialUpdateResult result;
  unsigned level = 0;        ///< index of the level at work
  image::VoxelGrid grid;     ///< of its comparison; without voxels before it begins
  double first_value = 0.;   ///< of the metric, at the begin of the level
  double best_value = 0.;    ///< of the metric
  unsigned n_accepted = 0;   ///< steps on the level
  double damping = 0.;       ///< of the next step of the search
  double n_independent = 0.; ///< measurements that the images count for; 0: no prior
  bool is_exact = false;     ///< the derivatives are differences
  bool walks_back = false;   ///< stepwise makes the tissue softer
  std::vector<std::vector<float>> derivatives; ///< of the residuals by each property
};

/// Finds the mechanical properties with which the unloaded images are most alike, section
/// "Material update".
///
/// search: Gauss-Newton steps (Levenberg, Marquardt) in logarithms q of the chosen
/// properties. With residuals r_v whose squares sum to twice the similarity, and
/// their derivatives dr/dq_i, a step solves
///   sum_j (H_ij + gamma H_ii delta_ij) dq_j = -g_i,
///   H_ij = sum_v dr_v/dq_i dr_v/dq_j, g_i = sum_v r_v dr_v/dq_i,
/// which finds all properties at once, however they depend on each other.
/// The derivatives follow from those of the unloaded positions by the implicit function theorem
/// (mechanics::UnloadedResponse). Breasts without such are unloaded once for each property, and
/// Broyden's update corrects the derivatives for two more steps.
///
/// Images of different contrast are compared by their labelled tissues (Compared::tissues):
/// residuals of mutual information and correlation say nothing about breasts that are far apart.
///
/// The prior of the properties (src/registration/searched_property.cc) adds
///   2 S/n sum_i 1/2 ((q_i - m_i)/s_i)^2,   n = V/L^3,
/// to the S that is minimised: the logarithm of the posterior where n independent residuals have
/// the variance that is left.
///
/// stepwise: the paper's. Multiplies the shear modulus (and with it lambda) by a
/// constant factor, stiffer or softer, and goes on while the similarity improves;
/// the last, unsuccessful trial is discarded.
class MaterialUpdate : public dealii::ParameterAcceptor {
public:
  MaterialUpdate();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// The pair has to be unloaded with its properties, and is left unloaded with those that were
  /// found, BreastPair::properties().
  MaterialUpdateResult run(BreastPair& pair, const ComparedImages& images, const Log& log,
                           const Observer& observer = {}) const;
  /// The same from `progress` on, which it brings up to date; `keep` is called where both it and
  /// the pair could be kept to go on from.
  void run(BreastPair& pair, const ComparedImages& images, const Log& log, const Observer& observer,
           MaterialProgress& progress, const Keeper& keep) const;

  /// Whether run() may change the shear modulus.
  bool searches() const;

private:
  std::string method_;
  std::string compared_;
  std::vector<std::string> properties_;
  std::vector<double> levels_{8., 4.};
  unsigned max_steps_ = 20;
  double least_gain_ = 0.02;
  double correlation_length_ = 20.;
  double factor_ = 1.1;
};

} // namespace prosup::registration

#endif
