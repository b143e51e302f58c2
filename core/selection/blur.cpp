#include "core/selection/blur.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/selection/links.h"
#include "core/surface/curvature.h"
#include "core/surface/evaluation/weights.h"

#include <algorithm>

namespace selection {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// Mean squared distance under the kernel in the plane, over the radius squared: 14 / 100.8.
constexpr double secondMoment = 5.0 / 36;

class Around {
  public:
    Around(const surface::Surface& surface, double radius)
        : m_tree(surface.tree()), m_links(surface), m_oriented(m_tree.layout()->oriented),
          m_radius(static_cast<float>(radius)) {}

    float radiusAt(const SurfelBlock& block, int slot) const {
        return std::max(m_radius, m_links.lengthAt(block.support(slot)));
    }
    /// That of no surfel of the block is greater.
    float mostRadius(const SurfelBlock& block) const {
        return std::max(m_radius, m_links.lengthAt(block.maxSupport()));
    }

    /// fn(block, slot, weight) for the surfels about one, itself among them.
    template <class Fn>
    void forEach(const SurfelBlock& block, int slot, const Fn& fn) const {
        const Vec3f p = block.position(slot), n = block.normal(slot);
        const float radius = radiusAt(block, slot);
        m_tree.forBlocksInBall(p, radius, [&](std::uint32_t, const SurfelBlock& other) {
            for (unsigned in = other.boundsLanes().within(p, radius * radius) & other.clusterMask(); in; in &= in - 1) {
                const int first = std::countr_zero(in) * surfel::clusterSize;
                const int end = std::min(other.size(), first + surfel::clusterSize);
                for (int k = first; k < end; ++k) {
                    const float l = distance(other.position(k), p) / radius;
                    if (l >= 1 || (m_oriented && !(dot(n, other.normal(k)) > 0) && (&other != &block || k != slot)))
                        continue;
                    const float h = other.support(k);
                    fn(other, k, static_cast<double>(surface::wendlandC2(l)) * static_cast<double>(h) * h);
                }
            }
        });
    }

  private:
    tree::SurfelTree m_tree;
    Links m_links;
    bool m_oriented;
    float m_radius;
};

/// Blocks near which the field varies: in all others means are what they are means of.
std::vector<std::uint32_t> varying(const tree::SurfelTree& tree, const Around& around, int channel) {
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    std::vector<float> least(blocks.size(), 2), most(blocks.size(), -1);
    base::parallelFor(blocks.size(), 64, [&](std::size_t b) {
        for (int slot = 0; slot < blocks[b]->size(); ++slot) {
            const float v = valueAt(*blocks[b], channel, slot);
            least[b] = std::min(least[b], v), most[b] = std::max(most[b], v);
        }
    });
    std::vector<std::uint8_t> varies(blocks.size());
    base::parallelFor(blocks.size(), 16, [&](std::size_t b) {
        const base::Box3f near = blocks[b]->box().inflated(around.mostRadius(*blocks[b]));
        tree.forBlocksInSupport(near, [&](std::uint32_t other, const SurfelBlock&) {
            varies[b] |= least[other] != least[b] || most[other] != least[b] ? 1 : 0;
        });
    });
    std::vector<std::uint32_t> out;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (varies[b])
            out.push_back(static_cast<std::uint32_t>(b));
    return out;
}

/// v + step (mean - v), within 0 and 1.
tree::SurfelTree mixedWithMean(const surface::Surface& surface, Field field, double radius, double step,
                               const base::Progress& progress) {
    const tree::SurfelTree& tree = surface.tree();
    const int channel = channelOf(*tree.layout(), field);
    if (channel < 0)
        return tree;
    progress.step(0, "Averaging");
    const Around around(surface, radius);
    return rewritten(
        tree, field, varying(tree, around, channel),
        [&](std::uint32_t, const SurfelBlock& block, BlockValues& values) {
            for (int slot = 0; slot < block.size(); ++slot) {
                const double own = static_cast<double>(valueAt(block, channel, slot));
                double sum = 0, weights = 0; // of differences, so that what does not vary keeps its bits
                around.forEach(block, slot, [&](const SurfelBlock& other, int k, double weight) {
                    sum += weight * (static_cast<double>(valueAt(other, channel, k)) - own);
                    weights += weight;
                });
                values[static_cast<std::size_t>(slot)] =
                    static_cast<float>(std::clamp(own + step * (sum / weights), 0.0, 1.0));
            }
        },
        1);
}

} // namespace

tree::SurfelTree blurred(const surface::Surface& surface, Field field, double radius, const base::Progress& progress) {
    return mixedWithMean(surface, field, radius, 1, progress);
}

tree::SurfelTree sharpened(const surface::Surface& surface, Field field, double radius, double amount,
                           const base::Progress& progress) {
    return mixedWithMean(surface, field, radius, -amount, progress);
}

tree::SurfelTree fromCavity(const surface::Surface& surface, Field field, double radius, double strength,
                            const base::Progress& progress) {
    if (!surface.tree().layout()->oriented)
        throw base::Error("the normals have no sides, which tell hollows from ridges", {}, "orient them first");
    progress.step(0, "Looking for hollows");
    const Around around(surface, radius);
    return rewritten(
        surface.tree(), field,
        [&](std::uint32_t, const SurfelBlock& block, BlockValues& values) {
            for (int slot = 0; slot < block.size(); ++slot) {
                const Vec3f p = block.position(slot);
                base::Vec3d sum;
                double weights = 0;
                around.forEach(block, slot, [&](const SurfelBlock& other, int k, double weight) {
                    sum += base::cast<double>(other.position(k) - p) * weight;
                    weights += weight;
                });
                // A paraboloid of mean curvature H stands H secondMoment r^2 / 2 off its tangent plane, in the mean.
                const double height = dot(sum, base::cast<double>(block.normal(slot))) / weights;
                const auto r = static_cast<double>(around.radiusAt(block, slot));
                const double curvature = 2 * height / (secondMoment * r * r);
                values[static_cast<std::size_t>(slot)] =
                    static_cast<float>(std::clamp(strength * curvature * r, 0.0, 1.0));
            }
        },
        1);
}

tree::SurfelTree fromCurvature(const surface::Surface& surface, Field field, double low, double high,
                               const base::Progress& progress) {
    progress.step(0, "Measuring curvature");
    return rewritten(
        surface.tree(), field,
        [&](std::uint32_t, const SurfelBlock& block, BlockValues& values) {
            std::array<Vec3f, surfel::blockCapacity> x;
            std::array<surface::Curvature, surfel::blockCapacity> at;
            const auto n = static_cast<std::size_t>(block.size());
            for (std::size_t i = 0; i < n; ++i)
                x[i] = block.position(static_cast<int>(i));
            surface::curvature(surface, std::span(x).first(n), std::span(at).first(n));
            for (std::size_t i = 0; i < n; ++i) {
                const double k = at[i].ok() ? std::max(std::abs(at[i].k1), std::abs(at[i].k2)) : 0;
                values[i] = static_cast<float>(std::clamp((k - low) / (high - low), 0.0, 1.0));
            }
        },
        1);
}

} // namespace selection
