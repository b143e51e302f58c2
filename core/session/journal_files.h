// What stands beside a journal and belongs to it: files that it keeps, and what a killed process had begun. What others
// may do with them is declared in journal.h. Inside this room only.
#pragma once

#include <filesystem>
#include <string_view>

namespace session {

/// Stands behind the lines that opened several models.
constexpr std::string_view openedLine = "# opened";

/// What a killed process had begun for this journal. REQUIRES: we hold it.
void removeUnfinished(const std::filesystem::path& journal);

} // namespace session
