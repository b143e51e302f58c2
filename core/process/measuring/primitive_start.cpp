#include "core/process/measuring/primitive_start.h"

#include "core/base/mat3.h"

#include <Eigen/Dense>

namespace process {

using base::Vec3d;
using Points = std::span<const OrientedPoint>;

namespace {

/// The solution of a symmetric system; nothing where it does not determine one.
std::optional<Vec3d> meeting(const base::Mat3d& sum, const Vec3d& right) {
    constexpr double parallel = 1e-8;
    const auto eigen = base::symmetricEigen(sum);
    if (!(eigen.value[0] > parallel * eigen.value[2]))
        return {};
    return base::inverse(sum) * right;
}

std::optional<Primitive> plane(Points points) {
    const Vec3d a = points[0].position;
    const Vec3d n = cross(points[1].position - a, points[2].position - a);
    if (!(lengthSq(n) > 0))
        return {};
    Primitive out{Shape::Plane, a, base::normalized(n)};
    return out;
}

/// Through four points: from the differences of their spheres' equations.
std::optional<Primitive> sphere(Points points) {
    const Vec3d o = points[0].position;
    base::Mat3d rows;
    Vec3d right;
    for (int k = 0; k < 3; ++k) {
        const Vec3d d = points[static_cast<std::size_t>(k) + 1].position - o;
        rows[k][0] = d.x, rows[k][1] = d.y, rows[k][2] = d.z;
        right[static_cast<std::size_t>(k)] = 0.5 * lengthSq(d);
    }
    if (!(std::abs(base::determinant(rows)) > 1e-12))
        return {};
    const Vec3d c = base::inverse(rows) * right;
    return Primitive{Shape::Sphere, o + c, {0, 0, 1}, length(c)};
}

/// The axis is across two normals; in the plane across it their lines meet on it.
std::optional<Primitive> cylinder(Points points) {
    constexpr double leastAngle = 0.05;
    const Vec3d across = cross(points[0].normal, points[1].normal);
    if (!(length(across) > leastAngle))
        return {};
    const Vec3d axis = base::normalized(across), d = points[1].position - points[0].position;
    const Vec3d flat = d - axis * dot(d, axis), n = points[1].normal;
    const Vec3d other = cross(axis, n); // across the second line, in the plane
    const double t = dot(flat, other) / dot(points[0].normal, other);
    const Vec3d centre = points[0].position + points[0].normal * t;
    const Vec3d to = points[1].position - centre;
    return Primitive{Shape::Cylinder, centre, axis, 0.5 * (std::abs(t) + length(to - axis * dot(to, axis)))};
}

/// Tangent planes meet in the apex; from there the points lie on a circle about the axis.
std::optional<Primitive> cone(Points points) {
    base::Mat3d sum;
    Vec3d right;
    for (const OrientedPoint& p : points) {
        sum += base::outer(p.normal, p.normal);
        right += p.normal * dot(p.normal, p.position);
    }
    const std::optional<Vec3d> apex = meeting(sum, right);
    if (!apex)
        return {};
    Vec3d way[3];
    for (std::size_t k = 0; k < 3; ++k)
        way[k] = base::normalized(points[k].position - *apex);
    Vec3d axis = base::normalized(cross(way[1] - way[0], way[2] - way[0]));
    if (dot(axis, way[0]) < 0)
        axis = -axis;
    const double cosine = (dot(axis, way[0]) + dot(axis, way[1]) + dot(axis, way[2])) / 3;
    if (!(cosine > 0.01 && cosine < 0.9999))
        return {};
    return Primitive{Shape::Cone, *apex, axis, 0, 0, std::acos(cosine)};
}

/// All normals of a surface of revolution meet its axis: a linear complex of lines, the least eigenvector of their
/// Pluecker coordinates. In the half plane beside the axis the normals meet in the tube's centre.
std::optional<Primitive> torus(Points points) {
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    for (const OrientedPoint& p : points) {
        const Vec3d m = cross(p.position, p.normal);
        const Vector6 line = (Vector6() << m.x, m.y, m.z, p.normal.x, p.normal.y, p.normal.z).finished();
        sum += line * line.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(sum);
    const Vector6 least = eigen.eigenvectors().col(0);
    const Vec3d direction{least(0), least(1), least(2)}, moment{least(3), least(4), least(5)};
    if (!(length(direction) > 1e-3))
        return {};
    const Vec3d axis = base::normalized(direction), on = cross(axis, moment) / length(direction);
    double xx = 0, xy = 0, yy = 0, bx = 0, by = 0;
    struct Flat {
        double across, along;
    };
    std::vector<Flat> flat;
    for (const OrientedPoint& p : points) {
        const Vec3d q = p.position - on;
        const double along = dot(q, axis);
        const Vec3d e = base::normalized(q - axis * along);
        const double nx = dot(p.normal, e), ny = dot(p.normal, axis), size = std::hypot(nx, ny);
        flat.push_back({dot(q, e), along});
        if (!(size > 0.1))
            return {};
        const double ax = -ny / size, ay = nx / size, off = ax * flat.back().across + ay * along; // across the line
        xx += ax * ax, xy += ax * ay, yy += ay * ay, bx += ax * off, by += ay * off;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-6))
        return {};
    const double radius = (yy * bx - xy * by) / determinant, height = (xx * by - xy * bx) / determinant;
    double tube = 0;
    for (const Flat& f : flat)
        tube += std::hypot(f.across - radius, f.along - height) / static_cast<double>(flat.size());
    if (!(radius > 0 && tube > 0))
        return {};
    return Primitive{Shape::Torus, on + axis * height, axis, radius, tube};
}

} // namespace

std::size_t startPoints(Shape shape) {
    switch (shape) {
    case Shape::Sphere:
        return 4;
    case Shape::Cylinder:
        return 2;
    case Shape::Torus:
        return 7;
    default:
        return 3;
    }
}

std::optional<Primitive> startFrom(Shape shape, Points points) {
    switch (shape) {
    case Shape::Plane:
        return plane(points);
    case Shape::Sphere:
        return sphere(points);
    case Shape::Cylinder:
        return cylinder(points);
    case Shape::Cone:
        return cone(points);
    default:
        return torus(points);
    }
}

} // namespace process
