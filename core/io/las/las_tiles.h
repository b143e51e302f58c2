// A LAS file larger than memory, tile by tile: what looks at neighbours sees each point with all that it has to see.
//
//     LasTiles tiles(*LasBlocks::open(path), most, progress);
//     tiles.sweep(fn, progress)      fn(tile) decides about the tile's own points; tiles.drop(...) for those that go
//     tiles.write(out, progress)     every bit of the records that stay, in their order
//
// Tiles are columns of about as many points each, dense places have small ones. Around its own points a tile holds
// those of a margin, which has no width by itself: fn tells how much farther it had to see, and gets the tile again.
// What it decides is then what it would decide about the whole file. Strays may be so far from everything that a margin
// that shows them their neighbours holds more points than memory: they are decided about among an even choice of the
// file. One thread at a time.
#pragma once

#include "core/io/las/las_blocks.h"
#include "core/surfel/surfel.h"

#include <functional>
#include <optional>

namespace io {

struct LasTile {
    surfel::SurfelList points;          ///< positions alone, relative to the origin, in the file's order
    std::vector<std::uint64_t> records; ///< of each point
    std::vector<std::uint8_t> own;      ///< else it is of the margin
    float low[2] = {}, high[2] = {};    ///< in x and y: all points between them are there
};

/// Who is decided about: all of a tile's own, if all see what they have to, or those who do.
enum class LasSight { OfAll, OfEach };

struct LasDecision {
    double missing = 0;               ///< by how much the margin is too narrow
    std::vector<std::uint64_t> blind; ///< records that nothing was decided about; with LasSight::OfEach alone
};

class LasTiles {
  public:
    /// `most`: points of a tile, with its margin. Throws base::Cancelled.
    LasTiles(LasBlocks records, std::uint64_t most, const base::Progress& progress);

    std::size_t count() const { return m_tiles.size(); }
    std::uint64_t left() const { return m_left; }
    void drop(std::uint64_t record);
    using Decide = std::function<LasDecision(const LasTile&, LasSight)>;
    /// Returns how many records were decided about among a choice. Throws base::Error where a tile with the least
    /// margin has more than `most` points.
    std::uint64_t sweep(const Decide& decide, const base::Progress& progress) const;
    /// As LAS, with what its header counts.
    void write(const std::filesystem::path& path, const base::Progress& progress) const;

  private:
    /// In whole numbers of the file; the high ends are outside.
    struct Box {
        std::int64_t low[2], high[2];
    };
    void findBounds(const base::Progress& progress);
    void divide(const Box& box, const base::Progress& progress, double from, double to);
    /// None where it has too many points.
    std::optional<LasTile> load(const Box& own, double margin, const base::Progress& progress, double from,
                                double to) const;
    LasTile among(const Box& own, const std::vector<std::uint64_t>& blind, const base::Progress& progress, double from,
                  double to) const;
    bool add(LasTile& tile, std::uint64_t number, const char* record, bool own) const;
    std::string writtenHead(const base::Progress& progress) const;

    LasBlocks m_records;
    std::uint64_t m_most, m_left;
    base::Vec3d m_origin; ///< as the reader of the whole file chooses it
    Box m_bounds;
    std::vector<Box> m_tiles;
    std::vector<bool> m_stays;
};

} // namespace io
