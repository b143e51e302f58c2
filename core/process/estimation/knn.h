// The k nearest of many points: nanoflann stays behind this header.
//
// A Cloud holds the distinct positions of a list in Morton order, so that neighbours in the list are neighbours in
// space and coincident points do not eat each other's neighbourhoods. It does not refer to the list afterwards.
// Const functions may run on any thread. Everything is the same bits at any thread count.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/surfel/surfel.h"

#include <memory>

namespace process {

/// Nearest first, with squared distances.
struct Neighbours {
    std::vector<std::uint32_t> index;
    std::vector<float> distanceSq;
    std::size_t size() const { return index.size(); }
};

class Cloud {
  public:
    /// REQUIRES: finite positions.
    explicit Cloud(std::span<const surfel::Surfel> points, const base::Progress& progress = {});
    ~Cloud();

    std::span<const base::Vec3f> positions() const { return m_positions; }
    std::size_t size() const { return m_positions.size(); }
    /// Of each point of the list: the place of its position in positions().
    std::span<const std::uint32_t> places() const { return m_places; }
    /// The k nearest other positions of position `i`; fewer where there are fewer.
    void nearest(std::size_t i, std::size_t k, Neighbours& out) const;
    /// Distance from anywhere to the k-th nearest position, or the last where there are fewer.
    float reach(const base::Vec3f& x, std::size_t k) const;

    /// body(i, neighbours) for every position, in parallel; body writes only what belongs to i.
    template <class Body>
    void forEach(std::size_t k, const base::Progress& progress, const char* what, const Body& body) const;

  private:
    struct Index;
    std::vector<base::Vec3f> m_positions;
    std::vector<std::uint32_t> m_places;
    std::unique_ptr<Index> m_index;
};

template <class Body>
void Cloud::forEach(std::size_t k, const base::Progress& progress, const char* what, const Body& body) const {
    constexpr std::size_t slab = 8192; // some 20 ms of work between two looks at `cancel`
    for (std::size_t from = 0; from < size(); from += slab) {
        progress.step(static_cast<double>(from) / static_cast<double>(size()), what);
        base::parallelChunks(std::min(slab, size() - from), 256, [&](std::size_t begin, std::size_t end, std::size_t) {
            Neighbours neighbours;
            for (std::size_t i = from + begin; i < from + end; ++i) {
                nearest(i, k, neighbours);
                body(i, static_cast<const Neighbours&>(neighbours));
            }
        });
    }
}

} // namespace process
