// What is said on the lines of devices, without a line: in any pieces, in the wrong order, and spoilt.
#include "haptics/fake_services.h"
#include "support/registry.h"

#include <QTest>

using namespace haptics;
using namespace haptics_test;

class LineProtocolTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void keysAreAnsweredAsPublished();
    void anyPiecesTellTheSame_data();
    void anyPiecesTellTheSame();
    void spoiltBytesDoNoHarm_data() { anyPiecesTellTheSame_data(); }
    void spoiltBytesDoNoHarm();
    void claimsAreNotBelieved_data();
    void claimsAreNotBelieved();
    void framesAgainstTheRulesEndTheLine_data();
    void framesAgainstTheRulesEndTheLine();
    void messagesOfManyFramesAreOne();
    void statesComeInTheFrameOfTheView();
    void oneAnswerEach();
    void vrpnHearsItsOwnDeviceInAnyOrder();
    void axesMoveAsLongAsTheyAreTold();
};

namespace {

struct Talk {
    const char* name;
    std::unique_ptr<LineProtocol> (*make)(const std::string&);
};
const Talk talks[] = {{"inverse3", makeInverse3}, {"vrpn", makeVrpn}, {"space-mouse", makeSpaceMouse}};

/// What a service says to a client that began so.
std::string saidBy(const std::string& name, const std::string& began, base::Random& random) {
    const auto place = [&] {
        return Vec3d{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
    };
    std::string out;
    if (name == "inverse3") {
        out = handshakeFor(began);
        for (int i = 0; i < 6; ++i)
            out += serverFrame(inverse3State(place(), place(), i % 2 == 1)) + serverFrame("are you there", 9);
    } else if (name == "vrpn") {
        out = vrpnCookie() + vrpnNames();
        for (int i = 1; i <= 6; ++i)
            out += vrpnPlace(place(), 0.001 * i) + vrpnPlace(place(), 0.001 * i, 2) + vrpnButton(i % 3, i % 2 == 1);
    } else {
        for (int i = 1; i <= 6; ++i)
            out += spaceEvent({0, 100 * i, -20, 30, 4, 5, 60, 16}) + spaceEvent({1 + i % 2, i % 3});
    }
    return out;
}

bool same(const DeviceState& a, const DeviceState& b) {
    return a.position == b.position && a.velocity == b.velocity && a.turning == b.turning && a.buttons == b.buttons;
}

} // namespace

void LineProtocolTest::keysAreAnsweredAsPublished() {
    QCOMPARE(webSocketAccept("dGhlIHNhbXBsZSBub25jZQ=="), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo="); // RFC 6455, 1.3
}

void LineProtocolTest::anyPiecesTellTheSame_data() {
    QTest::addColumn<int>("talk");
    for (int i = 0; i < 3; ++i)
        QTest::newRow(talks[i].name) << i;
}

void LineProtocolTest::anyPiecesTellTheSame() {
    QFETCH(int, talk);
    base::Random random(test::seed());
    for (int round = 0; round < 50; ++round) {
        std::optional<DeviceState> last[2];
        const auto seed = random.below(1u << 30);
        for (const int pieces : {0, 1}) {
            const auto protocol = talks[talk].make("");
            std::string began, in;
            protocol->begin(began);
            base::Random content(seed);
            const std::string said = saidBy(talks[talk].name, began, content);
            for (std::size_t at = 0; at < said.size();) {
                const std::size_t size = pieces == 0 ? said.size() : 1 + random.below(40);
                in += said.substr(at, size);
                at += size;
                QVERIFY(protocol->take(in, began, last[pieces]));
            }
            QVERIFY(in.empty() && last[pieces]);
        }
        QVERIFY2(same(*last[0], *last[1]), qPrintable(QString("seed %1").arg(test::seed())));
    }
}

/// Ten thousand each: it ends the line or goes on, and never tells of a place that is none, nor keeps what is too much.
void LineProtocolTest::spoiltBytesDoNoHarm() {
    QFETCH(int, talk);
    base::Random random(test::seed());
    int ended = 0, told = 0;
    for (int round = 0; round < 10000; ++round) {
        const auto protocol = talks[talk].make("");
        std::string began, in, out;
        protocol->begin(began);
        std::string said = saidBy(talks[talk].name, began, random);
        for (std::size_t spoilt = 1 + random.below(4); spoilt > 0 && !said.empty(); --spoilt) {
            const std::size_t at = random.below(said.size()), kind = random.below(4);
            if (kind == 0)
                said[at] = static_cast<char>(random.below(256));
            else if (kind == 1)
                said[at] = static_cast<char>(said[at] ^ 1 << random.below(8));
            else if (kind == 2)
                said.erase(at, 1 + random.below(30));
            else
                said.insert(at, said.substr(random.below(said.size()), random.below(30)));
        }
        bool goesOn = true;
        for (std::size_t at = 0; goesOn && at < said.size(); at += 100) {
            in += said.substr(at, 100);
            std::optional<DeviceState> state;
            goesOn = protocol->take(in, out, state);
            protocol->force({0, 0, 1}, out);
            if (state) {
                ++told;
                QVERIFY2(isFinite(state->position) && length(state->position) < 10 + 1 && isFinite(state->turning),
                         qPrintable(QString("seed %1, round %2").arg(test::seed()).arg(round)));
            }
        }
        QVERIFY(in.size() <= said.size() && out.size() < 20000);
        ended += goesOn ? 0 : 1;
    }
    QVERIFY(told > 1000 && ended > 100);
}

void LineProtocolTest::claimsAreNotBelieved_data() {
    QTest::addColumn<int>("talk");
    QTest::addColumn<QByteArray>("claim");
    QTest::newRow("frame of 2^63 bytes") << 0 << QByteArray("\x82\x7f\x80\0\0\0\0\0\0\0", 10);
    QTest::newRow("frame of a megabyte") << 0 << QByteArray("\x82\x7f\0\0\0\0\0\x10\0\0", 10);
    QTest::newRow("ping of 126 bytes") << 0 << QByteArray("\x89\x7e\0\x7e", 4);
    QTest::newRow("message of 2^31 - 1 bytes") << 1 << QByteArray("\x7f\xff\xff\xff", 4) + QByteArray(20, 0);
    QTest::newRow("message of -1 bytes") << 1 << QByteArray("\xff\xff\xff\xff", 4) + QByteArray(20, 0);
    QTest::newRow("message without its header") << 1 << QByteArray("\0\0\0\x17", 4) + QByteArray(20, 0);
    const std::string name = vrpnMessage(3, -1, bigEndian(1u << 30, 4) + "Phantom0");
    QTest::newRow("name of 2^30 letters") << 1 << QByteArray(name.data(), static_cast<qsizetype>(name.size()));
    const std::string event = spaceEvent({-5});
    QTest::newRow("an event that there is not") << 2 << QByteArray(event.data(), static_cast<qsizetype>(event.size()));
}

void LineProtocolTest::claimsAreNotBelieved() {
    QFETCH(int, talk);
    QFETCH(QByteArray, claim);
    const auto protocol = talks[talk].make("");
    std::string began, out;
    protocol->begin(began);
    base::Random random(test::seed());
    std::string in = saidBy(talks[talk].name, began, random);
    std::optional<DeviceState> state;
    QVERIFY(protocol->take(in, out, state));
    in += claim.toStdString();
    QVERIFY(!protocol->take(in, out, state));
}

void LineProtocolTest::framesAgainstTheRulesEndTheLine_data() {
    QTest::addColumn<QByteArray>("said");
    const auto row = [](const char* name, const std::string& bytes) {
        QTest::newRow(name) << QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size()));
    };
    row("goes on with nothing", serverFrame("{}", 0));
    row("a text within a text", serverFrame("{", 1, false) + serverFrame("{}", 1));
    row("masked by the server", std::string("\x81\x82\0\0\0\0{}", 8));
    row("a ping in parts", serverFrame("x", 9, false));
    row("a kind that there is not", serverFrame("x", 5));
    row("goodbye", serverFrame("", 8));
    row("no JSON", serverFrame("{\"inverse3\":[{"));
    row("JSON a hundred deep", serverFrame(std::string(100, '[') + std::string(100, ']')));
    std::string parts = serverFrame(std::string(60000, ' '), 1, false);
    for (int i = 0; i < 8; ++i)
        parts += serverFrame(std::string(60000, ' '), 0, false);
    row("a message without end", parts);
}

