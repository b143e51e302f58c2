#include "core/mesh/marching/cube_sizes.h"

#include <algorithm>
#include <span>

namespace mesh {

using base::Vec3d;

namespace {

constexpr double denser = 3;  ///< than cells of one size: such places would lose their shape
constexpr double squares = 3; ///< of a cell to a surfel: more cells of one size than that are too many
constexpr double wide = 1.41; ///< spacings, most of a cube's side; the least is half of that
constexpr double near = 1;    ///< spacings around a surfel

/// fn(position, spacing) for all surfels; spacings as supports tell them, which vary smoothly, but no more than lets a
/// cube fit into a wall.
template <class Fn>
void forSpacings(const surface::Surface& surface, const std::vector<float>& walls, const Fn& fn) {
    const double perUnit = SurfaceTraits(surface).spacingsPerUnit;
    std::size_t at = 0;
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot, ++at) {
            const double spacing = perUnit * double(block.support(slot));
            fn(base::cast<double>(block.position(slot)),
               walls.empty() ? spacing : std::min(spacing, double(walls[at]) / wide));
        }
    });
}

/// How often a side may be doubled that it is no more than `wide` spacings.
int doublings(double cell, double spacing) {
    return static_cast<int>(std::floor(std::log2(wide * spacing / cell)));
}

} // namespace

std::optional<CubeSizes> cubeSizesOf(const surface::Surface& surface, double median, double cell,
                                     std::vector<float> walls) {
    std::vector<double> spacings;
    forSpacings(surface, walls, [&](const Vec3d&, double spacing) { spacings.push_back(spacing); });
    if (spacings.empty() || !(median > 0))
        return {};
    constexpr std::size_t few = 200; // of so many one may be a stray
    std::sort(spacings.begin(), spacings.end());
    const std::size_t strays = spacings.size() / few;
    const double middle = walls.empty() ? spacings[spacings.size() / 2] : median;
    const double least = spacings[strays], most = spacings[spacings.size() - 1 - strays];
    double area = 0;
    for (const double each : std::span(spacings).first(spacings.size() - strays))
        area += each * each;
    if (walls.empty() && least * denser >= cell && area <= squares * cell * cell * static_cast<double>(spacings.size()))
        return {};
    // the cubes about the median are those of an even model; finer ones by halving, coarser ones by doubling
    const int finer = std::clamp(-doublings(median, least * median / middle), 0, CubeLevels::most / 2);
    const int coarser = std::clamp(doublings(median, most * median / middle), 0, CubeLevels::most / 2);
    return CubeSizes{std::ldexp(median, -finer), finer + coarser, std::move(walls)};
}

std::vector<std::vector<BrickBits>> cubesToHalve(const surface::Surface& surface, const Lattice& lattice,
                                                 const CubeSizes& sizes) {
    std::vector<std::vector<BrickBits>> wanted(std::size_t(sizes.highest) + 1);
    std::vector<std::size_t> enough(wanted.size(), 1 << 16);
    forSpacings(surface, sizes.walls, [&](const Vec3d& x, double spacing) {
        const int level = std::max(doublings(sizes.cell, spacing), 0) + 1;
        if (level > sizes.highest)
            return;
        const double side = std::ldexp(1, level), reach = near * spacing / lattice.cell;
        const Vec3d at = lattice.toGrid(x);
        const auto of = [&](double v) { return static_cast<std::int32_t>(std::floor(v / side)); };
        std::vector<BrickBits>& bits = wanted[std::size_t(level)];
        for (std::int32_t k = of(at.z - reach); k <= of(at.z + reach); ++k)
            for (std::int32_t j = of(at.y - reach); j <= of(at.y + reach); ++j)
                for (std::int32_t i = of(at.x - reach); i <= of(at.x + reach); ++i)
                    bits.push_back(bitsOf({i, j, k}));
        if (std::size_t& most = enough[std::size_t(level)]; bits.size() > most) {
            joinBits(bits);
            most = 2 * bits.size() + (1 << 16);
        }
    });
    return wanted;
}

} // namespace mesh
