#ifndef PROSUP_MECHANICS_LAW_H
#define PROSUP_MECHANICS_LAW_H

#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "prosup/mechanics/laws/law_list.h"

namespace prosup::mechanics {

/// `Container` of all types of a LawList.
template <template <typename...> class Container, typename List>
struct OfLaws;
/// @copydoc OfLaws
template <template <typename...> class Container, typename... L>
struct OfLaws<Container, LawList<L...>> {
  using Type = Container<L...>;
};

/// One of the laws, with its coefficients. Solvers look once per call which one it is (std::visit)
/// and then run code made for that law.
using Law = OfLaws<std::variant, Laws>::Type;

/// One of each law, in the order of the list.
using AllLaws = OfLaws<std::tuple, Laws>::Type;

/// Names of the laws, as in 'Material/Model'.
const std::vector<std::string>& law_names();

/// The name of a law.
inline std::string name_of(const Law& law) {
  return law_names()[law.index()];
}

} // namespace prosup::mechanics

#endif
