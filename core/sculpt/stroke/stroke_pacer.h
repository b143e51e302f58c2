// Keeps strokes as fast as the hand: what has come in while the engine was busy is handed on as one piece of path, and
// where even that would take too long, with dabs farther apart and as much stronger (StrokeSample::stride);
// what is held and dragged cuts corners instead.
//
// It changes samples before they are recorded, never afterwards, so that a stroke replays bit for bit however slow the
// machine was. Each of the samples it gives is a slice of work, after which pictures and Esc have their turn: long ways
// come as several.
#pragma once

#include "core/sculpt/stroke/stroke_sample.h"
#include "core/sculpt/stroke/stroke_settings.h"

#include <optional>
#include <vector>

namespace sculpt {

class StrokePacer {
  public:
    static constexpr double pieceSeconds = 0.1; ///< what one piece should take at most
    static constexpr double sliceSeconds = 0.03;

    StrokePacer() = default;
    explicit StrokePacer(const StrokeSettings& settings);

    /// What to hand to the engine for the samples that wait; their last is its last. `depth`: of the stroke's first
    /// contact along its ray, once there is one.
    std::vector<StrokeSample> paced(std::span<const StrokeSample> waiting, std::optional<float> depth);
    /// After the engine has taken some of them.
    void took(double seconds, int dabs);
    /// Of one dab, resampling included, as the last ones went; 0 before the first.
    double dabSeconds() const { return m_dabSeconds; }

  private:
    double expectedSeconds(std::span<const StrokeSample> waiting, std::optional<float> depth) const;
    double dabsBetween(const StrokeSample& a, const StrokeSample& b, float depth) const;

    StrokeSettings m_settings;
    double m_dabSeconds = 0;
    std::optional<StrokeSample> m_last; ///< given
};

} // namespace sculpt
