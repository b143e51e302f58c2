// The order in which a search for neighbours enters the children of a node.
#pragma once

#include "core/tree/node.h"

namespace tree {

/// Numbers of the first `count` by ascending distance, equal ones by number. Few of them: sorted by insertion.
inline void nearestFirstOrder(const float (&distance)[fanOut], int count, int (&order)[fanOut]) {
    for (int i = 0; i < count; ++i) {
        int at = i;
        for (; at > 0 && distance[order[at - 1]] > distance[i]; --at)
            order[at] = order[at - 1];
        order[at] = i;
    }
}

} // namespace tree
