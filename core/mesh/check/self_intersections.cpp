#include "core/mesh/check/self_intersections.h"

#include "core/mesh/check/box_pairs.h"

#include <algorithm>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <numeric>

namespace mesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

class Intersections {
  public:
    explicit Intersections(std::span<const base::Vec3d> positions) : m_positions(positions) {}

    /// Do two triangles share more than the vertices that both name?
    bool meet(Triangle s, Triangle t) const {
        switch (bringForward(s, t)) {
        case 0:
            return CGAL::do_intersect(triangle(s), triangle(t));
        case 1: // the sides opposite to the common corner
            return CGAL::do_intersect(triangle(s), segment(t)) || CGAL::do_intersect(triangle(t), segment(s));
        case 2: // folded flat onto each other
            return CGAL::coplanar(at(s[0]), at(s[1]), at(s[2]), at(t[2])) &&
                   CGAL::coplanar_orientation(at(s[0]), at(s[1]), at(s[2]), at(t[2])) == CGAL::POSITIVE;
        default:
            return true; // the same triangle twice
        }
    }
    bool flat(const Triangle& t) const { return !isProper(t) || CGAL::collinear(at(t[0]), at(t[1]), at(t[2])); }
    base::Box3d box(const Triangle& t) const {
        base::Box3d out;
        for (const std::uint32_t v : t)
            out.extend(m_positions[v]);
        return out;
    }

  private:
    /// Common vertices to the front, in the same order; returns how many.
    static int bringForward(Triangle& s, Triangle& t) {
        int common = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto found = std::find(t.begin() + common, t.end(), s[i]);
            if (found == t.end())
                continue;
            std::iter_swap(t.begin() + common, found);
            std::swap(s[std::size_t(common++)], s[i]);
        }
        return common;
    }
    Point at(std::uint32_t v) const {
        const base::Vec3d& p = m_positions[v];
        return {p.x, p.y, p.z};
    }
    Kernel::Triangle_3 triangle(const Triangle& t) const { return {at(t[0]), at(t[1]), at(t[2])}; }
    Kernel::Segment_3 segment(const Triangle& t) const { return {at(t[1]), at(t[2])}; }

    std::span<const base::Vec3d> m_positions;
};

} // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> selfIntersections(const Mesh& mesh,
                                                                       const base::Progress& progress) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return selfIntersections(mesh, all, progress);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>>
selfIntersections(const Mesh& mesh, std::span<const std::uint32_t> among, const base::Progress& progress) {
    const Intersections intersections(mesh.positions);
    std::vector<base::Box3d> boxes;
    std::vector<std::uint32_t> of;
    for (const std::uint32_t f : among)
        if (!intersections.flat(mesh.triangles[f])) {
            boxes.push_back(intersections.box(mesh.triangles[f]));
            of.push_back(f);
        }
    const auto named = [&of](const BoxPair& pair) { return BoxPair(std::minmax(of[pair.first], of[pair.second])); };
    std::vector<BoxPair> out = overlappingBoxes(
        boxes,
        [&](const BoxPair& pair) {
            const auto [a, b] = named(pair);
            return intersections.meet(mesh.triangles[a], mesh.triangles[b]);
        },
        progress);
    for (BoxPair& pair : out)
        pair = named(pair);
    std::sort(out.begin(), out.end());
    return out;
}

bool trianglesMeet(std::span<const base::Vec3d> positions, const Triangle& a, const Triangle& b) {
    return Intersections(positions).meet(a, b);
}

bool isFlat(std::span<const base::Vec3d> positions, const Triangle& t) {
    return Intersections(positions).flat(t);
}

} // namespace mesh
