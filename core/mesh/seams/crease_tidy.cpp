#include "core/mesh/seams/crease_tidy.h"

#include "core/mesh/connectivity/triangulation.h"

namespace mesh {

using base::Vec3d;

namespace {

constexpr int rounds = 6;
constexpr double enough = 0.35;     ///< sine of an angle from which on a triangle is left alone: 20 degrees
constexpr double leastFacing = 0.5; ///< cosine between a triangle and its cell's normal

class CreaseTidier {
  public:
    explicit CreaseTidier(CutMesh& cut) : m_cut(cut), m_triangulation(cut.mesh) {}

    void run() {
        for (int round = 0; round < rounds; ++round) {
            bool any = false;
            for (std::uint32_t f = 0; f < m_triangulation.faceCount(); ++f)
                if (m_triangulation.alive(f) && beside(f) && quality(f) < enough)
                    any |= flipped(f) || collapsed(f);
            if (!any)
                break;
        }
        std::vector<Triangle> triangles;
        std::vector<Vec3d> facing;
        std::vector<std::uint32_t> cells;
        for (std::uint32_t f = 0; f < m_triangulation.faceCount(); ++f)
            if (m_triangulation.alive(f)) {
                triangles.push_back(m_triangulation.corners(f));
                facing.push_back(m_cut.facing[f]);
                cells.push_back(m_cut.cells[f]);
            }
        m_cut.mesh.triangles = std::move(triangles);
        m_cut.facing = std::move(facing);
        m_cut.cells = std::move(cells);
    }

  private:
    const Vec3d& place(std::uint32_t v) const { return m_cut.mesh.positions[v]; }
    const CellsAt& cellsAt(std::uint32_t v) const { return m_cut.vertices[v].cells; }
    bool beside(std::uint32_t f) const {
        const Triangle& t = m_triangulation.corners(f);
        return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return m_cut.vertices[v].mixed; });
    }

    /// Sine of the least angle; less than that where the triangle faces away from where its cell does.
    double quality(const Triangle& t, const Vec3d& facing) const {
        const Vec3d a = place(t[1]) - place(t[0]), b = place(t[2]) - place(t[1]), c = place(t[0]) - place(t[2]);
        const Vec3d area = cross(a, b);
        const double twice = length(area), la = length(a), lb = length(b), lc = length(c);
        if (!(twice > 0))
            return -1;
        const double longest = std::max({la * lb, lb * lc, lc * la});
        const double turned = dot(area, facing) / twice;
        return turned < leastFacing ? turned - 1 : twice / longest;
    }
    double quality(std::uint32_t f) const { return quality(m_triangulation.corners(f), m_cut.facing[f]); }

    /// No seam, and inside of the mesh.
    bool withinCell(const Side& s) const {
        const Side other = m_triangulation.across(s);
        return other.exists() && m_cut.cells[s.face] == m_cut.cells[other.face];
    }

    bool flipped(std::uint32_t f) {
        double best = 0;
        Side which;
        for (const int k : Triangulation::sides) {
            const Side s{f, k};
            if (!withinCell(s))
                continue;
            const Side other = m_triangulation.across(s);
            if (!m_triangulation.agrees(s))
                continue;
            const std::uint32_t p = m_triangulation.apex(s), q = m_triangulation.apex(other);
            const std::uint32_t a = m_triangulation.from(s), b = m_triangulation.to(s);
            const double before = std::min(quality(f), quality(other.face));
            const double after =
                std::min(quality({p, a, q}, m_cut.facing[f]), quality({q, b, p}, m_cut.facing[other.face]));
            if (p != q && after - before > std::max(best, 1e-3)) {
                best = after - before;
                which = s;
            }
        }
        return which.exists() && m_triangulation.flip(which);
    }

    /// May `v` move into its neighbour: does nothing of a seam go with it?
    bool mayGo(std::uint32_t v, const Side& s, std::uint32_t into) const {
        if (m_triangulation.onBoundary(v) || !m_cut.vertices[v].mixed)
            return false;
        if (cellsAt(v).count() == 1)
            return cellsAt(into).has(*cellsAt(v).begin());
        if (cellsAt(v).count() > 2) // twice the same corner
            return cellsAt(into).count() > 2 && base::distance(place(v), place(into)) < 1e-3 * sizeAbout(v);
        // along the seam
        const Side other = m_triangulation.across(s);
        return other.exists() && m_cut.cells[s.face] != m_cut.cells[other.face] &&
               std::all_of(cellsAt(v).begin(), cellsAt(v).end(),
                           [&](std::uint32_t cell) { return cellsAt(into).has(cell); });
    }
    double sizeAbout(std::uint32_t v) const {
        std::vector<std::uint32_t> ring;
        m_triangulation.neighbours(v, ring);
        double out = 0;
        for (const std::uint32_t w : ring)
            out = std::max(out, base::distance(place(v), place(w)));
        return out;
    }
    bool collapsed(std::uint32_t f) {
        struct Candidate {
            double length;
            std::uint32_t from, into;
            Side side;
        };
        std::vector<Candidate> all;
        for (const int k : Triangulation::sides) {
            const Side s{f, k};
            const std::uint32_t a = m_triangulation.from(s), b = m_triangulation.to(s);
            const double size = base::distance(place(a), place(b));
            all.push_back({size, a, b, s});
            all.push_back({size, b, a, s});
        }
        std::stable_sort(all.begin(), all.end(),
                         [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
        for (const Candidate& each : all)
            if (mayGo(each.from, each.side, each.into) && better(each.from, each.into) &&
                m_triangulation.collapse(each.from, each.into))
                return true;
        return false;
    }
    /// Is the worst triangle about `v` better once it is in `into`?
    bool better(std::uint32_t v, std::uint32_t into) {
        m_triangulation.oneRing(v, m_ring);
        double before = 2, after = 2;
        for (const std::uint32_t f : m_ring) {
            Triangle t = m_triangulation.corners(f);
            before = std::min(before, quality(f));
            if (t[0] == into || t[1] == into || t[2] == into)
                continue;
            for (std::uint32_t& each : t)
                each = each == v ? into : each;
            after = std::min(after, quality(t, m_cut.facing[f]));
        }
        return after > before + 1e-3;
    }

    CutMesh& m_cut;
    Triangulation m_triangulation;
    std::vector<std::uint32_t> m_ring;
};

} // namespace

void tidyCreases(CutMesh& cut) {
    CreaseTidier(cut).run();
}

} // namespace mesh
