// What surfels of a model with cells carry (cells/README 1): a label, and at creases which cell is across.
//
// Labels are attributes by name, so that files, tools and resampling treat them as they treat any other:
//
//     cell       integer   the smooth patch that the surfel samples
//     partner    integer   the cell across the nearest crease within two spacings; the surfel's own where there is none
//     sign       integer   how both meet there: 0 not at all, 1 convex, 2 concave, as seen from where normals point
//     sharpness  integer   0 smooth to 255 sharp, of the crease; without this attribute all are sharp
//     face       integer   cells of one face are smooth to each other, but at creases; without it every cell is one
//
// A model has cells where the first three are there and normals are oriented. No header of other rooms knows them.
#pragma once

#include "core/surfel/surfel_block.h"

#include <algorithm>
#include <optional>

namespace cells {

/// How two cells meet: a solid with an edge outwards, or with one inwards.
enum class Meeting : std::uint8_t { None = 0, Convex = 1, Concave = 2 };
constexpr Meeting opposite(Meeting m) {
    return m == Meeting::Convex ? Meeting::Concave : m == Meeting::Concave ? Meeting::Convex : Meeting::None;
}

struct Label {
    std::uint32_t cell = 0, partner = 0;
    Meeting meeting = Meeting::None; ///< of cell and partner
    std::uint8_t sharpness = 255;
    std::uint32_t face = 0;

    bool operator==(const Label&) const = default;
    /// With numbers that begin at `offset`.
    Label shifted(std::uint32_t offset) const {
        return {cell + offset, partner + offset, meeting, sharpness, face + offset};
    }
};

/// Where the labels of a model's surfels are.
class LabelLayout {
  public:
    /// Nothing where the layout has no labels, or no oriented normals.
    static std::optional<LabelLayout> of(const surfel::AttributeLayout& layout);

    Label at(const surfel::SurfelBlock& block, int slot) const;
    std::uint32_t cellAt(const surfel::SurfelBlock& block, int slot) const { return word(block, slot, m_cell); }
    std::uint32_t faceAt(const surfel::SurfelBlock& block, int slot) const {
        return m_face ? word(block, slot, *m_face) : cellAt(block, slot);
    }
    /// Cells and faces of a cluster's surfels.
    struct Cluster {
        const std::uint32_t *cell, *face;
    };
    Cluster cluster(const surfel::SurfelBlock& block, int cluster) const {
        const auto words = [&](std::size_t index) {
            return block.words(cluster, surfel::Extra + static_cast<int>(index));
        };
        return {words(m_cell), words(m_face.value_or(m_cell))};
    }
    /// Does any surfel of a cluster lie beside a crease?
    bool anyMeets(const surfel::SurfelBlock& block, int cluster) const {
        const int count = std::min(surfel::clusterSize, block.size() - cluster * surfel::clusterSize);
        const std::uint32_t* const signs = block.words(cluster, surfel::Extra + static_cast<int>(m_sign));
        return std::any_of(signs, signs + count, [](std::uint32_t sign) { return sign != 0; });
    }
    /// Of a surfel by its words.
    Label at(std::span<const std::uint32_t> words) const;
    bool hasSharpness() const { return m_sharpness.has_value(); }

  private:
    static std::uint32_t word(const surfel::SurfelBlock& block, int slot, std::size_t index) {
        constexpr int lanes = surfel::clusterSize;
        return block.words(slot / lanes, surfel::Extra + static_cast<int>(index))[slot % lanes];
    }

    std::size_t m_cell = 0, m_partner = 0, m_sign = 0; ///< as words of a surfel
    std::optional<std::size_t> m_sharpness, m_face;
};

/// Throws base::Error where an attribute of a label's name holds reals: it is not ours.
void requireNames(const surfel::AttributeLayout& layout);

/// Adds labels to surfels, one for each: the attributes that are missing, sharpness and faces only where they tell
/// something, or where the `whole` label is wanted. What is there under these names is overwritten; an attribute of
/// that name that holds reals is not ours, and std::nullopt of `LabelLayout::of` tells.
void setLabels(surfel::SurfelList& surfels, std::span<const Label> labels, bool whole = false);

} // namespace cells
