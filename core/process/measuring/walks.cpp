#include "core/process/measuring/walks.h"

#include "core/base/disjoint_sets.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/neighbours/knn.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace process {

using base::Vec3d, base::Vec3f;

constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::uint32_t nobody = 0xffffffffu;

/// Not through a wall: normals with sides face alike, and a way between others does not go along both of them.
static bool alongSurface(const Vec3f& way, const Vec3f& n, const Vec3f& m, bool oriented) {
    if (oriented)
        return dot(n, m) > -0.5f;
    const float steep = 0.9f * length(way);
    return std::abs(dot(way, n)) <= steep || std::abs(dot(way, m)) <= steep;
}

Walks::Walks(const surface::Surface& surface, std::size_t neighbours, const base::Progress& progress)
    : m_tree(surface.tree()) {
    const surfel::SurfelList list = m_tree.surfels();
    const Cloud cloud(list.items, part(progress, 0, 0.2));
    for (std::size_t i = 0; i < cloud.places().size(); ++i)
        m_place.push_back(cloud.places()[i]);
    m_tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        m_firstOfBlock.push_back((m_firstOfBlock.empty() ? 0 : m_firstOfBlock.back()) +
                                 static_cast<std::uint32_t>(block.size()));
    });
    m_firstOfBlock.insert(m_firstOfBlock.begin(), 0);
    const std::size_t count = cloud.size(), row = std::min(neighbours, count - 1);
    std::vector<Vec3f> normal(count);
    for (std::size_t i = list.size(); i-- > 0;)
        normal[m_place[i]] = list.items[i].normal;
    for (const Vec3f& p : cloud.positions())
        m_position.push_back(base::cast<double>(p));
    std::vector<std::uint32_t> near(count * row, nobody);
    cloud.forEach(row, part(progress, 0.2, 0.9), "Looking for ways", [&](std::size_t i, const Neighbours& found) {
        for (std::size_t k = 0; k < found.size(); ++k)
            if (const std::uint32_t j = found.index[k];
                alongSurface(cloud.positions()[j] - cloud.positions()[i], normal[i], normal[j], list.layout->oriented))
                near[i * row + k] = j;
    });
    m_first.assign(count + 1, 0);
    const auto forWays = [&](const auto& fn) { // there and back
        for (std::uint32_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < row; ++k)
                if (const std::uint32_t j = near[i * row + k]; j != nobody)
                    fn(i, j), fn(j, i);
    };
    forWays([&](std::uint32_t i, std::uint32_t) { ++m_first[i + 1]; });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_neighbour.resize(m_first.back());
    std::vector<std::size_t> end(m_first.begin(), m_first.end() - 1);
    forWays([&](std::uint32_t i, std::uint32_t j) { m_neighbour[end[i]++] = j; });
}

std::vector<std::uint32_t> Walks::nearest(const Vec3d& x) const {
    constexpr std::size_t ring = 6;
    std::vector<tree::Neighbour> found;
    m_tree.nearest(base::cast<float>(x), ring, found);
    std::vector<std::uint32_t> out;
    const Vec3f facing = found.front().block->normal(found.front().slot);
    for (const tree::Neighbour& n : found)
        if (alongSurface({}, facing, n.block->normal(n.slot), m_tree.layout()->oriented))
            out.push_back(m_place[m_firstOfBlock[n.blockNumber] + static_cast<std::uint32_t>(n.slot)]);
    return out;
}

Walks::Field Walks::walked(const Vec3d& from, const std::vector<std::uint32_t>& goals, double farthest,
                           const base::Progress& progress) const {
    Field out{std::vector<double>(m_position.size(), never), std::vector<std::uint32_t>(m_position.size(), nobody)};
    using Entry = std::pair<double, std::uint32_t>; // ties by number
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    const auto reach = [&](std::uint32_t i, double length, std::uint32_t by) {
        if (length < out.distance[i]) {
            out.distance[i] = length, out.before[i] = by;
            waiting.push({length, i});
        }
    };
    for (const std::uint32_t i : nearest(from))
        reach(i, distance(from, m_position[i]), nobody);
    std::size_t open = goals.size(), looked = 0;
    while (!waiting.empty() && (goals.empty() || open > 0)) {
        const double length = waiting.top().first; // no structured binding: clang captures none
        const std::uint32_t i = waiting.top().second;
        waiting.pop();
        if (length > out.distance[i])
            continue;
        if (length > farthest)
            break;
        open -= static_cast<std::size_t>(std::count(goals.begin(), goals.end(), i));
        if (++looked % 4096 == 0)
            progress.step(static_cast<double>(looked) / static_cast<double>(m_position.size()), "Walking");
        forNeighbours(i, [&](std::uint32_t j, double step) { reach(j, length + step, i); });
    }
    return out;
}

