#include "core/raycast/subdivision.h"

#include "core/base/parallel.h"

#include <bit>

namespace raycast {

namespace {

/// Rays between two looks at whether to go on: some milliseconds.
constexpr std::size_t raysPerStep = 4096;
/// Cells that the surface covers in part are resolved to the pixel; from this size on all their pixels at once.
constexpr int outlineCell = 4;

struct Cell {
    Pixel at;
    int size;
};

class Subdivision {
  public:
    Subdivision(const CastView& view, const SubdivisionOptions& options, CastCounts& counts,
                const base::Progress& progress)
        : m_view(view), m_options(options), m_counts(counts), m_progress(progress) {}

    std::vector<Split> run() {
        std::vector<Split> done;
        std::vector<Cell> cells = startCells();
        settleMisses(cells, done);
        for (int size = m_view.startCell; size > 1 && !cells.empty(); size /= 2) {
            if (size <= outlineCell)
                moveOutlines(cells);
            std::vector<Split> splits(cells.size());
            for (std::size_t i = 0; i < cells.size(); ++i) {
                splits[i].at = cells[i].at, splits[i].half = size / 2;
                askAround(splits[i]);
            }
            castAsked(1 - static_cast<double>(size) / m_view.startCell / 2);
            base::parallelFor(splits.size(), 128, [&](std::size_t i) { judge(splits[i]); });
            cells.clear();
            for (Split& split : splits) {
                if (m_options.onlyFirst)
                    continue;
                split.forChildren(split.open, [&](Pixel at) { cells.push_back({at, size / 2}); });
                split.open = 0;
            }
            done.insert(done.end(), splits.begin(), splits.end());
        }
        if (!m_options.onlyFirst)
            growOutlines();
        for (const Cell& cell : m_outlines)
            addOutline(cell, done);
        return done;
    }

  private:
    /// Cells of the lattice that are not known as a whole, along a curve that keeps neighbours together.
    std::vector<Cell> startCells() {
        const int size = m_view.startCell;
        const int columns = (m_view.lattice.columns() - 1) / size, rows = (m_view.lattice.rows() - 1) / size;
        int side = 1;
        while (side < std::max(columns, rows))
            side *= 2;
        std::vector<Cell> out;
        const auto visit = [&](const auto& self, int column, int row, int width) -> void {
            if (column >= columns || row >= rows)
                return;
            if (width == 1) {
                const Pixel at{column * size, row * size};
                if (!known(at, size))
                    out.push_back({at, size});
                return;
            }
            for (int i = 0; i < 4; ++i)
                self(self, column + (i & 1) * width / 2, row + (i >> 1) * width / 2, width / 2);
        };
        visit(visit, 0, 0, side);
        return out;
    }
    /// Start cells that the surface misses at their corners, and no disc is seen in, are not split.
    void settleMisses(std::vector<Cell>& cells, std::vector<Split>& done) {
        const int size = m_view.startCell;
        for (const Cell& cell : cells)
            for (int i = 0; i < 4; ++i)
                ask({cell.at.column + (i & 1) * size, cell.at.row + (i >> 1) * size});
        castAsked(0);
        std::erase_if(cells, [&](const Cell& cell) {
            for (int i = 0; i < 4; ++i) {
                const Sample* corner =
                    m_view.sampleAt({cell.at.column + (i & 1) * size, cell.at.row + (i >> 1) * size});
                if (corner && corner->hit.hit)
                    return false;
            }
            if (m_view.guard.anyDisc(cell.at, size))
                return false;
            done.push_back({cell.at, size / 2, std::numeric_limits<float>::infinity(), 0, 15, 0});
            return true;
        });
    }

    /// Was every pixel redrawn?
    bool known(Pixel at, int size) const {
        for (int row = at.row; row < std::min(at.row + size, m_view.rays.height); ++row)
            for (int column = at.column; column < std::min(at.column + size, m_view.rays.width); ++column)
                if (!m_view.lattice.redrawn({column, row}))
                    return false;
        return true;
    }

