// Dialogs of commands beside the picture: what would come is shown and not done, places are clicked, and what is shown
// is what comes.
#include "ui/window/command_desk.h"

#include "support/patience.h"
#include "support/registry.h"
#include "ui/window/command_dialog.h"
#include "ui/window/parameter_values.h"
#include "ui/window_fixture.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QSignalSpy>

using test::WindowFixture;

class CommandDeskTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatIsShownIsWhatComes();
    void closingShowsTheModelAgain();
    void nothingIsShownWhereNobodyWantsIt();
    void strokesGoOnBesideADialog();
    void samplesAreSeenToSpreadBeforeTheyAreAModel();
    void closingEndsTheSpread();
    void errorsAreSeenInColours();
    void onlyWhatIsTakenOutCountsAsGone();
    void aClickGivesADrillPlaceAndDirection();
    void aTubeGoesThroughAllClicks();
    void planesAreThoseThatCutThePicture();
    void placesHaveTheDigitsThatTheModelNeeds();
};

static ui::CommandDesk& deskOf(WindowFixture& f) {
    return *f.window->findChild<ui::CommandDesk*>();
}

static const ui::Snapshot& shownBy(WindowFixture& f) {
    return f.window->sculptView().look().shown();
}

static bool previewed(WindowFixture& f) {
    return QTest::qWaitFor([&] { return f.window->sculptView().look().showsInstead(); }, test::patience);
}

static QString entered(WindowFixture& f, const char* field) {
    return deskOf(f).dialog()->findChild<QLineEdit*>(field)->text();
}

static void click(WindowFixture& f, const QPointF& at) {
    f.press(at);
    f.release(at);
}

void CommandDeskTest::whatIsShownIsWhatComes() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    const base::Hash128 before = f.hash();
    deskOf(f).open(session::command("thin"));
    auto& spacing = *deskOf(f).dialog()->findChild<QLineEdit*>("spacing");
    spacing.setText(QString::number(2 * spacing.text().toDouble()));
    QVERIFY(previewed(f));
    const base::Hash128 shown = shownBy(f).surface.tree().contentHash();
    const std::size_t gone = f.window->sculptView().overlay().gone.size();
    QCOMPARE(gone + shownBy(f).surfels, f.surfels());
    QVERIFY(gone > 1000 && f.hash() == before && !f.editor().snapshot().canUndo);
    deskOf(f).dialog()->accept();
    QVERIFY(f.settle());
    QVERIFY(f.editor().snapshot().surface.tree().contentHash() == shown);
    QVERIFY(!f.window->sculptView().look().showsInstead() && f.window->sculptView().overlay().gone.empty());
    f.window->undo();
    QVERIFY(f.hash() == before);
}

void CommandDeskTest::closingShowsTheModelAgain() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1500));
    deskOf(f).open(session::command("inflate"));
    QVERIFY(previewed(f)); // by the length that is proposed
    deskOf(f).dialog()->reject();
    QVERIFY(!f.window->sculptView().look().showsInstead());
    QVERIFY(shownBy(f).surface.tree() == f.editor().snapshot().surface.tree() && !f.editor().snapshot().canUndo);
    QTRY_VERIFY_WITH_TIMEOUT(!deskOf(f).dialog(), test::patience);
}

void CommandDeskTest::nothingIsShownWhereNobodyWantsIt() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1500));
    f.window->settings().previews = false;
    deskOf(f).open(session::command("inflate"));
    QTest::qWait(2 * ui::CommandDesk::pauseMs);
    QVERIFY(f.settle() && !f.window->sculptView().look().showsInstead());
    deskOf(f).dialog()->setPreviews(true); // kept
    QVERIFY(f.window->settings().previews && previewed(f));
}

void CommandDeskTest::strokesGoOnBesideADialog() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    deskOf(f).open(session::command("inflate"));
    QVERIFY(previewed(f));
    f.drag(f.centre() - QPointF(30, 0), f.centre() + QPointF(30, 0));
    QTRY_VERIFY_WITH_TIMEOUT(!f.editor().busy() && f.editor().snapshot().canUndo, test::patience);
    QVERIFY(previewed(f)); // of the model as it is now
    const base::Hash128 shown = shownBy(f).surface.tree().contentHash();
    deskOf(f).dialog()->accept();
    QVERIFY(f.settle());
    QVERIFY(f.editor().snapshot().surface.tree().contentHash() == shown);
    QCOMPARE(f.editor().snapshot().past.size(), std::size_t(2));
}

/// The dialog of `reduce`, for a tenth; each round is seen so long.
static void reduceToATenth(WindowFixture& f, int roundMs) {
    deskOf(f).preview().setRoundMs(roundMs);
    deskOf(f).open(session::command("reduce"));
    deskOf(f).dialog()->enter("ratio", "0.1");
}

static bool reducedIsShown(WindowFixture& f) {
    return QTest::qWaitFor([&] { return shownBy(f).surfels < f.surfels(); }, test::patience);
}

void CommandDeskTest::samplesAreSeenToSpreadBeforeTheyAreAModel() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1500));
    const base::Hash128 before = f.hash();
    int rounds = 0, right = 0;
    const auto spread = connect(&deskOf(f).preview(), &ui::CommandPreview::spread, this, [&](const ui::Snapshot& s) {
        ++rounds; // on the model, which picks meet
        right += s.whole.size() == f.surfels() + f.surfels() / 10 && s.surface.tree().size() == f.surfels() &&
                 shownBy(f).whole == s.whole;
    });
    reduceToATenth(f, 1);
    QVERIFY(reducedIsShown(f));
    disconnect(spread);
    QVERIFY(rounds >= 10 && right == rounds);
    const base::Hash128 shown = shownBy(f).surface.tree().contentHash();
    QVERIFY(f.hash() == before && !f.editor().snapshot().canUndo);
    deskOf(f).dialog()->accept();
    QVERIFY(f.settle());
    QVERIFY(f.editor().snapshot().surface.tree().contentHash() == shown);
    QCOMPARE(f.editor().snapshot().past.size(), std::size_t(1));
    f.window->undo();
    QVERIFY(f.hash() == before);
}

