// Trees put beside each other: new nodes above their roots.
#include "core/tree/regroup.h"
#include "core/tree/surfel_tree.h"

#include <algorithm>
#include <cassert>

namespace tree {

SurfelTree SurfelTree::beside(std::span<const SurfelTree> trees) {
    int highest = 0;
    surfel::AttributeLayoutPtr layout;
    for (const SurfelTree& each : trees)
        if (!each.empty()) {
            assert(!layout || layout->words() == each.layout()->words());
            highest = std::max(highest, int{each.root()->level});
            layout = layout ? layout : each.layout();
        }
    Children roots;
    for (const SurfelTree& each : trees) {
        if (each.empty())
            continue;
        Child child = asChild(each.root());
        for (int level = each.root()->level; level < highest; ++level) // blocks are all at one depth
            child = asChild(makeNode(level + 1, {&child, 1}));
        roots.push_back(std::move(child));
    }
    if (roots.empty())
        return {};
    return {rootAbove(highest + 1, std::move(roots)), layout};
}

} // namespace tree
