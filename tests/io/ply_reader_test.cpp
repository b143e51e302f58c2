// Each odd construct of real PLY files as a small literal; damaged ones must be refused in one sentence.
#include "io/io_support.h"
#include "support/registry.h"

using io::FileModel;

class PlyReaderTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void elementsBeforeTheVerticesArePassedOver();
    void connectivityIsReadAndNotWrittenBack();
    void listsAmongVertexPropertiesAreLeftOut();
    void pointsInThePlaneGetZeroHeight();
    void carriageReturnHeaderKeepsALineFeedThatBelongsToTheBody();
    void coloursOfEveryTypeBecomeBytes_data();
    void coloursOfEveryTypeBecomeBytes();
    void normalsBecomeUnitAndUnitOnesKeepTheirBits();
    void notFinitePointsAreDroppedAndCounted();
    void supportsCountOnlyWhenAllArePositive();
    void masksAreSharesAndLabelsAreAttributes();
    void farCoordinatesGetAnOrigin();
    void commentsThatLackTheWordAreComments();
    void unknownOwnCommentsAreTold();
    void namesTakenByChannelsAreMadeUnique();
    void whatFollowsTheDeclaredElementsIsTold();
    void facesThatNoFileCouldHoldDoNotCount();
    void truthValuesAreBytes();
    void damagedFilesAreRefusedInOneSentence_data();
    void damagedFilesAreRefusedInOneSentence();
    void everyCutOfAFileIsRefused();
};

static const std::string xyz = "property float x\nproperty float y\nproperty float z\n";

