// Rays and the surface (surface/README 4): the first hit, all hits along the ray, or whether there is any.
//
// Two policies. `fast` finds the nearest oriented disc along the ray (disc_kernel.h), iterates planes from there to the
// root, and marches around whatever makes that beginning doubtful: grazing rays, near sheets, boundaries, failing
// frames. `robust` marches through all surface bounds, front to back, with the sign of the frame transported along the
// ray. Surfels without oriented normals have no discs to trust: their bounds are walked by either policy, with planes
// and sphere tracing in the fast one.
//
//     intersect.h     what callers see            ray_policy.h         fast and robust, first, any and all
//     ray_probe.h     f along one ray             surface_intervals.h  where on the ray surface may be
//     ray_roots.h     from near a root to it      ray_march.h          the first root in an interval
//     ray_accept.h    which roots are surface     disc_kernel.h        nearest disc
//
// A root counts where the frame is valid, o <= limit (and `maxOffCentre`, where there is no limit) and the slope n.g is
// at least `minSlope`. Curves have no hits. Everything is const and may run on any thread; a ray gives the same bits
// alone and in any batch.
#pragma once

#include "core/surface/surface.h"

namespace surface {

/// Which zeros of f are surface: the mesher and the ray caster use the same constant (surface/README 4.4).
constexpr double minSlope = 0.3;
/// In units of h, also of surfaces without a boundary limit: where all surfels in support lie to one side so much, f
/// vanishes between near sheets and beside sharp parts without anything being there (surface/README 4.4). Holes of
/// radius up to 0.75 h stay closed.
constexpr double maxOffCentre = 0.5;

/// Is the frame valid there, o within the limit, and f steep enough along its own normal (surface/README 4.4)? Of a
/// zero of f, evaluated with its gradient.
template <class T>
bool isSurface(const Evaluation<T>& at) {
    return at.ok() && dot(at.normal, at.gradient) >= static_cast<T>(minSlope) &&
           at.offCentre <= static_cast<T>(maxOffCentre) * at.unit;
}

template <class T>
struct RayHit {
    bool hit = false;
    T t = 0; ///< distance along the unit direction
    base::Vec3<T> position;
    base::Vec3<T> normal;  ///< unit gradient, facing against the ray
    base::Vec3<T> outward; ///< unit gradient with the frame's own sign
    T unit = 0;            ///< h at the hit
    T agreement = 0;
    int evaluations = 0; ///< of f, spent on this ray (of all hits: since the hit before)
};

RayHit<float> rounded(const RayHit<double>& hit);

struct IntersectOptions {
    float tMin = 0; ///< hits closer than this are passed over
    float tMax = std::numeric_limits<float>::infinity();
    bool robust = false; ///< march always, never trust discs or planes
    /// How far from the root a hit may be, in units of h; 0: as close as the precision allows. 1e-3 is for pictures.
    double tolerance = 0;
};

/// Of the spacing: roots this close behind the start of a secondary ray, or behind another root, are that same place.
constexpr double secondaryEpsilon = 1e-3;

RayHit<float> intersect(const Surface& surface, const base::Rayf& ray, const IntersectOptions& options = {});
RayHit<double> intersectReference(const Surface& surface, const base::Rayd& ray, const IntersectOptions& options = {});
/// Many rays in parallel, best when neighbours in the list are neighbours in space.
void intersect(const Surface& surface, std::span<const base::Rayf> rays, const IntersectOptions& options,
               std::span<RayHit<float>> out);

/// All hits in [tMin, tMax], nearest first.
std::vector<RayHit<float>> intersectAll(const Surface& surface, const base::Rayf& ray,
                                        const IntersectOptions& options = {});
std::vector<RayHit<double>> intersectAllReference(const Surface& surface, const base::Rayd& ray,
                                                  const IntersectOptions& options = {});
void intersectAll(const Surface& surface, std::span<const base::Rayf> rays, const IntersectOptions& options,
                  std::span<std::vector<RayHit<float>>> out);

/// Does the ray meet the surface? For shadows: the place of the hit is not refined, and a start on the surface is no
/// hit, nor is what lies within `secondaryEpsilon` of it.
bool intersectAny(const Surface& surface, const base::Rayf& ray, const IntersectOptions& options = {});
bool intersectAnyReference(const Surface& surface, const base::Rayd& ray, const IntersectOptions& options = {});
/// 1 for rays that hit, 0 for others.
void intersectAny(const Surface& surface, std::span<const base::Rayf> rays, const IntersectOptions& options,
                  std::span<std::uint8_t> out);

} // namespace surface
