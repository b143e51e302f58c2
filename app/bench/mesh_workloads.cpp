// Tessellation: triangles per second.
#include "app/bench/naive_surface.h"
#include "app/bench/workload.h"
#include "core/mesh/delaunay/delaunay.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/estimation/spacing_sample.h"

#include <bit>

namespace bench {

namespace {

using base::Vec3d;

Run marching(Scene& scene) {
    return [&surface = scene.surface()] {
        mesh::MarchingReport report;
        const mesh::Mesh made = mesh::marchingCubes(surface, {}, report);
        keep(made);
        return made.triangles.size();
    };
}

/// What a table of 256 cases says in other words: around a cube whose corners' signs have `changes` sign changes along
/// its edges there are that many vertices, and a loop of n has n - 2 triangles; most cubes have one loop.
std::size_t trianglesOf(const double (&f)[8]) {
    std::size_t changes = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
        for (unsigned axis = 0; axis < 3; ++axis)
            if (const unsigned other = corner | 1u << axis; other != corner)
                changes += (f[corner] < 0) != (f[other] < 0) ? 1 : 0;
    return changes < 3 ? 0 : changes - 2;
}

/// A dense grid over the model's box, one evaluation per node, signs at the corners, crossings by linear interpolation:
/// as textbooks have it. A call does one layer of nodes
/// and the cubes beside it, in the model's middle.
class NaiveMarch {
  public:
    NaiveMarch(const surface::Surface& surface, const NaiveSurface& naive)
        : m_naive(naive), m_cell(double(process::typicalSpacing(surface.tree()))) {
        const base::Box3f box = surface.tree().bounds().inflated(static_cast<float>(2 * m_cell));
        m_lo = base::cast<double>(box.lo);
        const Vec3d size = base::cast<double>(box.size());
        for (std::size_t axis = 0; axis < 3; ++axis)
            m_count[axis] = static_cast<std::size_t>(size[axis] / m_cell) + 2;
        evaluateLayer(m_below);
    }

    std::size_t next() {
        m_up = !m_up;
        std::vector<double> above;
        evaluateLayer(above);
        std::size_t triangles = 0;
        for (std::size_t y = 0; y + 1 < m_count[1]; ++y)
            for (std::size_t x = 0; x + 1 < m_count[0]; ++x)
                triangles += cube(above, x, y);
        m_below.swap(above);
        return triangles;
    }

  private:
    void evaluateLayer(std::vector<double>& out) {
        out.resize(m_count[1] * m_count[0]);
        for (std::size_t y = 0; y < m_count[1]; ++y)
            for (std::size_t x = 0; x < m_count[0]; ++x) {
                const Vec3d at = m_lo + Vec3d{double(x), double(y), double(m_count[2] / 2 + (m_up ? 1 : 0))} * m_cell;
                const NaiveEvaluation e = m_naive.evaluate(at, surface::Need::Value);
                out[y * m_count[0] + x] = e.valid ? e.value : std::numeric_limits<double>::quiet_NaN();
            }
    }

    std::size_t cube(const std::vector<double>& above, std::size_t x, std::size_t y) const {
        double f[8];
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::size_t at = (y + (corner >> 1 & 1)) * m_count[0] + x + (corner & 1);
            f[corner] = (corner & 4 ? above : m_below)[at];
            if (!std::isfinite(f[corner]))
                return 0;
        }
        double places = 0;
        for (unsigned corner = 0; corner < 8; ++corner)
            for (unsigned axis = 0; axis < 3; ++axis)
                if (const unsigned other = corner | 1u << axis; (f[corner] < 0) != (f[other] < 0))
                    places += f[corner] / (f[corner] - f[other]);
        keep(places);
        return trianglesOf(f);
    }

    const NaiveSurface& m_naive;
    double m_cell;
    Vec3d m_lo;
    std::size_t m_count[3] = {};
    bool m_up = false;
    std::vector<double> m_below;
};

Run naiveMarching(Scene& scene) {
    if (!NaiveSurface::speaks(scene.surface()))
        return {};
    return [march = NaiveMarch(scene.surface(), scene.naive())]() mutable { return march.next(); };
}

/// Triangles about as large as the spacing.
Run triangulating(Scene& scene) {
    const mesh::DelaunayOptions options;
    return [&surface = scene.surface(), options] {
        mesh::DelaunayReport report;
        const mesh::Mesh made = mesh::restrictedDelaunay(surface, options, report);
        keep(made);
        return made.triangles.size();
    };
}

} // namespace

std::vector<Workload> meshWorkloads() {
    constexpr const char* denseGrid = "dense grid, nanoflann, Eigen double, corner signs";
    return {
        {"mesh-marching-cubes", "triangle", "marching cubes, cells of one spacing", denseGrid, marching, naiveMarching},
        {"mesh-delaunay", "triangle", "restricted Delaunay triangulation, sizes of one spacing", denseGrid,
         triangulating, naiveMarching},
    };
}

} // namespace bench
