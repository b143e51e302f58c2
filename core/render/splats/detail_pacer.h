// How coarse a moving view may be so that its frames keep to a budget: a controller from measured times to
// RenderOptions::detailPx.
//
//     options.detailPx = pacer.moving();                 a view that moves
//     options.detailPx = pacer.settling(last drawn);     it rests: finer from frame to frame, down to restPx
//     pacer.drew(options.detailPx, seconds);             after each frame of the whole picture
//
// Detail comes in steps of the tree's levels: what was too slow is not tried again for a while, else the picture would
// flicker between two levels.
#pragma once

#include <algorithm>
#include <cmath>

namespace render {

class DetailPacer {
  public:
    static constexpr float restPx = 1, mostPx = 8;

    explicit DetailPacer(double budgetSeconds) : m_budget(budgetSeconds) {}

    float moving() const { return m_detail; }
    float settling(float last) const { return std::max(restPx, 0.5f * last); }
    /// Even the coarsest detail takes too long: only fewer pixels help.
    bool overwhelmed() const { return m_overwhelmed; }

    void drew(float detailPx, double seconds) {
        constexpr float same = 1.01f, step = 0.85f, forget = 0.999f;
        m_tooFine *= forget;
        if (detailPx * same >= mostPx)
            m_overwhelmed = seconds > 1.5 * m_budget;
        // One slow frame among others says more about the machine than about the detail.
        const bool slow = seconds > m_budget && (m_previous > m_budget || seconds > 3 * m_budget);
        m_previous = seconds;
        if (slow) {
            m_tooFine = std::max(m_tooFine, detailPx);
            const auto factor = static_cast<float>(std::clamp(std::sqrt(seconds / m_budget), 1.0 / 0.85, 3.0));
            if (detailPx * same >= m_detail)
                m_detail = std::min(mostPx, detailPx * factor);
        } else if (detailPx <= restPx && seconds <= m_budget) {
            m_detail = restPx, m_tooFine = 0;
        } else if (seconds < 0.7 * m_budget && detailPx * step > 1.1f * m_tooFine) {
            m_detail = std::max(restPx, std::min(m_detail, detailPx * step));
        }
    }

  private:
    double m_budget;
    double m_previous = 0; ///< seconds of the last frame
    float m_detail = restPx;
    float m_tooFine = 0; ///< finest detail that is known to be too slow
    bool m_overwhelmed = false;
};

} // namespace render
