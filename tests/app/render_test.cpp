// render: a picture, its depth and its costs, by splats and by rays.
#include "core/base/up_axis.h"
#include "program.h"
#include "support/registry.h"

#include <cstring>
#include <QTest>

using nlohmann::json;
using test::Outcome;
using test::Program;

class RenderTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void depthIsTheDistanceToTheSphere_data();
    void depthIsTheDistanceToTheSphere();
    void statsHaveTheContractsKeys();
    void qualitySavesRays();
    void theDefaultViewShowsTheWholeModel();
    void viewsFollowTheUpAxis();
    void whatIsHiddenAndNotDrawnIsTold();
};

struct Depth {
    int width = 0, height = 0;
    std::vector<float> rows; ///< bottom to top
};

static Depth depthOf(const std::string& pfm) {
    Depth out;
    int offset = 0;
    float scale = 0;
    if (std::sscanf(pfm.c_str(), "Pf %d %d %f%n", &out.width, &out.height, &scale, &offset) != 3 || scale >= 0)
        return {};
    out.rows.resize(static_cast<std::size_t>(out.width * out.height));
    const std::size_t bytes = out.rows.size() * sizeof(float);
    if (pfm.size() != static_cast<std::size_t>(offset) + 1 + bytes)
        return {};
    std::memcpy(out.rows.data(), pfm.data() + offset + 1, bytes);
    return out;
}

static bool isPng(const std::string& bytes, int width, int height) {
    const auto at = [&](std::size_t k) { return static_cast<unsigned char>(bytes[k]); };
    return bytes.size() > 33 && bytes.compare(1, 3, "PNG") == 0 && at(18) * 256 + at(19) == width &&
           at(22) * 256 + at(23) == height;
}

void RenderTest::depthIsTheDistanceToTheSphere_data() {
    QTest::addColumn<QString>("mode");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("splats") << "splats" << 0.03;
    QTest::newRow("raycast") << "raycast" << 2e-3;
}

