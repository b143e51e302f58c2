// CSV text of numbers with a fixed number of significant digits, without the locale.
#pragma once

#include "core/base/vec.h"

#include <string>
#include <string_view>

namespace app {

class CsvWriter {
  public:
    /// 9 digits bring back every float, 17 every double.
    explicit CsvWriter(int digits) : m_digits(digits) {}

    CsvWriter& number(double value); ///< "nan" where there is none
    CsvWriter& vector(const base::Vec3d& v) { return number(v.x).number(v.y).number(v.z); }
    CsvWriter& integer(long long value);
    CsvWriter& word(std::string_view text);
    void endRow();

    /// What was written since the last call.
    std::string take();

  private:
    void separate();
    std::string m_text;
    bool m_begun = false; ///< the row has a field
    int m_digits;
};

} // namespace app
