// E57: files made byte by byte after ASTM E2807: packed whole numbers, reals, scaled ones, poses, spheres, pages.
#include "core/io/e57/packed_stream.h"
#include "core/io/e57/paged_bytes.h"

#include "io/io_support.h"
#include "support/registry.h"

#include <cstring>
#include <optional>

class E57Test : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void checksumIsCastagnolis();
    void numbersOfAnyWidthAreUnpacked();
    void everyKindOfFieldIsRead();
    void coloursOfSixteenBitsComeBack();
    void scansStandAtTheirPoses();
    void spheresBecomePlaces();
    void invalidPointsAreLeftOut();
    void manyPacketsReadAsOne();
    void damageIsNamed_data();
    void damageIsNamed();
    void realFile();
};

namespace {

/// Numbers bit by bit, the lowest first.
class Bits {
  public:
    void add(std::uint64_t value, unsigned width) {
        for (unsigned k = 0; k < width; ++k, ++m_count) {
            if (m_count % 8 == 0)
                m_bytes += '\0';
            m_bytes.back() = static_cast<char>(m_bytes.back() | static_cast<int>(value >> k & 1) << (m_count % 8));
        }
    }
    void add(float value) { add(std::bit_cast<std::uint32_t>(value), 32); }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value), 64); }
    const std::string& bytes() const { return m_bytes; }

  private:
    std::string m_bytes;
    std::size_t m_count = 0;
};

template <class T>
std::string raw(T value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

/// One section of points: a packet, or several of which each has so many bytes of every stream.
struct Section {
    std::string prototype, pose, extra;
    std::vector<std::string> streams;
    std::size_t count = 0;
    std::size_t cut = 60000;
};

std::uint64_t physical(std::uint64_t logical) {
    return logical / 1020 * 1024 + logical % 1020;
}

std::string packetsOf(const Section& section) {
    std::string out;
    std::size_t longest = 0;
    for (const std::string& stream : section.streams)
        longest = std::max(longest, stream.size());
    for (std::size_t at = 0; at < longest; at += section.cut) {
        std::string sizes, bodies;
        for (const std::string& stream : section.streams) {
            const std::string part = at < stream.size() ? stream.substr(at, section.cut) : std::string();
            sizes += raw(static_cast<std::uint16_t>(part.size()));
            bodies += part;
        }
        std::string packet = sizes + bodies;
        packet.resize((packet.size() + 6 + 3) / 4 * 4 - 6);
        out += raw(std::uint16_t(1)) + raw(static_cast<std::uint16_t>(packet.size() + 5)) +
               raw(static_cast<std::uint16_t>(section.streams.size())) + packet;
        out += std::string("\0\0\x0f\0", 4) + std::string(12, '\0'); // a packet of an index, which says nothing
    }
    return out;
}

std::string paged(const std::string& logical) {
    std::string out;
    for (std::size_t at = 0; at < logical.size(); at += 1020) {
        std::string page = logical.substr(at, 1020);
        page.resize(1020);
        const std::uint32_t sum = io::e57::checksum(page);
        for (int shift = 24; shift >= 0; shift -= 8)
            page += static_cast<char>(sum >> shift);
        out += page;
    }
    return out;
}

std::string file(const std::vector<Section>& sections, const std::string& root = "e57Root") {
    std::string body, scans;
    for (const Section& section : sections) {
        const std::size_t at = 48 + body.size();
        const std::string packets = packetsOf(section);
        body += raw(std::uint64_t(1)) + raw(std::uint64_t(32 + packets.size())) + raw(physical(at + 32)) +
                raw(std::uint64_t(0)) + packets;
        scans += "<vectorChild type=\"Structure\"><name type=\"String\"><![CDATA[one]]></name>" + section.pose +
                 section.extra + "<points type=\"CompressedVector\" fileOffset=\"" + std::to_string(physical(at)) +
                 "\" recordCount=\"" + std::to_string(section.count) + "\"><prototype type=\"Structure\">" +
                 section.prototype + "</prototype></points></vectorChild>";
    }
    const std::string xml =
        "<?xml version=\"1.0\"?><" + root + "><data3D type=\"Vector\">" + scans + "</data3D></" + root + ">";
    const std::string head = "ASTM-E57" + raw(std::uint32_t(1)) + raw(std::uint32_t(0)) + raw(std::uint64_t(0)) +
                             raw(physical(48 + body.size())) + raw(std::uint64_t(xml.size())) +
                             raw(std::uint64_t(1024));
    return paged(head + body + xml);
}

std::string real(const std::string& name, const char* precision) {
    return "<" + name + " type=\"Float\" precision=\"" + precision + "\"/>";
}

std::string whole(const std::string& name, long long least, long long most) {
    return "<" + name + " type=\"Integer\" minimum=\"" + std::to_string(least) + "\" maximum=\"" +
           std::to_string(most) + "\"/>";
}

/// Points (i, 2 i, 3 i) as floats.
Section line(std::size_t count) {
    Section out;
    out.count = count;
    for (std::size_t k = 0; k < 3; ++k) {
        out.prototype += real(std::string("cartesian") + "XYZ"[k], "single");
        Bits bits;
        for (std::size_t i = 0; i < count; ++i)
            bits.add(static_cast<float>(i * (k + 1)));
        out.streams.push_back(bits.bytes());
    }
    return out;
}

double value(const io::FileModel& model, std::size_t i, const char* name) {
    const surfel::Attribute* attribute = model.points.layout->find(name);
    return attribute ? surfel::read(*attribute, model.points.extraOf(i)) : std::nan("");
}

} // namespace

