// Pictures and colours of faces, as the readers bring them.
#include "core/io/pictures/face_pictures.h"

#include "core/io/pictures/colour_png.h"
#include "io_support.h"
#include "support/registry.h"

#include <cmath>

using namespace std::string_literals;
using surfel::rgba;

class FacePicturesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void materialsPaintTheFacesOfAnObj();
    void materialsHoldAcrossALongFile();
    void materialsColourFacesWithoutPictures();
    void oneColourForAllTellsNothing();
    void picturesAreScaledAndMoved();
    void whatIsMissingIsOneWarning_data();
    void whatIsMissingIsOneWarning();
    void nothingOutsideOfTheFolderIsRead();
    void facesOfPlyHavePicturesAndColours();
    void facesOfOffHaveColours();
    void tornLibrariesNeverCrash();
};

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0 0\nvt 1 1\nvt 0 1\n";

std::string png(int width, int height, surfel::Colour colour) {
    return io::encodePng(std::vector<std::uint32_t>(std::size_t(width) * std::size_t(height), colour), width, height,
                         "");
}

} // namespace

void FacePicturesTest::materialsPaintTheFacesOfAnObj() {
    const test::Folder folder;
    std::filesystem::create_directory(folder.path("maps"));
    folder.write("maps/red one.png", png(2, 3, rgba(250, 0, 0)));
    folder.write("blue.png", png(1, 1, rgba(0, 0, 250)));
    folder.write("my look.mtl", "newmtl a\nKd 1 1 1\nmap_Kd -clamp on -s 1 1 1 maps\\red one.png\r\nnewmtl b c\n"
                                "map_kd C:\\elsewhere\\blue.png\nnewmtl plain\n");
    const io::FileModel model = io::read(folder.write(
        "a.obj",
        "mtllib my look.mtl\n" + square +
            "f 1/1 2/2 3/3\nusemtl a\nf 1/1/7 2/2 3/-2\nusemtl b c\r\nf 1/4 3/99 4/3\nusemtl plain\nf 1 2 4\n"));
    const mesh::Polygons& faces = model.polygons;
    QCOMPARE(faces.size(), std::size_t(4));
    QVERIFY(faces.painted() && faces.places.size() == 12 && model.messages.empty());
    const auto pictureOf = [&](std::size_t face) {
        return faces.pictureOf[face] < faces.pictures.size() ? faces.pictures[faces.pictureOf[face]].get() : nullptr;
    };
    QVERIFY(!pictureOf(0) && !pictureOf(3));
    QVERIFY(pictureOf(1)->clamped && pictureOf(1)->height == 3 && pictureOf(1)->at(0.5, 0.5) == rgba(250, 0, 0));
    QVERIFY(!pictureOf(2)->clamped && pictureOf(2)->at(0.5, 0.5) == rgba(0, 0, 250));
    QVERIFY(faces.places[4].u == 1 && faces.places[4].v == 0 && faces.places[5].u == 1 && faces.places[5].v == 1);
    QVERIFY(std::isnan(faces.places[7].u) && std::isnan(faces.places[9].u) && faces.places[6].v == 1);
}

void FacePicturesTest::materialsHoldAcrossALongFile() {
    const test::Folder folder;
    folder.write("m.png", png(1, 1, rgba(1, 2, 3)));
    folder.write("m.mtl", "newmtl a\nmap_Kd m.png\n");
    const std::string padding(3 << 20, '#'); // chunks of their own
    const io::FileModel model =
        io::read(folder.write("a.obj", "mtllib m.mtl\nusemtl a\n" + square + padding + "\nf 1/1 2/2 3/3\n" + padding +
                                           "\nf 1/1 3/3 4/4\nusemtl none\nf 1 2 4\n"));
    QCOMPARE(model.polygons.pictureOf, (std::vector<std::uint32_t>{0, 0, mesh::Polygons::noPicture}));
}

