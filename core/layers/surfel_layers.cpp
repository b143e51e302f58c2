#include "core/layers/surfel_layers.h"

#include "core/layers/shown_cluster.h"

#include <algorithm>
#include <cmath>

namespace layers {

using base::Vec3d;

/// As in shown_cluster.cpp.
constexpr double opposite = -0.999, leastAreaSq = 1e-6;
/// Rounds in which the normal of one storey is found from that of the top.
constexpr int rounds = 8;
/// The support has a say in how far things lean, and what they hold in the support: so often one is taken for the
/// other.
constexpr int supportRounds = 8;
constexpr double sameDirection = 1 - 1e-13, closeDirection = 1 - 1e-10, insideOut = -1 + 1e-5;
/// Bounds of stretches of area.
constexpr double leastStretch = 0.25, mostStretch = 8;
/// Cosine between displacement and normal up to which stretches cannot be told, and from which they can.
constexpr double alongSurface = 0.2, uprightEnough = 0.5;
/// As in shown_cluster.cpp.
constexpr double leastWidth = 0.1;
/// Bounds of what a layer records of supports; what is beyond, and what only rounds, is the base's.
constexpr double mostWidening = 4, sameWidth = 3e-7, roundingOfWidth = 1e-6;
/// What is hidden more than this by a layer's own mask takes no stroke.
constexpr double hidden = 0.99;

Vec3d turned(const Vec3d& v, const Vec3d& a, const Vec3d& b) {
    const double c = dot(a, b);
    if (c < opposite)
        return v;
    const Vec3d h = a + b;
    return v - h * (dot(h, v) / (1 + c)) + b * (2 * dot(a, v));
}

static Vec3d vectorAt(const surfel::SurfelBlock& block, int slot, int channel) {
    const float* c = block.channel(slot / surfel::clusterSize, channel) + slot % surfel::clusterSize;
    return {double(c[0]), double(c[surfel::clusterSize]), double(c[2 * surfel::clusterSize])};
}

static void putVector(surfel::SurfelBlock& block, int slot, int channel, const Vec3d& v) {
    float* c = block.channel(slot / surfel::clusterSize, channel) + slot % surfel::clusterSize;
    for (std::size_t k = 0; k < 3; ++k)
        c[k * surfel::clusterSize] = static_cast<float>(v[k]);
}

static double wordAt(const surfel::SurfelBlock& block, int slot, int channel) {
    return double(block.channel(slot / surfel::clusterSize, channel)[slot % surfel::clusterSize]);
}

static void putWord(surfel::SurfelBlock& block, int slot, int channel, double value) {
    block.channel(slot / surfel::clusterSize, channel)[slot % surfel::clusterSize] = static_cast<float>(value);
}

void SurfelLayers::read(const surfel::SurfelBlock& block, int slot, const Channels& channels) {
    base = vectorAt(block, slot, channels.base);
    normal = vectorAt(block, slot, channels.base + 3);
    support = wordAt(block, slot, channels.base + 6);
    parts.resize(channels.layers.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const int first = channels.layers[i];
        parts[i].d = vectorAt(block, slot, first);
        parts[i].e = vectorAt(block, slot, first + Area);
        parts[i].q = wordAt(block, slot, first + Widening);
        parts[i].mask = wordAt(block, slot, first + OwnMask);
    }
}

void SurfelLayers::write(surfel::SurfelBlock& block, int slot, const Channels& channels) const {
    putVector(block, slot, channels.base, base);
    putVector(block, slot, channels.base + 3, normal);
    putWord(block, slot, channels.base + 6, support);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        putVector(block, slot, channels.layers[i], parts[i].d);
        putVector(block, slot, channels.layers[i] + Area, parts[i].e);
        putWord(block, slot, channels.layers[i] + Widening, parts[i].q);
        putWord(block, slot, channels.layers[i] + OwnMask, parts[i].mask);
    }
}

