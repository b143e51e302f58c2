#include "app/reduce_report.h"

#include <nlohmann/json.hpp>

namespace app {

nlohmann::ordered_json reduceReportJson(const reduce::Report& report) {
    return {{"count", report.count},
            {"rms", report.rms},
            {"p999", report.p999},
            {"max", report.max},
            {"normals_deg", report.normalsDeg},
            {"least_supports", report.leastSupports},
            {"holes", report.holes},
            {"shapes", report.ellipsoids ? "ellipsoids" : "spheres"}};
}

} // namespace app
