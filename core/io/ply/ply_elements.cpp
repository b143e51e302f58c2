#include "core/io/ply/ply_elements.h"

#include "core/io/number_text.h"
#include "core/io/ply/ply_records.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace io {

static const char* const cutOff = "the file is damaged or was cut off; fetch it again";

/// Smallest number of bytes that a binary record can take: every list empty.
static std::size_t leastBytes(const PlyElement& element) {
    std::size_t bytes = element.scalarBytes();
    for (const PlyProperty& property : element.properties)
        bytes += property.isList ? sizeOf(property.countType) : 0;
    return bytes;
}

std::size_t binaryExtent(const FileBytes& file, const PlyElement& element, std::size_t offset, bool bigEndian) {
    const std::size_t least = leastBytes(element), left = file.size() - offset;
    if (least == 0)
        return 0;
    if (element.count > left / least)
        file.fail("the header declares " + std::to_string(element.count) + " of element " + inQuotes(element.name) +
                      ", but there are bytes for at most " + std::to_string(left / least),
                  cutOff);
    if (!element.hasLists())
        return element.count * least;
    const RecordWalker walker(file, file.bytes(), element, bigEndian);
    std::size_t at = offset;
    for (std::size_t i = 0; i < element.count; ++i)
        at = walker.pass(at, [](const PlyProperty&, std::size_t, std::size_t) {});
    return at - offset;
}

static RecordTable emptyTable(const PlyElement& element, bool bigEndian) {
    RecordTable table;
    table.count = element.count;
    table.bigEndian = bigEndian;
    for (const PlyProperty& property : element.properties) {
        if (property.isList)
            continue;
        table.fields.push_back({property.name, property.type, property.type, table.stride});
        table.stride += sizeOf(property.type);
    }
    return table;
}

/// Copies the scalars of records with lists one behind the other.
static RecordTable packedTable(const FileBytes& file, std::string_view body, const PlyElement& element,
                               std::size_t offset, bool bigEndian) {
    RecordTable table = emptyTable(element, bigEndian);
    table.owned = std::make_unique_for_overwrite<char[]>(table.count * table.stride);
    table.data = table.owned.get();
    const RecordWalker walker(file, body, element, bigEndian);
    char* out = table.owned.get();
    for (std::size_t i = 0; i < element.count; ++i)
        offset = walker.pass(offset, [&](const PlyProperty& property, std::size_t at, std::size_t) {
            if (property.isList)
                return;
            std::memcpy(out, body.data() + at, sizeOf(property.type));
            out += sizeOf(property.type);
        });
    return table;
}

RecordTable binaryTable(const FileBytes& file, const PlyElement& element, std::size_t offset, bool bigEndian) {
    if (element.hasLists())
        return packedTable(file, file.bytes(), element, offset, bigEndian);
    RecordTable table = emptyTable(element, bigEndian);
    table.data = file.bytes().data() + offset;
    return table;
}

std::string littleEndianBody(const FileBytes& file, const PlyElement& element, std::size_t offset, std::size_t extent,
                             bool bigEndian) {
    std::string out(file.bytes().substr(offset, extent));
    if (!bigEndian)
        return out;
    const RecordWalker walker(file, file.bytes(), element, bigEndian);
    const auto turn = [&](std::size_t at, std::size_t size) {
        const auto first = out.begin() + static_cast<std::ptrdiff_t>(at);
        std::reverse(first, first + static_cast<std::ptrdiff_t>(size));
    };
    std::size_t at = offset;
    for (std::size_t i = 0; i < element.count && extent > 0; ++i)
        at = walker.pass(at, [&](const PlyProperty& property, std::size_t place, std::size_t items) {
            const std::size_t head = sizeOf(property.isList ? property.countType : property.type);
            turn(place - offset, head);
            for (std::size_t k = 0; k < items; ++k)
                turn(place - offset + head + k * sizeOf(property.type), sizeOf(property.type));
        });
    return out;
}

