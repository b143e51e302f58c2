// The parameters of `reduce` as the core takes them: one reading for the command and for `pointclay reduce`.
#pragma once

#include "core/reduce/reduce.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

/// Of a completed command. Throws base::Error where not exactly one of count, ratio and error is given.
reduce::Wish reduceWish(const nlohmann::json& complete);

} // namespace session
