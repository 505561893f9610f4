#ifndef PROSUP_OUTPUT_SURFACE_MODEL_H
#define PROSUP_OUTPUT_SURFACE_MODEL_H

#include <deal.II/base/point.h>

#include <cstddef>
#include <filesystem>
#include <functional>

namespace prosup::output {

/// Whether the ending of the file name is that of a surface model: .vtp, .stl or .obj.
bool is_model(const std::filesystem::path& file);

/// Writes the model `from` to `to`, with all points moved by `map`, LPS mm. A model that says that
/// it is in RAS is turned to LPS; what says nothing is taken as LPS, as 3D Slicer writes models.
/// Normals, which belong to the old shape, are left out. Any of the formats may become another.
/// @returns the number of points. @throws Error if a file cannot be read or written, has no points,
/// or if `map` gives a position that is not finite.
std::size_t move_model(const std::filesystem::path& from, const std::filesystem::path& to,
                       const std::function<dealii::Point<3>(const dealii::Point<3>&)>& map);

} // namespace prosup::output

#endif
