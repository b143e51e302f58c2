// Options that are several numbers, as in --eye 1,2,3 or --size 1280x720: read without the locale.
#pragma once

#include <span>
#include <string_view>

namespace app {

/// As many numbers as `out` holds with `separator` between them; blanks may stand before each. False where the text is
/// anything else; then `out` is undefined. Too large becomes infinite.
bool parseNumbers(std::string_view text, char separator, std::span<double> out);
/// Whole numbers; false where one overflows, too.
bool parseNumbers(std::string_view text, char separator, std::span<int> out);

} // namespace app
