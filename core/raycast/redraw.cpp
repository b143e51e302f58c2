#include "core/raycast/redraw.h"

#include "core/base/parallel.h"

#include <atomic>

namespace raycast {

namespace {

using base::Vec3d, base::Vec3f;

constexpr int bandRows = 64;
constexpr float flattest = 0.05f; ///< cosine between normal and ray, at least
constexpr float pixelDiagonal = 1.42f;
constexpr float mostStretched = 1.5f, mostMagnified = 4; ///< of a pixel's cell; of those that lie still
constexpr float stillBent = 8;                           ///< prediction errors of cells that must not be magnified
constexpr float squareSide = 4;                          ///< pixels
constexpr float overlap = 0.02f; ///< pixels: no gaps between squares of patches that are split differently

/// A point of a patch in the new view.
struct Corner {
    float column = 0, row = 0, even = 0;
    float u = 0, v = 0; ///< in the patch
    bool faces = false;
};

/// Which point of which patch a pixel shows.
struct Fragment {
    float order = std::numeric_limits<float>::infinity(); ///< smaller is nearer
    std::uint32_t quarter = 0;                            ///< of all patches
    float u = 0, v = 0;
};

/// Rows that a patch's samples are seen in.
struct Rows {
    float first = 1, last = 0;
};

class PatchProjector {
  public:
    explicit PatchProjector(const CastView& view) : m_lens(view.lens), m_forward(normalized(view.rays.corner)) {}

    Vec3d projected(const Vec3f& p) const { return m_lens.project(base::cast<double>(p)); }

    Corner corner(const KeptPatch::Values& k, float u, float v) const {
        const Vec3f p{k[KeptPatch::X], k[KeptPatch::Y], k[KeptPatch::Z]};
        const Vec3f n = normalized(Vec3f{k[KeptPatch::NormalX], k[KeptPatch::NormalY], k[KeptPatch::NormalZ]});
        const Vec3d at = projected(p);
        const Vec3d toIt = m_lens.parallel() ? m_forward : normalized(base::cast<double>(p) - m_lens.eye());
        return {static_cast<float>(at.x),
                static_cast<float>(at.y),
                static_cast<float>(m_lens.evenDepth(at.z)),
                u,
                v,
                at.z > 0 && -dot(n, base::cast<float>(toIt)) >= flattest};
    }
    Rows rowsOf(const KeptPatch& patch) const {
        Rows out{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
        for (std::size_t i = 0; i < 9; ++i) {
            if (!(patch.knots[i][KeptPatch::Unit] > 0))
                continue;
            const Vec3d at = projected(patch.position(i));
            if (!(at.z > 0))
                return {};
            out.first = std::min(out.first, static_cast<float>(at.y));
            out.last = std::max(out.last, static_cast<float>(at.y));
        }
        const float slack = 1 + 0.25f * (out.last - out.first); // curves bulge beyond their samples
        return {out.first - slack, out.last + slack};
    }

  private:
    const ViewLens& m_lens;
    Vec3d m_forward;
};

/// Draws patches into some rows.
class Band {
  public:
    Band(const CastView& view, const PatchProjector& projector, int first, int last)
        : m_view(view), m_projector(projector), m_first(first), m_last(last), m_width(view.rays.width),
          m_fragments(static_cast<std::size_t>(last - first) * static_cast<std::size_t>(m_width)) {}

    void draw(const KeptPatch& patch, std::uint32_t number) {
        for (unsigned i = 0; i < 4; ++i)
            if (m_number = 4 * number + i; patch.shown >> i & 1)
                drawQuarter(patch, i % 2 + i / 2 * 3);
    }

    template <class Fn>
    void forFragments(const Fn& fn) const {
        for (std::size_t i = 0; i < m_fragments.size(); ++i)
            if (m_fragments[i].order < std::numeric_limits<float>::infinity())
                fn(Pixel{static_cast<int>(i % static_cast<std::size_t>(m_width)),
                         m_first + static_cast<int>(i / static_cast<std::size_t>(m_width))},
                   m_fragments[i]);
    }

  private:
    Corner corner(const KeptPatch& patch, float u, float v) const {
        return m_projector.corner(patch.at(u, v, m_number % 4), u, v);
    }

    void drawQuarter(const KeptPatch& patch, std::size_t first) {
        Corner ends[4];
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t knot = first + i % 2 + i / 2 * 3;
            ends[i] = m_projector.corner(patch.knots[knot], 0.5f * static_cast<float>(knot % 3),
                                         0.5f * static_cast<float>(knot / 3));
        }
        for (const Corner& end : ends)
            if (!end.faces)
                return;
        const auto span = [&](int a, int b) {
            return std::hypot(ends[a].column - ends[b].column, ends[a].row - ends[b].row);
        };
        const float diagonal = std::max(span(0, 3), span(1, 2));
        const bool bent = patch.half == 1 && !(patch.error < stillBent);
        if (diagonal > static_cast<float>(patch.half) * pixelDiagonal * mostStretched * (bent ? 1 : mostMagnified))
            return;
        const int n = patch.half == 1 ? 1 : std::max(1, static_cast<int>(diagonal / (pixelDiagonal * squareSide)) + 1);
        if (n == 1)
            drawSquare(ends[0], ends[1], ends[2], ends[3]);
        else
            drawGrid(patch, ends[0].u, ends[0].v, n);
    }

