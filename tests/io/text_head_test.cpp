// What text without names, and the lines above its rows, tell of the columns.
#include "core/base/random.h"
#include "io/io_support.h"
#include "support/registry.h"

#include <functional>
#include <sstream>

using io::FileModel;

class TextHeadTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void numbersOfPointsAreNoCoordinates_data();
    void numbersOfPointsAreNoCoordinates();
    void labelledRowsAreAllThere_data();
    void labelledRowsAreAllThere();
    void unitsInTheHeadAreTold_data();
    void unitsInTheHeadAreTold();
};

static FileModel readText(const std::string& name, const std::string& content) {
    const test::Folder folder;
    return io::read(folder.write(name, content));
}

/// Rows of a random cloud behind what `number` says of each.
static std::string numbered(std::size_t n, const std::function<long long(std::size_t)>& number, const char* end) {
    base::Random random(test::seed());
    std::ostringstream out;
    out.precision(9);
    for (std::size_t i = 0; i < n; ++i)
        out << number(i) << ' ' << random.uniform(-5, 5) << ' ' << random.uniform(1, 2) << ' ' << random.uniform(7, 9)
            << end;
    return out.str();
}

void TextHeadTest::numbersOfPointsAreNoCoordinates_data() {
    QTest::addColumn<QString>("rows");
    QTest::addColumn<bool>("counts");
    const auto add = [](const char* name, const std::string& rows, bool counts) {
        QTest::newRow(name) << QString::fromStdString(rows) << counts;
    };
    const auto running = [](std::size_t i) { return static_cast<long long>(i) + 1; };
    add("from one", numbered(40000, running, "\n"), true);
    add("from zero",
        numbered(
            5, [](std::size_t i) { return static_cast<long long>(i); }, "\n"),
        true);
    add("cut from a larger file",
        numbered(
            9, [](std::size_t i) { return 100 + static_cast<long long>(i); }, "\n"),
        true);
    add("some taken out",
        numbered(
            300, [](std::size_t i) { return static_cast<long long>(i * i); }, "\n"),
        true);
    add("with colours", numbered(50, running, " 10 20 255\n"), true);
    add("named", "No;A;B;C\n" + numbered(50, running, "\n"), true);
    add("few with gaps",
        numbered(
            9, [](std::size_t i) { return static_cast<long long>(i * i); }, "\n"),
        false);
    add("columns of a grid",
        numbered(
            900, [](std::size_t i) { return static_cast<long long>(i / 30); }, "\n"),
        false);
    add("begins again",
        numbered(
            900, [](std::size_t i) { return static_cast<long long>(i % 450); }, "\n"),
        false);
    add("back at the end",
        numbered(
            40000, [](std::size_t i) { return i < 39999 ? static_cast<long long>(i) : 0; }, "\n"),
        false);
}

void TextHeadTest::numbersOfPointsAreNoCoordinates() {
    QFETCH(QString, rows);
    QFETCH(bool, counts);
    const FileModel model = readText("a.txt", rows.toStdString());
    const float z = model.points.items[0].position.z + static_cast<float>(model.origin.z);
    QVERIFY2((z >= 7) == counts, qPrintable(QString("z %1, seed %2").arg(double(z)).arg(test::seed())));
    QCOMPARE(test::anyContains(model.messages, "number"), counts);
    QCOMPARE(model.points.layout->colours, counts && rows.contains(" 20 255"));
}

void TextHeadTest::labelledRowsAreAllThere_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("labels") << "P1 1 2 3\nP2 4 5 6\nP3 7 8 9\n";
    QTest::newRow("statements") << "v 1 2 3\nv 4 5 6\nv 7 8 9\n";
    QTest::newRow("a date above") << "Scan 2024 11 28\n1 2 3\n4 5 6\n7 8 9\n";
    QTest::newRow("a title above") << "Scan made in Berlin, second day\n1 2 3\n4 5 6\n7 8 9\n";
    QTest::newRow("names above") << "id,x,y,z\nA,1,2,3\nB,4,5,6\nC,7,8,9\n";
}

void TextHeadTest::labelledRowsAreAllThere() {
    QFETCH(QString, text);
    const FileModel model = readText("a.txt", text.toStdString());
    QCOMPARE(model.points.size(), std::size_t(3));
    QCOMPARE(model.points.items[0].position, base::Vec3f({1, 2, 3}));
    QCOMPARE(model.points.items[2].position, base::Vec3f({7, 8, 9}));
}

void TextHeadTest::unitsInTheHeadAreTold_data() {
    QTest::addColumn<QString>("head");
    QTest::addColumn<QString>("unit");
    QTest::newRow("brackets") << "x [mm],y [mm],z [mm]\n"
                              << "millimeter";
    QTest::newRow("without a blank") << "X(m) Y(m) Z(m)\n"
                                     << "meter";
    QTest::newRow("other names") << "East [ft];North [ft];Height [ft]\n"
                                 << "foot";
    QTest::newRow("a line of its own") << "x,y,z\nmm,mm,mm\n"
                                       << "millimeter";
    QTest::newRow("in brackets there") << "x y z\n[cm] [cm] [cm]\n"
                                       << "centimeter";
    QTest::newRow("below a comment") << "# x y z\ninch inch inch\n"
                                     << "inch";
    QTest::newRow("none") << "x,y,z\n"
                          << "";
    QTest::newRow("not a length") << "x [deg],y [deg],z [deg]\n"
                                  << "";
    QTest::newRow("two") << "x [m],y [m],z [mm]\n"
                         << "?";
}

void TextHeadTest::unitsInTheHeadAreTold() {
    QFETCH(QString, head);
    QFETCH(QString, unit);
    const FileModel model = readText("a.csv", head.toStdString() + "1;2;3\n4;5;6\n");
    QCOMPARE(model.points.size(), std::size_t(2));
    QCOMPARE(model.points.items[0].position, base::Vec3f({1, 2, 3}));
    QVERIFY(!test::anyContains(model.messages, "first three"));
    QCOMPARE(test::anyContains(model.messages, "not in one unit"), unit == "?");
    QCOMPARE(test::anyContains(model.comments, "unit " + unit.toStdString()), unit.size() > 1);
    QCOMPARE(test::anyContains(model.comments, "unit "), unit.size() > 1);
}

static const test::Registered<TextHeadTest> registered;
#include "text_head_test.moc"
