// Seeded random numbers: the same sequence on every machine. The seed is always a parameter, never the clock.
#pragma once

#include "core/base/vec.h"

#include <cstdint>

namespace base {

/// SplitMix64 (Steele, Lea & Flood 2014): also the mixing function of hashes and of per-index randomness.
constexpr std::uint64_t mix(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

class Random {
  public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t next() {
        const std::uint64_t out = mix(m_state);
        m_state += 0x9e3779b97f4a7c15ULL;
        return out;
    }
    /// Uniform in [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }
    /// Uniform in [0, n). REQUIRES: n > 0.
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
    /// Standard normal distribution (Box & Muller 1958).
    double normal() {
        const double u = 1.0 - uniform(), v = uniform();
        return std::sqrt(-2.0 * std::log(u)) * std::cos(6.283185307179586 * v);
    }
    /// Uniform on the unit sphere (Archimedes: height and angle are uniform).
    Vec3d unitVector() {
        const double z = uniform(-1, 1), angle = uniform(0, 6.283185307179586), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

  private:
    std::uint64_t m_state;
};

} // namespace base
