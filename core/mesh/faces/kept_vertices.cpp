#include "core/mesh/faces/kept_vertices.h"

#include "core/mesh/faces/face_normals.h"
#include "core/process/resampling/resample.h"
#include "core/tree/surfel_tree.h"

#include <algorithm>
#include <array>
#include <map>

namespace mesh {

using base::Vec3f;
using surfel::SurfelList;

namespace {

/// Turns the vertices' own normals where those of a closed piece look inwards, by most of its area; false where none
/// does.
bool turnOwnNormals(SurfelList& vertices, const FaceTopology& topology) {
    std::vector<double> balance(topology.triangles.size()); // of bodies
    const auto forCorners = [&](const auto& fn) {
        for (std::size_t t = 0; t < topology.triangles.size(); ++t)
            for (std::size_t k = 0; k < 3 && topology.bodies[t] != noBody; ++k)
                fn(topology.bodies[t], t, topology.triangles[t][k]);
    };
    forCorners([&](std::uint32_t body, std::size_t t, std::uint32_t v) {
        const double along = dot(base::cast<double>(vertices.items[v].normal), topology.normals[t]);
        balance[body] += along < 0 ? -topology.areas[t] : along > 0 ? topology.areas[t] : 0;
    });
    std::vector<std::uint8_t> turned(vertices.size());
    forCorners([&](std::uint32_t body, std::size_t, std::uint32_t v) { turned[v] |= balance[body] < 0; });
    for (std::size_t v = 0; v < turned.size(); ++v)
        if (turned[v])
            vertices.items[v].normal = -vertices.items[v].normal;
    return std::find(turned.begin(), turned.end(), 1) != turned.end();
}

} // namespace

bool completeVertices(SurfelList& vertices, const FaceTopology& topology, std::span<const Vec3f> positions) {
    const std::vector<Vec3f> normals = vertexNormals(topology, positions);
    const bool own = vertices.layout->normals, turned = own && turnOwnNormals(vertices, topology);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        surfel::Surfel& s = vertices.items[i];
        if (!own || lengthSq(s.normal) == 0)
            s.normal = normals[i];
    }
    auto layout = std::make_shared<surfel::AttributeLayout>(*vertices.layout);
    layout->normals = true;
    layout->oriented = own ? vertices.layout->oriented : !topology.oneSided;
    vertices.layout = std::move(layout);
    return turned;
}

void paintVertices(SurfelList& vertices, const FacePaint& paint) {
    paint.paint(vertices.items);
    auto layout = std::make_shared<surfel::AttributeLayout>(*vertices.layout);
    layout->colours = true;
    vertices.layout = std::move(layout);
}

void findInner(const FaceTopology& topology, std::vector<std::uint8_t>& gone) {
    std::vector<std::uint8_t> inner(gone.size());
    for (const std::uint32_t v : topology.insideCorners)
        inner[v] = 1;
    for (const Triangle& t : topology.triangles)
        for (const std::uint32_t v : t)
            inner[v] = 0;
    for (std::size_t v = 0; v < gone.size(); ++v)
        gone[v] |= inner[v];
}

std::vector<float> vertexSupports(const SurfelList& kept, const FaceTopology& topology,
                                  std::span<const Vec3f> positions, const surface::SurfaceDefinition& definition) {
    struct Edges {
        double length = 0;
        std::size_t count = 0;
    };
    std::vector<Edges> own(positions.size());
    for (const Triangle& t : topology.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            const auto length = static_cast<double>(distance(positions[a], positions[b]));
            for (const std::uint32_t end : {a, b})
                own[end].length += length, ++own[end].count;
        }
    std::map<std::array<float, 3>, Edges> edges; // by place: vertices may stand in it twice
    const auto at = [&](const Vec3f& p) { return std::array{p.x, p.y, p.z}; };
    for (std::size_t v = 0; v < own.size(); ++v)
        if (own[v].count > 0) {
            Edges& here = edges[at(positions[v])];
            here.length += own[v].length, here.count += own[v].count;
        }
    std::vector<float> out(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (const auto found = edges.find(at(kept.items[i].position)); found != edges.end())
            out[i] = process::supportOf(
                definition, static_cast<float>(found->second.length / static_cast<double>(found->second.count)));
    if (std::ranges::find(out, 0.0f) == out.end())
        return out;
    SurfelList known;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (out[i] > 0)
            known.items.push_back({kept.items[i].position, {}, out[i]});
    if (known.items.empty())
        return out;
    const tree::SurfelTree tree = tree::SurfelTree::build(known);
    std::vector<tree::Neighbour> nearest;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (!(out[i] > 0)) {
            tree.nearest(kept.items[i].position, 1, nearest);
            out[i] = nearest[0].block->support(nearest[0].slot);
        }
    return out;
}

} // namespace mesh
