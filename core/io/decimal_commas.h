// Commas in rows of numbers: between fields, for the point, or between thousands.
#pragma once

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

} // namespace io
