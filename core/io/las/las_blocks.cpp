#include "core/io/las/las_blocks.h"

#include "core/base/cancel_scope.h"

#include <cstring>

namespace io {

/// The first bytes; fewer where the file ends.
static std::string firstBytes(std::ifstream& in, std::size_t count) {
    std::string out(count, '\0');
    in.seekg(0);
    in.read(out.data(), static_cast<std::streamsize>(count));
    out.resize(static_cast<std::size_t>(in.gcount()));
    in.clear();
    return out;
}

std::optional<LasBlocks> LasBlocks::open(const std::filesystem::path& path) {
    constexpr std::size_t least = 227, newest = 375, mostHead = std::size_t(1) << 28;
    std::error_code unknown;
    const std::uint64_t size = std::filesystem::is_regular_file(path, unknown) ? std::filesystem::file_size(path) : 0;
    if (size < least) // a pipe has bytes once only: they are its reader's
        return {};
    std::ifstream in(path, std::ios::binary);
    std::string head = firstBytes(in, newest);
    if (head.size() < least || !head.starts_with("LASF"))
        return {};
    std::uint32_t pointsAt = 0, legacy = 0;
    std::uint64_t points = 0;
    std::memcpy(&pointsAt, head.data() + 96, 4);
    std::memcpy(&legacy, head.data() + 107, 4);
    if (head.size() >= newest && head[25] >= 4)
        std::memcpy(&points, head.data() + 247, 8);
    points = legacy > 0 ? legacy : points;
    if (pointsAt > size)
        return {};
    head = firstBytes(in, std::min<std::size_t>(pointsAt, mostHead));
    if (head.size() != pointsAt || points == 0 || head.size() < least)
        return {};
    // A file of one record has the same header and passes the same checks.
    std::uint16_t stride = 0;
    std::memcpy(&stride, head.data() + 105, 2);
    std::string one = head + std::string(stride, '\0');
    const std::uint32_t single = 1;
    std::memcpy(one.data() + 107, &single, 4);
    const FileBytes small(path, std::move(one));
    LasHeader header;
    try {
        header = parseLasHeader(small);
    } catch (const base::Error&) {
        return {};
    }
    if (header.compressed || header.stride < 12 || points > (size - pointsAt) / header.stride)
        return {};
    LasBlocks out;
    out.m_path = path, out.m_head = std::move(head), out.m_points = points, out.m_stride = header.stride;
    out.m_scale = header.scale, out.m_offset = header.offset;
    return out;
}

void LasBlocks::forTail(const std::function<void(const std::string&)>& fn) const {
    std::ifstream in(m_path, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(m_head.size() + m_points * m_stride));
    std::string part(std::size_t(1) << 20, '\0');
    while (in.read(part.data(), static_cast<std::streamsize>(part.size())) || in.gcount() > 0) {
        base::CancelScope::check();
        part.resize(static_cast<std::size_t>(in.gcount()));
        fn(part);
    }
}

} // namespace io
