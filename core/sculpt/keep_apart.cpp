#include "core/sculpt/keep_apart.h"

#include "core/base/parallel.h"
#include "core/process/resampling/resample.h"

#include <algorithm>
#include <array>
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

constexpr float roundedAngle = 1e-3f; ///< radians, of arcs whose cosines are about 1

/// Where the normals of a block point: all within an angle of the mean.
struct Cone {
    Vec3f axis;
    float angle = 4; ///< radians
};

Cone coneOf(const SurfelBlock& block, int begin, int end) {
    Vec3f sum;
    for (int slot = begin; slot < end; ++slot)
        sum += block.normal(slot);
    const Cone none;
    const Vec3f axis = normalized(sum);
    if (axis == Vec3f{})
        return none;
    float least = 1;
    for (int slot = begin; slot < end; ++slot)
        least = std::min(least, dot(axis, block.normal(slot)));
    return {axis, std::acos(std::clamp(least, -1.0f, 1.0f))};
}

bool mayFaceApart(const Cone& a, const Cone& b) {
    const float between = std::acos(std::clamp(dot(a.axis, b.axis), -1.0f, 1.0f));
    return between + a.angle + b.angle > std::acos(apart) - roundedAngle;
}

/// What a pair of sides asks of the places of a block's or a cluster's surfels before the dab.
struct Patch {
    Vec3f centre;
    float radius = 0, spacing = 0; ///< of a ball around them; the largest
    Cone cone;

    /// The cosine to the cone's axis above which a normal faces apart from none of these.
    float limit() const {
        const float rest = std::acos(apart) - cone.angle - roundedAngle;
        return rest > 0 ? std::cos(rest) : 2;
    }
};

/// Can a surfel of `a` have one of `b` behind it, as two sides stand? The way from one to the other then goes along the
/// difference of their normals, by no more than `beside` off: a narrow beam, however far that a dab may bring them.
bool mayStandApart(const Patch& a, const Patch& b) {
    const Vec3f across = a.cone.axis - b.cone.axis, way = a.centre - b.centre;
    const float size = length(across), turn = a.cone.angle + b.cone.angle; // of n - m, at most
    if (!(turn < 0.5f * size))
        return true;
    constexpr float arc = 1.05f, rounding = 1.001f; // asin(t) <= 1.05 t up to 1/2
    const float far = length(way), along = dot(way, across) / size;
    const float off = std::sqrt(std::max(0.0f, far * far - along * along));
    const float room = rounding * (a.radius + b.radius + far * arc * turn / size) + 1e-3f * far;
    return along + room > 0 && off - room <= beside * 0.5f * (a.spacing + b.spacing);
}

bool mayMeet(const Patch& a, const Patch& b) {
    return mayFaceApart(a.cone, b.cone) && mayStandApart(a, b);
}

/// A block before and after the dab.
struct Sides {
    std::uint32_t number;
    surfel::BlockPtr before, after; ///< the same where it does not change
    Patch all;
    std::array<Patch, surfel::clustersPerBlock> clusters;
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
            sum += each.all.cone.axis;
        const Vec3f axis = normalized(sum);
        return std::all_of(m_sides.begin(), m_sides.end(), [&](const Sides& each) {
            return std::acos(std::clamp(dot(axis, each.all.cone.axis), -1.0f, 1.0f)) + each.all.cone.angle <
                   std::acos(narrow);
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
        m_tree.forBlocksInBall(
            box.centre(), 0.5f * box.diagonal() + radius, [&](std::uint32_t number, const SurfelBlock&) {
                const Sides* const other = find(number);
                if (other && mayFaceApart(own->all.cone, other->all.cone) && mayStandApart(own->all, other->all))
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
            m_sides.push_back({number, m_tree.block(number), m_tree.block(number), {}, {}});
        });
        std::sort(m_sides.begin(), m_sides.end(), [](const Sides& a, const Sides& b) { return a.number < b.number; });
        for (const tree::BlockEdit& each : m_edit.blocks)
            if (const std::size_t i = indexOf(each.block); each.changed && i < m_sides.size())
                m_sides[i].after = each.changed;
        base::parallelFor(m_sides.size(), 16, [&](std::size_t i) { describe(m_sides[i]); });
    }
    void describe(Sides& sides) const {
        const SurfelBlock& block = *sides.before;
        const auto patch = [&](const base::Box3f& box, float support, int begin, int end) {
            const float spacing = m_perSupport > 0 ? m_perSupport * support : m_oneSpacing;
            return Patch{box.centre(), 0.5f * box.diagonal(), spacing, coneOf(block, begin, end)};
        };
        sides.all = patch(block.box(), block.maxSupport(), 0, block.size());
        for (int c = 0; c < block.clusterCount(); ++c)
            sides.clusters[static_cast<std::size_t>(c)] =
                patch(block.bounds(c).box, block.bounds(c).maxSupport, c * clusterSize,
                      std::min((c + 1) * clusterSize, block.size()));
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
        const Patch& patch = own.clusters[static_cast<std::size_t>(cluster)];
        struct Opposite {
            const Sides* sides;
            int cluster;
            float limit; ///< of that cluster
        };
        std::vector<Opposite> opposite;
        for (const Sides* other : near) {
            const int clusters = mayMeet(patch, other->all) ? other->before->clusterCount() : 0;
            for (int c = 0; c < clusters; ++c)
                if (const Patch& there = other->clusters[static_cast<std::size_t>(c)]; mayMeet(patch, there))
                    opposite.push_back({other, c, there.limit()});
        }
        for (int slot = begin; slot < end && !opposite.empty(); ++slot) {
            const Vec3f x = own.before->position(slot);
            if (x == own.after->position(slot))
                continue;
            const Vec3f n = own.before->normal(slot);
            const Patch alone{x, 0, spacingAt(*own.before, slot), {n, 0}};
            Given given;
            for (const Opposite& each : opposite) {
                const Patch& there = each.sides->clusters[static_cast<std::size_t>(each.cluster)];
                if (dot(n, there.cone.axis) <= each.limit && mayStandApart(alone, there) &&
                    each.sides->before->bounds(each.cluster).box.distanceSq(x) <= radius * radius)
                    measure(own, slot, *each.sides, each.cluster, given);
            }
            if (given.back == 0)
                continue;
            if (!out)
                out = own.after->clone();
            const float part = std::min(1.0f, given.back / (wholly * spacingAt(*own.before, slot)));
            const Vec3f now = own.after->normal(slot);
            out->setPosition(slot, own.after->position(slot) + given.along * given.back);
            out->setNormal(slot, normalized(now * (1 - part) + given.normal * part, now));
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
