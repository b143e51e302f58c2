// The one executor: check, run, roll back on failure, validate in debug builds, journal.
#include "core/base/cancel_scope.h"
#include "core/complexes/complex.h"
#include "core/session/command.h"
#include "core/session/journal.h"

#include <nlohmann/json.hpp>

namespace session {

/// A command that would leave a complex without what its cells need is refused.
static void requireSound(const surface::Surface& now, const surface::Surface& before) {
    if (now.definition().manifold == surface::Manifold::Complex &&
        !(now.tree() == before.tree() && now.definition() == before.definition()))
        complexes::Complex::of(now);
}

static void execute(const CommandRow& row, Context& context, const nlohmann::json& complete) {
    const base::CancelScope scope(context.progress.cancel);
    const Document before = context.document;
    try {
        row.run(context, complete);
        requireSound(context.document.surface(), before.surface());
#ifndef NDEBUG
        context.document.surface().tree().validate();
#endif
    } catch (...) {
        context.document = before;
        throw;
    }
}

void run(Context& context, const nlohmann::json& command) {
    const nlohmann::json whole = complete(command, context.folder);
    const CommandRow& row = session::command(whole["op"].get_ref<const std::string&>());
    context.instead.reset();
    execute(row, context, whole);
    if (!row.changesModel)
        return;
    if (!context.instead)
        record(context, whole);
    else
        for (const nlohmann::json& each : *context.instead)
            record(context, each);
}

void record(Context& context, const nlohmann::json& complete) {
    if (context.journal)
        context.journal->record(complete, context);
    if (context.recorded)
        context.recorded(complete);
}

} // namespace session
