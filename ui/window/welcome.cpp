#include "ui/window/welcome.h"

#include "ui/panels/start_card.h"
#include "ui/window/main_window.h"
#include "ui/window/thumbnails.h"
#include "ui/window/tour.h"

namespace ui {

bool closeCards(MainWindow& window) {
    bool out = false;
    for (FloatingCard* card : window.viewport().widget()->findChildren<FloatingCard*>(Qt::FindDirectChildrenOnly))
        out |= card->isVisible() && card->close();
    return out;
}

void showTour(MainWindow& window) {
    closeCards(window);
    (new Tour(window))->show();
}

void showStart(MainWindow& window) {
    closeCards(window);
    FileActions& files = window.files();
    auto* card = new StartCard(*window.viewport().widget(), window.settings().recentFiles,
                               [&window](const std::string& file) { return window.thumbnails().of(file); });
    QObject::connect(card, &StartCard::openWanted, &window, [&files] { files.open(); });
    QObject::connect(card, &StartCard::sampleWanted, &window, [&files](const std::string& id) { files.make(id); });
    QObject::connect(card, &StartCard::recentWanted, &window,
                     [&files](const std::string& path) { files.open(std::filesystem::path(path)); });
    QObject::connect(
        card, &StartCard::tourWanted, &window, [&window] { showTour(window); }, Qt::QueuedConnection);
    QObject::connect(&files, &FileActions::began, card, &StartCard::close);
    card->show();
}

} // namespace ui
