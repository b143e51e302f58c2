#include "ui/render/renderer.h"

#include "core/base/error.h"
#include "ui/render/cpu_splatter.h"

namespace render {

std::unique_ptr<Renderer> makeRenderer(std::string_view backend) {
    if (backend == "cpu")
        return std::make_unique<CpuSplatter>();
    throw base::Error("unknown renderer '" + std::string(backend) + "'", "", "use one of: cpu, osmesa, egl");
}

} // namespace render
