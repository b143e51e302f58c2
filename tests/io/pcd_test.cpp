// PCD: every way of its data byte by byte from the specification, colours, grids, damaged bodies, and the way back.
#include "core/io/pcd/lzf.h"

#include "io/io_support.h"
#include "support/registry.h"

class PcdTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void asciiHasEveryType();
    void binaryReadsWhatAsciiReads();
    void compressedReadsWhatBinaryReads();
    void packedColoursAreBgr();
    void gridsTellRowsAndColumns();
    void countsAreClaims_data();
    void countsAreClaims();
    void lzfCopiesOverlapThemselves();
    void modelsComeBackBitForBit();
    void lossesAreNamedInOneSentence();
};

namespace {

std::string header(const std::string& data, const std::string& more = "WIDTH 3\nHEIGHT 1\n") {
    return "# .PCD v0.7 - Point Cloud Data file format\n# a remark\nVERSION 0.7\nFIELDS x y _ z rgb label big pair\n"
           "SIZE 4 8 1 4 4 2 8 1\nTYPE F F U F F I U U\nCOUNT 1 1 3 1 1 1 1 2\n" +
           more + "VIEWPOINT 1 2 3 1 0 0 0\nPOINTS 3\nDATA " + data + "\n";
}

template <class T>
void put(std::string& out, T value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

struct Record {
    float x;
    double y;
    float z;
    std::uint32_t rgb;
    std::int16_t label;
    std::uint64_t big;
    std::uint8_t pair[2];
};

constexpr Record records[3] = {{1.5f, 2.25, -3, 0x00102030, -5, 1ull << 40, {7, 8}},
                               {0.1f, 1e-3, 4, 0x00ff0001, 300, 3, {9, 10}},
                               {-1e3f, 0, 5, 0x00000000, 0, 0, {0, 255}}};

std::string binaryBody() {
    std::string out;
    for (const Record& r : records) {
        put(out, r.x), put(out, r.y);
        out += "abc";
        put(out, r.z), put(out, r.rgb), put(out, r.label), put(out, r.big), put(out, r.pair[0]), put(out, r.pair[1]);
    }
    return out;
}

std::string asciiBody() {
    return "1.5 2.25 1 2 3 -3 " + QString::number(double(std::bit_cast<float>(0x00102030u)), 'g', 9).toStdString() +
           " -5 1099511627776 7 8\r\n0.1 0.001 0 0 0 4 " +
           QString::number(double(std::bit_cast<float>(0x00ff0001u)), 'g', 9).toStdString() +
           " 300 3 9 10\n-1000 0 0 0 0 5 0 0 0 0 255\n";
}

/// As literal runs alone, which is LZF, too.
std::string literals(const std::string& bytes) {
    std::string out;
    for (std::size_t at = 0; at < bytes.size(); at += 32) {
        const std::string run = bytes.substr(at, 32);
        out += static_cast<char>(run.size() - 1);
        out += run;
    }
    return out;
}

std::string compressedBody() {
    std::string columns[8];
    for (const Record& r : records) {
        put(columns[0], r.x), put(columns[1], r.y);
        columns[2] += "abc";
        put(columns[3], r.z), put(columns[4], r.rgb), put(columns[5], r.label), put(columns[6], r.big);
        put(columns[7], r.pair[0]), put(columns[7], r.pair[1]);
    }
    std::string whole;
    for (const std::string& column : columns)
        whole += column;
    const std::string packed = literals(whole);
    std::string out;
    put(out, static_cast<std::uint32_t>(packed.size()));
    put(out, static_cast<std::uint32_t>(whole.size()));
    return out + packed;
}

double value(const io::FileModel& model, std::size_t i, const char* name) {
    const surfel::Attribute* attribute = model.points.layout->find(name);
    return attribute ? surfel::read(*attribute, model.points.extraOf(i)) : std::nan("");
}

} // namespace

void PcdTest::asciiHasEveryType() {
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.pcd", header("ascii") + asciiBody()));
    QCOMPARE(model.points.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) {
        const Record& r = records[i];
        QCOMPARE(model.points.items[i].position.x, r.x);
        QCOMPARE(model.points.items[i].position.y, static_cast<float>(r.y));
        QCOMPARE(model.points.items[i].position.z, r.z);
        QCOMPARE(value(model, i, "label"), double(r.label));
        QCOMPARE(value(model, i, "big"), double(r.big));
        QCOMPARE(value(model, i, "pair_1"), double(r.pair[0]));
        QCOMPARE(value(model, i, "pair_2"), double(r.pair[1]));
    }
    QVERIFY(model.points.layout->find("label")->type == surfel::ScalarType::Int16);
    QCOMPARE(model.points.items[0].colour, surfel::rgba(0x10, 0x20, 0x30));
    QVERIFY(test::anyContains(model.comments, "viewpoint 1 2 3 1 0 0 0"));
    QVERIFY(test::anyContains(model.comments, "a remark"));
    QCOMPARE(model.format, std::string("pcd ascii"));
}

void PcdTest::binaryReadsWhatAsciiReads() {
    const test::Folder folder;
    const io::FileModel ascii = io::read(folder.write("a.pcd", header("ascii") + asciiBody()));
    const io::FileModel binary = io::read(folder.write("b.pcd", header("binary") + binaryBody()));
    QVERIFY(test::sameBits(ascii, binary));
}

void PcdTest::compressedReadsWhatBinaryReads() {
    const test::Folder folder;
    const io::FileModel binary = io::read(folder.write("b.pcd", header("binary") + binaryBody()));
    const io::FileModel packed = io::read(folder.write("c.pcd", header("binary_compressed") + compressedBody()));
    QVERIFY(test::sameBits(binary, packed));
    QVERIFY(io::read(folder.write("no-name", header("binary") + binaryBody())).points.size() == 3);
}

void PcdTest::packedColoursAreBgr() {
    const test::Folder folder;
    const std::string head = "VERSION .5\nFIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F U\nWIDTH 2\nDATA ascii\n";
    const io::FileModel opaque = io::read(folder.write("a.pcd", head + "1 2 3 1056816\n4 5 6 16711680\n"));
    QCOMPARE(opaque.points.items[0].colour, surfel::rgba(0x10, 0x20, 0x30)); // no alpha anywhere: it means nothing
    QCOMPARE(opaque.points.items[1].colour, surfel::rgba(255, 0, 0));
    const io::FileModel clear = io::read(folder.write("b.pcd", head + "1 2 3 2148540464\n4 5 6 4294901760\n"));
    QCOMPARE(clear.points.items[0].colour, surfel::rgba(0x10, 0x20, 0x30, 0x80));
    QCOMPARE(clear.points.items[1].colour, surfel::rgba(255, 0, 0));
}

void PcdTest::gridsTellRowsAndColumns() {
    const test::Folder folder;
    const io::FileModel model =
        io::read(folder.write("a.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 3\nHEIGHT 2\nPOINTS 6\nDATA ascii\n"
                                       "0 0 0\nnan nan nan\n2 0 0\n0 1 0\n1 1 0\nnan nan nan\n"));
    QCOMPARE(model.points.size(), std::size_t(4));
    QCOMPARE(model.dropped, std::size_t(2));
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE(value(model, i, "column"), double(model.points.items[i].position.x));
        QCOMPARE(value(model, i, "row"), double(model.points.items[i].position.y));
    }
}

