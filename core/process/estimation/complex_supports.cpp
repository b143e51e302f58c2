#include "core/process/estimation/complex_supports.h"

#include "core/base/parallel.h"
#include "core/surface/points_by_cell.h"
#include "core/tree/surfel_tree.h"

#include <algorithm>

namespace process {

namespace {

/// Mean distance of the `count` nearest others of each; 0 where there is none. The last points of a curve have them all
/// on one side, and take what the next one has.
std::vector<float> spacings(const surfel::SurfelList& points, std::span<const std::uint32_t> cell, std::size_t count) {
    surfel::SurfelList own;
    for (const std::uint32_t i : cell) {
        own.items.push_back(points.items[i]);
        own.items.back().support = 1;
    }
    const tree::SurfelTree tree = tree::SurfelTree::build(own);
    const auto meanFrom = [&](const base::Vec3f& x, std::vector<tree::Neighbour>& near) {
        tree.nearest(x, count + 1, near);
        float mean = 0;
        for (std::size_t n = 1; n < near.size(); ++n) // itself is the first
            mean += std::sqrt(near[n].distanceSq) / static_cast<float>(near.size() - 1);
        return mean;
    };
    std::vector<float> out(cell.size());
    base::parallelFor(cell.size(), 64, [&](std::size_t k) {
        std::vector<tree::Neighbour> near;
        const base::Vec3f x = own.items[k].position;
        out[k] = meanFrom(x, near);
        if (count != 2 || near.size() < 3)
            return;
        const auto at = [&](std::size_t n) { return near[n].block->position(near[n].slot); };
        if (dot(at(1) - x, at(2) - x) > 0)
            out[k] = std::min(out[k], meanFrom(at(1), near));
    });
    return out;
}

} // namespace

void assignComplexSupports(surfel::SurfelList& points, const surface::SurfaceDefinition& definition, bool keep) {
    const std::vector<surface::ComplexCell>& cells = definition.connectivity->cells;
    const auto byCell = surface::pointsByCell(points, cells.size());
    const float given = definition.weight == surface::Weight::Gaussian ? definition.support * surface::gaussianReach
                                                                       : definition.support;
    const auto put = [&](std::uint32_t i, float support) {
        surfel::Surfel& s = points.items[i];
        if (!keep || !(s.support > 0) || !std::isfinite(s.support))
            s.support = given > 0 ? given : support;
    };
    const float scale =
        definition.weight == surface::Weight::Gaussian ? surface::gaussianScale * surface::gaussianReach : 1.0f;
    std::vector<float> typical(cells.size(), 0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const bool patch = cells[c].dimension == 2;
        if (cells[c].dimension == 0 || byCell[c].empty())
            continue;
        const std::vector<float> s = spacings(points, byCell[c], patch ? 6 : 2);
        for (std::size_t k = 0; k < s.size(); ++k)
            put(byCell[c][k], s[k] * (patch ? 0.93f : 1.0f) * definition.unitInSpacings() * scale);
        for (const std::uint32_t i : byCell[c])
            typical[c] += points.items[i].support / static_cast<float>(byCell[c].size());
    }
    std::vector<float> sum(cells.size(), 0), count(cells.size(), 0); // of the curves that end in a point
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (const std::uint32_t end : cells[c].boundary)
            if (typical[c] > 0)
                sum[end] += typical[c], ++count[end];
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (const std::uint32_t i : byCell[c])
            if (cells[c].dimension == 0)
                put(i, count[c] > 0 ? sum[c] / count[c] : 1);
    // a cell of one sample has no spacing: that of its neighbours in the complex
    const float largest = *std::max_element(typical.begin(), typical.end());
    for (surfel::Surfel& s : points.items)
        if (!(s.support > 0) || !std::isfinite(s.support))
            s.support = largest > 0 ? largest : 1;
}

} // namespace process
