#include "core/reduce/places.h"

#include "core/base/parallel.h"
#include "core/surface/projection/project.h"

#include <numbers>

namespace reduce {

/// Of the largest: places may coincide.
constexpr float leastArea = 1e-6f;
/// Feet that are looked for at once: an answer holds some 300 bytes.
constexpr std::size_t slab = 1 << 14;
constexpr std::size_t ring = 12;
/// Of the squared reach of a sample: pi h^2 / 4, some nine times what it stands for at the default support. What stands
/// alone would else stand for all that is empty around it.
constexpr float largestArea = std::numbers::pi_v<float> / (4 * farthestFoot * farthestFoot);

static bool isFoot(const surface::Projection<float>& p, const base::Vec3f& from, float reach) {
    return p.ok() && distanceSq(p.foot, from) < reach * reach && lengthSq(p.at.gradient) > 0.0025f;
}

void appendFeet(const surface::Surface& surface, std::span<const base::Vec3f> from, std::span<const base::Vec3f> side,
                std::span<const float> reach, Places& places, std::vector<std::uint8_t>* kept) {
    std::vector<surface::Projection<float>> feet(std::min(slab, from.size()));
    for (std::size_t begin = 0; begin < from.size(); begin += slab) {
        const std::size_t n = std::min(slab, from.size() - begin);
        surface::project(surface, from.subspan(begin, n), {}, std::span(feet).first(n));
        for (std::size_t k = 0; k < n; ++k) {
            bool good = isFoot(feet[k], from[begin + k], reach[begin + k]);
            base::Vec3f normal = good ? normalized(feet[k].at.gradient) : base::Vec3f{};
            if (good && dot(normal, side[begin + k]) < 0) {
                good = !places.oriented; // the other side of something thin is not this sample's
                normal = -normal;
            }
            if (kept)
                kept->push_back(good);
            if (!good)
                continue;
            places.position.push_back(feet[k].foot);
            places.normal.push_back(normal);
            places.area.push_back(largestArea * reach[begin + k] * reach[begin + k]);
        }
    }
}

namespace {

/// Surfels of some blocks, as a list of where to look.
struct Asked {
    std::vector<base::Vec3f> position, normal;
    std::vector<float> reach;

    void clear() { position.clear(), normal.clear(), reach.clear(); }
    void add(const surfel::SurfelBlock& block, int slot) {
        position.push_back(block.position(slot));
        normal.push_back(block.normal(slot));
        reach.push_back(farthestFoot * block.support(slot));
    }
};

/// Collects the feet of one slab after the other.
class Gatherer {
  public:
    Gatherer(Dense& dense, std::size_t stride, const base::Progress& progress)
        : m_dense(dense), m_stride(stride), m_progress(progress), m_total(dense.surface.tree().size()) {
        m_feet.oriented = dense.places.oriented;
    }
    void add(const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            m_asked.add(block, slot);
        if (m_asked.position.size() >= slab)
            flush();
    }
    void flush() {
        m_feet.position.clear(), m_feet.normal.clear(), m_feet.area.clear();
        const std::size_t first = m_dense.footed.size();
        appendFeet(m_dense.surface, m_asked.position, m_asked.normal, m_asked.reach, m_feet, &m_dense.footed);
        for (std::size_t k = 0, foot = 0; k < m_asked.position.size(); ++k) {
            if (!m_dense.footed[first + k])
                continue;
            m_sum += double(distanceSq(m_asked.position[k], m_feet.position[foot]));
            if (m_dense.feet++ % m_stride == 0) {
                m_dense.places.position.push_back(m_feet.position[foot]);
                m_dense.places.normal.push_back(m_feet.normal[foot]);
                m_dense.places.area.push_back(m_feet.area[foot] * static_cast<float>(m_stride));
            }
            ++foot;
        }
        m_asked.clear();
        m_progress.step(double(m_dense.footed.size()) / double(m_total), "Measuring the surface");
    }
    double sum() const { return m_sum; }

  private:
    Dense& m_dense;
    std::size_t m_stride;
    const base::Progress& m_progress;
    std::size_t m_total;
    Asked m_asked;
    Places m_feet;
    double m_sum = 0;
};

} // namespace

Dense denseOf(const surface::Surface& surface, std::size_t stride, const base::Progress& progress) {
    Dense out;
    out.surface = surface;
    out.places.oriented = surface.tree().layout()->normals && surface.tree().layout()->oriented;
    out.footed.reserve(surface.tree().size());
    out.places.position.reserve(surface.tree().size() / stride + 1);
    out.places.normal.reserve(surface.tree().size() / stride + 1);
    out.places.area.reserve(surface.tree().size() / stride + 1);
    Gatherer gatherer(out, stride, progress);
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { gatherer.add(block); });
    gatherer.flush();
    out.rms = out.feet > 0 ? std::sqrt(gatherer.sum() / double(out.feet)) : 0;
    return out;
}

/// The squared distance to the `ring`-th neighbour of the same sheet, and which one it is where there are fewer.
static std::pair<float, std::size_t> ringOf(const Places& places, const NumberedTree& tree, std::size_t i,
                                            std::vector<tree::Neighbour>& near) {
    std::pair<float, std::size_t> out{0, 0};
    for (const std::size_t asked : {ring + 1, 3 * ring}) {
        out = {0, 0};
        tree.tree().nearest(places.position[i], asked, near);
        for (const tree::Neighbour& n : near)
            if (const std::uint32_t j = NumberedTree::number(n);
                j != i && out.second < ring && places.facing(places.normal[i], places.normal[j], 0))
                out = {n.distanceSq, out.second + 1};
        if (out.second == ring)
            break;
    }
    return out;
}

void measureAreas(Places& places, const NumberedTree& tree) {
    base::parallelChunks(places.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<tree::Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
            const auto [distanceSq, which] = ringOf(places, tree, i, near);
            const float area = std::numbers::pi_v<float> * distanceSq / (static_cast<float>(which) + 0.5f);
            places.area[i] = std::max(std::min(places.area[i], area), leastArea * places.area[i]);
        }
    });
}

} // namespace reduce
