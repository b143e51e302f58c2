// A LAS file of any size, its records read in blocks and never all at once: for what goes through files larger than
// memory. Uncompressed files only.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/io/las/las_header.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>

namespace io {

class LasBlocks {
  public:
    /// None where the file is no uncompressed LAS or is damaged, which its reader tells.
    static std::optional<LasBlocks> open(const std::filesystem::path& path);

    const std::filesystem::path& path() const { return m_path; }
    const std::string& head() const { return m_head; } ///< all before the records
    std::uint64_t size() const { return m_points; }
    std::size_t stride() const { return m_stride; }
    const base::Vec3d& scale() const { return m_scale; }
    const base::Vec3d& offset() const { return m_offset; }

    /// fn(number, record) for all records, in their order. Throws base::Error where the file ends too early,
    /// base::Cancelled.
    template <class Fn>
    void forEach(const base::Progress& progress, double from, double to, const Fn& fn) const {
        std::ifstream in(m_path, std::ios::binary);
        in.seekg(static_cast<std::streamoff>(m_head.size()));
        const std::size_t atOnce = std::clamp<std::size_t>((std::size_t(1) << 24) / m_stride, 1, 65536);
        std::vector<char> bytes(std::min<std::uint64_t>(atOnce, m_points) * m_stride);
        for (std::uint64_t first = 0; first < m_points; first += atOnce) {
            progress.step(from + (to - from) * static_cast<double>(first) / static_cast<double>(m_points), "Reading");
            const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(atOnce, m_points - first));
            if (!in.read(bytes.data(), static_cast<std::streamsize>(count * m_stride)))
                throw base::Error("cannot be read to its end", m_path.string(), "check the disk, and copy it anew");
            for (std::size_t k = 0; k < count; ++k)
                fn(first + k, bytes.data() + k * m_stride);
        }
    }
    /// What stands behind the records, part by part: waveforms are more than memory holds, too. Throws base::Cancelled.
    void forTail(const std::function<void(const std::string&)>& fn) const;

  private:
    std::filesystem::path m_path;
    std::string m_head;
    std::uint64_t m_points = 0;
    std::size_t m_stride = 0;
    base::Vec3d m_scale, m_offset;
};

} // namespace io
