#include "prosup/registration/breast_model.h"

#include "grid_breast.h"
#include "prosup/core/error.h"
#include "prosup/core/parameters.h"
#include "prosup/registration/element_breast.h"

namespace prosup::registration {

namespace {

struct Method {
  const char* name;
  std::unique_ptr<Breast> (*make)(const BreastModel&, const BreastInput&, MPI_Comm);
};

/// A further method is one more line here.
constexpr Method methods[] = {{"fe",
                               [](const BreastModel& model, const BreastInput& input,
                                  MPI_Comm communicator) -> std::unique_ptr<Breast> {
                                 return make_element_breast(model, input, communicator);
                               }},
                              {"fdm",
                               [](const BreastModel& model, const BreastInput& input,
                                  MPI_Comm communicator) -> std::unique_ptr<Breast> {
                                 return std::make_unique<GridBreast>(model, input, communicator);
                               }}};

} // namespace

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Method& method : methods)
      list.emplace_back(method.name);
    return list;
  }();
  return names;
}

SimulationParameters::SimulationParameters()
    : ParameterAcceptor("Simulation"), method(method_names().front()) {}

void SimulationParameters::declare_parameters(dealii::ParameterHandler& prm) {
  prm.add_parameter("Method", method,
                    "Numerical method of register and unload. fe: finite elements. fdm: the "
                    "finite differences of the paper, for comparison.",
                    one_of(method_names()));
}

MechanicalProperties initial_properties(const BreastModel& model, unloading::ChestCondition chest) {
  MechanicalProperties properties{model.material.initial(), model.supports.chest_stiffness(chest),
                                  model.supports.lateral_chest_ratio()};
  if (model.simulation.method == "fe")
    for (const Position position : both_positions)
      properties.cut_plane_stiffness[position] = model.supports.cut_plane_stiffness();
  return properties;
}

std::unique_ptr<Breast> make_breast(const BreastModel& model, const BreastInput& input,
                                    MPI_Comm communicator) {
  for (const Method& method : methods)
    if (model.simulation.method == method.name)
      return method.make(model, input, communicator);
  throw Error("There is no numerical method '" + model.simulation.method + "'.");
}

} // namespace prosup::registration
