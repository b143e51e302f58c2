#include "fuzz/tame_session.h"

#include "core/base/hash.h"
#include "core/io/formats.h"
#include "core/session/command.h"
#include "core/session/json_text.h"
#include "fuzz/fuzzed.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

namespace fuzz {

using nlohmann::json;

static constexpr int mostLines = 12;
static constexpr std::size_t mostSamples = 12;
static constexpr const char* saved = "out.ply out.xyz out.obj no/out.ply";

static session::Document madeSmall() {
    session::Document out;
    session::Context context{out, {}, {}, {}, 0, {}, nullptr};
    session::run(context, {{"op", "new"}, {"sample", "sphere"}, {"count", 150}});
    return out;
}

const session::Document& smallDocument() {
    static const session::Document document = madeSmall();
    return document;
}

void putModels() {
    io::write(folder() / "a.ply", smallDocument().fileModel());
    put("b.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 0 0.1\n2 1 0.1\n0 2 0.2\n1 2 0.2\n2 2 0.3\n");
    put("f.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\n"
                 "f 1/1 3/2 2/3\nf 1/1 2/2 4/3\nf 1/1 4/2 3/3\nf 2/1 3/2 4/3\n");
}

void removeSaved() {
    std::error_code none;
    for (const char* name : {"out.ply", "out.xyz", "out.obj"})
        std::filesystem::remove(folder() / name, none);
}

/// Every text leads somewhere, the same to the same place.
static std::string tamePath(const std::string& op, const std::string& id, const std::string& text) {
    const std::size_t number = std::hash<std::string>()(text);
    const std::string name = op == "save"    ? oneOf(saved, number)
                             : id == "stamp" ? oneOf("p.png p.png no.png a.ply", number)
                                             : oneOf("a.ply b.xyz f.obj out.ply out.xyz no.ply", number);
    const std::string path = (folder() / name).string();
    return text.starts_with("file://") ? "file://" + path : path;
}

static void lessen(json& command, const char* id, double most) {
    const auto at = command.find(id);
    if (at != command.end() && at->is_number() && at->get<double>() > most)
        *at = static_cast<int>(most);
}

static json tamedCommand(json command) {
    const auto op = command.find("op");
    const std::string name = op != command.end() && op->is_string() ? op->get<std::string>() : std::string();
    for (const session::CommandRow& row : session::commandTable())
        for (const session::CommandParameter& p : row.parameters)
            if (const auto at = command.find(p.id);
                std::string_view(p.type).starts_with("path") && at != command.end()) {
                if (at->is_string())
                    *at = tamePath(name, p.id, at->get<std::string>());
                else if (at->is_array())
                    for (json& each : *at)
                        each = tamePath(name, p.id, each.is_string() ? each.get<std::string>() : std::string());
            }
    lessen(command, "count", 150);
    lessen(command, "sample_count", 150);
    if (const auto samples = command.find("samples"); samples != command.end() && samples->is_array())
        while (samples->size() > mostSamples)
            samples->erase(samples->size() - 1);
    if (const auto way = command.find("samples"); name == "touch" && way != command.end() && way->is_array())
        for (json& place : *way) // a second of a hand is a thousand ticks
            if (place.is_array() && !place.empty() && place[0].is_number() && std::abs(place[0].get<double>()) > 1)
                place[0] = std::fmod(place[0].get<double>(), 1.0);
    return command;
}

static std::string tamedLine(const std::string& line) {
    std::string out = line;
    tried([&] {
        const json value = session::jsonOf(line);
        if (value.is_object()) // blanks at the end tell a journal from a session
            out = tamedCommand(value).dump(-1, ' ', false, json::error_handler_t::replace) +
                  line.substr(std::min(line.size(), line.find_last_not_of(" \t\r") + 1));
    });
    return out;
}

std::string tamed(std::string_view session) {
    std::string out;
    for (int k = 0; k < mostLines && !session.empty(); ++k) {
        const std::size_t end = session.find('\n');
        out += tamedLine(std::string(session.substr(0, end)));
        if (end == std::string_view::npos)
            break;
        out += '\n';
        session.remove_prefix(end + 1);
    }
    return out;
}

} // namespace fuzz
