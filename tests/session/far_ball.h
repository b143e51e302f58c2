// A ball as file, in coordinates as far from zero as a test wants.
#pragma once

#include "workbench.h"

#include <cmath>
#include <sstream>

namespace test {

/// 2000 points of radius 1 about (offset, -offset, 0), red above, `quality` their numbers.
inline json openBall(Workbench& bench, double offset) {
    std::ostringstream out;
    out.precision(14);
    out << "ply\nformat ascii 1.0\nelement vertex 2000\nproperty double x\nproperty double y\nproperty double z\n"
           "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\nend_header\n";
    for (int i = 0; i < 2000; ++i) {
        const double z = 1 - (2 * i + 1.0) / 2000, r = std::sqrt(1 - z * z), a = i * 2.399963229728653;
        out << r * std::cos(a) + offset << ' ' << r * std::sin(a) - offset << ' ' << z << ' ' << (z > 0 ? 255 : 0)
            << " 0 0 " << i << '\n';
    }
    return {{"op", "open"}, {"path", test::write(bench.path("ball.ply"), out.str()).string()}};
}

inline json parsed(const char* text) {
    return json::parse(text);
}

} // namespace test
