// The way of the pointer since the place that was looked at last, measured in steps: the distances that dabs keep.
// Places on it do not depend on how many samples it came in.
#pragma once

#include "core/sculpt/stroke/stroke_sample.h"

#include <vector>

namespace sculpt {

class StrokeWay {
  public:
    /// From here on, measured at `depth` along the rays with steps of this length (times the stride of each sample).
    void begin(const StrokeSample& from, float depth, float step);
    void add(const StrokeSample& to);
    /// Steps up to the newest sample.
    float length() const { return m_length; }
    /// The place so many steps ahead, at most the newest sample. REQUIRES: begun.
    StrokeSample at(float steps) const;
    const StrokeSample& newest() const { return m_samples.back(); }
    /// Forgets what lies before that place.
    void leave(float steps);

  private:
    struct Place {
        std::size_t piece; ///< ends at this sample
        float u;           ///< part of it
    };
    Place placeOf(float steps) const;
    float lengthOf(std::size_t piece) const;
    void measure();

    std::vector<StrokeSample> m_samples; ///< the first is where the way begins
    float m_depth = 0, m_step = 1, m_length = 0;
};

} // namespace sculpt
