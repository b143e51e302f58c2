#include "core/haptics/devices/vrpn.h"

#include <array>
#include <bit>
#include <cstring>

namespace haptics {

using base::Vec3d;

namespace {

constexpr std::size_t cookieSize = 24, headerSize = 24, mostBody = 1 << 16;
constexpr std::string_view cookie = "vrpn: ver. 07.35  0", version = "vrpn: ver. 07.";
constexpr std::int32_t describesSender = -1, describesType = -2, disconnects = -5;
constexpr double fieldRadius = 1; ///< metres about the tool in which a force holds

std::uint64_t highestFirst(const char* bytes, std::size_t count) {
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < count; ++i)
        out = out << 8 | static_cast<unsigned char>(bytes[i]);
    return out;
}
std::int32_t wholeAt(const char* bytes) {
    return static_cast<std::int32_t>(highestFirst(bytes, 4));
}
double realAt(const char* bytes) {
    return std::bit_cast<double>(highestFirst(bytes, 8));
}
void put(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(static_cast<char>(value >> shift));
}
void put(std::string& out, float value) {
    put(out, std::bit_cast<std::uint32_t>(value));
}
std::size_t padded(std::size_t size) {
    return (size + 7) / 8 * 8;
}

void putMessage(std::string& out, std::int32_t sender, std::int32_t type, const std::string& body) {
    put(out, static_cast<std::uint32_t>(headerSize + body.size()));
    put(out, 0u), put(out, 0u); // the time: nobody asks for it
    put(out, static_cast<std::uint32_t>(sender));
    put(out, static_cast<std::uint32_t>(type));
    put(out, 0u);
    out += body;
    out.append(padded(body.size()) - body.size(), '\0');
}

void putName(std::string& out, std::int32_t number, std::int32_t what, std::string_view name) {
    std::string body;
    put(body, static_cast<std::uint32_t>(name.size() + 1));
    body += name;
    body.push_back('\0');
    putMessage(out, number, what, body);
}

struct Message {
    double time;
    std::int32_t sender, type;
    std::string_view body;
};

class Vrpn final : public LineProtocol {
  public:
    explicit Vrpn(std::string name) : m_name(std::move(name)) {}

    void begin(std::string& out) override {
        out += cookie;
        out.append(cookieSize - cookie.size(), '\0');
        putName(out, 0, describesSender, m_name);
        putName(out, 0, describesType, "vrpn_ForceDevice Force_Field");
    }
    bool take(std::string& in, std::string&, std::optional<DeviceState>& state) override;
    void force(const Vec3d& newtons, std::string& out) override {
        if (newtons == m_said || !m_met)
            return;
        m_said = newtons;
        std::string body;
        for (const Vec3d& v : {m_state.position, newtons})
            for (const double x : {v.x, v.y, v.z})
                put(body, static_cast<float>(x));
        for (int i = 0; i < 9; ++i) // how it changes from place to place
            put(body, 0.0f);
        put(body, static_cast<float>(newtons == Vec3d{} ? 0 : fieldRadius));
        putMessage(out, 0, 0, body);
    }
    void end(std::string& out) override {
        m_said = {1, 1, 1};
        force({}, out);
    }

  private:
    bool hear(const Message& message, std::optional<DeviceState>& state);
    bool hearName(const Message& message);
    void hearPlace(const Message& message);
    void hearButton(const Message& message);

    std::string m_name;
    bool m_met = false; ///< the cookie has come
    std::optional<std::int32_t> m_sender, m_place, m_button;
    DeviceState m_state;
    bool m_placed = false;
    Vec3d m_said;
};

bool Vrpn::take(std::string& in, std::string&, std::optional<DeviceState>& state) {
    std::size_t at = 0;
    if (!m_met) {
        const std::size_t known = std::min(in.size(), version.size());
        if (std::string_view(in).substr(0, known) != version.substr(0, known))
            return false;
        if (in.size() < cookieSize)
            return true;
        m_met = true;
        at = cookieSize;
    }
    while (in.size() - at >= headerSize) {
        const char* header = in.data() + at;
        const std::int64_t length = wholeAt(header);
        if (length < std::int64_t(headerSize) || length > std::int64_t(headerSize + mostBody))
            return false;
        const std::size_t body = static_cast<std::size_t>(length) - headerSize, whole = headerSize + padded(body);
        if (in.size() - at < whole)
            break;
        const double time = wholeAt(header + 4) + 1e-6 * wholeAt(header + 8);
        if (!hear(
                {time, wholeAt(header + 12), wholeAt(header + 16), std::string_view(in).substr(at + headerSize, body)},
                state))
            return false;
        at += whole;
    }
    in.erase(0, at);
    return true;
}

bool Vrpn::hear(const Message& message, std::optional<DeviceState>& state) {
    if (message.type == describesSender || message.type == describesType)
        return hearName(message);
    if (message.type == disconnects)
        return false;
    if (message.sender != m_sender)
        return true; // another device of the server's
    if (message.type == m_place)
        hearPlace(message);
    else if (message.type == m_button)
        hearButton(message);
    else
        return true;
    if (m_placed)
        state = m_state;
    return true;
}

/// The number that is given a name stands where other messages have their sender.
bool Vrpn::hearName(const Message& message) {
    if (message.body.size() < 4)
        return false;
    const std::int64_t size = wholeAt(message.body.data()); // with the zero at its end
    if (size < 1 || size > std::int64_t(message.body.size()) - 4)
        return false;
    const std::string_view name = message.body.substr(4, static_cast<std::size_t>(size) - 1);
    if (message.type == describesSender && name == m_name)
        m_sender = message.sender;
    else if (message.type == describesType && name == "vrpn_Tracker Pos_Quat")
        m_place = message.sender;
    else if (message.type == describesType && name == "vrpn_Button Change")
        m_button = message.sender;
    return true;
}

/// Sensor, padding, place, quaternion.
void Vrpn::hearPlace(const Message& message) {
    if (message.body.size() < 64 || wholeAt(message.body.data()) != 0)
        return;
    const char* at = message.body.data() + 8;
    const Vec3d place{realAt(at), realAt(at + 8), realAt(at + 16)};
    constexpr double far = 10; // metres: no tool's place
    if (!isFinite(place) || length(place) > far)
        return;
    const double seconds = message.time - m_state.time;
    if (m_placed && seconds <= 0 && seconds > -1) // an older report; more than that is a clock that was set
        return;
    m_state.velocity = m_placed && seconds > 0 ? (place - m_state.position) / seconds : Vec3d{};
    m_state.position = place;
    m_state.time = message.time;
    m_placed = true;
}

/// The button's number and whether it is down.
void Vrpn::hearButton(const Message& message) {
    if (message.body.size() < 8)
        return;
    const std::int32_t button = wholeAt(message.body.data()), down = wholeAt(message.body.data() + 4);
    if (button < 0 || button > 30)
        return;
    const unsigned bit = 1u << button;
    m_state.buttons = down != 0 ? m_state.buttons | bit : m_state.buttons & ~bit;
}

} // namespace

std::unique_ptr<LineProtocol> makeVrpn(const std::string& name) {
    return std::make_unique<Vrpn>(name.empty() ? "Phantom0" : name);
}

std::unique_ptr<Device> openVrpn(const DeviceSetup& setup) {
    // of a PHANToM, whose end weighs some 75 g
    return openLineDevice(setup.address.empty() ? "Phantom0@localhost:3883" : setup.address,
                          {makeVrpn, {3.3, 1000, 0.075, lineDelay}});
}

} // namespace haptics
