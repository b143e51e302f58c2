// The demo session, app/demo.jsonl, as the strokes that a person would make: a ball of clay becomes the head of a
// friendly beast. A test compares the file with what is written here; POINTCLAY_WRITE_DEMO=FILE writes it anew.
//
// Unless a path says otherwise, rays come from the front: straight along -z, through (x, y).
#pragma once

#include "core/base/vec.h"

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace test {

inline double steady(double) {
    return 1;
}

/// One stroke in the making; call `along` last.
class DemoStroke {
  public:
    DemoStroke(const char* tool, double radius, double strength) {
        m_line["op"] = "stroke";
        m_line["tool"] = tool;
        m_line["radius"] = radius;
        m_line["strength"] = strength;
    }
    DemoStroke& inverted() { return set("invert", true); }
    DemoStroke& mirrored() { return set("symmetry", {"x"}); }
    DemoStroke& set(const char* key, nlohmann::ordered_json value) {
        m_line[key] = std::move(value);
        return *this;
    }
    /// The line of a stroke of `count` samples over path(0) to path(1) in the image plane of a viewer at `eye`'s side,
    /// with pressure(0) to pressure(1). `eye`: direction towards the viewer.
    std::string along(
        const std::function<base::Vec3d(double)>& path, int count,
        const std::function<double(double)>& pressure = [](double) { return 1; }, const base::Vec3d& eye = {0, 0, 1}) {
        auto& samples = m_line["samples"] = nlohmann::ordered_json::array();
        const base::Vec3d d = base::normalized(-eye);
        for (int k = 0; k < count; ++k) {
            const double t = count > 1 ? static_cast<double>(k) / (count - 1) : 0;
            const base::Vec3d o = path(t) - 4 * d;
            samples.push_back({short4(o.x), short4(o.y), short4(o.z), short4(d.x), short4(d.y), short4(d.z),
                               short4(pressure(t)), short4(0.02 * k)});
        }
        return m_line.dump() + "\n";
    }

  private:
    /// Four decimals, so that the file stays short and is the same from every mathematics library.
    static double short4(double x) { return std::round(x * 1e4) / 1e4 + 0.0; }
    nlohmann::ordered_json m_line;
};

inline base::Vec3d mix(const base::Vec3d& a, const base::Vec3d& b, double t) {
    return a * (1 - t) + b * t;
}

inline std::function<base::Vec3d(double)> segment(const base::Vec3d& a, const base::Vec3d& b) {
    return [a, b](double t) { return mix(a, b, t); };
}

/// `turns` times around `centre` in the image plane of the front.
inline std::function<base::Vec3d(double)> circle(const base::Vec3d& centre, double radius, double turns = 1) {
    return [=](double t) {
        const double angle = 6.283185307179586 * turns * t;
        return centre + base::Vec3d{radius * std::cos(angle), radius * std::sin(angle), 0};
    };
}

/// Through three places, as a parabola.
inline std::function<base::Vec3d(double)> arc(const base::Vec3d& a, const base::Vec3d& b, const base::Vec3d& c) {
    return [=](double t) { return mix(mix(a, 2 * b - 0.5 * (a + c), t), mix(2 * b - 0.5 * (a + c), c, t), t); };
}

/// Soft at both ends.
inline double swelling(double t) {
    return 0.25 + 0.75 * std::sin(3.141592653589793 * t);
}

inline std::string demoSession() {
    std::string out = "# A ball of clay becomes the head of a friendly beast, with every tool.\n"
                      "{\"op\":\"new\",\"sample\":\"sphere\",\"count\":60000}\n";
    const auto stroke = [](const char* tool, double radius, double strength) {
        return DemoStroke(tool, radius, strength);
    };
    out += "# the muzzle\n";
    out += stroke("draw", 0.55, 0.35).along(circle({0, -0.24, 0}, 0.12, 2), 40);
    out += stroke("draw", 0.4, 0.3).along(circle({0, -0.22, 0}, 0.1, 2), 30);
    out += "# ears, pulled out and up, and hollowed\n";
    out += stroke("grab", 0.45, 1)
               .mirrored()
               .set("plateau", 0.15)
               .along(arc({0.58, 0.62, 0}, {0.76, 0.86, 0}, {0.85, 1.12, 0}), 24);
    out += stroke("smooth", 0.3, 1).mirrored().along(circle({0.84, 1.1, 0.45}, 0.1, 3), 30, steady, {0.4, 1, 0.6});
    out +=
        stroke("draw", 0.17, 0.8).mirrored().inverted().along(segment({0.62, 0.74, 0}, {0.78, 1.02, 0}), 16, swelling);
    out += "# eye sockets and eyes\n";
    out += stroke("draw", 0.28, 0.5).mirrored().inverted().along(circle({0.37, 0.22, 0}, 0.07), 20);
    out += stroke("draw", 0.17, 0.45).mirrored().along(circle({0.36, 0.22, 0}, 0.07, 2), 36);
    out += stroke("draw", 0.07, 0.8).mirrored().inverted().along(circle({0.34, 0.22, 0}, 0.02), 16);
    out += "# brows\n";
    out += stroke("clay", 0.14, 0.9)
               .mirrored()
               .along(arc({0.13, 0.42, 0}, {0.36, 0.54, 0}, {0.64, 0.38, 0}), 30, swelling);
    out += "# nose, nostrils, mouth\n";
    out += stroke("clay", 0.16, 1).along(arc({-0.13, -0.02, 0}, {0, 0.03, 0}, {0.13, -0.02, 0}), 30);
    out += stroke("draw", 0.07, 0.9).mirrored().inverted().along(segment({0.06, -0.07, 0}, {0.11, -0.02, 0}), 14);
    out += stroke("draw", 0.08, 1).inverted().along(arc({-0.44, -0.2, 0}, {0, -0.4, 0}, {0.44, -0.2, 0}), 60, swelling);
    out += stroke("draw", 0.06, 0.8).inverted().along(segment({0, -0.14, 0}, {0, -0.38, 0}), 16);
    out += "# cheeks\n";
    out += stroke("draw", 0.3, 0.3).mirrored().along(circle({0.6, -0.18, 0}, 0.06), 16);
    out += stroke("smooth", 0.25, 0.6).mirrored().along(segment({0.5, -0.05, 0}, {0.72, -0.35, 0}), 20);
    return out;
}

} // namespace test
