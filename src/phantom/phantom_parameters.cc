#include "prosup/phantom/phantom_parameters.h"

#include <algorithm>

namespace prosup::phantom {

using namespace dealii;

PhantomParameters::PhantomParameters() : ParameterAcceptor("Phantom") {}

void PhantomParameters::declare_parameters(ParameterHandler& prm) {
  declare_shape(prm);
  declare_mechanics(prm);
  declare_images(prm);
}

void PhantomParameters::parse_parameters(ParameterHandler&) {
  for (unsigned state = 0; state < 2; ++state)
    modality_[state] = modality_names_[state] == "MR" ? Modality::mr : Modality::ct;
}

void PhantomParameters::declare_shape(ParameterHandler& prm) {
  prm.add_parameter("Width", geometry.width, "Extent from right to left (paper: 160.4). Units: mm.",
                    Patterns::Double(40., 600.));
  prm.add_parameter("Length", geometry.length,
                    "Extent from inferior to superior (paper: 159.5). Units: mm.",
                    Patterns::Double(40., 600.));
  prm.add_parameter("Chest radius", geometry.chest_radius,
                    "R, radius of the cylinder that stands for the chest; more than half of the "
                    "width. Units: mm.",
                    Patterns::Double(25., 2000.));
  prm.add_parameter("Layer", geometry.layer,
                    "Thickness of the tissue on the chest far from the breast. Units: mm.",
                    Patterns::Double(2., 100.));
  prm.add_parameter("Height", geometry.height,
                    "Height of the Gaussian that the skin is; with the other defaults 98.6 gives "
                    "the 1.14 l of the paper. Units: mm.",
                    Patterns::Double(5., 300.));
  prm.add_parameter("Sigma", geometry.sigma, "Standard deviation of that Gaussian. Units: mm.",
                    Patterns::Double(10., 300.));
  prm.add_parameter("Gland fraction", gland_fraction,
                    "Part of the tissue volume that is gland. Units: none.",
                    Patterns::Double(0., 0.8));
  prm.add_parameter("Landmarks", n_landmarks,
                    "Number of landmarks, at random in the tissue (paper: 500). Units: none.",
                    Patterns::Integer(1, 100000));
  prm.add_parameter("Seed", seed,
                    "Of all that is random; the same seed gives the same phantom. Units: none.",
                    Patterns::Integer(0, 2147483647));
}

void PhantomParameters::declare_mechanics(ParameterHandler& prm) {
  prm.add_parameter("Fat shear modulus", fat_shear_modulus,
                    "mu of fat in the truth, neo-Hookean. Units: Pa.", Patterns::Double(1., 1e6));
  prm.add_parameter("Gland ratio", gland_ratio,
                    "Shear modulus of gland over that of fat; 1 for one material (paper). "
                    "Units: none.",
                    Patterns::Double(0.05, 100.));
  prm.add_parameter("Poisson ratio", poisson_ratio, "nu of all tissue. Units: none.",
                    Patterns::Double(0., 0.499));
  prm.add_parameter("Mesh edge length", edge_length,
                    "Of the quadratic tetrahedra that carry the truth; no mesh that is to be "
                    "tested should be the same. Units: mm.",
                    Patterns::Double(1., 50.));
  prm.add_parameter("Chest", chest_, "Whether the tissue is held on the chest or slides on it.",
                    Patterns::Selection("fixed|sliding"));
  prm.add_parameter("Contact stiffness", contact_stiffness,
                    "Pressure per distance to the chest, in and out, where it slides. Units: "
                    "Pa/mm.",
                    Patterns::Double(1., 1e8));
  prm.add_parameter("Fascia stiffness", fascia_stiffness,
                    "Traction per displacement of the springs that stand for the loose fascia of "
                    "a chest on which the tissue slides. Units: Pa/mm.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter("Push pressure", push_pressure,
                    "Pressure that pushes on the left side of the prone breast towards the right, "
                    "as a coil would, and that no registration knows of. Units: Pa.",
                    Patterns::Double(-5000., 5000.));
  prm.add_parameter("Push radius", push_radius,
                    "Standard deviation of the Gaussian patch of skin that is pushed. Units: mm.",
                    Patterns::Double(2., 200.));
}

void PhantomParameters::declare_images(ParameterHandler& prm) {
  prm.add_parameter("Prone modality", modality_names_[0],
                    "MR (T1-weighted, fat bright) or CT (Hounsfield units).",
                    Patterns::Selection("MR|CT"));
  prm.add_parameter("Supine modality", modality_names_[1], "As for prone.",
                    Patterns::Selection("MR|CT"));
  prm.add_parameter("Voxel edge", voxel_edge, "Of all images. Units: mm.",
                    Patterns::Double(0.2, 20.));
  prm.add_parameter("Anterior margin", anterior_margin,
                    "Room in the images for the breast that hangs: beyond the unloaded skin. "
                    "Units: mm.",
                    Patterns::Double(0., 500.));
  prm.add_parameter("Rotation", rotation,
                    "Of the image axes about x, y and z, in this order; the field of view shrinks "
                    "so that it ends within the tissue. Units: degrees.",
                    Patterns::List(Patterns::Double(-30., 30.), 3, 3));
  prm.add_parameter("Supine offset", supine_offset,
                    "Shift of the supine voxels along the image axes. Units: mm.",
                    Patterns::List(Patterns::Double(-50., 50.), 3, 3));
  prm.add_parameter("Supine crop", supine_crop,
                    "What the supine image lacks at each end across the anterior direction. "
                    "Units: mm.",
                    Patterns::Double(0., 200.));
  prm.add_parameter("MR noise", mr_noise_,
                    "Standard deviation of the Rician noise; fat has some 200. Units: those of the "
                    "image.",
                    Patterns::Double(0., 1000.));
  prm.add_parameter("CT noise", ct_noise_, "Standard deviation of the Gaussian noise. Units: HU.",
                    Patterns::Double(0., 1000.));
  prm.add_parameter("Bias field", bias_field,
                    "Standard deviation of the logarithm of the smooth field that multiplies MR "
                    "images. Units: none.",
                    Patterns::Double(0., 1.));
  prm.add_parameter("Label jitter", label_jitter,
                    "Standard deviation of a smooth random displacement of the boundaries of the "
                    "loaded labels. Units: mm.",
                    Patterns::Double(0., 20.));
}

} // namespace prosup::phantom
