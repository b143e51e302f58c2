// Points as records of named scalars: what every reader makes of its file, and what record_points.h makes points of.
//
// Binary bodies stay where they are in the mapped file; text is parsed into records of doubles that the table owns.
// Reading one table from several threads is fine.
#pragma once

#include "core/surfel/attributes.h"

#include <bit>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace io {

using surfel::ScalarType;

constexpr std::size_t sizeOf(ScalarType type) {
    switch (type) {
    case ScalarType::Int8:
    case ScalarType::UInt8:
        return 1;
    case ScalarType::Int16:
    case ScalarType::UInt16:
        return 2;
    case ScalarType::Int32:
    case ScalarType::UInt32:
    case ScalarType::Float32:
        return 4;
    case ScalarType::Float64:
        break;
    }
    return 8;
}

/// One column: where it stands in a record, and as what it is meant.
struct Field {
    std::string name;
    ScalarType stored = ScalarType::Float64;   ///< type of the bytes in the record
    ScalarType declared = ScalarType::Float64; ///< type that the file gives it; an attribute keeps this one
    std::size_t offset = 0;                    ///< bytes from the start of the record
    /// The value is bytes times scale plus shift. REQUIRES, unless they are 1 and 0: declared differs from stored.
    double scale = 1, shift = 0;
    /// Null, or the value of a record that no bytes hold as they are (bits of a byte, the row of a grid); called from
    /// many threads. REQUIRES: stored is Float64.
    std::function<double(std::size_t record)> made = nullptr;

    bool isScaled() const { return scale != 1 || shift != 0; }
};

struct RecordTable {
    std::vector<Field> fields;
    const char* data = nullptr;
    std::size_t stride = 0; ///< bytes from one record to the next
    std::size_t count = 0;
    bool bigEndian = false;
    std::unique_ptr<char[]> owned; ///< backs `data` where it does not lie in a file

    const char* record(std::size_t i) const { return data + i * stride; }
    /// Gives the table `n` records of `columns` uninitialised doubles and returns them.
    double* allocateDoubles(std::size_t n, std::size_t columns) {
        stride = columns * sizeof(double);
        count = n;
        bigEndian = false;
        owned = std::make_unique_for_overwrite<char[]>(n * stride);
        data = owned.get();
        return reinterpret_cast<double*>(owned.get());
    }
};

/// A scalar from unaligned bytes of either order.
template <class T, bool bigEndian>
T load(const char* bytes) {
    static_assert(std::endian::native == std::endian::little);
    if constexpr (sizeof(T) == 1 || !bigEndian) {
        T value;
        std::memcpy(&value, bytes, sizeof value);
        return value;
    } else {
        char turned[sizeof(T)];
        for (std::size_t k = 0; k < sizeof(T); ++k)
            turned[k] = bytes[sizeof(T) - 1 - k];
        return std::bit_cast<T>(turned);
    }
}

/// Calls `body.template operator()<T>()` with the C++ type of a scalar type.
template <class Body>
decltype(auto) withType(ScalarType type, const Body& body) {
    switch (type) {
    case ScalarType::Int8:
        return body.template operator()<std::int8_t>();
    case ScalarType::UInt8:
        return body.template operator()<std::uint8_t>();
    case ScalarType::Int16:
        return body.template operator()<std::int16_t>();
    case ScalarType::UInt16:
        return body.template operator()<std::uint16_t>();
    case ScalarType::Int32:
        return body.template operator()<std::int32_t>();
    case ScalarType::UInt32:
        return body.template operator()<std::uint32_t>();
    case ScalarType::Float32:
        return body.template operator()<float>();
    case ScalarType::Float64:
        break;
    }
    return body.template operator()<double>();
}

/// One value as a double; exact for every type.
inline double valueOf(const RecordTable& table, const Field& field, std::size_t record) {
    if (field.made)
        return field.made(record);
    const char* bytes = table.record(record) + field.offset;
    const double value = withType(field.stored, [&]<class T>() {
        return static_cast<double>(table.bigEndian ? load<T, true>(bytes) : load<T, false>(bytes));
    });
    return field.isScaled() ? value * field.scale + field.shift : value;
}

} // namespace io
