#include "ui/panels/mesh_bar.h"

#include "ui/panels/elided_label.h"
#include "ui/panels/number_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>

namespace ui {

MeshBar::MeshBar(QWidget* parent) : QToolBar(tr("Mesh"), parent) {
    setObjectName("mesh");
    setMovable(false);
    addMethod();
    addCell();
    addWidget(box("mesh-folds", tr("Close folds"), tr("Fill small holes where thin parts leave the surface undefined"),
                  &MeshChoice::closeFolds));
    addWidget(box("mesh-small", tr("Drop small parts"), tr("Leave out parts of fewer than 200 triangles"),
                  &MeshChoice::dropSmall));
    addWidget(box("mesh-preview", tr("Preview"), tr("Draw the mesh over the picture"), &MeshChoice::preview));
    m_text = new ElidedLabel; // gives way, so that Export stays
    m_text->setObjectName("mesh-text");
    m_text->setIndent(10);
    m_text->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(m_text);
    auto* save = new QPushButton(tr("Export…"));
    save->setObjectName("mesh-export");
    save->setFocusPolicy(Qt::NoFocus);
    addWidget(save);
    connect(save, &QPushButton::clicked, this, &MeshBar::exportWanted);
}

void MeshBar::addMethod() {
    auto* method = new QComboBox;
    method->setObjectName("mesh-method");
    method->addItem(tr("Marching cubes"));
    method->addItem(tr("Delaunay"));
    method->setItemData(0, tr("Fast; triangles follow a grid"), Qt::ToolTipRole);
    method->setItemData(1, tr("Slower; every angle at least 25°"), Qt::ToolTipRole);
    method->setFocusPolicy(Qt::NoFocus);
    addWidget(method);
    connect(method, &QComboBox::currentIndexChanged, this,
            [this](int index) { change([index](MeshChoice& choice) { choice.delaunay = index == 1; }); });
}

void MeshBar::addCell() {
    NumberRange range;
    range.min = MeshChoice::minCell, range.max = MeshChoice::maxCell;
    range.logarithmic = true;
    range.unit = tr("spacings");
    auto* cell = new NumberSlider(tr("Cell"), tr("Size of the triangles, in typical distances between surfels"), range);
    cell->setObjectName("mesh-cell");
    cell->setFixedWidth(160);
    cell->setValue(m_choice.cell);
    addWidget(cell);
    connect(cell, &NumberSlider::edited, this,
            [this](double value) { change([value](MeshChoice& choice) { choice.cell = value; }); });
}

QCheckBox* MeshBar::box(const char* name, const QString& label, const QString& tip, bool MeshChoice::*member) {
    auto* out = new QCheckBox(label);
    out->setObjectName(name);
    out->setToolTip(tip);
    out->setFocusPolicy(Qt::NoFocus);
    out->setChecked(m_choice.*member);
    connect(out, &QCheckBox::toggled, this,
            [this, member](bool on) { change([member, on](MeshChoice& choice) { choice.*member = on; }); });
    return out;
}

void MeshBar::change(const std::function<void(MeshChoice&)>& edit) {
    edit(m_choice);
    Q_EMIT edited(m_choice);
}

void MeshBar::tell(const QString& text, const QString& tip) {
    m_text->setText(text);
    m_text->setToolTip(tip);
}

QString MeshBar::text() const {
    return m_text->text();
}

} // namespace ui
