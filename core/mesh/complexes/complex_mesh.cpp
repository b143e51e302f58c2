#include "core/mesh/complexes/complex_mesh.h"

#include "core/base/error.h"
#include "core/mesh/check/shape.h"
#include "core/mesh/check/topology.h"
#include "core/mesh/complexes/edge_counts.h"
#include "core/mesh/complexes/rim_chains.h"
#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/finish/mesh_attributes.h"
#include "core/mesh/seams/crease_tidy.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>
#include <cmath>

namespace mesh {

using base::Vec3d, base::Vec3f;

namespace {

constexpr int rounds = 8;

/// A patch's triangles with the vertices of the whole mesh.
class Sewing {
  public:
    Sewing(const RimChains& chains, Mesh& mesh) : m_chains(chains), m_mesh(mesh) {
        for (const Vec3d& each : chains.vertices()) {
            m_mesh.positions.push_back(each);
            m_mesh.normals.push_back({});
            m_mesh.kinds.push_back(VertexKind::Limit); // until two patches meet there
        }
    }

    /// False where the patch came out torn or folded, as it may in acute corners, narrower than the cubes.
    bool add(std::uint32_t patch, const PatchMesh& part) {
        std::vector<std::uint32_t> name(part.on.size());
        m_normals.clear();
        for (std::uint32_t v = 0; v < name.size(); ++v) {
            if (part.on[v] != PatchMesh::inside) {
                name[v] = m_chains.vertexOf(patch, v);
                m_normals[name[v]] = part.mesh.normals[v];
                continue;
            }
            name[v] = static_cast<std::uint32_t>(m_mesh.positions.size());
            m_mesh.positions.push_back(part.mesh.positions[v]);
            m_mesh.normals.push_back(part.mesh.normals[v]);
            m_mesh.kinds.push_back(VertexKind::Inner);
        }
        std::vector<Triangle> triangles;
        for (const Triangle& t : part.mesh.triangles)
            if (const Triangle named{name[t[0]], name[t[1]], name[t[2]]}; isProper(named))
                triangles.push_back(named);
        fit(patch, triangles);
        for (const auto& [v, normal] : m_normals) // those of all its patches
            m_mesh.normals[v] += normal;
        const bool sound = tidy(patch, triangles) && followsCurves(patch, triangles);
        m_mesh.triangles.insert(m_mesh.triangles.end(), triangles.begin(), triangles.end());
        return sound;
    }

  private:
    bool onRim(std::uint32_t v) const { return v < m_chains.vertices().size(); }

    /// Sides on the boundary get all vertices that the curves have there.
    void fit(std::uint32_t patch, std::vector<Triangle>& triangles) {
        EdgeCounts sides = edgeCounts(triangles);
        while (dropFlat(patch, triangles, sides))
            continue;
        for (std::size_t i = 0; i < triangles.size(); ++i) // what is added at the end is looked at, too
            for (std::size_t k = 0; k < 3; ++k) {
                const Triangle t = triangles[i];
                const std::uint32_t a = t[k], b = t[(k + 1) % 3], opposite = t[(k + 2) % 3];
                const auto side = sides.find(std::minmax(a, b));
                if (!onRim(a) || !onRim(b) || side == sides.end() || side->second != 1)
                    continue;
                sides.erase(side);
                std::vector<std::uint32_t> way = m_chains.between(patch, a, b);
                if (way.empty())
                    continue;
                for (const std::uint32_t v : way)
                    m_normals.try_emplace(v, normalOf(opposite));
                way.push_back(b);
                triangles[i] = {a, way.front(), opposite};
                for (std::size_t n = 1; n < way.size(); ++n)
                    triangles.push_back({way[n - 1], way[n], opposite});
                --i; // its other sides
                break;
            }
    }

    /// Takes triangles out that lie on the boundary wholly: the third corner is between the others on the curves. False
    /// where there are none.
    bool dropFlat(std::uint32_t patch, std::vector<Triangle>& triangles, EdgeCounts& sides) {
        const auto isFlat = [&](const Triangle& t) {
            if (!onRim(t[0]) || !onRim(t[1]) || !onRim(t[2]))
                return false;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3], opposite = t[(k + 2) % 3];
                if (sides.at(std::minmax(a, b)) != 1)
                    continue;
                const std::vector<std::uint32_t> way = m_chains.between(patch, a, b);
                if (std::count(way.begin(), way.end(), opposite) > 0)
                    return true;
            }
            return false;
        };
        const std::size_t before = triangles.size();
        std::erase_if(triangles, isFlat);
        sides = edgeCounts(triangles);
        return triangles.size() < before;
    }

    /// Of the present patch.
    Vec3f normalOf(std::uint32_t v) const {
        const auto found = m_normals.find(v);
        return found != m_normals.end() ? found->second : m_mesh.normals[v];
    }

