// First hits of rays near seams, beside the same rays where nobody knows of creases.
#include "app/bench/batches.h"
#include "app/bench/workload.h"
#include "core/base/random.h"
#include "core/cells/cell_rays.h"

namespace bench {

using base::Rayf, base::Vec3d;

namespace {

constexpr std::size_t batchSize = 16384, rayCount = 65536;

/// A cube of side 2 of about so many surfels, in rows that jitter a little; a cell for each face.
surface::Surface cube(std::size_t count) {
    const auto rows = static_cast<std::size_t>(std::max(4.0, std::round(std::sqrt(static_cast<double>(count) / 6))));
    const double spacing = 2.0 / static_cast<double>(rows);
    base::Random random(6);
    surfel::SurfelList out;
    std::vector<cells::Label> labels;
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::size_t i = 0; i < rows * rows; ++i) {
            const std::size_t axis = face / 2;
            const double side = face % 2 == 0 ? 1 : -1;
            const auto at = [&](std::size_t row) {
                return (static_cast<double>(row) + 0.5 + random.uniform(-0.2, 0.2)) * spacing - 1;
            };
            Vec3d p, n;
            n[axis] = p[axis] = side;
            p[(axis + 1) % 3] = at(i % rows);
            p[(axis + 2) % 3] = at(i / rows);
            surfel::Surfel s;
            s.position = base::cast<float>(p);
            s.normal = base::cast<float>(n);
            s.support = static_cast<float>(3.5 * spacing);
            out.items.push_back(s);
            cells::Label label{face, face, cells::Meeting::None, 255, face};
            for (double nearest = 2 * spacing; const std::size_t other : {(axis + 1) % 3, (axis + 2) % 3})
                if (const double far = 1 - std::abs(p[other]); far < nearest) {
                    nearest = far;
                    label.partner = static_cast<std::uint32_t>(2 * other + (p[other] > 0 ? 0 : 1));
                    label.meeting = cells::Meeting::Convex;
                }
            labels.push_back(label);
        }
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    cells::setLabels(out, labels);
    return {tree::SurfelTree::build(out), {}};
}

/// A model with creases, the scene's or a cube as large, and rays from all sides to within a spacing of its seams.
struct Seams {
    cells::CellSurface cells;
    std::vector<Rayf> rays;
    Batches<Rayf> batches;
    std::vector<surface::RayHit<float>> out;

    explicit Seams(const cells::CellSurface& surface)
        : cells(surface), rays(raysAt(surface)), batches(rays, batchSize), out(batches.size()) {}

    Seams(const Seams&) = delete;
    Seams& operator=(const Seams&) = delete;

    static std::shared_ptr<Seams> of(Scene& scene) {
        if (const auto own = cells::CellSurface::of(scene.surface()); own && !besideSeams(*own).empty())
            return std::make_shared<Seams>(*own);
        return std::make_shared<Seams>(*cells::CellSurface::of(cube(scene.size())));
    }

  private:
    static std::vector<surfel::Surfel> besideSeams(const cells::CellSurface& surface) {
        const surfel::SurfelList all = surface.surface().tree().surfels();
        std::vector<surfel::Surfel> out;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (surface.labels().at(all.extraOf(i)).meeting != cells::Meeting::None)
                out.push_back(all.items[i]);
        return out;
    }
    static std::vector<Rayf> raysAt(const cells::CellSurface& surface) {
        constexpr double spacingOfSupport = 1 / 3.5;
        const std::vector<surfel::Surfel> beside = besideSeams(surface);
        const base::Box3f box = surface.surface().tree().bounds();
        const Vec3d centre = base::cast<double>(box.centre());
        base::Random random(7);
        std::vector<Rayf> out;
        for (std::size_t k = 0; k < rayCount; ++k) {
            const surfel::Surfel& s = beside[random.below(beside.size())];
            const double spacing = spacingOfSupport * static_cast<double>(s.support);
            const Vec3d to = base::cast<double>(s.position) + random.unitVector() * (spacing * random.uniform());
            const Vec3d from = centre + random.unitVector() * (1.5 * static_cast<double>(box.diagonal()));
            out.push_back({base::cast<float>(from), base::cast<float>(base::normalized(to - from))});
        }
        return out;
    }
};

template <class Cast>
Run casting(Scene& scene, const Cast& cast) {
    return [seams = Seams::of(scene), cast] {
        cast(seams->cells, seams->batches.next(), seams->out);
        keep(seams->out);
        return seams->out.size();
    };
}

} // namespace

std::vector<Workload> seamWorkloads() {
    using Rays = std::span<const Rayf>;
    using Hits = std::vector<surface::RayHit<float>>;
    return {{"rays-seams", "ray",
             "first hit of rays from all sides to within a spacing of seams; of a cube where the model has no creases",
             "ours: the same rays without cells",
             [](Scene& scene) {
                 return casting(scene, [](const cells::CellSurface& c, Rays rays, Hits& out) {
                     cells::intersect(c, rays, {}, out);
                 });
             },
             [](Scene& scene) {
                 return casting(scene, [](const cells::CellSurface& c, Rays rays, Hits& out) {
                     surface::intersect(c.surface(), rays, {}, out);
                 });
             }}};
}

} // namespace bench
