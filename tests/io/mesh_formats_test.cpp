// Vertices of meshes: OBJ, OFF and STL, each odd construct as a small literal.
#include "io/io_support.h"
#include "support/registry.h"

#include <set>

using base::Vec3f;
using io::FileModel;

class MeshFormatsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void objVerticesHaveColoursAndWeights_data();
    void objVerticesHaveColoursAndWeights();
    void objNormalsFollowTheCornersOfFaces();
    void objNormalsOfEqualCountBelongInOrder();
    void objNormalsWithoutOwnersAreLeftOut();
    void offHeadersOfEveryKindAreRead_data();
    void offHeadersOfEveryKindAreRead();
    void offNumbersMayStandInAnyLines();
    void objStatementsGoOnBehindABackslash();
    void stlCornersAreWeldedExactly();
    void asciiStlMayBeInCapitals();
    void stlNormalsPointOutwardAndAreUnit();
    void binaryStlMayCallItselfSolid();
    void damagedMeshesAreRefusedInOneSentence_data();
    void damagedMeshesAreRefusedInOneSentence();
    void contentIsBelievedMoreThanTheName();
};

static FileModel readAs(const std::string& name, const std::string& content) {
    const test::Folder folder;
    return io::read(folder.write(name, content));
}

void MeshFormatsTest::objVerticesHaveColoursAndWeights_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<unsigned>("colour");
    QTest::newRow("plain") << "v 1 2 3\nv 4 5 6\n" << surfel::white;
    QTest::newRow("weights") << "v 1 2 3 1.0\nv 4 5 6 0.5\n" << surfel::white;
    QTest::newRow("colours") << "v 1 2 3 0 0.5 1\nv 4 5 6 1 0 0\n" << surfel::rgba(0, 128, 255);
    QTest::newRow("colours to 255") << "v 1 2 3 0 128 255\nv 4 5 6 1 0 0\n" << surfel::rgba(0, 128, 255);
    QTest::newRow("weights and colours") << "v 1 2 3 1 0 0.5 1\nv 4 5 6 1 1 0 0\n" << surfel::rgba(0, 128, 255);
    QTest::newRow("blanks, comments, CRLF") << "# a\r\n  v\t1  2 3 # b\r\n\r\nvt 0 0\r\ng x\r\nv 4 5 6\r\n"
                                            << surfel::white;
}

void MeshFormatsTest::objVerticesHaveColoursAndWeights() {
    QFETCH(QString, text);
    QFETCH(unsigned, colour);
    const FileModel model = readAs("a.obj", text.toStdString());
    QCOMPARE(model.points.size(), std::size_t(2));
    QCOMPARE(model.points.items[0].position, Vec3f({1, 2, 3}));
    QCOMPARE(model.points.items[1].position, Vec3f({4, 5, 6}));
    QCOMPARE(model.points.items[0].colour, colour);
    QCOMPARE(model.points.layout->colours, colour != surfel::white);
}

void MeshFormatsTest::objNormalsFollowTheCornersOfFaces() {
    const FileModel model =
        readAs("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nvn 0 0 1\nvn 1 0 0\n"
                        "f 1//1 2/7/1 3//2\nf -4//-2 -3//-1 3//2\nf 1 2 3\nf 99//1 1//99 0//1 x//y /\n");
    QVERIFY(model.points.layout->normals);
    QCOMPARE(model.points.items[0].normal, Vec3f({0, 0, 1}));
    const float half = std::sqrt(0.5f);
    QVERIFY(base::distance(model.points.items[1].normal, Vec3f{half, 0, half}) < 1e-6f);
    QCOMPARE(model.points.items[2].normal, Vec3f({1, 0, 0}));
    QCOMPARE(model.points.items[3].normal, Vec3f());
    QCOMPARE(model.faces, std::size_t(4));
    QCOMPARE(model.polygons.size(), std::size_t(3));
    QVERIFY(test::anyContains(model.messages, "1 face was left out"));
}

void MeshFormatsTest::objNormalsOfEqualCountBelongInOrder() {
    const FileModel model = readAs("a.obj", "v 0 0 0\nvn 0 0 1\nv 1 0 0\nvn 0 2 0\n");
    QCOMPARE(model.points.items[0].normal, Vec3f({0, 0, 1}));
    QCOMPARE(model.points.items[1].normal, Vec3f({0, 1, 0}));
}

