// Faces of every format, as the readers bring them.
#include "io_support.h"
#include "support/registry.h"

using namespace std::string_literals;

class FileFacesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyFormatBringsTheSameFaces_data();
    void everyFormatBringsTheSameFaces();
    void facesFollowTheirPointsWhenOthersAreDropped();
    void facesWithoutTheirPointsAreLeftOut();
    void stripsBecomeTriangles();
    void negativeCornersCountBack();
};

namespace {

std::vector<std::vector<std::uint32_t>> facesOf(const io::FileModel& model) {
    std::vector<std::vector<std::uint32_t>> out;
    for (std::size_t i = 0; i < model.polygons.size(); ++i)
        out.emplace_back(model.polygons.face(i).begin(), model.polygons.face(i).end());
    return out;
}

const std::string plyHead = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                            "property float z\n";
const std::string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

} // namespace

void FileFacesTest::everyFormatBringsTheSameFaces_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    const auto row = [](const char* name, const std::string& content) {
        QTest::newRow(name) << QString(name) << QByteArray::fromStdString(content);
    };
    row("a.ply", plyHead +
                     "element face 2\nproperty uchar quality\nproperty list uchar int vertex_indices\nend_header\n" +
                     corners + "7 3 0 1 2\n7 3 0 2 3\n");
    row("b.ply", "ply\nformat binary_big_endian 1.0\nelement face 2\nproperty list uchar ushort vertex_index\n"
                 "element vertex 4\nproperty char x\nproperty char y\nproperty char z\nend_header\n"s +
                     "\3\0\0\0\1\0\2\3\0\0\0\2\0\3"s + "\0\0\0\1\0\0\1\1\0\0\1\0"s);
    row("c.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 1 3 4\n");
    row("d.off", "OFF\n4 2 0\n" + corners + "3 0 1 2\n3 0 2 3 255 0 0\n");
    std::string stl = "solid s\n";
    for (const char* t : {"vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n", "vertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\n"})
        stl += "facet normal 0 0 1\nouter loop\n"s + t + "endloop\nendfacet\n";
    row("e.stl", stl + "endsolid s\n");
}

void FileFacesTest::everyFormatBringsTheSameFaces() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write(name.toStdString(), content.toStdString()));
    QCOMPARE(model.faces, std::size_t(2));
    QCOMPARE(facesOf(model), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 2, 3}}));
}

void FileFacesTest::facesFollowTheirPointsWhenOthersAreDropped() {
    const test::Folder folder;
    const io::FileModel model =
        io::read(folder.write("a.obj", "v 0 0 0\nv nan 0 0\nv 1 0 0\nv 1 1 0\nf 1 3 4\nf 1 2 3\n"));
    QCOMPARE(facesOf(model), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}}));
    QVERIFY(test::anyContains(model.messages, "1 face was left out"));
}

void FileFacesTest::facesWithoutTheirPointsAreLeftOut() {
    const test::Folder folder;
    for (const auto& [name, content] :
         {std::pair{"a.ply"s, plyHead + "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
                                  corners + "3 0 1 4\n4 0 1 2 3\n"},
          {"b.ply"s, plyHead + "element face 2\nproperty list uchar int vertex_indices\nend_header\n" + corners +
                         "3 0 -1 2\n4 0 1 2 3\n"},
          {"c.off"s, "OFF\n4 2 0\n" + corners + "3 0 1 99\n4 0 1 2 3\n"},
          {"d.obj"s, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 99\nf 1 2 3 4\n"}}) {
        const io::FileModel model = io::read(folder.write(name, content));
        QCOMPARE(facesOf(model), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3}}));
        QVERIFY2(test::anyContains(model.messages, "1 face was left out"), name.c_str());
    }
}

void FileFacesTest::stripsBecomeTriangles() {
    const test::Folder folder;
    const io::FileModel model = io::read(
        folder.write("a.ply", plyHead + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                                  corners + "8 0 1 2 3 -1 1 2 3\n"));
    QCOMPARE(facesOf(model), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {2, 1, 3}, {1, 2, 3}}));
}

void FileFacesTest::negativeCornersCountBack() {
    const test::Folder folder;
    const io::FileModel model =
        io::read(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4//1 -2 -1\n"));
    QCOMPARE(facesOf(model), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 2, 3}}));
}

static const test::Registered<FileFacesTest> registered;
#include "file_faces_test.moc"
