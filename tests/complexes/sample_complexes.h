// The sample complexes as models.
#pragma once

#include "core/complexes/complex.h"
#include "core/process/estimation/prepare.h"
#include "core/process/samples/samples.h"

namespace complex_models {

inline surface::Surface surfaceOf(const char* id, std::size_t count) {
    const process::SampleRow& row = process::sample(id);
    process::PrepareOptions options;
    options.definition = process::definitionOf(row, count);
    return process::prepare(row.make(count, 1), options);
}

inline complexes::Complex complexOf(const char* id, std::size_t count) {
    return *complexes::Complex::of(surfaceOf(id, count));
}

/// The triangles of an icosahedron as it is sampled, from its points: three corners of each patch.
inline std::vector<std::array<base::Vec3d, 3>> facesOf(const complexes::Complex& complex) {
    std::vector<std::array<base::Vec3d, 3>> out;
    for (const complexes::Cell& cell : complex.cells())
        if (cell.dimension == 2 && cell.sharedEnds.size() == 3)
            out.push_back({complex.place(cell.sharedEnds[0]), complex.place(cell.sharedEnds[1]),
                           complex.place(cell.sharedEnds[2])});
    return out;
}

/// Of a triangle the point nearest to x.
inline base::Vec3d nearestIn(const std::array<base::Vec3d, 3>& t, const base::Vec3d& x) {
    const base::Vec3d n = normalized(cross(t[1] - t[0], t[2] - t[0]));
    const base::Vec3d inPlane = x - n * dot(x - t[0], n);
    bool inside = true;
    base::Vec3d best;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const base::Vec3d a = t[k], b = t[(k + 1) % 3], d = b - a;
        inside = inside && dot(cross(d, inPlane - a), n) >= 0;
        const base::Vec3d on = a + d * std::clamp(dot(x - a, d) / lengthSq(d), 0.0, 1.0);
        if (base::distance(on, x) < nearest) {
            nearest = base::distance(on, x);
            best = on;
        }
    }
    return inside ? inPlane : best;
}

} // namespace complex_models
