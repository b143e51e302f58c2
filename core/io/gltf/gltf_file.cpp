#include "core/io/gltf/gltf_file.h"

#include "core/io/pictures/face_pictures.h"

#include <algorithm>
#include <limits>

namespace io::gltf {

std::string withoutPercents(std::string_view uri) {
    std::string out;
    const auto digit = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : -1;
    };
    for (std::size_t i = 0; i < uri.size(); ++i)
        if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
            out += static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
            i += 2;
        } else {
            out += uri[i];
        }
    return out;
}

namespace {

const char* const fetchAgain = "the file is damaged or was cut off; fetch it again";

std::optional<ScalarType> typeOf(std::size_t componentType) {
    switch (componentType) {
    case 5120:
        return ScalarType::Int8;
    case 5121:
        return ScalarType::UInt8;
    case 5122:
        return ScalarType::Int16;
    case 5123:
        return ScalarType::UInt16;
    case 5125:
        return ScalarType::UInt32;
    case 5126:
        return ScalarType::Float32;
    default:
        return std::nullopt;
    }
}

std::size_t componentsOf(const std::string& type) {
    static constexpr std::pair<const char*, std::size_t> all[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                                  {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& [name, count] : all)
        if (type == name)
            return count;
    return 0;
}

} // namespace

double Accessor::at(std::size_t i, std::size_t component) const {
    const char* const bytes = data + (rows ? (*rows)[i] : i) * stride + component * sizeOf(type);
    return withType(type, [&]<class T>() {
        const T value = load<T, false>(bytes);
        if constexpr (std::is_integral_v<T>)
            return normalised
                       ? std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0)
                       : static_cast<double>(value);
        else
            return static_cast<double>(value);
    });
}

void GltfFile::damaged(const std::string& what) const {
    m_file.fail(what, fetchAgain);
}

GltfFile::GltfFile(const FileBytes& file, const std::filesystem::path& folder) : m_file(file) {
    if (file.bytes().starts_with("glTF"))
        readBinary();
    else
        parse(file.bytes());
    const std::string version = textOf(member(member(m_root, "asset"), "version"));
    if (!version.starts_with("2."))
        file.fail("is no glTF 2.0" + (version.empty() ? std::string() : ", but " + inQuotes(version)),
                  "export it as glTF 2.0");
    for (const json& each : member(m_root, "extensionsRequired"))
        if (const std::string name = textOf(each); name.find("compression") != std::string::npos)
            file.fail("is packed by the extension " + inQuotes(name) + ", which cannot be read",
                      "export it without compression");
    findBuffers(folder);
}

/// 12 bytes of header, then chunks of a length, a kind and bytes: the JSON and the buffer.
void GltfFile::readBinary() {
    const std::string_view bytes = m_file.bytes();
    if (bytes.size() < 20)
        damaged("is too short for a GLB file");
    if (const auto version = load<std::uint32_t, false>(bytes.data() + 4); version != 2)
        m_file.fail("is binary glTF of version " + std::to_string(version), "export it as glTF 2.0");
    std::string_view text;
    for (std::size_t at = 12; bytes.size() - at >= 8;) {
        const std::size_t size = load<std::uint32_t, false>(bytes.data() + at);
        const std::string_view kind = bytes.substr(at + 4, 4);
        at += 8;
        if (size > bytes.size() - at)
            damaged("a chunk of " + std::to_string(size) + " bytes is promised, but there are " +
                    std::to_string(bytes.size() - at));
        if (kind == "JSON" && text.empty())
            text = bytes.substr(at, size);
        else if (kind == std::string_view("BIN\0", 4) && m_binary.empty())
            m_binary = bytes.substr(at, size);
        at += size;
    }
    parse(text);
}

void GltfFile::parse(std::string_view text) {
    constexpr int deepest = 64;
    while (text.ends_with('\0')) // as some programs fill chunks up
        text.remove_suffix(1);
    const auto shallow = [this](int depth, json::parse_event_t, json&) {
        if (depth > deepest)
            damaged("its JSON is nested more than " + std::to_string(deepest) + " levels deep");
        return true;
    };
    try {
        m_root = json::parse(text, shallow);
    } catch (const json::exception&) {
        damaged("its JSON is damaged");
    }
}

