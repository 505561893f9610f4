#ifndef PROSUP_TESTS_UNIT_PREPARE_PREPARATION_OF_H
#define PROSUP_TESTS_UNIT_PREPARE_PREPARATION_OF_H

#include <vector>

#include "prosup/core/parameters.h"
#include "prosup/prepare/preparation.h"

namespace prosup::tests {

/// A preparation with some parameters.
class PreparationOf {
public:
  explicit PreparationOf(const std::vector<Override>& overrides) : preparation_(labels_) {
    read_parameters("", overrides);
  }
  prepare::PreparedScan run(const image::ScalarImage& scan,
                            const prepare::UserMasks& masks = {}) const {
    return preparation_.run(scan, Log(), masks);
  }

private:
  Labels labels_;
  prepare::Preparation preparation_;
};

} // namespace prosup::tests

#endif
