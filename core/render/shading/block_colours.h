// Colours that stand beside a version's blocks instead of in them: what shadings of measured numbers show. Splats blend
// them like the surfels' own.
//
// Blocks that a table lacks show their own: those that an edit has just made, until they are measured, and what stands
// for a node of the tree (node_detail.h), whose colours come from the table already.
//
// A table shares the colours of the blocks that versions share, by address: renderers tell by it what is new.
#pragma once

#include "core/surfel/surfel_block.h"
#include "core/tree/surfel_tree.h"

#include <memory>
#include <unordered_map>

namespace render {

class BlockColours {
  public:
    using Colours = std::shared_ptr<const std::vector<surfel::Colour>>; ///< blockCapacity of them, whatever the size

    /// `version` keeps the blocks alive whose addresses are the keys.
    explicit BlockColours(tree::SurfelTree version) : m_version(std::move(version)) {}

    void set(const surfel::SurfelBlock* block, Colours colours) { m_colours[block] = std::move(colours); }
    /// Null where none are known.
    const surfel::Colour* of(const surfel::SurfelBlock* block) const {
        const auto found = m_colours.find(block);
        return found != m_colours.end() ? found->second->data() : nullptr;
    }
    Colours shared(const surfel::SurfelBlock* block) const {
        const auto found = m_colours.find(block);
        return found != m_colours.end() ? found->second : nullptr;
    }
    const tree::SurfelTree& version() const { return m_version; }

  private:
    tree::SurfelTree m_version;
    std::unordered_map<const surfel::SurfelBlock*, Colours> m_colours;
};

} // namespace render
