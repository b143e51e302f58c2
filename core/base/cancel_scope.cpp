#include "core/base/cancel_scope.h"

#include "core/base/error.h"

namespace base {

static thread_local const std::atomic<bool>* innermost = nullptr;

CancelScope::CancelScope(const std::atomic<bool>* cancel) : m_outer(innermost) {
    if (cancel)
        innermost = cancel;
}

CancelScope::~CancelScope() {
    innermost = m_outer;
}

const std::atomic<bool>* CancelScope::flag() {
    return innermost;
}

void CancelScope::check() {
    if (innermost && innermost->load(std::memory_order_relaxed))
        throw Cancelled();
}

} // namespace base
