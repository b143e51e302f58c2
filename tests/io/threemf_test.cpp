// 3MF: what is to be built, where its items and components say, with colours; parts of their own; packages that are
// made to do harm.
#include "core/io/packed/zip_archive.h"

#include "io/io_support.h"
#include "support/registry.h"

class ThreemfTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void itemsAndComponentsPlaceMeshes();
    void partsOfTheirOwnAreFound();
    void coloursOfCornersAreThePointsWhereTheyAgree();
    void coloursOfFacesAreTheFaces();
    void trianglesMayLeaveOutTheGroup();
    void picturesAreThoseInside();
    void harmfulPackagesAreRefused_data();
    void harmfulPackagesAreRefused();
};

namespace {

constexpr const char* triangle =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices>
       <triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh>)";

std::string modelOf(const std::string& resources, const std::string& build) {
    return R"(<?xml version="1.0"?><model unit="inch" xmlns="a" xmlns:p="b"><resources>)" + resources +
           "</resources><build>" + build + "</build></model>";
}

std::filesystem::path packageIn(const test::Folder& folder,
                                const std::vector<std::pair<std::string, std::string>>& parts) {
    io::SafeFile file(folder.path("a.3mf"));
    io::ZipWriter zip(file);
    for (const auto& [name, content] : parts) {
        zip.begin(name);
        zip.write(content);
        zip.end();
    }
    zip.finish();
    file.commit();
    return folder.path("a.3mf");
}

io::FileModel readModel(const std::string& resources, const std::string& build) {
    const test::Folder folder;
    return io::read(packageIn(folder, {{"3D/3dmodel.model", modelOf(resources, build)}}));
}

} // namespace

void ThreemfTest::itemsAndComponentsPlaceMeshes() {
    const io::FileModel model = readModel(
        std::string(R"(<object id="1">)") + triangle +
            R"(</object><object id="2"><components><component objectid="1" transform="2 0 0 0 2 0 0 0 2 0 0 5"/>
                 <component objectid="1"/></components></object><object id="3">)" +
            triangle + "</object>",
        R"(<item objectid="2" transform="0 1 0 -1 0 0 0 0 1 10 0 0"/><item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>)");
    // x goes to y and y to -x, then 10 along x; object 3 is not to be built.
    const base::Vec3f expected[] = {{10, 0, 5}, {10, 2, 5}, {8, 0, 5},  {10, 0, 0}, {10, 1, 0},
                                    {9, 0, 0},  {0, 0, 0},  {-1, 0, 0}, {0, 1, 0}};
    QCOMPARE(model.points.size(), std::size_t(9));
    for (std::size_t i = 0; i < 9; ++i)
        QVERIFY2(model.points.items[i].position == expected[i], qPrintable(QString::number(i)));
    QVERIFY(model.polygons.corners == (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 8, 7, 6})); // mirrored
    QVERIFY(test::anyContains(model.comments, "unit inch"));
    QCOMPARE(model.usualUp, base::UpAxis::Z);
}

void ThreemfTest::partsOfTheirOwnAreFound() {
    const test::Folder folder;
    const std::string relations =
        R"(<Relationships><Relationship Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel" Target="/3D/root.model"/></Relationships>)";
    const io::FileModel model = io::read(packageIn(
        folder,
        {{"3D/other.model", modelOf(std::string(R"(<object id="1">)") + triangle + "</object>", "")},
         {"_rels/.rels", relations},
         {"3D/root.model",
          modelOf(
              R"(<object id="7"><components><component p:path="/3D/other.model" objectid="1"/></components></object>)",
              R"(<item objectid="7"/>)")}}));
    QCOMPARE(model.points.size(), std::size_t(3));
}

void ThreemfTest::coloursOfCornersAreThePointsWhereTheyAgree() {
    const io::FileModel model = readModel(
        R"(<colorgroup id="5"><color color="#FF0000"/><color color="#00FF0080"/><color color="#0000ff"/></colorgroup>
              <object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices>
              <triangles><triangle v1="0" v2="1" v3="2" pid="5" p1="2" p2="1" p3="0"/></triangles></mesh></object>)",
        R"(<item objectid="1"/>)");
    QVERIFY(model.points.layout->colours && model.polygons.colours.empty());
    QCOMPARE(model.points.items[0].colour, surfel::rgba(0, 0, 255));
    QCOMPARE(model.points.items[1].colour, surfel::rgba(0, 255, 0, 128));
    QCOMPARE(model.points.items[2].colour, surfel::rgba(255, 0, 0));
}

