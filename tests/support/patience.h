// How long a test waits for what another thread does. What happens is seen at once; only a failure takes all of it, so
// it may be long enough for a machine that has ten other things to do.
#pragma once

namespace test {

inline constexpr int patience = 60000; ///< in milliseconds

} // namespace test
