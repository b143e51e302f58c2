// A model that was saved and opened again goes on as one that was never closed: the file holds all that its bits come
// from (session/README 5). What it does not hold is the history.
#include "core/base/parallel.h"
#include "core/io/formats.h"
#include "random_strokes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "workbench.h"

#include <QTest>

using nlohmann::json;
using test::Workbench;

class ReopenTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void savedModelsGoOnAsIfTheyHadStayedOpen_data();
    void savedModelsGoOnAsIfTheyHadStayedOpen();
    void whatHadOneSideKeepsIt();
    void othersMayChangeTheFile();
    void undoEndsAtTheOpening();
    void cleanup() { base::setThreadCount(0); }
};

/// A sphere at coordinates that only doubles hold, spacing 20 times as wide around one pole as around the other, noise
/// and a few strays; no normals.
static std::string unevenPoints(std::size_t count, base::Random& random) {
    std::ostringstream out;
    out.precision(12);
    for (std::size_t i = 0; i < count; ++i) {
        const base::Vec3d u = random.unitVector();
        const double share = 0.5 + 0.5 * u.z;
        if (random.uniform() > std::pow(20.0, -2 * share))
            continue;
        const base::Vec3d p = u * (i % 500 == 0 ? random.uniform(1, 1.5) : 1 + 0.002 * random.normal());
        out << 4.5e6 + p.x << ' ' << p.y - 7e6 << ' ' << p.z << '\n';
    }
    return out.str();
}

/// Strokes, undo and redo; what is refused is refused in both.
static void goOn(Workbench& bench, int steps, base::Random random) {
    test::RandomStrokes strokes(bench.document, random);
    bool changed = false; // by the last command: then there is something to undo
    for (int k = 0; k < steps; ++k) {
        const std::size_t what = random.below(12);
        const tree::SurfelTree before = bench.document.surface().tree();
        if (what < 2 && changed)
            bench.run({{"op", "undo"}});
        else if (what == 2)
            bench.run({{"op", "surface"}, {"neighbours", 30}});
        else
            static_cast<void>(bench.refusal(strokes.next()));
        changed = what > 2 && !(bench.document.surface().tree() == before);
    }
}

void ReopenTest::savedModelsGoOnAsIfTheyHadStayedOpen_data() {
    QTest::addColumn<QString>("sample");
    QTest::addColumn<int>("count");
    QTest::newRow("sphere") << "sphere" << 6000;
    QTest::newRow("knot") << "knot" << 12000;
    QTest::newRow("clay") << "clay" << 9000;
    QTest::newRow("scan, open and noisy") << "scan" << 9000;
    QTest::newRow("one side") << "moebius" << 6000;
    QTest::newRow("uneven, far away, strays") << "" << 60000;
}

void ReopenTest::savedModelsGoOnAsIfTheyHadStayedOpen() {
    QFETCH(QString, sample);
    QFETCH(int, count);
    for (int round = 0; round < test::effort(3); ++round) {
        base::Random random(test::seed() + static_cast<std::uint64_t>(round));
        Workbench stays;
        if (sample.isEmpty())
            stays.run({{"op", "open"},
                       {"path", test::write(stays.path("a.xyz"), unevenPoints(std::size_t(count), random)).string()}});
        else
            stays.run({{"op", "new"}, {"sample", sample.toStdString()}, {"count", count}});
        goOn(stays, 6, base::Random(random.next()));
        const std::filesystem::path saved = stays.path("saved.ply");
        stays.run({{"op", "save"}, {"path", saved.string()}});
        const base::Random later(random.next());
        goOn(stays, 6, later);
        for (const int threads : {1, 2}) {
            if (threads == 1 && test::sanitized)
                continue;
            base::setThreadCount(threads);
            Workbench opens;
            opens.run({{"op", "open"}, {"path", saved.string()}});
            goOn(opens, 6, later);
            QVERIFY2(opens.hash() == stays.hash(),
                     qPrintable(QString("round %1, %2 threads, seed %3").arg(round).arg(threads).arg(test::seed())));
        }
    }
}

/// A strip that was cut through could be oriented now; who goes on without closing it has it unoriented still.
void ReopenTest::whatHadOneSideKeepsIt() {
    Workbench bench;
    bench.run({{"op", "new"}, {"sample", "moebius"}, {"count", 6000}});
    bench.run({{"op", "select"}, {"by", "box"}, {"least", {0.2, -2, -0.2}}, {"most", {2, 2, 0.2}}});
    bench.run({{"op", "delete"}});
    QVERIFY(!bench.document.surface().tree().layout()->oriented);
    const std::string hash = bench.hash();
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    bench.run({{"op", "open"}, {"path", bench.path("a.ply").string()}});
    QCOMPARE(bench.hash(), hash);
}

/// Another program has moved, shuffled or left out points and kept the rest of the file, or turned it into another
/// form: it opens without a word, as points of its own.
void ReopenTest::othersMayChangeTheFile() {
    Workbench bench;
    bench.run(test::newSphere(3000));
    for (int k = 0; k < 4; ++k)
        bench.run(test::strokeAt(0.1 * k));
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    const io::FileModel model = io::read(bench.path("a.ply"));
    QVERIFY(!model.shape.empty() && model.elements.empty());
    for (int how = 0; how < 4; ++how) {
        io::FileModel other = model;
        auto& items = other.points.items;
        if (how == 0)
            items[5].position.x += 1e-3f;
        else if (how == 1)
            std::swap(items.front(), items.back());
        else if (how == 2)
            items.resize(items.size() - 7);
        else
            other.shape.nodes.front() = 200;
        io::write(bench.path("b.ply"), other);
        other.shape = {};
        io::write(bench.path("c.ply"), other);
        std::vector<std::string> hashes;
        for (const char* name : {"b.ply", "c.ply"}) {
            Workbench opens;
            opens.run({{"op", "open"}, {"path", bench.path(name).string()}});
            QVERIFY(opens.context.messages.empty());
            opens.document.surface().tree().validate();
            opens.run(test::strokeAt(0.2, "smooth"));
            hashes.push_back(opens.hash());
        }
        QCOMPARE(hashes[0], hashes[1]);
    }
}

void ReopenTest::undoEndsAtTheOpening() {
    Workbench bench, opens;
    bench.run(test::newSphere());
    bench.run(test::strokeAt(0));
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    opens.run({{"op", "open"}, {"path", bench.path("a.ply").string()}});
    QVERIFY(bench.document.canUndo() && !opens.document.canUndo());
}

static const test::Registered<ReopenTest> registered;
#include "reopen_test.moc"