void FacePicturesTest::materialsColourFacesWithoutPictures() {
    const test::Folder folder;
    folder.write("m.png", png(1, 1, rgba(1, 2, 3)));
    folder.write("m.mtl",
                 "newmtl red\nKd 1 0 0.2\nnewmtl grey\nKd 0.5\nnewmtl map\nmap_Kd m.png\nKd 0 0 1\n"
                 "newmtl odd\nKd spectral a.rfl\nnewmtl out\nKd 7 -1 nan\nnewmtl gone\nKd 0 1 0\nmap_Kd n.png\n");
    const std::string faces =
        "f 1 2 3\nusemtl red\nf 1 2 3\nusemtl grey\nf 1 2 3\nusemtl map\nf 1/1 2/2 3/3\nusemtl odd\n"
        "f 1 2 3\nusemtl out\nf 1 2 3\nusemtl gone\nf 1/1 2/2 3/3\n";
    const io::FileModel model = io::read(folder.write("a.obj", "mtllib m.mtl\n" + square + faces));
    const mesh::Polygons& p = model.polygons;
    QCOMPARE(p.colours,
             (std::vector<surfel::Colour>{surfel::white, rgba(255, 0, 51), rgba(128, 128, 128), rgba(0, 0, 255),
                                          surfel::white, rgba(255, 0, 255), rgba(0, 255, 0)}));
    QVERIFY(p.pictures[p.pictureOf[3]] && !p.pictures[p.pictureOf[1]] && !p.pictures[p.pictureOf[6]]);
    QVERIFY(model.messages.size() == 1 && test::contains(model.messages[0], "'n.png'"));
    // Without places in pictures, colours are all there is; vertices' own colours are more.
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\n", plain = "usemtl red\nf 1 2 3\nusemtl grey\nf 1 2 3\n";
    const io::FileModel bare = io::read(folder.write("b.obj", "mtllib m.mtl\n" + corners + plain));
    QVERIFY(bare.polygons.painted() && bare.polygons.pictureOf.empty() && bare.polygons.places.empty());
    const std::string own = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\n";
    QVERIFY(!io::read(folder.write("c.obj", "mtllib m.mtl\n" + own + plain)).polygons.painted());
}

