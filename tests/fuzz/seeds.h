// Inputs to begin with that are no text, FOLDER/TARGET/NAME, and the words of sessions, FOLDER/session.dict. What is
// text lies in tests/fuzz.
#pragma once

#include <filesystem>

namespace fuzz {

void writeSeeds(const std::filesystem::path& folder);

} // namespace fuzz
