#include <CLI/CLI.hpp>

#include "command_table.h"
#include "prosup/core/collective.h"
#include "prosup/image/warp.h"
#include "state_map.h"

namespace prosup::pipeline {

namespace {

void add_map_options(CLI::App& command, MapRequest& request) {
  const CLI::IsMember states(state_names());
  command
      .add_option("--result", request.result,
                  "Result folder of prosup register, or its registration.h5")
      ->required();
  command.add_option("--from", request.from, "State of the points")->required()->check(states);
  command.add_option("--to", request.to, "State to map them to")->required()->check(states);
  command
      .add_option("POINTS", request.points, "Points: CSV (id,x,y,z), .fcsv or .mrk.json; LPS mm")
      ->required();
  command
      .add_option("-o,--output", request.output,
                  "File to write: .csv, or .fcsv and .mrk.json for 3D Slicer")
      ->required();
  for (const Position position : both_positions)
    command.add_option(std::string("--") + name_of(position) + "-nipple", request.nipples[position],
                       std::string("Nipple in the ") + name_of(position) +
                           " image, X,Y,Z (LPS mm); by default the skin furthest from the chest in "
                           "prone");
  command.add_flag("--overwrite", request.overwrite,
                   "Replace the output even if it is not what this command has written");
}

void add_warp_options(CLI::App& command, WarpRequest& request) {
  const CLI::IsMember states(state_names());
  command.add_option("--result", request.result, "Result folder of prosup register")->required();
  command.add_option("--from", request.from, "State of the input")->required()->check(states);
  command.add_option("--to", request.to, "State to carry it to")->required()->check(states);
  command
      .add_option("INPUT", request.input,
                  "Image, label map, or surface model (.vtp, .stl, .obj; LPS mm)")
      ->required();
  command.add_option("-o,--output", request.output, "File to write, of the format of its ending")
      ->required();
  command
      .add_option("--interpolation", request.interpolation,
                  "Between voxels; by default linear, and nearest if the values mark regions")
      ->check(CLI::IsMember(image::interpolation_names()));
  command.add_flag("--labels", request.labels,
                   "The input is a label map, whatever its values look like");
  command.add_option("--like", request.like,
                     "Image whose grid the output gets; by default that of the state's image");
  command.add_flag("--overwrite", request.overwrite, "Replace the output whatever it is");
}

void add_field_options(CLI::App& command, FieldRequest& request) {
  const CLI::IsMember states(state_names());
  command.add_option("--result", request.result, "Result folder of prosup register")->required();
  command.add_option("--from", request.from, "State on whose image the field lies")
      ->required()
      ->check(states);
  command.add_option("--to", request.to, "State to which it leads")->required()->check(states);
  command
      .add_option("-o,--output", request.output,
                  "File to write: .h5 (transform of ITK), .nrrd or .mha (image of vectors)")
      ->required();
  command.add_option("--like", request.like,
                     "Image whose grid the field gets; by default that of the state's image");
  command.add_flag("--overwrite", request.overwrite, "Replace the output whatever it is");
}

void add_report_options(CLI::App& command, ReportRequest& request) {
  command.add_option("RESULT", request.result, "Result folder of prosup register")->required();
  command.add_flag("--overwrite", request.overwrite,
                   "Replace the report even if it was changed since prosup wrote it");
}

void add_landmark_options(CLI::App& command, LandmarkRequest& request) {
  command
      .add_option("--result", request.result,
                  "Result folder of prosup register, or its registration.h5")
      ->required();
  command.add_option("OBSERVERS", request.observers, "Landmarks of one observer each, CSV")
      ->required();
  command.add_option("--control", request.control,
                     "Supine landmarks of an observer who was shown the prone ones of the first: "
                     "CSV (id,supine_x,... or id,x,y,z), .fcsv or .mrk.json");
  command
      .add_option("--exclude-above", request.exclude_above,
                  "Landmarks that two observers place further apart are not reliable (mm)")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command.add_option("-o,--output", request.output, "CSV file to write")->required();
  command.add_flag("--overwrite", request.overwrite,
                   "Replace the output even if it is not what this command has written");
}

void add_table_options(CLI::App& command, TableRequest& request) {
  command
      .add_option(
          "RESULT", request.results,
          "Result folders of prosup register; one without a finished result gets a row that "
          "says so")
      ->required();
  command.add_option("-o,--output", request.output,
                     "File to write, .csv or .html; by default CSV to the screen");
  command.add_flag("--overwrite", request.overwrite,
                   "Replace the output even if it is not what this command has written");
}

/// A command whose request is that member of all requests. It runs on one rank.
template <typename Options, typename Run, typename What>
Command on_result(const char* name, const char* text, What Request::*request, Options add_options,
                  Run run) {
  return {name, text,
          [=](CLI::App& app, const auto&, Request& all) { add_options(app, all.*request); },
          [=](const Request& all, MPI_Comm world) {
            on_root(world, [&] { run(all.*request); });
            return Outcome::success;
          }};
}

} // namespace

std::vector<Command> result_commands() {
  return {
      on_result("map", "Points from one state to another", &Request::map, add_map_options, run_map),
      on_result("warp", "An image, a label map or a model from one state to another",
                &Request::warp, add_warp_options, run_warp),
      on_result("field", "A displacement field as a transform for other programs", &Request::field,
                add_field_options, run_field),
      on_result("report", "The report of a result anew", &Request::report, add_report_options,
                run_report),
      on_result("landmarks", "Errors at the landmarks of several observers", &Request::landmarks,
                add_landmark_options, run_landmarks),
      on_result("table", "The verdicts and figures of many results", &Request::table,
                add_table_options, run_table)};
}

} // namespace prosup::pipeline
