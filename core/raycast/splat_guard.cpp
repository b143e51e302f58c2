#include "core/raycast/splat_guard.h"

#include "core/base/parallel.h"

#include <bit>
#include <mutex>

namespace raycast {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr double discOfSpacing = 0.6, hiddenBehind = 1.5; // in spacings
constexpr int bandRows = 64;

/// The support of Wendland's weight that reaches as far, which all lengths here are measured in.
double plainSupport(const surface::SurfaceDefinition& definition, float support) {
    const double unit = static_cast<double>(surface::unitOf(definition.weight, support));
    return definition.weight == surface::Weight::Gaussian ? unit / static_cast<double>(surface::gaussianScale) : unit;
}

/// How far from the nearest surfel the surface may be, in supports: what the limit leaves of rims and holes.
double reachOf(const surface::SurfaceDefinition& definition) {
    return definition.boundaryLimit <= 0.3f && !definition.knownRims ? 0.6 : 0.8;
}

/// Counts of spacings in pixels, eight bins to an octave.
struct SpacingBins {
    static constexpr int count = 192, unit = 64; ///< the bin that begins at one pixel
    std::array<std::uint32_t, count> bins{};

    void add(double spacingPx) {
        const double bin = std::floor(8 * std::log2(spacingPx)) + unit;
        ++bins[static_cast<std::size_t>(std::clamp(bin, 0.0, count - 1.0))];
    }
    void add(const SpacingBins& more) {
        for (std::size_t i = 0; i < count; ++i)
            bins[i] += more.bins[i];
    }
    /// 1 of none.
    double median() const {
        std::uint64_t all = 0, passed = 0;
        for (const std::uint32_t n : bins)
            all += n;
        for (int i = 0; i < count; ++i)
            if ((passed += bins[static_cast<std::size_t>(i)]) * 2 > all)
                return std::exp2((i - unit + 0.5) / 8);
        return 1;
    }
};

/// Rows that a block may be seen in, with all that its surfels reach.
struct BlockRows {
    const surfel::SurfelBlock* block;
    float first, last; ///< none if first > last
};

} // namespace

/// A surfel as the image shows it.
struct SplatGuard::Disc {
    float column, row;
    float xx, xy, yy; ///< the disc is where d^T [xx xy; xy yy]^-1 d <= 1
    float hiddenFrom; ///< depth
    float reach;      ///< of the ball, pixels
};

namespace {

/// Projects surfels of one model into one view.
class Projector {
  public:
    Projector(const surface::Surface& surface, const ImageRays& view)
        : m_definition(surface.definition()), m_lens(view), m_clips(view.clips), m_reach(reachOf(m_definition)) {}

    BlockRows rowsOf(const surfel::SurfelBlock& block, int columns, int rows) const {
        const double reach = m_reach * plainSupport(m_definition, block.maxSupport());
        const base::Box3f box = block.box().inflated(static_cast<float>(reach));
        const BoxImage seen = m_lens.imageOf(box);
        if (seen.left > seen.right || seen.right < -1 || seen.left > columns)
            return {&block, 1, 0};
        const auto row = [&](double y) { return static_cast<float>(std::clamp(y, -1.0, static_cast<double>(rows))); };
        return {&block, row(seen.top - 1), row(seen.bottom + 1)};
    }

    double reach(float support) const { return m_reach * plainSupport(m_definition, support); }
    double spacing(float support) const { return surface::spacingOfUnit * plainSupport(m_definition, support); }
    const ViewLens& lens() const { return m_lens; }
    /// Do the planes keep something within `distance` of the point?
    bool kept(const Vec3d& p, double distance) const {
        return std::ranges::all_of(m_clips, [&](const base::Plane& plane) { return plane.distance(p) >= -distance; });
    }

  private:
    const surface::SurfaceDefinition& m_definition;
    ViewLens m_lens;
    std::span<const base::Plane> m_clips;
    double m_reach;
};

} // namespace

