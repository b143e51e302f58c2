// What a person says of a file that it does not tell itself.
#include "core/base/random.h"
#include "journals.h"
#include "support/registry.h"

#include <iomanip>
#include <numbers>
#include <QTest>

using test::Workbench, test::json;

class ReadOptionsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void unitsScaleWhatIsRead();
    void columnsAreTakenAndRecovered();
    void thinnedPointsKeepTheirDistance();
    void theAxisUpwardsIsTaken();
    void modelsWithLengthsKeepTheirUnit();
    void scenesAndSamplesHaveNoFileToRead();
};

/// A bumpy ball as text, far from the origin: other z y x.
static std::string ball(int count, double far = 0) {
    base::Random random(test::seed());
    std::ostringstream out;
    out << std::setprecision(12);
    for (int i = 0; i < count; ++i) {
        const base::Vec3d p = random.unitVector() * 100.0;
        out << i << ' ' << p.z + far << ' ' << p.y + far << ' ' << p.x + far << '\n';
    }
    return out.str();
}

static base::Box3d boundsOf(const Workbench& bench) {
    const base::Box3f box = bench.document.surface().tree().bounds();
    const base::Vec3d origin = bench.document.provenance().origin;
    return {base::cast<double>(box.lo) + origin, base::cast<double>(box.hi) + origin};
}

void ReadOptionsTest::unitsScaleWhatIsRead() {
    for (const double far : {0.0, 4.5e6}) {
        Workbench plain, scaled;
        const std::string text = ball(1500, far);
        plain.run({{"op", "open"}, {"path", test::write(plain.path("a.xyz"), text).string()}, {"columns", "-,z,y,x"}});
        scaled.run({{"op", "open"},
                    {"path", test::write(scaled.path("a.xyz"), text).string()},
                    {"columns", "-,z,y,x"},
                    {"unit_scale", 0.001}});
        QCOMPARE(plain.size(), std::size_t(1500));
        QCOMPARE(scaled.size(), plain.size());
        const base::Box3d before = boundsOf(plain), after = boundsOf(scaled);
        const double error = std::max(length(after.lo - before.lo * 0.001), length(after.hi - before.hi * 0.001));
        QVERIFY2(error < 1e-7, qPrintable(QString("%1 off at %2, seed %3").arg(error).arg(far).arg(test::seed())));
    }
}

/// A journal says them again, and the copy that it keeps of the file is read by them.
void ReadOptionsTest::columnsAreTakenAndRecovered() {
    Workbench bench;
    const auto path = test::write(bench.path("a.txt"), ball(1200));
    session::Journal journal(bench.path("journal.jsonl"));
    bench.context.journal = &journal;
    bench.run({{"op", "open"}, {"path", path.string()}, {"columns", "-,z,y,x"}, {"up_axis", "z"}});
    bench.run({{"op", "transform"}, {"move", {1, 2, 3}}});
    QVERIFY(!bench.document.surface().tree().layout()->find("column_1"));
    QCOMPARE(test::recovered(journal.path()), bench.hash());
}

void ReadOptionsTest::thinnedPointsKeepTheirDistance() {
    Workbench bench;
    constexpr double spacing = 12;
    bench.run({{"op", "open"},
               {"path", test::write(bench.path("a.xyz"), ball(4000)).string()},
               {"columns", "-,z,y,x"},
               {"thin_to", spacing}});
    const surfel::SurfelList points = bench.document.surface().tree().surfels();
    // A disc of each: at most the sphere over the area of half-spacing discs, at least half of a full packing's.
    const double most = 4 * 100.0 * 100.0 / (spacing * spacing / 4);
    QVERIFY(static_cast<double>(points.size()) < most && static_cast<double>(points.size()) > 0.4 * most);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(length(points.items[i].position - points.items[j].position) >= static_cast<float>(spacing));
}

void ReadOptionsTest::theAxisUpwardsIsTaken() {
    for (const char* axis : {"x", "y", "z", "-x", "-y", "-z"}) {
        Workbench bench;
        bench.run({{"op", "open"},
                   {"path", test::write(bench.path("a.xyz"), ball(800)).string()},
                   {"columns", "-,x,y,z"},
                   {"up_axis", axis}});
        QCOMPARE(std::string(base::upRow(bench.document.up()).id), std::string(axis));
    }
}

void ReadOptionsTest::modelsWithLengthsKeepTheirUnit() {
    Workbench bench;
    bench.run(test::newSphere(900));
    const std::string path = bench.path("a.ply").string();
    bench.run({{"op", "save"}, {"path", path}});
    const std::string said = bench.refusal({{"op", "open"}, {"path", path}, {"unit_scale", 0.001}});
    QVERIFY(said.find("keeps its unit") != std::string::npos);
    QCOMPARE(bench.size(), std::size_t(900)); // and the model is as it was
}

void ReadOptionsTest::scenesAndSamplesHaveNoFileToRead() {
    Workbench bench;
    bench.run(test::newSphere(900));
    bench.run({{"op", "scene"}, {"do", "add"}, {"sample", "torus:900"}});
    const std::string path = bench.path("a.scene.json").string();
    bench.run({{"op", "save"}, {"path", path}});
    QVERIFY(!bench.refusal({{"op", "open"}, {"path", path}, {"thin_to", 0.1}}).empty());
    QVERIFY(bench.refusal({{"op", "open"}, {"path", path}}).empty());
    QVERIFY(!bench.refusal({{"op", "scene"}, {"do", "add"}, {"sample", "cone:900"}, {"thin_to", 0.1}}).empty());
}

static const test::Registered<ReadOptionsTest> registered;
#include "read_options_test.moc"
