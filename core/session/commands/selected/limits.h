// What a command changes: what is selected, where anything is, or the whole model. Inside this room.
#pragma once

#include "core/selection/affine.h"
#include "core/session/command.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

constexpr const char* limits = "auto selection all";
constexpr const char* limitTip = "what is changed; auto: what is selected, all where nothing is";
constexpr const char* limitFallback = "\"auto\"";

/// By the parameter "of". Throws base::Error where it asks for a selection and there is none.
selection::Limit limitOf(const Context& context, const nlohmann::json& complete);

/// A step in which what is under the limit was moved: layers go along with a whole model; a part goes into the active
/// layer, or takes those below along.
void commitMoved(Context& context, const selection::Affine& map, selection::Limit limit, const std::string& label);

/// Throws base::Error where the model is a curve, which has no sides and no areas.
void requireSurface(const Context& context);
/// Throws base::Error where nothing is selected.
void requireSelection(const Context& context);

} // namespace session