static std::string ascii(const std::string& elements, const std::string& body) {
    return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

static FileModel readText(const std::string& content) {
    const test::Folder folder;
    return io::read(folder.write("a.ply", content));
}

void PlyReaderTest::elementsBeforeTheVerticesArePassedOver() {
    const FileModel model =
        readText(ascii("element camera 1\nproperty float f\nelement face 2\nproperty list uchar int "
                       "vertex_indices\nelement vertex 2\n" +
                           xyz,
                       "50\n3 0 1 1\n4 0 1 0 1\n\n 1 2 3\n\t4 5 6\n"));
    QCOMPARE(model.points.size(), std::size_t(2));
    QCOMPARE(model.points.items[1].position, base::Vec3f({4, 5, 6}));
    QCOMPARE(model.faces, std::size_t(2));
    QCOMPARE(model.elements.size(), std::size_t(1));
    QCOMPARE(model.elements[0].declaration, std::string("element camera 1\nproperty float f\n"));
    QCOMPARE(model.elements[0].body, std::string("\0\0\x48\x42", 4));
}

void PlyReaderTest::connectivityIsReadAndNotWrittenBack() {
    const FileModel model =
        readText(ascii("element vertex 1\n" + xyz +
                           "element tristrips 1\nproperty list int int "
                           "vertex_indices\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n",
                       "1 2 3\n3 0 0 0\n0 0\n"));
    QCOMPARE(model.faces, std::size_t(1)); // of a strip
    QVERIFY(model.elements.empty());
    QCOMPARE(model.messages.size(), std::size_t(1));
    QVERIFY(test::anyContains(model.messages, "'edge'"));
}

void PlyReaderTest::listsAmongVertexPropertiesAreLeftOut() {
    const FileModel model =
        readText(ascii("element vertex 2\nproperty float x\nproperty list uchar short near\nproperty "
                       "float y\nproperty float z\nproperty int id\n",
                       "1 2 7 8 2 3 -9\n4 0 5 6 10\n"));
    QCOMPARE(model.points.items[0].position, base::Vec3f({1, 2, 3}));
    QCOMPARE(model.points.items[1].position, base::Vec3f({4, 5, 6}));
    QCOMPARE(surfel::read(*model.points.layout->find("id"), model.points.extraOf(0)), -9.0);
    QVERIFY(test::anyContains(model.messages, "'near'"));
}

void PlyReaderTest::pointsInThePlaneGetZeroHeight() {
    const FileModel model = readText(ascii("element point 2\nproperty float x\nproperty float y\n", "  1 2\n\t3\t4"));
    QCOMPARE(model.points.items[1].position, base::Vec3f({3, 4, 0}));
    QVERIFY(test::anyContains(model.messages, "no z"));
    // Exact floats of ours beside a missing z, as a damaged file once had them.
    const FileModel damaged = readText(ascii("comment pointclay origin 1 2 3\nelement vertex 1\nproperty double x\n"
                                             "property double y\nproperty float local_x\nproperty float local_y\n"
                                             "property float local_z\n",
                                             "5 5 4 3 0\n"));
    QCOMPARE(damaged.points.items[0].position, base::Vec3f({4, 3, 0}));
}

void PlyReaderTest::carriageReturnHeaderKeepsALineFeedThatBelongsToTheBody() {
    std::string head = "ply\rformat binary_little_endian 1.0\relement vertex 1\rproperty uchar x\rproperty uchar "
                       "y\rproperty uchar z\rend_header\r";
    QCOMPARE(readText(head + "\n\1\2").points.items[0].position, base::Vec3f({10, 1, 2}));
    for (std::size_t at = 0; (at = head.find('\r', at)) != std::string::npos; at += 2)
        head.insert(at + 1, "\n");
    QCOMPARE(readText(head + "\n\1\2").points.items[0].position, base::Vec3f({10, 1, 2}));
}

void PlyReaderTest::coloursOfEveryTypeBecomeBytes_data() {
    QTest::addColumn<QString>("names");
    QTest::addColumn<QString>("body");
    QTest::addColumn<unsigned>("first");
    QTest::newRow("uchar") << "uchar red uchar green uchar blue"
                           << "1 0 255" << surfel::rgba(1, 0, 255);
    QTest::newRow("alpha") << "uchar red uchar green uchar blue uchar alpha"
                           << "1 2 3 4" << surfel::rgba(1, 2, 3, 4);
    QTest::newRow("diffuse") << "uchar diffuse_red uchar diffuse_green uchar diffuse_blue"
                             << "9 8 7" << surfel::rgba(9, 8, 7);
    QTest::newRow("short names, other order") << "uchar b uchar g uchar r"
                                              << "1 2 3" << surfel::rgba(3, 2, 1);
    QTest::newRow("shares") << "float red float green float blue float alpha"
                            << "0 0.5 1 0.2" << surfel::rgba(0, 128, 255, 51);
    QTest::newRow("reals to 255") << "float red float green float blue"
                                  << "0 127.6 255" << surfel::rgba(0, 128, 255);
    QTest::newRow("16 bits") << "ushort red ushort green ushort blue"
                             << "0 32896 65535" << surfel::rgba(0, 128, 255);
    QTest::newRow("wide bytes") << "int red int green int blue"
                                << "-4 200 255" << surfel::rgba(0, 200, 255);
    QTest::newRow("dark bytes") << "uchar red uchar green uchar blue"
                                << "1 1 0" << surfel::rgba(1, 1, 0);
    QTest::newRow("not a number") << "float red float green float blue"
                                  << "nan 1 0.5" << surfel::rgba(0, 255, 128);
}

void PlyReaderTest::coloursOfEveryTypeBecomeBytes() {
    QFETCH(QString, names);
    QFETCH(QString, body);
    QFETCH(unsigned, first);
    const QStringList words = names.split(' ');
    std::string properties = xyz;
    for (qsizetype w = 0; w < words.size(); w += 2)
        properties += ("property " + words[w] + " " + words[w + 1] + "\n").toStdString();
    const FileModel model = readText(ascii("element vertex 1\n" + properties, "0 0 0 " + body.toStdString() + "\n"));
    QVERIFY(model.points.layout->colours);
    QVERIFY(model.points.layout->attributes().empty());
    QCOMPARE(model.points.items[0].colour, first);
}

void PlyReaderTest::normalsBecomeUnitAndUnitOnesKeepTheirBits() {
    const FileModel model =
        readText(ascii("element vertex 4\n" + xyz + "property double nx\nproperty double ny\nproperty double nz\n",
                       "0 0 0 0 0 -3\n0 0 1 0 0 0\n0 1 0 nan 0 1\n1 0 0 0.6000001 0.8 0\n"));
    QVERIFY(model.points.layout->normals && model.points.layout->oriented);
    QCOMPARE(model.points.items[0].normal, base::Vec3f({0, 0, -1}));
    QCOMPARE(model.points.items[1].normal, base::Vec3f());
    QCOMPARE(model.points.items[2].normal, base::Vec3f());
    QCOMPARE(model.points.items[3].normal, base::Vec3f({0.6000001f, 0.8f, 0}));
}

void PlyReaderTest::notFinitePointsAreDroppedAndCounted() {
    const FileModel model = readText(ascii("element vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
                                           "property int id\n",
                                           "nan 0 0 1\n1 2 3 2\n0 +inf 0 3\n0 0 1e300 4\n4 5 6 5\n"));
    QCOMPARE(model.dropped, std::size_t(3));
    QCOMPARE(model.points.size(), std::size_t(2));
    QCOMPARE(model.points.items[1].position, base::Vec3f({4, 5, 6}));
    QCOMPARE(surfel::read(*model.points.layout->find("id"), model.points.extraOf(1)), 5.0);
    QCOMPARE(model.messages.size(), std::size_t(1));
    QVERIFY(test::anyContains(model.messages, "3 points were left out"));
}

void PlyReaderTest::supportsCountOnlyWhenAllArePositive() {
    const std::string head = "element vertex 2\n" + xyz + "property float support_radius\n";
    const FileModel good = readText(ascii(head, "0 0 0 0.5\n0 0 1 2\n"));
    QVERIFY(good.hasSupports);
    QCOMPARE(good.points.items[1].support, 2.0f);
    for (const std::string bad : {"0", "-1", "nan", "inf"}) {
        const FileModel model = readText(ascii(head, "0 0 0 0.5\n0 0 1 " + bad + "\n"));
        QVERIFY(!model.hasSupports);
        QCOMPARE(model.points.items[0].support, 0.0f);
        QVERIFY(test::anyContains(model.messages, "support"));
    }
}

void PlyReaderTest::masksAreSharesAndLabelsAreAttributes() {
    const FileModel shares =
        readText(ascii("element vertex 3\n" + xyz + "property float mask\n", "0 0 0 0.25\n0 0 1 7\n0 1 0 nan\n"));
    QVERIFY(shares.points.layout->masks);
    QCOMPARE(shares.points.items[0].mask, 0.25f);
    QCOMPARE(shares.points.items[1].mask, 1.0f);
    QCOMPARE(shares.points.items[2].mask, 0.0f);
    const FileModel labels = readText(ascii("element vertex 1\n" + xyz + "property int mask\n", "0 0 0 17\n"));
    QVERIFY(!labels.points.layout->masks);
    QCOMPARE(surfel::read(labels.points.layout->attributes()[0], labels.points.extraOf(0)), 17.0);
}

void PlyReaderTest::farCoordinatesGetAnOrigin() {
    std::string body;
    for (int i = 0; i < 100; ++i)
        body += "5648350." + std::to_string(100 + i) + " 12 " + std::to_string(i % 10) + "\n";
    const FileModel model =
        readText(ascii("element vertex 100\nproperty double x\nproperty double y\nproperty double z\n", body));
    QVERIFY(model.origin.x > 5e6);
    for (int i = 0; i < 100; ++i)
        QVERIFY(std::abs(model.origin.x + double(model.points.items[std::size_t(i)].position.x) - 5648350.1 -
                         i * 1e-3) < 1e-6);
    // A file of ours says where its origin is, and is believed.
    const FileModel native =
        readText(ascii("comment pointclay origin 0 0 0\nelement vertex 1\n" + xyz, "5648350 1 2\n"));
    QCOMPARE(native.origin, base::Vec3d());
    QVERIFY(native.comments.empty());
}

/// As an exporter of 2008 wrote them.
void PlyReaderTest::commentsThatLackTheWordAreComments() {
    const std::string line = "Created by Modeller 2.4 - www.example.org, source file: ";
    const FileModel model = readText(ascii(line + "\nelement vertex 1\n" + xyz, "1 2 3\n"));
    QCOMPARE(model.points.items[0].position, base::Vec3f({1, 2, 3}));
    QVERIFY(test::anyContains(model.comments, "www.example.org"));
}

void PlyReaderTest::unknownOwnCommentsAreTold() {
    const FileModel model = readText(ascii("comment pointclay origin 1 2\ncomment pointclay surface frame=wooden\n"
                                           "comment pointclay future\ncomment pointclay up w\nelement vertex 1\n" +
                                               xyz,
                                           "1 2 3\n"));
    QCOMPARE(model.messages.size(), std::size_t(4));
    QVERIFY(model.comments.empty() && !model.definition && !model.up);
}

void PlyReaderTest::namesTakenByChannelsAreMadeUnique() {
    const test::Folder folder;
    const FileModel model = readText(ascii("element vertex 1\n" + xyz +
                                               "property int nx\nproperty int id\nproperty "
                                               "uchar id\nproperty float alpha\n",
                                           "1 2 3 4 5 6 7\n"));
    QCOMPARE(model.points.layout->names(), std::vector<std::string>({"position", "nx_2", "id", "id_2", "alpha_2"}));
    io::write(folder.path("a.ply"), model);
    QVERIFY(test::sameBits(model, io::read(folder.path("a.ply"))));
}

void PlyReaderTest::whatFollowsTheDeclaredElementsIsTold() {
    const std::string one = ascii("element vertex 1\n" + xyz, "1 2 3\n");
    QVERIFY(readText(one).messages.empty() && readText(one + "\n  \n").messages.empty());
    const FileModel more = readText(one + "4 5 6\n7 8 9\n");
    QCOMPARE(more.points.size(), std::size_t(1));
    QVERIFY(test::anyContains(more.messages, "2 lines more than its header declares"));
    const std::string binary =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + xyz + "end_header\n0123456789ab";
    QVERIFY(readText(binary).messages.empty() && readText(binary + "\n").messages.empty());
    QVERIFY(test::anyContains(readText(binary + "EXTRA").messages, "5 bytes"));
}

void PlyReaderTest::facesThatNoFileCouldHoldDoNotCount() {
    const FileModel model = readText(ascii("element vertex 1\n" + xyz + "element face 99999999999\n", "1 2 3\n"));
    QCOMPARE(model.faces, std::size_t(0));
    QVERIFY(test::anyContains(model.messages, "99999999999 of element 'face' without properties"));
}

void PlyReaderTest::truthValuesAreBytes() {
    const FileModel model = readText(ascii("element vertex 2\n" + xyz + "property bool valid\n", "1 2 3 1\n4 5 6 0\n"));
    QVERIFY(model.points.layout->find("valid")->type == surfel::ScalarType::UInt8);
    QCOMPARE(surfel::read(*model.points.layout->find("valid"), model.points.extraOf(0)), 1.0);
}

void PlyReaderTest::damagedFilesAreRefusedInOneSentence_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* name, const std::string& content, const char* part) {
        QTest::newRow(name) << QByteArray(content.data(), static_cast<qsizetype>(content.size())) << part;
    };
    const std::string le = "ply\nformat binary_little_endian 1.0\n";
    row("empty", "", "is empty");
    row("only the word", "ply", "no end_header");
    row("other word", "plyx\nformat ascii 1.0\n", "line 1: does not start with 'ply'");
    row("lfs", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", "git-lfs");
    row("no format", "ply\nelement vertex 1\n" + xyz + "end_header\n1 2 3\n", "no format line");
    row("unknown format", "ply\nformat binary 1.0\nend_header\n", "line 2: 'binary' is not a format");
    row("unknown line", "ply\nformat ascii 1.0\nelemnt vertex 1\nend_header\n", "line 3");
    row("unknown type", ascii("element vertex 1\nproperty quad x\n", "1\n"), "line 4: 'quad' is not a type");
    row("real list length", ascii("element vertex 1\nproperty list float int x\n", "1\n"), "cannot be of type float");
    row("property first", "ply\nformat ascii 1.0\nproperty float x\nend_header\n", "before any element");
    row("no count", ascii("element vertex\n", ""), "a name and a count");
    row("negative count", ascii("element vertex -1\n", ""), "'-1' is not a count");
    row("huge count", ascii("element vertex 99999999999999999999999\n", ""), "is not a count");
    row("no points", ascii("element vertex 0\n" + xyz, ""), "holds no points");
    row("no vertex", ascii("element face 0\nproperty list uchar int vertex_indices\n", ""), "no element 'vertex'");
    row("no y", ascii("element vertex 1\nproperty float x\n", "1\n"), "x and y");
    row("only nan", ascii("element vertex 2\n" + xyz, "nan 0 0\n0 inf 0\n"), "no finite points");
    row("four thousand million", le + "element vertex 4294967295\n" + xyz + "end_header\n0123456789ab",
        "bytes for at most 1");
    row("more than 64 bits hold", le + "element vertex 18446744073709551615\n" + xyz + "end_header\n0123", "at most");
    row("ascii count", ascii("element vertex 18446744073709551615\n" + xyz, "1 2 3\n"), "ends after 1");
    row("many empty columns", ascii("element vertex 1\n" + xyz, "\n\n\n"), "ends after 0");
    row("too few", ascii("element vertex 2\n" + xyz, "1 2 3\n4 5\n"), "line 9: holds 2 values where 3");
    row("too many", ascii("element vertex 2\n" + xyz, "1 2 3 4\n4 5 6\n"), "line 8: holds more than the 3");
    row("no number", ascii("element vertex 2\n" + xyz, "1 2 3\n4 y 6\n"), "line 9: 'y' is not a number");
    row("cut binary", le + "element vertex 2\n" + xyz + "end_header\n0123456789ab01234567890", "bytes for at most 1");
    const std::string face = "element vertex 1\n" + xyz + "element face 1\nproperty list ";
    row("cut list",
        le + face +
            "uchar int vertex_indices\nend_header\n0123456789ab\3"
            "01234567890",
        "inside element 'face'");
    row("absurd list",
        le + face +
            "uint int vertex_indices\nend_header\n0123456789ab\xff\xff\xff\xff"
            "0123",
        "inside element 'face'");
    row("negative list",
        le + face +
            "int int vertex_indices\nend_header\n0123456789ab\xff\xff\xff\xff"
            "0123",
        "negative length");
    row("ascii list",
        ascii("element vertex 1\n" + xyz + "element other 1\nproperty list int int v\n", "1 2 3\n2000000000 1\n"),
        "fewer values");
    row("ascii negative list",
        ascii("element vertex 1\n" + xyz + "element other 1\nproperty list int int v\n", "1 2 3\n-1\n"),
        "'v' has -1 items");
    row("ascii nan list",
        ascii("element vertex 1\n" + xyz + "element other 1\nproperty list int int v\n", "1 2 3\nnan\n"),
        "'v' has nan items");
    row("ascii list too long for its count",
        ascii("element vertex 1\n" + xyz + "element other 1\nproperty list uchar int v\n",
              "1 2 3\n300" + QString(" 1").repeated(300).toStdString() + "\n"),
        "'v' has 300 items, which its count of type uchar cannot hold");
    row("ascii list of broken length",
        ascii("element vertex 1\n" + xyz + "element other 1\nproperty list uchar int v\n", "1 2 3\n2.5 1 2 3\n"),
        "'v' has 2.5 items");
    row("ascii list of the points", ascii("element vertex 1\nproperty list uchar float q\n" + xyz, "0.4 8 0 0 0\n"),
        "'q' has 0.4 items");
    row("UTF-16", std::string("\xff\xfep\0l\0y\0", 8), "UTF-16");
    std::string many = "element vertex 1\n";
    for (int p = 0; p < 1001; ++p)
        many += "property float p" + std::to_string(p) + "\n";
    row("many properties", ascii(many, "1\n"), "more than 1000 properties");
}

