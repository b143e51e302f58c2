#include "core/selection/hidden.h"

#include "core/base/error.h"
#include "core/layers/layer_words.h"
#include "core/process/estimation/rim_samples.h"
#include "core/surface/definition.h"

#include <algorithm>

namespace selection {

using surfel::clusterSize, surfel::SurfelBlock;
using tree::SurfelTree;

/// A surface needs some surfels to be one.
constexpr std::size_t fewest = 16;

SurfelTree hidden(const SurfelTree& tree, Hiding which) {
    const int was = channelOf(*tree.layout(), Field::Hidden), chosen = channelOf(*tree.layout(), Field::Selection);
    const auto hides = [&](const SurfelBlock& block, int slot) {
        const bool before = valueAt(block, was, slot) >= half;
        switch (which) {
        case Hiding::Selected:
            return before || valueAt(block, chosen, slot) >= half;
        case Hiding::Rest:
            return before || valueAt(block, chosen, slot) < half;
        case Hiding::Masked:
            return before || block.mask(slot) >= half;
        case Hiding::Swap:
            return !before;
        }
        return before;
    };
    std::size_t shown = 0;
    tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            shown += hides(block, slot) ? 0 : 1;
    });
    if (shown < std::min(fewest, tree.size()))
        throw base::Error("next to nothing would be shown: " + std::to_string(shown) + " of " +
                              std::to_string(tree.size()) + " surfels",
                          {}, "hide less");
    const SurfelTree out = rewritten(tree, Field::Hidden, [&](auto, const SurfelBlock& block, BlockValues& values) {
        for (int slot = 0; slot < block.size(); ++slot)
            values[static_cast<std::size_t>(slot)] = hides(block, slot) ? 1.0f : 0.0f;
    });
    return chosen < 0 ? out : combined(out, selectedIn(out, Field::Hidden), Mode::Subtract);
}

SurfelTree allShown(const SurfelTree& tree) {
    const char* const name = attributeName(Field::Hidden);
    if (channelOf(*tree.layout(), Field::Hidden) < 0)
        return tree;
    return layers::laidOut(
        tree, layers::layoutWithout(*tree.layout(), [&](const std::string& each) { return each == name; }));
}

surface::Surface shownOf(const surface::Surface& surface) {
    const SurfelTree& tree = surface.tree();
    if (channelOf(*tree.layout(), Field::Hidden) < 0)
        return surface;
    const tree::Selection gone = selectedIn(tree, Field::Hidden);
    if (gone.empty() || sizeOf(gone) + fewest > tree.size()) // a file that hides everything
        return surface;
    tree::Edit edit;
    edit.inserted.layout = tree.layout();
    for (const tree::SelectedBlock& each : gone)
        edit.blocks.push_back({each.block, {}, each.slots});
    surface::SurfaceDefinition definition = surface.definition();
    definition.knownRims = false; // it ends where what is hidden begins
    if (!std::isfinite(definition.boundaryLimit))
        definition.boundaryLimit = process::loosestLimit; // which opens no pinholes, whatever the sampling
    return {tree.apply(edit), std::move(definition)};
}

namespace {

/// A surfel in its block, by all of its words.
struct Placed {
    const SurfelBlock* block;
    int slot;

