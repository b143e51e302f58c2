// glTF: clouds with all that they have, nodes that place meshes, pictures inside of the file, and claims that no bytes
// stand behind.
#include "core/io/pictures/colour_png.h"

#include "io/io_support.h"
#include "support/registry.h"

#include <QByteArray>

class GltfTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void cloudsComeBack_data();
    void cloudsComeBack();
    void nodesPlaceMeshes();
    void mirroredMeshesKeepTheirOutside();
    void picturesInsidePaintFaces();
    void coloursAreLinear();
    void primitivesMayShareVertices();
    void buffersBesideTheFileAreRead();
    void claimsAreNotBelieved_data();
    void claimsAreNotBelieved();
};

namespace {

template <class T>
void put(std::string& out, std::initializer_list<T> values) {
    for (const T value : values)
        out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// One triangle: 36 bytes of corners, 12 of numbers.
std::string triangleBytes() {
    std::string out;
    put<float>(out, {0, 0, 0, 1, 0, 0, 0, 1, 0});
    put<std::uint32_t>(out, {0, 1, 2});
    return out;
}

std::string embedded(const std::string& bytes) {
    return "data:application/octet-stream;base64," +
           QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())).toBase64().toStdString();
}

/// The triangle in a scene with these nodes.
std::string sceneOf(const std::string& nodes, const std::string& roots, const std::string& uri,
                    const std::string& more = "", const std::string& accessors = "") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" + roots + R"(}],"nodes":)" + nodes +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":48,"uri":")" +
           uri +
           R"("}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12}],"accessors":)" +
           (accessors.empty()
                ? R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}])"
                : accessors) +
           more + "}";
}

io::FileModel readScene(const std::string& text) {
    const test::Folder folder;
    return io::read(folder.write("a.gltf", text));
}

std::string glbOf(std::string json, const std::string& binary) {
    json.append((4 - json.size() % 4) % 4, ' ');
    std::string out = "glTF";
    put<std::uint32_t>(out, {2, static_cast<std::uint32_t>(28 + json.size() + binary.size()),
                             static_cast<std::uint32_t>(json.size())});
    out += "JSON" + json;
    put<std::uint32_t>(out, {static_cast<std::uint32_t>(binary.size())});
    return out + std::string("BIN\0", 4) + binary;
}

} // namespace

void GltfTest::cloudsComeBack_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("binary") << "a.glb";
    QTest::newRow("text") << "a.gltf";
}

void GltfTest::cloudsComeBack() {
    QFETCH(QString, name);
    base::Random random(test::seed());
    const test::Folder folder;
    for (int round = 0; round < 30; ++round) {
        const io::FileModel model = test::randomModel(random, 1 + random.below(50));
        const auto path = folder.path(name.toStdString());
        io::write(path, model);
        const io::FileModel back = io::read(path);
        QCOMPARE(back.points.size(), model.points.size());
        QCOMPARE(back.hasSupports, model.hasSupports);
        QCOMPARE(back.points.layout->normals, model.points.layout->normals);
        QCOMPARE(back.points.layout->colours, model.points.layout->colours);
        const bool far = !(model.origin == base::Vec3d{});
        for (std::size_t i = 0; i < model.points.size(); ++i) {
            const surfel::Surfel &a = model.points.items[i], &b = back.points.items[i];
            QVERIFY(far || test::sameBits(a.position, b.position));
            const base::Vec3d was = base::cast<double>(a.position) + model.origin;
            QVERIFY(base::distance(was, base::cast<double>(b.position) + back.origin) <= 1e-6 * (1 + length(was)));
            QVERIFY(test::sameBits(a.normal, b.normal) && test::sameBits(a.support, b.support));
            QVERIFY(a.colour == b.colour && test::sameBits(a.mask, b.mask));
            for (const surfel::Attribute& attribute : model.points.layout->attributes()) {
                const surfel::Attribute* found = back.points.layout->find(attribute.name);
                const bool fits =
                    attribute.type == surfel::ScalarType::Float32 || attribute.type <= surfel::ScalarType::UInt16;
                QCOMPARE(found != nullptr, fits);
                QVERIFY(!fits || (found->type == attribute.type && surfel::read(attribute, model.points.extraOf(i)) ==
                                                                       surfel::read(*found, back.points.extraOf(i))));
                QCOMPARE(test::contains(io::lossOf(path, model), attribute.name), !fits);
            }
        }
    }
}

