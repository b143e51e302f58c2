// Commands that add and take away matter: each is one step, replays to the same bits, and refuses in a sentence.
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/mesh/extent/extent.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/rims.h"
#include "support/registry.h"
#include "workbench.h"

#include <numbers>
#include <QTest>

using nlohmann::json;
using test::Workbench;

class SolidCommandsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void eachIsAStepThatUndoAndReplayBringBack_data();
    void eachIsAStepThatUndoAndReplayBringBack();
    void journalsBringThemBack();
    void savedOperandsAreOpenedAsModelsAre();
    void reducedModelsEndWhereTheyAreCut();
    void partsPushedIntoEachOtherBecomeOne();
    void rimsOfTheOtherModelStayRims();
    void whatBothKnowOfTheirRimsStaysKnown();
    void insideOfOpenModelsIsSaidToBeAGuess();
    void whatMeetsNothingIsSaidToBeApart();
    void whatIsSwallowedIsTold();
    void wrongNumbersAreRefused();
};

namespace {

const char* const lines[] = {
    R"({"op":"cut","plane":"0.2,1,0,0.3"})",
    R"({"op":"cut","plane":"0,1,0,0.3","keep":"below","cap":false})",
    R"({"op":"solid","sample":"sphere:1500","operation":"difference","position":"0.9,0,0","scale":0.6})",
    R"({"op":"solid","sample":"torus:2000","operation":"union","position":"0.7,0,0","rotation":"90,0,30","creases":false})",
    R"({"op":"solid","sample":"sphere:2500","operation":"union","position":"1.2,0,0","fillet":0.4,"seams":true})",
    R"({"op":"primitive","shape":"box","size":"0.5,0.6,3","rotation":"10,20,30"})",
    R"({"op":"primitive","shape":"cone","size":"0.5,1.5","position":"0,0,1","operation":"intersection"})",
    R"({"op":"drill","from":"0,0,3","direction":"0.1,0,-1","radius":0.3})",
    R"({"op":"drill","from":"0,0,3","direction":"0,0,-1","radius":0.3,"depth":0.5})",
    R"({"op":"trim","eye":[0,1,5],"target":[0,0,0],"size":[400,300],"polygon":[[150,90],[260,120],[200,260]]})",
    R"({"op":"tube","along":[[0.9,0,-0.4],[1.5,0,-0.2],[1.5,0,0.3],[0.8,0,0.5]],"radius":0.15})",
    R"({"op":"tube","along":[[-2,0,0],[0,0.3,0],[2,0,0]],"radius":0.2,"operation":"difference","smooth":false})",
    R"({"op":"mirror","plane":"1,0.2,0,0.1"})",
    R"({"op":"hollow","thickness":0.3})",
};

} // namespace

void SolidCommandsTest::eachIsAStepThatUndoAndReplayBringBack_data() {
    QTest::addColumn<QString>("line");
    for (const char* line : lines)
        QTest::newRow(line) << QString(line);
}

void SolidCommandsTest::eachIsAStepThatUndoAndReplayBringBack() {
    QFETCH(QString, line);
    const json command = json::parse(line.toStdString());
    Workbench bench;
    bench.run(test::newSphere(2500));
    const std::string before = bench.hash();
    bench.run(command);
    bench.document.surface().tree().validate();
    const std::string after = bench.hash();
    QVERIFY(after != before);
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), after);
    base::setThreadCount(1);
    Workbench again;
    again.run(test::newSphere(2500));
    again.run(command);
    base::setThreadCount(0);
    QCOMPARE(again.hash(), after);
}

void SolidCommandsTest::journalsBringThemBack() {
    Workbench bench;
    session::Journal journal(bench.path("journal.jsonl"));
    bench.context.journal = &journal;
    bench.run(test::newSphere(2500));
    for (const int line : {4, 7, 10})
        bench.run(json::parse(lines[line]));
    Workbench again;
    session::replay(bench.path("journal.jsonl"), again.context);
    QCOMPARE(again.hash(), bench.hash());
}

