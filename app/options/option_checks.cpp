#include "app/options/option_checks.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace app {

static std::string textOf(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

template <class Fits>
static CLI::Validator number(const std::string& wanted, Fits fits) {
    const auto fault = [wanted, fits](const std::string& text) -> std::string {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && fits(value);
        return good ? "" : "'" + text + "' is not a number " + wanted;
    };
    return {fault, wanted};
}

CLI::Validator between(double least, double most) {
    return number("from " + textOf(least) + " to " + textOf(most),
                  [least, most](double value) { return value >= least && value <= most; });
}

CLI::Validator above(double least) {
    return number("above " + textOf(least), [least](double value) { return value > least; });
}

CLI::Validator atLeast(double least) {
    return number("from " + textOf(least) + " up", [least](double value) { return value >= least; });
}

CLI::Validator pictureName() {
    const auto fault = [](const std::string& name) -> std::string {
        std::string end = name.substr(name.size() - std::min<std::size_t>(name.size(), 4));
        std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
        return end == ".png" ? "" : "'" + name + "' does not name a picture; end it in .png";
    };
    return {fault, ""};
}

} // namespace app
