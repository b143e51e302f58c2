#include "core/solid/loops/shape_patch.h"

#include "core/process/estimation/part_progress.h"
#include "core/solid/loops/fairing.h"
#include "core/solid/loops/loop_rings.h"

#include <queue>
#include <span>

namespace solid {

using base::Vec3d;

namespace {

/// The patch, whose positions stand first, with rings of the surface around it.
struct Ringed {
    std::vector<Vec3d> positions;
    std::vector<mesh::Triangle> triangles;
    std::vector<std::uint8_t> free; ///< of each position
};

Ringed ringed(const Patch& patch, std::span<const Vec3d> around) {
    Ringed out{patch.positions, patch.triangles, {}};
    const auto n = static_cast<std::uint32_t>(patch.loopSize), first = static_cast<std::uint32_t>(out.positions.size());
    out.positions.insert(out.positions.end(), around.begin(), around.end());
    out.free.assign(out.positions.size(), 0);
    std::fill(out.free.begin() + n, out.free.begin() + first, 1);
    for (std::uint32_t ring = 1; ring <= LoopRings::count; ++ring)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n, outer = first + (ring - 1) * n, inner = ring == 1 ? 0 : outer - n;
            out.triangles.push_back({inner + i, outer + i, inner + j});
            out.triangles.push_back({inner + j, outer + i, outer + j});
        }
    return out;
}

double extentOf(const Loop& loop) {
    double out = 0;
    for (const LoopPoint& p : loop.points)
        out = std::max(out, distance(p.position, loop.middle));
    return out;
}

/// Does a solution stay about its loop?
bool staysNear(const Loop& loop, std::span<const Vec3d> positions) {
    const double most = 2 * extentOf(loop) + 4 * loop.meanSpacing();
    return std::all_of(positions.begin(), positions.end(),
                       [&](const Vec3d& p) { return distance(p, loop.middle) <= most; });
}

/// What a sphere through the patch would have in its place: the Laplacian along the normals, everywhere as long as the
/// patch has it in the mean. A Laplacian that is harmonic, as least energy in a plane asks for, is that of no sphere.
Columns meanBend(const Measures& measures, const Ringed& at, const Columns& values) {
    const std::vector<Vec3d> normals = vertexNormals(at.positions, at.triangles);
    const Columns laplacian = measures.laplacian(values);
    double sum = 0, area = 0;
    for (std::size_t v = 0; v < normals.size(); ++v)
        if (at.free[v]) {
            const auto row = static_cast<Eigen::Index>(v);
            const double a = measures.areas[row];
            area += a;
            sum += a * dot(Vec3d{laplacian(row, 0), laplacian(row, 1), laplacian(row, 2)}, normals[v]);
        }
    Columns out(values.rows(), 3);
    for (std::size_t v = 0; v < normals.size(); ++v)
        for (std::size_t k = 0; k < 3; ++k)
            out(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) = normals[v][k] * sum / area;
    return out;
}

enum class Flow { Settled, Going, Lost };

/// A patch on its way to the shape of least energy of some order.
class Shaping {
  public:
    Shaping(const surface::Surface& surface, const Loop& loop)
        : m_loop(loop), m_around(ringsAround(surface, loop)), m_unit(loop.meanSpacing()) {}

    /// The loop comes to lie where the surface is that a smooth patch goes on from.
    void begin(Patch& patch) const { std::copy(m_around.edge.begin(), m_around.edge.end(), patch.positions.begin()); }
    /// So many steps at most, with areas and angles those of the last shape. `fresh`: it has none yet, and how it bends
    /// does not count at first. Lost where it swings away from the loop.
    Flow go(Patch& patch, int order, int passes, bool fresh) const {
        Ringed at = ringed(patch, m_around.behind);
        Flow out = Flow::Going;
        for (int pass = 0; pass < passes && out == Flow::Going; ++pass)
            out = step(at, patch.positions.size(), order, fresh && pass == 0);
        if (out != Flow::Lost)
            std::copy_n(at.positions.begin(), patch.positions.size(), patch.positions.begin());
        return out;
    }

    /// Of the loop's points, as the patch and the rings meet there.
    std::vector<Vec3d> edgeNormals(const Patch& patch) const {
        const Ringed at = ringed(patch, m_around.behind);
        std::vector<Vec3d> out = vertexNormals(at.positions, at.triangles);
        out.resize(patch.loopSize);
        return out;
    }

  private:
    Flow step(Ringed& at, std::size_t inner, int order, bool first) const {
        constexpr double share = 0.6;    // of the way: all of it goes to and fro where noise around the hole decides
        constexpr double settled = 0.02; // spacings
        Columns values(static_cast<Eigen::Index>(at.positions.size()), 3);
        for (std::size_t v = 0; v < at.positions.size(); ++v)
            for (std::size_t k = 0; k < 3; ++k)
                values(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) =
                    (at.positions[v][k] - m_loop.middle[k]) / m_unit;
        const Measures measures(at.positions, at.triangles, m_unit);
        const Columns bend = order > 1 && !first ? meanBend(measures, at, values) : Columns();
        if (!solve(measures, at.free, order, values, bend.size() > 0 ? &bend : nullptr))
            return Flow::Lost;
        double most = 0;
        for (std::size_t v = 0; v < inner; ++v) {
            const auto row = static_cast<Eigen::Index>(v);
            const Vec3d place = m_loop.middle + Vec3d{values(row, 0), values(row, 1), values(row, 2)} * m_unit;
            const Vec3d by = at.free[v] ? (place - at.positions[v]) * share : Vec3d{};
            most = std::max(most, length(by));
            at.positions[v] += by;
        }
        if (!staysNear(m_loop, std::span(at.positions).first(inner)))
            return Flow::Lost;
        return most < settled * m_unit ? Flow::Settled : Flow::Going;
    }

