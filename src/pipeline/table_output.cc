#include "table_output.h"

#include "prosup/core/error.h"
#include "prosup/core/text.h"

namespace prosup::pipeline {

void require_csv(const std::filesystem::path& output) {
  const std::string end = lower_case(output.extension().string());
  if (!end.empty() && end != ".csv" && end != ".txt")
    throw Error("The output '" + output.string() + "' ends in '" + end +
                "', but what is written is CSV; give a name that ends in .csv.");
}

} // namespace prosup::pipeline
