#include "ui/settings/settings.h"

#include "ui/view/navigation.h"

#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/render/effects/effect_rows.h"
#include "core/session/option_json.h"

#include <algorithm>
#include <QSettings>
#include <QStringList>

namespace ui {

static const sculpt::ToolRow* findTool(const std::string& id) {
    return base::findRow(sculpt::toolTable(), id);
}

const sculpt::ToolRow& Settings::toolRow() const {
    const auto* row = findTool(tool);
    return row ? *row : sculpt::toolTable().front();
}

sculpt::StrokeSettings Settings::choice(const sculpt::ToolRow& row) const {
    const auto found = tools.find(row.id);
    sculpt::StrokeSettings out = found != tools.end() ? found->second : sculpt::defaultsOf(row);
    copyOptions(sculpt::Scope::AllTools, shared, out);
    return out;
}

sculpt::StrokeSettings& Settings::edit(const sculpt::ToolRow& row) {
    return tools.try_emplace(row.id, sculpt::defaultsOf(row)).first->second;
}

void Settings::remember(const std::string& file) {
    std::erase(recentFiles, file);
    recentFiles.insert(recentFiles.begin(), file);
    if (recentFiles.size() > recentLimit)
        recentFiles.resize(recentLimit);
}

sculpt::StrokeSettings strokeSettings(const Settings& settings, const sculpt::ToolRow& row, float radius, bool flip) {
    sculpt::StrokeSettings out = settings.choice(row);
    out.radius = radius;
    out.invert = out.invert != flip;
    return out;
}

render::RenderOptions lookOf(const Settings& settings) {
    render::RenderOptions out;
    out.shading = settings.shading;
    out.backdrop = settings.backdrop;
    out.effects = settings.effects;
    return out;
}

static render::Shading rowValue(const render::ShadingRow& row) {
    return row.shading;
}
static render::Backdrop rowValue(const render::BackdropRow& row) {
    return row.backdrop;
}
static raycast::Material rowValue(const raycast::MaterialRow& row) {
    return row.material;
}
static raycast::LightRig rowValue(const raycast::LightRigRow& row) {
    return row.rig;
}

// --- reading: each value is taken only where it is a finite number in its range ---

static void readNumber(const QSettings& store, const QString& key, double min, double max, double& value) {
    bool ok = false;
    const double number = store.value(key).toDouble(&ok);
    if (ok && number >= min && number <= max)
        value = number;
}

template <class Rows, class Value>
static void readRow(const QSettings& store, const QString& key, const Rows& rows, Value& value) {
    const std::string id = store.value(key).toString().toStdString();
    if (const auto* row = base::findRow(rows, id))
        value = rowValue(*row);
}

/// "outline,creases": the bits of the rows named; an unknown name has none.
template <class Rows, class Bit>
static void readSet(const QSettings& store, const QString& key, const Rows& rows, Bit bit, std::uint32_t& value) {
    if (!store.contains(key))
        return;
    const QStringList names = store.value(key).toString().split(',');
    value = 0;
    for (const auto& row : rows)
        value |= names.contains(QString(row.id)) ? static_cast<std::uint32_t>(row.*bit) : 0u;
}

template <class Rows, class Bit>
static QString storedSet(const Rows& rows, Bit bit, std::uint32_t value) {
    QStringList names;
    for (const auto& row : rows)
        if (value & row.*bit)
            names << row.id;
    return names.join(',');
}

/// The options of one scope, under their ids, in the encoding of session lines.
static void readOptions(const QSettings& store, sculpt::Scope scope, const QString& group,
                        sculpt::StrokeSettings& out) {
    for (const auto& option : sculpt::strokeOptionTable()) {
        if (option.scope != scope || !store.contains(group + option.id))
            continue;
        try {
            session::setText(option, store.value(group + option.id).toString().toStdString(), out);
        } catch (const base::Error&) { // it keeps its default
        }
    }
}

/// What differs from `fallback`.
static void addOptions(const sculpt::StrokeSettings& settings, const sculpt::StrokeSettings& fallback,
                       sculpt::Scope scope, const QString& group, Entries& out) {
    for (const auto& option : sculpt::strokeOptionTable()) {
        if (option.scope != scope)
            continue;
        const std::string text = session::textOf(option, settings);
        if (text != session::textOf(option, fallback))
            out[group + option.id] = QString::fromStdString(text);
    }
}

static void readTools(const QSettings& store, Settings& out) {
    for (const auto& row : sculpt::toolTable()) {
        const QString group = QString("tools/%1/").arg(row.id);
        const sculpt::StrokeSettings fallback = sculpt::defaultsOf(row);
        sculpt::StrokeSettings choice = fallback;
        readOptions(store, sculpt::Scope::Tool, group, choice);
        for (const auto& p : row.parameters)
            readNumber(store, group + "parameters/" + p.id, p.min, p.max, choice.parameters[p.id]);
        if (choice != fallback)
            out.tools[row.id] = choice;
    }
}

static void readTableRows(const QSettings& store, Settings& out) {
    readRow(store, "view/shading", render::shadingTable(), out.shading);
    out.attribute = store.value("view/attribute").toString().toStdString();
    readRow(store, "view/background", render::backdropTable(), out.backdrop);
    readSet(store, "view/effects", render::effectTable(), &render::EffectRow::effect, out.effects);
    readSet(store, "view/annotations", render::annotationTable(), &render::AnnotationRow::annotation, out.annotated);
    out.grid = store.value("view/grid", out.grid).toBool();
    out.edges = store.value("view/edges", out.edges).toBool();
    out.leftHanded = store.value("window/leftHanded", out.leftHanded).toBool();
    out.gizmo = store.value("view/gizmo", out.gizmo).toBool();
    out.previews = store.value("window/previews", out.previews).toBool();
    out.truth.on = store.value("view/trueSurface", out.truth.on).toBool();
    readNumber(store, "view/trueQuality", TruthSettings::minQuality, TruthSettings::maxQuality, out.truth.quality);
    raycast::Lighting& lighting = out.truth.lighting;
    readRow(store, "view/material", raycast::materialTable(), lighting.material);
    readRow(store, "view/lights", raycast::lightRigTable(), lighting.rig);
    lighting.shadows = store.value("view/shadows", lighting.shadows).toBool();
    lighting.occlusion = store.value("view/occlusion", lighting.occlusion).toBool();
    lighting.ground = store.value("view/shadowGround", lighting.ground).toBool();
    const std::string tool = store.value("brush/tool").toString().toStdString();
    if (findTool(tool))
        out.tool = tool;
    const std::string shiftTool = store.value("brush/shiftTool").toString().toStdString();
    if (findTool(shiftTool))
        out.shiftTool = shiftTool;
}

Settings readSettings(const QSettings& store) {
    Settings out;
    readTableRows(store, out);
    readTools(store, out);
    if (store.value("brush/radiusUnit").toString() == "model")
        out.radiusUnit = RadiusUnit::Model;
    readNumber(store, "brush/radiusPx", Settings::minRadiusPx, Settings::maxRadiusPx, out.radiusPx);
    readNumber(store, "brush/radiusModel", 1e-30, 1e30, out.radiusModel);
    readOptions(store, sculpt::Scope::AllTools, "brush/", out.shared);
    for (const QString& key : store.allKeys())
        if (key.startsWith("panel/"))
            out.groups[key.mid(6).toStdString()] = store.value(key).toBool();
    out.theme = store.value("window/theme", "dark").toString().toStdString();
    out.language = store.value("window/language", "system").toString().toStdString();
    out.historyMib = std::max(16, store.value("history/mib", 1024).toInt());
    out.navigation = navigation(store.value("view/navigation").toString().toStdString()).id;
    for (const QString& line : store.value("window/keys").toStringList())
        if (const qsizetype at = line.indexOf('\t'); at > 0)
            out.keys[line.left(at).toStdString()] = line.mid(at + 1).toStdString();
    for (const QString& text : store.value("view/saved").toStringList())
        if (const auto view = savedViewOf(text.toStdString()))
            keep(out.savedViews, *view);
    for (const QString& file : store.value("files/recent").toStringList())
        if (out.recentFiles.size() < Settings::recentLimit)
            out.recentFiles.push_back(file.toStdString());
    out.geometry = store.value("window/geometry").toByteArray();
    out.windowState = store.value("window/state").toByteArray();
    return out;
}

static void addTools(const Settings& settings, Entries& out) {
    for (const auto& [id, choice] : settings.tools) {
        const QString group = QString("tools/%1/").arg(QString::fromStdString(id));
        const sculpt::StrokeSettings fallback = sculpt::defaultsOf(sculpt::tool(id));
        addOptions(choice, fallback, sculpt::Scope::Tool, group, out);
        for (const auto& [name, value] : choice.parameters)
            if (value != fallback.parameters.at(name))
                out[group + "parameters/" + QString::fromStdString(name)] = value;
    }
}

Entries entriesOf(const Settings& settings) {
    Entries out;
    out["brush/tool"] = QString::fromStdString(settings.tool);
    out["brush/shiftTool"] = QString::fromStdString(settings.shiftTool);
    out["brush/radiusUnit"] = settings.radiusUnit == RadiusUnit::Model ? "model" : "pixels";
    out["brush/radiusPx"] = settings.radiusPx;
    out["brush/radiusModel"] = settings.radiusModel;
    addOptions(settings.shared, sculpt::StrokeSettings(), sculpt::Scope::AllTools, "brush/", out);
    for (const auto& [id, open] : settings.groups)
        out[QString("panel/") + QString::fromStdString(id)] = open;
    addTools(settings, out);
    out["view/shading"] = render::shadingRow(settings.shading).id;
    out["view/attribute"] = QString::fromStdString(settings.attribute);
    out["view/background"] = render::backdropRow(settings.backdrop).id;
    out["view/effects"] = storedSet(render::effectTable(), &render::EffectRow::effect, settings.effects);
    out["view/annotations"] =
        storedSet(render::annotationTable(), &render::AnnotationRow::annotation, settings.annotated);
    out["view/grid"] = settings.grid;
    out["view/edges"] = settings.edges;
    out["window/leftHanded"] = settings.leftHanded;
    out["view/gizmo"] = settings.gizmo;
    out["window/previews"] = settings.previews;
    out["view/trueSurface"] = settings.truth.on;
    out["view/trueQuality"] = settings.truth.quality;
    const raycast::Lighting& lighting = settings.truth.lighting;
    out["view/material"] = raycast::materialRow(lighting.material).id;
    out["view/lights"] = raycast::lightRigRow(lighting.rig).id;
    out["view/shadows"] = lighting.shadows;
    out["view/occlusion"] = lighting.occlusion;
    out["view/shadowGround"] = lighting.ground;
    out["window/theme"] = QString::fromStdString(settings.theme);
    out["window/language"] = QString::fromStdString(settings.language);
    out["history/mib"] = settings.historyMib;
    out["view/navigation"] = QString::fromStdString(settings.navigation);
    QStringList keys;
    for (const auto& [id, key] : settings.keys)
        keys << QString::fromStdString(id + '\t' + key);
    out["window/keys"] = keys;
    QStringList saved;
    for (const SavedView& view : settings.savedViews)
        saved << QString::fromStdString(textOf(view));
    out["view/saved"] = saved;
    QStringList recent;
    for (const auto& file : settings.recentFiles)
        recent << QString::fromStdString(file);
    out["files/recent"] = recent;
    out["window/geometry"] = settings.geometry;
    out["window/state"] = settings.windowState;
    return out;
}

} // namespace ui
