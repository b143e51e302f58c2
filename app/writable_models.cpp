#include "app/writable_models.h"

#include "core/io/formats.h"

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

} // namespace app