void ThreemfTest::coloursOfFacesAreTheFaces() {
    const io::FileModel model = readModel(
        R"(<basematerials id="5"><base name="a" displaycolor="#FF0000"/><base name="b" displaycolor="#0000FF"/></basematerials>
              <object id="1" pid="5" pindex="1"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="1" y="1" z="0"/></vertices>
              <triangles><triangle v1="0" v2="1" v3="2" pid="5" p1="0"/><triangle v1="1" v2="3" v3="2"/></triangles></mesh></object>)",
        R"(<item objectid="1"/>)");
    QVERIFY(!model.points.layout->colours);
    QVERIFY(model.polygons.colours == (std::vector<surfel::Colour>{surfel::rgba(255, 0, 0), surfel::rgba(0, 0, 255)}));
}

/// p1 to p3 are of the object's group then.
void ThreemfTest::trianglesMayLeaveOutTheGroup() {
    const io::FileModel model = readModel(
        R"(<colorgroup id="5"><color color="#FF0000"/><color color="#00FF00"/><color color="#0000FF"/></colorgroup>
              <object id="1" pid="5" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices>
              <triangles><triangle v1="0" v2="1" v3="2" p1="2" p2="1" p3="0"/></triangles></mesh></object>)",
        R"(<item objectid="1"/>)");
    QCOMPARE(model.points.items[0].colour, surfel::rgba(0, 0, 255));
    QCOMPARE(model.points.items[1].colour, surfel::rgba(0, 255, 0));
    QCOMPARE(model.points.items[2].colour, surfel::rgba(255, 0, 0));
}

/// A package reads nothing else of the machine, whatever it calls its pictures.
void ThreemfTest::picturesAreThoseInside() {
    const test::Folder folder;
    const std::string elsewhere = folder.write("elsewhere.png", "no picture").string();
    const io::FileModel model = readModel(
        R"(<texture2d id="6" path=")" + elsewhere +
            R"(" contenttype="image/png"/><texture2dgroup id="5" texid="6"><tex2coord u="0" v="0"/></texture2dgroup>
              <object id="1" pid="5" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices>
              <triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object>)",
        R"(<item objectid="1"/>)");
    QVERIFY(model.polygons.pictures.empty());
    QVERIFY2(test::anyContains(model.messages, "it is not in the file"),
             model.messages.empty() ? "no message" : model.messages.front().c_str());
}

void ThreemfTest::harmfulPackagesAreRefused_data() {
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* name, const std::string& model, const char* part) {
        QTest::newRow(name) << QString::fromStdString(model) << part;
    };
    const std::string mesh = std::string(R"(<object id="1">)") + triangle + "</object>",
                      item = R"(<item objectid="1"/>)";
    row("circle", modelOf(R"(<object id="1"><components><component objectid="1"/></components></object>)", item),
        "without end");
    std::string laughs = mesh;
    for (int i = 2; i < 30; ++i) {
        const std::string component = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
        laughs +=
            "<object id=\"" + std::to_string(i) + "\"><components>" + component + component + "</components></object>";
    }
    row("doubled 28 times", modelOf(laughs, R"(<item objectid="29"/>)"), "so often");
    row("entities", R"(<?xml version="1.0"?><!DOCTYPE model [<!ENTITY a "aaaa">]>)" + modelOf(mesh, item).substr(21),
        "is no XML");
    row("cut", modelOf(mesh, item).substr(0, 200), "is no XML");
    row("deep",
        modelOf(
            [] {
                std::string out;
                for (int i = 0; i < 200; ++i)
                    out += "<a>";
                return out;
            }(),
            ""),
        "is no XML");
    row("missing object", modelOf(mesh, R"(<item objectid="2"/>)"), "is not there");
    row("missing part", modelOf(mesh, R"(<item objectid="1" p:path="/3D/no.model"/>)"), "has no part");
    row("nothing", modelOf("", ""), "holds no points");
    row("no number", modelOf(R"(<object id="1"><mesh><vertices><vertex x="a"/></vertices></mesh></object>)", item),
        "has no number x");
}

void ThreemfTest::harmfulPackagesAreRefused() {
    QFETCH(QString, model);
    QFETCH(QString, part);
    const test::Folder folder;
    const auto path = packageIn(folder, {{"3D/3dmodel.model", model.toStdString()}});
    const std::string message = test::refusal(path);
    QVERIFY2(test::contains(message, part.toStdString()) && test::contains(message, path.string()), message.c_str());
}

static const test::Registered<ThreemfTest> registered;
#include "threemf_test.moc"
