#include "core/session/command.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/process/estimation/spacing.h"
#include "core/process/samples/samples.h"
#include "core/sculpt/tool.h"
#include "support/registry.h"
#include "workbench.h"

#include <cmath>
#include <QTest>
#include <set>

using nlohmann::json;
using test::Workbench;

class CommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyRowIsWhole();
    void fallbacksPassTheirOwnCheck();
    void numbersInOneTextMayBeAList();
    void whatIsWrongIsRefused_data();
    void whatIsWrongIsRefused();
    void nothingToDoIsSaidAndTheSessionGoesOn();
    void everyToolsParametersAreTakenWithinTheirRange();
    void noToolHidesAParameterOfTheStroke();
    void failureLeavesTheDocumentAlone();
    void cancellingLeavesTheDocumentAlone();
    void aStrokeThatMissesLeavesNoStep();
    void everyToolUndoesToTheSameHash();
    void savedModelsOpenWithTheSameHash();
    void exportLeavesTheDocumentUnsaved();
    void everySampleCanBeMade();
    void surfaceChangesWhatItNames();
    void resampleReachesTheSpacing();
    void spacingsAsWideAsTheModelAreRefusedOrTold();
    void expectEndsASessionThatWentAstray();
};

void CommandTest::everyRowIsWhole() {
    const std::set<std::string> types{"path",    "paths",  "number",  "integer",
                                      "boolean", "choice", "choices", "number or choice",
                                      "list",    "range",  "text"};
    std::set<std::string> ops;
    for (const session::CommandRow& row : session::commandTable()) {
        QVERIFY2(ops.insert(row.op).second, row.op);
        QVERIFY2(*row.label && *row.tip && row.run, row.op);
        QVERIFY2(row.changesModel || !row.startsModel, row.op);
        QCOMPARE(&session::command(row.op), &row);
        std::set<std::string> ids;
        for (const session::CommandParameter& p : row.parameters) {
            QVERIFY2(ids.insert(p.id).second, p.id);
            QVERIFY2(*p.tip && types.contains(p.type), p.id);
            QVERIFY2((std::string(p.type).find("choice") != std::string::npos) == (*p.choices != 0), p.id);
            QVERIFY2(p.min <= p.max, p.id);
        }
    }
    for (const char* op :
         {"open", "new", "save", "surface", "stroke", "undo", "redo", "resample", "reduce", "refine", "expect", "up"})
        QVERIFY2(ops.contains(op), op);
}

/// A value that the parameter takes, where it is required.
static json someValue(const session::CommandParameter& p) {
    const std::string type = p.type;
    if (type == "choice")
        return std::string(p.choices).substr(0, std::string(p.choices).find(' '));
    if (type == "list")
        return json::array();
    return type == "number" || type == "integer" ? json(p.min) : json("file.ply");
}

void CommandTest::fallbacksPassTheirOwnCheck() {
    for (const session::CommandRow& row : session::commandTable()) {
        json command{{"op", row.op}};
        for (const session::CommandParameter& p : row.parameters)
            if (!*p.fallback)
                command[p.id] = someValue(p);
        const json whole = session::complete(command);
        QCOMPARE(session::complete(whole), whole);
        for (const session::CommandParameter& p : row.parameters)
            QVERIFY2(whole.contains(p.id) == (std::string(p.fallback) != "null"), p.id);
    }
}

void CommandTest::numbersInOneTextMayBeAList() {
    base::Random random(test::seed());
    for (int k = 0; k < 100; ++k) {
        json list = json::array();
        for (int i = 0; i < 3; ++i)
            list.push_back(random.uniform(-1, 1) * std::pow(10., random.uniform(-9, 9)));
        const json complete =
            session::complete({{"op", "drill"}, {"from", list}, {"direction", "0,0,1"}, {"radius", 1}});
        QCOMPARE(json::parse("[" + complete.at("from").get<std::string>() + "]"), list); // no bit is lost
        QCOMPARE(session::complete(complete), complete);
    }
    QCOMPARE(session::complete(json::parse(R"({"op":"cut","plane":[0,0,1,0.25]})")),
             session::complete(json::parse(R"({"op":"cut","plane":"0,0,1,0.25"})")));
    for (const char* wrong : {"[]", "[0,0,[1],0]", "[0,\"0\",1,0]", "[0,null,1,0]", "7", "{\"x\":1}"})
        QVERIFY_THROWS_EXCEPTION(base::Error, session::complete({{"op", "cut"}, {"plane", json::parse(wrong)}}));
}