    const Loop& m_loop;
    LoopRings m_around;
    double m_unit;
};

constexpr int passes = 12;

/// Of least curvature. A patch that swells as it goes is made even again, and goes on from there.
bool bendPatch(const Shaping& shaping, const Loop& loop, Patch& patch, const base::Progress& progress) {
    constexpr int rounds = 4, passesAtFirst = 5;
    constexpr double same = 0.05; // of the vertices
    for (int round = 0; round < rounds; ++round) {
        progress.step(static_cast<double>(round) / rounds, "Shaping");
        const Flow flow = shaping.go(patch, 2, round + 1 < rounds ? passesAtFirst : passes, round == 0);
        if (flow == Flow::Lost)
            return false;
        if (round + 1 == rounds)
            break;
        Patch again = evened(loop, patch);
        const double grew = static_cast<double>(again.positions.size()) / static_cast<double>(patch.positions.size());
        if (flow == Flow::Settled && std::abs(grew - 1) < same)
            break;
        patch = std::move(again);
    }
    return true;
}

} // namespace

bool shapePatch(const surface::Surface& surface, const Loop& loop, Shape shape, Patch& patch,
                const base::Progress& progress) {
    constexpr double beyond = 0.05; // of the loop's extent
    const Shaping shaping(surface, loop);
    if (shape == Shape::Flat)
        return shaping.go(patch, 1, passes, true) != Flow::Lost;
    Patch bent = patch;
    shaping.begin(bent);
    if (!bendPatch(shaping, loop, bent, process::part(progress, 0, 0.6)))
        return false;
    patch = bent;
    progress.step(0.6, "Shaping");
    bool near = shaping.go(bent, 3, passes, false) != Flow::Lost;
    for (std::size_t v = 0; v < patch.positions.size(); ++v)
        near = near && distance(bent.positions[v], patch.positions[v]) <= beyond * extentOf(loop);
    if (near)
        patch = std::move(bent);
    patch.edgeNormals = shaping.edgeNormals(patch);
    return true;
}

std::vector<Vec3d> patchNormals(const Loop& loop, const Patch& patch) {
    std::vector<Vec3d> out = vertexNormals(patch.positions, patch.triangles);
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v] = v >= loop.size()            ? normalized(out[v], loop.points[0].normal)
                 : patch.edgeNormals.empty() ? loop.points[v].normal
                                             : normalized(patch.edgeNormals[v], loop.points[v].normal);
    return out;
}

std::vector<std::vector<double>> spreadOver(const Patch& patch, const std::vector<std::vector<double>>& values) {
    const std::size_t width = values.empty() ? 0 : values[0].size();
    std::vector<std::vector<double>> out(patch.positions.size(), std::vector<double>(width, 0));
    if (width == 0)
        return out;
    Columns columns = Columns::Zero(static_cast<Eigen::Index>(out.size()), static_cast<Eigen::Index>(width));
    for (std::size_t v = 0; v < values.size(); ++v)
        for (std::size_t k = 0; k < width; ++k)
            columns(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) = values[v][k];
    std::vector<std::uint8_t> free(out.size(), 1);
    std::fill_n(free.begin(), patch.loopSize, 0);
    double unit = 0;
    for (const double spacing : patch.spacings)
        unit += spacing / static_cast<double>(patch.spacings.size());
    const bool found = solve(Measures(patch.positions, patch.triangles, unit), free, 1, columns);
    const std::vector<std::uint32_t> nearest = nearestOfLoop(patch);
    for (std::size_t v = 0; v < out.size(); ++v)
        for (std::size_t k = 0; k < width; ++k)
            out[v][k] =
                found ? columns(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) : values[nearest[v]][k];
    return out;
}

std::vector<std::uint32_t> nearestOfLoop(const Patch& patch) {
    std::vector<std::vector<std::uint32_t>> beside(patch.positions.size());
    for (const mesh::Triangle& t : patch.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            beside[t[k]].push_back(t[(k + 1) % 3]);
            beside[t[k]].push_back(t[(k + 2) % 3]);
        }
    struct Reached {
        double way;
        std::uint32_t vertex, from;
        bool operator>(const Reached& o) const { return way != o.way ? way > o.way : vertex > o.vertex; }
    };
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    std::vector<std::uint32_t> out(patch.positions.size(), 0);
    std::vector<std::uint8_t> done(patch.positions.size(), 0);
    for (std::uint32_t v = 0; v < patch.loopSize; ++v)
        open.push({0, v, v});
    while (!open.empty()) {
        const Reached at = open.top();
        open.pop();
        if (done[at.vertex])
            continue;
        done[at.vertex] = 1;
        out[at.vertex] = at.from;
        for (const std::uint32_t next : beside[at.vertex])
            if (!done[next])
                open.push({at.way + distance(patch.positions[at.vertex], patch.positions[next]), next, at.from});
    }
    return out;
}

} // namespace solid
