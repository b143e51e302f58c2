#include "ui/panels/stamp_field.h"

#include "core/base/error.h"
#include "core/io/pictures/grey_image.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

constexpr int side = 64;

/// As the brush sees it: grey, its longer side from edge to edge.
static QPixmap pictureOf(const io::GreyImage& image) {
    QImage grey(image.width, image.height, QImage::Format_Grayscale8);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            grey.scanLine(y)[x] =
                static_cast<uchar>(255 * image.values[std::size_t(y) * std::size_t(image.width) + std::size_t(x)]);
    return QPixmap::fromImage(grey.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

StampField::StampField(QWidget* parent)
    : QWidget(parent), m_picture(new QLabel), m_name(new QLabel), m_clear(new QToolButton) {
    m_picture->setObjectName("stamp-picture");
    m_picture->setFixedSize(side + 2, side + 2);
    m_picture->setAlignment(Qt::AlignCenter);
    m_name->setObjectName("faint");
    m_name->setWordWrap(true);
    m_name->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* chooser = new QToolButton;
    chooser->setObjectName("plain");
    chooser->setText(tr("Choose…"));
    chooser->setToolTip(tr("Choose a PNG or JPEG image to press in: white has full effect, black none."));
    m_clear->setObjectName("plain");
    m_clear->setText(tr("Clear"));
    m_clear->setToolTip(tr("Remove the stamp."));
    for (QToolButton* button : {chooser, m_clear})
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    buttons->addWidget(chooser);
    buttons->addWidget(m_clear);
    auto* right = new QVBoxLayout;
    right->setSpacing(4);
    right->addWidget(m_name, 1);
    right->addLayout(buttons);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_picture);
    layout->addLayout(right, 1);
    connect(chooser, &QToolButton::clicked, this, &StampField::ask);
    connect(m_clear, &QToolButton::clicked, this, [this] {
        setPath({});
        Q_EMIT edited();
    });
    show({});
}

bool StampField::show(const std::string& path) {
    m_picture->setPixmap({});
    m_clear->setEnabled(!path.empty());
    m_name->setText(tr("None"));
    m_name->setToolTip(QString::fromStdString(path));
    if (path.empty())
        return true;
    try {
        const io::GreyImage image = io::readGreyImage(path);
        m_picture->setPixmap(pictureOf(image));
        m_name->setText(tr("%1\n%2 × %3")
                            .arg(QFileInfo(QString::fromStdString(path)).fileName())
                            .arg(image.width)
                            .arg(image.height));
        return true;
    } catch (const base::Error& error) {
        m_name->setText(tr("Not readable: %1").arg(QFileInfo(QString::fromStdString(path)).fileName()));
        m_name->setToolTip(QString::fromUtf8(error.what()));
        return false;
    }
}

void StampField::setPath(const std::string& path) {
    if (path == m_path)
        return;
    m_path = path;
    show(path);
}

void StampField::choose(const QString& path) {
    const std::string chosen = path.toStdString();
    if (!show(chosen))
        return;
    m_path = chosen;
    Q_EMIT edited();
}

void StampField::ask() {
    const QString folder = m_path.empty() ? QString() : QFileInfo(QString::fromStdString(m_path)).path();
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Stamp"), folder, tr("Images (*.png *.jpg *.jpeg);;All files (*)"));
    if (!path.isEmpty())
        choose(path);
}

} // namespace ui
