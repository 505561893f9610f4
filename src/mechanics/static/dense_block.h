#ifndef PROSUP_SRC_MECHANICS_STATIC_DENSE_BLOCK_H
#define PROSUP_SRC_MECHANICS_STATIC_DENSE_BLOCK_H

#include <deal.II/base/tensor.h>

#include <vector>

namespace prosup::mechanics {

/// The entries of a block row by row, as libraries in C take them.
inline std::vector<double> dense(const dealii::Tensor<2, 3>& block) {
  std::vector<double> entries;
  for (unsigned row = 0; row < 3; ++row)
    for (unsigned column = 0; column < 3; ++column)
      entries.push_back(block[row][column]);
  return entries;
}

} // namespace prosup::mechanics

#endif
