// solid: as a person types it; the report, and what is refused.
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <cmath>
#include <numbers>
#include <QTest>

using test::json;
using test::Outcome;
using test::Program;

class SolidTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void reportsTellVolumeAndSeam();
    void filletsAddWhatTheBallLeaves();
    void whatDoesNotFitIsRefused();
};

static json unionOf(const Program& program, const QStringList& further) {
    QStringList args{"solid",
                     "sample:sphere:12000",
                     "sample:sphere:12000",
                     "-o",
                     "both.ply",
                     "--op",
                     "union",
                     "--position",
                     "1,0,0",
                     "--report",
                     "report.json"};
    args += further;
    const Outcome outcome = program.run(args);
    if (outcome.code != 0)
        return {{"error", outcome.err}};
    return json::parse(program.read("report.json"));
}

void SolidTest::reportsTellVolumeAndSeam() {
    const Program program;
    const json report = unionOf(program, {});
    QVERIFY2(report.size() == 5, report.dump().c_str());
    constexpr double pi = std::numbers::pi, wanted = 8 * pi / 3 - 5 * pi / 12;
    QVERIFY2(std::abs(double(report.at("volume")) / wanted - 1) < 0.002, report.dump().c_str());
    QVERIFY2(std::abs(double(report.at("seam_length")) / (pi * std::sqrt(3.0)) - 1) < 0.002, report.dump().c_str());
    QCOMPARE(report.at("seams"), 1);
    QCOMPARE(report.at("corners"), 0);
    QCOMPARE(report.at("open"), false);
}

void SolidTest::filletsAddWhatTheBallLeaves() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    const Program program;
    const double sharp = unionOf(program, {}).at("volume"), round = unionOf(program, {"--fillet", "0.3"}).at("volume");
    QVERIFY2(round > sharp * 1.001 && round < sharp * 1.05, QByteArray::number(round / sharp));
}

void SolidTest::whatDoesNotFitIsRefused() {
    const Program program;
    QStringList args{"solid", "sample:sphere:3000", "sample:sphere:3000", "-o",     "both.ply",
                     "--op",  "intersection",       "--position",         "1.5,0,0"};
    args += {"--fillet", "0.4"};
    const Outcome outcome = program.run(args);
    QCOMPARE(outcome.code, 1);
    QVERIFY2(outcome.err.find("fillet") != std::string::npos, outcome.err.c_str());
    args.back() = "-1";
    QCOMPARE(program.run(args).code, 2);
}

static const test::Registered<SolidTest> registered;
#include "solid_test.moc"
