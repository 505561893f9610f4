#include "prosup/pipeline/case_parameters.h"

#include "prosup/core/error.h"
#include "prosup/core/parameters.h"

namespace prosup::pipeline {

using namespace dealii;

namespace {

std::string capitalized(std::string word) {
  word[0] = static_cast<char>(std::toupper(word[0]));
  return word;
}

void require_file(const std::string& value, const std::string& entry, const std::string& option) {
  if (value.empty())
    throw Error("No file is given for '" + entry +
                "'; name it in the parameter file (section "
                "Case) or with " +
                option + " FILE.");
}

} // namespace

CaseParameters::CaseParameters() : ParameterAcceptor("Case") {}

void CaseParameters::declare_parameters(ParameterHandler& prm) {
  for (const Position position : both_positions) {
    const std::string name = name_of(position), Name = capitalized(name);
    prm.add_parameter(Name + " image", files_.images[position],
                      "Image of the loaded " + name + " breast: NIfTI, NRRD or MetaImage.",
                      Patterns::Anything());
    prm.add_parameter(Name + " labels", files_.labels[position],
                      "Labels on the same voxels; what they mean is said in section Labels.",
                      Patterns::Anything());
    prm.add_parameter(Name + " excluded", files_.excluded[position],
                      "Mask on the same voxels. Where it is not 0 the image gives no force, for "
                      "instance at marker clips. May be empty.",
                      Patterns::Anything());
    prm.add_parameter(Name + " gravity", files_.gravity[position],
                      "Direction of gravity, LPS. Units: none (its length does not matter).");
  }
  prm.add_parameter("Landmarks", landmarks_,
                    "Landmarks for evaluation only, CSV: id,prone_x,...,supine_z. May be empty.",
                    Patterns::Anything());
  prm.add_parameter("Supine offset", files_.supine_offset,
                    "Is added to all supine coordinates (image, labels, landmarks) as they are "
                    "read, to see how much a misaligned chest matters. Units: mm.");
  prm.add_parameter("State", state_, "What the commands mesh, unload and load work on.",
                    Patterns::Selection("prone|supine"));
  prm.add_parameter("Chest", chest_,
                    "Motion of the tissue on the chest wall. fixed: none. sliding: along it. "
                    "one-sided: along it, and it may lift off.",
                    one_of(unloading::chest_condition_names()));
}

void CaseParameters::parse_parameters(ParameterHandler&) {
  for (const Position position : both_positions)
    if (!(files_.gravity[position].norm() > 0.))
      throw Error("The direction 'Case/" + capitalized(name_of(position)) +
                  " gravity' is 0,0,0; give a direction in LPS, such as 0,-1,0 for prone and "
                  "0,1,0 for supine.");
  files_.chest = enumerator<unloading::ChestCondition>(chest_, unloading::chest_condition_names());
}

Position CaseParameters::position() const {
  return state_ == name_of(Position::prone) ? Position::prone : Position::supine;
}

void CaseParameters::resolve(const std::filesystem::path& folder, ParameterHandler& prm) {
  resolve_files(prm, get_section_name(),
                {"Prone image", "Prone labels", "Prone excluded", "Supine image", "Supine labels",
                 "Supine excluded", "Landmarks"},
                folder);
}

void CaseParameters::require_pair() const {
  for (const Position position : both_positions)
    require(position);
}

void CaseParameters::require(Position position) const {
  const std::string name = name_of(position);
  require_file(files_.images[position], "Case/" + capitalized(name) + " image",
               "--" + name + "-image");
  require_labels(position);
}

void CaseParameters::require_labels(Position position) const {
  const std::string name = name_of(position);
  require_file(files_.labels[position], "Case/" + capitalized(name) + " labels",
               "--" + name + "-labels");
}

} // namespace prosup::pipeline
