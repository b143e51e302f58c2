// A binary PLY of 27 bytes a point, as scanners' own programs write: to points in memory, and on to a tree to sculpt.
#include "app/bench/naive/naive_file.h"
#include "app/bench/scan_file.h"
#include "app/bench/workload.h"
#include "core/io/formats.h"
#include "core/process/estimation/normals.h"
#include "core/process/estimation/prepare.h"

namespace bench {

namespace {

Run loading(Scene& scene) {
    return [file = std::make_shared<ScanFile>(scene)] {
        const io::FileModel model = io::read((*file)->path);
        keep(model);
        return model.points.size();
    };
}

Run naiveLoading(Scene& scene) {
    return [file = std::make_shared<ScanFile>(scene)] {
        const std::vector<surfel::Surfel> points = naiveLoad(**file);
        keep(points);
        return points.size();
    };
}

/// As `open` does it, under the definition that a file without one gets.
Run opening(Scene& scene) {
    return [file = std::make_shared<ScanFile>(scene)] {
        io::FileModel model = io::read((*file)->path);
        std::size_t merged = 0;
        const surface::Surface surface = process::prepare(std::move(model.points), {{}, false, false, &merged});
        keep(surface);
        return surface.tree().size() + merged;
    };
}

Run naiveOpening(Scene& scene) {
    return [file = std::make_shared<ScanFile>(scene)] {
        const std::vector<surfel::Surfel> points = naiveOpen(**file, surface::SurfaceDefinition().neighbours);
        keep(points);
        return points.size();
    };
}

/// Without normals: estimated and oriented, duplicates merged, as a raw scan is opened.
Run openingPoints(Scene& scene) {
    return [file = std::make_shared<ScanFile>(scene, ScanFile::Normals::Without)] {
        io::FileModel model = io::read((*file)->path);
        std::size_t merged = 0;
        const surface::Surface surface = process::prepare(std::move(model.points), {{}, false, false, &merged});
        keep(surface);
        return surface.tree().size() + merged;
    };
}

Run naiveOpeningPoints(Scene& scene) {
    return [file = std::make_shared<ScanFile>(scene, ScanFile::Normals::Without)] {
        const std::vector<surfel::Surfel> points = naiveOpenRaw(**file, surface::SurfaceDefinition().neighbours);
        keep(points);
        return points.size();
    };
}

/// Points in no particular order that know nothing but their places.
surfel::SurfelList barePoints(Scene& scene) {
    surfel::SurfelList out = scene.unsorted();
    auto layout = std::make_shared<surfel::AttributeLayout>(*out.layout);
    layout->normals = layout->oriented = false;
    out.layout = layout;
    return out;
}

Run estimatingNormals(Scene& scene) {
    return [points = barePoints(scene)] {
        surfel::SurfelList out = points;
        process::estimateNormals(out);
        keep(out.items);
        return out.size();
    };
}

Run orientingNormals(Scene& scene) {
    surfel::SurfelList points = barePoints(scene);
    process::estimateNormals(points);
    return [points = std::move(points)] {
        surfel::SurfelList out = points;
        keep(process::orientNormals(out));
        return out.size();
    };
}

} // namespace

std::vector<Workload> fileWorkloads() {
    return {
        {"load-ply", "point", "a binary PLY of 27 bytes a point, read and checked",
         "the bytes copied into arrays, nothing checked", loading, naiveLoading, false, false},
        {"open-ply", "point", "the same up to a tree to sculpt: spacing, graded supports, boundary limit, tree",
         "the bytes copied into arrays, sorted along a Morton curve, nanoflann for 6 nearest and as the index; "
         "supports "
         "not graded",
         opening, naiveOpening, true},
        {"open-points", "point", "the same for a file without normals, which are estimated and oriented",
         "the same, nanoflann for 18 nearest, principal components, a minimum spanning tree for the signs",
         openingPoints, naiveOpeningPoints, true},
        {"normals",
         "point",
         "normals from the 18 nearest, of points in no particular order",
         "",
         estimatingNormals,
         {}},
        {"orient", "point", "their sides, as neighbours and the whole say", "", orientingNormals, {}},
    };
}

} // namespace bench
