#ifndef PROSUP_OUTPUT_CANVAS_H
#define PROSUP_OUTPUT_CANVAS_H

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace prosup::output {

using Colour = std::array<std::uint8_t, 3>;

/// A picture in memory; pixel (0, 0) is at the top left. Needs no display.
class Canvas {
public:
  Canvas(int width, int height, const Colour& background);

  /// Pixels outside the picture are ignored.
  void set(int x, int y, const Colour& colour);

  /// Writes text with its middle at (x, y).
  void text(int x, int y, const std::string& text, int font_size, const Colour& colour);

  /// The bytes of a PNG file; empty if VTK cannot make them.
  std::string png() const;

  /// @throws Error if the file cannot be written.
  void write_png(const std::filesystem::path& file) const;

private:
  void blend(int x, int y, const Colour& colour, double opacity);

  int width_, height_;
  std::vector<Colour> pixels_;
};

} // namespace prosup::output

#endif
