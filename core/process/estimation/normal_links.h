// What neighbours' normals say of each other's signs (process/README 2.2): the edges that spanning trees, and
// judgements of an orientation, are made of.
#pragma once

#include "core/process/estimation/knn.h"

namespace process {

struct NormalEdge {
    std::uint32_t a, b;
};

/// Classes of unlikeness: as fine as float normals of a scan mean anything, and sorted in one pass.
inline constexpr std::size_t unlikeClasses = 1 << 14;

struct Likeness {
    bool flip;            ///< one of the two has to be turned
    std::uint16_t unlike; ///< 0 certain to unlikeClasses - 1
};

/// Compares the normal at b with the one that a circular arc from a to b would carry there, the normal at a mirrored in
/// the plane halfway: exact on spheres and cylinders, and right across sharp edges, where n_a . n_b is 0. An edge along
/// the normals joins two layers or two sides of something thin, and nobody can tell which: it comes last.
Likeness likeness(const base::Vec3f& a, const base::Vec3f& na, const base::Vec3f& b, const base::Vec3f& nb);

struct NormalLinks {
    std::vector<NormalEdge> edges; ///< every pair of neighbours once
    std::vector<Likeness> likenesses;
    std::vector<std::uint32_t> order; ///< of edges, the most certain first; ties in the order of edges
};

/// In parallel, the same at any thread count. REQUIRES: two positions, unit normals.
NormalLinks normalLinks(const Cloud& cloud, std::span<const base::Vec3f> normals, int neighbours,
                        const base::Progress& progress);

} // namespace process
