#include "core/sculpt/keep_apart.h"

#include "core/base/parallel.h"
#include "core/process/resampling/resample.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sculpt {

using base::Vec3f;
using surfel::clusterSize;
using surfel::SurfelBlock;

/// In spacings: as near as two sides may come, and how far beside each other they may stand.
constexpr float nearest = 0.5f, beside = 0.75f;
/// Cosine of normals below which they are two sides; and half the angle that leaves nothing of the kind in a cone.
constexpr float apart = -0.7f, narrow = 0.407f;
/// Cosine of the carried normals up to which they tell where the other side is.
constexpr float stillApart = -0.3f;
/// In spacings: who gives back so much has the other side's normal.
constexpr float wholly = 0.1f;

namespace {

/// Where the normals of a block point: all within an angle of the mean.
struct Cone {
    Vec3f axis;
    float angle = 4; ///< radians
};

Cone coneOf(const SurfelBlock& block) {
    Vec3f sum;
    for (int slot = 0; slot < block.size(); ++slot)
        sum += block.normal(slot);
    const Cone none;
    const Vec3f axis = normalized(sum);
    if (axis == Vec3f{})
        return none;
    float least = 1;
    for (int slot = 0; slot < block.size(); ++slot)
        least = std::min(least, dot(axis, block.normal(slot)));
    return {axis, std::acos(std::clamp(least, -1.0f, 1.0f))};
}

bool mayFaceApart(const Cone& a, const Cone& b) {
    const float between = std::acos(std::clamp(dot(a.axis, b.axis), -1.0f, 1.0f));
    return between + a.angle + b.angle > std::acos(apart);
}

/// A block before and after the dab.
struct Sides {
    std::uint32_t number;
    surfel::BlockPtr before, after; ///< the same where it does not change
    Cone cone;
};

struct Given {
    float back = 0; ///< how far
    Vec3f along, normal;
};

class Keeper {
  public:
    Keeper(const surface::Surface& version, const tree::Edit& edit, float oneSpacing)
        : m_tree(version.tree()), m_edit(edit), m_oneSpacing(oneSpacing),
          m_perSupport(version.definition().support > 0 ? 0 : process::spacingOf(version.definition(), 1.0f)) {
        base::Box3f box;
        float widest = oneSpacing;
        std::vector<float> ways(edit.blocks.size());
        std::vector<base::Box3f> boxes(edit.blocks.size());
        base::parallelFor(edit.blocks.size(), 16, [&](std::size_t i) { ways[i] = look(edit.blocks[i], boxes[i]); });
        for (std::size_t i = 0; i < ways.size(); ++i)
            if (ways[i] > 0) {
                box.extend(boxes[i]);
                m_longest = std::max(m_longest, ways[i]);
                widest = std::max(widest, m_perSupport * m_tree.block(edit.blocks[i].block)->maxSupport());
            }
        if (m_longest > 0)
            gather(box.centre(), 0.5f * box.diagonal() + reach(widest));
    }

    /// Nothing is thin here.
    bool idle() const {
        Vec3f sum;
        for (const Sides& each : m_sides)
            sum += each.cone.axis;
        const Vec3f axis = normalized(sum);
        return std::all_of(m_sides.begin(), m_sides.end(), [&](const Sides& each) {
            return std::acos(std::clamp(dot(axis, each.cone.axis), -1.0f, 1.0f)) + each.cone.angle < std::acos(narrow);
        });
    }

    /// The block as it may become; null: as the dab has it.
    surfel::BlockPtr kept(const tree::BlockEdit& change) const {
        const Sides* const own = find(change.block);
        if (!own || own->before == own->after)
            return nullptr;
        const float radius = reach(std::max(m_oneSpacing, m_perSupport * own->before->maxSupport()));
        const base::Box3f box = own->before->box();
        std::vector<const Sides*> near;
        m_tree.forBlocksInBall(box.centre(), 0.5f * box.diagonal() + radius,
                               [&](std::uint32_t number, const SurfelBlock&) {
                                   const Sides* const other = find(number);
                                   if (other && mayFaceApart(own->cone, other->cone))
                                       near.push_back(other);
                               });
        if (near.empty())
            return nullptr;
        surfel::MutableBlockPtr out;
        for (int cluster = 0; cluster < own->before->clusterCount(); ++cluster)
            keep(*own, cluster, near, radius, out);
        if (out)
            out->seal();
        return out;
    }

  private:
    /// The longest way in a block, and its box.
    float look(const tree::BlockEdit& each, base::Box3f& box) const {
        if (!each.changed)
            return 0;
        const surfel::BlockPtr before = m_tree.block(each.block);
        float most = 0;
        for (int slot = 0; slot < before->size(); ++slot)
            most = std::max(most, distanceSq(before->position(slot), each.changed->position(slot)));
        box = before->box();
        return std::sqrt(most);
    }
    float reach(float spacing) const { return (nearest + beside) * spacing + 2 * m_longest; }
    float spacingAt(const SurfelBlock& block, int slot) const {
        return m_perSupport > 0 ? m_perSupport * block.support(slot) : m_oneSpacing;
    }

