// The options of a surface definition as command parameters: the same for `surface`, `open`, `new` and every subcommand
// of the command line. Inside this room and the command line's surface option group.
#pragma once

#include "core/session/command.h"
#include "core/surface/definition_options.h"

namespace session {

/// A parameter for every option that a person chooses; all may be left out.
std::span<const CommandParameter> surfaceParameters();

struct SurfaceChange {
    surface::SurfaceDefinition definition;
    bool newSupports = false; ///< supports that a file brought must not be kept
};

/// `base` with the options that `complete` names. Throws base::Error where two of them exclude each other.
SurfaceChange changed(const surface::SurfaceDefinition& base, const nlohmann::json& complete);

/// The parameters of `own` followed by those of a surface.
std::vector<CommandParameter> withSurfaceParameters(std::span<const CommandParameter> own);

} // namespace session