void MeshFormatsTest::objNormalsWithoutOwnersAreLeftOut() {
    const FileModel model = readAs("a.obj", "v 0 0 0\nv 1 0 0\nvn 0 0 1\nf 1 2 1\n");
    QVERIFY(!model.points.layout->normals);
    QVERIFY(test::anyContains(model.messages, "normals were left out"));
}

void MeshFormatsTest::offHeadersOfEveryKindAreRead_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("names");
    QTest::newRow("plain") << "OFF\n2 1 0\n1 2 3\n4 5 6\n3 0 1 0\n"
                           << "position";
    QTest::newRow("counts behind the word") << "OFF 2 0 0\n1 2 3\n4 5 6\n"
                                            << "position";
    QTest::newRow("no word") << "2 0 0\n1 2 3\n4 5 6\n"
                             << "position";
    QTest::newRow("no edges") << "OFF\n2 0\n1 2 3\n4 5 6\n"
                              << "position";
    QTest::newRow("comments") << "OFF # a\n\n# b\n2 0 0 # c\n1 2 3 # d\n#e\n4 5 6\n"
                              << "position";
    QTest::newRow("colours") << "COFF\n2 0 0\n1 2 3 255 0 0 255\n4 5 6 0 0 0 255\n"
                             << "position colour";
    QTest::newRow("colours in plain") << "OFF\n2 0 0\n1 2 3 255 0 0\n4 5 6 0 0 0\n"
                                      << "position colour";
    QTest::newRow("share colours") << "COFF\n2 0 0\n1 2 3 1 0 0 1\n4 5 6 0 0 0.5 1\n"
                                   << "position colour";
    QTest::newRow("normals") << "NOFF\n2 0 0\n1 2 3 0 0 1\n4 5 6 0 1 0\n"
                             << "position normal";
    QTest::newRow("colours and normals") << "CNOFF\n2 0 0\n1 2 3 0 0 1 255 0 0\n4 5 6 0 1 0 0 0 0\n"
                                         << "position normal colour";
    QTest::newRow("texture") << "STOFF\n2 0 0\n1 2 3 0.5 0.5\n4 5 6 0 1\n"
                             << "position column_4 column_5";
}

void MeshFormatsTest::offHeadersOfEveryKindAreRead() {
    QFETCH(QString, text);
    QFETCH(QString, names);
    const FileModel model = readAs("a.off", text.toStdString());
    QString found;
    for (const std::string& name : model.points.layout->names())
        found += (found.isEmpty() ? "" : " ") + QString::fromStdString(name);
    QCOMPARE(found, names);
    QCOMPARE(model.points.size(), std::size_t(2));
    QCOMPARE(model.points.items[1].position, Vec3f({4, 5, 6}));
    if (names.contains("colour"))
        QCOMPARE(model.points.items[0].colour, surfel::rgba(255, 0, 0));
    if (names.contains("normal"))
        QCOMPARE(model.points.items[1].normal, Vec3f({0, 1, 0}));
}

/// The same file with line breaks thrown anywhere, and with none.
void MeshFormatsTest::offNumbersMayStandInAnyLines() {
    const std::string head = "OFF", body = "4 2 0  0 0 0  1 0 0  0 1 0  0 0.5 1  3 0 1 2  4 0 1 2 3";
    const std::string lines = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0.5 1\n3 0 1 2\n4 0 1 2 3\n";
    const FileModel expected = readAs("a.off", lines);
    base::Random random(test::seed());
    for (int k = 0; k < 50; ++k) {
        std::string text = body;
        for (char& c : text)
            if (c == ' ' && k > 0 && random.below(3) == 0)
                c = '\n';
        if (k % 2 == 1)
            text += "\n# the end\n";
        const FileModel model = readAs("a.off", head + (k % 3 == 0 ? " " : "\n# free\n") + text);
        const QString where = QString("%1, seed %2").arg(text.c_str()).arg(test::seed());
        QVERIFY2(test::sameBits(model, expected) && model.faces == 2, qPrintable(where));
        QVERIFY2(model.polygons.corners == expected.polygons.corners, qPrintable(where));
    }
}

