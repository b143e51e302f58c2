// A glTF 2.0 file, its JSON and its buffers: one binary file (.glb), or text (.gltf) with buffers inside of it or
// beside it (io/README 2.15).
#pragma once

#include "core/io/file_bytes.h"
#include "core/io/gltf/gltf_json.h"
#include "core/io/record_table.h"

#include <memory>

namespace io::gltf {

/// "a b.bin" of "a%20b.bin".
std::string withoutPercents(std::string_view uri);

/// Values in a buffer that were found to lie inside of it.
struct Accessor {
    const char* data = nullptr;
    std::size_t count = 0, stride = 0, components = 0;
    ScalarType type = ScalarType::Float32;
    bool normalised = false;                          ///< integers are shares of their largest value
    const std::vector<std::uint32_t>* rows = nullptr; ///< which of the values count; null: all

    double at(std::size_t i, std::size_t component) const;
    std::uint32_t index(std::size_t i) const { return static_cast<std::uint32_t>(at(i, 0)); }
};

class GltfFile {
  public:
    /// Buffers that are files of their own are those of `folder` and below. Throws base::Error where it is no glTF 2.0,
    /// or packed in a way that cannot be read.
    GltfFile(const FileBytes& file, const std::filesystem::path& folder);
    GltfFile(const GltfFile&) = delete;
    GltfFile& operator=(const GltfFile&) = delete;

    const FileBytes& file() const { return m_file; }
    const json& root() const { return m_root; }
    const json& named(const char* array, std::size_t i) const { return entry(member(m_root, array), i); }
    /// All bytes that the scene may lie in.
    std::size_t size() const;
    /// Throws base::Error where it names bytes that are not there.
    Accessor accessor(std::size_t number) const;
    std::string_view view(std::size_t number) const;
    /// The bytes of a text that begins with `data:` and holds them in base 64; empty where it is no such.
    static std::string embedded(std::string_view uri);

  private:
    void readBinary();
    void parse(std::string_view text);
    void findBuffers(const std::filesystem::path& folder);
    std::string_view bytesOf(const json& buffer, std::size_t number, const std::filesystem::path& folder);
    [[noreturn]] void damaged(const std::string& what) const;

    const FileBytes& m_file;
    json m_root;
    std::string_view m_binary; ///< of a .glb
    std::vector<std::string_view> m_buffers;
    std::vector<std::unique_ptr<std::string>> m_texts; ///< decoded buffers
    std::vector<std::unique_ptr<FileBytes>> m_files;   ///< those that are files
};

} // namespace io::gltf