void PlyReaderTest::damagedFilesAreRefusedInOneSentence() {
    QFETCH(QByteArray, content);
    QFETCH(QString, part);
    const test::Folder folder;
    const auto path = folder.write("damaged.ply", content.toStdString());
    const std::string message = test::refusal(path);
    QVERIFY2(test::contains(message, part.toStdString()), message.c_str());
    QVERIFY2(test::contains(message, path.string()), message.c_str());
    QVERIFY2(!test::contains(message, "\n") && message.size() < path.string().size() + 250, message.c_str());
}

void PlyReaderTest::everyCutOfAFileIsRefused() {
    const test::Folder folder;
    base::Random random(test::seed());
    FileModel model = test::randomModel(random, 3);
    model.elements.push_back({"element other 1\nproperty list uchar int ids\n", std::string("\1\0\0\0\7", 5)});
    io::write(folder.path("a.ply"), model);
    const std::string whole = test::contentOf(folder.path("a.ply"));
    for (std::size_t size = 0; size < whole.size(); ++size)
        QVERIFY2(!test::refusal(folder.write("cut.ply", whole.substr(0, size))).empty(),
                 qPrintable(QString("%1 bytes, seed %2").arg(size).arg(test::seed())));
}

static const test::Registered<PlyReaderTest> registered;
#include "ply_reader_test.moc"