void SolidCommandsTest::savedOperandsAreOpenedAsModelsAre() {
    Workbench tool;
    tool.run(test::newSphere(1500));
    const std::string file = tool.path("ball.ply").string();
    tool.run({{"op", "save"}, {"path", file}});
    Workbench one, other;
    for (Workbench* bench : {&one, &other})
        bench->run(test::newSphere(2500));
    json command{{"op", "solid"}, {"operation", "difference"}, {"position", "0.9,0.3,0"}};
    command["path"] = file;
    command["hash"] = tool.hash();
    one.run(command);
    command.erase("path");
    command.erase("hash");
    command["sample"] = "sphere:1500";
    other.run(command);
    QCOMPARE(one.size(), other.size());
}

/// Few surfels hardly show a rim: without a limit the surface runs on beyond it, by half of its area.
void SolidCommandsTest::reducedModelsEndWhereTheyAreCut() {
    base::Random random(test::seed());
    for (const char* shapes : {"spheres", "ellipsoids"}) {
        Workbench bench;
        bench.run(test::newSphere(2000));
        bench.run({{"op", "reduce"}, {"ratio", 0.2}, {"shapes", shapes}});
        const double height = random.uniform(-0.3, 0.3);
        bench.run({{"op", "cut"}, {"plane", {0, 0, 1, height}}, {"cap", false}});
        const mesh::Extent found = mesh::extentOf(bench.document.surface());
        const double wanted = 2 * std::numbers::pi * (1 - height);
        QVERIFY(!found.closed);
        QVERIFY2(std::abs(found.area / wanted - 1) < 0.15, QByteArray::number(found.area / wanted));
    }
}

void SolidCommandsTest::partsPushedIntoEachOtherBecomeOne() {
    Workbench bench;
    bench.run(test::newSphere(2500));
    const std::string one = bench.hash();
    bench.run({{"op", "merge"}}); // nothing to do: no step
    QCOMPARE(bench.hash(), one);
    bench.run({{"op", "select"}, {"by", "all"}});
    bench.run({{"op", "duplicate"}, {"move", {1, 0, 0}}});
    const std::size_t both = bench.document.surface().tree().size();
    QCOMPARE(both, std::size_t(5000));
    const std::string before = bench.hash();
    bench.run({{"op", "merge"}});
    // a cap of height 1/2 went from each, a quarter of its area
    const auto left = static_cast<double>(bench.document.surface().tree().size());
    QVERIFY2(std::abs(left - 3750) < 100, QByteArray::number(left));
    QVERIFY(bench.document.surface().tree().layout()->find("cell"));
    const std::string after = bench.hash();
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), after);
}

void SolidCommandsTest::rimsOfTheOtherModelStayRims() {
    Workbench bowl;
    bowl.run(test::newSphere(2500));
    bowl.run({{"op", "cut"}, {"plane", "0,0,1,-0.3"}, {"cap", false}});
    bowl.run({{"op", "save"}, {"path", bowl.path("bowl.ply").string()}});
    // Its rim is beside the model, or within.
    for (const auto& [position, closed] : {std::pair("0.6,0,0.2", false), std::pair("0,0,1", true)}) {
        Workbench bench;
        bench.run(test::newSphere(2500));
        bench.run({{"op", "solid"}, {"path", bowl.path("bowl.ply").string()}, {"position", position}});
        QVERIFY2(std::isinf(bench.document.surface().definition().boundaryLimit) == closed, position);
    }
}

/// A closed model joined with an open one that knows its rims: those are the two's, and no tip is one.
void SolidCommandsTest::whatBothKnowOfTheirRimsStaysKnown() {
    Workbench bowl;
    bowl.run(test::newSphere(2500));
    bowl.run({{"op", "cut"}, {"plane", "0,0,1,-0.3"}, {"cap", false}});
    bowl.run({{"op", "cut"}, {"plane", "0,0,-1,-0.7"}}); // with a cap: its rim is known from now on
    QVERIFY(surface::knowsRims(bowl.document.surface()));
    bowl.run({{"op", "save"}, {"path", bowl.path("bowl.ply").string()}});
    for (const std::size_t rims : {1U, 0U}) { // below the model, and within it
        Workbench bench;
        bench.run(test::newSphere(2500));
        bench.run({{"op", "solid"},
                   {"path", bowl.path("bowl.ply").string()},
                   {"position", rims ? "0.05,0,-1.5" : "0,0,0"},
                   {"scale", rims ? 1 : 0.5}});
        QCOMPARE(surface::knowsRims(bench.document.surface()), rims == 1); // within, it is as it was
        QCOMPARE(surface::findBoundaryCurves(bench.document.surface()).size(), rims);
    }
}

