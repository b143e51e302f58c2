// render's light: depth and normals of cast rays are those of `intersect`; materials, lamps, shadows; what is no use
// together.
#include "core/base/vec.h"
#include "core/raycast/light_rigs.h"
#include "core/raycast/material_table.h"
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QImage>
#include <QTest>

using base::Vec3d;
using nlohmann::json;
using test::Outcome;
using test::Program;

class LightTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void depthAndNormalsAreThoseOfIntersect();
    void everyMaterialAndLightIsListedAndDrawn();
    void shadowsDarkenAndAreCounted();
    void theGroundHasAShadowOnly();
    void edgesAreSmoothedAtTheirPixelsOnly();
    void depthAsExrHoldsEveryPixel();
    void whatDoesNotGoTogetherIsWrongUsage();
};

constexpr int width = 80, height = 60;
static const QStringList fromFront{"--size", "80x60", "--eye", "0,0,4", "--target", "0,0,0",
                                   "--up",   "0,1,0", "--fov", "40",    "--mode",   "raycast"};

static QImage picture(const Program& program, const QStringList& options, const char* model = "sample:knot:6000") {
    const Outcome outcome = program.run(QStringList{"render", model, "-o", "a.png"} + fromFront + options);
    if (outcome.code != 0)
        qWarning("%s", outcome.err.c_str());
    return outcome.code == 0 ? QImage(program.dir().filePath("a.png")).convertToFormat(QImage::Format_RGBA8888)
                             : QImage();
}

void LightTest::depthAndNormalsAreThoseOfIntersect() {
    const Program program;
    const double focal = 30 / std::tan(20 * 3.14159265358979323846 / 180);
    std::string rays = "ox,oy,oz,dx,dy,dz\n";
    std::vector<Vec3d> directions;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            directions.push_back(normalized(Vec3d{column + 0.5 - 40, 30 - row - 0.5, -focal}));
            const Vec3d& d = directions.back();
            char line[128];
            std::snprintf(line, sizeof line, "0,0,4,%.17g,%.17g,%.17g\n", d.x, d.y, d.z);
            rays += line;
        }
    program.write("rays.csv", rays);
    QCOMPARE(program.run({"intersect", "sample:knot:6000", "--rays", "rays.csv", "-o", "hits.csv"}).code, 0);
    const auto hits = test::rowsOf(program.read("hits.csv"));
    const QImage image = picture(program, {"--shading", "normal", "--depth", "a.pfm"});
    const std::string pfm = program.read("a.pfm");
    QVERIFY(!image.isNull() && hits.size() == directions.size() + 1);
    std::vector<float> depth(directions.size());
    std::memcpy(depth.data(), pfm.data() + pfm.size() - depth.size() * sizeof(float), depth.size() * sizeof(float));
    int met = 0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto i = static_cast<std::size_t>(row * width + column);
            const auto& hit = hits[i + 1];
            const float found = depth[static_cast<std::size_t>((height - 1 - row) * width + column)];
            QCOMPARE(std::isfinite(found), hit[0] == "1");
            if (hit[0] != "1")
                continue;
            ++met;
            QVERIFY(std::abs(static_cast<double>(found) - std::stod(hit[1])) < 2e-6);
            // The picture has the normal turned by the rotation that takes the way to the eye to z.
            const Vec3d v = -directions[i], n{std::stod(hit[5]), std::stod(hit[6]), std::stod(hit[7])};
            const double facing = dot(n, v), s = (facing + n.z) / (1 + v.z);
            const double shown[] = {n.x - s * v.x, n.y - s * v.y, facing};
            const QRgb pixel = image.pixel(column, row);
            const int channels[] = {qRed(pixel), qGreen(pixel), qBlue(pixel)};
            for (int k = 0; k < 2; ++k)
                QVERIFY(std::abs(channels[k] - 127.5 * (shown[k] + 1)) < 2);
        }
    QVERIFY(met > 800);
}

void LightTest::everyMaterialAndLightIsListedAndDrawn() {
    if (test::sanitized)
        QSKIP("minutes under a sanitizer");
    const Program program;
    const std::string help = program.run({"render", "--help"}).out;
    std::vector<QImage> pictures;
    for (const raycast::MaterialRow& row : raycast::materialTable()) {
        QVERIFY2(help.find(std::string(row.id) + ":") != std::string::npos, row.id);
        pictures.push_back(picture(program, {"--material", row.id}));
    }
    const auto lit = [&](const char* lights) {
        return picture(program, {"--material", "clay", "--shadows", "--lights", lights});
    };
    for (const raycast::LightRigRow& row : raycast::lightRigTable()) {
        QVERIFY2(help.find(std::string(row.id) + ":") != std::string::npos, row.id);
        pictures.push_back(lit(row.id));
    }
    pictures.push_back(lit("1,2,3;-1,0.5,0"));
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            QVERIFY(!pictures[i].isNull() && pictures[i] != pictures[k]);
    // Neither a strip with one side nor raw points without normals stop any of them.
    for (const raycast::MaterialRow& row : raycast::materialTable())
        if (row.material != raycast::Material::Matcap)
            QVERIFY(!picture(program, {"--material", row.id, "--shadows", "--ao", "--ground"}, "sample:moebius:3000")
                         .isNull());
}

