#include "core/mesh/marching/relax_mesh.h"

#include "core/mesh/connectivity/triangulation.h"
#include "core/mesh/finish/own_sheet.h"
#include "core/mesh/marching/slabs.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/surface/curves/boundary.h"
#include "core/surface/evaluation/packets.h"
#include "core/surface/rays/intersect.h"

#include <algorithm>

namespace mesh {

using base::Vec3d, base::Vec3f;
using surface::Evaluationf;

namespace {

constexpr std::size_t grain = 8192;
constexpr const char* step = "shaping triangles";
constexpr double farthest = 0.5;             ///< of a cell, per move
constexpr double loose = 0.03, tight = 2e-3; ///< of the spacing: steps of Newton's method after which none is needed
constexpr double certain = 2e-5;             ///< the same where one sheet is not alone
constexpr float oneSheet = 0.95f;            ///< agreement above which it is
constexpr float steadiest = 0.6f;            ///< least cosine between a vertex' normals before and after a move

struct Settled {
    bool good = false;
    Vec3d position;
    Vec3f normal;
};

class Relaxer {
  public:
    Relaxer(Mesh& mesh, const surface::Surface& surface, const RelaxOptions& options)
        : m_mesh(mesh), m_surface(surface), m_traits(surface), m_options(options), m_triangulation(mesh),
          m_spacing(process::typicalSpacing(surface.tree())), m_landed(mesh.positions.size()) {
        lookAround();
    }

    void pass(bool last, const base::Progress& progress) {
        std::vector<Vec3d> targets(m_mesh.positions.size());
        base::parallelChunks(targets.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<std::uint32_t> ring;
            for (std::size_t v = begin; v < end; ++v)
                if (moves(v))
                    targets[v] = target(static_cast<std::uint32_t>(v), ring);
        });
        move(
            targets, last ? tight : loose, [&](std::size_t v) { return moves(v); }, progress);
    }

    /// Vertices that no pass has put there, onto the surface.
    void landTheRest(const base::Progress& progress) {
        const std::vector<Vec3d> targets = m_mesh.positions;
        const auto rest = [&](std::size_t v) { return moves(v) && m_landed[v] == 0 && !bridge(v); };
        move(targets, tight, rest, progress);
    }

  private:
    /// There is no surface under those: they only go to the middle of their neighbours.
    bool bridge(std::size_t v) const { return m_mesh.kinds[v] == VertexKind::Bridge; }
    bool moves(std::size_t v) const { return m_near.empty() || m_near[v] != 0; }

    double cellAt(std::size_t v) const { return m_options.cells.empty() ? m_options.cell : double(m_options.cells[v]); }

    void lookAround() {
        constexpr int rings = 4;
        if (m_options.about.empty())
            return;
        m_near.resize(m_mesh.positions.size());
        std::vector<std::uint32_t> ring = m_options.about, faces;
        for (int i = 0; i <= rings; ++i) {
            std::vector<std::uint32_t> next;
            for (const std::uint32_t v : ring) {
                if (std::exchange(m_near[v], std::uint8_t(1)))
                    continue;
                m_triangulation.oneRing(v, faces);
                for (const std::uint32_t t : faces)
                    next.insert(next.end(), m_mesh.triangles[t].begin(), m_mesh.triangles[t].end());
            }
            ring = std::move(next);
        }
    }

    /// Along the surface towards the middle of the neighbours. `ring` is scratch.
    Vec3d target(std::uint32_t v, std::vector<std::uint32_t>& ring) const {
        const Vec3d here = m_mesh.positions[v];
        const VertexKind kind = m_mesh.kinds[v];
        if (kind == VertexKind::Limit || (kind == VertexKind::Fold && m_triangulation.onBoundary(v)))
            return alongBoundary(v);
        m_triangulation.oneRing(v, ring);
        std::sort(ring.begin(), ring.end()); // sums depend on the order, which depends on how triangles are turned
        Vec3d sum;
        double reach = 0;
        int count = 0;
        for (const std::uint32_t t : ring)
            for (const std::uint32_t other : m_mesh.triangles[t])
                if (other != v) {
                    sum += m_mesh.positions[other] - here;
                    reach += distance(m_mesh.positions[other], here);
                    ++count;
                }
        if (count == 0)
            return here;
        if (bridge(v))
            return here + limited(sum / count * m_options.share, cellAt(v));
        const Vec3d n = base::cast<double>(m_mesh.normals[v]);
        return here + limited(along(sum / count, n) * m_options.share, std::max(cellAt(v), reach / count));
    }

