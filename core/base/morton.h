// Morton codes: the bits of three coordinates in turn, so that cells with close codes are close in space (Morton 1966).
// 21 bits an axis; x has the lowest bit of each three.
#pragma once

#include <cstdint>

namespace base {

constexpr int mortonBits = 21;

namespace detail {

/// Moves bit i to bit 3 i.
constexpr std::uint64_t spreadBits(std::uint64_t v) {
    v = (v | v << 32) & 0x001f00000000ffffULL;
    v = (v | v << 16) & 0x001f0000ff0000ffULL;
    v = (v | v << 8) & 0x100f00f00f00f00fULL;
    v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
    return (v | v << 2) & 0x1249249249249249ULL;
}

/// Moves bit 3 i to bit i and drops the others.
constexpr std::uint32_t gatherBits(std::uint64_t v) {
    v &= 0x1249249249249249ULL;
    v = (v | v >> 2) & 0x10c30c30c30c30c3ULL;
    v = (v | v >> 4) & 0x100f00f00f00f00fULL;
    v = (v | v >> 8) & 0x001f0000ff0000ffULL;
    v = (v | v >> 16) & 0x001f00000000ffffULL;
    v = (v | v >> 32) & 0x00000000001fffffULL;
    return static_cast<std::uint32_t>(v);
}

} // namespace detail

/// REQUIRES: coordinates below 2^21.
constexpr std::uint64_t mortonCode(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return detail::spreadBits(x) | detail::spreadBits(y) << 1 | detail::spreadBits(z) << 2;
}

/// Coordinate `axis`, 0 to 2, of a code.
constexpr std::uint32_t mortonCoordinate(std::uint64_t code, int axis) {
    return detail::gatherBits(code >> axis);
}

} // namespace base
