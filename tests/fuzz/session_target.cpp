// Sessions, parsed and executed on a small model. A line that fails or is cancelled leaves the model as it was; undo
// and redo lead back to the same bits.
#include "core/session/session_file.h"
#include "fuzz/fuzzed.h"
#include "fuzz/tame_session.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const bool ready = (fuzz::putModels(), true);
    static_cast<void>(ready);
    fuzz::removeSaved();
    const auto file = fuzz::put("s.jsonl", fuzz::tamed({reinterpret_cast<const char*>(data), size}));
    session::Document document = fuzz::smallDocument();
    const fuzz::Deadline deadline;
    session::Context context{document, {}, deadline.progress(), {}, 0, {}, nullptr};
    base::Hash128 last = document.hash();
    session::ReplayOptions options;
    options.done = [&](const session::LineReport&) { last = document.hash(); };
    const bool whole = fuzz::tried([&] { session::replay(file, context, options); });
    fuzz::require(whole || document.hash() == last, "a line that fails changes nothing");
    document.surface().tree().validate();
    if (document.canUndo()) {
        document.undo();
        document.surface().tree().validate();
        document.redo();
        fuzz::require(document.hash() == last, "redo leads back");
    }
    return 0;
}
