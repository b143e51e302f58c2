// Devices behind real lines, with a fake service at the other end: answers, silence, lines that break and come back.
#include "haptics/fake_services.h"

#include "core/haptics/devices/mouse.h"
#include "core/haptics/live.h"
#include "haptics/solids.h"
#include "support/registry.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

using namespace haptics;
using namespace haptics_test;

class LineDeviceTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void anInverse3IsAnsweredEachTick();
    void aServoThatIsSilentSendsNothing();
    void theLastForceIsZero();
    void linesThatBreakComeBack_data();
    void linesThatBreakComeBack();
    void aSilentDeviceIsSentNothing();
    void nothingWaitsForWhoIsNotThere();
    void addressesAreChecked();
    void aMouseIsWhereItWasLeft();
};

namespace {

DeviceSetup at(const std::string& address) {
    return {{}, address};
}

/// Until the device tells a new state; false after two seconds.
bool waitFor(Device& device, DeviceState& state) {
    QElapsedTimer since;
    since.start();
    while (!device.read(state)) {
        if (since.elapsed() > 2000)
            return false;
        QTest::qSleep(1);
    }
    return true;
}

bool shakeHands(FakeService& service) {
    if (!service.accept())
        return false;
    while (!service.heard.ends_with("\r\n\r\n"))
        if (!service.hear())
            return false;
    service.say(handshakeFor(service.heard));
    service.heard.clear();
    return true;
}

/// The next command; nothing where none comes.
std::optional<Vec3d> nextForce(FakeService& service) {
    for (;;) {
        const auto frames = clientFrames(service.heard);
        if (!frames.empty())
            return forceIn(frames.back().body);
        if (!service.hear())
            return {};
    }
}

} // namespace

void LineDeviceTest::anInverse3IsAnsweredEachTick() {
    FakeService service;
    const auto opened = openInverse3(at(service.address()));
    QVERIFY(shakeHands(service));
    DeviceState state;
    for (int i = 1; i <= 50; ++i) {
        service.say(serverFrame(inverse3State({0.001 * i, 0, 0}, {})));
        QVERIFY(waitFor(*opened, state));
        QCOMPARE(state.position.x, 0.001 * i);
        QVERIFY(nextForce(service));
        opened->send({0, 0, 0.01 * i}); // comes with the next answer
    }
    QVERIFY(opened->connected());
    QVERIFY(!service.hear(50)); // without a state no answer
}

void LineDeviceTest::aServoThatIsSilentSendsNothing() {
    FakeService service;
    const auto opened = openInverse3(at(service.address()));
    QVERIFY(shakeHands(service));
    DeviceState state;
    for (const bool silent : {false, true}) {
        QElapsedTimer since;
        std::optional<Vec3d> force;
        do { // a busy machine may take a while to hand over
            since.start();
            opened->send({0, 0, 2});
            QTest::qSleep(silent ? 60 : 3);
            service.say(serverFrame(inverse3State({}, {})));
            force = nextForce(service);
            QVERIFY(force);
        } while (!silent && *force == Vec3d() && since.elapsed() >= 15);
        QVERIFY(*force == (silent ? Vec3d() : Vec3d(0, -2, 0)));
    }
}

void LineDeviceTest::theLastForceIsZero() {
    FakeService service;
    auto opened = openInverse3(at(service.address()));
    QVERIFY(shakeHands(service));
    service.say(serverFrame(inverse3State({}, {})));
    QVERIFY(nextForce(service));
    opened->send({0, 0, 3});
    opened.reset();
    while (service.hear()) {
    }
    const auto frames = clientFrames(service.heard);
    QVERIFY(frames.size() >= 2 && frames.back().code == 8);
    QVERIFY(forceIn(frames[frames.size() - 2].body) == Vec3d());
}

void LineDeviceTest::linesThatBreakComeBack_data() {
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("dropped") << QByteArray();
    QTest::newRow("garbage") << QByteArray(3000, '\x5a');
    QTest::newRow("half a message") << QByteArray("\0\0\0\x58\0\0", 6);
}

