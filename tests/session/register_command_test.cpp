// The command `register`: scans of one body meet, as one step that undo and replay bring back to the same bits.
#include "core/base/mat3.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/registering/rigid.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "workbench.h"

#include <QTest>

using base::Vec3d;
using process::Rigid;
using test::json;
using test::Workbench;

class RegisterCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theModelMovesOntoTheOther_data();
    void theModelMovesOntoTheOther();
    void othersMoveOntoTheModel();
    void numbersOfScansGoOn();
    void whatNotAllHaveIsNamed();
    void journalsAndThreadsBringTheSameBits();
    void aFileThatChangedIsNoticed();
    void nonsenseIsRefused();
};

namespace {

double radiusAt(const Vec3d& d) {
    return 1 + 0.2 * std::sin(3 * d.x + 1) * std::cos(2.5 * d.y) + 0.15 * std::sin(4 * d.z + 0.5 * d.x) +
           0.1 * std::cos(5 * d.y - 2 * d.z);
}

Vec3d bodyAt(const Vec3d& d) {
    return base::normalized(d) * radiusAt(base::normalized(d));
}

/// What a scanner sees of a body without symmetry from `eye`, moved by `motion`; up to 20 times as dense on one side.
std::string scan(const Vec3d& eye, std::size_t count, const Rigid& motion, base::Random& random, Vec3d offset = {}) {
    std::ostringstream out;
    out.precision(14);
    out << "ply\nformat ascii 1.0\nelement vertex " << count
        << "\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\nproperty float ny\n"
           "property float nz\nend_header\n";
    for (std::size_t k = 0; k < count;) {
        const Vec3d d = random.unitVector(), u = base::perpendicular(d), v = cross(d, u), p = bodyAt(d);
        const Vec3d n = base::normalized(cross(bodyAt(d + u * 1e-5) - p, bodyAt(d + v * 1e-5) - p));
        if (dot(n, base::normalized(eye - p)) < 0.3 || random.uniform() > std::pow(20.0, -0.5 - 0.5 * d.z))
            continue;
        const Vec3d x = motion(p) + offset, m = motion.turn(n);
        out << x.x << ' ' << x.y << ' ' << x.z << ' ' << m.x << ' ' << m.y << ' ' << m.z << '\n';
        ++k;
    }
    return out.str();
}

struct TwoScans {
    base::Random random{test::seed()};
    Rigid motion = process::motionOf(random.unitVector() * 0.15, random.unitVector() * 0.08);
    Workbench bench;
    std::string front, side;

    explicit TwoScans(Vec3d offset = {}, std::size_t count = 4000) {
        front = test::write(bench.path("front.ply"), scan({3, 0, 0}, count, {}, random, offset)).string();
        side = test::write(bench.path("side.ply"), scan({2, 2.5, 0}, count, motion, random, offset)).string();
    }
    /// How far the surfels of `scan` stand from the body at most, in file coordinates less `offset`.
    double error(Vec3d offset, int scan = -1) const {
        const surfel::SurfelList list = bench.document.surface().tree().surfels();
        const surfel::Attribute* number = list.layout->find("scan");
        double out = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Vec3d x = base::cast<double>(list.items[i].position) + bench.document.provenance().origin - offset;
            if (scan < 0 || surfel::read(*number, list.extraOf(i)) == scan)
                out = std::max(out, std::abs(length(x) - radiusAt(base::normalized(x))));
        }
        return out;
    }
};

/// Of a scan, where it does not matter how near the scans come.
constexpr std::size_t few = test::sanitized ? 1000 : 4000;

QByteArray told(double value) {
    return QByteArray::number(value) + ", seed " + QByteArray::number(test::seed());
}

} // namespace

void RegisterCommandTest::theModelMovesOntoTheOther_data() {
    QTest::addColumn<double>("offset");
    QTest::addColumn<bool>("join");
    QTest::newRow("far from zero") << 1e7 << false;
    if (test::sanitized) // some ten seconds each there
        return;
    QTest::newRow("joined") << 0.0 << true;
    QTest::newRow("alone") << 0.0 << false;
    QTest::newRow("far from zero, joined") << 1e7 << true;
}

void RegisterCommandTest::theModelMovesOntoTheOther() {
    QFETCH(double, offset);
    QFETCH(bool, join);
    const Vec3d away{offset, -0.3 * offset, 0};
    TwoScans scans(away);
    scans.bench.run({{"op", "open"}, {"path", scans.side}});
    const std::string before = scans.bench.hash();
    QVERIFY2(scans.error(away) > 0.02, told(scans.error(away)));
    scans.bench.context.folder = scans.bench.path("");
    scans.bench.run({{"op", "register"}, {"to", "front.ply"}, {"join", join}});
    QCOMPARE(scans.bench.size(), std::size_t(join ? 8000 : 4000));
    QVERIFY2(scans.error(away) < 0.004, told(scans.error(away)));
    const std::string after = scans.bench.hash();
    scans.bench.run({{"op", "undo"}});
    QCOMPARE(scans.bench.hash(), before);
    scans.bench.run({{"op", "redo"}});
    QCOMPARE(scans.bench.hash(), after);
}

