#ifndef PROSUP_BENCHMARKS_SETUP_H
#define PROSUP_BENCHMARKS_SETUP_H

#include <CLI/CLI.hpp>
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "prosup/core/collective.h"
#include "prosup/core/parameters.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/mask_mesher.h"

namespace prosup::benchmarks {

/// Model name of the processor, as Linux tells it.
inline std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.rfind("model name", 0) == 0)
      return line.substr(line.find(':') + 2);
  return "unknown processor";
}

/// Meshes of about the wanted number of cells from a label image.
class MeshSource {
public:
  explicit MeshSource(const std::string& labels_file) : labels_(image::read_labels(labels_file)) {}

  mesh::TetMesh mesh(double edge_length) const {
    const Labels label_values;
    mesh::MaskMesher mesher(label_values);
    dealii::ParameterHandler parameters;
    read_parameters(parameters, {}, {"Meshing/Edge length=" + std::to_string(edge_length)});
    return mesher.mesh(labels_);
  }

  /// Cells go with the third power of the edge length, so that two tries do.
  mesh::TetMesh mesh_of(unsigned n_cells) const {
    double edge = 8.;
    mesh::TetMesh result = mesh(edge);
    for (unsigned i = 0; i < 2; ++i) {
      edge *= std::cbrt(static_cast<double>(result.cells.size()) / n_cells);
      result = mesh(edge);
    }
    return result;
  }

private:
  image::LabelImage labels_;
};

/// Runs `work` in a benchmark program's surroundings: MPI, and one sentence on
/// standard error if it fails.
template <typename Work>
int run_program(int argc, char** argv, CLI::App& app, Work work) {
  MPI_Init(&argc, &argv);
  int exit_code = 0;
  try {
    app.parse(argc, argv);
    work();
  } catch (const CLI::ParseError& request) {
    exit_code = app.exit(request);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), error.what());
    exit_code = 1;
  }
  MPI_Finalize();
  return exit_code;
}

} // namespace prosup::benchmarks

#endif