void GltfTest::nodesPlaceMeshes() {
    // Once 10 along x with twice the size, and below that a quarter turn about z; once by a matrix.
    const io::FileModel model = readScene(sceneOf(
        R"([{"translation":[10,0,0],"scale":[2,2,2],"children":[1]},{"mesh":0,"rotation":[0,0,0.70710678118654752,0.70710678118654752]},
            {"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]},{"mesh":0}])",
        "[0,2]", embedded(triangleBytes())));
    QCOMPARE(model.points.size(), std::size_t(6)); // the last node is in no scene
    const base::Vec3f expected[] = {{10, 0, 0}, {10, 2, 0}, {8, 0, 0}, {5, 6, 7}, {6, 6, 7}, {5, 7, 7}};
    for (std::size_t i = 0; i < 6; ++i)
        QVERIFY2(base::distance(model.points.items[i].position, expected[i]) < 1e-5f, qPrintable(QString::number(i)));
    QVERIFY(model.polygons.corners == (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
    QCOMPARE(model.faces, std::size_t(2));
    QVERIFY(test::anyContains(model.comments, "unit meter"));
}

void GltfTest::mirroredMeshesKeepTheirOutside() {
    const io::FileModel model =
        readScene(sceneOf(R"([{"mesh":0,"scale":[-1,1,1]}])", "[0]", embedded(triangleBytes())));
    QVERIFY(model.polygons.corners == (std::vector<std::uint32_t>{0, 2, 1}));
}

void GltfTest::picturesInsidePaintFaces() {
    const std::uint32_t pixels[] = {0xff0000ffu, 0xff00ff00u, 0xffff0000u, 0xffffffffu};
    std::string bytes = triangleBytes();
    put<float>(bytes, {0.25f, 0.25f, 0.75f, 0.25f, 0.25f, 0.75f});
    const std::string png = io::encodePng(pixels, 2, 2, "a");
    const std::string json =
        R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":0}]}],
            "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],"images":[{"bufferView":3,"mimeType":"image/png"}],
            "buffers":[{"byteLength":)" +
        std::to_string(bytes.size() + png.size()) +
        R"(}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12},{"buffer":0,"byteOffset":48,"byteLength":24},{"buffer":0,"byteOffset":72,"byteLength":)" +
        std::to_string(png.size()) +
        R"(}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"},{"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"}]})";
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.glb", glbOf(json, bytes + png)));
    QVERIFY2(model.messages.empty(), model.messages.empty() ? "" : model.messages.front().c_str());
    QVERIFY(model.polygons.painted());
    QCOMPARE(model.polygons.places.size(), std::size_t(3));
    const surfel::Colour expected[] = {pixels[0], pixels[1], pixels[2]}; // (0, 0) is the upper left corner in glTF
    for (std::size_t i = 0; i < 3; ++i) {
        const mesh::Polygons::Place& place = model.polygons.places[i];
        QCOMPARE(model.polygons.pictures[0]->at(double(place.u), double(place.v)), expected[i]);
    }
}

void GltfTest::coloursAreLinear() {
    io::FileModel model;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->colours = true;
    model.points.layout = layout;
    for (unsigned v = 0; v < 256; ++v) {
        surfel::Surfel s;
        s.position = {float(v), 0, 1};
        s.colour = surfel::rgba(v, 255 - v, v, v);
        model.points.append(s, {});
    }
    const test::Folder folder;
    io::write(folder.path("a.glb"), model);
    const std::string bytes = test::contentOf(folder.path("a.glb"));
    std::uint16_t middle = 0; // red of point 188, half as bright as white
    std::memcpy(&middle, bytes.data() + bytes.size() - 256 * 8 + 188 * 8, 2);
    QVERIFY2(std::abs(double(middle) / 65535 - 0.5029) < 1e-3, qPrintable(QString::number(middle)));
    const io::FileModel back = io::read(folder.path("a.glb"));
    for (std::size_t i = 0; i < 256; ++i)
        QCOMPARE(back.points.items[i].colour, model.points.items[i].colour);
}

/// Two triangles of one list of four vertices, each with a colour of its own: the points of each are its three.
void GltfTest::primitivesMayShareVertices() {
    std::string bytes;
    put<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    put<std::uint32_t>(bytes, {0, 1, 2, 1, 3, 2});
    const io::FileModel model = readScene(
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[
            {"attributes":{"POSITION":0},"indices":1,"material":0},{"attributes":{"POSITION":0},"indices":2,"material":1}]}],
            "materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}},{"pbrMetallicRoughness":{"baseColorFactor":[0,0,1,1]}}],
            "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],"accessors":[
            {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"},
            {"bufferView":1,"byteOffset":12,"componentType":5125,"count":3,"type":"SCALAR"}],"buffers":[{"byteLength":72,"uri":")" +
        embedded(bytes) + R"("}]})");
    QCOMPARE(model.points.size(), std::size_t(6));
    QVERIFY(model.polygons.corners == (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 4}));
    for (std::size_t i = 0; i < 6; ++i)
        QCOMPARE(model.points.items[i].colour, i < 3 ? surfel::rgba(255, 0, 0) : surfel::rgba(0, 0, 255));
    QVERIFY(model.points.items[5].position == (base::Vec3f{1, 1, 0})); // in the list's order: 1, 2, 3
}

