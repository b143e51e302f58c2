// pointclay run: executes a session, with a journal beside it.
#include "app/command_help.h"
#include "app/framing.h"
#include "app/open_model.h"
#include "app/options/face_options.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/scene_view.h"
#include "app/subcommands/subcommand.h"
#include "app/writable_models.h"
#include "core/base/error.h"
#include "core/io/safe_file.h"
#include "core/render/framed_box.h"
#include "core/render/image_io.h"
#include "core/render/scene_picture.h"
#include "core/render/shading/own_colours.h"
#include "core/session/journal.h"
#include "core/session/session_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace app {

using nlohmann::ordered_json;

namespace {

struct RunArguments {
    std::string session, model, out, image, timings, journal;
    GivenParameters faces;
    bool anyway = false;
};

/// The journal of one run: a named one stays, the default one goes with the process's normal end.
class RunJournal {
  public:
    RunJournal(const std::string& path, Console& console) : m_named(!path.empty()) {
        try {
            m_journal = std::make_unique<session::Journal>(path);
        } catch (const base::Error& error) {
            if (m_named)
                throw;
            console.tell(error.message() + "; continuing without a journal");
        }
    }
    ~RunJournal() {
        if (m_journal && !m_named)
            m_journal->discard();
    }
    /// Everything is written: a named journal may be replaced from now on.
    void end(session::Context& context) {
        if (m_journal && m_named)
            m_journal->end(context);
    }
    session::Journal* get() { return m_journal.get(); }

  private:
    bool m_named;
    std::unique_ptr<session::Journal> m_journal;
};

/// The value that a share `q` of the sorted ones does not exceed (nearest rank); 0 for none.
double quantile(const std::vector<double>& sorted, double q) {
    if (sorted.empty())
        return 0;
    const double rank = std::ceil(q * static_cast<double>(sorted.size()));
    return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

ordered_json timingOf(const session::LineReport& report) {
    std::vector<double> ms;
    for (const double seconds : report.dabSeconds)
        ms.push_back(1000 * seconds);
    std::sort(ms.begin(), ms.end());
    return {{"line", report.line},
            {"op", report.op},
            {"seconds", report.seconds},
            {"surfels", report.surfels},
            {"dabs", ms.size()},
            {"dab_ms", {{"p50", quantile(ms, 0.5)}, {"p99", quantile(ms, 0.99)}, {"max", quantile(ms, 1)}}}};
}

void savePicture(session::Document document, const std::string& path, const base::Progress& progress) {
    if (document.surface().tree().empty())
        throw base::Error("there is no model to draw", path, "open one in the session or with --model");
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    standInScene(context);
    const SceneView scene = sceneView(document, progress);
    render::PictureStats stats;
    render::PictureOptions look;
    look.style.shading = render::usualShading(document.surface().tree());
    const render::Camera camera =
        closeUp(render::Camera::looking(render::framedBox(scene.whole), 1280, 720, document.up()), scene.whole);
    render::savePng(render::ScenePictureMaker(scene.models, look).draw(camera, stats, progress), path);
}

/// What was done, in one line: strokes that went well say nothing of their own.
std::string doneText(int commands, int strokes, std::size_t before, std::size_t after) {
    const auto counted = [](int n, const char* noun) { return std::to_string(n) + ' ' + noun + (n == 1 ? "" : "s"); };
    std::string out = counted(commands, "command");
    if (strokes > 0)
        out += ", " + counted(strokes, "stroke") + " among them";
    return out + ": " + std::to_string(before) + " surfels before, " + std::to_string(after) + " after.";
}

/// The journal is a file of its own, and so is each output.
void checkNames(const RunArguments& options) {
    const std::pair<const std::string&, const char*> others[] = {{options.session, "the session itself"},
                                                                 {options.out, "the model to be written (-o)"},
                                                                 {options.image, "the picture (--render)"},
                                                                 {options.timings, "the timings (--timings)"}};
    for (const auto& [name, what] : others)
        if (!options.journal.empty() && !name.empty() && samePlace(name, options.journal))
            throw UsageError(std::string("--journal names ") + what + "; the journal needs a name of its own");
    requireOutputs({{"-o", options.out}, {"--render", options.image}, {"--timings", options.timings}});
    if (!options.out.empty())
        requireSceneName(options.out);
}

void runSession(const RunArguments& options, Console& console) {
    checkNames(options);
    session::Document document;
    const base::Progress progress = console.progress();
    RunJournal journal(options.journal, console);
    session::Context context{document, {}, progress, {}, 0, {}, journal.get(), options.anyway};
    if (!options.model.empty())
        openModel(context, options.model, parametersOf(options.faces), console, SceneUse::AsItIs);
    ordered_json timings = ordered_json::array();
    session::ReplayOptions replay;
    const std::size_t before = document.surface().tree().size();
    int strokes = 0;
    replay.done = [&](const session::LineReport& report) {
        strokes += report.op == "stroke";
        timings.push_back(timingOf(report));
        for (const std::string& message : context.messages)
            console.tell("line " + std::to_string(report.line) + ": " + message);
        context.messages.clear();
    };
    const int commands = session::replay(options.session, context, replay);
    context.folder.clear();
    if (!options.out.empty())
        session::run(context, {{"op", "save"}, {"path", options.out}});
    if (!options.image.empty())
        savePicture(document, options.image, progress);
    if (!options.timings.empty())
        io::writeFile(options.timings, timings.dump(1) + "\n");
    journal.end(context);
    console.tell(context.messages);
    console.tell(doneText(commands, strokes, before, document.surface().tree().size()));
}

} // namespace

Action addRun(OptionSet command) {
    auto options = std::make_shared<RunArguments>();
    command.add("SESSION", options->session, "session file with one JSON command per line, such as {\"op\":\"undo\"}")
        .typeName("SESSION.jsonl")
        .required();
    Option model =
        command.add("--model", options->model, std::string("model to open before the first line: ") + modelHelp)
            .typeName("MODEL");
    command.add("-o,--output", options->out, "model to write at the end").typeName("OUT");
    command.add("--render", options->image, "picture of the result").typeName("IMAGE.png").check(pictureName());
    command.add("--timings", options->timings, "seconds of each line and milliseconds of its dabs, as JSON")
        .typeName("OUT.json");
    command
        .add("--journal", options->journal,
             "where to keep the journal for `recover`, no file or the journal of a session that came to its end; "
             "default: in the XDG state folder, removed at the end")
        .typeName("FILE");
    command.addFlag("--anyway", options->anyway,
                    "take files as they are now that have changed since the session was recorded: strokes then meet "
                    "another model than they were drawn on");
    addFaceOptions(command, options->faces, model);
    command.addFooter([] { return "\n\n" + commandHelp(); });
    return [options](Console& console) { runSession(*options, console); };
}

} // namespace app
