#include "core/session/session_file.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/sculpt/tool.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "workbench.h"

#include <QTest>

using nlohmann::json;
using test::Workbench;

class SessionFileTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void blankLinesAndCommentsAreSkipped();
    void everyLineIsReported();
    void errorsNameFileAndLine_data();
    void errorsNameFileAndLine();
    void messagesAreSentencesWhateverTheBytes();
    void aSessionThatBreaksOffIsAnError();
    void nothingIsExecutedAfterAnError();
    void relativePathsStartAtTheSession();
    void theResultDoesNotDependOnTheThreads();
};

void SessionFileTest::blankLinesAndCommentsAreSkipped() {
    Workbench bench;
    const std::string text = "# a session\n\n  \t\r\n" + test::newSphere().dump() + "\r\n  # and a stroke\n" +
                             test::strokeAt(0).dump(); // no newline at the end
    QCOMPARE(session::replay(test::write(bench.path("s.jsonl"), text), bench.context), 2);
    Workbench plain;
    plain.run(test::newSphere());
    plain.run(test::strokeAt(0));
    QCOMPARE(bench.hash(), plain.hash());
}

void SessionFileTest::everyLineIsReported() {
    Workbench bench;
    const std::string text = test::newSphere().dump() + "\n\n" + test::strokeAt(0).dump() + "\n{\"op\":\"undo\"}\n";
    std::vector<session::LineReport> reports;
    session::replay(test::write(bench.path("s.jsonl"), text), bench.context,
                    {[&](const session::LineReport& report) { reports.push_back(report); }});
    QCOMPARE(reports.size(), std::size_t(3));
    QCOMPARE(reports[0].line, 1);
    QCOMPARE(reports[1].line, 3);
    QCOMPARE(reports[1].op, std::string("stroke"));
    QVERIFY(reports[1].dabSeconds.size() > 3 && reports[0].dabSeconds.empty() && reports[2].dabSeconds.empty());
    QVERIFY(reports[1].seconds > 0);
    QCOMPARE(reports[2].surfels, reports[0].surfels);
}

void SessionFileTest::errorsNameFileAndLine_data() {
    QTest::addColumn<QString>("line");
    QTest::newRow("op") << R"({"op":"melt"})";
    QTest::newRow("parameter") << R"({"op":"undo","much":1})";
    QTest::newRow("type") << R"({"op":"resample","spacing":true})";
    QTest::newRow("torn") << R"({"op":"undo")";
    QTest::newRow("not JSON") << "undo";
    QTest::newRow("deep") << R"({"op":"stroke","tool":)" + QString(65, '[') + QString(65, ']') + "}";
    QTest::newRow("far too deep") << QString(100000, '[');
    QTest::newRow("too large a number") << R"({"op":"resample","spacing":1e999})";
    QTest::newRow("too many digits") << R"({"op":"resample","spacing":)" + QString(400, '9') + "}";
    QTest::newRow("not UTF-8") << QString("{\"op\":\"open\",\"path\":\"\xff\"}");
    QTest::newRow("failing") << R"({"op":"expect","surfels":1})";
}

void SessionFileTest::errorsNameFileAndLine() {
    QFETCH(QString, line);
    Workbench bench;
    const std::string text = "# one\n" + test::newSphere(500).dump() + "\n" + line.toStdString() + "\n";
    test::write(bench.path("s.jsonl"), text);
    try {
        session::replay(bench.path("s.jsonl"), bench.context);
        QFAIL("the line was taken");
    } catch (const base::Error& error) {
        QVERIFY2(error.message().find("s.jsonl:3: ") != std::string::npos, error.what());
    }
}

