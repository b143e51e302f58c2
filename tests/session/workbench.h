// What tests of this room start from: a folder of their own, a document and a context, a small sphere and strokes on
// it.
#pragma once

#include "core/base/error.h"
#include "core/session/command.h"
#include "core/session/journal.h"
#include "core/session/recover.h"
#include "core/session/session_file.h"
#include "support/threads.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <QFloat16>
#include <QTemporaryDir>
#include <sstream>

namespace test {

using nlohmann::json;

struct Workbench {
    QTemporaryDir dir;
    session::Document document;
    session::Context context{document, {}, {}, {}, 0, {}, nullptr};

    std::filesystem::path path(const std::string& name) const { return dir.filePath(name.c_str()).toStdString(); }
    void run(const json& command) { session::run(context, command); }
    std::string hash() const { return document.hash().text(); }
    std::size_t size() const { return document.surface().tree().size(); }
    /// The message of the base::Error that the command throws; empty where it throws none.
    std::string refusal(const json& command) {
        try {
            run(command);
        } catch (const base::Error& error) {
            return error.message();
        }
        return {};
    }
};

inline std::string contentOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

inline std::filesystem::path write(const std::filesystem::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
    return file;
}

inline json newSphere(int count = 3000) {
    return {{"op", "new"}, {"sample", "sphere"}, {"count", count}};
}

/// Rays along -z over the front of the sphere from x = -0.4 to 0.4 in a shallow arc that begins at height `y`.
inline json samplesAt(double y, int count = 12) {
    json out = json::array();
    for (int k = 0; k < count; ++k) {
        const double part = static_cast<double>(k) / (count - 1);
        out.push_back({0.8 * part - 0.4, y + 0.1 * part * part, 5.0, 0.0, 0.0, -1.0, 0.5 + 0.5 * part, 0.02 * k});
    }
    return out;
}

inline json strokeAt(double y, const std::string& tool = "draw") {
    json out{{"op", "stroke"}, {"tool", tool}, {"radius", 0.3}, {"samples", samplesAt(y)}};
    if (tool == "clone") // from itself it would copy what is there
        out["x"] = 0.3;
    return out;
}

/// A sphere with uneven spacing, relief and colours, on which every tool finds work.
inline void makeWorkpiece(Workbench& bench) {
    bench.run(newSphere());
    for (const char* tool : {"grab", "draw", "paint"}) {
        json stroke = strokeAt(0, tool);
        stroke["resample"] = tool == std::string_view("draw");
        bench.run(stroke);
    }
}

/// The hash of a step that undo takes back and redo brings again, with the same bits on one and two threads and from
/// the journal; empty where any of that is not so. `prepare(bench)` makes the model. The result is left in `out`.
template <class Prepare>
std::string hashOfStep(Workbench& out, const Prepare& prepare, const json& step) {
    const auto made = [&](Workbench& bench) {
        session::Journal journal(bench.path("j.jsonl"));
        bench.context.journal = &journal;
        prepare(bench);
        const std::string before = bench.hash();
        bench.run(step);
        bench.document.surface().tree().validate();
        const std::string after = bench.hash();
        bench.run({{"op", "undo"}});
        const bool back = bench.hash() == before && after != before;
        bench.run({{"op", "redo"}});
        bench.context.journal = nullptr;
        return back && bench.hash() == after ? after : std::string();
    };
    Workbench two, again;
    const std::string hash = onThreads(1, [&] { return made(out); });
    if (onThreads(2, [&] { return made(two); }) != hash)
        return {};
    session::recover(out.path("j.jsonl"), again.context);
    return again.hash() == hash ? hash : std::string();
}

} // namespace test
