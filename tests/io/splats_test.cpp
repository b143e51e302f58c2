// 3D Gaussian splats in PLY: which are kept, their colours, and what becomes of them on the way back.
#include "io/io_support.h"
#include "support/registry.h"

#include "core/base/random.h"
#include "core/surfel/shape.h"

#include <array>
#include <sstream>

class SplatsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void coloursComeFromTheZerothHarmonic();
    void transparentSplatsAreLeftOut();
    void facesFollowTheirSplats();
    void savedSplatsAreNotColouredAgain();
    void otherPointsWithOpacityStay();
    void normalsAndShapesAreTheCovariances();
    void sizesBeyondAllNumbersTellNothing();
};

namespace {

struct Splat {
    double opacity; ///< share
    double colour[3];
    std::string covariance = "-3 -4 -5 1.5 0 0.5 0"; ///< scales, then the quaternion
};

std::string splatFile(const std::vector<Splat>& splats, const std::string& faces = "") {
    std::string out = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(splats.size()) + "\n";
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2", "f_rest_0", "opacity",
                             "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"})
        out += std::string("property float ") + name + "\n";
    if (!faces.empty())
        out += "element face 1\nproperty list uchar int vertex_indices\n";
    out += "end_header\n";
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const Splat& s = splats[i];
        out += std::to_string(i) + " 0 1 0 0 0";
        for (const double c : s.colour)
            out += " " + std::to_string((c - 0.5) / 0.28209479177387814);
        out += " 7 " + std::to_string(std::log(s.opacity / (1 - s.opacity))) + " " + s.covariance + "\n";
    }
    return out + faces;
}

} // namespace

void SplatsTest::coloursComeFromTheZerothHarmonic() {
    const test::Folder folder;
    const io::FileModel model =
        io::read(folder.write("a.ply", splatFile({{0.5, {0, 0.5, 1}}, {0.99, {-3, 0.2, 4}}, {0.2, {0.1, 0.1, 0.1}}})));
    QCOMPARE(model.points.size(), std::size_t(3));
    QCOMPARE(model.points.items[0].colour, surfel::rgba(0, 128, 255, 128));
    QCOMPARE(model.points.items[1].colour, surfel::rgba(0, 51, 255, 252));
    QCOMPARE(model.points.items[2].colour, surfel::rgba(26, 26, 26, 51));
    const surfel::AttributeLayout& layout = *model.points.layout;
    QVERIFY(layout.colours && !layout.oriented); // normals are zeros in such files
    QVERIFY(!layout.find("f_dc_0") && !layout.find("f_rest_0"));
    QCOMPARE(surfel::read(*layout.find("scale_1"), model.points.extraOf(0)), -4.0);
    QCOMPARE(surfel::read(*layout.find("rot_0"), model.points.extraOf(0)), 1.5);
}

void SplatsTest::transparentSplatsAreLeftOut() {
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write(
        "a.ply", splatFile({{0.05, {0, 0, 0}}, {0.5, {0, 0, 0}}, {0.099, {0, 0, 0}}, {0.101, {0, 0, 0}}})));
    QCOMPARE(model.points.size(), std::size_t(2));
    QVERIFY(model.points.items[0].position.x == 1 && model.points.items[1].position.x == 3);
    QVERIFY(test::anyContains(model.messages, "2 of 4 were left out"));
    QVERIFY(test::contains(test::refusal(folder.write("b.ply", splatFile({{0.05, {0, 0, 0}}}))), "nearly transparent"));
}

void SplatsTest::facesFollowTheirSplats() {
    const test::Folder folder;
    const io::FileModel model =
        io::read(folder.write("a.ply", splatFile({{0.05, {}}, {0.5, {}}, {0.5, {}}, {0.5, {}}}, "3 1 2 3\n")));
    QVERIFY(model.polygons.corners == (std::vector<std::uint32_t>{0, 1, 2}));
}

void SplatsTest::savedSplatsAreNotColouredAgain() {
    const test::Folder folder;
    io::FileModel model = io::read(folder.write("a.ply", splatFile({{0.5, {0, 0.5, 1}}, {0.7, {0.3, 0.5, 1}}})));
    model.points.items[0].colour = surfel::rgba(1, 2, 3);
    io::write(folder.path("b.ply"), model);
    const io::FileModel back = io::read(folder.path("b.ply"));
    QVERIFY(test::sameBits(model, back));
    QVERIFY(back.messages.empty());
}

