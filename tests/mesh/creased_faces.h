// Meshes opened with their creases, and what labels that gives.
#pragma once

#include "core/cells/labels.h"
#include "core/mesh/faces/open_faces.h"
#include "mesh/face_models.h"

namespace faces {

inline mesh::OpenedFaces openedFaces(const Faces& f, std::size_t count, bool creases = true, double at = sharp) {
    return mesh::openFaces(f.list(), f.triangles, {},
                           {.use = mesh::FaceUse::Sample, .count = count, .sharpRad = at, .creases = creases});
}

inline std::vector<cells::Label> labelsOf(const surfel::SurfelList& list) {
    std::vector<cells::Label> out;
    if (const auto layout = cells::LabelLayout::of(*list.layout))
        for (std::size_t i = 0; i < list.size(); ++i)
            out.push_back(layout->at(list.extraOf(i)));
    return out;
}

/// A sheet over [-1, 1]^2 with a ridge along the x axis, as high as `height` tells; facing up.
template <class Height>
Faces sheet(int n, const Height& height) {
    Faces out;
    for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n; ++k) {
            const double x = -1 + 2.0 * i / n, y = -1 + 2.0 * k / n;
            out.positions.push_back(base::cast<float>(Vec3d{x, y, height(x, y)}));
        }
    const auto at = [n](int i, int k) { return static_cast<std::uint32_t>(i * (n + 1) + k); };
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            out.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            out.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return out;
}

} // namespace faces
