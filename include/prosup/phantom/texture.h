#ifndef PROSUP_PHANTOM_TEXTURE_H
#define PROSUP_PHANTOM_TEXTURE_H

#include <string>
#include <vector>

#include "prosup/phantom/anatomy.h"

namespace prosup::phantom {

/// Modality of an image: T1-weighted magnetic resonance without fat suppression (fat bright,
/// gland dark, air 0, arbitrary units), or computed tomography (Hounsfield units).
enum class Modality { mr, ct };

/// The names of the modalities, in the order of their enumerators.
const std::vector<std::string>& modality_names();

/// Intensities of an image without noise. Tissue consists of fat with thin septa (Cooper's
/// ligaments), gland and skin. Its intensity is a function of the unloaded position, so that
/// the texture moves with the tissue. The chest is rigid and has muscle, ribs and lung.
class Texture {
public:
  Texture(const Anatomy& anatomy, std::uint64_t seed);

  /// Intensity of tissue at its unloaded position.
  double tissue(Modality modality, const Point<3>& X) const;
  /// Intensity of the chest, which is the same in all configurations.
  double chest(Modality modality, const Point<3>& x) const;
  double air(Modality modality) const;

private:
  const Anatomy& anatomy_;
  const SmoothNoise fat_, septa_, muscle_;
};

} // namespace prosup::phantom

#endif
