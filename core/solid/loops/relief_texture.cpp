#include "core/solid/loops/relief_texture.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solid {

using Cell = HeightGrid::Cell;

double correlationLength(const HeightGrid& grid, int most) {
    constexpr int directions[][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
    double mean = 0, count = 0;
    for (std::size_t i = 0; i < grid.values.size(); ++i)
        if (grid.cells[i] == Cell::Known)
            mean += grid.values[i], ++count;
    mean /= std::max(1.0, count);
    double out = 0;
    for (const auto& [dx, dy] : directions) {
        const double step = std::hypot(dx, dy);
        double reach = most, last = 1;
        for (int lag = 0; lag * step <= most; ++lag) {
            double common = 0, own = 0;
            for (int y = 0; y < grid.height; ++y)
                for (int x = 0; x < grid.width; ++x) {
                    const int u = x + lag * dx, v = y + lag * dy;
                    if (!grid.has(u, v) || grid.cells[grid.at(x, y)] != Cell::Known ||
                        grid.cells[grid.at(u, v)] != Cell::Known)
                        continue;
                    const double a = grid.values[grid.at(x, y)] - mean, b = grid.values[grid.at(u, v)] - mean;
                    common += a * b, own += 0.5 * (a * a + b * b);
                }
            const double correlation = own > 0 ? common / own : 0;
            if (correlation <= 0) {
                reach = (lag - 1 + (lag > 0 ? last / std::max(1e-9, last - correlation) : 1)) * step;
                break;
            }
            last = correlation;
        }
        out += std::min(reach, static_cast<double>(most)) / static_cast<double>(std::size(directions));
    }
    return out;
}

namespace {

class Synthesis {
  public:
    explicit Synthesis(HeightGrid& grid) : m_grid(grid), m_filled(grid.cells.size(), 0) {
        for (std::size_t i = 0; i < m_filled.size(); ++i)
            m_filled[i] = grid.cells[i] == Cell::Known;
    }

    bool run() {
        if (!chooseSize())
            return false;
        for (;;) {
            base::CancelScope::check();
            const std::size_t next = nextTarget();
            if (next == none)
                return true;
            const int x = static_cast<int>(next % static_cast<std::size_t>(m_grid.width)),
                      y = static_cast<int>(next / static_cast<std::size_t>(m_grid.width));
            paste(x, y, bestSource(x, y));
        }
    }

  private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    static constexpr std::size_t fewest = 40, mostLooks = 20000;
    static constexpr int leastHalf = 2, mostHalf = 16;

    struct Place {
        int x, y;
    };

    /// Pieces as wide as a wave, or as what is around allows.
    bool chooseSize() {
        const double quarter = correlationLength(m_grid, mostHalf);
        for (m_half = std::clamp(static_cast<int>(std::lround(2 * quarter)), leastHalf, mostHalf); m_half >= leastHalf;
             --m_half) {
            findSources();
            if (m_sources.size() >= fewest)
                return true;
        }
        return false;
    }
    /// Middles of pieces that are known whole, by sums over the grid.
    void findSources() {
        m_sources.clear();
        const auto stride = static_cast<std::size_t>(m_grid.width) + 1;
        std::vector<int> sums(stride * (static_cast<std::size_t>(m_grid.height) + 1), 0);
        for (int y = 0; y < m_grid.height; ++y)
            for (int x = 0; x < m_grid.width; ++x) {
                const std::size_t i = static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x);
                sums[i + stride + 1] =
                    sums[i + stride] + sums[i + 1] - sums[i] + (m_grid.cells[m_grid.at(x, y)] == Cell::Known ? 1 : 0);
            }
        const int side = 2 * m_half + 1;
        for (int y = m_half; y + m_half < m_grid.height; ++y)
            for (int x = m_half; x + m_half < m_grid.width; ++x) {
                const std::size_t lo = static_cast<std::size_t>(y - m_half) * stride +
                                       static_cast<std::size_t>(x - m_half),
                                  up = lo + static_cast<std::size_t>(side) * stride;
                const auto across = static_cast<std::size_t>(side);
                if (sums[up + across] - sums[up] - sums[lo + across] + sums[lo] == side * side)
                    m_sources.push_back({x, y});
            }
    }
    /// The wanted cell with the most around it that is there already.
    std::size_t nextTarget() const {
        std::size_t best = none;
        int most = 0;
        for (int y = 0; y < m_grid.height; ++y)
            for (int x = 0; x < m_grid.width; ++x) {
                if (m_grid.cells[m_grid.at(x, y)] != Cell::Wanted || m_filled[m_grid.at(x, y)] || !atRim(x, y))
                    continue;
                int count = 0;
                for (int v = -m_half; v <= m_half; ++v)
                    for (int u = -m_half; u <= m_half; ++u)
                        count += m_grid.has(x + u, y + v) && m_filled[m_grid.at(x + u, y + v)];
                if (count > most)
                    most = count, best = m_grid.at(x, y);
            }
        return best;
    }
    bool atRim(int x, int y) const {
        const auto there = [this](int u, int v) { return m_grid.has(u, v) && m_filled[m_grid.at(u, v)]; };
        return there(x - 1, y) || there(x + 1, y) || there(x, y - 1) || there(x, y + 1);
    }
    Place bestSource(int x, int y) const {
        struct Offset {
            int u, v;
            double value;
        };
        std::vector<Offset> there;
        for (int v = -m_half; v <= m_half; ++v)
            for (int u = -m_half; u <= m_half; ++u)
                if (m_grid.has(x + u, y + v) && m_filled[m_grid.at(x + u, y + v)])
                    there.push_back({u, v, m_grid.values[m_grid.at(x + u, y + v)]});
        const auto cost = [&](const Place& from) {
            double out = 0;
            for (const Offset& o : there) {
                const double off = m_grid.values[m_grid.at(from.x + o.u, from.y + o.v)] - o.value;
                out += off * off;
            }
            return out;
        };
        const std::size_t step = 1 + m_sources.size() / mostLooks, looks = (m_sources.size() + step - 1) / step;
        std::vector<double> costs(looks);
        base::parallelFor(looks, 256, [&](std::size_t i) { costs[i] = cost(m_sources[i * step]); });
        const auto best = static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
        return m_sources[best * step];
    }
    /// Copies what is wanted; what differs beside is evened out over some cells.
    void paste(int x, int y, const Place& from) {
        constexpr double blend = 1.5; // cells
        const int reach = 4;
        const auto isPiece = [this](int u, int v) { return std::abs(u) <= m_half && std::abs(v) <= m_half; };
        std::vector<std::pair<std::size_t, double>> fresh;
        for (int v = -m_half; v <= m_half; ++v)
            for (int u = -m_half; u <= m_half; ++u) {
                if (!m_grid.has(x + u, y + v))
                    continue;
                const std::size_t to = m_grid.at(x + u, y + v);
                if (m_grid.cells[to] != Cell::Wanted || m_filled[to])
                    continue;
                double off = 0, weights = 0.05;
                for (int dv = -reach; dv <= reach; ++dv)
                    for (int du = -reach; du <= reach; ++du) {
                        if (!isPiece(u + du, v + dv) || !m_grid.has(x + u + du, y + v + dv))
                            continue;
                        const std::size_t near = m_grid.at(x + u + du, y + v + dv);
                        if (!m_filled[near])
                            continue;
                        const double weight = std::exp(-(du * du + dv * dv) / (2 * blend * blend));
                        off +=
                            weight * (m_grid.values[near] - m_grid.values[m_grid.at(from.x + u + du, from.y + v + dv)]);
                        weights += weight;
                    }
                fresh.emplace_back(to, m_grid.values[m_grid.at(from.x + u, from.y + v)] + off / weights);
            }
        for (const auto& [to, value] : fresh) {
            m_grid.values[to] = value;
            m_filled[to] = 1;
        }
    }

    HeightGrid& m_grid;
    std::vector<std::uint8_t> m_filled;
    std::vector<Place> m_sources;
    int m_half = leastHalf;
};

} // namespace

bool synthesise(HeightGrid& grid) {
    return Synthesis(grid).run();
}

} // namespace solid
