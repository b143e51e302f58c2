#include "core/solid/loops/patch.h"

#include "core/base/cancel_scope.h"
#include "core/mesh/connectivity/triangulation.h"
#include "core/solid/loops/fairing.h"
#include "core/solid/loops/loop_triangles.h"

#include <map>
#include <numbers>

namespace solid {

using base::Vec3d;

namespace {

struct Polygon {
    std::vector<std::uint32_t> corners; ///< of the loop
    std::vector<Vec3d> positions, normals;
    std::vector<mesh::Triangle> triangles; ///< of the loop's points
};

Polygon polygonOf(const Loop& loop) {
    Polygon out;
    const std::size_t count = std::min(loop.size(), mostCorners);
    for (std::size_t i = 0; i < count; ++i) {
        out.corners.push_back(static_cast<std::uint32_t>(i * loop.size() / count));
        out.positions.push_back(loop.points[out.corners.back()].position);
        out.normals.push_back(loop.points[out.corners.back()].normal);
    }
    out.triangles = trianglesOver(out.positions, out.normals);
    for (mesh::Triangle& t : out.triangles)
        for (std::uint32_t& corner : t)
            corner = out.corners[corner];
    return out;
}

/// A triangulation whose edges come to the length wanted: split, joined, flipped and evened out in turn.
class Evening {
  public:
    Evening(const Loop& loop, std::span<const mesh::Triangle> triangles, const Sheet* sheet = nullptr,
            std::span<const SheetPlace> places = {})
        : m_loop(loop), m_mesh(triangles, loop.size()), m_sheet(sheet), m_places(places.begin(), places.end()) {
        for (const LoopPoint& p : loop.points) {
            m_out.positions.push_back(p.position);
            m_out.spacings.push_back(p.spacing);
        }
        m_out.loopSize = loop.size();
    }

    /// Of a patch that has been shaped: vertices stay on it.
    Evening(const Loop& loop, const Patch& shaped)
        : m_loop(loop), m_mesh(shaped.triangles, shaped.positions.size()), m_sheet(nullptr),
          m_shaped(true), m_out{shaped.positions, shaped.spacings, {}, shaped.loopSize} {}

    Patch result(const base::Progress& progress) {
        while (!m_sheet && !m_shaped && splitBoundary())
            flipAll();
        constexpr int rounds = 24, atLeast = 4;
        for (int round = 0; round < rounds; ++round) {
            progress.step(static_cast<double>(round) / rounds, "Filling");
            const bool split = splitLong();
            flipAll();
            if (round > 1)
                joinShort();
            flipAll();
            relax();
            if (!split && round >= atLeast)
                break;
        }
        return packed();
    }

