#include "core/reduce/counts.h"

#include <algorithm>
#include <utility>

namespace reduce {

std::vector<std::size_t> apportion(const std::vector<double>& weights, const std::vector<std::size_t>& least,
                                   const std::vector<std::size_t>& most, std::size_t total) {
    const auto at = [&](double factor, std::size_t i) {
        return std::clamp(factor * weights[i], double(least[i]), double(most[i]));
    };
    const auto sum = [&](double factor) {
        double out = 0;
        for (std::size_t i = 0; i < weights.size(); ++i)
            out += at(factor, i);
        return out;
    };
    double low = 0, high = 1;
    for (int k = 0; k < 1000 && sum(high) < double(total); ++k)
        high *= 2;
    for (int k = 0; k < 200; ++k) {
        const double mid = (low + high) / 2;
        (sum(mid) < double(total) ? low : high) = mid;
    }
    std::vector<std::size_t> out(weights.size());
    std::vector<std::pair<double, std::size_t>> rest;
    std::size_t given = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double exact = at(high, i);
        out[i] = std::clamp(static_cast<std::size_t>(exact), least[i], most[i]);
        given += out[i];
        rest.emplace_back(double(out[i]) - exact, i);
    }
    std::sort(rest.begin(), rest.end());
    while (given != total) // by rounding alone: a round or two
        for (std::size_t k = 0; k < rest.size() && given != total; ++k) {
            const std::size_t i = rest[given < total ? k : rest.size() - 1 - k].second;
            if (given < total && out[i] < most[i])
                ++out[i], ++given;
            else if (given > total && out[i] > least[i])
                --out[i], --given;
        }
    return out;
}

} // namespace reduce