    /// Are all sides on the boundary links of the curves' chains?
    bool followsCurves(std::uint32_t patch, std::span<const Triangle> triangles) const {
        for (const auto& [side, count] : edgeCounts(triangles))
            if (count == 1 && (!onRim(side.first) || !onRim(side.second) ||
                               !m_chains.between(patch, side.first, side.second).empty()))
                return false;
        return true;
    }

    /// Better triangles beside the boundary, which stays. False where they are no manifold, or flat ones are left.
    bool tidy(std::uint32_t patch, std::vector<Triangle>& triangles) const {
        CutMesh local;
        std::map<std::uint32_t, std::uint32_t> names;
        std::vector<std::uint32_t> back;
        const auto nameOf = [&](std::uint32_t v) {
            const auto [at, fresh] = names.try_emplace(v, static_cast<std::uint32_t>(back.size()));
            if (fresh) {
                back.push_back(v);
                local.mesh.positions.push_back(m_mesh.positions[v]);
                local.mesh.normals.push_back(normalOf(v));
                local.mesh.kinds.push_back(VertexKind::Inner);
                local.vertices.push_back({{patch}, patch, m_mesh.positions[v], normalOf(v), onRim(v)});
            }
            return at->second;
        };
        for (const Triangle& t : triangles) {
            const Triangle named{nameOf(t[0]), nameOf(t[1]), nameOf(t[2])};
            local.mesh.triangles.push_back(named);
            local.cells.push_back(patch);
            local.facing.push_back(normalized(base::cast<double>(normalOf(t[0]) + normalOf(t[1]) + normalOf(t[2]))));
        }
        if (!topologyOf(local.mesh.triangles, back.size(), local.mesh.kinds).manifold())
            return false;
        for (int ring = 0; ring < 2; ++ring) {
            const std::vector<CreaseVertex> before = local.vertices;
            for (const Triangle& t : local.mesh.triangles)
                if (before[t[0]].mixed || before[t[1]].mixed || before[t[2]].mixed)
                    for (const std::uint32_t v : t)
                        local.vertices[v].mixed = true;
        }
        tidyCreases(local);
        triangles.clear();
        for (const Triangle& t : local.mesh.triangles)
            triangles.push_back({back[t[0]], back[t[1]], back[t[2]]});
        return shapeOf(local.mesh).leastAngle > 0.02;
    }

    const RimChains& m_chains;
    Mesh& m_mesh;
    std::map<std::uint32_t, Vec3f> m_normals; ///< of the present patch, at vertices that others may share
};

void finish(Mesh& mesh) {
    const std::vector<bool> open = endsOfOpenEdges(mesh.triangles, mesh.positions.size());
    for (std::size_t v = 0; v < open.size(); ++v) {
        mesh.kinds[v] = open[v] ? VertexKind::Limit : VertexKind::Inner;
        mesh.normals[v] = normalized(mesh.normals[v], Vec3f{0, 0, 1});
    }
    dropUnused(mesh);
}

} // namespace

Mesh meshOfComplex(const complexes::Complex& complex, const ComplexMeshOptions& options,
                   const base::Progress& progress) {
    const std::size_t cells = complex.cells().size();
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t c = 0; c < cells; ++c)
        if (complex[c].dimension == 2) {
            if (complex[c].own.tree().empty())
                throw base::Error("patch " + std::to_string(c) + " of the complex has no points of its own to mesh", {},
                                  "give it some");
            wanted.push_back(c);
        }
    std::vector<PatchMesh> patches(cells);
    Mesh out;
    std::size_t least = cells + 1;
    // Patches that come out badly are cut by other cubes, with which the curves are, too.
    for (int round = 0; round < rounds && !wanted.empty(); ++round) {
        const base::Progress making = process::part(progress, 1 - std::pow(0.5, round), 1 - std::pow(0.5, round + 1));
        const Vec3d shift = Vec3d{0.37, 0.61, 0.23} * static_cast<double>(round);
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            const auto share = [&](std::size_t n) {
                return static_cast<double>(n) / static_cast<double>(wanted.size());
            };
            patches[wanted[k]] =
                meshOfPatch(complex, wanted[k], options.cell, shift, process::part(making, share(k), share(k + 1)));
        }
        const RimChains chains(complex, patches);
        Mesh sewn;
        Sewing sewing(chains, sewn);
        wanted.clear();
        for (std::uint32_t c = 0; c < cells; ++c)
            if (complex[c].dimension == 2 && !sewing.add(c, patches[c]))
                wanted.push_back(c);
        if (wanted.size() < least) {
            least = wanted.size();
            out = std::move(sewn);
        }
    }
    if (out.triangles.empty())
        throw base::Error("no surface was found to mesh", "", "check the complex's patches");
    finish(out);
    takeAttributes(out, complex.surface());
    return out;
}

} // namespace mesh
