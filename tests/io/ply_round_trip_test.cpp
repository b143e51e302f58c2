#include "core/io/ply/ply_header.h"
#include "core/io/record_table.h"

#include "core/io/number_text.h"
#include "io/io_support.h"
#include "support/registry.h"

#include <algorithm>

using io::FileModel;
using io::PlyElement;
using io::PlyEncoding;
using surfel::ScalarType;

class PlyRoundTripTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void nativeFilesBringBackEveryBit();
    void smallFloatsNearAFarOriginSurvive();
    void movedDoublesWinOverStaleFloats();
    void definitionCommentsAndElementsSurvive();
    void limitsThatNobodyDecidedStayUndecided();
    void shapesOfTreesSurvive();
    void shapesThatAreNotOursAreNone();
    void everyEncodingOfEveryLayoutReadsTheSame();
    void writtenFileIsPlainPly();
    void coloursOfSixteenBitsStayBesideTheirBytes_data();
    void coloursOfSixteenBitsStayBesideTheirBytes();
    void cancelledWritingLeavesNothing();
};

static QString round(int k) {
    return QString("round %1, seed %2").arg(k).arg(test::seed());
}

static surfel::Surfel at(const base::Vec3f& position) {
    surfel::Surfel out;
    out.position = position;
    return out;
}

void PlyRoundTripTest::nativeFilesBringBackEveryBit() {
    const test::Folder folder;
    base::Random random(test::seed());
    for (int k = 0; k < 60; ++k) {
        FileModel model = test::randomModel(random, 1 + random.below(400));
        io::write(folder.path("a.ply"), model);
        const FileModel read = io::read(folder.path("a.ply"));
        QVERIFY2(test::sameBits(model, read), qPrintable(round(k)));
        QVERIFY2(read.messages.empty(), qPrintable(round(k)));
        io::write(folder.path("b.ply"), read);
        QVERIFY2(test::contentOf(folder.path("a.ply")) == test::contentOf(folder.path("b.ply")), qPrintable(round(k)));
    }
}

void PlyRoundTripTest::smallFloatsNearAFarOriginSurvive() {
    const test::Folder folder;
    FileModel model;
    model.origin = {5648350, -665180, 240};
    for (const float tiny : {1e-30f, -0.0f, 1e-45f, 3.14159e-7f, 7.25f})
        model.points.items.push_back(at({tiny, -tiny, 1 + tiny}));
    io::write(folder.path("a.ply"), model);
    QVERIFY(test::contains(test::contentOf(folder.path("a.ply")), "property float local_x\n"));
    QVERIFY(test::sameBits(model, io::read(folder.path("a.ply"))));
    model.points.items = {at({1, 2, 3}), at({-0.5, 0.25, 8})}; // fine as doubles: no such property
    io::write(folder.path("a.ply"), model);
    QVERIFY(!test::contains(test::contentOf(folder.path("a.ply")), "local_x"));
    QVERIFY(test::sameBits(model, io::read(folder.path("a.ply"))));
}

void PlyRoundTripTest::movedDoublesWinOverStaleFloats() {
    const test::Folder folder;
    const auto path =
        folder.write("a.ply", "ply\nformat ascii 1.0\ncomment pointclay origin 1000000 0 0\n"
                              "element vertex 2\nproperty double x\nproperty double y\nproperty double z\n"
                              "property float local_x\nproperty float local_y\nproperty float local_z\n"
                              "end_header\n1000000 1 2 1e-30 1 2\n1000005 1 2 1e-30 1 2\n");
    const FileModel model = io::read(path);
    QVERIFY(model.points.layout->attributes().empty());
    QCOMPARE(model.points.items[0].position.x, 1e-30f);
    QCOMPARE(model.points.items[1].position.x, 5.0f);
}

void PlyRoundTripTest::shapesOfTreesSurvive() {
    const test::Folder folder;
    base::Random random(test::seed());
    for (int k = 0; k < 20; ++k) {
        FileModel model = test::randomModel(random, 50);
        model.shape.check = {random.next(), random.next()};
        for (std::size_t n = 1 + random.below(40); n > 0; --n)
            model.shape.blocks.push_back(static_cast<std::uint8_t>(random.next()));
        for (std::size_t n = random.below(40); n > 0; --n)
            model.shape.nodes.push_back(static_cast<std::uint8_t>(random.next()));
        io::write(folder.path("a.ply"), model);
        const FileModel read = io::read(folder.path("a.ply"));
        QVERIFY2(read.shape == model.shape && test::sameBits(model, read), qPrintable(round(k)));
        QVERIFY2(read.messages.empty() && read.elements.size() == model.elements.size(), qPrintable(round(k)));
    }
}