void PcdTest::countsAreClaims_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* name, const std::string& content, const char* told) {
        QTest::newRow(name) << QByteArray(content.data(), static_cast<qsizetype>(content.size())) << told;
    };
    const std::string head = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1000000000\nHEIGHT 1\n";
    row("ascii", head + "DATA ascii\n1 2 3\n", "body ends after 1");
    row("binary", head + "DATA binary\n123456789012", "the body holds 1");
    row("compressed", head + std::string("DATA binary_compressed\n\4\0\0\0\0\x70\x38\xbb", 31) + "abcd",
        "does not hold the 1000000000 points");
    row("cut", header("binary_compressed") + compressedBody().substr(0, 40), "compressed body should have");
    row("damaged", header("binary_compressed") + compressedBody().replace(8, 1, 1, '\xff'), "damaged");
    row("no data", "VERSION .7\nFIELDS x y z\n", "without a line DATA");
    row("sizes", "FIELDS x y z\nSIZE 4 4\nDATA ascii\n", "names 3 fields");
    row("no x", "FIELDS a b c\nWIDTH 1\nDATA ascii\n1 2 3\n", "no fields x and y");
    row("half", "FIELDS x y z\nSIZE 2 2 2\nWIDTH 1\nDATA ascii\n1 2 3\n", "reals of 2 bytes");
    row("huge", "FIELDS x y z\nWIDTH 99999999999999999\nDATA ascii\n1 2 3\n", "more points than any file");
}

