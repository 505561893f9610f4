// A registration that goes on in another process.

#include "prosup/registration/registration_state.h"

#include "prosup/registration/element_breast.h"
#include "prosup/registration/registration.h"

namespace prosup::registration {

namespace {

/// The fields of ImageForceProgress, by name.
template <typename Progress, typename Work>
void for_each_field(Progress& progress, const Work& work) {
  work("image_force_start", progress.start);
  work("image_force_present", progress.present);
}

/// The mesh of a state, whatever the labels.
struct GivenMesh : mesh::MeshSource {
  explicit GivenMesh(const mesh::TetMesh& mesh) : given(mesh) {}
  mesh::TetMesh mesh(const image::LabelImage&) const override { return given; }
  const mesh::TetMesh& given;
};

} // namespace

bool Registration::has_state() const {
  return parameters_.model.simulation.method == "fe";
}

RegistrationState Registration::state() const {
  RegistrationState state;
  state.stage = stage_;
  state.alignment = inputs_.alignment;
  state.properties = pair_->properties();
  state.converged = converged_;
  state.unloaded = unloaded_;
  state.material = material_;
  state.image_forces = forces_;
  for_each_field(state.image_forces, [](const char*, auto& field) { field = {}; });
  pair_->for_each([&](Position position, Breast& breast) {
    const ElementBreast& elements = *breast.elements();
    state.breasts[position] = elements.state();
    for_each_field(forces_, [&](const char* name, const auto& field) {
      if (field[position].size() > 0)
        state.breasts[position].fields[name] = elements.rows_of(field[position]);
    });
  });
  return state;
}

void Registration::resume(const RegistrationState& state) {
  if (!has_state())
    throw Error("A registration by finite differences cannot go on from a state; only those of "
                "finite elements can, so run it from the start.");
  inputs_.align_supine(state.alignment);
  is_aligned_ = true;
  const GivenMesh prone(state.breasts.prone.mesh), supine(state.breasts.supine.mesh);
  make_pair({&prone, &supine});
  pair_->set_properties(state.properties);
  stage_ = resumed_ = state.stage;
  converged_ = state.converged;
  unloaded_ = state.unloaded;
  material_ = state.material;
  forces_ = state.image_forces;
  pair_->for_each([&](Position position, Breast& breast) {
    const BreastState& saved = state.breasts[position];
    breast.elements()->resume(saved);
    for_each_field(forces_, [&](const char* name, auto& field) {
      const auto rows = saved.fields.find(name);
      if (rows != saved.fields.end())
        field[position] = breast.elements()->field_of(saved.nodes, rows->second);
    });
  });
}

} // namespace prosup::registration
