#include "core/base/large_memory.h"

#include <cstdint>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace base {

constexpr std::size_t largePage = std::size_t(1) << 21;

void* allocateLarge(std::size_t bytes) {
    const std::size_t whole = (bytes + largePage - 1) / largePage * largePage;
    void* out = whole >= bytes ? std::aligned_alloc(largePage, whole) : nullptr;
    if (!out && bytes > 0)
        throw std::bad_alloc();
#ifdef __linux__
    if (out)
        madvise(out, whole, MADV_HUGEPAGE); // a wish; small pages do as well
#endif
    return out;
}

void freeLarge(void* memory) {
    std::free(memory);
}

void preferLargePages(void* memory, std::size_t bytes) {
#ifdef __linux__
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (begin + largePage - 1) / largePage * largePage,
                         last = (begin + bytes) / largePage * largePage;
    if (first < last)
        madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#else
    (void)memory, (void)bytes;
#endif
}

} // namespace base
