// Layers as commands: what strokes did on them shows in any strength.
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "layered.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d, base::Vec3f;
using test::Workbench, test::json;
using namespace test::layered;

class LayerCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void anyStrengthIsThatPartOfWhatWasSculpted();
    void normalsOfAnyStrengthAreThoseOfTheShape();
    void strengthZeroIsTheSurfaceBelowAlsoWhereItWasResampled();
    void sculptedFormComesBackBitForBit();
    void removingIsStrengthZeroAndDropping();
    void independentPlacesMayBeSculptedInAnyOrder();
    void layersAboveGoAlongWithTheSurfaceBelow();
    void strokesBelowOthersShowAsAnywhere();
    void mergingShowsTheSame();
    void resamplingCarriesLayersAlong();
    void ownMasksHideInParts();
    void whatIsHiddenInPartDoesNotPileUp();
    void mapsOfTheWholeMapEachLayer();
    void shapesOfTheWholeGoIntoTheActiveLayer();
    void threadsDoNotShow();
};

void LayerCommandTest::anyStrengthIsThatPartOfWhatWasSculpted() {
    Workbench bench;
    bench.run(test::newSphere());
    const surfel::SurfelList before = surfels(bench);
    bench.run(layer("add"));
    for (const char* tool : {"draw", "grab", "clay", "smooth", "inflate"})
        bench.run(stroke(tool, 0, false));
    const surfel::SurfelList sculpted = surfels(bench);
    QVERIFY(farthest(before, sculpted) > 0.1);
    QVERIFY(isWhole(bench));
    for (const double part : {0.0, 0.5, -1.0, 2.0, 0.3, 1.0}) {
        bench.run(strength(part));
        const surfel::SurfelList shown = surfels(bench);
        double off = 0, turned = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const Vec3d from = base::cast<double>(before.items[i].position),
                        by = base::cast<double>(sculpted.items[i].position) - from;
            off = std::max(off, distance(base::cast<double>(shown.items[i].position), from + by * part));
            turned = std::max(turned, std::abs(double(length(shown.items[i].normal)) - 1));
        }
        QVERIFY2(off < rounding * 2, qPrintable(QString::number(off)));
        QVERIFY(turned < 1e-5);
        QVERIFY(isWhole(bench));
    }
    bench.run(strength(0));
    const surfel::SurfelList base = surfels(bench);
    for (std::size_t i = 0; i < base.size(); ++i)
        QVERIFY(base.items[i] == before.items[i]);
}

void LayerCommandTest::normalsOfAnyStrengthAreThoseOfTheShape() {
    constexpr int rows = 80;
    constexpr double step = 0.02;
    Workbench bench;
    std::ostringstream plane;
    plane << "ply\nformat ascii 1.0\nelement vertex " << rows * rows
          << "\nproperty float x\nproperty float y\nproperty float z\n"
             "property float nx\nproperty float ny\nproperty float nz\nend_header\n";
    for (int i = 0; i < rows * rows; ++i)
        plane << step * (i % rows - rows / 2) << ' ' << step * (i / rows - rows / 2) << " 0 0 0 1\n";
    bench.run({{"op", "open"}, {"path", test::write(bench.path("plane.ply"), plane.str()).string()}});
    std::map<std::pair<long, long>, std::size_t> at; // lattice to slot
    const surfel::SurfelList flat = surfels(bench);
    for (std::size_t i = 0; i < flat.size(); ++i)
        at[{std::lround(double(flat.items[i].position.x) / step),
            std::lround(double(flat.items[i].position.y) / step)}] = i;
    bench.run(layer("add"));
    bench.run(stroke("draw", 0, false, 0.35));
    bench.run(stroke("clay", 0.2, false, 0.3));
    const auto error = [&](double part, double& steepest) {
        bench.run(strength(part));
        const surfel::SurfelList shown = surfels(bench);
        const auto place = [&](long x, long y) { return base::cast<double>(shown.items[at.at({x, y})].position); };
        double out = 0;
        for (long x = 2 - rows / 2; x < rows / 2 - 2; ++x)
            for (long y = 2 - rows / 2; y < rows / 2 - 2; ++y) {
                const Vec3d n = normalized(cross(place(x + 1, y) - place(x - 1, y), place(x, y + 1) - place(x, y - 1)));
                out = std::max(out, distance(base::cast<double>(shown.items[at.at({x, y})].normal), n));
                steepest = std::max(steepest, std::acos(n.z));
            }
        return out;
    };
    double steepest = 0;
    const double own = error(1, steepest);
    for (const double part : {0.5, 2.0, -1.0}) {
        const double off = error(part, steepest);
        qInfo("strength %.1f: normals %.4f off, at 1 %.4f, steepest %.2f rad", part, off, own, steepest);
        QVERIFY(off < (part > 0 && part < 1 ? 1.5 * own : 0.1)); // beyond it is extrapolated
    }
    QVERIFY(steepest > 0.5);
}

