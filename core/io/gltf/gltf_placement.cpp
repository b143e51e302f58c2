#include "core/io/gltf/gltf_placement.h"

#include "core/base/srgb.h"

#include <algorithm>
#include <cmath>

namespace io::gltf {

surfel::Colour srgbOf(const std::array<double, 4>& linear) {
    surfel::Colour out = 0;
    for (unsigned k = 0; k < 4; ++k) {
        const double v = std::isfinite(linear[k]) ? std::clamp(linear[k], 0.0, 1.0) : 0;
        out |= static_cast<surfel::Colour>((k < 3 ? base::srgbOf(v) : v) * 255 + 0.5) << (8 * k);
    }
    return out;
}

Placement placementOf(const json& node) {
    const auto numbers = [&](const char* key, auto values) {
        const json& given = member(node, key);
        for (std::size_t i = 0; given.is_array() && given.size() == values.size() && i < values.size(); ++i)
            values[i] = numberOf(given[i], values[i]);
        return values;
    };
    Placement out;
    if (member(node, "matrix").is_array()) {
        const auto m = numbers("matrix", std::array<double, 16>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                out.linear[r][c] = m[static_cast<std::size_t>(4 * c + r)];
        out.shift = {m[12], m[13], m[14]};
        return out;
    }
    const auto t = numbers("translation", std::array<double, 3>{0, 0, 0});
    const auto q = numbers("rotation", std::array<double, 4>{0, 0, 0, 1});
    const auto s = numbers("scale", std::array<double, 3>{1, 1, 1});
    const auto [x, y, z, w] = q;
    out.linear = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                   {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                   {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            out.linear[r][c] *= s[static_cast<std::size_t>(c)];
    out.shift = {t[0], t[1], t[2]};
    return out;
}

mesh::Polygons::Place PicturePlace::operator()(double u, double v) const {
    const double c = std::cos(turn), s = std::sin(turn), x = u * scale[0], y = v * scale[1];
    return {static_cast<float>(c * x + s * y + offset[0]),
            static_cast<float>(1 - (-s * x + c * y + offset[1]))}; // rows from top to bottom
}

} // namespace io::gltf
