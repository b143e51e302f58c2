#include "core/io/las/las_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace io {

namespace {

constexpr ScalarType byte = ScalarType::UInt8, word = ScalarType::UInt16;

std::vector<LasField> oldFields() {
    return {{"intensity", word, 12},
            {"return_number", byte, 14, 0, 3},
            {"number_of_returns", byte, 14, 3, 3},
            {"scan_direction", byte, 14, 6, 1},
            {"edge_of_flight_line", byte, 14, 7, 1},
            {"classification", byte, 15, 0, 5},
            {"classification_flags", byte, 15, 5, 3},
            {"scan_angle", ScalarType::Int8, 16},
            {"user_data", byte, 17},
            {"point_source", word, 18}};
}

std::vector<LasField> newFields() {
    return {{"intensity", word, 12},
            {"return_number", byte, 14, 0, 4},
            {"number_of_returns", byte, 14, 4, 4},
            {"classification_flags", byte, 15, 0, 4},
            {"scanner_channel", byte, 15, 4, 2},
            {"scan_direction", byte, 15, 6, 1},
            {"edge_of_flight_line", byte, 15, 7, 1},
            {"classification", byte, 16},
            {"user_data", byte, 17},
            {"scan_angle", ScalarType::Int16, 18, 0, 0, 0.006},
            {"point_source", word, 20},
            {"gps_time", ScalarType::Float64, 22}};
}

/// What a format has beside the fields of its kind.
struct LasFormatRow {
    std::size_t gps, rgb, nir, waveform, size;
};
constexpr LasFormatRow formats[lasFormats] = {{0, 0, 0, 0, 20},   {20, 0, 0, 0, 28},  {0, 20, 0, 0, 26},
                                              {20, 28, 0, 0, 34}, {20, 0, 0, 28, 57}, {20, 28, 0, 34, 63},
                                              {0, 0, 0, 0, 30},   {0, 30, 0, 0, 36},  {0, 30, 36, 0, 38},
                                              {0, 0, 0, 30, 59},  {0, 30, 36, 38, 67}};

/// Of a value in a byte: all that its bits can hold.
unsigned maskOf(const LasField& field) {
    return (1u << field.bits) - 1;
}

} // namespace

const LasField* LasLayout::find(std::string_view name) const {
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const LasField& field) { return field.name == name; });
    return found == fields.end() ? nullptr : &*found;
}

LasLayout lasLayout(unsigned format) {
    const LasFormatRow& row = formats[format];
    LasLayout out;
    out.isLayered = format >= 6;
    out.fields = out.isLayered ? newFields() : oldFields();
    if (row.gps > 0)
        out.fields.push_back({"gps_time", ScalarType::Float64, row.gps});
    if (row.nir > 0)
        out.fields.push_back({"nir", word, row.nir});
    out.size = row.size;
    out.rgb = row.rgb, out.nir = row.nir, out.waveform = row.waveform;
    return out;
}

double lasValue(const LasField& field, const char* record) {
    const char* const bytes = record + field.offset;
    if (field.bits > 0)
        return static_cast<double>(static_cast<unsigned char>(*bytes) >> field.shift & maskOf(field));
    const double value = withType(field.type, [&]<class T>() { return static_cast<double>(load<T, false>(bytes)); });
    return field.declared() == field.type ? value : value * field.scale + field.plus;
}

void putLasValue(const LasField& field, char* record, double value) {
    char* const bytes = record + field.offset;
    if (field.bits > 0) {
        const auto part = static_cast<unsigned>(std::clamp(std::round(value), 0.0, static_cast<double>(maskOf(field))));
        const auto whole = static_cast<unsigned>(static_cast<unsigned char>(*bytes));
        *bytes = static_cast<char>((whole & ~(maskOf(field) << field.shift)) | part << field.shift);
        return;
    }
    if (field.declared() != field.type)
        value = (value - field.plus) / field.scale;
    withType(field.type, [&]<class T>() {
        T out = static_cast<T>(0);
        if constexpr (std::is_floating_point_v<T>)
            out = static_cast<T>(value);
        else if (value == value)
            out = static_cast<T>(std::clamp(std::round(value), static_cast<double>(std::numeric_limits<T>::min()),
                                            static_cast<double>(std::numeric_limits<T>::max())));
        std::memcpy(bytes, &out, sizeof out);
    });
}

} // namespace io
