#include "core/haptics/devices/inverse3.h"

#include "core/haptics/devices/web_socket.h"

#include <chrono>
#include <nlohmann/json.hpp>

namespace haptics {

using base::Vec3d;
using nlohmann::json;

namespace {

constexpr int deepest = 12; ///< of what the service sends; its messages go to 5

/// The value under a key; null where there is none.
const json& at(const json& object, const char* key) {
    static const json none;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() ? *found : none;
}

const json& firstOf(const json& list) {
    static const json none;
    return list.is_array() && !list.empty() ? list.front() : none;
}

std::optional<Vec3d> vectorOf(const json& value) {
    const json &x = at(value, "x"), &y = at(value, "y"), &z = at(value, "z");
    if (!x.is_number() || !y.is_number() || !z.is_number())
        return {};
    const Vec3d out{x.get<double>(), y.get<double>(), z.get<double>()};
    constexpr double far = 10; // metres, or metres a second: no device is there
    return isFinite(out) && length(out) < far ? std::optional(out) : std::nullopt;
}

/// From its frame to ours: right, up, towards the person.
Vec3d ours(const Vec3d& v) {
    return {v.x, v.z, -v.y};
}
Vec3d theirs(const Vec3d& v) {
    return {v.x, -v.z, v.y};
}

class Inverse3 final : public LineProtocol {
  public:
    explicit Inverse3(bool older) : m_older(older) {}

    void begin(std::string& out) override { m_socket.begin("localhost", out); }
    bool take(std::string& in, std::string& out, std::optional<DeviceState>& state) override {
        return m_socket.take(in, out, [&](const std::string& message) { return hear(message, state); });
    }
    void force(const Vec3d& newtons, std::string& out) override {
        if (m_owed)
            say(newtons, out);
        m_owed = false;
    }
    void end(std::string& out) override {
        if (!m_socket.open())
            return;
        if (!m_id.empty())
            say({}, out);
        m_socket.end(out);
    }

  private:
    bool hear(const std::string& message, std::optional<DeviceState>& state);
    unsigned buttonsOf(const json& message) const;
    void say(const Vec3d& newtons, std::string& out);

    bool m_older;
    WebSocket m_socket;
    std::string m_id;
    bool m_owed = false; ///< an answer
    DeviceState m_state;
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

bool Inverse3::hear(const std::string& message, std::optional<DeviceState>& state) {
    bool tooDeep = false;
    const json::parser_callback_t shallow = [&](int depth, json::parse_event_t, json&) {
        tooDeep = tooDeep || depth > deepest;
        return !tooDeep;
    };
    const json all = json::parse(message, shallow, false);
    if (all.is_discarded() || tooDeep || !all.is_object())
        return false;
    const json& device = firstOf(at(all, "inverse3"));
    const json& id = at(device, "device_id");
    if (!id.is_string() || id.get_ref<const std::string&>().empty()) // none is plugged in
        return true;
    m_id = id.get<std::string>();
    m_owed = true;
    const json& told = at(device, "state");
    const auto place = vectorOf(at(told, "cursor_position"));
    if (!place)
        return true;
    m_state.position = ours(*place);
    m_state.velocity = ours(vectorOf(at(told, "cursor_velocity")).value_or(Vec3d{}));
    m_state.buttons = buttonsOf(all);
    m_state.time = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
    state = m_state;
    return true;
}

/// Of whichever grip is there: with or without a wire, or one made by oneself.
unsigned Inverse3::buttonsOf(const json& message) const {
    unsigned out = 0;
    for (const char* grip : {"wireless_verse_grip", "verse_grip", "custom_verse_grip"}) {
        const json& state = at(firstOf(at(message, grip)), "state");
        const json& buttons = at(state, "buttons");
        out |= at(buttons, "a") == true || at(state, "button") == true ? holdButton : 0;
        out |= at(buttons, "b") == true ? clutchButton : 0;
    }
    return out;
}

void Inverse3::say(const Vec3d& newtons, std::string& out) {
    const Vec3d f = theirs(newtons);
    const json vector{{"x", f.x}, {"y", f.y}, {"z", f.z}};
    const json command{{"set_cursor_force", {{m_older ? "values" : "vector", vector}}}};
    const json device{{"device_id", m_id}, {"commands", command}};
    m_socket.send(json{{"inverse3", json::array({device})}}.dump(-1, ' ', true, json::error_handler_t::replace), out);
}

} // namespace

std::unique_ptr<LineProtocol> makeInverse3(const std::string& name) {
    return std::make_unique<Inverse3>(name == "VALUES");
}

std::unique_ptr<Device> openInverse3(const DeviceSetup& setup) {
    // what its maker gives: 8 N, and a stiffness that it renders well at a thousand answers a second
    return openLineDevice(setup.address.empty() ? "localhost:10001" : setup.address,
                          {makeInverse3, {8, 1500, 0.1, lineDelay}});
}

} // namespace haptics
