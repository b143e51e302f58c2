// Weighted averages over the surfels of the frozen surface: what a surfel that moved or was born takes over from those
// around it. Internal to resample.
//
//     height    sum theta off / w    off_j = f_c(p_j) / |g|, clamped: how far frozen samples stand off their surface
//     tilt      sum theta dn / w     dn_j = n_j - g_j: how their normals differ from its gradient
//     colour, mask, real attributes  theta-weighted
//     integer attributes             of the surfel with the largest weight
//
// Only surfels that face as asked count. Heights and tilts are measured where they are needed and nowhere else
// (process/README 4.1, step 6): all places are named at the beginning.
#pragma once

#include "core/process/resampling/resample_set.h"
#include "core/surface/evaluation/together.h"

#include <atomic>
#include <optional>

namespace process {

struct Blend {
    float height = 0;
    base::Vec3f tilt;
    surfel::Colour colour = surfel::white;
    float mask = 0;
    float support = 0;                ///< 0 where nothing faces alike
    float ofRims = 0;                 ///< the share of those that face alike and tell of a rim, by weight
    std::vector<std::uint32_t> words; ///< further attributes
};

class Blender {
  public:
    /// Measures what averages at `places` will need, in parallel.
    Blender(const surface::Surface& frozen, float spacing, std::span<const base::Vec3f> places);

    /// The blocks around some places, kept from one to the next.
    struct Near {
        base::Box3f box;                                                        ///< of places that they serve
        std::vector<std::pair<const surfel::SurfelBlock*, std::size_t>> blocks; ///< in tree order; which one it is
    };
    /// One thread per `near`. REQUIRES: x is one of the places. `gradient`: unit gradient there.
    void at(const base::Vec3f& x, const base::Vec3f& gradient, Near& near, Blend& out) const;

  private:
    struct Measured {
        float height = 0;
        base::Vec3f tilt, gradient;
    };
    void collectBlocks(std::span<const base::Vec3f> places);
    void lookAround(const base::Vec3f& x, Near& near) const;
    void markNeeded(const base::Vec3f& x, Near& near);
    void measure();
    /// fn(block, slot, index into m_measured, weight) for the surfels with weight at x.
    template <class Fn>
    void forWeights(const base::Vec3f& x, Near& near, const Fn& fn) const;
    Measured measured(const surface::TogetherAt& e, const base::Vec3f& normal) const;

    const surface::Surface& m_frozen;
    const surfel::AttributeLayout& m_layout;
    Facing m_facing;
    std::optional<int> m_rims;                        ///< channel that tells of them, where the model knows its rims
    float m_limit;                                    ///< of heights
    float m_slack;                                    ///< how far around a place blocks are collected
    std::vector<const surfel::SurfelBlock*> m_blocks; ///< by address, for finding
    std::vector<std::atomic<std::uint8_t>> m_needed;  ///< 128 per block
    std::vector<Measured> m_measured;
};

} // namespace process