void CommandTest::whatIsWrongIsRefused_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* line, const char* told) { QTest::newRow(line) << line << told; };
    row(R"({"op":"melt"})", "unknown op \"melt\"");
    row(R"([1,2])", "not a command");
    row(R"({"path":"a.ply"})", "not a command");
    row(R"({"op":7})", "not a command");
    row(R"({"op":"undo","times":2})", "unknown parameter \"times\" of \"undo\"");
    row(R"({"op":"open"})", "needs the parameter \"path\"");
    row(R"({"op":"open","path":7})", "\"path\" of \"open\" is 7");
    row(R"({"op":"open","path":"nowhere.ply"})", "nowhere.ply");
    row(R"({"op":"new","sample":"teapot"})", "must be one of");
    row(R"({"op":"new","sample":"sphere","count":2.5})", "a whole number");
    row(R"({"op":"new","sample":"sphere","count":3})", "100 to 1e+08 surfels");
    row(R"({"op":"resample","spacing":0})", "above 0 model units");
    row(R"({"op":"resample","spacing":1e300})", "at most 3.40282e+38 model units");
    row(R"({"op":"resample","spacing":"fine"})", "must be a number");
    row(R"({"op":"surface","frame":"square"})", "must be one of");
    row(R"({"op":"surface","boundary":"sometimes"})", "must be a number, above 0 h, or one of auto none");
    row(R"({"op":"surface","shrink-free":1})", "must be true or false, or one of on off");
    row(R"({"op":"save","path":""})", "must be text that is not empty");
    row(R"({"op":"surface","support":1,"neighbours":20})", "exclude each other");
    row(R"({"op":"stroke","tool":"draw","samples":[]})", "needs the parameter \"radius\"");
    row(R"({"op":"stroke","tool":"draw","radius":0.1,"samples":[]})", "no samples");
    row(R"({"op":"stroke","tool":"draw","radius":-1,"samples":[]})", "above 0");
    row(R"({"op":"stroke","tool":"draw","radius":0.1,"strength":1.5,"samples":[]})", "0 to 1");
    row(R"({"op":"stroke","tool":"axe","radius":0.1,"samples":[]})", "must be one of");
    row(R"({"op":"stroke","tool":"draw","radius":0.1,"wetness":1,"samples":[]})", "wetness");
    row(R"({"op":"stroke","tool":"draw","radius":0.1,"symmetry":["w"],"samples":[[0,0,5,0,0,-1,1,0]]})", "symmetry");
    row(R"({"op":"stroke","tool":"draw","radius":0.1,"samples":[[0,0,5,0,0,-1,1]]})", "sample 1");
    row(R"({"op":"stroke","tool":"draw","radius":0.1,"samples":[[0,0,5,0,0,-1,1,0],[0,0,5,0,0,0,1,0]]})", "sample 2");
    row(R"({"op":"stroke","tool":"draw","radius":0.1,"samples":[[0,0,5,0,0,-1,2,0]]})", "sample 1");
    row(R"({"op":"stroke","tool":"draw","radius":0.1,"samples":[[0,0,5,0,0,-1,1,-1]]})", "sample 1");
    row(R"({"op":"stroke","tool":"draw","radius":0.1,"samples":[[0,0,"5",0,0,-1,1,0]]})", "sample 1");
    row(R"({"op":"stroke","tool":"grab","radius":0.1,"samples":[[0,0,5,0,0,-1,1,0,1,1e30]]})", "below 1e15");
    row(R"({"op":"save","path":"out.unknown"})", "out.unknown");
    row(R"({"op":"expect","surfels":-1})", "a whole number or a list");
    row(R"({"op":"expect","surfels":[1,2,3]})", "a whole number or a list");
}

void CommandTest::nothingToDoIsSaidAndTheSessionGoesOn() {
    for (const char* op : {"undo", "redo", "fill"}) {
        Workbench bench;
        bench.run({{"op", "new"}, {"sample", "sphere"}, {"count", 500}});
        const std::string before = bench.document.hash().text();
        bench.context.messages.clear();
        bench.run({{"op", op}});
        QCOMPARE(bench.document.hash().text(), before);
        QVERIFY2(bench.context.messages.size() == 1 &&
                     bench.context.messages[0].find(std::string("nothing to ") + op) != std::string::npos,
                 op);
        QVERIFY2(!bench.document.canUndo(), op);
    }
}

void CommandTest::whatIsWrongIsRefused() {
    QFETCH(QString, line);
    QFETCH(QString, told);
    Workbench bench;
    bench.context.folder = bench.dir.path().toStdString();
    bench.run(test::newSphere(500));
    const std::string before = bench.hash(), message = bench.refusal(json::parse(line.toStdString()));
    QVERIFY2(message.find(told.toStdString()) != std::string::npos, message.c_str());
    QCOMPARE(bench.hash(), before);
    QVERIFY(!bench.document.canUndo());
}

