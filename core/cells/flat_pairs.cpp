#include "core/cells/flat_pairs.h"

#include "core/base/parallel.h"

#include <cmath>
#include <map>

namespace cells {

using base::Vec3d, base::Vec3f;
using surfel::SurfelBlock;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

namespace {

constexpr float around = 3.5f;    ///< spacings: surfels so near the crease tell by how much it turns
constexpr double flatTurn = 0.14; ///< 8 degrees
constexpr int fewest = 3;         ///< surfels of a side that tell anything
constexpr int strays = 32;        ///< one of so many may say that there is an edge: noise

/// How often surfels beside a crease say that it turns, and that it does not.
struct Votes {
    int sharp = 0, flat = 0;
    bool isFlat() const { return flat > 0 && sharp * strays <= flat; }
};

class FlatPairs {
  public:
    FlatPairs(const surface::Surface& surface, const LabelLayout& labels)
        : m_tree(surface.tree()), m_labels(labels), m_spacing(static_cast<float>(surface::spacingOfUnit)),
          m_scale(surface.supportScale()) {}

    /// By how much normals turn at the crease, beside what faces bend: of the line that normals follow across it, with
    /// one slope on both sides, the step in the middle. Nothing where surfels are too few for that.
    std::optional<double> turnAt(const SurfelBlock& block, int slot, const Label& label) const {
        const Vec3f p = block.position(slot);
        const float reach = around * m_spacing * m_scale * block.support(slot);
        Vec3d mean[2], middle[2];
        int count[2] = {};
        std::vector<std::pair<Vec3d, Vec3d>> sides[2]; // places and normals
        m_tree.forBlocksInBall(p, reach, [&](std::uint32_t, const SurfelBlock& each) {
            for (int other = 0; other < each.size(); ++other) {
                if (!(distanceSq(each.position(other), p) < reach * reach))
                    continue;
                const std::uint32_t cell = m_labels.cellAt(each, other);
                if (cell != label.cell && cell != label.partner)
                    continue;
                const std::size_t side = cell == label.cell ? 0 : 1;
                const Vec3d q = base::cast<double>(each.position(other) - p),
                            n = base::cast<double>(each.normal(other));
                mean[side] += n, middle[side] += q, ++count[side];
                sides[side].push_back({q, n});
            }
        });
        if (count[0] < fewest || count[1] < fewest)
            return std::nullopt;
        if (!(dot(mean[0], mean[1]) > 0))
            return 1;
        const Vec3d normal = base::normalized(mean[0] / count[0] + mean[1] / count[1]);
        Vec3d across = middle[1] / count[1] - middle[0] / count[0];
        across = base::normalized(across - normal * dot(normal, across));
        // within each side, and what is left between both
        double tt = 0, tv = 0, t[2] = {}, v[2] = {};
        for (std::size_t side = 0; side < 2; ++side) {
            for (const auto& [q, n] : sides[side])
                t[side] += dot(q, across) / count[side], v[side] += dot(n, across) / count[side];
            for (const auto& [q, n] : sides[side]) {
                const double dt = dot(q, across) - t[side];
                tt += dt * dt, tv += dt * (dot(n, across) - v[side]);
            }
        }
        const double bend = tt > 0 ? tv / tt : 0;
        return std::abs(v[1] - v[0] - bend * (t[1] - t[0]));
    }

    /// Votes of the surfels of these pairs, in parallel; `asked(position)` tells which count.
    template <class Asked>
    std::map<Pair, Votes> votes(const std::map<Pair, Votes>* of, const Asked& asked) const {
        std::vector<std::map<Pair, Votes>> some(m_tree.blockCount());
        base::parallelFor(m_tree.blockCount(), 4, [&](std::size_t number) {
            const surfel::BlockPtr block = m_tree.block(static_cast<std::uint32_t>(number));
            if (!asked(*block, Vec3f(), true))
                return;
            for (int slot = 0; slot < block->size(); ++slot) {
                const Label label = m_labels.at(*block, slot);
                const Pair pair = std::minmax(label.cell, label.partner);
                if (label.meeting == Meeting::None || label.cell == label.partner || label.sharpness == 0 ||
                    (of && !of->contains(pair)) || !asked(*block, block->position(slot), false))
                    continue;
                if (const std::optional<double> turn = turnAt(*block, slot, label))
                    ++(*turn > flatTurn ? some[number][pair].sharp : some[number][pair].flat);
            }
        });
        std::map<Pair, Votes> out;
        for (const auto& each : some)
            for (const auto& [pair, votes] : each)
                out[pair].sharp += votes.sharp, out[pair].flat += votes.flat;
        std::erase_if(out, [](const auto& each) { return !each.second.isFlat(); });
        return out;
    }