    /// Towards the middle of the two neighbours on the boundary.
    Vec3d alongBoundary(std::uint32_t v) const {
        const Vec3d here = m_mesh.positions[v];
        Vec3d sum;
        for (const Side& side : m_triangulation.boundarySides(v))
            if (side.exists())
                sum += m_mesh.positions[m_triangulation.otherEnd(side, v)] - here;
        return here + limited(sum * (0.5 * m_options.share), cellAt(v));
    }

    static Vec3d along(const Vec3d& d, const Vec3d& normal) { return d - normal * dot(d, normal); }
    static Vec3d limited(const Vec3d& d, double around) {
        const double size = length(d), most = farthest * around;
        return size > most ? d * (most / size) : d;
    }

    template <class Which>
    void move(std::span<const Vec3d> targets, double enough, const Which& which, const base::Progress& progress) {
        std::vector<Settled> next(targets.size());
        parallelSlabs(targets.size(), grain, progress, step, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<Vec3f> x;
            std::vector<std::size_t> vertices;
            for (std::size_t v = begin; v < end; ++v)
                if (which(v) && bridge(v)) {
                    next[v] = {true, targets[v], m_mesh.normals[v]};
                } else if (which(v)) {
                    x.push_back(base::cast<float>(targets[v]));
                    vertices.push_back(v);
                }
            surface::forPacketsWithin(m_surface, x, 0.1 * m_options.cell, [&](surface::Source& source, std::size_t i) {
                const std::size_t v = vertices[i];
                next[v] = m_mesh.kinds[v] == VertexKind::Limit ? onRim(targets[v], v)
                                                               : settled(source, targets[v], v, enough);
                if (!next[v].good)
                    next[v] = byOwnSheet(targets[v], v);
            });
        });
        take(next);
        for (std::size_t v = 0; v < next.size(); ++v)
            m_landed[v] = which(v) ? enough <= tight && next[v].good : m_landed[v];
    }

    /// Moves vertices, but where that turns a triangle over. What they had stays in `next`.
    void take(std::span<Settled> next) {
        base::parallelFor(next.size(), grain, [&](std::size_t v) {
            if (!next[v].good)
                return;
            std::swap(next[v].position, m_mesh.positions[v]);
            std::swap(next[v].normal, m_mesh.normals[v]);
        });
        keepFacing(next);
    }

    /// The surface may have been met at a step of f: its own sheet is then up to half a spacing away.
    Settled byOwnSheet(const Vec3d& start, std::size_t v) const {
        const Vec3f before = m_mesh.normals[v];
        const double far = farthest * (m_options.cells.empty() ? std::max(m_options.cell, m_spacing) : cellAt(v));
        const auto found = ontoOwnSheet(m_surface, m_traits, start, before, far);
        return found ? Settled{dot(found->normal, before) >= steadiest, found->position, found->normal} : Settled{};
    }

    /// With the sign of the vertex' normal where signs mean nothing.
    Vec3f facing(const Vec3f& normal, std::size_t v) const {
        return !m_traits.oriented && dot(normal, m_mesh.normals[v]) < 0 ? -normal : normal;
    }

    /// Newton's method along the gradient.
    Settled settled(surface::Source& source, const Vec3d& start, std::size_t v, double enough) const {
        const Vec3f before = m_mesh.normals[v];
        Vec3d x = start;
        for (int i = 0; i < 8; ++i) {
            Evaluationf at;
            const Vec3f rounded = base::cast<float>(x);
            source.evaluate(rounded, surface::Need::Gradient, {}, at);
            if (!surface::isSurface(at))
                return {};
            const Vec3d g = base::cast<double>(at.gradient), by = g * (-double(at.value) / lengthSq(g));
            x = base::cast<double>(rounded) + by;
            const double size = length(by);
            if (size > farthest * cellAt(v))
                return {};
            // where near sheets meet f may have steps: only what was evaluated counts
            const double still = at.agreement < oneSheet ? certain : enough;
            if (size > still * m_traits.spacingsPerUnit * double(at.unit))
                continue;
            const Vec3f normal = facing(base::normalized(at.gradient), v);
            return {dot(normal, before) >= steadiest, x, normal};
        }
        return {};
    }

