#include "core/process/estimation/normal_links.h"

#include "core/process/estimation/part_progress.h"

#include <algorithm>

namespace process {

/// Every pair of neighbours once, from the one that comes first or the only one that names the other.
static std::vector<NormalEdge> neighbourPairs(const Cloud& cloud, std::size_t k, const base::Progress& progress) {
    k = std::min(k, cloud.size() - 1);
    std::vector<std::uint32_t> near(cloud.size() * k);
    cloud.forEach(k, progress, "Linking neighbours", [&](std::size_t i, const Neighbours& found) {
        std::copy(found.index.begin(), found.index.end(), near.begin() + static_cast<std::ptrdiff_t>(i * k));
    });
    const auto names = [&](std::size_t i, std::uint32_t j) {
        const auto begin = near.begin() + static_cast<std::ptrdiff_t>(i * k);
        return std::find(begin, begin + static_cast<std::ptrdiff_t>(k), j) != begin + static_cast<std::ptrdiff_t>(k);
    };
    constexpr std::size_t grain = 8192;
    std::vector<std::vector<NormalEdge>> parts(base::chunkCount(cloud.size(), grain));
    base::parallelChunks(cloud.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t e = i * k; e < (i + 1) * k; ++e)
                if (near[e] > i || !names(near[e], static_cast<std::uint32_t>(i)))
                    parts[chunk].push_back({static_cast<std::uint32_t>(i), near[e]});
    });
    std::vector<NormalEdge> out;
    for (const auto& p : parts)
        out.insert(out.end(), p.begin(), p.end());
    return out;
}

/// Stable: ties keep the order of the points along the curve.
static std::vector<std::uint32_t> byUnlikeness(const std::vector<Likeness>& likenesses) {
    std::vector<std::uint32_t> start(unlikeClasses + 1), order(likenesses.size());
    for (const Likeness& l : likenesses)
        ++start[l.unlike + 1u];
    for (std::size_t c = 0; c < unlikeClasses; ++c)
        start[c + 1] += start[c];
    for (std::uint32_t e = 0; e < order.size(); ++e)
        order[start[likenesses[e].unlike]++] = e;
    return order;
}

Likeness likeness(const base::Vec3f& a, const base::Vec3f& na, const base::Vec3f& b, const base::Vec3f& nb) {
    const base::Vec3f e = base::normalized(b - a);
    const float alongA = base::dot(na, e), alongB = base::dot(nb, e);
    const float arc = base::dot(na, nb) - 2 * alongA * alongB;
    const float steep = std::max(alongA * alongA, alongB * alongB);
    const float unlike = std::clamp(1 - std::abs(arc) * (1 - steep), 0.0f, 1.0f);
    return {arc < 0, static_cast<std::uint16_t>(unlike * (unlikeClasses - 1))};
}

NormalLinks normalLinks(const Cloud& cloud, std::span<const base::Vec3f> normals, int neighbours,
                        const base::Progress& progress) {
    NormalLinks out;
    out.edges = neighbourPairs(cloud, static_cast<std::size_t>(neighbours), part(progress, 0, 0.85));
    progress.step(0.85, "Orienting normals");
    out.likenesses.resize(out.edges.size());
    base::parallelFor(out.edges.size(), 16384, [&](std::size_t e) {
        const auto [a, b] = out.edges[e];
        out.likenesses[e] = likeness(cloud.positions()[a], normals[a], cloud.positions()[b], normals[b]);
    });
    progress.step(0.95, "Orienting normals");
    out.order = byUnlikeness(out.likenesses);
    return out;
}

} // namespace process