void GltfTest::buffersBesideTheFileAreRead() {
    const test::Folder folder;
    folder.write("a b.bin", triangleBytes());
    const std::string nodes = R"([{"mesh":0}])";
    QCOMPARE(io::read(folder.write("a.gltf", sceneOf(nodes, "[0]", "a%20b.bin"))).points.size(), std::size_t(3));
    for (const char* name : {"missing.bin", "../a%20b.bin"})
        QVERIFY(test::contains(test::refusal(folder.write("b.gltf", sceneOf(nodes, "[0]", name))), "not beside it"));
}

void GltfTest::claimsAreNotBelieved_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* name, const std::string& content, const char* part) {
        QTest::newRow(name) << QByteArray(content.data(), static_cast<qsizetype>(content.size())) << part;
    };
    const std::string nodes = R"([{"mesh":0}])", uri = embedded(triangleBytes());
    const auto accessors = [&](const std::string& first) {
        return sceneOf(nodes, "[0]", uri, "",
                       "[" + first + R"(,{"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}])");
    };
    row("count", accessors(R"({"bufferView":0,"componentType":5126,"count":4000000000,"type":"VEC3"})"),
        "promises 4000000000 values, but there are bytes for 3");
    row("stride", accessors(R"({"bufferView":0,"componentType":5126,"count":3,"type":"MAT4"})"), "bytes for 0");
    row("no view", accessors(R"({"componentType":5126,"count":4000000000,"type":"VEC3"})"), "sparse");
    row("offset",
        accessors(R"({"bufferView":0,"byteOffset":18446744073709551615,"componentType":5126,"count":3,"type":"VEC3"})"),
        "bytes for 0");
    row("view", accessors(R"({"bufferView":7,"componentType":5126,"count":3,"type":"VEC3"})"), "outside");
    row("type", accessors(R"({"bufferView":0,"componentType":1,"count":3,"type":"VEC3"})"), "no type");
    row("no points", sceneOf("[{}]", "[0]", uri), "holds no points");
    row("packed", sceneOf(nodes, "[0]", uri, R"(,"extensionsRequired":["KHR_draco_mesh_compression"])"), "compression");
    row("old", R"({"asset":{"version":"1.0"}})", "is no glTF 2.0");
    row("no JSON", "{\"asset\":", "JSON is damaged");
    row("deep", std::string(1000, '['), "nested");
    row("cut", glbOf(sceneOf(nodes, "[0]", uri), "").substr(0, 100), "promised");
    row("version 1", std::string("glTF\1\0\0\0", 8) + std::string(20, '\0'), "of version 1");
    std::string many = "[";
    for (int i = 0; i < 1000; ++i)
        many += R"({"mesh":0},)";
    std::string roots = "[";
    for (int i = 0; i < 1000; ++i)
        roots += std::to_string(i) + ",";
    // A mesh that is placed again and again, with all its corners.
    std::string large;
    for (int i = 0; i < 2000; ++i)
        put<float>(large, {float(i), 0, 1});
    row("without end",
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":)" + roots + R"(0]}],"nodes":)" + many +
            R"({}],"meshes":[{"primitives":[{"mode":0,"attributes":{"POSITION":0}}]}],"buffers":[{"uri":")" +
            embedded(large) +
            R"("}],"bufferViews":[{"buffer":0,"byteLength":24000}],"accessors":[{"bufferView":0,"componentType":5126,"count":2000,"type":"VEC3"}]})",
        "so often");
}

void GltfTest::claimsAreNotBelieved() {
    QFETCH(QByteArray, content);
    QFETCH(QString, part);
    const test::Folder folder;
    const bool binary = content.startsWith("glTF");
    const auto path = folder.write(binary ? "a.glb" : "a.gltf", content.toStdString());
    const std::string message = test::refusal(path);
    QVERIFY2(test::contains(message, part.toStdString()) && test::contains(message, path.string()), message.c_str());
}

static const test::Registered<GltfTest> registered;
#include "gltf_test.moc"
