// boundary: the boundaries of models for which they are known, and what the files hold.
#include "program.h"
#include "support/registry.h"

#include <cmath>
#include <QTest>

using test::Outcome;
using test::Program;
using test::rowsOf;

class BoundaryTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void halfASphereHasOneRoundRim();
    void theMiddleIsThatOfTheLength();
    void polylinesCloseWhereRimsDo();
    void theMoebiusStripHasOneRim();
    void closedSurfacesHaveNone();
    void wrongUsageIsRefused();
};

namespace {

/// The upper half of the unit sphere on a golden lattice.
std::string halfSphere(int count) {
    std::string out;
    for (int i = 0; i < count; ++i) {
        const double z = (i + 0.5) / count, r = std::sqrt(1 - z * z), a = 2.399963229728653 * i;
        char line[120];
        std::snprintf(line, sizeof line, "%.9g %.9g %.9g\n", r * std::cos(a), r * std::sin(a), z);
        out += line;
    }
    return out;
}

} // namespace

void BoundaryTest::halfASphereHasOneRoundRim() {
    const Program program;
    program.write("half.xyz", halfSphere(4000));
    const Outcome outcome = program.run({"boundary", "half.xyz", "-o", "rims.csv"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const auto rows = rowsOf(program.read("rims.csv"));
    QCOMPARE(rows.at(0),
             (std::vector<std::string>{"rim", "closed", "x", "y", "z", "nx", "ny", "nz", "ox", "oy", "oz"}));
    QVERIFY(rows.size() > 60);
    const double spacing = std::sqrt(2 * 3.14159 / 4000);
    double turned = 0, before = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto at = [&](std::size_t k) { return std::stod(rows[i].at(k)); };
        QCOMPARE(at(0), 0.0);
        QCOMPARE(at(1), 1.0);
        // On the sphere, within a spacing of its edge, and outward is downward.
        QVERIFY(std::abs(std::hypot(at(2), at(3), at(4)) - 1) < 0.1 * spacing);
        QVERIFY2(std::abs(at(4)) < spacing, rows[i].at(4).c_str());
        QVERIFY(at(10) < -0.9);
        const double angle = std::atan2(at(3), at(2));
        if (i > 1)
            turned += std::remainder(angle - before, 2 * 3.14159265358979);
        before = angle;
    }
    QVERIFY2(std::abs(turned) > 6, "all the way round, once");
}

/// A square and half a disc beside it: lengths of pi, 1, 1 and 2 at -2 / pi, 1/2, 1/2 and 1. Points of the rim are
/// denser where it is round or turns a corner.
void BoundaryTest::theMiddleIsThatOfTheLength() {
    const Program program;
    std::string points;
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j)
            if (i > 0 || i * i + j * j < 400)
                points += std::to_string(0.05 * i) + " " + std::to_string(0.05 * j) + " 0\n";
    program.write("d.xyz", points);
    const Outcome outcome = program.run({"boundary", "d.xyz", "-o", "d.csv"});
    const std::size_t at = outcome.out.find("about ");
    QVERIFY2(outcome.code == 0 && at != std::string::npos, outcome.err.c_str());
    const double told = std::stod(outcome.out.substr(at + 6)), wanted = 1 / (3.14159265 + 4);
    QVERIFY2(std::abs(told - wanted) < 0.03, outcome.out.c_str());
    double sum = 0;
    const auto rows = rowsOf(program.read("d.csv"));
    for (std::size_t i = 1; i < rows.size(); ++i)
        sum += std::stod(rows[i].at(2));
    QVERIFY(std::abs(sum / static_cast<double>(rows.size() - 1) - wanted) > 0.05); // or this would show nothing
}

void BoundaryTest::polylinesCloseWhereRimsDo() {
    const Program program;
    program.write("half.xyz", halfSphere(3000));
    const Outcome outcome = program.run({"boundary", "half.xyz", "-o", "rims.obj", "--turn", "0.3"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    std::istringstream in(program.read("rims.obj"));
    std::size_t points = 0, normals = 0, lines = 0;
    for (std::string line; std::getline(in, line);) {
        points += line.starts_with("v ");
        normals += line.starts_with("vn ");
        if (line.starts_with("l ")) {
            ++lines;
            QVERIFY(line.starts_with("l 1 2 ") && line.ends_with(" " + std::to_string(points) + " 1"));
        }
    }
    QCOMPARE(lines, 1u);
    QVERIFY(points > 20 && points == normals);
}

void BoundaryTest::theMoebiusStripHasOneRim() {
    const Program program;
    const Outcome outcome = program.run({"boundary", "sample:moebius:6000", "-o", "rims.csv"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY2(outcome.out.starts_with("boundary curve 0: length "), outcome.out.c_str());
    QVERIFY2(outcome.out.find("boundary curve 1") == std::string::npos, outcome.out.c_str());
    QVERIFY2(outcome.out.find("closed") != std::string::npos, outcome.out.c_str());
}

void BoundaryTest::closedSurfacesHaveNone() {
    const Program program;
    const Outcome outcome = program.run({"boundary", "sample:sphere:3000"});
    QCOMPARE(outcome.code, 0);
    QVERIFY2(outcome.out.starts_with("no boundary"), outcome.out.c_str());
}

void BoundaryTest::wrongUsageIsRefused() {
    const Program program;
    QCOMPARE(program.run({"boundary", "sample:sphere:3000", "-o", "rims.stl"}).code, 2);
    QVERIFY(!program.dir().exists("rims.stl"));
    const Outcome curve = program.run({"boundary", "sample:coil"});
    QCOMPARE(curve.code, 1);
    QVERIFY2(curve.err.find("curve") != std::string::npos, curve.err.c_str());
}

static const test::Registered<BoundaryTest> registered;
#include "boundary_test.moc"