void MeshFormatsTest::objStatementsGoOnBehindABackslash() {
    const FileModel plain = readAs("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const char* end : {"\\\n", "\\\r\n"}) {
        const std::string e = end;
        const FileModel model =
            readAs("a.obj", "v 0 0 " + e + "0\nv" + e + " 1 0 0\nv 0 1 0\nf 1 " + e + "2 " + e + "3\n");
        QVERIFY(test::sameBits(model, plain));
        QVERIFY(model.polygons.corners == plain.polygons.corners);
    }
}

namespace {

/// A tetrahedron with outward normals.
constexpr Vec3f corners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, 1}};
constexpr int triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string asciiStl() {
    std::string out = "solid tetra\n";
    for (const auto& triangle : triangles) {
        out += "  facet normal 0 0 0\n    outer loop\n";
        for (const int c : triangle)
            out +=
                QString("      vertex %1 %2 %3\n").arg(corners[c].x).arg(corners[c].y).arg(corners[c].z).toStdString();
        out += "    endloop\n  endfacet\n";
    }
    return out + "endsolid tetra\n";
}

std::string binaryStl(const std::string& title) {
    std::string out = title + std::string(80 - title.size(), ' ') + std::string("\4\0\0\0", 4);
    const auto add = [&](float value) { out.append(reinterpret_cast<const char*>(&value), 4); };
    for (const auto& triangle : triangles) {
        add(0), add(0), add(0);
        for (const int c : triangle)
            add(corners[c].x), add(corners[c].y), add(corners[c].z);
        out += std::string(2, '\0');
    }
    return out;
}

} // namespace

void MeshFormatsTest::stlCornersAreWeldedExactly() {
    for (const std::string& content : {asciiStl(), binaryStl("made")}) {
        const FileModel model = readAs("a.stl", content);
        QCOMPARE(model.points.size(), std::size_t(4));
        QCOMPARE(model.faces, std::size_t(4));
        for (const Vec3f& corner : corners)
            QCOMPARE(std::count_if(model.points.items.begin(), model.points.items.end(),
                                   [&](const surfel::Surfel& s) { return s.position == corner; }),
                     std::ptrdiff_t(1));
    }
}

void MeshFormatsTest::asciiStlMayBeInCapitals() {
    const std::string capitals = QString::fromStdString(asciiStl()).toUpper().toStdString();
    QVERIFY(test::sameBits(readAs("a.stl", capitals), readAs("a.stl", asciiStl())));
}

void MeshFormatsTest::stlNormalsPointOutwardAndAreUnit() {
    for (const surfel::Surfel& s : readAs("a.stl", asciiStl()).points.items) {
        QVERIFY(std::abs(base::length(s.normal) - 1) < 1e-6f);
        QVERIFY(base::dot(s.normal, s.position - Vec3f{0.25f, 0.25f, 0.25f}) > 0);
    }
}

void MeshFormatsTest::binaryStlMayCallItselfSolid() {
    QCOMPARE(readAs("a.stl", binaryStl("solid angle_block")).format, std::string("stl binary"));
    QCOMPARE(readAs("a.stl", binaryStl("x") + "appended").points.size(), std::size_t(4));
    QCOMPARE(readAs("unknown", binaryStl("solid")).format, std::string("stl binary"));
    QCOMPARE(readAs("a.stl", asciiStl()).format, std::string("stl ascii"));
}

