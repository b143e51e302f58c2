#include "core/mesh/faces/face_rims.h"

#include "core/base/box.h"
#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/mesh/faces/edge_chains.h"
#include "core/surface/rims.h"
#include "core/surfel/widen.h"
#include "core/tree/surfel_tree.h"

#include <algorithm>

namespace mesh {

using base::Vec3d, base::Vec3f;

namespace {

constexpr float smallHole = 1.5f;  ///< of a support: holes less wide have none
constexpr float markLength = 0.2f; ///< of a support: of boundary for one mark

/// How wide the loops of the boundary are, by their border edges.
std::vector<float> widths(const std::vector<BorderEdge>& edges) {
    const std::vector<std::uint32_t> loops = chainsOf(edges);
    std::vector<base::Box3d> boxes(edges.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        base::Box3d& box = boxes[loops[e]];
        box.extend(edges[e].from);
        box.extend(edges[e].to);
    }
    std::vector<float> out(edges.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        out[e] = static_cast<float>(boxes[loops[e]].diagonal());
    return out;
}

surfel::SurfelList pointsOf(const surfel::SurfelList& samples, std::span<const float> supports) {
    surfel::SurfelList out;
    out.items.resize(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        out.items[i].position = samples.items[i].position;
        out.items[i].support = supports[i];
    }
    return out;
}

/// Points along the boundary, close to each other for the supports there.
tree::SurfelTree marksOf(const std::vector<BorderEdge>& edges, const tree::SurfelTree& samples) {
    const std::vector<float> wide = widths(edges);
    std::vector<tree::Neighbour> nearest;
    surfel::SurfelList marks;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        base::CancelScope::check();
        std::vector<std::pair<Vec3d, Vec3d>> parts{{edges[e].from, edges[e].to}};
        while (!parts.empty()) {
            const auto [from, to] = parts.back();
            parts.pop_back();
            const Vec3d middle = (from + to) * 0.5;
            samples.nearest(base::cast<float>(middle), 1, nearest);
            const float support = nearest[0].block->support(nearest[0].slot);
            // Far from all samples there is nothing to mark.
            const double length = distance(from, to);
            if (std::sqrt(static_cast<double>(nearest[0].distanceSq)) > 0.5 * length + static_cast<double>(support))
                continue;
            if (length > static_cast<double>(markLength * support)) {
                parts.emplace_back(from, middle);
                parts.emplace_back(middle, to);
            } else if (wide[e] >= smallHole * support) {
                marks.items.push_back({base::cast<float>(middle), {}, support});
            }
        }
    }
    return tree::SurfelTree::build(marks);
}

void write(surfel::SurfelList& samples, const std::vector<std::uint8_t>& rim) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*samples.layout);
    if (!layout->find(surface::rimName))
        layout->add(surface::rimName, surfel::ScalarType::UInt8);
    surfel::widen(samples, layout);
    const surfel::Attribute& attribute = *layout->find(surface::rimName);
    const std::size_t words = layout->words();
    for (std::size_t i = 0; i < samples.size(); ++i)
        surfel::write(attribute, std::span(samples.extra).subspan(i * words, words), rim[i]);
}

} // namespace

bool markRims(const FaceTopology& topology, std::span<const float> supports, surfel::SurfelList& samples) {
    if (samples.items.empty() || std::ranges::any_of(supports, [](float h) { return !(h > 0); }))
        return false;
    if (const surfel::Attribute* taken = samples.layout->find(surface::rimName); taken && surfel::isReal(taken->type))
        return false; // the file's own, about something else
    const tree::SurfelTree marks = marksOf(topology.borderEdges, tree::SurfelTree::build(pointsOf(samples, supports)));
    std::vector<std::uint8_t> rim(samples.size());
    if (!marks.empty())
        base::parallelChunks(samples.size(), 256, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<tree::Neighbour> nearest;
            for (std::size_t i = begin; i < end; ++i) {
                marks.nearest(samples.items[i].position, 1, nearest, surface::rimReach * supports[i]);
                rim[i] = nearest.empty() ? 0 : 1;
            }
        });
    write(samples, rim);
    return true;
}

} // namespace mesh