/// Marks the tiles that a ball is seen in. Rows of pixels from first to last - 1, whole tiles.
void SplatGuard::drawBall(const Disc& disc, int firstRow, int lastRow) {
    const float tile = static_cast<float>(m_tile), reachSq = disc.reach * disc.reach;
    const int top = std::max(firstRow / m_tile, static_cast<int>(std::floor((disc.row - disc.reach) / tile)));
    const int bottom = std::min((lastRow - 1) / m_tile, static_cast<int>(std::floor((disc.row + disc.reach) / tile)));
    for (int y = top; y <= bottom; ++y) {
        const float lo = static_cast<float>(y) * tile, hi = lo + tile - 1;
        const float dy = std::max({0.0f, lo - disc.row, disc.row - hi});
        const float half = std::sqrt(std::max(0.0f, reachSq - dy * dy));
        const float left = std::max(0.0f, disc.column - half), right = disc.column + half;
        if (!(right >= 0))
            continue;
        const int first = static_cast<int>(std::min(left, static_cast<float>(m_columns)) / tile);
        const int last = static_cast<int>(std::min(right, static_cast<float>(m_columns - 1)) / tile);
        std::uint8_t* row = &m_reached[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_tileColumns)];
        for (int x = first; x <= last; ++x)
            row[x] = 1;
    }
}

void SplatGuard::drawDisc(const Disc& disc, int firstRow, int lastRow) {
    const float height = std::sqrt(disc.yy);
    const int top = std::max(firstRow, static_cast<int>(std::ceil(disc.row - height)));
    const int bottom = std::min(lastRow - 1, static_cast<int>(std::floor(disc.row + height)));
    if (top > bottom)
        return;
    const float lean = disc.xy / disc.yy, width = std::max(0.0f, disc.xx - disc.xy * lean);
    for (int y = top; y <= bottom; ++y) {
        const float dy = static_cast<float>(y) - disc.row;
        const float half = std::sqrt(width * std::max(0.0f, 1 - dy * dy / disc.yy)), middle = disc.column + dy * lean;
        const int first = std::max(0, static_cast<int>(std::ceil(std::max(-1.0f, middle - half))));
        const int last = static_cast<int>(std::floor(std::min(static_cast<float>(m_columns - 1), middle + half)));
        float* row = &m_nearest[0][static_cast<std::size_t>(y) * static_cast<std::size_t>(m_columns)];
        for (int x = first; x <= last; ++x)
            row[x] = std::min(row[x], disc.hiddenFrom);
    }
}

