#include "core/reduce/density_by_result.h"

#include "core/base/parallel.h"
#include "core/base/ranked.h"
#include "core/reduce/coverage.h"
#include "core/reduce/density.h"
#include "core/surface/evaluation/packets.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reduce {

namespace {

/// The sum of squares is least where every sample has the same part of it; with errors that fall with the power 1.3 of
/// a sample's area (reduce/README 3.2) a sample with E times as much wants 1 / (2 p + 1) more of them.
constexpr double power = 1 / 3.6;
/// Of the middle of all: less is no reason to take samples away.
constexpr double least = 0.1;
/// Of the mean: where most of the model is exact, errors by rounding are none.
constexpr double leastOfMean = 1e-4;
/// Shares change at most so much, either way.
constexpr double fewer = 0.6, more = 3;
constexpr std::size_t smoothedOver = 8;
constexpr int smoothings = 2;
constexpr float likeFacing = 0.3f;
/// Of a support: what a place without surface counts as, and the most that any does.
constexpr float farthest = 0.3f;
constexpr float flattest = 0.05f;
constexpr float slack = 0.1f;

surface::Surface surfaceOf(const Sites& sites, bool oriented, bool oneSheet) {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = true;
    layout->oriented = oriented;
    surfel::SurfelList list;
    list.layout = layout;
    list.items.resize(sites.size());
    if (!sites.shape.empty())
        surfel::addShape(*layout);
    list.extra.resize(sites.size() * layout->words());
    for (std::size_t i = 0; i < sites.size(); ++i) {
        list.items[i].position = sites.position[i];
        list.items[i].normal = sites.normal[i];
        list.items[i].support = sites.support[i];
        if (!sites.shape.empty())
            surfel::putShape(std::span(list.extra).subspan(3 * i, 3), 0, sites.shape[i]);
    }
    surface::SurfaceDefinition definition;
    definition.neighbours = static_cast<int>(supportsOver);
    definition.oneSheet = oneSheet;
    return {tree::SurfelTree::build(list), definition};
}

/// Whether a rim is within that reach.
bool besideRim(const NumberedTree& rims, const base::Vec3f& x, float reach) {
    std::vector<tree::Neighbour> near;
    rims.tree().nearest(x, 1, near, reach);
    return !near.empty();
}

/// Squared distance of the sites' surface at each place times the area that it stands for, summed over the places of
/// each site; and once more with places that are lost beside rims as without surface.
struct Sums {
    std::vector<double> between, wanted;
};
Sums sumsOfSquares(const Places& places, const Sites& sites, const NumberedTree& tree, const Rims& rims,
                   bool oneSheet) {
    const NumberedTree ends =
        rims.empty() ? NumberedTree() : NumberedTree(rims.position, rims.normal, {}); // an empty one is not asked
    std::vector<std::uint32_t> site(places.size());
    std::vector<float> square(places.size()), wanted(places.size());
    base::parallelChunks(places.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<tree::Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
            tree.tree().nearest(places.position[i], sites.shape.empty() ? 6 : 12, near);
            const tree::Neighbour* own = nullptr;
            float closest = std::numeric_limits<float>::infinity();
            for (const tree::Neighbour& n : near) {
                const std::uint32_t k = NumberedTree::number(n);
                const base::Vec3f b = sites.shapeAt(k);
                const float d = sites.shape.empty()
                                    ? n.distanceSq
                                    : surfel::shapedSq(places.position[i] - sites.position[k], b) / surfel::aspectOf(b);
                if (places.facing(places.normal[i], sites.normal[k], likeFacing) && d < closest)
                    own = &n, closest = d;
            }
            site[i] = NumberedTree::number(own ? *own : near.front());
        }
    });
    surface::forPackets(surfaceOf(sites, places.oriented, oneSheet), places.position, slack,
                        [&](surface::Source& source, std::size_t i) {
                            const surface::Evaluationf e =
                                source.evaluate(places.position[i], surface::Need::Gradient, {places.normal[i]});
                            const float reach = sites.support[site[i]], most = farthest * reach;
                            const float slope = length(e.gradient);
                            const float off = e.ok() && slope > flattest ? std::abs(e.value) / slope : most;
                            square[i] = std::min(off, most) * std::min(off, most) * places.area[i];
                            const bool lost = !rims.empty() && e.ok() && e.offCentre > lostAtRims * e.unit &&
                                              besideRim(ends, places.position[i], reach);
                            wanted[i] = lost ? most * most * places.area[i] : square[i];
                        });
    Sums out{std::vector<double>(sites.size()), std::vector<double>(sites.size())};
    for (std::size_t i = 0; i < places.size(); ++i)
        out.between[site[i]] += double(square[i]), out.wanted[site[i]] += double(wanted[i]);
    return out;
}

/// Means of logarithms over the nearest of the same sheet.
std::vector<double> smoothed(const std::vector<double>& log, const Places& places, const Sites& sites,
                             const NumberedTree& tree) {
    std::vector<double> out(log.size());
    base::parallelChunks(log.size(), 256, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<tree::Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
            tree.tree().nearest(sites.position[i], smoothedOver, near);
            double sum = log[i], weight = 1;
            for (const tree::Neighbour& n : near) {
                const std::uint32_t k = NumberedTree::number(n);
                if (k != i && places.facing(sites.normal[i], sites.normal[k], likeFacing))
                    sum += log[k], weight += 1;
            }
            out[i] = sum / weight;
        }
    });
    return out;
}

/// Once all samples have the same part of the squares.
double foreseenFrom(const std::vector<double>& sums, const Places& places) {
    double all = 0;
    for (const double each : sums)
        all += std::pow(each, power);
    const double area = std::accumulate(places.area.begin(), places.area.end(), 0.0);
    const auto count = static_cast<double>(sums.size());
    return std::sqrt(count * std::pow(all / count, 1 / power) / area);
}

} // namespace

std::vector<float> sharesByResult(const Places& places, const Sites& sites, std::vector<float> shares,
                                  std::size_t count, const Rims& rims, bool oneSheet, double* foreseen) {
    const NumberedTree tree(sites.position, sites.normal, {});
    Sums squares = sumsOfSquares(places, sites, tree, rims, oneSheet);
    if (foreseen)
        *foreseen = foreseenFrom(squares.between, places);
    std::vector<double> log = std::move(squares.wanted), sums = log;
    const double mean = std::accumulate(log.begin(), log.end(), 0.0) / static_cast<double>(log.size());
    const double typical = std::max({base::median(sums), leastOfMean * mean, 1e-300});
    for (double& each : log)
        each = std::log(std::max(each / typical, least));
    for (int k = 0; k < smoothings; ++k)
        log = smoothed(log, places, sites, tree);
    base::parallelChunks(shares.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<tree::Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
            tree.tree().nearest(places.position[i], 4, near);
            double sum = 0, weight = 0;
            for (const tree::Neighbour& n : near) {
                const std::uint32_t k = NumberedTree::number(n);
                if (!places.facing(places.normal[i], sites.normal[k], likeFacing))
                    continue;
                const double w = 1 / (double(n.distanceSq) + 0.05 * double(sites.spacing[k] * sites.spacing[k]));
                sum += w * log[k], weight += w;
            }
            if (weight > 0)
                shares[i] *= static_cast<float>(std::clamp(std::exp(power * sum / weight), fewer, more));
        }
    });
    scaleShares(shares, count);
    return shares;
}

} // namespace reduce
