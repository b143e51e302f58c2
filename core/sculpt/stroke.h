// A stroke: samples in, versions out. Mouse, tablet, script, test and replay all build the same thing.
//
// The result depends on the settings and the samples alone, never on time or on how many samples came at once, so that
// a recorded stroke replays bit for bit. The caller shows `surface()` whenever it likes; dropping the Stroke undoes it.
//
//     Stroke stroke(surface, settings);
//     for each sample: stroke.add(sample);      contacts, spacing, symmetry, dabs, resampling
//     stroke.finish();                          the last resampling
//     use stroke.surface()
#pragma once

#include "core/sculpt/tool.h"

#include <memory>

namespace sculpt {

struct StrokeSample {
    base::Rayf ray;     ///< through the pointer, in model coordinates relative to the origin; any direction length > 0
    float pressure = 1; ///< 0 to 1
    float seconds = 0;  ///< since the stroke began
    bool operator==(const StrokeSample& o) const {
        return ray.origin == o.ray.origin && ray.direction == o.ray.direction && pressure == o.pressure &&
               seconds == o.seconds;
    }
};

struct Symmetry {
    bool x = false, y = false, z = false; ///< mirrored at the coordinate planes of the file's coordinates
    bool operator==(const Symmetry&) const = default;
};

struct StrokeSettings {
    std::string tool = "draw";
    float radius = 0;      ///< model units; REQUIRES > 0
    float strength = 0.5f; ///< 0 to 1
    bool invert = false;
    Falloff falloff = Falloff::Smooth;
    Symmetry symmetry;
    bool resample = true;                     ///< let the sampling follow the deformation
    float spacing = 0.1f;                     ///< distance of dabs as a part of the radius
    std::map<std::string, double> parameters; ///< the tool's own; missing ones take their defaults
    bool operator==(const StrokeSettings&) const = default;
};

/// A throw of base::Error for settings out of range, before anything is touched.
void check(const StrokeSettings& settings);

class Stroke {
  public:
    /// `origin`: what Symmetry mirrors at, relative to which positions are stored (io::FileModel::origin).
    Stroke(surface::Surface start, StrokeSettings settings, base::Vec3d origin = {});
    ~Stroke();
    Stroke(Stroke&&) noexcept;
    Stroke& operator=(Stroke&&) noexcept;

    /// Returns true where at least one dab was made: then `surface()` is a new version.
    bool add(const StrokeSample& sample);
    void finish();

    const surface::Surface& surface() const;
    int dabs() const;
    /// Seconds that each dab took, resampling included.
    std::span<const double> dabSeconds() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace sculpt