/// Damaged lines by the thousand: none passes with a library's message.
void SessionFileTest::messagesAreSentencesWhateverTheBytes() {
    base::Random random(test::seed());
    Workbench bench;
    const std::string whole = R"({"op":"stroke","tool":"draw","radius":0.3,"samples":[[0,0,5,0,0,-1,0.5,1.5e-3]]})";
    constexpr std::string_view pieces = "{}[]\",:\\eE+-.0123456789 \tntfalse\xc3\x28";
    for (int k = 0; k < test::effort(2000); ++k) {
        std::string line = whole;
        for (std::size_t changes = 1 + random.below(6); changes > 0; --changes) {
            const std::size_t at = random.below(line.size());
            std::string piece;
            for (std::size_t n = random.below(5); n > 0; --n)
                piece += pieces[random.below(pieces.size())];
            line.replace(at, random.below(3), piece);
        }
        const std::string where = line + QString(", seed %1").arg(test::seed()).toStdString();
        try {
            session::replay(test::write(bench.path("s.jsonl"), line + "\n"), bench.context);
        } catch (const base::Error& error) {
            QVERIFY2(error.message().find("s.jsonl:") != std::string::npos, where.c_str());
            QVERIFY2(error.message().find("json.exception") == std::string::npos, where.c_str());
        }
    }
}

void SessionFileTest::aSessionThatBreaksOffIsAnError() {
    const std::string text = test::newSphere(500).dump() + "\n" + test::strokeAt(0).dump();
    for (std::size_t cut = text.find('\n') + 2; cut + 1 < text.size(); cut += 37) {
        Workbench bench;
        test::write(bench.path("s.jsonl"), text.substr(0, cut));
        try {
            session::replay(bench.path("s.jsonl"), bench.context);
            QFAIL("half a line was taken");
        } catch (const base::Error& error) {
            QVERIFY2(error.message().find("s.jsonl:2: the JSON breaks off") != std::string::npos, error.what());
        }
    }
}

void SessionFileTest::nothingIsExecutedAfterAnError() {
    Workbench bench, plain;
    plain.run(test::newSphere());
    plain.run(test::strokeAt(0));
    const std::string text = test::newSphere().dump() + "\n" + test::strokeAt(0).dump() + "\n{\"op\":\"melt\"}\n" +
                             test::strokeAt(0.2).dump() + "\n";
    QVERIFY_EXCEPTION_THROWN(session::replay(test::write(bench.path("s.jsonl"), text), bench.context), base::Error);
    QCOMPARE(bench.hash(), plain.hash());
    QVERIFY_EXCEPTION_THROWN(session::replay(bench.path("nowhere.jsonl"), bench.context), base::Error);
    QVERIFY_EXCEPTION_THROWN(session::replay(bench.dir.path().toStdString(), bench.context), base::Error);
}

void SessionFileTest::relativePathsStartAtTheSession() {
    Workbench bench;
    const std::string text = test::newSphere().dump() + "\n{\"op\":\"save\",\"path\":\"a.ply\"}\n" +
                             "{\"op\":\"open\",\"path\":\"./a.ply\"}\n";
    session::replay(test::write(bench.path("s.jsonl"), text), bench.context);
    QVERIFY(std::filesystem::exists(bench.path("a.ply")));
    QCOMPARE(bench.document.path().string(), bench.path("a.ply").string());
}

void SessionFileTest::theResultDoesNotDependOnTheThreads() {
    Workbench bench;
    std::string text = test::newSphere(test::sanitized ? 4000 : 20000).dump() + "\n";
    double y = -0.4;
    for (const sculpt::ToolRow& tool : sculpt::toolTable())
        for (int k = 0; k < 2 && !tool.needs.layer; ++k) {
            json stroke = test::strokeAt(y += 0.1, tool.id);
            stroke["symmetry"] = json::array({"x"});
            text += stroke.dump() + "\n";
        }
    text += "{\"op\":\"undo\"}\n{\"op\":\"undo\"}\n{\"op\":\"redo\"}\n{\"op\":\"resample\",\"spacing\":0.03}\n";
    test::write(bench.path("s.jsonl"), text);
    std::vector<std::string> hashes;
    for (const int threads : {1, 2, 3, 2}) {
        base::setThreadCount(threads);
        Workbench run;
        session::replay(bench.path("s.jsonl"), run.context);
        hashes.push_back(run.hash());
    }
    base::setThreadCount(0);
    QCOMPARE(hashes[1], hashes[0]);
    QCOMPARE(hashes[2], hashes[0]);
    QCOMPARE(hashes[3], hashes[0]);
}

static const test::Registered<SessionFileTest> registered;
#include "session_file_test.moc"
