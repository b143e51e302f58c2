#include "core/mesh/faces/face_sampling.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/faces/crease_chains.h"
#include "core/mesh/faces/face_detail.h"
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
constexpr double nearlyAll = 0.02;         ///< of the samples
constexpr double mostForFiner = 1'000'000; ///< samples, where places ask for more than their pieces
constexpr double aLittle = 1.02;
constexpr double mostUnresolved = 0.01; ///< of a piece's places

base::Error tooMany() {
    return base::Error("sampling the faces so finely takes more than " + grouped(mostSamples) + " surfels", "",
                       "choose a larger spacing or a smaller count");
}

void checkAsked(double samples, double share, const FaceOptions& options) {
    if (!(samples / share <= static_cast<double>(mostSamples))) // with candidates for those that are inside
        throw tooMany();
    if (options.spacing > 0 && samples < fewestSamples)
        throw base::Error("a spacing of " + rounded(options.spacing) + " leaves only " +
                              grouped(static_cast<std::size_t>(samples)) + " surfels of the faces",
                          "", "choose a smaller spacing");
}

/// Are the walls, but for one percent of each piece's places, thick enough for samples so far apart?
template <class SpacingAt>
bool resolved(const PieceSpacings& pieces, const SpacingAt& spacingAt) {
    std::vector<std::size_t> all(pieces.spacings.size()), thin(all.size());
    for (std::size_t i = 0; i < pieces.walls.size(); ++i) {
        const auto& [wall, piece] = pieces.walls[i];
        ++all[piece];
        if (std::isfinite(wall) && static_cast<double>(wall) < resolvedWall * spacingAt(i))
            ++thin[piece];
    }
    for (std::size_t piece = 0; piece < all.size(); ++piece)
        if (static_cast<double>(thin[piece]) > mostUnresolved * static_cast<double>(all[piece]))
            return false;
    return true;
}

/// As far apart as that, everywhere.
FaceSampling evenly(const FaceTopology& topology, std::span<const Vec3f> positions, const InnerPlaces& inside,
                    const PieceSpacings& pieces, double spacing, const base::Progress& progress) {
    const double area = topology.area * inside.outerShare();
    const auto count = static_cast<std::size_t>(std::llround(area / (spacing * spacing)));
    FaceSampling out;
    out.points = spreadPoints(topology, positions, std::max<std::size_t>(4, count), process::part(progress, 0.3, 0.9),
                              {&inside, nullptr, clearChains(topology, spacing).patches, true});
    out.spacings = {std::sqrt(area / static_cast<double>(out.points.size()))};
    out.apart = resolved(pieces, [&](std::size_t) { return out.spacings[0]; });
    return out;
}

/// Each place as it needs.
class Uneven {
  public:
    Uneven(const FaceTopology& topology, std::span<const Vec3f> positions, const InnerPlaces& inside, double slope,
           PieceSpacings pieces)
        : m_topology(topology), m_positions(positions), m_inside(inside), m_slope(slope), m_pieces(std::move(pieces)) {}

    /// Makes what is finer coarser until it costs no more than all the rest, or `most` samples are not exceeded.
    void afford(double most) {
        const double without = density(false).samples(&m_inside);
        for (int round = 0; round < fewRounds; ++round) {
            const double more = density(true).samples(&m_inside) - without;
            const double affordable = std::max(without, most - without);
            if (more <= affordable)
                return;
            for (SpacedPlace& each : m_pieces.finer)
                each.spacing *= std::sqrt(more / affordable) * aLittle;
        }
    }

    /// `count`: 0: as many as all that asks for.
    FaceSampling run(std::size_t count, const base::Progress& progress) {
        std::optional<FaceDensity> density;
        double wanted = 0, all = 0;
        for (int round = 0; round < fewRounds; ++round) { // what is graded gets less as all of it gets coarser
            progress.step(0.3, "Sampling faces");
            density.reset();
            density.emplace(this->density(true));
            wanted = density->samples(&m_inside);
            all =
                count > 0 ? static_cast<double>(count) : std::min(wanted, mostSamplesOf(m_topology, m_pieces.spacings));
            if (std::abs(wanted - all) < nearlyAll * all)
                break;
            m_pieces.scale(std::sqrt(wanted / all));
        }
        FaceSampling out;
        out.points = spreadPoints(m_topology, m_positions, std::max<std::size_t>(4, static_cast<std::size_t>(all)),
                                  process::part(progress, 0.3, 0.9),
                                  {&m_inside, &*density, clearChains(m_topology, m_pieces.spacings).patches, true});
        const double wider = std::sqrt(wanted / static_cast<double>(out.points.size()));
        out.spacings.resize(out.points.size());
        base::parallelFor(out.points.size(), 1024, [&](std::size_t i) {
            const FacePoint& point = out.points[i];
            out.spacings[i] = wider * density->at(placeOf(point, m_topology, m_positions), point.triangle);
        });
        out.apart = resolved(m_pieces, [&](std::size_t i) {
            return wider * density->near(m_pieces.places[i].place, m_pieces.spacings[m_pieces.walls[i].piece]);
        });
        return out;
    }

  private:
    FaceDensity density(bool finer) const {
        std::vector<SpacedPlace> places = m_pieces.places;
        if (finer)
            places.insert(places.end(), m_pieces.finer.begin(), m_pieces.finer.end());
        return {m_topology, m_positions, m_pieces.spacings, std::move(places), m_slope};
    }

    const FaceTopology& m_topology;
    std::span<const Vec3f> m_positions;
    const InnerPlaces& m_inside;
    double m_slope;
    PieceSpacings m_pieces;
};

} // namespace

std::string FaceSampling::toldSpacing() const {
    const auto [least, most] = std::minmax_element(spacings.begin(), spacings.end());
    return rounded(*least) + (*most > muchFiner * *least ? " to " + rounded(*most) : "");
}

FaceSampling sampleFaces(const FaceTopology& topology, std::span<const Vec3f> positions, const InnerPlaces& inside,
                         const surface::SurfaceDefinition& definition, const FaceOptions& options,
                         const base::Progress& progress) {
    const double share = inside.outerShare();
    if (options.count > 0)
        checkAsked(static_cast<double>(options.count), share, options);
    if (options.spacing > 0)
        checkAsked(std::ceil(topology.area * share / (options.spacing * options.spacing)), share, options);
    PieceSpacings pieces = pieceSpacings(topology, positions, inside, options.count, process::part(progress, 0, 0.25));
    if (options.spacing > 0)
        return evenly(topology, positions, inside, pieces, options.spacing, progress);
    const std::vector<SpacedPlace> detail =
        detailedPlaces(topology, positions, pieces.spacings, clearChains(topology, pieces.spacings).patches);
    pieces.finer.insert(pieces.finer.end(), detail.begin(), detail.end());
    if (pieces.finer.empty() && topology.pieceCount <= 1)
        return evenly(topology, positions, inside, pieces, pieces.spacings[0], progress);
    const double slope = supportSlope * static_cast<double>(process::spacingOf(definition, 1));
    Uneven uneven(topology, positions, inside, slope, std::move(pieces));
    uneven.afford(options.count > 0 ? 0 : mostForFiner);
    return uneven.run(options.count, progress);
}

} // namespace mesh
