#include "core/session/session_file.h"

#include "core/base/error.h"
#include "core/session/json_text.h"
#include "core/session/session_lines.h"

#include <chrono>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

namespace {

bool isJson(const std::string& text) {
    return json::accept(text);
}

LineReport executed(const json& command, int line, Context& context) {
    context.dabs = 0;
    context.dabSeconds.clear();
    const auto begin = std::chrono::steady_clock::now();
    run(context, command);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    return {line, command["op"], time.count(), context.document.surface().tree().size(), context.dabSeconds};
}

} // namespace

int replay(const std::filesystem::path& file, Context& context, const ReplayOptions& options) {
    SessionLines lines(file);
    context.folder = std::filesystem::absolute(file).parent_path();
    int count = 0;
    while (lines.next()) {
        if (!lines.isCommand())
            continue;
        if (options.torn && (!lines.whole || (lines.isLast() && !isJson(lines.text)))) {
            options.torn(lines.number);
            break;
        }
        try {
            const LineReport report = executed(jsonOf(lines.text), lines.number, context);
            if (options.done)
                options.done(report);
            ++count;
        } catch (const base::Error& error) {
            const base::Error placed(error.message(), file.string() + ":" + std::to_string(lines.number));
            if (count == 0 || !options.passedOver)
                throw placed;
            options.passedOver(placed);
        }
    }
    return count;
}

} // namespace session
