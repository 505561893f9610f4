#ifndef PROSUP_PIPELINE_REGISTRATION_METHOD_H
#define PROSUP_PIPELINE_REGISTRATION_METHOD_H

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "prosup/mesh/tet_mesh.h"
#include "prosup/pipeline/inputs.h"
#include "prosup/pipeline/stages.h"
#include "prosup/registration/body_pair.h"

namespace prosup::pipeline {

/// The numerical method that unloads both breasts and pushes them together, in the
/// order of these functions. All are collective on the world of the ranks.
class RegistrationMethod {
public:
  virtual ~RegistrationMethod() = default;

  /// Sets up both bodies. The images in `inputs`, which has to live on, may move.
  virtual void build(Inputs& inputs) = 0;
  /// With the properties to start with.
  virtual std::array<settling::SettlingResult, 2> unload() = 0;
  virtual registration::MaterialUpdateResult
  update_material(const registration::Observer& observer) = 0;
  virtual registration::ImageForceResult
  push_with_image_forces(const registration::Observer& observer) = 0;

  /// As they are at present.
  virtual const registration::MechanicalProperties& properties() const = 0;
  /// Meshes of both states in the coordinates of the original images, with their present
  /// unloaded positions, on rank 0; empty elsewhere.
  virtual std::array<mesh::UnloadedMesh, 2> unloaded() const = 0;
};

/// The methods that can be chosen by name.
const std::vector<std::string>& method_names();

/// Keeps references to all it is given. @throws Error if there is no method of that name.
std::unique_ptr<RegistrationMethod> make_method(const std::string& name, const Stages& stages,
                                                const registration::RankSplit& ranks,
                                                const Log& log);

} // namespace prosup::pipeline

#endif
