// How a mesh is to be made of the surface, as the person chooses it. Plain value.
#pragma once

namespace ui {

struct MeshChoice {
    static constexpr double minCell = 0.5, maxCell = 8;
    bool delaunay = false; ///< restricted Delaunay triangulation; else marching cubes
    double cell = 1;       ///< side of a cube, or largest circumradius of a triangle, in spacings
    bool closeFolds = false, dropSmall = false;
    bool preview = true; ///< draw it over the picture
    bool operator==(const MeshChoice&) const = default;
    /// Do both give the same mesh?
    bool sameMesh(const MeshChoice& o) const {
        return delaunay == o.delaunay && cell == o.cell && closeFolds == o.closeFolds && dropSmall == o.dropSmall;
    }
};

} // namespace ui
