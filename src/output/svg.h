#ifndef PROSUP_OUTPUT_SVG_H
#define PROSUP_OUTPUT_SVG_H

#include <string>

#include "prosup/core/log.h"

// Elements of a picture in SVG; x to the right, y down, in pixels.
namespace prosup::output::svg {

/// Words as XML takes them.
inline std::string escaped(const std::string& words) {
  std::string result;
  for (const char c : words)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

/// The element that holds all others; `more` are attributes. It can be shown smaller.
inline std::string start(int width, int height, const std::string& more) {
  return format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
                "viewBox=\"0 0 %d %d\"%s>\n",
                width, height, width, height, more.c_str());
}

inline std::string text(double x, double y, const char* anchor, const std::string& words,
                        const std::string& more = "") {
  return format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>%s</text>\n", x, y, anchor,
                more.c_str(), escaped(words).c_str());
}

inline std::string line(double x1, double y1, double x2, double y2, const char* colour) {
  return format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x1, y1,
                x2, y2, colour);
}

/// A sign around a point, of one of four shapes in turn.
inline std::string marker(unsigned shape, double x, double y, double r, const std::string& colour) {
  if (shape % 4 == 0)
    return format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"/>\n", x, y, r,
                  colour.c_str());
  const double s = 1.2 * r;
  const std::string points =
      shape % 4 == 1 ? format("%.1f,%.1f %.1f,%.1f %.1f,%.1f", x, y - s, x + s, y + r, x - s, y + r)
      : shape % 4 == 2 ? format("%.1f,%.1f %.1f,%.1f %.1f,%.1f %.1f,%.1f", x - r, y - r, x + r,
                                y - r, x + r, y + r, x - r, y + r)
                       : format("%.1f,%.1f %.1f,%.1f %.1f,%.1f %.1f,%.1f", x, y - s, x + s, y, x,
                                y + s, x - s, y);
  return format("<polygon points=\"%s\" fill=\"%s\"/>\n", points.c_str(), colour.c_str());
}

} // namespace prosup::output::svg

#endif