/// As other programs may have written it: by hand in ascii, with other types, twice, or not at all.
void PlyRoundTripTest::shapesThatAreNotOursAreNone() {
    const test::Folder folder;
    const std::string lists = "property list uint uchar blocks\nproperty list uint uchar nodes\n"
                              "property list uchar uint check\n";
    const auto shapeOf = [&](const std::string& declaration, const std::string& rows) {
        const auto path = folder.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                                "property float y\nproperty float z\n" +
                                                    declaration + "end_header\n1 2 3\n" + rows);
        const FileModel model = io::read(path);
        return model.messages.empty() && model.elements.empty() ? model.shape : tree::TreeShape{{}, {77}, {}};
    };
    const tree::TreeShape ours{{1}, {1}, {std::uint64_t(8) << 32 | 7, std::uint64_t(10) << 32 | 9}};
    QVERIFY(shapeOf("element pointclay_tree 1\n" + lists, "1 1 1 1 4 7 8 9 10\n") == ours);
    QVERIFY(shapeOf("element pointclay_tree 1\n" + lists, "1 1 1 1 3 7 8 9\n").empty());
    QVERIFY(shapeOf("element pointclay_tree 0\n" + lists, "").empty());
    QVERIFY(shapeOf("element pointclay_tree 2\n" + lists, "1 1 1 1 4 7 8 9 10\n0 0 0\n").empty());
    QVERIFY(shapeOf("element pointclay_tree 1\nproperty uchar blocks\n", "1\n").empty());
}

void PlyRoundTripTest::definitionCommentsAndElementsSurvive() {
    const test::Folder folder;
    base::Random random(test::seed());
    FileModel model = test::randomModel(random, 10);
    model.definition = surface::SurfaceDefinition();
    model.definition->frame = surface::Frame::Covariance;
    model.definition->support = 0.1f;
    model.definition->boundaryLimit = 0.37f;
    model.limitDecided = true;
    model.comments = {"made by hand", "obj_info num_cols 512", ""};
    model.elements.push_back({"element camera 1\nproperty float view_px\nproperty list uchar int ids\n",
                              std::string("\0\0\x80\x3f\2\1\0\0\0\2\0\0\0", 13)});
    model.elements.push_back({"element nothing 4000000000\n", ""});
    io::write(folder.path("a.ply"), model);
    const FileModel read = io::read(folder.path("a.ply"));
    QVERIFY(test::sameBits(model, read));
    QVERIFY(read.definition && *read.definition == *model.definition);
    QVERIFY(read.comments == model.comments);
    QCOMPARE(read.elements.size(), model.elements.size());
    for (std::size_t e = 0; e < read.elements.size(); ++e) {
        QCOMPARE(read.elements[e].declaration, model.elements[e].declaration);
        QCOMPARE(read.elements[e].body, model.elements[e].body);
    }
}

namespace {

/// A PLY file as values: written in any encoding by the plainest code.
struct PlainPly {
    std::vector<PlyElement> elements;
    std::vector<std::vector<std::vector<std::vector<double>>>> values; ///< element, record, property, items