std::string GltfFile::embedded(std::string_view uri) {
    const std::size_t comma = uri.find(";base64,");
    if (!uri.starts_with("data:") || comma == std::string_view::npos)
        return {};
    std::string out;
    std::uint32_t bits = 0;
    int have = 0;
    for (const char c : uri.substr(comma + 8)) {
        const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                          : c >= 'a' && c <= 'z' ? c - 'a' + 26
                          : c >= '0' && c <= '9' ? c - '0' + 52
                          : c == '+' || c == '-' ? 62
                          : c == '/' || c == '_' ? 63
                                                 : -1;
        if (value < 0)
            break;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        have += 6;
        if (have >= 8)
            out += static_cast<char>(bits >> (have -= 8) & 255);
    }
    return out;
}

std::string_view GltfFile::bytesOf(const json& buffer, std::size_t number, const std::filesystem::path& folder) {
    const std::string uri = textOf(member(buffer, "uri"));
    if (uri.empty())
        return number == 0 ? m_binary : std::string_view();
    if (uri.starts_with("data:"))
        return *m_texts.emplace_back(std::make_unique<std::string>(embedded(uri)));
    const std::filesystem::path path = besideModel(folder, withoutPercents(uri));
    std::error_code none;
    if (path.empty() || !std::filesystem::is_regular_file(path, none))
        m_file.fail("the file " + inQuotes(uri) + " with its numbers is not beside it", "put it there");
    for (const auto& each : m_files) // one that is named again is read once
        if (each->path() == path)
            return each->bytes();
    return m_files.emplace_back(std::make_unique<FileBytes>(path))->bytes();
}

void GltfFile::findBuffers(const std::filesystem::path& folder) {
    const json& buffers = member(m_root, "buffers");
    for (std::size_t i = 0; i < (buffers.is_array() ? buffers.size() : 0); ++i)
        m_buffers.push_back(bytesOf(buffers[i], i, folder));
}

std::size_t GltfFile::size() const {
    std::size_t out = m_file.size();
    for (const auto& each : m_files)
        out += each->size();
    return out;
}

std::string_view GltfFile::view(std::size_t number) const {
    const json& view = named("bufferViews", number);
    const std::size_t buffer = countOf(member(view, "buffer")).value_or(m_buffers.size());
    const std::size_t at = countOf(member(view, "byteOffset")).value_or(0);
    const std::size_t size = countOf(member(view, "byteLength")).value_or(0);
    if (buffer >= m_buffers.size() || at > m_buffers[buffer].size() || size > m_buffers[buffer].size() - at)
        damaged("the buffer view " + std::to_string(number) + " lies outside of its buffer");
    return m_buffers[buffer].substr(at, size);
}

Accessor GltfFile::accessor(std::size_t number) const {
    const json& from = named("accessors", number);
    const std::string name = "the accessor " + std::to_string(number);
    const std::optional<ScalarType> type = typeOf(countOf(member(from, "componentType")).value_or(0));
    const std::optional<std::size_t> viewNumber = countOf(member(from, "bufferView"));
    Accessor out;
    out.components = componentsOf(textOf(member(from, "type")));
    out.count = countOf(member(from, "count")).value_or(0);
    if (!type || out.components == 0)
        damaged(name + " has no type");
    if (!viewNumber || member(from, "sparse").is_object())
        m_file.fail(name + " is sparse, which cannot be read", "export it without sparse accessors");
    out.type = *type;
    out.normalised = member(from, "normalized") == json(true);
    const std::string_view bytes = view(*viewNumber);
    const std::size_t at = countOf(member(from, "byteOffset")).value_or(0), size = out.components * sizeOf(*type);
    out.stride = countOf(member(named("bufferViews", *viewNumber), "byteStride")).value_or(size);
    if (out.stride < size || out.stride > 0xffff)
        damaged(name + " has a stride of " + std::to_string(out.stride));
    const std::size_t room =
        bytes.size() > at && bytes.size() - at >= size ? (bytes.size() - at - size) / out.stride + 1 : 0;
    if (out.count > room)
        damaged(name + " promises " + std::to_string(out.count) + " values, but there are bytes for " +
                std::to_string(room));
    out.data = bytes.data() + at;
    return out;
}

} // namespace io::gltf
