// Numbers of threads at which a law compares bits.
#pragma once

#include "support/sanitized.h"

#include <vector>

namespace test {

/// One thread and `others`; under a sanitizer `others` alone. There is no race among one, and TSan makes it sixty times
/// as slow: that the bits are the same is for the optimised build to say. Compare the first with each.
inline std::vector<int> comparedThreads(std::vector<int> others) {
    if (!sanitized)
        others.insert(others.begin(), 1);
    return others;
}

} // namespace test
