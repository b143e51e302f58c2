#include "core/process/registering/slack.h"

#include <algorithm>

namespace process {

namespace {

/// How far the motion moves the one of a model's points that it moves farthest.
double farthest(const std::vector<AskedPoints>& asked, const std::vector<Placed>& models, const Rigid& motion,
                std::uint32_t m) {
    double out = 0;
    for (const base::Vec3d& p : asked[m].position)
        out = std::max(out, distance(motion(models[m].pose(p)), models[m].pose(p)));
    return out;
}

/// Mean squared distance along normals of the pairs that count.
template <class Counts>
double costOf(const std::vector<FootPair>& pairs, const Counts& counts) {
    double sum = 0, count = 0;
    for (const FootPair& p : pairs)
        if (counts(p))
            sum += p.off * p.off, ++count;
    return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

} // namespace

void lookForSlack(std::vector<Placed>& models, const std::vector<AskedPoints>& asked, const MotionEquations& equations,
                  double size, double reach) {
    // Times the cost that is as well: of what is loose up to 1.5, of what noise of .3 spacings leaves held 2.4 and
    // more.
    constexpr double asWell = 1.7;
    constexpr double exact = 0.004; // part of `size` that surfaces are off anyway
    const std::vector<Rigid> motion = equations.loosest(size);
    std::vector<std::uint8_t> moves(models.size());
    for (Placed& each : models)
        each.held = true;
    for (std::uint32_t m = 1; m < models.size(); ++m)
        moves[m] = farthest(asked, models, motion[m], m) > size / 4;
    const auto counts = [&](const FootPair& p) { return moves[p.from] != moves[p.to]; };
    const auto cost = [&](bool back) {
        std::vector<Placed> moved = models;
        for (std::size_t m = 1; m < models.size(); ++m)
            moved[m].pose = (back ? motion[m].inverse() : motion[m]) * models[m].pose;
        return costOf(footPairs(moved, asked, reach), counts);
    };
    const double here = costOf(footPairs(models, asked, reach), counts);
    const double limit = asWell * here + exact * size * exact * size;
    if (cost(false) > limit || cost(true) > limit)
        return;
    for (std::size_t m = 1; m < models.size(); ++m)
        models[m].held = moves[m] == 0;
}

} // namespace process
