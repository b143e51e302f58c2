#include "core/io/text/text_rows.h"

#include "core/io/number_text.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <numeric>
#include <optional>

namespace io {

/// A place in a line, and what the rules say stands there.
struct TextRows::Cursor {
    const char* at;
    const char* end;
    const RowRules& rules;

    void skipBlanks() {
        while (at < end && isBlank(*at))
            ++at;
    }
    bool atSeparator() const {
        return rules.separators && at < end && ((*at == ',' && !rules.decimalComma) || *at == ';');
    }
    bool atEnd() const {
        if (at == end)
            return true;
        return rules.comments && (*at == '#' || *at == '%' || (*at == '/' && end - at > 1 && at[1] == '/'));
    }
    bool atFieldEnd() const { return atEnd() || isBlank(*at) || atSeparator(); }
    /// Passes over a field, quoted or not, and returns it without quotes and blanks inside them.
    std::string_view takeField() {
        if (rules.separators && *at == '"') {
            const char* close =
                static_cast<const char*>(std::memchr(at + 1, '"', static_cast<std::size_t>(end - at - 1)));
            if (close) {
                std::string_view inside(at + 1, static_cast<std::size_t>(close - at - 1));
                while (!inside.empty() && isBlank(inside.front()))
                    inside.remove_prefix(1);
                while (!inside.empty() && isBlank(inside.back()))
                    inside.remove_suffix(1);
                at = close + 1;
                return inside;
            }
        }
        const char* begin = at;
        while (!atFieldEnd())
            ++at;
        return {begin, static_cast<std::size_t>(at - begin)};
    }
    /// After a field: blanks and one separator. True where there was a separator.
    bool passSeparator() {
        skipBlanks();
        if (!atSeparator())
            return false;
        ++at;
        skipBlanks();
        return true;
    }
};

TextRows::TextRows(const FileBytes& file, std::size_t begin, const RowRules& rules, const ProgressSpan& progress)
    : m_lines(file, begin), m_rules(rules), m_firstRow(m_lines.chunks() + 1, 0) {
    m_lines.run(progress, [&](std::size_t chunk) {
        std::size_t rows = 0;
        m_lines.forLines(chunk, [&](std::size_t, std::string_view line) {
            rows += isRow(line) ? 1 : 0;
            return true;
        });
        m_firstRow[chunk + 1] = rows;
        return TextLines::none;
    });
    std::partial_sum(m_firstRow.begin(), m_firstRow.end(), m_firstRow.begin());
    m_count = m_firstRow.back();
}

bool TextRows::isRow(std::string_view line) const {
    Cursor cursor{line.data(), line.data() + line.size(), m_rules};
    cursor.skipBlanks();
    if (cursor.atEnd())
        return false;
    if (!m_rules.skipSingles)
        return true;
    cursor.takeField();
    cursor.passSeparator();
    return !cursor.atEnd();
}

std::size_t TextRows::offset(std::size_t k) const {
    const auto after = std::upper_bound(m_firstRow.begin(), m_firstRow.end(), k);
    const auto chunk = static_cast<std::size_t>(after - m_firstRow.begin()) - 1;
    std::size_t row = m_firstRow[chunk], found = 0;
    m_lines.forLines(chunk, [&](std::size_t at, std::string_view line) {
        found = at;
        return !isRow(line) || row++ != k;
    });
    return found;
}

std::vector<std::string_view> TextRows::fields(std::string_view row) const {
    std::vector<std::string_view> out;
    Cursor cursor{row.data(), row.data() + row.size(), m_rules};
    cursor.skipBlanks();
    while (!cursor.atEnd()) {
        out.push_back(cursor.atSeparator() ? std::string_view() : cursor.takeField());
        cursor.passSeparator();
    }
    return out;
}

bool TextRows::isRagged(std::size_t k, std::size_t wanted) const {
    int left = 10000;
    std::optional<std::size_t> first;
    bool fits = false, differ = false;
    forRows(k, [&](std::string_view line) {
        const std::size_t here = fields(line).size();
        fits = fits || here == wanted;
        differ = differ || here != first.value_or(here);
        first = first.value_or(here);
        return !(fits && differ) && --left > 0;
    });
    return fits && differ;
}

/// A number that has a comma for its point.
static const char* parseCommaNumber(const char* begin, const char* end, double& out) {
    const char* const last = std::find_if(begin, end, [](char c) { return isBlank(c) || c == ';'; });
    std::string text(begin, last);
    if (text.find('.') != std::string::npos)
        return nullptr;
    std::replace(text.begin(), text.end(), ',', '.');
    const char* const after = parseNumber(text.data(), text.data() + text.size(), out);
    return after ? begin + (after - text.data()) : nullptr;
}

/// Behind the number, or null.
static const char* parseAny(const RowRules& rules, const char* begin, const char* end, double& out) {
    return rules.decimalComma ? parseCommaNumber(begin, end, out) : parseNumber(begin, end, out);
}

std::optional<double> TextRows::number(std::string_view field) const {
    double value = 0;
    const char *const begin = field.data(), *const end = begin + field.size();
    if (field.empty() || parseAny(m_rules, begin, end, value) != end)
        return {};
    return value;
}

/// A number in quotes, nan where they hold nothing. The cursor goes behind it.
bool TextRows::parseQuoted(Cursor& cursor, double& out) const {
    const std::string_view text = cursor.takeField();
    out = std::numeric_limits<double>::quiet_NaN();
    if (text.empty())
        return true;
    const char *const begin = text.data(), *const end = begin + text.size();
    return parseAny(m_rules, begin, end, out) == end;
}

TextRows::Fault TextRows::parseRow(std::string_view line, std::span<const int> targets, double* out,
                                   std::size_t& found) const {
    Cursor cursor{line.data(), line.data() + line.size(), m_rules};
    cursor.skipBlanks();
    bool separated = false;
    for (found = 0; found < targets.size(); ++found) {
        const int target = targets[found];
        if (cursor.atEnd() && !separated) {
            for (std::size_t c = found; m_rules.ragged && c < targets.size(); ++c)
                if (targets[c] >= 0)
                    out[targets[c]] = std::numeric_limits<double>::quiet_NaN();
            return Fault::TooFew;
        }
        if (cursor.atSeparator() || cursor.atEnd()) {
            if (target >= 0)
                out[target] = std::numeric_limits<double>::quiet_NaN();
        } else if (target < 0) {
            cursor.takeField();
        } else if (m_rules.separators && *cursor.at == '"') {
            if (!parseQuoted(cursor, out[target]) || !cursor.atFieldEnd())
                return Fault::NotANumber;
        } else {
            const char* after = parseAny(m_rules, cursor.at, cursor.end, out[target]);
            cursor.at = after ? after : cursor.at;
            if (!after || !cursor.atFieldEnd())
                return Fault::NotANumber;
        }
        separated = cursor.passSeparator();
    }
    return cursor.atEnd() ? Fault::None : Fault::TooMany;
}

void TextRows::fail(std::size_t offset, std::span<const int> targets) const {
    std::vector<double> values(targets.size() + 1);
    std::vector<int> places(targets.begin(), targets.end());
    for (std::size_t c = 0; c < places.size(); ++c)
        places[c] = targets[c] < 0 ? -1 : static_cast<int>(c);
    std::size_t found = 0;
    const Fault fault = parseRow(m_lines.lineAt(offset), places, values.data(), found);
    const std::string expected = std::to_string(targets.size());
    if (fault == Fault::NotANumber) {
        const auto all = fields(m_lines.lineAt(offset));
        m_lines.file().failAt(offset, inQuotes(found < all.size() ? all[found] : "") + " is not a number",
                              "correct the line or remove it");
    }
    m_lines.file().failAt(offset,
                          fault == Fault::TooFew
                              ? "holds " + std::to_string(found) + (found == 1 ? " value" : " values") + " where " +
                                    expected + " are expected"
                              : "holds more than the " + expected + " values that are expected",
                          m_rules.separators ? "correct the line, or name the columns that are needed: --columns"
                                             : "correct the line or remove it");
}

void TextRows::checkRoom(std::size_t rows, std::size_t columns) const {
    columns = m_rules.ragged ? std::min<std::size_t>(columns, 1) : columns;
    if (columns == 0 || rows <= (m_lines.text().size() - m_lines.begin() + 1) / columns)
        return;
    m_lines.file().fail("holds lines with fewer than the " + std::to_string(columns) + " values that are expected",
                        "the file is damaged or was cut off; fetch it again");
}

std::size_t TextRows::parse(std::size_t first, std::size_t n, std::span<const int> targets, std::size_t width,
                            double* out, const ProgressSpan& progress) const {
    std::atomic<std::size_t> others = 0;
    const std::size_t fault = m_lines.run(progress, [&](std::size_t chunk) {
        const std::size_t end = std::min(m_firstRow[chunk + 1], first + n);
        std::size_t row = m_firstRow[chunk], found = 0, bad = TextLines::none;
        if (row >= end || end <= first)
            return bad;
        m_lines.forLines(chunk, [&](std::size_t at, std::string_view line) {
            if (!isRow(line))
                return true;
            if (row >= first) {
                const Fault wrong = parseRow(line, targets, out + (row - first) * width, found);
                if (m_rules.ragged && (wrong == Fault::TooFew || wrong == Fault::TooMany))
                    ++others;
                else if (wrong != Fault::None)
                    bad = at;
            }
            return bad == TextLines::none && ++row < end;
        });
        return bad;
    });
    if (fault != TextLines::none)
        fail(fault, targets);
    return others;
}

} // namespace io
