#include "meta_header.h"

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

#include "meta_fields.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"

namespace prosup::image {

namespace {

/// One header: its entries, and the sentences about it.
class Reading {
public:
  Reading(const std::string& text, const std::string& file, Remarks& remarks)
      : fields_(text, file), file_(file), remarks_(remarks) {}

  MetaHeader header() {
    const std::string object = fields_.text("ObjectType");
    if (!object.empty() && object != "Image")
      fields_.refuse("is that of a " + object + ", not of an Image");
    set_size();
    set_place();
    set_values();
    set_data();
    return std::move(header_);
  }

private:
  void doubt(const std::string& what) const {
    remarks_.add("The MetaImage header of '" + file_ + "' " + what + ".");
  }

  /// A whole number from `least` to what a double holds exactly.
  std::int64_t whole(const std::string& name, double value, double least) const {
    constexpr double largest = 9e15;
    if (!(value >= least && value <= largest) || value != std::floor(value))
      fields_.refuse(format("has %g in %s, which must be a whole number from %g on", value,
                            name.c_str(), least));
    return static_cast<std::int64_t>(value);
  }

  void set_size() {
    constexpr double most_dimensions = 10.; // of MetaIO
    const auto dimensions = fields_.number("NDims");
    if (!dimensions || !(*dimensions <= most_dimensions))
      fields_.refuse("has no NDims from 1 to 10");
    n_dimensions_ = static_cast<std::size_t>(whole("NDims", *dimensions, 1.));
    const auto sizes = fields_.numbers("DimSize", n_dimensions_);
    if (!sizes)
      fields_.refuse("has no DimSize");
    std::size_t n_extended = std::min<std::size_t>(n_dimensions_, 3);
    for (std::size_t d = 0; d < n_dimensions_; ++d) {
      const auto size = static_cast<std::size_t>(whole("DimSize", (*sizes)[d], 1.));
      if (d < 3)
        header_.size[d] = size;
      else if (size > 1)
        ++n_extended;
    }
    if (n_extended != 3)
      throw Error(format("'%s' has %zu dimension%s, but a three-dimensional image is needed; "
                         "convert it to one volume.",
                         file_.c_str(), n_extended, n_extended == 1 ? "" : "s"));
  }

  void set_place() {
    const std::size_t n = n_dimensions_;
    const auto spacing = fields_.has("ElementSpacing") ? fields_.numbers("ElementSpacing", n)
                                                       : fields_.numbers("ElementSize", n);
    const auto origin = fields_.numbers({"Offset", "Position", "Origin"}, n);
    const auto axes = fields_.numbers({"TransformMatrix", "Rotation", "Orientation"}, n * n);
    std::vector<std::string> missing;
    if (!spacing)
      missing.emplace_back("ElementSpacing (1 mm was assumed)");
    if (!origin)
      missing.emplace_back("Offset (0 was assumed)");
    if (!axes)
      missing.emplace_back("TransformMatrix (axes along left, posterior and superior were "
                           "assumed)");
    if (!missing.empty())
      doubt("has no " + joined(missing, ", no "));
    const double millimetres = unit();
    for (unsigned d = 0; d < 3; ++d) {
      header_.spacing[d] = millimetres * (spacing ? (*spacing)[d] : 1.);
      header_.origin[d] = millimetres * (origin ? (*origin)[d] : 0.);
      for (unsigned e = 0; e < 3; ++e)
        header_.direction[e][d] = axes ? (*axes)[d * n + e] : (d == e ? 1. : 0.);
    }
    check_spacing();
    check_customs(axes.has_value());
  }

  void check_spacing() const {
    for (unsigned d = 0; d < 3; ++d)
      if (!(header_.spacing[d] > 0.) || !std::isfinite(header_.spacing[d]))
        throw Error(format("'%s' has a voxel spacing of %g mm along axis %u, which must be "
                           "positive; correct its header.",
                           file_.c_str(), header_.spacing[d], d));
  }

  double unit() const {
    const std::string unit = fields_.text("DistanceUnits");
    if (unit == "um" || unit == "cm") {
      doubt("gives lengths in " + unit + ", in which they were read");
      return unit == "um" ? 1e-3 : 10.;
    }
    if (!unit.empty() && unit != "mm" && unit != "?")
      fields_.refuse("has '" + unit + "' in DistanceUnits, where um, mm and cm are allowed");
    return 1.;
  }

