#include "core/reduce/reduce.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/process/estimation/part_progress.h"
#include "core/reduce/assemble.h"
#include "core/reduce/by_cells.h"
#include "core/reduce/counts.h"
#include "core/reduce/coverage.h"
#include "core/reduce/density.h"
#include "core/reduce/density_by_result.h"
#include "core/reduce/fit.h"
#include "core/reduce/ground.h"
#include "core/reduce/placement.h"
#include "core/reduce/shapes_by_error.h"
#include "core/surface/definition_text.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace reduce {

namespace {

/// Places for each sample: more say nothing new.
constexpr std::size_t placesPerSample = 32;
/// Rounds in which supports grow where verification misses surface.
constexpr int mends = 4;

/// What ellipsoids must leave of the balls' error to be worth a word more per sample; and by prediction, to be tried.
constexpr double worth = 0.95, worthTrying = 0.93;

void check(const surface::Surface& model) {
    if (model.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(model.definition().manifold) + " cannot be reduced, only surfaces", "reduce",
                          "open a model whose points sample a surface");
    if (model.tree().size() <= fewest)
        throw base::Error("a model of " + std::to_string(model.tree().size()) + " surfels cannot be reduced", "reduce",
                          "a reduced one has at least " + std::to_string(fewest));
}

/// What is asked for as far as the model's attributes have room for it.
Shapes possible(const surface::Surface& model, Shapes shapes) {
    surfel::AttributeLayout trial = *model.tree().layout();
    try {
        if (shapes != Shapes::Spheres)
            surfel::addShape(trial);
    } catch (const base::Error&) {
        if (shapes == Shapes::Ellipsoids)
            throw;
        return Shapes::Spheres;
    }
    return shapes;
}

void checkCount(std::size_t size, std::size_t count) {
    if (count >= size)
        throw base::Error("the model has " + std::to_string(size) + " surfels, no more than the " +
                              std::to_string(count) + " asked for",
                          "reduce", "choose a count below " + std::to_string(size));
    if (count < fewest)
        throw base::Error(std::to_string(count) + " surfels make no surface", "reduce",
                          "choose a count of at least " + std::to_string(fewest));
}

std::size_t countFor(const surface::Surface& model, double ratio) {
    if (!(ratio > 0 && ratio < 1))
        throw base::Error("a ratio is above 0 and below 1", "reduce");
    return static_cast<std::size_t>(std::max(double(fewest), std::round(ratio * double(model.tree().size()))));
}

std::size_t strideFor(std::size_t size, std::size_t count) {
    return std::max<std::size_t>(1, size / (placesPerSample * count));
}

Ground groundOf(const surface::Surface& model, std::size_t stride, const base::Progress& progress) {
    Ground out{denseOf(model, stride, progress), {}, stride, {}};
    if (out.dense.feet <= fewest)
        throw base::Error("the model's points define hardly any surface", "reduce",
                          "look at its normals and supports first");
    out.tree = NumberedTree(out.dense.places.position, out.dense.places.normal, {});
    measureAreas(out.dense.places, out.tree);
    return out;
}

/// What a first placement and fit tell of a second one.
struct Draft {
    std::vector<float> shares;
    std::vector<base::Vec3f> shape; ///< of the places
    double foreseen = 0;            ///< distance between the surfaces, rms
};

Sites fitted(Ground& ground, std::span<const float> shares, std::size_t count, bool keepTree,
             const base::Progress& progress) {
    const Places& places = ground.dense.places;
    Sites sites = place(ground.dense.surface, places, keepTree ? ground.tree : std::move(ground.tree), shares, count,
                        process::part(progress, 0, 0.45));
    cover(places, supportsOver, sites);
    fit(places, sites, process::part(progress, 0.45, 1));
    return sites;
}

/// Nothing where ellipsoids were only to be tried, and are not worth it.
std::optional<Draft> draftOf(Ground& ground, std::size_t count, Shapes shapes, const base::Progress& progress) {
    Places& places = ground.dense.places;
    progress.step(0, "Measuring errors");
    Draft out;
    out.shares = sharesByError(places, ground.tree, count);
    places.shape.clear();
    if (shapes != Shapes::Spheres) {
        const double left = shapeByError(places, ground.tree, out.shares, count);
        if (shapes == Shapes::Auto && left > worthTrying)
            return std::nullopt;
        roundBesideRims(ground.rims, out.shares, places);
    }
    const Sites first = fitted(ground, out.shares, count, true, process::part(progress, 0.2, 1));
    out.shares = sharesByResult(places, first, std::move(out.shares), count, ground.rims,
                                ground.dense.surface.definition().oneSheet, &out.foreseen);
    out.shape = std::move(places.shape);
    return out;
}

/// Cells end at creases, too: their rims are fitted where all cells are together.
bool fitsRims(const Ground& ground) {
    return std::isfinite(ground.dense.surface.definition().boundaryLimit) && !ground.rims.empty();
}

surface::Surface surfaceOf(const Ground& ground, const Sites& sites, float limit) {
    const surface::Surface& model = ground.dense.surface;
    const surface::Surface out = assemble(model, sites, static_cast<int>(supportsOver));
    return fitsRims(ground) ? endingAtRims(model, out, ground.dense.places, ground.rims, limit)
                            : bounded(model, out, ground.dense.places, 0);
}

Reduced finished(const Ground& ground, Sites sites, const base::Progress& progress) {
    Reduced best;
    const Places& places = ground.dense.places;
    const FittedPart all{0, sites.size(), &places};
    float limit = 0;
    if (fitsRims(ground))
        limit = fitRims(ground.rims, std::span(&all, 1), places.oriented, sites, {{}, progress.cancel});
    for (int k = 0;; ++k) {
        Missed missed;
        Reduced out;
        out.surface = surfaceOf(ground, sites, limit);
        out.report = verify(ground.dense, out.surface, missed, progress);
        if (k == 0 || out.report.holes < best.report.holes)
            best = std::move(out);
        if (missed.position.empty() || k == mends ||
            !mendAround(missed.position, missed.normal, missed.samples, ground.dense.places.oriented, sites))
            return best;
    }
}

Reduced made(Ground& ground, Draft draft, std::size_t count, bool keepTree, const base::Progress& progress) {
    ground.dense.places.shape = std::move(draft.shape);
    Sites sites = fitted(ground, draft.shares, count, keepTree, process::part(progress, 0, 0.8));
    return finished(ground, std::move(sites), process::part(progress, 0.8, 1));
}

/// Clearly nearer and without further holes, or with fewer of them and not clearly farther.
bool better(const Report& ellipsoids, const Report& balls) {
    return ellipsoids.holes == balls.holes
               ? ellipsoids.surfaceRms < worth * balls.surfaceRms
               : ellipsoids.holes < balls.holes && worth * ellipsoids.surfaceRms <= balls.surfaceRms;
}

/// Balls or ellipsoids. The less promising ones are made only where they might win: nothing gets much nearer than its
/// draft foresees.
Reduced chosen(Ground& ground, std::size_t count, bool keepTree, const base::Progress& progress) {
    std::optional<Draft> ellipsoids = draftOf(ground, count, Shapes::Auto, process::part(progress, 0, 0.25));
    Draft balls = *draftOf(ground, count, Shapes::Spheres, process::part(progress, 0.25, 0.4));
    const base::Progress once = process::part(progress, 0.4, 0.7), last = process::part(progress, 0.7, 1);
    if (!ellipsoids)
        return made(ground, std::move(balls), count, keepTree, last);
    const double drawnAtBest = ellipsoids->foreseen, roundAtBest = balls.foreseen;
    if (drawnAtBest < worth * roundAtBest) {
        Reduced drawn = made(ground, std::move(*ellipsoids), count, true, once);
        if (drawn.report.holes == 0 && drawn.report.surfaceRms < worth * roundAtBest)
            return drawn;
        Reduced round = made(ground, std::move(balls), count, keepTree, last);
        return better(drawn.report, round.report) ? std::move(drawn) : std::move(round);
    }
    Reduced round = made(ground, std::move(balls), count, true, once);
    if (round.report.holes == 0 && drawnAtBest >= worth * round.report.surfaceRms)
        return round;
    Reduced drawn = made(ground, std::move(*ellipsoids), count, keepTree, last);
    return better(drawn.report, round.report) ? std::move(drawn) : std::move(round);
}

} // namespace