Vec3d SurfelLayers::leanTo(double far, const Vec3d& below) const {
    const double limit = double(leanLimit) * support;
    if (!(far > limit) || dot(normal, below) < opposite)
        return below;
    return normalized(normal + (below - normal) * leaning(far, limit), below);
}

SurfelLayers::Place SurfelLayers::climb(std::span<const float> weights, std::size_t from, std::size_t to,
                                        Place at) const {
    for (std::size_t i = from; i < to; ++i) {
        const double w = double(weights[i]) * (1 - parts[i].mask);
        if (w == 0)
            continue;
        const Vec3d leant = leanTo(parts[i], at.normal), area = at.normal + turned(parts[i].e, normal, leant) * w;
        at.up += turned(parts[i].d, normal, leant) * w;
        if (lengthSq(area) > leastAreaSq)
            at.normal = normalized(area);
    }
    return at;
}

double SurfelLayers::growth(std::size_t part, double weight) const {
    const Part& each = parts[part];
    const double w = weight * (1 - each.mask), width = std::max(leastWidth, 1 + w * each.q);
    if (each.q != 0 || (weight >= 0 && weight <= 1))
        return width;
    const double ratio = lengthSq(normal + each.e * w) / std::max(1.0, lengthSq(normal + each.e));
    return width * std::sqrt(std::sqrt(std::max(1.0, ratio)));
}

double SurfelLayers::growth(std::span<const float> weights) const {
    double out = 1;
    for (std::size_t i = 0; i < parts.size(); ++i)
        out *= growth(i, double(weights[i]));
    return out;
}

SurfelLayers::Shown SurfelLayers::shown(std::span<const float> weights) const {
    const Place top = climb(weights, 0, parts.size(), {{}, normal});
    return {base + top.up, top.normal, support * growth(weights)};
}

/// |M| for M along `side`: what moves along one direction e keeps the area seen along it, M . e = N . e. Where e lies
/// in the surface that tells nothing, and area counts as kept.
static double areaOf(const Vec3d& below, const Vec3d& displaced, const Vec3d& side) {
    const double far = length(displaced), before = dot(below, displaced), after = dot(side, displaced);
    if (!(before * after > 0))
        return 1;
    const double x = std::clamp((std::abs(before) / far - alongSurface) / (uprightEnough - alongSurface), 0.0, 1.0);
    return 1 + x * x * (3 - 2 * x) * (std::clamp(before / after, leastStretch, mostStretch) - 1);
}

/// What only rounds leaves the bits of the base.
bool SurfelLayers::takeSupport(double next) {
    if (!(std::abs(next - support) > roundingOfWidth * support))
        return false;
    support = next;
    return true;
}

/// Of what is missing of `displaced` and of `area` the part that its own mask leaves. How far the part leans depends on
/// how far it moves, and that is the same on either side of the turn.
void SurfelLayers::takePlace(Part& part, double strength, const Place& below, const Place& now, const Vec3d& displaced,
                             const Vec3d& area) {
    const double w = strength * (1 - part.mask);
    const Vec3d leant = leanTo(part, below.normal), areaNow = below.normal + turned(part.e, normal, leant) * w;
    const Vec3d shown = now.up - below.up, missing = displaced - shown, missingArea = area - areaNow;
    const Vec3d place = shown + missing * (w / strength);
    const Vec3d next = leanTo(length(place) / std::abs(w), below.normal);
    if (leant == next) { // as it leant before: what nothing moves keeps its bits
        part.d += turned(missing, leant, normal) / strength;
        part.e += turned(missingArea, leant, normal) / strength;
        return;
    }
    part.d = turned(place, next, normal) / w;
    part.e = turned(areaNow - below.normal + missingArea * (w / strength), next, normal) / w;
}

