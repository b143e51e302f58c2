#include "core/render/splats/label_cuts.h"

#include "core/render/splats/best_cut.h"

#include <algorithm>
#include <limits>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// Of a crease: with less both sides are nearly one, and discs blend.
constexpr int leastSharpness = 128;
/// Surfels of a patch this much farther off than its nearest one, in radii of the smaller disc, tell of its plane
/// there.
constexpr float aboutNearest = 1;
/// Patches farther off than this, in radii, of the disc or of theirs, do not cut.
constexpr float reach = 2.5f;
/// Cosine between normals of a patch that is no plane to a disc that it cuts.
constexpr float turned = 0.9f;
/// Cosines: normals on one side of a bend, and on both; where all are this near to their mean nothing is bent.
constexpr float oneSide = 0.985f, bent = 0.94f, narrow = 0.98f;
/// Where all are this near to their mean no two differ by as much as a bend.
constexpr float unbent = 0.985f;
/// Where all normals, of whatever cells, are this near to their mean, those of each are as near to theirs as `narrow`.
constexpr float flat = 0.9951f;
/// A square that is larger by this has a larger root.
constexpr float rounding = 1.0001f;
/// The same about tips.
constexpr float sameSide = 0.9f, farTurn = 0.77f;
constexpr int mostSides = 4;

} // namespace

/// fn(slot) for the slots of a cluster.
template <class Fn>
static void forSlots(const SurfelBlock& block, int cluster, const Fn& fn) {
    const int begin = cluster * surfel::clusterSize;
    for (int slot = begin; slot < std::min(begin + surfel::clusterSize, block.size()); ++slot)
        fn(slot);
}

void LabelCuts::gather(const SurfelBlock& block) {
    m_near.clear();
    const float own = m_radius * block.maxSupport(); // partners may be sampled more finely
    const base::Box3f box = block.box().inflated((reach + aboutNearest) * own);
    m_model.forBlocksInSupport(
        box,
        [&](std::uint32_t, const SurfelBlock& each) {
            const auto boxFor = [&](float support) { return box.inflated(reach * std::max(m_radius * support, own)); };
            for (int cluster = 0; cluster < each.clusterCount(); ++cluster) {
                const surfel::ClusterBounds bounds = each.bounds(cluster);
                if (!m_labels.anyMeets(each, cluster) || !boxFor(bounds.maxSupport).overlaps(bounds.box))
                    continue;
                forSlots(each, cluster, [&](int slot) {
                    const cells::Label label = m_labels.at(each, slot);
                    const float support = each.support(slot);
                    if (label.meeting != cells::Meeting::None && boxFor(support).contains(each.position(slot)))
                        m_near.push_back({each.position(slot), each.normal(slot), support, m_radius * support, label});
                });
            }
        },
        reach * m_radius);
}

std::optional<LabelCuts::Edge> LabelCuts::edgeTo(std::uint32_t cell, cells::Meeting meeting, const Disc& disc) const {
    float nearestSq = std::numeric_limits<float>::infinity();
    float radius = 0;
    for (const Disc& each : m_near) {
        const float distanceSq = lengthSq(each.centre - disc.centre), most = reach * std::max(disc.radius, each.radius);
        if (each.label.cell == cell && distanceSq < std::min(nearestSq, most * most)) {
            nearestSq = distanceSq;
            radius = std::min(disc.radius, each.radius);
        }
    }
    if (!(radius > 0))
        return std::nullopt;
    const float far = std::sqrt(nearestSq) + aboutNearest * radius;
    Vec3f normal, way;
    float total = 0;
    for (const Disc& each : m_near) {
        const float part = lengthSq(each.centre - disc.centre) / (far * far);
        if (each.label.cell != cell || !(part < 1))
            continue;
        const float weight = (1 - part) * (1 - part);
        normal += each.normal * weight, way += (each.centre - disc.centre) * weight, total += weight;
    }
    normal = normalized(normal, Vec3f{}), way = way / std::max(total, 1e-30f);
    const Vec3f own = normal;
    if (meeting == cells::Meeting::Concave)
        normal = -normal; // what is kept is in front of the patch
    const Vec3f across = normal - disc.normal * dot(normal, disc.normal);
    const float sine = length(across);
    if (!(sine > 0.05f))
        return std::nullopt;
    return Edge{across / sine, dot(way, normal) / sine, own, way, cell};
}

