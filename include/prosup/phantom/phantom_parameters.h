#ifndef PROSUP_PHANTOM_PHANTOM_PARAMETERS_H
#define PROSUP_PHANTOM_PHANTOM_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/tensor.h>

#include <string>

#include "prosup/core/position.h"
#include "prosup/phantom/geometry.h"
#include "prosup/phantom/texture.h"

namespace prosup::phantom {

/// What the phantom consists of, section "Phantom/Anatomy".
struct AnatomyParameters {
  void declare(dealii::ParameterHandler& prm);

  Geometry geometry;
  double gland_fraction = 0.22; ///< of the tissue volume
};

/// Material and boundary conditions of the phantom, section "Phantom/Mechanics".
struct MechanicsParameters {
  void declare(dealii::ParameterHandler& prm);

  bool chest_slides() const { return chest == "sliding"; }

  double fat_shear_modulus = 325.; ///< Pa
  double gland_ratio = 1.;         ///< shear modulus of gland over that of fat
  double poisson_ratio = 0.45;     ///< of all tissue
  double edge_length = 10.;        ///< of the mesh, mm
  std::string chest = "fixed";     ///< or "sliding"
  double contact_stiffness = 1e4;  ///< of a sliding chest, along its normal, Pa/mm
  double skin_stiffness = 0.;      ///< shear modulus times thickness of the skin, Pa mm
  double fascia_stiffness = 8.;    ///< of the springs on a sliding chest, Pa/mm
  double push_pressure = 0.;       ///< on the left side of the prone breast, Pa
  double push_radius = 20.;        ///< standard deviation of the pushed patch, mm
};

/// How the phantom is imaged, section "Phantom/Images".
struct ImagingParameters {
  void declare(dealii::ParameterHandler& prm);

  Modality modality(Position position) const;
  /// Standard deviation of the noise, in intensities of the image.
  double noise(Position position) const {
    return modality(position) == Modality::mr ? mr_noise : ct_noise;
  }

  PerPosition<std::string> modality_name{"MR", "MR"};
  double voxel_edge = 1.;             ///< mm
  double anterior_margin = 48.;       ///< in front of the unloaded skin, mm
  dealii::Tensor<1, 3> rotation;      ///< of the image axes about x, y, z, degrees
  dealii::Tensor<1, 3> supine_offset; ///< of the supine voxels, mm
  double supine_crop = 0.;            ///< mm
  double mr_noise = 3.;
  double ct_noise = 9.;     ///< HU
  double bias_field = 0.;   ///< standard deviation of its logarithm
  double label_jitter = 0.; ///< standard deviation, mm
};

/// Parameters of the numerical phantom, section "Phantom" and its subsections.
class PhantomParameters : public dealii::ParameterAcceptor {
public:
  PhantomParameters() : ParameterAcceptor("Phantom") {}
  void declare_parameters(dealii::ParameterHandler& prm) override;

  unsigned seed = 1; ///< of all random numbers
  unsigned n_landmarks = 500;
  AnatomyParameters anatomy;
  MechanicsParameters mechanics;
  ImagingParameters images;
};

} // namespace prosup::phantom

#endif
