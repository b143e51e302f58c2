// Batches in packets: consecutive positions share one neighbourhood; scattered ones are first put along a Morton curve.
#pragma once

#include "core/surface/evaluation/source.h"

#include <functional>
#include <span>

namespace surface {

namespace detail {

/// Calls fn(source, indices) for packets of positions that together are all of x, in parallel.
void forEachPacket(const Surface& surface, std::span<const base::Vec3f> x, float slack, float distance,
                   const std::function<void(Source&, std::span<const std::uint32_t>)>& fn);

} // namespace detail

/// Calls fn(source, i) for every i in [0, x.size()), in parallel, with sources prepared for x[i] and up to `slack`
/// units of h around it. The order is chosen for speed; fn must not depend on it.
template <class Fn>
void forPackets(const Surface& surface, std::span<const base::Vec3f> x, float slack, const Fn& fn) {
    detail::forEachPacket(surface, x, slack, 0, [&](Source& source, std::span<const std::uint32_t> packet) {
        for (const std::uint32_t i : packet)
            fn(source, static_cast<std::size_t>(i));
    });
}

/// The same, prepared for `distance` around each position, in model units: for steps whose length is not h's.
template <class Fn>
void forPacketsWithin(const Surface& surface, std::span<const base::Vec3f> x, double distance, const Fn& fn) {
    const auto some = [&](Source& source, std::span<const std::uint32_t> packet) {
        for (const std::uint32_t i : packet)
            fn(source, static_cast<std::size_t>(i));
    };
    detail::forEachPacket(surface, x, 0, static_cast<float>(distance), some);
}

} // namespace surface
