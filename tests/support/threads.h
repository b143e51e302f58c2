// The same work on any number of threads: what it returns may not tell how many there were.
#pragma once

#include "core/base/parallel.h"

namespace test {

/// What `work` returns on that many threads; the number is as before afterwards, whatever happens.
template <class Work>
auto onThreads(int count, const Work& work) {
    struct Kept {
        int before = base::threadCount();
        ~Kept() { base::setThreadCount(before); }
    } const kept;
    base::setThreadCount(count);
    return work();
}

} // namespace test
