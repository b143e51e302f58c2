// What a person meets who has opened nothing: a model to open, samples, what was open lately, the tour. A press beside
// it closes it, and sculpts. It asks; what is asked for is done elsewhere. Interface's thread only.
#pragma once

#include "ui/panels/floating_card.h"

#include <functional>
#include <QIcon>
#include <string>
#include <vector>

class QAbstractButton;
class QBoxLayout;
class QGridLayout;
class QLabel;

namespace ui {

class StartCard : public FloatingCard {
    Q_OBJECT
  public:
    using PictureOf = std::function<QIcon(const std::string& file)>;

    /// `recent`: files, the latest first; those that are gone are left out.
    StartCard(QWidget& canvas, const std::vector<std::string>& recent, const PictureOf& pictureOf);

  Q_SIGNALS:
    // Each closes the card.
    void openWanted();
    void sampleWanted(const std::string& id);
    void recentWanted(const std::string& path);
    void tourWanted();

  protected:
    void pressedBeside() override { close(); }
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    /// In a small picture fewer samples, in fewer columns, so that words are whole.
    void layOutFor(const QSize& canvas);
    QLabel* addHeading(const QString& text);
    void addSamples();
    void addRecent(const std::vector<std::string>& recent, const PictureOf& pictureOf);
    void addFoot();
    /// A flat button that closes the card and then does something.
    QAbstractButton* button(const QString& text, const QString& name, const std::function<void()>& then);

    QGridLayout* m_grid = nullptr;
    QBoxLayout* m_foot = nullptr;
    QLabel *m_what = nullptr, *m_samplesHeading = nullptr;
    std::vector<QAbstractButton*> m_samples;
};

} // namespace ui
