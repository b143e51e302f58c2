// Memory into which a kernel picks surfels out of clusters, a row for each of their channels (kernel_pick.h). Kept
// between calls; one thread at a time. Internal to the room.
#pragma once

#include "core/surfel/surfel_block.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace surface {

/// Floats of a row that takes all surfels of so many clusters: a packed store may write a cluster behind them.
constexpr std::size_t pickStride(std::size_t clusters) {
    return (clusters + 1) * surfel::clusterSize;
}

class PickScratch {
  public:
    /// 64-byte aligned; valid until the next call, its content is anything.
    float* rows(std::size_t rows, std::size_t clusters) {
        constexpr std::size_t alignment = 64, spare = alignment / sizeof(float);
        const std::size_t wanted = rows * pickStride(clusters) + spare;
        if (m_memory.size() < wanted)
            m_memory.resize(wanted);
        float* out = m_memory.data();
        while (reinterpret_cast<std::uintptr_t>(out) % alignment != 0)
            ++out;
        return out;
    }

  private:
    std::vector<float> m_memory;
};

} // namespace surface
