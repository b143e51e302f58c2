#include "core/cells/measured_labels.h"

#include "core/base/parallel.h"
#include "core/cells/crease_labels.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cells {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

constexpr float reach = 4.5f;        ///< spacings: how far off a patch may be that ends another one
constexpr float aboutNearest = 1.2f; ///< spacings: surfels so much farther than the nearest tell of the patch's plane
constexpr float leastSine = 0.14f;   ///< 8 degrees: flatter than that nobody can measure where a patch ends
constexpr float flatReach = 2.5f;    ///< spacings: so near the patch across still is where there is no edge
constexpr float leastTurn = 0.035f;  ///< 2 degrees: which way flatter ones turn makes no difference

constexpr float beyondEdge = 1.25f; ///< spacings: about so far beyond its edge a face has no surfels

struct Near {
    Vec3f position, normal;
    Label label;
};

class LabelMeter {
  public:
    LabelMeter(const surface::Surface& surface, const LabelLayout& labels, Partners partners)
        : m_surface(surface), m_labels(labels), m_kept(partners == Partners::Kept),
          m_spacing(static_cast<float>(surface::spacingOfUnit) * surface.supportScale()) {}

    /// The block with its labels as they are now; null where they stay. `asked` tells which surfels are meant.
    template <class Asked>
    surfel::MutableBlockPtr measured(const SurfelBlock& block, const Asked& asked) {
        surfel::MutableBlockPtr out;
        m_near.clear();
        const surfel::AttributeLayout& layout = *m_surface.tree().layout();
        for (int slot = 0; slot < block.size(); ++slot) {
            if (!asked(block.position(slot)))
                continue;
            if (m_near.empty())
                gather(block);
            const Label before = m_labels.at(block, slot), now = labelOf(block, slot, before);
            if (now == before)
                continue;
            if (!out)
                out = block.clone();
            std::vector<std::uint32_t> words(block.extraWords());
            block.extra(slot, words);
            surfel::write(*layout.find("partner"), words, now.partner);
            surfel::write(*layout.find("sign"), words, static_cast<std::uint32_t>(now.meeting));
            out->setExtra(slot, words);
        }
        if (out)
            out->seal();
        return out;
    }

  private:
    void gather(const SurfelBlock& block) {
        const base::Box3f box = block.box().inflated(reach * m_spacing * block.maxSupport());
        m_surface.tree().forBlocksInSupport(
            box,
            [&](std::uint32_t, const SurfelBlock& each) {
                for (int slot = 0; slot < each.size(); ++slot)
                    if (box.contains(each.position(slot)))
                        m_near.push_back({each.position(slot), each.normal(slot), m_labels.at(each, slot)});
            },
            m_surface.supportScale());
    }

    Label labelOf(const SurfelBlock& block, int slot, const Label& before) const {
        const Vec3f p = block.position(slot), n = block.normal(slot);
        const float s = m_spacing * block.support(slot);
        if (m_kept && before.meeting == Meeting::None)
            return before;
        // cells that this one is known to meet hereabouts, with how far off they are
        std::map<std::uint32_t, float> others;
        for (const Near& each : m_near) {
            const bool meets = each.label.meeting != Meeting::None &&
                               (each.label.cell == before.cell || each.label.partner == before.cell);
            if (meets && distanceSq(each.position, p) < reach * reach * s * s)
                others.emplace(each.label.cell == before.cell ? each.label.partner : each.label.cell,
                               std::numeric_limits<float>::infinity());
        }
        if (m_kept)
            std::erase_if(others, [&](const auto& other) { return other.first != before.partner; });
        for (const Near& each : m_near)
            if (const auto other = others.find(each.label.cell); other != others.end())
                other->second = std::min(other->second, distanceSq(each.position, p));
        Label out = before;
        out.partner = before.cell;
        out.meeting = Meeting::None;
        float nearest = (m_kept ? reach : static_cast<float>(partnerReach)) * s;
        bool flat = false; // is the crease still there, without an edge?
        Meeting turns = before.meeting;
        for (const auto& [cell, farSq] : others) {
            if (!(farSq < reach * reach * s * s))
                continue;
            const float within = std::sqrt(farSq) + aboutNearest * s;
            Vec3f normal, way;
            float total = 0;
            for (const Near& each : m_near) {
                const float part = distanceSq(each.position, p) / (within * within);
                if (each.label.cell != cell || !(part < 1))
                    continue;
                const float weight = (1 - part) * (1 - part);
                normal += each.normal * weight, way += (each.position - p) * weight, total += weight;
            }
            normal = normalized(normal), way = way / std::max(total, 1e-30f);
            const float sine = length(normal - n * dot(n, normal));
            if (!(sine > leastSine)) {
                if (cell == before.partner && dot(n, normal) > 0 && farSq < flatReach * flatReach * s * s) {
                    flat = true;
                    if (before.meeting != Meeting::None && sine > leastTurn)
                        turns = meetingWith(before.cell, p + way, normal, s);
                }
                continue;
            }
            const float distance = std::abs(dot(way, normal)) / sine;
            if (!(distance < nearest) ||
                (!m_kept && goesOnBeyond(before.cell, p, n, normal, dot(way, normal) / sine, s)))
                continue;
            nearest = distance;
            out.partner = cell;
            out.meeting = meetingWith(before.cell, p + way, normal, s);
        }
        if ((flat || m_kept) && out.meeting == Meeting::None) {
            out = before;
            out.meeting = turns;
        }
        return out;
    }