    /// Cells that are larger than others keep their label.
    std::map<std::uint32_t, Label> relabelled(const std::map<Pair, Votes>& pairs) const {
        std::map<std::uint32_t, std::pair<std::size_t, std::uint32_t>> cells; // sizes and faces
        for (const auto& [pair, votes] : pairs)
            cells[pair.first], cells[pair.second];
        m_tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                if (const auto at = cells.find(m_labels.cellAt(block, slot)); at != cells.end())
                    ++at->second.first, at->second.second = m_labels.faceAt(block, slot);
        });
        std::map<std::uint32_t, Label> out;
        const auto now = [&](std::uint32_t cell) {
            for (auto at = out.find(cell); at != out.end(); at = out.find(cell))
                cell = at->second.cell;
            return cell;
        };
        for (const auto& [pair, votes] : pairs) {
            std::uint32_t stays = now(pair.first), goes = now(pair.second);
            if (stays == goes || cells[stays].second == cells[goes].second) // of one face: drawn
                continue;
            if (cells[stays].first < cells[goes].first)
                std::swap(stays, goes);
            out[goes] = {stays, stays, Meeting::None, 255, cells[stays].second};
            cells[stays].first += cells[goes].first;
        }
        for (auto& [cell, label] : out)
            label.cell = now(cell), label.face = cells[label.cell].second;
        return out;
    }

  private:
    const tree::SurfelTree& m_tree;
    LabelLayout m_labels;
    float m_spacing, m_scale;
};

} // namespace

tree::Edit mergedFlatPairs(const surface::Surface& surface, std::span<const EditedBall> balls) {
    tree::Edit out;
    const tree::SurfelTree& tree = surface.tree();
    const auto labels = tree.empty() ? std::nullopt : LabelLayout::of(*tree.layout());
    if (!labels)
        return out;
    const FlatPairs pairs(surface, *labels);
    // what was touched first: mostly nothing there is flat
    std::map<Pair, Votes> flat = pairs.votes(nullptr, [&](const SurfelBlock& block, const Vec3f& p, bool all) {
        return std::any_of(balls.begin(), balls.end(), [&](const EditedBall& ball) {
            return all ? block.box().distanceSq(ball.centre) < ball.radius * ball.radius
                       : distanceSq(p, ball.centre) < ball.radius * ball.radius;
        });
    });
    if (!flat.empty())
        flat = pairs.votes(&flat, [](const SurfelBlock&, const Vec3f&, bool) { return true; });
    const std::map<std::uint32_t, Label> merged =
        flat.empty() ? std::map<std::uint32_t, Label>() : pairs.relabelled(flat);
    if (merged.empty())
        return out;
    std::map<std::uint32_t, std::uint32_t> faces; // of what goes, with those that were drawn in it
    tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (const auto at = merged.find(labels->cellAt(block, slot)); at != merged.end())
                faces[labels->faceAt(block, slot)] = at->second.face;
    });
    const surfel::AttributeLayout& layout = *tree.layout();
    tree.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) {
        surfel::MutableBlockPtr changed;
        for (int slot = 0; slot < block.size(); ++slot) {
            const Label before = labels->at(block, slot);
            Label now = before;
            if (const auto at = merged.find(before.cell); at != merged.end())
                now.cell = at->second.cell;
            if (const auto at = merged.find(before.partner); at != merged.end())
                now.partner = at->second.cell;
            if (const auto at = faces.find(before.face); layout.find("face") && at != faces.end())
                now.face = at->second;
            if (now.partner == now.cell)
                now.meeting = Meeting::None;
            if (now == before)
                continue;
            if (!changed)
                changed = block.clone();
            std::vector<std::uint32_t> words(block.extraWords());
            block.extra(slot, words);
            surfel::write(*layout.find("cell"), words, now.cell);
            surfel::write(*layout.find("partner"), words, now.partner);
            surfel::write(*layout.find("sign"), words, static_cast<std::uint32_t>(now.meeting));
            if (layout.find("face"))
                surfel::write(*layout.find("face"), words, now.face);
            changed->setExtra(slot, words);
        }
        if (changed) {
            changed->seal();
            out.blocks.push_back({number, changed, {}});
        }
    });
    out.inserted.layout = tree.layout();
    return out;
}

} // namespace cells
