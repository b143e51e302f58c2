#include "core/io/e57/paged_bytes.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <limits>

namespace io::e57 {

static const char* const damaged = "the file is damaged or was cut off; fetch it again";
static constexpr std::size_t checksumSize = 4;

std::uint32_t checksum(std::string_view bytes) {
    static const auto table = [] {
        std::array<std::uint32_t, 256> out{};
        for (std::uint32_t k = 0; k < 256; ++k) {
            out[k] = k;
            for (int bit = 0; bit < 8; ++bit)
                out[k] = (out[k] >> 1) ^ ((out[k] & 1) != 0 ? 0x82f63b78u : 0u);
        }
        return out;
    }();
    std::uint32_t sum = 0xffffffffu;
    for (const char each : bytes)
        sum = table[(sum ^ static_cast<unsigned char>(each)) & 255] ^ sum >> 8;
    return ~sum;
}

PagedBytes::PagedBytes(const FileBytes& file, std::size_t pageSize, const base::Progress& progress)
    : m_file(file), m_page(pageSize), m_payload(pageSize - checksumSize) {
    if (pageSize < 64 || pageSize > std::size_t(1) << 20)
        file.fail("the header claims pages of " + std::to_string(pageSize) + " bytes", damaged);
    const std::size_t pages = file.size() / m_page;
    m_size = pages * m_payload;
    std::atomic<std::size_t> first = std::numeric_limits<std::size_t>::max();
    const base::CancelScope scope(progress.cancel);
    base::parallelFor(pages, 256, [&](std::size_t k) {
        const std::string_view page = file.bytes().substr(k * m_page, m_page);
        std::uint32_t said = 0;
        for (std::size_t b = 0; b < checksumSize; ++b)
            said = said << 8 | static_cast<unsigned char>(page[m_payload + b]);
        if (said == checksum(page.substr(0, m_payload)))
            return;
        std::size_t known = first;
        while (k < known && !first.compare_exchange_weak(known, k)) {
        }
    });
    if (first < pages)
        file.failAtByte(first * m_page, "the checksum of page " + std::to_string(first + 1) + " is wrong", damaged);
}

std::size_t PagedBytes::logical(std::uint64_t physical) const {
    const std::uint64_t page = physical / m_page, rest = physical % m_page;
    if (page >= m_size / m_payload || rest >= m_payload)
        m_file.fail("a section is said to begin outside of the file", damaged);
    return static_cast<std::size_t>(page * m_payload + rest);
}

void PagedBytes::read(std::size_t offset, std::span<char> out) const {
    if (offset > m_size || out.size() > m_size - offset)
        m_file.fail("ends inside a section", damaged);
    for (std::size_t done = 0; done < out.size();) {
        const std::size_t page = (offset + done) / m_payload, at = (offset + done) % m_payload;
        const std::size_t some = std::min(m_payload - at, out.size() - done);
        std::memcpy(out.data() + done, m_file.bytes().data() + page * m_page + at, some);
        done += some;
    }
}

} // namespace io::e57
