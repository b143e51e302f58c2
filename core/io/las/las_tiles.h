// A LAS file larger than memory, tile by tile: what looks at neighbours sees each point with all that it has to see.
//
//     LasTiles tiles(*LasBlocks::open(path), most, progress);
//     tiles.sweep(fn, progress)      fn(tile) decides about the tile's own points; tiles.drop(...) for those that go
//     tiles.write(out, progress)     every bit of the records that stay, in their order
//
// Tiles are columns of about as many points each, dense places have small ones. Around its own points a tile holds
// those of a margin, which has no width by itself: fn tells how much farther it had to see, and gets the tile again.
// What it decides is then what it would decide about the whole file. One thread at a time.
#pragma once

#include "core/io/las/las_blocks.h"
#include "core/surfel/surfel.h"

#include <functional>

namespace io {

struct LasTile {
    surfel::SurfelList points;          ///< positions alone, relative to the origin, in the file's order
    std::vector<std::uint64_t> records; ///< of each point
    std::vector<std::uint8_t> own;      ///< else it is of the margin
    float low[2] = {}, high[2] = {};    ///< in x and y: all points between them are there
};

class LasTiles {
  public:
    /// `most`: points of a tile, with its margin. Throws base::Cancelled.
    LasTiles(LasBlocks records, std::uint64_t most, const base::Progress& progress);

    std::size_t count() const { return m_tiles.size(); }
    std::uint64_t left() const { return m_left; }
    void drop(std::uint64_t record);
    /// `decide` returns by how much the margin is too narrow, 0 if it decided. Throws base::Error where a tile with its
    /// margin has more than `most` points.
    void sweep(const std::function<double(const LasTile&)>& decide, const base::Progress& progress) const;
    /// As LAS, with what its header counts.
    void write(const std::filesystem::path& path, const base::Progress& progress) const;

  private:
    /// In whole numbers of the file; the high ends are outside.
    struct Box {
        std::int64_t low[2], high[2];
    };
    void findBounds(const base::Progress& progress);
    void divide(const base::Progress& progress);
    LasTile load(const Box& own, double margin, const base::Progress& progress, double from, double to) const;
    std::string writtenHead(const base::Progress& progress) const;

    LasBlocks m_records;
    std::uint64_t m_most, m_left;
    base::Vec3d m_origin; ///< as the reader of the whole file chooses it
    Box m_bounds;
    std::vector<Box> m_tiles;
    std::vector<bool> m_stays;
};

} // namespace io
