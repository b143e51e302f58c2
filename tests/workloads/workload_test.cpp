// Every workload of the table, on a small scene.
#include "app/bench/measure.h"
#include "core/base/error.h"
#include "core/sculpt/tool.h"
#include "support/registry.h"

#include <QTest>
#include <set>

using bench::Scene;
using bench::Workload;

class WorkloadTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theContractsNamesAreThere();
    void everyRunDoesItsItems_data();
    void everyRunDoesItsItems();
    void scenesAreTheSameEveryTime();
    void measuringCounts();
    void oneLongRunIsEnough();
    void cancelStops();
};

void WorkloadTest::theContractsNamesAreThere() {
    std::set<std::string> names;
    for (const Workload& workload : bench::workloadTable()) {
        QVERIFY2(names.insert(workload.name).second, "twice");
        QVERIFY(!workload.item.empty() && !workload.tip.empty());
        QCOMPARE(workload.baseline.empty(), !workload.naive);
        QCOMPARE(bench::findWorkload(workload.name), &workload);
    }
    for (const char* name : {"build",
                             "evaluate",
                             "evaluate-scattered",
                             "project-basic",
                             "project-almost",
                             "project-orthogonal",
                             "project-scattered",
                             "rays-camera",
                             "rays-random",
                             "curvature",
                             "edit",
                             "undo",
                             "dab-draw-10k-resampled",
                             "splat-cpu",
                             "splat-cpu-moving",
                             "splat-osmesa",
                             "splat-osmesa-moving",
                             "splat-cpu-edit",
                             "splat-osmesa-upload",
                             "raycast-adaptive",
                             "load-ply",
                             "open-ply",
                             "open-points",
                             "normals",
                             "orient",
                             "start"})
        QVERIFY2(names.contains(name), name);
    QVERIFY(names.contains("mesh-marching-cubes"));
    QVERIFY(names.contains("mesh-delaunay"));
    QVERIFY(names.contains("rays-shadow") && names.contains("rays-occlusion"));
    for (const sculpt::ToolRow& row : sculpt::toolTable())
        QVERIFY2(names.contains(std::string("dab-") + row.id) != row.needs.layer, row.id);
    QVERIFY(!bench::findWorkload("no-such-thing"));
}

void WorkloadTest::everyRunDoesItsItems_data() {
    QTest::addColumn<QString>("name");
    for (const Workload& workload : bench::workloadTable())
        QTest::newRow(workload.name.c_str()) << QString::fromStdString(workload.name);
}

void WorkloadTest::everyRunDoesItsItems() {
    QFETCH(QString, name);
    static Scene scene({700, 0.02});
    const Workload& workload = *bench::findWorkload(name.toStdString());
    try {
        for (const auto& make : {workload.ours, workload.naive}) {
            if (!make)
                continue;
            const bench::Run run = make(scene);
            QVERIFY(run);
            const std::size_t items = run();
            const bool many = workload.item == "ray" || workload.item == "triangle" || workload.item == "pixel";
            QVERIFY(items > 0 && (many || items <= scene.size()));
            const int again = many || workload.item == "start" || name.startsWith("splat") ? 1 : test::effort(40);
            for (int i = 0; i < again; ++i)
                QCOMPARE(run(), items); // brushes, batches and edits come round
        }
    } catch (const base::Error& error) {
        QVERIFY2(name.startsWith("splat-osmesa"), error.what());
        QSKIP(error.what());
    }
}

void WorkloadTest::scenesAreTheSameEveryTime() {
    Scene a({2000, 0.1}), b({2000, 0.1}), quiet({2000, 0});
    QVERIFY(a.surface().tree().contentHash() == b.surface().tree().contentHash());
    QVERIFY(a.surface().tree().contentHash() != quiet.surface().tree().contentHash());
    QVERIFY(std::ranges::equal(a.scattered(), b.scattered()));
    double neighbours = 0;
    for (const base::Vec3f& x : a.coherent())
        neighbours += a.surface().evaluate(x).samples;
    neighbours /= static_cast<double>(a.coherent().size());
    QVERIFY2(neighbours > 17 && neighbours < 22, qPrintable(QString::number(neighbours)));
}

void WorkloadTest::measuringCounts() {
    Scene scene({500, 0.02});
    int ours = 0, naive = 0;
    const auto counting = [](int& calls, std::size_t items) {
        return [&calls, items](Scene&) -> bench::Run { return [&calls, items] { return ++calls, items; }; };
    };
    Workload workload{"counted", "thing", "nothing", "less", counting(ours, 7), counting(naive, 3)};
    const bench::Measurement found = bench::measure(workload, scene, 0.002);
    QVERIFY(ours >= 4 && naive >= 4);
    QVERIFY(found.ours.items % 7 == 0 && found.ours.items > 0 && found.ours.perSecond() > 0);
    QVERIFY(found.baseline && found.baseline->items % 3 == 0 && found.baseline->seconds > 0);
    workload.naive = [](Scene&) { return bench::Run(); };
    QVERIFY(!bench::measure(workload, scene, 0.002).baseline);
}

void WorkloadTest::oneLongRunIsEnough() {
    Scene scene({500, 0.02});
    int calls = 0;
    Workload workload{"long", "thing", "nothing", "", nullptr, nullptr};
    workload.ours = [&](Scene&) -> bench::Run {
        return {[&] {
                    QTest::qSleep(20);
                    return static_cast<std::size_t>(++calls);
                },
                [&] { return "call " + std::to_string(calls); }};
    };
    const bench::Measurement found = bench::measure(workload, scene, 0.001);
    QCOMPARE(calls, 1);
    QVERIFY(found.ours.items == 1 && found.ours.seconds >= 0.02);
    QCOMPARE(found.remark, std::string("call 1"));
}

void WorkloadTest::cancelStops() {
    Scene scene({500, 0.02});
    const std::atomic<bool> cancel = true;
    QVERIFY_EXCEPTION_THROWN(bench::measure(*bench::findWorkload("evaluate"), scene, 1000, base::Progress{{}, &cancel}),
                             base::Cancelled);
}

static const test::Registered<WorkloadTest> registered;
#include "workload_test.moc"
