#include "core/raycast/edited_region.h"

#include "core/base/random.h"
#include "core/surfel/shape.h"

#include <bit>

namespace raycast {

namespace {

/// A surfel by its content, and where it is.
struct Entry {
    std::uint64_t content;
    std::size_t cluster; ///< of all unshared clusters of both versions
    base::Vec3f position;
    float support;
};

std::uint64_t contentOf(const surfel::Surfel& s, const base::Vec3f& shape) {
    std::uint64_t out = s.colour;
    for (const float value : {s.position.x, s.position.y, s.position.z, s.normal.x, s.normal.y, s.normal.z, s.support,
                              s.mask, shape.x, shape.y, shape.z})
        out = base::mix(out ^ std::bit_cast<std::uint32_t>(value));
    return out;
}

/// The surfels of some blocks, ordered by content; clusters are numbered on from `clusters`.
std::vector<Entry> entriesOf(const std::vector<surfel::BlockPtr>& blocks, int shape, std::size_t& clusters) {
    std::vector<Entry> out;
    for (const surfel::BlockPtr& block : blocks) {
        for (int slot = 0; slot < block->size(); ++slot) {
            const surfel::Surfel s = block->surfel(slot);
            const auto cluster = clusters + static_cast<std::size_t>(slot / surfel::clusterSize);
            out.push_back({contentOf(s, surfel::shapeOf(*block, slot, shape)), cluster, s.position, s.support});
        }
        clusters += static_cast<std::size_t>(block->clusterCount());
    }
    std::ranges::sort(out, {}, &Entry::content);
    return out;
}

} // namespace

std::vector<base::Box3f> editedRegion(const tree::SurfelTree& from, const tree::SurfelTree& to) {
    const tree::Diff diff = tree::diff(from, to);
    std::size_t clusters = 0;
    const std::vector<Entry> gone = entriesOf(diff.removed, surfel::shapeChannel(*from.layout()), clusters),
                             come = entriesOf(diff.added, surfel::shapeChannel(*to.layout()), clusters);
    std::vector<Entry> changed;
    std::ranges::set_symmetric_difference(gone, come, std::back_inserter(changed), {}, &Entry::content,
                                          &Entry::content);
    std::vector<base::Box3f> boxes(clusters);
    std::vector<float> supports(clusters);
    for (const Entry& entry : changed) {
        boxes[entry.cluster].extend(entry.position);
        supports[entry.cluster] = std::max(supports[entry.cluster], entry.support);
    }
    std::vector<base::Box3f> out;
    for (std::size_t i = 0; i < clusters; ++i)
        if (!boxes[i].empty())
            out.push_back(boxes[i].inflated(supports[i]));
    return out;
}

} // namespace raycast
