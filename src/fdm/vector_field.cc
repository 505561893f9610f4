#include "prosup/fdm/vector_field.h"

#include "prosup/fdm/trilinear_cell.h"

namespace prosup::fdm {

Tensor<1, 3> VectorField::value(const Point<3>& position) const {
  const TrilinearCell cell(grid, position);
  Tensor<1, 3> sum;
  for (unsigned corner = 0; corner < 8; ++corner)
    sum += cell.weight(corner) * values[cell.node(corner)];
  return sum;
}

} // namespace prosup::fdm
