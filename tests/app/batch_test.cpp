// Many files at once: each under its own name in a folder, a table that tells of all, one failure that ends nothing,
// and plans that other programs run to the same bytes.
#include "program.h"
#include "support/registry.h"

#include <QFile>
#include <QTest>

using test::json;
using test::Outcome;
using test::Program;
using test::rowsOf;

class BatchTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyFileBecomesOne();
    void oneFailureEndsNothing();
    void everySubcommandHasIt_data();
    void everySubcommandHasIt();
    void contractFormsStay();
    void plansRunToTheSameBytes();
    void scriptsRunTheSameJobs();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
    void cleaningTakesSeveralWays();
    void dryRunsWriteNothing();
    void contoursAreLevel();
    void convertThinsInAnyMemory();
};

namespace {

void makeInputs(const Program& program) {
    for (const char* name : {"a.ply", "b's {one}.xyz"}) // as people name them
        QCOMPARE(program.run({"convert", name[0] == 'a' ? "sample:sphere:800" : "sample:torus:900", name}).code, 0);
}

/// The command of a job, by the program that is tested.
Outcome runJob(const Program& program, const json& job) {
    QStringList arguments;
    for (std::size_t k = 1; k < job.at("command").size(); ++k)
        arguments << QString::fromStdString(job.at("command").at(k).get<std::string>());
    return program.run(arguments);
}

} // namespace

