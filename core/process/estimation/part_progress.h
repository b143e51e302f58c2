// Progress of one part of longer work: its 0 to 1 becomes [from, to] of the whole.
#pragma once

#include "core/base/progress.h"

namespace process {

/// REQUIRES: `whole` outlives the result.
inline base::Progress part(const base::Progress& whole, double from, double to) {
    base::Progress out{{}, whole.cancel};
    if (whole.report)
        out.report = [&whole, from, to](double done, std::string_view what) {
            whole.report(from + (to - from) * done, what);
        };
    return out;
}

} // namespace process