void LayerCommandTest::strengthZeroIsTheSurfaceBelowAlsoWhereItWasResampled() {
    for (const char* tool : {"draw", "grab", "snake-hook", "clay"}) {
        Workbench bench;
        bench.run(test::newSphere());
        const std::size_t count = bench.size();
        bench.run(layer("add"));
        bench.run(stroke(tool, 0, true, 0.4));
        bench.run(stroke("draw", 0.1, true, 0.25));
        const double relief = offSphere(surfels(bench)), s = spacing(bench);
        QVERIFY(isWhole(bench));
        const surfel::SurfelList sculpted = surfels(bench);
        bench.run(strength(0));
        const double left = offSphere(surfels(bench)), moved = farthest(sculpted, surfels(bench));
        qInfo("%s: %zu -> %zu surfels, moved by %.3f, relief %.3f, left of it %.5f, spacing %.4f", tool, count,
              bench.size(), moved, relief, left, s);
        QVERIFY(relief > 0.05);
        QVERIFY(left < 0.05 * s + 0.04 * moved);
    }
}

void LayerCommandTest::sculptedFormComesBackBitForBit() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(layer("add"));
    bench.run(stroke("draw", 0, true));
    bench.run(layer("add"));
    bench.run(stroke("snake-hook", 0.1, true));
    const std::string sculpted = bench.hash();
    for (const double part : {0.2, 2.0, -0.7, 1.0})
        bench.run(strength(part));
    QCOMPARE(bench.hash(), sculpted);
    bench.run(layer("hide", {{"name", "Layer 1"}}));
    QVERIFY(bench.hash() != sculpted);
    bench.run(layer("show", {{"name", "Layer 1"}}));
    QCOMPARE(bench.hash(), sculpted);
    bench.run(layer("move", {{"place", 1}}));
    QVERIFY(bench.hash() != sculpted);
    bench.run(layer("move", {{"place", 2}}));
    QCOMPARE(bench.hash(), sculpted);
}

void LayerCommandTest::removingIsStrengthZeroAndDropping() {
    Workbench bench;
    bench.run(test::newSphere());
    const std::string before = bench.hash();
    bench.run(layer("add", {{"name", "one"}}));
    bench.run(stroke("draw", 0, false));
    const std::string one = bench.hash();
    bench.run(layer("add", {{"name", "two"}}));
    bench.run(stroke("clay", 0.05, false));
    bench.run(layer("remove"));
    QCOMPARE(bench.hash(), one);
    bench.run(layer("remove"));
    QCOMPARE(bench.hash(), before);
    QVERIFY(bench.document.layers().empty());
}

void LayerCommandTest::independentPlacesMayBeSculptedInAnyOrder() {
    std::string hash[2];
    for (int order = 0; order < 2; ++order) {
        Workbench bench;
        bench.run(test::newSphere());
        bench.run(layer("add", {{"name", "a"}}));
        bench.run(layer("add", {{"name", "b"}}));
        for (int k = 0; k < 2; ++k) {
            const bool first = k == order;
            bench.run(layer("activate", {{"name", first ? "a" : "b"}}));
            bench.run(stroke(first ? "draw" : "clay", first ? 0.6 : -0.6, false, 0.2));
        }
        bench.run(layer("base"));
        bench.run(layer("strength", {{"name", order == 0 ? "a" : "b"}, {"strength", order == 0 ? 0.4 : 1.5}}));
        bench.run(layer("strength", {{"name", order == 0 ? "b" : "a"}, {"strength", order == 0 ? 1.5 : 0.4}}));
        hash[order] = bench.hash();
    }
    QCOMPARE(hash[0], hash[1]);
}