void E57Test::checksumIsCastagnolis() {
    QCOMPARE(io::e57::checksum("123456789"), 0xe3069283u); // the check value of CRC-32C
}

void E57Test::numbersOfAnyWidthAreUnpacked() {
    base::Random random(test::seed());
    for (unsigned width = 0; width <= 64; ++width) {
        io::e57::PackedField field;
        field.kind = io::e57::Kind::Integer;
        field.least = width == 64 ? std::numeric_limits<std::int64_t>::min() : -5;
        const std::uint64_t range = width == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << width) - 1;
        field.most = static_cast<std::int64_t>(static_cast<std::uint64_t>(field.least) + range);
        if (width == 63)
            field.least = 0, field.most = std::numeric_limits<std::int64_t>::max();
        QCOMPARE(field.bits(), width);
        Bits bits;
        std::vector<std::uint64_t> values;
        for (int k = 0; k < 40; ++k) {
            values.push_back(random.next() & range);
            bits.add(values.back(), width);
        }
        io::e57::PackedStream stream(field);
        std::size_t told = 0;
        const std::string& bytes = bits.bytes();
        for (std::size_t at = 0; at < bytes.size() || width == 0; at += 3) { // in pieces, some values dropped between
            stream.append(std::string_view(bytes).substr(std::min(at, bytes.size()), 3));
            const std::uint64_t there = std::min<std::uint64_t>(stream.available(), values.size() - told);
            for (std::uint64_t k = 0; k < there; ++k)
                QCOMPARE(stream.value(k), static_cast<double>(static_cast<std::int64_t>(
                                              static_cast<std::uint64_t>(field.least) + values[told + k])));
            stream.drop(there);
            told += there;
            if (width == 0)
                break;
        }
        QCOMPARE(told, values.size());
    }
}

