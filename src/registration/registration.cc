#include "prosup/registration/registration.h"

#include <deal.II/base/mpi.h>

#include <cmath>
#include <utility>

#include "prosup/core/collective.h"
#include "prosup/core/error.h"
#include "prosup/image/broadcast.h"

namespace prosup::registration {

using settling::SettlingResult;

namespace {

// A breast that is too soft for its weight becomes stiffer by this factor, so many times: up to
// 11 times as stiff in short attempts, then up to 3.4 times with all patience.
constexpr double stiffening = 1.5;
constexpr unsigned most_attempts = 7, most_stiffenings = 3;

} // namespace

Registration::Registration(const RegistrationParameters& parameters, MPI_Comm world, const Log& log)
    : parameters_(parameters), log_(log), ranks_(world),
      metric_(parameters.similarity.make_metric()) {}

void Registration::read(const CaseFiles& files) {
  Remarks remarks(log_);
  read(files, remarks);
}

void Registration::read(const CaseFiles& files, Remarks& remarks) {
  files_ = files;
  inputs_ = parameters_.images.read_pair(files, ranks_.world(), remarks);
  is_aligned_ = false;
  pair_.reset();
  stage_ = resumed_ = Stage::nothing;
}

void Registration::align() {
  is_aligned_ = true;
  if (!parameters_.pre_alignment.wanted())
    return;
  image::RigidTransform to_prone;
  on_root(ranks_.world(), [&] {
    alignment_ = parameters_.pre_alignment.run(inputs_.originals.prone.image,
                                               inputs_.originals.supine.image, inputs_.scene);
    if (!alignment_)
      return;
    log_.line(describe(*alignment_));
    to_prone = alignment_->transform;
  });
  image::broadcast(to_prone, ranks_.world());
  inputs_.align_supine(to_prone);
}

PerPosition<dealii::Tensor<1, 3>> Registration::gravity() const {
  return {files_.gravity.prone, inputs_.alignment.rotation * files_.gravity.supine};
}

SceneReport Registration::check() const {
  SceneReport report;
  on_root(ranks_.world(), [&] {
    report = parameters_.checks.check_pair(inputs_, gravity(), metric_->needs_same_contrast());
  });
  return report;
}

void Registration::build() {
  if (!is_aligned_)
    align();
  make_pair({mesher_, mesher_});
  stage_ = Stage::built;
}

void Registration::make_pair(const PerPosition<const mesh::MeshSource*>& meshers) {
  const BreastModel& model = parameters_.model;
  const MechanicalProperties properties = initial_properties(model, files_.chest);
  const PerPosition<dealii::Tensor<1, 3>> gravity = this->gravity();
  const bool speaks = dealii::Utilities::MPI::max(int(log_.speaks()), ranks_.world()) > 0;
  pair_ = std::make_unique<BreastPair>(ranks_, properties, [&](Position position, MPI_Comm group) {
    return make_breast(model,
                       {position, inputs_.scene, gravity[position], files_.chest, meshers[position],
                        speaks ? Log(group) : Log()},
                       group);
  });
}

/// A body that is too soft to have an unloaded state becomes stiffer: the search of the properties
/// has to start where there is one. Short attempts come first, since a soft breast takes long until
/// nothing has helped, and may then settle with its chest held, which its search would keep.
PerPosition<SettlingResult> Registration::unload_stiff_enough() {
  const MechanicalProperties given = pair_->properties();
  const bool may_stiffen = parameters_.material_update.searches();
  // Finite differences need returns where nothing is too soft.
  const unsigned first = may_stiffen && pair_->consists_of_elements() ? 0 : most_attempts;
  pair_->save();
  for (unsigned n = first;; ++n) {
    const bool is_short = n < most_attempts;
    const unsigned n_stiffenings = is_short ? n : n - most_attempts;
    MechanicalProperties properties = given;
    properties.tissue.shear_modulus *= std::pow(stiffening, n_stiffenings);
    try {
      if (n > first) {
        log_.line(format("  Once more with %.4g Pa", properties.tissue.shear_modulus));
        if (is_short)
          pair_->restore();
        else // nodes may be held by now
          make_pair({mesher_, mesher_});
        pair_->set_properties(properties);
      }
      PerPosition<SettlingResult> results = pair_->unload({0, is_short});
      if (n_stiffenings > 0)
        results.prone.remarks.push_back(
            format("With 'Material/Shear modulus' as given a breast did not settle, so the search "
                   "of the properties starts from %.4g Pa.",
                   properties.tissue.shear_modulus));
      return results;
    } catch (const Error& error) {
      if (!may_stiffen || n == most_attempts + most_stiffenings)
        throw;
      log_.line("  " + std::string(error.what()));
    }
  }
}

PerPosition<SettlingResult> Registration::unload() {
  if (!pair_)
    build();
  if (resumed_ < Stage::unloaded) {
    unloaded_ = unload_stiff_enough();
    converged_ = unloaded_.prone.converged && unloaded_.supine.converged;
    material_ = {};
    forces_ = {};
    stage_ = Stage::unloaded;
  }
  return unloaded_;
}

ComparedImages Registration::compared() const {
  return {inputs_.images, inputs_.scene, metric_, parameters_.similarity.n_layers,
          parameters_.similarity.margin};
}

MaterialUpdateResult Registration::match_properties() {
  if (resumed_ < Stage::properties_matched) {
    if (stage_ >= Stage::properties_matched) // once more
      material_ = {};
    parameters_.material_update.run(*pair_, compared(), log_, observer_, material_, keeper_);
    converged_ = converged_ && material_.result.converged;
    stage_ = Stage::properties_matched;
  }
  return material_.result;
}

ImageForceResult Registration::match_images() {
  if (resumed_ < Stage::images_matched) {
    if (stage_ >= Stage::images_matched)
      forces_ = {};
    parameters_.image_forces.run(*pair_, compared(), log_, observer_, forces_, keeper_);
    converged_ = converged_ && forces_.result.converged;
    stage_ = Stage::images_matched;
  }
  return forces_.result;
}

UncertaintyParameters::Covariances Registration::covariances() const {
  bool descended = true;
  pair_->for_each([&](Position position, Breast&) {
    descended = descended && forces_.level > 0 && forces_.start[position].size() > 0;
  });
  if (!descended)
    return {};
  return parameters_.uncertainty.covariances(*pair_, compared(), forces_.start);
}

RegistrationResult Registration::result() const {
  RegistrationResult result{pair_->meshes(), pair_->properties(), converged_};
  const image::RigidTransform to_supine = inputs_.alignment.inverse();
  for (dealii::Point<3>& point : result.meshes.supine.mesh.points)
    point = to_supine(point);
  return result;
}

} // namespace prosup::registration
