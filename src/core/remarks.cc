#include "prosup/core/remarks.h"

#include <algorithm>

#include "prosup/core/text.h"

namespace prosup {

void Remarks::add(const std::string& sentence) {
  const std::string line = one_printable_line(sentence);
  if (std::find(all_.begin(), all_.end(), line) != all_.end())
    return;
  all_.push_back(line);
  log_.warning(line);
}

} // namespace prosup
