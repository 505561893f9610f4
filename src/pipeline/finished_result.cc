#include "prosup/pipeline/finished_result.h"

#include "prosup/core/error.h"
#include "prosup/output/vtu.h"

namespace prosup::pipeline {

namespace {

std::filesystem::path required(const std::filesystem::path& result, const std::string& name) {
  if (!std::filesystem::exists(result / name))
    throw Error("The folder '" + result.string() + "' holds no finished registration (no " + name +
                "); give the --output folder of prosup register.");
  return result / name;
}

} // namespace

void require_finished(const std::filesystem::path& result) {
  required(result, "summary.json");
}

evaluation::PointMapper read_mapper(const std::filesystem::path& result, const std::string& state) {
  return evaluation::PointMapper(output::read_mesh(required(result, state + "_loaded.vtu")));
}

} // namespace prosup::pipeline
