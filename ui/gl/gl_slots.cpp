#include "ui/gl/gl_slots.h"

#include "core/surfel/shape.h"

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

static std::uint32_t packed(float support, CutCode code) {
    if ((code & twoCuts) != 0)
        return std::bit_cast<std::uint32_t>(roughSupport(support)) | code;
    constexpr std::uint32_t mask = (1u << cutBits) - 1;
    return ((std::bit_cast<std::uint32_t>(support) + mask / 2) & ~mask) | code;
}

/// `shape`: the channel of the shapes of supports.
static void packShapes(const surfel::SurfelBlock& block, int shape, GlShape* out) {
    if (block.extraWords() == 0) // what stands for many is round
        shape = 0;
    for (int slot = 0; slot < block.size(); ++slot)
        out[slot] = packed(surfel::shapeOf(block, slot, shape) / surfel::longestShape);
}

static void pack(const surfel::SurfelBlock& block, const BlockColours* colours, const CutCodes* codes, GlSurfel* out) {
    const surfel::Colour* shown = colours ? colours->of(&block) : nullptr;
    for (int slot = 0; slot < block.size(); ++slot) {
        const surfel::Surfel s = block.surfel(slot);
        const auto mask = static_cast<std::uint32_t>(std::clamp(s.mask, 0.0f, 1.0f) * 255 + 0.5f);
        const surfel::Colour colour = shown ? shown[slot] : s.colour;
        const CutCode code = codes ? (*codes)[static_cast<std::size_t>(slot)] : wholeDisc;
        out[slot] = {s.position, packed(s.normal), packed(s.support, code), (colour & 0x00ffffffu) | mask << 24};
    }
}

GlSlots::~GlSlots() {
    clear();
}

void GlSlots::clear() {
    m_gl.deleteBuffers(static_cast<GLsizei>(m_pages.size()), m_pages.data());
    m_gl.deleteBuffers(static_cast<GLsizei>(m_shapePages.size()), m_shapePages.data());
    m_pages.clear(), m_shapePages.clear();
    m_capacity = 0;
    m_shown = {};
    m_slotOf.clear(), m_cut.clear(), m_free.clear();
}

static GLuint newPage(const GlFunctions& gl, std::size_t bytes) {
    GLuint out = 0;
    gl.genBuffers(1, &out);
    gl.bindBuffer(GL_COPY_WRITE_BUFFER, out);
    gl.bufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_DRAW);
    return out;
}

void GlSlots::grow(std::size_t wanted) {
    if (wanted <= m_capacity)
        return;
    const std::size_t capacity =
        m_capacity == 0 ? wanted : std::max(wanted, m_capacity + std::min(m_capacity / 4, slotsPerPage));
    for (std::size_t slot = m_capacity; slot < capacity; ++slot)
        m_free.push_back(slot);
    growPages(m_pages, slotBytes, capacity);
    if (shaped())
        growPages(m_shapePages, shapeBytes, capacity);
    m_capacity = capacity;
}

/// `bytes`: of a slot.
void GlSlots::growPages(std::vector<GLuint>& pages, std::size_t bytes, std::size_t capacity) const {
    const std::size_t begun = m_capacity % slotsPerPage;
    if (begun > 0) { // the last page was not a full one
        const std::size_t size = std::min(slotsPerPage, capacity - (pages.size() - 1) * slotsPerPage);
        const GLuint bigger = newPage(m_gl, size * bytes);
        m_gl.bindBuffer(GL_COPY_READ_BUFFER, pages.back());
        m_gl.copyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(begun * bytes));
        m_gl.deleteBuffers(1, &pages.back());
        pages.back() = bigger;
    }
    while (pages.size() * slotsPerPage < capacity)
        pages.push_back(newPage(m_gl, std::min(slotsPerPage, capacity - pages.size() * slotsPerPage) * bytes));
}

