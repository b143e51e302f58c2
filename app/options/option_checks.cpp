#include "app/options/option_checks.h"

#include "core/io/number_text.h"

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
static Check number(const std::string& wanted, Fits fits) {
    const auto fault = [wanted, fits](const std::string& text) -> std::string {
        const std::optional<double> value = io::numberOf(text);
        return value && std::isfinite(*value) && fits(*value) ? "" : "'" + text + "' is not a number " + wanted;
    };
    return {fault, wanted};
}

Check between(double least, double most) {
    return number("from " + textOf(least) + " to " + textOf(most),
                  [least, most](double value) { return value >= least && value <= most; });
}

Check above(double least) {
    return number("above " + textOf(least), [least](double value) { return value > least; });
}

Check atLeast(double least) {
    return number("from " + textOf(least) + " up", [least](double value) { return value >= least; });
}

Check oneOf(const std::vector<std::string>& words) {
    std::string known;
    for (const std::string& word : words)
        known += (known.empty() ? "" : ",") + word;
    const auto fault = [words, known](const std::string& text) -> std::string {
        const bool good = std::find(words.begin(), words.end(), text) != words.end();
        return good ? "" : "'" + text + "' is none of {" + known + "}";
    };
    return {fault, "{" + known + "}"};
}

Check pictureName() {
    const auto fault = [](const std::string& name) -> std::string {
        std::string end = name.substr(name.size() - std::min<std::size_t>(name.size(), 4));
        std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
        return end == ".png" ? "" : "'" + name + "' does not name a picture; end it in .png";
    };
    return {fault, ""};
}

} // namespace app
