// Ray and surface (alg. 3.2): exact first hit by plane iteration inside the surface bounds, with marching as fallback.
//
// The clusters' surface bounds are visited front to back; in each merged interval the iteration intersects the ray with
// the plane at the current point until it stands still. Near silhouettes, and wherever the iteration leaves its
// interval or a root might lie before the one it found, the interval is marched with the sign of the frame transported
// along. A root counts where the frame is valid, o <= limit and the slope n.g is at least `minSlope`.
#pragma once

#include "core/surface/surface.h"

namespace surface {

/// Which zeros of f are surface: the mesher and the ray caster use the same constant (RULES-4 B2).
constexpr double minSlope = 0.3;

template <class T>
struct RayHit {
    bool hit = false;
    T t = 0; ///< distance along the unit direction
    base::Vec3<T> position;
    base::Vec3<T> normal;  ///< unit gradient, facing against the ray
    base::Vec3<T> outward; ///< unit gradient with the frame's own sign
    T unit = 0;            ///< h at the hit
    T agreement = 0;
    int evaluations = 0; ///< of f, spent on this ray
};

struct IntersectOptions {
    float tMin = 0; ///< hits closer than this are passed over
    float tMax = std::numeric_limits<float>::infinity();
    bool robust = false; ///< march always, never trust the iteration
};

RayHit<float> intersect(const Surface& surface, const base::Rayf& ray, const IntersectOptions& options = {});
RayHit<double> intersectReference(const Surface& surface, const base::Rayd& ray, const IntersectOptions& options = {});
/// Many rays in parallel; the same bits as one by one.
void intersect(const Surface& surface, std::span<const base::Rayf> rays, const IntersectOptions& options,
               std::span<RayHit<float>> out);

} // namespace surface
