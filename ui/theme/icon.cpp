#include "ui/theme/icon.h"

#include <QFile>
#include <QPainter>
#include <QSvgRenderer>

// Resources of a static library need a hand: the macro must stand outside every namespace.
static void loadIcons() {
    Q_INIT_RESOURCE(icons);
}

namespace ui {

static QPixmap drawn(QSvgRenderer& drawing, int size, double opacity) {
    QPixmap out(size, size);
    out.fill(Qt::transparent);
    QPainter painter(&out);
    painter.setOpacity(opacity);
    drawing.render(&painter, QRectF(0, 0, size, size));
    return out;
}

QIcon icon(std::string_view name) {
    loadIcons();
    const QString path = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    const QString file = path.endsWith(".svg") ? ":/" + path : QString(":/icons/%1.svg").arg(path);
    QIcon out;
    if (!QFile::exists(file))
        return out;
    QSvgRenderer drawing(file);
    for (const int size : {16, 20, 24, 32, 48, 64}) {
        out.addPixmap(drawn(drawing, size, 1), QIcon::Normal);
        out.addPixmap(drawn(drawing, size, 0.35), QIcon::Disabled);
    }
    return out;
}

} // namespace ui
