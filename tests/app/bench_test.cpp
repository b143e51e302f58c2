// bench: the table and the JSON of the contract.
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using nlohmann::json;
using test::Outcome;
using test::Program;

class BenchTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void jsonHasTheContractsKeys();
    void modelsCanBeMeasured();
    void unknownWorkloadsAreWrongUsage();
};

static void check(const json& row) {
    QCOMPARE(row.size(), std::size_t(12));
    QVERIFY(row.at("remark").is_string());
    QCOMPARE(row.at("same_work").is_null(), row.at("baseline").is_null());
    for (const char* key : {"points", "threads", "items", "seconds", "items_per_second"})
        QVERIFY2(row.at(key).get<double>() > 0, key);
    const double rate = row.at("items").get<double>() / row.at("seconds").get<double>();
    QVERIFY(std::abs(row.at("items_per_second").get<double>() / rate - 1) < 1e-9);
    QVERIFY(row.at("baseline").is_null() || !row.at("baseline").get<std::string>().empty());
    QCOMPARE(row.at("baseline_items_per_second").is_null(), row.at("baseline").is_null());
    if (!row.at("baseline").is_null())
        QVERIFY(row.at("baseline_items_per_second").get<double>() > 0);
    const bool awaited = row.at("name").get<std::string>().starts_with("dab-");
    QVERIFY(!awaited || !row.at("ms").is_null());
    for (const char* key : {"ms", "baseline_ms"})
        if (const json& ms = row.at(key); !ms.is_null())
            QVERIFY(0 < ms.at("p50") && ms.at("p50") <= ms.at("p99") && ms.at("p99") <= ms.at("max"));
}

/// Whether the help says of a workload that it has no baseline.
static bool saysNone(const std::string& help, const std::string& name) {
    const std::size_t begin = help.find(" " + name + ": ");
    const std::string line = help.substr(begin, help.find('\n', begin) - begin);
    return line.ends_with("baseline: none");
}

void BenchTest::jsonHasTheContractsKeys() {
    if (test::sanitized)
        QSKIP("minutes under a sanitizer");
    const Program program;
    const std::string help = program.run({"bench", "--help"}).out;
    const Outcome outcome = program.run(
        {"bench", "--points", "600", "--noise", "0.1", "--seconds", "0.001", "--threads", "1", "--json", "a.json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json rows = json::parse(program.read("a.json"));
    QVERIFY(rows.size() > 12);
    std::size_t lines = 1; // the head
    for (const json& row : rows) {
        check(row);
        QCOMPARE(row.at("points"), json(600));
        QCOMPARE(row.at("threads"), json(1));
        QVERIFY(outcome.out.find("\n" + row.at("name").get<std::string>() + " ") != std::string::npos);
        QCOMPARE(row.at("baseline").is_null(), saysNone(help, row.at("name").get<std::string>()));
        ++lines;
    }
    QCOMPARE(static_cast<std::size_t>(std::count(outcome.out.begin(), outcome.out.end(), '\n')), lines);
}

void BenchTest::modelsCanBeMeasured() {
    if (test::sanitized)
        QSKIP("minutes under a sanitizer");
    const Program program;
    const Outcome outcome = program.run(
        {"bench", "curvature", "evaluate", "--model", "sample:torus:2000", "--seconds", "0.001", "--json", "a.json"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const json rows = json::parse(program.read("a.json"));
    QCOMPARE(rows.size(), std::size_t(2));
    QCOMPARE(rows[0].at("name"), json("curvature")); // in the order asked for
    QCOMPARE(rows[1].at("name"), json("evaluate"));
    for (const json& row : rows) {
        check(row);
        QVERIFY(row.at("points").get<int>() > 1500);
    }
}

void BenchTest::unknownWorkloadsAreWrongUsage() {
    const Program program;
    const Outcome outcome = program.run({"bench", "evaluate", "fly", "--points", "600", "--json", "a.json"});
    QCOMPARE(outcome.code, 2);
    for (const char* part : {"'fly'", "evaluate-scattered", "dab-draw", "load-ply"})
        QVERIFY2(outcome.err.find(part) != std::string::npos, part);
    QVERIFY(outcome.out.empty());
    QVERIFY(!std::filesystem::exists(program.path("a.json")));
    QCOMPARE(program.run({"bench", "--model", "sample:torus", "--points", "600"}).code, 2);
    QCOMPARE(program.run({"bench", "--model", "missing.ply"}).code, 1);
}

static const test::Registered<BenchTest> registered;
#include "bench_test.moc"
