// A plan in the hands of the engine that it was made for: Snakemake with two workers, of which one is killed in its
// work. Debian's package brings 700 MB of other engines' parts, so that it is no part of every run: `tests/run
// snakemake` installs it.
#include "program.h"
#include "support/registry.h"

#include <QFile>
#include <QStandardPaths>
#include <QTest>

using test::Outcome;
using test::Program;

class SnakemakeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aKilledWorkerLosesOneJobUntilTheNextRun();
};

namespace {

/// What stands in the place of the program: the first time that it meshes `b.ply` it is killed on the way.
void makeKilledProgram(const Program& program) {
    program.write("bin/pointclay", "#!/bin/sh\nif [ \"$1 $2\" = 'mesh b.ply' ] && mkdir killed 2>/dev/null; then\n"
                                   "    \"$POINTCLAY_PROGRAM\" \"$@\" &\n    sleep 0.05\n    kill -9 $! $$\nfi\n"
                                   "exec \"$POINTCLAY_PROGRAM\" \"$@\"\n");
    QVERIFY(QFile::setPermissions(program.dir().filePath("bin/pointclay"),
                                  QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
}

Outcome snakemake(const Program& program) {
    QProcess process;
    program.prepare(process, {"--cores", "2", "--keep-going", "--rerun-incomplete"});
    QProcessEnvironment environment = process.processEnvironment();
    environment.insert("PATH", program.dir().filePath("bin") + ":" + environment.value("PATH"));
    process.setProcessEnvironment(environment);
    process.setProgram("snakemake");
    process.start();
    return test::outcomeOf(process, 240000);
}

} // namespace

void SnakemakeTest::aKilledWorkerLosesOneJobUntilTheNextRun() {
    if (QStandardPaths::findExecutable("snakemake").isEmpty())
        QSKIP("runs by hand where Snakemake is: tests/run snakemake");
    const Program program;
    program.dir().mkpath("bin");
    makeKilledProgram(program);
    for (const char* name : {"a.ply", "b.ply", "c d.ply"})
        QCOMPARE(program.run({"convert", name[0] == 'b' ? "sample:sphere:40000" : "sample:torus:3000", name}).code, 0);
    const QStringList batch{"mesh", "a.ply", "b.ply", "c d.ply", "--as", "stl", "--into"};
    QCOMPARE(program.run(batch + QStringList{"alone"}).code, 0);
    QCOMPARE(program.run(batch + QStringList{"out", "--plan", "Snakefile"}).code, 0);

    const Outcome killed = snakemake(program);
    QVERIFY2(killed.code != 0 && QFile::exists(program.dir().filePath("killed")), killed.err.c_str());
    QVERIFY(!QFile::exists(program.dir().filePath("out/b.stl"))); // nothing half written in its place
    for (const char* name : {"a.stl", "c d.stl"})
        QVERIFY2(QFile::exists(program.dir().filePath(QString("out/") + name)), killed.err.c_str());

    const Outcome again = snakemake(program);
    QVERIFY2(again.code == 0, again.err.c_str());
    QVERIFY2(again.err.find("rule mesh_0002") != std::string::npos &&
                 again.err.find("rule mesh_0001") == std::string::npos,
             again.err.c_str()); // that one alone
    for (const char* name : {"a.stl", "b.stl", "c d.stl"})
        QVERIFY(program.read(std::string("out/") + name) == program.read(std::string("alone/") + name));

    const Outcome done = snakemake(program);
    QVERIFY2(done.code == 0 && done.err.find("Nothing to be done") != std::string::npos, done.err.c_str());
}

static const test::Registered<SnakemakeTest> registered;
#include "snakemake_test.moc"
