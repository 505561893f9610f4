#ifndef PROSUP_PHANTOM_TEXTURE_H
#define PROSUP_PHANTOM_TEXTURE_H

#include <string>
#include <vector>

#include "prosup/phantom/anatomy.h"

namespace prosup::phantom {

/// How an image is made: T1-weighted magnetic resonance without fat
/// suppression (fat bright, gland dark, air 0; arbitrary units), or computed
/// tomography (Hounsfield units).
enum class Modality { mr, ct };

/// The names of the modalities, in the order of their enumerators.
const std::vector<std::string>& modality_names();

/// Intensities of an ideal image, without noise. Tissue is looked up where it
/// lies in the unloaded configuration, so that its texture moves with it: fat
/// with thin septa (Cooper's ligaments), gland and the skin. The chest, rigid,
/// has muscle, ribs and lung.
class Texture {
public:
  Texture(const Anatomy& anatomy, std::uint64_t seed);

  /// At a point of the tissue, in the unloaded configuration.
  double tissue(Modality modality, const Point<3>& X) const;
  /// At a point of the chest, the same in all configurations.
  double chest(Modality modality, const Point<3>& x) const;
  double air(Modality modality) const;

private:
  const Anatomy& anatomy_;
  const SmoothNoise fat_, septa_, muscle_;
};

} // namespace prosup::phantom

#endif
