#include "core/process/resampling/spacing_field.h"

#include "core/base/parallel.h"
#include "core/process/neighbours/knn.h"
#include "core/surface/curvature.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace process {

/// Neighbours along which a small target limits those around it, and those that a place goes by.
constexpr std::size_t around = 8, asked = 4;

/// s_i <= s_j + grading |p_i - p_j| for all neighbours, from the smallest upwards (Dijkstra).
static void grade(const std::vector<surfel::Surfel>& items, std::vector<float>& targets) {
    const Cloud cloud(items);
    std::vector<float> least(cloud.size(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < items.size(); ++i)
        least[cloud.places()[i]] = std::min(least[cloud.places()[i]], targets[i]);
    std::vector<Neighbours> near(cloud.size());
    cloud.forEach(around, {}, "Grading", [&](std::size_t i, const Neighbours& found) { near[i] = found; });
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::uint32_t i = 0; i < least.size(); ++i)
        queue.push({least[i], i});
    while (!queue.empty()) {
        const auto [target, i] = queue.top();
        queue.pop();
        if (target > least[i])
            continue;
        for (std::size_t k = 0; k < near[i].size(); ++k) {
            const float limit = target + grading * std::sqrt(near[i].distanceSq[k]);
            if (limit < least[near[i].index[k]])
                queue.push({least[near[i].index[k]] = limit, near[i].index[k]});
        }
    }
    for (std::size_t i = 0; i < items.size(); ++i)
        targets[i] = least[cloud.places()[i]];
}

SpacingField::SpacingField(tree::SurfelTree tree, float scale)
    : m_tree(std::move(tree)), m_scale(scale), m_coarsest(scale * m_tree.maxSupport()) {}

SpacingField::SpacingField(const surfel::SurfelList& surfels, std::vector<float> targets) {
    grade(surfels.items, targets);
    surfel::SurfelList list;
    list.items = surfels.items;
    for (std::size_t i = 0; i < targets.size(); ++i)
        list.items[i].support = targets[i];
    m_tree = tree::SurfelTree::build(list);
    const auto [least, most] = std::minmax_element(targets.begin(), targets.end());
    m_finest = *least, m_coarsest = *most;
}

SpacingField SpacingField::byCurvature(const surface::Surface& surface, const CurvatureSpacing& by,
                                       const base::Progress& progress) {
    const surfel::SurfelList list = surface.tree().surfels();
    std::vector<base::Vec3f> places(list.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = list.items[i].position;
    std::vector<surface::Curvature> bent(places.size());
    progress.step(0, "Measuring curvature");
    surface::curvature(surface, places, bent);
    std::vector<float> targets(places.size());
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double k = bent[i].ok() ? std::max(std::abs(bent[i].k1), std::abs(bent[i].k2)) : 0.0;
        const double asks = k > 0 ? std::sqrt(static_cast<double>(by.tolerance) / k) : 1e30;
        targets[i] = std::clamp(static_cast<float>(std::min(asks, 1e30)), by.finest, by.coarsest);
    }
    return {list, std::move(targets)};
}

float SpacingField::at(const base::Vec3f& x) const {
    std::vector<tree::Neighbour> near;
    m_tree.nearest(x, asked, near);
    return meanOf(near);
}

SpacingField::Search::Search(const SpacingField& field) : m_field(field), m_around(field.m_tree, asked) {}

void SpacingField::Search::at(std::span<const base::Vec3f> x, std::span<float> out) {
    m_around.forEach(x, [&](std::size_t i, std::span<const tree::Neighbour> near) { out[i] = m_field.meanOf(near); });
}

float SpacingField::meanOf(std::span<const tree::Neighbour> near) const {
    double sum = 0, weight = 0;
    for (const tree::Neighbour& n : near) {
        const double target = static_cast<double>(m_scale * n.block->support(n.slot));
        const double w = 1 / (static_cast<double>(n.distanceSq) + 1e-4 * target * target);
        sum += w * target, weight += w;
    }
    return static_cast<float>(sum / weight);
}

} // namespace process
