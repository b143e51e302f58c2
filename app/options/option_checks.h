// What values of options must be. A fault says what is wanted.
#pragma once

#include "app/options/option_set.h"

#include <string>
#include <vector>

namespace app {

/// Finite numbers. The bounds are allowed values, but for that of `above`.
Check between(double least, double most);
Check above(double least);
Check atLeast(double least);

/// A file's name for a picture: we write PNG alone.
Check pictureName();

/// One of these words.
Check oneOf(const std::vector<std::string>& words);
/// One of a table's rows, by its id.
template <class Rows>
Check idOf(const Rows& rows) {
    std::vector<std::string> ids;
    for (const auto& row : rows)
        ids.push_back(row.id);
    return oneOf(ids);
}

} // namespace app
