// Lines of numbers, parsed in parallel: the bodies of ascii PLY, XYZ and its relatives, and OFF.
//
// A row is a line that holds something: blank lines and comment lines are not rows. What comes out does not depend on
// the chunks into which text_lines.h cuts the text. Errors name the first wrong line, whatever thread found it.
#pragma once

#include "core/io/text/text_lines.h"

#include <optional>
#include <span>

namespace io {

struct RowRules {
    bool separators = false;   ///< ',' and ';' part fields too, and a field between two of them may be empty: nan
    bool comments = false;     ///< '#', '%' and '//' begin a comment that runs to the end of the line
    bool decimalComma = false; ///< ',' stands for the point in numbers and parts no fields
    bool ragged = false; ///< rows may be shorter or longer: what they lack is nan, what they have beyond is passed over
    bool skipSingles = false; ///< lines of one field are not rows (counts before each scan of a PTS file)
};

class TextRows {
  public:
    /// Rows of `file` from the byte `begin` on. The file must outlive the object.
    TextRows(const FileBytes& file, std::size_t begin, const RowRules& rules, const ProgressSpan& progress);

    std::size_t count() const { return m_count; }
    /// Byte in the file at which row k starts. REQUIRES: k < count().
    std::size_t offset(std::size_t k) const;
    /// Row k without its line end. REQUIRES: k < count().
    std::string_view row(std::size_t k) const { return m_lines.lineAt(offset(k)); }
    /// Rows from the k-th on, in order, until `body(row)` returns false.
    template <class Body>
    void forRows(std::size_t k, const Body& body) const;

    /// Whether rows from the k-th on differ in how many fields they have, and some (of 10,000) have `wanted`.
    bool isRagged(std::size_t k, std::size_t wanted) const;

    /// A whole field as a number by these rules.
    std::optional<double> number(std::string_view field) const;
    bool isNumber(std::string_view field) const { return number(field).has_value(); }
    /// Fields of a row, without comments; quotes around a field are taken off.
    std::vector<std::string_view> fields(std::string_view row) const;

    /// Throws where the bytes cannot hold so many values, so that nobody allocates room for them.
    void checkRoom(std::size_t rows, std::size_t columns) const;

    /// Parses rows [first, first + n) of exactly `targets.size()` fields each. Field c of the r-th goes to
    /// out[r * width + targets[c]], or is passed over where targets[c] < 0. Returns how many rows had another number of
    /// fields, where that is allowed. REQUIRES: first + n <= count().
    std::size_t parse(std::size_t first, std::size_t n, std::span<const int> targets, std::size_t width, double* out,
                      const ProgressSpan& progress) const;

  private:
    enum class Fault { None, TooFew, TooMany, NotANumber };
    struct Cursor;
    bool isRow(std::string_view line) const;
    bool parseQuoted(Cursor& cursor, double& out) const;
    Fault parseRow(std::string_view line, std::span<const int> targets, double* out, std::size_t& found) const;
    [[noreturn]] void fail(std::size_t offset, std::span<const int> targets) const;

    TextLines m_lines;
    RowRules m_rules;
    std::size_t m_count = 0;
    std::vector<std::size_t> m_firstRow; ///< per chunk
};

template <class Body>
void TextRows::forRows(std::size_t k, const Body& body) const {
    if (k >= m_count)
        return;
    for (std::size_t at = offset(k); at < m_lines.text().size(); at = m_lines.nextLine(at)) {
        const std::string_view line = m_lines.lineAt(at);
        if (isRow(line) && !body(line))
            return;
    }
}

} // namespace io