void LineProtocolTest::framesAgainstTheRulesEndTheLine() {
    QFETCH(QByteArray, said);
    const auto protocol = makeInverse3("");
    std::string began, out;
    protocol->begin(began);
    std::string in = handshakeFor(began) + said.toStdString();
    std::optional<DeviceState> state;
    QVERIFY(!protocol->take(in, out, state));
    QVERIFY(!state);
    const auto other = makeInverse3("");
    std::string wrong =
        "HTTP/1.1 101 Switching Protocols\r\nSec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n\r\n";
    other->begin(began);
    QVERIFY(!other->take(wrong, out, state));
}

void LineProtocolTest::messagesOfManyFramesAreOne() {
    const auto protocol = makeInverse3("");
    std::string began, out;
    protocol->begin(began);
    const std::string text = inverse3State({0.01, 0.02, 0.03}, {});
    std::string in = handshakeFor(began) + serverFrame(text.substr(0, 10), 1, false) + serverFrame("still?", 9) +
                     serverFrame(text.substr(10, 30), 0, false) + serverFrame(text.substr(40), 0);
    std::optional<DeviceState> state;
    QVERIFY(protocol->take(in, out, state));
    QVERIFY(state && state->position == Vec3d(0.01, 0.03, -0.02));
    const auto frames = clientFrames(out);
    QCOMPARE(frames.size(), std::size_t(1));
    QVERIFY(frames[0].code == 10 && frames[0].body == "still?");
}

