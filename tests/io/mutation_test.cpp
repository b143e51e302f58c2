// Damaged files by the thousand: each one either loads or is refused with base::Error, and nothing else happens.
// Under the sanitizers this is the test that readers stay inside their bytes.
#include "io/io_support.h"
#include "support/registry.h"

class MutationTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void damagedFilesLoadOrAreRefused_data();
    void damagedFilesLoadOrAreRefused();
};

namespace {

/// Words and bytes that parsers stumble over.
const char* const splinters[] = {"-1",
                                 "0",
                                 "4294967295",
                                 "18446744073709551616",
                                 "1e999",
                                 "nan",
                                 "inf",
                                 "\n",
                                 "\r",
                                 "\r\n",
                                 " ",
                                 ",",
                                 ";",
                                 "\"",
                                 "#",
                                 "//",
                                 "list",
                                 "property",
                                 "ply",
                                 "vertex",
                                 "end_header\n",
                                 "element",
                                 "double",
                                 "char",
                                 "uchar",
                                 "f ",
                                 "v ",
                                 "/",
                                 "OFF",
                                 "solid",
                                 "vertex ",
                                 "\xff\xff\xff\xff",
                                 "\x80",
                                 "9",
                                 "."};

std::string damaged(std::string bytes, base::Random& random) {
    const std::size_t wounds = 1 + random.below(4);
    for (std::size_t w = 0; w < wounds && !bytes.empty(); ++w) {
        const std::size_t at = random.below(bytes.size()), span = 1 + random.below(16);
        switch (random.below(7)) {
        case 0:
            bytes[at] = static_cast<char>(random.next());
            break;
        case 1:
            bytes.erase(at, span);
            break;
        case 2:
            bytes.insert(at, bytes.substr(random.below(bytes.size()), span));
            break;
        case 3:
            bytes.resize(at);
            break;
        case 4:
            bytes.insert(at, splinters[random.below(std::size(splinters))]);
            break;
        case 5:
            bytes.replace(at, span, splinters[random.below(std::size(splinters))]);
            break;
        case 6:
            bytes.insert(at, std::string(1 + random.below(300), bytes[at]));
            break;
        }
    }
    return bytes;
}

} // namespace

void MutationTest::damagedFilesLoadOrAreRefused_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    base::Random random(test::seed());
    const test::Folder folder;
    io::FileModel model = test::randomModel(random, 5);
    model.elements.push_back(
        {"element other 2\nproperty list uchar int ids\nproperty short s\n", std::string("\1\0\0\0\7\1\1\0\2\2", 10)});
    for (const char* name : {"a.ply", "a.csv", "a.pts", "a.xyz", "a.pcd", "a.las", "a.laz"}) {
        io::write(folder.path(name), model);
        const std::string content = test::contentOf(folder.path(name));
        QTest::newRow(name) << name << QByteArray(content.data(), static_cast<qsizetype>(content.size()));
    }
    const char* head =
        "element face 1\nproperty list uchar int vertex_indices\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty list int short l\nproperty double z\nproperty float red\n"
        "property float green\nproperty float blue\nelement other 1\nproperty list char uint l\nend_header\n";
    QTest::newRow("ascii.ply") << "a.ply"
                               << QByteArray("ply\nformat ascii 1.0\ncomment pointclay origin 1 2 3\n") + head +
                                      "3 0 1 2\n1 2 0 3 0 0 1\n4 5 1 7 6 0.5 1 0\n7 8 0 9 1 1 1\n2 5 6\n";
    QTest::newRow("big.ply") << "a.ply"
                             << QByteArray("ply\r\nformat binary_big_endian 1.0\r\n") +
                                    QByteArray(head).replace("\n", "\r\n") + QByteArray(1, '\0') +
                                    QByteArray(90, '\0') + QByteArray("\1\0\0\0\5", 5);
    QTest::newRow("a.obj") << "a.obj"
                           << QByteArray("# a\nv 1 2 3 0.1 0.2 0.3\nv 4 5 6 1 1 1\nv 7 8 9 0 0 0\nvn 0 0 1\n"
                                         "vn 1 0 0\nf 1//1 2//2 -1//-1\nf 1/1/1 2/2/2 3/3/2\n");
    QTest::newRow("a.off") << "a.off"
                           << QByteArray("CNOFF\n# a\n3 1 0\n1 2 3 0 0 1 1 0 0 1\n4 5 6 0 1 0 1 0 0 1\n"
                                         "7 8 9 1 0 0 1 0 0 1\n3 0 1 2\n");
    QTest::newRow("ascii.stl") << "a.stl"
                               << QByteArray("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                             "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
    QTest::newRow("binary.stl") << "a.stl" << QByteArray(80, 's') + QByteArray("\2\0\0\0", 4) + QByteArray(100, '\x3f');
    QTest::newRow("a.pwn") << "a.pwn" << QByteArray("2\n1 2 3\n4 5 6\n0 0 1\n0 1 0\n");
    QTest::newRow("no name") << "a" << QByteArray("1 2 3 0 0 1\n4 5 6 0 1 0\n");
}

void MutationTest::damagedFilesLoadOrAreRefused() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    const test::Folder folder;
    base::Random random(test::seed() ^ base::mix(static_cast<std::uint64_t>(content.size())));
    const std::string whole = content.toStdString();
    int loaded = 0, refused = 0;
    for (int round = 0; round < 400; ++round) {
        const std::string bytes = damaged(whole, random);
        const auto path = folder.write(name.toStdString(), bytes);
        try {
            const io::FileModel model = io::read(path);
            ++loaded;
            QVERIFY(model.points.size() > 0);
            QVERIFY(model.points.extra.size() == model.points.size() * model.points.layout->words());
            QVERIFY(model.points.size() <= 2048 * bytes.size()); // no more than packed bytes can tell of
            for (const surfel::Surfel& s : model.points.items)
                QVERIFY(base::isFinite(s.position) && base::isFinite(s.normal));
        } catch (const base::Error& error) {
            ++refused;
            QVERIFY2(!error.message().empty(), qPrintable(name));
        } catch (const std::exception& other) {
            QFAIL(qPrintable(
                QString("%1: round %2, seed %3: %4").arg(name).arg(round).arg(test::seed()).arg(other.what())));
        }
    }
    QVERIFY2(refused > 0, "no wound did any harm: the damage is too gentle to test anything");
    QVERIFY2(loaded > 0, "nothing survived: the damage is too rough to reach the later stages");
}

static const test::Registered<MutationTest> registered;
#include "mutation_test.moc"