void LineDeviceTest::linesThatBreakComeBack() {
    QFETCH(QByteArray, said);
    FakeService service;
    const auto opened = openVrpn(at("Phantom0@" + service.address()));
    DeviceState state;
    for (int life = 1; life <= 3; ++life) {
        QVERIFY(service.accept());
        service.say(vrpnCookie() + vrpnNames() + vrpnPlace({0.01 * life, 0, 0}, life));
        QVERIFY(waitFor(*opened, state));
        QCOMPARE(state.position.x, 0.01 * life);
        QVERIFY(opened->connected() && !opened->ended());
        service.say(said.toStdString());
        QTest::qSleep(20);
        service.drop();
        for (int i = 0; i < 200 && opened->connected(); ++i)
            QTest::qSleep(10);
        QVERIFY(!opened->connected());
    }
}

/// Pressed against a floor until it is felt, then the tracker says nothing more: the force ends. On a busy machine
/// forces pause, and what was not put in is not given back: the hand goes on until there is enough.
void LineDeviceTest::aSilentDeviceIsSentNothing() {
    FakeService service;
    ServoOptions options;
    options.law.stiffness = 500;
    options.safety.rampSeconds = 0;
    options.safety.stalePatch = 10; // the machine may be busy
    Live live(openVrpn(at("Phantom0@" + service.address())), options);
    live.show(shapes::surfaceOf(shapes::plane(10, 0.01, 0.035)));
    QVERIFY(service.accept());
    service.say(vrpnCookie() + vrpnNames());
    std::vector<Vec3d> forces;
    for (int i = 0; i < 3000 && (forces.empty() || length(forces.back()) < 1); ++i) {
        service.say(vrpnPlace({0, 0, std::max(-0.05, 0.01 - 0.0001 * i)}, 0.001 * i));
        QTest::qSleep(1);
        service.hear(0);
        forces = vrpnForces(service.heard);
    }
    QVERIFY2(!forces.empty() && forces.back().z > 0.9,
             qPrintable(forces.empty() ? QString("never felt") : QString::number(forces.back().z)));
    QElapsedTimer since;
    since.start();
    while (since.elapsed() < 2000 && length(vrpnForces(service.heard).back()) > 0)
        service.hear(10);
    QCOMPARE(vrpnForces(service.heard).back(), Vec3d());
}

void LineDeviceTest::nothingWaitsForWhoIsNotThere() {
    QTemporaryDir dir;
    const std::string path = dir.filePath("me@home spnav.sock").toStdString(); // names stand before no path
    const auto opened = openSpaceMouse(at(path));                              // plugged in later
    DeviceState state;
    QVERIFY(!opened->read(state) && !opened->connected() && !opened->ended());
    opened->send({1, 2, 3});
    FakeService service(path);
    QVERIFY(service.accept());
    service.say(spaceEvent({0, 350, 0, 0, 0, 0, 0, 16}).substr(0, 20));
    QTest::qSleep(20);
    QVERIFY(!opened->read(state));
    service.say(spaceEvent({0, 350, 0, 0, 0, 0, 0, 16}).substr(20));
    QVERIFY(waitFor(*opened, state));
    QVERIFY(state.velocity.x > 0.09);
}

void LineDeviceTest::addressesAreChecked() {
    for (const char* wrong : {"example.org:80", "localhost", "localhost:", "localhost:70000", "localhost:8x", ":80"})
        QVERIFY_EXCEPTION_THROWN(openInverse3(at(wrong)), std::runtime_error);
    QVERIFY_EXCEPTION_THROWN(openSpaceMouse(at("/" + std::string(200, 'x'))), std::runtime_error);
}

void LineDeviceTest::aMouseIsWhereItWasLeft() {
    QVERIFY_EXCEPTION_THROWN(openMouse({}), std::runtime_error);
    const auto pointer = std::make_shared<Mailbox<DeviceState>>();
    const auto opened = openMouse({{}, {}, pointer});
    DeviceState state;
    QVERIFY(!opened->read(state));
    pointer->put({{0.1, 0, 0}, {}, 0, 1});
    QVERIFY(opened->read(state) && state.velocity == Vec3d());
    pointer->put({{0.1, 0.2, 0}, {}, holdButton, 1.5});
    QVERIFY(opened->read(state) && distance(state.velocity, {0, 0.4, 0}) < 1e-12);
    QVERIFY(opened->read(state) && state.velocity == Vec3d() && state.position == Vec3d(0.1, 0.2, 0));
    QCOMPARE(state.buttons, holdButton);
}

static const test::Registered<LineDeviceTest> registered;
#include "line_device_test.moc"