void SplatsTest::otherPointsWithOpacityStay() {
    const test::Folder folder;
    const io::FileModel model =
        io::read(folder.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                                       "property float y\nproperty float z\nproperty float opacity\n"
                                       "end_header\n1 2 3 -9\n4 5 6 0\n"));
    QCOMPARE(model.points.size(), std::size_t(2));
    QVERIFY(!model.points.layout->colours && model.points.layout->find("opacity"));
}

/// Of random ones, whatever the order of their axes and the length of their quaternions.
void SplatsTest::normalsAndShapesAreTheCovariances() {
    base::Random random(test::seed());
    std::vector<Splat> splats;
    std::vector<base::Vec3d> along, across, normal; // of each, the axes of its deviations
    std::vector<double> aspect, thinness;
    for (int k = 0; k < 40; ++k) {
        const base::Vec3d axis = random.unitVector();
        const double angle = random.uniform(-3, 3), length = random.uniform(0.6, 1.3), thin = random.uniform(1.1, 6);
        const double middle = std::exp(random.uniform(-6, 0)), wide = random.uniform(1, 6);
        std::array<double, 3> scale{middle * wide, middle, middle / thin};
        std::array<base::Vec3d, 3> unit{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        for (base::Vec3d& u : unit) // Rodrigues' turn
            u = u * std::cos(angle) + cross(axis, u) * std::sin(angle) + axis * (dot(axis, u) * (1 - std::cos(angle)));
        const std::size_t first = random.below(3);
        std::array<double, 3> inFile;
        for (std::size_t a = 0; a < 3; ++a)
            inFile[(first + a) % 3] = std::log(scale[a]);
        const double half = std::sin(angle / 2) * length;
        std::ostringstream said;
        for (const double each : {inFile[0], inFile[1], inFile[2], std::cos(angle / 2) * length, axis.x * half,
                                  axis.y * half, axis.z * half})
            said << each << ' ';
        splats.push_back({0.5, {}, said.str()});
        along.push_back(unit[first]), across.push_back(unit[(first + 1) % 3]), normal.push_back(unit[(first + 2) % 3]);
        aspect.push_back(wide), thinness.push_back(thin);
    }
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.ply", splatFile(splats)));
    const surfel::AttributeLayout& layout = *model.points.layout;
    QVERIFY(layout.normals && !layout.oriented && !model.hasSupports && surfel::shapeChannel(layout) > 0);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const QByteArray told = ("splat " + std::to_string(i) + ", seed " + std::to_string(test::seed())).c_str();
        const auto n = base::cast<double>(model.points.items[i].normal);
        if (std::abs(thinness[i] - 2) > 0.001)
            QVERIFY2(thinness[i] > 2 ? length(cross(n, normal[i])) < 1e-4 && length(n) > 0.999 : length(n) == 0, told);
        const auto b = base::cast<double>(surfel::shapeIn(model.points.extraOf(i), surfel::shapeWord(layout)));
        const double asked = std::min(aspect[i], double(surfel::mostAspect));
        QVERIFY2(std::abs(surfel::aspectOf(base::cast<float>(b)) - float(asked)) < 1e-3f, told);
        QVERIFY2(std::abs(dot(b, normal[i])) < 1e-4 && std::abs(dot(b, along[i])) < 1e-4, told);
    }
}

void SplatsTest::sizesBeyondAllNumbersTellNothing() {
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.ply", splatFile({{0.5, {}, "400 400 390 1 0 0 0"},
                                                                          {0.5, {}, "-400 -400 -400 1 0 0 0"},
                                                                          {0.5, {}, "0 0 0 0 0 0 0"}})));
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(model.points.items[i].normal == base::Vec3f{});
        QVERIFY(surfel::shapeIn(model.points.extraOf(i), surfel::shapeWord(*model.points.layout)) == base::Vec3f{});
    }
}

static const test::Registered<SplatsTest> registered;
#include "splats_test.moc"
