// What splats can be drawn with on a machine without a display: the CPU, or OpenGL by way of a library found at run
// time. One table.
#pragma once

#include "core/render/renderer.h"

#include <memory>
#include <span>
#include <string_view>

namespace render {

struct BackendRow {
    const char* id; ///< as the command line names it
    /// Throws base::Error where the machine lacks it, telling what to install.
    std::unique_ptr<Renderer> (*make)();
};

std::span<const BackendRow> backendTable();

/// By its id; throws base::Error also where the table lacks it.
std::unique_ptr<Renderer> makeRenderer(std::string_view backend);

} // namespace render
