// Who looks on while samples spread themselves over a surface (placement.h): a picture of it, as it goes.
//
//     reduce::WatchScope scope([](const reduce::Sites& floaters) { ... });   // at the door, as base::CancelScope
//     reduce::reduceBy(...)                                                  // tells of every round
#pragma once

#include "core/reduce/sites.h"

#include <functional>

namespace reduce {

using Watch = std::function<void(const Sites&)>;

/// While it lives, placement that its thread does tells of its samples after each round, on that thread; what is told
/// takes no part in the result. Scopes nest: the innermost is told.
class WatchScope {
  public:
    explicit WatchScope(Watch watch);
    ~WatchScope();
    WatchScope(const WatchScope&) = delete;
    WatchScope& operator=(const WatchScope&) = delete;

    /// By placement.
    static void tell(const Sites& floaters);

  private:
    Watch m_watch;
    const WatchScope* m_outer;
};

} // namespace reduce
