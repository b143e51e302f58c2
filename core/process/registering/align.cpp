#include "core/process/registering/align.h"

#include "core/base/error.h"
#include "core/base/ranked.h"
#include "core/process/cleaning/spread.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/registering/slack.h"

namespace process {

using base::Vec3d;

namespace {

constexpr double narrowing = 4;  ///< reach of the next round, in robust deviations of this one
constexpr double leastReach = 3; ///< in spacings
/// Motion that counts as none, in spacings at the model's farthest point.
constexpr double stillness = 1e-4;
constexpr double fewestFeet = 20;
constexpr double slide = 5; ///< in spacings: what is moved so far and fits as well is not held

/// What is told of each model at the end.
void judge(std::vector<Placed>& models, const std::vector<AskedPoints>& asked, const std::vector<FootPair>& pairs,
           double reach) {
    for (std::uint32_t m = 0; m < models.size(); ++m) {
        std::vector<double> nearest(asked[m].position.size(), std::numeric_limits<double>::infinity());
        for (const FootPair& p : pairs)
            if (p.from == m && std::abs(p.off) < std::abs(nearest[p.point]) && p.distance <= reach)
                nearest[p.point] = p.off;
        double squares = 0;
        std::size_t count = 0;
        for (const double off : nearest)
            if (std::isfinite(off))
                squares += off * off, ++count;
        models[m].overlap = static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(nearest.size(), 1));
        models[m].rms = count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0;
    }
}

void requireFeet(const std::vector<FootPair>& pairs, std::size_t models) {
    std::vector<double> feet(models);
    for (const FootPair& p : pairs)
        ++feet[p.from], ++feet[p.to];
    for (std::size_t m = 1; m < models; ++m)
        if (feet[m] < fewestFeet)
            throw base::Error("moving model " + std::to_string(m) + " has nothing in common with the others",
                              "register", "bring it closer, or look for its place everywhere");
}

} // namespace

Alignment align(std::vector<Placed>& models, const AlignOptions& options, const base::Progress& progress) {
    Alignment out;
    if (models.size() < 2)
        return out;
    std::vector<AskedPoints> asked;
    double spacing = 0;
    for (const Placed& m : models) {
        asked.push_back(askedPoints(m.surface, options.points));
        spacing = std::max(spacing, static_cast<double>(typicalSpacing(m.surface.tree())));
    }
    const base::Box3f box = models[0].surface.tree().bounds();
    const MotionFrame frame{models[0].pose(base::cast<double>(box.centre())),
                            std::max(0.5 * static_cast<double>(box.diagonal()), 1e-30)};
    double reach = options.reach > 0 ? options.reach : 0.4 * frame.scale;
    std::vector<FootPair> pairs;
    for (; out.rounds < options.mostRounds && !out.settled; ++out.rounds) {
        progress.step(static_cast<double>(out.rounds) / options.mostRounds, "Aligning");
        pairs = footPairs(models, asked, reach);
        requireFeet(pairs, models.size());
        std::vector<double> sizes;
        for (const FootPair& p : pairs)
            sizes.push_back(std::abs(p.off));
        const double deviation = std::max(deviationOverMad * base::median(sizes), 1e-3 * spacing);
        const MotionEquations equations(pairs, models.size(), frame, robustReach * deviation);
        const std::vector<Rigid> steps = equations.best();
        double moved = 0;
        for (std::size_t m = 1; m < models.size(); ++m) {
            for (const Vec3d& x : {frame.centre + Vec3d{frame.scale, 0, 0}, frame.centre + Vec3d{0, frame.scale, 0},
                                   frame.centre + Vec3d{0, 0, frame.scale}})
                moved = std::max(moved, distance(steps[m](x), x));
            models[m].pose = steps[m] * models[m].pose;
        }
        const double narrower = std::max(narrowing * deviation, leastReach * spacing);
        out.settled = moved < stillness * spacing && !(narrower < 0.9 * reach);
        reach = std::min(reach, std::max(narrower, 0.7 * reach));
    }
    reach = std::max(reach, leastReach * spacing);
    judge(models, asked, pairs, reach);
    out.slide = slide * spacing;
    lookForSlack(models, asked, MotionEquations(pairs, models.size(), frame, reach), out.slide, reach);
    return out;
}

} // namespace process
