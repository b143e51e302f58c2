// run and recover: sessions from files, their outputs, and what a kill leaves.
#include "demo_session.h"
#include "program.h"
#include "support/patience.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <csignal>
#include <fcntl.h>
#include <QTest>
#include <sys/stat.h>
#include <unistd.h>

using nlohmann::json;
using test::Outcome;
using test::Program;

class RunTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void outputsAreWritten();
    void whatWasDoneIsTold();
    void threadsDoNotShow();
    void savedAndOpenedAreTheSame();
    void theJournalGoesWithANormalEnd();
    void aKilledSessionIsRecovered();
    void recoverLeavesOutWhatItCannotRead();
    void changedFilesAreTakenWhenAsked();
    void picturesAreThoseOfRender();
    void aModelIsNoJournal();
    void lineWithoutEndIsNoSession();
    void whoWaitsForAPipeCanBeEnded_data();
    void whoWaitsForAPipeCanBeEnded();
    void theDemoIsWhatItsGeneratorWrites();
    void theDemoSessionRuns();
};

static json strokeAt(double y, const char* tool) {
    json samples = json::array();
    for (int k = 0; k < 12; ++k)
        samples.push_back({0.07 * k - 0.4, y, 5, 0, 0, -1, 0.5 + 0.04 * k, 0.02 * k});
    return {{"op", "stroke"}, {"tool", tool}, {"radius", 0.25}, {"symmetry", {"x"}}, {"samples", samples}};
}

static std::string session(int strokes, int count) {
    std::string out = "{\"op\":\"new\",\"sample\":\"sphere\",\"count\":" + std::to_string(count) + "}\n";
    const char* tools[] = {"draw", "clay", "smooth", "grab"};
    for (int k = 0; k < strokes; ++k)
        out += strokeAt(0.01 * (k % 60) - 0.3, tools[k % 4]).dump() + "\n";
    return out;
}