void LightTest::shadowsDarkenAndAreCounted() {
    const Program program;
    const QImage plain = picture(program, {"--material", "clay", "--stats", "plain.json"});
    const QImage lit = picture(program, {"--material", "clay", "--shadows", "--ao", "--stats", "lit.json"});
    int darker = 0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            QVERIFY(qGreen(lit.pixel(column, row)) <= qGreen(plain.pixel(column, row)));
            darker += qGreen(lit.pixel(column, row)) + 10 < qGreen(plain.pixel(column, row)) ? 1 : 0;
        }
    QVERIFY2(darker > 150, qPrintable(QString::number(darker)));
    const json before = json::parse(program.read("plain.json")), after = json::parse(program.read("lit.json"));
    QCOMPARE(before.at("rays"), json(width * height));
    QCOMPARE(after.at("rays"), json(width * height));
    for (const char* key : {"shadow_rays", "occlusion_rays"})
        QVERIFY2(before.at(key) == 0 && after.at(key).get<int>() > 1000, key);
    QVERIFY(after.at("path_rays") == 0 && after.at("antialias_rays") == 0);
    picture(program, {"--material", "glass", "--stats", "glass.json"});
    QVERIFY(json::parse(program.read("glass.json")).at("path_rays").get<int>() > 1000);
}

void LightTest::theGroundHasAShadowOnly() {
    const Program program;
    const QImage plain = picture(program, {"--material", "clay", "--shadows", "--transparent"}, "sample:sphere:3000");
    const QImage ground =
        picture(program, {"--material", "clay", "--shadows", "--transparent", "--ground"}, "sample:sphere:3000");
    int shadow = 0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const QRgb a = plain.pixel(column, row), b = ground.pixel(column, row);
            if (qAlpha(a) == 255)
                QCOMPARE(a, b); // what is before the ground stays
            else if (qAlpha(b) > 0) {
                ++shadow;
                QVERIFY(qRed(b) == 0 && qGreen(b) == 0 && qBlue(b) == 0);
            }
        }
    QVERIFY2(shadow > 20, qPrintable(QString::number(shadow)));
}

void LightTest::edgesAreSmoothedAtTheirPixelsOnly() {
    const Program program;
    const QStringList sphere{"--shading", "studio", "--background", "plain", "--transparent", "--stats", "a.json"};
    const QImage sharp = picture(program, sphere, "sample:sphere:3000");
    const QImage smooth = picture(program, sphere + QStringList{"--antialias"}, "sample:sphere:3000");
    const json stats = json::parse(program.read("a.json"));
    int partial = 0, changed = 0;
    double covered = 0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const int a = qAlpha(sharp.pixel(column, row)), b = qAlpha(smooth.pixel(column, row));
            QVERIFY(a == 0 || a == 255);
            partial += b != 0 && b != 255 ? 1 : 0;
            changed += a != b ? 1 : 0;
            covered += b / 255.0;
        }
    // The outline is a circle seen under the angle asin(1/4): its area in pixels is known.
    const double focal = 30 / std::tan(20 * 3.14159265358979323846 / 180), radius = focal / std::sqrt(15.0);
    QVERIFY2(std::abs(covered - 3.14159265 * radius * radius) < 4, qPrintable(QString::number(covered)));
    QVERIFY(partial > 80 && partial < 400 && changed == partial);
    QCOMPARE(stats.at("rays"), json(width * height));
    const int more = stats.at("antialias_rays");
    QVERIFY2(more % 8 == 0 && more / 8 >= partial && more < 4 * width * height, qPrintable(QString::number(more)));
}

void LightTest::depthAsExrHoldsEveryPixel() {
    const Program program;
    picture(program, {"--depth", "a.exr"});
    const std::string exr = program.read("a.exr");
    const unsigned char magic[] = {0x76, 0x2f, 0x31, 0x01};
    QVERIFY(exr.size() > 400 && std::memcmp(exr.data(), magic, 4) == 0);
    QVERIFY(exr.find("channels") != std::string::npos && exr.find(std::string("Z\0\2\0\0\0", 6)) != std::string::npos);
    QCOMPARE(program.run({"render", "sample:knot:2000", "-o", "a.png", "--depth", "no/where/a.exr"}).code, 1);
}

void LightTest::whatDoesNotGoTogetherIsWrongUsage() {
    const Program program;
    const QList<QStringList> wrong{{"--material", "glass"},
                                   {"--shadows"},
                                   {"--ground", "--ao"},
                                   {"--antialias"},
                                   {"--lights", "sun"},
                                   {"--mode", "raycast", "--material", "wood"},
                                   {"--mode", "raycast", "--material", "clay", "--lights", "moon"},
                                   {"--mode", "raycast", "--material", "clay", "--lights", "0,0,0"},
                                   {"--mode", "raycast", "--material", "clay", "--lights", "1,2"},
                                   {"--mode", "raycast", "--lights", "sun"},
                                   {"--mode", "raycast", "--ground"},
                                   {"--mode", "raycast", "--material", "metal", "--shading", "wax"}};
    for (const auto& options : wrong) {
        const Outcome outcome = program.run(QStringList{"render", "sample:sphere:500", "-o", "a.png"} + options);
        QVERIFY2(outcome.code == 2 && !outcome.err.empty(), qPrintable(options.join(" ")));
    }
    const QStringList usual{"render", "sample:sphere:500", "-o", "a.png", "--size", "32x24", "--material", "matcap"};
    QCOMPARE(program.run(usual).code, 0);
}

static const test::Registered<LightTest> registered;
#include "light_test.moc"
