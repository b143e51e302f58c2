// Memory for arrays of many megabytes, in pages as large as the system gives: touching it for the first time then
// costs a fraction. Nothing is initialised.
#pragma once

#include <cstddef>

namespace base {

/// Throws std::bad_alloc. To be given back by `freeLarge`.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory);

/// Wishes for large pages in memory that somebody else allocated and nobody has touched yet: what a vector reserved.
void preferLargePages(void* memory, std::size_t bytes);

} // namespace base
