// haptic: what the file holds, at home and far from zero, and what is refused in one sentence.
#include "program.h"
#include "support/registry.h"

#include <cmath>
#include <iomanip>
#include <QTest>

using test::Outcome;
using test::Program;
using test::rowsOf;

class HapticCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aSpherePushesBack();
    void farFromZeroNothingIsLost();
    void forcesArePlotted();
    void lightPlacesPushHarder();
    void wrongInputIsRefused_data();
    void wrongInputIsRefused();
};

/// Down from above the pole of the unit sphere to `depth` in it, then along it.
static std::string press(double depth, double by = 0) {
    std::ostringstream out;
    out << std::setprecision(17) << "t,x,y,z\n";
    for (int i = 0; i < 60; ++i)
        out << 0.001 * i << ',' << by + 0.125 * std::max(0, i - 30) / 32 << ',' << by << ','
            << by + std::max(1.25 - i / 64.0, 1 - depth) << '\n';
    return out.str();
}

void HapticCommandTest::aSpherePushesBack() {
    const Program program;
    program.write("t.csv", press(0.0625));
    for (const double radius : {0.0, 0.05}) {
        const Outcome outcome = program.run({"haptic", "sample:sphere:8000", "--trajectory", "t.csv", "-o", "f.csv",
                                             "--radius", QString::number(radius), "--stiffness", "400"});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
        const auto rows = rowsOf(program.read("f.csv"));
        QCOMPARE(rows.at(0),
                 (std::vector<std::string>{"t", "x", "y", "z", "px", "py", "pz", "fx", "fy", "fz", "contact", "us"}));
        QCOMPARE(rows.size(), std::size_t(61));
        int contacts = 0;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const auto at = [&](std::size_t k) { return std::stod(rows[i].at(k)); };
            const double away = std::hypot(at(1), at(2), at(3)), depth = 1 + radius - away;
            if (std::abs(depth) > 1e-4)
                QCOMPARE(at(10), depth > 0 ? 1.0 : 0.0);
            QVERIFY(at(11) >= 0);
            contacts += depth > 0 ? 1 : 0;
            QVERIFY(std::abs(std::hypot(at(7), at(8), at(9)) - 400 * std::max(0.0, depth)) < 1e-3 * 400 * 0.1);
            QVERIFY(std::abs(std::hypot(at(4), at(5), at(6)) - std::max(1 + radius, away)) < 1e-4);
        }
        QVERIFY(contacts > 30);
    }
}

/// The same at the place where georeferenced scans lie: coordinates are multiples of 2^-6, exact in both places.
void HapticCommandTest::farFromZeroNothingIsLost() {
    constexpr double by = 10000000;
    const Program program;
    std::ostringstream home, far;
    home << std::setprecision(17);
    far << std::setprecision(17);
    for (int i = -24; i <= 24; ++i)
        for (int j = -24; j <= 24; ++j) {
            const double x = i / 32.0, y = j / 32.0, z = std::round(64 * (1 - 0.5 * (x * x + y * y))) / 64;
            home << x << ' ' << y << ' ' << z << '\n';
            far << by + x << ' ' << by + y << ' ' << by + z << '\n';
        }
    program.write("home.xyz", home.str());
    program.write("far.xyz", far.str());
    program.write("home.csv", press(0.0625));
    program.write("far.csv", press(0.0625, by));
    std::vector<std::vector<std::string>> rows[2];
    for (const bool away : {false, true}) {
        const QString name = away ? "far" : "home";
        const Outcome outcome = program.run({"haptic", name + ".xyz", "--trajectory", name + ".csv", "-o", "f.csv"});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
        rows[away] = rowsOf(program.read("f.csv"));
    }
    QCOMPARE(rows[0].size(), rows[1].size());
    int contacts = 0;
    for (std::size_t i = 1; i < rows[0].size(); ++i) {
        const auto at = [&](int where, std::size_t k) { return std::stod(rows[where][i].at(k)); };
        for (std::size_t k = 1; k <= 3; ++k)
            QCOMPARE(at(1, k), at(0, k) + by);
        for (std::size_t k = 4; k <= 6; ++k)
            QVERIFY(std::abs(at(1, k) - by - at(0, k)) < 4e-6);
        for (std::size_t k = 7; k <= 9; ++k)
            QVERIFY(std::abs(at(1, k) - at(0, k)) < 4e-6);
        QCOMPARE(rows[1][i].at(10), rows[0][i].at(10));
        contacts += rows[0][i].at(10) == "1" ? 1 : 0;
    }
    QVERIFY(contacts > 30);
}

