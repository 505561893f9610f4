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

/// Precision of the internal forces; positions and sums are double always.
enum class Precision { double_precision, single_precision };

/// The finite element of a body.
struct Element {
  ElementType type = ElementType::linear;
  Precision precision = Precision::double_precision;
  std::string instruction_set = "best"; ///< of the processor, or of instruction_set_names()

  unsigned degree() const { return type == ElementType::quadratic ? 2 : 1; }
  unsigned n_nodes() const { return type == ElementType::quadratic ? 10 : 4; }
  /// Linear tetrahedra that interpolate nodal fields in an element; see Body::cells().
  unsigned n_cells() const { return degree() == 1 ? 1 : 8; }
};

/// The elements and precisions that can be chosen by name, in the order of
/// their enumerators.
const std::vector<std::string>& element_names();
const std::vector<std::string>& precision_names();

/// The instruction sets that forces are compiled for, the plainest first; not all
/// may run on this processor.
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
