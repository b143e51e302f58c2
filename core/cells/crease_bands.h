// Both sides of creases within one face, as bands (cells/README 1.4, 6.2): samples at the ends of links that cross a
// crease are parted into two sides, and what is near them goes with them.
//
//     BandPairs pairs(size, crossing, flat, ends);      which side of which crease an end is on
//     growBands(ends, cells, forLinks, open, width);    those around
//
// Made serially, in the order of what is given.
#pragma once

#include "core/base/cancel_scope.h"
#include "core/base/disjoint_sets.h"

#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace cells {

/// A link that crosses no crease, between ends of links that do.
struct FlatLink {
    float turn; ///< 1 less the cosine between both normals
    std::uint32_t a, b;

    bool operator<(const FlatLink& o) const { return std::tie(turn, a, b) < std::tie(o.turn, o.a, o.b); }
};

class BandPairs {
  public:
    using Link = std::pair<std::uint32_t, std::uint32_t>;

    /// Of `size` samples. Links that cross turn, the others do not, flattest first: the other order joins both sides
    /// around the end of a crease.
    BandPairs(std::size_t size, std::span<const Link> crossing, std::vector<FlatLink> flat,
              std::span<const std::uint32_t> ends);

    std::size_t count() const { return m_numbers.size(); }
    /// Twice the number of its pair, one more on the second side; nothing where its crease has too few ends to be one.
    std::optional<std::uint32_t> bandOf(std::uint32_t end);

  private:
    base::ParitySets m_sides;
    std::map<std::uint32_t, std::uint32_t> m_numbers; ///< of pairs, by root
};

/// Cells of the seeds go on over shortest ways, no longer than `width`: forLinks(a, fn(b, way)). `open(a, b)` is asked
/// last of what may be dear to know: may the way take this link?
template <class ForLinks, class Open>
void growBands(std::span<const std::uint32_t> seeds, std::vector<std::uint32_t>& cells, const ForLinks& forLinks,
               const Open& open, double width) {
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::map<std::uint32_t, double> known;
    for (const std::uint32_t a : seeds) {
        known[a] = 0;
        queue.emplace(0.0, a);
    }
    for (std::size_t steps = 0; !queue.empty(); ++steps) {
        if (steps % 4096 == 0)
            base::CancelScope::check();
        const auto [far, a] = queue.top();
        queue.pop();
        if (far > known.at(a))
            continue;
        forLinks(a, [&, far = far, a = a](std::uint32_t b, double way) {
            const double further = far + way;
            const auto at = known.find(b);
            if (further > width || (at != known.end() && at->second <= further) || !open(a, b))
                return;
            known[b] = further;
            cells[b] = cells[a];
            queue.emplace(further, b);
        });
    }
}

} // namespace cells
