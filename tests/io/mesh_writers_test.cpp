#include "core/io/mesh_formats.h"

#include "io/mesh_file_readers.h"
#include "io_support.h"
#include "support/registry.h"

using base::Vec3d, base::Vec3f, mesh::Mesh;
using mesh_files::Found, mesh_files::take;

class MeshWritersTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyFormatBringsTheMeshBack_data();
    void everyFormatBringsTheMeshBack();
    void ourReadersFindTheVertices_data();
    void ourReadersFindTheVertices();
    void plyKeepsFurtherAttributes();
    void stlFarFromTheOriginIsText();
    void emptyMeshesAreWritten();
    void unknownExtensionsAreRefused();
};

namespace {

/// A triangle soup of random vertices, all of them used.
Mesh randomMesh(base::Random& random, bool attributes) {
    Mesh out;
    for (std::uint32_t v = 0; v < 3 * 40; ++v) {
        out.positions.push_back(random.unitVector() * random.uniform(0.1, 3));
        if (attributes) {
            out.normals.push_back(base::cast<float>(random.unitVector()));
            out.colours.push_back(static_cast<surfel::Colour>(random.next()) | 0xff000000u);
            out.masks.push_back(static_cast<float>(random.uniform()));
        }
        if (v % 3 == 2)
            out.triangles.push_back({v - 2, v - 1, v});
    }
    for (std::uint32_t i = 0; i < 100; ++i) {
        const auto any = [&] { return static_cast<std::uint32_t>(random.below(out.positions.size())); };
        out.triangles.push_back({any(), any(), any()});
    }
    return out;
}

void everyFormat() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<bool>("attributes");
    QTest::addColumn<bool>("far");
    for (const io::MeshFormatRow& row : io::meshFormatTable())
        for (const bool attributes : {false, true})
            for (const bool far : {false, true})
                QTest::addRow("%s%s%s", row.id, attributes ? " with attributes" : "", far ? " far away" : "")
                    << row.id << attributes << far;
}

/// A mesh in a file, as the row of everyFormat() says.
struct Written {
    std::string format;
    bool full = false, distant = false;
    Mesh mesh;
    Vec3d origin;
    test::Folder folder;
    std::filesystem::path path;

    Written() {
        QFETCH(QString, extension);
        QFETCH(bool, attributes);
        QFETCH(bool, far);
        format = extension.toStdString();
        full = attributes, distant = far;
        base::Random random(test::seed());
        mesh = randomMesh(random, full);
        origin = distant ? Vec3d{637000.25, 851000.5, -400} : Vec3d{};
        path = folder.path("a." + format);
        io::writeMesh(path, mesh, origin);
    }
};

} // namespace

void MeshWritersTest::everyFormatBringsTheMeshBack_data() {
    everyFormat();
}

void MeshWritersTest::everyFormatBringsTheMeshBack() {
    const Written w;
    const Mesh& mesh = w.mesh;
    QCOMPARE(w.folder.entries(), std::size_t(1));
    const Found found = mesh_files::readers.at(w.format)(test::contentOf(w.path));
    QCOMPARE(found.triangles.size(), mesh.triangles.size());
    const bool stl = w.format == "stl", glb = w.format == "glb";
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& inside = mesh.positions[mesh.triangles[f][k]];
            const Vec3d expected = (glb ? base::cast<double>(base::cast<float>(inside)) : inside) + w.origin;
            const Vec3d got = found.positions[found.triangles[f][k]];
            QVERIFY2(got == (stl && !w.distant ? base::cast<double>(base::cast<float>(expected)) : expected),
                     "the same doubles");
            QVERIFY(stl || found.triangles[f] == mesh.triangles[f]);
        }
    if (stl || !w.full)
        return;
    QCOMPARE(found.normals.size(), w.format == "3mf" ? 0 : mesh.positions.size());
    QCOMPARE(found.colours.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        QVERIFY(found.normals.empty() || base::cast<float>(found.normals[i]) == mesh.normals[i]);
        for (unsigned k = 0; k < 4; ++k)
            QCOMPARE(unsigned(found.colours[i][k]), mesh.colours[i] >> (8 * k) & 0xff);
    }
}

