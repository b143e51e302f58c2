// Creases in raw points (cells/README 7): from positions and the side that normals point to.
//
//     pointNormals      normals that edges do not smear, and noise                    point_normals.h
//     links that turn by more than the angle, in clusters that are long enough
//     facesOfLinks, splitAtCreases, CellRefit, labelByLinks                           link_faces.h and so on
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

namespace cells {

struct DetectOptions {
    double angleRad = 0.5585; ///< 32 degrees: normals that differ by more are parted by a crease
    double sharpness = 1;     ///< of what is found
};

struct DetectedCreases {
    surface::Surface surface; ///< with labels and, beside creases, normals of one side; as it was where there is none
    bool found = false;
    double noise = 0;       ///< spacings
    std::size_t narrow = 0; ///< patches that are too narrow to be told
};

/// Labels that are there are made anew. Throws base::Error where normals tell no sides, and where the noise leaves
/// nothing to tell; base::Cancelled.
DetectedCreases detectCreases(const surface::Surface& surface, const DetectOptions& options = {},
                              const base::Progress& progress = {});

} // namespace cells
