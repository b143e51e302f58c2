// Float jets of order 1 and 2 in registers of four: value and first derivatives in one, the second derivatives by `sym`
// in two more, the last two lanes of which are zero. The same operations in the same order as number by number, hence
// the same bits; the compiler does not find them by itself (-fno-tree-slp-vectorize, CMakeLists.txt).
//
// Included by jet.h, whose operators come here where jets are such.
#pragma once

#include <cstring>
#include <type_traits>

namespace surface {

template <class T, int Order>
struct Jet;

template <class T, int Order>
constexpr bool inRegisters = std::is_same_v<T, float> && (Order == 1 || Order == 2);

/// The compiler's own vectors: single floats in one register, on every machine.
using Four = float __attribute__((vector_size(16)));

namespace jet_lanes {

template <int O>
constexpr std::size_t registers = O == 1 ? 1 : 3;

template <int O>
[[gnu::always_inline]] inline Four get(const Jet<float, O>& a, std::size_t i) {
    static_assert(sizeof(a) == sizeof(Four) * registers<O>);
    Four out;
    std::memcpy(&out, reinterpret_cast<const char*>(&a) + i * sizeof(Four), sizeof(Four));
    return out;
}
template <int O>
[[gnu::always_inline]] inline void put(Jet<float, O>& to, std::size_t i, Four value) {
    std::memcpy(reinterpret_cast<char*>(&to) + i * sizeof(Four), &value, sizeof(Four));
}
[[gnu::always_inline]] inline Four all(float value) {
    return Four{value, value, value, value};
}

/// Of the first register the derivatives d_k and d_l that belong to the second ones, d_kl, of register 1 or 2.
struct Pair {
    Four k, l;
};
template <std::size_t i>
[[gnu::always_inline]] inline Pair pairOf(Four first) {
    constexpr Four zero{};
    if constexpr (i == 1) // 00 01 02 11
        return {__builtin_shufflevector(first, first, 1, 1, 1, 2), __builtin_shufflevector(first, first, 1, 2, 3, 2)};
    else // 12 22
        return {__builtin_shufflevector(first, zero, 2, 3, 4, 4), __builtin_shufflevector(first, zero, 3, 3, 4, 4)};
}

template <int O>
[[gnu::always_inline]] inline Jet<float, O> add(const Jet<float, O>& a, const Jet<float, O>& b) {
    Jet<float, O> out;
    for (std::size_t i = 0; i < registers<O>; ++i)
        put(out, i, get(a, i) + get(b, i));
    return out;
}
template <int O>
[[gnu::always_inline]] inline Jet<float, O> subtract(const Jet<float, O>& a, const Jet<float, O>& b) {
    Jet<float, O> out;
    for (std::size_t i = 0; i < registers<O>; ++i)
        put(out, i, get(a, i) - get(b, i));
    return out;
}
template <int O>
[[gnu::always_inline]] inline Jet<float, O> scale(const Jet<float, O>& a, float s) {
    Jet<float, O> out;
    for (std::size_t i = 0; i < registers<O>; ++i)
        put(out, i, get(a, i) * all(s));
    return out;
}

template <std::size_t i, int O>
[[gnu::always_inline]] inline void multiplySecond(const Jet<float, O>& a, const Jet<float, O>& b, Jet<float, O>& out) {
    const Pair da = pairOf<i>(get(a, 0)), db = pairOf<i>(get(b, 0));
    put(out, i, get(a, i) * all(b.v) + da.k * db.l + da.l * db.k + all(a.v) * get(b, i));
}
template <int O>
[[gnu::always_inline]] inline Jet<float, O> multiply(const Jet<float, O>& a, const Jet<float, O>& b) {
    Jet<float, O> out;
    Four first = get(a, 0) * all(b.v) + all(a.v) * get(b, 0);
    first[0] = a.v * b.v;
    put(out, 0, first);
    if constexpr (O == 2) {
        multiplySecond<1>(a, b, out);
        multiplySecond<2>(a, b, out);
    }
    return out;
}

template <std::size_t i, int O>
[[gnu::always_inline]] inline void chainSecond(const Jet<float, O>& a, float f1, float f2, Jet<float, O>& out) {
    const Pair d = pairOf<i>(get(a, 0));
    put(out, i, all(f1) * get(a, i) + all(f2) * d.k * d.l);
}
template <int O>
[[gnu::always_inline]] inline Jet<float, O> chain(const Jet<float, O>& a, float f0, float f1,
                                                  [[maybe_unused]] float f2) {
    Jet<float, O> out;
    Four first = all(f1) * get(a, 0);
    first[0] = f0;
    put(out, 0, first);
    if constexpr (O == 2) {
        chainSecond<1>(a, f1, f2, out);
        chainSecond<2>(a, f1, f2, out);
    }
    return out;
}

/// A jet with value v, derivatives d and second derivatives from two registers.
template <int O>
[[gnu::always_inline]] inline Jet<float, O> jet(Four first, [[maybe_unused]] Four second = Four{},
                                                [[maybe_unused]] Four third = Four{}) {
    Jet<float, O> out;
    put(out, 0, first);
    if constexpr (O == 2) {
        put(out, 1, second);
        put(out, 2, third);
    }
    return out;
}

template <int O>
[[gnu::always_inline]] inline Jet<float, O> timesCoordinate(int axis, const Jet<float, O>& a) {
    Four slope{};
    slope[axis + 1] = a.v;
    if constexpr (O == 1)
        return jet<O>(slope);
    else if (axis == 0)
        return jet<O>(slope, Four{2 * a.d[0], a.d[1], a.d[2], 0});
    else if (axis == 1)
        return jet<O>(slope, Four{0, a.d[0], 0, 2 * a.d[1]}, Four{a.d[2], 0, 0, 0});
    else
        return jet<O>(slope, Four{0, 0, a.d[0], 0}, Four{a.d[1], 2 * a.d[2], 0, 0});
}

} // namespace jet_lanes

} // namespace surface
