#include "ui/work/task_queue.h"

#include "support/registry.h"

#include <QTest>
#include <thread>

using namespace ui;

class TaskQueueTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void floodsOfSamplesAreMergedAndKeepTheirEnds();
    void nothingButSamplesIsDropped();
    void cancellingForgetsTheSamplesThatWait();
    void closingWakesWhoeverWaits();
};

static AddSamples sampleAt(float seconds) {
    AddSamples out;
    out.samples.emplace_back().seconds = seconds;
    return out;
}

static std::vector<float> waitingTimes(TaskQueue& queue) {
    std::vector<float> out;
    queue.push(EndStroke{});
    while (const auto task = queue.pop()) {
        if (const auto* piece = std::get_if<AddSamples>(&*task))
            for (const auto& sample : piece->samples)
                out.push_back(sample.seconds);
        else if (std::holds_alternative<EndStroke>(*task))
            break;
    }
    return out;
}

void TaskQueueTest::floodsOfSamplesAreMergedAndKeepTheirEnds() {
    TaskQueue queue;
    std::size_t dropped = 0;
    queue.push(BeginStroke{});
    for (int k = 0; k < 1000; ++k)
        dropped += queue.push(sampleAt(static_cast<float>(k)));
    const std::vector<float> times = waitingTimes(queue);
    QVERIFY(times.size() <= TaskQueue::maxWaitingSamples);
    QCOMPARE(dropped, std::size_t(999)); // one piece
    QCOMPARE(times.front(), 0.0f);
    QCOMPARE(times.back(), 999.0f);
    QVERIFY(std::is_sorted(times.begin(), times.end()));
}

void TaskQueueTest::nothingButSamplesIsDropped() {
    TaskQueue queue;
    std::size_t dropped = 0;
    for (int k = 0; k < 100; ++k) {
        dropped += queue.push(BeginStroke{});
        dropped += queue.push(sampleAt(0));
        dropped += queue.push(EndStroke{});
        dropped += queue.push(CommandTask{});
    }
    QCOMPARE(dropped, std::size_t(0));
    for (int k = 0; k < 100; ++k) {
        QVERIFY(std::holds_alternative<BeginStroke>(*queue.pop()));
        QVERIFY(std::holds_alternative<AddSamples>(*queue.pop()));
        QVERIFY(std::holds_alternative<EndStroke>(*queue.pop()));
        QVERIFY(std::holds_alternative<CommandTask>(*queue.pop()));
    }
}

void TaskQueueTest::cancellingForgetsTheSamplesThatWait() {
    TaskQueue queue;
    queue.push(BeginStroke{});
    for (int k = 0; k < 5; ++k)
        queue.push(sampleAt(1));
    QCOMPARE(queue.push(CancelStroke{}), std::size_t(1));
    QVERIFY(std::holds_alternative<BeginStroke>(*queue.pop()));
    QVERIFY(std::holds_alternative<CancelStroke>(*queue.pop()));
}

void TaskQueueTest::closingWakesWhoeverWaits() {
    TaskQueue queue;
    bool ended = false;
    std::thread waiting([&] { ended = !queue.pop(); });
    queue.close();
    waiting.join();
    QVERIFY(ended);
    queue.push(EndStroke{});
    QVERIFY(!queue.pop());
}

static const test::Registered<TaskQueueTest> registered;
#include "task_queue_test.moc"
