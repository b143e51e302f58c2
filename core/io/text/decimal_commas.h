// Commas in rows of numbers: between fields, for the point, or between thousands.
#pragma once

#include "core/io/text/text_rows.h"

#include <string>
#include <string_view>

namespace io {

enum class Commas {
    Separators, ///< or there are none
    Decimal,    ///< "1,5;2,5;3,5" or "1,5 2,5 3,5": other characters part the fields
    Thousands   ///< "1,234.5" or "1 000" between separators: no program can tell those from fields
};

/// What the commas of one row are. `columns`: how many names the file gives; 0 where it gives none. `example` receives
/// the field that tells, unless they are separators.
Commas commasIn(std::string_view row, std::size_t columns, std::string& example);

/// Whether commas stand both for the point and between the fields of some rows: "20,2236,20,0000,1,5000". Then every
/// second field is digits alone. There are twice as many fields as names, or, where the file gives no names, those
/// digits are as many in every field and row, two or more, and begin with a zero somewhere, as no whole number does.
class DoubledCommas {
  public:
    explicit DoubledCommas(std::size_t names) : m_names(names) {}
    /// Looks at one more row.
    void look(std::string_view row);
    /// The first two fields where it is so; else empty.
    std::string found() const;

  private:
    std::size_t m_names, m_width = 0;
    std::string m_first;
    bool m_fits = true, m_even = true, m_zero = false;
};

/// A field with a decimal comma where rows from the `first` on have such, by the first that tells; else empty.
/// `columns` as above. Throws base::Error where commas part thousands, or stand for the point and between fields as
/// well.
std::string decimalCommaIn(const FileBytes& file, const TextRows& rows, std::size_t first, std::size_t columns);

} // namespace io
