#ifndef PROSUP_SRC_FDM_CHEST_MOTION_H
#define PROSUP_SRC_FDM_CHEST_MOTION_H

#include <vector>

#include "dynamics.h"
#include "loaded_maps.h"
#include "prosup/fdm/chest_condition.h"
#include "prosup/fdm/fdm_parameters.h"
#include "smooth_distance.h"

namespace prosup::fdm {

/// The effect of the rigid chest on the grid. Either it is a wall to which tissue is fixed,
/// or it keeps the nodes next to its surface (the slave nodes of the paper) at their
/// distance from it by eq. 10, and the nodes inside it are soft and free.
class ChestMotion {
public:
  ChestMotion(const Slab& slab, const image::LabelImage& labels, unsigned chest_label,
              const LoadedMaps& maps, const ChestCondition& condition,
              const FdmParameters& parameters, double density);

  /// Distance of a node from a chest that is a wall, otherwise the largest float, mm.
  float wall_distance(std::size_t node) const { return wall_distance_[node]; }
  /// Number of nodes inside a chest that is a wall, or of slave nodes; of all ranks.
  unsigned long n_nodes() const { return n_nodes_; }

  void set_spring_stiffness(double stiffness);

  /// Adds the effect of the springs in one step, the acceleration -k u_t/(rho h), to the
  /// increments of the slave nodes, and then corrects x' = x + s(v_s) c(x).
  void correct(Dynamics& dynamics) const;
  /// Adds the spring of a node to its acceleration, and removes the component that the
  /// chest balances.
  void project(const Dynamics& dynamics, std::size_t node, Tensor<1, 3>& acceleration) const;

private:
  struct Slave {
    std::size_t node;
    Point<3> position; ///< X
    double distance;   ///< from the chest at X, mm
  };
  Tensor<1, 3> spring(const Tensor<1, 3>& displacement, const Tensor<1, 3>& normal) const;

  const Slab& slab_;
  const ChestContact contact_;
  const ContactMethod method_;
  const double correction_part_, speed_limit_; ///< p and v_max of eq. 11
  const double mass_per_area_;                 ///< of a slave node, g/mm^2
  double spring_per_mass_ = 0.;                ///< 1/s^2
  std::vector<float> wall_distance_;
  std::vector<Slave> slaves_;
  std::vector<int> slave_of_; ///< of each node, -1 for none
  SmoothDistance distance_;
  unsigned long n_nodes_ = 0;
};

} // namespace prosup::fdm

#endif