void RenderTest::depthIsTheDistanceToTheSphere() {
    QFETCH(QString, mode);
    QFETCH(double, tolerance);
    const Program program;
    const Outcome outcome =
        program.run({"render", "sample:sphere:4000", "-o", "a.png", "--mode", mode, "--size", "80x60", "--eye", "0,0,4",
                     "--target", "0,0,0", "--up", "0,1,0", "--fov", "40", "--depth", "a.pfm"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY(isPng(program.read("a.png"), 80, 60));
    const Depth depth = depthOf(program.read("a.pfm"));
    QVERIFY(depth.width == 80 && depth.height == 60);
    const double focal = 30 / std::tan(20 * 3.14159265358979 / 180);
    int hits = 0;
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 80; ++column) {
            const base::Vec3d d = base::normalized(base::Vec3d{column + 0.5 - 40, row + 0.5 - 30, -focal});
            const double along = -4 * d.z, beside = std::sqrt(16 - along * along);
            const float found = depth.rows[static_cast<std::size_t>(row * 80 + column)];
            if (std::abs(beside - 1) < 0.06)
                continue;
            QCOMPARE(std::isfinite(found), beside < 1);
            if (beside < 1) {
                ++hits;
                QVERIFY(std::abs(found - (along - std::sqrt(1 - beside * beside))) < tolerance);
            }
        }
    QVERIFY(hits > 500);
}

void RenderTest::statsHaveTheContractsKeys() {
    const Program program;
    for (const char* mode : {"splats", "raycast"}) {
        QCOMPARE(program
                     .run({"render", "sample:torus:3000", "-o", "a.png", "--mode", mode, "--size", "64x48", "--stats",
                           "a.json", "--quality", "0"})
                     .code,
                 0);
        const json stats = json::parse(program.read("a.json"));
        const bool rays = std::string(mode) == "raycast";
        QCOMPARE(stats.size(), std::size_t(rays ? 8 : 4));
        QCOMPARE(stats.at("pixels"), json(64 * 48));
        QVERIFY(stats.at("seconds").get<double>() > 0);
        QCOMPARE(stats.at("rays").get<int>() > 0, rays);
        QCOMPARE(stats.at("evaluations").get<int>() > 0, rays);
    }
}

void RenderTest::qualitySavesRays() {
    const Program program;
    const auto render = [&](const char* quality, const char* turntable) {
        const auto outcome =
            program.run({"render", "sample:torus:20000", "-o", "a.png", "--mode", "raycast", "--size", "240x180",
                         "--stats", "a.json", "--quality", quality, "--turntable", turntable});
        return outcome.code == 0 ? json::parse(program.read("a.json")).at("rays").get<int>() : 0;
    };
    const int one = render("1", "1");
    QCOMPARE(render("0", "1"), 240 * 180);
    QVERIFY(one > 0 && one * 4 < 240 * 180);
    // The torus looks nearly the same from all around, but each picture is asked for anew.
    QVERIFY(render("1", "36") < 36 * one * 2 / 3);
}

void RenderTest::theDefaultViewShowsTheWholeModel() {
    const Program program;
    QCOMPARE(program
                 .run({"render", "sample:knot:8000", "-o", "a.png", "--size", "120x90", "--depth", "a.pfm",
                       "--transparent", "--shading", "normal"})
                 .code,
             0);
    const Depth depth = depthOf(program.read("a.pfm"));
    int inside = 0;
    for (int row = 0; row < 90; ++row)
        for (int column = 0; column < 120; ++column)
            if (std::isfinite(depth.rows[static_cast<std::size_t>(row * 120 + column)])) {
                ++inside;
                QVERIFY(row > 0 && row < 89 && column > 0 && column < 119);
            }
    QVERIFY(inside > 120 * 90 / 10);
}

/// A snail's shell of points that has no symmetry, standing with `up` upwards.
static std::string shell(base::UpAxis up) {
    std::string out;
    for (int i = 0; i < 4000; ++i) {
        const double t = 0.003 * i, around = 2.4 * i, r = 0.25 + 0.02 * t;
        const base::Vec3d p{(1 + r * std::cos(around)) * std::cos(0.4 * t), 0.1 * t + r * std::sin(around),
                            (1 + r * std::cos(around)) * std::sin(0.4 * t)};
        const base::Vec3d q = fromStanding(up, p);
        for (const double v : {q.x, q.y, q.z})
            out += std::to_string(v) + " ";
        out += "\n";
    }
    return out;
}

void RenderTest::viewsFollowTheUpAxis() {
    const Program program;
    const auto depth = [&](base::UpAxis axis, const QStringList& view) {
        const std::string id = base::upRow(axis).id;
        program.write("m.xyz", shell(axis));
        const Outcome outcome = program.run(QStringList{"render", "m.xyz", "-o", "a.png", "--size", "80x60", "--depth",
                                                        "a.pfm", "--grid", "--up", id.c_str()} +
                                            view);
        return outcome.code == 0 ? depthOf(program.read("a.pfm")) : Depth{};
    };
    for (const QStringList& view : {QStringList{}, {"--view", "front"}, {"--view", "top"}, {"--view", "left"}}) {
        const Depth standing = depth(base::UpAxis::Y, view);
        QCOMPARE(standing.rows.size(), std::size_t(4800));
        for (const base::UpAxis axis : {base::UpAxis::Z, base::UpAxis::MinusX, base::UpAxis::MinusY}) {
            const Depth turned = depth(axis, view);
            QCOMPARE(turned.rows.size(), std::size_t(4800));
            int other = 0;
            for (std::size_t i = 0; i < 4800; ++i)
                other += std::isfinite(standing.rows[i]) != std::isfinite(turned.rows[i]) ||
                         std::abs(standing.rows[i] - turned.rows[i]) > 0.05f;
            QVERIFY2(other < 60, qPrintable(QString("%1 %2").arg(view.join(' ')).arg(other)));
        }
    }
    // A vector is up in the picture alone, as it always was.
    QCOMPARE(program.run({"render", "m.xyz", "-o", "a.png", "--size", "40x30", "--up", "0,0.5,1"}).code, 0);
    QCOMPARE(program.run({"render", "m.xyz", "-o", "a.png", "--size", "40x30", "--up=-z"}).code, 0);
    QCOMPARE(program.run({"render", "m.xyz", "-o", "a.png", "--up", "w"}).code, 2);
    QCOMPARE(program.run({"render", "m.xyz", "-o", "a.png", "--up", "0,0,0"}).code, 2);
}

void RenderTest::whatIsHiddenAndNotDrawnIsTold() {
    const Program program;
    program.write("s.jsonl", R"({"op":"new","sample":"sphere","count":2000}
{"op":"save","path":"whole.ply"}
{"op":"select","by":"plane","plane":[0,1,0,0.5]}
{"op":"hide"}
{"op":"save","path":"part.ply"}
)");
    QCOMPARE(program.run({"run", "s.jsonl"}).code, 0);
    for (const auto& [name, told] : {std::pair("whole.ply", false), std::pair("part.ply", true)}) {
        const Outcome outcome = program.run({"render", name, "-o", "o.png", "--size", "64x48"});
        QVERIFY2(outcome.code == 0 && (outcome.err.find("not drawn") != std::string::npos) == told,
                 outcome.err.c_str());
    }
}

static const test::Registered<RenderTest> registered;
#include "render_test.moc"
