#include "ui/gl/backends.h"

#include "core/base/error.h"
#include "core/render/splats/cpu_splatter.h"
#include "ui/gl/offscreen_renderer.h"

namespace render {

std::unique_ptr<Renderer> makeRenderer(std::string_view backend) {
    if (backend == "cpu")
        return std::make_unique<CpuSplatter>();
    if (backend == "osmesa")
        return std::make_unique<OffscreenRenderer>(makeOsMesaContext());
    if (backend == "egl")
        return std::make_unique<OffscreenRenderer>(makeEglContext());
    throw base::Error("unknown renderer '" + std::string(backend) + "'", "", "use one of: cpu, osmesa, egl");
}

} // namespace render