void MeshWritersTest::ourReadersFindTheVertices_data() {
    everyFormat();
}

void MeshWritersTest::ourReadersFindTheVertices() {
    const Written w;
    const Mesh& mesh = w.mesh;
    const io::FileModel model = io::read(w.path);
    QCOMPARE(model.faces, mesh.triangles.size());
    QCOMPARE(model.points.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const surfel::Surfel& s = model.points.items[i];
        QVERIFY(base::distance(base::cast<double>(s.position) + model.origin, mesh.positions[i] + w.origin) < 1e-6);
        if (!w.full || w.format == "stl")
            continue;
        QVERIFY(w.format == "3mf" || base::distance(s.normal, mesh.normals[i]) < 1e-6f);
        QCOMPARE(s.colour, mesh.colours[i]);
        if (w.format == "ply")
            QCOMPARE(s.mask, mesh.masks[i]);
    }
}

void MeshWritersTest::plyKeepsFurtherAttributes() {
    base::Random random(test::seed());
    Mesh mesh = randomMesh(random, true);
    auto layout = std::make_shared<surfel::AttributeLayout>();
    for (const auto& [name, type] :
         {std::pair("scan", surfel::ScalarType::UInt8), std::pair("line", surfel::ScalarType::Int16),
          std::pair("intensity", surfel::ScalarType::Float32), std::pair("time", surfel::ScalarType::Float64)})
        layout->add(name, type);
    mesh.layout = layout;
    mesh.extra.resize(mesh.positions.size() * layout->words());
    const auto valueOf = [](std::size_t vertex, std::size_t attribute) {
        return double((vertex * 7 + attribute * 31) % 100) + (attribute == 3 ? 0.125 : 0);
    };
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        for (std::size_t a = 0; a < 4; ++a)
            write(layout->attributes()[a], {mesh.extra.data() + v * layout->words(), layout->words()}, valueOf(v, a));
    const test::Folder folder;
    io::writeMesh(folder.path("a.ply"), mesh);
    const io::FileModel back = io::read(folder.path("a.ply"));
    QVERIFY(back.points.layout->attributes() == layout->attributes());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        for (std::size_t a = 0; a < 4; ++a)
            QCOMPARE(read(layout->attributes()[a], back.points.extraOf(v)), valueOf(v, a));
    QCOMPARE(back.faces, mesh.triangles.size());
}

void MeshWritersTest::stlFarFromTheOriginIsText() {
    base::Random random(test::seed());
    const Mesh mesh = randomMesh(random, false);
    const test::Folder folder;
    io::writeMesh(folder.path("near.stl"), mesh);
    io::writeMesh(folder.path("far.stl"), mesh, {1e6, 0, 0});
    QCOMPARE(io::read(folder.path("near.stl")).format, std::string("stl binary"));
    QCOMPARE(io::read(folder.path("far.stl")).format, std::string("stl ascii"));
    // Normals of facets are unit and right-handed.
    const Found found = mesh_files::readStlFile(test::contentOf(folder.path("near.stl")));
    for (std::size_t f = 0; f < 40; ++f) {
        const Vec3d across = cross(found.positions[3 * f + 1] - found.positions[3 * f],
                                   found.positions[3 * f + 2] - found.positions[3 * f]);
        QVERIFY(base::distance(base::normalized(across), found.normals[f]) < 1e-4);
    }
}

void MeshWritersTest::emptyMeshesAreWritten() {
    const test::Folder folder;
    for (const io::MeshFormatRow& row : io::meshFormatTable()) {
        const auto path = folder.path(std::string("a.") + row.id);
        io::writeMesh(path, {});
        QVERIFY2(mesh_files::readers.at(row.id)(test::contentOf(path)).triangles.empty(), row.id);
    }
}

void MeshWritersTest::unknownExtensionsAreRefused() {
    const test::Folder folder;
    for (const char* name : {"a.xyz", "a", "a.plyx"})
        QVERIFY_EXCEPTION_THROWN(io::writeMesh(folder.path(name), {}), base::Error);
    QCOMPARE(folder.entries(), std::size_t(0));
    QVERIFY(io::meshFormatOf("B.STL") != nullptr);
}

static const test::Registered<MeshWritersTest> registered;
#include "mesh_writers_test.moc"
