#include "core/mesh/faces/face_cells.h"

#include "core/base/disjoint_sets.h"
#include "core/base/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mesh {

namespace {

using base::Vec3d;

constexpr std::uint64_t seed = 0x63656c6c73ULL;
constexpr int mostRays = 8;
constexpr double clearOfEdges = 1e-6; ///< barycentric: a ray that passes nearer to a corner or side tells nothing
constexpr double leastSlope = 1e-3;   ///< cosine between a ray and a face
constexpr double sameAngle = 1e-7;    ///< radians: faces on top of each other, at least
constexpr double roundOff = 1e-6;     ///< of coordinates; over the third corner's distance it is an angle
constexpr double mostAngle = 1e-2;    ///< radians: of needles nothing is known
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The side of face t that its normal points to is 2 t, the other one 2 t + 1.
constexpr std::uint32_t front(std::uint32_t t) {
    return 2 * t;
}
constexpr std::uint32_t back(std::uint32_t t) {
    return 2 * t + 1;
}

class Cells {
  public:
    Cells(const CellFaces& faces, std::span<const FaceSide> sides, const Places& places)
        : m_faces(faces), m_sides(sides), m_places(places), m_complexes(faces.triangles.size()),
          m_cells(2 * faces.triangles.size()), m_asked(faces.triangles.size()) {}

    std::vector<FaceRole> run() {
        if (!joinComplexes())
            return {};
        forEdges(m_sides, [&](std::span<const FaceSide> edge) { joinAround(edge); });
        std::vector<std::vector<std::uint32_t>> members = complexes();
        std::vector<FaceRole> out(m_faces.triangles.size(), FaceRole::Skin);
        for (const auto& complex : members)
            judge(complex, out);
        return out;
    }

  private:
    Vec3d at(std::uint32_t place) const { return base::cast<double>(m_faces.positions[place]); }
    Vec3d corner(std::uint32_t t, std::size_t k) const { return at(m_places.of[m_faces.triangles[t][k]]); }

    /// What meets in an edge is of one complex; asked are those with an edge of three faces and more. A face without
    /// area at such an edge has no angle there: nobody can tell. False where nothing is asked.
    bool joinComplexes() {
        forEdges(m_sides, [&](std::span<const FaceSide> edge) {
            for (std::size_t i = 1; i < edge.size(); ++i)
                m_complexes.join(edge[0].corner / 3, edge[i].corner / 3);
        });
        std::vector<std::uint8_t> unclear(m_asked.size());
        bool any = false;
        forEdges(m_sides, [&](std::span<const FaceSide> edge) {
            if (edge.size() < 3)
                return;
            any = true;
            const std::uint32_t root = m_complexes.find(edge[0].corner / 3);
            m_asked[root] = 1;
            for (const FaceSide& side : edge)
                unclear[root] |= m_faces.areas[side.corner / 3] > 0 ? 0 : 1;
        });
        for (std::size_t t = 0; t < m_asked.size(); ++t)
            m_asked[t] &= unclear[t] ^ 1;
        return any;
    }

    /// The side of a face that one leaves it by, turning about its edge as a right-handed screw goes to the higher
    /// place.
    static std::uint32_t ahead(const FaceSide& side) {
        const std::uint32_t t = side.corner / 3;
        return side.downwards ? back(t) : front(t);
    }
    static std::uint32_t behind(const FaceSide& side) { return ahead(side) ^ 1u; }

