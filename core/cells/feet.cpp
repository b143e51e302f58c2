#include "core/cells/feet.h"

#include "core/base/mat3.h"

namespace cells {

using base::Vec3d;
using surface::Evaluationd;
using surface::Need;

namespace {

constexpr double longestStep = 0.7;  ///< of h
constexpr double leastSinSq = 0.01;  ///< of the angle at a seam
constexpr double leastVolume = 0.05; ///< of the normals at a corner

} // namespace

bool Feet::evaluate(std::span<const std::uint32_t> cells, const Vec3d& y) {
    m_source.moveTo(y);
    m_at.clear();
    for (const std::uint32_t cell : cells) {
        const std::size_t i = m_source.find(cell);
        if (i == CellSource::none)
            return false;
        const Evaluationd& at = m_source.at(i, Need::Gradient);
        ++m_evaluations;
        if (!valid(at) || !(lengthSq(at.gradient) > 1e-4))
            return false;
        m_at.push_back(at);
    }
    return true;
}

template <class Step>
std::optional<Vec3d> Feet::iterate(std::span<const std::uint32_t> cells, Vec3d y, const Step& step) {
    const int most = 2 * m_options.maxIterations;
    double before = std::numeric_limits<double>::infinity();
    double relaxed = 1;
    for (int k = 0; k < most; ++k) {
        if (!evaluate(cells, y))
            return std::nullopt;
        const std::optional<Vec3d> next = step(y);
        if (!next)
            return std::nullopt;
        ++m_iterations;
        Vec3d way = *next - y;
        const double unit = m_at.front().unit, far = length(way);
        const double tolerance = (m_options.tolerance > 0 ? m_options.tolerance : 1e-12) * unit +
                                 8 * std::numeric_limits<double>::epsilon() * length(y);
        if (far <= tolerance)
            return *next;
        // plain steps swing from one side to the other where the distance is as large as the radius of curvature
        if (far > 0.9 * before)
            relaxed = std::max(relaxed / 2, 1.0 / 16);
        before = far;
        way *= std::min(relaxed, longestStep * unit / far);
        y += way;
    }
    return std::nullopt;
}

std::optional<Vec3d> Feet::face(std::uint32_t cell, const Vec3d& start) {
    return iterate({&cell, 1}, start, [&](const Vec3d& y) -> std::optional<Vec3d> {
        const Evaluationd& at = m_at.front();
        switch (m_options.projector) {
        case surface::Projector::Basic:
            return y - at.normal * at.value;
        case surface::Projector::Almost:
            return m_x - at.normal * (at.value + dot(at.normal, m_x - y));
        case surface::Projector::Orthogonal:
            break;
        }
        return m_x - at.gradient * ((at.value + dot(at.gradient, m_x - y)) / lengthSq(at.gradient));
    });
}

std::optional<Vec3d> Feet::seam(std::uint32_t a, std::uint32_t b, const Vec3d& start) {
    const std::uint32_t pair[] = {a, b};
    return iterate(pair, start, [&](const Vec3d& y) -> std::optional<Vec3d> {
        const Vec3d &g = m_at[0].gradient, &h = m_at[1].gradient;
        const double gg = lengthSq(g), hh = lengthSq(h), gh = dot(g, h), det = gg * hh - gh * gh;
        if (!(det > leastSinSq * gg * hh))
            return std::nullopt;
        const double u = m_at[0].value + dot(g, m_x - y), v = m_at[1].value + dot(h, m_x - y);
        return m_x - g * ((hh * u - gh * v) / det) - h * ((gg * v - gh * u) / det);
    });
}

std::optional<Vec3d> Feet::corner(std::span<const std::uint32_t> cells, const Vec3d& start) {
    return iterate(cells, start, [&](const Vec3d& y) -> std::optional<Vec3d> {
        base::Mat3d squares;
        Vec3d right;
        for (const Evaluationd& at : m_at) {
            const double slope = length(at.gradient);
            const Vec3d g = at.gradient / slope;
            squares += base::outer(g, g);
            right += g * (at.value / slope);
        }
        if (!(base::determinant(squares) > leastVolume * leastVolume)) // of three: the square of their volume
            return std::nullopt;
        return y - base::inverse(squares) * right;
    });
}

} // namespace cells
