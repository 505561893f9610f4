#ifndef PROSUP_SRC_FDM_FORCE_RECORD_H
#define PROSUP_SRC_FDM_FORCE_RECORD_H

#include <memory>
#include <vector>

#include "loaded_maps.h"
#include "prosup/fdm/vector_field.h"

namespace prosup::fdm {

/// Image forces, accumulated in the loaded configuration as in the paper's eq. 15.
/// The last one added rises linearly in time. Copies are cheap.
class ForceRecord {
public:
  /// Moves a force density from X to x = X + u(X), and adds it to `maps` over
  /// `ramp_time` seconds from `time` on.
  void add(const VectorField& force, const VectorField& displacement, double time, double ramp_time,
           const LoadedMaps& maps);
  /// Sets the force of the maps to that at `time`. Returns whether the ramp is over.
  bool update(double time, LoadedMaps& maps);

  /// Tells update() that the maps have the force of another record.
  void write_again() { part_ = -1.; }

private:
  using Field = std::vector<Tensor<1, 3>>;       ///< at the points of the maps
  std::shared_ptr<const Field> sum_, increment_; ///< none before the first force
  double ramp_start_ = 0., ramp_time_ = 0.;
  double part_ = 1.; ///< of the increment that the maps have
};

} // namespace prosup::fdm

#endif
