// LAS and LAZ: headers and records byte by byte from the specification, every point format there and back, compressed
// and not, damaged ones.
#include "core/io/las/las_fields.h"

#include "io/io_support.h"
#include "support/registry.h"

#include <cstring>

class LasTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void recordsOfTheSpecificationAreRead();
    void extraBytesAreAttributes();
    void coloursOfSixteenBitsComeBack_data();
    void coloursOfSixteenBitsComeBack();
    void everythingComesBack_data();
    void everythingComesBack();
    void coordinatesStayOnTheirGrid();
    void claimsAreChecked_data();
    void claimsAreChecked();
    void damagedChunksAreRefused();
    void realFilesComeBack_data();
    void realFilesComeBack();
};

namespace {

class Bytes {
  public:
    explicit Bytes(std::size_t size) : m_bytes(size, '\0') {}
    template <class T>
    Bytes& put(std::size_t at, T value) {
        std::memcpy(m_bytes.data() + at, &value, sizeof value);
        return *this;
    }
    Bytes& text(std::size_t at, const std::string& value) {
        value.copy(m_bytes.data() + at, value.size());
        return *this;
    }
    const std::string& bytes() const { return m_bytes; }

  private:
    std::string m_bytes;
};

/// LAS 1.2, a grid of hundredths from (1000, 2000, 0).
Bytes header(unsigned format, unsigned stride, unsigned points, unsigned minor = 2, unsigned records = 0,
             unsigned pointsAt = 0) {
    const unsigned size = minor >= 4 ? 375 : 227;
    Bytes out(size);
    out.text(0, "LASF").put(24, std::uint8_t(1)).put(25, std::uint8_t(minor)).put(94, std::uint16_t(size));
    out.put(96, pointsAt > 0 ? pointsAt : size).put(100, records).put(104, std::uint8_t(format));
    out.put(105, std::uint16_t(stride)).put(107, points);
    for (std::size_t k = 0; k < 3; ++k)
        out.put(131 + 8 * k, 0.01).put(155 + 8 * k, k == 2 ? 0.0 : 1000.0 * double(k + 1));
    return out;
}

Bytes placed(unsigned stride, int x, int y, int z) {
    Bytes out(stride);
    out.put(0, x).put(4, y).put(8, z);
    return out;
}

double value(const io::FileModel& model, std::size_t i, const char* name) {
    const surfel::Attribute* attribute = model.points.layout->find(name);
    return attribute ? surfel::read(*attribute, model.points.extraOf(i)) : std::nan("");
}

base::Vec3d place(const io::FileModel& model, std::size_t i) {
    return base::cast<double>(model.points.items[i].position) + model.origin;
}

/// The values of a point that the format has a field for, those of points nearby like each other as in real files.
io::FileModel lidarModel(unsigned format, std::size_t count, base::Random& random) {
    const io::LasLayout has = io::lasLayout(format);
    io::FileModel model;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->colours = has.rgb > 0;
    for (const io::LasField& field : has.fields)
        layout->add(field.name, field.declared());
    layout->add("height above ground", surfel::ScalarType::Float32);
    layout->add("segment", surfel::ScalarType::UInt16);
    model.points.layout = layout;
    model.up = base::UpAxis::Z;
    double time = 3e5;
    int channel = 0, source = 7;
    base::Vec3d p;
    for (std::size_t i = 0; i < count; ++i) {
        p += {random.uniform(-1, 2), random.uniform(-3, 3), random.uniform(-0.5, 0.5)};
        if (random.below(40) == 0)
            p = {random.uniform(-900, 900), random.uniform(-900, 900), random.uniform(-90, 90)};
        if (random.below(3) != 0)
            time += random.below(30) == 0 ? random.uniform(0, 1e7) : 1e-5 * double(1 + random.below(3));
        if (random.below(50) == 0)
            channel = int(random.below(4)), source = int(random.below(65536));
        const auto returns = double(1 + random.below(has.isLayered ? 15 : 7));
        surfel::Surfel s;
        s.position = base::cast<float>(p);
        if (layout->colours)
            s.colour = random.below(4) == 0 ? 0xff000000u | static_cast<surfel::Colour>(random.next() & 0xffffff)
                                            : surfel::rgba(unsigned(i) & 255, 90, 90 + unsigned(i) % 7);
        std::vector<std::uint32_t> words(layout->words());
        for (const surfel::Attribute& attribute : layout->attributes()) {
            const std::string& name = attribute.name;
            double v = double(random.below(200));
            const io::LasField* field = has.find(name);
            if (name == "gps_time")
                v = time;
            else if (name == "scanner_channel")
                v = channel;
            else if (name == "point_source")
                v = source;
            else if (name == "number_of_returns")
                v = returns;
            else if (name == "return_number")
                v = 1 + double(random.below(std::uint64_t(returns)));
            else if (name == "scan_angle")
                v = has.isLayered ? double(float(0.006 * (double(random.below(60000)) - 30000)))
                                  : double(random.below(180)) - 90;
            else if (field && field->bits > 0)
                v = double(random.below(1u << field->bits));
            else if (name == "height above ground")
                v = double(test::anyFloat(random));
            surfel::write(attribute, words, v);
        }
        model.points.append(s, words);
    }
    return model;
}

/// Nothing but names that files cannot have is changed, and coordinates by less than half a step of the grid.
void compare(const io::FileModel& model, const io::FileModel& read, double step, const char* what) {
    QVERIFY2(read.points.size() == model.points.size(), what);
    for (const surfel::Attribute& attribute : model.points.layout->attributes()) {
        std::string name = attribute.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        const surfel::Attribute* found = read.points.layout->find(name);
        for (std::size_t i = 0; i < model.points.size(); ++i) {
            const double wanted = surfel::read(attribute, model.points.extraOf(i));
            const double got = found ? surfel::read(*found, read.points.extraOf(i)) : 0;
            QVERIFY2(wanted == got || std::abs(wanted - got) < 1e-6 * std::abs(wanted),
                     qPrintable(QString("%1: %2 of point %3 is %4, not %5")
                                    .arg(what, attribute.name.c_str())
                                    .arg(i)
                                    .arg(got, 0, 'g', 17)
                                    .arg(wanted, 0, 'g', 17)));
        }
    }
    for (std::size_t i = 0; i < model.points.size(); ++i) {
        const base::Vec3d apart = place(read, i) - place(model, i);
        QVERIFY2(std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) <= step, what);
        QVERIFY2(!model.points.layout->colours || read.points.items[i].colour == model.points.items[i].colour, what);
    }
}

} // namespace

