// What values of options must be, beyond what the library checks: it lets pass what is not a number ("nan"). A fault
// says what is wanted.
#pragma once

#include <CLI/CLI.hpp>

namespace app {

/// Finite numbers. The bounds are allowed values, but for that of `above`.
CLI::Validator between(double least, double most);
CLI::Validator above(double least);
CLI::Validator atLeast(double least);

/// A file's name for a picture: we write PNG alone.
CLI::Validator pictureName();

/// One of a table's rows, by its id.
template <class Rows>
CLI::Validator idOf(const Rows& rows) {
    std::vector<std::string> ids;
    for (const auto& row : rows)
        ids.push_back(row.id);
    return CLI::IsMember(ids);
}

} // namespace app