void BatchTest::everyFileBecomesOne() {
    const Program program;
    makeInputs(program);
    const Outcome outcome = program.run({"clean", "a.ply", "b's {one}.xyz", "sample:knot:700", "--into", "out/there",
                                         "--outliers", "radius", "--json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json found = json::parse(outcome.out);
    QVERIFY(found.at("done") == 3 && found.at("failed") == 0);
    const char* names[] = {"out/there/a.ply", "out/there/b's {one}.xyz", "out/there/sample-knot-700.ply"};
    for (std::size_t k = 0; k < 3; ++k) {
        const json row = found.at("jobs").at(k);
        QVERIFY2(row.at("output") == names[k] && row.at("ok") == true, row.dump().c_str());
        QVERIFY(row.at("report").at("outliers").at("method") == "radius" && row.contains("seconds"));
        QCOMPARE(program.run({"info", names[k]}).code, 0);
    }
    // the same as one by one
    QCOMPARE(program.run({"clean", "a.ply", "alone.ply", "--outliers", "radius"}).code, 0);
    QCOMPARE(program.read("alone.ply"), program.read("out/there/a.ply"));
}

void BatchTest::oneFailureEndsNothing() {
    const Program program;
    makeInputs(program);
    program.write("broken.ply", "ply\nformat ascii 1.0\nelement vertex x\n");
    const Outcome outcome =
        program.run({"convert", "broken.ply", "nowhere.ply", "a.ply", "--into", "out", "--as", "xyz"});
    QCOMPARE(outcome.code, 1);
    QVERIFY2(outcome.out.find("failed  broken.ply: ") != std::string::npos &&
                 outcome.out.find("failed  nowhere.ply: ") != std::string::npos &&
                 outcome.out.find("done    a.ply -> out/a.xyz") != std::string::npos,
             outcome.out.c_str());
    QVERIFY2(outcome.err.find("2 of 3 files failed") != std::string::npos, outcome.err.c_str());
    QVERIFY(QFile::exists(program.dir().filePath("out/a.xyz")));
    QCOMPARE(QDir(program.dir().filePath("out")).entryList(QDir::Files | QDir::Hidden), QStringList{"a.xyz"});
}

void BatchTest::everySubcommandHasIt_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("output");
    const auto row = [](const char* name, QStringList arguments, const char* output) {
        QTest::newRow(name) << arguments << QString(output);
    };
    row("clean", {"--thin", "0.1"}, "out/a.ply");
    row("convert", {"--as", "pts"}, "out/a.pts");
    row("resample", {"--count", "600"}, "out/a.ply");
    row("mesh", {"--as", ".stl", "--method", "delaunay"}, "out/a.stl");
}

void BatchTest::everySubcommandHasIt() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, output);
    const Program program;
    makeInputs(program);
    const Outcome outcome = program.run(QStringList{QTest::currentDataTag(), "a.ply", "b's {one}.xyz"} + arguments +
                                        QStringList{"--into", "out"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    QVERIFY2(QFile::exists(program.dir().filePath(output)), outcome.out.c_str());
    QCOMPARE(QDir(program.dir().filePath("out")).entryList(QDir::Files).size(), 2);
}

void BatchTest::contractFormsStay() {
    const Program program;
    makeInputs(program);
    QCOMPARE(program.run({"clean", "a.ply", "c.ply", "--thin", "0.1"}).code, 0);
    QCOMPARE(program.run({"convert", "a.ply", "d.xyz"}).code, 0);
    QCOMPARE(program.run({"resample", "a.ply", "-o", "e.ply", "--count", "600"}).code, 0);
    QCOMPARE(program.run({"mesh", "a.ply", "-o", "f.obj"}).code, 0);
    for (const char* name : {"c.ply", "d.xyz", "e.ply", "f.obj"})
        QVERIFY2(!program.read(name).empty(), name);
}

void BatchTest::plansRunToTheSameBytes() {
    const Program program;
    makeInputs(program);
    const QStringList batch{"clean", "a.ply",        "b's {one}.xyz", "--outliers", "radius,islands", "--thin",
                            "0.08",  "--duplicates", "--into",        "planned",    "--as",           "ply"};
    const Outcome outcome = program.run(batch + QStringList{"--plan", "plan.json"});
    QVERIFY2(outcome.code == 0 && !QFile::exists(program.dir().filePath("planned")), outcome.err.c_str());
    const json plan = json::parse(program.read("plan.json"));
    QCOMPARE(plan.at("jobs").size(), std::size_t(2));
    program.dir().mkpath("planned");
    std::vector<std::string> first;
    for (int round = 0; round < 2; ++round) // again to the same bytes
        for (const json& job : plan.at("jobs")) {
            QVERIFY(job.at("needs").empty() && job.at("inputs").size() == 1);
            const Outcome done = runJob(program, job);
            QVERIFY2(done.code == 0, done.err.c_str());
            first.push_back(program.read(job.at("outputs").at(0).get<std::string>()));
        }
    QVERIFY(first[0] == first[2] && first[1] == first[3]);
    QCOMPARE(program.run(QStringList(batch).replaceInStrings("planned", "direct")).code, 0);
    QCOMPARE(program.read("direct/a.ply"), first[0]);
    QCOMPARE(program.read("direct/b's {one}.ply"), first[1]);
}

void BatchTest::scriptsRunTheSameJobs() {
    const Program program;
    makeInputs(program);
    const QStringList batch{"convert", "a.ply", "b's {one}.xyz", "--into", "out", "--as", "xyz", "--plan"};
    QCOMPARE(program.run(batch + QStringList{"job.sh"}).code, 0);
    const Outcome braces = program.run(batch + QStringList{"Snakefile"}); // wildcards to Snakemake
    QVERIFY2(braces.code == 2 && braces.err.find("braces") != std::string::npos, braces.err.c_str());
    QVERIFY(QFile::copy(program.dir().filePath("b's {one}.xyz"), program.dir().filePath("b's two.xyz")));
    const QStringList plain{"convert", "a.ply", "b's two.xyz", "--into", "out", "--as", "xyz", "--plan"};
    for (const char* name : {"Snakefile", "rules.smk"})
        QCOMPARE(program.run(plain + QStringList{name}).code, 0);
    // The script of Slurm, run as Slurm would run each of its tasks.
    program.dir().mkpath("bin");
    QVERIFY(QFile::link(qEnvironmentVariable("POINTCLAY_PROGRAM"), program.dir().filePath("bin/pointclay")));
    for (const char* task : {"0", "1"}) {
        QProcess shell;
        program.prepare(shell, {"job.sh"});
        QProcessEnvironment environment = shell.processEnvironment();
        environment.insert("PATH", program.dir().filePath("bin") + ":" + environment.value("PATH"));
        environment.insert("SLURM_ARRAY_TASK_ID", task);
        shell.setProcessEnvironment(environment);
        shell.setProgram("sh");
        shell.start();
        const Outcome outcome = test::outcomeOf(shell, 60000);
        QVERIFY2(outcome.code == 0, outcome.err.c_str());
    }
    QVERIFY(!program.read("out/a.xyz").empty() && !program.read("out/b's {one}.xyz").empty());
    QVERIFY(program.read("job.sh").find("#SBATCH --array=0-1\n") != std::string::npos);
    const std::string snake = program.read("Snakefile");
    QVERIFY2(snake.starts_with("rule all:\n    input: \"out/a.xyz\", \"out/b's two.xyz\"\n") &&
                 snake.find("rule convert_0002:\n    input: \"b's two.xyz\"\n") != std::string::npos,
             snake.c_str());
    QCOMPARE(program.read("rules.smk"), snake);
}

void BatchTest::wrongUsageIsRefused_data() {
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* arguments, const char* told) { QTest::newRow(arguments) << arguments << told; };
    row("convert a.ply b.xyz c.ply", "--into");
    row("convert a.ply", "OUT is required");
    row("convert a.ply b.xyz --as ply", "--into");
    row("convert a.ply other/a.xyz --into out --as ply", "two inputs");
    row("convert a.ply --into .", "written over");
    row("convert a.ply --into out --as docx", "docx");
    row("convert a.ply --into out --plan plan.txt", ".json");
    row("mesh a.ply -o b.stl --into out", "-o");
    row("mesh a.ply", "--output is required");
    row("mesh a.ply --into out --check", "--check");
    row("resample a.ply --count 500", "--output is required");
    row("clean a.ply --into out", "nothing to do");
    row("clean a.ply --into out --thin 0.1 --report r.json", "--json");
    row("clean a.ply b.ply --outliers radius,shape", "statistical");
}

