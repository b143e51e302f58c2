#include "core/selection/levels.h"

#include "core/surfel/colour_light.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace selection {

using base::Vec3d;
using surfel::Colour, surfel::lightOf, surfel::SurfelBlock;
using tree::SurfelTree;

/// Of each channel, 0 to 255, not rounded.
static Vec3d gained(Colour colour, const Vec3d& gain) {
    if (gain == Vec3d{1, 1, 1}) // to the digit
        return {static_cast<double>(colour & 255u), static_cast<double>(colour >> 8 & 255u),
                static_cast<double>(colour >> 16 & 255u)};
    const Vec3d light = lightOf(colour);
    const auto out = [](double v) { return 255 * base::srgbOf(std::min(v, 1.0)); };
    return {out(light.x * gain.x), out(light.y * gain.y), out(light.z * gain.z)};
}

Colour Levels::operator()(Colour colour) const {
    const Vec3d v = gained(colour, gain);
    const auto channel = [&](double each, unsigned c) {
        const double share = std::clamp((each - black) / (white - black), 0.0, 1.0);
        return static_cast<Colour>(std::lround(255 * std::pow(share, 1 / gamma))) << 8 * c;
    };
    return channel(v.x, 0) | channel(v.y, 1) | channel(v.z, 2) | (colour & 0xff000000u);
}

Vec3d greyGains(const Vec3d& mean) {
    constexpr double dark = 1e-3;
    if (!(std::min({mean.x, mean.y, mean.z}) > dark))
        return {1, 1, 1};
    const double bright = 0.2126 * mean.x + 0.7152 * mean.y + 0.0722 * mean.z; // of Rec. 709
    return {bright / mean.x, bright / mean.y, bright / mean.z};
}

template <class Body>
static void forColours(const tree::SurfelTree& tree, Limit limit, const Body& body) {
    const int channel = channelOf(*tree.layout(), Field::Selection);
    tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (limit == Limit::Everything || valueAt(block, channel, slot) >= half)
                body(block.surfel(slot).colour);
    });
}

Vec3d meanLight(const tree::SurfelTree& tree, Limit limit) {
    Vec3d sum, all;
    double count = 0, allCount = 0;
    forColours(tree, limit, [&](Colour colour) {
        const Vec3d light = lightOf(colour);
        all += light, ++allCount;
        const auto sound = [&](unsigned c) { return (colour >> 8 * c & 255u) - 1u < 254u; };
        if (sound(0) && sound(1) && sound(2))
            sum += light, ++count;
    });
    return count > 0 ? sum / count : all / std::max(allCount, 1.0);
}

Vec3d meanLightAt(const tree::SurfelTree& tree, const Vec3d& place) {
    constexpr std::size_t wanted = 16;
    std::vector<std::pair<double, Colour>> near;
    tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            near.emplace_back(lengthSq(base::cast<double>(block.position(slot)) - place), block.surfel(slot).colour);
    });
    const std::size_t count = std::min(wanted, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    Vec3d sum;
    for (std::size_t k = 0; k < count; ++k)
        sum += lightOf(near[k].second) / static_cast<double>(count);
    return sum;
}

std::pair<double, double> usedRange(const tree::SurfelTree& tree, Limit limit, const Vec3d& gain) {
    constexpr double left = 0.005;
    std::array<std::size_t, 256> often{};
    std::size_t all = 0;
    forColours(tree, limit, [&](Colour colour) {
        const Vec3d v = gained(colour, gain);
        for (const double each : {v.x, v.y, v.z})
            ++often[static_cast<std::size_t>(std::clamp(std::lround(each), 0l, 255l))], ++all;
    });
    const auto cut = static_cast<std::size_t>(left * static_cast<double>(all));
    int black = 0, white = 255;
    for (std::size_t below = often[0]; below <= cut && black < 254; below += often[static_cast<std::size_t>(black)])
        ++black;
    for (std::size_t above = often[255]; above <= cut && white > black + 1;
         above += often[static_cast<std::size_t>(white)])
        --white;
    return {black, white};
}

SurfelTree levelled(const SurfelTree& tree, const Levels& levels, Limit limit) {
    return recoloured(tree, levels, 1, limit);
}

} // namespace selection
