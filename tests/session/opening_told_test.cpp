// What opening says of a file that will not look as its owner expects.
#include "core/base/random.h"
#include "support/registry.h"
#include "workbench.h"

#include <numbers>
#include <QTest>

using test::Workbench;

class OpeningToldTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void coloursThatAreMostlyBlackAreTold();
    void drawingsAreOfferedAsCurves();
};

/// Opens the text as `name` and says whether a message has `part` in it.
static bool tells(const std::string& name, const std::string& text, const char* part) {
    Workbench bench;
    bench.run({{"op", "open"}, {"path", test::write(bench.path(name.c_str()), text).string()}});
    for (const std::string& each : bench.context.messages)
        if (each.find(part) != std::string::npos)
            return true;
    return false;
}

/// Labels as colours: what has no label is black. Where all is black, colours say nothing and are not shown.
void OpeningToldTest::coloursThatAreMostlyBlackAreTold() {
    for (const double part : {0.05, 0.6, 1.0}) {
        base::Random random(test::seed());
        std::ostringstream out;
        for (int i = 0; i < 1500; ++i) {
            const base::Vec3d p = random.unitVector();
            out << p.x << ' ' << p.y << ' ' << p.z << (random.uniform() < part ? " 0 0 0\n" : " 200 40 90\n");
        }
        QCOMPARE(tells("labels.xyz", out.str(), "are black in the file"), part == 0.6);
    }
}

void OpeningToldTest::drawingsAreOfferedAsCurves() {
    base::Random random(test::seed());
    std::ostringstream rings, sheet;
    for (int i = 0; i < 1500; ++i) {
        const double turn = random.uniform(0, 2 * std::numbers::pi);
        rings << std::cos(turn) + 3 * (i % 3) << ' ' << std::sin(turn) << " 0\n";
        sheet << random.uniform() << ' ' << random.uniform() << " 0\n";
    }
    QVERIFY(tells("rings.xyz", rings.str(), "--manifold curve"));
    QVERIFY(!tells("sheet.xyz", sheet.str(), "--manifold curve"));
}

static const test::Registered<OpeningToldTest> registered;
#include "opening_told_test.moc"
