#include "ui/settings.h"

#include <algorithm>
#include <QSettings>
#include <QStringList>

namespace ui {

static const sculpt::ToolRow* findTool(const std::string& id) {
    for (const auto& row : sculpt::toolTable())
        if (id == row.id)
            return &row;
    return nullptr;
}

const sculpt::ToolRow& Settings::toolRow() const {
    const auto* row = findTool(tool);
    return row ? *row : sculpt::toolTable().front();
}

ToolChoice Settings::choice(const sculpt::ToolRow& row) const {
    ToolChoice out{row.strength, {}};
    const auto found = tools.find(row.id);
    if (found != tools.end())
        out.strength = found->second.strength;
    for (const auto& p : row.parameters) {
        out.parameters[p.id] = p.fallback;
        if (found != tools.end() && found->second.parameters.contains(p.id))
            out.parameters[p.id] = found->second.parameters.at(p.id);
    }
    return out;
}

void Settings::remember(const std::string& file) {
    std::erase(recentFiles, file);
    recentFiles.insert(recentFiles.begin(), file);
    if (recentFiles.size() > recentLimit)
        recentFiles.resize(recentLimit);
}

sculpt::StrokeSettings strokeSettings(const Settings& settings, const sculpt::ToolRow& row, float radius, bool flip) {
    const ToolChoice choice = settings.choice(row);
    sculpt::StrokeSettings out;
    out.tool = row.id;
    out.radius = radius;
    out.strength = static_cast<float>(choice.strength);
    out.invert = settings.invert != flip;
    out.falloff = settings.falloff;
    out.symmetry = settings.symmetry;
    out.resample = settings.resample;
    out.spacing = static_cast<float>(settings.spacing);
    out.parameters = choice.parameters;
    return out;
}

// --- reading: each value is taken only where it is a finite number in its range ---

static void readNumber(const QSettings& store, const QString& key, double min, double max, double& value) {
    bool ok = false;
    const double number = store.value(key).toDouble(&ok);
    if (ok && number >= min && number <= max)
        value = number;
}

static void readTools(const QSettings& store, Settings& out) {
    for (const auto& row : sculpt::toolTable()) {
        const QString group = QString("tools/%1/").arg(row.id);
        ToolChoice choice = out.choice(row);
        const ToolChoice fallback = choice;
        readNumber(store, group + "strength", 0, 1, choice.strength);
        for (const auto& p : row.parameters)
            readNumber(store, group + "parameters/" + p.id, p.min, p.max, choice.parameters[p.id]);
        if (choice != fallback)
            out.tools[row.id] = choice;
    }
}

static void readTableRows(const QSettings& store, Settings& out) {
    const std::string falloff = store.value("brush/falloff").toString().toStdString();
    for (const auto& row : sculpt::falloffTable())
        if (falloff == row.id)
            out.falloff = row.falloff;
    const std::string shading = store.value("view/shading").toString().toStdString();
    for (const auto& row : render::shadingTable())
        if (shading == row.id)
            out.shading = row.shading;
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
    readNumber(store, "brush/spacing", Settings::minSpacing, Settings::maxSpacing, out.spacing);
    const QString symmetry = store.value("brush/symmetry").toString();
    out.symmetry = {symmetry.contains('x'), symmetry.contains('y'), symmetry.contains('z')};
    out.invert = store.value("brush/invert", out.invert).toBool();
    out.resample = store.value("brush/resample", out.resample).toBool();
    for (const QString& file : store.value("files/recent").toStringList())
        if (out.recentFiles.size() < Settings::recentLimit)
            out.recentFiles.push_back(file.toStdString());
    out.geometry = store.value("window/geometry").toByteArray();
    out.windowState = store.value("window/state").toByteArray();
    return out;
}

static void writeTools(const Settings& settings, QSettings& store) {
    store.remove("tools");
    for (const auto& [id, choice] : settings.tools) {
        const QString group = QString("tools/%1/").arg(QString::fromStdString(id));
        store.setValue(group + "strength", choice.strength);
        for (const auto& [name, value] : choice.parameters)
            store.setValue(group + "parameters/" + QString::fromStdString(name), value);
    }
}

void writeSettings(const Settings& settings, QSettings& store) {
    store.setValue("brush/tool", QString::fromStdString(settings.tool));
    store.setValue("brush/shiftTool", QString::fromStdString(settings.shiftTool));
    store.setValue("brush/radiusUnit", settings.radiusUnit == RadiusUnit::Model ? "model" : "pixels");
    store.setValue("brush/radiusPx", settings.radiusPx);
    store.setValue("brush/radiusModel", settings.radiusModel);
    store.setValue("brush/falloff", sculpt::row(settings.falloff).id);
    store.setValue("brush/spacing", settings.spacing);
    const auto& s = settings.symmetry;
    store.setValue("brush/symmetry", QString(s.x ? "x" : "") + (s.y ? "y" : "") + (s.z ? "z" : ""));
    store.setValue("brush/invert", settings.invert);
    store.setValue("brush/resample", settings.resample);
    writeTools(settings, store);
    for (const auto& row : render::shadingTable())
        if (row.shading == settings.shading)
            store.setValue("view/shading", row.id);
    QStringList recent;
    for (const auto& file : settings.recentFiles)
        recent << QString::fromStdString(file);
    store.setValue("files/recent", recent);
    store.setValue("window/geometry", settings.geometry);
    store.setValue("window/state", settings.windowState);
}

} // namespace ui