void RunTest::outputsAreWritten() {
    const Program program;
    program.write("s.jsonl", session(4, 4000) + "{\"op\":\"undo\"}\n");
    const Outcome outcome = program.run(
        {"run", "s.jsonl", "-o", "out.ply", "--render", "out.png", "--timings", "out.json", "--threads", "2"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY(program.read("out.ply").starts_with("ply\n"));
    QVERIFY(program.read("out.png").starts_with("\x89PNG"));
    const json timings = json::parse(program.read("out.json"));
    QCOMPARE(timings.size(), std::size_t(6));
    for (std::size_t k = 0; k < timings.size(); ++k) {
        QCOMPARE(timings[k].size(), std::size_t(6));
        QCOMPARE(timings[k].at("line").get<std::size_t>(), k + 1);
        QVERIFY(timings[k].at("seconds").get<double>() >= 0 && timings[k].at("surfels").get<int>() > 3000);
        const json ms = timings[k].at("dab_ms");
        const double p50 = ms.at("p50"), p99 = ms.at("p99"), max = ms.at("max");
        QVERIFY(p50 <= p99 && p99 <= max);
        QCOMPARE(timings[k].at("op").get<std::string>(), std::string(k == 0 ? "new" : k == 5 ? "undo" : "stroke"));
        QCOMPARE(timings[k].at("dabs").get<int>() > 0, k > 0 && k < 5);
        QCOMPARE(max > 0, k > 0 && k < 5);
    }
}

/// Strokes that went well say nothing of their own, and a silent end is no answer.
void RunTest::whatWasDoneIsTold() {
    const Program program;
    program.write("s.jsonl", session(2, 4000) + "{\"op\":\"undo\"}\n{\"op\":\"undo\"}\n{\"op\":\"undo\"}\n");
    const std::string told = program.run({"run", "s.jsonl"}).err;
    QVERIFY2(told.find("line 6: ") != std::string::npos, told.c_str()); // there was nothing left to undo
    QVERIFY2(told.find("6 commands, 2 strokes among them: 0 surfels before, ") != std::string::npos, told.c_str());
    QVERIFY(program.run({"--quiet", "run", "s.jsonl"}).err.empty());
}

void RunTest::threadsDoNotShow() {
    const Program program;
    program.write("s.jsonl", session(8, 6000) + "{\"op\":\"undo\"}\n{\"op\":\"undo\"}\n{\"op\":\"redo\"}\n");
    QCOMPARE(program.run({"run", "s.jsonl", "-o", "one.ply", "--threads", "1"}).code, 0);
    QCOMPARE(program.run({"run", "s.jsonl", "-o", "two.ply", "--threads", "2"}).code, 0);
    QVERIFY(program.read("one.ply") == program.read("two.ply"));
    QCOMPARE(program.hash("one.ply"), program.hash("two.ply"));
}

void RunTest::savedAndOpenedAreTheSame() {
    const Program program;
    program.write("s.jsonl", session(3, 4000) + "{\"op\":\"save\",\"path\":\"a.ply\"}\n");
    QCOMPARE(program.run({"run", "s.jsonl", "-o", "b.ply"}).code, 0);
    const std::string hash = program.hash("a.ply");
    QCOMPARE(hash.size(), std::size_t(32));
    QCOMPARE(program.hash("b.ply"), hash);
    program.write("t.jsonl", "{\"op\":\"expect\",\"hash\":\"" + hash + "\"}\n");
    QCOMPARE(program.run({"run", "t.jsonl", "--model", "a.ply"}).code, 0);
    program.write("t.jsonl", "{\"op\":\"expect\",\"hash\":\"" + std::string(32, '1') + "\"}\n");
    const Outcome outcome = program.run({"run", "t.jsonl", "--model", "a.ply"});
    QCOMPARE(outcome.code, 1);
    QVERIFY2(outcome.err.find("t.jsonl:1: ") != std::string::npos, outcome.err.c_str());
}

void RunTest::theJournalGoesWithANormalEnd() {
    const Program program;
    program.write("s.jsonl", session(2, 2000));
    QCOMPARE(program.run({"run", "s.jsonl"}).code, 0);
    QVERIFY(QDir(program.path("state/pointclay").c_str()).exists());
    QVERIFY(QDir(program.path("state/pointclay").c_str()).isEmpty());
    QCOMPARE(program.run({"run", "s.jsonl", "--journal", "j.jsonl", "-o", "a.ply"}).code, 0);
    QCOMPARE(program.run({"recover", "j.jsonl", "-o", "b.ply"}).code, 0);
    QCOMPARE(program.hash("b.ply"), program.hash("a.ply"));
}

void RunTest::recoverLeavesOutWhatItCannotRead() {
    const Program program;
    program.write("whole.jsonl", session(2, 2000));
    std::string damaged = session(2, 2000);
    damaged.insert(damaged.find('\n') + 1, "{\"op\":\"melt\"}\n");
    program.write("damaged.jsonl", damaged);
    const Outcome outcome = program.run({"recover", "damaged.jsonl", "-o", "a.ply"});
    QCOMPARE(outcome.code, 0);
    QVERIFY2(outcome.err.find("damaged.jsonl:2: ") != std::string::npos, outcome.err.c_str());
    QCOMPARE(program.run({"run", "whole.jsonl", "-o", "b.ply"}).code, 0);
    QCOMPARE(program.hash("a.ply"), program.hash("b.ply"));
}

void RunTest::changedFilesAreTakenWhenAsked() {
    const Program program;
    QCOMPARE(program.run({"convert", "sample:sphere:3000", "a.ply"}).code, 0);
    program.write("s.jsonl", "{\"op\":\"open\",\"path\":\"a.ply\"}\n" + strokeAt(0, "draw").dump() + "\n");
    QCOMPARE(program.run({"run", "s.jsonl", "--journal", "j.jsonl"}).code, 0);
    QCOMPARE(program.run({"convert", "sample:sphere:2000", "a.ply"}).code, 0);
    QCOMPARE(program.run({"run", "s.jsonl", "-o", "wanted.ply"}).code, 0);
    for (const QStringList& words :
         {QStringList{"recover", "j.jsonl", "-o", "b.ply"}, QStringList{"run", "j.jsonl", "-o", "b.ply"}}) {
        const Outcome refused = program.run(words);
        QCOMPARE(refused.code, 1);
        QVERIFY2(refused.err.find("--anyway") != std::string::npos, refused.err.c_str());
        QVERIFY(program.read("b.ply").empty());
        const Outcome taken = program.run(words + QStringList{"--anyway"});
        QVERIFY2(taken.code == 0 && taken.err.find("it is taken as it is now") != std::string::npos, taken.err.c_str());
        QCOMPARE(program.hash("b.ply"), program.hash("wanted.ply"));
        QFile::remove(program.path("b.ply").c_str());
    }
}

/// The same view, and colours where there are some.
void RunTest::picturesAreThoseOfRender() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    const Program program;
    std::string points = "x,y,z,red,green,blue\n";
    for (int i = 0; i < 3000; ++i) {
        const double z = 1 - (2 * i + 1) / 3000.0, r = std::sqrt(1 - z * z), t = 2.399963 * i;
        points += std::to_string(r * std::cos(t)) + "," + std::to_string(r * std::sin(t)) + "," + std::to_string(z) +
                  (z > 0 ? ",250,40,0\n" : ",0,90,250\n");
    }
    program.write("ball.csv", points);
    for (const char* model : {"ball.csv", "sample:knot:3000"}) {
        program.write("s.jsonl", "");
        QCOMPARE(program.run({"run", "s.jsonl", "--model", model, "--render", "a.png"}).code, 0);
        QCOMPARE(program.run({"render", model, "-o", "b.png"}).code, 0);
        QVERIFY2(program.read("a.png") == program.read("b.png") && program.read("a.png").size() > 5000, model);
    }
    program.run({"render", "ball.csv", "-o", "c.png", "--shading", "matcap"});
    QCOMPARE(program.run({"run", "s.jsonl", "--model", "ball.csv", "--render", "a.png"}).code, 0);
    QVERIFY(program.read("a.png") != program.read("c.png"));
}

void RunTest::aModelIsNoJournal() {
    const Program program;
    program.write("s.jsonl", session(1, 500));
    QCOMPARE(program.run({"convert", "sample:sphere:500", "model.ply"}).code, 0);
    const std::string before = program.read("model.ply");
    const Outcome outcome = program.run({"run", "s.jsonl", "--journal", "model.ply"});
    QCOMPARE(outcome.code, 1);
    QVERIFY2(outcome.err.find("model.ply: is not a journal") != std::string::npos, outcome.err.c_str());
    QCOMPARE(program.read("model.ply"), before);
}

void RunTest::lineWithoutEndIsNoSession() {
    const Outcome outcome = Program().run({"run", "/dev/zero"});
    QCOMPARE(outcome.code, 1);
    QVERIFY2(outcome.err.find("/dev/zero: has a line of more than") != std::string::npos, outcome.err.c_str());
}

void RunTest::whoWaitsForAPipeCanBeEnded_data() {
    QTest::addColumn<QString>("command");
    QTest::addColumn<bool>("written");
    for (const char* command : {"run", "info"})
        for (const bool written : {false, true})
            QTest::addRow("%s, %s", command, written ? "somebody writes" : "nobody writes")
                << QString(command) << written;
}

/// Has it come to where it hears signals, and does it sleep? To be asked again and again: who starts sleeps at times.
static bool waits(const QProcess& process) {
    std::ifstream in("/proc/" + std::to_string(process.processId()) + "/status");
    bool hears = false, sleeps = false;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("SigCgt:"))
            hears = std::stoull(line.substr(7), nullptr, 16) >> (SIGTERM - 1) & 1;
        sleeps = sleeps || line.starts_with("State:\tS");
    }
    return hears && sleeps;
}

