#ifndef PROSUP_REGISTRATION_BREAST_MODEL_H
#define PROSUP_REGISTRATION_BREAST_MODEL_H

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/tensor.h>
#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

#include "prosup/core/labels.h"
#include "prosup/core/log.h"
#include "prosup/fdm/fdm_parameters.h"
#include "prosup/mechanics/body/element.h"
#include "prosup/mechanics/laws/tissue_material.h"
#include "prosup/mesh/mask_mesher.h"
#include "prosup/registration/breast.h"
#include "prosup/unloading/support_parameters.h"
#include "prosup/unloading/unloading_parameters.h"

namespace prosup::registration {

/// The numerical methods that can be chosen by name: fe (finite elements) and fdm (the finite
/// differences of the paper).
const std::vector<std::string>& method_names();

/// Choice of the numerical method, section "Simulation".
class SimulationParameters : public dealii::ParameterAcceptor {
public:
  SimulationParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  std::string method; ///< of method_names()
};

/// How breasts are modelled: the parameters of all methods.
struct BreastModel {
  /// Keeps a reference to the labels.
  explicit BreastModel(const Labels& labels) : mesher(labels), material(labels) {}

  SimulationParameters simulation;
  mesh::MaskMesher mesher;
  mechanics::ElementParameters elements;
  mechanics::TissueMaterial material;
  unloading::SupportParameters supports;
  unloading::UnloadingParameters unloading;
  fdm::FdmParameters fdm;
};

/// The properties to start with.
MechanicalProperties initial_properties(const BreastModel& model, unloading::ChestCondition chest);

/// What belongs to one breast and not to the method.
struct BreastInput {
  Position position;
  const similarity::Scene& scene;                                     ///< its labels at least
  dealii::Tensor<1, 3> gravity;                                       ///< direction, LPS
  unloading::ChestCondition chest = unloading::ChestCondition::fixed; ///< at the chest wall
  const mesh::MeshSource* mesher = nullptr; ///< of finite elements; null: that of the model
  Log log{};                                ///< is told of the progress
};

/// A breast of the model's method, with the properties to start with. Keeps references to the
/// model and the scene. Collective on `communicator`.
/// @throws Error if the labels cannot be meshed, or if nothing holds the breast.
std::unique_ptr<Breast> make_breast(const BreastModel& model, const BreastInput& input,
                                    MPI_Comm communicator);

} // namespace prosup::registration

#endif