void FacePicturesTest::oneColourForAllTellsNothing() {
    const test::Folder folder;
    folder.write("m.mtl", "newmtl a\nKd 0.8 0.8 0.8\nnewmtl b\nKd 0.8 0.8 0.8\n");
    const io::FileModel model =
        io::read(folder.write("a.obj", "mtllib m.mtl\n" + square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n"));
    QVERIFY(!model.polygons.painted() && model.polygons.pictureOf.empty() && model.messages.empty());
}

void FacePicturesTest::picturesAreScaledAndMoved() {
    const test::Folder folder;
    folder.write("m.png", png(1, 1, rgba(1, 2, 3)));
    folder.write("m.mtl", "newmtl a\nmap_Kd -s 2 4 1 -o 0.5 -0.25 0 -t 9 9 9 m.png\nnewmtl b\nmap_Kd -o 3 m.png\n"
                          "newmtl c\nmap_Kd -s inf nan m.png\n");
    const io::FileModel model = io::read(folder.write("a.obj", "mtllib m.mtl\n" + square +
                                                                   "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\n"
                                                                   "usemtl c\nf 1/1 2/2 3/3\n"));
    const auto is = [&](std::size_t corner, float u, float v) {
        const mesh::Polygons::Place& place = model.polygons.places[corner];
        return place.u == u && place.v == v;
    };
    QVERIFY(is(0, 0.5f, -0.25f) && is(1, 2.5f, -0.25f) && is(2, 2.5f, 3.75f));
    QVERIFY(is(3, 3, 0) && is(5, 4, 1) && is(8, 1, 1));
}

void FacePicturesTest::whatIsMissingIsOneWarning_data() {
    QTest::addColumn<QByteArray>("library");
    QTest::addColumn<QByteArray>("image");
    const QByteArray named = "newmtl a\nmap_Kd m.png\n";
    QTest::newRow("library") << QByteArray() << QByteArray();
    QTest::newRow("picture") << named << QByteArray();
    QTest::newRow("broken") << named << QByteArray::fromStdString(png(20, 20, 5).substr(0, 60));
    QTest::newRow("no picture") << named << QByteArray("text");
    QTest::newRow("huge") << named << QByteArray::fromStdString(png(8200, 1, 5));
    QTest::newRow("two") << named + "newmtl b\nmap_Kd n.png\n" << QByteArray();
}

void FacePicturesTest::whatIsMissingIsOneWarning() {
    QFETCH(QByteArray, library);
    QFETCH(QByteArray, image);
    const test::Folder folder;
    if (!library.isEmpty())
        folder.write("m.mtl", library.toStdString());
    if (!image.isEmpty())
        folder.write("m.png", image.toStdString());
    const io::FileModel model = io::read(
        folder.write("a.obj", "mtllib m.mtl\n" + square + "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/4\n"));
    QVERIFY(model.polygons.size() == 2 && !model.polygons.painted());
    QCOMPARE(model.messages.size(), std::size_t(1));
    QVERIFY2(test::contains(model.messages[0], "left out"), model.messages[0].c_str());
}

void FacePicturesTest::nothingOutsideOfTheFolderIsRead() {
    const std::filesystem::path model = "/models/statue";
    for (const char* name : {"../b.png", "maps/../../b.png", "..\\b.png", "..", "", ".", "maps/.."})
        QVERIFY2(io::besideModel(model, name).empty(), name);
    QCOMPARE(io::besideModel(model, "maps/./c/../b.png"), std::filesystem::path("/models/statue/maps/b.png"));
    for (const char* name : {"/etc/b.png", "C:\\Users\\b.png", "b.png", "./b.png"})
        QCOMPARE(io::besideModel(model, name), std::filesystem::path("/models/statue/b.png"));
    const test::Folder folder;
    std::filesystem::create_directory(folder.path("sub"));
    folder.write("m.png", png(1, 1, 5));
    folder.write("sub/m.mtl", "newmtl a\nmap_Kd ../m.png\n");
    const io::FileModel read =
        io::read(folder.write("sub/a.obj", "mtllib m.mtl\n" + square + "usemtl a\nf 1/1 2/2 3/3\n"));
    QVERIFY(!read.polygons.painted() && test::anyContains(read.messages, "outside of the model's folder"));
}

void FacePicturesTest::facesOfPlyHavePicturesAndColours() {
    const test::Folder folder;
    folder.write("m.png", png(1, 1, rgba(10, 20, 30)));
    const std::string
        head = "ply\nformat ascii 1.0\ncomment TextureFile none.png\ncomment TextureFile m.png\nelement vertex 4\n"
               "property float x\nproperty float y\nproperty float z\n",
        corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    const io::FileModel lists = io::read(
        folder.write("a.ply", head +
                                  "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float "
                                  "texcoord\nproperty int texnumber\nend_header\n" +
                                  corners + "3 0 1 2 6 0 0 1 0 1 1 1\n3 0 2 3 2 0 0 -5\n"));
    QCOMPARE(lists.polygons.pictureOf, (std::vector<std::uint32_t>{1, mesh::Polygons::noPicture}));
    QVERIFY(lists.polygons.painted() && lists.polygons.pictures[1]->at(0, 0) == rgba(10, 20, 30));
    QVERIFY(lists.polygons.places[2].v == 1 && std::isnan(lists.polygons.places[3].u));
    const std::string own =
        "ply\nformat ascii 1.0\ncomment TextureFile m.png\nelement vertex 4\nproperty float x\nproperty float "
        "y\nproperty float z\nproperty float s\nproperty float t\n";
    const io::FileModel vertices =
        io::read(folder.write("b.ply", own + "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                                             "nan 0 0 9 9\n1 0 0 1 0.25\n1 1 0 1 1\n0 1 0 0 1\n3 1 2 3\n"));
    QVERIFY(vertices.polygons.painted() && vertices.polygons.places[0].v == 0.25f &&
            vertices.polygons.places[2].u == 0);
    const io::FileModel colours = io::read(folder.write(
        "c.ply",
        "ply\nformat ascii 1.0\nelement face 2\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "property list uchar int vertex_indices\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n1 2 3 3 0 1 2\n4 5 6 3 0 2 3\n" +
            corners));
    QCOMPARE(colours.polygons.colours, (std::vector<surfel::Colour>{rgba(1, 2, 3), rgba(4, 5, 6)}));
}

void FacePicturesTest::facesOfOffHaveColours() {
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write(
        "a.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 128 0\n3 0 2 3 0.5 0 1.0 0.3\n3 0 1 3 7\n"));
    QCOMPARE(model.polygons.colours,
             (std::vector<surfel::Colour>{rgba(255, 128, 0), rgba(128, 0, 255), surfel::white}));
    QVERIFY(io::read(folder.write("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n")).polygons.colours.empty());
}

/// Bytes of all kinds in libraries, and corners that name places that are not there.
void FacePicturesTest::tornLibrariesNeverCrash() {
    const test::Folder folder;
    folder.write("m.png", png(4, 4, 7));
    const std::string good = "newmtl a\nmap_Kd -clamp on -bm 1 m.png\nmap_Kd -o\nmap_Kd\nnewmtl\n";
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(300); ++k) {
        std::string library = good,
                    model = "mtllib m.mtl\nusemtl a\n" + square + "f 1/1 2/2 3/3\nf 1/-9 2/ 3//\nf 1/1e9 2/4 4/0\n";
        for (int hits = 0; hits < 4; ++hits) {
            library[random.below(library.size())] = static_cast<char>(random.below(256));
            model[random.below(model.size())] = static_cast<char>(random.below(256));
        }
        folder.write("m.mtl", library);
        const std::filesystem::path file = folder.write("a.obj", model);
        try {
            const io::FileModel read = io::read(file);
            QVERIFY(read.polygons.places.empty() || read.polygons.places.size() == read.polygons.corners.size());
            QVERIFY(read.polygons.pictureOf.empty() || read.polygons.pictureOf.size() == read.polygons.size());
        } catch (const base::Error&) {
        }
    }
}

static const test::Registered<FacePicturesTest> registered;
#include "face_pictures_test.moc"
