#include "core/io/pictures/grey_image.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/io/pictures/colour_image.h"
#include "support/registry.h"

#include <cstdio>
#include <fstream>
#include <jpeglib.h>
#include <png.h>
#include <QTemporaryDir>
#include <QTest>

class GreyImageTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void greyPngsKeepEveryValue();
    void coloursBecomeTheirLuma();
    void deepPngsKeepSixteenBits();
    void jpegsAreReadNearly();
    void picturesKeepTheirColours();
    void brokenImagesAreRefusedByName();
    void tornImagesNeverCrash();
    void shortFilesClaimNoLargeImages();
    void imagesThatEndTooEarlyAreRefused();

  private:
    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }
    QTemporaryDir m_folder;
};

template <class Value>
static void writePng(const std::filesystem::path& path, int width, int height, png_uint_32 format,
                     const std::vector<Value>& values) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(width), image.height = png_uint_32(height), image.format = format;
    QVERIFY(png_image_write_to_file(&image, path.c_str(), 0, values.data(), 0, nullptr));
}

static void writeJpeg(const std::filesystem::path& path, int side, std::vector<unsigned char> grey) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    jpeg_stdio_dest(&info, file);
    info.image_width = info.image_height = JDIMENSION(side);
    info.input_components = 1, info.in_color_space = JCS_GRAYSCALE;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, 95, TRUE);
    jpeg_start_compress(&info, TRUE);
    for (int y = 0; y < side; ++y) {
        unsigned char* row = grey.data() + y * side;
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    jpeg_destroy_compress(&info);
    std::fclose(file);
}

