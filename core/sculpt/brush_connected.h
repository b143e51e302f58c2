// Which surfels under a brush can be walked to from its contact, so that a brush does not grab the other side of a thin
// sheet.
//
// Two surfels are neighbours where they are at most `reach` apart, their normals agree (n.m > -0.2, which walks around
// sharp edges; |n.m| where signs mean nothing) and neither lies above the other: the way between them rises at most 60
// degrees over both tangent planes. Connected is what a chain of neighbours inside the brush joins to the contact. The
// relation is symmetric, so that the answer does not depend on the order of the walk. Cost: the surfels under the
// brush.
#pragma once

#include "core/sculpt/contact.h"

#include <bitset>
#include <unordered_map>

namespace sculpt {

class Connected {
  public:
    /// Under the ball of `radius` around the contact, on one version; `reach` in model units, some two spacings.
    Connected(const tree::SurfelTree& version, const Contact& from, float radius, float reach);

    using Slots = std::bitset<surfel::blockCapacity>;
    /// Of a block of that version, by number; null where none of its surfels is connected.
    const Slots* slotsOf(std::uint32_t block) const {
        const auto found = m_blocks.find(block);
        return found == m_blocks.end() ? nullptr : &found->second;
    }
    std::size_t count() const { return m_count; } ///< connected surfels

  private:
    std::unordered_map<std::uint32_t, Slots> m_blocks;
    std::size_t m_count = 0;
};

} // namespace sculpt
