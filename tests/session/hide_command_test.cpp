// What is hidden is neither seen nor met nor moved nor selected, and nothing of it is lost.
#include "core/base/random.h"
#include "core/selection/hidden.h"
#include "core/session/live_stroke.h"
#include "core/session/scene/shown_scene.h"
#include "core/surface/rays/intersect.h"
#include "random_strokes.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"
#include "workbench.h"

#include <QTest>

using base::Vec3d, base::Vec3f;
using test::json;
using test::Workbench;

class HideCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everythingComesBack();
    void whatIsChosenIsHidden();
    void raysPassWhatIsHidden();
    void raysMeetNoPinholesInWhatIsShown();
    void strokesLeaveWhatIsHidden_data();
    void strokesLeaveWhatIsHidden();
    void strokesOnWhatIsShownAreThoseOnItAlone();
    void strokesUndoReplayAndDependOnNoThreads();
    void strokesOnLayersLeaveWhatIsHidden();
    void waysTakeNothingHiddenUnlessAsked();
    void piecesEndAtWhatIsHidden();
    void changesOfShapeLeaveWhatIsHidden();
    void wholeModelsMoveWithWhatIsHidden();
    void keptAndDeletedPartsSpareWhatIsHidden();
    void whatIsHiddenIsShownWhereNothingElseIsLeft();
    void filesKeepWhatIsHidden();
    void modelsBesideShowNoHiddenParts();
    void commandsSpareWhatIsHiddenOrSayThatTheyDoNot_data();
    void commandsSpareWhatIsHiddenOrSayThatTheyDoNot();
    void stepsBesideWhatIsHiddenAreTold();
    void nonsenseIsRefused();
};

namespace {

json parsed(const char* text) {
    return json::parse(text);
}

/// The sphere's right half hidden.
void makeHidden(Workbench& bench, int count = 3000) {
    bench.run(test::newSphere(count));
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[1,0,0,0.1]})"));
    bench.run(parsed(R"({"op":"hide"})"));
}

std::size_t hiddenIn(const Workbench& bench) {
    return sizeOf(selection::selectedIn(bench.document.surface().tree(), selection::Field::Hidden));
}

std::size_t selectedIn(const Workbench& bench) {
    return sizeOf(selection::selectedIn(bench.document.surface().tree()));
}

/// Order-free hash of the surfels that are hidden.
base::Hash128 hashOfHidden(const surface::Surface& surface) {
    const tree::SurfelTree& tree = surface.tree();
    surfel::SurfelList list;
    list.layout = tree.layout();
    std::vector<std::uint32_t> words(list.layout->words());
    const int channel = selection::channelOf(*list.layout, selection::Field::Hidden);
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (selection::valueAt(block, channel, slot) >= selection::half) {
                block.extra(slot, words);
                list.append(block.surfel(slot), words);
            }
    });
    return tree::SurfelTree::build(list).contentHash();
}

/// Does a ray from outside meet the sphere's near side at `d`?
bool meetsNear(const surface::Surface& surface, const Vec3d& d) {
    const std::vector<base::Rayf> rays{{base::cast<float>(d * 2.0), base::cast<float>(-d)}};
    std::vector<surface::RayHit<float>> hits(1);
    surface::intersect(surface, rays, {}, hits);
    return hits[0].hit && hits[0].t < 1.5f;
}

} // namespace

void HideCommandTest::everythingComesBack() {
    Workbench bench;
    test::makeWorkpiece(bench);
    const std::string bare = bench.hash();
    bench.run(parsed(R"({"op":"mask","do":"curvature","to":4})"));
    const std::string before = bench.hash();
    bench.run(parsed(R"({"op":"hide","what":"mask"})"));
    QVERIFY(hiddenIn(bench) > 50);
    QVERIFY(bench.hash() != before);
    bench.run(parsed(R"({"op":"show"})"));
    QCOMPARE(bench.hash(), before); // the attribute is gone, too
    bench.run({{"op", "undo"}});
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), before);
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), bare);
}

void HideCommandTest::whatIsChosenIsHidden() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[1,0,0,0]})"));
    const std::size_t right = selectedIn(bench), all = bench.size();
    bench.run(parsed(R"({"op":"hide"})"));
    QCOMPARE(hiddenIn(bench), right);
    QCOMPARE(selectedIn(bench), std::size_t(0));
    bench.run(parsed(R"({"op":"hide","what":"swap"})"));
    QCOMPARE(hiddenIn(bench), all - right);
    bench.run(parsed(R"({"op":"show"})"));
    QCOMPARE(hiddenIn(bench), std::size_t(0));
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[0,1,0,0.5]})"));
    const std::size_t top = selectedIn(bench);
    bench.run(parsed(R"({"op":"hide","what":"rest"})"));
    QCOMPARE(hiddenIn(bench), all - top);
    QCOMPARE(selectedIn(bench), top);
    QCOMPARE(bench.size(), all);
    QCOMPARE(selection::shownOf(bench.document.surface()).tree().size(), top);
}

