// A stroke: samples in, versions out. Mouse, tablet, script, test and replay all build the same thing.
//
// Motion::Along: dabs are `spacing` radii apart, measured between contacts on the surface. Between two samples the rays
// are interpolated and each dab's ray is intersected with the version that the dab works on; rays that miss make none.
// Motion::Drag: the first contact is held and carried along in the plane through it that faces the viewer, in steps of
// at most a tenth of the radius; pressure has no say.
// Symmetry: every mirrored ray has its own exact contact, found on the same version as the others'. Where mirrored
// brushes overlap they share the strength as Blender's feathering does: 1 / sum of (1 - distance / 2R).
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

/// Dabs closer than this (in radii) share the strength that they would have at this distance.
constexpr float usualSpacing = 0.1f;

/// A throw of base::Error for settings out of range, before anything is touched.
void check(const StrokeSettings& settings);

class Stroke {
  public:
    /// `origin`: what Symmetry mirrors at, relative to which positions are stored (io::FileModel::origin). Checks the
    /// settings.
    Stroke(surface::Surface start, StrokeSettings settings, base::Vec3d origin = {});
    ~Stroke();
    Stroke(Stroke&&) noexcept;
    Stroke& operator=(Stroke&&) noexcept;

    /// Returns true where at least one dab was made: then `surface()` is a new version. Throws base::Error for samples
    /// that are not finite or rays without direction.
    bool add(const StrokeSample& sample);
    /// The last resampling. Adding more samples afterwards is allowed and continues the stroke.
    void finish();

    const surface::Surface& surface() const;
    /// Places where the tool was applied; mirror images do not count.
    int dabs() const;
    /// Seconds that each of them took, mirror images and resampling included.
    std::span<const double> dabSeconds() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace sculpt
