// Feet on the surface of a model with cells (cells/README 5): on faces, on seams where two cells meet, at corners where
// three or more do. Float64 near creases; where only one cell is near the position and its foot, the answer of the
// surface without cells, bit for bit.
#pragma once

#include "core/cells/cell_value.h"
#include "core/surface/projection/project.h"

namespace cells {

/// What a point of the surface lies on.
enum class Feature : unsigned char { None, Face, Seam, Corner };
const char* featureName(Feature feature);

/// Of the spacing: a foot so near to a seam or corner lies on it.
constexpr double featureTolerance = 1e-3;

struct CellFoot {
    surface::Projection<double> projection;
    Feature feature = Feature::None;  ///< of the foot
    std::vector<std::uint32_t> cells; ///< that meet there: one, two, or more
    bool mixed = false;               ///< several cells had a say
};

/// By cells alone, wherever on the model.
CellFoot projectCells(const CellSurface& surface, const base::Vec3d& x, const surface::ProjectOptions& options = {});

/// By cells where several are near, else as surface::projectReference.
CellFoot project(const CellSurface& surface, const base::Vec3d& x, const surface::ProjectOptions& options = {});

} // namespace cells
