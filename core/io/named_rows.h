// Text of numbers whose first line names its columns, in any order and among others: rays, trajectories. Commas are
// the point of numbers where decimal_commas.h finds them so. Errors know the line they are about.
#pragma once

#include "core/base/progress.h"
#include "core/io/text/decimal_commas.h"

#include <algorithm>
#include <array>
#include <optional>

namespace io {

constexpr RowRules namedRowRules{true, true, false};

/// Where a text begins: behind the byte order mark that spreadsheets put before it.
inline std::size_t textBegin(const FileBytes& file) {
    return file.bytes().starts_with("\xef\xbb\xbf") ? 3 : 0;
}

/// The rows of a file that may begin with a line of names. Throws base::Error where its commas part thousands, or stand
/// for the point and between fields as well.
inline TextRows namedRows(const FileBytes& file, const base::Progress& progress) {
    TextRows rows(file, textBegin(file), namedRowRules, {progress});
    if (rows.count() == 0)
        return rows;
    const auto head = rows.fields(rows.row(0));
    const bool names = std::none_of(head.begin(), head.end(), [&](auto field) { return rows.isNumber(field); });
    if (decimalCommaIn(file, rows, names ? 1 : 0, names ? head.size() : 0).empty())
        return rows;
    RowRules rules = namedRowRules;
    rules.decimalComma = true;
    return {file, textBegin(file), rules, {progress}};
}

/// Column by column of one line; errors know where it stands. REQUIRES: file and rows outlive it.
class NumberRow {
  public:
    NumberRow(const FileBytes& file, const TextRows& rows, std::string_view line)
        : m_file(file), m_rows(rows), m_line(line), m_fields(rows.fields(line)) {}

    double number(std::size_t column, const char* form) const {
        const auto value = column < m_fields.size() ? m_rows.number(m_fields[column]) : std::nullopt;
        if (!value)
            fail(column < m_fields.size() ? "'" + std::string(m_fields[column]) + "' is not a number"
                                          : "the line has too few numbers",
                 form);
        return *value;
    }
    [[noreturn]] void fail(const std::string& what, const char* form) const {
        m_file.failAt(static_cast<std::size_t>(m_line.data() - m_file.bytes().data()), what, form);
    }
    const std::vector<std::string_view>& fields() const { return m_fields; }
    /// Not one of its fields is a number.
    bool isHeader() const {
        return std::none_of(m_fields.begin(), m_fields.end(),
                            [&](std::string_view field) { return m_rows.isNumber(field); });
    }

  private:
    const FileBytes& m_file;
    const TextRows& m_rows;
    std::string_view m_line;
    std::vector<std::string_view> m_fields;
};

/// Numbers of a row, in the order of the names that a header was asked for.
template <std::size_t N>
class NamedColumns {
  public:
    using Names = std::array<std::string_view, N>;

    /// `begin`: what the error tells to begin with where a name is missing.
    NamedColumns(const NumberRow& header, const Names& names, const char* begin) {
        for (std::size_t k = 0; k < N; ++k) {
            const auto& fields = header.fields();
            const auto found = std::find(fields.begin(), fields.end(), names[k]);
            if (found == fields.end())
                header.fail("the column " + std::string(names[k]) + " is missing", begin);
            m_columns[k] = static_cast<std::size_t>(found - fields.begin());
        }
    }
    std::array<double, N> numbers(const NumberRow& row, const char* form) const {
        std::array<double, N> out{};
        for (std::size_t k = 0; k < N; ++k)
            out[k] = row.number(m_columns[k], form);
        return out;
    }

  private:
    std::array<std::size_t, N> m_columns{};
};

/// Rows under a header of names.
template <std::size_t N, class Take>
void forNamedRows(const FileBytes& file, const base::Progress& progress, const typename NamedColumns<N>::Names& names,
                  const char* begin, const Take& take) {
    const TextRows rows = namedRows(file, progress);
    std::optional<NamedColumns<N>> columns;
    rows.forRows(0, [&](std::string_view line) {
        const NumberRow row(file, rows, line);
        if (!columns)
            columns.emplace(row, names, begin);
        else
            take(row, *columns);
        return true;
    });
}

} // namespace io
