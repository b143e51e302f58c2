#include "core/io/folder_names.h"

#include <dirent.h>
#include <memory>

namespace io {

std::vector<std::string> namesIn(const std::filesystem::path& folder) {
    const auto close = [](DIR* each) { ::closedir(each); };
    const std::unique_ptr<DIR, decltype(close)> open(::opendir(folder.empty() ? "." : folder.c_str()), close);
    std::vector<std::string> out;
    while (const dirent* entry = open ? ::readdir(open.get()) : nullptr)
        if (const std::string name = entry->d_name; name != "." && name != "..")
            out.push_back(name);
    return out;
}

} // namespace io
