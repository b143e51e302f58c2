#include "core/render/overlay/wireframe.h"

#include "core/base/parallel.h"
#include "core/base/ranked.h"
#include "core/mesh/connectivity/triangulation.h"
#include "core/render/effects/pixel_geometry.h"

#include <algorithm>

namespace render {

using base::Vec3d;

Wires wiresOf(std::shared_ptr<const mesh::Mesh> mesh) {
    Wires out;
    const mesh::Triangulation triangulation(*mesh);
    triangulation.forEdges([&](const mesh::Side& s) {
        const auto [low, high] = std::minmax({triangulation.from(s), triangulation.to(s)});
        out.edges.push_back({low, high, triangulation.onBoundary(s)});
    });
    out.mesh = std::move(mesh);
    return out;
}

namespace {

constexpr int bandRows = 32;

/// A vertex in the image: pixels, and nearness, which is linear across it (view_frame.h).
struct ProjectedVertex {
    float x = 0, y = 0, w = 0;
    bool seen = false; ///< before the eye and kept by all clip planes
};

struct WireDrawing {
    const Wires& wires;
    const WireColours& colours;
    std::vector<ProjectedVertex> vertices;
    std::vector<float> nearest; ///< of the triangles, per pixel
    float background, alpha;
    Image& out;

    float& nearestAt(int x, int y) { return nearest[index(x, y)]; }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) + static_cast<std::size_t>(x);
    }
};

std::vector<ProjectedVertex> projected(const mesh::Mesh& mesh, const Camera& camera) {
    std::vector<ProjectedVertex> out(mesh.positions.size());
    base::parallelFor(out.size(), 4096, [&](std::size_t i) {
        const Vec3d& p = mesh.positions[i];
        const Vec3d at = camera.project(p);
        if (at.z > 0 && camera.clips.keeps(p))
            out[i] = {static_cast<float>(at.x), static_cast<float>(at.y),
                      static_cast<float>(camera.parallel() ? -at.z : 1 / at.z), true};
    });
    return out;
}

/// The rows [top, bottom) of one triangle into the depth buffer.
void fillTriangle(WireDrawing& d, const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c, int top,
                  int bottom) {
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0)
        return;
    const auto low = [](float value) { return static_cast<int>(std::ceil(std::max(value, -1e6f) - 0.5f)); };
    const int y0 = std::max(top, low(std::min({a.y, b.y, c.y}))), x0 = std::max(0, low(std::min({a.x, b.x, c.x})));
    const int y1 = std::min(bottom, low(std::min(1e6f, std::max({a.y, b.y, c.y})) + 1));
    const int x1 = std::min(d.out.width, low(std::min(1e6f, std::max({a.x, b.x, c.x})) + 1));
    const float gx = ((b.w - a.w) * (c.y - a.y) - (c.w - a.w) * (b.y - a.y)) / area;
    const float gy = ((c.w - a.w) * (b.x - a.x) - (b.w - a.w) * (c.x - a.x)) / area;
    const float sign = area > 0 ? 1.0f : -1.0f;
    const auto inside = [&](const ProjectedVertex& p, const ProjectedVertex& q, float x, float y) {
        return sign * ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x)) >= 0;
    };
    for (int row = y0; row < y1; ++row)
        for (int column = x0; column < x1; ++column) {
            const float x = static_cast<float>(column) + 0.5f, y = static_cast<float>(row) + 0.5f;
            if (!inside(a, b, x, y) || !inside(b, c, x, y) || !inside(c, a, x, y))
                continue;
            float& nearest = d.nearestAt(column, row);
            nearest = std::max(nearest, a.w + gx * (x - a.x) + gy * (y - a.y));
        }
}

/// The farthest of the pixel and its neighbours: a line in a slanted triangle must not be hidden by that triangle.
float hiddenBehind(WireDrawing& d, int x, int y) {
    float out = std::numeric_limits<float>::infinity();
    for (int row = std::max(0, y - 1); row <= std::min(d.out.height - 1, y + 1); ++row)
        for (int column = std::max(0, x - 1); column <= std::min(d.out.width - 1, x + 1); ++column)
            out = std::min(out, d.nearestAt(column, row));
    return out;
}

/// Colours above colours, alpha kept: the stronger of the two.
void blend(surfel::Colour& pixel, surfel::Colour colour, float part) {
    const auto alpha = static_cast<unsigned>(static_cast<float>(colour >> 24) * part + 0.5f);
    if (alpha > pixel >> 24)
        pixel = (colour & 0x00ffffffu) | alpha << 24;
}

