#include "prosup/core/text.h"

#include <cstddef>

namespace prosup {

std::string one_printable_line(std::string text) {
  constexpr std::size_t longest = 2000, kept = 900;
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
      c = '?';
  if (text.size() > longest)
    text.replace(kept, text.size() - 2 * kept, " ... ");
  return text;
}

} // namespace prosup
