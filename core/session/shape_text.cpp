#include "core/session/shape_text.h"

#include "core/session/place_text.h"

#include <numbers>
#include <sstream>

namespace session {

/// To a ten-thousandth.
static std::string directionText(const base::Vec3d& v) {
    std::ostringstream out;
    out.precision(4);
    const char* between = "";
    for (const double each : {v.x, v.y, v.z})
        out << std::exchange(between, " ") << (std::abs(each) < 5e-5 ? 0.0 : std::round(1e4 * each) / 1e4);
    return out.str();
}

std::string sentenceOf(const process::DetectedShape& shape, const base::Vec3d& origin, double size) {
    const process::Primitive& p = shape.primitive;
    const std::string place = placeText(p.place + origin, size / 100);
    std::ostringstream out;
    out.precision(5);
    out << process::shapeTable()[static_cast<std::size_t>(p.shape)].id << " of " << shape.points << " points";
    switch (p.shape) {
    case process::Shape::Plane:
        out << " at " << place << " across " << directionText(p.axis);
        break;
    case process::Shape::Sphere:
        out << " about " << place << ", radius " << p.radius;
        break;
    case process::Shape::Cylinder:
        out << " about " << place << " along " << directionText(p.axis) << ", radius " << p.radius;
        break;
    case process::Shape::Cone:
        out << " from " << place << " along " << directionText(p.axis) << ", " << 180 / std::numbers::pi * p.angle
            << " degrees to its axis";
        break;
    default:
        out << " about " << place << " along " << directionText(p.axis) << ", radius " << p.radius << ", tube "
            << p.tube;
    }
    out << ", rms " << shape.rms;
    return out.str();
}

} // namespace session
