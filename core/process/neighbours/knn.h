// The k nearest of many points, exactly.
//
// A Cloud holds the distinct positions of a list in Morton order, so that neighbours in the list are neighbours in
// space and coincident points do not eat each other's neighbourhoods. It does not refer to the list afterwards.
// Neighbours are ordered by distance, those at one distance by their place in that order. Const functions may run on
// any thread. Everything is the same bits at any thread count.
#pragma once

#include "core/base/large_array.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/process/neighbours/nearest_kernel.h"
#include "core/surfel/surfel.h"

namespace process {

/// Nearest first, with squared distances.
struct Neighbours {
    std::vector<std::uint32_t> index;
    std::vector<float> distanceSq;
    std::size_t size() const { return index.size(); }
};

/// The number of its position for each point of a list. Written down only where it is not the point's own. Refers to a
/// cloud.
class PointPlaces {
  public:
    PointPlaces(std::span<const std::uint32_t> numbers, std::size_t count) : m_numbers(numbers), m_count(count) {}
    std::size_t size() const { return m_count; }
    std::uint32_t operator[](std::size_t i) const { return areOwn() ? static_cast<std::uint32_t>(i) : m_numbers[i]; }
    bool areOwn() const { return m_numbers.empty(); }

  private:
    std::span<const std::uint32_t> m_numbers;
    std::size_t m_count;
};

class Cloud {
  public:
    /// REQUIRES: finite positions.
    explicit Cloud(std::span<const surfel::Surfel> points, const base::Progress& progress = {});

    std::span<const base::Vec3f> positions() const { return m_positions; }
    std::size_t size() const { return m_positions.size(); }
    /// Of each point of the list: the place of its position in positions().
    PointPlaces places() const { return {m_places, m_count}; }
    /// The k nearest other positions of position `i`; fewer where there are fewer.
    void nearest(std::size_t i, std::size_t k, Neighbours& out) const;
    /// Distance from anywhere to the k-th nearest position, or the last where there are fewer. REQUIRES: k >= 1, and a
    /// position.
    float reach(const base::Vec3f& x, std::size_t k) const;

    /// body(i, neighbours) for every position, in parallel; body writes only what belongs to i. Much faster than one
    /// by one.
    template <class Body>
    void forEach(std::size_t k, const base::Progress& progress, const char* what, const Body& body) const;
    /// The same for whole cells: body(rows), many consecutive positions with all their neighbours. REQUIRES: k >= 1 and
    /// more than one position.
    template <class Body>
    void forEachCell(std::size_t k, const base::Progress& progress, const char* what, const Body& body) const;
    /// The same for some of the cells.
    template <class Body>
    void forCells(std::span<const std::uint32_t> some, std::size_t k, const base::Progress& progress, const char* what,
                  const Body& body) const;
    /// The cells, for work that looks at some of them.
    const PointCells& cells() const { return m_cells; }

  private:
    template <class Number, class Body>
    void forNumbered(std::size_t count, const Number& number, std::size_t k, const base::Progress& progress,
                     const char* what, const Body& body) const;

    base::LargeArray<base::Vec3f> m_positions;
    base::LargeArray<std::uint32_t> m_places; ///< empty where points are distinct and stand in order
    std::size_t m_count;                      ///< of points
    PointCells m_cells;
};

template <class Body>
void Cloud::forEachCell(std::size_t k, const base::Progress& progress, const char* what, const Body& body) const {
    forNumbered(
        m_cells.count(), [](std::size_t n) { return n; }, k, progress, what, body);
}

template <class Body>
void Cloud::forCells(std::span<const std::uint32_t> some, std::size_t k, const base::Progress& progress,
                     const char* what, const Body& body) const {
    forNumbered(
        some.size(), [some](std::size_t n) { return some[n]; }, k, progress, what, body);
}

template <class Number, class Body>
void Cloud::forNumbered(std::size_t count, const Number& number, std::size_t k, const base::Progress& progress,
                        const char* what, const Body& body) const {
    constexpr std::size_t slab = 128, grain = 4; // cells: a millisecond of work between two reports
    k = std::min(k, size() - 1);
    for (std::size_t from = 0; from < count; from += slab) {
        progress.step(static_cast<double>(from) / static_cast<double>(count), what);
        base::parallelChunks(std::min(slab, count - from), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            if (progress.cancel && progress.cancel->load(std::memory_order_relaxed))
                throw base::Cancelled();
            NearestRows rows;
            for (std::size_t n = from + begin; n < from + end; ++n) {
                nearestOfCell(m_cells, m_positions, number(n), k, rows);
                body(static_cast<const NearestRows&>(rows));
            }
        });
    }
}

template <class Body>
void Cloud::forEach(std::size_t k, const base::Progress& progress, const char* what, const Body& body) const {
    if (size() < 2 || k == 0) {
        for (std::size_t i = 0; i < size(); ++i)
            body(i, Neighbours());
        return;
    }
    forEachCell(k, progress, what, [&](const NearestRows& rows) {
        Neighbours neighbours;
        for (std::size_t n = 0; n < rows.count; ++n) {
            const auto row = static_cast<std::ptrdiff_t>(n * rows.k), end = row + static_cast<std::ptrdiff_t>(rows.k);
            neighbours.index.assign(rows.index.begin() + row, rows.index.begin() + end);
            neighbours.distanceSq.assign(rows.distanceSq.begin() + row, rows.distanceSq.begin() + end);
            body(rows.first + n, static_cast<const Neighbours&>(neighbours));
        }
    });
}

} // namespace process
