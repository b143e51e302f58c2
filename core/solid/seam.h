// Where two surfaces cross, traced as curves (solid/README 2.5): seams of two solids, and by heights above both the way
// of a ball that rolls along them.
//
// Model coordinates, float64. Pure functions of what is asked: the same bits wherever they run.
#pragma once

#include "core/solid/side.h"

#include <functional>
#include <optional>
#include <vector>

namespace solid {

/// A place, and which way either function rises there.
struct SeamPoint {
    base::Vec3d position;
    base::Vec3d risesA, risesB; ///< unit
    /// Unit, along the curve.
    base::Vec3d tangent() const { return normalized(cross(risesA, risesB)); }
};

/// Two functions whose common zeros make the curve: values with unit gradients; not `near` where they are not known.
struct TwoSides {
    std::function<SideValue(const base::Vec3d&)> a, b;
};

/// The common zero nearest to x, by Newton's steps until one is shorter than `tolerance`; nothing where there is none,
/// or both cross at less than 6 degrees.
std::optional<SeamPoint> seamPoint(const TwoSides& sides, const base::Vec3d& x, double tolerance);

/// Of the spacing: how exact places of seams are.
constexpr double seamTolerance = 1e-4;

struct SeamCurve {
    std::vector<SeamPoint> points;
    std::vector<std::size_t> corners; ///< which of the points lie on an edge of one of both surfaces
    bool closed = false;

    double length() const;
    /// Pieces between corners and ends.
    std::size_t pieces() const { return corners.empty() ? 1 : closed ? corners.size() : corners.size() + 1; }
};

/// Somewhere near a seam, and how far from each other surfels are there.
struct SeamSeed {
    base::Vec3d position;
    double spacing = 0;
};

/// Every curve that passes by one of the seeds, in steps of half a spacing at most; in their order. Throws
/// base::Cancelled by the scope.
std::vector<SeamCurve> traceSeams(const TwoSides& sides, const std::vector<SeamSeed>& seeds);

} // namespace solid
