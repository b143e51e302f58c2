#include "core/layers/layer_words.h"

#include "core/base/error.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace layers {

using surfel::AttributeLayout, surfel::clusterSize, surfel::SurfelBlock;

/// Blocks on one thread in a row.
constexpr std::size_t grain = 16;

constexpr std::array<const char*, layerWords> endings{"x", "y", "z", "nx", "ny", "nz", "support", "mask"};

/// Groups of the base have id 0, and no mask.
static int wordsOf(std::uint32_t id) {
    return id == 0 ? baseWords : layerWords;
}

static std::string nameOf(std::uint32_t id, int word) {
    return "layer_" + (id == 0 ? "base" : std::to_string(id)) + "_" + endings[static_cast<std::size_t>(word)];
}

/// The channel of the first word of a group that stands there as a whole; 0: there is none.
static int channelOf(const AttributeLayout& layout, std::uint32_t id) {
    std::size_t first = 0;
    for (int word = 0; word < wordsOf(id); ++word) {
        const surfel::Attribute* attribute = layout.find(nameOf(id, word));
        if (!attribute || attribute->type != surfel::ScalarType::Float32)
            return 0;
        if (word == 0)
            first = attribute->firstWord;
        if (attribute->firstWord != first + static_cast<std::size_t>(word))
            return 0;
    }
    return surfel::Extra + static_cast<int>(first);
}

std::optional<Channels> Channels::of(const AttributeLayout& layout, const Stack& stack) {
    Channels out;
    out.base = channelOf(layout, 0);
    bool whole = out.base > 0;
    for (const Layer& each : stack.layers) {
        out.layers.push_back(channelOf(layout, each.id));
        whole = whole && out.layers.back() > 0;
    }
    return whole ? std::optional(out) : std::nullopt;
}

bool areSound(const tree::SurfelTree& tree, const Channels& channels) {
    const float far = 1000 * std::max(tree.bounds().diagonal(), std::numeric_limits<float>::min());
    constexpr float turned = 1e4f, widened = 100; // far beyond what edits leave
    constexpr float roundedUnit = 1e-3f;
    const base::Vec3f middle = tree.bounds().centre();
    bool sound = true;
    tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
        const auto valueOf = [&](int slot, int channel) {
            return block.channel(slot / clusterSize, channel)[slot % clusterSize];
        };
        const auto within = [&](int slot, int channel, float about, float most) {
            sound = sound && std::abs(valueOf(slot, channel) - about) <= most; // false for what is no number, too
        };
        for (int slot = 0; slot < block.size() && sound; ++slot) {
            for (int k = 0; k < 3; ++k)
                within(slot, channels.base + k, middle[static_cast<std::size_t>(k)], far);
            const base::Vec3f normal{valueOf(slot, channels.base + 3), valueOf(slot, channels.base + 4),
                                     valueOf(slot, channels.base + 5)};
            sound = sound && (normal == base::Vec3f{} || std::abs(length(normal) - 1) <= roundedUnit);
            within(slot, channels.base + 6, 0, far);
            for (const int layer : channels.layers) {
                for (int k = 0; k < 3; ++k)
                    within(slot, layer + Displacement + k, 0, far), within(slot, layer + Area + k, 0, turned);
                within(slot, layer + Widening, 0, widened);
                within(slot, layer + OwnMask, 0.5f, 0.5f);
            }
        }
    });
    return sound;
}

static void addGroup(AttributeLayout& layout, std::uint32_t id) {
    if (channelOf(layout, id) > 0)
        return;
    for (int word = 0; word < wordsOf(id); ++word)
        if (layout.find(nameOf(id, word)))
            throw base::Error("the model has an attribute \"" + nameOf(id, word) + "\" that is no part of a layer",
                              "layer", "give it another name in the file");
    for (int word = 0; word < wordsOf(id); ++word)
        layout.add(nameOf(id, word), surfel::ScalarType::Float32);
}

tree::SurfelTree laidOut(const tree::SurfelTree& tree, const surfel::AttributeLayoutPtr& layout,
                         const std::function<void(SurfelBlock&)>& fill) {
    const AttributeLayout& from = *tree.layout();
    std::vector<std::pair<int, int>> kept; // words: new, old
    std::vector<int> fresh;
    for (const surfel::Attribute& each : layout->attributes()) {
        const surfel::Attribute* known = from.find(each.name);
        for (std::size_t w = 0; w < surfel::wordsOf(each.type); ++w) {
            const int word = static_cast<int>(each.firstWord + w);
            if (known && known->type == each.type)
                kept.emplace_back(word, static_cast<int>(known->firstWord + w));
            else
                fresh.push_back(word);
        }
    }
    std::vector<const SurfelBlock*> blocks(tree.blockCount());
    tree.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) { blocks[number] = &block; });
    tree::Edit edit;
    edit.blocks.resize(blocks.size());
    edit.layout = layout;
    base::parallelFor(blocks.size(), grain, [&](std::size_t b) {
        surfel::MutableBlockPtr out = SurfelBlock::create(blocks[b]->size(), layout->words());
        for (int cluster = 0; cluster < out->clusterCount(); ++cluster) {
            std::copy_n(blocks[b]->channel(cluster, 0), surfel::Extra * clusterSize, out->channel(cluster, 0));
            for (const auto& [to, old] : kept)
                std::copy_n(blocks[b]->channel(cluster, surfel::Extra + old), clusterSize,
                            out->channel(cluster, surfel::Extra + to));
            for (const int word : fresh)
                std::fill_n(out->channel(cluster, surfel::Extra + word), clusterSize, 0.0f);
        }
        if (fill)
            fill(*out);
        out->seal();
        edit.blocks[b].block = static_cast<std::uint32_t>(b);
        edit.blocks[b].changed = out;
    });
    return tree.apply(edit);
}

tree::SurfelTree withWords(const tree::SurfelTree& tree, const Stack& before, std::uint32_t id) {
    auto layout = std::make_shared<AttributeLayout>(*tree.layout());
    addGroup(*layout, 0);
    addGroup(*layout, id);
    const int base = before.empty() ? channelOf(*layout, 0) : 0, own = channelOf(*layout, id);
    return laidOut(tree, layout, [base, own](SurfelBlock& block) { // whatever a file had under these names
        for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
            std::fill_n(block.channel(cluster, own), layerWords * clusterSize, 0.0f);
            if (base > 0)
                std::copy_n(block.channel(cluster, surfel::X), baseWords * clusterSize, block.channel(cluster, base));
        }
    });
}

surfel::AttributeLayoutPtr layoutWithout(const AttributeLayout& layout,
                                         const std::function<bool(const std::string&)>& gone) {
    auto out = std::make_shared<AttributeLayout>();
    out->normals = layout.normals, out->oriented = layout.oriented;
    out->colours = layout.colours, out->masks = layout.masks;
    for (const surfel::Attribute& each : layout.attributes())
        if (!gone(each.name))
            out->add(each.name, each.type);
    return out;
}

tree::SurfelTree withoutWords(const tree::SurfelTree& tree, const Stack& after, std::uint32_t id) {
    return laidOut(tree, layoutWithout(*tree.layout(), [&](const std::string& name) {
                       const auto names = [&](std::uint32_t group) {
                           for (int word = 0; word < wordsOf(group); ++word)
                               if (name == nameOf(group, word))
                                   return true;
                           return false;
                       };
                       return names(id) || (after.empty() && names(0));
                   }));
}

} // namespace layers
