#include "prosup/mechanics/static/quasi_static.h"

namespace prosup::mechanics {

using namespace dealii;

const std::vector<std::string>& linear_algebra_names() {
  static const std::vector<std::string> names{"petsc-direct", "petsc-gamg", "trilinos-direct",
                                              "trilinos-amg"};
  return names;
}

QuasiStaticParameters::QuasiStaticParameters()
    : ParameterAcceptor("Quasi-static"), linear_algebra("petsc-gamg") {}

void QuasiStaticParameters::declare_parameters(ParameterHandler& prm) {
  std::string names;
  for (const std::string& name : linear_algebra_names())
    names += (names.empty() ? "" : "|") + name;
  prm.add_parameter(
      "Linear algebra", linear_algebra,
      "Solver of the linear equations in Newton's method. petsc-direct: PETSc's SNES with MUMPS. "
      "petsc-gamg: SNES with GMRES and the algebraic multigrid GAMG. trilinos-direct: MUMPS "
      "through "
      "Amesos. trilinos-amg: GMRES with the algebraic multigrid ML.",
      Patterns::Selection(names));
  prm.add_parameter("Tolerance", tolerance,
                    "Newton's method stops when the norm of the residual forces is below this "
                    "fraction of the norm of the external force. Units: none.",
                    Patterns::Double(1e-12, 1.));
  prm.add_parameter("Maximum iterations", max_iterations,
                    "Newton steps after which a load step counts as failed. Units: none.",
                    Patterns::Integer(1, 10000));
  prm.add_parameter(
      "Load steps", load_steps,
      "Number of equal steps in which the load is applied at first; a step that fails "
      "is halved. Units: none.",
      Patterns::Integer(1, 10000));
  prm.add_parameter("Maximum halvings", max_halvings,
                    "How often the load step may be halved before the solver gives up. "
                    "Units: none.",
                    Patterns::Integer(0, 30));
}

} // namespace prosup::mechanics
