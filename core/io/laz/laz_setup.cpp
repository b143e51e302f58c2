#include "core/io/laz/laz_setup.h"

#include <algorithm>

namespace io::laz {

static const char* const damaged = "the file is damaged or was cut off; fetch it again";
static constexpr std::string_view recordUser = "laszip encoded";
static constexpr unsigned recordId = 22204;

/// No point takes less than a two-thousandth of a byte: the coder gives no symbol more than 32767 of 32768 parts.
static constexpr std::uint64_t mostPointsPerByte = 2000;

Setup setupOf(const LasLayout& layout, std::size_t stride) {
    Setup out;
    out.stride = stride;
    out.layered = layout.isLayered;
    const auto add = [&](Item item, std::size_t size, unsigned version) { out.items.push_back({item, size, version}); };
    if (layout.isLayered) {
        add(Item::Point14, 30, 3);
        if (layout.nir > 0)
            add(Item::RgbNir14, 8, 3);
        else if (layout.rgb > 0)
            add(Item::Rgb14, 6, 3);
        if (stride > layout.size)
            add(Item::Byte14, stride - layout.size, 3);
        return out;
    }
    add(Item::Point10, 20, 2);
    if (layout.find("gps_time"))
        add(Item::Gps11, 8, 2);
    if (layout.rgb > 0)
        add(Item::Rgb12, 6, 2);
    if (stride > layout.size)
        add(Item::Byte, stride - layout.size, 2);
    return out;
}

std::string recordOf(const Setup& setup) {
    std::string out(lasRecordHead + 34 + 6 * setup.items.size(), '\0');
    recordUser.copy(out.data() + 2, recordUser.size());
    set(out.data() + 18, static_cast<std::uint16_t>(recordId));
    set(out.data() + 20, static_cast<std::uint16_t>(out.size() - lasRecordHead));
    char* const data = out.data() + lasRecordHead;
    set(data, static_cast<std::uint16_t>(setup.layered ? 3 : 2));
    data[4] = setup.layered ? 3 : 2; // of LASzip, which began with these numbers to write such files
    data[5] = setup.layered ? 4 : 2;
    set(data + 12, setup.chunkPoints);
    set(data + 16, std::int64_t(-1));
    set(data + 24, std::int64_t(-1));
    set(data + 32, static_cast<std::uint16_t>(setup.items.size()));
    for (std::size_t k = 0; k < setup.items.size(); ++k) {
        set(data + 34 + 6 * k, static_cast<std::uint16_t>(setup.items[k].item));
        set(data + 36 + 6 * k, static_cast<std::uint16_t>(setup.items[k].size));
        set(data + 38 + 6 * k, static_cast<std::uint16_t>(setup.items[k].version));
    }
    return out;
}

namespace {

/// Whether the item is known in that version and has the size that it must have.
bool isKnown(const ItemRow& row) {
    switch (row.item) {
    case Item::Byte:
        return row.size > 0 && row.version == 2;
    case Item::Point10:
        return row.size == Point10::size && row.version == 2;
    case Item::Gps11:
        return row.size == GpsTime::size && row.version == 2;
    case Item::Rgb12:
        return row.size == Rgb::size && row.version == 2;
    case Item::Wave13:
        return row.size == WavePacket::size && row.version == 1;
    case Item::Point14:
        return row.size == 30 && (row.version == 3 || row.version == 4);
    case Item::Rgb14:
        return row.size == Rgb::size && (row.version == 3 || row.version == 4);
    case Item::RgbNir14:
        return row.size == Rgb::size + Nir::size && (row.version == 3 || row.version == 4);
    case Item::Wave14:
        return row.size == WavePacket::size && (row.version == 3 || row.version == 4);
    case Item::Byte14:
        return row.size > 0 && (row.version == 3 || row.version == 4);
    }
    return false;
}

bool isLayered(Item item) {
    return item >= Item::Point14;
}

} // namespace

Setup parseSetup(const FileBytes& file, const LasHeader& header) {
    const LasRecord* record = header.find(recordUser, recordId);
    if (!record || record->data.size() < 34)
        file.fail("is compressed, but has no record of LASzip that tells how", damaged);
    const char* const data = record->data.data();
    const unsigned compressor = get<std::uint16_t>(data), coder = get<std::uint16_t>(data + 2);
    const std::size_t count = get<std::uint16_t>(data + 32);
    if (compressor < 1 || compressor > 3 || coder != 0 || record->data.size() < 34 + 6 * count)
        file.fail("is compressed in a way of LASzip that is not known", "convert it to LAS");
    Setup out;
    out.stride = header.stride;
    out.layered = compressor == 3;
    out.chunked = compressor != 1;
    out.chunkPoints = get<std::uint32_t>(data + 12);
    std::size_t size = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const char* const at = data + 34 + 6 * k;
        const ItemRow row{static_cast<Item>(get<std::uint16_t>(at)), get<std::uint16_t>(at + 2),
                          get<std::uint16_t>(at + 4)};
        const bool first = k == 0;
        if (!isKnown(row) || isLayered(row.item) != out.layered ||
            first != (row.item == Item::Point10 || row.item == Item::Point14))
            file.fail("is compressed with item " + std::to_string(static_cast<unsigned>(row.item)) + " in version " +
                          std::to_string(row.version) + ", which is not known",
                      "compress it again with a newer LASzip");
        size += row.size;
        out.items.push_back(row);
    }
    if (out.items.empty() || size != out.stride || out.layered != lasLayout(header.format).isLayered)
        file.fail("the record of LASzip contradicts the point format", damaged);
    return out;
}

