#ifndef PROSUP_PIPELINE_COMMANDS_H
#define PROSUP_PIPELINE_COMMANDS_H

#include <deal.II/base/parameter_handler.h>
#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/core/result_folder.h"
#include "prosup/pipeline/all_parameters.h"
#include "prosup/pipeline/outcome.h"

namespace prosup::pipeline {

// The commands that take a parameter file. Each is given the parameters and, for used.prm, the
// handler that they came from, and returns whether its simulations settled or its runs succeeded.
// Collective on `world`.

/// `prosup register`: both images and masks to the registered unloaded pair.
Outcome run_register(const AllParameters& parameters, const dealii::ParameterHandler& all,
                     const ResultTarget& output, MPI_Comm world);

/// `prosup check`: what is wrong with the input of run_register(), without any simulation; writes
/// no files. @returns whether there are no errors.
bool run_check(const AllParameters& parameters, const dealii::ParameterHandler& all,
               const ResultTarget& output, MPI_Comm world);

/// `prosup mesh`: the mask of one position to a mesh, with a quality report.
bool run_mesh(const AllParameters& parameters, const dealii::ParameterHandler& all,
              const ResultTarget& output, MPI_Comm world);

/// `prosup unload`: one breast to its unloaded configuration.
bool run_unload(const AllParameters& parameters, const dealii::ParameterHandler& all,
                const ResultTarget& output, MPI_Comm world);

/// `prosup load`: one unloaded breast to its loaded configuration.
bool run_load(const AllParameters& parameters, const dealii::ParameterHandler& all,
              const ResultTarget& output, MPI_Comm world);

/// `prosup prepare`: scans of one or both positions to images and labels that run_register() takes.
bool run_prepare(const AllParameters& parameters, const dealii::ParameterHandler& all,
                 const ResultTarget& output, MPI_Comm world);

/// `prosup phantom`: images of a numerical phantom, with their truth.
bool run_phantom(const AllParameters& parameters, const dealii::ParameterHandler& all,
                 const ResultTarget& output, MPI_Comm world);

/// `prosup compare`: the runs of section Comparison, each as a process of its own, with tables and
/// a picture that bear the name of the output folder. For one rank, without mpirun.
/// @throws Error if a peer is not installed, or if all runs fail (after writing).
bool run_compare(const AllParameters& parameters, const dealii::ParameterHandler& all,
                 const ResultTarget& output, MPI_Comm world);

/// Where a user says that the nipple is in each loaded state, LPS, mm: "X,Y,Z", or empty.
using GivenNipples = PerPosition<std::string>;

/// What `prosup map` is asked for.
struct MapRequest {
  std::filesystem::path result; ///< folder of a finished registration, or its registration.h5
  std::string from, to;         ///< prone, supine or unloaded
  std::filesystem::path points, output;
  GivenNipples nipples;
  bool overwrite = false; ///< an output that prosup did not write
};

/// `prosup map`: points from one state to another with a finished registration.
/// For one rank.
void run_map(const MapRequest& request);

/// What `prosup report` is asked for.
struct ReportRequest {
  std::filesystem::path result; ///< folder of a finished registration
  bool overwrite = false;       ///< a report that was changed since prosup wrote it
};

/// `prosup report`: the report of a finished registration anew. For one rank.
void run_report(const ReportRequest& request);

/// What `prosup table` is asked for.
struct TableRequest {
  std::vector<std::filesystem::path> results; ///< folders of registrations, finished or not
  std::filesystem::path output;               ///< .csv or .html; empty: CSV to standard output
  bool overwrite = false;                     ///< an output that prosup did not write
};

/// `prosup table`: the verdicts and figures of many registrations. For one rank.
void run_table(const TableRequest& request);

/// What `prosup warp` is asked for.
struct WarpRequest {
  std::filesystem::path result; ///< folder of a finished registration
  std::string from, to;         ///< prone, supine or unloaded
  std::filesystem::path input, output;
  std::string interpolation;  ///< of image::interpolation_names(); empty: chosen by the input
  bool labels = false;        ///< the input is a label map, whatever its values look like
  std::filesystem::path like; ///< image whose grid the output gets; empty: that of the state
  bool overwrite = false;     ///< an output that prosup did not write
};

/// `prosup warp`: an image, a label map or a surface model from one state to another with a
/// finished registration. For one rank.
void run_warp(const WarpRequest& request);

/// What `prosup field` is asked for.
struct FieldRequest {
  std::filesystem::path result; ///< folder of a finished registration
  std::string from, to;         ///< prone, supine or unloaded
  std::filesystem::path output;
  std::filesystem::path like; ///< image whose grid the field gets; empty: that of the state `from`
  bool overwrite = false;     ///< an output that prosup did not write
};

/// `prosup field`: the displacement field from one state to another, as a transform of ITK or an
/// image of vectors. For one rank.
void run_field(const FieldRequest& request);

/// What `prosup landmarks` is asked for.
struct LandmarkRequest {
  std::filesystem::path result; ///< folder of a finished registration, or its registration.h5
  std::vector<std::filesystem::path> observers;
  std::filesystem::path control; ///< may be empty
  double exclude_above = 10.;    ///< mm, as in the paper
  std::filesystem::path output;
  bool overwrite = false; ///< an output that prosup did not write
};

/// `prosup landmarks`: errors of a finished registration at the landmarks of
/// several observers, and how far these agree. For one rank.
void run_landmarks(const LandmarkRequest& request);

} // namespace prosup::pipeline

#endif
