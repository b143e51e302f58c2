#include "core/raycast/adaptive_picture.h"

#include "core/base/parallel.h"

#include <atomic>

namespace raycast {

static_assert(std::is_trivially_copyable_v<Sample>); // lives in memory that nobody has written yet

void AdaptivePicture::resize(int width, int height) {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (count == m_known.size())
        return;
    m_known.clear();
    m_samples.reset();
    // Left as it is: touching so much memory takes longer than many a picture, and `show` does it in parallel.
    m_samples.reset(static_cast<Sample*>(base::allocateLarge(count * sizeof(Sample))));
    m_known.assign(count, Known::Nothing);
}

namespace {

/// Writes the pixels of one split.
class SplitPainter {
  public:
    SplitPainter(const CastView& view, const Split& split, Sample* samples, Known* known)
        : m_view(view), m_split(split), m_samples(samples), m_known(known) {}

    void run() {
        if (m_split.shown && m_split.half > 1)
            m_patch = m_split.patch(m_view);
        m_split.forChildren(m_split.shown, [&](Pixel at) { paint(at, Known::Interpolated, m_split.half > 1); });
        m_split.forChildren(m_split.missed, [&](Pixel at) { paint(at, Known::Interpolated, false); });
        m_split.forChildren(m_split.open, [&](Pixel at) { paint(at, Known::Nothing, false); });
    }
    std::size_t hits() const { return m_hits; }
    std::size_t pixels() const { return m_pixels; }

  private:
    void paint(Pixel at, Known otherwise, bool between) {
        const int right = std::min(at.column + m_split.half, m_view.rays.width);
        const int bottom = std::min(at.row + m_split.half, m_view.rays.height);
        for (Pixel p = at; p.row < bottom; ++p.row) {
            Patch::Row row;
            if (between)
                row = m_patch.row(part(p.row - m_split.at.row));
            for (p.column = at.column; p.column < right; ++p.column)
                write(p, otherwise, between ? &row : nullptr);
        }
    }
    float part(int offset) const { return static_cast<float>(offset) / static_cast<float>(2 * m_split.half); }

    void write(Pixel p, Known otherwise, const Patch::Row* row) {
        const std::size_t i = static_cast<std::size_t>(p.row) * static_cast<std::size_t>(m_view.rays.width) +
                              static_cast<std::size_t>(p.column);
        ++m_pixels;
        if (m_view.lattice.redrawn(p)) {
            ++m_hits;
            return;
        }
        Sample& out = m_samples[i];
        m_known[i] = otherwise;
        if (const Sample* ray = m_view.lattice.ray(p)) {
            out = *ray;
            m_known[i] = Known::Exact;
        } else if (row)
            out = sampleOf(row->at(part(p.column - m_split.at.column)), m_patch.knots[0].behind, p.column, p.row,
                           m_view.lens, m_view.kind.attributes);
        else
            out = {};
        m_hits += out.hit.hit ? 1 : 0;
    }

    const CastView& m_view;
    const Split& m_split;
    Sample* m_samples;
    Known* m_known;
    Patch m_patch;
    std::size_t m_hits = 0, m_pixels = 0;
};

} // namespace

std::size_t AdaptivePicture::show(const CastView& view, std::span<const Split> splits) {
    std::atomic<std::size_t> hits{0}, pixels{0};
    base::parallelChunks(splits.size(), 128, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::size_t some = 0, seen = 0;
        for (std::size_t i = begin; i < end; ++i) {
            SplitPainter painter(view, splits[i], m_samples.get(), m_known.data());
            painter.run();
            some += painter.hits(), seen += painter.pixels();
        }
        hits += some, pixels += seen;
    });
    return hits + (size() - pixels);
}

} // namespace raycast
