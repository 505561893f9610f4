#include "prosup/pipeline/scan_parameters.h"

#include "prosup/core/error.h"
#include "prosup/core/parameters.h"

namespace prosup::pipeline {

using namespace dealii;

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
  resolve_files(prm, get_section_name(), {"Prone", "Supine"}, folder);
}

void ScanParameters::require_any() const {
  if (scans.prone.empty() && scans.supine.empty())
    throw Error("No scan is given; name one with --prone FILE or --supine FILE, or both.");
}

unsigned ScanParameters::series(Position position) const {
  if (series_.empty())
    return 0;
  return position == Position::prone ? series_.front() : series_.back();
}

} // namespace prosup::pipeline
