#include "core/render/shading/selected_colours.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace render {

using surfel::SurfelBlock;
using Colours = BlockColours::Colours;

constexpr const char* selectionName = "selection";

surfel::Colour underSelection(surfel::Colour colour, float selected) {
    constexpr float orange[] = {255, 132, 26}, most = 0.85f;
    const float t = most * std::clamp(selected, 0.0f, 1.0f);
    surfel::Colour out = colour & 0xff000000u;
    for (int k = 0; k < 3; ++k) {
        const auto from = static_cast<float>(colour >> (8 * k) & 255u);
        out |= static_cast<surfel::Colour>(from + t * (orange[k] - from) + 0.5f) << (8 * k);
    }
    return out;
}

process::FieldQuestion selectionQuestion(const surface::Surface& surface) {
    return {process::Quantity::Attribute, surface, {}, selectionName};
}

/// Of blocks in which nothing is selected, under a material.
static const Colours& plain() {
    static const Colours out =
        std::make_shared<const std::vector<surfel::Colour>>(surfel::blockCapacity, surfel::white);
    return out;
}

static bool anySelected(const SurfelBlock& block, int channel) {
    for (int slot = 0; slot < block.size(); ++slot)
        if (block.channel(slot / surfel::clusterSize, channel)[slot % surfel::clusterSize] > 0)
            return true;
    return false;
}

/// Over `under`, else over the surfels' own colours or white.
static Colours coloursOf(const SurfelBlock& block, int channel, const surfel::Colour* under, bool own) {
    auto out = std::make_shared<std::vector<surfel::Colour>>(surfel::blockCapacity, surfel::white);
    for (int slot = 0; slot < block.size(); ++slot) {
        const float selected = block.channel(slot / surfel::clusterSize, channel)[slot % surfel::clusterSize];
        const surfel::Colour base = under ? under[slot] : own ? block.surfel(slot).colour : surfel::white;
        (*out)[static_cast<std::size_t>(slot)] = underSelection(base, selected);
    }
    return out;
}

SelectedColours showSelected(const tree::SurfelTree& version, Shading shading,
                             std::shared_ptr<const BlockColours> under, const SelectedColours* before) {
    const surfel::Attribute* attribute = version.layout()->find(selectionName);
    if (!attribute || attribute->type != surfel::ScalarType::Float32)
        return {under, under};
    const int channel = surfel::Extra + static_cast<int>(attribute->firstWord);
    const bool own = shadingRow(shading).usesColour();
    std::vector<const SurfelBlock*> blocks(version.blockCount());
    std::vector<Colours> found(blocks.size());
    std::vector<char> selected(blocks.size());
    version.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) { blocks[number] = &block; });
    base::parallelFor(blocks.size(), 64, [&](std::size_t i) {
        const SurfelBlock& block = *blocks[i];
        selected[i] = anySelected(block, channel) ? 1 : 0;
        const surfel::Colour* beneath = under ? under->of(&block) : nullptr;
        if (!selected[i]) {
            found[i] = beneath ? under->shared(&block) : own ? nullptr : plain();
            return;
        }
        const bool same = before && before->shown && (before->under ? before->under->of(&block) : nullptr) == beneath;
        if (same)
            found[i] = before->shown->shared(&block);
        if (!found[i])
            found[i] = coloursOf(block, channel, beneath, own);
    });
    if (std::find(selected.begin(), selected.end(), 1) == selected.end())
        return {under, under};
    auto shown = std::make_shared<BlockColours>(version);
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (found[i])
            shown->set(blocks[i], std::move(found[i]));
    return {std::move(under), std::move(shown)};
}

} // namespace render