std::vector<Walks::Crossing> Walks::crossings(const Field& there, const Field& back, double longest) const {
    std::vector<Crossing> out;
    for (std::uint32_t i = 0; i < m_position.size(); ++i) {
        if (!(there.distance[i] <= back.distance[i]) || there.distance[i] == never)
            continue;
        Crossing best{i, i, longest};
        forNeighbours(i, [&](std::uint32_t j, double step) {
            const double length = there.distance[i] + step + back.distance[j];
            if (there.distance[j] > back.distance[j] && length < best.length)
                best = {i, j, length};
        });
        if (best.to != i)
            out.push_back(best);
    }
    std::sort(out.begin(), out.end(), [](const Crossing& a, const Crossing& b) {
        return std::tie(a.length, a.from) < std::tie(b.length, b.from);
    });
    return out;
}

/// Of the crossings along the middle the least ones, each of which others that are longer by `apart` part from all
/// that are less.
std::vector<Walks::Crossing> Walks::leastOfEach(std::vector<Crossing> crossings, double longest, double apart) const {
    std::vector<std::uint32_t> number(m_position.size(), nobody); // of the crossing that a position belongs to
    base::DisjointSets valleys(crossings.size());
    std::vector<double> rim(crossings.size(), longest); // of a valley by its least crossing: where it meets another
    const auto meet = [&](std::uint32_t a, std::uint32_t b, double at) {
        a = valleys.find(a), b = valleys.find(b); // the representative is the least
        if (a != b)
            rim[std::max(a, b)] = at;
        valleys.join(a, b);
    };
    for (std::uint32_t c = 0; c < crossings.size(); ++c)
        for (const std::uint32_t end : {crossings[c].from, crossings[c].to}) {
            forNeighbours(end, [&](std::uint32_t j, double) {
                if (number[j] != nobody)
                    meet(c, number[j], crossings[c].length);
            });
            number[end] = std::min(number[end], c);
        }
    std::vector<Crossing> out;
    for (std::size_t c = 0; c < crossings.size(); ++c)
        if (c == 0 || rim[c] - crossings[c].length > apart)
            out.push_back(crossings[c]);
    return out;
}

std::vector<std::vector<Vec3d>> Walks::between(const Vec3d& from, const Vec3d& to, std::size_t most,
                                               const base::Progress& progress) const {
    constexpr double longer = 1.15, apart = 0.01; // parts of the shortest: what straightening can change, and by chance
    const std::vector<std::uint32_t> goals = nearest(to);
    const Field there = walked(from, goals, never, part(progress, 0, 0.5));
    double shortest = never;
    std::uint32_t last = nobody;
    for (const std::uint32_t goal : goals)
        if (const double length = there.distance[goal] + distance(m_position[goal], to); length < shortest)
            shortest = length, last = goal;
    if (last == nobody)
        return {};
    const Field back = walked(to, {}, 0.6 * longer * shortest, part(progress, 0.5, 0.9));
    const auto walk = [](const Field& field, std::uint32_t end) {
        std::vector<std::uint32_t> out;
        for (std::uint32_t i = end; i != nobody; i = field.before[i])
            out.push_back(i);
        return out;
    };
    std::vector<std::vector<Vec3d>> out;
    const auto add = [&](std::vector<std::uint32_t> first, const std::vector<std::uint32_t>& second) {
        std::reverse(first.begin(), first.end());
        first.insert(first.end(), second.begin(), second.end());
        std::vector<Vec3d> way{from};
        for (const std::uint32_t i : first)
            way.push_back(m_position[i]);
        way.push_back(to);
        out.push_back(std::move(way));
    };
    add(walk(there, last), {});
    const std::vector<Crossing> least =
        leastOfEach(crossings(there, back, longer * shortest), longer * shortest, apart * shortest);
    for (std::size_t k = 1; k < least.size() && out.size() < most; ++k)
        add(walk(there, least[k].from), walk(back, least[k].to));
    return out;
}

} // namespace process
