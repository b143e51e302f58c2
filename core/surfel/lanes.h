// Eight floats at once with the few operations that bounds need. SSE2, which every x86-64 has, else plain loops: the
// operations are exact, so both give the same bits.
//
// Written out because plain loops of eight are unrolled before they could be vectorised (and the pass that would still
// do it is off, see CMakeLists).
#pragma once

#include <algorithm>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace surfel {

constexpr int laneCount = 8;

#ifdef __SSE2__

struct Lanes {
    __m128 low, high;

    Lanes(float all) : low(_mm_set1_ps(all)), high(low) {}
    Lanes(__m128 a, __m128 b) : low(a), high(b) {}
    /// REQUIRES: 16-byte alignment.
    static Lanes load(const float* from) { return {_mm_load_ps(from), _mm_load_ps(from + 4)}; }
    void store(float* to) const { _mm_storeu_ps(to, low), _mm_storeu_ps(to + 4, high); }
};

inline Lanes operator+(const Lanes& a, const Lanes& b) {
    return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)};
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
    return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)};
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
    return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)};
}
inline Lanes max(const Lanes& a, const Lanes& b) {
    return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}
inline Lanes min(const Lanes& a, const Lanes& b) {
    return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}
/// Bit i where a[i] < b[i].
inline unsigned less(const Lanes& a, const Lanes& b) {
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(a.low, b.low)) |
                                 _mm_movemask_ps(_mm_cmplt_ps(a.high, b.high)) << 4);
}
/// Bit i where a[i] <= b[i].
inline unsigned lessOrEqual(const Lanes& a, const Lanes& b) {
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(a.low, b.low)) |
                                 _mm_movemask_ps(_mm_cmple_ps(a.high, b.high)) << 4);
}

#else

struct Lanes {
    float v[laneCount];

    Lanes() = default;
    Lanes(float all) { std::fill_n(v, laneCount, all); }
    static Lanes load(const float* from) {
        Lanes out;
        std::copy_n(from, laneCount, out.v);
        return out;
    }
    void store(float* to) const { std::copy_n(v, laneCount, to); }
    template <class Fn>
    static Lanes each(const Lanes& a, const Lanes& b, const Fn& fn) {
        Lanes out;
        for (int i = 0; i < laneCount; ++i)
            out.v[i] = fn(a.v[i], b.v[i]);
        return out;
    }
};

inline Lanes operator+(const Lanes& a, const Lanes& b) {
    return Lanes::each(a, b, [](float x, float y) { return x + y; });
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
    return Lanes::each(a, b, [](float x, float y) { return x - y; });
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
    return Lanes::each(a, b, [](float x, float y) { return x * y; });
}
inline Lanes max(const Lanes& a, const Lanes& b) {
    return Lanes::each(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Lanes min(const Lanes& a, const Lanes& b) {
    return Lanes::each(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline unsigned less(const Lanes& a, const Lanes& b) {
    unsigned mask = 0;
    for (int i = 0; i < laneCount; ++i)
        mask |= a.v[i] < b.v[i] ? 1u << i : 0u;
    return mask;
}
inline unsigned lessOrEqual(const Lanes& a, const Lanes& b) {
    unsigned mask = 0;
    for (int i = 0; i < laneCount; ++i)
        mask |= a.v[i] <= b.v[i] ? 1u << i : 0u;
    return mask;
}

#endif

} // namespace surfel