    void joinAround(std::span<const FaceSide> edge) {
        if (!m_asked[m_complexes.find(edge[0].corner / 3)])
            return;
        if (edge.size() < 3) { // of one face, both of its sides meet
            m_cells.join(ahead(edge.front()), behind(edge.back()));
            m_cells.join(ahead(edge.back()), behind(edge.front()));
            return;
        }
        struct Turn {
            double angle, blur;
            const FaceSide* side;
        };
        const auto largest = [](const Vec3d& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); };
        const Vec3d from = at(static_cast<std::uint32_t>(edge[0].key >> 32)),
                    axis = base::normalized(at(static_cast<std::uint32_t>(edge[0].key)) - from),
                    u = base::perpendicular(axis), v = cross(axis, u);
        std::vector<Turn> turns;
        for (const FaceSide& side : edge) {
            const Vec3d to = corner(side.corner / 3, (side.corner % 3 + 2) % 3) - from;
            const double a = dot(to, v), b = dot(to, u);
            const double off = roundOff * std::max(largest(from), largest(from + to));
            const double blur = std::clamp(off / std::max(std::hypot(a, b), 1e-300), sameAngle, mostAngle);
            turns.push_back({std::atan2(a, b), blur, &side});
        }
        std::stable_sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.angle < b.angle; });
        // Of faces on top of each other those come first that are entered from their fronts: what lies between is
        // solid. Such a group may lie across the angle at which the turn begins.
        std::size_t first = 0;
        while (first < turns.size() && onTopOfLast(turns, first))
            ++first;
        std::rotate(turns.begin(), turns.begin() + static_cast<std::ptrdiff_t>(first % turns.size()), turns.end());
        for (std::size_t begin = 0, end; begin < turns.size(); begin = end) {
            for (end = begin + 1; end < turns.size() && onTopOfLast(turns, end);)
                ++end;
            std::stable_partition(turns.begin() + static_cast<std::ptrdiff_t>(begin),
                                  turns.begin() + static_cast<std::ptrdiff_t>(end),
                                  [](const Turn& t) { return behind(*t.side) % 2 == 0; });
        }
        for (std::size_t i = 0; i < turns.size(); ++i)
            m_cells.join(ahead(*turns[i].side), behind(*turns[(i + 1) % turns.size()].side));
    }
    template <class Turns>
    static double gapBefore(const Turns& turns, std::size_t i) {
        const double gap = turns[i].angle - turns[(i + turns.size() - 1) % turns.size()].angle;
        return gap < 0 ? gap + 2 * std::numbers::pi : gap;
    }
    template <class Turns>
    static bool onTopOfLast(const Turns& turns, std::size_t i) {
        return gapBefore(turns, i) <= std::max(turns[i].blur, turns[(i + turns.size() - 1) % turns.size()].blur);
    }

    std::vector<std::vector<std::uint32_t>> complexes() {
        std::vector<std::uint32_t> number(m_asked.size(), none);
        std::vector<std::vector<std::uint32_t>> out;
        for (std::uint32_t t = 0; t < m_asked.size(); ++t) {
            const std::uint32_t root = m_complexes.find(t);
            if (!m_asked[root])
                continue;
            if (number[root] == none) {
                number[root] = static_cast<std::uint32_t>(out.size());
                out.emplace_back();
            }
            out[number[root]].push_back(t);
        }
        return out;
    }

    /// A side of a face that is seen from outside; `none` where no ray tells.
    std::uint32_t outermostSide(const std::vector<std::uint32_t>& complex) const {
        const std::uint32_t aim = *std::max_element(
            complex.begin(), complex.end(), [&](auto a, auto b) { return m_faces.areas[a] < m_faces.areas[b]; });
        base::Random random(base::mix(seed ^ aim));
        for (int ray = 0; ray < mostRays; ++ray) {
            const double u = random.uniform(0.2, 0.4), v = random.uniform(0.2, 0.4);
            const Vec3d from =
                corner(aim, 0) + (corner(aim, 1) - corner(aim, 0)) * u + (corner(aim, 2) - corner(aim, 0)) * v;
            if (const std::uint32_t found = lastHit(complex, from, random.unitVector()); found != none)
                return found;
        }
        return none;
    }

    /// The far side of the last face on the way, that of all which may be last if there is no doubt.
    std::uint32_t lastHit(const std::vector<std::uint32_t>& complex, const Vec3d& from, const Vec3d& way) const {
        double farthest = -1, doubtful = -1;
        std::uint32_t out = none;
        for (const std::uint32_t t : complex) {
            if (!(m_faces.areas[t] > 0))
                continue;
            const Vec3d a = corner(t, 0), ab = corner(t, 1) - a, ac = corner(t, 2) - a, n = cross(ab, ac);
            const double slope = dot(n, way), size = length(n);
            if (std::abs(slope) < 1e-12 * size)
                continue;
            const double along = dot(n, a - from) / slope;
            const Vec3d at = from + way * along - a;
            const double b = dot(n, cross(at, ac)) / (size * size), c = dot(n, cross(ab, at)) / (size * size);
            const double inside = std::min({b, c, 1 - b - c});
            if (inside < -clearOfEdges)
                continue;
            if (inside < clearOfEdges || std::abs(slope) < leastSlope * size)
                doubtful = std::max(doubtful, along);
            else if (along > farthest)
                farthest = along, out = slope > 0 ? front(t) : back(t);
        }
        return farthest > doubtful ? out : none;
    }

    void judge(const std::vector<std::uint32_t>& complex, std::vector<FaceRole>& out) {
        const std::uint32_t side = outermostSide(complex);
        if (side == none)
            return;
        const std::uint32_t outside = m_cells.find(side);
        const std::vector<int> turns = turnsAround(complex, outside);
        const auto solid = [&](std::uint32_t at) {
            const std::uint32_t cell = m_cells.find(at);
            return cell != outside && (turns.empty() || turns[m_slot[cell]] != 0);
        };
        double right = 0, wrong = 0; // area of the skin by its facing
        for (const std::uint32_t t : complex) {
            const bool ahead = solid(front(t)), behind = solid(back(t));
            if (ahead && behind)
                out[t] = FaceRole::Inside;
            else if (ahead || behind)
                (ahead ? wrong : right) += m_faces.areas[t];
            if (ahead && !behind)
                out[t] = FaceRole::Turned;
        }
        if (right > 0 && wrong > 0)
            return;
        for (const std::uint32_t t : complex) // all alike: turned as a whole, or a hole in something (turn_outwards.h)
            if (out[t] == FaceRole::Turned)
                out[t] = FaceRole::Skin;
    }

    /// How often the faces turn around each cell of a complex, by m_slot; empty where ways there contradict each other,
    /// or where faces that were given both ways round bound it.
    std::vector<int> turnsAround(const std::vector<std::uint32_t>& complex, std::uint32_t outside) {
        m_slot.resize(2 * m_faces.triangles.size(), none);
        std::vector<std::uint32_t> cells;
        const auto slotOf = [&](std::uint32_t at) {
            const std::uint32_t cell = m_cells.find(at);
            if (m_slot[cell] == none) {
                m_slot[cell] = static_cast<std::uint32_t>(cells.size());
                cells.push_back(cell);
            }
            return m_slot[cell];
        };
        slotOf(outside);
        std::vector<std::vector<std::uint32_t>> faces; // of each cell
        for (const std::uint32_t t : complex)
            for (const std::uint32_t at : {front(t), back(t)}) {
                const std::uint32_t slot = slotOf(at);
                faces.resize(std::max<std::size_t>(faces.size(), slot + 1));
                faces[slot].push_back(t);
            }
        constexpr int unknown = std::numeric_limits<int>::max();
        std::vector<int> out(cells.size(), unknown);
        out[0] = 0;
        std::vector<std::uint32_t> open{0};
        while (!open.empty()) {
            const std::uint32_t cell = open.back();
            open.pop_back();
            for (const std::uint32_t t : faces[cell]) {
                const std::uint32_t f = slotOf(front(t)), b = slotOf(back(t));
                const int step = m_faces.given[t];
                if (f == b) // a sheet that ends within the cell
                    continue;
                if (step == 0 && (f == 0 || b == 0))
                    return {};
                const std::uint32_t other = f == cell ? b : f;
                const int turns = out[cell] + (f == cell ? step : -step);
                if (out[other] == unknown) {
                    out[other] = turns;
                    open.push_back(other);
                } else if (out[other] != turns)
                    return {};
            }
        }
        return out;
    }

    const CellFaces& m_faces;
    std::span<const FaceSide> m_sides;
    const Places& m_places;
    base::DisjointSets m_complexes, m_cells; ///< of faces, of their sides
    std::vector<std::uint8_t> m_asked;       ///< of each complex, by its root
    std::vector<std::uint32_t> m_slot;       ///< of each cell, by its root: its number in its complex
};

} // namespace

std::vector<FaceRole> rolesOf(const CellFaces& faces, std::span<const FaceSide> sides, const Places& places) {
    return Cells(faces, sides, places).run();
}

} // namespace mesh
