// Labels of cells on both sides of a seam (solid/README 2.3). Inside this room only.
#pragma once

#include "core/cells/labels.h"
#include "core/solid/fillet.h"
#include "core/tree/surfel_tree.h"

namespace solid {

/// A version with labels: as it is, or all of one cell; with sharpness and faces where `other` has them. Surfels keep
/// their order. Throws base::Error where an attribute of a label's name holds something else.
tree::SurfelTree labelled(const tree::SurfelTree& tree, const tree::SurfelTree& other);

/// A number that no cell and no face has.
std::uint32_t firstFree(const tree::SurfelTree& tree);

/// Of the surfel nearest to a place; cell 0 of models without labels.
cells::Label nearestLabel(const tree::SurfelTree& tree, const base::Vec3d& x);

void writeLabel(const surfel::AttributeLayout& layout, const cells::Label& label, std::span<std::uint32_t> words);

/// A surfel's label from now on, beside a seam with that cell across.
cells::Label besideSeam(cells::Label label, std::uint32_t across, cells::Meeting meeting);

/// A block some of whose surfels get other labels: copied at the first of them.
class RelabelledBlock {
  public:
    RelabelledBlock(const surfel::SurfelBlock& block, const surfel::AttributeLayout& layout)
        : m_block(block), m_layout(layout) {}
    void put(int slot, const cells::Label& label);
    /// Seals the copy, if there is one, as what the block becomes. Returns how many got a label.
    std::size_t giveTo(tree::BlockEdit& edit);

  private:
    const surfel::SurfelBlock& m_block;
    const surfel::AttributeLayout& m_layout;
    surfel::MutableBlockPtr m_copy;
    std::size_t m_count = 0;
};

/// Words of one layout as those of another: attributes of the same name, others zero; so is what layers hold.
class Translation {
  public:
    Translation(const surfel::AttributeLayout& from, const surfel::AttributeLayout& to);
    std::span<std::uint32_t> operator()(std::span<const std::uint32_t> words);

  private:
    std::vector<std::pair<surfel::Attribute, surfel::Attribute>> m_pairs;
    std::vector<std::uint32_t> m_words;
};

/// Faces that a fillet makes one: those of both sides where the ball touches them.
class JoinedFaces {
  public:
    /// `offset`: added to the operand's numbers. Fresh numbers start at `next`.
    JoinedFaces(const tree::SurfelTree& model, const tree::SurfelTree& operand, std::uint32_t offset,
                std::uint32_t next, const std::vector<FilletPlace>& contacts);
    std::uint32_t of(std::uint32_t face) const;
    /// The model with its faces so.
    tree::SurfelTree in(const tree::SurfelTree& model) const;

  private:
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_joined; ///< a face, and what it is now; by face
};

} // namespace solid
