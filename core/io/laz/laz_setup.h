// What a LAZ file says of its compression (the record of LASzip) and where its chunks lie (io/README 2.13).
#pragma once

#include "core/io/las/las_header.h"
#include "core/io/laz/layered_points.h"

namespace io::laz {

/// Kinds of items by LASzip's numbers.
enum class Item : unsigned {
    Byte = 0,
    Point10 = 6,
    Gps11 = 7,
    Rgb12 = 8,
    Wave13 = 9,
    Point14 = 10,
    Rgb14 = 11,
    RgbNir14 = 12,
    Wave14 = 13,
    Byte14 = 14
};

struct ItemRow {
    Item item = Item::Byte;
    std::size_t size = 0;
    unsigned version = 0;
};

struct Setup {
    std::vector<ItemRow> items; ///< in the order of the record
    std::size_t stride = 0;
    bool layered = false;
    bool chunked = true;
    std::uint32_t chunkPoints = 50000; ///< variableChunks: each says how many
};

constexpr std::uint32_t variableChunks = 0xffffffffu;

/// The items that a point format is made of, with the versions that are written.
Setup setupOf(const LasLayout& layout, std::size_t stride);
/// The record of LASzip, whole, for a writer.
std::string recordOf(const Setup& setup);
/// Of a file. Throws base::Error where it has none or asks for what is not known.
Setup parseSetup(const FileBytes& file, const LasHeader& header);

struct Chunk {
    std::size_t at = 0, bytes = 0;
    std::uint64_t points = 0;
};

/// Checked against the size of the file; their points are those of the header.
std::vector<Chunk> chunksOf(const FileBytes& file, const LasHeader& header, const Setup& setup);
/// The table of chunks (their sizes in bytes), for a writer.
std::string chunkTable(const std::vector<Chunk>& chunks);

/// Appends the records of a chunk to `out`, which grows with what the bytes tell, not with what they claim. False where
/// they are damaged. Throws base::Cancelled.
bool unpackChunk(std::string_view bytes, const Setup& setup, std::uint64_t points, std::string& out);
/// `records` lie side by side and are at least one.
std::string packChunk(std::string_view records, const Setup& setup);

} // namespace io::laz
