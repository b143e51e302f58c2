// What all subcommands share: help, exit codes, messages, and that no failure leaves a file behind.
#include "core/sculpt/tool.h"
#include "core/session/command.h"
#include "program.h"
#include "support/registry.h"

#include <algorithm>
#include <csignal>
#include <QTest>
#include <sstream>

using test::Outcome;
using test::Program;

class CommandLineTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void helpNamesEverySubcommandWithAnExample();
    void helpOfRunNamesEveryCommandAndTool();
    void theSessionInHelpRuns();
    void helpNamesWhatHoldsWithoutAnOption();
    void wrongUsageIsTwo_data();
    void wrongUsageIsTwo();
    void emptyValuesAreRefused();
    void outputsOfOneNameAreRefused_data();
    void outputsOfOneNameAreRefused();
    void devicesTakeSeveralOutputs();
    void aDashIsStandardInput();
    void mistypedWordsAreAnsweredWithTheNearest();
    void badInputIsOneAndLeavesNothing_data();
    void badInputIsOneAndLeavesNothing();
    void interruptStopsCleanly();
    void quietSaysNothing();
};

/// The first words of the indented lines below "Subcommands:".
static std::vector<std::string> subcommandsIn(const std::string& help) {
    std::vector<std::string> out;
    std::istringstream lines(help.substr(std::min(help.find("\nSubcommands:\n"), help.size())));
    for (std::string line; std::getline(lines, line);)
        if (line.size() > 2 && line.starts_with("  ") && line[2] != ' ')
            out.push_back(line.substr(2, line.find(' ', 2) - 2));
    return out;
}

void CommandLineTest::helpNamesEverySubcommandWithAnExample() {
    const Program program;
    const Outcome help = program.run({"--help"});
    QCOMPARE(help.code, 0);
    const std::vector<std::string> all = subcommandsIn(help.out);
    // These names are a contract with scripts (app/README 2); the program may have more.
    for (const char* name : {"info", "convert", "query", "intersect", "boundary", "section", "mesh", "haptic", "reduce",
                             "render", "run", "recover", "bench"})
        QVERIFY2(std::find(all.begin(), all.end(), name) != all.end(), name);
    for (const std::string& name : all) {
        const Outcome own = program.run({QString::fromStdString(name), "--help"});
        QCOMPARE(own.code, 0);
        for (const std::string& part : {"Example: pointclay " + name, std::string("--threads"), std::string("--quiet")})
            QVERIFY2(own.out.find(part) != std::string::npos, name.c_str());
    }
    const Outcome version = program.run({"--version"});
    QCOMPARE(version.code, 0);
    QVERIFY(version.out.starts_with("pointclay "));
}

void CommandLineTest::helpOfRunNamesEveryCommandAndTool() {
    const std::string help = Program().run({"run", "--help"}).out;
    for (const session::CommandRow& row : session::commandTable()) {
        const std::size_t at = help.find(std::string("\n  ") + row.op + ": " + row.tip);
        QVERIFY2(at != std::string::npos, row.op);
        // What others share is listed.
        std::size_t end = help.find("\n  ", at + 1);
        while (end != std::string::npos && help[end + 3] == ' ')
            end = help.find("\n  ", end + 1);
        const std::string own = help.substr(at, end - at) + '\n';
        const std::string shared = own.substr(std::min(own.find("\n    as for "), own.size()));
        for (const session::CommandParameter& p : row.parameters) {
            const std::string word = std::string(" ") + p.id;
            QVERIFY2(own.find(std::string("\n    ") + p.id + " (") != std::string::npos ||
                         shared.find(word + ' ') != std::string::npos || shared.find(word + '\n') != std::string::npos,
                     (row.op + word).c_str());
        }
    }
    for (const sculpt::ToolRow& tool : sculpt::toolTable())
        QVERIFY2(help.find(std::string("\n  ") + tool.id + ": " + tool.tip) != std::string::npos, tool.id);
}

