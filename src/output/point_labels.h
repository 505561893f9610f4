#ifndef PROSUP_OUTPUT_POINT_LABELS_H
#define PROSUP_OUTPUT_POINT_LABELS_H

#include <string>
#include <vector>

namespace prosup::output {

/// Writes names beside points of a picture where they cover nothing.
class PointLabels {
public:
  /// Labels stay between `left` and `right` (pixels).
  PointLabels(double left, double right) : left_(left), right_(right) {}

  /// A sign that no label may cover.
  void occupy(double x, double y, double radius);

  /// SVG of a label beside a point: above, right, below or left of it, the first of
  /// these that is free; empty if none is.
  std::string place(double x, double y, const std::string& words, const std::string& colour);

private:
  struct Box {
    double left, upper, right, lower;
  };
  bool is_free(const Box& box) const;

  double left_, right_;
  std::vector<Box> taken_;
};

} // namespace prosup::output

#endif
