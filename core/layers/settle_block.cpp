#include "core/layers/settle_block.h"

#include <algorithm>

namespace layers {

using surfel::clusterSize, surfel::MutableBlockPtr, surfel::SurfelBlock;

static SurfelLayers::Shown placeOf(const SurfelBlock& block, int slot) {
    return {base::cast<double>(block.position(slot)), normalized(base::cast<double>(block.normal(slot))),
            double(block.support(slot))};
}

static void settle(SurfelLayers& words, const SurfelLayers::Shown& wanted, bool inPlace, const SettleRules& rules,
                   Inheritance* inheritance) {
    if (inheritance && rules.how == How::Carry && !inPlace)
        inheritance->at(wanted, words);
    if (rules.how == How::Record && rules.target >= 0)
        words.record(rules.weights, rules.target, wanted);
    else
        words.rebase(rules.weights, wanted, rules.how == How::Record);
}

bool settle(SurfelBlock& block, const SettleRules& rules, Inheritance* inheritance) {
    bool changed = false;
    SurfelLayers words;
    ShownCluster shown;
    for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
        show(block, cluster, rules.channels, rules.weights, shown);
        unsigned moved = 0;
        for (int lane = 0; lane < std::min(clusterSize, block.size() - cluster * clusterSize); ++lane) {
            if (shown.agrees(block, cluster, lane))
                continue;
            const int slot = cluster * clusterSize + lane;
            words.read(block, slot, rules.channels);
            settle(words, placeOf(block, slot), shown.agreesInPlace(block, cluster, lane), rules, inheritance);
            words.write(block, slot, rules.channels);
            moved |= 1u << lane;
        }
        if (moved == 0)
            continue;
        show(block, cluster, rules.channels, rules.weights, shown);
        for (int lane = 0; lane < clusterSize; ++lane)
            if (moved >> lane & 1)
                shown.put(block, cluster, lane);
        changed = true;
    }
    return changed;
}

static bool stands(const SurfelBlock& block, const SettleRules& rules) {
    ShownCluster shown;
    for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
        show(block, cluster, rules.channels, rules.weights, shown);
        for (int lane = 0; lane < std::min(clusterSize, block.size() - cluster * clusterSize); ++lane)
            if (!shown.agrees(block, cluster, lane))
                return false;
    }
    return true;
}

surfel::BlockPtr settled(const SurfelBlock& block, const SettleRules& rules, Inheritance* inheritance) {
    if (stands(block, rules))
        return {};
    MutableBlockPtr out = block.clone();
    settle(*out, rules, inheritance);
    out->seal();
    return out;
}

} // namespace layers
