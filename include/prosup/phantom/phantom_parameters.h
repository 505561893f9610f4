#ifndef PROSUP_PHANTOM_PHANTOM_PARAMETERS_H
#define PROSUP_PHANTOM_PHANTOM_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>

#include "prosup/phantom/geometry.h"
#include "prosup/phantom/texture.h"

namespace prosup::phantom {

/// Parameters of the numerical phantom, section "Phantom". States are numbered
/// 0 prone, 1 supine.
class PhantomParameters : public dealii::ParameterAcceptor {
public:
  PhantomParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;
  void parse_parameters(dealii::ParameterHandler& prm) override;

  bool chest_slides() const { return chest_ == "sliding"; }
  Modality modality(unsigned state) const { return modality_[state]; }
  /// Standard deviation of the noise of a state's image.
  double noise(unsigned state) const {
    return modality_[state] == Modality::mr ? mr_noise_ : ct_noise_;
  }

  Geometry geometry;
  double gland_fraction = 0.22;
  unsigned seed = 1;
  unsigned n_landmarks = 500;

  double fat_shear_modulus = 325.; ///< Pa
  double gland_ratio = 1.;
  double poisson_ratio = 0.45;
  double edge_length = 10.;       ///< of the mesh, mm
  double contact_stiffness = 1e4; ///< normal to a sliding chest, Pa/mm
  double fascia_stiffness = 8.;   ///< springs on a sliding chest, Pa/mm
  double push_pressure = 0.;      ///< on the side of the prone breast, Pa
  double push_radius = 20.;       ///< standard deviation of its patch, mm

  double voxel_edge = 1.;             ///< mm
  double anterior_margin = 48.;       ///< of the images beyond the unloaded skin, mm
  dealii::Tensor<1, 3> rotation;      ///< of the image axes about x, y, z, degrees
  dealii::Tensor<1, 3> supine_offset; ///< of the grid, mm
  double supine_crop = 0.;            ///< mm
  double bias_field = 0.;             ///< standard deviation of its logarithm
  double label_jitter = 0.;           ///< standard deviation, mm

private:
  void declare_shape(dealii::ParameterHandler& prm);
  void declare_mechanics(dealii::ParameterHandler& prm);
  void declare_images(dealii::ParameterHandler& prm);

  std::string chest_ = "fixed";
  std::array<std::string, 2> modality_names_{"MR", "MR"};
  std::array<Modality, 2> modality_{};
  double mr_noise_ = 3., ct_noise_ = 9.;
};

} // namespace prosup::phantom

#endif
