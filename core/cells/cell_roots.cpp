#include "core/cells/cell_roots.h"

namespace cells {

using surface::Need;

template <class Source>
void CellRoots<Source>::find(const Stretch& stretch, std::vector<double>& out) {
    m_cell = stretch.cell;
    m_source.setScale(stretch.unit);
    double t = 0;
    if (stretch.monotone() && newton(stretch, t)) {
        if (t >= stretch.begin && t <= stretch.end)
            out.push_back(t);
        return;
    }
    march(stretch, out);
}

/// Plain Newton, the step no longer than half a support. False where it leaves the stretch or does not settle.
template <class Source>
bool CellRoots<Source>::newton(const Stretch& stretch, double& t) {
    constexpr int most = 24;
    const double margin = 0.2 * stretch.unit;
    t = std::clamp(stretch.guess, stretch.first, stretch.last);
    for (int k = 0; k < most; ++k) {
        m_source.moveTo(m_ray.at(t));
        const std::size_t i = m_source.find(m_cell);
        ++m_evaluations;
        if (i == Source::none)
            return false;
        const auto& at = m_source.at(i, Need::Gradient);
        const double slope = valid(at) ? dot(at.gradient, m_ray.direction) : 0;
        if (!(std::abs(slope) > 0.05))
            return false;
        const double step = std::clamp(-at.value / slope, -0.5 * at.unit, 0.5 * at.unit);
        t += step;
        if (t < stretch.begin - margin || t > stretch.end + margin)
            return false;
        if (std::abs(step) <= Source::settled * at.unit + rounding(t))
            return true;
    }
    return false;
}

template <class Source>
auto CellRoots<Source>::sample(double t) -> Sample {
    m_source.moveTo(m_ray.at(t));
    const std::size_t i = m_source.find(m_cell);
    ++m_evaluations;
    if (i == Source::none)
        return {t, 0, false};
    const auto& at = m_source.at(i, Need::Value);
    return {t, at.value, valid(at)};
}

template <class Source>
void CellRoots<Source>::march(const Stretch& stretch, std::vector<double>& out) {
    constexpr double stepOfUnit = 1.0 / 12, dip = 0.6; // of the support; of a step, below which zeros may be in pairs
    constexpr int finer = 8, longest = 4;
    constexpr double leastSpan = 1.5; // steps to a zero, at least: f over the step times this
    const double span = stretch.last - stretch.first;
    const int steps = std::max(2, static_cast<int>(std::min(std::ceil(span / (stepOfUnit * stretch.unit)), 1e6)));
    const double step = span / steps;
    Sample before, last = sample(stretch.first);
    int stride = 1; // in steps, since the sample before
    for (int k = 1; k <= steps; k += stride) {
        const int passed = stride;
        const Sample next = sample(stretch.first + k * step);
        if (last.valid && next.valid && (last.f > 0) != (next.f > 0)) {
            refine(last, next, stretch.unit, out);
        } else if (k > 1 && passed == 1 && before.valid && last.valid && next.valid && std::abs(last.f) < dip * step &&
                   std::abs(last.f) <= std::abs(before.f) && std::abs(last.f) <= std::abs(next.f)) {
            Sample a = last.t - before.t < 1.5 * step ? before : sample(last.t - step);
            const double begin = a.t;
            for (int m = 1; m <= 2 * finer; ++m) {
                const Sample b = sample(begin + m * step / finer);
                if (a.valid && b.valid && (a.f > 0) != (b.f > 0))
                    refine(a, b, stretch.unit, out);
                a = b;
            }
        }
        before = last;
        last = next;
        // f hardly falls faster than by the way: far from zero there is none within the next steps
        stride = next.valid ? std::clamp(static_cast<int>(std::abs(next.f) / (leastSpan * step)), 1, longest) : 1;
        if (k < steps && k + stride > steps)
            stride = steps - k;
    }
    std::sort(out.begin(), out.end());
}

/// False position after Illinois, halving where that is slow.
template <class Source>
void CellRoots<Source>::refine(Sample a, Sample b, double unit, std::vector<double>& out) {
    constexpr int most = 80;
    constexpr double jump = 0.02; // of the support: larger where the interval has shrunk to nothing is no zero
    double fa = a.f, fb = b.f;
    for (int k = 0; k < most && b.t - a.t > Source::precision * unit + rounding(b.t); ++k) {
        double t = k % 4 == 3 ? (a.t + b.t) / 2 : (a.t * fb - b.t * fa) / (fb - fa);
        if (!(t > a.t && t < b.t))
            t = (a.t + b.t) / 2;
        const Sample mid = sample(t);
        if (!mid.valid)
            return;
        if (mid.f == 0) {
            a = b = mid;
            break;
        }
        if ((mid.f > 0) == (a.f > 0)) {
            a = mid;
            fa = mid.f;
            fb /= 2;
        } else {
            b = mid;
            fb = mid.f;
            fa /= 2;
        }
    }
    if (std::min(std::abs(a.f), std::abs(b.f)) > jump * unit)
        return;
    out.push_back(std::abs(a.f) < std::abs(b.f) ? a.t : b.t);
}

template class CellRoots<CellSource>;
template class CellRoots<CellSourcef>;

} // namespace cells