void CommandLineTest::theSessionInHelpRuns() {
    const Program program;
    std::istringstream lines(program.run({"run", "--help"}).out);
    std::string session;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  {"))
            session += line + '\n';
    program.write("s.jsonl", session);
    const Outcome outcome = program.run({"run", "s.jsonl"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY(program.hash("ridge.ply") != program.hash("sample:sphere:50000"));
}

/// Of subcommands that are commands of sessions: the table's defaults.
void CommandLineTest::helpNamesWhatHoldsWithoutAnOption() {
    for (const char* op : {"fill", "reduce", "crease", "cut", "solid", "trim", "tube"}) {
        const std::string help = Program().run({op, "--help"}).out;
        int named = 0;
        for (const session::CommandParameter& p : session::command(op).parameters) {
            const std::string text = *p.fallback ? p.fallback : "null";
            const std::size_t at = help.find("\n  --" + std::string(p.id) + ' ');
            if (text == "null" || std::string_view(p.type) == "boolean" || at == std::string::npos)
                continue;
            std::string wanted = text;
            std::erase(wanted, '"');
            // the text of an option ends where the next one's begins
            const std::size_t end = help.find('[' + wanted + "]\n", at);
            QVERIFY2(end != std::string::npos && end < help.find("\n  -", at + 3),
                     (op + (" --" + std::string(p.id))).c_str());
            ++named;
        }
        QVERIFY2(named > 0, op);
    }
}

void CommandLineTest::wrongUsageIsTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char* arguments) {
        QTest::newRow(arguments) << QString(arguments).split(' ', Qt::SkipEmptyParts);
    };
    row("info");
    row("info sample:sphere:500 --jason");
    row("info sample:sphere:500 --threads many");
    row("convert sample:sphere:500");
    row("query sample:sphere:500 --at p.xyz -o out.csv");
    row("query sample:sphere:500 --at p.xyz --what colour -o out.csv");
    row("query sample:sphere:500 --at p.xyz --what project-basic,project-almost -o out.csv");
    row("query sample:sphere:500 --at p.xyz --what value -o out.csv --frame square");
    row("query sample:sphere:500 --at p.xyz --what value -o out.csv --support 0");
    row("query sample:sphere:500 --at p.xyz --what value -o out.csv --support 1 --neighbours 20");
    row("query sample:sphere:500 --at p.xyz --what value -o out.csv --boundary sometimes");
    row("query sample:sphere:500 --at p.xyz --what value -o out.csv --precision half");
    row("intersect sample:sphere:500 -o out.csv");
    row("render sample:sphere:500 -o out.png --size huge");
    row("render sample:sphere:500 -o out.png --size 0x5");
    row("render sample:sphere:500 -o out.png --eye 1,2");
    row("render sample:sphere:500 -o out.png --eye 1,2,3 --target 1,2,3");
    row("render sample:sphere:500 -o out.png --mode sketch");
    row("render sample:sphere:500 -o out.png --fov nan");
    row("render sample:sphere:500 -o out.png --quality nan");
    row("render sample:sphere:500 -o out.jpg");
    row("run good.jsonl --render out.jpg");
    row("mesh sample:sphere:500 -o out.ply --cell nan");
    row("mesh sample:sphere:500 -o out.ply --cell 0");
    row("mesh sample:sphere:500 -o out.ply --method delaunay --angle inf");
    row("section sample:sphere:500 --plane 0,0,1,0 --least -1");
    row("render sample:sphere:500 -o out.png --shading plaid");
    row("run");
    row("run p.xyz --journal p.xyz");
    row("run p.xyz --journal j.ply -o ./j.ply");
    row("run p.xyz --journal j.png --render j.png");
    row("run p.xyz --journal j.json --timings j.json");
    row("recover j.jsonl");
    row("clean a b");
    row("inof p.xyz");
    // Of two faults, one in a file, the name is told: it is known before the work.
    row("convert sample:sphere:500 out.melted");
    row("convert bad.ply out.melted");
    row("clean bad.ply out.melted --duplicates");
    row("resample bad.ply -o out.melted --count 100");
    row("cut bad.ply --plane 0,0,1,0 -o out.melted");
    row("measure bad.ply --thickness -o out.melted");
    row("run bad.jsonl -o out.melted");
    row("recover empty.xyz -o out.melted");
    row("reduce bad.ply --count 100 -o out.melted");
    row("crease bad.ply --detect -o out.melted");
    row("cut bad.ply --plane 0,0,0,1 -o out.ply");
    row("cut bad.ply --plane 0,0,1 -o out.ply");
    row("solid bad.ply bad.ply --op union --position 1,2 -o out.ply");
    row("solid bad.ply bad.ply --op union --fillet 1 --chamfer 1 -o out.ply");
    row("crease bad.ply --along p.xyz --angle 30 -o out.ply");
    row("clean bad.ply out.ply --duplicates --limit 3");
    row("query bad.ply --at p.xyz --what value -o ./p.xyz");
    row("intersect bad.ply --rays p.xyz -o p.xyz");
    row("haptic bad.ply --trajectory p.xyz -o p.xyz");
    row("measure p.xyz --thickness --csv p.xyz");
}

void CommandLineTest::wrongUsageIsTwo() {
    QFETCH(QStringList, arguments);
    const Program program;
    program.write("p.xyz", "0 0 1\n");
    const Outcome outcome = program.run(arguments);
    QVERIFY2(outcome.code == 2, outcome.err.c_str());
    QVERIFY(!outcome.err.empty());
    QCOMPARE(program.dir().entryList(QDir::Files), QStringList{"p.xyz"});
}

/// As by a script whose variable is not set: nothing would be written, and nobody told.
void CommandLineTest::emptyValuesAreRefused() {
    const Program program;
    program.write("s.jsonl", "{\"op\":\"new\",\"sample\":\"sphere\",\"count\":500}\n");
    const std::pair<QStringList, const char*> rows[] = {
        {{"run", "s.jsonl", "-o", ""}, "--output is empty"},
        {{"run", "s.jsonl", "--timings", ""}, "--timings is empty"},
        {{"boundary", "sample:sphere:500", "-o", ""}, "--output is empty"},
        {{"cut", "sample:sphere:500", "--plane", "0,0,1,0", "-o", ""}, "--output is empty"},
        {{"register", "", "--to", "sample:sphere:500", "-o", "o.ply"}, "MOVING is empty"},
        {{"info", ""}, "MODEL is empty"},
    };
    for (const auto& [words, wanted] : rows) {
        const Outcome outcome = program.run(words);
        QVERIFY2(outcome.code == 2 && outcome.err.find(wanted) != std::string::npos,
                 (wanted + (": " + outcome.err)).c_str());
    }
    QCOMPARE(program.dir().entryList(QDir::Files), QStringList{"s.jsonl"});
}

void CommandLineTest::outputsOfOneNameAreRefused_data() {
    QTest::addColumn<QString>("arguments");
    const auto row = [](const char* arguments) { QTest::newRow(arguments) << QString(arguments); };
    row("mesh sample:sphere:500 -o o.obj --report ./o.obj");
    row("render sample:sphere:500 --size 8x8 -o o.png --depth o.png");
    row("render sample:sphere:500 --size 8x8 -o o.png --depth d.pfm --stats d.pfm");
    row("clean sample:sphere:500 o.ply --duplicates --report o.ply");
    row("crease sample:sphere:500 --detect -o o.ply --report o.ply");
    row("solid sample:sphere:500 sample:sphere:500 --op union --position 1,0,0 -o o.ply --report o.ply");
    row("reduce sample:sphere:500 --count 100 -o o.ply --report ../HERE/o.ply");
    row("refine sample:sphere:500 --spacing 0.1 -o o.ply --report o.ply");
    row("register sample:sphere:500 --to sample:sphere:500 -o o.ply --report o.ply");
    row("measure sample:sphere:500 --thickness -o o.ply --csv o.ply");
    row("run s.jsonl -o o.ply --timings o.ply");
    row("query sample:sphere:500 --at s.jsonl --what value -o -");
}

/// The second would replace the first.
void CommandLineTest::outputsOfOneNameAreRefused() {
    QFETCH(QString, arguments);
    const Program program;
    program.write("s.jsonl", "{\"op\":\"new\",\"sample\":\"sphere\",\"count\":500}\n");
    arguments.replace("HERE", program.dir().dirName());
    const Outcome outcome = program.run(arguments.split(' '));
    QVERIFY2(outcome.code == 2 && !outcome.err.empty(), outcome.err.c_str());
    QCOMPARE(program.dir().entryList(QDir::Files), QStringList{"s.jsonl"});
}

void CommandLineTest::devicesTakeSeveralOutputs() {
    const Program program;
    const Outcome outcome = program.run({"render", "sample:sphere:500", "--size", "8x8", "-o", "o.png", "--depth",
                                         "/dev/null", "--stats", "/dev/null"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
}

void CommandLineTest::aDashIsStandardInput() {
    const Program program;
    program.run({"convert", "sample:sphere:500", "a.ply"});
    QProcess process;
    program.prepare(process, {"info", "-", "--json"});
    process.setStandardInputFile(program.path("a.ply").c_str());
    process.start();
    const Outcome outcome = test::outcomeOf(process, 60000);
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QCOMPARE(test::json::parse(outcome.out).at("hash").get<std::string>(), program.hash("a.ply"));
}

void CommandLineTest::mistypedWordsAreAnsweredWithTheNearest() {
    const Program program;
    program.write("p.xyz", "0 0 1\n");
    program.write("s.jsonl", "{\"op\":\"new\",\"sample\":\"shpere\"}\n");
    program.write("t.jsonl", "{\"op\":\"nwe\",\"sample\":\"sphere\"}\n");
    const std::pair<const char*, const char*> rows[] = {
        {"inof p.xyz", "did you mean 'info'? pointclay --help"},
        {"info sample:sphere:500 --jsn", "Did you mean --json?"},
        {"render sample:sphere:500 --ouput a.png", "Did you mean --output?"},
        {"render sample:sphere:500 --sizes=8x8 -o a.png", "Did you mean --size?"},
        {"query sample:sphere:500 --at p.xyz --what vlaue -o o.csv", "did you mean 'value'? known are"},
        {"fill p.xyz -o w.ply --report r.json", "not expected: --report r.json\n"},
        {"info sample:shpere:500", "did you mean 'sphere'?"},
        {"run s.jsonl", "did you mean 'sphere'?"},
        {"run t.jsonl", "did you mean 'new'? known are"},
    };
    for (const auto& [words, wanted] : rows) {
        const Outcome outcome = program.run(QString(words).split(' '));
        QVERIFY2(outcome.code > 0 && outcome.err.find(wanted) != std::string::npos,
                 (words + (": " + outcome.err)).c_str());
    }
    QVERIFY(program.run({"info", "sample:sphere:500", "--qwertz"}).err.find("Did you mean") == std::string::npos);
}

void CommandLineTest::badInputIsOneAndLeavesNothing_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* arguments, const char* told) {
        QTest::newRow(arguments) << QString(arguments).split(' ', Qt::SkipEmptyParts) << told;
    };
    row("info nowhere.ply", "nowhere.ply");
    row("info bad.ply", "bad.ply");
    row("info sample:teapot", "teapot");
    row("info sample:torus:many", "sample:torus:many");
    row("convert bad.ply out.ply", "bad.ply");
    row("convert sample:sphere:500 nowhere/out.ply", "nowhere/out.ply");
    row("query sample:sphere:500 --at bad.xyz --what value -o out.csv", "bad.xyz, line 3");
    row("query sample:sphere:500 --at empty.xyz --what value -o out.csv", "empty.xyz");
    row("query sample:sphere:500 --at nowhere.xyz --what value -o out.csv", "nowhere.xyz");
    row("query three.xyz --at good.xyz --what value -o out.csv", "three.xyz");
    row("query sample:sphere:500 --at good.xyz --what value -o nowhere/out.csv", "nowhere/out.csv");
    row("intersect sample:sphere:500 --rays good.xyz -o out.csv", "good.xyz");
    row("intersect sample:sphere:500 --rays bad_rays.csv -o out.csv", "bad_rays.csv, line 3");
    row("render bad.ply -o out.png", "bad.ply");
    row("render sample:sphere:500 -o nowhere/out.png", "nowhere/out.png");
    row("run nowhere.jsonl", "nowhere.jsonl");
    row("run bad.jsonl -o out.ply --render out.png --timings out.json", "bad.jsonl:2");
    row("run good.jsonl --model nowhere.ply", "nowhere.ply");
    row("recover empty.xyz -o out.ply", "empty.xyz");
    // Of two faults the output's is told: it is known before the work.
    row("convert bad.ply nowhere/out.ply", "nowhere/out.ply");
    row("cut bad.ply --plane 0,0,1,0 -o nowhere/out.ply", "nowhere/out.ply");
    row("register bad.ply --to bad.ply -o nowhere/out.ply", "nowhere/out.ply");
    row("reduce bad.ply --count 100 -o out.ply --report nowhere/out.json", "nowhere/out.json");
    row("render bad.ply -o out.png --depth nowhere/out.pfm", "nowhere/out.pfm");
    row("mesh bad.ply -o nowhere/out.stl", "nowhere/out.stl");
    row("run bad.jsonl --timings nowhere/out.json", "nowhere/out.json");
}

void CommandLineTest::badInputIsOneAndLeavesNothing() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, told);
    const Program program;
    program.write("bad.ply", "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nend_header\n0 0\n");
    program.write("good.xyz", "0 0 1\n1 0 0\n");
    program.write("bad.xyz", "# positions\n0 0 1\n0 zero 1\n");
    program.write("empty.xyz", "# nothing\n");
    program.write("three.xyz", "0 0 1\n1 0 0\n0 1 0\n");
    program.write("bad_rays.csv", "ox,oy,oz,dx,dy,dz\n0,0,5,0,0,-1\n0,0,5,0,0,0\n");
    program.write("bad.jsonl", "{\"op\":\"new\",\"sample\":\"sphere\",\"count\":500}\n{\"op\":\"melt\"}\n\n");
    program.write("good.jsonl", "{\"op\":\"expect\"}\n");
    const QStringList before = program.dir().entryList(QDir::Files);
    const Outcome outcome = program.run(arguments);
    QVERIFY2(outcome.code == 1, (std::to_string(outcome.code) + " " + outcome.err).c_str());
    QVERIFY2(outcome.err.find(told.toStdString()) != std::string::npos, outcome.err.c_str());
    QVERIFY2(std::count(outcome.err.begin(), outcome.err.end(), '\n') <= 2, outcome.err.c_str());
    QCOMPARE(program.dir().entryList(QDir::Files), before);
}

void CommandLineTest::interruptStopsCleanly() {
    const Program program;
    QProcess process;
    program.prepare(process,
                    {"render", "sample:scan:400000", "-o", "out.png", "--mode", "raycast", "--size", "4000x4000"});
    process.start();
    QVERIFY(process.waitForStarted());
    QTest::qWait(1500);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("cancelled"));
    QVERIFY(program.dir().entryList(QDir::Files).isEmpty());
}

void CommandLineTest::quietSaysNothing() {
    const Program program;
    program.write("a.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\nnan 0 0\n0 0 1\n");
    const Outcome loud = program.run({"convert", "a.xyz", "b.ply"});
    QCOMPARE(loud.code, 0);
    QVERIFY2(loud.err.find("1 ") != std::string::npos, loud.err.c_str());
    const Outcome quiet = program.run({"convert", "a.xyz", "c.ply", "--quiet"});
    QCOMPARE(quiet.code, 0);
    QVERIFY(quiet.err.empty() && quiet.out.empty());
}

static const test::Registered<CommandLineTest> registered;
#include "command_line_test.moc"
