#include "core/layers/layer_edits.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/layers/settle_block.h"

#include <algorithm>
#include <unordered_set>

namespace layers {

using surfel::MutableBlockPtr, surfel::SurfelBlock;
using tree::SurfelTree;

/// Blocks on one thread in a row.
constexpr std::size_t few = 2;

namespace {

/// New surfels, a block of them at a time.
void settle(surfel::SurfelList& list, const SurfelTree& before, const SettleRules& rules) {
    constexpr auto capacity = static_cast<std::size_t>(surfel::blockCapacity);
    const std::size_t words = list.layout->words();
    base::parallelFor((list.size() + capacity - 1) / capacity, few, [&](std::size_t part) {
        const std::size_t first = part * capacity, count = std::min(capacity, list.size() - first);
        Inheritance inheritance(before, rules.channels);
        MutableBlockPtr block = SurfelBlock::create(static_cast<int>(count), words);
        for (std::size_t i = 0; i < count; ++i) {
            block->set(static_cast<int>(i), list.items[first + i]);
            block->setExtra(static_cast<int>(i), list.extraOf(first + i));
        }
        settle(*block, rules, &inheritance);
        for (std::size_t i = 0; i < count; ++i) {
            list.items[first + i] = block->surfel(static_cast<int>(i));
            block->extra(static_cast<int>(i), std::span(list.extra).subspan((first + i) * words, words));
        }
    });
}

tree::Edit settled(const SurfelTree& before, tree::Edit edit, const Stack& stack, How how) {
    const auto channels = Channels::of(*(edit.layout ? edit.layout : before.layout()), stack);
    if (stack.empty() || !channels || edit.empty())
        return edit;
    const SettleRules rules{*channels, weightsOf(stack), stack.target(), how};
    base::parallelFor(edit.blocks.size(), few, [&](std::size_t i) {
        if (!edit.blocks[i].changed)
            return;
        base::CancelScope::check();
        Inheritance inheritance(before, rules.channels);
        if (const surfel::BlockPtr next = settled(*edit.blocks[i].changed, rules, &inheritance))
            edit.blocks[i].changed = next;
    });
    if (!edit.inserted.items.empty())
        settle(edit.inserted, before, rules);
    return edit;
}

} // namespace

tree::Edit recorded(const SurfelTree& before, tree::Edit edit, const Stack& stack) {
    return settled(before, std::move(edit), stack, How::Record);
}

tree::Edit carried(const SurfelTree& before, tree::Edit edit, const Stack& stack) {
    return settled(before, std::move(edit), stack, How::Carry);
}

SurfelTree reconciled(const SurfelTree& before, const SurfelTree& after, const Stack& stack, How how) {
    if (stack.empty() || after.empty() || !Channels::of(*after.layout(), stack))
        return after;
    const tree::Diff diff = tree::diff(before, after);
    std::unordered_set<const SurfelBlock*> added;
    for (const surfel::BlockPtr& each : diff.added)
        added.insert(each.get());
    tree::Edit edit;
    after.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) {
        if (added.contains(&block))
            edit.blocks.push_back({number, surfel::BlockPtr(&block), {}});
    });
    // what is inherited lies in the words of the version before, at its own channels
    const auto known = Channels::of(*before.layout(), stack);
    const SettleRules rules{*Channels::of(*after.layout(), stack), weightsOf(stack), stack.target(), how};
    base::parallelFor(edit.blocks.size(), few, [&](std::size_t i) {
        base::CancelScope::check();
        Inheritance inheritance(before, known ? *known : rules.channels, known.has_value());
        edit.blocks[i].changed = settled(*edit.blocks[i].changed, rules, &inheritance);
    });
    std::erase_if(edit.blocks, [](const tree::BlockEdit& each) { return !each.changed; });
    return after.apply(edit);
}

} // namespace layers
