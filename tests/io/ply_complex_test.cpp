// Complexes in PLY files: every bit comes back, text files say the same, what breaks a rule is refused with its place.
#include "core/base/error.h"
#include "core/process/samples/samples.h"
#include "io/io_support.h"
#include "support/registry.h"

using io::FileModel;

class PlyComplexTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void complexesComeBack_data();
    void complexesComeBack();
    void tangentsStandInTheFilesCoordinates();
    void handWrittenFilesAreComplexes();
    void brokenOnesAreRefused_data();
    void brokenOnesAreRefused();
};

static FileModel modelOf(const char* sample) {
    const process::SampleRow& row = process::sample(sample);
    FileModel out;
    out.points = row.make(800, 1);
    out.definition = process::definitionOf(row, 800);
    return out;
}

void PlyComplexTest::complexesComeBack_data() {
    QTest::addColumn<QString>("sample");
    for (const char* sample : {"square", "gasket", "octant", "cone", "rounded"})
        QTest::newRow(sample) << QString(sample);
}

void PlyComplexTest::complexesComeBack() {
    QFETCH(QString, sample);
    const test::Folder folder;
    const FileModel model = modelOf(sample.toUtf8());
    io::write(folder.path("a.ply"), model);
    const FileModel read = io::read(folder.path("a.ply"));
    QVERIFY(read.definition && read.definition->manifold == surface::Manifold::Complex);
    QVERIFY(read.definition->connectivity && *read.definition->connectivity == *model.definition->connectivity);
    QVERIFY(read.messages.empty());
    io::write(folder.path("b.ply"), read);
    QVERIFY(test::contentOf(folder.path("a.ply")) == test::contentOf(folder.path("b.ply")));
}

void PlyComplexTest::tangentsStandInTheFilesCoordinates() {
    const test::Folder folder;
    FileModel model = modelOf("cone");
    model.origin = {5e6, -3e5, 120.5};
    io::write(folder.path("far.ply"), model);
    const FileModel read = io::read(folder.path("far.ply"));
    QVERIFY(read.origin == model.origin);
    const auto &was = model.definition->connectivity->tangents, &is = read.definition->connectivity->tangents;
    QCOMPARE(is.size(), was.size());
    for (std::size_t i = 0; i < is.size(); ++i)
        QVERIFY(base::distance(is[i].position, was[i].position) < 1e-6f);
}

/// A triangle with its three edges; `cells`: rows of the element.
static std::string triangle(const std::string& cells, int count, const std::string& tangents = {}) {
    std::string out = "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\nproperty float y\nproperty float z\n"
                      "property int complex_cell\nelement complex_cell " +
                      std::to_string(count) + "\nproperty int dimension\nproperty list uchar int boundary\n";
    if (!tangents.empty())
        out += "element complex_tangent 1\nproperty int at\nproperty list uchar int cells\nproperty float x\n"
               "property float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n";
    return out +
           "end_header\n0 0 0 0\n1 0 0 1\n0 1 0 2\n0.5 0 0 3\n0.5 0.5 0 4\n0 0.5 0 5\n0.3 0.3 0 6\n0.2 0.3 0 6\n"
           "0.3 0.2 0 6\n" +
           cells + tangents;
}

static const char* const sound = "0 0\n0 0\n0 0\n1 2 0 1\n1 2 1 2\n1 2 2 0\n2 3 3 4 5\n";

void PlyComplexTest::handWrittenFilesAreComplexes() {
    const test::Folder folder;
    const FileModel plain = io::read(folder.write("a.ply", triangle(sound, 7)));
    QVERIFY(plain.definition && plain.definition->manifold == surface::Manifold::Complex);
    QCOMPARE(plain.definition->connectivity->cells.size(), std::size_t(7));
    QVERIFY(plain.definition->connectivity->cells[6].boundary == (std::vector<std::uint32_t>{3, 4, 5}));
    const FileModel bound = io::read(folder.write("b.ply", triangle(sound, 7, "3 1 6 0.5 0 0 0 0 2\n")));
    QCOMPARE(bound.definition->connectivity->tangents.size(), std::size_t(1));
    QVERIFY(bound.definition->connectivity->tangents[0].direction == (base::Vec3f{0, 0, 1}));
}

void PlyComplexTest::brokenOnesAreRefused_data() {
    QTest::addColumn<QString>("cells");
    QTest::addColumn<int>("count");
    QTest::addColumn<QString>("tangents");
    QTest::addColumn<QString>("tells");
    const QString points = "0 0\n0 0\n0 0\n";
    QTest::newRow("dimension") << points + "3 2 0 1\n1 2 1 2\n1 2 2 0\n2 3 3 4 5\n"
                               << 7 << ""
                               << "cell 3";
    QTest::newRow("negative") << points + "1 2 0 -1\n1 2 1 2\n1 2 2 0\n2 3 3 4 5\n"
                              << 7 << ""
                              << "cell 3";
    QTest::newRow("one end") << points + "1 1 0\n1 2 1 2\n1 2 2 0\n2 3 3 4 5\n"
                             << 7 << ""
                             << "cell 3";
    QTest::newRow("open loop") << points + "1 2 0 1\n1 2 1 2\n1 2 2 0\n2 2 3 4\n"
                               << 7 << ""
                               << "do not close";
    QTest::newRow("fewer") << points + "1 2 0 1\n"
                           << 7 << ""
                           << "";
    QTest::newRow("tangent at a patch") << QString(sound) << 7 << "6 1 6 0 0 0 0 0 1\n"
                                        << "tangent";
    QTest::newRow("tangent of none") << QString(sound) << 7 << "3 1 9 0 0 0 0 0 1\n"
                                     << "tangent";
    QTest::newRow("no direction") << QString(sound) << 7 << "3 1 6 0 0 0 0 0 0\n"
                                  << "tangent";
}

void PlyComplexTest::brokenOnesAreRefused() {
    QFETCH(QString, cells);
    QFETCH(int, count);
    QFETCH(QString, tangents);
    QFETCH(QString, tells);
    const test::Folder folder;
    const auto file = folder.write("a.ply", triangle(cells.toStdString(), count, tangents.toStdString()));
    const std::string refusal = test::refusal(file);
    QVERIFY2(!refusal.empty() && test::contains(refusal, tells.toStdString()), refusal.c_str());
}

static const test::Registered<PlyComplexTest> registered;
#include "ply_complex_test.moc"
