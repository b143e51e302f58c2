// Every call to the system fails once, each in a run of its own (tests/faults/faults.cpp): the program then either has
// done all that was asked, or says in one sentence what is wrong and ends with exit code 1. Files that were there stay
// whole, the old or the new one, and nothing is left beside them.
#include "app/program.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>
#include <set>

using test::Outcome;

class FaultsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void threadsHaveNoVariablesWithDestructors();
    void eachCallFailsOnce_data();
    void eachCallFailsOnce();
};

namespace {

/// A folder with a model, a session that changes and saves it, and something old in the place of every output.
class Workplace {
  public:
    test::Program program;

    Workplace() {
        program.write("s.jsonl", R"({"op":"open","path":"in.ply"}
{"op":"stroke","tool":"draw","radius":0.4,"samples":[[-0.2,0,3,0,0,-1,1,0],[0.2,0,3,0,0,-1,1,0.1]]}
{"op":"save","path":"out.ply"}
{"op":"undo"}
{"op":"save","path":"in.ply"}
)");
        program.write("points.csv", "0,0,1\n0.9,0,0\n");
        program.write("rays.csv", "ox,oy,oz,dx,dy,dz\n0,0,5,0,0,-1\n");
        program.run({"convert", "sample:sphere:400", "in.ply"});
        program.run({"run", "s.jsonl", "--journal", "left.jsonl"});
    }
    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> out;
        for (const QFileInfo& each : program.dir().entryInfoList(QDir::Files | QDir::Hidden | QDir::System))
            out[each.fileName().toStdString()] = program.read(each.fileName().toStdString());
        return out;
    }
    /// As they were, with nothing beside them.
    void restore(const std::map<std::string, std::string>& wanted) const {
        for (const auto& [name, content] : files())
            if (!wanted.contains(name))
                QFile::remove(QString::fromStdString(program.path(name)));
        for (const auto& [name, content] : wanted)
            program.write(name, content);
    }
};

Outcome runWith(const test::Program& program, const QStringList& arguments, const QString& fault) {
    QProcess process;
    program.prepare(process, arguments);
    QProcessEnvironment environment = process.processEnvironment();
    environment.insert("LD_PRELOAD", qEnvironmentVariable("POINTCLAY_FAULTS"));
    environment.insert("FAULT", fault);
    environment.insert("FAULT_LOG", program.dir().filePath("state/struck"));
    process.setProcessEnvironment(environment);
    process.start();
    return test::outcomeOf(process, 60000);
}

int sentences(const std::string& err) {
    int out = 0;
    std::istringstream lines(err);
    for (std::string line; std::getline(lines, line);)
        out += line.starts_with("pointclay: ") ? 1 : 0;
    return out;
}

/// A shorter journal is one, as is none, which is told; times differ.
bool mayDiffer(const std::string& name) {
    return name.starts_with("j.jsonl") || name == "t.json";
}

} // namespace

/// glibc ends the program where memory for such a destructor cannot be had, and faults meet that once in many runs.
void FaultsTest::threadsHaveNoVariablesWithDestructors() {
    if (!qEnvironmentVariableIsSet("POINTCLAY_FAULTS"))
        QSKIP("the library that injects faults is not there under a sanitizer");
    QFile program(qEnvironmentVariable("POINTCLAY_PROGRAM"));
    QVERIFY(program.open(QIODevice::ReadOnly));
    const QByteArray bytes = program.readAll();
    QVERIFY(bytes.contains("__libc_start_main"));
    QVERIFY2(!bytes.contains("__cxa_thread_atexit"), "base/scratch.h stands for thread_local");
}

void FaultsTest::eachCallFailsOnce_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("info") << QStringList{"info", "in.ply", "--json"};
    QTest::newRow("convert") << QStringList{"convert", "in.ply", "out.ply"};
    QTest::newRow("run") << QStringList{"run", "s.jsonl", "--journal", "j.jsonl",
                                        "-o",  "end.ply", "--timings", "t.json"};
    QTest::newRow("recover") << QStringList{"recover", "left.jsonl", "-o", "out.ply"};
    QTest::newRow("mesh") << QStringList{"mesh", "in.ply", "-o", "out.stl", "--report", "r.json"};
    QTest::newRow("query") << QStringList{"query", "in.ply", "--at", "points.csv", "--what", "value", "-o", "q.csv"};
    QTest::newRow("intersect") << QStringList{"intersect", "in.ply", "--rays", "rays.csv", "-o", "h.csv"};
    QTest::newRow("render") << QStringList{"render", "in.ply", "-o", "out.png", "--size", "80x60"};
}

void FaultsTest::eachCallFailsOnce() {
    if (!qEnvironmentVariableIsSet("POINTCLAY_FAULTS"))
        QSKIP("the library that injects faults is not there under a sanitizer");
    QFETCH(QStringList, arguments);
    const Workplace place;
    const auto before = place.files();
    place.program.dir().mkpath("state");
    const Outcome whole = place.program.run(arguments);
    QCOMPARE(whole.code, 0);
    const auto after = place.files();
    const std::uint64_t seed = test::seed();
    base::Random random(seed);
    int struck = 0;
    for (const char* kind : {"open", "read", "write", "sync", "rename", "truncate", "memory"}) {
        const bool many = std::string_view(kind) == "memory"; // thousands: ever fewer of them
        for (long call = 1;; call += 1 + (many ? static_cast<long>(random.below(std::size_t(1 + call / 2))) : 0)) {
            place.restore(before);
            QFile::remove(place.program.dir().filePath("state/struck"));
            const QString fault = QString("%1:%2").arg(kind).arg(call);
            const Outcome out = runWith(place.program, arguments, fault);
            if (!QFile::exists(place.program.dir().filePath("state/struck")))
                break;
            ++struck;
            const auto where = [&](const std::string& what) {
                return fault + ", seed " + QString::number(seed) + ": " + QString::fromStdString(what + "\n" + out.err);
            };
            QVERIFY2(out.code == 0 || out.code == 1, qPrintable(where("crashed")));
            QVERIFY2(sentences(out.err) == out.code, qPrintable(where("one sentence where it fails, else none")));
            const auto found = place.files();
            for (const auto& [name, content] : after)
                QVERIFY2(out.code != 0 || mayDiffer(name) || found.contains(name), qPrintable(where("no " + name)));
            for (const auto& [name, content] : found) {
                const auto then = before.find(name);
                const auto now = after.find(name);
                QVERIFY2(then != before.end() || now != after.end(), qPrintable(where("left behind: " + name)));
                if (mayDiffer(name))
                    continue;
                const bool isOld = then != before.end() && then->second == content;
                const bool isNew = now != after.end() && now->second == content;
                QVERIFY2(out.code == 0 ? isNew : isOld || isNew, qPrintable(where("not whole: " + name)));
            }
        }
    }
    qInfo("%d faults", struck);
    QVERIFY(struck > 20);
}

static const test::Registered<FaultsTest> registered;
#include "faults_test.moc"
