#include "prosup/mechanics/laws/law.h"

namespace prosup::mechanics {

namespace {

template <typename... L>
std::vector<std::string> names_of(LawList<L...>) {
  return {L::name...};
}

} // namespace

const std::vector<std::string>& law_names() {
  static const std::vector<std::string> names = names_of(Laws());
  return names;
}

} // namespace prosup::mechanics
