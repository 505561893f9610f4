#include "prosup/phantom/phantom_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::phantom {

using namespace dealii;

void PhantomParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Seed", seed,
                    "Seed of all random numbers: the same seed gives the same phantom.",
                    Patterns::Integer(0, 2147483647));
  prm.add_parameter("Landmarks", n_landmarks,
                    "Number of landmarks, placed at random in the tissue (paper: 500).",
                    Patterns::Integer(1, 100000));
  prm.enter_subsection("Anatomy");
  anatomy.declare(prm);
  prm.leave_subsection();
  prm.enter_subsection("Mechanics");
  mechanics.declare(prm);
  prm.leave_subsection();
  prm.enter_subsection("Images");
  images.declare(prm);
  prm.leave_subsection();
}

void AnatomyParameters::declare(ParameterHandler& prm) {
  prm.add_parameter("Width", geometry.width, "Extent from right to left (paper: 160.4). Units: mm.",
                    Patterns::Double(40., 600.));
  prm.add_parameter("Length", geometry.length,
                    "Extent from inferior to superior (paper: 159.5). Units: mm.",
                    Patterns::Double(40., 600.));
  prm.add_parameter("Chest radius", geometry.chest_radius,
                    "R, radius of the cylinder that represents the chest; more than half of the "
                    "width. Units: mm.",
                    Patterns::Double(25., 2000.));
  prm.add_parameter("Layer", geometry.layer,
                    "Thickness of the tissue on the chest far from the breast. Units: mm.",
                    Patterns::Double(2., 100.));
  prm.add_parameter("Height", geometry.height,
                    "Height of the breast over that layer, a Gaussian. With the other defaults, "
                    "98.6 gives the volume of the paper, 1.14 l. Units: mm.",
                    Patterns::Double(5., 300.));
  prm.add_parameter("Sigma", geometry.sigma, "Standard deviation of the Gaussian. Units: mm.",
                    Patterns::Double(10., 300.));
  prm.add_parameter("Gland fraction", gland_fraction,
                    "Fraction of the tissue volume that is gland. Units: none.",
                    Patterns::Double(0., 0.8));
}

void MechanicsParameters::declare(ParameterHandler& prm) {
  prm.add_parameter("Fat shear modulus", fat_shear_modulus,
                    "mu, shear modulus of fat, neo-Hookean. Units: Pa.", Patterns::Double(1., 1e6));
  prm.add_parameter("Gland ratio", gland_ratio,
                    "Shear modulus of gland over that of fat; 1 for one material (paper). "
                    "Units: none.",
                    Patterns::Double(0.05, 100.));
  prm.add_parameter("Poisson ratio", poisson_ratio,
                    "nu, Poisson's ratio of all tissue. Units: none.", Patterns::Double(0., 0.499));
  prm.add_parameter("Skin stiffness", skin_stiffness,
                    "Shear modulus of the skin times its thickness, a neo-Hookean membrane that "
                    "wrinkles under pressure; 0: no skin. Units: Pa mm.",
                    Patterns::Double(0., 1e7));
  prm.add_parameter("Mesh edge length", edge_length,
                    "Edge length of the quadratic tetrahedra on which the true displacement is "
                    "computed. A mesh under test should differ from them. Units: mm.",
                    Patterns::Double(1., 50.));
  prm.add_parameter("Chest", chest, "Whether the tissue is fixed to the chest or slides on it.",
                    Patterns::Selection("fixed|sliding"));
  prm.add_parameter("Contact stiffness", contact_stiffness,
                    "On a sliding chest, pressure per distance of the tissue from the chest, "
                    "inwards and outwards. Units: Pa/mm.",
                    Patterns::Double(1., 1e8));
  prm.add_parameter("Fascia stiffness", fascia_stiffness,
                    "On a sliding chest, traction per displacement of springs that represent the "
                    "loose fascia. Units: Pa/mm.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter("Push pressure", push_pressure,
                    "Pressure on the left side of the prone breast, towards the right, such as "
                    "from a coil. The registration does not know of it. Units: Pa.",
                    Patterns::Double(-5000., 5000.));
  prm.add_parameter("Push radius", push_radius,
                    "Standard deviation of the Gaussian patch of skin that is pushed. Units: mm.",
                    Patterns::Double(2., 200.));
}

void ImagingParameters::declare(ParameterHandler& prm) {
  prm.add_parameter("Prone modality", modality_name.prone,
                    "Modality of the prone image: MR (T1-weighted, fat bright) or CT (Hounsfield "
                    "units).",
                    one_of(modality_names()));
  prm.add_parameter("Supine modality", modality_name.supine, "Modality of the supine image.",
                    one_of(modality_names()));
  prm.add_parameter("Voxel edge", voxel_edge, "Edge of the cubic voxels of all images. Units: mm.",
                    Patterns::Double(0.2, 20.));
  prm.add_parameter("Anterior margin", anterior_margin,
                    "Space in the images in front of the unloaded skin, for the hanging breast. "
                    "Units: mm.",
                    Patterns::Double(0., 500.));
  prm.add_parameter("Rotation", rotation,
                    "Rotation of the image axes about x, y and z, in this order. The field of view "
                    "shrinks so that it ends within the tissue. Units: degrees.",
                    Patterns::List(Patterns::Double(-30., 30.), 3, 3));
  prm.add_parameter("Supine offset", supine_offset,
                    "Shift of the supine voxels along the image axes. Units: mm.",
                    Patterns::List(Patterns::Double(-50., 50.), 3, 3));
  prm.add_parameter("Supine crop", supine_crop,
                    "Width that is cut off at the left, right, upper and lower end of the supine "
                    "image. Units: mm.",
                    Patterns::Double(0., 200.));
  prm.add_parameter("MR noise", mr_noise,
                    "Standard deviation of the Rician noise of MR images, in which fat has an "
                    "intensity of about 200. Units: intensity.",
                    Patterns::Double(0., 1000.));
  prm.add_parameter("CT noise", ct_noise,
                    "Standard deviation of the Gaussian noise of CT images. Units: HU.",
                    Patterns::Double(0., 1000.));
  prm.add_parameter("Bias field", bias_field,
                    "Standard deviation of the logarithm of the smooth field that multiplies MR "
                    "images. Units: none.",
                    Patterns::Double(0., 1.));
  prm.add_parameter("Label jitter", label_jitter,
                    "Standard deviation of a smooth random displacement of the boundaries in the "
                    "label images of the loaded states. Units: mm.",
                    Patterns::Double(0., 20.));
}

Modality ImagingParameters::modality(Position position) const {
  return enumerator<Modality>(modality_name[position], modality_names());
}

} // namespace prosup::phantom