void LasTest::recordsOfTheSpecificationAreRead() {
    const test::Folder folder;
    Bytes one = placed(34, 150, -50, 777), two = placed(34, 1000000, 0, -1);
    one.put(12, std::uint16_t(40000)).put(14, std::uint8_t(2 | 3 << 3 | 1 << 6 | 1 << 7));
    one.put(15, std::uint8_t(2 | 5 << 5)).put(16, std::int8_t(-15)).put(17, std::uint8_t(9));
    one.put(18, std::uint16_t(513)).put(20, 123456.789);
    one.put(28, std::uint16_t(0xff00)).put(30, std::uint16_t(0x8000)).put(32, std::uint16_t(0));
    const io::FileModel model = io::read(folder.write("a.las", header(3, 34, 2).bytes() + one.bytes() + two.bytes()));
    QCOMPARE(model.points.size(), std::size_t(2));
    QVERIFY(length(place(model, 0) - base::Vec3d{1001.5, 1999.5, 7.77}) < 1e-3);
    QVERIFY(length(place(model, 1) - base::Vec3d{11000, 2000, -0.01}) < 1e-3);
    QCOMPARE(value(model, 0, "intensity"), 40000.0);
    QCOMPARE(value(model, 0, "return_number"), 2.0);
    QCOMPARE(value(model, 0, "number_of_returns"), 3.0);
    QCOMPARE(value(model, 0, "scan_direction"), 1.0);
    QCOMPARE(value(model, 0, "edge_of_flight_line"), 1.0);
    QCOMPARE(value(model, 0, "classification"), 2.0);
    QCOMPARE(value(model, 0, "classification_flags"), 5.0);
    QCOMPARE(value(model, 0, "scan_angle"), -15.0);
    QCOMPARE(value(model, 0, "user_data"), 9.0);
    QCOMPARE(value(model, 0, "point_source"), 513.0);
    QCOMPARE(value(model, 0, "gps_time"), 123456.789);
    QCOMPARE(model.points.items[0].colour, surfel::rgba(255, 128, 0));
    QVERIFY(model.up == base::UpAxis::Z);
    Bytes modern = placed(38, 1, 2, 3);
    modern.put(14, std::uint8_t(11 | 13 << 4)).put(15, std::uint8_t(8 | 2 << 4 | 1 << 7)).put(16, std::uint8_t(64));
    modern.put(18, std::int16_t(-5000)).put(22, 5.5).put(36, std::uint16_t(77));
    Bytes head = header(8, 38, 0, 4);
    head.put(247, std::uint64_t(1));
    const io::FileModel latest = io::read(folder.write("b.las", head.bytes() + modern.bytes()));
    QCOMPARE(value(latest, 0, "return_number"), 11.0);
    QCOMPARE(value(latest, 0, "number_of_returns"), 13.0);
    QCOMPARE(value(latest, 0, "classification_flags"), 8.0);
    QCOMPARE(value(latest, 0, "scanner_channel"), 2.0);
    QCOMPARE(value(latest, 0, "edge_of_flight_line"), 1.0);
    QCOMPARE(value(latest, 0, "classification"), 64.0);
    QCOMPARE(value(latest, 0, "scan_angle"), -30.0);
    QCOMPARE(value(latest, 0, "gps_time"), 5.5);
    QCOMPARE(value(latest, 0, "nir"), 77.0);
    QVERIFY(test::anyContains(latest.messages, "black"));
    QCOMPARE(latest.format, std::string("las 1.4 point format 8"));
}

