#include "core/mesh/faces/face_sides.h"

#include "core/base/random.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace mesh {

using base::Vec3f;

std::vector<std::uint32_t> placesOf(std::span<const Vec3f> positions) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> slots(std::bit_ceil(2 * positions.size() + 1), none), out(positions.size());
    const std::size_t mask = slots.size() - 1;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::uint64_t hash = 0;
        for (std::size_t k = 0; k < 3; ++k)
            hash = base::mix(hash ^ std::bit_cast<std::uint32_t>(positions[i][k] + 0.0f)); // -0 is 0
        std::size_t slot = hash & mask;
        while (slots[slot] != none && positions[slots[slot]] != positions[i])
            slot = (slot + 1) & mask;
        if (slots[slot] == none)
            slots[slot] = i;
        out[i] = slots[slot];
    }
    return out;
}

static std::uint64_t keyOf(std::uint64_t a, std::uint64_t b) {
    return std::min(a, b) << 32 | std::max(a, b);
}

std::vector<FaceSide> sidesOf(std::span<const Triangle> triangles, const Places& places) {
    std::vector<FaceSide> out;
    out.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const Triangle corners = places.at(triangles[t]);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint64_t a = corners[k], b = corners[(k + 1) % 3], key = keyOf(a, b);
            if (a == b)
                continue;
            const auto joints = places.joints.empty() ? places.joints.end() : places.joints.find(key);
            if (joints == places.joints.end()) {
                out.push_back({key, 3 * t + k, a > b});
                continue;
            }
            std::uint64_t from = std::min(a, b);
            const auto part = [&](std::uint64_t to) {
                out.push_back({keyOf(from, to), 3 * t + k, (a > b) != (from > to)});
                from = to;
            };
            for (const std::uint32_t place : joints->second)
                part(place);
            part(std::max(a, b));
        }
    }
    std::sort(out.begin(), out.end(), [](const FaceSide& a, const FaceSide& b) {
        return a.key != b.key ? a.key < b.key : a.corner < b.corner;
    });
    return out;
}

double edgeLength(std::span<const Vec3f> positions, std::uint64_t key) {
    return distance(base::cast<double>(positions[key >> 32]),
                    base::cast<double>(positions[static_cast<std::uint32_t>(key)]));
}

} // namespace mesh
