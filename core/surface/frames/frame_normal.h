// Normals of frames with their derivatives (surface/README 6.2): normalised sums and eigenvectors of symmetric
// matrices.
#pragma once

#include "core/surface/evaluation/jet.h"
#include "core/surface/surface.h"

#include <algorithm>

namespace surface {

template <class T, int O>
struct FrameNormal {
    JetVec<T, O> n{};
    bool valid = false;
    Cause cause = Cause::ClosedGap; ///< why it is not valid
};

/// m / |m|. REQUIRES for `valid`: |m| > 0.
template <class T, int O>
FrameNormal<T, O> normalisedSum(const JetVec<T, O>& m) {
    const Jet<T, O> square = dot(m, m);
    if (!(square.v > T(0)))
        return {{}, false, Cause::CancellingNormals};
    return {m * inverseSqrt(square), true, Cause::None};
}

enum class Pick { Smallest, Largest };
/// What the matrix's eigenvalues are: what the tests of degeneracy compare, or its squares (those of J J^T).
enum class Eigenvalues { Plain, Squares };

/// l1/l2 below which points count as collinear, and l1 - l0 and l2 - l1 in l2 below which an eigenvector is not told
/// from the next (surface/README 2.5).
constexpr double collinearBelow = 1e-2, leastGap = 1e-3, leastGapOfLargest = 0.1;

namespace detail {

template <class T>
base::Mat3<T> matrixOf(const T* s) {
    return {{{s[0], s[1], s[2]}, {s[1], s[3], s[4]}, {s[2], s[4], s[5]}}};
}

/// Derivative of the matrix by x_k, or its second derivative by x_k and x_l, or itself.
template <class T, int O>
base::Mat3<T> valueMatrix(const Jet<T, O>* s) {
    const T v[6] = {s[0].v, s[1].v, s[2].v, s[3].v, s[4].v, s[5].v};
    return matrixOf(v);
}
template <class T, int O>
base::Mat3<T> firstMatrix(const Jet<T, O>* s, int k) {
    const std::size_t i = static_cast<std::size_t>(k);
    const T v[6] = {s[0].d[i], s[1].d[i], s[2].d[i], s[3].d[i], s[4].d[i], s[5].d[i]};
    return matrixOf(v);
}
template <class T, int O>
base::Mat3<T> secondMatrix(const Jet<T, O>* s, int k, int l) {
    const std::size_t i = static_cast<std::size_t>(sym(k, l));
    const T v[6] = {s[0].dd[i], s[1].dd[i], s[2].dd[i], s[3].dd[i], s[4].dd[i], s[5].dd[i]};
    return matrixOf(v);
}

/// On ascending eigenvalues: is the picked direction alone, and are the samples not all on a
/// line? None where it is.
template <class T>
Cause degeneracy(const T (&l)[3], Pick pick) {
    if (!(l[2] > T(0)))
        return Cause::Coincident;
    if (pick == Pick::Largest)
        return l[2] - l[1] >= T(leastGapOfLargest) * l[2] ? Cause::None : Cause::ClosedGap;
    if (!(l[1] >= T(collinearBelow) * l[2]))
        return Cause::Collinear;
    return l[1] - l[0] >= T(leastGap) * l[2] ? Cause::None : Cause::ClosedGap;
}

template <class T>
Cause degeneracy(const base::SymmetricEigen<T>& eigen, Pick pick, Eigenvalues values) {
    T l[3];
    for (int i = 0; i < 3; ++i)
        l[i] = values == Eigenvalues::Plain ? eigen.value[i] : std::sqrt(std::max(eigen.value[i], T(0)));
    return degeneracy(l, pick);
}

} // namespace detail

/// Unit eigenvector of a symmetric matrix of jets (6 entries by `sym`), its sign arbitrary. With G = sum over the
/// other eigenpairs of v v^T / (l0 - l): n_k = G S_k n; n_kl = G[S_kl n + (S_k - l_k) n_l + (S_l - l_l) n_k]
/// - (n_k.n_l) n.
template <class T, int O>
FrameNormal<T, O> eigenvector(const Jet<T, O>* s, Pick pick, Eigenvalues values = Eigenvalues::Plain) {
    using base::Mat3, base::Vec3;
    const base::SymmetricEigen<T> eigen = base::symmetricEigen(detail::valueMatrix(s));
    FrameNormal<T, O> out;
    out.cause = detail::degeneracy(eigen, pick, values);
    out.valid = out.cause == Cause::None;
    if (!out.valid)
        return out;
    const int chosen = pick == Pick::Smallest ? 0 : 2;
    const Vec3<T> n = eigen.vector[chosen];
    for (std::size_t a = 0; a < 3; ++a)
        out.n[a].v = n[a];
    if constexpr (O >= 1) {
        Mat3<T> g;
        for (int j = 0; j < 3; ++j)
            if (j != chosen)
                g += outer(eigen.vector[j], eigen.vector[j]) * (T(1) / (eigen.value[chosen] - eigen.value[j]));
        Vec3<T> sn[3], first[3];
        for (int k = 0; k < 3; ++k) {
            sn[k] = detail::firstMatrix(s, k) * n;
            first[k] = g * sn[k];
            for (std::size_t a = 0; a < 3; ++a)
                out.n[a].d[static_cast<std::size_t>(k)] = first[k][a];
        }
        if constexpr (O >= 2)
            for (int k = 0; k < 3; ++k)
                for (int l = k; l < 3; ++l) {
                    const Vec3<T> inner = detail::secondMatrix(s, k, l) * n + detail::firstMatrix(s, k) * first[l] -
                                          first[l] * dot(n, sn[k]) + detail::firstMatrix(s, l) * first[k] -
                                          first[k] * dot(n, sn[l]);
                    const Vec3<T> second = g * inner - n * dot(first[k], first[l]);
                    for (std::size_t a = 0; a < 3; ++a)
                        out.n[a].dd[static_cast<std::size_t>(sym(k, l))] = second[a];
                }
    }
    return out;
}

} // namespace surface
