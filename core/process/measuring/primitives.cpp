#include "core/process/measuring/primitives.h"

#include <cmath>

namespace process {

using base::Vec3d;

std::span<const ShapeRow> shapeTable() {
    static constexpr ShapeRow rows[] = {{"plane", Shape::Plane, 3},
                                        {"sphere", Shape::Sphere, 4},
                                        {"cylinder", Shape::Cylinder, 6},
                                        {"cone", Shape::Cone, 7},
                                        {"torus", Shape::Torus, 8}};
    return rows;
}

double Primitive::distance(const Vec3d& x) const {
    const Vec3d q = x - place;
    if (shape == Shape::Sphere)
        return length(q) - radius;
    const double along = dot(q, axis);
    if (shape == Shape::Plane)
        return along;
    const double across = length(q - axis * along);
    if (shape == Shape::Cylinder)
        return across - radius;
    if (shape == Shape::Torus)
        return std::hypot(across - radius, along) - tube;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    // behind the apex nothing is nearer than the apex itself
    return along * cosine + across * sine < 0 ? length(q) : across * cosine - along * sine;
}

} // namespace process
