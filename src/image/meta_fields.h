#ifndef PROSUP_SRC_IMAGE_META_FIELDS_H
#define PROSUP_SRC_IMAGE_META_FIELDS_H

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace prosup::image {

/// The lines "Name = value" of a MetaImage header, up to the one that names the voxels.
class MetaFields {
public:
  /// @throws Error that names `file` if a line is none, or if the last one is missing.
  MetaFields(const std::string& text, std::string file);

  /// Bytes up to the end of the last line.
  std::size_t length() const { return length_; }
  bool has(const std::string& name) const { return values_.count(name) != 0; }
  /// Empty if there is none.
  std::string text(const std::string& name) const;
  bool flag(const std::string& name, bool otherwise) const;
  /// `n` numbers. @throws Error if there are others.
  std::optional<std::vector<double>> numbers(const std::string& name, std::size_t n) const;
  std::optional<double> number(const std::string& name) const;
  /// The numbers of whichever of the names is there. @throws Error if two differ.
  std::optional<std::vector<double>> numbers(const std::vector<std::string>& names,
                                             std::size_t n) const;

  [[noreturn]] void refuse(const std::string& what) const;

private:
  const std::string file_;
  std::map<std::string, std::string> values_;
  std::size_t length_ = 0;
};

} // namespace prosup::image

#endif
