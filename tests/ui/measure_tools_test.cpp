// Measuring with the pointer: what clicks on the model tell, against the ball they are made on.
#include "ui/window/measure_tools.h"

#include "support/patience.h"
#include "support/registry.h"
#include "ui/interaction/contact.h"
#include "ui/panels/measure_bar.h"
#include "ui/window_fixture.h"

#include <numbers>
#include <QClipboard>
#include <QSignalSpy>
#include <QToolButton>

using test::WindowFixture;

class MeasureToolsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whoOpensTheBarMeasures();
    void everyRowTellsTheBall_data();
    void everyRowTellsTheBall();
    void besideTheModelNothingIsPicked();
    void anotherModelTakesResultsAway();
    void resultsAreCopied();
};

namespace {

struct Bar {
    WindowFixture f;
    bool ready = f.make("sphere", 20000);
    ui::MeasureBar& bar = *f.window->findChild<ui::MeasureBar*>();

    Bar() { bar.toggleViewAction()->trigger(); }
    void click(const char* name) {
        if (QToolButton* button = bar.findChild<QToolButton*>(QString("measure-") + name); !button->isChecked())
            button->click();
    }
    QPointF at(double x, double y) { return {x * f.view().width(), y * f.view().height()}; }
    void tap(const QPointF& place) {
        f.press(place);
        f.release(place);
    }
    base::Vec3d contact(const QPointF& place) {
        return ui::contactAt(f.editor().snapshot().surface, f.window->sculptView().motion().camera(),
                             place * f.view().devicePixelRatioF())
            ->position;
    }
    /// The number that the bar tells, once it does.
    double told() {
        const QString before = bar.said();
        double out = 0;
        bool number = false;
        if (!QTest::qWaitFor(
                [&] {
                    const QString text = bar.said().section(' ', 0, 0).remove(QChar(0xb0));
                    out = text.toDouble(&number);
                    return number;
                },
                test::patience))
            qWarning("no number, but: %s", qPrintable(bar.said()));
        return out;
    }
};

} // namespace

/// Two clicks right after the key tell a distance; they went into the model as dabs.
void MeasureToolsTest::whoOpensTheBarMeasures() {
    Bar b;
    QVERIFY(b.ready);
    const base::Hash128 before = b.f.hash();
    const QPointF from = b.at(0.45, 0.5), to = b.at(0.55, 0.45);
    const double wanted = distance(b.contact(from), b.contact(to));
    b.tap(from);
    b.tap(to);
    const double told = b.told();
    QVERIFY2(std::abs(told - wanted) < 0.01 * wanted, QByteArray::number(told));
    QVERIFY(b.f.hash() == before);
}

void MeasureToolsTest::everyRowTellsTheBall_data() {
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < ui::rulerTable().size(); ++i)
        QTest::addRow("%s", ui::rulerTable()[i].id) << int(i);
}

void MeasureToolsTest::everyRowTellsTheBall() {
    QFETCH(int, row);
    const ui::RulerRow& what = ui::rulerTable()[static_cast<std::size_t>(row)];
    Bar t;
    QVERIFY(t.ready);
    t.click(what.id);
    QCOMPARE(t.bar.row(), row);
    const QPointF clicks[] = {t.at(0.45, 0.5), t.at(0.55, 0.5), t.at(0.55, 0.4)};
    std::vector<base::Vec3d> x;
    for (std::size_t i = 0; i < what.places; ++i) {
        x.push_back(t.contact(clicks[i]));
        t.tap(clicks[i]);
    }
    const std::string_view id = what.id;
    if (id == "place") {
        QTRY_VERIFY_WITH_TIMEOUT(t.bar.said().count(',') == 2, test::patience);
        const QStringList numbers = t.bar.said().split(", ");
        QVERIFY(std::abs(numbers[0].toDouble() - x[0].x) < 1e-5 && std::abs(numbers[2].toDouble() - x[0].z) < 1e-5);
        return;
    }
    const double told = t.told(), radius = length(x[0]);
    const auto between = [](const base::Vec3d& a, const base::Vec3d& b) {
        return std::atan2(length(cross(a, b)), dot(a, b));
    };
    const double degrees = 180 / std::numbers::pi;
    const double wanted = id == "distance"    ? distance(x[0], x[1])
                          : id == "along"     ? radius * between(x[0], x[1])
                          : id == "angle"     ? between(x[0] - x[1], x[2] - x[1]) * degrees
                          : id == "slopes"    ? between(x[0], x[1]) * degrees
                          : id == "thickness" ? 2 * radius
                                              : -1;
    QVERIFY2(std::abs(told - wanted) < 0.01 * wanted, qPrintable(QString("%1 for %2").arg(told).arg(wanted)));
    QCOMPARE(t.f.editor().snapshot().canUndo, false); // nothing was sculpted
}

void MeasureToolsTest::besideTheModelNothingIsPicked() {
    Bar t;
    t.click("thickness");
    const QString before = t.bar.said();
    t.tap(t.at(0.02, 0.02));
    QTest::qWait(50);
    QCOMPARE(t.bar.said(), before);
    QVERIFY(t.f.window->sculptView().picker().on());
}

void MeasureToolsTest::anotherModelTakesResultsAway() {
    Bar t;
    t.click("distance");
    t.tap(t.at(0.45, 0.5));
    t.tap(t.at(0.55, 0.5));
    QVERIFY(t.told() > 0);
    QVERIFY(t.f.make("torus", 2000));
    t.click("copy");
    QVERIFY(QApplication::clipboard()->text().isEmpty());
}

void MeasureToolsTest::resultsAreCopied() {
    Bar t;
    t.click("distance");
    for (int k = 0; k < 2; ++k) {
        t.tap(t.at(0.45, 0.5));
        t.tap(t.at(0.55, 0.5 - 0.05 * k));
        QVERIFY(t.told() > 0);
    }
    t.click("copy");
    QCOMPARE(QApplication::clipboard()->text().count('\n'), 1);
    t.click("clear");
    t.click("copy");
    QVERIFY(QApplication::clipboard()->text().isEmpty());
}

static const test::Registered<MeasureToolsTest> registered;
#include "measure_tools_test.moc"
