// The oriented discs of a model along a ray, found front to back through the boxes of the tree.
//
// Disc i lies about p_i across n_i with radius surfaceReach * h_i. Together they cover the surface wherever it has
// normals; smaller ones lose hits (surface/README 4.2). The surface is near the nearest of them, not on it: what comes
// out is where to begin, and what makes that beginning doubtful.
//
// The walk and the discs of a cluster run in vectors chosen at run time, 16 virtual lanes with explicit multiply-adds:
// AVX2 and AVX-512 give the same bits, the portable fallback may differ. Each ray is walked by itself, whatever else is
// in the batch. Read only; any number of threads. Internal to the room.
#pragma once

#include "core/tree/surfel_tree.h"

#include <optional>

namespace surface {

struct DiscHit {
    static constexpr float none = std::numeric_limits<float>::infinity();

    float nearest = none; ///< t of the first crossing
    float guess = none;   ///< where the surface itself is expected: crossings of the discs about it, blended
    float cosine = 0;     ///< n.d of the first disc crossed
    float support = 0;    ///< its h
    /// Where a disc is first passed closely without a crossing, before the nearest crossing.
    float brushFirst = none;
    float brushLast = -none; ///< where last, if none is crossed
    float brushSupport = 0;  ///< the largest h of discs passed so
    /// First crossing of a disc that faces against the ray, looked for closely behind a nearest one that faces along.
    float facing = none;

    bool crossed() const { return nearest < none; }
    bool brushed() const { return brushFirst < none; }
    bool doubtful() const { return !crossed() || brushed() || (cosine > 0 && facing < none); }
    float first() const { return std::min(nearest, brushFirst); }
    float last() const { return crossed() ? nearest : brushLast; }
    float reach() const { return crossed() ? support : brushSupport; }
};

/// Where on a ray to look, and the largest support of the model.
struct DiscRange {
    float tMin, tMax, maxSupport;
};

/// The discs first met in `range`, for every ray. Neighbouring rays share what they read; of scattered ones
/// several are under way at once. REQUIRES: normals, unit directions, tMin >= 0, rays.size() == out.size().
void nearestDiscs(const tree::SurfelTree& tree, std::span<const base::Rayf> rays, const DiscRange& range,
                  std::span<DiscHit> out);

/// From where to where, at most, the ray runs within surfaceReach * h of the surfels of a cluster.
std::optional<std::pair<float, float>> reachChord(const float* cluster, const base::Rayf& ray);

} // namespace surface
