// A plate that nobody made for sculpting: thin as some spacings or less, its six faces jittered.
#pragma once

#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "sculpt/shapes.h"

namespace test {

/// Around the origin, `size` long, wide and thick, sampled at `s` on each face with exact normals.
inline surface::Surface randomPlate(base::Random& random, const base::Vec3d& size, double s) {
    using base::Vec3d;
    surfel::SurfelList out;
    out.layout = orientedLayout();
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-0.5, 0.5}) {
            const int a = (axis + 1) % 3, b = (axis + 2) % 3;
            const int rows = std::max(1, int(std::lround(size[a] / s))),
                      columns = std::max(1, int(std::lround(size[b] / s)));
            for (int i = 0; i < rows; ++i)
                for (int k = 0; k < columns; ++k) {
                    Vec3d p, n;
                    p[axis] = side * size[axis], n[axis] = side * 2;
                    p[a] = ((i + 0.5 + random.uniform(-0.2, 0.2)) / rows - 0.5) * size[a];
                    p[b] = ((k + 0.5 + random.uniform(-0.2, 0.2)) / columns - 0.5) * size[b];
                    surfel::Surfel each;
                    each.position = base::cast<float>(p), each.normal = base::cast<float>(n);
                    out.append(each, {});
                }
        }
    return process::prepare(out, {});
}

} // namespace test
