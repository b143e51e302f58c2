#include "core/io/las/las_header.h"

#include <algorithm>
#include <cmath>

namespace io {

static const char* const damaged = "the file is damaged or was cut off; fetch it again";

namespace {

class HeaderReader {
  public:
    explicit HeaderReader(const FileBytes& file) : m_file(file) {}
    LasHeader read();

  private:
    template <class T>
    T at(std::size_t offset) const {
        return load<T, false>(m_file.bytes().data() + offset);
    }
    void readCounts(LasHeader& out) const;
    void readScales(LasHeader& out) const;
    void readRecords(LasHeader& out, std::size_t headerSize, std::size_t count) const;

    const FileBytes& m_file;
};

std::string textOf(std::string_view bytes) {
    return std::string(bytes.substr(0, std::min(bytes.find('\0'), bytes.size())));
}

void HeaderReader::readRecords(LasHeader& out, std::size_t headerSize, std::size_t count) const {
    std::size_t at = headerSize;
    for (std::size_t k = 0; k < count; ++k) {
        if (at + lasRecordHead > out.pointsAt)
            m_file.failAtByte(at, "the header declares more records than there are before the points", damaged);
        const std::size_t size = this->at<std::uint16_t>(at + 20);
        if (size > out.pointsAt - at - lasRecordHead)
            m_file.failAtByte(at, "a record reaches into the points", damaged);
        const std::string_view whole = m_file.bytes().substr(at, lasRecordHead + size);
        out.records.push_back(
            {textOf(whole.substr(2, 16)), this->at<std::uint16_t>(at + 18), whole, whole.substr(lasRecordHead)});
        at += whole.size();
    }
}

void HeaderReader::readCounts(LasHeader& out) const {
    out.points = at<std::uint32_t>(107);
    if (out.minor >= 4 && out.points == 0)
        out.points = at<std::uint64_t>(247);
    if (out.points == 0)
        m_file.fail("holds no points", "choose a file with at least one");
    const std::size_t least = lasLayout(out.format).size;
    if (out.stride < least)
        m_file.fail("the header has records of " + std::to_string(out.stride) + " bytes where point format " +
                        std::to_string(out.format) + " needs " + std::to_string(least),
                    damaged);
    const std::size_t room = (m_file.size() - out.pointsAt) / out.stride;
    if (!out.compressed && out.points > room)
        m_file.fail("the header declares " + std::to_string(out.points) + " points, but the body holds " +
                        std::to_string(room),
                    damaged);
}

void HeaderReader::readScales(LasHeader& out) const {
    for (std::size_t k = 0; k < 3; ++k) {
        out.scale[k] = at<double>(131 + 8 * k);
        out.offset[k] = at<double>(155 + 8 * k);
        if (!std::isfinite(out.scale[k]) || out.scale[k] == 0 || !std::isfinite(out.offset[k]))
            m_file.fail("the header's scale or offset of the coordinates is no usable number", damaged);
    }
}

LasHeader HeaderReader::read() {
    if (!m_file.bytes().starts_with("LASF") || m_file.size() < 227)
        m_file.fail("is no LAS or LAZ file", "choose one that begins with LASF");
    LasHeader out;
    const unsigned major = at<std::uint8_t>(24);
    out.minor = at<std::uint8_t>(25);
    if (major != 1 || out.minor > 4)
        m_file.fail("is LAS " + std::to_string(major) + "." + std::to_string(out.minor) + ", which is not known",
                    "convert it to LAS 1.4");
    const std::size_t headerSize = at<std::uint16_t>(94), least = out.minor >= 4 ? 375 : 227;
    out.pointsAt = at<std::uint32_t>(96);
    if (headerSize < least || headerSize > m_file.size() || out.pointsAt < headerSize || out.pointsAt > m_file.size())
        m_file.fail("the header claims places that are not in the file", damaged);
    out.encoding = at<std::uint16_t>(6);
    const unsigned format = at<std::uint8_t>(104);
    out.compressed = (format & 0xc0) != 0;
    out.format = format & 0x3f;
    if (out.format >= lasFormats)
        m_file.fail("has point format " + std::to_string(out.format) + ", which is not known",
                    "convert it to one of 0 to 10");
    out.stride = at<std::uint16_t>(105);
    readCounts(out);
    readScales(out);
    readRecords(out, headerSize, at<std::uint32_t>(100));
    return out;
}

/// Types of extra bytes, from 1 on; those of 8 bytes that are whole numbers are none of ours.
constexpr ScalarType extraTypes[11] = {ScalarType::UInt8,   ScalarType::UInt8,   ScalarType::Int8,
                                       ScalarType::UInt16,  ScalarType::Int16,   ScalarType::UInt32,
                                       ScalarType::Int32,   ScalarType::Float64, ScalarType::Float64,
                                       ScalarType::Float32, ScalarType::Float64};

} // namespace

const LasRecord* LasHeader::find(std::string_view user, unsigned id) const {
    for (const LasRecord& record : records)
        if (record.user == user && record.id == id)
            return &record;
    return nullptr;
}

LasHeader parseLasHeader(const FileBytes& file) {
    return HeaderReader(file).read();
}

std::vector<LasField> extraFields(const LasHeader& header, std::size_t size, std::vector<std::string>* leftOut) {
    constexpr std::size_t entry = 192;
    std::vector<LasField> out;
    const LasRecord* record = header.find("LASF_Spec", 4);
    for (std::size_t at = 0; record && at + entry <= record->data.size(); at += entry) {
        const char* const bytes = record->data.data() + at;
        const unsigned type = static_cast<unsigned char>(bytes[2]), options = static_cast<unsigned char>(bytes[3]);
        const unsigned scalar = type > 10 ? (type - 1) % 10 + 1 : type, elements = type > 10 ? (type - 1) / 10 + 1 : 1;
        const std::size_t each = type == 0 ? options : sizeOf(extraTypes[scalar]);
        const std::string name = textOf({bytes + 4, 32});
        for (unsigned k = 0; k < elements && type <= 30; ++k, size += each) {
            if (size + each > header.stride)
                return out;
            if (type == 0 || scalar == 7 || scalar == 8) {
                if (leftOut && each > 0)
                    leftOut->push_back(inQuotes(name));
                continue;
            }
            LasField field{elements == 1 ? name : name + "_" + std::to_string(k + 1), extraTypes[scalar], size};
            const auto scale = load<double, false>(bytes + 112 + 8 * k);
            const auto plus = load<double, false>(bytes + 136 + 8 * k);
            if ((options & 8) != 0 && std::isfinite(scale) && scale != 0)
                field.scale = scale;
            if ((options & 16) != 0 && std::isfinite(plus))
                field.plus = plus;
            out.push_back(field);
        }
    }
    return out;
}

} // namespace io
