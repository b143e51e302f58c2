// Every real scan of the data folder, as its README.md counts it: loads with that many points, or is refused.
#include "io/io_support.h"
#include "support/registry.h"

class DataFilesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyFileLoadsWithItsCountOrIsRefused_data();
    void everyFileLoadsWithItsCountOrIsRefused();
    void everyFileOfTheReadmeWasTried();
    void savedScansReadTheSame();
};

namespace {

/// One row of a table in the data folder's README.md.
struct DataRow {
    QString file;
    long points = -1; ///< -1 where the table has "-"
    long faces = -1;
    bool normals = false, colours = false, malformed = false, readable = false;
    long dropped = 0;
    bool countsDropped = true; ///< the table tells how many are not finite
};

long countIn(QString cell) {
    bool isNumber = false;
    const long count = cell.remove(',').toLong(&isNumber);
    return isNumber ? count : -1;
}

std::vector<DataRow> dataRows() {
    QFile readme(QString::fromStdString(test::dataFolder()) + "/README.md");
    std::vector<DataRow> rows;
    if (!readme.open(QIODevice::ReadOnly))
        return rows;
    static const QRegularExpression notFinite("\\((\\d+) non-finite\\)");
    static const QRegularExpression finite("\\(([\\d,]+) finite\\)");
    for (const QString& line : QString::fromUtf8(readme.readAll()).split('\n')) {
        const QStringList cells = line.split('|');
        if (cells.size() < 9 || !cells[1].trimmed().startsWith('`'))
            continue;
        DataRow row;
        row.file = cells[1].trimmed().remove('`');
        row.malformed = cells[2].contains("MALFORMED");
        row.points = countIn(cells[3].trimmed());
        row.faces = countIn(cells[4].trimmed());
        row.normals = cells[5].contains("yes");
        row.colours = cells[6].contains("rgb") || cells[6].contains("yes");
        row.dropped = notFinite.match(cells[2]).captured(1).toLong();
        if (const auto match = finite.match(cells[2]); match.hasMatch())
            row.dropped = row.points - countIn(match.captured(1));
        row.countsDropped = !cells[2].contains("nan") || row.dropped > 0;
        static const QRegularExpression ours(
            "\\.(ply|xyz|txt|csv|pts|asc|pwn|obj|off|stl|pcd|las|laz|e57|ptx|glb|gltf|3mf)$");
        row.readable = ours.match(row.file).hasMatch() && !row.malformed && !cells[7].contains("Expe");
        rows.push_back(row);
    }
    return rows;
}

std::filesystem::path pathOf(const QString& file) {
    return std::filesystem::path(test::dataFolder()) / file.toStdString();
}

} // namespace

void DataFilesTest::everyFileLoadsWithItsCountOrIsRefused_data() {
    QTest::addColumn<int>("row");
    const auto rows = dataRows();
    for (std::size_t r = 0; r < rows.size(); ++r)
        QTest::newRow(qPrintable(rows[r].file)) << static_cast<int>(r);
    if (rows.empty())
        QTest::newRow("no data") << -1;
}

void DataFilesTest::everyFileLoadsWithItsCountOrIsRefused() {
    QFETCH(int, row);
    if (row < 0)
        QSKIP("POINTCLAY_DATA names no folder with a README.md");
    const DataRow expected = dataRows()[static_cast<std::size_t>(row)];
    if (!expected.readable) {
        const std::string message = test::refusal(pathOf(expected.file));
        QVERIFY2(test::contains(message, pathOf(expected.file).string()), message.c_str());
        return;
    }
    const io::FileModel model = io::read(pathOf(expected.file));
    if (expected.points >= 0)
        QCOMPARE(static_cast<long>(model.points.size() + model.dropped), expected.points);
    if (expected.countsDropped)
        QCOMPARE(static_cast<long>(model.dropped), expected.dropped);
    if (expected.faces >= 0)
        QCOMPARE(static_cast<long>(model.faces), expected.faces);
    QVERIFY(!expected.normals || model.points.layout->normals);
    QCOMPARE(model.points.layout->colours, expected.colours);
    for (const surfel::Surfel& s : model.points.items) {
        QVERIFY(base::isFinite(s.position));
        const float length = base::length(s.normal);
        QVERIFY(length == 0 || std::abs(length - 1) < 1e-5f);
    }
}

void DataFilesTest::everyFileOfTheReadmeWasTried() {
    if (test::dataFolder().empty())
        QSKIP("POINTCLAY_DATA is not set");
    const auto rows = dataRows();
    QVERIFY(rows.size() >= 50);
    QVERIFY(std::count_if(rows.begin(), rows.end(), [](const DataRow& row) { return row.readable; }) >= 35);
    for (const DataRow& row : rows)
        QVERIFY2(std::filesystem::exists(pathOf(row.file)), qPrintable(row.file));
}

void DataFilesTest::savedScansReadTheSame() {
    if (test::dataFolder().empty())
        QSKIP("POINTCLAY_DATA is not set");
    const test::Folder folder;
    for (const DataRow& row : dataRows()) {
        if (!row.readable)
            continue;
        const io::FileModel model = io::read(pathOf(row.file));
        io::write(folder.path("a.ply"), model);
        QVERIFY2(test::sameBits(model, io::read(folder.path("a.ply"))), qPrintable(row.file));
    }
}

static const test::Registered<DataFilesTest> registered;
#include "data_files_test.moc"
