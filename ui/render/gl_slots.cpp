#include "ui/render/gl_slots.h"

#include <algorithm>

namespace render {

/// Slots in one upload at most, so that staging stays small.
constexpr std::size_t slotsPerUpload = 1024;

static std::uint32_t packed(const base::Vec3f& n) {
    const auto component = [](float value) {
        return static_cast<std::uint32_t>(static_cast<int>(std::lround(std::clamp(value, -1.0f, 1.0f) * 511))) & 1023u;
    };
    return component(n.x) | component(n.y) << 10 | component(n.z) << 20;
}

static void pack(const surfel::SurfelBlock& block, GlSurfel* out) {
    for (int slot = 0; slot < block.size(); ++slot) {
        const surfel::Surfel s = block.surfel(slot);
        const auto mask = static_cast<std::uint32_t>(std::clamp(s.mask, 0.0f, 1.0f) * 255 + 0.5f);
        out[slot] = {s.position, packed(s.normal), s.support, (s.colour & 0x00ffffffu) | mask << 24};
    }
}

GlSlots::~GlSlots() {
    m_gl.deleteBuffers(1, &m_buffer);
}

void GlSlots::grow(std::size_t wanted) {
    if (wanted <= m_capacity)
        return;
    const std::size_t capacity = m_capacity == 0 ? wanted : std::max(wanted, m_capacity + m_capacity / 4);
    GLuint bigger = 0;
    m_gl.genBuffers(1, &bigger);
    m_gl.bindBuffer(GL_COPY_WRITE_BUFFER, bigger);
    m_gl.bufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(capacity * slotBytes), nullptr, GL_DYNAMIC_DRAW);
    if (m_buffer) {
        m_gl.bindBuffer(GL_COPY_READ_BUFFER, m_buffer);
        m_gl.copyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                               static_cast<GLsizeiptr>(m_capacity * slotBytes));
        m_gl.deleteBuffers(1, &m_buffer);
    }
    for (std::size_t slot = m_capacity; slot < capacity; ++slot)
        m_free.push_back(static_cast<std::uint32_t>(slot));
    m_buffer = bigger;
    m_capacity = capacity;
}

void GlSlots::upload(std::span<const surfel::BlockPtr> blocks, std::span<const std::uint32_t> places) {
    m_gl.bindBuffer(GL_COPY_WRITE_BUFFER, m_buffer);
    for (std::size_t begin = 0, end = 0; begin < blocks.size(); begin = end) {
        for (end = begin + 1;
             end < blocks.size() && end - begin < slotsPerUpload && places[end] == places[end - 1] + 1;)
            ++end;
        // Slots are longer than most blocks; what lies behind a block's end is never drawn.
        m_staging.resize((end - begin) * surfel::blockCapacity);
        for (std::size_t i = begin; i < end; ++i)
            pack(*blocks[i], m_staging.data() + (i - begin) * surfel::blockCapacity);
        m_gl.bufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(places[begin] * slotBytes),
                           static_cast<GLsizeiptr>((end - begin) * slotBytes), m_staging.data());
        ++m_uploads;
        m_uploadedBytes += (end - begin) * slotBytes;
    }
}

void GlSlots::show(const tree::SurfelTree& model) {
    m_uploads = m_uploadedBytes = 0;
    if (model == m_shown)
        return;
    const tree::Diff change = tree::diff(m_shown, model);
    for (const surfel::BlockPtr& block : change.removed) {
        const auto found = m_slotOf.find(block.get());
        m_free.push_back(found->second);
        m_slotOf.erase(found);
    }
    std::sort(m_free.begin(), m_free.end());
    grow(m_slotOf.size() + change.added.size());
    std::vector<std::uint32_t> slots(m_free.begin(), m_free.begin() + static_cast<std::ptrdiff_t>(change.added.size()));
    m_free.erase(m_free.begin(), m_free.begin() + static_cast<std::ptrdiff_t>(change.added.size()));
    for (std::size_t i = 0; i < slots.size(); ++i)
        m_slotOf[change.added[i].get()] = slots[i];
    upload(change.added, slots);
    m_shown = model;
}

} // namespace render
