#include "app/options/memory_option.h"

#include "app/options/number_list.h"

#include <cmath>
#include <string_view>

namespace app {

std::uint64_t bytesOf(std::string text) {
    static constexpr std::string_view units = "KMG";
    const auto unit = text.empty() ? std::string_view::npos : units.find(text.back());
    if (unit != std::string_view::npos)
        text.pop_back();
    double number = 0;
    if (!parseNumbers(text, ',', {&number, 1}) || !(number > 0) || number > 1e15)
        return 0;
    const double bytes = std::ldexp(number, unit == std::string_view::npos ? 0 : 10 * (static_cast<int>(unit) + 1));
    return bytes < 1e18 ? static_cast<std::uint64_t>(bytes) : 0;
}

std::string memoryFault(const std::string& text) {
    return bytesOf(text) > 0 ? "" : "'" + text + "' is no amount of memory; write 4G or 512M";
}

} // namespace app
