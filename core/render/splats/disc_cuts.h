// Where the discs of splats end before their radius does: at the boundaries of open surfaces, where the surface itself
// ends (off-centre value beyond its limit, surface/README 5.1), at sharp edges (sharp_cuts.h, label_cuts.h,
// complex_cuts.h), where a surfel's own normal stands across the surface about it, and where there is no surface.
//
// A disc at the boundary is cut by a line: across the direction from the centroid of its surroundings, where the
// off-centre value reaches the limit. Codes of 14 bits say so, alike for the CPU and for the low bits of the GPU's
// supports:
//
//     axis (1 bit) << 13 | corner (1 bit) << 12 | angle about the normal (7 bits) << 5 | distance in 32nds of the
//     disc's radius, 1 to 31; at corners 1 to 15, and 16 more at tips
//     0: the whole disc     32: its radius times acrossRadius     64: no disc     96: a pixel, whatever its radius
//
// A corner may have two lines, in 21 bits and the highest one, which tells; the GPU's support then has two bits of its
// fraction left, and distances are in 20ths of the radius of that (roughSupport), 1 to 16:
//
//     1 << 31 | axis << 20 | angles (6 bits each) << 14, << 8 | distances less one (4 bits each) << 4, << 0
//
// The angle counts from axis x normal towards normal x (axis x normal); the axis is x, or y where the normal is near x.
//
// Neighbours decide about a surfel, so that an edit changes the codes of blocks that it leaves alone: `follow` finds
// them. Blocks are looked at when their discs are first large enough in a picture for it to show.
#pragma once

#include "core/surface/surface.h"

#include <memory>
#include <unordered_map>

namespace render {

using CutCode = std::uint32_t;
constexpr int cutBits = 14, twoCutBits = 21;
constexpr CutCode twoCuts = 1u << 31;
constexpr CutCode wholeDisc = 0, acrossDisc = 32, noDisc = 64, loneDisc = 96;
/// What is left of the radius of a disc that stands across the surface.
constexpr float acrossRadius = 0.35f;
/// And of one that is too lonely to have a surface about it: rays pass, and only the filter's pixel shows where it is.
constexpr float loneRadius = 1e-3f;
/// What is left of the radius of a disc that is cut: sideways the boundary may be bent.
constexpr float cutRadius = 0.8f;
/// The same where a second edge is near.
constexpr float cornerRadius = 0.45f;
/// And where both are so near, and meet at so acute an angle, that this would reach over one of them.
constexpr float tipRadius = 0.25f;
/// Discs smaller than this many pixels stay whole: less than a pixel would go.
constexpr float cutPx = 1.5f;

/// The tangential direction that angles of codes count from; zero where there is no normal.
base::Vec3f discAxis(const base::Vec3f& normal);

/// Calls fn(block) for the blocks of the later version in whose support, from their place or their disc's end,
/// something came or went; for some more than once.
template <class Fn>
void forBlocksBeside(const tree::Diff& change, const tree::SurfelTree& to, float radiusOfSupport, const Fn& fn) {
    for (const auto* side : {&change.removed, &change.added})
        for (const surfel::BlockPtr& block : *side)
            to.forBlocksInSupport(
                block->box().inflated(block->maxSupport()),
                [&](std::uint32_t, const surfel::SurfelBlock& each) { fn(each); }, radiusOfSupport);
}

/// What is left of a disc's radius that is cut: cutRadius, cornerRadius, tipRadius.
enum class Beside { Edge, Corner, Tip };
/// The code of a disc cut at `part` of its radius in a tangential direction; beside an edge part >= 1 is whole.
CutCode cutCode(const base::Vec3f& normal, const base::Vec3f& direction, float part, Beside beside = Beside::Edge);

/// A line that cuts a disc: across a tangential direction, at a part of its radius.
struct CutLine {
    base::Vec3f direction; ///< unit
    float part = 0;        ///< 0 where nothing is cut
};
/// The code of a disc cut by two lines.
CutCode twoCutsCode(const base::Vec3f& normal, float support, const CutLine& first, const CutLine& second);
/// The support of a disc with two lines, as far as the GPU knows it.
float roughSupport(float support);

struct DiscCut : CutLine {
    float radius = 1; ///< what is left of it; 0: nothing
    CutLine second;   ///< at corners
};
DiscCut discCut(const base::Vec3f& normal, float support, CutCode code);

/// One per slot of a block.
using CutCodes = std::array<CutCode, surfel::blockCapacity>;

class ComplexCuts;

class DiscCuts {
  public:
    /// Whether splats are cut at all under this definition.
    static bool any(const surface::SurfaceDefinition& definition) {
        return definition.manifold != surface::Manifold::Curve;
    }
    /// What codes depend on beside the version; forgets all if it changes.
    void use(const surface::SurfaceDefinition& definition, float radiusOfSupport);
    /// Looks at those blocks of the version followed to that were not looked at, on all cores.
    void prepare(std::span<const surfel::SurfelBlock* const> blocks);
    /// Null where all discs of the block are whole, or nobody looked.
    const CutCodes* of(const surfel::SurfelBlock* block) const {
        const auto found = m_codes.find(block);
        return found == m_codes.end() ? nullptr : found->second.codes.get();
    }
    /// Goes on to the next version. Returns the blocks that it shares with the last whose codes it changed.
    std::vector<const surfel::SurfelBlock*> follow(const tree::SurfelTree& to);

  private:
    struct Kept {
        surfel::BlockPtr block;          ///< keeps its address its own
        std::unique_ptr<CutCodes> codes; ///< null: all whole
    };
    using Found = std::vector<std::unique_ptr<CutCodes>>;
    Found look(std::span<const surfel::SurfelBlock* const> blocks);
    /// Null for models that are no complex. Made once for a version: it needs all of its points.
    const ComplexCuts* complexCuts();

    surface::SurfaceDefinition m_definition;
    float m_radiusOfSupport = 0;
    tree::SurfelTree m_model;
    bool m_complexKnown = false;
    std::shared_ptr<const ComplexCuts> m_complex;
    std::unordered_map<const surfel::SurfelBlock*, Kept> m_codes;
};

} // namespace render