    std::uint32_t word(int channel) const { return block->words(slot / clusterSize, channel)[slot % clusterSize]; }
    std::strong_ordering operator<=>(const Placed& o) const {
        const int channels = surfel::Extra + static_cast<int>(block->extraWords());
        for (int channel = 0; channel < channels; ++channel)
            if (const auto order = word(channel) <=> o.word(channel); order != 0)
                return order;
        return std::strong_ordering::equal;
    }
    bool operator==(const Placed& o) const { return (*this <=> o) == 0; }
};

std::vector<Placed> sortedIn(const std::vector<surfel::BlockPtr>& blocks) {
    std::vector<Placed> out;
    for (const surfel::BlockPtr& block : blocks)
        for (int slot = 0; slot < block->size(); ++slot)
            out.push_back({block.get(), slot});
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace

SurfelTree grafted(const SurfelTree& whole, const SurfelTree& before, const SurfelTree& after) {
    const tree::Diff difference = diff(before, after);
    const std::vector<Placed> was = sortedIn(difference.removed), is = sortedIn(difference.added);
    std::vector<Placed> gone, come;
    std::ranges::set_difference(was, is, std::back_inserter(gone));
    std::ranges::set_difference(is, was, std::back_inserter(come));

    std::vector<std::bitset<surfel::blockCapacity>> removed(whole.blockCount());
    for (const Placed& each : gone) {
        bool found = false;
        whole.forBlocksInBall(each.block->position(each.slot), 0, [&](std::uint32_t number, const SurfelBlock& block) {
            for (int slot = 0; slot < block.size() && !found; ++slot)
                if (!removed[number][static_cast<std::size_t>(slot)] && Placed{&block, slot} == each) {
                    removed[number].set(static_cast<std::size_t>(slot));
                    found = true;
                }
        });
    }
    tree::Edit edit;
    edit.layout = after.layout();
    edit.inserted.layout = after.layout();
    for (std::size_t b = 0; b < removed.size(); ++b)
        if (removed[b].any())
            edit.blocks.push_back({static_cast<std::uint32_t>(b), {}, removed[b]});
    std::vector<std::uint32_t> words(after.layout()->words());
    for (const Placed& each : come) {
        each.block->extra(each.slot, words);
        edit.inserted.append(each.block->surfel(each.slot), words);
    }
    return whole.apply(edit);
}

/// By how much more a place is off a plane than where the surface was there before.
static float grown(const SurfelTree& before, const base::Vec3f& x, const base::Vec3f& on, const base::Vec3f& n) {
    std::vector<tree::Neighbour> at;
    before.nearest(x, 1, at);
    if (at.empty())
        return 0;
    const base::Vec3f own = at[0].block->normal(at[0].slot);
    const base::Vec3f was = x - own * dot(x - at[0].block->position(at[0].slot), own);
    return std::abs(dot(x - on, n)) - std::abs(dot(was - on, n));
}

Step stepBesideHidden(const SurfelTree& whole, const SurfelTree& before, const SurfelTree& after) {
    constexpr float beside = 1.6f, moved = 0.1f; // spacings; what was beside an edge stays far from the plane across
    constexpr std::size_t looked = 12;
    const int channel = channelOf(*whole.layout(), Field::Hidden);
    Step out;
    std::vector<tree::Neighbour> near;
    for (const surfel::BlockPtr& block : diff(before, after).added)
        for (int slot = 0; slot < block->size(); ++slot) {
            const base::Vec3f x = block->position(slot);
            const float spacing = block->support(slot) * static_cast<float>(surface::spacingOfUnit);
            whole.nearest(x, looked, near);
            for (const tree::Neighbour& each : near) {
                const base::Vec3f way = x - each.block->position(each.slot), n = each.block->normal(each.slot);
                const float height = std::abs(dot(way, n));
                if (valueAt(*each.block, channel, each.slot) < half ||
                    length(way - n * dot(way, n)) > beside * spacing || dot(n, block->normal(slot)) < 0 ||
                    !(height > static_cast<float>(out.spacings) * spacing) ||
                    grown(before, x, each.block->position(each.slot), n) < moved * spacing)
                    continue;
                out = {static_cast<double>(height / spacing), static_cast<double>(height), x};
            }
        }
    return out;
}

namespace {

/// What of a surfel is its shape.
using Shape = std::array<float, 7>;

Shape shapeOf(const SurfelBlock& block, int slot) {
    const base::Vec3f p = block.position(slot), n = block.normal(slot);
    return {p.x, p.y, p.z, n.x, n.y, n.z, block.support(slot)};
}

/// Sorted; of a channel's hidden surfels alone unless that is -1.
std::vector<Shape> shapesIn(const std::vector<surfel::BlockPtr>& blocks, int channel) {
    std::vector<Shape> out;
    for (const surfel::BlockPtr& block : blocks)
        for (int slot = 0; slot < block->size(); ++slot)
            if (channel < 0 || valueAt(*block, channel, slot) >= half)
                out.push_back(shapeOf(*block, slot));
    std::ranges::sort(out);
    return out;
}

} // namespace

std::size_t hiddenChanged(const SurfelTree& before, const SurfelTree& after) {
    const int channel = channelOf(*before.layout(), Field::Hidden);
    if (channel < 0 || before == after)
        return 0;
    const tree::Diff difference = diff(before, after);
    const std::vector<Shape> was = shapesIn(difference.removed, channel), is = shapesIn(difference.added, -1);
    std::vector<Shape> gone;
    std::ranges::set_difference(was, is, std::back_inserter(gone));
    return gone.size();
}

SurfelTree hiddenSpared(const SurfelTree& before, const SurfelTree& after) {
    const int channel = channelOf(*before.layout(), Field::Hidden);
    if (channel < 0)
        return after;
    const std::vector<const SurfelBlock*> was = blocksOf(before), is = blocksOf(after);
    tree::Edit edit;
    for (std::size_t b = 0; b < is.size(); ++b) {
        if (was[b] == is[b])
            continue;
        surfel::MutableBlockPtr kept;
        for (int slot = 0; slot < is[b]->size(); ++slot)
            if (valueAt(*was[b], channel, slot) >= half) {
                if (!kept)
                    kept = is[b]->clone();
                const int cluster = slot / clusterSize, lane = slot % clusterSize,
                          channels = surfel::Extra + static_cast<int>(kept->extraWords());
                for (int word = 0; word < channels; ++word)
                    kept->words(cluster, word)[lane] = was[b]->words(cluster, word)[lane];
            }
        if (kept) {
            kept->seal();
            edit.blocks.push_back({static_cast<std::uint32_t>(b), kept, {}});
        }
    }
    return after.apply(edit);
}

} // namespace selection