void LineProtocolTest::statesComeInTheFrameOfTheView() {
    for (const char* name : {"", "VALUES"}) {
        const auto protocol = makeInverse3(name);
        std::string began, out;
        protocol->begin(began);
        std::string in = handshakeFor(began) + serverFrame(inverse3State({1, 2, 3}, {4, 5, 6}, true));
        std::optional<DeviceState> state;
        QVERIFY(protocol->take(in, out, state));
        QVERIFY(state->position == Vec3d(1, 3, -2) && state->velocity == Vec3d(4, 6, -5));
        QCOMPARE(state->buttons, holdButton);
        protocol->force({7, 8, 9}, out);
        const auto frames = clientFrames(out);
        QCOMPARE(frames.size(), std::size_t(1));
        QVERIFY(forceIn(frames[0].body, *name ? "values" : "vector") == Vec3d(7, -9, 8));
    }
}

void LineProtocolTest::oneAnswerEach() {
    const auto protocol = makeInverse3("");
    std::string began, out;
    protocol->begin(began);
    std::string in = handshakeFor(began);
    std::optional<DeviceState> state;
    QVERIFY(protocol->take(in, out, state));
    for (int i = 0; i < 20; ++i) {
        if (i % 3 == 0)
            in += serverFrame(inverse3State({0, 0, 0.001 * i}, {}));
        if (i % 3 == 1)
            in += serverFrame(R"({"inverse3":[]})"); // unplugged: nobody to answer
        QVERIFY(protocol->take(in, out, state));
        for (int k = 0; k < 3; ++k)
            protocol->force({0, 0, 1}, out);
    }
    QCOMPARE(clientFrames(out).size(), std::size_t(7));
    protocol->end(out);
    const auto last = clientFrames(out);
    QCOMPARE(last.size(), std::size_t(2));
    QVERIFY(forceIn(last[0].body) == Vec3d() && last[1].code == 8);
}

void LineProtocolTest::vrpnHearsItsOwnDeviceInAnyOrder() {
    const auto protocol = makeVrpn("Phantom0");
    std::string out, in = vrpnCookie("07.34") + vrpnPlace({9, 9, 9}, 0.5);
    protocol->begin(out);
    std::optional<DeviceState> state;
    QVERIFY(protocol->take(in, out, state));
    QVERIFY(!state); // before the names
    in = vrpnName(5, -2, "vrpn_Tracker Pos_Quat") + vrpnPlace({9, 9, 9}, 0.6) + vrpnNames();
    QVERIFY(protocol->take(in, out, state));
    QVERIFY(!state);
    in = vrpnPlace({0.1, 0.2, 0.3}, 1) + vrpnPlace({8, 8, 8}, 1.1, 2) + vrpnPlace({8, 8, 8}, 1.1, 3, 1);
    QVERIFY(protocol->take(in, out, state));
    QVERIFY(state && state->position == Vec3d(0.1, 0.2, 0.3));
    in = vrpnPlace({0.1, 0.2, 0.4}, 1.5) + vrpnPlace({7, 7, 7}, 1.25) + vrpnButton(1, true);
    QVERIFY(protocol->take(in, out, state));
    QVERIFY(distance(state->position, {0.1, 0.2, 0.4}) < 1e-12 && std::abs(state->velocity.z - 0.2) < 1e-5);
    QCOMPARE(state->buttons, clutchButton);
    protocol->force({1, 2, 3}, out);
    protocol->force({1, 2, 3}, out); // the same is said once
    protocol->end(out);
    const auto forces = vrpnForces(out);
    QCOMPARE(forces.size(), std::size_t(2));
    QVERIFY(forces[0] == Vec3d(1, 2, 3) && forces[1] == Vec3d());
    in = vrpnMessage(0, -5, "");
    QVERIFY(!protocol->take(in, out, state));
    const auto other = makeVrpn("");
    in = "vrpn: ver. 06.00";
    QVERIFY(!other->take(in, out, state));
}

void LineProtocolTest::axesMoveAsLongAsTheyAreTold() {
    const auto protocol = makeSpaceMouse("");
    std::string out, in = spaceEvent({0, 350, 0, 0, 0, 350, 0, 20});
    std::optional<DeviceState> state;
    for (int i = 0; i < 10; ++i, in = spaceEvent({0, 350, 0, 0, 0, 350, 0, 20}))
        QVERIFY(protocol->take(in, out, state));
    QVERIFY(distance(state->position, {0.02, 0, 0}) < 1e-9 && state->turning.y > 1);
    in = spaceEvent({0, 0, 0, 0, 0, 0, 0, 20}) + spaceEvent({0, 0, 0, 0, 0, 0, 0, 2000000000}) + spaceEvent({1, 0}) +
         spaceEvent({1, 1}) + spaceEvent({2, 0});
    QVERIFY(protocol->take(in, out, state));
    QVERIFY(distance(state->position, {0.02, 0, 0}) < 1e-9 && state->velocity == Vec3d());
    QCOMPARE(state->buttons, clutchButton);
    QVERIFY(out.empty());
}

static const test::Registered<LineProtocolTest> registered;
#include "line_protocol_test.moc"
