#include "core/process/samples/block_of_clay.h"

#include "core/process/samples/even_rows.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace process {

namespace {

using base::Vec3d;

constexpr double quarter = std::numbers::pi / 2;

/// A rectangle of half extents `x` and `z` with everything within `radius` of it: what a level cut of the box is.
struct RoundedRectangle {
    double x, z, radius;
    double length() const { return 4 * (x + z) + 4 * quarter * radius; }
};

struct PlanePoint {
    double x, z, outX, outZ;
};

/// Walks the four sides, each a straight piece and the corner behind it, anticlockwise from the right-hand one.
PlanePoint walk(const RoundedRectangle& r, double distance) {
    double outX = 1, outZ = 0;
    for (int side = 0;; ++side) {
        const double half = side % 2 ? r.x : r.z, off = side % 2 ? r.z : r.x;
        const double straight = 2 * half, corner = quarter * r.radius;
        // The side looks to (outX, outZ) and runs along (-outZ, outX).
        if (distance < straight || side == 4) {
            const double along = distance - half;
            return {outX * (off + r.radius) - outZ * along, outZ * (off + r.radius) + outX * along, outX, outZ};
        }
        distance -= straight;
        if (distance < corner) {
            const double a = distance / r.radius, c = std::cos(a), s = std::sin(a);
            const double nx = outX * c - outZ * s, nz = outX * s + outZ * c;
            return {outX * off - outZ * half + nx * r.radius, outZ * off + outX * half + nz * r.radius, nx, nz};
        }
        distance -= corner;
        outX = std::exchange(outZ, outX) * -1;
    }
}

/// The closed row at a distance from the middle of the top, measured over the surface; y is up.
Row blockRow(const RoundedBox& b, double fromTop) {
    const double x = b.halfX - b.rounding, y = b.halfY - b.rounding, z = b.halfZ - b.rounding;
    const double flat = std::min(x, z), round = quarter * b.rounding, half = flat + round + y;
    const double up = fromTop < half ? 1 : -1, t = half - std::abs(fromTop - half); // t: from the nearer middle
    RoundedRectangle cut{x, z, b.rounding};
    double slope = 0, height = y - (t - flat - round); // slope: angle of the normal above the horizon
    if (t < flat) {
        cut = {x - (flat - t), z - (flat - t), 0};
        slope = quarter, height = b.halfY;
    } else if (t < flat + round) {
        slope = quarter - (t - flat) / b.rounding;
        cut.radius = b.rounding * std::cos(slope), height = y + b.rounding * std::sin(slope);
    }
    return {cut.length(), [=](double distance) {
                const PlanePoint p = walk(cut, distance);
                const double c = std::cos(slope), s = std::sin(slope);
                return RowPoint{{p.x, up * height, p.z}, {p.outX * c, up * s, p.outZ * c}};
            }};
}

double area(const RoundedBox& b) {
    const double x = b.halfX - b.rounding, y = b.halfY - b.rounding, z = b.halfZ - b.rounding;
    const double flats = 8 * (x * y + y * z + z * x), edges = 8 * quarter * b.rounding * (x + y + z);
    return flats + edges + 8 * quarter * b.rounding * b.rounding;
}

} // namespace

surfel::SurfelList sampleBlock(const RoundedBox& box, std::size_t count) {
    const auto make = [&](double apart) {
        const double flat = std::min(box.halfX, box.halfZ) - box.rounding;
        const double total = 2 * (flat + quarter * box.rounding + box.halfY - box.rounding);
        std::vector<Row> rows;
        const std::size_t n = std::max<std::size_t>(3, static_cast<std::size_t>(std::llround(total / apart)));
        for (std::size_t r = 0; r < n; ++r)
            rows.push_back(blockRow(box, (static_cast<double>(r) + 0.5) * total / static_cast<double>(n)));
        return rows;
    };
    return sampleRows(make, area(box), count);
}

} // namespace process
