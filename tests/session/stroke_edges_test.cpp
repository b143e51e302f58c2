// Strokes and edges that stay sharp: lines that leave one, smoothing that keeps or fades it, sessions that say so.
#include "core/cells/labels.h"
#include "core/cells/seam_lines.h"
#include "journals.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using nlohmann::json;
using test::Workbench;

class StrokeEdgesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void linesLeaveAnEdge_data();
    void linesLeaveAnEdge();
    void imagesLeaveTheirs();
    void edgesBesideEachOtherStayTwo();
    void smoothingKeepsEdgesUnlessTold();
    void othersTakeNoNotice();
    void journalsBringEdgesBack();
    void snappingKeepsToSeams();
    void layersAreRefused();
};

static double seamLength(const Workbench& bench) {
    double out = 0;
    for (const cells::SeamLine& line : cells::seamLines(bench.document.surface()))
        out += line.length();
    return out;
}

/// The mean sharpness beside creases, 0 to 255; -1 without any.
static double sharpness(const Workbench& bench) {
    const auto layout = cells::LabelLayout::of(*bench.document.surface().tree().layout());
    double sum = 0, count = 0;
    bench.document.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size() && layout; ++slot)
            if (const cells::Label label = layout->at(block, slot); label.meeting != cells::Meeting::None) {
                sum += label.sharpness;
                ++count;
            }
    });
    return count > 0 ? sum / count : -1;
}

static json edgeStroke(const char* tool, double edge) {
    json out = test::strokeAt(0, tool);
    out["edge"] = edge;
    out["strength"] = 0.8;
    return out;
}

void StrokeEdgesTest::linesLeaveAnEdge_data() {
    QTest::addColumn<QString>("tool");
    for (const char* tool : {"crease", "pinch", "draw-sharp"})
        QTest::newRow(tool) << QString(tool);
}

void StrokeEdgesTest::linesLeaveAnEdge() {
    QFETCH(QString, tool);
    Workbench bench, plain;
    bench.run(test::newSphere(6000));
    plain.run(test::newSphere(6000));
    bench.run(edgeStroke(tool.toUtf8(), 1));
    plain.run(edgeStroke(tool.toUtf8(), 0));
    QVERIFY(sharpness(plain) < 0);
    QVERIFY2(sharpness(bench) > 100, qPrintable(QString::number(sharpness(bench))));
    QVERIFY(std::abs(static_cast<double>(bench.size()) - static_cast<double>(plain.size())) <
            0.02 * static_cast<double>(plain.size()));
    if (tool != "pinch") // which raises nothing on a ball
        QVERIFY2(seamLength(bench) > 0.4 && seamLength(bench) < 1.6, qPrintable(QString::number(seamLength(bench))));
    bench.document.undo(); // one step, edge and all
    QVERIFY(sharpness(bench) < 0 && !bench.document.canUndo());
}

void StrokeEdgesTest::imagesLeaveTheirs() {
    Workbench one, two;
    for (Workbench* bench : {&one, &two}) {
        bench->run(test::newSphere(6000));
        json stroke = test::strokeAt(0.35, "draw-sharp");
        stroke["edge"] = 1;
        stroke["radius"] = 0.2;
        stroke["strength"] = 0.8;
        if (bench == &two)
            stroke["symmetry"] = {"y"};
        bench->run(stroke);
    }
    QVERIFY2(seamLength(two) > 1.6 * seamLength(one) && seamLength(two) < 2.4 * seamLength(one),
             qPrintable(QString("%1 %2").arg(seamLength(one)).arg(seamLength(two))));
}

void StrokeEdgesTest::edgesBesideEachOtherStayTwo() {
    for (const double apart : {0.52, 0.58, 0.64}) { // 3.2 h and more: bands reach 3
        Workbench bench;
        bench.run(test::newSphere(6000));
        double alone = 0;
        for (const double y : {-apart / 2, apart / 2}) {
            json stroke = test::strokeAt(y, "crease");
            stroke["edge"] = 1;
            stroke["radius"] = 0.15;
            bench.run(stroke);
            if (alone == 0)
                alone = seamLength(bench);
        }
        QVERIFY2(seamLength(bench) > 1.8 * alone && seamLength(bench) < 2.25 * alone,
                 qPrintable(QString("%1 apart: %2 and %3").arg(apart).arg(alone).arg(seamLength(bench))));
    }
}

