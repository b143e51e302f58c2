// The one executor: check, run, roll back on failure, validate in debug builds, journal.
#include "core/base/cancel_scope.h"
#include "core/complexes/complex.h"
#include "core/selection/hidden.h"
#include "core/session/command.h"
#include "core/session/journal.h"

#include <nlohmann/json.hpp>

namespace session {

static bool walksHistory(const CommandRow& row) {
    return row.op == std::string_view("undo") || row.op == std::string_view("redo");
}

/// A command that would leave a complex without what its cells need is refused.
static void requireSound(const surface::Surface& now, const surface::Surface& before) {
    if (now.definition().manifold == surface::Manifold::Complex &&
        !(now.tree() == before.tree() && now.definition() == before.definition()))
        complexes::Complex::of(now);
}

/// What is locked stays as it is, and what is hidden is not changed unseen. Undoing and redoing go where things were.
static void requireFree(const Scene& before, const Scene& now) {
    for (const SceneModel& was : before.models) {
        const int at = now.indexOf(was.id);
        if (was.id == 0 || at < 0 || (was.visible && !was.locked))
            continue;
        const surface::Surface& is = now.models[static_cast<std::size_t>(at)].surface;
        if (!(is.tree() == was.surface.tree() && is.definition() == was.surface.definition()))
            refuseChange(was);
    }
}

/// Nobody saw what is hidden change.
static void tellOfHidden(const Scene& before, Context& context) {
    const Scene& now = context.document.scene();
    std::size_t count = 0;
    for (const SceneModel& was : before.models)
        if (const int at = now.indexOf(was.id); was.id != 0 && at >= 0)
            count +=
                selection::hiddenChanged(was.surface.tree(), now.models[static_cast<std::size_t>(at)].surface.tree());
    if (count > 0)
        context.messages.push_back(std::to_string(count) + (count == 1 ? " hidden surfel" : " hidden surfels") +
                                   " changed as well: this works on the whole model.");
}

static void execute(const CommandRow& row, Context& context, const nlohmann::json& complete) {
    const base::CancelScope scope(context.progress.cancel);
    const Document before = context.document;
    try {
        row.run(context, complete);
        requireSound(context.document.surface(), before.surface());
        if (!walksHistory(row))
            requireFree(before.scene(), context.document.scene());
        if (row.changesModel && !row.startsModel && !walksHistory(row) && row.hidden == HiddenParts::Included)
            tellOfHidden(before.scene(), context);
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
    if (row.startsModel && context.instead && context.journal)
        context.journal->opened(context);
}

void record(Context& context, const nlohmann::json& complete) {
    if (context.journal)
        context.journal->record(complete, context);
    if (context.recorded)
        context.recorded(complete);
}

} // namespace session
