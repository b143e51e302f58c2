#include "core/layers/stack.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace layers {

constexpr std::string_view prefix = "pointclay-layer ";
constexpr std::size_t longestName = 64;

int Stack::indexOf(std::uint32_t id) const {
    for (std::size_t i = 0; i < layers.size() && id != 0; ++i)
        if (layers[i].id == id)
            return static_cast<int>(i);
    return -1;
}

int Stack::indexOf(std::string_view name) const {
    for (std::size_t i = 0; i < layers.size(); ++i)
        if (layers[i].name == name)
            return static_cast<int>(i);
    return -1;
}

Layer& Stack::add(const std::string& name) {
    std::uint32_t id = 1;
    for (const Layer& each : layers)
        id = std::max(id, each.id + 1);
    layers.push_back({id, name, 1, true});
    active = id;
    return layers.back();
}

bool isName(std::string_view name) {
    return !name.empty() && name.size() <= longestName && name.front() != ' ' && name.back() != ' ' &&
           std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; });
}

static std::string text(float value) {
    char out[32];
    return {out, std::to_chars(out, out + sizeof out, value).ptr};
}

std::vector<std::string> linesOf(const Stack& stack) {
    std::vector<std::string> out;
    for (const Layer& each : stack.layers)
        out.push_back(std::string(prefix) + std::to_string(each.id) + " strength " + text(each.strength) + " visible " +
                      (each.visible ? "1" : "0") + " active " + (each.id == stack.active ? "1" : "0") + " name " +
                      each.name);
    return out;
}

namespace {

/// Reads words from the front of a line; what does not fit makes it fail for good.
class Words {
  public:
    explicit Words(std::string_view line) : m_rest(line) {}
    std::string_view next() {
        const std::size_t blank = std::min(m_rest.find(' '), m_rest.size());
        const std::string_view out = m_rest.substr(0, blank);
        m_rest.remove_prefix(std::min(blank + 1, m_rest.size()));
        return out;
    }
    void expect(std::string_view word) { m_good = next() == word && m_good; }
    template <class Number>
    Number number() {
        const std::string_view word = next();
        Number out{};
        const auto read = std::from_chars(word.data(), word.data() + word.size(), out);
        m_good = m_good && read.ec == std::errc() && read.ptr == word.data() + word.size();
        return out;
    }
    bool flag() {
        const auto value = number<unsigned>();
        m_good = m_good && value <= 1;
        return value == 1;
    }
    std::string_view rest() const { return m_rest; }
    bool good() const { return m_good; }

  private:
    std::string_view m_rest;
    bool m_good = true;
};

struct Line {
    Layer layer;
    bool active = false;
};

std::optional<Line> lineOf(std::string_view comment) {
    if (!comment.starts_with(prefix))
        return {};
    Words words(comment.substr(prefix.size()));
    Line out;
    out.layer.id = words.number<std::uint32_t>();
    words.expect("strength");
    out.layer.strength = words.number<float>();
    words.expect("visible");
    out.layer.visible = words.flag();
    words.expect("active");
    out.active = words.flag();
    words.expect("name");
    out.layer.name = std::string(words.rest());
    const bool sound = out.layer.id > 0 && out.layer.id < 0x40000000u && out.layer.strength >= leastStrength &&
                       out.layer.strength <= mostStrength && isName(out.layer.name);
    return words.good() && sound ? std::optional(out) : std::nullopt;
}

} // namespace

Stack takeLines(std::vector<std::string>& comments) {
    Stack out;
    std::erase_if(comments, [&](const std::string& comment) {
        const std::optional<Line> line = lineOf(comment);
        if (!line || out.indexOf(line->layer.id) >= 0 || out.indexOf(line->layer.name) >= 0)
            return false;
        out.layers.push_back(line->layer);
        if (line->active)
            out.active = line->layer.id;
        return true;
    });
    return out;
}

} // namespace layers
