// What `reduce` and `refine` write with --report: one set of keys, a contract with scripts (app/README 2.5).
#pragma once

#include "core/reduce/verify.h"

#include <nlohmann/json_fwd.hpp>

namespace app {

nlohmann::ordered_json reduceReportJson(const reduce::Report& report);

} // namespace app
