#include "core/process/estimation/normals.h"

#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/orientation/global_orientation.h"
#include "core/process/estimation/part_progress.h"

namespace process {

namespace {

void setFlags(surfel::SurfelList& points, bool oriented) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*points.layout);
    layout->normals = true;
    layout->oriented = oriented;
    points.layout = std::move(layout);
}

} // namespace

std::vector<base::Vec3f> normalsOf(const Cloud& cloud, int neighbours, const base::Progress& progress) {
    std::vector<base::Vec3f> out(cloud.size(), {0, 0, 1});
    if (cloud.size() > 2)
        cloud.forEachCell(
            static_cast<std::size_t>(neighbours), progress, "Estimating normals",
            [&](const NearestRows& rows) { planeNormals(cloud.positions(), rows, rows.k, out.data() + rows.first); });
    return out;
}

void estimateNormals(surfel::SurfelList& points, int neighbours, const base::Progress& progress) {
    const Cloud cloud(points.items, part(progress, 0, 0.2));
    const std::vector<base::Vec3f> normals = normalsOf(cloud, neighbours, part(progress, 0.2, 1));
    for (std::size_t i = 0; i < points.size(); ++i)
        points.items[i].normal = normals[cloud.places()[i]];
    setFlags(points, false);
}

bool orientNormals(surfel::SurfelList& points, int neighbours, const base::Progress& progress) {
    const Cloud cloud(points.items, part(progress, 0, 0.2));
    std::vector<base::Vec3f> normals(cloud.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        normals[cloud.places()[i]] = points.items[i].normal;
    const NeighbourTable links = nearestTable(cloud, static_cast<std::size_t>(neighbours), part(progress, 0.2, 0.5));
    if (!orientGlobally(cloud, links, normals, part(progress, 0.5, 1))) {
        setFlags(points, false);
        return false;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        // Coincident points may differ in their normals: each one turns towards what its place decided.
        base::Vec3f& n = points.items[i].normal;
        if (base::dot(n, normals[cloud.places()[i]]) < 0)
            n = -n;
    }
    setFlags(points, true);
    return true;
}

} // namespace process
