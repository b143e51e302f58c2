// A block: up to 128 surfels as clusters of 16, each cluster a structure of arrays of float32 (surfel/README 2).
//
//     cluster 0: x[16] y[16] z[16] nx[16] ny[16] nz[16] support[16] colour[16] mask[16] extra0[16] ...
//     cluster 1: ...
//
// Every array is 64-byte aligned. Colours and further attributes are 32-bit words in the same lanes (`words`).
// Invariants: 1 <= size() <= 128 once built; every cluster but the last is full; slots past the end have far, finite
// positions, support 1, so that their weight is exactly zero in a kernel that never looks at the size.
// Header: per cluster a tight box of its positions and its largest support, which answer both questions that queries
// ask:
//     may this cluster have weight at x?   distance(x, box) < maxSupport
//     may the surface near it meet a ray?  the ray meets the box inflated by surfaceReach * maxSupport
//
// Ownership: shared and immutable once `seal`ed; a fresh or cloned block belongs to one thread, which fills it, seals
// it and hands it to a tree. Memory: the header plus 36 bytes per slot (and 4 per extra word), clusters fitted exactly.
#pragma once

#include "core/base/hash.h"
#include "core/base/pointer.h"
#include "core/surfel/bounds_lanes.h"
#include "core/surfel/surfel.h"

namespace surfel {

constexpr int clusterSize = 16;
constexpr int clustersPerBlock = laneCount;
constexpr int blockCapacity = clusterSize * clustersPerBlock;

/// Arrays of a cluster, in their order.
enum Channel : int { X, Y, Z, NormalX, NormalY, NormalZ, Support, ColourWord, Mask, Extra };

/// Bounds of one cluster.
struct ClusterBounds {
    base::Box3f box;      ///< of the positions, tight
    float maxSupport = 0; ///< largest support radius

    bool supports(const base::Vec3f& x) const { return box.distanceSq(x) < maxSupport * maxSupport; }
};

class SurfelBlock;
using BlockPtr = base::Pointer<const SurfelBlock>;
using MutableBlockPtr = base::Pointer<SurfelBlock>;

class SurfelBlock : public base::Shared {
  public:
    /// A block of `size` slots, to be filled with `set` or through `channel`, then sealed. REQUIRES: 1 <= size <= 128.
    static MutableBlockPtr create(int size, std::size_t extraWords);
    /// A writable copy of the same size.
    MutableBlockPtr clone() const;
    static void destroy(const SurfelBlock* block);

    int size() const { return m_size; }
    int clusterCount() const { return (m_size + clusterSize - 1) / clusterSize; }
    std::size_t extraWords() const { return m_extraWords; }
    /// Bytes of memory that this block takes.
    std::size_t bytes() const;

    ClusterBounds bounds(int cluster) const { return {m_bounds.box(cluster), m_bounds.maxSupport[cluster]}; }
    /// The bounds of all clusters, one to a lane.
    const BoundsLanes& boundsLanes() const { return m_bounds; }
    /// A bit for every cluster.
    unsigned clusterMask() const { return (1u << clusterCount()) - 1; }
    /// Bounds of the whole block.
    const base::Box3f& box() const { return m_box; }
    float maxSupport() const { return m_maxSupport; }

    /// 16 values of one channel of one cluster, 64-byte aligned.
    const float* channel(int cluster, int channel) const { return m_data + offset(cluster, channel); }
    float* channel(int cluster, int channel) { return m_data + offset(cluster, channel); }
    const std::uint32_t* words(int cluster, int channel) const;
    std::uint32_t* words(int cluster, int channel);

    Surfel surfel(int slot) const;
    base::Vec3f position(int slot) const { return vector(slot, X); }
    base::Vec3f normal(int slot) const { return vector(slot, NormalX); }
    float support(int slot) const { return channel(slot / clusterSize, Support)[slot % clusterSize]; }
    float mask(int slot) const { return channel(slot / clusterSize, Mask)[slot % clusterSize]; }
    /// Copies the further attributes of a surfel. REQUIRES: out.size() == extraWords().
    void extra(int slot, std::span<std::uint32_t> out) const;

    void set(int slot, const Surfel& surfel);
    void setPosition(int slot, const base::Vec3f& p) { setVector(slot, X, p); }
    void setNormal(int slot, const base::Vec3f& n) { setVector(slot, NormalX, n); }
    void setExtra(int slot, std::span<const std::uint32_t> words);

    /// Computes the bounds from the content; the last step before the block is shared.
    void seal();

    /// Order-free hash of the content: the sum over its surfels.
    base::Hash128 contentHash() const;

  private:
    SurfelBlock(int size, std::size_t extraWords) : m_size(size), m_extraWords(extraWords) {}
    ~SurfelBlock() = default;
    std::size_t clusterStride() const { return clusterSize * (Extra + m_extraWords); }
    std::size_t offset(int cluster, int channel) const {
        return static_cast<std::size_t>(cluster) * clusterStride() + static_cast<std::size_t>(channel) * clusterSize;
    }
    base::Vec3f vector(int slot, int first) const {
        const float* c = channel(slot / clusterSize, first) + slot % clusterSize;
        return {c[0], c[clusterSize], c[2 * clusterSize]};
    }
    void setVector(int slot, int first, const base::Vec3f& v) {
        float* c = channel(slot / clusterSize, first) + slot % clusterSize;
        c[0] = v.x, c[clusterSize] = v.y, c[2 * clusterSize] = v.z;
    }

    float* m_data = nullptr;
    int m_size;
    std::size_t m_extraWords;
    float m_maxSupport = 0;
    base::Box3f m_box;
    BoundsLanes m_bounds;
};

} // namespace surfel