Ground groundFor(const surface::Surface& model, std::size_t count, Rims rims, const base::Progress& progress) {
    Ground out = groundOf(model, strideFor(model.tree().size(), count), progress);
    out.rims = std::move(rims);
    return out;
}

Reduced reduced(Ground& ground, std::size_t count, Shapes shapes, bool keepTree, const base::Progress& progress) {
    if (const std::size_t stride = strideFor(ground.dense.surface.tree().size(), count); stride != ground.stride) {
        Rims rims = std::move(ground.rims);
        ground = groundOf(ground.dense.surface, stride, {{}, progress.cancel});
        ground.rims = std::move(rims);
    }
    const std::size_t most = ground.dense.places.size();
    if (count > most)
        throw base::Error("only " + std::to_string(most) + " of the model's points lie on a surface, fewer than the " +
                              std::to_string(count) + " asked for",
                          "reduce", "choose a smaller count");
    if (shapes == Shapes::Auto)
        return chosen(ground, count, keepTree, progress);
    Draft draft = *draftOf(ground, count, shapes, process::part(progress, 0, 0.45));
    return made(ground, std::move(draft), count, keepTree, process::part(progress, 0.45, 1));
}

namespace {

constexpr int mostTries = 14;
constexpr double closeEnough = 1.02;
std::size_t firstTry(std::size_t size) {
    return std::max(fewest, size / 10);
}
/// A try with more than this part of the samples missed does not count as good, whatever its error.
constexpr double heldMisses = 1e-4;

/// The search for the least count: known counts, and the error there.
class Search {
  public:
    Search(std::size_t size, double error, double floor) : m_error(error), m_floor(floor), m_high(double(size)) {}

