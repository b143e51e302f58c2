// Values of a glTF file's JSON as whoever reads one wants them: what is missing or of another kind is a value without
// anything, so that no claim has to be believed.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace io::gltf {

using nlohmann::json;

inline const json& member(const json& object, const char* key) {
    static const json nothing;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() ? *found : nothing;
}

inline const json& entry(const json& array, std::size_t i) {
    static const json nothing;
    return array.is_array() && i < array.size() ? array[i] : nothing;
}

inline std::optional<std::size_t> countOf(const json& value) {
    return value.is_number_unsigned() ? std::optional(value.get<std::size_t>()) : std::nullopt;
}

inline double numberOf(const json& value, double without) {
    return value.is_number() ? value.get<double>() : without;
}

inline std::string textOf(const json& value) {
    return value.is_string() ? value.get<std::string>() : std::string();
}

} // namespace io::gltf