void PcdTest::countsAreClaims() {
    QFETCH(QByteArray, content);
    QFETCH(QString, told);
    const test::Folder folder;
    const std::string message = test::refusal(folder.write("a.pcd", content.toStdString()));
    QVERIFY2(test::contains(message, told.toStdString()), message.c_str());
}

void PcdTest::lzfCopiesOverlapThemselves() {
    char out[12];
    // One byte as it is, then a copy of 11 from one byte before: length 7 + 2 + 2.
    QVERIFY(io::unpackLzf(std::string_view("\0a\xe0\2\0", 5), out));
    QCOMPARE(std::string(out, 12), std::string(12, 'a'));
    QVERIFY(!io::unpackLzf(std::string_view("\0a\xe0\2\1", 5), out)); // from before the beginning
    QVERIFY(!io::unpackLzf(std::string_view("\0a\xe0\3\0", 5), out)); // beyond the end
    QVERIFY(!io::unpackLzf(std::string_view("\0a\xe0", 3), out));     // cut off
}

void PcdTest::modelsComeBackBitForBit() {
    const test::Folder folder;
    base::Random random(test::seed());
    for (int k = 0; k < 40; ++k) {
        io::FileModel model = test::randomModel(random, 20 + random.below(300));
        model.origin = {}; // which no line of PCD tells
        auto layout = std::make_shared<surfel::AttributeLayout>(*model.points.layout);
        layout->oriented = layout->normals;
        model.points.layout = layout;
        io::write(folder.path("a.pcd"), model);
        const io::FileModel read = io::read(folder.path("a.pcd"));
        QVERIFY2(test::sameBits(read, model), qPrintable(QString("round %1, seed %2").arg(k).arg(test::seed())));
    }
}

void PcdTest::lossesAreNamedInOneSentence() {
    io::FileModel model;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->masks = layout->colours = true;
    layout->add("label", surfel::ScalarType::UInt8);
    layout->add("intensity", surfel::ScalarType::Float32);
    model.points.layout = layout;
    model.hasSupports = true;
    const std::uint32_t words[2] = {1, 0};
    model.points.append({}, words);
    QCOMPARE(io::lossOf("a.ply", model), std::string());
    QCOMPARE(io::lossOf("a.pcd", model), std::string());
    QCOMPARE(io::lossOf("a.csv", model), std::string());
    QCOMPARE(io::lossOf("a.xyz", model),
             std::string("Points as text cannot hold the support radii, the masks, 'label' and 'intensity'."));
    QCOMPARE(io::lossOf("a.pts", model),
             std::string("Points as text cannot hold the normals, the support radii, the masks and 'label'."));
    model = {};
    model.up = base::UpAxis::Z;
    model.comments = {"las scale 0.01 0.01 0.01 offset 0 0 0 encoding 0"};
    QCOMPARE(io::lossOf("a.ply", model), std::string());
    QCOMPARE(io::lossOf("a.las", model), std::string()); // its z is upwards anyway
    QCOMPARE(io::lossOf("a.e57", model), std::string("ASTM E57 cannot hold the grid of the LAS coordinates."));
    for (const char* name : {"a.xyz", "a.csv", "a.glb", "a.obj"})
        QVERIFY(io::lossOf(name, model)
                    .ends_with(" cannot hold the axis that is upwards and the grid of the LAS coordinates."));
}

static const test::Registered<PcdTest> registered;
#include "pcd_test.moc"