void CommandTest::everyToolsParametersAreTakenWithinTheirRange() {
    for (const sculpt::ToolRow& tool : sculpt::toolTable())
        for (const sculpt::ToolParameter& p : tool.parameters) {
            json command{{"op", "stroke"}, {"tool", tool.id}, {"radius", 0.1}, {"samples", json::array()}};
            for (const double value : {p.fallback, p.min, p.max}) {
                command[p.id] = value;
                QVERIFY2(session::complete(command).at(p.id) == value, p.id);
            }
            for (const json& value : {json(p.max + 1), json(p.min - 1), json("much")}) {
                command[p.id] = value;
                QVERIFY_EXCEPTION_THROWN(session::complete(command), base::Error);
            }
        }
}

void CommandTest::noToolHidesAParameterOfTheStroke() {
    for (const sculpt::ToolRow& tool : sculpt::toolTable())
        for (const sculpt::ToolParameter& own : tool.parameters)
            for (const session::CommandParameter& p : session::command("stroke").parameters)
                QVERIFY2(std::string(own.id) != p.id && std::string(own.id) != "op", own.id);
}

void CommandTest::failureLeavesTheDocumentAlone() {
    Workbench bench;
    for (const char* op : {"undo", "save", "surface", "resample"})
        QVERIFY(!bench.refusal({{"op", op}, {"path", "a.ply"}, {"spacing", 1}}).empty());
    QVERIFY(bench.refusal(test::strokeAt(0)).find("no model") != std::string::npos);
    bench.run(test::newSphere());
    bench.run(test::strokeAt(0));
    const std::string before = bench.hash();
    test::write(bench.path("three.xyz"), "0 0 0\n1 0 0\n0 1 0\n");
    const std::string message = bench.refusal({{"op", "open"}, {"path", bench.path("three.xyz").string()}});
    QVERIFY2(message.find("three.xyz") != std::string::npos, message.c_str());
    QCOMPARE(bench.hash(), before);
    QVERIFY(bench.document.canUndo());
}

void CommandTest::cancellingLeavesTheDocumentAlone() {
    Workbench bench;
    bench.run(test::newSphere());
    const std::string before = bench.hash();
    const std::atomic<bool> cancel = true;
    bench.context.progress.cancel = &cancel;
    QVERIFY_EXCEPTION_THROWN(bench.run(test::strokeAt(0)), base::Cancelled);
    QVERIFY_EXCEPTION_THROWN(bench.run({{"op", "resample"}, {"spacing", 0.05}}), base::Cancelled);
    QCOMPARE(bench.hash(), before);
    QVERIFY(!bench.document.canUndo());
}

void CommandTest::aStrokeThatMissesLeavesNoStep() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(test::strokeAt(40));
    QVERIFY(!bench.document.canUndo());
    QCOMPARE(bench.context.messages.size(), std::size_t(1));
    QCOMPARE(bench.context.dabs, 0);
}

void CommandTest::everyToolUndoesToTheSameHash() {
    for (const sculpt::ToolRow& tool : sculpt::toolTable()) {
        if (tool.needs.layer)
            continue;
        Workbench bench;
        test::makeWorkpiece(bench);
        const std::string before = bench.hash();
        bench.context.dabs = 0;
        bench.run(test::strokeAt(0.05, tool.id));
        QVERIFY2(bench.hash() != before && bench.context.dabs > 0, tool.id);
        QCOMPARE(bench.document.undoLabel(), std::string(tool.label));
        bench.run({{"op", "undo"}});
        QCOMPARE(bench.hash(), before);
        bench.document.surface().tree().validate();
    }
}

void CommandTest::savedModelsOpenWithTheSameHash() {
    Workbench bench;
    for (const char* sample : {"sphere", "scan"}) {
        bench.run({{"op", "new"}, {"sample", sample}, {"count", 3000}});
        const double radius = 0.1 * bench.document.surface().tree().bounds().diagonal();
        json stroke = test::strokeAt(0);
        stroke["radius"] = radius;
        bench.run(stroke);
        const std::string saved = bench.hash();
        const auto definition = bench.document.surface().definition();
        bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
        QVERIFY(!bench.document.modified());
        Workbench other;
        other.run({{"op", "open"}, {"path", bench.path("a.ply").string()}, {"hash", saved}});
        QCOMPARE(other.hash(), saved);
        QVERIFY(other.document.surface().definition().frame == definition.frame);
        other.run({{"op", "save"}, {"path", bench.path("b.ply").string()}});
        Workbench third;
        third.run({{"op", "open"}, {"path", bench.path("b.ply").string()}});
        QCOMPARE(third.hash(), saved);
    }
}