void CommandDeskTest::closingEndsTheSpread() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1500));
    constexpr int roundMs = 50;
    reduceToATenth(f, roundMs);
    QVERIFY(previewed(f) && shownBy(f).whole.size() > f.surfels());
    deskOf(f).dialog()->reject();
    QVERIFY(!f.window->sculptView().look().showsInstead());
    QTest::qWait(3 * roundMs);
    QVERIFY(!f.window->sculptView().look().showsInstead() && !f.editor().snapshot().canUndo);
}

void CommandDeskTest::errorsAreSeenInColours() {
    WindowFixture f;
    QVERIFY(f.make("torus", 1500));
    const ui::PictureLook& look = f.window->sculptView().look();
    const render::Shading own = look.shading();
    reduceToATenth(f, 0);
    QVERIFY(reducedIsShown(f));
    const tree::SurfelTree after = shownBy(f).surface.tree();
    auto& error = *deskOf(f).dialog()->findChild<QCheckBox*>("errorColours");
    error.setChecked(true);
    QVERIFY(look.shading() == render::Shading::Deviation && shownBy(f).reference.tree() == after);
    QVERIFY(shownBy(f).surface.tree() == f.editor().snapshot().surface.tree());
    QTRY_VERIFY_WITH_TIMEOUT(look.scale(), test::patience);
    error.setChecked(false);
    QVERIFY(look.shading() == own && shownBy(f).surface.tree() == after);
    error.setChecked(true);
    deskOf(f).dialog()->reject();
    QVERIFY(look.shading() == own && !look.showsInstead());
    deskOf(f).open(session::command("inflate")); // which is to move the surface
    QVERIFY(!deskOf(f).dialog()->findChild<QCheckBox*>("errorColours"));
}

void CommandDeskTest::onlyWhatIsTakenOutCountsAsGone() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    const tree::SurfelTree before = f.editor().snapshot().surface.tree();
    surfel::SurfelList fewer = before.surfels();
    fewer.items.resize(700);
    const tree::SurfelTree part = tree::SurfelTree::build(fewer);
    QCOMPARE(ui::goneFrom(before, part, 1000).size(), std::size_t(300));
    QVERIFY(ui::goneFrom(before, part, 100).size() <= 100 && !ui::goneFrom(before, part, 100).empty());
    QVERIFY(ui::goneFrom(before, before, 1000).empty() && ui::goneFrom(part, before, 1000).empty());
    fewer.items[5].position.x += 0.01f; // moved, not taken out
    QVERIFY(ui::goneFrom(before, tree::SurfelTree::build(fewer), 1000).empty());
}

void CommandDeskTest::aClickGivesADrillPlaceAndDirection() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const std::size_t before = f.surfels();
    deskOf(f).open(session::command("drill"));
    QVERIFY(f.window->sculptView().picker().on()); // what is lacking is asked for
    click(f, f.centre());
    QVERIFY(!f.window->sculptView().picker().on() && !entered(f, "from").isEmpty());
    QVERIFY(!f.editor().snapshot().canUndo); // and was no dab
    const nlohmann::json command = deskOf(f).dialog()->command();
    const QStringList from = QString::fromStdString(command["from"]).split(','),
                      into = QString::fromStdString(command["direction"]).split(',');
    double along = 0;
    for (int k = 0; k < 3; ++k)
        along += from[k].toDouble() * into[k].toDouble();
    QVERIFY2(along < -0.99, qPrintable(QString::number(along))); // straight to the ball's middle, from outside
    deskOf(f).dialog()->accept();
    QVERIFY(f.settle());
    QCOMPARE(f.editor().snapshot().undoLabel, std::string("Drill"));
    QVERIFY(f.surfels() != before);
}

void CommandDeskTest::aTubeGoesThroughAllClicks() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    deskOf(f).open(session::command("tube"));
    for (const double x : {-60.0, 0.0, 60.0})
        click(f, f.centre() + QPointF(x, x));
    QVERIFY(deskOf(f).dialog()->command()["along"].size() == 3);
    f.window->escape();
    QVERIFY(!f.window->sculptView().picker().on() && deskOf(f).dialog());
    QVERIFY(previewed(f));
}

void CommandDeskTest::planesAreThoseThatCutThePicture() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    ui::Cuts cuts;
    cuts.each[2].on = true, cuts.each[2].offset = 0.25;
    f.window->sculptView().cuts().set(cuts);
    deskOf(f).open(session::command("cut"));
    QCOMPARE(entered(f, "plane"), QString("0,0,-1,-0.25")); // below z = 0.25, as in the picture
    f.window->sculptView().cuts().reset();
    deskOf(f).open(session::command("mirror"));
    QVERIFY2(entered(f, "plane").startsWith("1,0,0,"), qPrintable(entered(f, "plane")));
}

void CommandDeskTest::placesHaveTheDigitsThatTheModelNeeds() {
    const base::Vec3d place{400123.12345678, -1e-9, 0.5};
    QCOMPARE(ui::textOf(place, 1), QString("400123.12346, 0, 0.5"));
    QCOMPARE(ui::textOf(place, 900), QString("400123.123, 0, 0.5"));

    QCOMPARE(ui::textOf(place, 0), ui::textOf(place, 1)); // of a point
}

static const test::Registered<CommandDeskTest> registered;
#include "command_desk_test.moc"
