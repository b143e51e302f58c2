// A model's positions as the file's coordinates, for writers.
#pragma once

#include "core/io/file_model.h"

namespace io {

inline bool hasOrigin(const FileModel& model) {
    return !(model.origin == base::Vec3d{});
}

/// Coordinates of a point in the file. With an origin the sum is rounded to double, and a reader that subtracts the
/// origin gets the float back only where the double is fine enough (isExact).
inline base::Vec3d fileCoordinates(const FileModel& model, std::size_t i) {
    return base::cast<double>(model.points.items[i].position) + model.origin;
}

/// Whether the coordinates bring back the bits of every float: small floats near the origin of far coordinates do not.
bool coordinatesAreExact(const FileModel& model);

} // namespace io
