#ifndef PROSUP_CORE_LABELS_H
#define PROSUP_CORE_LABELS_H

#include <deal.II/base/parameter_acceptor.h>

#include <vector>

namespace prosup {

/// What the values of the label images mean, section "Labels"; 0 is air.
class Labels : public dealii::ParameterAcceptor {
public:
  Labels();
  void declare_parameters(dealii::ParameterHandler& prm) override;
  void parse_parameters(dealii::ParameterHandler& prm) override;

  /// @throws Error if a value is given twice or is not between 1 and 255, if there is
  /// no tissue, or if gland is not one of the tissues.
  void check() const;

  /// The first tissue that is not gland. @throws Error if there is none.
  unsigned fat() const;

  unsigned chest = 1;                  ///< chest wall and muscle
  std::vector<unsigned> tissues{2, 3}; ///< what the breast consists of
  unsigned gland = 3;                  ///< one of the tissues; 0 if the labels do not tell it
  unsigned unknown = 255;              ///< what the image does not show; 0 if it is not marked
};

} // namespace prosup

#endif
