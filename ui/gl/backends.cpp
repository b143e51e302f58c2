#include "ui/gl/backends.h"

#include "core/base/row_of_id.h"
#include "core/render/splats/cpu_splatter.h"
#include "ui/gl/offscreen_renderer.h"

namespace render {

template <auto context>
static std::unique_ptr<Renderer> offscreen() {
    return std::make_unique<OffscreenRenderer>(context());
}

static std::unique_ptr<Renderer> onTheCpu() {
    return std::make_unique<CpuSplatter>();
}

std::span<const BackendRow> backendTable() {
    static constexpr BackendRow rows[] = {
        {"cpu", onTheCpu}, {"osmesa", offscreen<makeOsMesaContext>}, {"egl", offscreen<makeEglContext>}};
    return rows;
}

std::unique_ptr<Renderer> makeRenderer(std::string_view backend) {
    return base::rowOf(backendTable(), backend, {"unknown renderer '%'", "", "use one of: %"}).make();
}

} // namespace render