void RegisterCommandTest::othersMoveOntoTheModel() {
    TwoScans scans;
    scans.bench.run({{"op", "open"}, {"path", scans.front}});
    const std::string before = scans.bench.hash();
    scans.bench.run({{"op", "register"}, {"moving", {scans.side}}});
    QCOMPARE(scans.bench.size(), std::size_t(8000));
    QVERIFY2(scans.error({}, 0) < 1e-6 && scans.error({}, 1) < 0.004, told(scans.error({}, 1)));
    QVERIFY(scans.bench.context.figures.at("overlap") > 0.3 && scans.bench.context.figures.at("rms") < 0.002);
    scans.bench.document.surface().tree().validate();
    scans.bench.run({{"op", "undo"}});
    QCOMPARE(scans.bench.hash(), before);
}

void RegisterCommandTest::numbersOfScansGoOn() {
    TwoScans scans({}, few);
    scans.bench.run({{"op", "open"}, {"path", scans.front}});
    scans.bench.run({{"op", "register"}, {"moving", scans.side}}); // one may stand alone
    scans.bench.run({{"op", "register"}, {"moving", {scans.side, scans.side}}});
    const surfel::SurfelList list = scans.bench.document.surface().tree().surfels();
    std::map<double, std::size_t> counts;
    for (std::size_t i = 0; i < list.size(); ++i)
        ++counts[surfel::read(*list.layout->find("scan"), list.extraOf(i))];
    QVERIFY((counts == std::map<double, std::size_t>{{0, few}, {1, few}, {2, few}, {3, few}}));
}

void RegisterCommandTest::whatNotAllHaveIsNamed() {
    TwoScans scans({}, few);
    std::vector<std::string>& messages = scans.bench.context.messages;
    const auto left = [&] {
        return std::count_if(messages.begin(), messages.end(), [](const std::string& each) {
            return each == "Left out, as not all models share them: the colours, \"thickness\" and the layers.";
        });
    };
    scans.bench.run({{"op", "open"}, {"path", scans.front}});
    scans.bench.run({{"op", "register"}, {"moving", {scans.side}}});
    QVERIFY(std::none_of(messages.begin(), messages.end(),
                         [](const std::string& each) { return each.starts_with("Left out"); }));
    scans.bench.run({{"op", "colour"}, {"colour", {1, 2, 3}}});
    scans.bench.run({{"op", "measure"}, {"thickness", true}});
    scans.bench.run({{"op", "layer"}, {"do", "add"}});
    scans.bench.run({{"op", "register"}, {"moving", {scans.side}}});
    QCOMPARE(left(), 1);
    QVERIFY(!scans.bench.document.surface().tree().layout()->colours);
}

void RegisterCommandTest::journalsAndThreadsBringTheSameBits() {
    TwoScans scans({}, few);
    session::Journal journal(scans.bench.path("journal.jsonl"));
    scans.bench.context.journal = &journal;
    scans.bench.run({{"op", "open"}, {"path", scans.side}});
    scans.bench.run({{"op", "register"}, {"to", scans.front}});
    scans.bench.run({{"op", "register"}, {"moving", {scans.front}}});
    base::setThreadCount(1);
    Workbench again;
    session::replay(scans.bench.path("journal.jsonl"), again.context);
    base::setThreadCount(0);
    QCOMPARE(again.hash(), scans.bench.hash());
}

/// A journal must not bring another model and say nothing.
void RegisterCommandTest::aFileThatChangedIsNoticed() {
    for (const bool to : {true, false}) {
        if (test::sanitized && !to)
            break;
        TwoScans scans({}, few);
        session::Journal journal(scans.bench.path("journal.jsonl"));
        scans.bench.context.journal = &journal;
        scans.bench.run({{"op", "open"}, {"path", scans.side}});
        scans.bench.run({{"op", "register"}, {to ? "to" : "moving", scans.front}});
        test::write(scans.front, scan({3, 0, 0}, 4000, {}, scans.random));
        Workbench again;
        QVERIFY_EXCEPTION_THROWN(session::replay(scans.bench.path("journal.jsonl"), again.context), base::Error);
        again.context.takesChangedFiles = true;
        session::replay(scans.bench.path("journal.jsonl"), again.context);
    }
}

void RegisterCommandTest::nonsenseIsRefused() {
    TwoScans scans;
    scans.bench.run({{"op", "open"}, {"path", scans.side}});
    const std::string before = scans.bench.hash();
    const auto refused = [&](const json& command, const char* word) {
        const std::string why = scans.bench.refusal(command);
        QVERIFY2(why.find(word) != std::string::npos, why.c_str());
        QCOMPARE(scans.bench.hash(), before);
    };
    refused({{"op", "register"}}, "either");
    refused({{"op", "register"}, {"to", scans.front}, {"moving", {scans.front}}}, "either");
    refused({{"op", "register"}, {"moving", json::array()}}, "a list of paths");
    refused({{"op", "register"}, {"moving", {7}}}, "a list of paths");
    refused({{"op", "register"}, {"to", scans.front}, {"hashes", {"00"}}}, "not the one that was recorded");
    const std::string ball =
        test::write(scans.bench.path("far.xyz"), "90 0 0\n91 0 0\n90 1 0\n91 1 0\n90.5 .5 .3\n").string();
    QVERIFY(!scans.bench.refusal({{"op", "register"}, {"to", ball}}).empty());
}

static const test::Registered<RegisterCommandTest> registered;
#include "register_command_test.moc"