static bool told(const Workbench& bench, const char* words) {
    return std::ranges::any_of(bench.context.messages,
                               [&](const std::string& each) { return each.find(words) != std::string::npos; });
}

/// By every command that closes or joins, and by none that leaves a cut open.
void SolidCommandsTest::insideOfOpenModelsIsSaidToBeAGuess() {
    for (const bool open : {false, true})
        for (const char* line : lines) {
            json command = json::parse(line);
            if (command["op"] == "mirror")
                continue;
            command.erase("fillet"); // it would not fit at the rim
            Workbench bench;
            bench.run(test::newSphere(2500));
            if (open)
                bench.run({{"op", "cut"}, {"plane", "0,0,1,-0.6"}, {"cap", false}});
            bench.context.messages.clear();
            bench.run(command);
            QVERIFY2(told(bench, "are a guess") == (open && command.value("cap", true)), line);
        }
}

void SolidCommandsTest::whatMeetsNothingIsSaidToBeApart() {
    for (const char* line : {R"({"op":"tube","along":[[%1,0,0],[%1,1,0]],"radius":0.2})",
                             R"({"op":"primitive","size":"0.3","position":"%1,0,0"})",
                             R"({"op":"solid","sample":"sphere:500","scale":0.4,"position":"%1,0,0"})"})
        for (const auto& [x, apart] : {std::pair("0.9", false), std::pair("3", true)}) {
            Workbench bench;
            bench.run(test::newSphere(2500));
            bench.run(json::parse(QString(line).arg(x).toStdString()));
            QVERIFY2(told(bench, "does not meet") == apart, line);
        }
}

void SolidCommandsTest::whatIsSwallowedIsTold() {
    for (const auto& [size, gone] : {std::pair("0.3", false), std::pair("2", true)}) {
        Workbench bench;
        bench.run(test::newSphere(2500));
        bench.run(json::parse(R"({"op":"primitive","size":"0.3","position":"4,0,0"})"));
        QVERIFY(!told(bench, "gone as a whole"));
        bench.run(
            json::parse(QString(R"({"op":"primitive","size":"%1","position":"4.2,0,0"})").arg(size).toStdString()));
        QVERIFY2(told(bench, "A part of the model is gone as a whole.") == gone, size);
    }
}

void SolidCommandsTest::wrongNumbersAreRefused() {
    Workbench bench;
    bench.run(test::newSphere(1500));
    const std::string before = bench.hash();
    for (const char* line :
         {R"({"op":"cut","plane":"0,0,0,1"})", R"({"op":"cut","plane":"0,1,0"})", R"({"op":"cut","plane":"0,1,0,x"})",
          R"({"op":"cut","plane":"0,1,0,7"})", R"({"op":"solid"})", R"({"op":"solid","sample":"teapot"})",
          R"({"op":"solid","sample":"sphere","path":"a.ply"})", R"({"op":"primitive","size":"1,2"})",
          R"({"op":"primitive","size":"-1"})", R"({"op":"primitive","size":"1e9","spacing":1e-3})",
          R"({"op":"drill","from":"5,5,5","direction":"0,0,1","radius":0.1})",
          R"({"op":"drill","from":"0,0,3","direction":"0,0,0","radius":0.1})",
          R"({"op":"drill","from":"0,0,3","direction":"0,0,-1","radius":0.01})",
          R"({"op":"tube","along":[[0,0,2],[0,0,0]],"radius":0.01})",
          R"({"op":"tube","along":[[0,0,0],[0.5,0,0.2],[1.5,0,0]],"radius":0.01,"operation":"difference"})",
          R"({"op":"hollow","thickness":2})", R"({"op":"mirror","plane":"1,0,0,9"})", R"({"op":"fill","holes":0})"}) {
        QVERIFY2(!bench.refusal(json::parse(line)).empty(), line);
        QCOMPARE(bench.hash(), before);
    }
}

static const test::Registered<SolidCommandsTest> registered;
#include "solid_commands_test.moc"