void CommandTest::exportLeavesTheDocumentUnsaved() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(test::strokeAt(0));
    bench.run({{"op", "save"}, {"path", bench.path("a.xyz").string()}});
    QVERIFY(std::filesystem::file_size(bench.path("a.xyz")) > 0);
    QVERIFY(bench.document.modified());
    // What this format cannot hold is said, and PLY holds everything.
    QVERIFY(bench.context.messages.back().find("cannot hold") != std::string::npos);
    bench.context.messages.clear();
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    QVERIFY(bench.context.messages.empty());
}

void CommandTest::everySampleCanBeMade() {
    for (const process::SampleRow& sample : process::sampleTable()) {
        Workbench one, two;
        one.run({{"op", "new"}, {"sample", sample.id}, {"count", 2000}, {"seed", 5}});
        two.run({{"op", "new"}, {"sample", sample.id}, {"count", 2000}, {"seed", 5}});
        QCOMPARE(one.hash(), two.hash());
        QVERIFY2(one.size() > 1000 && one.size() < 4000, sample.id);
        one.document.surface().tree().validate();
    }
}

void CommandTest::surfaceChangesWhatItNames() {
    Workbench bench;
    bench.run(test::newSphere());
    const std::string before = bench.hash();
    bench.run({{"op", "surface"}, {"frame", "hyperplanes"}, {"shrink-free", "off"}, {"boundary", 0.3}});
    const auto& d = bench.document.surface().definition();
    QVERIFY(d.frame == surface::Frame::Hyperplanes && !d.shrinkFree && d.oneSheet);
    QCOMPARE(d.boundaryLimit, 0.3f);
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "surface"}, {"support", 0.25}});
    QCOMPARE(bench.document.surface().tree().maxSupport(), 0.25f);
    bench.run({{"op", "surface"}, {"neighbours", 20}});
    QVERIFY(bench.document.surface().tree().maxSupport() != 0.25f);
    QCOMPARE(bench.document.surface().definition().support, 0.0f);
    QCOMPARE(bench.document.surface().definition().neighbours, 20);
    for (int k = 0; k < 3; ++k)
        bench.run({{"op", "undo"}});
    QVERIFY(bench.document.surface().definition().frame == surface::Frame::Normals);
    QVERIFY(!bench.document.modified());
}

void CommandTest::spacingsAsWideAsTheModelAreRefusedOrTold() {
    Workbench bench;
    bench.run(test::newSphere(1000));
    const std::string before = bench.hash();
    const std::string atLeast = bench.refusal({{"op", "resample"}, {"spacing", 3.0}}),
                      wider = bench.refusal({{"op", "resample"}, {"spacing", 1e4}});
    QVERIFY2(atLeast.find("at least 4 points") != std::string::npos, atLeast.c_str());
    QVERIFY2(wider.find("wider than the model") != std::string::npos, wider.c_str());
    QCOMPARE(bench.hash(), before);
    bench.context.messages.clear();
    bench.run({{"op", "resample"}, {"spacing", 0.5}});
    QVERIFY(bench.size() < 100 && !bench.context.messages.empty());
    QVERIFY(bench.context.messages[0].starts_with(std::to_string(bench.size()) + " of "));
}

void CommandTest::resampleReachesTheSpacing() {
    Workbench bench;
    bench.run(test::newSphere(2000));
    const auto median = [&] {
        return process::summarise(process::spacings(bench.document.surface().tree().surfels().items)).median;
    };
    const float before = median();
    for (const float part : {0.6f, 1.2f}) {
        bench.run({{"op", "resample"}, {"spacing", part * before}});
        const float reached = median() / (part * before);
        QVERIFY2(reached > 0.8f && reached < 1.3f, qPrintable(QString::number(reached)));
    }
}

void CommandTest::expectEndsASessionThatWentAstray() {
    Workbench bench;
    bench.run(test::newSphere());
    const auto surfels = bench.size();
    bench.run({{"op", "expect"}, {"surfels", surfels}, {"hash", bench.hash()}});
    bench.run({{"op", "expect"}, {"surfels", {surfels - 1, surfels + 1}}});
    QVERIFY(!bench.refusal({{"op", "expect"}, {"surfels", surfels + 1}}).empty());
    QVERIFY(!bench.refusal({{"op", "expect"}, {"surfels", {surfels + 1, surfels + 2}}}).empty());
    QVERIFY(bench.refusal({{"op", "expect"}, {"hash", std::string(32, '0')}}).find(bench.hash()) != std::string::npos);
}

static const test::Registered<CommandTest> registered;
#include "command_test.moc"