void BatchTest::wrongUsageIsRefused() {
    QFETCH(QString, arguments);
    QFETCH(QString, told);
    const Program program;
    makeInputs(program);
    const Outcome outcome = program.run(arguments.split(' '));
    QVERIFY2(outcome.code == 2 && outcome.err.find(told.toStdString()) != std::string::npos,
             (std::to_string(outcome.code) + ": " + outcome.err).c_str());
    QVERIFY(!QFile::exists(program.dir().filePath("out")));
}

void BatchTest::cleaningTakesSeveralWays() {
    const Program program;
    std::string points;
    for (int i = 0; i < 4000; ++i) {
        const double z = 1 - (2 * i + 1.0) / 4000, r = std::sqrt(1 - z * z), a = i * 2.399963229728653;
        points += QString("%1 %2 %3\n").arg(r * std::cos(a)).arg(r * std::sin(a)).arg(z).toStdString();
    }
    for (int i = 0; i < 12; ++i) // a dense island
        points += QString("%1 %2 3\n").arg(0.02 * (i % 4)).arg(0.02 * (i / 4)).toStdString();
    for (int i = 0; i < 8; ++i) // strays, one by one
        points += QString("%1 %2 -2.5\n").arg(2 + i).arg(3 - 1.3 * i).toStdString();
    program.write("scan.xyz", points);
    const auto removed = [&](const char* ways) {
        const Outcome outcome =
            program.run({"clean", "scan.xyz", "out.ply", "--outliers", ways, "--report", "report.json"});
        return outcome.code == 0 ? json::parse(program.read("report.json")).at("outliers") : json(outcome.err);
    };
    const json both = removed("statistical,islands");
    QVERIFY2(both.at("removed") == 20 && both.at("method") == "statistical,islands", both.dump().c_str());
    QVERIFY2(both.at("by").at("statistical").get<int>() + both.at("by").at("islands").get<int>() == 20,
             both.dump().c_str());
    QVERIFY(!removed("islands").contains("by"));
    QCOMPARE(program.run({"clean", "scan.xyz", "out.ply", "--outliers", "radius,islands", "--limit", "3"}).code, 1);
}

