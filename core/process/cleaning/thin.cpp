#include "core/process/cleaning/thin.h"

#include "core/base/box.h"
#include "core/base/cells.h"
#include "core/base/radix_sort.h"

#include <algorithm>
#include <bit>

namespace process {

using base::Vec3f;

namespace {

constexpr float oppositeCosine = -0.5f; ///< normals that differ by more than 120 degrees are of two sides

struct Turn {
    std::uint64_t chance;
    std::uint32_t point;
};

std::uint64_t chanceOf(const Vec3f& p) {
    std::uint64_t out = 0;
    for (const float x : {p.x, p.y, p.z})
        out = base::mix(out ^ std::bit_cast<std::uint32_t>(x + 0.0f)); // -0 and 0 are the same place
    return out;
}

/// Coincident points come in their order in the list.
std::vector<Turn> turnsOf(const surfel::SurfelList& points) {
    constexpr int bits = 48;
    std::vector<Turn> out(points.size());
    for (std::uint32_t i = 0; i < out.size(); ++i) {
        const bool first = points.layout->masks && points.items[i].mask >= 1;
        out[i] = {first ? 0 : chanceOf(points.items[i].position) >> (64 - bits), i};
    }
    base::radixSort(out, bits, [](const Turn& turn) { return turn.chance; });
    return out;
}

} // namespace

std::vector<std::uint8_t> thinned(const surfel::SurfelList& points, float spacing, const base::Progress& progress) {
    std::vector<std::uint8_t> removed(points.size());
    if (points.items.empty())
        return removed;
    base::Box3f box;
    for (const surfel::Surfel& s : points.items)
        box.extend(s.position);
    constexpr float finest = 1e-6f; ///< of the model: smaller cells would not be told apart
    const float scale = 1 / std::max(spacing, finest * box.diagonal());
    const double nearSq = static_cast<double>(spacing) * static_cast<double>(spacing);
    const bool sided = points.layout->normals && points.layout->oriented;
    base::CellMap<std::vector<std::uint32_t>> kept;
    const auto taken = [&](const surfel::Surfel& s, const base::Cell& around) {
        bool found = false;
        base::forCellsAround(around, [&](const base::Cell& cell) {
            const std::vector<std::uint32_t>* there = found ? nullptr : kept.find(cell);
            if (!there)
                return;
            found = std::any_of(there->begin(), there->end(), [&](std::uint32_t j) {
                const surfel::Surfel& other = points.items[j];
                return static_cast<double>(distanceSq(other.position, s.position)) < nearSq &&
                       !(sided && dot(other.normal, s.normal) < oppositeCosine);
            });
        });
        return found;
    };
    std::size_t done = 0;
    for (const Turn& turn : turnsOf(points)) {
        if (done++ % 16384 == 0)
            progress.step(static_cast<double>(done) / static_cast<double>(points.size()), "Thinning");
        const surfel::Surfel& s = points.items[turn.point];
        const base::Cell cell = base::cellOf(s.position, box.lo, scale);
        const bool masked = points.layout->masks && s.mask >= 1;
        if (!masked && taken(s, cell))
            removed[turn.point] = 1;
        else
            kept.at(cell).push_back(turn.point);
    }
    return removed;
}

} // namespace process
