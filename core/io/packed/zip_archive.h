// ZIP archives (APPNOTE.TXT 6.3), as far as models come in them: entries stored or deflated, ZIP64, nothing encrypted,
// no parts.
#pragma once

#include "core/base/progress.h"
#include "core/io/file_bytes.h"
#include "core/io/safe_file.h"

#include <functional>
#include <memory>
#include <vector>

namespace io {

/// What the directory at an archive's end says of a file in it.
struct ZipEntry {
    std::string name;
    std::string_view packed;
    std::uint32_t checksum = 0;
    bool deflated = false;
};

/// In the archive's order. Throws base::Error where the directory is damaged or says what cannot be read.
std::vector<ZipEntry> zipEntries(const FileBytes& file);

/// The entry's bytes, piece by piece. Throws base::Error where they are damaged or become more than mostInflated();
/// base::Cancelled.
void unpackEntry(const FileBytes& file, const ZipEntry& entry, const base::Progress& progress,
                 const std::function<void(std::string_view)>& sink);
std::string unpackedEntry(const FileBytes& file, const ZipEntry& entry, const base::Progress& progress);

/// An archive on its way to a file: an entry at a time, deflated in memory.
class ZipWriter {
  public:
    explicit ZipWriter(SafeFile& file) : m_file(file) {}
    void begin(const std::string& name);
    void write(std::string_view bytes);
    void end();
    /// The directory. Throws base::Error for more than 4 GiB.
    void finish();

  private:
    class Deflater;
    struct Written {
        std::string name;
        std::uint32_t checksum = 0;
        std::size_t packed = 0, size = 0, at = 0;
    };
    std::string head(const Written& entry, bool central) const;

    SafeFile& m_file;
    std::vector<Written> m_entries;
    std::shared_ptr<Deflater> m_deflater;
    std::size_t m_at = 0;
};

} // namespace io
