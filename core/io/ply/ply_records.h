// Binary records of a PLY element, one after the other: lists make them unequally long.
#pragma once

#include "core/io/ply/ply_header.h"
#include "core/io/record_table.h"

namespace io {

/// A value as a whole number; reals are cut off.
inline std::int64_t loadInteger(ScalarType type, const char* bytes, bool bigEndian) {
    return withType(type, [&]<class T>() {
        return static_cast<std::int64_t>(bigEndian ? load<T, true>(bytes) : load<T, false>(bytes));
    });
}

inline double loadReal(ScalarType type, const char* bytes, bool bigEndian) {
    return withType(
        type, [&]<class T>() { return static_cast<double>(bigEndian ? load<T, true>(bytes) : load<T, false>(bytes)); });
}

/// Passes over binary records whose lists make them unequally long.
class RecordWalker {
  public:
    RecordWalker(const FileBytes& file, std::string_view body, const PlyElement& element, bool bigEndian)
        : m_file(file), m_body(body), m_element(element), m_bigEndian(bigEndian) {}

    /// Calls `visit(property, at, items)` for every property of the record at `at` (`items` is 0 for scalars) and
    /// returns where the next one starts.
    template <class Visit>
    std::size_t pass(std::size_t at, const Visit& visit) const {
        for (const PlyProperty& property : m_element.properties) {
            const std::size_t head = sizeOf(property.isList ? property.countType : property.type);
            if (head > m_body.size() - at)
                failCut(at);
            std::size_t items = 0;
            if (property.isList) {
                const std::int64_t count = loadInteger(property.countType, m_body.data() + at, m_bigEndian);
                if (count < 0)
                    m_file.failAtByte(at, "a list of element " + inQuotes(m_element.name) + " has a negative length",
                                      damaged);
                items = static_cast<std::size_t>(count);
                if (items > (m_body.size() - at - head) / sizeOf(property.type))
                    failCut(at);
            }
            visit(property, at, items);
            at += head + items * sizeOf(property.type);
        }
        return at;
    }

  private:
    static constexpr const char* damaged = "the file is damaged or was cut off; fetch it again";
    [[noreturn]] void failCut(std::size_t at) const {
        m_file.failAtByte(at, "the body ends inside element " + inQuotes(m_element.name), damaged);
    }
    const FileBytes& m_file;
    std::string_view m_body;
    const PlyElement& m_element;
    bool m_bigEndian;
};

} // namespace io