void GlSlots::upload(std::span<const surfel::SurfelBlock* const> blocks, std::span<const std::size_t> slots) {
    for (std::size_t begin = 0, end = 0; begin < blocks.size(); begin = end) {
        for (end = begin + 1; end < blocks.size() && end - begin < slotsPerUpload && slots[end] == slots[end - 1] + 1 &&
                              slots[end] % slotsPerPage != 0;)
            ++end;
        // Slots are longer than most blocks; what lies behind a block's end is never drawn.
        m_staging.resize((end - begin) * surfel::blockCapacity);
        for (std::size_t i = begin; i < end; ++i) {
            const auto cut = m_cut.find(blocks[i]);
            pack(*blocks[i], m_colours.get(), cut == m_cut.end() ? nullptr : &cut->second,
                 m_staging.data() + (i - begin) * surfel::blockCapacity);
        }
        m_gl.bindBuffer(GL_COPY_WRITE_BUFFER, m_pages[slots[begin] / slotsPerPage]);
        m_gl.bufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(slots[begin] % slotsPerPage * slotBytes),
                           static_cast<GLsizeiptr>((end - begin) * slotBytes), m_staging.data());
        ++m_uploads;
        m_uploadedBytes += (end - begin) * slotBytes;
        if (!shaped())
            continue;
        m_shapeStaging.resize((end - begin) * surfel::blockCapacity);
        for (std::size_t i = begin; i < end; ++i)
            packShapes(*blocks[i], m_shape, m_shapeStaging.data() + (i - begin) * surfel::blockCapacity);
        m_gl.bindBuffer(GL_COPY_WRITE_BUFFER, m_shapePages[slots[begin] / slotsPerPage]);
        m_gl.bufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(slots[begin] % slotsPerPage * shapeBytes),
                           static_cast<GLsizeiptr>((end - begin) * shapeBytes), m_shapeStaging.data());
        m_uploadedBytes += (end - begin) * shapeBytes;
    }
}

void GlSlots::place(std::span<const surfel::SurfelBlock* const> blocks) {
    if (blocks.empty())
        return;
    grow(m_slotOf.size() + blocks.size());
    std::sort(m_free.begin(), m_free.end());
    const auto taken = m_free.begin() + static_cast<std::ptrdiff_t>(blocks.size());
    const std::vector<std::size_t> slots(m_free.begin(), taken);
    m_free.erase(m_free.begin(), taken);
    for (std::size_t i = 0; i < slots.size(); ++i)
        m_slotOf[blocks[i]] = slots[i];
    upload(blocks, slots);
}

void GlSlots::release(const surfel::SurfelBlock* block) {
    const auto found = m_slotOf.find(block);
    if (found == m_slotOf.end())
        return;
    m_free.push_back(found->second);
    m_slotOf.erase(found);
    m_cut.erase(block);
}

void GlSlots::cut(std::span<const std::pair<const surfel::SurfelBlock*, const CutCodes*>> blocks) {
    std::vector<const surfel::SurfelBlock*> changed;
    std::vector<std::size_t> slots;
    for (const auto& [block, codes] : blocks) {
        const auto known = m_cut.find(block);
        if (codes ? known != m_cut.end() && known->second == *codes : known == m_cut.end())
            continue;
        if (codes)
            m_cut[block] = *codes;
        else
            m_cut.erase(known);
        changed.push_back(block);
        slots.push_back(m_slotOf.at(block));
    }
    upload(changed, slots);
}

void GlSlots::recolour(std::shared_ptr<const BlockColours> colours) {
    if (colours == m_colours)
        return;
    const auto of = [](const auto& table, const surfel::SurfelBlock* block) {
        return table ? table->of(block) : nullptr;
    };
    std::vector<std::pair<std::size_t, const surfel::SurfelBlock*>> found;
    for (const auto& [block, slot] : m_slotOf)
        if (of(colours, block) != of(m_colours, block))
            found.emplace_back(slot, block);
    std::sort(found.begin(), found.end());
    std::vector<const surfel::SurfelBlock*> blocks;
    std::vector<std::size_t> slots;
    for (const auto& [slot, block] : found) {
        slots.push_back(slot);
        blocks.push_back(block);
    }
    m_colours = std::move(colours);
    upload(blocks, slots);
}

void GlSlots::show(const tree::SurfelTree& model, std::shared_ptr<const BlockColours> colours) {
    m_uploads = m_uploadedBytes = 0;
    const int shape = surfel::shapeChannel(*model.layout());
    if ((shape > 0) != shaped())
        clear();
    m_shape = shape;
    const tree::Diff change = model == m_shown ? tree::Diff{} : tree::diff(m_shown, model);
    for (const surfel::BlockPtr& block : change.removed)
        release(block.get());
    recolour(std::move(colours));
    std::vector<const surfel::SurfelBlock*> added;
    for (const surfel::BlockPtr& block : change.added)
        added.push_back(block.get());
    place(added);
    m_shown = model;
}

void GlSlots::hold(std::span<const surfel::SurfelBlock* const> proxies) {
    std::vector<const surfel::SurfelBlock*> fresh;
    for (const surfel::SurfelBlock* proxy : proxies)
        if (!holds(proxy))
            fresh.push_back(proxy);
    place(fresh);
}

void GlSlots::drop(std::span<const surfel::BlockPtr> proxies) {
    for (const surfel::BlockPtr& proxy : proxies)
        release(proxy.get());
}

} // namespace render
