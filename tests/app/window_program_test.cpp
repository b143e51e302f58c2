// The window is a program of its own: `pointclay` becomes it without a subcommand, and knows no Qt itself.
#include "program.h"
#include "support/registry.h"

#include <csignal>
#include <QTest>

using test::Outcome;
using test::Program;

class WindowProgramTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void subcommandsNeedNoQt();
    void theWindowGetsTheSameArgumentsAndProcess();
    void aMissingWindowIsToldInOneSentence();
    void withoutADisplayItSaysSo();
    void theWindowOpensAndLeavesOnTheSameSignals();
    void theWindowsProgramRefusesTheSameWords();
};

static QString thisProgram() {
    return qEnvironmentVariable("POINTCLAY_PROGRAM");
}

/// A copy of the program, alone in a folder.
static QString lonelyCopy(const Program& program) {
    const QString copy = program.dir().filePath("pointclay");
    QFile::copy(thisProgram(), copy);
    return copy;
}

static Outcome run(const QString& file, const QStringList& arguments, const QProcessEnvironment& environment) {
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(file, arguments);
    return test::outcomeOf(process, 60000);
}

static Outcome run(const QString& file, const QStringList& arguments) {
    return run(file, arguments, QProcessEnvironment::systemEnvironment());
}

void WindowProgramTest::subcommandsNeedNoQt() {
    const Outcome needs = run("ldd", {thisProgram()});
    QCOMPARE(needs.code, 0);
    QVERIFY(needs.out.find("libstdc++") != std::string::npos);
    QVERIFY2(needs.out.find("Qt") == std::string::npos, needs.out.c_str());
}

void WindowProgramTest::theWindowGetsTheSameArgumentsAndProcess() {
    const Program program;
    const QString copy = lonelyCopy(program);
    program.write("pointclay-window", "#!/bin/sh\necho $$\nfor a in \"$@\"; do echo \"<$a>\"; done\nexit 7\n");
    QFile::setPermissions(copy + "-window", QFile::permissions(copy));
    QProcess process;
    process.start(copy, {"--threads", "2", "a b.ply", "unknown", "--quiet", "--", "-c.ply"});
    QVERIFY(process.waitForStarted());
    const std::string id = std::to_string(process.processId());
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), 7);
    QCOMPARE(process.readAllStandardOutput().toStdString(),
             id + "\n<--threads>\n<2>\n<a b.ply>\n<unknown>\n<--quiet>\n<-->\n<-c.ply>\n");
}

void WindowProgramTest::aMissingWindowIsToldInOneSentence() {
    const Program program;
    const QString copy = lonelyCopy(program);
    const Outcome outcome = run(copy, {"scan.ply"});
    QCOMPARE(outcome.code, 1);
    QVERIFY2(outcome.err.find(copy.toStdString() + "-window") != std::string::npos, outcome.err.c_str());
    QCOMPARE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
    QCOMPARE(run(copy, {"--version"}).code, 0);
    QCOMPARE(run(copy, {"info", "sample:sphere:500"}).code, 0);
}

static QProcessEnvironment without(const QStringList& names) {
    QProcessEnvironment out = QProcessEnvironment::systemEnvironment();
    for (const QString& name : names)
        out.remove(name);
    return out;
}

void WindowProgramTest::withoutADisplayItSaysSo() {
    const auto environment = without({"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"});
    for (const char* end : {"", "-window"}) {
        const Outcome outcome = run(thisProgram() + end, {}, environment);
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.err.find("pointclay: there is no display") != std::string::npos, outcome.err.c_str());
    }
}

void WindowProgramTest::theWindowOpensAndLeavesOnTheSameSignals() {
    const Program program;
    QProcess process;
    program.prepareWindow(process, {"sample:sphere:500"});
    process.start();
    QVERIFY(process.waitForStarted());
    QVERIFY(!process.waitForFinished(1500)); // it stays open
    ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitStatus(), QProcess::CrashExit); // by the signal, which the window does not catch
    QCOMPARE(process.exitCode(), SIGTERM);
}

void WindowProgramTest::theWindowsProgramRefusesTheSameWords() {
    for (const QStringList& words : {QStringList{"--jason"}, QStringList{"--threads", "many"}}) {
        const Outcome a = run(thisProgram(), words), b = run(thisProgram() + "-window", words);
        QCOMPARE(a.code, 2);
        QCOMPARE(b.code, 2);
        QCOMPARE(a.err, b.err);
    }
    QCOMPARE(run(thisProgram(), {"--version"}).out, run(thisProgram() + "-window", {"--version"}).out);
}

static const test::Registered<WindowProgramTest> registered;
#include "window_program_test.moc"
