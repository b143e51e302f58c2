// What ends in exit code 2.
#pragma once

#include <stdexcept>

namespace app {

/// Options that do not go together: wrong usage.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace app
