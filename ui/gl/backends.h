// What splats can be drawn with on a machine without a display: the CPU, or OpenGL by way of a library found at run
// time.
#pragma once

#include "core/render/renderer.h"

#include <memory>
#include <string_view>

namespace render {

/// "cpu", "osmesa" or "egl". Throws base::Error where the machine lacks it, telling what to install.
std::unique_ptr<Renderer> makeRenderer(std::string_view backend);

} // namespace render
