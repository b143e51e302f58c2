// Surfels taken out of a version, and what follows for those that stay.
#pragma once

#include "core/surface/surface.h"

namespace process {

enum class Supports { WhereChanged, Everywhere };

/// Without the surfels of which `removed`, in tree order, is true. Where one of a surfel's 12 nearest went, or
/// everywhere, its support is made anew by the definition; so is the boundary limit if the definition leaves it to the
/// model. Other surfels keep every bit. Throws base::Error where fewer than 4 are left, base::Cancelled.
surface::Surface takenOut(const surface::Surface& before, std::vector<std::uint8_t> removed, Supports supports,
                          const base::Progress& progress = {});

} // namespace process
