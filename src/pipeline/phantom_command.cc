#include "phantom_truth.h"
#include "prosup/core/collective.h"
#include "prosup/evaluation/landmarks_csv.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/output/pictures.h"
#include "prosup/output/summary.h"
#include "prosup/phantom/grids.h"
#include "prosup/phantom/landmarks.h"
#include "prosup/phantom/phantom_body.h"
#include "prosup/phantom/state_images.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/descriptions.h"
#include "prosup/pipeline/result_run.h"

namespace prosup::pipeline {

using phantom::LoadedPhantom;

namespace {

namespace fs = std::filesystem;

constexpr const char* meshing = "Meshing";

/// An image of the phantom and the mask of its tissue.
struct PhantomImage {
  image::ScalarImage image;
  image::LabelImage tissue;
};

/// Images of a phantom and their truth, on all ranks of a communicator: all work together on the
/// two loaded breasts, the first one makes the images.
class PhantomJob {
public:
  PhantomJob(const AllParameters& all, const dealii::ParameterHandler& handler,
             const ResultTarget& output, MPI_Comm world)
      : all_(all), parameters_(all.phantom), geometry_(all.phantom.anatomy.geometry), world_(world),
        run_("phantom", handler, output, world) {}

  bool run() {
    on_every_rank(world_, [&] { check(); });
    run_.stage(meshing, [&] { build(); });
    run_.stage("Loading", [&] { load(); });
    run_.stage("Making images", [&] { on_root(world_, [&] { write(run_.folder()); }); });
    run_.summary().time.mesh = run_.seconds(meshing);
    return run_.finish();
  }

private:
  void check() {
    geometry_.check();
    for (const Position position : both_positions)
      grids_[position] = phantom::image_grid(geometry_, parameters_.images, position);
  }

  /// The grid of the unloaded image and of the fields from it.
  const image::VoxelGrid& unloaded_grid() const { return grids_.prone; }

  void build() {
    anatomy_ = std::make_unique<phantom::Anatomy>(geometry_, parameters_.anatomy.gland_fraction,
                                                  parameters_.seed);
    body_ = std::make_unique<phantom::PhantomBody>(parameters_.mechanics, *anatomy_, world_);
    run_.log().line(format("  %u quadratic tetrahedra, %u nodes, volume %.1f ml",
                           body_->body().n_global_cells() / 8, n_global_nodes(body_->body()),
                           geometry_.volume() / 1000.));
  }

  void load() {
    const unloading::UnloadingParameters& unloading = all_.model().unloading;
    for (const Position position : both_positions) {
      const dealii::Tensor<1, 3>& direction = all_.case_files.files().gravity[position];
      phantom::Load load;
      load.body_force = unloading.density * unloading.gravity / direction.norm() * direction;
      load.push_pressure = position == Position::prone ? parameters_.mechanics.push_pressure : 0.;
      loaded_[position] = body_->load(load, all_.quasi_static, run_.log());
      run_.log().line(describe(name_of(position), loaded_[position].result));
    }
  }

  void write(const fs::path& folder) {
    const phantom::Texture texture(*anatomy_, parameters_.seed);
    PerPosition<PhantomImage> images;
    unsigned random_number = 0; // each image has noise of its own
    for (const Position position : both_positions) {
      write_field(position, folder);
      images[position] = write_image(name_of(position), random_number++, position,
                                     loaded_[position].mesh, texture, folder);
    }
    const mesh::UnloadedMesh& prone = loaded_.prone.mesh;
    mesh::TetMesh at_rest = prone.mesh;
    at_rest.points = prone.unloaded;
    const PhantomImage unloaded = write_image("unloaded", random_number, Position::prone,
                                              {at_rest, prone.unloaded}, texture, folder);
    write_truth(folder);
    if (all_.results.pictures)
      write_pictures(images, unloaded, folder);
    summarize();
  }

