#include "core/selection/parts.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/estimation/part_limit.h"

namespace selection {

using surfel::SurfelBlock;
using tree::SurfelTree;

/// A surface needs some surfels to be one.
constexpr std::size_t fewest = 16;

static SurfelTree without(const SurfelTree& tree, bool selected) {
    const int channel = channelOf(*tree.layout(), Field::Selection);
    const int hidden = selected ? -1 : channelOf(*tree.layout(), Field::Hidden);
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    std::vector<tree::BlockEdit> edits(blocks.size());
    base::parallelFor(blocks.size(), 16, [&](std::size_t b) {
        edits[b].block = static_cast<std::uint32_t>(b);
        for (int slot = 0; slot < blocks[b]->size(); ++slot)
            edits[b].removed[static_cast<std::size_t>(slot)] =
                (valueAt(*blocks[b], channel, slot) >= half) == selected && valueAt(*blocks[b], hidden, slot) < half;
    });
    tree::Edit edit;
    edit.inserted.layout = tree.layout();
    std::size_t count = 0;
    for (tree::BlockEdit& each : edits)
        if (each.removed.any())
            count += each.removed.count(), edit.blocks.push_back(std::move(each));
    if (count > 0 && count + fewest > tree.size())
        throw base::Error("next to nothing would be left: " + std::to_string(tree.size() - count) + " of " +
                              std::to_string(tree.size()) + " surfels",
                          {}, selected ? "select less" : "select more");
    return tree.apply(edit);
}

SurfelTree withoutSelected(const SurfelTree& tree) {
    return without(tree, true);
}

SurfelTree withoutRest(const SurfelTree& tree) {
    return without(tree, false);
}

surface::Surface asPart(const surface::Surface& whole, SurfelTree part, const base::Progress& progress) {
    const bool anyHidden = sizeOf(selectedIn(whole.tree(), Field::Hidden)) > 0;
    return process::partOf(whole, std::move(part), progress, !anyHidden);
}

surfel::SurfelList partOf(const SurfelTree& tree, bool selected) {
    const int channel = channelOf(*tree.layout(), Field::Selection);
    surfel::SurfelList out;
    out.layout = tree.layout();
    std::vector<std::uint32_t> words(tree.layout()->words());
    tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            if ((valueAt(block, channel, slot) >= half) != selected)
                continue;
            block.extra(slot, words);
            if (channel >= 0)
                words[static_cast<std::size_t>(channel - surfel::Extra)] = 0;
            out.append(block.surfel(slot), words);
        }
    });
    return out;
}

/// The version in which `change(block, slot, weight)` was done to a copy of every block that has surfels to change.
template <class Change>
static tree::Edit changedUnder(const SurfelTree& tree, Limit limit, double least, const Change& change) {
    const int channel = channelOf(*tree.layout(), Field::Selection);
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    std::vector<surfel::BlockPtr> changed(blocks.size());
    base::parallelFor(blocks.size(), 16, [&](std::size_t b) {
        surfel::MutableBlockPtr copy;
        for (int slot = 0; slot < blocks[b]->size(); ++slot) {
            const double weight = weightUnder(limit, *blocks[b], channel, slot);
            if (weight < least || weight == 0)
                continue;
            if (!copy)
                copy = blocks[b]->clone();
            change(*copy, slot, weight);
        }
        if (copy) {
            copy->seal();
            changed[b] = copy;
        }
    });
    tree::Edit edit;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (changed[b])
            edit.blocks.push_back({static_cast<std::uint32_t>(b), std::move(changed[b]), {}});
    return edit;
}

SurfelTree recoloured(const SurfelTree& tree, const std::function<surfel::Colour(surfel::Colour)>& colourFor,
                      double strength, Limit limit) {
    tree::Edit edit = changedUnder(tree, limit, 0, [&](SurfelBlock& block, int slot, double weight) {
        std::uint32_t& word = block.words(slot / surfel::clusterSize, surfel::ColourWord)[slot % surfel::clusterSize];
        surfel::Colour next = word & 0xff000000u;
        const surfel::Colour colour = colourFor(word);
        for (unsigned c = 0; c < 3; ++c) {
            const double a = static_cast<double>(word >> 8 * c & 255u), b = static_cast<double>(colour >> 8 * c & 255u);
            next |= static_cast<surfel::Colour>(std::lround(a + (b - a) * weight * strength)) << 8 * c;
        }
        word = next;
    });
    if (!edit.blocks.empty() && !tree.layout()->colours) {
        auto layout = std::make_shared<surfel::AttributeLayout>(*tree.layout());
        layout->colours = true;
        edit.layout = layout;
    }
    return tree.apply(edit);
}

SurfelTree coloured(const SurfelTree& tree, surfel::Colour colour, double strength, Limit limit) {
    return recoloured(
        tree, [colour](surfel::Colour) { return colour; }, strength, limit);
}

SurfelTree flipped(const SurfelTree& tree, Limit limit) {
    return tree.apply(changedUnder(tree, limit, static_cast<double>(half), [](SurfelBlock& block, int slot, double) {
        block.setNormal(slot, -block.normal(slot));
    }));
}

} // namespace selection