    bool wide() const { return m_high / m_low > closeEnough && m_high - m_low > 1.5; }
    /// Within the bracket; where the power law leads from the last try, not too near to the ends.
    std::size_t next() const {
        double guess = std::sqrt(m_low * m_high);
        if (m_last > 0) {
            const double want = excess(m_error), had = excess(m_lastError);
            if (want > 0 && had > 0)
                guess = m_last * std::pow(want / had, -1 / fall) * (m_lastError <= m_error ? 0.995 : 1.005);
        }
        const double margin = std::pow(m_high / m_low, 0.1);
        return static_cast<std::size_t>(std::lround(std::clamp(std::clamp(guess, m_low * margin, m_high / margin),
                                                               m_low + 1, std::max(m_low + 1, m_high - 1))));
    }
    void learn(std::size_t count, double error) {
        m_last = double(count), m_lastError = error;
        (error <= m_error ? m_high : m_low) = double(count);
    }

  private:
    /// What the reduction adds to the model's own distance.
    double excess(double error) const { return error > m_floor ? std::sqrt(error * error - m_floor * m_floor) : 0; }
    double m_error, m_floor, m_low = fewest - 1, m_high, m_last = 0, m_lastError = 0;
};

} // namespace

Reduced reduceToCount(const surface::Surface& model, std::size_t count, Shapes shapes, const base::Progress& progress) {
    check(model);
    checkCount(model.tree().size(), count);
    shapes = possible(model, shapes);
    const base::CancelScope scope(progress.cancel);
    Ground ground =
        groundFor(model, count, rimsOf(model, process::part(progress, 0, 0.05)), process::part(progress, 0.05, 0.15));
    return reduced(ground, count, shapes, false, process::part(progress, 0.15, 1));
}

Reduced reduceByRatio(const surface::Surface& model, double ratio, Shapes shapes, const base::Progress& progress) {
    check(model);
    return reduceToCount(model, countFor(model, ratio), shapes, progress);
}

Reduced reducedToError(Ground& ground, double error, Shapes shapes, const base::Progress& progress) {
    const std::size_t size = ground.dense.surface.tree().size();
    if (ground.dense.rms > error) {
        std::ostringstream said;
        said << "no count keeps an error of " << error << ": the model's own surface is " << ground.dense.rms
             << " from its points";
        throw base::Error(said.str(), "reduce", "choose a larger error");
    }
    std::size_t count = firstTry(size);
    Search search(std::min(size, ground.dense.feet), error, ground.dense.rms);
    Reduced best;
    for (int k = 0; k < mostTries && search.wide(); ++k, count = search.next()) {
        Reduced tried = reduced(ground, count, shapes, true, process::part(progress, 0.06 * k, 0.06 * (k + 1)));
        const bool whole = double(tried.report.holes) <= heldMisses * double(ground.dense.feet);
        const bool good = tried.report.rms <= error && whole;
        search.learn(count, good ? tried.report.rms : std::max(tried.report.rms, 1.05 * error));
        if (good && (best.surface.tree().empty() || tried.report.count < best.report.count))
            best = std::move(tried);
    }
    if (best.surface.tree().empty())
        throw base::Error("fewer surfels than the model has do not keep that error", "reduce", "choose a larger error");
    return best;
}

Reduced reduceToError(const surface::Surface& model, double error, Shapes shapes, const base::Progress& progress) {
    check(model);
    if (!(error > 0))
        throw base::Error("an error is a length above 0", "reduce");
    shapes = possible(model, shapes);
    const base::CancelScope scope(progress.cancel);
    Ground ground = groundFor(model, firstTry(model.tree().size()), rimsOf(model, {{}, progress.cancel}),
                              process::part(progress, 0, 0.05));
    return reducedToError(ground, error, shapes, process::part(progress, 0.05, 1));
}

Reduced reduceBy(const surface::Surface& model, const Wish& wish, const base::Progress& progress) {
    if (hasCells(model)) {
        check(model);
        Wish own = wish;
        if (wish.ratio > 0)
            own.count = countFor(model, wish.ratio);
        if (own.count > 0)
            checkCount(model.tree().size(), own.count);
        own.shapes = possible(model, wish.shapes);
        return reduceCells(model, own, progress);
    }
    if (wish.count > 0)
        return reduceToCount(model, wish.count, wish.shapes, progress);
    return wish.ratio > 0 ? reduceByRatio(model, wish.ratio, wish.shapes, progress)
                          : reduceToError(model, wish.error, wish.shapes, progress);
}

std::string summaryOf(const Report& report) {
    std::ostringstream out;
    out.precision(3);
    out << report.count << " surfels; the surfaces are " << report.surfaceRms << " apart (rms), " << report.surfaceMax
        << " (most); the model's points are " << report.rms << " from the reduced surface (rms), " << report.p999
        << " (99.9 %), " << report.max << " (most), and " << report.denseRms << " from their own (rms)";
    if (report.holes > 0)
        out << "; " << report.holes << " of them miss it: a hole";
    if (report.picked > 0)
        out << "; " << report.picked << " of the surfels are the model's own, of cells that have hardly any surface";
    if (report.strays > 0)
        out << "; " << report.strays << " had no surface and do not count";
    return out.str();
}

} // namespace reduce