void HideCommandTest::raysPassWhatIsHidden() {
    Workbench bench;
    makeHidden(bench);
    const surface::Surface shown = selection::shownOf(bench.document.surface());
    QVERIFY(std::isfinite(shown.definition().boundaryLimit));
    base::Random random(7);
    for (int i = 0; i < 200; ++i) {
        const Vec3d d = normalized(Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
        if (std::abs(d.x - 0.1) < 0.15) // its end
            continue;
        QVERIFY(meetsNear(bench.document.surface(), d));
        QCOMPARE(meetsNear(shown, d), d.x < 0.1);
    }
}

/// Points drawn by chance, whose gaps are closed by closed models' lack of a limit, get no holes by what is hidden.
void HideCommandTest::raysMeetNoPinholesInWhatIsShown() {
    Workbench bench;
    base::Random random(11);
    std::ostringstream out;
    out << "ply\nformat ascii 1.0\nelement vertex 4000\nproperty float x\nproperty float y\nproperty float z\n"
           "property float nx\nproperty float ny\nproperty float nz\nend_header\n";
    for (int i = 0; i < 4000; ++i) {
        const double z = random.uniform(-1, 1), r = std::sqrt(1 - z * z), a = random.uniform(0, 6.283185307);
        const Vec3d n{r * std::cos(a), r * std::sin(a), z};
        out << n.x << ' ' << n.y << ' ' << n.z << ' ' << n.x << ' ' << n.y << ' ' << n.z << '\n';
    }
    bench.run({{"op", "open"}, {"path", test::write(bench.path("chance.ply"), out.str()).string()}});
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[0,0,1,0.5]})"));
    bench.run(parsed(R"({"op":"hide"})"));
    const surface::Surface shown = selection::shownOf(bench.document.surface());
    int lost = 0;
    for (int i = 0; i < 1000; ++i) {
        const double z = random.uniform(-1, 0.3), r = std::sqrt(1 - z * z), a = random.uniform(0, 6.283185307);
        lost += !meetsNear(shown, {r * std::cos(a), r * std::sin(a), z});
    }
    QVERIFY2(lost <= 2, qPrintable(QString::number(lost)));
}

void HideCommandTest::strokesLeaveWhatIsHidden_data() {
    QTest::addColumn<QString>("tool");
    for (const sculpt::ToolRow& row : sculpt::toolTable())
        if (!row.needs.layer)
            QTest::newRow(row.id) << row.id;
}

/// By strokes that run over its end.
void HideCommandTest::strokesLeaveWhatIsHidden() {
    QFETCH(QString, tool);
    Workbench bench;
    makeHidden(bench);
    bench.run(test::strokeAt(0, "paint")); // something to smear
    const base::Hash128 before = hashOfHidden(bench.document.surface());
    const std::size_t count = hiddenIn(bench), size = bench.size();
    const std::string hash = bench.hash();
    bench.run(test::strokeAt(0.1, tool.toStdString()));
    QCOMPARE(hiddenIn(bench), count);
    QVERIFY(hashOfHidden(bench.document.surface()) == before);
    QVERIFY(bench.hash() != hash);
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), hash);
    QCOMPARE(bench.size(), size);
}

void HideCommandTest::strokesOnWhatIsShownAreThoseOnItAlone() {
    Workbench bench;
    makeHidden(bench);
    const surface::Surface shown = selection::shownOf(bench.document.surface());
    session::Document alone = bench.document;
    alone.commit(shown, "Shown");
    session::Context other{alone, {}, {}, {}, 0, {}, nullptr};
    for (const double y : {0.1, 0.3}) {
        bench.run(test::strokeAt(y));
        session::run(other, test::strokeAt(y));
        const surface::Surface now = selection::shownOf(bench.document.surface());
        QCOMPARE(now.tree().size(), alone.surface().tree().size());
        QVERIFY(y > 0.2 || now.tree().contentHash() == alone.surface().tree().contentHash());
    }
}

