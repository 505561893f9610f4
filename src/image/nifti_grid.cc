#include "nifti_grid.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "nifti_transforms.h"
#include "prosup/core/error.h"

namespace prosup::image {

namespace {

constexpr double largest_deviation = 0.1; // of two transforms that agree, voxels
constexpr double largest_stretch = 0.01;  // of the sform against the voxel sizes

constexpr const char* remedy = "correct the header, or set 'Images/NIfTI transform' to 'sform' or "
                               "'qform'";

std::string text(const Point<3>& x) {
  return format("(%.2f, %.2f, %.2f)", x[0], x[1], x[2]);
}

/// One header, and the sentences about it.
class Placing {
public:
  Placing(const NiftiHeader& header, NiftiTransform transform, const std::string& file,
          Remarks& remarks)
      : header_(header), transform_(transform), file_(file), remarks_(remarks),
        qform_(qform(header)), sform_(sform(header)) {}

  VoxelGrid grid() {
    check_voxel_sizes();
    if (header_.qform_code > 0 && !qform_ && sform_)
      doubt("has a qform that holds no turn or no voxel size; the sform was taken");
    if (header_.sform_code > 0 && !sform_ && qform_)
      doubt("has an sform whose numbers are no transform; the qform was taken");
    if (qform_ && sform_)
      return one_of_both();
    if (qform_)
      return regular(*qform_);
    if (sform_)
      return of_sform_alone();
    if (header_.qform_code > 0 || header_.sform_code > 0)
      refuse("has neither a qform nor an sform that is a transform",
             "correct it or convert the image again");
    refuse("does not say where the image is (the codes of its qform and sform are 0), so that left "
           "and right, prone and supine could be confused",
           "convert the image again from its source, or set the qform");
  }

private:
  [[noreturn]] void refuse(const std::string& what, const std::string& advice) const {
    throw Error("The NIfTI header of '" + file_ + "' " + what + "; " + advice + ".");
  }
  void doubt(const std::string& what) const {
    remarks_.add("The NIfTI header of '" + file_ + "' " + what + ".");
  }

  VoxelGrid regular(const VoxelSteps& place) const { return regular_grid(header_.size, place); }

  std::string voxel_sizes() const {
    return format("%g x %g x %g", header_.pixdim[0], header_.pixdim[1], header_.pixdim[2]);
  }

  void check_voxel_sizes() const {
    for (const double size : header_.pixdim)
      if (!is_size(size) || size < 0.)
        return doubt("has the voxel size " + voxel_sizes() +
                     (is_size(size) ? "; its signs were ignored" : "; it was ignored"));
  }

  VoxelGrid one_of_both() {
    const VoxelGrid by_qform = regular(*qform_);
    const Distance apart = distance(*sform_, by_qform);
    if (apart.voxels <= largest_deviation)
      try {
        return regular(*sform_);
      } catch (const std::domain_error&) {
        return by_qform; // sheared by less than a tenth of a voxel
      }
    if (distance(with_voxel_size(*sform_), by_qform).voxels <= largest_deviation) {
      doubt("has an sform that lacks the voxel size; the qform was taken");
      return by_qform;
    }
    const std::string both =
        format("has an sform (code %d) and a qform (code %d) that put the first voxel at LPS %s mm "
               "and %s mm and differ by up to %.1f mm in the image",
               header_.sform_code, header_.qform_code, text(sform_->origin).c_str(),
               text(qform_->origin).c_str(), apart.mm);
    if (transform_ == NiftiTransform::must_agree)
      refuse(both, remedy);
    const bool takes_sform = transform_ == NiftiTransform::sform;
    doubt(both + "; the " + (takes_sform ? "sform" : "qform") + " was taken");
    return takes_sform ? regular(*sform_) : by_qform;
  }

  VoxelSteps with_voxel_size(VoxelSteps place) const {
    for (unsigned axis = 0; axis < 3; ++axis)
      place.steps[axis] *= std::abs(header_.pixdim[axis]);
    return place;
  }

  VoxelGrid of_sform_alone() {
    double stretch = 0.;
    for (unsigned axis = 0; axis < 3; ++axis)
      if (is_size(header_.pixdim[axis]))
        stretch =
            std::max(stretch, std::abs(sform_->steps[axis].norm() /
                                           (header_.millimetres * std::abs(header_.pixdim[axis])) -
                                       1.));
    if (stretch > largest_stretch) {
      const std::string both =
          format("has voxels of %g x %g x %g by its sform, but of %s by its voxel size", //
                 sform_->steps[0].norm() / header_.millimetres,
                 sform_->steps[1].norm() / header_.millimetres,
                 sform_->steps[2].norm() / header_.millimetres, voxel_sizes().c_str());
      if (transform_ != NiftiTransform::sform)
        refuse(both, "correct the header, or set 'Images/NIfTI transform' to 'sform' if that is "
                     "right");
      doubt(both + "; the sform was taken");
    }
    return regular(*sform_);
  }

  const NiftiHeader& header_;
  const NiftiTransform transform_;
  const std::string& file_;
  Remarks& remarks_;
  const std::optional<VoxelSteps> qform_, sform_;
};

} // namespace

VoxelGrid nifti_grid(const NiftiHeader& header, NiftiTransform transform, const std::string& file,
                     Remarks& remarks) {
  return Placing(header, transform, file, remarks).grid();
}

} // namespace prosup::image