void E57Test::everyKindOfFieldIsRead() {
    Section section;
    section.count = 50;
    section.prototype = real("cartesianX", "double") +
                        "<cartesianY type=\"ScaledInteger\" minimum=\"-1000\" maximum=\"1000\" scale=\"0.01\" "
                        "offset=\"2\"/>" +
                        whole("cartesianZ", -3, 96) + whole("colorRed", 0, 255) + whole("colorGreen", 0, 1023) +
                        whole("colorBlue", 7, 7) + whole("intensity", 0, 65535) + whole("rowIndex", 0, 4) +
                        whole("columnIndex", 0, 9) + real("timeStamp", "double") + whole("ext:label", -4, 3);
    Bits bits[11];
    for (unsigned i = 0; i < 50; ++i) {
        bits[0].add(0.1 * i);
        bits[1].add(1000 + i, 11);
        bits[2].add(i, 7);
        bits[3].add(i * 5, 8);
        bits[4].add(i * 20, 10);
        bits[6].add(1000 * i, 16);
        bits[7].add(i / 10, 3);
        bits[8].add(i % 10, 4);
        bits[9].add(1e9 + 0.125 * i);
        bits[10].add(i % 8, 3);
    }
    for (const Bits& each : bits)
        section.streams.push_back(each.bytes());
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.e57", file({section})));
    QCOMPARE(model.points.size(), std::size_t(50));
    for (unsigned i = 0; i < 50; ++i) {
        QCOMPARE(model.points.items[i].position.x, static_cast<float>(0.1 * i));
        QVERIFY(std::abs(double(model.points.items[i].position.y) - (0.01 * i + 2)) < 1e-6);
        QCOMPARE(model.points.items[i].position.z, static_cast<float>(static_cast<int>(i) - 3));
        QCOMPARE(model.points.items[i].colour & 255, i * 5);
        QCOMPARE(model.points.items[i].colour >> 8 & 255, unsigned(i * 20 * 255.0 / 1023 + 0.5));
        QCOMPARE(value(model, i, "intensity"), 1000.0 * i);
        QCOMPARE(value(model, i, "row"), double(i / 10));
        QCOMPARE(value(model, i, "column"), double(i % 10));
        QCOMPARE(value(model, i, "time"), 1e9 + 0.125 * i);
        QCOMPARE(value(model, i, "label"), double(i % 8) - 4);
    }
}

void E57Test::coloursOfSixteenBitsComeBack() {
    Section section = line(3);
    const unsigned reds[] = {0, 0x1234, 65535};
    Bits bits;
    for (const char* name : {"colorRed", "colorGreen", "colorBlue"})
        section.prototype += whole(name, 0, 65535);
    for (const unsigned red : reds)
        bits.add(red, 16);
    section.streams.insert(section.streams.end(), 3, bits.bytes());
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.e57", file({section})));
    io::write(folder.path("b.las"), model);
    const io::FileModel again = io::read(folder.path("b.las"));
    for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(model.points.items[i].colour & 255, (reds[i] + 128) / 257);
        QCOMPARE(value(model, i, "red_16"), double(reds[i]));
        QCOMPARE(value(again, i, "blue_16"), double(reds[i]));
    }
}

void E57Test::scansStandAtTheirPoses() {
    Section still = line(10), turned = line(7);
    // A quarter turn about z, and 100 to the right.
    turned.pose = "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">0.70710678118654752</w>"
                  "<x type=\"Float\"/><y type=\"Float\"/><z type=\"Float\">7.0710678118654752e-001</z></rotation>"
                  "<translation type=\"Structure\"><x type=\"Float\">100</x><y type=\"Float\"/><z type=\"Float\">5</z>"
                  "</translation></pose>";
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.e57", file({still, turned})));
    QCOMPARE(model.points.size(), std::size_t(17));
    for (std::size_t i = 0; i < 7; ++i) {
        const auto t = static_cast<double>(i);
        const base::Vec3d apart =
            base::cast<double>(model.points.items[10 + i].position) - base::Vec3d{100 - 2 * t, t, 3 * t + 5};
        QVERIFY(length(apart) < 1e-5);
        QCOMPARE(value(model, 10 + i, "scan"), 1.0);
        QCOMPARE(value(model, i, "scan"), 0.0);
    }
    QVERIFY(test::anyContains(model.comments, "scan one viewpoint 100 0 5"));
    QVERIFY(test::anyContains(model.messages, "2 scans"));
}

void E57Test::spheresBecomePlaces() {
    Section section;
    section.count = 30;
    section.prototype =
        real("sphericalRange", "double") + real("sphericalAzimuth", "double") + real("sphericalElevation", "double");
    Bits bits[3];
    for (int i = 0; i < 30; ++i)
        bits[0].add(2.0 + i), bits[1].add(-3 + 0.2 * i), bits[2].add(-1.5 + 0.1 * i);
    for (const Bits& each : bits)
        section.streams.push_back(each.bytes());
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.e57", file({section})));
    for (int i = 0; i < 30; ++i) {
        const base::Vec3d p = base::cast<double>(model.points.items[static_cast<std::size_t>(i)].position);
        QVERIFY(std::abs(length(p) - (2.0 + i)) < 1e-5);
        QVERIFY(std::abs(std::atan2(p.y, p.x) - (-3 + 0.2 * i)) < 1e-5);
        QVERIFY(std::abs(std::asin(p.z / length(p)) - (-1.5 + 0.1 * i)) < 1e-5);
    }
}

