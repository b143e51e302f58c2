// Too little memory (`ulimit -v`) ends in one sentence and exit code 1, whatever the command and wherever it runs out;
// with enough the same command succeeds. What stood at the target stays.
#include "app/program.h"
#include "support/registry.h"

#include <QTest>

using test::Outcome;

class MemoryTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void tooLittleMemoryEndsInASentence_data();
    void tooLittleMemoryEndsInASentence();
    void headersCannotAskForMemory();
    void theWindowNeverAborts();
};

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr bool limited = true;
#else
constexpr bool limited = false; // sanitizers take address space by the terabyte
#endif

static Outcome runWithin(const test::Program& program, long kib, const QStringList& arguments) {
    QProcess process;
    program.prepare(process, {});
    const QString words = "ulimit -v " + QString::number(kib) + "; exec \"$0\" \"$@\"";
    process.setArguments(QStringList{"-c", words, process.program()} + arguments);
    process.setProgram("/bin/bash");
    process.start();
    return test::outcomeOf(process, 120000);
}

/// Address space with which the program starts at all.
static long leastOf(const test::Program& program) {
    long kib = 16 << 10;
    while (kib < (8 << 20) && runWithin(program, kib, {"info", "--help"}).code != 0)
        kib += 4 << 10;
    return kib;
}

void MemoryTest::tooLittleMemoryEndsInASentence_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("info") << QStringList{"info", "in.xyz"};
    QTest::newRow("convert") << QStringList{"convert", "in.xyz", "out.ply"};
    QTest::newRow("mesh") << QStringList{"mesh", "sample:sphere:30000", "-o", "out.stl"};
    QTest::newRow("delaunay") << QStringList{"mesh", "sample:sphere:3000", "-o", "out.stl", "--method", "delaunay"};
    QTest::newRow("render") << QStringList{"render", "sample:sphere:60000", "-o", "out.png", "--size", "900x700"};
    QTest::newRow("raycast") << QStringList{
        "render", "sample:sphere:60000", "-o", "out.png", "--mode", "raycast", "--size", "200x150"};
    QTest::newRow("run") << QStringList{"run", "s.jsonl", "-o", "out.ply"};
    QTest::newRow("bench") << QStringList{
        "bench",    "evaluate", "project-orthogonal", "rays-camera", "rays-random", "build",   "splat-cpu",
        "--points", "30000",    "--seconds",          "0.01",        "--json",      "out.json"};
    QTest::newRow("query") << QStringList{"query",  "sample:sphere:60000", "--at", "in.xyz", "--what", "value", "-o",
                                          "out.csv"};
}

/// Without what nanoflann prints on its own before it throws.
static std::string ownWords(std::string text) {
    const std::string others = "Failed to allocate memory.\n";
    return text.starts_with(others) ? text.substr(others.size()) : text;
}

void MemoryTest::tooLittleMemoryEndsInASentence() {
    if (!limited)
        QSKIP("address space cannot be limited under a sanitizer");
    QFETCH(QStringList, arguments);
    const test::Program program;
    QVERIFY(program.run({"convert", "sample:scan:60000", "in.xyz"}).code == 0);
    program.write("s.jsonl", R"({"op":"new","sample":"sphere","count":60000}
{"op":"stroke","tool":"draw","radius":0.4,"samples":[[-0.2,0,3,0,0,-1,1,0],[0.2,0,3,0,0,-1,1,0.1]]}
{"op":"resample","spacing":0.02}
)");
    const std::string target = arguments.size() > 2 ? QString(arguments.filter("out.").value(0)).toStdString() : "";
    const long least = leastOf(program);
    int refused = 0;
    bool done = false;
    for (long more = 0; !done && more < (4 << 20); more += more < (96 << 10) ? 8 << 10 : more / 3) {
        if (!target.empty())
            program.write(target, "what was there");
        const Outcome out = runWithin(program, least + more, arguments);
        const auto where = [&] { return QString("%1 KiB: %2").arg(least + more).arg(out.err.c_str()).toUtf8(); };
        QVERIFY2(out.code == 0 || out.code == 1, where());
        done = out.code == 0;
        if (done)
            break;
        ++refused;
        const std::string words = ownWords(out.err);
        QVERIFY2(words.starts_with("pointclay: ") && std::count(words.begin(), words.end(), '\n') == 1, where());
        if (!target.empty())
            QCOMPARE(program.read(target), std::string("what was there"));
    }
    QVERIFY2(done, "never enough");
    QVERIFY2(refused > 0, "always enough");
}

/// Headers that claim what no memory holds are refused by what the file has, within little memory.
void MemoryTest::headersCannotAskForMemory() {
    if (!limited)
        QSKIP("address space cannot be limited under a sanitizer");
    const test::Program program;
    program.write("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
                           "property float y\nproperty float z\nend_header\n0123456789");
    program.write("b.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
                           "element face 4000000000\nproperty list uint int vertex_indices\nend_header\n0 0\n");
    program.write("c.off", "OFF\n4000000000 4000000000 0\n0 0 0\n");
    program.write("d.stl", std::string(80, 's') + "\xff\xff\xff\x7f" + std::string(100, '\0'));
    program.write("e.pwn", "4000000000\n0 0 0\n");
    for (const char* name : {"a.ply", "b.ply", "c.off", "d.stl", "e.pwn"}) {
        const Outcome out = runWithin(program, leastOf(program) + (64 << 10), {"info", name});
        QVERIFY2(out.code == 1 && out.err.find("memory") == std::string::npos, out.err.c_str());
    }
}

/// With too little it ends in a sentence, with more it stays open, whether its model fits or not.
void MemoryTest::theWindowNeverAborts() {
    if (!limited)
        QSKIP("address space cannot be limited under a sanitizer");
    const test::Program program;
    const QString window = qEnvironmentVariable("POINTCLAY_PROGRAM") + "-window";
    int stayed = 0, ended = 0;
    for (long kib = 96 << 10; kib < (4 << 20) && stayed < 4; kib += kib / 5) {
        QProcess process;
        program.prepareWindow(process, {"-c", "ulimit -v " + QString::number(kib) + "; exec \"$0\" \"$@\"", window,
                                        "--threads", "2", "sample:sphere:400000"});
        process.setProgram("/bin/bash");
        process.start();
        const bool open = !process.waitForFinished(3000);
        process.kill();
        process.waitForFinished();
        const QByteArray err = process.readAllStandardError();
        const auto where = [&] {
            return QString("%1 KiB: code %2, %3").arg(kib).arg(process.exitCode()).arg(err.data()).toUtf8();
        };
        const bool loads = !err.contains("error while loading shared libraries"); // before the program has begun
        stayed += open ? 1 : 0;
        if (open || !loads)
            continue;
        ++ended;
        QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 1, where());
        QVERIFY2(err.contains("pointclay: "), where());
    }
    QVERIFY2(stayed == 4, "never enough");
    QVERIFY2(ended > 0, "always enough");
}

static const test::Registered<MemoryTest> registered;
#include "memory_test.moc"
