#include "phantom_truth.h"

#include <nlohmann/json.hpp>

#include "prosup/core/text_file.h"
#include "prosup/core/version.h"

namespace prosup::pipeline {

namespace {

using Json = nlohmann::ordered_json;

Json as_json(const dealii::Tensor<1, 3>& v) {
  return {v[0], v[1], v[2]};
}

Json mechanics_of(const phantom::MechanicsParameters& phantom) {
  Json json;
  json["material"] = {
      {"model", "neo-Hookean: W = mu/2 (tr C - 3) - mu ln J + lambda/2 (ln J)^2"},
      {"mu_fat_Pa", phantom.fat_shear_modulus},
      {"mu_gland_Pa", phantom.gland_ratio * phantom.fat_shear_modulus},
      {"nu", phantom.poisson_ratio},
      {"lambda_fat_Pa",
       mechanics::lame_parameters(phantom.fat_shear_modulus, phantom.poisson_ratio).lambda}};
  if (phantom.skin_stiffness > 0.)
    json["material"]["skin_Pa_mm"] = phantom.skin_stiffness;
  json["boundary"] = {{"cut_planes", "fixed"},
                      {"skin", "free"},
                      {"chest", phantom.chest_slides() ? "sliding" : "fixed"}};
  if (phantom.chest_slides()) {
    json["boundary"]["contact_stiffness_Pa_per_mm"] = phantom.contact_stiffness;
    json["boundary"]["fascia_stiffness_Pa_per_mm"] = phantom.fascia_stiffness;
  }
  if (phantom.push_pressure != 0.)
    json["boundary"]["prone_push"] = {{"pressure_Pa", phantom.push_pressure},
                                      {"radius_mm", phantom.push_radius}};
  return json;
}

Json geometry_of(const phantom::AnatomyParameters& anatomy) {
  const phantom::Geometry& shape = anatomy.geometry;
  return {{"width_mm", shape.width},
          {"length_mm", shape.length},
          {"chest_radius_mm", shape.chest_radius},
          {"layer_mm", shape.layer},
          {"height_mm", shape.height},
          {"sigma_mm", shape.sigma},
          {"volume_ml", shape.volume() / 1000.},
          {"gland_fraction", anatomy.gland_fraction}};
}

Json images_of(const phantom::ImagingParameters& images) {
  Json json;
  for (const Position position : both_positions)
    json[name_of(position)] = {{"modality", images.modality_name[position]},
                               {"noise", images.noise(position)}};
  json["voxel_edge_mm"] = images.voxel_edge;
  json["bias_field"] = images.bias_field;
  json["label_jitter_mm"] = images.label_jitter;
  return json;
}

} // namespace

void write_phantom_truth(const PhantomTruth& truth, const std::filesystem::path& file) {
  const phantom::PhantomParameters& phantom = truth.phantom;
  Json json = mechanics_of(phantom.mechanics);
  json["version"] = version();
  json["seed"] = phantom.seed;
  json["density_g_per_mm3"] = truth.load.density;
  json["gravity_mm_per_s2"] = truth.load.gravity;
  json["geometry"] = geometry_of(phantom.anatomy);
  json["images"] = images_of(phantom.images);
  json["mesh"] = {{"element", "quadratic tetrahedra"},
                  {"edge_length_mm", phantom.mechanics.edge_length}};
  for (const Position position : both_positions) {
    const char* name = name_of(position);
    json["gravity_direction_LPS"][name] = as_json(truth.gravity_direction[position]);
    json["min_jacobian"][name] = truth.results[position].min_jacobian;
  }
  json["initial_TRE_mm"] = {{"mean", truth.initial_error.mean},
                            {"std", truth.initial_error.std},
                            {"max", truth.initial_error.max}};
  json["coordinates"] = "LPS mm";
  write_text_file(json.dump(2) + "\n", file);
}

} // namespace prosup::pipeline
