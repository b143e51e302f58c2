#include "core/process/estimation/prepare.h"
#include "core/process/samples/samples.h"
#include "core/session/commands/commands.h"
#include "core/session/surface_options.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static void make(Context& context, const json& complete) {
    const process::SampleRow& sample = process::sample(complete.at("sample").get<std::string>());
    const std::size_t count = complete.value("count", sample.count);
    const auto surface = changed(process::definitionOf(sample, count), complete);
    surface::Surface made = process::prepare(sample.make(count, complete.at("seed").get<std::uint64_t>()),
                                             {surface.definition, false}, context.progress);
    Provenance provenance;
    provenance.format = std::string("sample ") + sample.id;
    context.document.reset(std::move(made), std::move(provenance));
}

CommandRow newCommand() {
    static const std::string samples = idsOf(process::sampleTable());
    static const CommandParameter own[] = {
        {"sample", "choice", "", "what to make", "", samples.c_str(), 0, 0},
        {"count", "integer", "surfels", "about how many; each sample has its own default", "null", "", 100, 1e8},
        {"seed", "integer", "", "selects among random variants", "1", "", 0, 9007199254740992.0},
    };
    static const auto parameters = withSurfaceParameters(own);
    return {"new", "New", "Makes a sample model by code.", parameters, true, true, make, nullptr};
}

} // namespace session