    /// Has the cell surfels beyond the plane of another one, `far` off along its own? Then it does not end there: it is
    /// one wall of what is thin, and that the other one.
    bool goesOnBeyond(std::uint32_t own, const Vec3f& p, const Vec3f& n, const Vec3f& normal, float far,
                      float s) const {
        const Vec3f along = normalized(normal - n * dot(n, normal));
        const Vec3f beyond = p + along * (far + (far < 0 ? -beyondEdge : beyondEdge) * s);
        return std::any_of(m_near.begin(), m_near.end(), [&](const Near& each) {
            return each.label.cell == own && distanceSq(each.position, beyond) < s * s && dot(each.normal, n) > 0.5f;
        });
    }

    /// How a cell meets a patch around a place, as its surfels nearest to that tell: where faces bend towards an edge,
    /// those farther off tell another angle.
    Meeting meetingWith(std::uint32_t own, const Vec3f& place, const Vec3f& normal, float s) const {
        float farSq = std::numeric_limits<float>::infinity();
        for (const Near& each : m_near)
            if (each.label.cell == own)
                farSq = std::min(farSq, distanceSq(each.position, place));
        const float within = std::sqrt(farSq) + aboutNearest * s;
        Vec3f mean, way;
        for (const Near& each : m_near) {
            const float part = distanceSq(each.position, place) / (within * within);
            if (each.label.cell == own && part < 1) {
                const float weight = (1 - part) * (1 - part);
                mean += each.normal * weight, way += (place - each.position) * weight;
            }
        }
        return dot(normalized(mean) - normal, way) < 0 ? Meeting::Convex : Meeting::Concave;
    }

    const surface::Surface& m_surface;
    LabelLayout m_labels;
    bool m_kept;     ///< partners are
    float m_spacing; ///< of a surfel's support
    std::vector<Near> m_near;
};

} // namespace

tree::Edit measuredLabels(const surface::Surface& surface, std::span<const EditedBall> balls, Partners partners) {
    tree::Edit out;
    const tree::SurfelTree& tree = surface.tree();
    const auto labels = tree.empty() ? std::nullopt : LabelLayout::of(*tree.layout());
    if (!labels)
        return out;
    std::map<std::uint32_t, std::vector<const EditedBall*>> near; // of each block those that may reach its surfels
    for (const EditedBall& ball : balls)
        tree.forBlocksInSupport(
            base::Box3f{ball.centre, ball.centre}.inflated(ball.radius),
            [&](std::uint32_t number, const SurfelBlock&) { near[number].push_back(&ball); }, surface.supportScale());
    const std::vector<std::pair<std::uint32_t, std::vector<const EditedBall*>>> all(near.begin(), near.end());
    std::vector<surfel::MutableBlockPtr> changed(all.size());
    base::parallelChunks(all.size(), 4, [&](std::size_t begin, std::size_t end, std::size_t) {
        LabelMeter meter(surface, *labels, partners);
        for (std::size_t i = begin; i < end; ++i) {
            const std::vector<const EditedBall*>& reaching = all[i].second;
            const surfel::BlockPtr block = tree.block(all[i].first);
            const float around = surface.supportScale() * block->maxSupport();
            changed[i] = meter.measured(*block, [&](const Vec3f& p) {
                return std::any_of(reaching.begin(), reaching.end(), [&](const EditedBall* ball) {
                    return base::distance(p, ball->centre) < ball->radius + around;
                });
            });
        }
    });
    for (std::size_t i = 0; i < all.size(); ++i)
        if (changed[i])
            out.blocks.push_back({all[i].first, changed[i], {}});
    out.inserted.layout = tree.layout();
    return out;
}

} // namespace cells
