#include "core/session/session_file.h"

#include "core/base/error.h"
#include "core/session/json_text.h"

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

namespace {

/// The lines of a file with a look at what follows, so that the last one is known.
class Lines {
  public:
    explicit Lines(const std::filesystem::path& file) : m_name(file.string()), m_in(file, std::ios::binary) {
        if (std::filesystem::is_directory(file) || !m_in)
            throw base::Error("cannot be read", m_name, "name a session file");
    }
    bool next() {
        if (!std::getline(m_in, text)) {
            if (m_in.bad())
                throw base::Error("cannot be read to its end", m_name, "the file or the pipe broke off; try again");
            return false;
        }
        ++number;
        whole = !m_in.eof();
        if (!text.empty() && text.back() == '\r')
            text.pop_back();
        return true;
    }
    bool isLast() { return m_in.peek() == std::ifstream::traits_type::eof(); }
    bool isCommand() const {
        const std::size_t first = text.find_first_not_of(" \t");
        return first != std::string::npos && text[first] != '#';
    }

    std::string text;
    int number = 0;
    bool whole = true; ///< ended by a newline

  private:
    std::string m_name;
    std::ifstream m_in;
};

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
    Lines lines(file);
    context.folder = std::filesystem::absolute(file).parent_path();
    int count = 0;
    while (lines.next()) {
        if (!lines.isCommand())
            continue;
        if (options.allowTornEnd && (!lines.whole || (lines.isLast() && !isJson(lines.text)))) {
            if (options.torn)
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
