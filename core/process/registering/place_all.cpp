#include "core/process/registering/place_all.h"

#include "core/base/error.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/registering/agreement.h"
#include "core/process/registering/features.h"
#include "core/process/registering/find_place.h"

#include <algorithm>
#include <numeric>

namespace process {

/// What `next` adds once it is where `pose` says.
static void add(Features& all, const Features& next, const Rigid& pose) {
    for (std::size_t i = 0; i < next.position.size(); ++i) {
        all.position.push_back(pose(next.position[i]));
        all.normal.push_back(pose.turn(next.normal[i]));
    }
    all.feature.insert(all.feature.end(), next.feature.begin(), next.feature.end());
    all.oriented = all.oriented && next.oriented;
}

/// Wide enough for all of them.
static float featureSpacing(std::span<const Placed> models) {
    constexpr double perDiagonal = 1 / 70.0;
    double out = perDiagonal * static_cast<double>(models[0].surface.tree().bounds().diagonal());
    for (const Placed& p : models)
        out = std::max(out, 2 * static_cast<double>(typicalSpacing(p.surface.tree())));
    return static_cast<float>(out);
}

void placeAll(std::span<Placed> models, std::span<const std::string> names, const base::Progress& progress) {
    constexpr double leastShare = 0.1;
    constexpr std::size_t most = 8;     // places
    constexpr double worthATrial = 0.6; // of the best one's share
    const float wide = featureSpacing(models);
    std::vector<Features> features;
    for (const Placed& p : models)
        features.push_back(featuresOf(p.surface, wide, progress));
    Features all = features[0];
    std::vector<std::size_t> waiting(models.size() - 1);
    std::vector<Placed> placed{models[0]};
    std::iota(waiting.begin(), waiting.end(), std::size_t(1));
    while (!waiting.empty()) {
        std::vector<FoundPlace> best;
        std::size_t which = 0;
        for (std::size_t k = 0; k < waiting.size(); ++k)
            if (auto found = findPlaces(features[waiting[k]], all, wide, most, progress);
                !found.empty() && (best.empty() || found[0].share > best[0].share))
                best = std::move(found), which = k;
        const std::size_t m = waiting[which];
        if (best.empty() || best[0].share < leastShare)
            throw base::Error("nothing in it looks like a part of the others", names[m],
                              "move it near its place and do not look for it everywhere (leave out --global)");
        std::vector<Rigid> poses;
        for (const FoundPlace& each : best)
            if (each.share > worthATrial * best[0].share)
                poses.push_back(each.pose);
        const Agreement found = bestAgreement(placed, models[m].surface, poses, static_cast<double>(wide), progress);
        models[m].pose = found.pose, models[m].unique = found.unique;
        add(all, features[m], found.pose);
        placed.push_back(models[m]);
        waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(which));
    }
}

} // namespace process
