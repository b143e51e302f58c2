// CSV text of numbers with a fixed number of significant digits, without the locale.
#pragma once

#include "core/base/vec.h"

#include <string>
#include <string_view>

namespace app {

class CsvWriter {
  public:
    /// 9 digits bring back every float, 17 every double.
    explicit CsvWriter(int digits) : m_digits(digits), m_placeDigits(digits) {}
    /// Of answers about a model: float or double, stored relative to `origin`. Far from zero 9 digits are not enough
    /// for a place, however near the model's own zero it is.
    CsvWriter(bool precise, const base::Vec3d& origin)
        : m_digits(precise ? 17 : 9), m_placeDigits(origin == base::Vec3d{} ? m_digits : 17) {}

    CsvWriter& number(double value) { return number(value, m_digits); } ///< "nan" where there is none
    CsvWriter& vector(const base::Vec3d& v) { return number(v.x).number(v.y).number(v.z); }
    /// A position in file coordinates.
    CsvWriter& place(const base::Vec3d& v);
    CsvWriter& integer(long long value);
    CsvWriter& word(std::string_view text);
    void endRow();

    /// What was written since the last call.
    std::string take();

  private:
    void separate();
    CsvWriter& number(double value, int digits);

    std::string m_text;
    bool m_begun = false; ///< the row has a field
    int m_digits, m_placeDigits;
};

} // namespace app