std::vector<Chunk> chunksOf(const FileBytes& file, const LasHeader& header, const Setup& setup) {
    const std::string_view bytes = file.bytes();
    std::vector<Chunk> out;
    const auto take = [&](std::size_t at, std::uint64_t size, std::uint64_t points) {
        if (size > bytes.size() - at || size < setup.stride || points == 0 || points / mostPointsPerByte > size)
            file.failAtByte(at, "the chunks of points do not fit the file", damaged);
        out.push_back({at, static_cast<std::size_t>(size), points});
    };
    if (!setup.chunked) {
        take(header.pointsAt, bytes.size() - header.pointsAt, header.points);
        return out;
    }
    if (bytes.size() - header.pointsAt < 8)
        file.fail("ends before its points", damaged);
    auto table = get<std::int64_t>(bytes.data() + header.pointsAt);
    if (table == -1)
        table = get<std::int64_t>(bytes.data() + bytes.size() - 8);
    std::size_t at = header.pointsAt + 8;
    if (table < static_cast<std::int64_t>(at) || static_cast<std::uint64_t>(table) + 8 > bytes.size())
        file.fail("has no table of its chunks", damaged);
    const auto place = static_cast<std::size_t>(table);
    const std::size_t count = get<std::uint32_t>(bytes.data() + place + 4);
    if (get<std::uint32_t>(bytes.data() + place) != 0 || count > (place - at) / setup.stride)
        file.failAtByte(place, "the table of chunks makes no sense", damaged);
    Decoder decoder(bytes.substr(place + 8));
    IntegerModel numbers(32, 2);
    std::uint64_t left = header.points;
    std::int32_t lastPoints = 0, lastBytes = 0;
    for (std::size_t k = 0; k < count && left > 0; ++k) {
        if (setup.chunkPoints == variableChunks)
            lastPoints = numbers.code(decoder, lastPoints, 0, 0);
        lastBytes = numbers.code(decoder, lastBytes, 0, 1);
        const std::uint64_t said = setup.chunkPoints == variableChunks ? static_cast<std::uint32_t>(lastPoints)
                                                                       : std::uint64_t(setup.chunkPoints);
        take(at, static_cast<std::uint32_t>(lastBytes), std::min(said, left));
        left -= out.back().points;
        at += out.back().bytes;
    }
    if (left > 0 || decoder.overran() || at > place)
        file.fail("the header declares " + std::to_string(header.points) + " points, but the chunks hold " +
                      std::to_string(header.points - left),
                  damaged);
    return out;
}

std::string chunkTable(const std::vector<Chunk>& chunks) {
    std::string out(8, '\0');
    set(out.data() + 4, static_cast<std::uint32_t>(chunks.size()));
    Encoder encoder;
    IntegerModel numbers(32, 2);
    std::int32_t last = 0;
    for (const Chunk& chunk : chunks)
        last = numbers.code(encoder, last, static_cast<std::int32_t>(chunk.bytes), 1);
    return out + encoder.finish();
}

} // namespace io::laz
