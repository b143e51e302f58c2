#include "core/render/shading/colour_map.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace render {

using base::Vec3d;

static surfel::Colour encoded(const Vec3d& linear) {
    const auto byte = [](double c) {
        c = std::clamp(c, 0.0, 1.0);
        c = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
        return static_cast<unsigned>(c * 255 + 0.5);
    };
    return surfel::rgba(byte(linear.x), byte(linear.y), byte(linear.z));
}

/// Magnitude, saturation and hue: polar coordinates of CIELAB around black (Moreland's section 4).
static surfel::Colour fromMsh(double m, double s, double h) {
    const double l = m * std::cos(s), a = m * std::sin(s) * std::cos(h), b = m * std::sin(s) * std::sin(h);
    const auto inverse = [](double t) { return t > 6.0 / 29 ? t * t * t : (t - 4.0 / 29) * 108 / 841; };
    const double fy = (l + 16) / 116;
    const double x = 0.9505 * inverse(fy + a / 500), y = inverse(fy), z = 1.089 * inverse(fy - b / 200);
    return encoded({3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
                    0.0557 * x - 0.2040 * y + 1.0570 * z});
}

/// From grey at 0 to a saturated end at 1; the hue of the grey turns away from the end's so that steps stay equal.
static surfel::Colour towards(double end, double t) {
    constexpr double m = 80, saturation = 1.08, grey = 88;
    const double spin = saturation * std::sqrt(grey * grey - m * m) / (m * std::sin(saturation));
    const double start = end > -std::numbers::pi / 3 ? end + spin : end - spin;
    return fromMsh(grey + (m - grey) * t, saturation * t, start + (end - start) * t);
}

static surfel::Colour diverging(double t) {
    constexpr double blue = -1.1, red = 0.5;
    return t < 0.5 ? towards(blue, 1 - 2 * t) : towards(red, 2 * t - 1);
}

static surfel::Colour sequential(double t) {
    constexpr double degree = std::numbers::pi / 180;
    const double lightness = 0.4 + 0.53 * t, hue = (272 - 168 * t) * degree, chroma = 0.112;
    const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);
    const auto cube = [](double v) { return v * v * v; };
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b),
                 m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b),
                 s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return encoded({4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                    -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s});
}

static surfel::Colour chosen(double t) {
    const Vec3d rest{0.5, 0.5, 0.51}, taken{0.87, 0.29, 0.03};
    return encoded(rest + (taken - rest) * t);
}

constexpr std::size_t steps = 1025; // odd: zero is one of them
using Table = std::array<surfel::Colour, steps>;

static Table tableOf(surfel::Colour (*map)(double)) {
    Table out;
    for (std::size_t i = 0; i < steps; ++i)
        out[i] = map(static_cast<double>(i) / (steps - 1));
    return out;
}

surfel::Colour mapped(ColourMap map, float t) {
    static const Table tables[] = {tableOf(diverging), tableOf(sequential), tableOf(chosen)};
    if (std::isnan(t))
        return unknownColour;
    const float place = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(steps - 1);
    return tables[static_cast<std::size_t>(map)][static_cast<std::size_t>(place + 0.5f)];
}

std::vector<double> ticks(const ColourScale& scale) {
    const double low = scale.low, high = scale.high, wanted = (high - low) / 8;
    const double power = std::pow(10, std::floor(std::log10(wanted)));
    const double factor = wanted / power, step = power * (factor > 5 ? 10 : factor > 2 ? 5 : factor > 1 ? 2 : 1);
    const double slack = 1e-6 * step; // the ends are floats
    std::vector<double> out;
    for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k)
        out.push_back(k == 0 ? 0 : k * step);
    return out;
}

std::string numberLabel(double value) {
    char text[32];
    const auto shorten = [&](int digits) {
        return std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr;
    };
    std::from_chars(text, shorten(4), value);
    return {text, shorten(7)}; // 13000, not 1.3e+04
}

} // namespace render
