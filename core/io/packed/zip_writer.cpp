#include "core/base/error.h"
#include "core/io/packed/zip_archive.h"

#include <array>
#include <zlib.h>

namespace io {

/// One entry's bytes, packed as they come.
class ZipWriter::Deflater {
  public:
    Deflater() {
        constexpr int bare = -15, usualMemory = 8;
        if (deflateInit2(&m_stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, bare, usualMemory, Z_DEFAULT_STRATEGY) != Z_OK)
            throw std::bad_alloc();
    }
    ~Deflater() { deflateEnd(&m_stream); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    void write(std::string_view bytes, bool last) {
        std::array<unsigned char, 1 << 16> out;
        m_stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
        m_stream.avail_in = static_cast<uInt>(bytes.size());
        do {
            m_stream.next_out = out.data();
            m_stream.avail_out = static_cast<uInt>(out.size());
            ::deflate(&m_stream, last ? Z_FINISH : Z_NO_FLUSH);
            packed.append(reinterpret_cast<const char*>(out.data()), out.size() - m_stream.avail_out);
        } while (m_stream.avail_out == 0);
        if (!bytes.empty()) // without an address zlib begins anew
            checksum = ::crc32(checksum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
        size += bytes.size();
    }

    std::string packed;
    uLong checksum = ::crc32(0, nullptr, 0);
    std::size_t size = 0;

  private:
    z_stream m_stream{};
};

template <class T>
static void put(std::string& out, std::size_t value) {
    const T bits = static_cast<T>(value);
    out.append(reinterpret_cast<const char*>(&bits), sizeof bits);
}

/// The local head of an entry, or its line in the directory. Dates are the first that ZIP knows, so that the same model
/// makes the same bytes.
std::string ZipWriter::head(const Written& entry, bool central) const {
    constexpr std::size_t version = 20, deflated = 8, firstDay = 0x21;
    std::string out = central ? "PK\x01\x02" : "PK\x03\x04";
    if (central)
        put<std::uint16_t>(out, version);
    for (const std::size_t each : {version, std::size_t(0), deflated, std::size_t(0), firstDay})
        put<std::uint16_t>(out, each);
    for (const std::size_t each : {std::size_t(entry.checksum), entry.packed, entry.size})
        put<std::uint32_t>(out, each);
    put<std::uint16_t>(out, entry.name.size());
    put<std::uint16_t>(out, 0);
    if (central) {
        for (int i = 0; i < 3; ++i)
            put<std::uint16_t>(out, 0);
        put<std::uint32_t>(out, 0);
        put<std::uint32_t>(out, entry.at);
    }
    return out + entry.name;
}

void ZipWriter::begin(const std::string& name) {
    m_entries.push_back({name, 0, 0, 0, m_at});
    m_deflater = std::make_shared<Deflater>();
}

void ZipWriter::write(std::string_view bytes) {
    m_deflater->write(bytes, false);
}

void ZipWriter::end() {
    m_deflater->write({}, true);
    Written& entry = m_entries.back();
    entry.checksum = static_cast<std::uint32_t>(m_deflater->checksum);
    entry.packed = m_deflater->packed.size();
    entry.size = m_deflater->size;
    const std::string before = head(entry, false);
    m_at += before.size() + entry.packed;
    if (m_at > 0xf0000000u || entry.size > 0xf0000000u)
        throw base::Error("needs more than the 4 GiB that a ZIP archive can have", {}, "write PLY instead");
    m_file.write(before);
    m_file.write(m_deflater->packed);
    m_deflater.reset();
}

void ZipWriter::finish() {
    std::string directory;
    for (const Written& entry : m_entries)
        directory += head(entry, true);
    const std::size_t size = directory.size();
    directory += "PK\x05\x06";
    for (const std::size_t each : {std::size_t(0), std::size_t(0), m_entries.size(), m_entries.size()})
        put<std::uint16_t>(directory, each);
    put<std::uint32_t>(directory, size);
    put<std::uint32_t>(directory, m_at);
    put<std::uint16_t>(directory, 0);
    m_file.write(directory);
}

} // namespace io
