#include "core/cells/creases/detect_creases.h"

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/cells/creases/cell_refit.h"
#include "core/cells/creases/labelled_surface.h"
#include "core/cells/creases/link_bands.h"
#include "core/cells/creases/link_faces.h"
#include "core/cells/creases/link_labels.h"
#include "core/cells/creases/point_normals.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cells {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr double weakPart = 0.69;       ///< of the angle: links that belong to a crease where others tell of it
constexpr std::size_t fewestStrong = 4; ///< links of a crease that turn by the angle
constexpr double shortest = 3.5;        ///< spacings
constexpr double mostNoise = 0.25;      ///< spacings: beyond that the seam is no better than the rounded edge
constexpr int refits = 5;

/// Links that turn, where they make lines.
void cutTurns(SurfelLinks& links, std::span<const Vec3f> normals, double angle) {
    const auto strong = static_cast<float>(std::cos(angle)), weak = static_cast<float>(std::cos(weakPart * angle));
    base::DisjointSets lines(links.size());
    const auto turns = [&](std::uint32_t i, std::uint32_t e, float cosine) {
        return links.link(e).cut == Cut::None && dot(normals[i], normals[links.link(e).other]) < cosine;
    };
    for (std::uint32_t i = 0; i < links.size(); ++i)
        for (std::uint32_t e = links.begin(i); e < links.end(i); ++e)
            if (turns(i, e, weak))
                lines.join(i, links.link(e).other);
    struct Line {
        std::size_t strong = 0;
        base::Box3d box;
        double spacing = 0;
    };
    std::vector<Line> of(links.size());
    for (std::uint32_t i = 0; i < links.size(); ++i)
        for (std::uint32_t e = links.begin(i); e < links.end(i); ++e)
            if (turns(i, e, weak)) {
                Line& line = of[lines.find(i)];
                line.strong += links.link(e).other > i && turns(i, e, strong) ? 1 : 0;
                line.box.extend(links.at(i));
                line.spacing = std::max(line.spacing, links.spacing(i));
            }
    for (std::uint32_t i = 0; i < links.size(); ++i)
        for (std::uint32_t e = links.begin(i); e < links.end(i); ++e) {
            const Line& line = of[lines.find(i)];
            if (turns(i, e, weak) && line.strong >= fewestStrong &&
                length(line.box.hi - line.box.lo) > shortest * line.spacing)
                links.cut(e, Cut::Crease);
        }
}

} // namespace

DetectedCreases detectCreases(const surface::Surface& surface, const DetectOptions& options,
                              const base::Progress& progress) {
    requireSides(surface);
    surfel::SurfelList surfels = surface.tree().surfels();
    progress.step(0, "Looking for neighbours");
    SurfelLinks links(surface.tree(), surfels.items);
    const auto part = [&](double from, double to) {
        base::Progress out = progress;
        if (progress.report)
            out.report = [&progress, from, to](double done, std::string_view what) {
                progress.report(from + (to - from) * done, what);
            };
        return out;
    };
    const PointNormals points = pointNormals(links, part(0.2, 0.6));
    DetectedCreases out;
    out.surface = surface;
    out.noise = points.noise;
    if (points.noise > mostNoise) {
        std::ostringstream said;
        said.precision(2);
        said << "the points lie " << points.noise << " spacings off their surface: no edge can be told from noise";
        throw base::Error(said.str(), {}, "take out noise first (\"denoise\"), or draw creases along lines");
    }
    progress.step(0.6, "Parting faces");
    links.cutWalls(points.normals);
    cutTurns(links, points.normals, options.angleRad);
    const LinkFaces found = facesOfLinks(links);
    out.narrow = found.narrow;
    std::vector<std::uint32_t> cells = splitAtCreases(links, found.faces);
    progress.step(0.8, "Parting faces");
    CellRefit refit(links, cells, found.faces, points.normals, points.noise);
    for (int k = 0; k < refits; ++k)
        refit.reassign();
    refit.takeBackFlat();
    const std::vector<Vec3f> normals = refit.ownNormals();
    std::vector<std::uint32_t> faces(links.size());
    std::vector<Label> labels(links.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        labels[i].cell = labels[i].partner = cells[i];
        labels[i].face = faces[i] = refit.faceOf(static_cast<std::uint32_t>(i));
        surfels.items[i].normal = normals[i];
    }
    labelByLinks(links, cells, faces, normals, options.sharpness, labels);
    out.found = std::any_of(labels.begin(), labels.end(), [](const Label& l) { return l.meeting != Meeting::None; });
    if (out.found)
        out.surface = labelled(surface, std::move(surfels), labels);
    return out;
}

} // namespace cells
