// Layers in tests: their commands, and what holds of every model that has some.
#pragma once

#include "core/layers/shown_cluster.h"
#include "core/process/estimation/spacing_sample.h"
#include "workbench.h"

namespace test::layered {

inline json layer(const char* what, const json& more = json::object()) {
    json out{{"op", "layer"}, {"do", what}};
    out.update(more);
    return out;
}

inline json strength(double value) {
    return layer("strength", {{"strength", value}});
}

inline json stroke(const char* tool, double y, bool resample, double radius = 0.3) {
    json out = test::strokeAt(y, tool);
    out["resample"] = resample;
    out["radius"] = radius;
    out["strength"] = 0.7;
    return out;
}

inline surfel::SurfelList surfels(const Workbench& bench) {
    return bench.document.surface().tree().surfels();
}

/// Every surfel stands where its words show it.
inline bool isWhole(const Workbench& bench) {
    const auto channels = layers::Channels::of(*bench.document.surface().tree().layout(), bench.document.layers());
    if (!channels)
        return false;
    const std::vector<float> weights = layers::weightsOf(bench.document.layers());
    bool whole = true;
    bench.document.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        layers::ShownCluster shown;
        for (int slot = 0; slot < block.size(); ++slot) {
            layers::show(block, slot / surfel::clusterSize, *channels, weights, shown);
            whole = whole && shown.agrees(block, slot / surfel::clusterSize, slot % surfel::clusterSize);
        }
    });
    return whole;
}

/// Greatest distance between surfels of the same slots.
inline double farthest(const surfel::SurfelList& a, const surfel::SurfelList& b) {
    double out = a.size() == b.size() ? 0 : 1e9;
    for (std::size_t i = 0; i < a.size() && out < 1e9; ++i)
        out = std::max(out, double(distance(a.items[i].position, b.items[i].position)));
    return out;
}

/// Greatest distance of surfels from the unit sphere.
inline double offSphere(const surfel::SurfelList& list) {
    double out = 0;
    for (const surfel::Surfel& each : list.items)
        out = std::max(out, std::abs(length(base::cast<double>(each.position)) - 1));
    return out;
}

inline double spacing(const Workbench& bench) {
    return double(process::typicalSpacing(bench.document.surface().tree()));
}

inline constexpr double rounding = 3e-7;

} // namespace test::layered
