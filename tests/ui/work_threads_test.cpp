// The threads beside the interface's, without a window: the model's owner publishes versions while the drawing thread
// draws those before. TSan looks here.
#include "support/patience.h"
#include "support/registry.h"
#include "ui/work/editor.h"
#include "ui/work/render_thread.h"

#include <future>
#include <QTest>

using namespace ui;

class WorkThreadsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void versionsAreDrawnWhileAStrokeGoesOn();
    void theTrueSurfaceIsInterrupted();
    void cancelledWorkLeavesTheModel();
    void workIsCancelledWhileItWaits();
};

static Frame frameOf(const Editor& editor) {
    Frame out;
    out.model = editor.snapshot().surface.tree();
    out.camera = render::Camera::looking(out.model.bounds(), 120, 80);
    out.options.splatScale = editor.snapshot().splatScale;
    return out;
}

static bool settled(const Editor& editor) {
    return QTest::qWaitFor([&] { return !editor.busy(); }, test::patience);
}

/// An editor without a journal, of a sphere.
static std::unique_ptr<Editor> sphere() {
    EditorOptions options;
    options.keepJournal = false;
    auto out = std::make_unique<Editor>(options);
    out->run({{"op", "new"}, {"sample", "sphere"}, {"count", 3000}});
    return settled(*out) && out->snapshot().surfels > 0 ? std::move(out) : nullptr;
}

static void stroke(Editor& editor, int samples) {
    sculpt::StrokeSettings settings;
    settings.radius = 0.3f;
    editor.beginStroke(settings);
    for (int k = 0; k < samples; ++k) {
        const float x = 0.8f * static_cast<float>(k) / static_cast<float>(samples) - 0.4f;
        editor.addSample({{{x, 0, 3}, {0, 0, -1}}, 1, 0.01f * static_cast<float>(k)});
    }
    editor.endStroke();
}

void WorkThreadsTest::versionsAreDrawnWhileAStrokeGoesOn() {
    const auto editor = sphere();
    QVERIFY(editor);
    std::atomic<int> pictures = 0, versions = 0;
    RenderThread drawing(std::make_unique<render::CpuSplatter>(),
                         [&](const RenderThread::Result& result) { pictures += result.picture.isNull() ? 0 : 1; });
    QObject::connect(editor.get(), &Editor::changed, editor.get(), [&] {
        ++versions;
        drawing.request(frameOf(*editor));
    });
    const base::Hash128 before = editor->hashWhenDone();
    stroke(*editor, 40);
    QVERIFY(settled(*editor));
    QVERIFY(QTest::qWaitFor([&] { return pictures > 0; }, test::patience));
    QVERIFY(versions > 0 && !(editor->hashWhenDone() == before));
    editor->run({{"op", "undo"}});
    QVERIFY(settled(*editor));
    QVERIFY(editor->hashWhenDone() == before);
    QObject::disconnect(editor.get(), nullptr, nullptr, nullptr);
}

void WorkThreadsTest::theTrueSurfaceIsInterrupted() {
    const auto editor = sphere();
    QVERIFY(editor);
    std::atomic<int> levels = 0;
    RenderThread drawing(std::make_unique<render::CpuSplatter>(),
                         [&](const RenderThread::Result& result) { levels += result.refinement ? 1 : 0; });
    Frame frame = frameOf(*editor);
    frame.truth = TrueSurface{editor->snapshot().surface, 1, {}, {}};
    for (int k = 0; k < 5; ++k) {
        frame.camera.fovDeg += 1;
        drawing.request(frame);
        QTest::qWait(200);
    }
    QVERIFY(QTest::qWaitFor([&] { return levels > 0; }, test::patience));
}

void WorkThreadsTest::cancelledWorkLeavesTheModel() {
    const auto editor = sphere();
    QVERIFY(editor);
    const base::Hash128 before = editor->hashWhenDone();
    QVERIFY(settled(*editor)); // that the hash is done is known here, too: it is not what is cancelled
    stroke(*editor, 40);
    editor->cancelStroke();
    bool done = true;
    editor->run({{"op", "resample"}, {"spacing", 0.01}}, [&](bool success) { done = success; });
    editor->cancelWork();
    QVERIFY(settled(*editor));
    QVERIFY(!done);
    if (!editor->snapshot().canUndo) // the stroke's end may have been faster
        QVERIFY(editor->hashWhenDone() == before);
}

/// Whatever it waits for: here a task that ends when it has been cancelled, too, and a stroke.
void WorkThreadsTest::workIsCancelledWhileItWaits() {
    const auto editor = sphere();
    QVERIFY(editor);
    std::promise<void> cancelled;
    const std::shared_future<void> wait = cancelled.get_future().share();
    std::vector<bool> done;
    const auto note = [&](bool success) { done.push_back(success); };
    editor->runAside({"Waiting", [wait](const surface::Surface&, const base::Progress&) { wait.wait(); }, note});
    stroke(*editor, 40);
    editor->run({{"op", "flip"}}, note);
    editor->cancelWork(); // the task that waits, which does not look
    cancelled.set_value();
    QVERIFY(QTest::qWaitFor([&] { return done.size() == 2; }, test::patience));
    QCOMPARE(done, (std::vector<bool>{true, true}));

    stroke(*editor, 40);
    editor->run({{"op", "resample"}, {"spacing", 0.01}}, note);
    editor->cancelWork();
    editor->run({{"op", "flip"}}, note);
    QVERIFY(settled(*editor));
    QCOMPARE(done, (std::vector<bool>{true, true, false, true}));
}

static const test::Registered<WorkThreadsTest> registered;
#include "work_threads_test.moc"