static std::vector<char> bytesOf(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void GreyImageTest::greyPngsKeepEveryValue() {
    std::vector<png_byte> values;
    for (int k = 0; k < 256; ++k)
        values.push_back(png_byte(k));
    writePng(path("a.png"), 32, 8, PNG_FORMAT_GRAY, values);
    const io::GreyImage image = io::readGreyImage(path("a.png"));
    QCOMPARE(image.width, 32);
    QCOMPARE(image.height, 8);
    for (int k = 0; k < 256; ++k)
        QCOMPARE(image.values[std::size_t(k)], float(k) / 255.0f);
}

void GreyImageTest::coloursBecomeTheirLuma() {
    writePng<png_byte>(path("rgb.png"), 4, 1, PNG_FORMAT_RGB, {255, 255, 255, 0, 0, 0, 90, 90, 90, 0, 255, 0});
    const io::GreyImage image = io::readGreyImage(path("rgb.png"));
    QCOMPARE(image.values[0], 1.0f);
    QCOMPARE(image.values[1], 0.0f);
    QVERIFY(std::abs(image.values[2] - 90.0f / 255) < 0.01f);
    QVERIFY(image.values[3] > 0.5f && image.values[3] < 1);
    // Transparent is black.
    writePng<png_byte>(path("alpha.png"), 2, 1, PNG_FORMAT_GA, {255, 255, 255, 0});
    const io::GreyImage clear = io::readGreyImage(path("alpha.png"));
    QCOMPARE(clear.values[0], 1.0f);
    QCOMPARE(clear.values[1], 0.0f);
}

void GreyImageTest::deepPngsKeepSixteenBits() {
    std::vector<png_uint_16> values;
    for (int k = 0; k < 4096; ++k)
        values.push_back(png_uint_16(16 * k + 3));
    writePng(path("deep.png"), 64, 64, PNG_FORMAT_LINEAR_Y, values);
    const io::GreyImage image = io::readGreyImage(path("deep.png"));
    for (std::size_t k = 0; k < 4096; ++k)
        QVERIFY(std::abs(image.values[k] - float(values[k]) / 65535) < 2e-5f);
}

void GreyImageTest::jpegsAreReadNearly() {
    std::vector<unsigned char> grey;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            grey.push_back(static_cast<unsigned char>(3 * x + 2 * y));
    writeJpeg(path("a.jpg"), 40, grey);
    const io::GreyImage image = io::readGreyImage(path("a.jpg"));
    QCOMPARE(image.width, 40);
    for (std::size_t k = 0; k < grey.size(); ++k)
        QVERIFY(std::abs(image.values[k] - float(grey[k]) / 255) < 0.03f);
}

void GreyImageTest::picturesKeepTheirColours() {
    writePng(path("rgb.png"), 2, 1, PNG_FORMAT_RGB, std::vector<png_byte>{1, 2, 3, 250, 128, 0});
    const mesh::Picture colours = io::readPicture(path("rgb.png"));
    QVERIFY(colours.width == 2 && colours.height == 1);
    QCOMPARE(colours.pixels, (std::vector<surfel::Colour>{surfel::rgba(1, 2, 3), surfel::rgba(250, 128, 0)}));
    writePng(path("alpha.png"), 1, 1, PNG_FORMAT_RGBA, std::vector<png_byte>{9, 8, 7, 0});
    QCOMPARE(io::readPicture(path("alpha.png")).pixels[0], surfel::rgba(9, 8, 7));
    std::vector<unsigned char> grey;
    for (int k = 0; k < 40 * 40; ++k)
        grey.push_back(static_cast<unsigned char>(3 * (k % 40) + 2 * (k / 40)));
    writeJpeg(path("a.jpg"), 40, grey);
    const mesh::Picture jpeg = io::readPicture(path("a.jpg"));
    QVERIFY(jpeg.width == 40 && jpeg.height == 40);
    for (std::size_t k = 0; k < grey.size(); ++k)
        for (const unsigned shift : {0u, 8u, 16u})
            QVERIFY(std::abs(static_cast<int>(jpeg.pixels[k] >> shift & 255u) - grey[k]) < 8);
    for (const char* name : {"text.png", "missing.png"}) {
        std::ofstream(path("text.png")) << "not an image";
        QVERIFY_EXCEPTION_THROWN(io::readPicture(path(name)), base::Error);
    }
}

static bool refused(const std::filesystem::path& path) {
    try {
        io::readGreyImage(path);
    } catch (const base::Error& error) {
        return std::string(error.what()).find(path.filename().string()) != std::string::npos;
    }
    return false;
}

void GreyImageTest::brokenImagesAreRefusedByName() {
    std::ofstream(path("text.png")) << "not an image";
    QVERIFY(refused(path("text.png")));
    QVERIFY(refused(path("missing.png")));
    QVERIFY(refused(m_folder.path().toStdString()));
    writePng(path("wide.png"), 8200, 1, PNG_FORMAT_GRAY, std::vector<png_byte>(8200, 7));
    QVERIFY(refused(path("wide.png")));
}

void GreyImageTest::tornImagesNeverCrash() {
    base::Random random(test::seed());
    for (const char* name : {"a.png", "a.jpg"}) {
        const std::vector<char> whole = bytesOf(path(name));
        QVERIFY(whole.size() > 60);
        for (int round = 0; round < 300; ++round) {
            std::vector<char> torn(whole.begin(), whole.begin() + std::ptrdiff_t(1 + random.below(whole.size())));
            for (int k = 0; k < 3; ++k)
                torn[random.below(torn.size())] = char(random.below(256));
            std::ofstream(path("torn"), std::ios::binary).write(torn.data(), std::streamsize(torn.size()));
            try {
                const io::GreyImage image = io::readGreyImage(path("torn"));
                QCOMPARE(image.values.size(), std::size_t(image.width) * std::size_t(image.height));
            } catch (const base::Error&) {
            }
        }
    }
}

static std::string refusalOf(const std::filesystem::path& path) {
    try {
        io::readGreyImage(path);
    } catch (const base::Error& error) {
        return error.message();
    }
    return {};
}

static void writeBytes(const std::filesystem::path& path, const std::vector<char>& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void GreyImageTest::shortFilesClaimNoLargeImages() {
    writeJpeg(path("a.jpg"), 40, std::vector<unsigned char>(1600, 90));
    std::vector<char> bytes = bytesOf(path("a.jpg"));
    std::size_t frame = 0;
    while (!(bytes[frame] == '\xff' && bytes[frame + 1] == '\xc0'))
        ++frame;
    for (const std::size_t side : {5u, 7u}) // height, width
        bytes[frame + side] = 31, bytes[frame + side + 1] = 64;
    writeBytes(path("large.jpg"), bytes);
    QVERIFY2(refusalOf(path("large.jpg")).find("8000 x 8000") != std::string::npos,
             refusalOf(path("large.jpg")).c_str());
}

void GreyImageTest::imagesThatEndTooEarlyAreRefused() {
    base::Random random(test::seed());
    std::vector<unsigned char> grey(1600);
    for (unsigned char& each : grey)
        each = static_cast<unsigned char>(random.next());
    writeJpeg(path("a.jpg"), 40, grey);
    writePng<png_byte>(path("a.png"), 40, 40, PNG_FORMAT_GRAY, grey);
    for (const char* name : {"a.jpg", "a.png"}) {
        std::vector<char> bytes = bytesOf(path(name));
        QCOMPARE(refusalOf(path(name)), std::string());
        bytes.resize(bytes.size() * 2 / 3);
        writeBytes(path(name), bytes);
        QVERIFY2(!refusalOf(path(name)).empty(), name);
    }
}

static const test::Registered<GreyImageTest> registered;
#include "grey_image_test.moc"