void StrokeEdgesTest::smoothingKeepsEdgesUnlessTold() {
    Workbench bench;
    bench.run(test::newSphere(6000));
    bench.run(edgeStroke("draw-sharp", 1));
    const double before = sharpness(bench);
    bench.run(test::strokeAt(0, "smooth"));
    QVERIFY2(std::abs(sharpness(bench) - before) < 0.1 * before, qPrintable(QString::number(sharpness(bench))));
    json fading = test::strokeAt(0, "smooth");
    fading["fade-edges"] = true;
    fading["strength"] = 0.5;
    bench.run(fading);
    const double once = sharpness(bench);
    QVERIFY2(once < 0.8 * before && once > 0, qPrintable(QString("%1 %2").arg(before).arg(once)));
    bench.run(fading);
    QVERIFY2(sharpness(bench) < 0.85 * once, qPrintable(QString("%1 %2").arg(once).arg(sharpness(bench))));
}

void StrokeEdgesTest::othersTakeNoNotice() {
    Workbench with, without;
    for (Workbench* bench : {&with, &without})
        bench->run(test::newSphere());
    json stroke = test::strokeAt(0, "clay");
    without.run(stroke);
    stroke["edge"] = 1;
    stroke["fade-edges"] = true;
    with.run(stroke);
    QCOMPARE(with.hash(), without.hash());
}

void StrokeEdgesTest::journalsBringEdgesBack() {
    Workbench bench;
    session::Journal journal(bench.path("journal.jsonl"));
    bench.context.journal = &journal;
    bench.run(test::newSphere(5000));
    bench.run(edgeStroke("crease", 0.7));
    json fading = test::strokeAt(0, "smooth");
    fading["fade-edges"] = true;
    bench.run(fading);
    QCOMPARE(test::recovered(bench.path("journal.jsonl")), bench.hash());
}

void StrokeEdgesTest::snappingKeepsToSeams() {
    Workbench bench;
    const std::string box = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 0 1 1\n"
                            "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    bench.run({{"op", "open"},
               {"path", test::write(bench.path("box.obj"), box).string()},
               {"faces", "sample"},
               {"sample_count", 8000}});
    json samples = json::array();
    for (int k = 0; k <= 10; ++k) // along the upper edge y = 1, but on top, beside it
        samples.push_back({0.5 + 0.1 * k, 0.93 + 0.04 * (k % 2), 5.0, 0.0, 0.0, -1.0, 1.0, 0.02 * k});
    json stroke{{"op", "stroke"}, {"tool", "mask"},     {"radius", 0.1},
                {"strength", 1},  {"samples", samples}, {"snap", 1}};
    bench.run(stroke);
    double least = 2, most = 0, onTop = 0, onSide = 0;
    bench.document.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (block.mask(slot) > 0.5f) {
                const base::Vec3f p = block.position(slot);
                least = std::min(least, double(p.y));
                most = std::max(most, double(p.y));
                onTop += p.z > 0.999f ? 1 : 0;
                onSide += p.y > 0.999f ? 1 : 0;
            }
    });
    QVERIFY2(least > 0.9 && most > 0.999, qPrintable(QString("%1 %2").arg(least).arg(most)));
    QVERIFY2(onTop > 50 && onSide > 0.7 * onTop && onSide < 1.4 * onTop,
             qPrintable(QString("%1 %2").arg(onTop).arg(onSide)));
    // to a corner
    bench.document.undo();
    stroke["samples"] = {{1.93, 0.94, 5.0, 0.0, 0.0, -1.0, 1.0, 0.0}};
    stroke["snap"] = 2;
    bench.run(stroke);
    base::Box3f masked;
    bench.document.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (block.mask(slot) > 0)
                masked.extend(block.position(slot));
    });
    QVERIFY2(masked.lo.x > 1.88f && masked.lo.y > 0.88f && masked.lo.z > 0.88f && masked.hi.x > 1.99f,
             qPrintable(QString("%1 %2 %3 to %4 %5 %6")
                            .arg(masked.lo.x)
                            .arg(masked.lo.y)
                            .arg(masked.lo.z)
                            .arg(masked.hi.x)
                            .arg(masked.hi.y)
                            .arg(masked.hi.z)));
}

void StrokeEdgesTest::layersAreRefused() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run({{"op", "layer"}, {"do", "add"}, {"name", "wrinkles"}});
    QVERIFY(bench.refusal(edgeStroke("crease", 1)).find("layers") != std::string::npos);
}

static const test::Registered<StrokeEdgesTest> registered;
#include "stroke_edges_test.moc"
