// Models with a hidden part, and what can be asked of it.
#pragma once

#include "core/selection/hidden.h"
#include "workbench.h"

namespace test::hiding {

inline json parsed(const char* text) {
    return json::parse(text);
}

/// The sphere's right half hidden.
inline void makeHidden(Workbench& bench, int count = 3000) {
    bench.run(newSphere(count));
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[1,0,0,0.1]})"));
    bench.run(parsed(R"({"op":"hide"})"));
}

inline std::size_t hiddenIn(const Workbench& bench) {
    return sizeOf(selection::selectedIn(bench.document.surface().tree(), selection::Field::Hidden));
}

inline std::size_t selectedIn(const Workbench& bench) {
    return sizeOf(selection::selectedIn(bench.document.surface().tree()));
}

/// Order-free hash of the surfels that are hidden.
inline base::Hash128 hashOfHidden(const surface::Surface& surface) {
    const tree::SurfelTree& tree = surface.tree();
    surfel::SurfelList list;
    list.layout = tree.layout();
    std::vector<std::uint32_t> words(list.layout->words());
    const int channel = selection::channelOf(*list.layout, selection::Field::Hidden);
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (selection::valueAt(block, channel, slot) >= selection::half) {
                block.extra(slot, words);
                list.append(block.surfel(slot), words);
            }
    });
    return tree::SurfelTree::build(list).contentHash();
}

} // namespace test::hiding
