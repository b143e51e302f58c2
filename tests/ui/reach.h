// What became of a ball about the origin.
#pragma once

#include "window_fixture.h"

namespace test {

struct Reach {
    float lowest = 1e9f, highest = 0;
};
/// Smallest and largest distance from the origin: what happened to a sphere about it.
inline Reach reachOf(WindowFixture& f) {
    Reach out;
    for (const auto& s : f.editor().snapshot().surface.tree().surfels().items) {
        out.lowest = std::min(out.lowest, length(s.position));
        out.highest = std::max(out.highest, length(s.position));
    }
    return out;
}

} // namespace test
