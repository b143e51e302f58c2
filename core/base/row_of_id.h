// The row of a table that has an id, or an error that names them all.
#pragma once

#include "core/base/error.h"

#include <string>
#include <string_view>

namespace base {

template <class Rows>
const auto& rowOf(const Rows& rows, const char* what, std::string_view id) {
    std::string known;
    for (const auto& row : rows) {
        if (row.id == id)
            return row;
        known += (known.empty() ? "" : ", ") + std::string(row.id);
    }
    throw Error("unknown " + std::string(what) + " '" + std::string(id) + "'", "", "use one of: " + known);
}

} // namespace base