  private:
    /// Sides that stand for several steps of the loop are split at its middle point.
    bool splitBoundary() {
        bool any = false;
        const auto n = static_cast<std::uint32_t>(m_loop.size());
        for (std::uint32_t f = 0, end = m_mesh.faceCount(); f < end; ++f)
            for (const int k : mesh::Triangulation::sides) {
                const mesh::Side s{f, k};
                if (!m_mesh.onBoundary(s))
                    continue;
                const std::uint32_t steps = (m_mesh.to(s) + n - m_mesh.from(s)) % n;
                if (steps < 2)
                    continue;
                m_mesh.splitSide(s, (m_mesh.from(s) + steps / 2) % n);
                any = true;
                break;
            }
        return any;
    }
    double edge(const mesh::Side& s) const { return distance(at(m_mesh.from(s)), at(m_mesh.to(s))); }
    double wanted(const mesh::Side& s) const {
        return 0.5 * (m_out.spacings[m_mesh.from(s)] + m_out.spacings[m_mesh.to(s)]) * hexagonal;
    }
    bool splitLong() {
        bool any = false;
        for (std::uint32_t f = 0, end = m_mesh.faceCount(); f < end; ++f) {
            if (!m_mesh.alive(f))
                continue;
            mesh::Side longest;
            double most = splitAbove;
            for (const int k : mesh::Triangulation::sides)
                if (const mesh::Side s{f, k}; m_mesh.across(s).exists() && edge(s) > most * wanted(s)) {
                    most = edge(s) / wanted(s);
                    longest = s;
                }
            if (!longest.exists())
                continue;
            const std::uint32_t a = m_mesh.from(longest), b = m_mesh.to(longest), middle = m_mesh.addVertex();
            if (m_sheet) {
                m_places.push_back({m_places[a].u + 0.5 * aheadOf(a, b), 0.5 * (m_places[a].v + m_places[b].v)});
                m_out.positions.push_back(m_sheet->at(m_places.back()));
            } else {
                m_out.positions.push_back((at(a) + at(b)) * 0.5);
            }
            m_out.spacings.push_back(0.5 * (m_out.spacings[a] + m_out.spacings[b]));
            m_mesh.splitSide(longest, middle);
            any = true;
        }
        base::CancelScope::check();
        return any;
    }
    void joinShort() {
        for (std::uint32_t f = 0, end = m_mesh.faceCount(); f < end; ++f)
            for (const int k : mesh::Triangulation::sides) {
                const mesh::Side s{f, k};
                if (!m_mesh.alive(f) || !m_mesh.across(s).exists() || edge(s) > joinBelow * wanted(s))
                    continue;
                const std::uint32_t a = m_mesh.from(s), b = m_mesh.to(s);
                const bool movesA = m_out.inside(a), movesB = m_out.inside(b);
                if ((movesA && m_mesh.collapse(a, b)) || (!movesA && movesB && m_mesh.collapse(b, a)))
                    break;
            }
    }
    Vec3d normalOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return normalized(cross(at(b) - at(a), at(c) - at(a)));
    }
    /// Flips what makes the angles opposite to edges smaller, and folds nothing, until nothing is left to flip.
    void flipAll() {
        constexpr int passes = 12;
        for (int pass = 0; pass < passes; ++pass) {
            bool any = false;
            for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f)
                for (const int k : mesh::Triangulation::sides)
                    if (const mesh::Side s{f, k}; m_mesh.alive(f) && m_mesh.across(s).exists())
                        any |= flipsWell(s) && m_mesh.flip(s);
            base::CancelScope::check();
            if (!any)
                return;
        }
    }
    double angleAt(std::uint32_t corner, std::uint32_t a, std::uint32_t b) const {
        const Vec3d u = at(a) - at(corner), v = at(b) - at(corner);
        return std::atan2(length(cross(u, v)), dot(u, v));
    }
    bool flipsWell(const mesh::Side& s) const {
        const std::uint32_t a = m_mesh.from(s), b = m_mesh.to(s), p = m_mesh.apex(s), q = m_mesh.apex(m_mesh.across(s));
        if (angleAt(p, a, b) + angleAt(q, a, b) <= std::numbers::pi * (1 + 1e-6))
            return false;
        const double before = dot(normalOf(p, a, b), normalOf(q, b, a)),
                     after = dot(normalOf(p, a, q), normalOf(q, b, p));
        return after >= std::min(0.5, before) - 1e-9;
    }
    /// How far ahead one vertex is of another, the shorter way about the sheet.
    double aheadOf(std::uint32_t a, std::uint32_t b) const { return std::remainder(m_places[b].u - m_places[a].u, 1); }
    /// Vertices inside go half the way to the middle of their neighbours, in the sheet where there is one.
    void relax() {
        constexpr int sweeps = 3;
        for (int sweep = 0; sweep < sweeps; ++sweep)
            m_sheet ? relaxInSheet() : relaxInSpace();
    }
    void relaxInSheet() {
        std::vector<SheetPlace> sums(m_places.size());
        std::vector<double> counts(m_places.size(), 0);
        m_mesh.forEdges([&](const mesh::Side& s) {
            const std::uint32_t a = m_mesh.from(s), b = m_mesh.to(s);
            const double ahead = aheadOf(a, b), across = m_places[b].v - m_places[a].v;
            sums[a].u += ahead, sums[b].u -= ahead;
            sums[a].v += across, sums[b].v -= across;
            counts[a] += 1, counts[b] += 1;
        });
        for (std::size_t v = m_out.loopSize; v < sums.size(); ++v)
            if (counts[v] > 0) {
                m_places[v].u += 0.5 * sums[v].u / counts[v], m_places[v].v += 0.5 * sums[v].v / counts[v];
                m_out.positions[v] = m_sheet->at(m_places[v]);
            }
    }
    void relaxInSpace() {
        std::vector<Vec3d> sums(m_out.positions.size());
        std::vector<double> counts(m_out.positions.size(), 0);
        m_mesh.forEdges([&](const mesh::Side& s) {
            const std::uint32_t a = m_mesh.from(s), b = m_mesh.to(s);
            sums[a] += at(b), sums[b] += at(a);
            counts[a] += 1, counts[b] += 1;
        });
        const std::vector<Vec3d> normals = m_shaped ? normalsNow() : std::vector<Vec3d>(sums.size());
        for (std::size_t v = m_out.loopSize; v < sums.size(); ++v)
            if (counts[v] > 0) {
                const Vec3d by = (sums[v] / counts[v] - m_out.positions[v]) * 0.5;
                m_out.positions[v] += by - normals[v] * dot(by, normals[v]);
            }
    }
    std::vector<Vec3d> normalsNow() const {
        std::vector<mesh::Triangle> triangles;
        for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f)
            if (m_mesh.alive(f))
                triangles.push_back(m_mesh.corners(f));
        return vertexNormals(m_out.positions, triangles);
    }
    const Vec3d& at(std::uint32_t vertex) const { return m_out.positions[vertex]; }
    /// Without vertices that are not in use.
    Patch packed() {
        std::vector<std::uint32_t> place(m_out.positions.size(), 0);
        for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f)
            if (m_mesh.alive(f))
                for (const std::uint32_t corner : m_mesh.corners(f))
                    place[corner] = 1;
        Patch out;
        out.loopSize = m_out.loopSize;
        for (std::size_t v = 0; v < place.size(); ++v)
            if (place[v] || v < m_out.loopSize) {
                place[v] = static_cast<std::uint32_t>(out.positions.size());
                out.positions.push_back(m_out.positions[v]);
                out.spacings.push_back(m_out.spacings[v]);
            }
        for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f)
            if (m_mesh.alive(f)) {
                const mesh::Triangle& t = m_mesh.corners(f);
                out.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
            }
        return out;
    }

    /// Edges of the length wanted times this. With both, patches have as many vertices as their area asks for, within
    /// some 5 % (2 % to 15 % more if edges are joined below 0.6, 35 % fewer below 0.75).
    static constexpr double splitAbove = 4.0 / 3, joinBelow = 0.65;
    /// Edges of a layout of equilateral triangles with spacing 1 (process/README 1.1).
    static constexpr double hexagonal = 1 / 0.9306;
    const Loop& m_loop;
    mesh::Triangulation m_mesh;
    const Sheet* m_sheet;             ///< null: vertices lie between their neighbours
    bool m_shaped = false;            ///< but no nearer to the tangent plane
    std::vector<SheetPlace> m_places; ///< of vertices on it
    Patch m_out;
};

