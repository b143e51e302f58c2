#include "ui/work/latest_worker.h"

#include "support/patience.h"
#include "support/registry.h"
#include "ui/work/post.h"

#include <QTest>

using ui::LatestWorker;

class LatestWorkerTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void lastRequestIsAlwaysDone();
    void stoppedWorkMakesRoom();
    void failureIsToldAndWorkGoesOn();
    void cancelledWorkerRests();
    void endStopsWhatRuns();
    void restIsToldAfterAllThatWasDone();
};

namespace {

/// Spins until stopped.
void forever(const base::Progress& progress) {
    for (;;)
        progress.step(0, {});
}

} // namespace

void LatestWorkerTest::lastRequestIsAlwaysDone() {
    std::atomic<int> done = 0;
    LatestWorker<int> worker([&](int request, const base::Progress&) { done = request; }, {});
    for (int k = 1; k <= 1000; ++k)
        worker.request(k, k % 3 == 0);
    QVERIFY(QTest::qWaitFor([&] { return done == 1000 && !worker.busy(); }, test::patience));
}

void LatestWorkerTest::stoppedWorkMakesRoom() {
    std::atomic<int> started = 0, done = 0;
    LatestWorker<int> worker(
        [&](int request, const base::Progress& progress) {
            ++started;
            if (request == 1)
                forever(progress);
            done = request;
        },
        {});
    worker.request(1, false);
    QVERIFY(QTest::qWaitFor([&] { return started == 1; }, test::patience));
    worker.request(2, true);
    QVERIFY(QTest::qWaitFor([&] { return done == 2; }, test::patience));
}

void LatestWorkerTest::failureIsToldAndWorkGoesOn() {
    std::atomic<int> failures = 0, done = 0;
    LatestWorker<int> worker(
        [&](int request, const base::Progress&) {
            if (request == 1)
                throw std::bad_alloc();
            done = request;
        },
        [&](const std::exception&) { ++failures; });
    worker.request(1, false);
    QVERIFY(QTest::qWaitFor([&] { return failures == 1; }, test::patience));
    worker.request(2, false);
    QVERIFY(QTest::qWaitFor([&] { return done == 2; }, test::patience));
}

void LatestWorkerTest::cancelledWorkerRests() {
    std::atomic<int> rests = 0, started = 0;
    LatestWorker<int> worker(
        [&](int, const base::Progress& progress) {
            ++started;
            forever(progress);
        },
        {}, [&] { ++rests; });
    worker.request(1, false);
    QVERIFY(QTest::qWaitFor([&] { return started == 1; }, test::patience));
    worker.cancel();
    QVERIFY(QTest::qWaitFor([&] { return rests >= 1 && !worker.busy(); }, test::patience));
    const int before = rests;
    worker.request(2, false);
    worker.cancel(); // whether it had begun or not
    QVERIFY(QTest::qWaitFor([&] { return rests > before && !worker.busy(); }, test::patience));
}

void LatestWorkerTest::endStopsWhatRuns() {
    std::atomic<bool> started = false;
    {
        LatestWorker<int> worker(
            [&](int, const base::Progress& progress) {
                started = true;
                forever(progress);
            },
            {});
        worker.request(1, false);
        QVERIFY(QTest::qWaitFor([&] { return started.load(); }, test::patience));
    }
    QVERIFY(started);
}

void LatestWorkerTest::restIsToldAfterAllThatWasDone() {
    QObject receiver;
    bool busy = false;
    std::vector<std::string> order;
    const auto deliver = [&] {
        QCoreApplication::sendPostedEvents(&receiver);
        QCoreApplication::sendPostedEvents(&receiver);
    };
    ui::postRest(
        &receiver, [&] { return busy; }, [&] { order.push_back("rest"); });
    ui::post(&receiver, [&] { order.push_back("done"); }); // by the worker, before the first of these has come
    deliver();
    QCOMPARE(order, (std::vector<std::string>{"done", "rest"}));
    busy = true;
    ui::postRest(
        &receiver, [&] { return busy; }, [&] { order.push_back("rest"); });
    deliver();
    QCOMPARE(order.size(), 2U);
}

static const test::Registered<LatestWorkerTest> registered;
#include "latest_worker_test.moc"
