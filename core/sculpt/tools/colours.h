// Colours as bytes that tools mix.
#pragma once

#include "core/sculpt/tool.h"

#include <bit>
#include <cmath>

namespace sculpt {

inline std::uint32_t hashed(const base::Vec3f& p, std::uint32_t seed) {
    std::uint32_t h = seed * 0x9e3779b9u;
    for (const float c : {p.x, p.y, p.z}) {
        h = (h ^ std::bit_cast<std::uint32_t>(c)) * 0x85ebca6bu;
        h ^= h >> 13;
    }
    return h;
}

/// What a dab rounds by: its place and its number in the stroke, so that no two dabs round a surfel alike.
inline std::uint32_t roundingSeed(const Dab& dab) {
    return hashed(dab.centre, static_cast<std::uint32_t>(dab.past.size()));
}

/// Threshold in [0, 1) that a place rounds by: of bits alone, so that it is the same on any machine.
inline float roundingAt(const base::Vec3f& p, std::uint32_t seed, unsigned channel) {
    std::uint32_t h = hashed(p, seed + channel);
    h *= 0xc2b2ae35u;
    h ^= h >> 16;
    return static_cast<float>(h >> 8) * 0x1p-24f;
}

/// `from` moved by `part` (0 to 1) towards `to`; alpha goes along.
inline surfel::Colour mixed(surfel::Colour from, surfel::Colour to, float part, const base::Vec3f& place,
                            std::uint32_t seed) {
    surfel::Colour out = 0;
    for (unsigned c = 0; c < 4; ++c) {
        const float a = static_cast<float>(from >> (8 * c) & 255u), b = static_cast<float>(to >> (8 * c) & 255u);
        const float exact = a + (b - a) * part, below = std::floor(exact);
        const float value = exact - below > roundingAt(place, seed, c) ? below + 1 : below;
        out |= static_cast<surfel::Colour>(value) << (8 * c);
    }
    return out;
}

/// A tool parameter 0xRRGGBB as a colour.
inline surfel::Colour colourOf(double rgb) {
    const auto value = static_cast<std::uint32_t>(rgb);
    return surfel::rgba(value >> 16 & 255u, value >> 8 & 255u, value & 255u);
}

} // namespace sculpt