void RunTest::whoWaitsForAPipeCanBeEnded() {
    QFETCH(QString, command);
    QFETCH(bool, written);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        const Program program;
        QCOMPARE(::mkfifo(program.path("pipe").c_str(), 0600), 0);
        QProcess process;
        program.prepare(process, {command, "pipe"});
        process.start();
        QVERIFY(process.waitForStarted());
        const int writer = written ? ::open(program.path("pipe").c_str(), O_WRONLY) : -1; // waits for the reader
        QVERIFY(QTest::qWaitFor([at = 0, &process]() mutable { return (at = waits(process) ? at + 1 : 0) > 20; },
                                test::patience));
        ::kill(static_cast<pid_t>(process.processId()), signal);
        const Outcome outcome = test::outcomeOf(process, 60000);
        if (writer >= 0)
            ::close(writer);
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.err.find("cancelled") != std::string::npos, outcome.err.c_str());
    }
}

static int linesOf(const std::string& text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

void RunTest::aKilledSessionIsRecovered() {
    const Program program;
    QCOMPARE(program.run({"convert", "sample:torus:20000", "model.ply"}).code, 0);
    std::string text = session(400, 100);
    text.replace(0, text.find('\n'), "{\"op\":\"open\",\"path\":\"model.ply\"}");
    program.write("s.jsonl", text);
    QProcess process;
    program.prepare(process, {"run", "s.jsonl", "--journal", "j.jsonl"});
    process.start();
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(linesOf(program.read("j.jsonl")) > 5 || process.state() == QProcess::NotRunning, 60000);
    ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);
    const int done = linesOf(program.read("j.jsonl"));
    QVERIFY(done > 5 && done < 401);
    const Outcome outcome = program.run({"recover", "j.jsonl", "-o", "rescued.ply"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    // The same commands without a kill.
    std::size_t end = 0;
    for (int k = 0; k < done; ++k)
        end = text.find('\n', end) + 1;
    program.write("same.jsonl", text.substr(0, end));
    QCOMPARE(program.run({"run", "same.jsonl", "-o", "same.ply"}).code, 0);
    QCOMPARE(program.hash("rescued.ply"), program.hash("same.ply"));
}

void RunTest::theDemoIsWhatItsGeneratorWrites() {
    if (const QString file = qEnvironmentVariable("POINTCLAY_WRITE_DEMO"); !file.isEmpty())
        std::ofstream(file.toStdString(), std::ios::binary) << test::demoSession();
    std::ifstream in(POINTCLAY_DEMO, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    QVERIFY(text.str() == test::demoSession());
}

void RunTest::theDemoSessionRuns() {
    if (test::sanitized)
        QSKIP("a minute under a sanitizer");
    const Program program;
    const QString demo = QString(POINTCLAY_DEMO);
    const Outcome outcome = program.run({"run", demo, "--render", "demo.png", "--timings", "demo.json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY(program.read("demo.png").size() > 20000);
    int dabs = 0;
    for (const json& line : json::parse(program.read("demo.json")))
        dabs += line.at("dabs").get<int>();
    QVERIFY(dabs > 100);
    QVERIFY(outcome.err.find("strokes among them") < outcome.err.find('\n'));
}

static const test::Registered<RunTest> registered;
#include "run_test.moc"
