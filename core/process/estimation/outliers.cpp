#include "core/process/estimation/outliers.h"

#include "core/base/mat3.h"

namespace process {

namespace {

using base::Vec3d;
using base::Vec3f;

/// Of a neighbour's radius: what wants more and is not seen by it may be an outlier.
constexpr float farWider = 1.25f;
/// See each other: among the nearest of both. Few of them keep a swarm apart that comes near a sparse part of the
/// model.
constexpr std::size_t mutualNeighbours = 8;
/// Mean squared sine of the angle between the ways to the model and the model's tangent planes. A third is what
/// directions by chance would have; sparse samples of the model itself lie beside dense ones, not above them.
constexpr double steepestSight = 0.25;

/// Tells small groups of positions from the model, looking at no more of it than it must.
class Groups {
  public:
    Groups(const NeighbourGraph& graph, const SwarmLimit& limit)
        : m_graph(graph), m_limit(limit.of(graph.size())), m_kind(graph.size(), Kind::Unknown) {}

    bool isModel(std::uint32_t i) {
        take(i);
        return m_kind[i] == Kind::Model;
    }

    /// The group of i, sorted; empty where that is the model or was given out before.
    std::vector<std::uint32_t> take(std::uint32_t i) {
        if (m_kind[i] != Kind::Unknown)
            return {};
        std::vector<std::uint32_t>& group = m_group;
        group.assign(1, i);
        m_kind[i] = Kind::Queued;
        bool large = m_limit < 2;
        for (std::size_t k = 0; k < group.size() && !large; ++k)
            large = !enqueueMutual(group[k], group) || group.size() >= m_limit;
        for (const std::uint32_t j : group)
            m_kind[j] = large ? Kind::Model : Kind::Small;
        if (large)
            return {};
        std::sort(group.begin(), group.end());
        return group;
    }

  private:
    enum class Kind : std::uint8_t { Unknown, Queued, Small, Model };

    /// False where the group belongs to the model.
    bool enqueueMutual(std::uint32_t i, std::vector<std::uint32_t>& group) {
        const NeighbourGraph::Row row = m_graph.row(i);
        for (std::size_t k = 0; k < std::min(m_graph.count(), mutualNeighbours); ++k) {
            const std::uint32_t j = row[k];
            if (m_kind[j] == Kind::Queued || !m_graph.sees(j, i, mutualNeighbours))
                continue;
            if (m_kind[j] == Kind::Model)
                return false;
            m_kind[j] = Kind::Queued;
            group.push_back(j);
        }
        return true;
    }

