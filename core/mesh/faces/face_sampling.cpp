#include "core/mesh/faces/face_sampling.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/faces/crease_chains.h"
#include "core/mesh/faces/face_spacing.h"
#include "core/mesh/faces/figures.h"
#include "core/mesh/faces/piece_spacings.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/resampling/resample.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mesh {

namespace {

using base::Vec3f;

constexpr std::size_t mostSamples = 200'000'000;
constexpr double fewestSamples = 64; ///< of a spacing: fewer are a slip of the unit
constexpr double resolvedWall = 2.5; ///< spacings
constexpr double supportSlope = 0.5; ///< by which supports differ over their distance (process/README 1.3)
constexpr double muchFiner = 1.1;    ///< spacings that differ by more are told
constexpr int fewRounds = 6;
constexpr double nearlyAll = 0.02; ///< of the samples

base::Error tooMany() {
    return base::Error("sampling the faces so finely takes more than " + grouped(mostSamples) + " surfels", "",
                       "choose a larger spacing or a smaller count");
}

std::size_t samplesFor(const FaceTopology& topology, double share, double wall, const FaceOptions& options) {
    if (options.count == 0 && options.spacing <= 0)
        return fittingCount(topology, wall, share);
    const double wanted = options.count > 0 ? static_cast<double>(options.count)
                                            : std::ceil(topology.area * share / (options.spacing * options.spacing));
    if (!(wanted / share <= static_cast<double>(mostSamples))) // with candidates for those that are inside
        throw tooMany();
    if (options.count == 0 && wanted < fewestSamples)
        throw base::Error("a spacing of " + rounded(options.spacing) + " leaves only " +
                              grouped(static_cast<std::size_t>(wanted)) + " surfels of the faces",
                          "", "choose a smaller spacing");
    return std::max<std::size_t>(4, static_cast<std::size_t>(wanted));
}

FaceSampling evenly(const FaceTopology& topology, std::span<const Vec3f> positions, const InnerPlaces& inside,
                    const FaceOptions& options, const base::Progress& progress) {
    const double share = inside.outerShare();
    const double wall = thinnestWall(topology, positions, process::part(progress, 0, 0.3), &inside);
    const std::size_t count = samplesFor(topology, share, wall, options);
    const double spacing = std::sqrt(topology.area * share / static_cast<double>(count));
    FaceSampling out;
    out.points = spreadPoints(topology, positions, count, process::part(progress, 0.3, 0.9), &inside, nullptr,
                              clearChains(topology, spacing).patches);
    out.spacings = {std::sqrt(topology.area * share / static_cast<double>(out.points.size()))};
    out.apart = wall >= resolvedWall * out.spacings[0];
    return out;
}

/// Each piece as it needs.
FaceSampling piecewise(const FaceTopology& topology, std::span<const Vec3f> positions, const InnerPlaces& inside,
                       const surface::SurfaceDefinition& definition, std::size_t count,
                       const base::Progress& progress) {
    if (!(static_cast<double>(count) / inside.outerShare() <= static_cast<double>(mostSamples)))
        throw tooMany();
    PieceSpacings pieces = pieceSpacings(topology, positions, inside, count, process::part(progress, 0, 0.3));
    const double slope = supportSlope * static_cast<double>(process::spacingOf(definition, 1));
    std::optional<FaceDensity> density;
    double wanted = 0, all = 0;
    for (int round = 0; round < fewRounds; ++round) { // what is graded gets less as all of it gets coarser
        progress.step(0.3, "Sampling faces");
        density.reset();
        density.emplace(topology, positions, pieces.spacings, pieces.places, slope);
        wanted = samplesOn(density->parts(), topology, &inside);
        all = count > 0 ? static_cast<double>(count) : std::min(wanted, mostSamplesOf(topology, pieces.spacings));
        if (std::abs(wanted - all) < nearlyAll * all)
            break;
        pieces.scale(std::sqrt(wanted / all));
    }
    FaceSampling out;
    out.points = spreadPoints(topology, positions, std::max<std::size_t>(4, static_cast<std::size_t>(all)),
                              process::part(progress, 0.3, 0.9), &inside, &*density,
                              clearChains(topology, pieces.spacings).patches);
    const double wider = std::sqrt(wanted / static_cast<double>(out.points.size()));
    out.spacings.resize(out.points.size());
    base::parallelFor(out.points.size(), 1024, [&](std::size_t i) {
        const FacePoint& point = out.points[i];
        out.spacings[i] = wider * density->at(placeOf(point, topology, positions), point.triangle);
    });
    out.apart = true;
    for (std::size_t i = 0; i < pieces.walls.size(); ++i)
        out.apart = out.apart && !(pieces.walls[i] < resolvedWall * wider * pieces.spacings[i]);
    return out;
}

} // namespace

std::string FaceSampling::toldSpacing() const {
    const auto [least, most] = std::minmax_element(spacings.begin(), spacings.end());
    return rounded(*least) + (*most > muchFiner * *least ? " to " + rounded(*most) : "");
}

FaceSampling sampleFaces(const FaceTopology& topology, std::span<const Vec3f> positions, const InnerPlaces& inside,
                         const surface::SurfaceDefinition& definition, const FaceOptions& options,
                         const base::Progress& progress) {
    return topology.pieceCount > 1 && !(options.spacing > 0)
               ? piecewise(topology, positions, inside, definition, options.count, progress)
               : evenly(topology, positions, inside, options, progress);
}

} // namespace mesh