/// Do the patches across two creases of a disc's own meet the other way than it meets them? Then it goes on behind
/// either.
bool LabelCuts::reflex(const Edge& a, const Edge& b, cells::Meeting meeting) {
    const bool convex = dot(a.normal - b.normal, b.way - a.way) < 0;
    return convex != (meeting == cells::Meeting::Convex);
}

/// Does the patch across turn below the disc, so that no line cuts it?
bool LabelCuts::turnsAway(const Edge& edge, const Disc& disc) const {
    return std::any_of(m_near.begin(), m_near.end(), [&](const Disc& each) {
        return each.label.cell == edge.cell && dot(each.normal, edge.normal) < turned &&
               lengthSq(each.centre - disc.centre) < disc.radius * disc.radius;
    });
}

/// Lines at which the disc's patch ends within it: that of its partner first, which may be farther off.
std::vector<LabelCuts::Edge> LabelCuts::edgesOf(const Disc& disc) const {
    std::vector<Edge> out;
    if (const auto edge = edgeTo(disc.label.partner, disc.label.meeting, disc))
        out.push_back(*edge);
    for (const Disc& each : m_near) {
        const cells::Label& label = each.label;
        if (label.cell != disc.label.cell || label.partner == disc.label.partner ||
            lengthSq(each.centre - disc.centre) > 4 * disc.radius * disc.radius ||
            std::any_of(out.begin(), out.end(), [&](const Edge& known) { return known.cell == label.partner; }))
            continue;
        const auto other = edgeTo(label.partner, label.meeting, disc);
        if (other && other->distance < cutRadius * disc.radius &&
            !(!out.empty() && label.meeting == disc.label.meeting && reflex(out.front(), *other, label.meeting)))
            out.push_back(*other);
    }
    return out;
}

/// Of discs by cell, those of cells whose normals are not all within this cosine of their mean.
void LabelCuts::keepTurning(std::vector<Disc>& discs, float within) {
    auto kept = discs.begin();
    for (auto begin = discs.begin(), end = begin; begin != discs.end(); begin = end) {
        Vec3f mean;
        for (end = begin; end != discs.end() && end->label.cell == begin->label.cell; ++end)
            mean += end->normal;
        mean = normalized(mean, Vec3f{});
        if (std::any_of(begin, end, [&](const Disc& each) { return dot(each.normal, mean) < within; }))
            kept = std::move(begin, end, kept);
    }
    discs.erase(kept, discs.end());
}

/// Is nothing bent in m_clusters, whatever cell it is of?
bool LabelCuts::isFlat() const {
    Vec3f mean;
    for (const Cluster& each : m_clusters)
        forSlots(*each.block, each.number, [&](int slot) { mean += each.block->normal(slot); });
    mean = normalized(mean, Vec3f{});
    bool is = true;
    for (const Cluster& each : m_clusters)
        forSlots(*each.block, each.number, [&](int slot) { is &= dot(each.block->normal(slot), mean) > flat; });
    return is;
}

/// All discs near the block whose cell is bent there.
void LabelCuts::gatherBent(const SurfelBlock& block) {
    m_bent.clear();
    const float own = m_radius * block.maxSupport();
    const base::Box3f box = block.box().inflated(2 * own);
    m_clusters.clear();
    m_model.forBlocksInSupport(
        box,
        [&](std::uint32_t, const SurfelBlock& each) {
            for (int cluster = 0; cluster < each.clusterCount(); ++cluster)
                if (box.overlaps(each.bounds(cluster).box))
                    m_clusters.push_back({&each, cluster});
        },
        2 * m_radius);
    if (isFlat())
        return;
    for (const Cluster& from : m_clusters)
        forSlots(*from.block, from.number, [&, &each = *from.block](int slot) {
            if (box.contains(each.position(slot)))
                m_bent.push_back({each.position(slot), each.normal(slot), each.support(slot),
                                  m_radius * each.support(slot), m_labels.at(each, slot)});
        });
    std::stable_sort(m_bent.begin(), m_bent.end(),
                     [](const Disc& a, const Disc& b) { return a.label.cell < b.label.cell; });
    keepTurning(m_bent, narrow);
}

/// What of m_bent a disc of the cluster may reach, where that is bent enough.
void LabelCuts::gatherAround(const surfel::ClusterBounds& bounds) {
    m_around.clear();
    const float widest = m_radius * bounds.maxSupport;
    for (const Disc& each : m_bent) {
        const float far = widest + each.radius;
        if (bounds.box.distanceSq(each.centre) <= rounding * far * far)
            m_around.push_back(each);
    }
    keepTurning(m_around, unbent);
}

