// The bytes of an E57 file without the checksums that end each of its pages (ASTM E2807, io/README 2.14).
//
// "Physical" offsets count the checksums, "logical" ones do not.
#pragma once

#include "core/base/progress.h"
#include "core/io/file_bytes.h"

#include <span>

namespace io::e57 {

/// CRC-32C (Castagnoli), as pages end in it, highest byte first.
std::uint32_t checksum(std::string_view bytes);

class PagedBytes {
  public:
    /// Checks all pages, in parallel. Throws base::Error where one is damaged or the size of pages makes no sense.
    PagedBytes(const FileBytes& file, std::size_t pageSize, const base::Progress& progress);

    std::size_t size() const { return m_size; } ///< logical
    std::size_t logical(std::uint64_t physical) const;
    /// Copies bytes from a logical offset; throws base::Error where the file ends before.
    void read(std::size_t offset, std::span<char> out) const;

  private:
    const FileBytes& m_file;
    std::size_t m_page, m_payload, m_size = 0;
};

} // namespace io::e57
