#include "core/sculpt/tools/elastic_grab.h"

#include "core/sculpt/tools/deform.h"
#include "core/sculpt/tools/gather_in.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

/// Weight of the falloff from which nothing is taken away.
constexpr float wholeFrom = 0.25f;

constexpr ToolParameter parameters[] = {
    {"softness", "Softness", "radii", "Size of what is held; the rest of the brush gives way.", 0.6, 0.3, 1.0},
    {"volume", "Keep volume", "", "Poisson ratio of the material: at 0.5 it keeps its volume.", 0.45, 0.0, 0.5},
};

namespace {

/// One regularised Kelvinlet, its coefficients already divided by what the sum is at the centre.
struct Scale {
    float radiusSq, one, two, cube; ///< E^2; (a - b), b, a/2 E^2, all weighted
};

struct Kelvinlet {
    Scale scales[3];

    Kelvinlet(float e, float poisson) {
        const double a = 1, b = a / (4 * (1 - double(poisson)));
        const double radius[3] = {double(e), 1.1 * double(e), 1.21 * double(e)};
        const double q[3] = {radius[0] * radius[0], radius[1] * radius[1], radius[2] * radius[2]};
        const double share[3] = {1, -(q[2] - q[0]) / (q[2] - q[1]), (q[1] - q[0]) / (q[2] - q[1])};
        double centre = 0;
        for (int k = 0; k < 3; ++k)
            centre += share[k] * (1.5 * a - b) / radius[k];
        for (int k = 0; k < 3; ++k) {
            const double s = share[k] / centre;
            scales[k] = {float(q[k]), float(s * (a - b)), float(s * b), float(s * a / 2 * q[k])};
        }
    }

    /// u = A m + B (d.m) d with A, B and their derivatives over |d|^2 / 2.
    void at(float distSq, float& A, float& B, float& dA, float& dB) const {
        A = B = dA = dB = 0;
        for (const Scale& s : scales) {
            const float inverse = 1 / std::sqrt(distSq + s.radiusSq), square = inverse * inverse,
                        cube = inverse * square;
            A += s.one * inverse + s.cube * cube;
            B += s.two * cube;
            dA -= s.one * cube + 3 * s.cube * cube * square;
            dB -= 3 * s.two * cube * square;
        }
    }
};

} // namespace

static tree::Edit elasticGrab(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    if (dab.move * dab.strength == base::Vec3f{})
        return {};
    const float grip = foldBrake(version, dab);
    const base::Vec3f m = dab.move * (std::abs(dab.strength) * grip);
    if (grip == 0)
        return {};
    const Kelvinlet kelvinlet(dab.parameter("softness") * dab.radius, dab.parameter("volume"));
    return deform(version.tree(), brush, [&](const LanePlace&, const BrushLanes& at, ShiftLanes& out) {
        alignas(64) float weight[lanes], gradient[lanes], A[lanes], B[lanes], dA[lanes], dB[lanes], along[lanes];
        brush.fade(at, weight, gradient);
        const float* d[3] = {at.x, at.y, at.z};
        for (std::size_t i = 0; i < lanes; ++i) {
            kelvinlet.at(at.x[i] * at.x[i] + at.y[i] * at.y[i] + at.z[i] * at.z[i], A[i], B[i], dA[i], dB[i]);
            along[i] = at.x[i] * m.x + at.y[i] * m.y + at.z[i] * m.z;
            const float t = std::min(1.0f, weight[i] / wholeFrom);
            gradient[i] *= 6 * t * (1 - t) / wholeFrom; // of the cut c
            weight[i] = t * t * (3 - 2 * t);
        }
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t i = 0; i < lanes; ++i) {
                const float u = A[i] * m[a] + B[i] * along[i] * d[a][i];
                const float slope = dA[i] * m[a] + dB[i] * along[i] * d[a][i];
                out.d[a][i] = weight[i] * u;
                for (std::size_t b = 0; b < 3; ++b)
                    out.j[a][b][i] = gradient[i] * u * d[b][i] + weight[i] * (slope * d[b][i] + B[i] * m[b] * d[a][i] +
                                                                              (a == b ? B[i] * along[i] : 0.0f));
            }
    });
}

const ToolRow elasticGrabTool{"elastic-grab",
                              "Elastic Grab",
                              "icons/tool-elastic-grab.svg",
                              "",
                              "Pulls the surface as if it were part of an elastic solid.",
                              Motion::Drag,
                              1.0,
                              parameters,
                              elasticGrab};

} // namespace sculpt
