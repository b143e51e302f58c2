// A version's surfels in the memory of the GPU, a slot per block, in pages: buffers of at most 192 MiB, so that models
// of any size need no buffer that a driver may refuse, and growing copies one page at most.
//
// Going from one version to another touches what they do not share: `diff` says which blocks go and which come; coming
// blocks take the lowest free slots and are uploaded in runs of neighbouring slots. Representatives of nodes
// (node_detail.h) stand in slots too, from when they are first drawn until they are dropped. 24 bytes per surfel, and 4
// more in pages beside these where supports are ellipsoids.
#pragma once

#include "core/render/shading/block_colours.h"
#include "core/render/splats/disc_cuts.h"
#include "core/tree/surfel_tree.h"
#include "ui/gl/gl_functions.h"

#include <unordered_map>

namespace render {

/// A surfel as the vertex shader reads it.
struct GlSurfel {
    base::Vec3f position;
    std::uint32_t normal;        ///< GL_INT_2_10_10_10_REV; zero where unknown
    std::uint32_t support;       ///< a float whose lowest cutBits bits are a CutCode,
                                 ///< or, where it is negative, its lowest twoCutBits bits
    std::uint32_t colourAndMask; ///< the mask takes the place of alpha
};
/// Of ellipsoids b as GL_INT_2_10_10_10_REV, in parts of surfel::longestShape.
using GlShape = std::uint32_t;
constexpr std::size_t slotBytes = sizeof(GlSurfel) * surfel::blockCapacity;
constexpr std::size_t shapeBytes = sizeof(GlShape) * surfel::blockCapacity; ///< of a slot
constexpr std::size_t slotsPerPage = std::size_t(1) << 16;

class GlSlots {
  public:
    explicit GlSlots(const GlFunctions& gl) : m_gl(gl) {}
    ~GlSlots();
    GlSlots(const GlSlots&) = delete;
    GlSlots& operator=(const GlSlots&) = delete;

    /// Makes the pages hold `model` with the surfels' own colours or, where there is a table, with its colours; blocks
    /// whose colours the table does not share with the one before are uploaded again. REQUIRES: the context that first
    /// called it is current.
    void show(const tree::SurfelTree& model, std::shared_ptr<const BlockColours> colours = nullptr);
    /// Uploads blocks of the version shown again whose discs are cut otherwise than they were. Null: whole discs.
    void cut(std::span<const std::pair<const surfel::SurfelBlock*, const CutCodes*>> blocks);
    /// Uploads those proxies that have no slot yet. They must live until dropped.
    void hold(std::span<const surfel::SurfelBlock* const> proxies);
    /// Frees the slots of those that have one.
    void drop(std::span<const surfel::BlockPtr> proxies);

    /// Blocks with a disc that is cut.
    std::size_t cutBlocks() const { return m_cut.size(); }
    bool holds(const surfel::SurfelBlock* block) const { return m_slotOf.contains(block); }
    std::size_t pages() const { return m_pages.size(); }
    GLuint buffer(std::size_t page) const { return m_pages[page]; }
    /// Are supports ellipsoids? Then the buffer of shapes beside it.
    bool shaped() const { return m_shape > 0; }
    GLuint shapes(std::size_t page) const { return m_shapePages[page]; }
    std::size_t page(const surfel::SurfelBlock* block) const { return m_slotOf.at(block) / slotsPerPage; }
    /// First surfel, within its page, of a block of the version shown or of a proxy held.
    GLint first(const surfel::SurfelBlock* block) const {
        return static_cast<GLint>(m_slotOf.at(block) % slotsPerPage) * surfel::blockCapacity;
    }
    /// Upload calls and bytes since the last `show` began, for tests and statistics.
    std::size_t uploads() const { return m_uploads; }
    std::size_t uploadedBytes() const { return m_uploadedBytes; }
    std::size_t capacity() const { return m_capacity; }

  private:
    void grow(std::size_t wanted);
    void growPages(std::vector<GLuint>& pages, std::size_t bytes, std::size_t capacity) const;
    /// Nothing is held any more.
    void clear();
    /// Gives slots to blocks without one and uploads them.
    void place(std::span<const surfel::SurfelBlock* const> blocks);
    void release(const surfel::SurfelBlock* block);
    /// Uploads what is there already and has other colours.
    void recolour(std::shared_ptr<const BlockColours> colours);
    void upload(std::span<const surfel::SurfelBlock* const> blocks, std::span<const std::size_t> slots);

    const GlFunctions& m_gl;
    std::vector<GLuint> m_pages;      ///< all but the last full
    std::vector<GLuint> m_shapePages; ///< none where supports are balls
    std::size_t m_capacity = 0;       ///< in slots
    int m_shape = 0;                  ///< channel of the shapes of supports in the blocks of `m_shown`
    std::shared_ptr<const BlockColours> m_colours;
    tree::SurfelTree m_shown; ///< keeps its blocks alive, so that their addresses name them
    std::unordered_map<const surfel::SurfelBlock*, std::size_t> m_slotOf;
    std::unordered_map<const surfel::SurfelBlock*, CutCodes> m_cut; ///< of those that have any
    std::vector<std::size_t> m_free;                                ///< ascending, but for what `release` appended
    std::vector<GlSurfel> m_staging;
    std::vector<GlShape> m_shapeStaging;
    std::size_t m_uploads = 0, m_uploadedBytes = 0;
};

} // namespace render