    bool hits(Pixel p) const {
        const Sample* sample = m_view.sampleAt(p);
        return sample && sample->hit.hit;
    }
    /// Cells that the surface covers in part are not split but grown into.
    void moveOutlines(std::vector<Cell>& cells) {
        const auto regular = std::stable_partition(cells.begin(), cells.end(), [&](const Cell& cell) {
            int count = 0;
            for (int i = 0; i < 4; ++i)
                count += hits({cell.at.column + (i & 1) * cell.size, cell.at.row + (i >> 1) * cell.size}) ? 1 : 0;
            return count == 4;
        });
        m_outlines.insert(m_outlines.end(), regular, cells.end());
        cells.erase(regular, cells.end());
    }
    /// Casts the pixels of outline cells that lie beside a hit, or that a disc covers, until there are no more: of the
    /// misses only those along the outline cost a ray.
    void growOutlines() {
        std::vector<std::uint32_t> wanted(m_outlines.size());
        static_assert(outlineCell * outlineCell <= 32);
        do {
            castAsked(1);
            base::parallelFor(m_outlines.size(), 256, [&](std::size_t i) { wanted[i] = wantedIn(m_outlines[i]); });
            for (std::size_t i = 0; i < wanted.size(); ++i)
                for (std::uint32_t rest = wanted[i]; rest; rest &= rest - 1)
                    ask(pixelOf(m_outlines[i], std::countr_zero(rest)));
        } while (!m_asked.empty());
    }
    static Pixel pixelOf(const Cell& cell, int i) {
        return {cell.at.column + i % cell.size, cell.at.row + i / cell.size};
    }
    std::uint32_t wantedIn(const Cell& cell) const {
        std::uint32_t out = 0;
        for (int i = 0; i < cell.size * cell.size; ++i) {
            const Pixel p = pixelOf(cell, i);
            if (m_view.lattice.open(p) &&
                (m_view.guard.anyDisc(p, 1) || hits({p.column + 1, p.row}) || hits({p.column, p.row + 1}) ||
                 (p.column > 0 && hits({p.column - 1, p.row})) || (p.row > 0 && hits({p.column, p.row - 1}))))
                out |= 1u << i;
        }
        return out;
    }
    /// As splits of two pixels, which tell every pixel by itself.
    void addOutline(const Cell& cell, std::vector<Split>& done) const {
        constexpr float bent = std::numeric_limits<float>::infinity();
        if (m_options.onlyFirst) {
            done.push_back({cell.at, cell.size / 2, bent, 0, 0, 15});
            return;
        }
        for (int y = 0; y < cell.size; y += 2)
            for (int x = 0; x < cell.size; x += 2)
                done.push_back({{cell.at.column + x, cell.at.row + y}, 1, bent, 15, 0, 0});
    }

    /// Asks for the nine samples.
    void askAround(const Split& split) {
        for (int i = 0; i < 9; ++i)
            ask({split.at.column + i % 3 * split.half, split.at.row + i / 3 * split.half});
    }
    /// Where it is neither known nor background.
    void ask(Pixel p) {
        if (!m_view.lattice.open(p))
            return;
        if (m_view.guard.reached(p)) {
            m_view.lattice.ask(p);
            m_asked.push_back(p);
        } else
            m_view.lattice.setBackground(p);
    }

    void castAsked(double done) {
        std::size_t cast = 0;
        try {
            std::vector<Sample> samples;
            while (cast < m_asked.size()) {
                m_progress.step(done, "casting rays");
                const std::size_t count = std::min(raysPerStep, m_asked.size() - cast);
                samples.resize(count);
                castPixels(m_view.surface, m_view.rays, {&m_asked[cast], count}, samples);
                for (std::size_t i = 0; i < count; ++i)
                    take(m_asked[cast + i], samples[i]);
                cast += count;
            }
        } catch (...) {
            for (; cast < m_asked.size(); ++cast)
                m_view.lattice.reopen(m_asked[cast]);
            throw;
        }
        m_asked.clear();
    }
    void take(Pixel p, const Sample& sample) {
        m_view.lattice.set(p, sample);
        ++m_counts.rays;
        m_counts.evaluations += static_cast<std::size_t>(sample.hit.evaluations);
    }

