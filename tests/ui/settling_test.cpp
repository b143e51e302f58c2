// What becomes of a stroke between its release and its step of history, task by task, without a thread.
#include "core/session/session_file.h"
#include "support/registry.h"
#include "ui/work/model_worker.h"

#include <nlohmann/json.hpp>
#include <QTemporaryDir>
#include <QTest>

using namespace ui;

class SettlingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void slicesEndAsOneCallDoes();
    void undoIsThereAtOnceAndRedoBringsTheStrokeBack();
    void whatIsAskedForNextComesAfterTheStroke();
    void aStrokeAfterAnUndoneOneDropsIt();
    void everyTaskIsAnsweredOnce();
};

namespace {

/// A worker whose tasks are performed at once.
struct Bench {
    QTemporaryDir folder;
    WorkerSignals signals;
    Snapshot shown;
    int answers = 0, asked = 0;
    std::unique_ptr<ModelWorker> worker;

    Bench() {
        WorkerReports reports;
        reports.published = [this](Snapshot snapshot) { shown = std::move(snapshot); };
        reports.progressed = [](double, const QString&) {};
        reports.told = reports.failed = [](const QString&) {};
        reports.finished = [this](const std::function<void(bool)>&, bool, int) { ++answers; };
        worker = std::make_unique<ModelWorker>(signals, reports, std::make_unique<session::Journal>(journal()));
        command({{"op", "new"}, {"sample", "sphere"}, {"count", 6000}});
    }
    std::filesystem::path journal() const { return folder.filePath("journal.jsonl").toStdString(); }

    void perform(Task task) {
        ++asked;
        worker->perform(task);
    }
    void command(const nlohmann::json& line, CommandKind kind = CommandKind::Other) {
        perform(CommandTask{[line](session::Context& context) { session::run(context, line); }, {}, kind});
    }
    void undo() { command({{"op", "undo"}}, CommandKind::Undo); }
    void redo() { command({{"op", "redo"}}, CommandKind::Redo); }
    /// A hook, pulled far enough to be resampled at its end.
    void stroke(float from = 0) {
        sculpt::StrokeSettings settings;
        settings.tool = "snake-hook";
        settings.radius = 0.4f;
        perform(BeginStroke{settings});
        for (int k = 0; k < 12; ++k)
            perform(AddSamples{{{{{from + 0.05f * static_cast<float>(k), 0, 3}, {0, 0, -1}}, 1, 0}}, 0});
        perform(EndStroke{});
    }
    int settle() {
        int slices = 0;
        for (; worker->settling(); ++slices)
            worker->settleSlice();
        return slices;
    }
    QString hash() const { return QString::fromStdString(worker->document().hash().text()); }
    QString shownHash() const {
        return QString::fromStdString(session::contentHash(shown.surface.tree(), shown.origin).text());
    }
    /// What the record says the model is.
    QString recorded() const {
        session::Document document;
        session::Context context{document, {}, {}, {}, 0, {}, nullptr};
        session::replay(journal(), context);
        return QString::fromStdString(document.hash().text());
    }
};

} // namespace

void SettlingTest::slicesEndAsOneCallDoes() {
    Bench slices, once;
    slices.stroke(), once.stroke();
    QVERIFY(slices.worker->settling());
    QVERIFY(slices.shown.canUndo && slices.shown.modified);
    QCOMPARE(slices.shown.undoLabel, std::string("Snake Hook"));
    QVERIFY(slices.settle() > 1);
    once.perform(SideTask{"", [](const surface::Surface&, const base::Progress&) {}, {}}); // does the rest at once
    QVERIFY(!once.worker->settling());
    // each against its own record, which is replayed at once: a slow machine hands on other pieces of a path
    QCOMPARE(slices.recorded(), slices.hash());
    QCOMPARE(once.recorded(), once.hash());
    QCOMPARE(slices.shownHash(), slices.hash());
}

void SettlingTest::undoIsThereAtOnceAndRedoBringsTheStrokeBack() {
    Bench reference, bench;
    const QString start = bench.hash();
    reference.stroke(), reference.settle();
    bench.stroke();
    bench.worker->settleSlice();
    bench.undo();
    QVERIFY(!bench.worker->settling());
    QCOMPARE(bench.shownHash(), start);
    QVERIFY(bench.shown.canRedo && !bench.shown.canUndo && !bench.shown.modified);
    QCOMPARE(bench.recorded(), start);
    bench.redo();
    QCOMPARE(bench.hash(), reference.hash());
    QCOMPARE(bench.shownHash(), reference.hash());
    bench.undo();
    QCOMPARE(bench.hash(), start);
    bench.redo();
    QCOMPARE(bench.hash(), reference.hash());
    QCOMPARE(bench.recorded(), reference.hash());
}

void SettlingTest::whatIsAskedForNextComesAfterTheStroke() {
    Bench reference, bench;
    reference.stroke(), reference.settle();
    const QString one = reference.hash();
    reference.stroke(-0.5f), reference.settle();
    bench.stroke();
    bench.stroke(-0.5f); // the first one settles before the second begins
    bench.settle();
    QCOMPARE(bench.hash(), reference.hash());
    bench.undo();
    QCOMPARE(bench.hash(), one);
    const std::string file = bench.folder.filePath("saved.ply").toStdString();
    bench.redo();
    bench.stroke(0.3f);
    bench.undo(); // laid aside
    bench.command({{"op", "save"}, {"path", file}});
    QCOMPARE(bench.hash(), reference.hash());
    QVERIFY(bench.shown.canRedo);
    bench.redo();
    QVERIFY(bench.hash() != reference.hash());
    QCOMPARE(bench.recorded(), bench.hash());
}

void SettlingTest::aStrokeAfterAnUndoneOneDropsIt() {
    Bench reference, bench;
    reference.stroke(-0.5f), reference.settle();
    bench.stroke();
    bench.undo();
    bench.stroke(-0.5f);
    bench.settle();
    QCOMPARE(bench.hash(), reference.hash());
    QVERIFY(!bench.shown.canRedo);
    bench.redo(); // there is nothing to do again
    QCOMPARE(bench.hash(), reference.hash());
    QCOMPARE(bench.recorded(), bench.hash());
}

void SettlingTest::everyTaskIsAnsweredOnce() {
    Bench bench;
    for (int k = 0; k < 4; ++k) {
        bench.stroke(0.1f * static_cast<float>(k));
        if (k == 1)
            bench.settle();
        if (k % 2 == 0)
            bench.undo();
        if (k == 2)
            bench.redo();
    }
    bench.perform(BeginStroke{});
    bench.perform(CancelStroke{});
    bench.perform(EndStroke{});
    bench.settle();
    QCOMPARE(bench.answers, bench.asked);
}

static const test::Registered<SettlingTest> registered;
#include "settling_test.moc"
