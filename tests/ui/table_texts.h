// Every text of the tables that a person sees in the window, with the table that it means something else in.
#pragma once

#include "core/haptics/device.h"
#include "core/io/formats.h"
#include "core/io/mesh_formats.h"
#include "core/process/samples/samples.h"
#include "core/raycast/light_rigs.h"
#include "core/raycast/material_table.h"
#include "core/render/effects/effect_rows.h"
#include "core/render/named_views.h"
#include "core/render/overlay/annotations.h"
#include "core/render/shading/backdrop.h"
#include "core/render/shading/shading_table.h"
#include "core/sculpt/stroke/stroke_options.h"
#include "core/sculpt/tool.h"
#include "core/session/command.h"
#include "ui/interaction/select_ways.h"
#include "ui/theme/theme.h"
#include "ui/view/gesture_table.h"
#include "ui/view/navigation.h"
#include "ui/window/command_dialog.h"
#include "ui/window/parameter_words.h"
#include "ui/words/language.h"
#include "ui/work/ruler_table.h"

#include <QStringList>
#include <set>
#include <string>

namespace test {

/// Table, text.
using Texts = std::set<std::pair<std::string, std::string>>;

inline std::string asWords(std::string id) {
    for (std::size_t i = 1; i < id.size(); ++i)
        id[i] = id[i] == '-' || id[i] == '_' ? ' ' : id[i];
    if (!id.empty())
        id[0] = static_cast<char>(std::toupper(id[0]));
    return id;
}

template <class Row>
void addRow(Texts& out, const Row& row, const char* table = "") {
    out.insert({table, row.label});
    if constexpr (requires { row.tip; })
        out.insert({"", row.tip});
}

template <class Rows>
void addRows(Texts& out, const Rows& rows, const char* table = "") {
    for (const auto& row : rows)
        addRow(out, row, table);
}

inline void addCommands(Texts& out) {
    for (const session::CommandRow& row : session::commandTable()) {
        if (!ui::hasDialog(row) && !row.startsModel)
            continue;
        addRow(out, row);
        for (const session::CommandParameter& each : row.parameters) {
            if (each.recorded)
                continue;
            out.insert({"parameter", ui::parameterWords(row.op, each.id).toStdString()});
            out.insert({"", each.tip});
            out.insert({"", each.unit});
            for (const QString& choice : QString(each.choices).split(' ', Qt::SkipEmptyParts))
                out.insert({"choice", asWords(choice.toStdString())});
        }
    }
}

inline void addStrokes(Texts& out) {
    addRows(out, sculpt::toolTable(), "tool");
    addRows(out, sculpt::toolTable(), "step"); // of the history
    for (const sculpt::ToolRow& tool : sculpt::toolTable())
        for (const sculpt::ToolParameter& each : tool.parameters) {
            addRow(out, each);
            out.insert({"", each.unit});
        }
    for (const sculpt::StrokeOption& each : sculpt::strokeOptionTable()) {
        addRow(out, each);
        out.insert({"", each.gesture});
        out.insert({"", std::string_view(each.unit) == "degrees" ? "°" : each.unit});
    }
    addRows(out, sculpt::optionGroupTable());
    addRows(out, sculpt::methodTable(), "option");
    addRows(out, sculpt::falloffTable(), "falloff");
    addRows(out, sculpt::axisTable(), "option");
    addRows(out, sculpt::upAxisTable(), "option");
}

inline void addPictures(Texts& out) {
    addRows(out, render::shadingTable());
    for (const auto& row : render::shadingTable()) {
        out.insert({"", row.group});
        if (row.measure)
            out.insert({"legend", row.measure->title});
    }
    addRows(out, render::backdropTable());
    addRows(out, render::effectTable());
    addRows(out, render::annotationTable());
    addRows(out, render::namedViews(), "view");
    addRows(out, raycast::materialTable());
    addRows(out, raycast::lightRigTable());
}

inline Texts tableTexts() {
    Texts out;
    addCommands(out);
    addStrokes(out);
    addPictures(out);
    addRows(out, process::sampleTable());
    addRows(out, haptics::deviceTable());
    addRows(out, io::formatTable());
    addRows(out, io::meshFormatTable());
    addRows(out, ui::selectWays());
    addRows(out, ui::rulerTable());
    addRows(out, ui::navigationTable());
    addRows(out, ui::themeTable());
    addRows(out, ui::languageTable());
    for (const ui::GestureRow& row : ui::gestureTable())
        out.insert({"", row.gesture}), out.insert({"", row.effect});
    std::erase_if(out, [](const auto& each) { return each.second.empty(); });
    return out;
}

} // namespace test
