// The one executor: check, run, roll back on failure, validate in debug builds, journal.
#include "core/base/cancel_scope.h"
#include "core/session/command.h"
#include "core/session/journal.h"

#include <nlohmann/json.hpp>

namespace session {

static void execute(const CommandRow& row, Context& context, const nlohmann::json& complete) {
    const base::CancelScope scope(context.progress.cancel);
    const Document before = context.document;
    try {
        row.run(context, complete);
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
    execute(row, context, whole);
    if (context.journal && row.changesModel)
        context.journal->record(whole, context);
}

} // namespace session
