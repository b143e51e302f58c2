// The pixels of an adaptive picture: kept samples, filled from the leaves of a subdivision.
#pragma once

#include "core/base/large_memory.h"
#include "core/raycast/adaptive_cast.h"
#include "core/raycast/subdivision.h"

namespace raycast {

class AdaptivePicture {
  public:
    /// Room for so many pixels; what they hold means nothing until `show`.
    void resize(int width, int height);
    std::size_t size() const { return m_known.size(); }

    /// Writes every pixel of the splits' leaves: its ray if there is one, what was redrawn, else what its patch says.
    /// All other pixels stay, as hits. Returns the number of hits.
    std::size_t show(const CastView& view, std::span<const Split> splits);

    Sample* samples() { return m_samples.get(); }
    const Sample* samples() const { return m_samples.get(); }
    std::span<const Sample> all() const { return {m_samples.get(), m_known.size()}; }
    std::vector<Known>& known() { return m_known; }
    const std::vector<Known>& known() const { return m_known; }

  private:
    struct Release {
        void operator()(Sample* samples) const { base::freeLarge(samples); }
    };
    std::unique_ptr<Sample, Release> m_samples; ///< Sample needs no destructor
    std::vector<Known> m_known;
};

} // namespace raycast
