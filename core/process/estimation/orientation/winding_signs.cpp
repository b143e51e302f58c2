#include "core/process/estimation/orientation/winding_signs.h"

#include "core/base/parallel.h"
#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/orientation/nearest_signs.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/winding/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace process {

using base::Vec3d, base::Vec3f;

namespace {

constexpr std::size_t mostLookedAt = 4000;
constexpr std::size_t leastAsked = 50; ///< of a surface
constexpr std::size_t mostDipoles = 500000;
constexpr const char* orienting = "Orienting normals";

/// Points as dipoles, one in so many of them that a cloud has no more than `mostDipoles`.
struct Dipoles {
    std::vector<Vec3f> places, areas; ///< areas times normals as the trees turn them

    Dipoles(const Cloud& cloud, const NeighbourTable& links, std::span<const Vec3f> normals, base::ParitySets& trees,
            std::span<const std::uint32_t> points) {
        const std::size_t thinning = 1 + cloud.size() / mostDipoles;
        for (std::size_t k = thinning / 2 % points.size(); k < points.size(); k += thinning) {
            const std::uint32_t i = points[k];
            const NeighbourTable::Row row = links.row(i);
            std::array<float, ringSize> distancesSq;
            const std::size_t count = std::min(ringSize, links.count());
            for (std::size_t n = 0; n < count; ++n)
                distancesSq[n] = base::distanceSq(cloud.positions()[i], cloud.positions()[row[n]]);
            const float spacing = spacingOfRing(std::span(distancesSq).first(count));
            const float area = spacing * spacing * static_cast<float>(thinning);
            places.push_back(cloud.positions()[i]);
            areas.push_back(normals[i] * (trees.find(i).opposite ? -area : area));
        }
    }
    surface::WindingNumber field() const { return {places, areas}; }
};

} // namespace

std::vector<SignRelation> signsByWinding(const Cloud& cloud, const NeighbourTable& links,
                                         std::span<const Vec3f> normals,
                                         const std::vector<std::vector<std::uint32_t>>& pieces, base::ParitySets& trees,
                                         const base::Progress& progress) {
    if (pieces.size() < 2)
        return {};
    std::vector<Dipoles> dipoles;
    std::size_t held = 0;
    for (const std::vector<std::uint32_t>& piece : pieces) {
        progress.step(0.3 * static_cast<double>(held) / static_cast<double>(cloud.size()), orienting);
        held += dipoles.emplace_back(cloud, links, normals, trees, piece).places.size();
    }
    const std::size_t step = 1 + held / mostLookedAt;
    std::vector<surface::WindingNumber> fields;
    std::vector<Vec3d> asked;
    std::vector<double> weights;
    for (const Dipoles& each : dipoles) {
        progress.step(0.4, orienting);
        for (std::size_t k = step / 2 % each.places.size(); k < each.places.size(); k += step) {
            asked.push_back(base::cast<double>(each.places[k]));
            weights.push_back(std::sqrt(static_cast<double>(length(each.areas[k]))));
        }
        fields.push_back(each.field());
    }
    std::vector<double> winding(asked.size() * pieces.size()), closed(asked.size());
    base::parallelFor(asked.size(), 2, [&](std::size_t k) { // a few are some milliseconds
        closed[k] = 0.5 * weights[k];
        for (std::size_t p = 0; p < pieces.size(); ++p)
            winding[p * asked.size() + k] = weights[k] * fields[p].at(asked[k]);
    });
    const std::vector<double> signs = nearestSigns(winding, closed);
    std::vector<SignRelation> out;
    const std::uint32_t a = pieces[0].front();
    for (std::size_t p = 1; p < pieces.size(); ++p) {
        const std::uint32_t b = pieces[p].front();
        const bool alike = trees.find(a).opposite == trees.find(b).opposite;
        out.push_back({a, b, alike == (signs[0] != signs[p])});
    }
    return out;
}

std::vector<std::uint32_t> surfacesOf(const NeighbourTable& links, const base::Progress& progress) {
    base::DisjointSets sets(links.size());
    for (std::uint32_t i = 0; i < links.size(); ++i) {
        if (i % 131072 == 0)
            progress.step(static_cast<double>(i) / static_cast<double>(links.size()), orienting);
        for (const std::uint32_t j : links.row(i))
            if (j < i && links.sees(j, i))
                sets.join(i, j);
    }
    std::vector<std::uint32_t> out(links.size());
    for (std::uint32_t i = 0; i < links.size(); ++i)
        out[i] = sets.find(i);
    return out;
}

std::map<std::uint32_t, WindingSide> windingSides(const Cloud& cloud, const NeighbourTable& links,
                                                  std::span<const Vec3f> normals,
                                                  std::span<const std::uint32_t> surfaceOf, base::ParitySets& signs,
                                                  const base::Progress& progress) {
    using Key = std::pair<std::uint32_t, std::uint32_t>; // a component, and a surface of it
    std::map<std::uint32_t, WindingSide> out;
    std::map<Key, std::vector<std::uint32_t>> surfaces;
    std::vector<std::uint32_t>*ofComponent = nullptr, *ofSurface = nullptr;
    Key last;
    for (std::uint32_t i = 0; i < cloud.size(); ++i) {
        if (const Key key{signs.find(i).root, surfaceOf[i]}; !ofSurface || key != last) // mostly the same as before
            last = key, ofComponent = &out[key.first].members, ofSurface = &surfaces[key];
        ofComponent->push_back(i);
        ofSurface->push_back(i);
    }
    struct Sum {
        double outwards = 0, inwards = 0;
        std::size_t count = 0;
    };
    std::map<std::uint32_t, Sum> sums;
    std::size_t done = 0;
    for (const auto& [key, points] : surfaces) {
        progress.step(static_cast<double>(done) / static_cast<double>(cloud.size()), orienting);
        done += points.size();
        if (points.size() < leastAsked)
            continue;
        const surface::WindingNumber winding = Dipoles(cloud, links, normals, signs, points).field();
        const std::size_t step = std::min(1 + cloud.size() / mostLookedAt, points.size() / leastAsked);
        std::vector<double> numbers(points.size() / step);
        base::parallelFor(numbers.size(), 16, [&](std::size_t k) {
            numbers[k] = winding.at(base::cast<double>(cloud.positions()[points[k * step]]));
        });
        Sum& sum = sums[key.first];
        for (const double w : numbers)
            sum.outwards += std::abs(w - 0.5), sum.inwards += std::abs(w + 0.5);
        sum.count += numbers.size();
    }
    std::erase_if(out, [&](const auto& each) { return !sums.contains(each.first); });
    for (auto& [root, side] : out) {
        const Sum& sum = sums[root];
        side.off = std::min(sum.outwards, sum.inwards) / static_cast<double>(sum.count);
        side.inwards = sum.inwards < sum.outwards;
    }
    return out;
}

} // namespace process