    Settled onRim(const Vec3d& start, std::size_t v) const {
        // as the surface answers unasked, where that leads to a boundary
        if (const Settled out = onRim(start, v, {}); out.good)
            return out;
        Settled out = onRim(start, v, {m_mesh.normals[v]});
        for (int turn = 0; turn < 3 && out.good; ++turn)
            out = onRim(out.position, v, {out.normal});
        return out;
    }
    Settled onRim(const Vec3d& start, std::size_t v, const surface::OrientationHint& sheet) const {
        const surface::BoundarySearch found = surface::findBoundaryPoint(m_surface, start, sheet);
        if (!found.ok() || distance(found.point.position, start) > farthest * cellAt(v))
            return {};
        const Vec3f normal = facing(base::cast<float>(found.point.normal), v);
        return {dot(normal, m_mesh.normals[v]) >= steadiest, found.point.position, normal};
    }

    /// Corners of triangles that a pass has turned over go back to where they were, again until none is left. What
    /// had no area, as beside ends of folds, cannot be turned over.
    void keepFacing(std::span<Settled> before) {
        const auto leastArea = [&](const Triangle& t) { return 1e-6 * cellAt(t[0]) * cellAt(t[0]); };
        const auto facingOf = [&](const Triangle& t, const auto& vertex) {
            const std::array<Settled, 3> corners{vertex(t[0]), vertex(t[1]), vertex(t[2])};
            const Vec3d area =
                cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position);
            double sum = 0;
            for (const Settled& corner : corners)
                sum += dot(area, base::cast<double>(corner.normal));
            return sum;
        };
        const auto now = [&](std::uint32_t v) { return Settled{true, m_mesh.positions[v], m_mesh.normals[v]}; };
        const auto then = [&](std::uint32_t v) { return before[v].good ? before[v] : now(v); };
        for (int round = 0; round < 8; ++round) {
            std::vector<std::vector<std::uint32_t>> turned(base::chunkCount(m_mesh.triangles.size(), grain));
            base::parallelChunks(m_mesh.triangles.size(), grain,
                                 [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                                     for (std::size_t t = begin; t < end; ++t)
                                         if (facingOf(m_mesh.triangles[t], now) < 0 &&
                                             facingOf(m_mesh.triangles[t], then) > leastArea(m_mesh.triangles[t]))
                                             turned[chunk].push_back(static_cast<std::uint32_t>(t));
                                 });
            bool any = false;
            for (const auto& part : turned)
                for (const std::uint32_t t : part)
                    for (const std::uint32_t v : m_mesh.triangles[t])
                        if (before[v].good) {
                            m_mesh.positions[v] = before[v].position;
                            m_mesh.normals[v] = before[v].normal;
                            before[v].good = false;
                            any = true;
                        }
            if (!any)
                return;
        }
    }

    Mesh& m_mesh;
    const surface::Surface& m_surface;
    SurfaceTraits m_traits;
    const RelaxOptions& m_options;
    Triangulation m_triangulation;
    double m_spacing;
    std::vector<std::uint8_t> m_near;   ///< does the vertex move? Empty: all do
    std::vector<std::uint8_t> m_landed; ///< is the vertex on the surface, as closely as can be?
};

} // namespace

void relax(Mesh& mesh, const surface::Surface& surface, const RelaxOptions& options, const base::Progress& progress) {
    Relaxer relaxer(mesh, surface, options);
    const double share = 1.0 / (options.passes + 1);
    for (int pass = 0; pass < options.passes; ++pass)
        relaxer.pass(pass + 1 == options.passes, process::part(progress, pass * share, (pass + 1) * share));
    relaxer.landTheRest(process::part(progress, options.passes * share, 1));
}

} // namespace mesh
