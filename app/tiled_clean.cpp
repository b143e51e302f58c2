#include "app/tiled_clean.h"

#include "core/base/error.h"
#include "core/io/file_name.h"
#include "core/io/las/las_tiles.h"
#include "core/process/cleaning/missing_sight.h"
#include "core/process/estimation/duplicates.h"
#include "core/process/estimation/part_progress.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

namespace app {

using nlohmann::json, nlohmann::ordered_json;

namespace {

/// Bytes that a point takes while its neighbours are looked at; measured.
constexpr std::uint64_t perPoint = 450;

/// Throws base::Error for what is no matter of neighbours, or not of points that go.
void refuseWholes(const json& command) {
    static constexpr const char* steps[][2] = {
        {"denoise", "it moves points, and tiles only take points out"},
        {"thin", "convert --thin does it in any memory"},
        {"normals", "it changes points, and tiles only take points out"},
        {"orient", "which side is outside the whole decides"},
        {"mixed", "the scanner sees points beside each other that are any distance apart"}};
    for (const auto& [step, why] : steps) {
        const json value = command.value(step, json());
        if (!value.is_null() && value != false)
            throw base::Error("--" + std::string(step) + " does not work in tiles: " + why, {},
                              "give more --memory, or leave it out");
    }
}

process::OutlierWay wayOf(const std::string& name) {
    if (name == "islands")
        throw base::Error("--outliers islands does not work in tiles: a piece may be as large as the file", {},
                          "give more --memory, or choose another way");
    return name == "radius"    ? process::OutlierWay::Radius
           : name == "surface" ? process::OutlierWay::Surface
                               : process::OutlierWay::Statistical;
}

/// A way of finding outliers, by its name.
struct Wish {
    std::string way;
    process::OutlierQuestion question;
};

/// In the order in which they are asked for. Throws base::Error for those that do not work in tiles.
std::vector<Wish> wishesOf(const json& command) {
    const json outliers = command.value("outliers", json()), limit = command.value("limit", json());
    const json ways = outliers.is_array() || outliers.is_null() ? outliers : json::array({outliers});
    if (ways.size() > 1 && !limit.is_null())
        throw base::Error("\"limit\" means something else to each way of finding outliers", {},
                          "give one way, or several without a limit");
    std::vector<Wish> out;
    for (const json& way : ways) {
        const auto name = way.get<std::string>();
        out.push_back({name, {wayOf(name), {}}});
        if (!limit.is_null())
            out.back().question.limit = limit.get<double>();
    }
    return out;
}

class TiledClean {
  public:
    TiledClean(io::LasTiles& tiles, base::Progress progress) : m_tiles(tiles), m_progress(std::move(progress)) {}

    /// Takes points of their own away that duplicates are, as opening a file does. Returns how many.
    std::uint64_t duplicates(double from, double to) {
        return sweep(from, to, [&](const process::Cloud& cloud, std::vector<std::uint8_t>& gone) {
            const process::CloudNeighbours near = process::neighboursOf(cloud, 0, quiet());
            const std::vector<std::uint32_t> first = process::firstOfDuplicates(cloud, near, quiet());
            for (std::size_t i = 0; i < first.size(); ++i)
                gone[i] = first[i] != i;
        });
    }
    std::uint64_t outliers(const process::OutlierQuestion& question, double from, double to) {
        return sweep(from, to, [&](const process::Cloud& cloud, std::vector<std::uint8_t>& gone) {
            const std::vector<std::uint8_t> found = process::findOutliers(cloud, question, quiet());
            for (std::size_t i = 0; i < gone.size(); ++i)
                gone[i] = found[cloud.places()[i]];
        });
    }

    /// Points that were judged among a choice of the file, with each question again.
    std::uint64_t chosen() const { return m_chosen; }

  private:
    /// Tiles are told of by their reading.
    base::Progress quiet() const { return {{}, m_progress.cancel}; }