void LayerCommandTest::layersAboveGoAlongWithTheSurfaceBelow() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(layer("add", {{"name", "form"}}));
    bench.run(stroke("grab", 0, false, 0.5));
    const surfel::SurfelList form = surfels(bench);
    bench.run(layer("add", {{"name", "detail"}}));
    bench.run(stroke("draw", 0, false, 0.15));
    const surfel::SurfelList both = surfels(bench);
    bench.run(layer("hide", {{"name", "form"}}));
    const surfel::SurfelList detail = surfels(bench);
    bench.run(layer("hide", {{"name", "detail"}}));
    const surfel::SurfelList base = surfels(bench);
    double most = 0;
    for (std::size_t i = 0; i < base.size(); ++i) {
        const Vec3f on = both.items[i].position - form.items[i].position,
                    alone = detail.items[i].position - base.items[i].position;
        QVERIFY(std::abs(length(on) - length(alone)) < 1e-5f);                                       // as far
        QVERIFY(std::abs(dot(on, form.items[i].normal) - dot(alone, base.items[i].normal)) < 1e-4f); // and as steep
        most = std::max(most, double(length(on)));
    }
    QVERIFY(most > 0.01);
    QVERIFY(isWhole(bench));
}

void LayerCommandTest::strokesBelowOthersShowAsAnywhere() {
    for (const char* tool : {"draw", "grab", "smooth"}) {
        Workbench layered, plain;
        for (Workbench* bench : {&layered, &plain}) {
            bench->run(test::newSphere());
            bench->run(layer("add"));
            bench->run(stroke("draw", 0, false, 0.4));
            bench->run(layer("add"));
            bench->run(stroke("clay", 0.05, false, 0.3));
            bench->run(strength(0.6));
        }
        plain.run(layer("merge"));
        plain.run(layer("merge"));
        QVERIFY(plain.document.layers().empty());
        layered.run(layer("activate", {{"name", "Layer 1"}}));
        const surfel::SurfelList before = surfels(layered);
        for (Workbench* bench : {&layered, &plain})
            bench->run(stroke(tool, -0.05, false, 0.35));
        QVERIFY2(farthest(before, surfels(layered)) > 1e-3, tool);
        const double off = farthest(surfels(layered), surfels(plain));
        QVERIFY2(off < 1e-4, qPrintable(tool + QString(" %1").arg(off)));
        QVERIFY(isWhole(layered));
    }
}

void LayerCommandTest::mergingShowsTheSame() {
    Workbench bench;
    bench.run(test::newSphere());
    for (const char* tool : {"draw", "grab", "clay"}) {
        bench.run(layer("add"));
        bench.run(stroke(tool, 0.02, true));
        bench.run(strength(tool == std::string_view("grab") ? 0.5 : 1.3));
    }
    const surfel::SurfelList shown = surfels(bench);
    for (int left = 2; left >= 0; --left) {
        bench.run(layer("merge"));
        QCOMPARE(bench.document.layers().layers.size(), std::size_t(left));
        QVERIFY(farthest(shown, surfels(bench)) < 1e-6);
        QVERIFY(left == 0 || isWhole(bench));
    }
}

void LayerCommandTest::resamplingCarriesLayersAlong() {
    for (const double finer : {0.6, 1.4}) {
        Workbench bench;
        bench.run(test::newSphere(6000));
        bench.run(layer("add"));
        bench.run(stroke("draw", 0, true, 0.4));
        const double s = spacing(bench), relief = offSphere(surfels(bench));
        bench.run({{"op", "resample"}, {"spacing", finer * s}});
        QVERIFY(isWhole(bench));
        const double kept = offSphere(surfels(bench));
        bench.run(strength(0));
        const double left = offSphere(surfels(bench));
        qInfo("relief %.4f, after resampling %.4f, left at strength 0 %.5f of spacing %.4f", relief, kept, left, s);
        QVERIFY(std::abs(kept - relief) < 0.1 * relief);
        QVERIFY(left < 0.15 * s);
        QCOMPARE(bench.document.layers().layers.size(), std::size_t(1));
    }
}

