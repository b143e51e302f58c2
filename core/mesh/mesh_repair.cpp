#include "core/mesh/mesh_repair.h"

#include "core/mesh/mesh_fans.h"

#include <algorithm>
#include <unordered_map>

namespace mesh {

using base::Vec3d, base::Vec3f;

namespace {

struct RimEdge {
    std::uint32_t from = 0, to = 0; ///< as its triangle runs
};

/// The two edges at each vertex of the boundary.
class Boundary {
  public:
    explicit Boundary(const Mesh& mesh) {
        const MeshFans fans(mesh);
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (int corner = 0; corner < 3; ++corner) {
                const Triangle& triangle = mesh.triangles[t];
                const std::uint32_t a = triangle[std::size_t(corner)], b = triangle[std::size_t((corner + 1) % 3)];
                if (fans.across(t, corner) != MeshFans::none)
                    continue;
                add(a);
                add(b);
                m_edges.push_back({a, b});
            }
    }

    /// Loops in the order of their first edges.
    template <class Fn>
    void forLoops(const Fn& fn) const {
        std::vector<bool> done(m_edges.size());
        std::vector<RimEdge> loop;
        for (std::size_t first = 0; first < m_edges.size(); ++first) {
            loop.clear();
            std::uint32_t vertex = m_edges[first].from;
            for (std::size_t at = first; !done[at];) {
                done[at] = true;
                loop.push_back(m_edges[at]);
                vertex = m_edges[at].from == vertex ? m_edges[at].to : m_edges[at].from;
                const auto& two = m_at.at(vertex);
                at = two[0] == at ? two[1] : two[0];
            }
            if (!loop.empty())
                fn(loop);
        }
    }

  private:
    void add(std::uint32_t vertex) {
        auto& two = m_at.try_emplace(vertex, std::array<std::size_t, 2>{none, none}).first->second;
        two[two[0] == none ? 0 : 1] = m_edges.size();
    }

    static constexpr std::size_t none = ~std::size_t(0);
    std::vector<RimEdge> m_edges;
    std::unordered_map<std::uint32_t, std::array<std::size_t, 2>> m_at;
};

void closeLoop(Mesh& mesh, std::span<const RimEdge> loop) {
    const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
    Vec3d position;
    Vec3f normal;
    for (const RimEdge& edge : loop) {
        position += (mesh.positions[edge.from] + mesh.positions[edge.to]) / (2.0 * static_cast<double>(loop.size()));
        normal += mesh.normals[edge.from] + mesh.normals[edge.to];
        mesh.kinds[edge.from] = mesh.kinds[edge.to] = VertexKind::Inner;
        mesh.triangles.push_back({edge.to, edge.from, middle});
    }
    mesh.positions.push_back(position);
    mesh.normals.push_back(normalized(normal, mesh.normals[loop[0].from]));
    mesh.kinds.push_back(VertexKind::Inner);
}

template <class T>
void keepOnly(std::vector<T>& values, std::span<const std::uint32_t> numbers) {
    if (values.empty())
        return;
    std::size_t count = 0;
    for (std::size_t v = 0; v < numbers.size(); ++v)
        if (numbers[v] != MeshFans::none)
            values[count++] = values[v];
    values.resize(count);
}

} // namespace

std::size_t closeFolds(Mesh& mesh, std::size_t longest) {
    std::size_t closed = 0;
    Boundary(mesh).forLoops([&](std::span<const RimEdge> loop) {
        const bool fold = std::any_of(loop.begin(), loop.end(), [&](const RimEdge& edge) {
            return mesh.kinds[edge.from] == VertexKind::Fold || mesh.kinds[edge.to] == VertexKind::Fold;
        });
        if (!fold || loop.size() > longest)
            return;
        closeLoop(mesh, loop);
        ++closed;
    });
    return closed;
}

void dropUnused(Mesh& mesh) {
    std::vector<std::uint32_t> numbers(mesh.positions.size(), MeshFans::none);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            numbers[v] = 0;
    std::uint32_t next = 0;
    for (std::uint32_t& number : numbers)
        if (number != MeshFans::none)
            number = next++;
    keepOnly(mesh.positions, numbers);
    keepOnly(mesh.normals, numbers);
    keepOnly(mesh.colours, numbers);
    keepOnly(mesh.masks, numbers);
    keepOnly(mesh.kinds, numbers);
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            v = numbers[v];
}

void dropSmallPieces(Mesh& mesh, const Orientation& pieces, std::size_t least) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (pieces.pieceSizes[pieces.pieceOf[t]] >= least)
            mesh.triangles[count++] = mesh.triangles[t];
    mesh.triangles.resize(count);
    dropUnused(mesh);
}

} // namespace mesh
