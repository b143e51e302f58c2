// The fit against erosion (process/README 4.10): samples that moved, are new or have other supports are raised and
// tilted until the surface that they define is the frozen one again. Internal to resample.
//
//     d(x) = f / |g|, u(x) = g / |g|:    p_i += u_F (d - d_F)(x_i),    n_i += (u_F - u)(x_i),    x_i where p_i began
//
// One round wants one evaluation at each sample of the surface that they make now, by whatever definition. What has
// the frozen surface beside it already keeps every bit. The same bits at any thread count.
#pragma once

#include "core/surface/surface.h"
#include "core/tree/selection.h"

#include <functional>

namespace process {

class SampleFit {
  public:
    struct Sample {
        base::Vec3f position, normal;
        float spacing = 0; ///< of its surroundings: the unit of limits
    };
    /// `pinned`: off-centre values in h beyond which a sample belongs to an open border and stays.
    SampleFit(const surface::Surface& frozen, std::vector<Sample> samples, float pinned);

    /// One round; `now` is what the samples make as they are. False: none has changed.
    bool improve(const surface::Surface& now);
    const base::Vec3f& position(std::size_t i) const { return m_samples[i].position; }
    const base::Vec3f& normal(std::size_t i) const { return m_samples[i].normal; }
    /// By the last round.
    bool changed(std::size_t i) const { return m_changed[i] != 0; }

  private:
    /// What the frozen surface is where a sample began.
    struct Start {
        base::Vec3f place, normal;
        base::Vec3f gradient; ///< unit, on the normal's side; zero: not told, the sample stays
        float distance = 0;
    };
    std::vector<Start> m_start;
    std::vector<Sample> m_samples;
    std::vector<std::uint8_t> m_changed;
};

struct FitOptions {
    std::function<float(const base::Vec3f&)> spacingAt; ///< by place; from many threads
    float pinned;                                       ///< as above
    int rounds;
};

/// How these surfels of a version change, but for fully masked ones, so that it makes the frozen surface; those that
/// have it keep every bit. Throws base::Cancelled.
tree::Edit fit(const tree::SurfelTree& tree, tree::Selection which, const surface::Surface& frozen,
               const FitOptions& options);

/// All surfels of a version, in three rounds, but for fully masked ones, fitted to a frozen surface; those that have it
/// keep every bit. `spacingAt`: by place; from many threads. Throws base::Cancelled.
tree::SurfelTree fitted(const tree::SurfelTree& tree, const surface::Surface& frozen,
                        const std::function<float(const base::Vec3f&)>& spacingAt);

} // namespace process