void LasTest::extraBytesAreAttributes() {
    const test::Folder folder;
    Bytes described(54 + 3 * 192);
    described.text(2, "LASF_Spec").put(18, std::uint16_t(4)).put(20, std::uint16_t(3 * 192));
    described.put(54 + 2, std::uint8_t(9)).text(54 + 4, "heat"); // float
    described.put(54 + 192 + 2, std::uint8_t(0)).put(54 + 192 + 3, std::uint8_t(3)).text(54 + 192 + 4, "raw");
    described.put(54 + 384 + 2, std::uint8_t(4)).put(54 + 384 + 3, std::uint8_t(8 | 16)).text(54 + 384 + 4, "depth");
    described.put(54 + 384 + 112, 0.25).put(54 + 384 + 136, 10.0);
    Bytes point = placed(20 + 4 + 3 + 2, 1, 2, 3);
    point.put(20, 36.6f).put(27, std::int16_t(-6));
    const auto size = static_cast<unsigned>(227 + described.bytes().size());
    const io::FileModel model =
        io::read(folder.write("a.las", header(0, 29, 1, 2, 1, size).bytes() + described.bytes() + point.bytes()));
    QCOMPARE(value(model, 0, "heat"), double(36.6f));
    QCOMPARE(value(model, 0, "depth"), 8.5);
    QCOMPARE(model.points.layout->attributes().size(), std::size_t(2));
}

void LasTest::coloursOfSixteenBitsComeBack_data() {
    QTest::addColumn<int>("red");
    QTest::newRow("of 8 bits") << 17;
    QTest::newRow("shifted") << 0x1200;
    QTest::newRow("full") << 0x1212;
    QTest::newRow("fine") << 0x1234;
}

void LasTest::coloursOfSixteenBitsComeBack() {
    QFETCH(int, red);
    const test::Folder folder;
    Bytes point = placed(26, 1, 2, 3);
    point.put(20, std::uint16_t(red)).put(22, std::uint16_t(red)).put(24, std::uint16_t(0));
    const io::FileModel model = io::read(folder.write("a.las", header(2, 26, 1).bytes() + point.bytes()));
    io::write(folder.path("b.las"), model);
    const io::FileModel again = io::read(folder.path("b.las"));
    QCOMPARE(again.points.items[0].colour, model.points.items[0].colour);
    QCOMPARE(model.points.items[0].colour & 0xff, unsigned(red < 256 ? 17 : 0x12));
    QCOMPARE(model.points.layout->find("red_16") != nullptr, red == 0x1234);
    if (red == 0x1234)
        QCOMPARE(value(again, 0, "red_16"), double(red));
}

void LasTest::everythingComesBack_data() {
    QTest::addColumn<unsigned>("format");
    for (const unsigned format : {0u, 1u, 2u, 3u, 6u, 7u, 8u})
        QTest::newRow(qPrintable(QString::number(format))) << format;
}

void LasTest::everythingComesBack() {
    QFETCH(unsigned, format);
    const test::Folder folder;
    base::Random random(test::seed() + format);
    for (const std::size_t count : {std::size_t(1), std::size_t(2), std::size_t(700)}) {
        const io::FileModel model = lidarModel(format, count, random);
        for (const char* name : {"a.las", "a.laz"}) {
            const QByteArray what = QString("%1, format %2, %3 points, seed %4")
                                        .arg(name)
                                        .arg(format)
                                        .arg(count)
                                        .arg(test::seed())
                                        .toLatin1();
            io::write(folder.path(name), model);
            const io::FileModel read = io::read(folder.path(name));
            compare(model, read, 1e-4, what.constData());
            io::write(folder.path("b.las"), read);
            io::write(folder.path("c.las"), io::read(folder.path("b.las")));
            QVERIFY2(test::contentOf(folder.path("b.las")) == test::contentOf(folder.path("c.las")), what.constData());
        }
    }
    QVERIFY(std::filesystem::file_size(folder.path("a.laz")) < std::filesystem::file_size(folder.path("a.las")));
}

