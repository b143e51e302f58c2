#include "core/mesh/mesh_repair.h"

#include "core/mesh/marching/own_sheet.h"
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

/// The fan that closes a loop.
class Fan {
  public:
    Fan(Mesh& mesh, std::span<const RimEdge> loop) : m_mesh(mesh), m_loop(loop) {
        const Vec3f first = mesh.normals[loop[0].from];
        Vec3f normal;
        for (const RimEdge& edge : loop) {
            m_middle.position += (at(edge.from) + at(edge.to)) / (2.0 * static_cast<double>(loop.size()));
            for (const std::uint32_t v : {edge.from, edge.to})
                normal += dot(mesh.normals[v], first) < 0 ? -mesh.normals[v] : mesh.normals[v];
        }
        m_middle.normal = normalized(normal, first);
    }

    /// Moves the middle onto the sheet around it; returns whether it is there.
    bool land(const surface::Surface& surface, const WalkSetting& setting, double cell) {
        const auto found = ontoOwnSheet(surface, setting, m_middle.position, m_middle.normal, 0.5 * cell);
        if (found)
            m_middle = *found;
        return found.has_value();
    }

    /// Do the normals around it and the loop face as the middle does?
    bool isOneSheet() const {
        constexpr double steepest = 0.5; // cosine
        const Vec3d normal = base::cast<double>(m_middle.normal);
        Vec3d all;
        for (const RimEdge& edge : m_loop)
            all += area(edge);
        const auto facesAlike = [&](const RimEdge& edge) {
            return std::abs(dot(base::cast<double>(m_mesh.normals[edge.from]), normal)) > steepest;
        };
        return std::abs(dot(base::normalized(all), normal)) > steepest &&
               std::all_of(m_loop.begin(), m_loop.end(), facesAlike);
    }

    std::uint32_t add() {
        const auto middle = static_cast<std::uint32_t>(m_mesh.positions.size());
        for (const RimEdge& edge : m_loop) {
            m_mesh.kinds[edge.from] = m_mesh.kinds[edge.to] = VertexKind::Inner;
            m_mesh.triangles.push_back({edge.to, edge.from, middle});
        }
        m_mesh.positions.push_back(m_middle.position);
        m_mesh.normals.push_back(m_middle.normal);
        m_mesh.kinds.push_back(VertexKind::Inner);
        return middle;
    }

  private:
    const Vec3d& at(std::uint32_t v) const { return m_mesh.positions[v]; }
    Vec3d area(const RimEdge& edge) const {
        return cross(at(edge.from) - m_middle.position, at(edge.to) - m_middle.position);
    }

    Mesh& m_mesh;
    std::span<const RimEdge> m_loop;
    SheetPoint m_middle;
};

/// Of `each` values per vertex.
template <class T>
void keepOnly(std::vector<T>& values, std::span<const std::uint32_t> numbers, std::size_t each = 1) {
    if (values.empty())
        return;
    std::size_t count = 0;
    for (std::size_t i = 0; i < numbers.size() * each; ++i)
        if (numbers[i / each] != MeshFans::none)
            values[count++] = values[i];
    values.resize(count);
}

} // namespace

std::vector<std::uint32_t> closeFolds(Mesh& mesh, const surface::Surface& surface, const FoldClosing& options) {
    const WalkSetting setting(surface);
    std::vector<std::uint32_t> middles;
    Boundary(mesh).forLoops([&](std::span<const RimEdge> loop) {
        const bool fold = std::any_of(loop.begin(), loop.end(), [&](const RimEdge& edge) {
            return mesh.kinds[edge.from] == VertexKind::Fold || mesh.kinds[edge.to] == VertexKind::Fold;
        });
        if (!fold || loop.size() > options.longest)
            return;
        Fan fan(mesh, loop);
        const bool goesOn = fan.land(surface, setting, options.cell) && fan.isOneSheet();
        if (!(options.everyLoop || (goesOn && loop.size() <= options.shortHole)))
            return;
        middles.push_back(fan.add());
    });
    return middles;
}

std::size_t keepTriangles(Mesh& mesh, const std::function<bool(std::size_t)>& keep) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (keep(t))
            mesh.triangles[kept++] = mesh.triangles[t];
    const std::size_t out = mesh.triangles.size() - kept;
    mesh.triangles.resize(kept);
    return out;
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
    keepOnly(mesh.extra, numbers, mesh.layout->words());
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            v = numbers[v];
}

void dropSmallPieces(Mesh& mesh, const Orientation& pieces, std::size_t least) {
    keepTriangles(mesh, [&](std::size_t t) { return pieces.pieceSizes[pieces.pieceOf[t]] >= least; });
    dropUnused(mesh);
}

} // namespace mesh
