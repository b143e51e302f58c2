#include "core/surfel/surfel_block.h"

#include "core/base/clones.h"

#include <bit>
#include <cassert>
#include <cstdlib>
#include <cstring>
#include <new>

namespace surfel {

constexpr std::size_t alignment = 64;
constexpr std::size_t headerBytes = (sizeof(SurfelBlock) + alignment - 1) / alignment * alignment;

/// Far enough that no support reaches it, near enough that its square is finite.
constexpr float farAway = 1e15f;

static std::size_t dataBytes(int size, std::size_t extraWords) {
    const std::size_t clusters = (static_cast<std::size_t>(size) + clusterSize - 1) / clusterSize;
    return clusters * clusterSize * (Extra + extraWords) * sizeof(float);
}

MutableBlockPtr SurfelBlock::create(int size, std::size_t extraWords) {
    assert(size >= 1 && size <= blockCapacity);
    void* memory = ::operator new(headerBytes + dataBytes(size, extraWords), std::align_val_t(alignment));
    MutableBlockPtr block(new (memory) SurfelBlock(size, extraWords));
    block->m_data = reinterpret_cast<float*>(static_cast<char*>(memory) + headerBytes);
    const int last = block->clusterCount() - 1;
    for (int slot = size - last * clusterSize; slot < clusterSize; ++slot)
        for (int c = 0; c < Extra + static_cast<int>(extraWords); ++c)
            block->channel(last, c)[slot] = c <= Z ? farAway : c == Support ? 1.0f : 0.0f;
    return block;
}

MutableBlockPtr SurfelBlock::clone() const {
    MutableBlockPtr copy = create(m_size, m_extraWords);
    std::memcpy(copy->m_data, m_data, dataBytes(m_size, m_extraWords));
    copy->m_box = m_box;
    copy->m_maxSupport = m_maxSupport;
    copy->m_bounds = m_bounds;
    return copy;
}

void SurfelBlock::destroy(const SurfelBlock* block) {
    block->~SurfelBlock();
    ::operator delete(const_cast<SurfelBlock*>(block), std::align_val_t(alignment));
}

std::size_t SurfelBlock::bytes() const {
    return headerBytes + dataBytes(m_size, m_extraWords);
}

const std::uint32_t* SurfelBlock::words(int cluster, int channel) const {
    return reinterpret_cast<const std::uint32_t*>(m_data + offset(cluster, channel));
}
std::uint32_t* SurfelBlock::words(int cluster, int channel) {
    return reinterpret_cast<std::uint32_t*>(m_data + offset(cluster, channel));
}

Surfel SurfelBlock::surfel(int slot) const {
    const int cluster = slot / clusterSize, lane = slot % clusterSize;
    return {position(slot), normal(slot), channel(cluster, Support)[lane],
            std::bit_cast<Colour>(channel(cluster, ColourWord)[lane]), channel(cluster, Mask)[lane]};
}

void SurfelBlock::extra(int slot, std::span<std::uint32_t> out) const {
    for (std::size_t k = 0; k < m_extraWords; ++k)
        std::memcpy(&out[k], channel(slot / clusterSize, Extra + static_cast<int>(k)) + slot % clusterSize, 4);
}

void SurfelBlock::set(int slot, const Surfel& s) {
    const int cluster = slot / clusterSize, lane = slot % clusterSize;
    setPosition(slot, s.position);
    setNormal(slot, s.normal);
    channel(cluster, Support)[lane] = s.support;
    std::memcpy(channel(cluster, ColourWord) + lane, &s.colour, 4);
    channel(cluster, Mask)[lane] = s.mask;
}

void SurfelBlock::setExtra(int slot, std::span<const std::uint32_t> in) {
    for (std::size_t k = 0; k < m_extraWords; ++k)
        std::memcpy(channel(slot / clusterSize, Extra + static_cast<int>(k)) + slot % clusterSize, &in[k], 4);
}

/// Least and most of 16 values, halves against each other.
[[gnu::always_inline]] static inline void range(const float* value, float& least, float& most) {
    float lo[8], hi[8];
    for (int i = 0; i < 8; ++i)
        lo[i] = smaller(value[i], value[i + 8]), hi[i] = larger(value[i], value[i + 8]);
    for (int i = 0; i < 4; ++i)
        lo[i] = smaller(lo[i], lo[i + 4]), hi[i] = larger(hi[i], hi[i + 4]);
    least = smaller(smaller(lo[0], lo[1]), smaller(lo[2], lo[3]));
    most = larger(larger(hi[0], hi[1]), larger(hi[2], hi[3]));
}

/// Bounds of a full cluster; `data` are its channels.
POINTCLAY_CLONES
static void fullBounds(const float* data, ClusterBounds& out) {
    range(data + X * clusterSize, out.box.lo.x, out.box.hi.x);
    range(data + Y * clusterSize, out.box.lo.y, out.box.hi.y);
    range(data + Z * clusterSize, out.box.lo.z, out.box.hi.z);
    float least;
    range(data + Support * clusterSize, least, out.maxSupport);
}

void SurfelBlock::seal() {
    m_box = {};
    m_maxSupport = 0;
    for (int cluster = 0; cluster < clusterCount(); ++cluster) {
        ClusterBounds bounds;
        const int lanes = std::min(clusterSize, m_size - cluster * clusterSize);
        if (lanes == clusterSize)
            fullBounds(channel(cluster, X), bounds);
        else
            for (int lane = 0; lane < lanes; ++lane) {
                bounds.box.extend(position(cluster * clusterSize + lane));
                bounds.maxSupport = std::max(bounds.maxSupport, channel(cluster, Support)[lane]);
            }
        m_bounds.set(cluster, bounds.box, bounds.maxSupport);
        m_box.extend(bounds.box);
        m_maxSupport = std::max(m_maxSupport, bounds.maxSupport);
    }
}

base::Hash128 SurfelBlock::contentHash() const {
    std::vector<std::uint32_t> words(Extra + m_extraWords);
    base::Hash128 sum;
    for (int slot = 0; slot < m_size; ++slot) {
        for (int c = 0; c < static_cast<int>(words.size()); ++c) {
            float value = channel(slot / clusterSize, c)[slot % clusterSize];
            std::memcpy(&words[static_cast<std::size_t>(c)], &value, 4);
            if (words[static_cast<std::size_t>(c)] == 0x80000000u && c != ColourWord && c < Extra)
                words[static_cast<std::size_t>(c)] = 0; // -0 and 0 are the same place
        }
        sum += base::hashWords(words);
    }
    return sum;
}

} // namespace surfel
