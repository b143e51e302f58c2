#include "core/process/cleaning/mutual_spacing.h"

namespace process {

NearestGraph nearestGraph(const Cloud& cloud, std::size_t count, const base::Progress& progress) {
    NearestGraph out;
    out.count = std::min(count, cloud.size() - 1);
    out.index.resize(cloud.size() * out.count);
    out.distance.resize(out.index.size());
    cloud.forEach(out.count, progress, "Looking at neighbours", [&](std::size_t i, const Neighbours& near) {
        for (std::size_t k = 0; k < out.count; ++k) {
            out.index[i * out.count + k] = near.index[k];
            out.distance[i * out.count + k] = std::sqrt(near.distanceSq[k]);
        }
    });
    return out;
}

void mutualNeighbours(const NearestGraph& graph, std::size_t i, std::vector<std::uint32_t>& out) {
    out.clear();
    for (std::uint32_t k = 0; k < graph.count; ++k)
        if (graph.sees(graph.index[i * graph.count + k], static_cast<std::uint32_t>(i)))
            out.push_back(k);
}

std::vector<float> mutualSpacings(const NearestGraph& graph) {
    constexpr std::size_t ring = 6, grain = 4096;
    std::vector<float> out(graph.size());
    base::parallelChunks(out.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<std::uint32_t> mutual;
        for (std::size_t i = begin; i < end; ++i) {
            mutualNeighbours(graph, i, mutual);
            mutual.resize(std::min(mutual.size(), ring));
            float sum = 0;
            for (const std::uint32_t k : mutual)
                sum += graph.distance[i * graph.count + k];
            out[i] = mutual.empty() ? 0 : sum / static_cast<float>(mutual.size());
        }
    });
    return out;
}

} // namespace process