/// The rows [top, bottom) of one edge, a pixel wide, smooth across.
void drawEdge(WireDrawing& d, const ProjectedVertex& a, const ProjectedVertex& b, surfel::Colour colour, float strength,
              int top, int bottom) {
    const float dx = b.x - a.x, dy = b.y - a.y, longest = std::max(std::abs(dx), std::abs(dy));
    if (!(longest > 0) || longest > 1e5f)
        return;
    const bool steep = std::abs(dy) > std::abs(dx);
    const int steps = static_cast<int>(std::ceil(longest));
    for (int k = 0; k <= steps; ++k) {
        const float part = static_cast<float>(k) / static_cast<float>(steps);
        const float x = a.x + dx * part - 0.5f, y = a.y + dy * part - 0.5f, w = a.w + (b.w - a.w) * part;
        const float across = steep ? x : y, base = std::floor(across), share = across - base;
        for (int side = 0; side < 2; ++side) {
            const int column = steep ? static_cast<int>(base) + side : static_cast<int>(std::lround(x));
            const int row = steep ? static_cast<int>(std::lround(y)) : static_cast<int>(base) + side;
            if (row < top || row >= bottom || column < 0 || column >= d.out.width)
                continue;
            if (w >= hiddenBehind(d, column, row))
                blend(d.out.colour[d.index(column, row)], colour, strength * (side ? share : 1 - share));
        }
    }
}

surfel::Colour colourOf(const WireDrawing& d, const Wires::Edge& edge) {
    const std::vector<mesh::VertexKind>& kinds = d.wires.mesh->kinds;
    if (!edge.boundary)
        return d.colours.edge;
    const bool fold =
        !kinds.empty() && (kinds[edge.a] == mesh::VertexKind::Fold || kinds[edge.b] == mesh::VertexKind::Fold);
    return fold ? d.colours.fold : d.colours.limit;
}

/// Runs over bands of rows; what does not reach a band is passed over.
template <class Body>
void forBands(int height, const base::Progress& progress, double done, const Body& body) {
    const int bands = (height + bandRows - 1) / bandRows;
    base::parallelFor(static_cast<std::size_t>(bands), 1, [&](std::size_t band) {
        if (progress.cancel && progress.cancel->load(std::memory_order_relaxed))
            return;
        const int top = static_cast<int>(band) * bandRows;
        body(top, std::min(height, top + bandRows));
    });
    progress.step(done, "Drawing the mesh");
}

/// Median length of the edges in pixels, of some of them.
float typicalLength(const WireDrawing& d) {
    std::vector<float> lengths;
    const std::size_t stride = std::max<std::size_t>(1, d.wires.edges.size() / 1000);
    for (std::size_t i = 0; i < d.wires.edges.size(); i += stride) {
        const ProjectedVertex &a = d.vertices[d.wires.edges[i].a], &b = d.vertices[d.wires.edges[i].b];
        if (a.seen && b.seen)
            lengths.push_back(std::hypot(b.x - a.x, b.y - a.y));
    }
    return base::median(lengths);
}

} // namespace

void drawWires(const Wires& wires, const Camera& camera, const WireColours& colours, Image& out,
               const base::Progress& progress) {
    out.resize(camera.width, camera.height);
    const float background = camera.parallel() ? nowhereParallel : nowhere;
    WireDrawing d{wires, colours, projected(*wires.mesh, camera), {}, background, 1, out};
    d.nearest.assign(out.colour.size(), background);
    d.alpha = std::clamp(typicalLength(d) / 8, 0.12f, 1.0f);
    const auto reaches = [](float low, float high, int top, int bottom) {
        return high >= static_cast<float>(top - 1) && low <= static_cast<float>(bottom + 1);
    };
    forBands(out.height, progress, 0.5, [&](int top, int bottom) {
        for (const mesh::Triangle& t : wires.mesh->triangles) {
            const ProjectedVertex &a = d.vertices[t[0]], &b = d.vertices[t[1]], &c = d.vertices[t[2]];
            if (a.seen && b.seen && c.seen &&
                reaches(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), top, bottom))
                fillTriangle(d, a, b, c, top, bottom);
        }
    });
    forBands(out.height, progress, 1, [&](int top, int bottom) {
        for (const Wires::Edge& edge : wires.edges) {
            const ProjectedVertex &a = d.vertices[edge.a], &b = d.vertices[edge.b];
            if (a.seen && b.seen && reaches(std::min(a.y, b.y), std::max(a.y, b.y), top, bottom))
                drawEdge(d, a, b, colourOf(d, edge), edge.boundary ? 1 : d.alpha, top, bottom);
        }
    });
}

} // namespace render
