#include "scan_stage.h"

#include <deal.II/base/mpi.h>

#include "prosup/core/collective.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"
#include "prosup/output/outlines.h"
#include "prosup/prepare/dicom.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

ScanStage::ScanStage(const ScanStageParameters& parameters, const fs::path& folder, ResultRun& run,
                     MPI_Comm world)
    : parameters_(parameters), folder_(folder.empty() ? run.folder() : run.folder() / folder),
      run_(run), world_(world) {}

void ScanStage::run(Position position) {
  const std::string name = name_of(position);
  image::ScalarImage scan;
  run_.stage("Reading " + name + " scan", [&] { on_root(world_, [&] { scan = read(position); }); });
  run_.stage("Segmenting " + name,
             [&] { on_root(world_, [&] { segment(position, std::move(scan)); }); });
  run_.stage("Writing " + name, [&] { on_root(world_, [&] { write(position); }); });
}

fs::path ScanStage::image(Position position) const {
  return folder_ / (std::string(name_of(position)) + ".nii.gz");
}

fs::path ScanStage::labels(Position position) const {
  return folder_ / (std::string(name_of(position)) + "_labels.nii.gz");
}

bool ScanStage::contrasts_differ() const {
  const bool differ =
      contrasts_.prone && contrasts_.supine && *contrasts_.prone != *contrasts_.supine;
  return dealii::Utilities::MPI::broadcast(world_, static_cast<int>(differ)) != 0;
}

image::ScalarImage ScanStage::read(Position position) {
  const fs::path file = parameters_.scans.scans[position];
  return fs::is_directory(file)
             ? prepare::read_dicom(file, position, parameters_.scans.series(position), run_.log(),
                                   run_.remarks())
             : image::read_image(file, run_.remarks());
}

prepare::UserMasks ScanStage::read_masks(Position position) {
  const auto read = [&](const std::string& file) {
    return file.empty() ? std::nullopt : std::optional(image::read_labels(file, run_.remarks()));
  };
  const ScanParameters& scans = parameters_.scans;
  return {read(scans.chest[position]), read(scans.breast[position]), read(scans.gland[position])};
}

void ScanStage::segment(Position position, image::ScalarImage scan) {
  prepared_ = parameters_.preparation.run(std::move(scan), run_.log(), read_masks(position));
  contrasts_[position] = prepared_.contrast;
  for (const std::string& doubt : prepared_.confidence.doubts) {
    doubts_.push_back(format("In %s, %s", name_of(position), doubt.c_str()));
    run_.remarks().add(doubts_.back());
  }
}

void ScanStage::write(Position position) {
  fs::create_directories(folder_);
  const std::string name = name_of(position);
  image::write_image(prepared_.image, image(position));
  image::write_labels(prepared_.labels, labels(position));
  image::write_image(prepared_.gland, folder_ / (name + "_gland.nii.gz"));
  const Labels& labels = parameters_.labels;
  if (parameters_.pictures)
    output::write_outlines(prepared_.image, prepared_.labels,
                           {labels.chest, labels.fat(), labels.gland}, name, folder_);
  run_.log().line(
      format("  fat %.0f ml, gland %.0f ml", prepared_.fat_volume, prepared_.gland_volume));
  output::PreparationSummary& summary = run_.summary().preparation[position].emplace();
  const prepare::Confidence& confidence = prepared_.confidence;
  summary.contrast = prepare::contrast_names()[std::size_t(prepared_.contrast)];
  summary.fat_volume = prepared_.fat_volume;
  summary.gland_volume = prepared_.gland_volume;
  summary.weak_edge = confidence.weak_edge;
  summary.bridged_area = confidence.bridged_area;
  summary.odd_area = confidence.odd_area;
  summary.unknown_contact = prepared_.unknown_contact;
  summary.separation = confidence.separation;
  summary.doubts = confidence.doubts;
}

} // namespace prosup::pipeline
