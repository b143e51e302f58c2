#include "app/options/saved_views_file.h"

#include "core/io/ini_values.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace app {

using std::filesystem::path;

static std::string variable(const char* name, const char* fallback) {
    const char* value = std::getenv(name);
    return value && *value ? value : fallback;
}

/// The person's first, then the machine's; in each the program's before the organisation's.
static std::vector<path> settingsFiles() {
    std::vector<path> folders{path(variable("HOME", "/")) / variable("XDG_CONFIG_HOME", ".config")};
    std::istringstream shared(variable("XDG_CONFIG_DIRS", "/etc/xdg"));
    for (std::string folder; std::getline(shared, folder, ':');)
        folders.emplace_back(folder);
    std::vector<path> out;
    for (const path& folder : folders)
        for (const char* name : {"pointclay/pointclay.conf", "pointclay.conf"})
            out.push_back(folder / name);
    return out;
}

std::vector<ui::SavedView> savedViews() {
    std::vector<ui::SavedView> out;
    for (const path& file : settingsFiles()) {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        const auto lines = io::iniValues(text.str(), "view", "saved");
        if (!lines)
            continue;
        for (const std::string& line : *lines)
            if (const auto view = ui::savedViewOf(line))
                keep(out, *view);
        break;
    }
    return out;
}

} // namespace app
