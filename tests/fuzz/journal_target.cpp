// Left journals: found, recovered as far as they go, and recorded anew in a journal that holds the same model.
#include "core/session/journal.h"
#include "core/session/recover.h"
#include "fuzz/fuzzed.h"
#include "fuzz/tame_session.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const bool ready = (fuzz::putModels(), true);
    static_cast<void>(ready);
    fuzz::removeSaved();
    const auto left = fuzz::put("journal-1.jsonl", fuzz::tamed({reinterpret_cast<const char*>(data), size}));
    fuzz::require(session::findLeftJournals(fuzz::folder()).size() <= 1, "one journal is one");

    const auto own = fuzz::folder() / "own.jsonl";
    session::removeJournal(own);
    session::Document document;
    const fuzz::Deadline deadline;
    {
        session::Journal journal(own);
        session::Context context{document, {}, deadline.progress(), {}, 0, {}, &journal};
        fuzz::tried([&] { session::recover(left, context); });
    }
    if (document.surface().tree().empty() || deadline.passed())
        return 0;
    session::Document again;
    session::Context context{again, {}, {}, {}, 0, {}, nullptr};
    fuzz::require(fuzz::tried([&] { session::recover(own, context); }), "a journal of ours can be recovered");
    fuzz::require(again.hash() == document.hash(), "it holds the same model");
    return 0;
}