    static void append(std::string& out, ScalarType type, double value, PlyEncoding encoding) {
        io::withType(type, [&]<class T>() {
            const T typed = static_cast<T>(value);
            if (encoding == PlyEncoding::Ascii) {
                if constexpr (std::is_integral_v<T>)
                    io::appendNumber(out, static_cast<std::int64_t>(typed));
                else
                    io::appendNumber(out, typed);
                out += ' ';
                return;
            }
            char bytes[sizeof(T)];
            std::memcpy(bytes, &typed, sizeof typed);
            if (encoding == PlyEncoding::BigEndian)
                std::reverse(bytes, bytes + sizeof typed);
            out.append(bytes, sizeof bytes);
        });
    }
    std::string body(std::size_t element, PlyEncoding encoding) const {
        std::string out;
        for (const auto& record : values[element]) {
            for (std::size_t p = 0; p < record.size(); ++p) {
                const io::PlyProperty& property = elements[element].properties[p];
                if (property.isList)
                    append(out, property.countType, double(record[p].size()), encoding);
                for (const double value : record[p])
                    append(out, property.type, value, encoding);
            }
            if (encoding == PlyEncoding::Ascii && !record.empty())
                out += '\n';
        }
        return out;
    }
    std::string text(PlyEncoding encoding, const std::string& lineEnd) const {
        std::string head = std::string("ply\nformat ") + io::nameOf(encoding) + " 1.0\ncomment random\n";
        for (const PlyElement& element : elements)
            head += element.declaration();
        head += "end_header\n";
        std::string out;
        for (const char c : head)
            out += c == '\n' ? lineEnd : std::string(1, c);
        for (std::size_t e = 0; e < elements.size(); ++e)
            out += body(e, encoding);
        return out;
    }
};

PlainPly randomPly(base::Random& random) {
    PlainPly ply;
    const std::size_t before = random.below(3), after = random.below(3);
    for (std::size_t e = 0; e < before + 1 + after; ++e) {
        const bool vertex = e == before;
        PlyElement element;
        element.name = vertex ? "vertex" : "other_" + std::to_string(e);
        element.count = (vertex ? 1 : 0) + random.below(40);
        const std::size_t further = random.below(6);
        for (std::size_t p = 0; p < further; ++p)
            element.properties.push_back({"value_" + std::to_string(p), test::allTypes[random.below(8)],
                                          random.below(3) == 0, test::allTypes[random.below(6)]});
        for (std::size_t k = 0; vertex && k < 3; ++k) {
            const auto place = static_cast<std::ptrdiff_t>(random.below(element.properties.size() + 1));
            element.properties.insert(element.properties.begin() + place,
                                      {std::string(1, "xyz"[k]), test::allTypes[random.below(8)], false, {}});
        }
        std::vector<std::vector<std::vector<double>>> records(element.count);
        for (auto& record : records)
            for (const io::PlyProperty& property : element.properties) {
                const bool position = property.name.size() == 1;
                std::vector<double> items(property.isList ? random.below(5) : 1);
                for (double& item : items) // coordinates near zero, so that no origin is chosen
                    item = position && property.type == ScalarType::Float64 ? random.uniform(-100, 100)
                                                                            : test::anyValue(property.type, random);
                record.push_back(items);
            }
        ply.elements.push_back(element);
        ply.values.push_back(records);
    }
    return ply;
}

/// Compares what was read with the values the file was made of.
bool agrees(const FileModel& model, const PlainPly& ply) {
    std::size_t opaque = 0;
    for (std::size_t e = 0; e < ply.elements.size(); ++e) {
        const PlyElement& element = ply.elements[e];
        if (element.name != "vertex") {
            if (model.elements.at(opaque).declaration != element.declaration() ||
                model.elements[opaque++].body != ply.body(e, PlyEncoding::LittleEndian))
                return false;
            continue;
        }
        if (model.points.size() != element.count)
            return false;
        for (std::size_t i = 0; i < element.count; ++i)
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const io::PlyProperty& property = element.properties[p];
                if (property.isList)
                    continue;
                const double value = ply.values[e][i][p][0];
                if (property.name.size() == 1) {
                    const std::size_t k = static_cast<std::size_t>(property.name[0] - 'x');
                    const double origin = model.origin[k];
                    if (model.points.items[i].position[k] != static_cast<float>(value - origin))
                        return false;
                    continue;
                }
                const surfel::Attribute* attribute = model.points.layout->find(property.name);
                if (!attribute || attribute->type != property.type ||
                    surfel::read(*attribute, model.points.extraOf(i)) != value)
                    return false;
            }
    }
    return opaque == model.elements.size();
}

} // namespace

void PlyRoundTripTest::everyEncodingOfEveryLayoutReadsTheSame() {
    const test::Folder folder;
    base::Random random(test::seed());
    const std::string lineEnds[] = {"\n", "\r\n", "\r"};
    for (int k = 0; k < 60; ++k) {
        const PlainPly ply = randomPly(random);
        for (const PlyEncoding encoding : {PlyEncoding::Ascii, PlyEncoding::LittleEndian, PlyEncoding::BigEndian}) {
            const auto path = folder.write("a.ply", ply.text(encoding, lineEnds[random.below(3)]));
            const FileModel model = io::read(path);
            QVERIFY2(agrees(model, ply), qPrintable(round(k) + " " + io::nameOf(encoding)));
            io::write(folder.path("b.ply"), model);
            const FileModel again = io::read(folder.path("b.ply"));
            QVERIFY2(test::sameBits(model, again) && agrees(again, ply), qPrintable(round(k)));
        }
    }
}

