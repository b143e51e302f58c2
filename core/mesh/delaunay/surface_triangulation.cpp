#include "core/mesh/delaunay/surface_triangulation.h"

namespace mesh {

using base::Vec3d, base::Vec3f;

SurfaceTriangulation::SurfaceTriangulation(const surface::Surface& surface, const Mesh& mesh, Asking asking)
    : Triangulation(mesh), positions(mesh.positions), normals(mesh.normals), kinds(mesh.kinds),
      m_source(surface, surface::Steps::Apart), m_asking(asking) {}

std::uint32_t SurfaceTriangulation::addVertex(const SurfacePoint& at, VertexKind kind) {
    positions.push_back(at.position);
    normals.push_back(at.normal);
    kinds.push_back(kind);
    return Triangulation::addVertex();
}

Vec3d SurfaceTriangulation::faceNormal(const Triangle& t) const {
    const Vec3d& a = positions[t[0]];
    return base::normalized(cross(positions[t[1]] - a, positions[t[2]] - a));
}

Vec3d SurfaceTriangulation::surfaceNormal(const Triangle& t) const {
    const Vec3f first = normals[t[0]];
    Vec3f sum = first;
    for (std::size_t k = 1; k < 3; ++k)
        sum += dot(first, normals[t[k]]) < 0 ? -normals[t[k]] : normals[t[k]];
    return base::normalized(base::cast<double>(sum));
}

/// In float, and from there to x by the slope: far from the origin floats are coarser than small triangles.
SurfaceTriangulation::Sheet SurfaceTriangulation::evaluate(const Vec3d& x, const Vec3d& normal) {
    const Vec3f near = base::cast<float>(x);
    const base::Vec3f sheet = m_asking == Asking::OwnSheet ? base::cast<float>(normal) : base::Vec3f{};
    const auto at = m_source.evaluate(near, surface::Need::Gradient, {sheet});
    if (!at.ok() && at.status != surface::Status::BeyondBoundary)
        return {};
    const Vec3d gradient = base::cast<double>(at.gradient);
    return {double(at.value) + dot(gradient, x - base::cast<double>(near)), gradient, double(at.unit)};
}

SurfaceTriangulation::Facing SurfaceTriangulation::facingOf(const Triangle& t) const {
    constexpr double slack = 0.05;
    Facing out{surfaceNormal(t)};
    if (m_asking == Asking::AsItIs) // at edges corners lie on sheets that face different ways
        for (const std::uint32_t v : t)
            out.least = std::min(out.least, dot(base::cast<double>(normals[v]), out.normal) - slack);
    return out;
}

std::optional<SurfaceTriangulation::Root> SurfaceTriangulation::root(const Vec3d& x, const Vec3d& along, double reach,
                                                                     const Facing& facing) {
    constexpr int steps = 8;
    constexpr double precise = 1e-5, leastSlope = 0.1;
    double t = 0;
    for (int i = 0; i < steps; ++i) {
        const Sheet at = evaluate(x + along * t, facing.normal);
        const double slope = dot(at.gradient, along);
        if (!(std::abs(slope) >= leastSlope * length(at.gradient)))
            return std::nullopt;
        const double step = -at.value / slope;
        t += step;
        if (!(std::abs(t) <= reach))
            return std::nullopt;
        if (std::abs(step) <= precise * at.unit) {
            const Vec3d unit = base::normalized(at.gradient);
            const bool counts = dot(unit, facing.normal) >= facing.least && (m_asking == Asking::OwnSheet || slope > 0);
            return counts ? std::optional(Root{t, base::cast<float>(unit)}) : std::nullopt;
        }
    }
    return std::nullopt;
}

double SurfaceTriangulation::height(const Vec3d& x, const Vec3d& normal) {
    const Sheet at = evaluate(x, normal);
    const double slope = length(at.gradient);
    return slope > 0 ? std::abs(at.value) / slope : std::numeric_limits<double>::infinity();
}

Ball SurfaceTriangulation::ball(const Triangle& t) {
    const auto [a, b, c] = cornersOf(t);
    const Vec3d u = b - a, v = c - a, w = cross(u, v);
    const double area = lengthSq(w);
    const double longest = std::max({lengthSq(u), lengthSq(v), distanceSq(b, c)});
    constexpr double flat = 1e-14;
    Ball out;
    if (area <= flat * longest * longest) { // the longest side's ball: nothing larger tells of the corners
        const auto& [p, q] = lengthSq(u) == longest   ? std::pair(a, b)
                             : lengthSq(v) == longest ? std::pair(a, c)
                                                      : std::pair(b, c);
        out.centre = (p + q) * 0.5;
        out.radius = 0.5 * std::sqrt(longest);
        return out;
    }
    out.centre = a + (cross(w, u) * lengthSq(v) + cross(v, w) * lengthSq(u)) / (2 * area);
    out.radius = distance(out.centre, a);
    const Vec3d along = w / std::sqrt(area);
    if (const auto found = root(out.centre, along, out.radius, facingOf(t))) {
        out.centre += along * found->t;
        out.radius = distance(out.centre, a);
        out.onSurface = true;
    }
    return out;
}

Mesh SurfaceTriangulation::mesh(const std::vector<bool>& leftOut) const {
    Mesh out;
    out.positions = positions;
    out.normals = normals;
    out.kinds = kinds;
    for (std::uint32_t f = 0; f < faceCount(); ++f)
        if (alive(f) && !leftOut[f])
            out.triangles.push_back(corners(f));
    return out;
}

} // namespace mesh
