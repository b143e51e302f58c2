#include "ui/window/recovery_dialog.h"

#include "ui/window/file_dialogs.h"
#include "ui/window/grown_dialog.h"

#include <chrono>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

static QString describe(const session::LeftJournal& journal) {
    const auto when = std::chrono::file_clock::to_sys(journal.time);
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(when.time_since_epoch()).count();
    const QString name = journal.model.empty() ? QObject::tr("a new model") : textOf(journal.model.filename());
    const QString steps = journal.commands == 1 ? QObject::tr("1 step") : QObject::tr("%1 steps").arg(journal.commands);
    return QObject::tr("The program ended without saving %1 (%2, last changed %3).")
        .arg(name, steps, QDateTime::fromSecsSinceEpoch(seconds).toString("yyyy-MM-dd hh:mm"));
}

RecoveryDialog::RecoveryDialog(const session::LeftJournal& journal, QWidget* parent) : QDialog(parent) {
    constexpr QSize size(420, 280);
    setWindowTitle(tr("Recover lost work?"));
    auto* layout = new QVBoxLayout(this);
    auto* what = new QLabel(describe(journal));
    what->setWordWrap(true);
    layout->addWidget(what);
    m_picture = new QLabel(tr("Looking at what is left…"));
    m_picture->setObjectName("stamp-picture");
    m_picture->setAlignment(Qt::AlignCenter);
    m_picture->setFixedSize(size);
    layout->addWidget(m_picture);
    m_steps = new QLabel;
    m_steps->setObjectName("recovered-steps");
    m_steps->setWordWrap(true);
    layout->addWidget(m_steps);
    auto* buttons = new QDialogButtonBox;
    auto* recover = buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole);
    auto* discard = buttons->addButton(tr("&Discard"), QDialogButtonBox::DestructiveRole);
    auto* later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    recover->setObjectName("recover");
    recover->setDefault(true);
    discard->setObjectName("discard");
    discard->setToolTip(tr("Deletes what is left; it cannot come back"));
    later->setToolTip(tr("Asks again at the next start"));
    connect(recover, &QPushButton::clicked, this, [this] { done(Recover); });
    connect(discard, &QPushButton::clicked, this, [this] { done(Discard); });
    connect(later, &QPushButton::clicked, this, [this] { done(Later); });
    layout->addWidget(buttons);
    connect(&m_preview, &RecoveryPreview::shown, this, &RecoveryDialog::showPicture);
    connect(&m_preview, &RecoveryPreview::failed, this, [this](const QString& why) {
        m_picture->setText(tr("There is no picture of it."));
        m_steps->setText(why);
        growToWords(*this);
    });
    connect(&m_preview, &RecoveryPreview::progressed, this, [this](double share, const QString&) {
        if (m_shown.isNull())
            m_picture->setText(tr("Replaying what was done, %1 %").arg(100 * share, 0, 'f', 0));
    });
    m_preview.want(journal.path, size * devicePixelRatioF());
}

void RecoveryDialog::showPicture(const QImage& picture, const QString& steps) {
    m_shown = picture;
    m_shown.setDevicePixelRatio(devicePixelRatioF());
    m_picture->setPixmap(QPixmap::fromImage(m_shown));
    m_steps->setText(steps.isEmpty() ? QString() : tr("Done to it: %1.").arg(steps));
    growToWords(*this);
}

} // namespace ui
