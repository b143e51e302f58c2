// Between nine samples: what a picture interpolates, and how far the prediction from the corners is off
// (raycast/README 2.2 and 2.5).
//
//     0 1 2      the corners of a cell are 0, 2, 6, 8; the others are what its split asked for
//     3 4 5
//     6 7 8
//
// What is interpolated: the even depth of ViewLens, which is exact for planes, and the normal turned against the ray.
#pragma once

#include "core/raycast/view_lens.h"
#include "core/surface/definition.h"

#include <array>

namespace raycast {

/// What a sample contributes to the interpolation.
struct Knot {
    enum : std::size_t { Depth, NormalX, NormalY, NormalZ, Unit, Agreement, Red, Green, Blue, Mask, Count = 12 };

    std::array<float, Count> v{};
    bool hit = false;
    bool behind = false; ///< the ray meets the side that the frame's normals point away from

    base::Vec3f normal() const { return {v[NormalX], v[NormalY], v[NormalZ]}; }

    /// `stretch` is the lens' at the pixel of the sample.
    static Knot of(const Sample& s, const ViewLens& lens, double stretch) {
        Knot out;
        out.hit = s.hit.hit;
        if (!out.hit)
            return out;
        const base::Vec3f& n = s.hit.normal;
        out.behind = dot(n, s.hit.outward) < 0;
        out.v = {static_cast<float>(lens.evenDepth(static_cast<double>(s.hit.t) / stretch)),
                 n.x,
                 n.y,
                 n.z,
                 s.hit.unit,
                 s.hit.agreement,
                 static_cast<float>(s.colour & 255u),
                 static_cast<float>(s.colour >> 8 & 255u),
                 static_cast<float>(s.colour >> 16 & 255u),
                 s.mask,
                 0,
                 0};
        return out;
    }
};

/// A sample of a pixel from interpolated values; with the opaque colour where the model has colours.
inline Sample sampleOf(const std::array<float, Knot::Count>& v, bool behind, int column, int row, const ViewLens& lens,
                       bool attributes) {
    Sample out;
    const auto even = static_cast<double>(v[Knot::Depth]);
    const double depth = lens.parallel() ? even : 1 / even;
    out.hit.hit = true;
    out.hit.t = static_cast<float>(depth * lens.stretch(column, row));
    out.hit.position = base::cast<float>(lens.at(column, row, depth));
    out.hit.normal = normalized(base::Vec3f{v[Knot::NormalX], v[Knot::NormalY], v[Knot::NormalZ]});
    out.hit.outward = behind ? -out.hit.normal : out.hit.normal;
    out.hit.unit = v[Knot::Unit];
    out.hit.agreement = v[Knot::Agreement];
    if (attributes) {
        const auto byte = [](float c) { return static_cast<unsigned>(std::clamp(c, 0.0f, 255.0f) + 0.5f); };
        out.colour = surfel::rgba(byte(v[Knot::Red]), byte(v[Knot::Green]), byte(v[Knot::Blue]));
        out.mask = std::clamp(v[Knot::Mask], 0.0f, 1.0f);
    }
    return out;
}

/// Lagrange's weights of three samples at 0, 1/2 and 1.
inline std::array<float, 3> quadraticWeights(float u) {
    return {(2 * u - 1) * (u - 1), 4 * u * (1 - u), u * (2 * u - 1)};
}

/// Nine samples `half` pixels apart, all of them hits.
struct Patch {
    std::array<Knot, 9> knots;

    /// The biquadratic through the samples along one row, ready for any column.
    struct Row {
        std::array<std::array<float, Knot::Count>, 3> columns;

        std::array<float, Knot::Count> at(float u) const {
            const auto w = quadraticWeights(u);
            std::array<float, Knot::Count> out;
            for (std::size_t k = 0; k < Knot::Count; ++k)
                out[k] = w[0] * columns[0][k] + w[1] * columns[1][k] + w[2] * columns[2][k];
            return out;
        }
    };
    Row row(float v) const {
        const auto w = quadraticWeights(v);
        Row out;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < Knot::Count; ++k)
                out.columns[i][k] = w[0] * knots[i].v[k] + w[1] * knots[3 + i].v[k] + w[2] * knots[6 + i].v[k];
        return out;
    }
};

/// What a model's samples carry, as far as it decides about interpolation.
struct PatchKind {
    bool oriented = false;   ///< a sample in front and one from behind are not of one piece
    bool attributes = false; ///< colours or masks count
    float spacingOfUnit = static_cast<float>(surface::spacingOfUnit);
};

/// A leaf shows the biquadratic of the split that it comes from where the bilinear prediction was off by this much at
/// most: the leaf is off by an eighth of that, unless the surface bends between the samples.
inline bool goodFor(float error, double quality) {
    return error <= 2.5f * static_cast<float>(quality);
}

/// How far the bilinear prediction from the corners is from the five other samples, in units of what quality 1 aims at:
/// 2 degrees, 0.2 spacings along the ray, and 8 of 255 steps of a colour. Infinite where any sample is a miss.
/// `stretch` is the lens' for each of the nine.
float predictionError(const Patch& patch, const std::array<double, 9>& stretch, const ViewLens& lens, PatchKind kind);

} // namespace raycast
