// `trim` in a session: what goes is what the same outline selects.
#include "core/selection/field.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using nlohmann::json;
using test::newSphere;
using test::Workbench;

class TrimCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatGoesIsWhatTheOutlineSelects();
    void outlinesThatHoldNothingAreRefused();
};

static json outline(json more) {
    json out{{"eye", {1, 0.5, 4}}, {"target", {0, 0, 0}}, {"size", {400, 300}}};
    out.update(more);
    return out;
}

void TrimCommandTest::whatGoesIsWhatTheOutlineSelects() {
    const json shapes[] = {outline({{"rectangle", {150, 80, 260, 400}}}),
                           outline({{"polygon", {{20, 20}, {380, 60}, {220, 160}, {90, 290}}}, {"fov", 50}}),
                           outline({{"polygon", {{120, 90}, {250, 100}, {200, 210}}}, {"ortho", 2.5}})};
    for (const json& shape : shapes) {
        Workbench bench;
        bench.run(newSphere());
        json select = shape, trim = shape;
        select.update({{"op", "select"}, {"by", "view"}});
        trim.update({{"op", "trim"}, {"cap", false}});
        bench.run(select);
        const std::size_t all = bench.size(), held = sizeOf(selection::selectedIn(bench.document.surface().tree()));
        QVERIFY(held > 50 && held < all - 50);
        bench.run(trim);
        QCOMPARE(bench.size(), all - held);
        bench.run({{"op", "undo"}});
        trim["keep"] = "inside";
        bench.run(trim);
        QCOMPARE(bench.size(), held);
        trim["cap"] = true;
        bench.run({{"op", "undo"}});
        bench.run(trim);
        QVERIFY(bench.size() > held);
    }
}

void TrimCommandTest::outlinesThatHoldNothingAreRefused() {
    Workbench bench;
    QVERIFY(!bench.refusal(outline({{"op", "trim"}, {"rectangle", {0, 0, 10, 10}}})).empty()); // no model
    bench.run(newSphere(500));
    const std::string hash = bench.hash();
    for (const json& shape : {outline({{"rectangle", {5, 5, 5, 5}}}), outline({{"polygon", {{1, 1}, {2, 2}, {1, 1}}}}),
                              outline({{"polygon", {{1, 1}, {2, 2}}}}), outline({{"rectangle", {0, 0, 3, 3}}}),
                              outline({{"rectangle", {-1e4, -1e4, 1e4, 1e4}}}), outline(json::object()),
                              outline({{"rectangle", {150, 80, 260, 400}}, {"fov", 30}, {"ortho", 3}}),
                              outline({{"rectangle", {0, 0, 9, 9}}, {"polygon", {{1, 1}, {2, 2}, {1, 9}}}})}) {
        json trim = shape;
        trim["op"] = "trim";
        QVERIFY2(!bench.refusal(trim).empty(), trim.dump().c_str());
    }
    QCOMPARE(bench.hash(), hash);
}

static const test::Registered<TrimCommandTest> registered;
#include "trim_command_test.moc"
