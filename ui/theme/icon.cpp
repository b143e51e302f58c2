#include "ui/theme/icon.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

// Resources of a static library need a hand: the macro must stand outside every namespace.
static void loadIcons() {
    Q_INIT_RESOURCE(icons);
}

namespace ui {

namespace {

/// What the drawings have for "the colour of text".
constexpr const char* drawnColour = "#d7dae0";

QColor& lineColour() {
    static QColor colour(drawnColour);
    return colour;
}

/// An SVG drawing whose lines have the theme's colour at the time it is painted.
class Drawing : public QIconEngine {
  public:
    explicit Drawing(QByteArray svg) : m_svg(std::move(svg)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        QByteArray svg = m_svg;
        svg.replace(drawnColour, lineColour().name().toLatin1());
        QSvgRenderer drawing(svg);
        const double size = std::min(rect.width(), rect.height());
        QRectF place(0, 0, size, size);
        place.moveCenter(QRectF(rect).center());
        painter->save();
        painter->setOpacity(painter->opacity() * (mode == QIcon::Disabled ? 0.35 : 1));
        drawing.render(painter, place);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap out(size);
        out.fill(Qt::transparent);
        QPainter painter(&out);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return out;
    }
    QIconEngine* clone() const override { return new Drawing(m_svg); }
    bool isNull() override { return m_svg.isEmpty(); }

  private:
    QByteArray m_svg;
};

} // namespace

void setIconColour(const QColor& colour) {
    lineColour() = colour;
}

QIcon icon(std::string_view name) {
    loadIcons();
    const QString path = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    QFile file(path.endsWith(".svg") ? ":/" + path : QString(":/icons/%1.svg").arg(path));
    return file.open(QIODevice::ReadOnly) ? QIcon(new Drawing(file.readAll())) : QIcon();
}

} // namespace ui
