#ifndef PROSUP_MECHANICS_ELEMENT_H
#define PROSUP_MECHANICS_ELEMENT_H

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace prosup::mechanics {

enum class ElementType {
  linear,         ///< 4 nodes, constant strain; locks towards incompressibility
  nodal_pressure, ///< 4 nodes; volume changes averaged at the nodes
  quadratic       ///< 10 nodes, 4 quadrature points
};

/// Precision of the internal forces; positions and sums are always double.
enum class Precision { double_precision, single_precision };

/// The finite element of a body.
struct Element {
  ElementType type = ElementType::linear;
  Precision precision = Precision::double_precision;
  std::string instruction_set = "best"; ///< best of the processor, or one by its name

  unsigned degree() const { return type == ElementType::quadratic ? 2 : 1; }
  unsigned n_nodes() const { return type == ElementType::quadratic ? 10 : 4; }
  /// Linear tetrahedra that interpolate nodal fields in an element; see Body::cells().
  unsigned n_cells() const { return degree() == 1 ? 1 : 8; }
};

/// Names of the elements and precisions in parameters, in the order of their enumerators.
const std::vector<std::string>& element_names();
const std::vector<std::string>& precision_names();

/// Names of the instruction sets for which forces are compiled, the simplest first. This
/// processor may lack some of them.
const std::vector<std::string>& instruction_set_names();

/// Choice of the element, section "Elements".
class ElementParameters : public dealii::ParameterAcceptor {
public:
  ElementParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  Element element() const;

private:
  std::string type_, precision_, instruction_set_ = "best";
};

} // namespace prosup::mechanics

#endif
