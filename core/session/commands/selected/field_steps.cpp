#include "core/session/commands/selected/field_steps.h"

#include "core/base/error.h"
#include "core/selection/blur.h"
#include "core/selection/spread.h"
#include "core/session/commands/scans/clean_steps.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;
using selection::BlockValues, selection::Field;
using surfel::SurfelBlock;

double neededNumber(const json& complete, const char* id) {
    if (!complete.contains(id))
        throw base::Error("\"" + complete.at("op").get<std::string>() + "\" needs the parameter \"" + id + "\" to " +
                          complete.at("do").get<std::string>());
    return complete.at(id).get<double>();
}

void commitSelection(Context& context, tree::SurfelTree next, const std::string& label, bool hidden) {
    if (!hidden)
        next = selection::combined(next, selection::selectedIn(next, Field::Hidden), selection::Mode::Subtract);
    const std::size_t count = sizeOf(selection::selectedIn(next));
    context.figures["selected"] = static_cast<double>(count);
    context.messages.push_back(std::to_string(count) + " of " + std::to_string(next.size()) + " surfels are selected.");
    clean::commit(context, {next, context.document.surface().definition()}, label);
}

tree::SurfelTree fieldChanged(Context& context, Field field, const json& complete) {
    const surface::Surface& surface = context.document.surface();
    const auto what = complete.at("do").get<std::string>();
    if (what == "blur")
        return selection::blurred(surface, field, neededNumber(complete, "length"), context.progress);
    if (what == "sharpen")
        return selection::sharpened(surface, field, neededNumber(complete, "length"), complete.at("strength"),
                                    context.progress);
    if (what == "grow")
        return selection::grown(surface, field, neededNumber(complete, "length"), context.progress);
    if (what == "shrink")
        return selection::shrunk(surface, field, neededNumber(complete, "length"), context.progress);
    const int other =
        selection::channelOf(*surface.tree().layout(), field == Field::Mask ? Field::Selection : Field::Mask);
    return selection::rewritten(
        surface.tree(), field, [&](std::uint32_t, const SurfelBlock& block, BlockValues& values) {
            for (int slot = 0; slot < block.size(); ++slot) {
                float& v = values[static_cast<std::size_t>(slot)];
                v = what == "clear" ? 0 : what == "invert" ? 1 - v : selection::valueAt(block, other, slot);
            }
        });
}

} // namespace session
