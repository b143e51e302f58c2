// PTX: grids of scans at their poses, and claims of points that are not there.
#include "io/io_support.h"
#include "support/registry.h"

class PtxTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void scansStandAtTheirPoses();
    void claimsAreChecked();
};

namespace {

const std::string turned = "2\n3\n1 2 3\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 0 0 1\n";
const std::string upright =
    "1\r\n1\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n1 0 0 0\r\n0 1 0 0\r\n0 0 1 0\r\n0 0 5 1\r\n";

} // namespace

void PtxTest::scansStandAtTheirPoses() {
    const test::Folder folder;
    const io::FileModel model =
        io::read(folder.write("a.ptx", turned +
                                           "1 0 0 0.5 255 0 7\n0 0 0 0.5 0 0 0\n0 2 0 0.25 0 255 0\n1 1 1 0 1 2 3\n"
                                           "2 2 2 1 4 5 6\n0 0 0 0 0 0 0\n" +
                                           upright + "1 2 3 0.75\r\n"));
    QCOMPARE(model.points.size(), std::size_t(5));
    const base::Vec3f expected[] = {{10, 1, 0}, {8, 0, 0}, {9, 1, 1}, {8, 2, 2}, {1, 2, 8}};
    const double rows[] = {0, 2, 0, 1, 0}, columns[] = {0, 0, 1, 1, 0}, light[] = {0.5, 0.25, 0, 1, 0.75};
    for (std::size_t i = 0; i < 5; ++i) {
        const auto value = [&](const char* name) {
            return surfel::read(*model.points.layout->find(name), model.points.extraOf(i));
        };
        QVERIFY(model.points.items[i].position == expected[i]);
        QCOMPARE(value("row"), rows[i]);
        QCOMPARE(value("column"), columns[i]);
        QCOMPARE(value("intensity"), light[i]);
        QCOMPARE(value("scan"), i < 4 ? 0.0 : 1.0);
    }
    QCOMPARE(model.points.items[0].colour, surfel::rgba(255, 0, 7));
    QCOMPARE(model.points.items[4].colour, surfel::white);
    QVERIFY(test::anyContains(model.messages, "2 places of the grids saw nothing"));
    // A quarter turn about z, then 10 along x.
    QVERIFY(test::anyContains(model.comments, "scan 0 viewpoint 10 0 0 0.707106781186547"));
    QVERIFY(test::anyContains(model.comments, "scan 1 viewpoint 0 0 5 1 0 0 0"));
}

void PtxTest::claimsAreChecked() {
    const test::Folder folder;
    const auto refused = [&](const std::string& text, const std::string& part) {
        const std::string message = test::refusal(folder.write("a.ptx", text));
        return test::contains(message, part);
    };
    QVERIFY(refused(turned + "1 2 3 0.5\n", "promises 6 points, but holds 1"));
    QVERIFY(refused("1000000000\n1000000000" + upright.substr(4) + "1 2 3 0.5\n", "but holds 1"));
    QVERIFY(refused("-1\n3\n", "line 1: is no number of rows or columns"));
    QVERIFY(refused("2\n1.5\n", "line 2: is no number"));
    QVERIFY(refused(turned + "1 2\n", "line 11: needs 3 numbers"));
    QVERIFY(refused(turned.substr(0, 20), "needs"));
    QVERIFY(refused(upright + "0 0 0 0\n", "holds no points"));
}

static const test::Registered<PtxTest> registered;
#include "ptx_test.moc"
