// LAS files gone through tile by tile: each record is some tile's own, tiles end where they see enough, and what is
// written is what stayed.
#include "core/io/las/las_tiles.h"

#include "core/base/random.h"
#include "core/io/formats.h"
#include "io/io_support.h"
#include "support/registry.h"

#include <cstring>
#include <fstream>
#include <QTest>

using base::Vec3d;

class LasTilesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void eachRecordIsOneTilesOwn();
    void marginsThatLackNextToNothingGrow();
    void whatStandsBehindTheRecordsIsWrittenBehindThem();
};

namespace {

struct Scene {
    QTemporaryDir dir;
    std::filesystem::path path = dir.filePath("scan.las").toStdString();

    explicit Scene(std::size_t count) {
        base::Random random(test::seed());
        io::FileModel model;
        for (std::size_t k = 0; k < count; ++k) {
            surfel::Surfel s;
            s.position = {float(random.uniform(0, 9)), float(random.uniform(0, 4)), float(random.uniform())};
            model.points.items.push_back(s);
        }
        io::write(path, model);
    }
    io::LasTiles tiles(std::uint64_t most) const { return {*io::LasBlocks::open(path), most, {}}; }
};

template <class T>
T at(const std::string& bytes, std::size_t place) {
    T out;
    std::memcpy(&out, bytes.data() + place, sizeof out);
    return out;
}

} // namespace

void LasTilesTest::eachRecordIsOneTilesOwn() {
    const Scene scene(5000);
    const io::LasTiles tiles = scene.tiles(1500);
    QVERIFY(tiles.count() >= 10);
    std::vector<int> owners(5000);
    tiles.sweep(
        [&](const io::LasTile& tile, io::LasSight) {
            for (std::size_t i = 0; i < tile.records.size(); ++i)
                owners[tile.records[i]] += tile.own[i];
            return io::LasDecision();
        },
        {});
    QVERIFY(owners == std::vector<int>(5000, 1));
}

/// Each time is a pass over the file.
void LasTilesTest::marginsThatLackNextToNothingGrow() {
    const Scene scene(500);
    const io::LasTiles tiles = scene.tiles(600);
    QVERIFY(tiles.count() > 2);
    int passes = 0;
    tiles.sweep(
        [&](const io::LasTile& tile, io::LasSight) {
            ++passes;
            const bool whole = std::isinf(tile.low[0]) && std::isinf(tile.high[0]) && std::isinf(tile.low[1]) &&
                               std::isinf(tile.high[1]);
            return io::LasDecision{whole || passes > 1000 ? 0 : 1e-9, {}};
        },
        {});
    QVERIFY2(passes < 100 * int(tiles.count()), QByteArray::number(passes));
}

void LasTilesTest::whatStandsBehindTheRecordsIsWrittenBehindThem() {
    const Scene scene(400);
    std::string tail(3 << 20, '\0'); // more than is read at once
    base::Random random(test::seed());
    for (char& each : tail)
        each = static_cast<char>(random.below(256));
    std::ofstream(scene.path, std::ios::binary | std::ios::app) << tail;
    io::LasTiles tiles = scene.tiles(1500);
    for (const std::uint64_t record : {3, 70, 399})
        tiles.drop(record);
    const std::filesystem::path out = scene.dir.filePath("out.las").toStdString();
    tiles.write(out, {});
    std::ifstream in(out, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    QCOMPARE(io::LasBlocks::open(out)->size(), std::uint64_t{397});
    QCOMPARE(bytes.size(), at<std::uint32_t>(bytes, 96) + 397 * at<std::uint16_t>(bytes, 105) + tail.size());
    QVERIFY(bytes.ends_with(tail));
}

static const test::Registered<LasTilesTest> registered;
#include "las_tiles_test.moc"
