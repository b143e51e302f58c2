#include "ui/window/parameter_words.h"

#include "ui/words/counted.h"
#include "ui/words/words.h"

#include <QObject>
#include <span>
#include <string>
#include <utility>

namespace ui {

static QString plain(std::string_view id) {
    QString out = QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()));
    for (qsizetype i = 1; i < out.size(); ++i) // a first one is the sign of an axis
        if (out[i] == '-' || out[i] == '_')
            out[i] = ' ';
    if (!out.isEmpty())
        out[0] = out[0].toUpper();
    return out;
}

using Words = std::pair<std::string_view, const char*>;

static const char* find(std::span<const Words> words, std::string_view id) {
    for (const auto& [each, text] : words)
        if (each == id)
            return text;
    return nullptr;
}

/// What means something else in one command than in others.
static constexpr Words ofCommands[] = {
    {"blend.by", QT_TR_NOOP("Scans told apart by")},
    {"blend.fade", QT_TR_NOOP("Points to fade out over")},
    {"crease.along", QT_TR_NOOP("Line through places")},
    {"drill.from", QT_TR_NOOP("Begins at")},
    {"levels.balance", QT_TR_NOOP("White balance")},
    {"levels.grey", QT_TR_NOOP("Place that is grey")},
    {"measure.to", QT_TR_NOOP("File of the other model")},
    {"mixed.limit", QT_TR_NOOP("Least step in depth")},
    {"open.path", QT_TR_NOOP("File")},
    {"register.to", QT_TR_NOOP("File to move onto")},
    {"scene.by", QT_TR_NOOP("Split by")},
    {"select.of", QT_TR_NOOP("Number asked for")},
    {"select.keep", QT_TR_NOOP("Part to keep")},
    {"shapes.fewest", QT_TR_NOOP("Points of a shape, at least")},
    {"shapes.kinds", QT_TR_NOOP("Shapes to look for")},
    {"shapes.tolerance", QT_TR_NOOP("Distance from a shape")},
    {"tube.along", QT_TR_NOOP("Way through places")},
    {"unit.from", QT_TR_NOOP("One place")},
    {"unit.length", QT_TR_NOOP("Known distance")},
    {"unit.to", QT_TR_NOOP("Another place")},
    {"up.axis", QT_TR_NOOP("Upwards")},
};