/// The part's displacement and area vector for the place and the normal wanted.
void SurfelLayers::takeWay(std::span<const float> weights, std::size_t k, const Shown& wanted) {
    const Place below = climb(weights, 0, k, {{}, normal}), now = climb(weights, k, k + 1, below);
    Vec3d side = now.normal;
    Place above;
    for (int round = 0; round < rounds; ++round) { // until the layers above carry it to the normal wanted
        above = climb(weights, k + 1, parts.size(), {{}, side});
        if (dot(above.normal, wanted.normal) > sameDirection)
            break;
        side = normalized(turned(side, above.normal, wanted.normal), side);
        if (dot(above.normal, wanted.normal) < opposite)
            side = -side;
    }
    above = climb(weights, k + 1, parts.size(), {{}, side});
    const Vec3d displaced = wanted.position - base - above.up - below.up;
    takePlace(parts[k], double(weights[k]), below, now, displaced, side * areaOf(below.normal, displaced, side));
}

void SurfelLayers::record(std::span<const float> weights, int target, const Shown& wanted) {
    const auto k = static_cast<std::size_t>(target);
    Part& part = parts[k];
    if (part.mask > hidden)
        return;
    const double strength = double(weights[k]), w = strength * (1 - part.mask);
    takeWay(weights, k, wanted);
    const double others = growth(weights) / growth(k, strength), needed = wanted.support / (support * others);
    const double q = std::clamp((needed - 1) / w, -mostWidening, mostWidening);
    if (std::abs(w * (q - part.q)) > sameWidth)
        part.q = q;
    if (part.mask == 0) // what is hidden in part shows a part of the turn
        takeNormal(weights, wanted.normal);
    for (int round = 0; round < supportRounds && takeSupport(wanted.support / growth(weights)); ++round)
        if (part.mask == 0) { // the support says how far things lean
            takeWay(weights, k, wanted);
            takeNormal(weights, wanted.normal);
        }
}

/// Where no turn of a lower storey leads to a normal of the top, at cliffs and folds, the uppermost layer takes what is
/// missing.
void SurfelLayers::takeNormal(std::span<const float> weights, const Vec3d& wanted) {
    if (lengthSq(wanted) == 0 || dot(climb(weights, 0, parts.size(), {{}, normal}).normal, wanted) > closeDirection)
        return;
    for (std::size_t k = parts.size(); k-- > 0;) {
        const double w = double(weights[k]) * (1 - parts[k].mask);
        if (std::abs(w) < double(leastRecording))
            continue;
        const Place below = climb(weights, 0, k, {{}, normal});
        const Vec3d leant = leanTo(parts[k], below.normal), area = below.normal + turned(parts[k].e, normal, leant) * w;
        parts[k].e += turned(wanted * std::clamp(length(area), leastStretch, mostStretch) - area, leant, normal) / w;
        return; // next to nothing is shown above it
    }
}

/// Inside out: normals and area vectors change their signs.
void SurfelLayers::turnOver() {
    normal = -normal;
    for (Part& part : parts)
        part.e = -part.e;
}

void SurfelLayers::rebase(std::span<const float> weights, const Shown& wanted, bool follow) {
    if (lengthSq(normal) == 0 || lengthSq(wanted.normal) == 0)
        normal = wanted.normal;
    Place top = climb(weights, 0, parts.size(), {{}, normal});
    if (dot(top.normal, wanted.normal) < insideOut)
        turnOver();
    const SurfelLayers before = *this;
    for (int round = 0; round < rounds; ++round) {
        top = climb(weights, 0, parts.size(), {{}, normal});
        if (dot(top.normal, wanted.normal) > sameDirection)
            break;
        const Vec3d next = normalized(turned(normal, top.normal, wanted.normal), normal);
        if (follow)
            for (Part& part : parts) {
                const Vec3d leant = leanTo(part, next);
                part.d = turned(part.d, normal, leant), part.e = turned(part.e, normal, leant);
            }
        normal = next;
    }
    if (dot(climb(weights, 0, parts.size(), {{}, normal}).normal, wanted.normal) < closeDirection)
        normal = before.normal, parts = before.parts;
    takeNormal(weights, wanted.normal);
    for (int round = 0; round < supportRounds && takeSupport(wanted.support / growth(weights)); ++round)
        takeNormal(weights, wanted.normal);
    base = wanted.position - climb(weights, 0, parts.size(), {{}, normal}).up;
}

} // namespace layers
