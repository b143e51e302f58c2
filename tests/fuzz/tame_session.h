// A session that the fuzzer made, so that it can be executed by the million: paths lead to files of its own folder,
// models stay small and strokes short. What is no command stays as it is.
#pragma once

#include "core/session/document.h"

#include <string>

namespace fuzz {

/// Puts the files that sessions open and press in into the folder, and takes away what they have saved.
void putModels();
void removeSaved();
/// Lines behind the first dozen are left out.
std::string tamed(std::string_view session);
/// A sphere of some hundred surfels, to begin with.
const session::Document& smallDocument();

} // namespace fuzz
