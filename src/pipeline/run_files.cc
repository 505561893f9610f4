#include "run_files.h"

#include "prosup/image/image_files.h"
#include "prosup/output/registration_file.h"
#include "prosup/output/report.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

namespace {

void add(Names& names, const Names& more) {
  names.insert(names.end(), more.begin(), more.end());
}

Names mesh_of(const std::string& state) {
  return {state + "_loaded.vtu", state + "_unloaded.vtu", state + ".pvd"};
}

const Names& slices() {
  static const Names names{"slices_axial.png", "slices_sagittal.png", "slices_coronal.png"};
  return names;
}

Names of_register() {
  Names names{"landmarks.csv",
              "convergence.csv",
              "convergence.svg",
              output::registration_h5,
              output::registration_xdmf,
              output::report_html,
              "unloaded_radius_95.nii.gz",
              "prepared/"};
  add(names, slices());
  for (const Position position : both_positions) {
    const std::string state = name_of(position), other_state = name_of(other(position));
    add(names, mesh_of(state));
    add(names, {state + "_unloaded.nii.gz", "unloaded_to_" + state + ".nrrd",
                state + "_to_" + other_state + ".nrrd", "valid_" + state + ".nii.gz",
                "valid_unloaded_" + state + ".nii.gz", state + "_in_" + other_state + ".nii.gz"});
  }
  return names;
}

/// Of load and unload.
Names of_one_state(const std::string& command, const std::string& state) {
  Names names = mesh_of(state);
  add(names, slices());
  names.push_back("unloaded_to_" + state + ".nrrd");
  if (command == "unload")
    names.push_back(state + "_unloaded.nii.gz");
  else
    add(names, {state + "_to_unloaded.nrrd", state + "_loaded.nii.gz"});
  return names;
}

Names of_phantom() {
  Names names{"landmarks.csv", "truth.json"};
  add(names, slices());
  for (const char* state : {"prone", "supine", "unloaded"})
    add(names, {std::string(state) + ".nii.gz", std::string(state) + "_labels.nii.gz"});
  add(names, {"unloaded_to_prone.nrrd", "unloaded_to_supine.nrrd"});
  return names;
}

Names of_prepare() {
  Names names{"case.prm"};
  for (const Position position : both_positions) {
    const std::string state = name_of(position);
    for (const char* end : {".nii.gz", "_labels.nii.gz", "_gland.nii.gz", "_axial.png",
                            "_sagittal.png", "_coronal.png"})
      names.push_back(state + end);
  }
  return names;
}

} // namespace

std::vector<fs::path> files_read(const AllParameters& parameters, const fs::path& parameter_file) {
  const registration::CaseFiles& files = parameters.case_files.files();
  std::vector<fs::path> all{parameter_file, parameters.case_files.landmarks(),
                            parameters.single_state.mesh};
  for (const Position position : both_positions)
    for (const auto* kind : {&files.images, &files.labels, &files.excluded})
      for (const fs::path& part : image::files_of_image((*kind)[position]))
        all.push_back(part);
  const ScanParameters& scans = parameters.scans;
  for (const Position position : both_positions)
    for (const auto* kind : {&scans.scans, &scans.chest, &scans.breast, &scans.gland})
      for (const fs::path& part : image::files_of_image((*kind)[position]))
        all.push_back(part);
  return all;
}

Names files_written(const std::string& command, const dealii::ParameterHandler& parameters) {
  Names names;
  if (command == "register")
    names = of_register();
  else if (command == "phantom")
    names = of_phantom();
  else if (command == "prepare")
    names = of_prepare();
  else if (command == "mesh")
    names = mesh_of(parameters.get({"Case"}, "State"));
  else
    names = of_one_state(command, parameters.get({"Case"}, "State"));
  add(names, {"summary.json", "used.prm", log_txt});
  return names;
}

} // namespace prosup::pipeline
