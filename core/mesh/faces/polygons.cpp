#include "core/mesh/faces/polygons.h"

#include <algorithm>
#include <limits>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

void Polygons::append(const Polygons& more) {
    const std::size_t before = corners.size();
    corners.insert(corners.end(), more.corners.begin(), more.corners.end());
    for (const std::size_t end : more.ends)
        ends.push_back(before + end);
    places.insert(places.end(), more.places.begin(), more.places.end());
    pictureOf.insert(pictureOf.end(), more.pictureOf.begin(), more.pictureOf.end());
    colours.insert(colours.end(), more.colours.begin(), more.colours.end());
}

std::size_t Polygons::renumber(std::span<const std::uint32_t> renumbered) {
    const auto to = [&](std::uint32_t corner) {
        return corner < renumbered.size() ? renumbered[corner] : std::numeric_limits<std::uint32_t>::max();
    };
    std::size_t keptCorners = 0, kept = 0, begin = 0;
    for (std::size_t face = 0; face < ends.size(); ++face) {
        const std::size_t end = ends[face];
        const bool whole = std::all_of(
            corners.begin() + static_cast<std::ptrdiff_t>(begin), corners.begin() + static_cast<std::ptrdiff_t>(end),
            [&](std::uint32_t corner) { return to(corner) != std::numeric_limits<std::uint32_t>::max(); });
        for (std::size_t k = begin; whole && k < end; ++k) {
            if (!places.empty())
                places[keptCorners] = places[k];
            corners[keptCorners++] = to(corners[k]);
        }
        if (whole) {
            if (!pictureOf.empty())
                pictureOf[kept] = pictureOf[face];
            if (!colours.empty())
                colours[kept] = colours[face];
            ends[kept++] = keptCorners;
        }
        begin = end;
    }
    const std::size_t lost = ends.size() - kept;
    ends.resize(kept);
    corners.resize(keptCorners);
    places.resize(std::min(places.size(), keptCorners));
    pictureOf.resize(std::min(pictureOf.size(), kept));
    colours.resize(std::min(colours.size(), kept));
    return lost;
}

namespace {

/// One face with more than three corners, in its mean plane.
class EarClipper {
  public:
    /// `corners`: numbers in `vertices`.
    EarClipper(std::vector<std::uint32_t> corners, std::span<const std::uint32_t> vertices,
               std::span<const Vec3f> positions)
        : m_corners(std::move(corners)), m_vertices(vertices), m_positions(positions) {
        for (std::size_t k = 0; k < m_corners.size(); ++k) // Newell: twice the area vector
            m_normal += cross(at(k) - at(0), at(k + 1) - at(0));
        m_normal = normalized(m_normal);
    }

    void run(std::vector<Triangle>& out) {
        while (m_corners.size() > 3) {
            const std::size_t ear = roundestEar(), n = m_corners.size();
            out.push_back({m_corners[(ear + n - 1) % n], m_corners[ear], m_corners[(ear + 1) % n]});
            m_corners.erase(m_corners.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        out.push_back({m_corners[0], m_corners[1], m_corners[2]});
    }

  private:
    Vec3d at(std::size_t k) const {
        return base::cast<double>(m_positions[m_vertices[m_corners[k % m_corners.size()]]]);
    }
    double turn(const Vec3d& a, const Vec3d& b, const Vec3d& c) const { return dot(cross(b - a, c - a), m_normal); }

    /// Twice the area over the longest side squared: 0.87 for an equilateral triangle, negative for a dent.
    double roundness(std::size_t k) const {
        const std::size_t n = m_corners.size();
        const Vec3d a = at(k + n - 1), b = at(k), c = at(k + 1);
        const double longest = std::max({distanceSq(a, b), distanceSq(b, c), distanceSq(c, a)});
        return longest > 0 ? turn(a, b, c) / longest : 0;
    }
    /// No other corner lies in the triangle that would be cut off.
    bool isEmpty(std::size_t k) const {
        const std::size_t n = m_corners.size();
        const Vec3d a = at(k + n - 1), b = at(k), c = at(k + 1);
        for (std::size_t j = 0; j < n; ++j) {
            const Vec3d p = at(j);
            if (p == a || p == b || p == c)
                continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0)
                return false;
        }
        return true;
    }
    std::size_t roundestEar() const {
        std::size_t best = 0;
        double most = -std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < m_corners.size(); ++k) {
            const double round = roundness(k);
            if (round > most && (round <= 0 || isEmpty(k)))
                best = k, most = round;
        }
        return best;
    }

    std::vector<std::uint32_t> m_corners;
    std::span<const std::uint32_t> m_vertices;
    std::span<const Vec3f> m_positions;
    Vec3d m_normal;
};

/// Beyond this, time that grows with the square of the corners is not worth it: such faces are convex discs and the
/// like.
constexpr std::size_t mostClipped = 4096;

} // namespace

/// The numbers of a face's corners, repeated ones once.
static std::vector<std::uint32_t> distinctCorners(const Polygons& polygons, std::size_t begin, std::size_t end) {
    const auto vertex = [&](std::uint32_t corner) { return polygons.corners[corner]; };
    std::vector<std::uint32_t> out;
    for (std::size_t k = begin; k < end; ++k)
        if (out.empty() || polygons.corners[k] != vertex(out.back()))
            out.push_back(static_cast<std::uint32_t>(k));
    while (out.size() > 1 && vertex(out.back()) == vertex(out.front()))
        out.pop_back();
    return out;
}

CutPolygons cut(const Polygons& polygons, std::span<const Vec3f> positions) {
    CutPolygons out;
    out.corners.reserve(polygons.corners.size());
    for (std::size_t i = 0, begin = 0; i < polygons.size(); begin = polygons.ends[i++]) {
        std::vector<std::uint32_t> corners = distinctCorners(polygons, begin, polygons.ends[i]);
        if (corners.size() < 3)
            continue;
        if (corners.size() <= mostClipped)
            EarClipper(std::move(corners), polygons.corners, positions).run(out.corners);
        else
            for (std::size_t k = 2; k < corners.size(); ++k)
                out.corners.push_back({corners[0], corners[k - 1], corners[k]});
        out.faces.resize(out.corners.size(), static_cast<std::uint32_t>(i));
    }
    out.triangles.reserve(out.corners.size());
    for (const Triangle& t : out.corners)
        out.triangles.push_back({polygons.corners[t[0]], polygons.corners[t[1]], polygons.corners[t[2]]});
    return out;
}

std::vector<Triangle> triangulated(const Polygons& polygons, std::span<const Vec3f> positions) {
    return cut(polygons, positions).triangles;
}

} // namespace mesh