void LayerCommandTest::ownMasksHideInParts() {
    Workbench bench;
    bench.run(test::newSphere());
    const surfel::SurfelList base = surfels(bench);
    bench.run({{"op", "select"}, {"by", "plane"}, {"plane", {1, 0, 0, 0}}});
    bench.run(layer("add"));
    bench.run(stroke("draw", 0, false));
    const surfel::SurfelList sculpted = surfels(bench);
    bench.run(layer("mask", {{"from", "selection"}}));
    const surfel::SurfelList masked = surfels(bench);
    for (std::size_t i = 0; i < base.size(); ++i)
        QVERIFY(masked.items[i] == (base.items[i].position.x >= 0 ? base : sculpted).items[i]);
    bench.run(stroke("draw", 0.05, false)); // what is hidden takes nothing
    const surfel::SurfelList again = surfels(bench);
    for (std::size_t i = 0; i < base.size(); ++i)
        QVERIFY(base.items[i].position.x < 0 || again.items[i] == base.items[i]);
    QVERIFY(farthest(again, masked) > 0.01);
    bench.run({{"op", "undo"}});
    bench.run(layer("mask", {{"from", "nothing"}}));
    QCOMPARE(farthest(surfels(bench), sculpted), 0.0);
}

/// Of dabs that do not accumulate the farthest counts, whatever part of it is shown meanwhile.
void LayerCommandTest::whatIsHiddenInPartDoesNotPileUp() {
    Workbench masked, plain;
    json line = stroke("draw", 0, false);
    line["accumulate"] = false;
    for (Workbench* bench : {&masked, &plain}) {
        bench->run(test::newSphere());
        bench->run({{"op", "select"}, {"by", "plane"}, {"plane", {1, 0, 0, 0}}});
        bench->run({{"op", "selection"}, {"do", "blur"}, {"length", 0.3}});
        bench->run(layer("add"));
        if (bench == &masked)
            bench->run(layer("mask", {{"from", "selection"}}));
        bench->run(line);
        QVERIFY(isWhole(*bench));
    }
    masked.run(layer("mask", {{"from", "nothing"}}));
    const double relief = offSphere(surfels(plain));
    QVERIFY(relief > 1e-3);
    QVERIFY2(offSphere(surfels(masked)) < relief + 1e-4, qPrintable(QString::number(offSphere(surfels(masked)))));
}

void LayerCommandTest::mapsOfTheWholeMapEachLayer() {
    const json move{{"op", "transform"}, {"axis", {1, 2, 3}}, {"angle", 70}, {"scale", 2.5}, {"move", {1, -2, 0.5}}};
    Workbench first, last;
    for (Workbench* bench : {&first, &last}) {
        bench->run(test::newSphere());
        for (const char* tool : {"grab", "draw"}) {
            bench->run(layer("add"));
            bench->run(stroke(tool, 0, false, 0.4));
        }
    }
    json about = move;
    about["about"] = {0.1, 0.2, 0.3}; // the same point whatever the shape is
    first.run(about);
    QVERIFY(isWhole(first));
    for (Workbench* bench : {&first, &last}) {
        bench->run(strength(0.4));
        bench->run(layer("strength", {{"name", "Layer 1"}, {"strength", 0.2}}));
    }
    last.run(about);
    QVERIFY(farthest(surfels(first), surfels(last)) < 1e-5);
}

void LayerCommandTest::shapesOfTheWholeGoIntoTheActiveLayer() {
    for (const json& shape :
         {json{{"op", "inflate"}, {"length", 0.1}}, json{{"op", "noise"}, {"amplitude", 0.05}, {"size", 0.4}},
          json{{"op", "smooth"}, {"scale", 3}}}) {
        Workbench bench;
        bench.run(test::newSphere());
        bench.run(stroke("draw", 0, false));
        const surfel::SurfelList before = surfels(bench);
        bench.run(layer("add"));
        bench.run(shape);
        QVERIFY(isWhole(bench));
        QVERIFY(farthest(before, surfels(bench)) > 1e-3);
        bench.run(strength(0));
        QVERIFY(farthest(before, surfels(bench)) < rounding); // of as many
    }
}

void LayerCommandTest::threadsDoNotShow() {
    std::string hash[2];
    for (int k = 0; k < 2; ++k) {
        base::setThreadCount(k + 1);
        Workbench bench;
        bench.run(test::newSphere(8000));
        bench.run(layer("add"));
        bench.run(stroke("snake-hook", 0, true));
        bench.run(layer("add"));
        bench.run(stroke("draw", 0, true));
        bench.run({{"op", "resample"}, {"count", 9000}});
        bench.run(layer("strength", {{"name", "Layer 1"}, {"strength", 0.7}}));
        hash[k] = bench.hash();
    }
    base::setThreadCount(0);
    QCOMPARE(hash[0], hash[1]);
}

static const test::Registered<LayerCommandTest> registered;
#include "layer_command_test.moc"
