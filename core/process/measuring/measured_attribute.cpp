#include "core/process/measuring/measured_attribute.h"

#include "core/base/error.h"

#include <bit>

namespace process {

using surfel::SurfelBlock;
using tree::SurfelTree;

/// The same surfels with room for one more word each.
static surfel::MutableBlockPtr widened(const SurfelBlock& block) {
    surfel::MutableBlockPtr out = SurfelBlock::create(block.size(), block.extraWords() + 1);
    std::vector<std::uint32_t> words(block.extraWords() + 1);
    for (int slot = 0; slot < block.size(); ++slot) {
        out->set(slot, block.surfel(slot));
        block.extra(slot, std::span(words).first(block.extraWords()));
        out->setExtra(slot, words);
    }
    return out;
}

/// An edit by fn(copy, slot, place in tree order) -> did it change? Every block gets a copy by `copied`; those in which
/// nothing changed are left out unless `all`.
template <class Copied, class Fn>
static tree::Edit editOf(const SurfelTree& tree, bool all, const Copied& copied, const Fn& fn) {
    tree::Edit edit;
    edit.inserted.layout = tree.layout();
    std::size_t at = 0;
    tree.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) {
        const surfel::MutableBlockPtr copy = copied(block);
        bool changed = all;
        for (int slot = 0; slot < block.size(); ++slot, ++at)
            changed |= fn(*copy, slot, at);
        if (!changed)
            return;
        copy->seal();
        edit.blocks.push_back({number, copy, {}});
    });
    return edit;
}

SurfelTree withAttribute(const SurfelTree& tree, const std::string& name, std::span<const float> values) {
    const surfel::Attribute* attribute = tree.layout()->find(name);
    if (attribute && attribute->type != surfel::ScalarType::Float32)
        throw base::Error("the model has an attribute \"" + name + "\" that holds something else", {},
                          "rename it in the file");
    const bool fresh = !attribute;
    auto layout = std::make_shared<surfel::AttributeLayout>(*tree.layout());
    if (fresh)
        layout->add(name, surfel::ScalarType::Float32);
    const int channel = surfel::Extra + static_cast<int>(layout->find(name)->firstWord);
    const auto copied = [&](const SurfelBlock& block) { return fresh ? widened(block) : block.clone(); };
    tree::Edit edit = editOf(tree, fresh, copied, [&](SurfelBlock& block, int slot, std::size_t at) {
        std::uint32_t& word = block.words(slot / surfel::clusterSize, channel)[slot % surfel::clusterSize];
        const auto next = std::bit_cast<std::uint32_t>(values[at]);
        return std::exchange(word, next) != next;
    });
    if (fresh)
        edit.layout = layout;
    return tree.apply(edit);
}

SurfelTree withColours(const SurfelTree& tree, std::span<const surfel::Colour> colours) {
    const auto copied = [](const SurfelBlock& block) { return block.clone(); };
    const tree::Edit edit = editOf(tree, false, copied, [&](SurfelBlock& block, int slot, std::size_t at) {
        surfel::Surfel s = block.surfel(slot);
        if (s.colour == colours[at])
            return false;
        s.colour = colours[at];
        block.set(slot, s);
        return true;
    });
    auto layout = std::make_shared<surfel::AttributeLayout>(*tree.layout());
    layout->colours = true;
    return tree.apply(edit).withLayout(layout);
}

} // namespace process