    /// find(cloud, gone): what goes of a tile's points. All is decided before anything is dropped, so that
    /// tiles see what the whole would see.
    template <class Find>
    std::uint64_t sweep(double from, double to, const Find& find) {
        std::vector<std::uint64_t> dropped;
        m_chosen += m_tiles.sweep(
            [&](const io::LasTile& tile, io::LasSight sight) {
                io::LasDecision out;
                if (tile.points.size() == 0)
                    return out;
                const process::Cloud cloud(tile.points.items, quiet());
                std::vector<std::uint8_t> gone(tile.points.size());
                const std::vector<float> missing = process::missingSight(cloud, tile.low, tile.high, quiet());
                for (std::size_t i = 0; i < gone.size(); ++i)
                    if (tile.own[i])
                        out.missing = std::max(out.missing, static_cast<double>(missing[cloud.places()[i]]));
                if (out.missing > 0 && sight == io::LasSight::OfAll)
                    return out;
                find(cloud, gone);
                for (std::size_t i = 0; i < gone.size(); ++i)
                    if (tile.own[i] && missing[cloud.places()[i]] > 0)
                        out.blind.push_back(tile.records[i]);
                    else if (tile.own[i] && gone[i])
                        dropped.push_back(tile.records[i]);
                return out;
            },
            process::part(m_progress, from, to));
        for (const std::uint64_t record : dropped)
            m_tiles.drop(record);
        return dropped.size();
    }

    io::LasTiles& m_tiles;
    base::Progress m_progress;
    std::uint64_t m_chosen = 0;
};

} // namespace

bool needsTiles(const std::string& in, std::uint64_t memory) {
    std::error_code unknown;
    const std::uint64_t size = std::filesystem::file_size(in, unknown);
    if (unknown)
        return false;
    const std::optional<io::LasBlocks> records = io::LasBlocks::open(in);
    return (records ? records->size() * perPoint : 20 * size) > memory;
}

ordered_json cleanInTiles(const std::string& in, const std::string& out, const json& command, std::uint64_t memory,
                          bool dryRun, std::vector<std::string>& messages, const base::Progress& progress) {
    refuseWholes(command);
    std::optional<io::LasBlocks> records = io::LasBlocks::open(in);
    if (!records)
        throw base::Error("only LAS files that are not compressed are cleaned in tiles", in,
                          "convert it to LAS, or give more --memory");
    if (!dryRun && io::extensionOf(out) != "las")
        throw base::Error("what was cleaned in tiles is written as LAS alone", out, "name it .las");
    const std::vector<Wish> wishes = wishesOf(command);
    ordered_json report;
    const std::uint64_t read = records->size();
    io::LasTiles tiles(std::move(*records), memory / perPoint, process::part(progress, 0, 0.1));
    TiledClean clean(tiles, progress);
    const double share = 0.8 / static_cast<double>(wishes.size() + 1); // of a sweep
    double from = 0.1 + share;
    const std::uint64_t merged = clean.duplicates(0.1, from);
    report["read"] = read, report["merged"] = merged, report["tiles"] = tiles.count();
    std::uint64_t all = 0;
    for (const Wish& wish : wishes) {
        const std::uint64_t before = tiles.left(), found = clean.outliers(wish.question, from, from + share);
        from += share, all += found;
        report["outliers"]["by"][wish.way] = found;
        messages.push_back("Outliers (" + wish.way + "): " + std::to_string(found) + " of " + std::to_string(before) +
                           " points removed.");
    }
    if (!wishes.empty())
        report["outliers"]["removed"] = all;
    report["surfels"] = tiles.left();
    messages.insert(messages.begin(), std::to_string(read) + " points were read in " + std::to_string(tiles.count()) +
                                          (tiles.count() == 1 ? " tile, " : " tiles, ") + std::to_string(merged) +
                                          " stood in the place of others and were merged with them.");
    if (clean.chosen() > 0)
        messages.push_back(std::to_string(clean.chosen()) +
                           " times a point stood so far from all others that it was compared with an even choice of "
                           "the file.");
    if (!wishes.empty())
        messages.emplace_back("Swarms of strays were looked for in each tile by itself.");
    if (!dryRun)
        tiles.write(out, process::part(progress, 0.9, 1));
    return report;
}

} // namespace app
