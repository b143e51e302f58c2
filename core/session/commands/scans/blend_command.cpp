#include "core/base/error.h"
#include "core/process/measuring/measured_attribute.h"
#include "core/process/registering/colour_blend.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static std::vector<std::uint32_t> scansOf(const surfel::SurfelList& list, const std::string& name, std::size_t& count) {
    constexpr std::size_t most = 1000;
    const surfel::Attribute* attribute = list.layout->find(name);
    if (!attribute)
        throw base::Error("the model has no attribute \"" + name + "\" that tells its scans apart", {},
                          "name the one that does: \"scan\" of E57 and PTX, \"part\" of joined models");
    std::map<double, std::uint32_t> numbers;
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const double value = surfel::read(*attribute, list.extraOf(i));
        out.push_back(numbers.try_emplace(value, static_cast<std::uint32_t>(numbers.size())).first->second);
        if (numbers.size() > most)
            throw base::Error("the attribute \"" + name + "\" has more than 1000 values", {},
                              "name the one that tells scans apart");
    }
    count = numbers.size();
    return out;
}

static void blend(Context& context, const json& complete) {
    requireModel(context);
    const surface::Surface& now = context.document.surface();
    const surfel::SurfelList list = now.tree().surfels();
    if (!list.layout->colours)
        throw base::Error("the model has no colours to blend", {}, "open scans that have them");
    std::size_t scans = 0;
    const std::vector<std::uint32_t> scanOf = scansOf(list, complete.at("by").get<std::string>(), scans);
    if (scans < 2)
        throw base::Error("all points are of one scan", {}, "join scans first");
    const process::BlendedColours found =
        process::blendColours(list, scanOf, scans, complete.at("fade").get<int>(), context.progress);
    if (found.pairs == 0)
        throw base::Error("the scans do not overlap anywhere", {}, "register them first");
    const auto tenth = [](double v) { return std::round(10 * v) / 10; };
    std::ostringstream told;
    told << scans << " scans blended: where they overlap colours differed by " << tenth(found.before)
         << " levels of 255, and now by " << tenth(found.after) << ".";
    context.messages.push_back(told.str());
    context.figures["before"] = found.before, context.figures["after"] = found.after;
    clean::commit(context, {process::withColours(now.tree(), found.colours), now.definition()}, "Blend colours");
}

CommandRow blendCommand() {
    static const CommandParameter parameters[] = {
        {"by", "text", "", "attribute that tells which scan a point is of: scan of E57 and PTX, part of joined models",
         "\"scan\"", "", 0, 0},
        {"fade", "integer", "", "points over which what still differs fades out; 0: brightness of whole scans alone",
         "10", "", 0, 100},
    };
    return {"blend",
            "Blend colours",
            "Makes scans that were taken in different light alike in colour.",
            parameters,
            true,
            false,
            blend,
            nullptr};
}

} // namespace session
