#include "ui/work/ruler_table.h"

#include "core/base/error.h"
#include "core/process/measuring/thickness.h"

#include <charconv>
#include <cmath>
#include <numbers>

namespace ui {

using base::Vec3d;
using Places = std::span<const RuledPlace>;

namespace {

constexpr double degree = std::numbers::pi / 180;

std::string digits(double value, int count) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, count).ptr};
}

double between(const Vec3d& a, const Vec3d& b) {
    return std::atan2(length(cross(a, b)), dot(a, b)) / degree;
}

Ruled place(const surface::Surface&, Places at, const Vec3d& origin, const base::Progress&) {
    const Vec3d x = at[0].position + origin;
    Ruled out;
    out.value = std::numeric_limits<double>::quiet_NaN();
    out.line = {at[0].position};
    out.text = digits(x.x, 8) + ", " + digits(x.y, 8) + ", " + digits(x.z, 8);
    return out;
}

Ruled straight(const surface::Surface&, Places at, const Vec3d&, const base::Progress&) {
    const Vec3d d = at[1].position - at[0].position;
    return {length(d),
            false,
            {at[0].position, at[1].position},
            "along x " + digits(d.x, 5) + ", y " + digits(d.y, 5) + ", z " + digits(d.z, 5)};
}

Ruled along(const surface::Surface& surface, Places at, const Vec3d&, const base::Progress& progress) {
    const process::Geodesic way = process::geodesic(surface, at[0].position, at[1].position, progress);
    Ruled out;
    out.value = way.length;
    for (const process::GeodesicPoint& each : way.points)
        out.line.push_back(each.position);
    out.text = "straight " + digits(distance(at[0].position, at[1].position), 5);
    return out;
}

Ruled angle(const surface::Surface&, Places at, const Vec3d&, const base::Progress&) {
    const Vec3d a = at[0].position - at[1].position, b = at[2].position - at[1].position;
    if (!(length(a) > 0) || !(length(b) > 0))
        throw base::Error("there is no angle where two of its places are one", {}, "pick three places");
    return {between(a, b), true, {at[0].position, at[1].position, at[2].position}, {}};
}

Ruled slopes(const surface::Surface&, Places at, const Vec3d&, const base::Progress&) {
    return {between(at[0].normal, at[1].normal), true, {at[0].position, at[1].position}, {}};
}

Ruled thickness(const surface::Surface& surface, Places at, const Vec3d&, const base::Progress&) {
    const process::ThicknessAt found = process::thicknessAt(surface, at[0].position);
    Ruled out;
    out.value = found.thickness;
    out.line = {found.foot.position};
    if (std::isfinite(found.thickness))
        out.line.push_back(found.opposite), out.text = "its sides lean by " + digits(found.leanRad / degree, 3) + "°";
    else
        out.text = "nothing is opposite";
    return out;
}

constexpr RulerRow rows[] = {
    {"distance", "Distance", "Straight from one place to another", 2, straight},
    {"along", "Along the Surface", "The shortest way on the surface from one place to another", 2, along},
    {"angle", "Angle", "At the second of three places", 3, angle},
    {"slopes", "Between Faces", "The angle between the surface's normals at two places", 2, slopes},
    {"thickness", "Thickness", "From a place straight through to the other side", 1, thickness},
    {"place", "Place", "The coordinates of a place on the surface", 1, place},
};

} // namespace

std::span<const RulerRow> rulerTable() {
    return rows;
}

std::string textOf(const Ruled& ruled) {
    if (std::isnan(ruled.value))
        return ruled.text;
    return digits(ruled.value, 5) + (ruled.degrees ? "°" : "");
}

} // namespace ui