void PlyRoundTripTest::writtenFileIsPlainPly() {
    const test::Folder folder;
    FileModel model;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = layout->colours = true;
    layout->add("scan", ScalarType::UInt8);
    model.points.layout = layout;
    const std::uint32_t scan = 7;
    model.points.append({{1, 2, 3}, {0, 0, 1}, 0.5f, surfel::rgba(1, 2, 3, 4), 0}, {&scan, 1});
    model.hasSupports = true;
    io::write(folder.path("a.ply"), model);
    const std::string head = "ply\nformat binary_little_endian 1.0\ncomment pointclay origin 0 0 0\n"
                             "comment pointclay normals oriented\nelement vertex 1\n"
                             "property float x\nproperty float y\nproperty float z\n"
                             "property float nx\nproperty float ny\nproperty float nz\n"
                             "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
                             "property float support_radius\nproperty uchar scan\nend_header\n";
    const std::string body("\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40\0\0\0\0\0\0\0\0\0\0\x80\x3f\1\2\3\4\0\0\0\x3f\7", 33);
    const std::string expected = head + body;
    QCOMPARE(test::contentOf(folder.path("a.ply")), expected);
}

void PlyRoundTripTest::coloursOfSixteenBitsStayBesideTheirBytes_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<unsigned>("red");
    QTest::addColumn<unsigned>("byte");
    QTest::addColumn<bool>("kept");
    QTest::newRow("fine") << "ushort" << 0x1234u << 0x12u << true;
    QTest::newRow("in integers of 32 bits") << "int" << 0x1234u << 0x12u << true;
    QTest::newRow("that bytes bring back") << "ushort" << 0x1212u << 0x12u << false;
    QTest::newRow("of reals") << "float" << 0x1234u << 0x12u << false;
    QTest::newRow("that are bytes") << "ushort" << 77u << 77u << false;
}

void PlyRoundTripTest::coloursOfSixteenBitsStayBesideTheirBytes() {
    QFETCH(QString, type);
    QFETCH(unsigned, red);
    QFETCH(unsigned, byte);
    QFETCH(bool, kept);
    std::string text = "ply\nformat ascii 1.0\nelement vertex 1\n";
    for (const char* name : {"x", "y", "z"})
        text += std::string("property float ") + name + "\n";
    for (const char* name : {"red", "green", "blue"})
        text += "property " + type.toStdString() + " " + name + "\n";
    text += "end_header\n1 2 3 " + std::to_string(red) + " 0 " + std::to_string(red) + "\n";
    const test::Folder folder;
    io::write(folder.path("b.ply"), io::read(folder.write("a.ply", text)));
    const FileModel back = io::read(folder.path("b.ply"));
    QCOMPARE(back.points.items[0].colour & 0xff, byte);
    const surfel::Attribute* wide = back.points.layout->find("blue_16");
    QCOMPARE(wide != nullptr, kept);
    if (wide)
        QCOMPARE(surfel::read(*wide, back.points.extraOf(0)), double(red));
}

void PlyRoundTripTest::cancelledWritingLeavesNothing() {
    const test::Folder folder;
    base::Random random(test::seed());
    const FileModel model = test::randomModel(random, 100);
    std::atomic<bool> cancel = true;
    base::Progress progress;
    progress.cancel = &cancel;
    for (const char* name : {"a.ply", "a.xyz", "a.csv", "a.obj"})
        QVERIFY_EXCEPTION_THROWN(io::write(folder.path(name), model, progress), base::Cancelled);
    QCOMPARE(folder.entries(), std::size_t(0));
    io::write(folder.path("a.ply"), model);
    QVERIFY_EXCEPTION_THROWN(io::read(folder.path("a.ply"), progress), base::Cancelled);
}

void PlyRoundTripTest::limitsThatNobodyDecidedStayUndecided() {
    const test::Folder folder;
    FileModel model;
    model.points.items.push_back(at({1, 2, 3}));
    for (const bool decided : {false, true}) {
        model.definition = surface::SurfaceDefinition();
        model.definition->boundaryLimit = 0.25f;
        model.definition->knownRims = true;
        model.limitDecided = decided;
        io::write(folder.path("a.ply"), model);
        const FileModel read = io::read(folder.path("a.ply"));
        QCOMPARE(read.limitDecided, decided);
        QVERIFY(read.definition->knownRims);
        QVERIFY(decided ? read.definition == model.definition : std::isinf(read.definition->boundaryLimit));
    }
}

static const test::Registered<PlyRoundTripTest> registered;
#include "ply_round_trip_test.moc"
