#include "core/process/registering/feet.h"

#include "core/base/parallel.h"
#include "core/surface/projection/project.h"

namespace process {

using base::Vec3d, base::Vec3f;

AskedPoints askedPoints(const surface::Surface& surface, std::size_t count) {
    const surfel::SurfelList list = surface.tree().surfels();
    AskedPoints out;
    out.oriented = list.layout->normals && list.layout->oriented;
    count = std::min(count, list.size());
    for (std::size_t k = 0; k < count; ++k) {
        const surfel::Surfel& s = list.items[k * list.size() / count];
        out.position.push_back(base::cast<double>(s.position));
        out.normal.push_back(base::cast<double>(s.normal));
    }
    return out;
}

std::vector<std::uint32_t> pointsNear(const surface::Surface& on, const AskedPoints& asked, const Rigid& there,
                                      float reach) {
    const base::Box3f box = on.tree().bounds().inflated(reach);
    std::vector<std::uint8_t> is(asked.position.size());
    base::parallelFor(is.size(), 64, [&](std::size_t i) {
        std::vector<tree::Neighbour> found;
        if (const Vec3f p = base::cast<float>(there(asked.position[i])); box.contains(p))
            on.tree().nearest(p, 1, found, reach);
        is[i] = !found.empty();
    });
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < is.size(); ++i)
        if (is[i])
            out.push_back(i);
    return out;
}

namespace {

/// Feet as exact as weights and normals need them; what does not get there soon lies beyond or between.
surface::ProjectOptions footing() {
    surface::ProjectOptions out;
    out.tolerance = 1e-5;
    out.maxIterations = 10;
    return out;
}

void add(const std::vector<Placed>& models, const std::vector<AskedPoints>& asked, std::uint32_t from, std::uint32_t to,
         double reach, std::vector<FootPair>& out) {
    constexpr double sameSide = 0.5; // cosine between a point's normal and its foot's
    const surface::Surface& on = models[to].surface;
    const Rigid &pose = models[to].pose, there = pose.inverse() * models[from].pose;
    const std::vector<std::uint32_t> which = pointsNear(on, asked[from], there, static_cast<float>(reach));
    std::vector<Vec3f> moved;
    for (const std::uint32_t i : which)
        moved.push_back(base::cast<float>(there(asked[from].position[i])));
    std::vector<surface::Projection<float>> feet(moved.size());
    surface::project(on, moved, footing(), feet);
    const bool sided = asked[from].oriented && asked[to].oriented;
    for (std::size_t k = 0; k < feet.size(); ++k) {
        if (!feet[k].ok())
            continue;
        const Vec3d foot = base::cast<double>(feet[k].foot), p = base::cast<double>(moved[k]);
        const Vec3d n = base::normalized(base::cast<double>(feet[k].at.gradient));
        const double along = dot(n, there.turn(asked[from].normal[which[k]])), alike = sided ? along : std::abs(along);
        if (const double far = base::distance(foot, p); far <= reach && alike >= sameSide)
            out.push_back({from, to, which[k], pose(p), pose.turn(n), dot(n, p - foot), far, alike});
    }
}

} // namespace

std::vector<FootPair> footPairs(const std::vector<Placed>& models, const std::vector<AskedPoints>& asked,
                                double reach) {
    std::vector<FootPair> out;
    for (std::uint32_t from = 0; from < models.size(); ++from)
        for (std::uint32_t to = 0; to < models.size(); ++to)
            if (from != to)
                add(models, asked, from, to, reach, out);
    return out;
}

} // namespace process
