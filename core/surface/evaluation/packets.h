// Batches in packets: consecutive positions share one neighbourhood; scattered ones are first put along a Morton curve.
#pragma once

#include "core/surface/evaluation/source.h"

#include <functional>
#include <span>

namespace surface {

/// Numbers of positions that share a source.
using Packet = std::span<const std::uint32_t>;

namespace detail {

/// Calls fn(sources, packets) for packets of positions that together are all of x, some at a time, in parallel.
using PacketFunction = std::function<void(std::span<Source>, std::span<const Packet>)>;
void forEachGroup(const Surface& surface, std::span<const base::Vec3f> x, float slack, float distance,
                  const PacketFunction& fn);
/// Calls fn(source, i) one by one.
template <class Fn>
void forEachPosition(const Surface& surface, std::span<const base::Vec3f> x, float slack, float distance,
                     const Fn& fn) {
    forEachGroup(surface, x, slack, distance, [&](std::span<Source> sources, std::span<const Packet> packets) {
        for (std::size_t k = 0; k < packets.size(); ++k)
            for (const std::uint32_t i : packets[k])
                fn(sources[k], static_cast<std::size_t>(i));
    });
}

} // namespace detail

/// Calls fn(source, i) for every i in [0, x.size()), in parallel, with sources prepared for x[i] and up to `slack`
/// units of h around it. The order is chosen for speed; fn must not depend on it.
template <class Fn>
void forPackets(const Surface& surface, std::span<const base::Vec3f> x, float slack, const Fn& fn) {
    detail::forEachPosition(surface, x, slack, 0, fn);
}

/// The same for several packets at a time, each with a source of its own: fn(sources, packets).
template <class Fn>
void forPacketGroups(const Surface& surface, std::span<const base::Vec3f> x, float slack, const Fn& fn) {
    detail::forEachGroup(surface, x, slack, 0, fn);
}

/// The same, prepared for `distance` around each position, in model units: for steps whose length is not h's.
template <class Fn>
void forPacketsWithin(const Surface& surface, std::span<const base::Vec3f> x, double distance, const Fn& fn) {
    detail::forEachPosition(surface, x, 0, static_cast<float>(distance), fn);
}

} // namespace surface
