// Polylines on the surface as OBJ text: `v` and `vn` for every point, then one `l`, which a closed one ends where it
// began. Numbers carry 17 digits, since such curves are traced in float64.
#pragma once

#include "core/base/vec.h"

#include <cstdio>
#include <string>
#include <vector>

namespace app {

constexpr int curveDigits = 17;

/// A Point has position and normal. `before`: vertices in the file so far; `origin` is added to positions.
template <class Point>
std::string objPolyline(const std::vector<Point>& points, bool closed, std::size_t before, const base::Vec3d& origin) {
    const auto row = [](const char* key, const base::Vec3d& v) {
        char text[100];
        std::snprintf(text, sizeof text, "%s %.*g %.*g %.*g\n", key, curveDigits, v.x, curveDigits, v.y, curveDigits,
                      v.z);
        return std::string(text);
    };
    std::string out;
    for (const Point& p : points)
        out += row("v", p.position + origin) + row("vn", p.normal);
    out += 'l';
    for (std::size_t i = 1; i <= points.size(); ++i)
        out += ' ' + std::to_string(before + i);
    if (closed)
        out += ' ' + std::to_string(before + 1);
    return out + '\n';
}

} // namespace app
