// Pictures of several models: what is in front hides what is behind, as in a picture of one model of them all.
#include "core/render/scene_picture.h"

#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;

class ScenePictureTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void modelsApartLookLikeOneModel_data();
    void modelsApartLookLikeOneModel();
    void theNearerModelIsInFront();
    void orderDoesNotShow();
};

static surface::Surface ballAt(const base::Vec3d& centre, double radius, std::size_t count) {
    return {test::built(test::sphere(centre, radius, count)), {}};
}

void ScenePictureTest::modelsApartLookLikeOneModel_data() {
    QTest::addColumn<bool>("rayCast");
    QTest::addColumn<bool>("transparent");
    QTest::newRow("splats") << false << false;
    QTest::newRow("rays") << true << false;
    QTest::newRow("splats, transparent") << false << true;
}

void ScenePictureTest::modelsApartLookLikeOneModel() {
    QFETCH(bool, rayCast);
    QFETCH(bool, transparent);
    const surface::Surface a = ballAt({0, 0, 0}, 1, 5000), b = ballAt({1.4, 0.3, -2.5}, 1, 5000);
    surfel::SurfelList both = a.tree().surfels();
    for (const surfel::Surfel& s : b.tree().surfels().items)
        both.append(s, {});
    const surface::Surface one(test::built(both), {});
    PictureOptions options;
    options.rayCast = rayCast;
    options.style.transparent = transparent;
    options.style.grid.reset();
    const Camera camera = Camera::looking(one.tree().bounds(), 200, 150);
    PictureStats stats;
    const Image wanted = drawPicture(one, camera, options, stats, {}),
                found = ScenePictureMaker({a, b}, options).draw(camera, stats, {});
    const double off = transparent ? 0 : test::difference(wanted, found).mean; // colours that nobody sees differ
    QVERIFY2(off < 0.6, qPrintable(QString::number(off)));
    int other = 0;
    for (std::size_t i = 0; i < wanted.depth.size(); ++i) {
        other += std::isfinite(wanted.depth[i]) != std::isfinite(found.depth[i]);
        QCOMPARE(found.colour[i] >> 24 == 0, wanted.colour[i] >> 24 == 0);
    }
    QVERIFY2(other < 30, qPrintable(QString::number(other)));
}

void ScenePictureTest::theNearerModelIsInFront() {
    const surface::Surface front = ballAt({0, 0, 2}, 0.5, 3000), behind = ballAt({0, 0, -2}, 1, 3000);
    PictureOptions options;
    Camera camera = Camera::looking({{-1, -1, -3}, {1, 1, 3}}, 120, 120);
    camera.eye = {0, 0, 9};
    camera.target = {0, 0, 0};
    PictureStats stats;
    const Image image = ScenePictureMaker({behind, front}, options).draw(camera, stats, {});
    const std::size_t middle = 60 * 120 + 60;
    QVERIFY(std::abs(image.depth[middle] - 6.5f) < 0.02f);
    const Image alone = drawPicture(front, camera, options, stats, {});
    QCOMPARE(image.colour[middle], alone.colour[middle]);
}

void ScenePictureTest::orderDoesNotShow() {
    const surface::Surface a = ballAt({0, 0, 0}, 1, 4000), b = ballAt({0.7, 0.2, 0.6}, 0.8, 4000),
                           c = ballAt({-0.7, 0.5, 0.3}, 0.6, 4000);
    PictureOptions options;
    const Camera camera = Camera::looking(a.tree().bounds(), 160, 120);
    PictureStats stats;
    const Image one = ScenePictureMaker({a, b, c}, options).draw(camera, stats, {}),
                two = ScenePictureMaker({c, b, a}, options).draw(camera, stats, {});
    QVERIFY(one.depth == two.depth);
    const double off = test::difference(one, two).mean;
    QVERIFY2(off < 0.2, qPrintable(QString::number(off)));
}

static const test::Registered<ScenePictureTest> registered;
#include "scene_picture_test.moc"
