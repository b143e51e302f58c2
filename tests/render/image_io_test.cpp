#include "core/render/image_io.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <cstring>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace render;

class ImageIoTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void pngKeepsEveryPixel();
    void pfmKeepsEveryDepthFromBottomToTop();
    void aMissingFolderIsAnErrorWithItsName();
    void aSizeThatPngCannotHoldIsAnErrorWithTheName();
};

static Image noise(bool opaque) {
    base::Random random(test::seed());
    Image image;
    image.resize(37, 23);
    for (std::size_t i = 0; i < image.colour.size(); ++i) {
        image.colour[i] = static_cast<std::uint32_t>(random.next()) | (opaque ? 0xff000000u : 0);
        if (random.uniform() < 0.7)
            image.depth[i] = static_cast<float>(random.uniform(0.1, 1e6));
    }
    return image;
}

void ImageIoTest::pngKeepsEveryPixel() {
    const QTemporaryDir folder;
    for (const bool opaque : {true, false}) {
        const Image image = noise(opaque);
        const QString path = folder.filePath("a.png");
        savePng(image, path.toStdString());
        const QImage read(path);
        QCOMPARE(read.size(), QSize(37, 23));
        QCOMPARE(read.hasAlphaChannel(), !opaque);
        for (int y = 0; y < 23; ++y)
            for (int x = 0; x < 37; ++x) {
                const QRgb p = read.pixel(x, y);
                const surfel::Colour c = image.colour[static_cast<std::size_t>(y * 37 + x)];
                QCOMPARE(surfel::rgba(static_cast<unsigned>(qRed(p)), static_cast<unsigned>(qGreen(p)),
                                      static_cast<unsigned>(qBlue(p)), static_cast<unsigned>(qAlpha(p))),
                         c);
            }
    }
}

void ImageIoTest::pfmKeepsEveryDepthFromBottomToTop() {
    const QTemporaryDir folder;
    const Image image = noise(true);
    const QString path = folder.filePath("a.pfm");
    savePfm(image, path.toStdString());
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readLine(), QByteArray("Pf\n"));
    QCOMPARE(file.readLine(), QByteArray("37 23\n"));
    QVERIFY(file.readLine().toDouble() < 0); // little-endian
    const QByteArray body = file.readAll();
    QCOMPARE(body.size(), qsizetype(37 * 23 * 4));
    for (int y = 0; y < 23; ++y)
        QVERIFY(std::memcmp(body.constData() + (22 - y) * 37 * 4, image.depth.data() + y * 37, 37 * 4) == 0);
}

void ImageIoTest::aMissingFolderIsAnErrorWithItsName() {
    try {
        savePng(noise(true), "/no/such/folder/a.png");
        QFAIL("wrote into a folder that is not there");
    } catch (const base::Error& e) {
        QVERIFY(e.message().find("/no/such/folder") != std::string::npos);
    }
}

void ImageIoTest::aSizeThatPngCannotHoldIsAnErrorWithTheName() {
    const QTemporaryDir folder;
    for (const auto& [width, height] : {std::pair(0, 0), std::pair(0, 5), std::pair(2000000, 1)}) {
        Image image;
        image.resize(width, height);
        const std::string path = folder.filePath("a.png").toStdString();
        try {
            savePng(image, path);
            QFAIL("wrote what nobody could read");
        } catch (const base::Error& e) {
            QVERIFY2(e.message().find(path) != std::string::npos, e.what());
        }
        QVERIFY(!QFile::exists(path.c_str()));
    }
}

static const test::Registered<ImageIoTest> registered;
#include "image_io_test.moc"
