// A surfel: one sample of a point-set surface, and plain lists of them for import, insertion and tests.
//
// Positions are float32 relative to the model's float64 origin. Lengths are in model units.
#pragma once

#include "core/base/vec.h"
#include "core/surfel/attributes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace surfel {

/// 0xAABBGGRR: red in the lowest byte, as GL and PNG want it in memory.
using Colour = std::uint32_t;
constexpr Colour white = 0xffffffffu;
constexpr Colour rgba(unsigned r, unsigned g, unsigned b, unsigned a = 255) {
    return r | g << 8 | b << 16 | a << 24;
}

struct Surfel {
    base::Vec3f position;
    base::Vec3f normal; ///< unit length, or zero where unknown; its sign has no meaning unless the layout says oriented
    float support = 0;  ///< radius beyond which its weight is zero (surfel/README 1); > 0 once in a tree
    Colour colour = white;
    float mask = 0; ///< 0 free, 1 protected from tools

    bool operator==(const Surfel&) const = default;
};

/// Surfels in plain order with their further attributes: `extra` holds `layout->words()` words per surfel.
struct SurfelList {
    AttributeLayoutPtr layout = AttributeLayout::none();
    std::vector<Surfel> items;
    std::vector<std::uint32_t> extra;

    std::size_t size() const { return items.size(); }
    std::span<const std::uint32_t> extraOf(std::size_t i) const {
        return {extra.data() + i * layout->words(), layout->words()};
    }
    /// REQUIRES: `words` has layout->words() entries.
    void append(const Surfel& s, std::span<const std::uint32_t> words) {
        items.push_back(s);
        extra.insert(extra.end(), words.begin(), words.end());
    }
};

} // namespace surfel
