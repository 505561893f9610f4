#include "state_hdf5.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <type_traits>

#include "prosup/output/mesh_hdf5.h"

namespace prosup::pipeline {

using namespace dealii;
using registration::BreastState;
using registration::RegistrationState;

namespace {

/// The names that any rank has, and its numbers, which are the same wherever they are.
std::map<std::string, double> of_all_ranks(const std::map<std::string, double>& mine,
                                           MPI_Comm world) {
  const std::vector<std::pair<std::string, double>> list(mine.begin(), mine.end());
  std::map<std::string, double> all;
  for (const auto& numbers : Utilities::MPI::all_gather(world, list))
    all.insert(numbers.begin(), numbers.end());
  return all;
}

/// Calls `visit` with the path of each single number of a state.
template <typename State, typename Visitor>
void for_each_number(State& state, const Visitor& visit) {
  visit("registration/stage", state.stage);
  visit("registration/converged", state.converged);
  visit("registration/shear_modulus", state.properties.tissue.shear_modulus);
  visit("registration/poisson_ratio", state.properties.tissue.poisson_ratio);
  visit("registration/gland_ratio", state.properties.tissue.gland_ratio);
  visit("registration/skin_stiffness", state.properties.tissue.skin_stiffness);
  visit("registration/chest_stiffness", state.properties.chest_stiffness);
  visit("registration/lateral_chest_ratio", state.properties.lateral_chest_ratio);
  for (const Position position : both_positions)
    visit(std::string("registration/cut_plane_stiffness_") + name_of(position),
          state.properties.cut_plane_stiffness[position]);
  visit("registration/tilt_left", state.properties.tilt.left);
  visit("registration/tilt_superior", state.properties.tilt.superior);
  for (unsigned i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    visit("alignment/centre_" + axis, state.alignment.centre[i]);
    visit("alignment/translation_" + axis, state.alignment.translation[i]);
    for (unsigned j = 0; j < 3; ++j)
      visit("alignment/rotation_" + axis + "xyz"[j], state.alignment.rotation[i][j]);
  }
  for (const Position position : both_positions) {
    auto& unloaded = state.unloaded[position];
    const std::string group = std::string("unloading_") + name_of(position);
    visit(group + "/converged", unloaded.converged);
    visit(group + "/n_steps", unloaded.n_steps);
    visit(group + "/n_retries", unloaded.n_retries);
    visit(group + "/residual", unloaded.residual);
    visit(group + "/distance", unloaded.distance);
    visit(group + "/min_jacobian", unloaded.min_jacobian);
  }
  const auto visit_grid = [&](const std::string& group, auto& grid) {
    for (unsigned d = 0; d < 3; ++d) {
      const std::string axis(1, "xyz"[d]);
      visit(group + "/size_" + axis, grid.size[d]);
      visit(group + "/origin_" + axis, grid.origin[d]);
      visit(group + "/spacing_" + axis, grid.spacing[d]);
    }
  };
  auto& material = state.material;
  visit("material/n_steps", material.result.n_steps);
  visit("material/n_trials", material.result.n_trials);
  visit("material/converged", material.result.converged);
  visit("material/level", material.level);
  visit("material/first_value", material.first_value);
  visit("material/best_value", material.best_value);
  visit("material/n_accepted", material.n_accepted);
  visit("material/damping", material.damping);
  visit("material/n_independent", material.n_independent);
  visit("material/is_exact", material.is_exact);
  visit("material/walks_back", material.walks_back);
  visit_grid("material", material.grid);
  auto& forces = state.image_forces;
  visit("image_forces/n_steps", forces.result.n_steps);
  visit("image_forces/n_all_updates", forces.result.n_updates);
  visit("image_forces/converged", forces.result.converged);
  visit("image_forces/level", forces.level);
  visit("image_forces/n_updates", forces.n_updates);
  visit("image_forces/gained", forces.gained);
  visit("image_forces/length", forces.length);
  visit("image_forces/weight", forces.weight);
  visit_grid("image_forces", forces.grid);
}

} // namespace

void write_state(output::Hdf5Writer& file, const std::string& group, const BreastState& breast,
                 MPI_Comm world) {
  output::write_tets(file, group + "/mesh", breast.mesh);
  file.rows(group + "/nodes", breast.nodes);
  std::map<std::string, double> names;
  for (const auto& field : breast.fields)
    names[field.first] = 0.;
  for (const auto& name : of_all_ranks(names, world)) {
    const auto mine = breast.fields.find(name.first);
    file.rows(group + "/fields/" + name.first,
              mine == breast.fields.end() ? std::vector<double>() : mine->second, 3);
  }
  for (const auto& [name, value] : of_all_ranks(breast.numbers, world))
    file.number(group + "/numbers/" + name, value);
}

BreastState read_breast_state(const output::Hdf5Reader& file, const std::string& group) {
  BreastState breast;
  breast.mesh = output::read_tets(file, group + "/mesh");
  breast.nodes = file.integers(group + "/nodes");
  for (const std::string& name : file.data_sets(group + "/fields"))
    breast.fields[name] = file.doubles(group + "/fields/" + name);
  for (const std::string& name : file.attributes(group + "/numbers"))
    breast.numbers[name] = file.number(group + "/numbers/" + name);
  return breast;
}

void write_state(output::Hdf5Writer& file, const RegistrationState& state, MPI_Comm world) {
  for_each_number(state, [&](const std::string& path, const auto& value) {
    file.number(path, static_cast<double>(value));
  });
  // All ranks have all derivatives, of which each writes its part.
  std::vector<float> all, mine;
  for (const std::vector<float>& derivative : state.material.derivatives)
    all.insert(all.end(), derivative.begin(), derivative.end());
  const std::size_t n = Utilities::MPI::n_mpi_processes(world),
                    rank = Utilities::MPI::this_mpi_process(world);
  mine.assign(all.begin() + static_cast<std::ptrdiff_t>(all.size() * rank / n),
              all.begin() + static_cast<std::ptrdiff_t>(all.size() * (rank + 1) / n));
  file.rows("material/derivatives", mine);
  file.number("material/n_derivatives", static_cast<double>(state.material.derivatives.size()));
  for (const Position position : both_positions)
    write_state(file, name_of(position), state.breasts[position], world);
}

RegistrationState read_registration_state(const output::Hdf5Reader& file) {
  RegistrationState state;
  for_each_number(state, [&](const std::string& path, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_enum_v<Value>)
      value = static_cast<Value>(static_cast<int>(file.number(path)));
    else
      value = static_cast<Value>(file.number(path));
  });
  const std::vector<float> all = file.floats("material/derivatives");
  const auto n = static_cast<std::size_t>(file.number("material/n_derivatives"));
  for (std::size_t i = 0; i < n; ++i)
    state.material.derivatives.emplace_back(
        all.begin() + static_cast<std::ptrdiff_t>(all.size() / n * i),
        all.begin() + static_cast<std::ptrdiff_t>(all.size() / n * (i + 1)));
  for (const Position position : both_positions)
    state.breasts[position] = read_breast_state(file, name_of(position));
  return state;
}

} // namespace prosup::pipeline