/// From the loop at v = 0 to that at v = 1: whichever has the next point sooner goes on.
std::vector<mesh::Triangle> stripOver(std::span<const SheetPlace> places) {
    std::size_t first = 0; // points of the first loop
    while (first < places.size() && places[first].v < 0.5)
        ++first;
    const std::size_t second = places.size() - first;
    const auto a = [&](std::size_t i) { return static_cast<std::uint32_t>(i % first); };
    const auto b = [&](std::size_t j) { return static_cast<std::uint32_t>(first + (second - j % second) % second); };
    // begins at point 0 of the first and that of the other which is next to it
    std::size_t begin = 0;
    const auto ahead = [&](std::size_t j) { return std::remainder(places[b(j)].u - places[0].u, 1); };
    for (std::size_t j = 0; j < second; ++j)
        if (std::abs(ahead(j)) < std::abs(ahead(begin)))
            begin = j;
    const double offset = ahead(begin);
    const auto wayA = [&](std::size_t i) { return i == first ? 1 : places[a(i)].u - places[0].u; };
    const auto wayB = [&](std::size_t j) {
        const double way = places[b(begin + j)].u - places[b(begin)].u;
        return offset + (j == second ? 1 : way - std::floor(way));
    };
    std::vector<mesh::Triangle> out;
    for (std::size_t i = 0, j = 0; i < first || j < second;)
        if (j == second || (i < first && wayA(i + 1) <= wayB(j + 1))) {
            out.push_back({a(i), a(i + 1), b(begin + j)});
            ++i;
        } else {
            out.push_back({a(i), b(begin + j + 1), b(begin + j)});
            ++j;
        }
    return out;
}

} // namespace

double areaOver(const Loop& loop) {
    double sum = 0;
    for (const mesh::Triangle& t : polygonOf(loop).triangles) {
        const Vec3d &a = loop.points[t[0]].position, &b = loop.points[t[1]].position, &c = loop.points[t[2]].position;
        sum += 0.5 * length(cross(b - a, c - a));
    }
    return sum;
}

Patch patchOver(const Loop& loop, const base::Progress& progress) {
    return Evening(loop, polygonOf(loop).triangles).result(progress);
}

Patch evened(const Loop& loop, const Patch& patch) {
    return Evening(loop, patch).result({});
}

Patch patchBetween(const Loop& loops, std::span<const SheetPlace> places, const Sheet& sheet,
                   const base::Progress& progress) {
    return Evening(loops, stripOver(places), &sheet, places).result(progress);
}

void halveEdges(Patch& patch, std::vector<Vec3d>& normals, int times) {
    for (int level = 0; level < times; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, fresh] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(patch.positions.size()));
            if (fresh) {
                const Vec3d e = patch.positions[b] - patch.positions[a];
                patch.positions.push_back((patch.positions[a] + patch.positions[b]) * 0.5 +
                                          (normals[b] * dot(e, normals[b]) - normals[a] * dot(e, normals[a])) / 8);
                patch.spacings.push_back(0.5 * (patch.spacings[a] + patch.spacings[b]));
                normals.push_back(normalized(normals[a] + normals[b], normals[a]));
            }
            return found->second;
        };
        std::vector<mesh::Triangle> fine;
        for (const mesh::Triangle& t : patch.triangles) {
            const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
            fine.insert(fine.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
        }
        patch.triangles = std::move(fine);
        for (double& spacing : patch.spacings)
            spacing *= 0.5;
        base::CancelScope::check();
    }
    if (times > 0)
        patch.loopSize = 0;
}

} // namespace solid
