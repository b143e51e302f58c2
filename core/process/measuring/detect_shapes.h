// Planes, spheres, cylinders, cones and tori among many points that no shape explains as a whole: scans of buildings,
// machine parts (process/README 12.1).
//
// Efficient RANSAC after [Schnabel07]: shapes through a few points that stand near each other, judged by some of the
// others, the best of them by all; what hangs together on the best is taken out, and so on until no shape of that many
// points is likely to have been missed. Points near several of the shapes then go to the one that they fit best.
//
// A point is on a shape that is no farther than a tolerance, its own where none is told: from the noise and the
// spacing at that place. Normals say which way a shape faces it; their sign means nothing. In parallel, the same bits
// at any thread count.
#pragma once

#include "core/process/measuring/primitives.h"

namespace process {

struct DetectWish {
    std::vector<Shape> shapes{Shape::Plane, Shape::Sphere, Shape::Cylinder};
    double tolerance = 0;   ///< distance; 0: of each point its own
    double angleRad = 0.35; ///< by which normals may differ from the shape's
    std::size_t fewest = 0; ///< points of a shape; 0: a hundredth of all, at least 50
};

struct DetectedShape {
    Primitive primitive;
    std::size_t points = 0;
    double rms = 0; ///< distance of these
};

struct DetectedShapes {
    std::vector<DetectedShape> shapes;  ///< those of most points first
    std::vector<std::uint32_t> shapeOf; ///< of each point 1 + the number of its shape, 0: none
    std::size_t fewest = 0;             ///< that was asked for, or chosen
};

/// Throws base::Error without normals, for fewer than 10 points, and where they stand in one place; base::Cancelled.
DetectedShapes detectShapes(const surfel::SurfelList& points, const DetectWish& wish,
                            const base::Progress& progress = {});

} // namespace process
