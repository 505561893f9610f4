#include "prosup/core/remarks.h"

#include <algorithm>

namespace prosup {

void Remarks::add(const std::string& sentence) {
  if (std::find(all_.begin(), all_.end(), sentence) != all_.end())
    return;
  all_.push_back(sentence);
  log_.warning(sentence);
}

} // namespace prosup
