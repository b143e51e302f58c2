#include "core/reduce/watch.h"

#include <utility>

namespace reduce {

static thread_local const WatchScope* innermost = nullptr;

WatchScope::WatchScope(Watch watch) : m_watch(std::move(watch)), m_outer(std::exchange(innermost, this)) {}

WatchScope::~WatchScope() {
    innermost = m_outer;
}

void WatchScope::tell(const Sites& floaters) {
    if (innermost && innermost->m_watch)
        innermost->m_watch(floaters);
}

} // namespace reduce
