// What tests of journals look at.
#pragma once

#include "workbench.h"

#include <algorithm>

namespace test {

inline std::string recovered(const std::filesystem::path& journal) {
    Workbench bench;
    session::recover(journal, bench.context);
    return bench.hash();
}

inline int lineCount(const std::filesystem::path& file) {
    const std::string content = contentOf(file);
    return static_cast<int>(std::count(content.begin(), content.end(), '\n'));
}

} // namespace test
