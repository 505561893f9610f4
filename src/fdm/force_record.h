#ifndef PROSUP_SRC_FDM_FORCE_RECORD_H
#define PROSUP_SRC_FDM_FORCE_RECORD_H

#include <mpi.h>

#include <vector>

#include "loaded_maps.h"
#include "prosup/fdm/vector_field.h"

namespace prosup::fdm {

/// Image forces, accumulated in the loaded configuration as by the paper's
/// eq. 15, the last of which rises linearly in time.
class ForceRecord {
public:
  /// Takes a force density given at X to x = X + u(X), to be added to `maps` in
  /// `ramp_time` seconds from `time`.
  void add(const VectorField& force, const VectorField& displacement, double time, double ramp_time,
           const LoadedMaps& maps);
  /// Brings the force of the maps to what it is at `time`. Returns whether all of
  /// it acts.
  bool update(double time, LoadedMaps& maps);

  /// The next update() writes the force even where it has not changed.
  void write_again() { part_ = -1.; }

private:
  std::vector<Tensor<1, 3>> sum_, increment_; ///< at the points of the maps
  double ramp_start_ = 0., ramp_time_ = 0.;
  double part_ = 1.; ///< of the increment that the maps have
};

} // namespace prosup::fdm

#endif