void HideCommandTest::strokesUndoReplayAndDependOnNoThreads() {
    const std::uint64_t seed = test::seed();
    const auto made = [&](Workbench& bench) {
        session::Journal journal(bench.path("j.jsonl"));
        bench.context.journal = &journal;
        makeHidden(bench, 6000);
        base::Random random(seed);
        test::RandomStrokes strokes(bench.document, random);
        std::vector<std::string> hashes{bench.hash()};
        for (int k = 0; k < (test::sanitized ? 4 : 12); ++k) {
            bench.run(strokes.next());
            hashes.push_back(bench.hash());
        }
        bench.context.journal = nullptr;
        return hashes;
    };
    Workbench one, two;
    const std::vector<std::string> hashes = test::onThreads(1, [&] { return made(one); });
    QCOMPARE(test::onThreads(2, [&] { return made(two); }), hashes);
    Workbench again;
    session::recover(one.path("j.jsonl"), again.context);
    QVERIFY2(again.hash() == hashes.back(), qPrintable(QString("seed %1").arg(seed)));
    while (one.document.undoLabel() != std::string("Hide"))
        one.run({{"op", "undo"}});
    QCOMPARE(one.hash(), hashes.front());
}

void HideCommandTest::strokesOnLayersLeaveWhatIsHidden() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"layer","do":"add","name":"a"})"));
    bench.run(test::strokeAt(0.2));
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[1,0,0,0.1]})"));
    bench.run(parsed(R"({"op":"hide"})"));
    const base::Hash128 before = hashOfHidden(bench.document.surface());
    bench.run(test::strokeAt(-0.1));
    QVERIFY(hashOfHidden(bench.document.surface()) == before);
    bench.run(parsed(R"({"op":"layer","do":"strength","name":"a","strength":0})")); // of all of the model
    QVERIFY(!(hashOfHidden(bench.document.surface()) == before));
    float most = 0;
    bench.document.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            most = std::max(most, std::abs(length(block.position(slot)) - 1));
    });
    QVERIFY2(most < 0.01f, qPrintable(QString::number(most)));
}

void HideCommandTest::waysTakeNothingHiddenUnlessAsked() {
    Workbench bench;
    makeHidden(bench);
    const std::size_t all = bench.size(), gone = hiddenIn(bench);
    for (const char* line :
         {R"({"op":"select","by":"all"})", R"({"op":"selection","do":"grow","length":0.3})",
          R"({"op":"selection","do":"border"})", R"({"op":"select","by":"none"})",
          R"({"op":"selection","do":"invert"})", R"({"op":"select","by":"ball","at":[0,0,1],"radius":0.6})",
          R"({"op":"select","by":"view","eye":[0,0,9],"target":[0,0,0],"visible":true,
                                 "rectangle":[-9999,-9999,9999,9999]})"}) {
        bench.run(parsed(line));
        std::size_t both = 0;
        const tree::SurfelTree& tree = bench.document.surface().tree();
        const int chosen = selection::channelOf(*tree.layout(), selection::Field::Selection),
                  hidden = selection::channelOf(*tree.layout(), selection::Field::Hidden);
        tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                both += selection::valueAt(block, chosen, slot) > 0 && selection::valueAt(block, hidden, slot) > 0;
        });
        QVERIFY2(both == 0, line);
    }
    bench.run(parsed(R"({"op":"select","by":"all"})"));
    QCOMPARE(selectedIn(bench), all - gone);
    bench.run(parsed(R"({"op":"select","by":"all","hidden":true})"));
    QCOMPARE(selectedIn(bench), all);
    // through what is hidden the camera sees the far side's inside
    bench.run(parsed(R"({"op":"select","by":"view","eye":[9,0,0],"target":[0,0,0],"up":[0,1,0],"visible":true,
                         "rectangle":[-9999,-9999,9999,9999]})"));
    QVERIFY(selectedIn(bench) > (all - gone) / 2);
}

void HideCommandTest::piecesEndAtWhatIsHidden() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"select","by":"box","least":[-2,-2,-0.3],"most":[2,2,0.3]})"));
    bench.run(parsed(R"({"op":"hide"})"));
    bench.run(parsed(R"({"op":"select","by":"piece","at":[0,0,1]})"));
    const std::size_t top = selectedIn(bench);
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[0,0,1,0]})"));
    QCOMPARE(top, selectedIn(bench));
    bench.run(parsed(R"({"op":"select","by":"piece","at":[1,0,0.25]})")); // the nearest that is shown
    QCOMPARE(top, selectedIn(bench));
    bench.run(parsed(R"({"op":"select","by":"piece","at":[0,0,1],"hidden":true})"));
    QCOMPARE(selectedIn(bench), bench.size());
}

