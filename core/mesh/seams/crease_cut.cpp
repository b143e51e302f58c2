#include "core/mesh/seams/crease_cut.h"

#include "core/base/parallel.h"
#include "core/mesh/connectivity/triangulation.h"
#include "core/mesh/seams/corner_vertices.h"
#include "core/process/estimation/part_progress.h"

#include <unordered_map>

namespace mesh {

using base::Vec3d, base::Vec3f;

namespace {

constexpr std::size_t grain = 128;
constexpr double seamSnap = 0.3, cornerSnap = 0.5; ///< of the edges about a vertex: how near it moves to a crease
constexpr double reach = 3;                        ///< of an edge: how far from its middle a seam may be
constexpr int rounds = 3;                          ///< of cuts, in which vertices go to corners
constexpr std::uint32_t none = Triangulation::none;

class CreaseCutter {
  public:
    CreaseCutter(const cells::CellSurface& surface, Mesh mesh, std::vector<CreaseVertex> onFaces, CreaseMemory& memory)
        : m_surface(surface), m_memory(memory), m_mesh(std::move(mesh)), m_triangulation(m_mesh),
          m_vertices(std::move(onFaces)), m_faces(m_vertices),
          m_triangles(std::move(m_mesh.triangles)), m_before{m_mesh.positions, m_mesh.normals} {}

    CutMesh run(const base::Progress& progress) {
        progress.step(0, "finding creases");
        snap();
        for (int round = 1;; ++round) {
            progress.step(0.5 * round / rounds, "finding creases");
            begin();
            splitEdges();
            cut();
            if (round == rounds || !m_cornerVertices.settle(m_corners))
                break;
        }
        return {std::move(m_mesh),  std::move(m_vertices), std::move(m_facing),
                std::move(m_cells), std::move(m_before),   std::move(m_between)};
    }

  private:
    /// Vertices where they have moved to, and nothing cut yet.
    void begin() {
        const std::size_t count = m_faces.size();
        m_vertices.resize(count);
        m_mesh.positions.resize(count);
        m_mesh.normals.resize(count);
        if (!m_mesh.kinds.empty())
            m_mesh.kinds.resize(count);
        m_before.positions.resize(count);
        m_before.normals.resize(count);
        m_between.clear();
        m_corners.clear();
        m_split.clear();
        m_mesh.triangles.clear();
        m_facing.clear();
        m_cells.clear();
        for (std::size_t v = 0; v < count; ++v)
            if (m_vertices[v].mixed) {
                m_mesh.positions[v] = m_vertices[v].position;
                m_mesh.normals[v] = m_vertices[v].normal;
            }
    }

    bool known(std::uint32_t v) const { return m_vertices[v].cells.count() > 0; }
    Vec3d place(std::uint32_t v) const { return m_vertices[v].position; }

    CreaseSnap snapOf(CreaseFinder& finder, std::uint32_t v, std::vector<std::uint32_t>& ring) const {
        CreaseSnap out;
        if (!m_vertices[v].mixed || !known(v) || !movable(m_mesh, v))
            return out;
        m_triangulation.neighbours(v, ring);
        double size = 0;
        CellsAt others;
        for (const std::uint32_t w : ring) {
            size += base::distance(place(v), place(w)) / static_cast<double>(ring.size());
            if (known(w) && !m_vertices[w].cells.has(m_vertices[v].own))
                for (const std::uint32_t cell : m_vertices[w].cells)
                    others.add(cell);
        }
        if (others.count() == 0)
            return out;
        const CellsAt own{m_vertices[v].own};
        out.seam = finder.between(own, others, place(v), cornerSnap * size);
        CellsAt all = own;
        for (const std::uint32_t cell : others)
            all.add(cell);
        if (all.count() >= 3)
            out.corner = finder.corner(all, place(v), cornerSnap * size);
        if (!out.corner && out.seam && out.seam->cells.count() >= 3)
            out.corner = out.seam;
        if (out.seam &&
            (out.seam->cells.count() != 2 || !(base::distance(out.seam->position, place(v)) < seamSnap * size)))
            out.seam.reset();
        return out;
    }

