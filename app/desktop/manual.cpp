#include "app/desktop/manual.h"

#include "app/command_help.h"
#include "app/desktop/described_subcommands.h"
#include "app/desktop/markup.h"
#include "core/io/formats.h"
#include "core/raycast/material_table.h"
#include "core/render/effects/effect_rows.h"
#include "core/render/shading/shading_table.h"
#include "core/sculpt/tool.h"
#include "ui/view/gesture_table.h"

#include <sstream>

namespace app {

namespace {

const char* const style = "body { font-family: sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; }\n"
                          "td { vertical-align: top; padding: 2px 12px 2px 0; }\n"
                          "code, pre { font-family: monospace; }\n";

/// What no table knows: how to begin. Paragraphs of HTML.
const char* const firstSteps =
    "<p>Pointclay works on points alone. Wherever points lie close enough they define a smooth surface; the program "
    "finds "
    "it, draws it and touches it exactly. There is no mesh to repair, and none to make until you ask for one.</p>\n"
    "<h3>Open and look</h3>\n"
    "<p>Drop a scan or a mesh on the window, or press Ctrl+O. Normals, spacing and boundary are estimated where the "
    "file "
    "does not tell them, and the faces of a mesh are sampled. If the model lies on its side, press U. The left button "
    "beside the model turns the view, the middle button moves it, the wheel zooms. F6 shows the surface itself, ray by "
    "ray, instead of discs.</p>\n"
    "<h3>Sculpt</h3>\n"
    "<p>Choose a tool at the left and draw on the model. Hold Shift to smooth and Ctrl to invert; hold F and move for "
    "the "
    "radius, Shift+F for the strength. Where a stroke stretches the surface, points are added, and where it squeezes, "
    "they are merged; turn &#8220;resample&#8221; off to keep each point. Ctrl+Z takes any step back, and Esc the "
    "stroke "
    "that you are making.</p>\n"
    "<h3>Clean and repair a scan</h3>\n"
    "<p>Remove outliers and duplicates first, then noise; fill the holes; resample at last, if the spacing should be "
    "even. "
    "Each of these is an entry of the menu Model and a step that can be undone, and each is a command for "
    "scripts.</p>\n"
    "<h3>Keep and hand on</h3>\n"
    "<p>PLY keeps everything: points, normals, supports, masks, colours, attributes, and how the surface is defined. "
    "Export a mesh for programs that want triangles. Should the program ever end without saving, the next start offers "
    "what the journal kept.</p>\n";

std::string row(const std::string& left, const std::string& right) {
    return "<tr><td>" + left + "</td><td>" + right + "</td></tr>\n";
}

std::string bold(std::string_view text) {
    return "<b>" + escapedMarkup(text) + "</b>";
}
std::string code(std::string_view text) {
    return "<code>" + escapedMarkup(text) + "</code>";
}

std::string gestures() {
    std::string out = "<table>\n";
    for (const ui::GestureRow& each : ui::gestureTable())
        out += row(bold(each.gesture), escapedMarkup(each.effect));
    return out + "</table>\n";
}

std::string tools() {
    std::string out;
    for (const sculpt::ToolRow& tool : sculpt::toolTable()) {
        out += "<h3>" + escapedMarkup(tool.label) + "</h3>\n<p>" + escapedMarkup(tool.tip);
        if (*tool.shortcut)
            out += " Key: " + bold(tool.shortcut) + ".";
        out += "</p>\n";
        if (tool.parameters.empty())
            continue;
        out += "<table>\n";
        for (const sculpt::ToolParameter& each : tool.parameters) {
            std::ostringstream range;
            range << " From " << each.min << " to " << each.max << (*each.unit ? " " : "") << each.unit << ", else "
                  << each.fallback << ".";
            out += row(bold(each.label), escapedMarkup(each.tip) + escapedMarkup(range.str()));
        }
        out += "</table>\n";
    }
    return out;
}

/// Of this look there is a picture that says something: a knot has neither colours nor something to deviate from.
bool pictured(const render::ShadingRow& each) {
    const bool ofSamples = !each.measure || each.measure->quantity != process::Quantity::Attribute;
    return !each.surfelColours && each.shading != render::Shading::Mask && each.shading != render::Shading::Deviation &&
           ofSamples;
}

std::string shadingPicture(const render::ShadingRow& each) {
    return std::string("shading-") + each.id + ".png";
}
std::string materialPicture(const raycast::MaterialRow& each) {
    return std::string("material-") + each.id + ".png";
}

std::string image(const std::string& file) {
    return "<br><img src=\"" + file + "\" width=\"240\" height=\"180\">";
}

std::string looks(bool pictures) {
    std::string out = "<h3>Shadings</h3>\n<table>\n";
    for (const render::ShadingRow& each : render::shadingTable())
        out += row(bold(each.label) + "<br>" + code(each.id),
                   escapedMarkup(each.tip) + (pictures && pictured(each) ? image(shadingPicture(each)) : ""));
    out += "</table>\n<h3>Materials of cast pictures</h3>\n<table>\n";
    for (const raycast::MaterialRow& each : raycast::materialTable())
        out += row(bold(each.label) + "<br>" + code(each.id),
                   escapedMarkup(each.tip) + (pictures ? image(materialPicture(each)) : ""));
    out += "</table>\n<h3>Effects</h3>\n<table>\n";
    for (const render::EffectRow& each : render::effectRows)
        out += row(bold(each.label) + "<br>" + code(each.id), escapedMarkup(each.tip));
    return out + "</table>\n";
}

std::string commands() {
    std::string out =
        "<p>One JSON object a line, as the journal writes them: <code>{\"op\":\"undo\"}</code>. Lines that "
        "begin with # are comments, and relative paths start in the session's folder. <code>pointclay run "
        "FILE</code> executes them without a window.</p>\n<p>" +
        escapedMarkup(hiddenHelp()) + "</p>\n";
    for (const session::CommandRow& each : session::commandTable()) {
        out += "<h3>" + code(each.op) + "</h3>\n<p>" + escapedMarkup(each.tip) + "</p>\n";
        if (each.parameters.empty())
            continue;
        out += "<table>\n";
        for (const session::CommandParameter& p : each.parameters)
            out += row(code(p.id), escapedMarkup(p.tip) + " (" + escapedMarkup(detailsOf(p)) + ")");
        out += "</table>\n";
    }
    return out;
}

std::string subcommands() {
    std::string out;
    forSubcommands([&](const SubcommandRow& each, const CLI::App& command) {
        out += "<h3>" + code(std::string("pointclay ") + each.name) + "</h3>\n<p>" + escapedMarkup(each.tip) +
               ". Example: " + code(each.example) + "</p>\n<table>\n";
        for (const CLI::Option* option : optionsOf(command))
            out += row(code(option->get_name(true, true)), escapedMarkup(option->get_description()));
        out += "</table>\n";
    });
    return out;
}

std::string formats() {
    std::string out = "<table>\n";
    for (const io::FormatRow& each : io::formatTable())
        out += row(bold(each.label) + "<br>" + code(each.extensions), each.read && each.write ? "read and written"
                                                                      : each.read             ? "read"
                                                                                              : "written");
    return out + "</table>\n";
}

} // namespace

std::vector<ManualPage> manual(bool pictures) {
    struct Chapter {
        const char *file, *title;
        std::string text;
    };
    const Chapter chapters[] = {
        {"manual.html", "First steps", firstSteps},
        {"manual-keys.html", "Mouse and keys", gestures()},
        {"manual-tools.html", "Tools", tools()},
        {"manual-looks.html", "Looks", looks(pictures)},
        {"manual-formats.html", "Formats", formats()},
        {"manual-commands.html", "Commands of sessions", commands()},
        {"manual-command-line.html", "Command line", subcommands()},
    };
    std::string contents = "<p>";
    for (const Chapter& each : chapters)
        contents += (&each == chapters ? "" : " &middot; ") + std::string("<a href=\"") + each.file + "\">" +
                    each.title + "</a>";
    contents += "</p>\n<hr>\n";
    std::vector<ManualPage> out;
    for (const Chapter& each : chapters)
        out.push_back({each.file, "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                                      std::string(each.title) +
                                      " - Pointclay " POINTCLAY_VERSION "</title>\n<style>\n" + style +
                                      "</style></head><body>\n" + contents + "<h2>" + each.title + "</h2>\n" +
                                      each.text + "</body></html>\n"});
    return out;
}

std::vector<ManualPicture> manualPictures() {
    const std::vector<std::string> common = {"--size", "480x360", "--quiet"};
    std::vector<ManualPicture> out;
    const auto add = [&](const std::string& file, std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), common.begin(), common.end());
        out.push_back({file, std::move(arguments)});
    };
    for (const render::ShadingRow& each : render::shadingTable())
        if (pictured(each))
            add(shadingPicture(each), {"render", "sample:knot", "--shading", each.id});
    for (const raycast::MaterialRow& each : raycast::materialTable())
        add(materialPicture(each),
            {"render", "sample:knot", "--mode", "raycast", "--quality", "1", "--material", each.id});
    return out;
}

} // namespace app
