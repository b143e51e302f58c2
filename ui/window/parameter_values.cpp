#include "ui/window/parameter_values.h"

#include "core/base/error.h"
#include "core/base/up_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <QRegularExpression>
#include <QStringList>

namespace ui {

using nlohmann::json;
using session::CommandParameter;

bool isOptional(const CommandParameter& p) {
    return std::string_view(p.fallback) == "null";
}

QString fallbackOf(const CommandParameter& p) {
    QString text = QString(p.fallback).remove('"');
    if (std::string_view(p.type) == "choices") // "plane, sphere"
        text.remove(QRegularExpression("[\\[\\]]")).replace(",", ", ");
    return text == "null" ? QString() : text;
}

static bool hasThreeNumbers(const CommandParameter& p) {
    return (std::string_view(p.type) == "list" || std::string_view(p.type) == "text") &&
           std::string_view(p.tip).find("x,y,z") != std::string_view::npos;
}

bool isPlace(const CommandParameter& p) {
    constexpr std::array<std::string_view, 10> ids{"at",   "about",     "from",      "to",    "position",
                                                   "grey", "viewpoint", "direction", "least", "most"};
    return hasThreeNumbers(p) && std::ranges::find(ids, p.id) != ids.end();
}

bool isPlaces(const CommandParameter& p) {
    return hasThreeNumbers(p) && std::string_view(p.tip).starts_with("[[");
}

bool isDirection(const CommandParameter& p) {
    return std::string_view(p.id) == "direction";
}

bool isFile(const CommandParameter& p) {
    return std::string_view(p.type) == "path" || std::string_view(p.type) == "paths";
}

/// Without zeros that say nothing.
static QString shortText(double value, int decimals) {
    QString out = QString::number(value, 'f', decimals);
    while (out.contains('.') && (out.endsWith('0') || out.endsWith('.')))
        out.chop(1);
    return out == "-0" ? "0" : out;
}

QString textOf(const base::Vec3d& place, double size) {
    constexpr int digits = 5, most = 15;
    const int decimals =
        size > 0 ? std::clamp(digits - static_cast<int>(std::floor(std::log10(size))), 0, most) : digits;
    return QString("%1, %2, %3")
        .arg(shortText(place.x, decimals), shortText(place.y, decimals), shortText(place.z, decimals));
}

static json numbersOf(const CommandParameter& p, const QString& text) {
    json out = json::array();
    for (const QString& part : text.split(',', Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const double number = part.trimmed().toDouble(&isNumber);
        if (!isNumber)
            throw base::Error("\"" + part.trimmed().toStdString() + "\" is no number", p.id, "give x, y, z");
        out.push_back(number);
    }
    return out;
}

json valueOf(const CommandParameter& p, const QString& text) {
    const std::string_view type = p.type;
    if (type == "list") {
        if (!isPlaces(p) && !text.contains(';'))
            return numbersOf(p, text);
        json out = json::array();
        for (const QString& row : text.split(';', Qt::SkipEmptyParts))
            out.push_back(numbersOf(p, row));
        return out;
    }
    if (type == "text" || type == "path" || type == "paths") // "2" is a name, too
        return json(text.toStdString());
    if (type == "choices" && text.contains(',')) {
        json out = json::array();
        for (const QString& each : text.split(',', Qt::SkipEmptyParts))
            out.push_back(each.trimmed().toStdString());
        return out;
    }
    bool isWhole = false, isNumber = false;
    const long long whole = text.toLongLong(&isWhole);
    const double number = text.toDouble(&isNumber);
    return isWhole ? json(whole) : isNumber ? json(number) : json(text.toStdString());
}

/// One digit of it.
static double rounded(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)));
    return std::max(std::floor(value / unit), 1.0) * unit;
}

static QString planeText(const base::Plane& plane) {
    return textOf(plane.normal).remove(' ') + QString(",%1").arg(plane.offset, 0, 'g', 8);
}

/// Across x where both sides are to be alike, else level.
static base::Plane middlePlane(const session::CommandRow& row, const Snapshot& model) {
    const bool mirror = row.op == std::string_view("mirror");
    const base::Vec3d normal = mirror ? base::Vec3d{1, 0, 0} : base::cast<double>(base::upRow(model.up).up);
    const base::Vec3d middle = base::cast<double>(model.surface.tree().bounds().centre()) + model.origin;
    return {normal, dot(normal, middle)};
}

QString proposalFor(const session::CommandRow& row, const CommandParameter& p, const Snapshot& model,
                    const std::optional<base::Plane>& plane) {
    const std::string_view id = p.id, type = p.type;
    if (row.op == std::string_view("reduce") && id == "ratio") // one of three, and the one that suits any model
        return "0.1";
    const auto size = static_cast<double>(model.surface.tree().bounds().diagonal());
    if (isOptional(p) || *p.fallback || model.surface.tree().empty() || !(size > 0))
        return {};
    if (id == "plane" && type == "text")
        return planeText(plane.value_or(middlePlane(row, model)));
    if (std::string_view(p.unit) != "model units")
        return {};
    if (id == "size" && type == "text")
        return QString::number(rounded(size / 10), 'g', 3);
    if (type != "number")
        return {};
    const double part = id == "amplitude" ? 200 : id == "length" ? 100 : id == "thickness" ? 50 : 20;
    return QString::number(rounded(size / part), 'g', 3);
}

} // namespace ui