void SplatGuard::look(const surface::Surface& surface, const ImageRays& view, int columns, int rows,
                      const base::Progress& progress) {
    m_columns = columns, m_rows = rows;
    m_tileColumns = (columns + m_tile - 1) / m_tile, m_tileRows = (rows + m_tile - 1) / m_tile;
    m_nearest.resize(static_cast<std::size_t>(std::countr_zero(unsigned(largestSquare))) + 1);
    m_nearest[0].assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), none);
    m_reached.assign(static_cast<std::size_t>(m_tileColumns) * static_cast<std::size_t>(m_tileRows), 0);
    const Projector projector(surface, view);
    std::vector<BlockRows> blocks;
    blocks.reserve(surface.tree().blockCount());
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        blocks.push_back({&block, 1, 0});
    });
    base::parallelFor(blocks.size(), 256,
                      [&](std::size_t i) { blocks[i] = projector.rowsOf(*blocks[i].block, columns, rows); });
    progress.step(0, "looking for the model");

    const ViewLens& lens = projector.lens();
    const Vec3d &u = lens.columnAxis(), &v = lens.rowAxis(), &w = lens.depthAxis();
    SpacingBins spacings;
    std::mutex guard;
    const auto surfelInBand = [&](const surfel::SurfelBlock& block, int slot, int first, int last, SpacingBins& seen) {
        const Vec3d p = base::cast<double>(block.position(slot));
        const double support = plainSupport(surface.definition(), block.support(slot));
        const double reach = projector.reach(block.support(slot));
        if (!view.clips.empty() && !projector.kept(p, reach))
            return;
        const Vec3d at = lens.project(p);
        const double pixel = lens.pixelAt(at.z), stretch = lens.stretch(at.x, at.y);
        // Balls about the eye are everywhere, and those beside it too large for what follows.
        if (!lens.parallel() && !(at.z > 0 && at.z * stretch > 2 * reach)) {
            if (distanceSq(p, lens.eye()) < 9 * reach * reach)
                std::fill_n(&m_reached[static_cast<std::size_t>(first / m_tile * m_tileColumns)],
                            static_cast<std::size_t>((last - first + m_tile - 1) / m_tile * m_tileColumns), 1);
            return;
        }
        const double perspective = lens.parallel() ? 1 : stretch * length(w); // 1 / cosine to the axis of the view
        Disc disc{};
        disc.column = static_cast<float>(at.x), disc.row = static_cast<float>(at.y);
        disc.reach = static_cast<float>(1.1 * reach / pixel * perspective) + 1;
        if (disc.row + disc.reach < static_cast<float>(first) || disc.row - disc.reach > static_cast<float>(last))
            return;
        drawBall(disc, first, last);
        if (!(at.z > 0) || (!view.clips.empty() && !projector.kept(p, 0)))
            return;
        const double s = surface::spacingOfUnit * support, radius = discOfSpacing * s;
        if (at.y >= first && at.y < last && at.x >= 0 && at.x < columns)
            seen.add(s / pixel);
        const double scale = lens.parallel() ? 1 : 1 / at.z;
        Vec3d a = (u - w * (lens.parallel() ? 0 : at.x)) * (scale * radius),
              b = (v - w * (lens.parallel() ? 0 : at.y)) * (scale * radius);
        // Rows of the projection of offsets from the centre; without their part along the normal.
        const Vec3d n = base::cast<double>(block.normal(slot));
        a -= n * dot(a, n), b -= n * dot(b, n);
        disc.xx = static_cast<float>(dot(a, a)), disc.xy = static_cast<float>(dot(a, b));
        disc.yy = static_cast<float>(dot(b, b));
        disc.hiddenFrom = static_cast<float>(at.z + hiddenBehind * s / stretch);
        if (disc.yy > 0)
            drawDisc(disc, first, last);
    };
    const std::size_t bands = base::chunkCount(static_cast<std::size_t>(rows), bandRows);
    base::parallelFor(bands, 1, [&](std::size_t band) {
        const int first = static_cast<int>(band) * bandRows, last = std::min(rows, first + bandRows);
        SpacingBins seen;
        for (const BlockRows& b : blocks)
            if (b.first <= static_cast<float>(last) && b.last >= static_cast<float>(first))
                for (int slot = 0; slot < b.block->size(); ++slot)
                    surfelInBand(*b.block, slot, first, last, seen);
        const std::lock_guard lock(guard);
        spacings.add(seen);
    });
    m_spacingPx = spacings.median();
    progress.step(0, "looking for the model");
    makeSquares();
}

void SplatGuard::makeSquares() {
    int columns = m_columns, rows = m_rows;
    for (std::size_t level = 1; level < m_nearest.size(); ++level) {
        const std::vector<float>& fine = m_nearest[level - 1];
        const int width = (columns + 1) / 2, height = (rows + 1) / 2;
        m_nearest[level].resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        base::parallelFor(static_cast<std::size_t>(height), 32, [&, columns, rows](std::size_t y) {
            const auto stride = static_cast<std::size_t>(columns);
            const float* upper = &fine[2 * y * stride];
            const float* lower = 2 * y + 1 < static_cast<std::size_t>(rows) ? upper + stride : upper;
            float* out = &m_nearest[level][y * static_cast<std::size_t>(width)];
            for (int x = 0; x < width; ++x) {
                const int left = 2 * x, right = std::min(left + 1, columns - 1);
                out[x] = std::min(std::min(upper[left], upper[right]), std::min(lower[left], lower[right]));
            }
        });
        columns = width, rows = height;
    }
}

float SplatGuard::nearest(Pixel p, int size) const {
    const auto level = static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(size)));
    const int columns = (m_columns + size - 1) / size;
    const int column = p.column >> level, row = p.row >> level;
    if (column >= columns || row >= (m_rows + size - 1) / size)
        return none;
    return m_nearest[level][static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                            static_cast<std::size_t>(column)];
}

bool SplatGuard::allReached(Pixel p, int size) const {
    for (int row = p.row; row < std::min(p.row + size, m_rows); row += m_tile)
        for (int column = p.column; column < std::min(p.column + size, m_columns); column += m_tile)
            if (!reached({column, row}))
                return false;
    return true;
}

} // namespace raycast
