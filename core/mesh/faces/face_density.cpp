#include "core/mesh/faces/face_density.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr double slack = 1e-3;      ///< for what float coordinates round
constexpr double evenEnough = 0.35; ///< spacings differ by so much within a part, over that of its middle

/// Halves the longest sides until the spacing is nearly one.
class Cutting {
  public:
    Cutting(const NearSpacings* near, double own, double slope, std::vector<FacePart>& out)
        : m_near(near), m_own(own), m_slope(slope), m_out(out) {}

    void run(std::uint32_t triangle, const std::array<Vec3d, 3>& corners) {
        cut({triangle, {0, 1, 0}, {0, 0, 1}}, corners);
    }

  private:
    void cut(FacePart part, const std::array<Vec3d, 3>& p) {
        base::CancelScope::check();
        const Vec3d middle = (p[0] + p[1] + p[2]) / 3;
        double radiusSq = 0;
        for (const Vec3d& corner : p)
            radiusSq = std::max(radiusSq, distanceSq(corner, middle));
        const double varies = m_slope * std::sqrt(radiusSq), nobodyAsks = m_own + varies;
        const double asked = m_near ? m_near->at(middle, nobodyAsks) : nobodyAsks, spacing = std::min(m_own, asked);
        part.even = asked >= nobodyAsks;
        if (part.even || varies <= evenEnough * spacing) {
            part.most = part.even ? m_own : std::min(m_own, spacing + (1 + slack) * varies);
            part.weight = length(cross(p[1] - p[0], p[2] - p[0])) / 2 / (spacing * spacing);
            m_out.push_back(part);
            return;
        }
        std::size_t k = 0; // the longest side begins there
        for (std::size_t i = 1; i < 3; ++i)
            if (distanceSq(p[i], p[(i + 1) % 3]) > distanceSq(p[k], p[(k + 1) % 3]))
                k = i;
        const std::size_t l = (k + 1) % 3;
        for (const auto& [moved, kept] : {std::pair(l, k), std::pair(k, l)}) {
            FacePart half = part;
            half.b[moved] = (part.b[moved] + part.b[kept]) / 2;
            half.c[moved] = (part.c[moved] + part.c[kept]) / 2;
            std::array<Vec3d, 3> q = p;
            q[moved] = (p[moved] + p[kept]) / 2;
            cut(half, q);
        }
    }

    const NearSpacings* m_near; ///< null: nobody asks for less
    double m_own, m_slope;
    std::vector<FacePart>& m_out;
};

} // namespace

FaceDensity::FaceDensity(const FaceTopology& topology, std::span<const Vec3f> positions, std::vector<double> spacings,
                         std::vector<SpacedPlace> places, double slope)
    : m_topology(topology), m_positions(positions), m_spacings(std::move(spacings)),
      m_least(*std::min_element(m_spacings.begin(), m_spacings.end())) {
    for (const SpacedPlace& each : places)
        m_least = std::min(m_least, each.spacing);
    if (!places.empty())
        m_near.emplace(std::move(places), slope);
    cut(slope);
}

double FaceDensity::at(const Vec3d& place, std::uint32_t triangle) const {
    return near(place, m_spacings[m_topology.pieces[triangle]]);
}

double FaceDensity::at(const Vec3d& place, const FacePart& part) const {
    return m_near && !part.even ? m_near->at(place, part.most) : part.most;
}

void FaceDensity::cut(double slope) {
    constexpr std::size_t grain = 256;
    std::vector<std::vector<FacePart>> found(base::chunkCount(m_topology.triangles.size(), grain));
    base::parallelChunks(
        m_topology.triangles.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t t = begin; t < end; ++t) {
                std::array<Vec3d, 3> corners;
                for (std::size_t k = 0; k < 3; ++k)
                    corners[k] = base::cast<double>(m_positions[m_topology.triangles[t][k]]);
                if (m_topology.areas[t] > 0)
                    Cutting(m_near ? &*m_near : nullptr, m_spacings[m_topology.pieces[t]], slope, found[chunk])
                        .run(static_cast<std::uint32_t>(t), corners);
            }
        });
    std::size_t count = 0;
    for (const auto& each : found)
        count += each.size();
    m_parts.reserve(count);
    for (std::vector<FacePart>& each : found) {
        m_parts.insert(m_parts.end(), each.begin(), each.end());
        each = {};
    }
}

double FaceDensity::samples(const InnerPlaces* inside) const {
    const FaceDraws draws(m_parts);
    return draws.total() * draws.outerShare(m_topology, m_positions, inside);
}

} // namespace mesh
