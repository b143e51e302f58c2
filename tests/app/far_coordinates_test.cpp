// Far from zero nothing is lost: what the program tells and does about a model in map coordinates is what it does about
// the same model at home, moved. Coordinates are multiples of 2^-12, exact in both places.
#include "core/base/random.h"
#include "program.h"
#include "support/registry.h"

#include <cmath>
#include <iomanip>
#include <QTest>

using base::Vec3d;
using test::Outcome;
using test::Program;
using test::rowsOf;

class FarCoordinatesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void answersMoveAlong();
    void hitsMoveAlong();
    void sectionsMoveAlong();
    void strokesMoveAlong();
};

namespace {

const Vec3d far{4500000, -7000000, 10000000};
/// Two millionths of the spacing: at home floats are written with as many digits as tell them apart.
constexpr double tolerance = 1e-7;

double grid(double value) {
    return std::round(value * 4096) / 4096;
}

Vec3d grid(const Vec3d& v) {
    return {grid(v.x), grid(v.y), grid(v.z)};
}

std::string line(const Vec3d& p, const char* separator = " ") {
    std::ostringstream out;
    out << std::setprecision(17) << p.x << separator << p.y << separator << p.z;
    return out.str();
}

/// A lumpy ball of some 0.05 spacing.
std::vector<Vec3d> ball() {
    std::vector<Vec3d> out;
    constexpr int count = 6000;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), a = i * 2.399963229728653;
        const double lump = 1 + 0.1 * std::sin(5 * z) * std::cos(3 * a);
        out.push_back(grid(Vec3d{r * std::cos(a) + 0.3, r * std::sin(a) - 0.2, z + 0.1} * lump));
    }
    return out;
}

/// The ball in two places, as home.xyz and far.xyz.
class Places {
  public:
    Places() {
        write(
            "ball.xyz", [](const Vec3d& p) { return line(p); }, ball());
    }

    /// Rows made of positions, in both places, under one name after `home-` and `far-`.
    template <class Row>
    void write(const std::string& name, const Row& row, const std::vector<Vec3d>& points, const char* head = "") {
        for (const auto& [place, by] : {std::pair{"home-", Vec3d{}}, std::pair{"far-", far}}) {
            std::string text = head;
            for (const Vec3d& p : points)
                text += row(p + by) + "\n";
            program.write(place + name, text);
        }
    }

    Program program;
};

Vec3d vectorAt(const std::vector<std::string>& row, std::size_t k) {
    return {std::stod(row.at(k)), std::stod(row.at(k + 1)), std::stod(row.at(k + 2))};
}

/// Compares tables whose columns from `at` on hold a position.
void compare(const Program& program, const std::string& name, std::initializer_list<std::size_t> places,
             std::size_t least) {
    const auto home = rowsOf(program.read("home-" + name)), away = rowsOf(program.read("far-" + name));
    QCOMPARE(away.size(), home.size());
    QVERIFY(home.size() > least);
    for (std::size_t i = 1; i < home.size(); ++i)
        for (const std::size_t k : places) {
            if (home[i][k] == "nan")
                continue;
            const double apart = length(vectorAt(away[i], k) - far - vectorAt(home[i], k));
            QVERIFY2(apart < tolerance, qPrintable(QString("row %1: %2").arg(i).arg(apart)));
        }
}

} // namespace

void FarCoordinatesTest::answersMoveAlong() {
    Places places;
    base::Random random(test::seed());
    std::vector<Vec3d> where;
    for (const Vec3d& p : ball())
        if (where.size() < 200)
            where.push_back(grid(p + random.unitVector() * 0.05));
    places.write(
        "at.xyz", [](const Vec3d& p) { return line(p); }, where);
    for (const char* place : {"home-", "far-"}) {
        const auto named = [&](const char* name) { return QString(place) + name; };
        const Outcome outcome = places.program.run({"query", named("ball.xyz"), "--at", named("at.xyz"), "--what",
                                                    "value,centroid,project-orthogonal", "-o", named("answers.csv")});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
    }
    compare(places.program, "answers.csv", {0, 5, 8}, 200);
}

void FarCoordinatesTest::hitsMoveAlong() {
    Places places;
    base::Random random(test::seed());
    std::vector<Vec3d> eyes;
    for (int i = 0; i < 200; ++i)
        eyes.push_back(grid(Vec3d{0.3, -0.2, 0.1} + random.unitVector() * 3));
    std::size_t next = 0;
    places.write(
        "rays.csv",
        [&](const Vec3d& p) {
            return line(p, ",") + "," + line(Vec3d{0.3, -0.2, 0.1} - eyes[next++ % eyes.size()], ",");
        },
        eyes, "ox,oy,oz,dx,dy,dz\n");
    for (const char* place : {"home-", "far-"}) {
        const auto named = [&](const char* name) { return QString(place) + name; };
        const Outcome outcome =
            places.program.run({"intersect", named("ball.xyz"), "--rays", named("rays.csv"), "-o", named("hits.csv")});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
    }
    compare(places.program, "hits.csv", {2}, 199);
}

void FarCoordinatesTest::sectionsMoveAlong() {
    const Places places;
    for (const auto& [place, d] : {std::pair{"home-", "0.125"}, std::pair{"far-", "10000000.125"}}) {
        const auto named = [&](const char* name) { return QString(place) + name; };
        const Outcome outcome = places.program.run(
            {"section", named("ball.xyz"), "--plane", QString("0,0,1,") + d, "-o", named("cut.csv")});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
    }
    compare(places.program, "cut.csv", {2}, 100);
}

/// Drawn, dragged and resampled; saved, and told as text.
void FarCoordinatesTest::strokesMoveAlong() {
    const Places places;
    for (const auto& [place, by] : {std::pair{"home-", Vec3d{}}, std::pair{"far-", far}}) {
        const std::string name = place;
        std::string session = R"({"op": "open", "path": ")" + name + "ball.xyz\"}\n";
        for (const char* tool : {"draw", "grab", "crease"}) {
            session += R"({"op": "stroke", "tool": ")" + std::string(tool) + R"(", "radius": 0.2, "samples": [)";
            for (int k = 0; k < 9; ++k)
                session += (k ? ", [" : "[") + line(by + grid({0.09 * k, 0.1 * std::sin(k) - 0.2, 4}), ", ") +
                           ", 0, 0, -1, 1, 0]";
            session += "]}\n";
        }
        places.program.write(name + "session.jsonl", session);
        const QString out = QString::fromStdString(name) + "out";
        Outcome outcome = places.program.run({"run", (name + "session.jsonl").c_str(), "-o", out + ".ply"});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
        outcome = places.program.run({"convert", out + ".ply", out + ".csv"});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
    }
    compare(places.program, "out.csv", {0}, 5900);
}

static const test::Registered<FarCoordinatesTest> registered;
#include "far_coordinates_test.moc"
