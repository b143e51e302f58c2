// What sums over the surfels of one sheet tell of it: plane, height and how much like one sheet they are. Jets in x, as
// all of it moves. Internal to the room.
#pragma once

#include "core/surface/evaluation/moving_sums.h"

namespace surface {

template <class T, int O>
struct SolidSheet {
    JetVec<T, O> n, c;        ///< unit normal, zero where normals cancel; centroid relative to where x is
    Jet<T, O> weight, height; ///< sum theta; f, above zero outside
    Jet<T, O> agreementSq;    ///< (|m|/w)^2

    SolidSheet() = default;
    /// REQUIRES: sums of some weight.
    explicit SolidSheet(const Moments<T, O>& m) : weight(m.one) {
        const Jet<T, O> inverseWeight = inverse(m.one), square = dot(m.n, m.n);
        agreementSq = square * inverseWeight * inverseWeight;
        if (agreementSq.v > T(cancelled))
            n = m.n * inverseSqrt(square);
        c = m.q * inverseWeight;
        height = movingHeight(m) * inverseWeight;
    }

    /// f = plain n.(x - c) + (1 - plain) sum theta n_i.(x - p_i) / w
    void mixPlane(const Jet<T, O>& plain) {
        JetVec<T, O> d; // x - c
        for (std::size_t a = 0; a < 3; ++a)
            d[a] = coordinate<T, O>(int(a)) - c[a];
        height += plain * (dot(n, d) - height);
    }

    /// Variance of what is summed, along n. REQUIRES: products of offsets were summed.
    Jet<T, O> thicknessSq(const Moments<T, O>& m) const {
        const Jet<T, O> inverseWeight = inverse(m.one);
        Jet<T, O> out;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                out += n[a] * n[b] * (m.outer[sym(int(a), int(b))] * inverseWeight - c[a] * c[b]);
        return out;
    }

    /// The centroid on supports `wider` times as wide: its way from x along the sheet, as at a boundary, is as much
    /// longer.
    JetVec<T, O> centroidOn(T wider) const {
        JetVec<T, O> way, out = c;
        for (std::size_t k = 0; k < 3; ++k)
            way[k] = c[k] - coordinate<T, O>(int(k));
        const Jet<T, O> across = dot(n, way);
        for (std::size_t k = 0; k < 3; ++k)
            out[k] += (way[k] - n[k] * across) * (wider - T(1));
        return out;
    }

  private:
    static constexpr double cancelled = 1e-10; ///< of agreementSq: far below where n has a share in f
};

} // namespace surface