void HideCommandTest::changesOfShapeLeaveWhatIsHidden() {
    for (const char* line : {R"({"op":"inflate","length":0.05})", R"({"op":"smooth","scale":3})",
                             R"({"op":"noise","amplitude":0.05,"size":0.3})", R"({"op":"sharpen"})"}) {
        Workbench bench;
        makeHidden(bench);
        const base::Hash128 before = hashOfHidden(bench.document.surface());
        const std::string hash = bench.hash();
        bench.run(parsed(line));
        QVERIFY(bench.hash() != hash);
        QVERIFY2(hashOfHidden(bench.document.surface()) == before, line);
    }
}

void HideCommandTest::wholeModelsMoveWithWhatIsHidden() {
    Workbench bench;
    makeHidden(bench);
    const std::size_t count = hiddenIn(bench);
    bench.run(parsed(R"({"op":"transform","move":[0,3,0]})"));
    QVERIFY(bench.document.surface().tree().bounds().lo.y > 1.9f);
    QCOMPARE(hiddenIn(bench), count);
    bench.run(parsed(R"({"op":"resample","count":5000})"));
    const std::size_t now = hiddenIn(bench);
    const double before = double(count) / 3000, after = double(now) / double(bench.size());
    QVERIFY2(std::abs(before - after) < 0.03, qPrintable(QString::number(after)));
}

void HideCommandTest::keptAndDeletedPartsSpareWhatIsHidden() {
    Workbench bench;
    makeHidden(bench);
    const std::size_t gone = hiddenIn(bench);
    const base::Hash128 before = hashOfHidden(bench.document.surface());
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[0,1,0,0.5]})"));
    const std::size_t chosen = selectedIn(bench);
    bench.run(parsed(R"({"op":"keep"})"));
    QCOMPARE(bench.size(), gone + chosen);
    QVERIFY(hashOfHidden(bench.document.surface()) == before);
    bench.run({{"op", "undo"}});
    const std::size_t all = bench.size();
    bench.run(parsed(R"({"op":"delete"})"));
    QCOMPARE(bench.size(), all - chosen);
    QVERIFY(hashOfHidden(bench.document.surface()) == before);
}

/// There would be nothing to be seen.
void HideCommandTest::whatIsHiddenIsShownWhereNothingElseIsLeft() {
    Workbench bench;
    makeHidden(bench);
    const std::size_t gone = hiddenIn(bench);
    bench.run(parsed(R"({"op":"select","by":"all"})"));
    bench.run(parsed(R"({"op":"delete"})"));
    QCOMPARE(bench.size(), gone);
    QCOMPARE(hiddenIn(bench), std::size_t(0));
}

void HideCommandTest::filesKeepWhatIsHidden() {
    Workbench bench;
    makeHidden(bench);
    bench.run({{"op", "save"}, {"path", bench.path("part.ply").string()}});
    Workbench other;
    other.run({{"op", "open"}, {"path", bench.path("part.ply").string()}});
    QCOMPARE(other.hash(), bench.hash());
    QCOMPARE(hiddenIn(other), hiddenIn(bench));
    bench.run(test::strokeAt(0.1));
    other.run(test::strokeAt(0.1));
    QCOMPARE(other.hash(), bench.hash());
}

void HideCommandTest::modelsBesideShowNoHiddenParts() {
    Workbench bench;
    makeHidden(bench);
    const std::size_t shown = bench.size() - hiddenIn(bench);
    bench.run(parsed(R"({"op":"scene","do":"duplicate"})"));
    session::ShownScene scene;
    const std::vector<session::ShownModel>& beside = scene.beside(bench.document.scene());
    QCOMPARE(beside.size(), std::size_t(1));
    QCOMPARE(beside[0].surface.tree().size(), shown);
}

