#include "app/writable_models.h"

#include "app/usage_error.h"
#include "core/base/error.h"
#include "core/io/before_writing.h"
#include "core/io/formats.h"
#include "core/session/scene/scene_file.h"

#include <algorithm>
#include <sstream>

namespace app {

/// fn(extension without its dot) for each.
template <class Fn>
static void forWritable(const Fn& fn) {
    for (const io::FormatRow& row : io::formatTable()) {
        std::istringstream in(row.extensions);
        for (std::string extension; row.write && in >> extension;)
            fn(extension);
    }
}

std::string writableExtensions() {
    std::string out;
    forWritable([&](const std::string& extension) { out += (out.empty() ? "." : " .") + extension; });
    return out;
}

bool isWritableModel(const std::string& path) {
    std::string lower = path;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    bool out = false;
    forWritable([&](const std::string& extension) { out |= lower.ends_with("." + extension); });
    return out;
}

/// What is asked of a name alone is wrong usage, unlike what is found in a file.
template <class Require>
static void asUsage(const Require& require) {
    try {
        require();
    } catch (const base::Error& error) {
        throw UsageError(error.message());
    }
}

void requireModelName(const std::string& path) {
    asUsage([&] { io::requireModelFormat(path); });
}

void requireSceneName(const std::string& path) {
    asUsage([&] { session::requireSavable(path); });
}

} // namespace app