    void drawGrid(const KeptPatch& patch, float u, float v, int n) {
        const float step = 0.5f / static_cast<float>(n);
        const auto row = [&](int y, std::vector<Corner>& out) {
            out.resize(static_cast<std::size_t>(n) + 1);
            for (int x = 0; x <= n; ++x)
                out[static_cast<std::size_t>(x)] =
                    corner(patch, u + step * static_cast<float>(x), v + step * static_cast<float>(y));
        };
        row(0, m_upper);
        for (int y = 1; y <= n; ++y, std::swap(m_upper, m_lower)) {
            row(y, m_lower);
            for (std::size_t x = 0; x < static_cast<std::size_t>(n); ++x)
                if (m_upper[x].faces && m_upper[x + 1].faces && m_lower[x].faces && m_lower[x + 1].faces)
                    drawSquare(m_upper[x], m_upper[x + 1], m_lower[x], m_lower[x + 1]);
        }
    }

    void drawSquare(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
        drawTriangle(a, b, c);
        drawTriangle(b, d, c);
    }

    void drawTriangle(const Corner& a, const Corner& b, const Corner& c) {
        const float area = (b.column - a.column) * (c.row - a.row) - (c.column - a.column) * (b.row - a.row);
        if (area == 0)
            return;
        const auto [left, right] = std::minmax({a.column, b.column, c.column});
        const auto [top, bottom] = std::minmax({a.row, b.row, c.row});
        const int firstRow = std::max(m_first, static_cast<int>(std::ceil(top - overlap)));
        const int lastRow = std::min(m_last - 1, static_cast<int>(std::floor(bottom + overlap)));
        const int firstColumn = std::max(0, static_cast<int>(std::ceil(left - overlap)));
        const int lastColumn = std::min(m_width - 1, static_cast<int>(std::floor(right + overlap)));
        // Weights of b and c; each is less than zero by its slope times the overlap at most.
        const float bx = (c.row - a.row) / area, by = -(c.column - a.column) / area;
        const float cx = -(b.row - a.row) / area, cy = (b.column - a.column) / area;
        const float bLeast = -overlap * (std::abs(bx) + std::abs(by)),
                    cLeast = -overlap * (std::abs(cx) + std::abs(cy)), aLeast = bLeast + cLeast;
        for (int y = firstRow; y <= lastRow; ++y)
            for (int x = firstColumn; x <= lastColumn; ++x) {
                const float dx = static_cast<float>(x) - a.column, dy = static_cast<float>(y) - a.row;
                const float wb = bx * dx + by * dy, wc = cx * dx + cy * dy, wa = 1 - wb - wc;
                if (wb >= bLeast && wc >= cLeast && wa >= aLeast)
                    write(x, y, wa * a.even + wb * b.even + wc * c.even, wa * a.u + wb * b.u + wc * c.u,
                          wa * a.v + wb * b.v + wc * c.v);
            }
    }

    void write(int x, int y, float even, float u, float v) {
        Fragment& out = m_fragments[static_cast<std::size_t>(y - m_first) * static_cast<std::size_t>(m_width) +
                                    static_cast<std::size_t>(x)];
        const float order = m_view.lens.parallel() ? even : -even;
        if (order < out.order)
            out = {order, m_number, u, v};
    }

    const CastView& m_view;
    const PatchProjector& m_projector;
    int m_first, m_last, m_width;
    std::uint32_t m_number = 0;
    std::vector<Fragment> m_fragments;
    std::vector<Corner> m_upper, m_lower;
};

} // namespace

std::vector<std::uint8_t> redraw(const KeptPatches& patches, const CastView& view, double quality,
                                 AdaptivePicture& picture) {
    const std::span<const KeptPatch> all = patches.all();
    const PatchProjector projector(view);
    std::vector<std::uint8_t> seen(all.size(), 0);
    std::vector<Rows> rows(all.size());
    base::parallelFor(all.size(), 256, [&](std::size_t i) {
        if (all[i].half == 1 || goodFor(all[i].error, quality))
            rows[i] = projector.rowsOf(all[i]);
    });
    const auto height = static_cast<std::size_t>(view.rays.height);
    base::parallelFor(base::chunkCount(height, bandRows), 1, [&](std::size_t part) {
        const int first = static_cast<int>(part) * bandRows, last = std::min(view.rays.height, first + bandRows);
        Band band(view, projector, first, last);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (rows[i].first <= static_cast<float>(last) && rows[i].last >= static_cast<float>(first))
                band.draw(all[i], static_cast<std::uint32_t>(i));
        band.forFragments([&](Pixel p, const Fragment& fragment) {
            const KeptPatch& patch = all[fragment.quarter / 4];
            const float even = view.lens.parallel() ? fragment.order : -fragment.order;
            const double depth = view.lens.parallel() ? static_cast<double>(even) : 1 / static_cast<double>(even);
            std::atomic_ref(seen[fragment.quarter / 4]).store(1, std::memory_order_relaxed);
            if (!view.lattice.open(p) || !view.guard.reached(p) ||
                depth > static_cast<double>(view.guard.hiddenFrom(p, 1)))
                return;
            const std::size_t i = static_cast<std::size_t>(p.row) * static_cast<std::size_t>(view.rays.width) +
                                  static_cast<std::size_t>(p.column);
            const KeptPatch::Values v = patch.at(fragment.u, fragment.v, fragment.quarter % 4);
            picture.samples()[i] = sampleOf({even, v[KeptPatch::NormalX], v[KeptPatch::NormalY], v[KeptPatch::NormalZ],
                                             v[KeptPatch::Unit], v[KeptPatch::Agreement], v[KeptPatch::Red],
                                             v[KeptPatch::Green], v[KeptPatch::Blue], v[KeptPatch::Mask], 0, 0},
                                            patch.behind, p.column, p.row, view.lens, view.kind.attributes);
            picture.known()[i] = Known::Interpolated;
            view.lattice.setRedrawn(p, patch.generation + 1);
        });
    });
    return seen;
}

} // namespace raycast
