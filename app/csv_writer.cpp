#include "app/csv_writer.h"

#include <charconv>
#include <cmath>
#include <utility>

namespace app {

void CsvWriter::separate() {
    if (m_begun)
        m_text += ',';
    m_begun = true;
}

CsvWriter& CsvWriter::number(double value, int digits) {
    if (std::isnan(value))
        return word("nan");
    separate();
    char out[40];
    m_text.append(out, std::to_chars(out, out + sizeof out, value, std::chars_format::general, digits).ptr);
    return *this;
}

CsvWriter& CsvWriter::place(const base::Vec3d& v) {
    return number(v.x, m_placeDigits).number(v.y, m_placeDigits).number(v.z, m_placeDigits);
}

CsvWriter& CsvWriter::integer(long long value) {
    return word(std::to_string(value));
}

CsvWriter& CsvWriter::word(std::string_view text) {
    separate();
    m_text += text;
    return *this;
}

void CsvWriter::endRow() {
    m_text += '\n';
    m_begun = false;
}

std::string CsvWriter::take() {
    return std::exchange(m_text, {});
}

} // namespace app
