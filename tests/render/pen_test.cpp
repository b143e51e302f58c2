// Lines by the pen: as wide as asked, each pixel inked once, and nothing outside.
#include "core/render/overlay/pen.h"

#include "support/registry.h"

#include <QTest>

using namespace render;

class PenTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void linesAreAsWideAsAsked_data();
    void linesAreAsWideAsAsked();
    void translucentLinesAreEvenAtJointsAndCrossings();
    void whatLiesOutsideIsCutOff();
    void nothingIsAsOpaqueAsItsInk();
};

static Image canvas(int width, int height, surfel::Colour colour = surfel::rgba(0, 0, 0)) {
    Image out;
    out.resize(width, height);
    std::fill(out.colour.begin(), out.colour.end(), colour);
    return out;
}

static void line(const std::vector<PenLine>& lines, float width, float alpha, Image& out) {
    const auto ink = [&](surfel::Colour under, float away) {
        return inked(under, {1, 1, 1}, alpha * covered(width, away));
    };
    draw(lines, 0.5f * width + 1, ink, out);
}

void PenTest::linesAreAsWideAsAsked_data() {
    QTest::addColumn<float>("width");
    QTest::addColumn<float>("angle");
    for (const float width : {1.2f, 2.64f, 5.0f})
        for (const float angle : {0.0f, 0.3f, 0.7854f, 1.5708f})
            QTest::addRow("%g px at %g", double(width), double(angle)) << width << angle;
}

void PenTest::linesAreAsWideAsAsked() {
    QFETCH(float, width);
    QFETCH(float, angle);
    Image image = canvas(200, 200);
    const float x = 60 * std::cos(angle), y = 60 * std::sin(angle);
    line({{{100 - x, 100 - y}, {100 + x, 100 + y}}}, width, 1, image);
    double sum = 0;
    for (const surfel::Colour c : image.colour)
        sum += (c & 255u) / 255.0;
    const double wanted = double(width) * 120 + 3.1416 * double(width * width) / 4; // round ends
    QVERIFY2(std::abs(sum / wanted - 1) < 0.06, qPrintable(QString::number(sum / wanted)));
}

void PenTest::translucentLinesAreEvenAtJointsAndCrossings() {
    Image image = canvas(100, 100);
    line({{{10, 50}, {50, 50}}, {{50, 50}, {90, 50}}, {{50, 10}, {50, 90}}, {{50, 50}, {50, 50}}}, 6, 0.5f, image);
    surfel::Colour most = 0;
    for (const surfel::Colour c : image.colour)
        most = std::max(most, c & 255u);
    QCOMPARE(most, 128u);
    QCOMPARE(image.colour[50 * 100 + 50] & 255u, 128u);
    QCOMPARE(image.colour[50 * 100 + 30] & 255u, 128u);
}

void PenTest::whatLiesOutsideIsCutOff() {
    Image image = canvas(40, 30);
    line({{{-1e9f, 15}, {1e9f, 15}}, {{-50, -50}, {-20, -20}}, {{20, 200}, {30, 300}}}, 2, 1, image);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            QCOMPARE(image.colour[std::size_t(y * 40 + x)] & 255u, y == 14 || y == 15 ? 255u : 0u);
    const Image before = image;
    line({}, 2, 1, image);
    QVERIFY(before.colour == image.colour);
}

void PenTest::nothingIsAsOpaqueAsItsInk() {
    QCOMPARE(inked(0, {1, 0, 0}, 0), surfel::Colour(0));
    QCOMPARE(inked(0, {1, 0, 0}, 0.5f), surfel::rgba(255, 0, 0, 128));
    QCOMPARE(inked(surfel::rgba(0, 0, 255), {1, 0, 0}, 1), surfel::rgba(255, 0, 0));
}

static const test::Registered<PenTest> registered;
#include "pen_test.moc"
