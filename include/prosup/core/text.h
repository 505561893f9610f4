#ifndef PROSUP_CORE_TEXT_H
#define PROSUP_CORE_TEXT_H

#include <sstream>
#include <string>
#include <vector>

namespace prosup {

/// The values one after the other, as in "ssd, nmi, lncc".
template <typename Value>
std::string joined(const std::vector<Value>& values, const char* separator = ", ") {
  std::ostringstream text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text << (i == 0 ? "" : separator) << values[i];
  return text.str();
}

} // namespace prosup

#endif