void LasTest::coordinatesStayOnTheirGrid() {
    const test::Folder folder;
    std::string body;
    base::Random random(test::seed());
    for (int i = 0; i < 500; ++i)
        body += placed(20, int(random.below(2000000)), int(random.below(2000000)), int(random.below(20000))).bytes();
    // Wider than what usually gets an origin, but too far from zero for floats to stay on the grid.
    for (int i = 0; i < 500; ++i)
        body += placed(20, int(random.below(9000000)), int(random.below(9000000)), 0).bytes();
    Bytes wide = header(0, 20, 1000);
    wide.put(155, 3e5).put(163, 3e5);
    io::write(folder.path("d.las"), io::read(folder.write("w.las", wide.bytes() + body)));
    const std::string far = test::contentOf(folder.path("d.las"));
    QVERIFY(far.substr(far.size() - body.size()) == body);
    body.resize(500 * 20);
    Bytes head = header(0, 20, 500);
    head.put(155, 6e5).put(163, 5.1e6);
    const auto path = folder.write("a.las", head.bytes() + body);
    const io::FileModel model = io::read(path);
    QVERIFY(!(model.origin == base::Vec3d{}));
    io::write(folder.path("b.las"), model);
    const std::string written = test::contentOf(folder.path("b.las"));
    QCOMPARE(written.substr(written.size() - body.size()) == body, true);
    io::write(folder.path("b.laz"), model);
    QVERIFY(test::sameBits(io::read(folder.path("b.laz")), model));
    io::write(folder.path("b.ply"), model); // the grid comes along
    io::write(folder.path("c.las"), io::read(folder.path("b.ply")));
    QVERIFY(test::contentOf(folder.path("c.las")) == written);
}

void LasTest::claimsAreChecked_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* name, const std::string& content, const char* told) {
        QTest::newRow(name) << QByteArray(content.data(), static_cast<qsizetype>(content.size())) << told;
    };
    const std::string point = placed(20, 1, 2, 3).bytes();
    row("points", header(0, 20, 1000000).bytes() + point, "declares 1000000 points, but the body holds 1");
    row("short", header(3, 20, 1).bytes() + point, "where point format 3 needs 34");
    row("format", header(11, 80, 1).bytes() + std::string(80, 'x'), "point format 11");
    row("version", Bytes(header(0, 20, 1)).put(25, std::uint8_t(7)).bytes() + point, "LAS 1.7");
    row("scale", Bytes(header(0, 20, 1)).put(139, 0.0).bytes() + point, "scale or offset");
    row("place", header(0, 20, 1, 2, 0, 100000).bytes() + point, "places that are not in the file");
    row("records", header(0, 20, 1, 2, 5).bytes() + point, "more records than there are");
    row("none", header(0, 20, 0).bytes() + point, "holds no points");
    row("laz", header(0x80, 20, 1).bytes() + point, "no record of LASzip");
    row("text", "LASF and so on", "no LAS or LAZ");
}

void LasTest::claimsAreChecked() {
    QFETCH(QByteArray, content);
    QFETCH(QString, told);
    const test::Folder folder;
    const std::string message = test::refusal(folder.write("a.las", content.toStdString()));
    QVERIFY2(test::contains(message, told.toStdString()), message.c_str());
}

void LasTest::damagedChunksAreRefused() {
    const test::Folder folder;
    base::Random random(test::seed());
    io::write(folder.path("a.laz"), lidarModel(3, 300, random));
    const std::string whole = test::contentOf(folder.path("a.laz"));
    QVERIFY(test::contains(test::refusal(folder.write("b.laz", whole.substr(0, whole.size() - 40))), "b.laz"));
    std::string many = whole;
    many.replace(107, 4,
                 std::string("\xff\xff\xff\x7f", 4)); // of a file of 1.4 with extra bytes the count stands there, too
    QVERIFY(!test::refusal(folder.write("c.laz", many)).empty());
    int refused = 0;
    for (int k = 0; k < 80; ++k) {
        std::string bytes = whole;
        for (int wounds = 0; wounds < 3; ++wounds)
            bytes[random.below(bytes.size())] = static_cast<char>(random.next());
        refused += test::refusal(folder.write("d.laz", bytes)).empty() ? 0 : 1;
    }
    QVERIFY(refused > 0);
}

void LasTest::realFilesComeBack_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"simple.las", "autzen_trim.laz", "odd/extrabytes.las"})
        QTest::newRow(name) << name;
}

void LasTest::realFilesComeBack() {
    QFETCH(QString, name);
    if (test::dataFolder().empty())
        QSKIP("POINTCLAY_DATA is not set");
    const io::FileModel model = io::read(std::filesystem::path(test::dataFolder()) / name.toStdString());
    const test::Folder folder;
    for (const char* format : {"a.las", "a.laz", "a.ply"}) {
        io::write(folder.path(format), model);
        QVERIFY2(test::sameBits(io::read(folder.path(format)), model), format);
    }
}

static const test::Registered<LasTest> registered;
#include "las_test.moc"
