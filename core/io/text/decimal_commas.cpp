#include "core/io/text/decimal_commas.h"

#include <algorithm>
#include <vector>

namespace io {

static bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// The parts between any of `separators`, without blanks around them; empty ones between blanks do not count.
static std::vector<std::string_view> partsOf(std::string_view row, std::string_view separators) {
    std::vector<std::string_view> out;
    while (!row.empty()) {
        const std::size_t end = std::min(row.find_first_of(separators), row.size());
        std::string_view part = row.substr(0, end);
        part.remove_prefix(std::min(part.find_first_not_of(" \t\r"), part.size()));
        part = part.substr(0, part.find_last_not_of(" \t\r") + 1);
        if (!part.empty())
            out.push_back(part);
        row.remove_prefix(std::min(end + 1, row.size()));
    }
    return out;
}

/// One to three digits, then groups of three behind `separator`, at least `least` of them, then perhaps a fraction.
static bool isGrouped(std::string_view text, char separator, std::size_t least) {
    text.remove_prefix(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
    std::size_t digits = 0, groups = 0;
    while (digits < text.size() && isDigit(text[digits]))
        ++digits;
    if (digits < 1 || digits > 3)
        return false;
    for (text.remove_prefix(digits); text.size() >= 4 && text[0] == separator; ++groups) {
        if (!std::all_of(text.begin() + 1, text.begin() + 4, isDigit))
            return false;
        text.remove_prefix(4);
    }
    const bool fraction = !text.empty() && (text[0] == '.' || text[0] == ',') && text[0] != separator;
    return groups >= (fraction ? 1 : least) && (text.empty() || fraction);
}

static bool isDecimal(std::string_view text) {
    const std::size_t comma = text.find(',');
    return comma != std::string_view::npos && comma > 0 && comma + 1 < text.size() && isDigit(text[comma - 1]) &&
           isDigit(text[comma + 1]) && text.find_first_not_of("0123456789,+-eEdD") == std::string_view::npos &&
           text.find(',', comma + 1) == std::string_view::npos;
}

void DoubledCommas::look(std::string_view row) {
    const auto parts = partsOf(row, ",");
    m_fits = m_fits && parts.size() >= 6 && parts.size() % 2 == 0 && (m_names == 0 || parts.size() == 2 * m_names);
    for (std::size_t i = 0; m_fits && i < parts.size(); ++i) {
        std::string_view part = parts[i];
        const bool fraction = i % 2 == 1;
        part.remove_prefix(!fraction && (part[0] == '-' || part[0] == '+') ? 1 : 0);
        m_fits = !part.empty() && std::all_of(part.begin(), part.end(), isDigit);
        if (!m_fits || !fraction)
            continue;
        m_width = m_width == 0 ? part.size() : m_width;
        m_even = m_even && part.size() == m_width && m_width >= 2;
        m_zero = m_zero || part[0] == '0';
    }
    if (m_fits && m_first.empty())
        m_first = std::string(parts[0]) + "," + std::string(parts[1]);
}

std::string DoubledCommas::found() const {
    return m_fits && (m_names > 0 || (m_even && m_zero)) ? m_first : std::string();
}

Commas commasIn(std::string_view row, std::size_t columns, std::string& example) {
    const auto groupedIn = [&](const std::vector<std::string_view>& parts, char separator, std::size_t least) {
        const auto at = std::find_if(parts.begin(), parts.end(),
                                     [&](std::string_view part) { return isGrouped(part, separator, least); });
        if (at != parts.end())
            example = *at;
        return at != parts.end();
    };
    const auto between = partsOf(row, ",;");
    if (columns >= 3 && between.size() == columns && groupedIn(between, ' ', 1))
        return Commas::Thousands;
    auto parts = partsOf(row, row.find(';') != std::string_view::npos ? ";" : " \t\r");
    for (std::string_view& part : parts)
        if (part.size() > 2 && part.starts_with('"') && part.ends_with('"'))
            part = part.substr(1, part.size() - 2);
    if (parts.size() < 3 || row.find(',') == std::string_view::npos)
        return Commas::Separators;
    if (groupedIn(parts, ',', 2) || groupedIn(parts, '.', 2))
        return Commas::Thousands;
    for (const std::string_view part : parts)
        if (part.find(',') != std::string_view::npos && !isDecimal(part))
            return Commas::Separators;
    example = *std::find_if(parts.begin(), parts.end(), isDecimal);
    return Commas::Decimal;
}

std::string decimalCommaIn(const FileBytes& file, const TextRows& rows, std::size_t first, std::size_t columns) {
    constexpr int most = 100;
    std::string example;
    Commas found = Commas::Separators;
    std::size_t row = first;
    DoubledCommas doubled(columns);
    rows.forRows(first, [&](std::string_view line) {
        found = commasIn(line, columns, example);
        doubled.look(line);
        return found == Commas::Separators && ++row - first < most;
    });
    if (found == Commas::Thousands)
        file.failAt(rows.offset(row), inQuotes(example) + " holds separators of thousands",
                    "write numbers without them, as 1234.5");
    if (found == Commas::Separators && !doubled.found().empty())
        file.failAt(rows.offset(first),
                    "begins with " + inQuotes(doubled.found()) +
                        ": commas seem to stand for the point and between numbers as well",
                    "write points in numbers, or semicolons between them");
    return found == Commas::Decimal ? example : std::string();
}

} // namespace io