void BatchTest::dryRunsWriteNothing() {
    const Program program;
    makeInputs(program);
    const Outcome outcome =
        program.run({"clean", "a.ply", "out.ply", "--thin", "0.2", "--dry-run", "--report", "report.json"});
    QVERIFY2(outcome.code == 0 && outcome.err.find("Nothing was written") != std::string::npos, outcome.err.c_str());
    QVERIFY(!QFile::exists(program.dir().filePath("out.ply")));
    const json dry = json::parse(program.read("report.json"));
    const Outcome nameless = program.run({"clean", "a.ply", "--thin", "0.2", "--dry-run", "--report", "report.json"});
    QVERIFY2(nameless.code == 0 && nameless.err.find("the model would have") != std::string::npos,
             nameless.err.c_str());
    QCOMPARE(json::parse(program.read("report.json")), dry);
    QCOMPARE(program.run({"clean", "a.ply", "out.ply", "--thin", "0.2", "--report", "report.json"}).code, 0);
    QCOMPARE(json::parse(program.read("report.json")), dry);
}

void BatchTest::contoursAreLevel() {
    const Program program;
    const Outcome outcome =
        program.run({"section", "sample:sphere:4000", "--plane", "0,0,2,0.2", "--every", "0.25", "-o", "c.csv"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const auto rows = rowsOf(program.read("c.csv"));
    QCOMPARE(rows.at(0).back(), std::string("height"));
    std::set<int> levels;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double x = std::stod(rows[i].at(2)), y = std::stod(rows[i].at(3)), z = std::stod(rows[i].at(4));
        const double height = std::stod(rows[i].at(8)), k = (height - 0.1) / 0.25;
        QVERIFY(std::abs(z - height) < 1e-12 && std::abs(k - std::round(k)) < 1e-9);
        QVERIFY(std::abs(std::sqrt(x * x + y * y + z * z) - 1) < 1e-3);
        levels.insert(int(std::lround(k)));
    }
    QCOMPARE(levels, (std::set<int>{-4, -3, -2, -1, 0, 1, 2, 3})); // from -0.9 to 0.85
    QCOMPARE(std::count(outcome.out.begin(), outcome.out.end(), '\n'), std::ptrdiff_t(8));
    QVERIFY(outcome.out.starts_with("height -0.9: 1 curve, length 2.7"));
    // Level ones from height 0 without a plane; the sample stands with y upwards. In drawings, too.
    for (const char* file : {"c.dxf", "c.svg", "c.obj"})
        QCOMPARE(program.run({"section", "sample:sphere:4000", "--every", "0.3", "-o", file}).code, 0);
    QCOMPARE(QString::fromStdString(program.read("c.svg")).count("<path"), 7);
    QCOMPARE(program.run({"section", "sample:sphere:500", "--every", "1e-9"}).code, 1);
    QCOMPARE(program.run({"section", "sample:sphere:500", "--plane", "0,0,1,-100", "--every", "1e-307"}).code, 1);
}

void BatchTest::convertThinsInAnyMemory() {
    const Program program;
    for (const char* name : {"a.las", "a.laz", "a.ply"})
        QCOMPARE(program.run({"convert", "sample:sphere:20000", name}).code, 0);
    const auto thin = [&](const char* in, const char* out, const char* memory) {
        const Outcome outcome = program.run({"convert", in, out, "--thin", "0.2", "--memory", memory});
        return outcome.code == 0 ? outcome.err : std::string();
    };
    const std::string told = thin("a.las", "much.las", "1G"), often = thin("a.las", "little.las", "200K");
    QVERIFY2(told.find("20000 points were thinned to ") != std::string::npos &&
                 told.find("passes") == std::string::npos,
             told.c_str());
    QVERIFY2(often.find("passes") != std::string::npos, often.c_str());
    QCOMPARE(program.read("little.las"), program.read("much.las"));
    for (const char* in : {"a.las", "a.laz", "a.ply"}) { // all readers: a Poisson disk of the sphere
        QVERIFY(!thin(in, "few.xyz", "1G").empty());
        const auto count = rowsOf(program.read("few.xyz")).size();
        QVERIFY2(count > 200 && count < 420, (in + std::to_string(count)).c_str());
    }
    QCOMPARE(program.run({"convert", "a.las", "b.las", "--thin", "0.2", "--memory", "some"}).code, 2);
    QCOMPARE(program.run({"convert", "a.las", "b.las", "--memory", "1G"}).code, 2); // of nothing
    QCOMPARE(program.run({"convert", "a.las", "b.las", "--thin", "0.001", "--memory", "1K"}).code, 1);
}

static const test::Registered<BatchTest> registered;
#include "batch_test.moc"
