#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "support/registry.h"

#include <array>
#include <QTest>

using namespace base;

struct Fruit {
    const char* id;
    std::string name;
};

static const std::array<Fruit, 3> fruits{{{"a", "apple"}, {"b", "banana"}, {"c%", "cherry"}}};

class RowOfIdTest : public QObject {
    Q_OBJECT

  private Q_SLOTS:
    void FindsTheRowByAnyMember() {
        QCOMPARE(findRow(fruits, "b"), &fruits[1]);
        QCOMPARE(findRow(fruits, "cherry", &Fruit::name), &fruits[2]);
        QVERIFY(!findRow(fruits, "banan"));
        QCOMPARE(&rowOf(fruits, "a", {"", "", ""}), &fruits[0]);
    }

    void RefusesOthersAndNamesAllThereAre() {
        QCOMPARE(joinedIds(fruits, &Fruit::name), std::string("apple, banana, cherry"));
        try {
            rowOf(fruits, "50%", {"no fruit '%'", "basket", "take % or none"});
            QFAIL("accepted");
        } catch (const Error& error) {
            QCOMPARE(error.message(), std::string("basket: no fruit '50%'; take a, b, c% or none"));
        }
        try {
            rowOf(fruits, "bananna", {"no fruit '%'", "", "take %"}, &Fruit::name);
            QFAIL("accepted");
        } catch (const Error& error) {
            QCOMPARE(error.message(),
                     std::string("no fruit 'bananna'; did you mean 'banana'? take apple, banana, cherry"));
        }
    }
};

static const test::Registered<RowOfIdTest> registered;
#include "row_of_id_test.moc"
