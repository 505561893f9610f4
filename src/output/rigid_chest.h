#ifndef PROSUP_SRC_OUTPUT_RIGID_CHEST_H
#define PROSUP_SRC_OUTPUT_RIGID_CHEST_H

#include "prosup/output/displacement_fields.h"

namespace prosup::output {

/// Turns a field that is continued from the mesh into the rigid motion of the chest outside of it.
void turn_into_chest(image::VectorImage& field, const image::LabelImage& in_mesh,
                     const RigidChest& chest);

} // namespace prosup::output

#endif