void HideCommandTest::commandsSpareWhatIsHiddenOrSayThatTheyDoNot_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("meets");
    for (const char* line :
         {R"({"op":"cut","plane":"-1,0,0,-0.5"})",
          R"({"op":"drill","from":"2,0,0","direction":"-1,0,0","radius":0.3,"depth":1.5})",
          R"({"op":"primitive","shape":"ball","size":"0.6","position":"1,0,0"})",
          R"({"op":"mirror","plane":"0,1,0,0"})", R"({"op":"resample","count":2000})", R"({"op":"flip"})",
          R"({"op":"transform","move":[0,0,1]})", R"({"op":"tube","along":[[0.8,0,0],[2,0,0]],"radius":0.1})",
          R"({"op":"colour","colour":[255,0,0]})", R"({"op":"mask","do":"invert"})",
          R"({"op":"mask","do":"curvature","to":0.5})", R"({"op":"inflate","length":0.05})",
          R"({"op":"smooth","scale":3})", R"({"op":"sharpen"})", R"({"op":"noise","amplitude":0.05,"size":0.3})",
          R"({"op":"select","by":"all"})", R"({"op":"show"})"})
        QTest::newRow(line) << line << true;
    // far from what is hidden, and beneath it
    for (const char* line : {R"({"op":"cut","plane":"1,0,0,-0.5"})", R"({"op":"hollow","thickness":0.2})"})
        QTest::newRow(line) << line << false;
}

/// The row says which; none does it without a word.
void HideCommandTest::commandsSpareWhatIsHiddenOrSayThatTheyDoNot() {
    QFETCH(QString, line);
    QFETCH(bool, meets);
    const json command = parsed(line.toUtf8().constData());
    Workbench bench;
    makeHidden(bench);
    const tree::SurfelTree before = bench.document.surface().tree();
    const base::Hash128 hidden = hashOfHidden(bench.document.surface());
    bench.context.messages.clear();
    bench.run(command);
    const tree::SurfelTree after = bench.document.surface().tree();
    QVERIFY(!(before == after));
    const std::size_t changed = selection::hiddenChanged(before, after);
    const bool told = std::ranges::any_of(bench.context.messages, [&](const std::string& each) {
        return each.find(std::to_string(changed) + " hidden surfels changed") != std::string::npos;
    });
    QCOMPARE(told, changed > 0);
    if (session::command(command["op"].get<std::string>()).hidden == session::HiddenParts::Spared)
        QVERIFY(changed == 0 && (command["op"] == "show" || command["op"] == "select" ||
                                 hashOfHidden(bench.document.surface()) == hidden));
    else
        QCOMPARE(changed > 0, meets);
}

void HideCommandTest::stepsBesideWhatIsHiddenAreTold() {
    const auto toldBy = [](Workbench& bench, const char* tool, double x) {
        bench.context.messages.clear();
        json samples = json::array();
        for (int k = 0; k < 8; ++k)
            samples.push_back({x, 0.1 * k - 0.4, 5.0, 0.0, 0.0, -1.0, 1.0, 0.02 * k});
        bench.run({{"op", "stroke"}, {"tool", tool}, {"radius", 0.25}, {"strength", 1}, {"samples", samples}});
        return std::ranges::any_of(bench.context.messages,
                                   [](const std::string& each) { return each.find("A step of") != std::string::npos; });
    };
    for (const double x : {0.0, -0.5}) { // the end is at 0.1
        Workbench bench;
        makeHidden(bench);
        QCOMPARE(toldBy(bench, "draw", x), x == 0);
    }
    // an edge is no step, and colours make none
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"cut","plane":"-1,0,0,-0.5","cap":true})"));
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[1,0,0,0.49]})"));
    bench.run(parsed(R"({"op":"hide"})"));
    QVERIFY(hiddenIn(bench) > 100);
    const std::string before = bench.hash();
    QVERIFY(!toldBy(bench, "paint", 0.4));
    QVERIFY(bench.hash() != before);
}

void HideCommandTest::nonsenseIsRefused() {
    Workbench bench;
    QVERIFY(bench.refusal({{"op", "hide"}}).find("no model") != std::string::npos);
    bench.run(test::newSphere());
    QVERIFY(bench.refusal({{"op", "hide"}}).find("nothing is selected") != std::string::npos);
    bench.run(parsed(R"({"op":"select","by":"all"})"));
    QVERIFY(bench.refusal({{"op", "hide"}}).find("next to nothing") != std::string::npos);
    QVERIFY(bench.refusal({{"op", "hide"}, {"what", "swap"}}).find("next to nothing") != std::string::npos);
    bench.run(parsed(R"({"op":"select","by":"plane","plane":[1,0,0,0]})"));
    bench.run({{"op", "hide"}});
    json stroke = test::strokeAt(0, "crease");
    stroke["edge"] = 1;
    QVERIFY(bench.refusal(stroke).find("hidden") != std::string::npos);
    const std::string hash = bench.hash();
    bench.run({{"op", "show"}});
    bench.run({{"op", "show"}}); // nothing to show: no step
    bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), hash);
}

static const test::Registered<HideCommandTest> registered;
#include "hide_command_test.moc"
