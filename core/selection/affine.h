// Affine maps with numbers, and surfels moved by them exactly (selection/README 8).
//
//     x' = x + w (A x + t - x)      F = I + w (A - I) + (A x + t - x) grad w^T      n' = +- cof(F) n / |cof(F) n|
//
// w is the selection; grad w counts where it is neither 0 nor 1, so that what is selected whole moves as one piece. The
// sign is that of det F: mirrored solids keep their outsides. Supports follow the area, h' = h sqrt |cof(F) n|.
// Coordinates are stored ones. Float64 inside, rounded once.
#pragma once

#include "core/base/mat3.h"
#include "core/base/plane.h"
#include "core/selection/parts.h"

namespace selection {

struct Affine {
    base::Mat3d linear = base::Mat3d::identity();
    base::Vec3d shift;

    bool isNothing() const;
    base::Vec3d operator()(const base::Vec3d& x) const { return linear * x + shift; }
    /// This map after `first`.
    Affine after(const Affine& first) const { return {linear * first.linear, linear * first.shift + shift}; }
    /// The same about another point than zero: that point stays if it would stay at zero.
    Affine about(const base::Vec3d& centre) const { return {linear, shift + centre - linear * centre}; }

    static Affine moving(const base::Vec3d& by) { return {base::Mat3d::identity(), by}; }
    static Affine stretching(const base::Vec3d& by);
    /// About an axis through zero, right-handed. REQUIRES: |axis| > 0.
    static Affine turning(const base::Vec3d& axis, double angleRad);
    static Affine mirroring(const base::Plane& plane);
};

/// The same version where the map does nothing. Throws base::Error where it is singular, or takes surfels so far from
/// the model's origin that float32 would no longer tell neighbours apart.
surface::Surface transformed(const surface::Surface& surface, const Affine& map, Limit limit);

/// A copy of what is selected, moved; the copy is selected in its place. Throws as `transformed`, and where the copy
/// would lie upon what it is one of.
surface::Surface duplicated(const surface::Surface& surface, const Affine& map);

/// Of what is selected, or of everything; empty where nothing is.
base::Box3f boxUnder(const tree::SurfelTree& tree, Limit limit);

} // namespace selection