void MeshFormatsTest::damagedMeshesAreRefusedInOneSentence_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* tag, const char* name, const std::string& content, const char* part) {
        QTest::newRow(tag) << name << QByteArray(content.data(), static_cast<qsizetype>(content.size())) << part;
    };
    row("obj without points", "a.obj", "vn 0 0 1\nf 1 2 3\n", "holds no points");
    row("obj short vertex", "a.obj", "v 1 2 3\nv 1 2\n", "line 2: needs three numbers");
    row("obj short normal", "a.obj", "v 1 2 3\nvn 1\n", "line 2: needs three numbers");
    row("obj binary", "a.obj", std::string("v 1 2 3\0\1", 9), "is binary");
    row("off without counts", "a.off", "OFF\nmany\n", "does not say");
    row("off without points", "a.off", "OFF\n0 0 0\n", "holds no points");
    row("off cut", "a.off", "OFF\n3 1 0\n1 2 3\n4 5 6\n", "promises 3 vertices and 1 faces, but holds 2");
    row("off huge", "a.off", "OFF\n18446744073709551615 18446744073709551615 0\n1 2 3\n", "promises");
    row("off flat", "a.off", "OFF\n2 0 0\n1 2\n3 4\n", "where a vertex needs 3");
    row("off of four dimensions", "a.off", "4OFF\n1 0 0\n1 2 3 4\n", "dimensions");
    row("off binary", "a.off", "OFF BINARY\nxx", "binary OFF");
    row("stl short", "a.stl", "abc", "too short");
    row("stl cut", "a.stl", binaryStl("x").substr(0, 200), "promises 4 triangles, but there are bytes for 2");
    row("stl absurd", "a.stl", std::string(80, 'x') + "\xff\xff\xff\xff", "promises 4294967295");
    row("stl empty", "a.stl", std::string(80, 'x') + std::string(4, '\0'), "holds no points");
    row("stl ascii cut", "a.stl", asciiStl().substr(0, 300), "ends inside");
    row("stl ascii short", "a.stl", "solid\nvertex 1 2\nendsolid\n", "line 2: a vertex needs three");
    row("gzip", "a.obj", "\x1f\x8b\x08", "break off");
    row("glTF", "a.gltf", "no JSON", "JSON is damaged");
    row("3MF", "a.3mf", "no archive", "no 3MF file");
    row("ZIP", "a.ply", "PK\x03\x04", "in the format ZIP");
    row("unknown", "a.xyzzy", "\1\2\3", "no known format");
    row("las", "a.las", "whatever", "no LAS or LAZ file");
    row("pcd", "a.pcd", "VERSION 0.7\n", "DATA");
    row("laz", "a.laz", "1 2 3\n", "no LAS or LAZ file");
    row("e57", "a.E57", "1 2 3\n", "no E57 file");
}

void MeshFormatsTest::damagedMeshesAreRefusedInOneSentence() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(QString, part);
    const test::Folder folder;
    const auto path = folder.write(name.toStdString(), content.toStdString());
    const std::string message = test::refusal(path);
    QVERIFY2(test::contains(message, part.toStdString()), message.c_str());
    QVERIFY2(test::contains(message, path.string()), message.c_str());
    QVERIFY2(!test::contains(message, "\n") && message.size() < path.string().size() + 250, message.c_str());
}

void MeshFormatsTest::contentIsBelievedMoreThanTheName() {
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n";
    for (const char* name : {"a.xyz", "a.obj", "a.stl", "a", "a.PLY", "a.unknown", "a.las", "a.E57"})
        QCOMPARE(readAs(name, ply).format, std::string("ply ascii"));
    QCOMPARE(readAs("a.ply", "OFF\n1 0 0\n1 2 3\n").format, std::string("off"));
    const test::Folder folder;
    QVERIFY(test::contains(test::refusal(folder.path("missing.ply")), "cannot be opened"));
    QVERIFY(test::contains(test::refusal(folder.path("")), "is a folder"));
    const FileModel model = readAs("a.xyz", "1 2 3\n");
    QVERIFY_EXCEPTION_THROWN(io::write(folder.path("a.stl"), model), base::Error);
    QVERIFY_EXCEPTION_THROWN(io::write(folder.path("noname"), model), base::Error);
    QCOMPARE(folder.entries(), std::size_t(0));
    std::set<std::string> ids, extensions;
    for (const io::FormatRow& row : io::formatTable()) {
        QVERIFY2(row.read || row.write, row.id);
        QVERIFY2(ids.insert(row.id).second, row.id);
        for (const QString& extension : QString(row.extensions).split(' '))
            QVERIFY2(extensions.insert(extension.toStdString()).second, qPrintable(extension));
    }
}

static const test::Registered<MeshFormatsTest> registered;
#include "mesh_formats_test.moc"
