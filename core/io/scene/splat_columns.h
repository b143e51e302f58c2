// 3D Gaussian splats as PLY files hold them (Kerbl 2023): `f_dc_0 ...` the colour as the zeroth spherical harmonic,
// `f_rest_...` the higher ones, `opacity` before the sigmoid, `scale_0 ...` logarithms, `rot_0 ...` a quaternion
// (io/README 2.17).
#pragma once

#include "core/io/file_model.h"
#include "core/io/record_table.h"

namespace io {

/// Whether the columns are those of splats and no others tell colours, as files do that were saved since.
bool areSplats(const std::vector<Field>& fields);

/// Replaces the harmonics by `red green blue alpha`, and takes out the normals, which such files fill with zeros. The
/// table outlives what is made of it.
void colourSplats(RecordTable& table);

/// Normals of splats that are clearly thinner than wide, of no side, and the shape of each as a support's. Others have
/// no normal, and none has a support: sizes of splats are no measure of how densely they stand. Files that bring
/// supports or shapes keep them. REQUIRES: the attributes of splats.
void shapeSplats(FileModel& model);

/// Takes out splats that are nearly transparent; returns how many.
std::size_t dropTransparent(FileModel& model);

} // namespace io
