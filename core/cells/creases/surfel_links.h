// Links between neighbouring surfels, and which of them a crease cuts (cells/README 6): what detected and drawn creases
// are made of.
//
//     SurfelLinks links(tree, surfels);          who is near whom
//     links.cut(e, Cut::Crease)                  detect_creases.h, draw_crease.h
//     splitAtCreases, labelsOfLinks              cells, partners and signs             link_bands.h, link_labels.h
#pragma once

#include "core/tree/surfel_tree.h"

namespace cells {

/// What is between both ends of a link: the surface; a crease; matter or air, between the walls of a plate or groove.
enum class Cut : std::uint8_t { None, Crease, Wall };

class SurfelLinks {
  public:
    /// How many neighbours a surfel knows, and with how many of them it is linked where they are near enough.
    static constexpr std::size_t nearCount = 30, linkCount = 10;
    static constexpr double linkReach = 2.2; ///< spacings

    /// `surfels` are those of the tree in its order, and outlive this. In parallel.
    SurfelLinks(const tree::SurfelTree& tree, std::span<const surfel::Surfel> surfels);

    std::size_t size() const { return m_surfels.size(); }
    /// Of a surfel that a search in the tree found.
    std::uint32_t number(const tree::Neighbour& found) const {
        return static_cast<std::uint32_t>(m_first[found.blockNumber]) + static_cast<std::uint32_t>(found.slot);
    }
    base::Vec3d at(std::uint32_t i) const { return base::cast<double>(m_surfels[i].position); }
    const surfel::Surfel& surfel(std::uint32_t i) const { return m_surfels[i]; }
    double spacing(std::uint32_t i) const { return static_cast<double>(m_spacing[i]); } ///< there
    /// The nearest other surfels, nearest first.
    std::span<const std::uint32_t> near(std::uint32_t i) const {
        return {m_near.data() + i * nearCount, m_nearCount[i]};
    }

    struct Link {
        std::uint32_t other; ///< end
        std::uint32_t twin;  ///< the same link as its other end has it
        Cut cut = Cut::None;
    };
    /// The links of surfel i have these numbers. Who is linked with i has i as an end as well.
    std::uint32_t begin(std::uint32_t i) const { return m_begin[i]; }
    std::uint32_t end(std::uint32_t i) const { return m_begin[i + 1]; }
    const Link& link(std::uint32_t e) const { return m_links[e]; }
    void cut(std::uint32_t e, Cut cut) { m_links[e].cut = m_links[m_links[e].twin].cut = cut; }
    /// fn(other, cut) for the links of i.
    template <class Fn>
    void forLinks(std::uint32_t i, const Fn& fn) const {
        for (std::uint32_t e = begin(i); e < end(i); ++e)
            fn(m_links[e].other, m_links[e].cut);
    }
    base::Vec3d middle(std::uint32_t i, std::uint32_t e) const { return (at(i) + at(m_links[e].other)) / 2; }

    /// Links from one side of a wall to the other, by these normals, become Cut::Wall.
    void cutWalls(std::span<const base::Vec3f> normals);

  private:
    void findNear(const tree::SurfelTree& tree);
    void findSpacing();
    void join();

    std::span<const surfel::Surfel> m_surfels;
    std::vector<std::size_t> m_first;               ///< surfel of each block
    std::vector<std::uint32_t> m_near, m_nearCount; ///< nearCount places for each
    std::vector<float> m_spacing;
    std::vector<std::uint32_t> m_begin;
    std::vector<Link> m_links;
};

} // namespace cells