/// Appends a value in little-endian binary of a type, clamped to what the type can hold.
static void appendAs(std::string& out, ScalarType type, double value) {
    withType(type, [&]<class T>() {
        T typed;
        if constexpr (std::is_integral_v<T>) {
            const double least = static_cast<double>(std::numeric_limits<T>::min());
            const double most = static_cast<double>(std::numeric_limits<T>::max());
            typed = std::isnan(value) ? T(0) : static_cast<T>(std::clamp(std::nearbyint(value), least, most));
        } else {
            typed = static_cast<T>(value);
        }
        char bytes[sizeof(T)];
        std::memcpy(bytes, &typed, sizeof typed);
        out.append(bytes, sizeof bytes);
    });
}

namespace {

/// Whether a list can have so many items: a whole number that the type of its count holds.
bool isCount(double value, ScalarType type) {
    return withType(type, [&]<class T>() {
        return value >= 0 && value <= std::min(static_cast<double>(std::numeric_limits<T>::max()), 4294967295.0) &&
               value == std::floor(value);
    });
}

/// Turns one ascii row after another into binary.
class AsciiRecords {
  public:
    AsciiRecords(const FileBytes& file, const PlyElement& element) : m_file(file), m_element(element) {}

    void append(std::string_view row, std::string& out) {
        m_begin = m_at = row.data();
        m_end = row.data() + row.size();
        for (const PlyProperty& property : m_element.properties) {
            skipBlanks();
            const char* const begin = m_at;
            const double value = next();
            appendAs(out, property.isList ? property.countType : property.type, value);
            if (!property.isList)
                continue;
            // A short row ends the loop below, whatever the count says.
            if (!isCount(value, property.countType))
                fail("the list " + inQuotes(property.name) + " has " + std::string(begin, m_at) +
                     " items, which its count of type " + plyName(property.countType) + " cannot hold");
            for (double k = 0; k < value; ++k)
                appendAs(out, property.type, next());
        }
        skipBlanks();
        if (m_at != m_end)
            fail("holds more values than the header declares");
    }

  private:
    void skipBlanks() {
        while (m_at < m_end && (*m_at == ' ' || *m_at == '\t' || *m_at == '\r' || *m_at == '\v' || *m_at == '\f'))
            ++m_at;
    }
    double next() {
        skipBlanks();
        if (m_at == m_end)
            fail("holds fewer values than the header declares");
        double value = 0;
        const char* after = parseNumber(m_at, m_end, value);
        if (!after)
            fail("holds something that is not a number");
        m_at = after;
        return value;
    }
    [[noreturn]] void fail(const std::string& what) const {
        m_file.failAt(static_cast<std::size_t>(m_begin - m_file.bytes().data()),
                      what + " (element " + inQuotes(m_element.name) + ")", cutOff);
    }
    const FileBytes& m_file;
    const PlyElement& m_element;
    const char* m_begin = nullptr;
    const char* m_at = nullptr;
    const char* m_end = nullptr;
};

} // namespace

std::string littleEndianBody(const FileBytes& file, const TextRows& rows, std::size_t firstRow,
                             const PlyElement& element) {
    std::string out;
    AsciiRecords records(file, element);
    std::size_t left = element.properties.empty() ? 0 : element.count;
    if (left > 0)
        rows.forRows(firstRow, [&](std::string_view row) {
            records.append(row, out);
            return --left > 0;
        });
    return out;
}

RecordTable asciiTable(const FileBytes& file, const TextRows& rows, std::size_t firstRow, const PlyElement& element,
                       const ProgressSpan& progress) {
    if (element.hasLists())
        return [&] {
            const std::string body = littleEndianBody(file, rows, firstRow, element);
            return packedTable(file, body, element, 0, false);
        }();
    RecordTable table;
    std::vector<int> targets;
    for (const PlyProperty& property : element.properties) {
        targets.push_back(static_cast<int>(targets.size()));
        table.fields.push_back(
            {property.name, ScalarType::Float64, property.type, table.fields.size() * sizeof(double)});
    }
    rows.checkRoom(element.count, targets.size());
    double* const values = table.allocateDoubles(element.count, targets.size());
    rows.parse(firstRow, element.count, targets, targets.size(), values, progress);
    return table;
}

} // namespace io