    void gather(const Vec3f& centre, float radius) {
        m_tree.forBlocksInBall(centre, radius, [&](std::uint32_t number, const SurfelBlock&) {
            m_sides.push_back({number, m_tree.block(number), m_tree.block(number), {}});
        });
        std::sort(m_sides.begin(), m_sides.end(), [](const Sides& a, const Sides& b) { return a.number < b.number; });
        for (const tree::BlockEdit& each : m_edit.blocks)
            if (const std::size_t i = indexOf(each.block); each.changed && i < m_sides.size())
                m_sides[i].after = each.changed;
        base::parallelFor(m_sides.size(), 16, [&](std::size_t i) { m_sides[i].cone = coneOf(*m_sides[i].before); });
    }
    std::size_t indexOf(std::uint32_t number) const {
        const auto at = std::lower_bound(m_sides.begin(), m_sides.end(), number,
                                         [](const Sides& each, std::uint32_t n) { return each.number < n; });
        return at != m_sides.end() && at->number == number ? static_cast<std::size_t>(at - m_sides.begin())
                                                           : m_sides.size();
    }
    const Sides* find(std::uint32_t number) const {
        const std::size_t i = indexOf(number);
        return i < m_sides.size() ? &m_sides[i] : nullptr;
    }

    void keep(const Sides& own, int cluster, const std::vector<const Sides*>& near, float radius,
              surfel::MutableBlockPtr& out) const {
        const int begin = cluster * clusterSize, end = std::min(begin + clusterSize, own.before->size());
        for (int slot = begin; slot < end; ++slot) {
            const Vec3f x = own.before->position(slot);
            if (x == own.after->position(slot))
                continue;
            Given given;
            for (const Sides* other : near)
                for (unsigned left =
                         other->before->boundsLanes().within(x, radius * radius) & other->before->clusterMask();
                     left != 0; left &= left - 1)
                    measure(own, slot, *other, std::countr_zero(left), given);
            if (given.back == 0)
                continue;
            if (!out)
                out = own.after->clone();
            const float part = std::min(1.0f, given.back / (wholly * spacingAt(*own.before, slot)));
            const Vec3f n = own.after->normal(slot);
            out->setPosition(slot, own.after->position(slot) + given.along * given.back);
            out->setNormal(slot, normalized(n * (1 - part) + given.normal * part, n));
        }
    }

    /// What one surfel has to give back for those of a cluster.
    void measure(const Sides& own, int slot, const Sides& other, int cluster, Given& out) const {
        const Vec3f x = own.before->position(slot), n = own.before->normal(slot);
        const Vec3f xAfter = own.after->position(slot), nAfter = own.after->normal(slot);
        const int begin = cluster * clusterSize, end = std::min(begin + clusterSize, other.before->size());
        for (int k = begin; k < end; ++k) {
            const Vec3f y = other.before->position(k), m = other.before->normal(k);
            if (dot(n, m) > apart)
                continue;
            const Vec3f d = x - y, across = normalized(n - m);
            const float s = 0.5f * (spacingAt(*own.before, slot) + spacingAt(*other.before, k));
            const float gap = dot(d, across);
            if (gap <= 0 || dot(d, d) - gap * gap > beside * beside * s * s)
                continue;
            const Vec3f yAfter = other.after->position(k), mAfter = other.after->normal(k);
            const Vec3f then = dot(nAfter, mAfter) < stillApart ? normalized(nAfter - mAfter) : across;
            const float lacks = std::min(gap, nearest * s) - dot(xAfter - yAfter, then);
            const float came = -dot(xAfter - x, then), cameThere = dot(yAfter - y, then);
            if (lacks <= 0 || came <= 0)
                continue;
            const float back = cameThere > 0 ? lacks * came / (came + cameThere) : lacks;
            if (back > out.back)
                out = {back, then, -mAfter};
        }
    }

    const tree::SurfelTree& m_tree;
    const tree::Edit& m_edit;
    float m_oneSpacing, m_perSupport, m_longest = 0;
    std::vector<Sides> m_sides; ///< by number
};

} // namespace

tree::Edit keptApart(const surface::Surface& version, tree::Edit edit, float oneSpacing) {
    const surfel::AttributeLayout& layout = *version.tree().layout();
    if (edit.empty() || edit.layout || !layout.normals || !layout.oriented)
        return edit;
    const Keeper keeper(version, edit, oneSpacing);
    if (keeper.idle())
        return edit;
    std::vector<surfel::BlockPtr> kept(edit.blocks.size());
    base::parallelFor(kept.size(), 4, [&](std::size_t i) {
        if (edit.blocks[i].changed)
            kept[i] = keeper.kept(edit.blocks[i]);
    });
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i])
            edit.blocks[i].changed = kept[i];
    return edit;
}

} // namespace sculpt
