#include "core/io/text_rows.h"

#include "core/base/parallel.h"
#include "core/io/number_text.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace io {

static constexpr std::size_t chunkBytes = std::size_t(1) << 20;
static constexpr std::size_t slabChunks = 4; ///< chunks between two looks at the cancel flag, some 20 ms of parsing
static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

static bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// A place in a line, and what the rules say stands there.
struct TextRows::Cursor {
    const char* at;
    const char* end;
    const RowRules& rules;

    void skipBlanks() {
        while (at < end && isBlank(*at))
            ++at;
    }
    bool atSeparator() const { return rules.separators && at < end && (*at == ',' || *at == ';'); }
    bool atEnd() const {
        if (at == end)
            return true;
        return rules.comments && (*at == '#' || *at == '%' || (*at == '/' && end - at > 1 && at[1] == '/'));
    }
    bool atFieldEnd() const { return atEnd() || isBlank(*at) || atSeparator(); }
    /// Passes over a field, quoted or not, and returns it without quotes.
    std::string_view takeField() {
        if (rules.separators && *at == '"') {
            const char* close =
                static_cast<const char*>(std::memchr(at + 1, '"', static_cast<std::size_t>(end - at - 1)));
            if (close) {
                const std::string_view inside(at + 1, static_cast<std::size_t>(close - at - 1));
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
    : m_file(file), m_begin(begin), m_rules(rules) {
    if (!std::memchr(text().data() + begin, '\n', text().size() - begin))
        m_end = '\r';
    const std::size_t chunks = base::chunkCount(text().size() - begin, chunkBytes);
    m_firstRow.assign(chunks + 1, 0);
    for (std::size_t slab = 0; slab < chunks; slab += 8 * slabChunks) {
        progress.step(static_cast<double>(slab) / static_cast<double>(chunks));
        base::parallelFor(std::min(8 * slabChunks, chunks - slab), 1, [&](std::size_t k) {
            std::size_t rows = 0;
            const std::size_t end = chunkStart(slab + k + 1);
            for (std::size_t at = chunkStart(slab + k); at < end; at = nextLine(at))
                rows += isRow(lineAt(at)) ? 1 : 0;
            m_firstRow[slab + k + 1] = rows;
        });
    }
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
        m_firstRow[chunk + 1] += m_firstRow[chunk];
    m_count = m_firstRow.back();
}

std::string_view TextRows::lineAt(std::size_t offset) const {
    const std::string_view rest = text().substr(offset);
    const auto* end = static_cast<const char*>(std::memchr(rest.data(), m_end, rest.size()));
    return end ? rest.substr(0, static_cast<std::size_t>(end - rest.data())) : rest;
}

std::size_t TextRows::nextLine(std::size_t offset) const {
    return std::min(offset + lineAt(offset).size() + 1, text().size());
}

/// The first line that starts at or after the cut belongs to the chunk.
std::size_t TextRows::chunkStart(std::size_t chunk) const {
    if (chunk == 0)
        return m_begin;
    const std::size_t cut = m_begin + chunk * chunkBytes;
    return cut >= text().size() ? text().size() : nextLine(cut - 1);
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
    std::size_t at = chunkStart(chunk);
    for (std::size_t row = m_firstRow[chunk];; at = nextLine(at))
        if (isRow(lineAt(at)) && row++ == k)
            break;
    return at;
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

TextRows::Fault TextRows::parseRow(std::string_view line, std::span<const int> targets, double* out,
                                   std::size_t& found) const {
    Cursor cursor{line.data(), line.data() + line.size(), m_rules};
    cursor.skipBlanks();
    bool separated = false;
    for (found = 0; found < targets.size(); ++found) {
        const int target = targets[found];
        if (cursor.atEnd() && !separated)
            return Fault::TooFew;
        if (cursor.atSeparator() || cursor.atEnd()) {
            if (target >= 0)
                out[target] = std::numeric_limits<double>::quiet_NaN();
        } else if (target < 0) {
            cursor.takeField();
        } else {
            const char* after = parseNumber(cursor.at, cursor.end, out[target]);
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
    const Fault fault = parseRow(lineAt(offset), places, values.data(), found);
    const std::string expected = std::to_string(targets.size());
    if (fault == Fault::NotANumber) {
        const auto all = fields(lineAt(offset));
        m_file.failAt(offset, inQuotes(found < all.size() ? all[found] : "") + " is not a number",
                      "correct the line or remove it");
    }
    m_file.failAt(offset,
                  fault == Fault::TooFew
                      ? "holds " + std::to_string(found) + " values where " + expected + " are expected"
                      : "holds more than the " + expected + " values that are expected",
                  "correct the line or remove it");
}

void TextRows::checkRoom(std::size_t rows, std::size_t columns) const {
    if (columns == 0 || rows <= (text().size() - m_begin + 1) / columns)
        return;
    m_file.fail("holds lines with fewer than the " + std::to_string(columns) + " values that are expected",
                "the file is damaged or was cut off; fetch it again");
}

void TextRows::parse(std::size_t first, std::size_t n, std::span<const int> targets, std::size_t width, double* out,
                     const ProgressSpan& progress) const {
    const std::size_t chunks = m_firstRow.size() - 1;
    for (std::size_t slab = 0; slab < chunks; slab += slabChunks) {
        progress.step(static_cast<double>(slab) / static_cast<double>(chunks));
        std::size_t bad[slabChunks];
        std::fill_n(bad, slabChunks, none);
        base::parallelFor(std::min(slabChunks, chunks - slab), 1, [&](std::size_t k) {
            const std::size_t chunk = slab + k;
            std::size_t row = m_firstRow[chunk], found = 0;
            if (m_firstRow[chunk + 1] <= first || row >= first + n)
                return;
            for (std::size_t at = chunkStart(chunk); row < std::min(m_firstRow[chunk + 1], first + n);) {
                const std::string_view line = lineAt(at);
                if (isRow(line)) {
                    if (row >= first && parseRow(line, targets, out + (row - first) * width, found) != Fault::None) {
                        bad[k] = at;
                        return;
                    }
                    ++row;
                }
                at = std::min(at + line.size() + 1, text().size());
            }
        });
        const std::size_t worst = *std::min_element(bad, bad + slabChunks);
        if (worst != none)
            fail(worst, targets);
    }
}

} // namespace io
