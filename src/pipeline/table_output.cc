#include "table_output.h"

#include <algorithm>
#include <cctype>

#include "prosup/core/error.h"

namespace prosup::pipeline {

void require_csv(const std::filesystem::path& output) {
  std::string end = output.extension().string();
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!end.empty() && end != ".csv" && end != ".txt")
    throw Error("The output '" + output.string() + "' ends in '" + end +
                "', but what is written is CSV; give a name that ends in .csv.");
}

} // namespace prosup::pipeline
