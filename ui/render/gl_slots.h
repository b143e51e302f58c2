// A version's surfels in the memory of the GPU: one buffer of slots, a slot per block.
//
// Going from one version to another touches what they do not share: `diff` says which blocks go and which come; coming
// blocks take the lowest free slots and are uploaded in runs of neighbouring slots. 24 bytes per surfel.
#pragma once

#include "core/tree/surfel_tree.h"
#include "ui/render/gl_functions.h"

#include <unordered_map>

namespace render {

/// A surfel as the vertex shader reads it.
struct GlSurfel {
    base::Vec3f position;
    std::uint32_t normal; ///< GL_INT_2_10_10_10_REV; zero where unknown
    float support;
    std::uint32_t colourAndMask; ///< the mask stands in the place of alpha
};
constexpr std::size_t slotBytes = sizeof(GlSurfel) * surfel::blockCapacity;

class GlSlots {
  public:
    explicit GlSlots(const GlFunctions& gl) : m_gl(gl) {}
    ~GlSlots();
    GlSlots(const GlSlots&) = delete;
    GlSlots& operator=(const GlSlots&) = delete;

    /// Makes the buffer hold `model`. REQUIRES: the context that first called it is current.
    void show(const tree::SurfelTree& model);
    GLuint buffer() const { return m_buffer; }
    /// First surfel of a block of the version shown.
    GLint first(const surfel::SurfelBlock* block) const {
        return static_cast<GLint>(m_slotOf.at(block)) * surfel::blockCapacity;
    }
    /// Upload calls and bytes of the last `show`, for tests and statistics.
    std::size_t uploads() const { return m_uploads; }
    std::size_t uploadedBytes() const { return m_uploadedBytes; }
    std::size_t capacity() const { return m_capacity; }

  private:
    void grow(std::size_t wanted);
    void upload(std::span<const surfel::BlockPtr> blocks, std::span<const std::uint32_t> places);

    const GlFunctions& m_gl;
    GLuint m_buffer = 0;
    std::size_t m_capacity = 0; ///< in slots
    tree::SurfelTree m_shown;   ///< keeps its blocks alive, so that their addresses name them
    std::unordered_map<const surfel::SurfelBlock*, std::uint32_t> m_slotOf;
    std::vector<std::uint32_t> m_free; ///< ascending
    std::vector<GlSurfel> m_staging;
    std::size_t m_uploads = 0, m_uploadedBytes = 0;
};

} // namespace render
