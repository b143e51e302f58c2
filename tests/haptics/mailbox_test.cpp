// The hand-over between two threads: whole values, in order, the newest at last.
#include "core/haptics/mailbox.h"
#include "support/registry.h"

#include <memory>
#include <QTest>
#include <thread>

class MailboxTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theNewestIsTakenOnce();
    void valuesComeWholeAndInOrder();
    void theReaderFreesNothing();
};

void MailboxTest::theNewestIsTakenOnce() {
    haptics::Mailbox<int> box;
    QVERIFY(!box.take());
    box.put(1);
    box.put(2);
    const int* taken = box.take();
    QVERIFY(taken && *taken == 2);
    QVERIFY(!box.take());
    box.put(3);
    QCOMPARE(*box.take(), 3);
}

void MailboxTest::valuesComeWholeAndInOrder() {
    struct Value {
        long number, words[30];
    };
    constexpr long last = test::effort(200000);
    haptics::Mailbox<Value> box;
    std::thread writer([&] {
        for (long i = 1; i <= last; ++i) {
            Value value{i, {}};
            std::fill(std::begin(value.words), std::end(value.words), i);
            box.put(value);
        }
    });
    bool whole = true, ascending = true;
    for (long seen = 0; seen < last;)
        if (const Value* value = box.take()) {
            ascending = ascending && value->number > seen;
            seen = value->number;
            for (const long word : value->words)
                whole = whole && word == seen;
        } else {
            std::this_thread::yield();
        }
    writer.join();
    QVERIFY(whole);
    QVERIFY(ascending);
}

void MailboxTest::theReaderFreesNothing() {
    haptics::Mailbox<std::shared_ptr<int>> box;
    std::weak_ptr<int> first;
    {
        auto value = std::make_shared<int>(1);
        first = value;
        box.put(std::move(value));
    }
    QCOMPARE(**box.take(), 1);
    box.put(std::make_shared<int>(2));
    QCOMPARE(**box.take(), 2);
    QVERIFY(!first.expired()); // lies in a slot until the writer comes there
    box.put(std::make_shared<int>(3));
    box.put(std::make_shared<int>(4));
    QVERIFY(first.expired());
}

static const test::Registered<MailboxTest> registered;
#include "mailbox_test.moc"
