// Reduced models with ellipsoidal supports, as a person meets them: report, info, file, session, and what is done with
// such a model afterwards.
#include "program.h"
#include "support/registry.h"

#include <cmath>
#include <QTest>

using test::json;
using test::Outcome;
using test::Program;

class EllipsoidsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theFileOpensAsItWas();
    void whatWasSculptedOpensAsItWas();
    void infoAndReportTellTheShapes();
    void turningTheModelTurnsThem();
    void whatMakesSupportsAnewMakesBalls();
};

static json infoOf(const Program& program, const char* model) {
    return json::parse(program.run({"info", model, "--json"}).out);
}

static void reduced(const Program& program) {
    const Outcome outcome = program.run({"reduce", "sample:torus:4000", "-o", "few.ply", "--ratio", "0.1", "--shapes",
                                         "ellipsoids", "--report", "few.json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
}

void EllipsoidsTest::theFileOpensAsItWas() {
    const Program program;
    reduced(program);
    program.write("again.jsonl", R"({"op":"open","path":"few.ply"}
{"op":"save","path":"again.ply"}
{"op":"new","sample":"torus","count":4000}
{"op":"reduce","ratio":0.1,"shapes":"ellipsoids"}
{"op":"save","path":"session.ply"}
)");
    const Outcome outcome = program.run({"run", "again.jsonl"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QCOMPARE(program.read("again.ply"), program.read("few.ply"));
    QCOMPARE(program.hash("session.ply"), program.hash("few.ply"));
    for (const char* mode : {"raycast", "splats"})
        QCOMPARE(program.run({"render", "few.ply", "-o", "few.png", "--size", "64x64", "--mode", mode}).code, 0);
    QCOMPARE(program.run({"mesh", "few.ply", "-o", "few.stl", "--method", "delaunay"}).code, 0);
}

/// Strokes turn normals, and shapes are not turned after them.
void EllipsoidsTest::whatWasSculptedOpensAsItWas() {
    const Program program;
    reduced(program);
    program.write("sculpt.jsonl", R"({"op":"open","path":"few.ply"}
{"op":"stroke","tool":"grab","radius":0.6,"strength":1,"resample":false,"samples":[[0,0,5,0,0,-1,1,0],[1,0,5,0,0,-1,1,0],[1.4,0.3,5,0,0,-1,1,1]]}
{"op":"save","path":"sculpted.ply"}
)");
    program.write("open.jsonl", R"({"op":"open","path":"sculpted.ply"}
{"op":"save","path":"again.ply"}
)");
    for (const char* session : {"sculpt.jsonl", "open.jsonl"}) {
        const Outcome outcome = program.run({"run", session});
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
    }
    QVERIFY(program.read("sculpted.ply") != program.read("few.ply"));
    QCOMPARE(program.read("again.ply"), program.read("sculpted.ply"));
}

void EllipsoidsTest::infoAndReportTellTheShapes() {
    const Program program;
    reduced(program);
    const json report = json::parse(program.read("few.json"));
    QCOMPARE(report.at("shapes"), "ellipsoids");
    QCOMPARE(report.at("holes"), 0);
    QCOMPARE(infoOf(program, "few.ply").at("shapes"), true);
    QCOMPARE(infoOf(program, "sample:torus:500").at("shapes"), false);
}

/// A turn of the model and back: its surface is where it was.
void EllipsoidsTest::turningTheModelTurnsThem() {
    const Program program;
    reduced(program);
    program.write("turn.jsonl", R"({"op":"open","path":"few.ply"}
{"op":"transform","axis":[1,2,3],"angle":70,"about":[0,0,0]}
{"op":"save","path":"turned.ply"}
{"op":"transform","axis":[1,2,3],"angle":-70,"about":[0,0,0]}
{"op":"save","path":"back.ply"}
)");
    const Outcome outcome = program.run({"run", "turn.jsonl"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QCOMPARE(infoOf(program, "turned.ply").at("shapes"), true);
    const auto apart = [&](const char* of, const char* to) { // of its points to that surface
        return json::parse(program.run({"measure", of, "--to", to, "--json"}).out).at("to").at("rms").get<double>();
    };
    const double own = apart("few.ply", "few.ply");
    QVERIFY(own > 0);
    for (const double other : {apart("turned.ply", "turned.ply"), apart("back.ply", "few.ply")})
        QVERIFY2(std::abs(other - own) < 1e-2 * own, qPrintable(QString("%1, not %2").arg(other).arg(own)));
}

void EllipsoidsTest::whatMakesSupportsAnewMakesBalls() {
    const Program program;
    reduced(program);
    program.write("anew.jsonl", R"({"op":"open","path":"few.ply"}
{"op":"resample","spacing":0.1}
{"op":"save","path":"even.ply"}
{"op":"open","path":"few.ply"}
{"op":"surface","neighbours":30}
{"op":"save","path":"thirty.ply"}
)");
    const Outcome outcome = program.run({"run", "anew.jsonl"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QCOMPARE(infoOf(program, "even.ply").at("shapes"), false);
    QCOMPARE(infoOf(program, "thirty.ply").at("shapes"), false);
}

static const test::Registered<EllipsoidsTest> registered;
#include "ellipsoids_test.moc"
