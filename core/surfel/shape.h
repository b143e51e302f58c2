// Shapes of supports: an ellipsoid instead of a ball, by one vector b beside the radius h of a surfel:
//
//     r^2 = (|q|^2 + (b.q)^2) / h^2                 its weight ends where r = 1 (surfel/README 2.4)
//
// h is the large semi-axis, h / sqrt(1 + |b|^2) that along b; b = 0 is the ball. b lies in the tangent plane where it
// was made, follows what strokes do to its surroundings, and has no unit and no sign. As h bounds the support,
// whatever b is, bounds and queries of trees know nothing of shapes.
//
// b is stored as three further attributes that stand next to each other in the layout. Models without them have no
// shapes, and cost and compute what they would if there were none anywhere.
#pragma once

#include "core/base/mat3.h"
#include "core/surfel/surfel_block.h"

namespace surfel {

inline constexpr const char* shapeNames[3] = {"support_shape_x", "support_shape_y", "support_shape_z"};
/// Most of a1 / a2, the ratio of the semi-axes; of |b| so.
constexpr float mostAspect = 3.3f, longestShape = 3.14484f;

/// The channel of clusters that holds b_x; those of b_y and b_z follow. 0: supports are balls.
int shapeChannel(const AttributeLayout& layout);
/// The first of the three words among a surfel's further ones. REQUIRES: shapeChannel(layout) > 0.
inline std::size_t shapeWord(const AttributeLayout& layout) {
    return static_cast<std::size_t>(shapeChannel(layout) - Extra);
}
/// Adds the attributes of shapes where the layout lacks them. Throws base::Error where one of the names is taken
/// otherwise.
void addShape(AttributeLayout& layout);
/// A copy without them: attributes of the same surfels, in order, words closed up.
SurfelList withoutShape(const SurfelList& list);

/// b of a surfel; zero for channel 0.
inline base::Vec3f shapeOf(const SurfelBlock& block, int slot, int channel) {
    if (channel == 0)
        return {};
    const float* c = block.channel(slot / clusterSize, channel) + slot % clusterSize;
    return {c[0], c[clusterSize], c[2 * clusterSize]};
}
/// REQUIRES: channel > 0.
inline void setShape(SurfelBlock& block, int slot, int channel, const base::Vec3f& b) {
    float* c = block.channel(slot / clusterSize, channel) + slot % clusterSize;
    c[0] = b.x, c[clusterSize] = b.y, c[2 * clusterSize] = b.z;
}
/// A ball of that radius, whatever the shape was.
inline void setBall(SurfelBlock& block, int slot, int channel, float radius) {
    block.channel(slot / clusterSize, Support)[slot % clusterSize] = radius;
    if (channel > 0)
        setShape(block, slot, channel, {});
}
/// The same among a surfel's further words, from shapeWord(layout) on.
base::Vec3f shapeIn(std::span<const std::uint32_t> words, std::size_t first);
void putShape(std::span<std::uint32_t> words, std::size_t first, const base::Vec3f& b);

/// b becomes fn(b) for the surfels of a list from `begin` on, where it has shapes.
template <class Fn>
void mapShapes(SurfelList& list, std::size_t begin, const Fn& fn) {
    if (shapeChannel(*list.layout) == 0)
        return;
    const std::size_t first = shapeWord(*list.layout), words = list.layout->words();
    for (std::size_t i = begin; i < list.size(); ++i) {
        const auto own = std::span(list.extra).subspan(i * words, words);
        putShape(own, first, fn(shapeIn(own, first)));
    }
}

/// a1 / a2.
inline float aspectOf(const base::Vec3f& b) {
    return std::sqrt(1 + lengthSq(b));
}
/// The semi-axis of a ball of the same area in the tangent plane, in radii: sqrt(a2 / a1).
inline float meanAxis(const base::Vec3f& b) {
    return 1 / std::sqrt(aspectOf(b));
}
/// The radius of the ball of the same area.
inline float ballOf(const SurfelBlock& block, int slot, int channel) {
    const float h = block.support(slot);
    return channel > 0 ? h * meanAxis(shapeOf(block, slot, channel)) : h;
}
/// Makes a ball of the same area of a surfel with these further words: for one that is born, or comes to another place.
void becomeBall(const AttributeLayout& layout, Surfel& s, std::span<std::uint32_t> words);
/// |q|^2 + (b.q)^2, to be compared with the squared radius.
inline float shapedSq(const base::Vec3f& q, const base::Vec3f& b) {
    const float along = dot(b, q);
    return lengthSq(q) + along * along;
}
/// b as it may be: finite, in the plane across `n` (if that is not zero), no longer than longestShape.
base::Vec3f soundShape(const base::Vec3f& b, const base::Vec3f& n);

struct Ellipse {
    float radius = 0;
    base::Vec3f shape;
};
/// What becomes of a support under a deformation with this Jacobian, which turns the normal n into `turned`: its
/// ellipse in the tangent plane goes along. Capped at mostAspect by growing the short axis, so that it covers what it
/// covered.
Ellipse deformed(const Ellipse& support, const base::Vec3f& n, const base::Mat3d& jacobian, const base::Vec3f& turned);

} // namespace surfel