    /// What becomes of the children.
    void judge(Split& split) const {
        const Patch patch = split.patch(m_view);
        std::array<double, 9> stretch;
        for (int i = 0; i < 9; ++i)
            stretch[static_cast<std::size_t>(i)] =
                m_view.lens.stretch(split.at.column + i % 3 * split.half, split.at.row + i / 3 * split.half);
        split.error = predictionError(patch, stretch, m_view.lens, m_view.kind);
        for (int i = 0; i < 4; ++i) {
            const Pixel at = split.child(i);
            if (!m_view.inImage(at))
                continue;
            const std::size_t first = static_cast<std::size_t>(i % 2 + i / 2 * 3);
            const Knot* corners[4] = {&patch.knots[first], &patch.knots[first + 1], &patch.knots[first + 3],
                                      &patch.knots[first + 4]};
            const auto bit = static_cast<unsigned char>(1 << i);
            if (known(at, split.half))
                continue;
            (split.half == 1 ? split.shown : fateOf(split, at, corners)) |= bit;
        }
    }
    unsigned char& fateOf(Split& split, Pixel at, const Knot* const (&corners)[4]) const {
        const auto hits = std::ranges::count_if(corners, &Knot::hit);
        if (hits == 0)
            return m_view.guard.anyDisc(at, split.half) ? split.open : split.missed;
        if (hits < 4 || !goodFor(split.error, m_options.quality))
            return split.open;
        return m_view.guard.allReached(at, split.half) && !hidden(at, split.half, corners) ? split.shown : split.open;
    }
    /// Does a disc stand before what would be shown?
    bool hidden(Pixel at, int size, const Knot* const (&corners)[4]) const {
        double even[4];
        for (std::size_t i = 0; i < 4; ++i)
            even[i] = static_cast<double>(corners[i]->v[Knot::Depth]);
        const auto depth = [&](double e) { return m_view.lens.parallel() ? e : 1 / e; };
        const auto [lo, hi] = std::minmax({depth(even[0]), depth(even[1]), depth(even[2]), depth(even[3])});
        if (!(hi > static_cast<double>(m_view.guard.hiddenFrom(at, size))))
            return false;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const double x = static_cast<double>(column) / size, y = static_cast<double>(row) / size;
                const double e = (even[0] * (1 - x) + even[1] * x) * (1 - y) + (even[2] * (1 - x) + even[3] * x) * y;
                if (depth(e) > static_cast<double>(m_view.guard.hiddenFrom({at.column + column, at.row + row}, 1)))
                    return true;
            }
        return false;
    }

    const CastView& m_view;
    const SubdivisionOptions& m_options;
    CastCounts& m_counts;
    const base::Progress& m_progress;
    std::vector<Pixel> m_asked;
    std::vector<Cell> m_outlines;
};

} // namespace

const Sample* CastView::sampleAt(Pixel p) const {
    if (lattice.redrawn(p))
        return &picture[static_cast<std::size_t>(p.row) * static_cast<std::size_t>(rays.width) +
                        static_cast<std::size_t>(p.column)];
    return lattice.ray(p);
}

Knot CastView::knotAt(Pixel p) const {
    const Sample* sample = sampleAt(p);
    return sample ? Knot::of(*sample, lens, lens.stretch(p.column, p.row)) : Knot{};
}

Patch Split::patch(const CastView& view) const {
    Patch out;
    for (int i = 0; i < 9; ++i)
        out.knots[static_cast<std::size_t>(i)] = view.knotAt({at.column + i % 3 * half, at.row + i / 3 * half});
    return out;
}

std::vector<Split> subdivide(const CastView& view, const SubdivisionOptions& options, CastCounts& counts,
                             const base::Progress& progress) {
    return Subdivision(view, options, counts, progress).run();
}

int startCellFor(double spacingPx) {
    int out = 4;
    while (out < 32 && 2 * out <= 3.35 * spacingPx)
        out *= 2;
    return out;
}

} // namespace raycast
