#ifndef PROSUP_REGISTRATION_INPUTS_H
#define PROSUP_REGISTRATION_INPUTS_H

#include <deal.II/base/parameter_acceptor.h>
#include <mpi.h>

#include <optional>
#include <string>

#include "prosup/core/labels.h"
#include "prosup/core/remarks.h"
#include "prosup/image/image_io.h"
#include "prosup/image/rigid_transform.h"
#include "prosup/image/voxel_image.h"
#include "prosup/registration/case_files.h"
#include "prosup/similarity/domain.h"

namespace prosup::registration {

/// An image as it was read, and the mask of the breast on its voxels.
struct OriginalImage {
  image::ScalarImage image;
  image::LabelImage breast;
};

/// What is read of one breast for a simulation of it alone.
struct SingleInput {
  image::LabelImage labels;              ///< isotropic, on the grid of the image if there is one
  std::optional<OriginalImage> original; ///< nothing if no image is given
};

/// The images of a case, ready for use. The originals stay in the coordinates in which they were
/// read; all else is in those of the prone image.
struct Inputs {
  PerPosition<OriginalImage> originals;   ///< images on all ranks, masks on rank 0
  PerPosition<image::ScalarImage> images; ///< isotropic, scaled to [0, 1]
  similarity::Scene scene;                ///< isotropic labels
  image::RigidTransform alignment;        ///< from supine coordinates to prone ones

  /// Moves the supine image and labels, without resampling.
  void align_supine(const image::RigidTransform& to_prone);
};

/// Reads and prepares images and label images, section "Images".
class InputReader : public dealii::ParameterAcceptor {
public:
  /// Keeps a reference to `labels`.
  explicit InputReader(const Labels& labels);
  explicit InputReader(Labels&&) = delete;
  void declare_parameters(dealii::ParameterHandler& prm) override;

  // What is doubtful about a file goes to `remarks`, on the rank that reads.

  /// Images and labels of both positions, the same on all ranks. Rank 0 reads. Collective.
  /// @throws Error for files that are missing, unreadable or do not fit each other, and for labels
  /// that are not there.
  Inputs read_pair(const CaseFiles& files, MPI_Comm communicator, Remarks& remarks) const;

  /// Labels and image of one position; for one rank. @throws Error as read_pair().
  SingleInput read_breast(const CaseFiles& files, Position position, Remarks& remarks) const;

private:
  /// Reads the image, and puts `labels` on its voxels.
  OriginalImage read_original(const CaseFiles& files, Position position, image::LabelImage& labels,
                              Remarks& remarks) const;
  void prepare(const CaseFiles& files, Position position, Inputs& inputs, Remarks& remarks) const;
  image::LabelImage checked_labels(const CaseFiles& files, Position position,
                                   Remarks& remarks) const;
  image::LabelImage read_excluded(const CaseFiles& files, Position position,
                                  const image::ScalarImage& image, Remarks& remarks) const;
  image::NiftiTransform nifti_transform() const;
  void convert_contrast(Inputs& inputs) const;
  double isotropic_edge(const image::VoxelGrid& grid) const;

  double voxel_edge_ = 1.;
  double low_percentile_ = 1., high_percentile_ = 99.;
  std::string contrast_ = "as given", nifti_transform_ = "must agree";
  const Labels& labels_;
};

} // namespace prosup::registration

#endif
