// Rays and complexes: of every patch the zeros of f along the ray that are not past its boundary.
//
// The ray is walked where the tree says that the patch may be, by half of |f| at a time and at least a 28th of h; where
// the sign changes, regula falsi finds the root.
#pragma once

#include "core/complexes/complex.h"
#include "core/surface/rays/intersect.h"

#include <span>

namespace complexes {

struct ComplexHit {
    surface::RayHit<double> hit;
    std::uint32_t cell = 0; ///< the patch
};

/// Nearest first. Only `tMin` and `tMax` of the options matter.
std::vector<ComplexHit> intersectAll(const Complex& complex, const base::Rayd& ray,
                                     const surface::IntersectOptions& options = {});

surface::RayHit<double> intersectReference(const Complex& complex, const base::Rayd& ray,
                                           const surface::IntersectOptions& options = {});
std::vector<surface::RayHit<double>> intersectAllReference(const Complex& complex, const base::Rayd& ray,
                                                           const surface::IntersectOptions& options = {});
bool intersectAnyReference(const Complex& complex, const base::Rayd& ray,
                           const surface::IntersectOptions& options = {});

/// Many rays, in parallel; float only in what goes in and comes out.
void intersect(const Complex& complex, std::span<const base::Rayf> rays, const surface::IntersectOptions& options,
               std::span<surface::RayHit<float>> out);
void intersectAll(const Complex& complex, std::span<const base::Rayf> rays, const surface::IntersectOptions& options,
                  std::span<std::vector<surface::RayHit<float>>> out);
void intersectAny(const Complex& complex, std::span<const base::Rayf> rays, const surface::IntersectOptions& options,
                  std::span<std::uint8_t> out);

} // namespace complexes
