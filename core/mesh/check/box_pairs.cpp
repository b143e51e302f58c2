#include "core/mesh/check/box_pairs.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/base/ranked.h"

#include <algorithm>
#include <numeric>

namespace mesh {

using base::Box3d, base::Vec3d;

namespace {

constexpr std::size_t few = 256;  ///< boxes, which are compared along one axis
constexpr double mostTwice = 1.5; ///< of the boxes, in both halves together: more would not end
constexpr std::size_t leavesAtOnce = 256;

constexpr std::size_t axes[] = {0, 1, 2};

/// A part of space, without its upper sides, and the boxes that reach into it.
struct Part {
    Box3d space;
    std::vector<std::uint32_t> boxes;
};

class BoxTree {
  public:
    explicit BoxTree(std::span<const Box3d> boxes) : m_boxes(boxes) {
        constexpr double inf = Box3d::inf;
        Part all{{{-inf, -inf, -inf}, {inf, inf, inf}}, std::vector<std::uint32_t>(boxes.size())};
        std::iota(all.boxes.begin(), all.boxes.end(), 0u);
        halve(std::move(all));
    }
    const std::vector<Part>& leaves() const { return m_leaves; }

    /// Two boxes are a pair of the part that their lowest common corner is in.
    template <class Fn>
    void forPairs(const Part& part, const Fn& fn) const {
        const std::size_t k = longest(part.boxes);
        std::vector<std::uint32_t> order = part.boxes;
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(m_boxes[a].lo[k], a) < std::pair(m_boxes[b].lo[k], b);
        });
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Box3d& one = m_boxes[order[i]];
            for (std::size_t j = i + 1; j < order.size() && m_boxes[order[j]].lo[k] <= one.hi[k]; ++j) {
                const Box3d both = one.cut(m_boxes[order[j]]);
                if (!both.empty() && holds(part.space, both.lo))
                    fn(BoxPair(std::minmax(order[i], order[j])));
            }
        }
    }

  private:
    static bool holds(const Box3d& space, const Vec3d& p) {
        return std::all_of(std::begin(axes), std::end(axes),
                           [&](std::size_t k) { return space.lo[k] <= p[k] && p[k] < space.hi[k]; });
    }
    /// The axis along which the middles of boxes are farthest apart.
    std::size_t longest(const std::vector<std::uint32_t>& boxes) const {
        Box3d middles;
        for (const std::uint32_t b : boxes)
            middles.extend(m_boxes[b].centre());
        const Vec3d size = middles.size();
        return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    }
    void halve(Part part) {
        base::CancelScope::check();
        if (part.boxes.size() <= few)
            return leave(std::move(part));
        const std::size_t k = longest(part.boxes);
        std::vector<double> middles;
        double mean = 0; // where many share a middle, as on a wall, half of them are not below it
        for (const std::uint32_t b : part.boxes) {
            middles.push_back(m_boxes[b].centre()[k]);
            mean += middles.back() / static_cast<double>(part.boxes.size());
        }
        for (const double at : {base::median(middles), mean})
            if (auto [low, high] = halves(part, k, at); ends(part, low, high)) {
                part.boxes = {};
                halve(std::move(low));
                return halve(std::move(high));
            }
        leave(std::move(part));
    }
    std::pair<Part, Part> halves(const Part& part, std::size_t k, double at) const {
        Part low{part.space, {}}, high{part.space, {}};
        low.space.hi[k] = high.space.lo[k] = at;
        for (const std::uint32_t b : part.boxes) {
            if (m_boxes[b].lo[k] < at)
                low.boxes.push_back(b);
            if (m_boxes[b].hi[k] >= at)
                high.boxes.push_back(b);
        }
        return {std::move(low), std::move(high)};
    }
    static bool ends(const Part& part, const Part& low, const Part& high) {
        const std::size_t n = part.boxes.size(), one = low.boxes.size(), other = high.boxes.size();
        return one < n && other < n && static_cast<double>(one + other) <= mostTwice * static_cast<double>(n);
    }
    void leave(Part part) {
        if (part.boxes.size() > 1)
            m_leaves.push_back(std::move(part));
    }

    std::span<const Box3d> m_boxes;
    std::vector<Part> m_leaves;
};

} // namespace

std::vector<BoxPair> overlappingBoxes(std::span<const Box3d> boxes, const std::function<bool(const BoxPair&)>& keep,
                                      const base::Progress& progress) {
    const BoxTree tree(boxes);
    const std::size_t n = tree.leaves().size();
    std::vector<std::vector<BoxPair>> found(n);
    for (std::size_t first = 0; first < n; first += leavesAtOnce) {
        progress.step(static_cast<double>(first) / static_cast<double>(n), "Looking for intersections");
        base::parallelFor(std::min(leavesAtOnce, n - first), 1, [&](std::size_t i) {
            std::vector<BoxPair>& own = found[first + i];
            tree.forPairs(tree.leaves()[first + i], [&](const BoxPair& pair) {
                if (keep(pair))
                    own.push_back(pair);
            });
        });
    }
    std::vector<BoxPair> out;
    for (const std::vector<BoxPair>& each : found)
        out.insert(out.end(), each.begin(), each.end());
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace mesh