    /// Has anything moved, of a vertex and those about it, since snaps were looked for?
    bool moved(std::uint32_t v, std::vector<std::uint32_t>& ring) const {
        const auto differs = [&](std::uint32_t w) {
            const CreaseVertex &a = m_memory.faces[w], &b = m_vertices[w];
            return !(a.cells == b.cells) || a.own != b.own || a.position != b.position || a.mixed != b.mixed;
        };
        if (m_memory.faces.empty() || differs(v))
            return true;
        m_triangulation.neighbours(v, ring);
        return std::any_of(ring.begin(), ring.end(), differs);
    }
    const std::vector<CreaseSnap>& findSnaps() {
        m_memory.snaps.resize(m_vertices.size());
        base::parallelChunks(m_vertices.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            CreaseFinder finder(m_surface);
            std::vector<std::uint32_t> ring;
            for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
                if (moved(v, ring))
                    m_memory.snaps[v] = snapOf(finder, v, ring);
        });
        m_memory.faces = m_vertices;
        return m_memory.snaps;
    }
    void snap() {
        const std::vector<CreaseSnap>& found = findSnaps();
        // a corner takes the nearest vertex about it
        std::vector<std::uint32_t> order;
        for (std::uint32_t v = 0; v < found.size(); ++v)
            if (found[v].corner)
                order.push_back(v);
        const auto far = [&](std::uint32_t v) {
            return base::distance(found[v].corner->position, m_faces[v].position);
        };
        std::sort(order.begin(), order.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return far(a) != far(b) ? far(a) < far(b) : a < b; });
        for (const std::uint32_t v : order)
            m_cornerVertices.goIfFree(v, *found[v].corner);
        for (std::uint32_t v = 0; v < found.size(); ++v)
            if (found[v].seam && m_vertices[v].cells.count() == 1 && !flattens(v, found[v].seam->cells))
                m_vertices[v].goTo(*found[v].seam);
    }
    /// Would all corners of a triangle be on the same seam?
    bool flattens(std::uint32_t v, const CellsAt& cells) const {
        std::vector<std::uint32_t> faces;
        m_triangulation.oneRing(v, faces);
        return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
            const Triangle& t = m_triangulation.corners(f);
            return std::all_of(t.begin(), t.end(), [&](std::uint32_t w) {
                return w == v || std::all_of(cells.begin(), cells.end(),
                                             [&](std::uint32_t cell) { return m_vertices[w].cells.has(cell); });
            });
        });
    }

    static std::uint64_t nameOf(std::uint32_t a, std::uint32_t b) {
        return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
    }

    CreaseSplit splitOf(CreaseFinder& finder, std::uint32_t a, std::uint32_t b) const {
        CreaseSplit out{{m_vertices[a].cells, place(a)}, {m_vertices[b].cells, place(b)}, {}};
        const auto before = m_memory.splits.find(nameOf(a, b));
        if (before != m_memory.splits.end() && before->second.from == out.from && before->second.to == out.to)
            return before->second;
        out.place = finder.between(out.from.cells, out.to.cells, (place(a) + place(b)) / 2,
                                   reach * base::distance(place(a), place(b)));
        return out;
    }
    void splitEdges() {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
        m_triangulation.forEdges([&](const Side& s) {
            const std::uint32_t a = m_triangulation.from(s), b = m_triangulation.to(s);
            if (known(a) && known(b) && (m_vertices[a].mixed || m_vertices[b].mixed) &&
                !m_vertices[a].cells.shares(m_vertices[b].cells))
                edges.emplace_back(a, b);
        });
        std::vector<CreaseSplit> found(edges.size());
        base::parallelChunks(found.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            CreaseFinder finder(m_surface);
            for (std::size_t i = begin; i < end; ++i)
                found[i] = splitOf(finder, edges[i].first, edges[i].second);
        });
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto [a, b] = edges[i];
            if (found[i].place)
                m_split.emplace(nameOf(a, b), addVertex(*found[i].place, {a, b}));
            m_memory.splits[nameOf(a, b)] = std::move(found[i]);
        }
    }
    /// In the middle of some vertices before.
    std::uint32_t addVertex(const CreasePlace& at, std::initializer_list<std::uint32_t> of) {
        Vec3d middle, normal;
        for (const std::uint32_t v : of) {
            middle += m_before.positions[v] / static_cast<double>(of.size());
            normal += base::cast<double>(m_before.normals[v]);
        }
        m_before.positions.push_back(middle);
        m_before.normals.push_back(base::cast<float>(base::normalized(normal)));
        m_mesh.positions.push_back(at.position);
        m_mesh.normals.push_back(at.normal);
        if (!m_mesh.kinds.empty())
            m_mesh.kinds.push_back(VertexKind::Inner);
        m_vertices.push_back({at.cells, *at.cells.begin(), at.position, at.normal, true});
        m_between.push_back({*of.begin(), *(of.begin() + 1), *(of.end() - 1)});
        return static_cast<std::uint32_t>(m_mesh.positions.size() - 1);
    }
    std::uint32_t splitOf(std::uint32_t a, std::uint32_t b) const {
        const auto found = m_split.find(nameOf(a, b));
        return found == m_split.end() ? none : found->second;
    }

    void cut() {
        for (const Triangle& t : m_triangles)
            if (isProper(t)) {
                m_current = t;
                cut(t);
            }
    }
    void cut(Triangle t) {
        std::array<std::uint32_t, 3> m; // m[k] between corners k and k + 1
        int count = 0;
        const auto find = [&] {
            count = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                m[k] = splitOf(t[k], t[(k + 1) % 3]);
                count += m[k] != none ? 1 : 0;
            }
        };
        const auto turn = [&](const auto& enough) {
            find();
            for (int k = 0; k < 3 && !enough(); ++k) {
                t = {t[1], t[2], t[0]};
                find();
            }
        };
        find();
        switch (count) {
        case 0:
            return add(t, t);
        case 1:
            turn([&] { return m[0] != none; });
            add({t[0], m[0], t[2]}, {t[0], t[2], t[2]});
            return add({m[0], t[1], t[2]}, {t[1], t[2], t[2]});
        case 2: {
            turn([&] { return m[2] == none; }); // the tip is corner 1
            add({m[0], t[1], m[1]}, {t[1], t[1], t[1]});
            const bool across = base::distance(place(t[0]), place(m[1])) < base::distance(place(m[0]), place(t[2]));
            if (across) {
                add({t[0], m[0], m[1]}, {t[0], t[2], t[0]});
                return add({t[0], m[1], t[2]}, {t[0], t[2], t[0]});
            }
            add({t[0], m[0], t[2]}, {t[0], t[2], t[0]});
            return add({m[0], m[1], t[2]}, {t[2], t[0], t[2]});
        }
        default:
            break;
        }
        const Vec3d middle = (place(m[0]) + place(m[1]) + place(m[2])) / 3;
        CellsAt all;
        for (const std::uint32_t v : t)
            for (const std::uint32_t cell : m_vertices[v].cells)
                all.add(cell);
        const double size = base::distance(place(t[0]), place(t[1])) + base::distance(place(t[1]), place(t[2]));
        CreasePlace centre{all, middle, m_mesh.normals[m[0]]};
        if (const auto corner = m_finder.corner(all, middle, reach * size)) {
            centre = *corner;
            m_corners.push_back({centre, m_current});
        }
        const std::uint32_t c = addVertex(centre, {t[0], t[1], t[2]});
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = t[(k + 1) % 3];
            add({m[k], v, c}, {v, v, v});
            add({v, m[(k + 1) % 3], c}, {v, v, v});
        }
    }

    /// A cell that all three are of.
    std::optional<std::uint32_t> commonCell(const Triangle& t) const {
        for (const std::uint32_t candidate : m_vertices[t[0]].cells)
            if (m_vertices[t[1]].cells.has(candidate) && m_vertices[t[2]].cells.has(candidate))
                return candidate;
        return std::nullopt;
    }

    /// A triangle that faces as those of `from` do that are of its cell. Between three seams it has a corner.
    void add(const Triangle& t, const Triangle& from) {
        const auto common = commonCell(t);
        if (!common && known(t[0]) && known(t[1]) && known(t[2])) {
            CellsAt all;
            for (const std::uint32_t v : t)
                for (const std::uint32_t each : m_vertices[v].cells)
                    all.add(each);
            const double size = base::distance(place(t[0]), place(t[1])) + base::distance(place(t[1]), place(t[2]));
            const Vec3d middle = (place(t[0]) + place(t[1]) + place(t[2])) / 3;
            if (const auto corner = all.count() < 3 ? std::nullopt : m_finder.corner(all, middle, reach * size)) {
                m_corners.push_back({*corner, m_current});
                const std::uint32_t c = addVertex(*corner, {t[0], t[1], t[2]});
                for (std::size_t k = 0; k < 3; ++k)
                    put({t[k], t[(k + 1) % 3], c}, from);
                return;
            }
        }
        put(t, from);
    }
    void put(const Triangle& t, const Triangle& from) {
        const std::uint32_t cell = commonCell(t).value_or(m_vertices[from[0]].own);
        Vec3d facing, any;
        for (const std::uint32_t v : from) {
            const CreaseVertex& vertex = v < m_faces.size() ? m_faces[v] : m_vertices[v];
            any += base::cast<double>(vertex.normal);
            if (vertex.own == cell)
                facing += base::cast<double>(vertex.normal);
        }
        m_mesh.triangles.push_back(t);
        m_facing.push_back(base::normalized(lengthSq(facing) > 0 ? facing : any));
        m_cells.push_back(cell);
    }

    const cells::CellSurface& m_surface;
    CreaseMemory& m_memory;
    Mesh m_mesh;
    Triangulation m_triangulation;
    std::vector<CreaseVertex> m_vertices; ///< as they are now
    std::vector<CreaseVertex> m_faces;    ///< as they came to rest on their faces
    std::vector<Triangle> m_triangles;    ///< that are cut
    Triangle m_current{};                 ///< the one that is being cut
    std::vector<NewCorner> m_corners;
    CornerVertices m_cornerVertices{m_triangulation, m_mesh, m_faces, m_vertices};
    std::unordered_map<std::uint64_t, std::uint32_t> m_split;
    std::vector<Vec3d> m_facing;
    std::vector<std::uint32_t> m_cells;
    VertexPlaces m_before; ///< of vertices, new ones too, on the triangles as they were
    std::vector<std::array<std::uint32_t, 3>> m_between;
    CreaseFinder m_finder{m_surface};
};

} // namespace

CutMesh cutAtCreases(const cells::CellSurface& surface, Mesh mesh, std::vector<CreaseVertex> onFaces,
                     CreaseMemory& memory, const base::Progress& progress) {
    return CreaseCutter(surface, std::move(mesh), std::move(onFaces), memory).run(progress);
}

} // namespace mesh
