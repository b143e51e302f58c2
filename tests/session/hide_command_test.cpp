// What is hidden is neither seen nor met nor moved nor selected, and nothing of it is lost.
#include "core/base/random.h"
#include "core/session/scene/shown_scene.h"
#include "core/surface/rays/intersect.h"
#include "hiding.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d, base::Vec3f;
using test::json;
using test::Workbench;
using test::hiding::hashOfHidden, test::hiding::hiddenIn, test::hiding::makeHidden, test::hiding::parsed,
    test::hiding::selectedIn;

class HideCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everythingComesBack();
    void whatIsChosenIsHidden();
    void raysPassWhatIsHidden();
    void raysMeetNoPinholesInWhatIsShown();
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
    void nonsenseIsRefused();
};

namespace {

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
