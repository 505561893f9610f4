#include "table.h"

#include "prosup/core/log.h"

namespace prosup::benchmarks {

std::string page_head(Size size) {
  return std::string("# Hard cases\n\n") + (size == Size::small ? "small" : "full") +
         "\n\n| case | what is hard | cells | steps | retries | distance to Newton, mm | outcome | "
         "expected | ok |\n|---|---|---|---|---|---|---|---|---|\n";
}

std::string row(const Case& hard_case, const Result& result) {
  const std::string distance = result.is_compared ? format("%.3f", result.distance) : "";
  std::string outcome = name_of(result.outcome);
  if (!result.explanation.empty())
    outcome += ": " + result.explanation;
  return "| " + hard_case.name + " | " + hard_case.hardness +
         format(" | %u | %u | %u | ", result.n_cells, result.n_steps, result.n_retries) + distance +
         " | " + outcome + " | " + name_of(hard_case.expected) + " | " +
         (result.as_expected ? "yes" : "**no**") + " |\n";
}

} // namespace prosup::benchmarks
