#include "ui/window/image_dialog.h"

#include <algorithm>
#include <cmath>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

namespace ui {

static QSpinBox* pixels(const char* name, int value) {
    auto* out = new QSpinBox;
    out->setObjectName(name);
    out->setRange(1, ImageDialog::largest);
    out->setSuffix(QObject::tr(" px"));
    out->setValue(value);
    return out;
}

static QCheckBox* box(const QString& text, const char* name, bool on, const QString& tip = {}) {
    auto* out = new QCheckBox(text);
    out->setObjectName(name);
    out->setChecked(on);
    out->setToolTip(tip);
    return out;
}

ImageDialog::ImageDialog(const ImageChoice& choice, QSize view, QWidget* parent) : QDialog(parent), m_view(view) {
    setWindowTitle(tr("Export Image"));
    m_width = pixels("width", choice.size.width());
    m_height = pixels("height", choice.size.height());
    const bool shaped =
        std::abs(double(choice.size.width()) * view.height() / (double(choice.size.height()) * view.width()) - 1) <
        0.01;
    m_keepShape = box(tr("Same &shape as the view"), "keep-shape", shaped);
    m_transparent = box(tr("&Transparent background"), "transparent", choice.transparent);
    m_smooth = box(tr("Smooth &outlines"), "smooth", choice.smooth, tr("Antialiasing: draws four pixels for each"));
    m_how = new QComboBox;
    m_how->setObjectName("how");
    m_how->addItem(tr("Splats, as in the window"));
    m_how->addItem(tr("The true surface, ray by ray"));
    m_how->setCurrentIndex(choice.rayCast ? 1 : 0);
    connect(m_width, &QSpinBox::valueChanged, this, &ImageDialog::widthEdited);
    connect(m_height, &QSpinBox::valueChanged, this, &ImageDialog::heightEdited);
    connect(m_keepShape, &QCheckBox::toggled, this, [this] { widthEdited(m_width->value()); });

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Export…"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Width"), m_width);
    form->addRow(tr("&Height"), m_height);
    form->addRow(QString(), m_keepShape);
    form->addRow(tr("&Draw"), m_how);
    form->addRow(QString(), m_smooth);
    form->addRow(QString(), m_transparent);
    form->addRow(buttons);
}

static int scaled(int value, int by, int to) {
    return std::clamp(static_cast<int>(std::lround(double(value) * to / by)), 1, ImageDialog::largest);
}

void ImageDialog::widthEdited(int width) {
    if (!m_keepShape->isChecked())
        return;
    const QSignalBlocker quiet(m_height);
    m_height->setValue(scaled(width, m_view.width(), m_view.height()));
}

void ImageDialog::heightEdited(int height) {
    if (!m_keepShape->isChecked())
        return;
    const QSignalBlocker quiet(m_width);
    m_width->setValue(scaled(height, m_view.height(), m_view.width()));
}

ImageChoice ImageDialog::choice() const {
    return {{m_width->value(), m_height->value()},
            m_transparent->isChecked(),
            m_smooth->isChecked(),
            m_how->currentIndex() == 1};
}

} // namespace ui
