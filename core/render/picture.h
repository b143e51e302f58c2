// Pictures for files: what `render`, `run --render` and the window's export draw, each at its best.
#pragma once

#include "core/base/progress.h"
#include "core/raycast/lighting.h"
#include "core/render/overlay/annotations.h"
#include "core/render/renderer.h"
#include "core/surface/surface.h"

#include <functional>

namespace render {

struct PictureOptions {
    bool rayCast = false; ///< the true surface; else splats
    double quality = 0;   ///< of cast rays, in pixels (adaptive_cast.h); 0: one for every pixel
    /// Makes what draws splats, when the first are wanted; empty: the CPU.
    std::function<std::unique_ptr<Renderer>()> renderer;
    bool smooth = true;         ///< splats: four pixels drawn for one, up to 16 million
    bool smoothRays = false;    ///< cast rays: nine for pixels at edges
    raycast::Lighting lighting; ///< of cast rays
    bool sections = false;      ///< draw the curves where the camera's clip planes meet the surface
    bool seams = false;         ///< draw the edges that stay sharp
    Annotated annotated = 0;    ///< drawn over the picture; a legend where the shading measures
    RenderOptions style;        ///< its splatScale comes on top of splatScaleOf the model
    surface::Surface reference; ///< that deviations are measured from; empty: unknown
    std::string attribute;      ///< that Shading::Attribute shows
    /// Of the colours of measured numbers; empty: automatic.
    std::optional<std::pair<float, float>> range;
};

/// What it cost, as `render --stats` tells it.
struct PictureStats {
    std::size_t rays = 0; ///< of pixels; all others are counted beside
    std::size_t pixels = 0, evaluations = 0;
    double seconds = 0;
    std::size_t edgeRays = 0;
    raycast::LightCounts light;

    PictureStats& operator+=(const PictureStats& more) {
        rays += more.rays, pixels += more.pixels, evaluations += more.evaluations, seconds += more.seconds;
        edgeRays += more.edgeRays, light += more.light;
        return *this;
    }
    std::optional<ColourScale> scale; ///< of measured numbers, where the shading shows some
};

/// Draws one model from any number of views; what they share (measured numbers, representatives, section curves, rays)
/// is made once. One thread at a time.
class PictureMaker {
  public:
    PictureMaker(surface::Surface surface, PictureOptions options);
    ~PictureMaker();
    PictureMaker(const PictureMaker&) = delete;
    PictureMaker& operator=(const PictureMaker&) = delete;

    /// Throws base::Error where the renderer is missing, the picture too large for it or for the memory;
    /// base::Cancelled.
    Image draw(const Camera& camera, PictureStats& stats, const base::Progress& progress);

  private:
    struct Kept;
    void measure(const base::Progress& progress);
    void castRays(const Camera& camera, PictureStats& stats, const base::Progress& progress, Image& out);
    void drawSplats(const Camera& camera, const base::Progress& progress, Image& out);
    void addLines(const Camera& camera, const base::Progress& progress, Image& out);

    surface::Surface m_surface;
    PictureOptions m_options;
    std::unique_ptr<Kept> m_kept;
};

/// One picture.
Image drawPicture(const surface::Surface& surface, const Camera& camera, const PictureOptions& options,
                  PictureStats& stats, const base::Progress& progress);

} // namespace render
