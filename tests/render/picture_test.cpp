// Pictures for files: those of a sequence are those drawn one by one.
#include "core/render/picture.h"

#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;

class PictureTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void picturesOfASequenceAreThoseDrawnAlone_data();
    void picturesOfASequenceAreThoseDrawnAlone();
};

void PictureTest::picturesOfASequenceAreThoseDrawnAlone_data() {
    QTest::addColumn<bool>("rayCast");
    QTest::newRow("splats") << false;
    QTest::newRow("rays") << true;
}

void PictureTest::picturesOfASequenceAreThoseDrawnAlone() {
    QFETCH(bool, rayCast);
    const surface::Surface torus(test::built(test::torus(1, 0.4, 12000, test::seed())), {});
    PictureOptions options;
    options.rayCast = rayCast;
    options.sections = true;
    options.style.shading = shading("curvature");
    PictureMaker maker(torus, options);
    for (int k = 0; k < 4; ++k) {
        Camera camera = Camera::looking(torus.tree().bounds(), 96, 72);
        const double angle = 0.7 * k;
        camera.eye = {4 * std::sin(angle), 2, 4 * std::cos(angle)};
        if (k >= 2) // the cut changes on the way, and stays
            camera.clips.add({{0, 1, 0}, 0.05});
        PictureStats together, alone;
        const Image a = maker.draw(camera, together, {}), b = drawPicture(torus, camera, options, alone, {});
        QVERIFY2(a.colour == b.colour && a.depth == b.depth, qPrintable(QString("view %1").arg(k)));
        QVERIFY(together.scale && together.rays == alone.rays && together.pixels == alone.pixels);
    }
}

static const test::Registered<PictureTest> registered;
#include "picture_test.moc"
