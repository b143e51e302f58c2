// The true surface in a view that a person works in: an adaptive ray cast whose levels grow out of the splats.
//
//     known(subject)            a frame that cannot wait: what earlier levels know of it and no edit has touched
//     refine(subject, level)    the view rests: casts rays, tells each level, up to the quality asked for
//
// Both give layers for CpuSplatter::showOver; where they know nothing the splats stay. What was cast serves the next
// view too (adaptive_cast.h). One thread at a time.
#pragma once

#include "core/raycast/adaptive_cast.h"
#include "core/raycast/lighting.h"
#include "core/render/shaded_layer.h"
#include "core/render/shading/measured_colours.h"

namespace render {

class TrueView {
  public:
    struct Subject {
        surface::Surface surface;
        Camera camera;
        RenderOptions options;                    ///< shading and backdrop count
        double quality = 1;                       ///< in pixels (adaptive_cast.h)
        raycast::Lighting lighting;               ///< comes after the surface, where it is wanted: coarsely at first
        bool smooth = false;                      ///< the last level has smooth outlines (smooth_edges.h)
        std::shared_ptr<const Measured> measured; ///< what a shading of numbers asks; else null
    };
    struct Level {
        std::shared_ptr<const ShadedLayer> layer;
        double quality = 0;
        bool complete = false; ///< the last one
    };
    using OnLevel = std::function<void(const Level&)>;

    /// Casts no ray. Null where nothing is known: the view is another than the last one refined.
    std::shared_ptr<const ShadedLayer> known(const Subject& subject);
    /// The last level has the quality of the subject. Throws base::Cancelled; what was cast by then is kept.
    void refine(const Subject& subject, const OnLevel& onLevel, const base::Progress& progress);

  private:
    Level shaded(const raycast::AdaptiveImage& image, const base::Progress& progress);
    void light(const raycast::AdaptiveImage& image, const OnLevel& onLevel, const base::Progress& progress);
    Level smoothed(const raycast::AdaptiveImage& image, const base::Progress& progress);

    std::optional<raycast::AdaptiveCast> m_cast;
    Subject m_subject;                          ///< of the layer
    std::shared_ptr<const ShadedLayer> m_layer; ///< the last level, less what edits have touched since
    std::shared_ptr<const ShadedLayer> m_lit;   ///< the same of the last with light; shown above others without
    ShadedLayer m_unlit;                        ///< the last level without light
    std::vector<raycast::Sample> m_coloured;    ///< of the last level, where numbers were measured
};

} // namespace render
