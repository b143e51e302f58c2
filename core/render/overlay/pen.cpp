#include "core/render/overlay/pen.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

struct Span {
    int begin, end;
};

Span pixels(float low, float high, float reach, Span within) {
    const auto inside = [&](float value) {
        return static_cast<int>(std::clamp(value, static_cast<float>(within.begin), static_cast<float>(within.end)));
    };
    return {inside(low - reach), inside(high + reach + 1)};
}

/// Floats cannot tell how near a pixel is to a line whose ends are very far away: such a line is cut to what lies
/// around any image.
PenLine nearby(const PenLine& line) {
    constexpr double far = 1e5;
    const double x = double(line.from.x), y = double(line.from.y), dx = double(line.to.x) - x,
                 dy = double(line.to.y) - y;
    double begin = 0, end = 1;
    const auto cut = [&](double place, double step, double side) { // keeps side * (place + t step) <= far
        const double room = far - side * place, rate = side * step;
        if (rate > 0)
            end = std::min(end, room / rate);
        else if (rate < 0)
            begin = std::max(begin, room / rate);
        else if (room < 0)
            end = -1;
    };
    for (const double side : {-1.0, 1.0})
        cut(x, dx, side), cut(y, dy, side);
    if (begin == 0 && end == 1)
        return line;
    const auto at = [&](double t) { return ImagePoint{float(x + t * dx), float(y + t * dy)}; };
    constexpr auto away = static_cast<float>(-2 * far);
    return begin < end ? PenLine{at(begin), at(end)} : PenLine{{away, away}, {away, away}};
}

float distance(const PenLine& line, float x, float y) {
    const ImagePoint a = line.from;
    const float dx = line.to.x - a.x, dy = line.to.y - a.y, length = dx * dx + dy * dy;
    const float t = length > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length, 0.0f, 1.0f) : 0;
    return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}

/// Rows of an image, with each pixel's distance to the nearest line.
class Band {
  public:
    Band(Span rows, int width)
        : m_rows(rows), m_width(width),
          m_away(static_cast<std::size_t>(rows.end - rows.begin) * static_cast<std::size_t>(width),
                 std::numeric_limits<float>::infinity()) {}

    void add(const PenLine& line, float reach) {
        const auto [left, right] = std::minmax(line.from.x, line.to.x);
        const auto [top, bottom] = std::minmax(line.from.y, line.to.y);
        const Span columns = pixels(left, right, reach, {0, m_width}), rows = pixels(top, bottom, reach, m_rows);
        for (int y = rows.begin; y < rows.end; ++y)
            for (int x = columns.begin; x < columns.end; ++x) {
                float& away = m_away[at(x, y - m_rows.begin)];
                away = std::min(away, distance(line, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
            }
    }
    void paint(float reach, const Ink& ink, Image& out) const {
        surfel::Colour* colours = out.colour.data() + at(0, m_rows.begin);
        for (std::size_t i = 0; i < m_away.size(); ++i)
            if (m_away[i] < reach)
                colours[i] = ink(colours[i], m_away[i]);
    }

  private:
    std::size_t at(int x, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    }
    Span m_rows;
    int m_width;
    std::vector<float> m_away;
};

constexpr int bandHeight = 32;

} // namespace

void draw(std::span<const PenLine> asked, float reach, const Ink& ink, Image& out) {
    std::vector<PenLine> lines(asked.size());
    std::transform(asked.begin(), asked.end(), lines.begin(), nearby);
    float top = std::numeric_limits<float>::infinity(), bottom = -top;
    for (const PenLine& line : lines) {
        top = std::min({top, line.from.y, line.to.y});
        bottom = std::max({bottom, line.from.y, line.to.y});
    }
    if (lines.empty())
        return;
    const Span all = pixels(top, bottom, reach, {0, out.height});
    const auto bands = static_cast<std::size_t>((all.end - all.begin + bandHeight - 1) / bandHeight);
    base::parallelFor(bands, 1, [&](std::size_t k) {
        const int begin = all.begin + static_cast<int>(k) * bandHeight;
        Band band({begin, std::min(begin + bandHeight, all.end)}, out.width);
        for (const PenLine& line : lines)
            band.add(line, reach);
        band.paint(reach, ink, out);
    });
}

float covered(float width, float distance) {
    return std::clamp(0.5f + 0.5f * width - distance, 0.0f, 1.0f);
}

surfel::Colour inked(surfel::Colour pixel, const base::Vec3f& colour, float cover) {
    const float under = static_cast<float>(pixel >> 24) / 255 * (1 - cover), alpha = cover + under;
    if (!(alpha > 0))
        return pixel;
    surfel::Colour out = static_cast<surfel::Colour>(alpha * 255 + 0.5f) << 24;
    for (std::size_t k = 0; k < 3; ++k) {
        const float old = static_cast<float>(pixel >> (8 * k) & 255u);
        out |= static_cast<surfel::Colour>((255 * colour[k] * cover + old * under) / alpha + 0.5f) << (8 * k);
    }
    return out;
}

} // namespace render
