// A 128-bit content hash whose sum does not depend on order: the hash of a set is the sum of its members' hashes.
//
// Blocks can therefore be hashed on their own, in parallel, and a model has the same hash however its tree is cut.
// Not cryptographic; collisions of honest data have probability about n^2 / 2^128.
#pragma once

#include "core/base/random.h"

#include <cstdio>
#include <span>
#include <string>

namespace base {

struct Hash128 {
    std::uint64_t lo = 0, hi = 0;

    bool operator==(const Hash128&) const = default;
    Hash128& operator+=(const Hash128& o) {
        const std::uint64_t sum = lo + o.lo;
        hi += o.hi + (sum < lo ? 1 : 0);
        lo = sum;
        return *this;
    }
    /// 32 hexadecimal digits.
    std::string text() const {
        char out[33];
        std::snprintf(out, sizeof out, "%016llx%016llx", static_cast<unsigned long long>(hi),
                      static_cast<unsigned long long>(lo));
        return out;
    }
};

/// Hash of a sequence of words, in their order.
inline Hash128 hashWords(std::span<const std::uint32_t> words) {
    Hash128 out{0x243f6a8885a308d3ULL, 0x13198a2e03707344ULL};
    for (const std::uint32_t word : words) {
        out.lo = mix(out.lo ^ word);
        out.hi = mix(out.hi + out.lo + word);
    }
    return out;
}

} // namespace base
