#include "ui/snapshot.h"

#include "ui/render/splat_scale.h"

#include <algorithm>

namespace ui {

float typicalSpacing(const tree::SurfelTree& tree) {
    constexpr std::uint32_t samples = 200;
    constexpr std::size_t neighbours = 6;
    std::vector<float> found;
    std::vector<tree::Neighbour> near;
    const std::uint32_t step = std::max(1u, tree.blockCount() / samples);
    for (std::uint32_t number = 0; number < tree.blockCount(); number += step) {
        const surfel::BlockPtr block = tree.block(number);
        tree.nearest(block->surfel(0).position, neighbours + 1, near);
        if (near.size() <= neighbours)
            continue;
        float sum = 0;
        for (std::size_t k = 1; k < near.size(); ++k)
            sum += std::sqrt(near[k].distanceSq);
        found.push_back(0.93f * sum / static_cast<float>(neighbours));
    }
    if (found.empty())
        return 0;
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    return *middle;
}

Snapshot snapshotOf(const session::Document& document) {
    Snapshot out;
    out.surface = document.surface();
    out.path = document.provenance().path;
    out.origin = document.provenance().origin;
    out.modified = document.modified();
    out.canUndo = document.canUndo();
    out.canRedo = document.canRedo();
    if (out.canUndo)
        out.undoLabel = document.undoLabel();
    if (out.canRedo)
        out.redoLabel = document.redoLabel();
    out.modelBytes = document.surface().tree().bytes();
    out.historyBytes = document.historyBytes();
    out.spacing = typicalSpacing(document.surface().tree());
    out.splatScale = render::splatScaleOf(document.surface().tree());
    return out;
}

} // namespace ui