static constexpr Words ofAll[] = {
    {"about", QT_TR_NOOP("Place that stays")},
    {"apss-beta", QT_TR_NOOP("Fit spheres rather than planes (APSS)")},
    {"at", QT_TR_NOOP("Place")},
    {"axis", QT_TR_NOOP("Turn about the axis")},
    {"boundary", QT_TR_NOOP("Ends of open surfaces")},
    {"by", QT_TR_NOOP("Choose by")},
    {"cap", QT_TR_NOOP("Close the cut")},
    {"coarsest", QT_TR_NOOP("Longest distance")},
    {"columns", QT_TR_NOOP("Columns of a text")},
    {"count", QT_TR_NOOP("Number of points")},
    {"creases", QT_TR_NOOP("Sharp seams")},
    {"curvature-spacings", QT_TR_NOOP("Smallest support for curvature")},
    {"denoise", QT_TR_NOOP("Noise to take out")},
    {"detect", QT_TR_NOOP("Find them in the points")},
    {"do", QT_TR_NOOP("What to do")},
    {"error", QT_TR_NOOP("Distance allowed")},
    {"finest", QT_TR_NOOP("Shortest distance")},
    {"fit", QT_TR_NOOP("Keep the surface where it is")},
    {"frame", QT_TR_NOOP("Normals from")},
    {"global", QT_TR_NOOP("Look for their places everywhere")},
    {"interpolating", QT_TR_NOOP("Through the points")},
    {"join", QT_TR_NOOP("Add the other model's points")},
    {"keep", QT_TR_NOOP("Side to keep")},
    {"least", QT_TR_NOOP("Lower corner")},
    {"limit", QT_TR_NOOP("Limit of outliers")},
    {"longest", QT_TR_NOOP("Longest loop")},
    {"manifold", QT_TR_NOOP("The points sample")},
    {"mixed", QT_TR_NOOP("Mixed pixels at edges in depth")},
    {"model", QT_TR_NOOP("Other model of the scene")},
    {"most", QT_TR_NOOP("Upper corner")},
    {"move", QT_TR_NOOP("Move by")},
    {"moving", QT_TR_NOOP("Files of models to move")},
    {"neighbours", QT_TR_NOOP("Neighbours in a support")},
    {"of", QT_TR_NOOP("Applied to")},
    {"one-sheet", QT_TR_NOOP("Keep near sheets apart")},
    {"path", QT_TR_NOOP("File of the other model")},
    {"ratio", QT_TR_NOOP("Part to keep")},
    {"rimls-sigma", QT_TR_NOOP("Edge tolerance (RIMLS)")},
    {"sample", QT_TR_NOOP("Sample")},
    {"scene", QT_TR_NOOP("All other models of the scene")},
    {"seams", QT_TR_NOOP("Trace the seams")},
    {"shrink-free", QT_TR_NOOP("Without shrinking")},
    {"sigma", QT_TR_NOOP("Noise to take out")},
    {"stretch", QT_TR_NOOP("Stretch along x, y, z")},
    {"support", QT_TR_NOOP("Support radius")},
    {"thin", QT_TR_NOOP("Thin to distance")},
    {"thin_to", QT_TR_NOOP("Thin to distance")},
    {"tolerance", QT_TR_NOOP("Follow the curvature within")},
    {"unit_scale", QT_TR_NOOP("Scale of its unit")},
    {"up_axis", QT_TR_NOOP("Upwards")},
    {"up_to", QT_TR_NOOP("Longest hole")},
    {"viewpoint", QT_TR_NOOP("Scanner at x, y, z")},
    {"visible", QT_TR_NOOP("Only what is seen")},
    {"way", QT_TR_NOOP("How")},
    {"weight", QT_TR_NOOP("Weights")},
};

QString parameterWords(std::string_view op, std::string_view id) {
    if (const char* own = find(ofCommands, std::string(op) + '.' + std::string(id)))
        return QObject::tr(own);
    const char* shared = find(ofAll, id);
    return shared ? QObject::tr(shared) : spoken(plain(id).toStdString(), "parameter");
}

QString choiceWords(std::string_view id) {
    static constexpr Words words[] = {
        {"apss", QT_TR_NOOP("Sphere fits (APSS)")},
        {"auto", QT_TR_NOOP("Automatic")},
        {"grid", QT_TR_NOOP("Rows and columns of a range scan")},
        {"jet", QT_TR_NOOP("Curved fits")},
        {"rimls", QT_TR_NOOP("Edge-preserving (RIMLS)")},
        {"wls", QT_TR_NOOP("Weighted planes (WLS)")},
        {"x", "x"},
        {"y", "y"},
        {"z", "z"},
    };
    const char* text = find(words, id);
    return spoken(text ? std::string(text) : plain(id).toStdString(), "choice");
}

QString rangeWords(double min, double max) {
    constexpr double endless = 1e9; // as good as no limit at all
    constexpr double large = 1e5;   // told with its digits, not as 2e+08
    if (max <= min || max >= endless)
        return {};
    const QString low = min < 1e-30 ? QString(min < 0 ? "" : "0") : QString::number(min);
    return QObject::tr(" (%1 to %2)")
        .arg(low, max < large ? QString::number(max) : counted(static_cast<qulonglong>(max)));
}

QString withMnemonic(const QString& label, QString& taken) {
    for (qsizetype i = 0; i < label.size(); ++i) {
        const QChar letter = label[i].toLower();
        if (letter.isLetter() && !taken.contains(letter)) {
            taken += letter;
            return QString(label).insert(i, '&');
        }
    }
    return label;
}

} // namespace ui
