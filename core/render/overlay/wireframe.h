// A mesh as lines over a picture of the surface it came from: edges that its triangles do not hide, boundaries in
// colours of their own. Drawn on the CPU by bands of rows in parallel; the same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/render/camera.h"
#include "core/render/renderer.h"

namespace render {

struct WireColours {
    surfel::Colour edge = surfel::rgba(20, 24, 30, 150);
    surfel::Colour limit = surfel::rgba(255, 176, 64, 255); ///< boundaries where the surface ends by its limit
    surfel::Colour fold = surfel::rgba(255, 84, 64, 255);   ///< boundaries where its definition ends
};

/// What it draws of a mesh, found once for all views.
struct Wires {
    struct Edge {
        std::uint32_t a, b;
        bool boundary = false;
    };
    std::shared_ptr<const mesh::Mesh> mesh;
    std::vector<Edge> edges; ///< each once
};
Wires wiresOf(std::shared_ptr<const mesh::Mesh> mesh);

/// Alpha 0 where no line is; colours are not premultiplied. Depths of the image mean nothing. Where edges are shorter
/// than a few pixels they are fainter. Clip planes cut it as they cut the picture. Throws base::Cancelled.
void drawWires(const Wires& wires, const Camera& camera, const WireColours& colours, Image& out,
               const base::Progress& progress = {});

} // namespace render
