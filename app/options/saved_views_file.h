// The views that a person has named in the window, from its settings file.
#pragma once

#include "ui/view/saved_views.h"

namespace app {

/// From the file that QSettings("pointclay", "pointclay") writes, or where that lacks them from those that it falls
/// back to. None where there are none; what is no view is left out.
std::vector<ui::SavedView> savedViews();

} // namespace app
