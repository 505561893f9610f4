#include "prosup/pipeline/scan_parameters.h"

#include <tuple>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/parameters.h"

namespace prosup::pipeline {

using namespace dealii;

namespace {

const std::vector<std::string>& mask_names() {
  static const std::vector<std::string> names{"chest", "breast", "gland"};
  return names;
}

std::string entry_of(Position position, const std::string& mask) {
  return (position == Position::prone ? "Prone " : "Supine ") + mask;
}

} // namespace

ScanParameters::ScanParameters() : ParameterAcceptor("Scans") {}

void ScanParameters::declare_parameters(ParameterHandler& prm) {
  for (const Position position : both_positions) {
    const bool prone = position == Position::prone;
    prm.add_parameter(prone ? "Prone" : "Supine", scans[position],
                      std::string("Scan of the patient lying ") + name_of(position) +
                          ", as the scanner made it: NIfTI, NRRD or MetaImage, or a folder of "
                          "DICOM files. May be empty.",
                      Patterns::Anything());
  }
  for (const Position position : both_positions)
    for (const auto& [name, file, text] :
         {std::tuple(
              "chest", &chest[position],
              "chest, or of its muscle, that replaces the search of the chest wall: its front "
              "is the chest wall, and what is behind it is chest"),
          std::tuple(
              "breast", &breast[position],
              "breast that limits its tissue: the rest of the body is chest, but for 5 mm of "
              "skin on the breast"),
          std::tuple("gland", &gland[position],
                     "gland that replaces the classification of fat and gland")})
      prm.add_parameter(entry_of(position, name), *file,
                        "Mask of the " + std::string(text) +
                            ". Not 0 where it applies, on any voxels. May be empty.",
                        Patterns::Anything());
  prm.add_parameter("Series", series_,
                    "Number of the series to take from a folder of DICOM files, as in the list "
                    "that is printed: one for both folders, or two, prone and supine. Empty: the "
                    "one with most slices of those that show a whole chest.",
                    Patterns::List(Patterns::Integer(1), 0, 2));
}

void ScanParameters::parse_parameters(ParameterHandler&) {
  if (series_.size() > 2)
    throw Error("'Scans/Series' has more than two numbers; give one, or two for prone and supine.");
}

void ScanParameters::resolve(const std::filesystem::path& folder, ParameterHandler& prm) {
  std::vector<std::string> entries{"Prone", "Supine"};
  for (const Position position : both_positions)
    for (const std::string& mask : mask_names())
      entries.push_back(entry_of(position, mask));
  resolve_files(prm, get_section_name(), entries, folder);
}

void ScanParameters::require_any() const {
  if (scans.prone.empty() && scans.supine.empty())
    throw Error("No scan is given; name one with --prone FILE or --supine FILE, or both.");
}

void ScanParameters::require_no_contradiction(const registration::CaseFiles& files) const {
  for (const Position position : both_positions) {
    const char* name = name_of(position);
    if (!gives(position)) {
      for (const auto* mask : {&chest[position], &breast[position], &gland[position]})
        if (!mask->empty())
          throw Error(format("The mask '%s' is for the %s scan, which is not given; name the scan "
                             "with --%s FILE, or leave the mask out.",
                             mask->c_str(), name, name));
      continue;
    }
    for (const auto* given : {&files.labels[position], &files.images[position]})
      if (!given->empty())
        throw Error(
            format("For %s both a scan to prepare ('%s') and an image or labels that are ready "
                   "('%s') are given; leave out either --%s, or --%s-image and "
                   "--%s-labels.",
                   name, scans[position].c_str(), given->c_str(), name, name, name));
  }
}

unsigned ScanParameters::series(Position position) const {
  if (series_.empty())
    return 0;
  return position == Position::prone ? series_.front() : series_.back();
}

} // namespace prosup::pipeline
