#include "core/io/packed/inflate.h"
#include "core/io/packed/zip_archive.h"
#include "core/io/record_table.h"

#include <algorithm>
#include <limits>
#include <zlib.h>

namespace io {

namespace {

const char* const damaged = "the file is damaged or was cut off; fetch it again";
constexpr std::size_t inZip64 = 0xffffffffu;

/// Little-endian numbers at an offset; throws where the bytes end before.
class Numbers {
  public:
    explicit Numbers(const FileBytes& file) : m_file(file) {}
    template <class T>
    T at(std::size_t offset) const {
        return load<T, false>(text(offset, sizeof(T)).data());
    }
    std::size_t offset(std::uint64_t claimed) const {
        if (claimed > m_file.size())
            m_file.fail("its directory points outside of it", damaged);
        return static_cast<std::size_t>(claimed);
    }
    std::string_view text(std::size_t offset, std::size_t size) const {
        if (offset > m_file.size() || size > m_file.size() - offset)
            m_file.fail("the archive breaks off", damaged);
        return m_file.bytes().substr(offset, size);
    }

  private:
    const FileBytes& m_file;
};

struct Directory {
    std::size_t at = 0, count = 0;
};

Directory directoryOf(const FileBytes& file) {
    const Numbers numbers(file);
    const std::size_t end = file.bytes().rfind("PK\x05\x06");
    if (end == std::string_view::npos)
        file.fail("has no directory at its end", damaged);
    Directory out{
        numbers.offset(numbers.at<std::uint32_t>(end + 16) == inZip64 ? 0 : numbers.at<std::uint32_t>(end + 16)),
        numbers.at<std::uint16_t>(end + 10)};
    if (end >= 20 && numbers.text(end - 20, 4) == "PK\x06\x07") {
        const std::size_t far = numbers.offset(numbers.at<std::uint64_t>(end - 12));
        out = {numbers.offset(numbers.at<std::uint64_t>(far + 48)),
               static_cast<std::size_t>(numbers.at<std::uint64_t>(far + 32))};
    }
    return out;
}

/// What did not fit into 32 bits stands in an extra field, in this order.
void readZip64(const Numbers& numbers, std::size_t at, std::size_t size, std::initializer_list<std::uint64_t*> wanted) {
    for (const std::size_t end = at + size; at + 4 <= end;) {
        const auto kind = numbers.at<std::uint16_t>(at), length = numbers.at<std::uint16_t>(at + 2);
        at += 4;
        if (kind != 1) {
            at += length;
            continue;
        }
        std::size_t next = at;
        for (std::uint64_t* const value : wanted)
            if (*value == inZip64 && next + 8 <= at + length) {
                *value = numbers.at<std::uint64_t>(next);
                next += 8;
            }
        return;
    }
}

} // namespace

std::vector<ZipEntry> zipEntries(const FileBytes& file) {
    const Numbers numbers(file);
    const Directory directory = directoryOf(file);
    std::vector<ZipEntry> out;
    std::size_t at = directory.at;
    for (std::size_t i = 0; i < directory.count; ++i) {
        if (numbers.text(at, 46).substr(0, 4) != "PK\x01\x02")
            file.fail("its directory is damaged", damaged);
        const auto flags = numbers.at<std::uint16_t>(at + 8), method = numbers.at<std::uint16_t>(at + 10);
        std::uint64_t packed = numbers.at<std::uint32_t>(at + 20), size = numbers.at<std::uint32_t>(at + 24),
                      local = numbers.at<std::uint32_t>(at + 42);
        const std::size_t name = numbers.at<std::uint16_t>(at + 28), extra = numbers.at<std::uint16_t>(at + 30),
                          comment = numbers.at<std::uint16_t>(at + 32);
        ZipEntry entry{std::string(numbers.text(at + 46, name)), {}, numbers.at<std::uint32_t>(at + 16), method == 8};
        readZip64(numbers, at + 46 + name, extra, {&size, &packed, &local});
        at += 46 + name + extra + comment;
        if ((flags & 1) != 0 || (method != 0 && method != 8))
            continue; // encrypted, or packed in another way: not what models are in
        const std::size_t begin = numbers.offset(local);
        if (numbers.text(begin, 30).substr(0, 4) != "PK\x03\x04")
            file.fail("its directory is damaged", damaged);
        entry.packed =
            numbers.text(begin + 30 + numbers.at<std::uint16_t>(begin + 26) + numbers.at<std::uint16_t>(begin + 28),
                         numbers.offset(packed));
        out.push_back(std::move(entry));
    }
    return out;
}

void unpackEntry(const FileBytes& file, const ZipEntry& entry, const base::Progress& progress,
                 const std::function<void(std::string_view)>& sink) {
    const std::size_t most = mostInflated(entry.packed.size());
    uLong sum = ::crc32(0, nullptr, 0);
    const auto checked = [&](std::string_view piece) {
        sum = ::crc32(sum, reinterpret_cast<const Bytef*>(piece.data()), static_cast<uInt>(piece.size()));
        sink(piece);
    };
    if (!entry.deflated) {
        constexpr std::size_t step = std::size_t(1) << 20;
        for (std::size_t at = 0; at < entry.packed.size(); at += step) {
            progress.step(static_cast<double>(at) / static_cast<double>(entry.packed.size()), "Reading");
            checked(entry.packed.substr(at, step));
        }
    } else {
        const Inflated found = inflate(entry.packed, Wrapping::None, most, progress, checked);
        if (found.end == InflateEnd::TooLong)
            file.fail(inQuotes(entry.name) + " in it becomes more than " + std::to_string(most >> 20) +
                          " MiB when it is unpacked",
                      "do not open it, unless you trust it; then unpack it by yourself");
        if (found.end != InflateEnd::Whole)
            file.fail(inQuotes(entry.name) + " in it is damaged", damaged);
    }
    if (sum != entry.checksum)
        file.fail("the checksum of " + inQuotes(entry.name) + " in it is wrong", damaged);
}

std::string unpackedEntry(const FileBytes& file, const ZipEntry& entry, const base::Progress& progress) {
    std::string out;
    unpackEntry(file, entry, progress, [&](std::string_view piece) { out.append(piece); });
    return out;
}

} // namespace io