  void write_truth(const fs::path& folder) {
    const auto landmarks = phantom::sample_landmarks(
        geometry_, {loaded_.prone.mesh, loaded_.supine.mesh}, {grids_.prone, grids_.supine},
        parameters_.n_landmarks, parameters_.seed);
    evaluation::write_landmarks(landmarks, folder / "landmarks.csv");
    initial_error_ = evaluation::initial_error(landmarks);
    write_phantom_truth({parameters_,
                         all_.model().unloading,
                         all_.case_files.files().gravity,
                         {loaded_.prone.result, loaded_.supine.result},
                         initial_error_},
                        folder / "truth.json");
    run_.log().line(format("  %zu landmarks, distance prone to supine: mean %.1f mm, max %.1f mm",
                           initial_error_.n, initial_error_.mean, initial_error_.max));
  }

  void write_field(Position position, const fs::path& folder) const {
    const mesh::UnloadedMesh& mesh = loaded_[position].mesh;
    image::write_displacement(
        output::unloaded_to_loaded(unloaded_grid(), mesh, evaluation::PointMapper(mesh))
            .displacement,
        folder / (std::string("unloaded_to_") + name_of(position) + ".nrrd"));
  }

  /// Writes an image of the modality of `position`, and its labels: exact ones of the unloaded
  /// breast, with the jitter of a segmentation for the others.
  PhantomImage write_image(const std::string& name, unsigned random_number, Position position,
                           const mesh::UnloadedMesh& mesh, const phantom::Texture& texture,
                           const fs::path& folder) const {
    const phantom::ImagingParameters& imaging = parameters_.images;
    const auto points = phantom::material_points(grids_[position], mesh);
    const phantom::StateImages images(*anatomy_, points, parameters_.seed, random_number);
    const image::LabelImage labels =
        name == "unloaded" ? images.labels() : images.jittered_labels(imaging.label_jitter);
    PhantomImage result{images.image(texture, imaging.modality(position),
                                     {imaging.noise(position), imaging.bias_field}),
                        image::select_labels(labels, {phantom::fat, phantom::gland})};
    image::write_image(result.image, folder / (name + ".nii.gz"));
    image::write_labels(labels, folder / (name + "_labels.nii.gz"));
    return result;
  }

  static void write_pictures(const PerPosition<PhantomImage>& images, const PhantomImage& unloaded,
                             const fs::path& folder) {
    std::vector<output::Panel> row;
    const auto add = [&](const char* name, const PhantomImage& shown) {
      image::IntensityRange window = image::robust_range(shown.image, shown.tissue, 1., 99.);
      window.low -= 0.3 * (window.high - window.low); // air and lung are below all tissue
      row.push_back({name, {&shown.image, window}, {}});
    };
    add("prone", images.prone);
    add("unloaded", unloaded);
    add("supine", images.supine);
    output::write_slices({row}, output::slice_box({&images.prone.tissue, &images.supine.tissue}),
                         folder);
  }

  void summarize() {
    output::Summary& summary = run_.summary();
    for (const Position position : both_positions) {
      summary.breasts[position] = output::summarize(loaded_[position].mesh);
      // Of all quadrature points of the quadratic cells.
      summary.breasts[position]->min_jacobian = loaded_[position].result.min_jacobian;
      summary.breasts[position]->max_jacobian.reset();
    }
    summary.shear_modulus = parameters_.mechanics.fat_shear_modulus;
    summary.tre.initial = initial_error_;
    summary.converged = loaded_.prone.result.converged && loaded_.supine.result.converged;
  }

  const AllParameters& all_;
  const phantom::PhantomParameters& parameters_;
  const phantom::Geometry& geometry_;
  MPI_Comm world_;
  ResultRun run_;
  PerPosition<image::VoxelGrid> grids_;
  std::unique_ptr<phantom::Anatomy> anatomy_;
  std::unique_ptr<phantom::PhantomBody> body_;
  PerPosition<LoadedPhantom> loaded_;
  evaluation::ErrorStatistics initial_error_;
};

} // namespace

bool run_phantom(const AllParameters& parameters, const dealii::ParameterHandler& all,
                 const ResultTarget& output, MPI_Comm world) {
  return PhantomJob(parameters, all, output, world).run();
}

} // namespace prosup::pipeline
