#include "core/session/scene/scene_ply.h"

#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/session/json_text.h"
#include "core/session/scene/joined_models.h"
#include "core/surface/definition_text.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

namespace session {

using nlohmann::json;
using surfel::Attribute, surfel::AttributeLayout, surfel::ScalarType;

static constexpr const char* partAttribute = "part";
static constexpr std::string_view prefix = "pointclay-part ";

static void refuse(const SceneModel& model) {
    const char* what = !model.layers.empty()                     ? "has layers"
                       : model.surface.definition().connectivity ? "is a cell complex"
                                                                 : nullptr;
    if (what)
        throw base::Error("\"" + model.name + "\" " + what + ", which one PLY holds of one model only", {},
                          "save the scene as NAME.scene.json, a file for each model, or that model alone");
}

/// What the one file does not say of each model.
static json lineOf(const SceneModel& model, bool active) {
    const AttributeLayout& layout = *model.surface.tree().layout();
    json attributes = json::object();
    for (const Attribute& a : layout.attributes())
        attributes[a.name] = static_cast<int>(a.type);
    return {{"name", model.name},
            {"surface", surface::toWords(model.surface.definition())},
            {"up", base::upRow(model.up).id},
            {"normals", layout.normals},
            {"oriented", layout.oriented},
            {"colours", layout.colours},
            {"masks", layout.masks},
            {"attributes", std::move(attributes)},
            {"visible", model.visible},
            {"locked", model.locked},
            {"active", active}};
}

io::FileModel togetherAsParts(const Scene& scene) {
    const SceneModel& first = scene.models.front();
    io::FileModel out;
    out.origin = first.pose(first.origin());
    out.up = first.up;
    out.hasSupports = out.limitDecided = true;
    out.definition = first.surface.definition();
    const std::shared_ptr<AttributeLayout> layout = unitedLayout(scene.models);
    if (!layout->find(partAttribute))
        layout->add(partAttribute, ScalarType::Int32);
    const Attribute& part = *layout->find(partAttribute);
    out.points.layout = layout;
    SceneModel frame; // the scene's, with that origin
    Provenance at;
    at.origin = out.origin;
    frame.provenance = std::make_shared<Provenance>(at);
    for (std::size_t k = 0; k < scene.models.size(); ++k) {
        const SceneModel& model = scene.models[k];
        refuse(model);
        const std::size_t begin = out.points.size();
        appendAs(out.points, placed(model.surface, between(model, frame)).tree().surfels());
        for (std::size_t i = begin; i < out.points.size(); ++i)
            surfel::write(part, std::span(out.points.extra).subspan(i * layout->words(), layout->words()),
                          static_cast<double>(k));
        out.comments.push_back(std::string(prefix) + std::to_string(k) + " " +
                               lineOf(model, k == scene.active).dump(-1, ' ', false, json::error_handler_t::replace));
    }
    return out;
}

namespace {

/// A line that is understood, by the number of its part.
struct Line {
    ScenePart part;
    surfel::AttributeLayoutPtr layout;
};

std::shared_ptr<AttributeLayout> layoutOf(const json& line) {
    auto out = std::make_shared<AttributeLayout>();
    out->normals = line.at("normals").get<bool>();
    out->oriented = line.at("oriented").get<bool>();
    out->colours = line.at("colours").get<bool>();
    out->masks = line.at("masks").get<bool>();
    for (const auto& [name, type] : line.at("attributes").items()) {
        const int number = type.get<int>();
        if (number < 0 || number > static_cast<int>(ScalarType::Float64))
            throw base::Error("unknown type");
        out->add(name, static_cast<ScalarType>(number));
    }
    return out;
}

std::optional<std::pair<int, Line>> lineOf(const std::string& comment) {
    if (!std::string_view(comment).starts_with(prefix))
        return {};
    try {
        const std::size_t blank = comment.find(' ', prefix.size());
        const int number = std::stoi(comment.substr(prefix.size(), blank - prefix.size()));
        const json line = jsonOf(std::string_view(comment).substr(std::min(blank, comment.size())));
        Line out;
        out.layout = layoutOf(line);
        out.part.model.name = line.at("name").get<std::string>();
        out.part.model.visible = line.at("visible").get<bool>();
        out.part.model.locked = line.at("locked").get<bool>();
        out.part.active = line.at("active").get<bool>();
        out.part.file.definition = surface::definitionFromWords(line.at("surface").get<std::string>());
        out.part.file.limitDecided = line.at("surface").get<std::string>().find("boundary-limit=") != std::string::npos;
        const base::UpRow& up = base::rowOf(base::upTable(), line.at("up").get<std::string>(), {"", "", ""});
        out.part.file.up = up.axis;
        const bool sound = number >= 0 && isModelName(out.part.model.name) && !out.part.file.definition->connectivity;
        return sound ? std::optional(std::pair(number, std::move(out))) : std::nullopt;
    } catch (const std::exception&) { // a line of somebody else, or one that was changed: the points are still good
        return {};
    }
}

/// Each point to its part; false where one has none.
bool share(const surfel::SurfelList& points, std::map<int, Line>& lines) {
    const Attribute* number = points.layout->find(partAttribute);
    if (!number)
        return false;
    for (auto& [id, line] : lines)
        line.part.file.points.layout = line.layout;
    std::vector<std::uint32_t> words;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double part = surfel::read(*number, points.extraOf(i));
        const auto line = lines.find(static_cast<int>(std::clamp(part, -1.0, 1e9)));
        if (line == lines.end())
            return false;
        surfel::SurfelList& own = line->second.part.file.points;
        words.assign(own.layout->words(), 0);
        for (const Attribute& a : own.layout->attributes())
            if (const Attribute* from = points.layout->find(a.name))
                surfel::write(a, words, surfel::read(*from, points.extraOf(i)));
        own.append(points.items[i], words);
    }
    return std::ranges::none_of(lines, [](const auto& each) { return each.second.part.file.points.items.empty(); });
}

} // namespace

static bool isLine(const std::string& comment) {
    return std::string_view(comment).starts_with(prefix);
}

bool tellsOfParts(const io::FileModel& file) {
    return std::ranges::any_of(file.comments, isLine);
}

std::vector<ScenePart> partsOf(io::FileModel& file) {
    std::map<int, Line> lines;
    for (const std::string& comment : file.comments)
        if (auto line = lineOf(comment))
            lines.insert(std::move(*line));
    if (lines.empty())
        return {};
    const bool fits = share(file.points, lines);
    std::erase_if(file.comments, isLine);
    if (!fits) {
        file.messages.push_back("The models that the file tells of are not those of its points: it is opened as one.");
        return {};
    }
    std::vector<ScenePart> out;
    for (auto& [number, line] : lines) {
        io::FileModel& part = line.part.file;
        part.origin = file.origin;
        part.usualUp = file.usualUp;
        part.hasSupports = file.hasSupports;
        part.format = file.format;
        part.comments = file.comments;
        if (out.empty()) {
            part.dropped = file.dropped;
            part.messages = file.messages;
        }
        out.push_back(std::move(line.part));
    }
    return out;
}

} // namespace session
