// The fields of LAS point records, formats 0 to 10, as ASPRS's specification 1.4 R15 has them (io/README 2.12): one
// table for the readers of LAS and LAZ and for the writer.
#pragma once

#include "core/io/record_table.h"

namespace io {

/// A field beside the coordinates, which are three int32 at the start of every record.
struct LasField {
    std::string name;
    ScalarType type = ScalarType::UInt8; ///< of the bytes
    std::size_t offset = 0;
    unsigned shift = 0, bits = 0; ///< of a byte; bits 0: all of it
    double scale = 1;             ///< a field that is scaled is an attribute of Float32
    double plus = 0;

    ScalarType declared() const { return scale == 1 && plus == 0 ? type : ScalarType::Float32; }
};

struct LasLayout {
    std::vector<LasField> fields;
    std::size_t size = 0;                       ///< of a record without extra bytes
    std::size_t rgb = 0, nir = 0, waveform = 0; ///< offsets; 0 where the format has none
    bool isLayered = false;                     ///< format 6 and further

    const LasField* find(std::string_view name) const;
};

constexpr unsigned lasFormats = 11;
/// REQUIRES: format < lasFormats.
LasLayout lasLayout(unsigned format);

/// The value of a field in a record.
double lasValue(const LasField& field, const char* record);
/// Puts a value there, rounded and clamped to what the field can hold.
void putLasValue(const LasField& field, char* record, double value);

} // namespace io