    const NeighbourGraph& m_graph;
    std::size_t m_limit;
    std::vector<Kind> m_kind;
    std::vector<std::uint32_t> m_group; ///< that is being taken
};

bool isUnseen(const NeighbourGraph& g, std::span<const float> wanted, std::size_t i, std::uint32_t j) {
    return wanted[i] > farWider * wanted[j] && !g.sees(j, static_cast<std::uint32_t>(i));
}

/// Whether i wants more than one of its neighbours that does not see it.
bool isSuspect(const NeighbourGraph& g, std::span<const float> wanted, std::size_t i) {
    const NeighbourGraph::Row row = g.row(i);
    return std::any_of(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(g.count()),
                       [&](std::uint32_t j) { return isUnseen(g, wanted, i, j); });
}

/// The normal of the plane through i and its neighbours.
Vec3d planeAt(const NeighbourGraph& g, std::size_t i) {
    const Vec3d origin = base::cast<double>(g.positions()[i]);
    const NeighbourGraph::Row row = g.row(i);
    Vec3d mean{};
    base::Mat3d square{};
    for (std::size_t k = 0; k < g.count(); ++k) {
        const Vec3d d = base::cast<double>(g.positions()[row[k]]) - origin;
        mean += d;
        square += base::outer(d, d);
    }
    mean *= 1.0 / double(g.count() + 1);
    return base::symmetricEigen(square - base::outer(mean, mean) * double(g.count() + 1)).vector[0];
}

/// What the group sees beside itself. REQUIRES: a sorted group.
std::vector<Outliers::Sight> sightsOf(const NeighbourGraph& g, const std::vector<std::uint32_t>& group) {
    std::vector<Outliers::Sight> out;
    for (const std::uint32_t i : group) {
        const NeighbourGraph::Row row = g.row(i);
        for (std::uint32_t k = 0; k < g.count(); ++k)
            if (!std::binary_search(group.begin(), group.end(), row[k]))
                out.push_back({i, row[k], k});
    }
    return out;
}

bool standApart(const NeighbourGraph& g, std::span<const Outliers::Sight> sights, Groups& groups) {
    double sum = 0;
    std::size_t count = 0;
    for (const Outliers::Sight& sight : sights) {
        if (!groups.isModel(sight.seen))
            continue; // of other outliers' planes nothing follows
        const Vec3d way = base::cast<double>(g.positions()[sight.outlier] - g.positions()[sight.seen]);
        const double rise = dot(way, planeAt(g, sight.seen));
        sum += rise * rise / std::max(dot(way, way), 1e-300);
        ++count;
    }
    return count == 0 || sum > steepestSight * double(count);
}

/// What a row sees in one place from now on.
void redirect(NeighbourGraph& g, const Outliers::Sight& sight, std::uint32_t to) {
    NeighbourGraph::Row row = g.row(sight.outlier);
    row[sight.place] = to;
    g.set(sight.outlier, row);
}

} // namespace

Outliers cutOutliers(NeighbourGraph& graph, std::span<const float> wanted, const SwarmLimit& limit) {
    std::vector<std::uint8_t> suspect(graph.size());
    base::parallelFor(graph.size(), 4096, [&](std::size_t i) { suspect[i] = isSuspect(graph, wanted, i); });
    Groups groups(graph, limit);
    std::vector<std::vector<std::uint32_t>> small;
    for (std::uint32_t i = 0; i < suspect.size(); ++i)
        if (suspect[i])
            if (std::vector<std::uint32_t> group = groups.take(i); !group.empty())
                small.push_back(std::move(group));
    Outliers out;
    for (const std::vector<std::uint32_t>& group : small) {
        const std::vector<Outliers::Sight> sights = sightsOf(graph, group);
        if (sights.empty() || !standApart(graph, sights, groups))
            continue;
        out.members.insert(out.members.end(), group.begin(), group.end());
        out.ends.push_back(out.members.size());
        out.sights.insert(out.sights.end(), sights.begin(), sights.end());
    }
    for (const Outliers::Sight& sight : out.sights)
        redirect(graph, sight, sight.outlier);
    return out;
}

void lowerOutliers(std::vector<float>& h, NeighbourGraph& g, const Outliers& outliers, float slope) {
    for (const Outliers::Sight& sight : outliers.sights)
        redirect(g, sight, sight.seen);
    std::vector<std::uint8_t> isOutlier(h.size(), 0);
    for (const std::uint32_t i : outliers.members)
        isOutlier[i] = 1;
    std::vector<float> least = h, floors(h.size(), 0);
    for (const auto& [i, seen, place] : outliers.sights)
        if (!isOutlier[seen])
            least[i] = std::min(least[i], h[seen]),
            floors[i] = std::max(floors[i], h[seen] - slope * g.distance(i, seen));
    for (const std::uint32_t i : outliers.members)
        h[i] = std::max(least[i], floors[i]);
    bool changed = true;
    const auto lower = [&](std::uint32_t i, std::uint32_t j, float distance) {
        const float most = h[j] + slope * distance;
        if (isOutlier[i] && h[i] > most)
            h[i] = most, changed = true;
    };
    while (changed) {
        changed = false;
        for (const std::uint32_t i : outliers.members) {
            const NeighbourGraph::Row row = g.row(i);
            for (std::size_t k = 0; k < g.count(); ++k) {
                const float distance = g.distance(i, row[k]);
                lower(i, row[k], distance), lower(row[k], i, distance);
            }
        }
    }
}

} // namespace process