void HapticCommandTest::forcesArePlotted() {
    const Program program;
    program.write("t.csv", press(0.0625));
    const QStringList call{"haptic", "sample:sphere:2000", "--trajectory", "t.csv", "-o", "f.csv", "--plot"};
    const Outcome outcome = program.run(call + QStringList{"f.png"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY(program.read("f.png").starts_with("\x89PNG"));
    QCOMPARE(program.run(call + QStringList{"f.csv"}).code, 2);
}

void HapticCommandTest::lightPlacesPushHarder() {
    const Program program;
    std::ostringstream floor;
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j)
            floor << i / 20.0 << ' ' << j / 20.0 << " 0 0 0 1 " << (i > 0 ? "255 255 255\n" : "0 0 0\n");
    program.write("floor.xyz", floor.str());
    program.write("t.csv", "t,x,y,z\n0,-0.5,0,0.2\n0.001,-0.5,0,-0.0625\n0.002,-0.5,0,0.2\n0.003,0.5,0,0.2\n"
                           "0.004,0.5,0,-0.0625\n");
    const Outcome outcome = program.run(
        {"haptic", "floor.xyz", "--trajectory", "t.csv", "-o", "f.csv", "--stiffness", "16", "--colour", "0.5"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const auto rows = rowsOf(program.read("f.csv"));
    QVERIFY(std::abs(std::stod(rows.at(2).at(9)) - 0.75) < 0.01);
    QVERIFY(std::abs(std::stod(rows.at(5).at(9)) - 1.25) < 0.01);
}

void HapticCommandTest::wrongInputIsRefused_data() {
    QTest::addColumn<QString>("trajectory");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    const QString good = "t,x,y,z\n0,0,0,2\n1,0,0,1\n";
    QTest::newRow("no header") << "0,0,0,2\n1,0,0,1\n" << QStringList() << 1 << "column t";
    QTest::newRow("no z") << "t,x,y\n0,0,0\n" << QStringList() << 1 << "column z";
    QTest::newRow("no rows") << "t,x,y,z\n" << QStringList() << 1 << "no places";
    QTest::newRow("empty") << "" << QStringList() << 1 << "is empty";
    QTest::newRow("a word") << "t,x,y,z\n0,0,0,2\n1,0,up,1\n" << QStringList() << 1 << "up";
    QTest::newRow("times stand still") << "t,x,y,z\n0,0,0,2\n0,0,0,1\n" << QStringList() << 1 << "ascend";
    QTest::newRow("not finite") << "t,x,y,z\n0,0,0,2\n1,0,nan,1\n" << QStringList() << 1 << "finite";
    QTest::newRow("too far") << "t,x,y,z\n0,0,0,1e300\n" << QStringList() << 1 << "place 0";
    QTest::newRow("radius") << good << QStringList{"--radius", "-1"} << 2 << "-1";
    QTest::newRow("stiffness") << good << QStringList{"--stiffness", "0"} << 2 << "0";
    QTest::newRow("friction") << good << QStringList{"--friction", "nan"} << 2 << "nan";
}

void HapticCommandTest::wrongInputIsRefused() {
    QFETCH(QString, trajectory);
    QFETCH(QStringList, options);
    QFETCH(int, code);
    QFETCH(QString, says);
    const Program program;
    program.write("t.csv", trajectory.toStdString());
    const Outcome outcome =
        program.run(QStringList{"haptic", "sample:sphere:500", "--trajectory", "t.csv", "-o", "f.csv"} + options);
    QCOMPARE(outcome.code, code);
    QVERIFY2(QString::fromStdString(outcome.err).contains(says), outcome.err.c_str());
    QVERIFY(!program.dir().exists("f.csv"));
}

static const test::Registered<HapticCommandTest> registered;
#include "haptic_test.moc"
