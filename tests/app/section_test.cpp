// section and the views of render: what the files hold, how pictures are named, and what is refused in one sentence.
#include "program.h"
#include "support/registry.h"

#include <cmath>
#include <QImage>
#include <QSettings>
#include <QTest>

using test::Outcome;
using test::Program;
using test::rowsOf;

class SectionCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aSphereIsCutInACircle();
    void polylinesCloseWhereCurvesDo();
    void drawingsHoldTheSameCurves_data();
    void drawingsHoldTheSameCurves();
    void aMissedModelIsAnEmptySheet();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
    void turntablesAreNumbered();
    void viewsLookFromTheirSide();
    void clippedPicturesAreCutOpen();
    void savedViewsAreFoundByName();
};

void SectionCommandTest::aSphereIsCutInACircle() {
    const Program program;
    const Outcome outcome =
        program.run({"section", "sample:sphere:4000", "--plane", "0,2,0,1", "-o", "s.csv", "--frame", "apss"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const auto rows = rowsOf(program.read("s.csv"));
    QCOMPARE(rows.at(0), (std::vector<std::string>{"curve", "closed", "x", "y", "z", "nx", "ny", "nz"}));
    QVERIFY(rows.size() > 40);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto at = [&](std::size_t k) { return std::stod(rows[i].at(k)); };
        QCOMPARE(at(0), 0.0);
        QCOMPARE(at(1), 1.0);
        QVERIFY(std::abs(at(3) - 0.5) < 1e-14);
        QVERIFY(std::abs(std::hypot(at(2), at(4)) - std::sqrt(0.75)) < 1e-3);
        QVERIFY(at(6) > 0.4);
    }
    QVERIFY(outcome.out.starts_with("curve 0: length 5.44"));
}

void SectionCommandTest::polylinesCloseWhereCurvesDo() {
    const Program program;
    const Outcome outcome = program.run({"section", "sample:torus:6000", "--plane", "1,0,0,0", "-o", "s.obj"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    std::istringstream in(program.read("s.obj"));
    std::vector<std::vector<int>> lines;
    int vertices = 0;
    for (std::string line; std::getline(in, line);) {
        vertices += line.starts_with("v ") ? 1 : 0;
        if (!line.starts_with("l "))
            continue;
        std::istringstream numbers(line.substr(2));
        lines.emplace_back();
        for (int k; numbers >> k;)
            lines.back().push_back(k);
    }
    QCOMPARE(lines.size(), std::size_t(2));
    for (const auto& line : lines)
        QVERIFY(line.size() > 20 && line.front() == line.back());
    QCOMPARE(static_cast<std::size_t>(vertices), lines[0].size() + lines[1].size() - 2);
}

void SectionCommandTest::drawingsHoldTheSameCurves_data() {
    QTest::addColumn<QString>("plane");
    QTest::addColumn<std::vector<double>>("right");
    QTest::addColumn<std::vector<double>>("up");
    const double half = std::sqrt(0.5);
    QTest::newRow("front") << "0,0,1,0.05" << std::vector{1., 0., 0.} << std::vector{0., 1., 0.};
    QTest::newRow("back") << "0,0,-1,0.05" << std::vector{-1., 0., 0.} << std::vector{0., 1., 0.};
    QTest::newRow("top") << "0,2,0,0.1" << std::vector{1., 0., 0.} << std::vector{0., 0., -1.};
    QTest::newRow("oblique") << "0,1,1,0.1" << std::vector{1., 0., 0.} << std::vector{0., half, -half};
}

/// Every point of the CSV file stands in the DXF file, and, seen from the normal's side, in the SVG file.
void SectionCommandTest::drawingsHoldTheSameCurves() {
    QFETCH(QString, plane);
    QFETCH(std::vector<double>, right);
    QFETCH(std::vector<double>, up);
    const Program program;
    for (const char* name : {"s.csv", "s.dxf", "s.svg"}) {
        const Outcome outcome = program.run({"section", "sample:torus:6000", "--plane", plane, "-o", name});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
    }
    const auto rows = rowsOf(program.read("s.csv"));
    std::istringstream dxf(program.read("s.dxf"));
    std::vector<double> inSpace;
    int lines = 0, ends = 0;
    bool vertex = false;
    for (std::string code, value; std::getline(dxf, code) && std::getline(dxf, value);) {
        lines += value == "POLYLINE" ? 1 : 0;
        ends += value == "SEQEND" ? 1 : 0;
        vertex = code == "0" ? value == "VERTEX" : vertex;
        if (vertex && (code == "10" || code == "20" || code == "30"))
            inSpace.push_back(std::stod(value));
    }
    std::string svg = program.read("s.svg");
    int paths = 0, closed = 0;
    std::vector<double> drawn;
    for (std::size_t at = svg.find("d=\"M"); at != std::string::npos; at = svg.find("d=\"M", at + 1)) {
        std::string path = svg.substr(at + 3, svg.find('"', at + 3) - at - 3);
        ++paths;
        closed += path.back() == 'Z' ? 1 : 0;
        for (char& c : path)
            c = c == 'M' || c == 'L' || c == 'Z' ? ' ' : c;
        std::istringstream numbers(path);
        for (double x; numbers >> x;)
            drawn.push_back(x);
    }
    const std::size_t count = rows.size() - 1;
    QCOMPARE(inSpace.size(), 3 * count);
    QCOMPARE(drawn.size(), 2 * count);
    QCOMPARE(lines, std::stoi(rows.back().at(0)) + 1);
    QCOMPARE(ends, lines);
    QCOMPARE(paths, lines);
    QCOMPARE(closed, lines);
    double least[2] = {1e9, 1e9}, left = 1e9, top = 1e9;
    for (std::size_t i = 0; i < count; ++i) {
        double across = 0, down = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = std::stod(rows[i + 1].at(2 + k));
            QCOMPARE(inSpace[3 * i + k], x);
            across += x * right[k];
            down -= x * up[k];
        }
        if (i == 0) {
            left = across - drawn[0];
            top = down - drawn[1];
        }
        QVERIFY(std::abs(across - drawn[2 * i] - left) < 1e-12 && std::abs(down - drawn[2 * i + 1] - top) < 1e-12);
        least[0] = std::min(least[0], drawn[2 * i]);
        least[1] = std::min(least[1], drawn[2 * i + 1]);
    }
    QVERIFY(std::abs(least[0]) < 1e-12 && std::abs(least[1]) < 1e-12); // the corner is its zero
}

void SectionCommandTest::aMissedModelIsAnEmptySheet() {
    const Program program;
    const Outcome outcome = program.run({"section", "sample:sphere:500", "--plane", "0,0,1,5", "-o", "s.svg"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const std::string svg = program.read("s.svg"), box = "viewBox=\"";
    std::istringstream numbers(svg.substr(svg.find(box) + box.size()));
    float left = 0, top = 0, width = 0, height = 0; // what viewers count in
    QVERIFY(numbers >> left >> top >> width >> height);
    QVERIFY2(width > 1e-3F && height > 1e-3F && svg.find("<path") == std::string::npos, svg.c_str());
}

void SectionCommandTest::wrongUsageIsRefused_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    const QStringList section{"section", "sample:sphere:500"}, render{"render", "sample:sphere:500", "-o", "a.png"};
    QTest::newRow("no plane") << section << 2 << "--plane";
    QTest::newRow("no normal") << section + QStringList{"--plane", "0,0,0,1"} << 2 << "0,0,0,1";
    QTest::newRow("no such ending") << section + QStringList{"--plane", "0,0,1,0", "-o", "a.stl"} << 2 << ".csv";
    QTest::newRow("no drawing of boundaries")
        << QStringList{"boundary", "sample:sphere:500", "-o", "a.svg"} << 2 << ".csv, .obj or .dxf";
    QTest::newRow("no model") << QStringList{"section", "nowhere.ply", "--plane", "0,0,1,0"} << 1 << "nowhere.ply";
    QTest::newRow("no height") << render + QStringList{"--ortho", "-3"} << 2 << "-3";
    QTest::newRow("two projections") << render + QStringList{"--ortho", "fit", "--fov", "30"} << 2 << "--fov";
    QTest::newRow("no clip plane") << render + QStringList{"--clip", "1,2,3"} << 2 << "1,2,3";
    QTest::newRow("too large") << render + QStringList{"--size", "99999x10"} << 2 << "99999x10";
    QTest::newRow("no view") << render + QStringList{"--view", "behind"} << 1 << "behind";
    QTest::newRow("two eyes") << render + QStringList{"--view", "front", "--eye", "0,0,3"} << 2 << "--eye";
    QTest::newRow("no turns") << render + QStringList{"--turntable", "0"} << 2 << "--turntable";
    QStringList seven = render;
    for (int k = 0; k < 7; ++k)
        seven << "--clip"
              << "1,0,0,0";
    QTest::newRow("seven planes") << seven << 2 << "--clip";
}

void SectionCommandTest::wrongUsageIsRefused() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, says);
    const Program program;
    const Outcome outcome = program.run(arguments);
    QVERIFY2(outcome.code == code && outcome.err.find(says.toStdString()) != std::string::npos,
             (std::to_string(outcome.code) + ": " + outcome.err).c_str());
    QVERIFY(!QFile::exists(program.path("a.png").c_str()));
}

static QImage picture(const Program& program, const char* name) {
    return QImage(QString::fromStdString(program.path(name)));
}

/// Share of opaque pixels.
static double covered(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += qAlpha(image.pixel(x, y)) > 127 ? 1 : 0;
    return double(count) / (image.width() * image.height());
}

void SectionCommandTest::turntablesAreNumbered() {
    const Program program;
    const Outcome outcome =
        program.run({"render", "sample:torus:3000", "-o", "turn.png", "--size", "64x48", "--turntable", "4", "--depth",
                     "d.pfm", "--transparent", "--ortho", "fit", "--view", "front"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    for (const char* name : {"turn-000.png", "turn-001.png", "turn-002.png", "turn-003.png", "d-003.pfm"})
        QVERIFY2(QFile::exists(program.path(name).c_str()), name);
    QVERIFY(!QFile::exists(program.path("turn.png").c_str()) && !QFile::exists(program.path("turn-004.png").c_str()));
    // Half a turn later a torus looks the same, mirrored; the pictures in between show it as large.
    const double front = covered(picture(program, "turn-000.png"));
    QVERIFY(front > 0.1 && std::abs(covered(picture(program, "turn-002.png")) - front) < 0.01);
}

void SectionCommandTest::viewsLookFromTheirSide() {
    const Program program;
    // An arm along +x, drawn as wide from the front and the top, and as a dot from the right.
    std::string points;
    for (int i = 0; i < 2000; ++i) {
        char line[160];
        const double a = 2.39996 * i, x = 4.0 * i / 2000, n = std::cos(a), m = std::sin(a);
        std::snprintf(line, sizeof line, "%.9g %.9g %.9g 0 %.9g %.9g\n", x, 0.2 * n, 0.2 * m, n, m);
        points += line;
    }
    program.write("arm.xyz", points);
    const auto share = [&](const char* view) {
        const Outcome outcome = program.run(
            {"render", "arm.xyz", "-o", "a.png", "--size", "80x80", "--transparent", "--view", view, "--ortho", "5"});
        return outcome.code == 0 ? covered(picture(program, "a.png")) : -1;
    };
    const double front = share("front"), top = share("top"), right = share("right");
    QVERIFY(front > 0.04 && std::abs(front - top) < 0.01);
    QVERIFY(right > 0 && right < 0.25 * front);
}

void SectionCommandTest::clippedPicturesAreCutOpen() {
    const Program program;
    const auto draw = [&](const char* name, const QStringList& more) {
        return program
            .run(QStringList{"render", "sample:sphere:4000", "-o", name, "--size", "80x60", "--transparent", "--view",
                             "front", "--ortho", "3"} +
                 more)
            .code;
    };
    QCOMPARE(draw("whole.png", {}), 0);
    QCOMPARE(draw("half.png", {"--clip", "1,0,0,0"}), 0);
    QCOMPARE(draw("line.png", {"--clip", "0,0,-1,0", "--section"}), 0);
    QCOMPARE(draw("bowl.png", {"--clip", "0,0,-1,0"}), 0);
    const double whole = covered(picture(program, "whole.png")), half = covered(picture(program, "half.png"));
    QVERIFY(std::abs(half / whole - 0.5) < 0.03);
    QVERIFY(picture(program, "line.png") != picture(program, "bowl.png"));
    QVERIFY(picture(program, "bowl.png") != picture(program, "whole.png"));
}

/// A view as the window saves it: target, distance, turn, angle, parallel, origin, pivot, name.
void SectionCommandTest::savedViewsAreFoundByName() {
    const Program program;
    qputenv("XDG_CONFIG_HOME", program.path("config").c_str());
    QSettings(program.path("config/pointclay/pointclay.conf").c_str(), QSettings::IniFormat)
        .setValue("view/saved", QStringList{"0 0 0 10 1 0 0 0 35 1 0 0 0 0 0 0 0 my side"});
    const QStringList common{"render", "sample:sphere:4000", "-o", "a.png", "--size", "100x100", "--transparent"};
    const Outcome good = program.run(common + QStringList{"--view", "my side"});
    const Outcome bad = program.run(common + QStringList{"--view", "no such"});
    const Outcome both = program.run(common + QStringList{"--view", "my side", "--fov", "20"});
    qunsetenv("XDG_CONFIG_HOME");
    QVERIFY2(good.code == 0, good.err.c_str());
    // Parallel, 2 * 10 * tan(35 deg / 2) high: the unit sphere's disc.
    const double height = 20 * std::tan(17.5 * 3.14159265358979 / 180), radius = 1 / height;
    QVERIFY(std::abs(covered(picture(program, "a.png")) - 3.14159265358979 * radius * radius) < 0.012);
    QVERIFY(bad.code == 1 && bad.err.find("my side") != std::string::npos);
    QCOMPARE(both.code, 2);
}

static const test::Registered<SectionCommandTest> registered;
#include "section_test.moc"
