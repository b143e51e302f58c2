#include "core/mesh/delaunay/coarsen_net.h"

#include "core/mesh/check/shape.h"

#include <algorithm>

namespace mesh {

using base::Vec3d;

namespace {

class Coarsening {
  public:
    Coarsening(SurfaceNet& net, const SizeField& size, double distance)
        : m_net(net), m_size(size), m_distance(distance) {}

    bool shorten(std::uint32_t vertex);

  private:
    bool allowed(std::uint32_t vertex, std::uint32_t into);
    bool rimKeepsCourse(std::uint32_t vertex, std::uint32_t into);
    bool facesKeepFacing(std::uint32_t vertex, std::uint32_t into);

    SurfaceNet& m_net;
    const SizeField& m_size;
    double m_distance;
    std::vector<std::uint32_t> m_fan, m_around, m_rim;
};

/// Into the nearest neighbour that may take it.
bool Coarsening::shorten(std::uint32_t vertex) {
    m_net.net.neighbours(vertex, m_around);
    if (m_around.empty())
        return false;
    const Vec3d at = m_net.positions[vertex];
    const double size = m_size(at);
    std::vector<std::pair<double, std::uint32_t>> near;
    for (const std::uint32_t v : m_around)
        if (const double d = distance(at, m_net.positions[v]); d < size)
            near.emplace_back(d, v);
    std::sort(near.begin(), near.end());
    return std::any_of(near.begin(), near.end(), [&](const auto& n) {
        return allowed(vertex, n.second) && m_net.net.collapse(vertex, n.second);
    });
}

bool Coarsening::allowed(std::uint32_t vertex, std::uint32_t into) {
    return (!m_net.net.onRim(vertex) || rimKeepsCourse(vertex, into)) && facesKeepFacing(vertex, into);
}

bool Coarsening::rimKeepsCourse(std::uint32_t vertex, std::uint32_t into) {
    m_net.net.fan(vertex, m_fan);
    m_rim.clear(); // neighbours along the rim
    for (const std::uint32_t f : m_fan)
        for (int k = 0; k < 3; ++k)
            if (const Side s{f, k}; m_net.net.onRim(s) && m_net.net.apex(s) != vertex)
                m_rim.push_back(m_net.net.from(s) == vertex ? m_net.net.to(s) : m_net.net.from(s));
    if (m_rim.size() != 2 || (m_rim[0] != into && m_rim[1] != into))
        return false;
    const Vec3d a = m_net.positions[m_rim[0]], ab = m_net.positions[m_rim[1]] - a, av = m_net.positions[vertex] - a;
    const double t = dot(av, ab) / lengthSq(ab);
    return t > 0 && t < 1 && length(av - ab * t) <= 0.5 * m_distance;
}

bool Coarsening::facesKeepFacing(std::uint32_t vertex, std::uint32_t into) {
    constexpr double facing = 0.9, turned = 0.5; // cosines
    constexpr double sharpest = 0.1;             // radians
    m_net.net.fan(vertex, m_fan);
    return std::all_of(m_fan.begin(), m_fan.end(), [&](std::uint32_t f) {
        Triangle t = m_net.net.corners(f);
        if (std::count(t.begin(), t.end(), into) > 0)
            return true;
        const auto sharpness = [&] {
            const auto [a, b, c] = m_net.places(t);
            return std::min(smallestAngle(a, b, c), sharpest);
        };
        const double angle = sharpness(), before = std::min(std::abs(m_net.facing(t)), facing);
        const Vec3d side = m_net.across(t);
        std::replace(t.begin(), t.end(), vertex, into);
        if (sharpness() < angle)
            return false;
        const bool sliver = angle < sharpest; // tells no direction
        return sliver || (std::abs(m_net.facing(t)) >= before && dot(side, m_net.across(t)) >= turned);
    });
}

/// Faces with two sides on rims that meet at a small angle.
void cutSharpCorners(SurfaceNet& net) {
    const double sharp = 3.14159265358979323846 / 3;
    for (bool any = true; any;) {
        any = false;
        for (std::uint32_t f = 0; f < net.net.faceCount(); ++f)
            for (int k = 0; k < 3 && net.net.alive(f); ++k) {
                if (!net.net.onRim(Side{f, (k + 1) % 3}) || !net.net.onRim(Side{f, (k + 2) % 3}))
                    continue;
                const Triangle& t = net.net.corners(f);
                const Vec3d at = net.positions[t[std::size_t(k)]];
                const Vec3d u = base::normalized(net.positions[t[std::size_t((k + 1) % 3)]] - at),
                            v = base::normalized(net.positions[t[std::size_t((k + 2) % 3)]] - at);
                if (dot(u, v) > std::cos(sharp)) {
                    net.net.removeEar(f);
                    any = true;
                }
            }
    }
}

} // namespace

void coarsen(SurfaceNet& net, const SizeField& size, double distance, const base::Progress& progress) {
    cutSharpCorners(net);
    Coarsening coarsening(net, size, distance);
    constexpr int passes = 6;
    const auto count = static_cast<std::uint32_t>(net.positions.size());
    for (int pass = 0; pass < passes; ++pass) {
        bool any = false;
        for (std::uint32_t v = 0; v < count; ++v) {
            if (v % 1024 == 0)
                progress.step((pass + double(v) / count) / passes, "Coarsening");
            any |= coarsening.shorten(v);
        }
        if (!any)
            break;
    }
}

} // namespace mesh
