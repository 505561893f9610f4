#include "prosup/registration/registration.h"

#include <deal.II/base/mpi.h>

#include <utility>

#include "prosup/core/collective.h"
#include "prosup/image/broadcast.h"

namespace prosup::registration {

using settling::SettlingResult;

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
}

void Registration::align() {
  is_aligned_ = true;
  if (!parameters_.pre_alignment.wanted())
    return;
  image::RigidTransform to_prone;
  on_root(ranks_.world(), [&] {
    alignment_ = parameters_.pre_alignment.run(inputs_.originals.prone.image,
                                               inputs_.originals.supine.image, inputs_.scene);
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
  const BreastModel& model = parameters_.model;
  const MechanicalProperties properties{model.material.initial(),
                                        model.supports.chest_stiffness(files_.chest)};
  const PerPosition<dealii::Tensor<1, 3>> gravity = this->gravity();
  const bool speaks = dealii::Utilities::MPI::max(int(log_.speaks()), ranks_.world()) > 0;
  pair_ = std::make_unique<BreastPair>(ranks_, properties, [&](Position position, MPI_Comm group) {
    return make_breast(model,
                       {position, inputs_.scene, gravity[position], files_.chest, mesher_,
                        speaks ? Log(group) : Log()},
                       group);
  });
}

PerPosition<SettlingResult> Registration::unload() {
  if (!pair_)
    build();
  const PerPosition<SettlingResult> results = pair_->unload();
  converged_ = results.prone.converged && results.supine.converged;
  return results;
}

ComparedImages Registration::compared() const {
  return {inputs_.images, inputs_.scene, metric_, parameters_.similarity.n_layers,
          parameters_.similarity.margin};
}

MaterialUpdateResult Registration::match_properties() {
  const MaterialUpdateResult result =
      parameters_.material_update.run(*pair_, compared(), log_, observer_);
  converged_ = converged_ && result.converged;
  return result;
}

ImageForceResult Registration::match_images() {
  const ImageForceResult result = parameters_.image_forces.run(*pair_, compared(), log_, observer_);
  converged_ = converged_ && result.converged;
  return result;
}

RegistrationResult Registration::result() const {
  RegistrationResult result{pair_->meshes(), pair_->properties(), converged_};
  const image::RigidTransform to_supine = inputs_.alignment.inverse();
  for (dealii::Point<3>& point : result.meshes.supine.mesh.points)
    point = to_supine(point);
  return result;
}

} // namespace prosup::registration