  /// Entries that no reader uses for the place of voxels, if they contradict those that count.
  void check_customs(bool has_axes) const {
    const auto centre = fields_.numbers("CenterOfRotation", n_dimensions_);
    const bool is_turned =
        (header_.direction - Tensor<2, 3>(dealii::unit_symmetric_tensor<3>())).norm() > 1e-6;
    if (centre && is_turned &&
        std::any_of(centre->begin(), centre->end(), [](double c) { return c != 0.; }))
      doubt(
          "turns about a CenterOfRotation that is not 0; it was ignored, as ITK and 3D Slicer do");
    const std::string letters = fields_.text("AnatomicalOrientation");
    if (!has_axes && !letters.empty() && letters[0] != '?' && letters != "RAI" && letters != "LPS")
      doubt("has the AnatomicalOrientation " + letters +
            " but no TransformMatrix; it was ignored, "
            "as ITK and 3D Slicer do");
  }

  NumberType number_type() const {
    static const std::pair<const char*, NumberType> types[] = {
        {"MET_CHAR", NumberType::int8},       {"MET_UCHAR", NumberType::uint8},
        {"MET_SHORT", NumberType::int16},     {"MET_USHORT", NumberType::uint16},
        {"MET_INT", NumberType::int32},       {"MET_UINT", NumberType::uint32},
        {"MET_LONG", NumberType::int32},      {"MET_ULONG", NumberType::uint32},
        {"MET_LONG_LONG", NumberType::int64}, {"MET_ULONG_LONG", NumberType::uint64},
        {"MET_FLOAT", NumberType::float32},   {"MET_DOUBLE", NumberType::float64}};
    std::string name = fields_.text("ElementType");
    const std::size_t array = name.rfind("_ARRAY"); // of channels, in old files
    if (array != std::string::npos && array + 6 == name.size())
      name.resize(array);
    for (const auto& [known, type] : types)
      if (name == known)
        return type;
    fields_.refuse(name.empty() ? "has no ElementType"
                                : "has the ElementType " + name + ", which is none for voxels");
  }

  void set_values() {
    constexpr double most_channels = 1 << 20;
    StoredValues& values = header_.values;
    values.type = number_type();
    const double channels = fields_.number("ElementNumberOfChannels").value_or(1.);
    values.n_components = static_cast<unsigned>(
        whole("ElementNumberOfChannels", std::min(channels, most_channels), 1.));
    // Both names are in use.
    values.swapped =
        fields_.flag("BinaryDataByteOrderMSB", fields_.flag("ElementByteOrderMSB", false)) !=
        (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__);
    values.slope = fields_.number("ElementToIntensityFunctionSlope").value_or(1.);
    values.intercept = fields_.number("ElementToIntensityFunctionOffset").value_or(0.);
    if (values.slope == 0.)
      fields_.refuse("has a slope of 0, with which all voxels are equal");
    if (values.slope != 1. || values.intercept != 0.)
      doubt(format("has the slope %g and the offset %g, which were applied although not all "
                   "programs do so",
                   values.slope, values.intercept));
  }

  void set_data() {
    header_.is_binary = fields_.flag("BinaryData", true);
    header_.is_packed = fields_.flag("CompressedData", false);
    if (const auto size = fields_.number("CompressedDataSize"))
      header_.packed_size = static_cast<std::uintmax_t>(whole("CompressedDataSize", *size, 0.));
    if (header_.packed_size == 0u)
      header_.packed_size.reset();
    if (const auto size = fields_.number("HeaderSize"))
      header_.skipped = whole("HeaderSize", *size, -1.);
    header_.data_file = fields_.text("ElementDataFile");
    if (header_.data_file.empty())
      fields_.refuse("names no ElementDataFile");
    header_.length = fields_.length();
  }

  const MetaFields fields_;
  const std::string& file_;
  Remarks& remarks_;
  std::size_t n_dimensions_ = 0;
  MetaHeader header_;
};

} // namespace

bool MetaHeader::is_local() const {
  return data_file == "LOCAL" || data_file == "Local" || data_file == "local";
}

bool is_meta_image(const std::string& text) {
  const std::size_t name = text.find("NDims");
  return name != std::string::npos && text.find("ElementDataFile", name) != std::string::npos;
}

MetaHeader parse_meta_header(const std::string& text, const std::string& file, Remarks& remarks) {
  return Reading(text, file, remarks).header();
}

} // namespace prosup::image