void E57Test::invalidPointsAreLeftOut() {
    Section section = line(20);
    section.prototype += whole("cartesianInvalidState", 0, 2);
    Bits states;
    for (unsigned i = 0; i < 20; ++i)
        states.add(i % 3, 2);
    section.streams.push_back(states.bytes());
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.e57", file({section})));
    QCOMPARE(model.points.size(), std::size_t(7));
    QCOMPARE(model.dropped, std::size_t(13));
    QCOMPARE(model.points.items[2].position.x, 6.0f);
}

void E57Test::manyPacketsReadAsOne() {
    const test::Folder folder;
    Section section = line(5000);
    const io::FileModel one = io::read(folder.write("a.e57", file({section})));
    for (const std::size_t cut : {1u, 3u, 700u, 4096u}) { // cuts through values, and through pages
        section = line(cut == 1 ? 200 : 5000);
        section.cut = cut;
        const io::FileModel many = io::read(folder.write("b.e57", file({section})));
        QCOMPARE(many.points.size(), section.count);
        for (std::size_t i = 0; i < section.count; ++i)
            QVERIFY(test::sameBits(many.points.items[i], one.points.items[i]));
    }
}

void E57Test::damageIsNamed_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* name, const std::string& content, const char* told) {
        QTest::newRow(name) << QByteArray(content.data(), static_cast<qsizetype>(content.size())) << told;
    };
    const std::string sound = file({line(1000)});
    std::string hurt = sound;
    hurt[2000] = static_cast<char>(hurt[2000] ^ 1);
    row("a bit", hurt, "byte 1024: the checksum of page 2 is wrong");
    row("cut", sound.substr(0, 1024 * (sound.size() / 1024 - 1)), "section");
    Section more = line(1000);
    more.count = 1000000000000;
    row("count", file({more}), "should have 1000000000000 points, but 1000 are there");
    Section flat = line(3);
    flat.prototype = whole("cartesianX", 1, 1) + whole("cartesianY", 1, 1) + whole("cartesianZ", 1, 1);
    flat.count = 1000000000;
    row("no bits", file({flat}), "all its points at one place");
    Section streams = line(3);
    streams.prototype += whole("intensity", 0, 3);
    row("streams", file({streams}), "packets of a scan make no sense");
    Section text = line(3);
    text.prototype = "<cartesianX type=\"String\"/>";
    row("type", file({text}), "'String', which is not known");
    Section none = line(3);
    none.prototype = real("a", "single") + real("b", "single") + real("c", "single");
    row("no places", file({none}), "neither cartesian nor spherical");
    row("root", file({line(3)}, "html"), "not one of E57");
    row("empty", file({}), "holds no points");
    row("short", "ASTM-E57", "no E57 file");
}

void E57Test::damageIsNamed() {
    QFETCH(QByteArray, content);
    QFETCH(QString, told);
    const test::Folder folder;
    const std::string message = test::refusal(folder.write("a.e57", content.toStdString()));
    QVERIFY2(test::contains(message, told.toStdString()), message.c_str());
}

void E57Test::realFile() {
    if (test::dataFolder().empty())
        QSKIP("POINTCLAY_DATA is not set");
    const io::FileModel model = io::read(std::filesystem::path(test::dataFolder()) / "bunny_float.e57");
    QCOMPARE(model.points.size(), std::size_t(30571));
    for (const surfel::Surfel& s : model.points.items) { // the bounds that its XML tells
        QVERIFY(s.position.x >= -0.0947f && s.position.x <= 0.0611f);
        QVERIFY(s.position.y >= 0.04f && s.position.y <= 0.1874f);
        QVERIFY(s.position.z >= -0.0619f && s.position.z <= 0.0588f);
    }
}

static const test::Registered<E57Test> registered;
#include "e57_test.moc"
