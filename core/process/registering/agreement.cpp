#include "core/process/registering/agreement.h"

#include "core/base/error.h"
#include "core/base/ranked.h"
#include "core/process/cleaning/spread.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/registering/feet.h"

#include <algorithm>

namespace process {

using base::Vec3d;

namespace {

/// A model that has settled on another one from a place that was guessed.
struct Trial {
    Rigid pose;
    bool held = false;
    std::vector<double> off; ///< of the points that lie on the other's surface and face the same way
};

Trial tried(const Placed& fixed, const Placed& moving, const AskedPoints& asked, double spacing, double reach,
            const base::Progress& progress) {
    constexpr double alike = 0.8; // cosine
    std::vector<Placed> both{fixed, moving};
    AlignOptions options;
    options.points = 800;
    options.mostRounds = 20;
    options.reach = reach;
    Trial out;
    out.pose = moving.pose;
    try {
        align(both, options, {nullptr, progress.cancel});
    } catch (const base::Error&) {
        return out; // no foot on each other
    }
    out.pose = both[1].pose, out.held = both[1].held;
    for (const FootPair& p : footPairs(both, {{}, asked}, spacing))
        if (p.alike > alike)
            out.off.push_back(std::abs(p.off));
    return out;
}

std::vector<double> scoresOf(const std::vector<Trial>& trials, double spacing) {
    constexpr double closely = 3;  // deviations of the closest trial
    constexpr double surely = 0.2; // in spacings: surfaces are off by that anyway
    constexpr double loose = 0.7;
    constexpr std::size_t few = 50;
    double reach = spacing;
    for (const Trial& each : trials)
        if (std::vector<double> off = each.off; off.size() >= few)
            reach = std::min(reach, closely * deviationOverMad * base::median(off));
    reach = std::max(reach, surely * spacing);
    std::vector<double> out;
    for (const Trial& each : trials) {
        out.push_back(0);
        for (const double off : each.off)
            out.back() += (each.held ? 1 : loose) * biweight(off, reach);
    }
    return out;
}

} // namespace

Agreement bestAgreement(const std::vector<Placed>& placed, const surface::Surface& moving,
                        const std::vector<Rigid>& places, double wide, const base::Progress& progress) {
    constexpr double nearly = 0.93; // of the best score
    constexpr double reach = 5.6;   // times `wide`, of the first round
    const AskedPoints asked = askedPoints(moving, 1500), few = askedPoints(moving, 300);
    double spacing = static_cast<double>(typicalSpacing(moving.tree()));
    for (const Placed& p : placed)
        spacing = std::max(spacing, static_cast<double>(typicalSpacing(p.surface.tree())));
    std::vector<Trial> trials;
    for (const Rigid& pose : places) {
        std::size_t most = 0, on = 0;
        for (std::size_t m = 0; m < placed.size(); ++m)
            if (const std::size_t count =
                    pointsNear(placed[m].surface, few, placed[m].pose.inverse() * pose, static_cast<float>(wide))
                        .size();
                count > most)
                most = count, on = m;
        trials.push_back(tried(placed[on], {moving, pose}, asked, spacing, reach * wide, progress));
    }
    const std::vector<double> scores = scoresOf(trials, spacing);
    const auto best = static_cast<std::size_t>(std::max_element(scores.begin(), scores.end()) - scores.begin());
    Agreement out{trials[best].pose};
    for (std::size_t k = 0; k < trials.size(); ++k) {
        const auto isElsewhere = [&](const Vec3d& p) { return distance(trials[k].pose(p), out.pose(p)) > 3 * wide; };
        if (scores[k] > nearly * scores[best] && std::any_of(few.position.begin(), few.position.end(), isElsewhere))
            out.unique = false;
    }
    return out;
}

} // namespace process