/// Where the disc's own cell turns along lines within it, one or two: hardly a disc there turns by less than the bend
/// and by more than what lies on one side of it. About a tip, where some turn by every angle, those count that turn
/// far.
void LabelCuts::addBends(const Disc& disc, std::vector<Edge>& edges) const {
    const auto [begin, end] =
        std::equal_range(m_around.begin(), m_around.end(), disc,
                         [](const Disc& a, const Disc& b) { return a.label.cell < b.label.cell; });
    struct Beyond {
        Vec3f normal, way;
        float cosine, distance;
    };
    std::vector<Beyond> beyond;
    std::size_t bends = 0, between = 0;
    for (auto each = begin; each != end; ++each) {
        const Vec3f way = each->centre - disc.centre;
        const float cosine = dot(each->normal, disc.normal), reach = disc.radius + each->radius;
        if (cosine > oneSide || lengthSq(way) > reach * reach)
            continue;
        ++(cosine > bent ? between : bends);
        if (cosine > bent || !(dot(way, disc.normal) < 0))
            continue;
        const float distance = dot(way, each->normal) / std::sqrt(std::max(1e-30f, 1 - cosine * cosine));
        if (distance > 0)
            beyond.push_back({each->normal, way, cosine, distance});
    }
    const bool tip = 5 * between > bends;
    if (tip)
        std::erase_if(beyond, [](const Beyond& each) { return each.cosine > farTurn; });
    const float alike = tip ? sameSide : oneSide;
    for (int number = 0; number < (tip ? mostSides : 2); ++number) {
        const auto nearest = std::min_element(beyond.begin(), beyond.end(),
                                              [](const Beyond& a, const Beyond& b) { return a.distance < b.distance; });
        if (nearest == beyond.end() || nearest->distance >= cutRadius * disc.radius)
            return;
        const Vec3f facing = nearest->normal;
        const auto side = std::stable_partition(beyond.begin(), beyond.end(),
                                                [&](const Beyond& each) { return dot(each.normal, facing) <= alike; });
        Edge edge{{}, 0, {}, {}, disc.label.cell};
        for (auto each = side; each != beyond.end(); ++each)
            edge.normal += each->normal, edge.way += each->way;
        const auto count = static_cast<float>(beyond.end() - side);
        beyond.erase(side, beyond.end());
        edge.normal = normalized(edge.normal, Vec3f{}), edge.way = edge.way / count;
        const Vec3f across = edge.normal - disc.normal * dot(edge.normal, disc.normal);
        edge.direction = normalized(across, Vec3f{});
        edge.distance = dot(edge.way, edge.normal) / length(across);
        if (count > 1 && edge.distance < disc.radius)
            edges.push_back(edge);
    }
}

CutCode LabelCuts::cutOf(const Disc& disc) const {
    std::vector<Edge> edges;
    if (disc.label.meeting != cells::Meeting::None && disc.label.sharpness >= leastSharpness)
        edges = edgesOf(disc);
    if (!m_around.empty())
        addBends(disc, edges);
    if (edges.empty())
        return wholeDisc;
    std::vector<CutLine> lines;
    for (const Edge& each : edges)
        lines.push_back({each.direction, each.distance / disc.radius});
    if (lines.size() == 1)
        return oneCut(disc.normal, lines.front(), turnsAway(edges.front(), disc) ? Beside::Corner : Beside::Edge);
    return bestCut(disc.normal, disc.support, lines);
}

bool LabelCuts::cut(const SurfelBlock& block, CutCodes& codes) {
    gather(block);
    gatherBent(block);
    if (m_near.empty() && m_bent.empty())
        return false;
    bool any = false;
    for (int slot = 0; slot < block.size(); ++slot) {
        if (slot % surfel::clusterSize == 0)
            gatherAround(block.bounds(slot / surfel::clusterSize));
        CutCode& code = codes[static_cast<std::size_t>(slot)];
        const Disc disc{block.position(slot), block.normal(slot), block.support(slot), m_radius * block.support(slot),
                        m_labels.at(block, slot)};
        if (code != wholeDisc || lengthSq(disc.normal) < 0.25f)
            continue;
        code = cutOf(disc);
        any |= code != wholeDisc;
    }
    return any;
}

} // namespace render
