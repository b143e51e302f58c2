// Scenes on the command line: told, drawn and worked on where they stand.
#include "program.h"
#include "support/registry.h"

#include <cmath>
#include <QTest>

using nlohmann::json;
using test::Outcome, test::Program;

class SceneTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void infoTellsWhereModelsStand();
    void picturesDoNotDependOnWhoIsActive();
    void subcommandsAreAboutTheActiveModelWhereItStands();
    void conversionWritesAllModels();
};

/// A ball and, turned by a quarter and moved by 3 along x, a torus. `active` tells who is.
static void makeScene(const Program& program, const std::string& active) {
    program.write("s.jsonl", R"({"op":"new","sample":"sphere","count":2000}
{"op":"scene","do":"rename","to":"ball"}
{"op":"scene","do":"add","sample":"torus:3000","name":"ring","matrix":[1,0,0,3,0,0,-1,0,0,1,0,0,0,0,0,1]}
{"op":"scene","do":"activate","name":")" +
                                 active + "\"}\n");
    QCOMPARE(program.run({"run", "s.jsonl", "-o", (active + ".scene.json").c_str()}).code, 0);
    QCOMPARE(program.run({"run", "s.jsonl", "-o", (active + ".ply").c_str()}).code, 0);
}

static json infoOf(const Program& program, const char* model) {
    return json::parse(program.run({"info", model, "--json"}).out);
}

void SceneTest::infoTellsWhereModelsStand() {
    const Program program;
    makeScene(program, "ball");
    for (const char* file : {"ball.scene.json", "ball.ply"}) {
        const json info = infoOf(program, file);
        QCOMPARE(info["models"].size(), std::size_t(2));
        QCOMPARE(info["surfels"], info["models"][0]["surfels"].get<int>() + info["models"][1]["surfels"].get<int>());
        const json& ring = info["models"][1];
        QCOMPARE(ring["name"], json("ring"));
        const auto low = [&](int k) { return ring["bounds"]["min"][std::size_t(k)].get<double>(); };
        QVERIFY(std::abs(low(0) - 2) < 0.05 && std::abs(low(1) + 1) < 0.05); // it stands upright, 3 to the right
        QVERIFY(std::abs(low(2) + 0.3) < 0.05);
        program.write("o.jsonl", "{\"op\":\"open\",\"path\":\"" + std::string(file) +
                                     "\"}\n{\"op\":\"expect\",\"hash\":" + info["hash"].dump() + "}\n");
        QCOMPARE(program.run({"run", "o.jsonl"}).code, 0);
    }
}

void SceneTest::picturesDoNotDependOnWhoIsActive() {
    const Program program;
    makeScene(program, "ball");
    makeScene(program, "ring");
    for (const QStringList& view :
         {QStringList{"--eye", "2,1,7", "--target", "1.5,0,0"}, QStringList{"--mode", "raycast"}}) {
        for (const char* active : {"ball", "ring"})
            QCOMPARE(program
                         .run(QStringList{"render", QString("%1.scene.json").arg(active), "-o",
                                          QString("%1.png").arg(active), "--size", "160x120", "--depth",
                                          QString("%1.pfm").arg(active)} +
                              view)
                         .code,
                     0);
        const std::string a = program.read("ball.pfm"), b = program.read("ring.pfm");
        QCOMPARE(a.size(), b.size());
        const std::size_t begin = a.size() - 4 * 160 * 120;
        int off = 0;
        for (std::size_t i = begin; i < a.size(); i += 4) {
            float x = 0, y = 0;
            std::memcpy(&x, a.data() + i, 4);
            std::memcpy(&y, b.data() + i, 4);
            off += std::isfinite(x) != std::isfinite(y) || (std::isfinite(x) && std::abs(x - y) > 0.02f) ? 1 : 0;
        }
        QVERIFY2(off < 60, qPrintable(QString("%1: %2").arg(view.join(' ')).arg(off)));
    }
}

void SceneTest::subcommandsAreAboutTheActiveModelWhereItStands() {
    const Program program;
    makeScene(program, "ring");
    program.write("at.csv", "3.9,0,0.0\n0,0,1\n");
    const Outcome query = program.run({"query", "ring.scene.json", "--at", "at.csv", "--what", "value", "-o", "q.csv"});
    QCOMPARE(query.code, 0);
    QVERIFY2(query.err.find("\"ring\" alone") != std::string::npos, query.err.c_str());
    const auto rows = test::rowsOf(program.read("q.csv"));
    QCOMPARE(rows[1][3], std::string("ok"));      // within the ring's tube
    QCOMPARE(rows[2][3], std::string("outside")); // the ball is not asked
}

void SceneTest::conversionWritesAllModels() {
    const Program program;
    makeScene(program, "ball");
    QCOMPARE(program.run({"convert", "ball.scene.json", "all.ply"}).code, 0);
    QCOMPARE(infoOf(program, "all.ply")["models"].size(), std::size_t(2));
    QCOMPARE(infoOf(program, "all.ply")["hash"], infoOf(program, "ball.ply")["hash"]);
}

static const test::Registered<SceneTest> registered;
#include "scene_test.moc"
