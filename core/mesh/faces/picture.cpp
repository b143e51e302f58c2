#include "core/mesh/faces/picture.h"

#include <algorithm>
#include <cmath>

namespace mesh {

/// The two pixels beside a place on one axis, and the share of the second.
namespace {
struct Between {
    std::size_t first, second;
    double share;
};
} // namespace

static Between between(double place, int size, bool clamped) {
    const double n = size;
    place = clamped ? std::clamp(place, 0.0, 1.0) : place - std::floor(place);
    const double x = place * n - 0.5, low = std::floor(x);
    const auto pixel = [&](double k) {
        const double kept = clamped ? std::clamp(k, 0.0, n - 1) : k < 0 ? k + n : k >= n ? k - n : k;
        return static_cast<std::size_t>(kept);
    };
    return {pixel(low), pixel(low + 1), x - low};
}

surfel::Colour Picture::at(double u, double v) const {
    const Between x = between(u, width, clamped), y = between(1 - v, height, clamped);
    const auto pixel = [this](std::size_t row, std::size_t column) {
        return pixels[row * static_cast<std::size_t>(width) + column];
    };
    const surfel::Colour corners[4] = {pixel(y.first, x.first), pixel(y.first, x.second), pixel(y.second, x.first),
                                       pixel(y.second, x.second)};
    const double weights[4] = {(1 - x.share) * (1 - y.share), x.share * (1 - y.share), (1 - x.share) * y.share,
                               x.share * y.share};
    surfel::Colour out = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k)
            sum += weights[k] * (corners[k] >> shift & 255u);
        out |= static_cast<surfel::Colour>(std::min(255.0, std::floor(sum + 0.5))) << shift;
    }
    return out;
}

} // namespace mesh
