#ifndef PROSUP_MECHANICS_NODE_MEMORY_H
#define PROSUP_MECHANICS_NODE_MEMORY_H

#include <map>
#include <string>

#include "prosup/core/error.h"
#include "prosup/mechanics/body/body.h"

namespace prosup::mechanics {

/// What a simulation goes on from, by name: fields of the nodes of a body and single numbers. So it
/// can be kept without knowing what it means.
struct NodeMemory {
  std::map<std::string, NodeVector> fields;
  std::map<std::string, double> numbers;

  /// @throws Error if there is none of that name.
  const NodeVector& field(const std::string& name) const { return find(fields, name); }
  double number(const std::string& name) const { return find(numbers, name); }

private:
  template <typename Value>
  static const Value& find(const std::map<std::string, Value>& values, const std::string& name) {
    const auto found = values.find(name);
    if (found == values.end())
      throw Error("The state of a simulation lacks '" + name +
                  "'; it was saved by another version, so run the simulation again.");
    return found->second;
  }
};

} // namespace prosup::mechanics

#endif
