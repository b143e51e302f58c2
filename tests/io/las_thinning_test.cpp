// LAS files thinned in passes: against brute force, the same bytes whatever the memory, and every bit of what stays.
#include "core/io/las/las_thinning.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/io/formats.h"
#include "io/io_support.h"
#include "support/registry.h"

#include <map>
#include <QTest>
#include <sys/stat.h>

using base::Vec3d;

class LasThinningTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatStaysIsAPoissonDisk();
    void memoryChangesNothing();
    void recordsKeepEveryBit();
    void whatDoesNotFitIsRefused();
    void othersAreLeftToTheirReaders();
};

namespace {

constexpr double grid = 0.001;

/// Records with an intensity, far from zero: twenty times as dense on one side, with coincident points and strays.
io::FileModel uneven(std::size_t count, base::Random& random) {
    io::FileModel out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->add("intensity", surfel::ScalarType::UInt16);
    out.points.layout = layout;
    out.origin = {1e7, -3e6, 0};
    while (out.points.size() < count) {
        const Vec3d p{10 * std::pow(20.0, -random.uniform()), random.uniform(0, 8),
                      random.uniform() < 0.01 ? random.uniform(0, 9) : 1};
        surfel::Surfel s;
        for (std::size_t k = 0; k < 3; ++k)
            s.position[k] = static_cast<float>(std::round(p[k] / grid) * grid);
        const std::uint32_t words[] = {static_cast<std::uint32_t>(out.points.size() % 60000)};
        out.points.append(s, words);
        if (random.uniform() < 0.02)
            out.points.append(s, words);
    }
    return out;
}

struct Scene {
    base::Random random{test::seed()};
    QTemporaryDir dir;
    std::filesystem::path path = dir.filePath("scan.las").toStdString();
    io::FileModel model;

    explicit Scene(std::size_t count) : model(uneven(count, random)) {
        io::write(path, model);
        model = io::read(path); // on the file's grid
    }
    io::ThinnedLas thinned(double spacing, std::uint64_t memory) const {
        return *io::thinnedLas(path, spacing, memory);
    }
};

std::vector<Vec3d> positionsOf(const io::FileModel& model) {
    std::vector<Vec3d> out;
    for (const surfel::Surfel& s : model.points.items)
        out.push_back(base::cast<double>(s.position) + model.origin);
    return out;
}

io::FileModel opened(const io::ThinnedLas& thinned) {
    return io::read(io::FileBytes("scan.las", thinned.content), {}, {});
}

QByteArray seed() {
    return "seed " + QByteArray::number(test::seed());
}

} // namespace

void LasThinningTest::whatStaysIsAPoissonDisk() {
    const Scene scene(6000);
    const std::vector<Vec3d> all = positionsOf(scene.model);
    for (const double spacing : {0.05, 0.31, 2.0}) {
        const io::ThinnedLas found = scene.thinned(spacing, 1u << 30);
        QVERIFY(found.passes == 1 && found.read == all.size());
        const std::vector<Vec3d> kept = positionsOf(opened(found));
        QCOMPARE(kept.size(), std::size_t(found.kept));
        const double rounding = 1e-6;
        for (std::size_t i = 0; i < kept.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY2(distance(kept[i], kept[j]) > spacing - rounding, seed());
        for (const Vec3d& p : all)
            QVERIFY2(std::any_of(kept.begin(), kept.end(),
                                 [&](const Vec3d& q) { return distance(p, q) < spacing + rounding; }),
                     seed());
    }
}

void LasThinningTest::memoryChangesNothing() {
    const Scene scene(30000);
    const io::ThinnedLas once = scene.thinned(0.4, 1u << 30);
    for (const std::uint64_t memory : {std::uint64_t(600) << 10, std::uint64_t(1200) << 10}) {
        const io::ThinnedLas often = scene.thinned(0.4, memory);
        QVERIFY(often.passes > 1);
        QVERIFY2(often.content == once.content, seed());
    }
}

void LasThinningTest::recordsKeepEveryBit() {
    const Scene scene(5000);
    const io::FileModel kept = opened(scene.thinned(0.2, 1u << 30));
    const auto placed = [](const io::FileModel& model) {
        std::multimap<std::array<double, 3>, double> out;
        const surfel::Attribute& intensity = *model.points.layout->find("intensity");
        const std::vector<Vec3d> at = positionsOf(model);
        for (std::size_t i = 0; i < at.size(); ++i)
            out.insert({{std::round(at[i].x / grid), std::round(at[i].y / grid), std::round(at[i].z / grid)},
                        surfel::read(intensity, model.points.extraOf(i))});
        return out;
    };
    const auto all = placed(scene.model), few = placed(kept);
    QVERIFY(few.size() > 100 && few.size() < all.size());
    for (const auto& [at, value] : few) {
        const auto [first, last] = all.equal_range(at);
        QVERIFY2(std::any_of(first, last, [v = value](const auto& each) { return each.second == v; }), seed());
    }
}

void LasThinningTest::whatDoesNotFitIsRefused() {
    const Scene scene(5000);
    QVERIFY_THROWS_EXCEPTION(base::Error, io::thinnedLas(scene.path, 0.001, 100000));
    const std::atomic<bool> cancel = true;
    QVERIFY_THROWS_EXCEPTION(base::Cancelled, io::thinnedLas(scene.path, 0.1, 1u << 30, {{}, &cancel}));
}

void LasThinningTest::othersAreLeftToTheirReaders() {
    const Scene scene(2000);
    const std::filesystem::path laz = scene.dir.filePath("scan.laz").toStdString(),
                                cut = scene.dir.filePath("cut.las").toStdString();
    io::write(laz, scene.model);
    QVERIFY(!io::thinnedLas(laz, 0.1, 1u << 30));
    QVERIFY(!io::thinnedLas("nowhere.las", 0.1, 1u << 30));
    QVERIFY(!io::thinnedLas(scene.dir.path().toStdString(), 0.1, 1u << 30));
    const std::string fifo = scene.dir.filePath("fifo").toStdString();
    QVERIFY(::mkfifo(fifo.c_str(), 0600) == 0);
    QVERIFY(!io::thinnedLas(fifo, 0.1, 1u << 30)); // nor waits for who writes to it
    std::filesystem::copy_file(scene.path, cut);
    for (const std::uintmax_t size : {std::filesystem::file_size(cut) - 1, std::uintmax_t(300), std::uintmax_t(100)}) {
        std::filesystem::resize_file(cut, size);
        QVERIFY(!io::thinnedLas(cut, 0.1, 1u << 30));
    }
}

static const test::Registered<LasThinningTest> registered;
#include "las_thinning_test.moc"
