#include "ui/window/parameter_words.h"

#include <QObject>
#include <utility>

namespace ui {

static QString plain(std::string_view id) {
    QString out = QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size())).replace('-', ' ');
    if (!out.isEmpty())
        out[0] = out[0].toUpper();
    return out;
}

template <std::size_t N>
static QString wordsOf(const std::pair<std::string_view, const char*> (&words)[N], std::string_view id) {
    for (const auto& [each, text] : words)
        if (each == id)
            return QObject::tr(text);
    return plain(id);
}

QString parameterWords(std::string_view id) {
    static const std::pair<std::string_view, const char*> words[] = {
        {"apss-beta", "Fit spheres rather than planes (APSS)"},
        {"axis", "Upwards"},
        {"boundary", "Ends of open surfaces"},
        {"coarsest", "Longest distance"},
        {"count", "Number of points"},
        {"curvature-spacings", "Smallest support for curvature"},
        {"denoise", "Noise to take out"},
        {"error", "Distance allowed"},
        {"finest", "Shortest distance"},
        {"frame", "Normals from"},
        {"interpolating", "Through the points"},
        {"limit", "Limit of outliers"},
        {"manifold", "The points sample"},
        {"neighbours", "Neighbours in a support"},
        {"one-sheet", "Keep near sheets apart"},
        {"ratio", "Part to keep"},
        {"rimls-sigma", "Edge tolerance (RIMLS)"},
        {"shrink-free", "Without shrinking"},
        {"sigma", "Noise to take out"},
        {"support", "Support radius"},
        {"thin", "Thin to distance"},
        {"tolerance", "Follow the curvature within"},
        {"viewpoint", "Scanner at x, y, z"},
        {"way", "How"},
        {"weight", "Weights"},
    };
    return wordsOf(words, id);
}

QString choiceWords(std::string_view id) {
    static const std::pair<std::string_view, const char*> words[] = {
        {"apss", "Sphere fits (APSS)"},
        {"auto", "Automatic"},
        {"grid", "Rows and columns of a range scan"},
        {"jet", "Curved fits"},
        {"rimls", "Edge-preserving (RIMLS)"},
        {"wls", "Weighted planes (WLS)"},
        {"x", "x"},
        {"y", "y"},
        {"z", "z"},
    };
    return wordsOf(words, id);
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
