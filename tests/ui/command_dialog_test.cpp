// Dialogs of commands: what the model has now stands in them, in words and units, and what will become of it below.
#include "core/base/error.h"
#include "support/registry.h"
#include "ui/window/command_dialog.h"
#include "ui/window/parameter_words.h"
#include "ui/window_fixture.h"

#include <algorithm>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>

using test::WindowFixture;

class CommandDialogTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void resampleProposesThePresentSpacing();
    void anotherWishTakesThePlaceOfTheProposal();
    void surfaceShowsWhatTheModelHas();
    void everyLabelIsWordsWithAKey();
    void scannersStandAtThreeNumbers();
    void returnAcceptsFromEveryField();
    void endlessRangesAreNotTold();
};

static QLineEdit& line(ui::CommandDialog& dialog, const char* name) {
    return *dialog.findChild<QLineEdit*>(name);
}

void CommandDialogTest::resampleProposesThePresentSpacing() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    const double spacing = static_cast<double>(f.editor().snapshot().spacing);
    ui::CommandDialog dialog(session::command("resample"), f.editor().snapshot());
    QVERIFY(std::abs(line(dialog, "spacing").text().toDouble() / spacing - 1) < 1e-3);
    QVERIFY(std::abs(dialog.command()["spacing"].get<double>() / spacing - 1) < 1e-3);
    QVERIFY(!dialog.outcome().isEmpty());
    // What it says is what comes.
    line(dialog, "spacing").setText(QString::number(1.5 * spacing));
    const double said = dialog.outcome().section(' ', 1, 1).remove(',').toDouble();
    QCOMPARE(dialog.findChild<QLabel*>("outcome")->text(), dialog.outcome());
    f.editor().run(dialog.command());
    QVERIFY(f.settle());
    QVERIFY2(std::abs(said / static_cast<double>(f.surfels()) - 1) < 0.15,
             qPrintable(QString("%1 said, %2 came").arg(said).arg(f.surfels())));
}

void CommandDialogTest::anotherWishTakesThePlaceOfTheProposal() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    ui::CommandDialog dialog(session::command("resample"), f.editor().snapshot());
    QVERIFY(line(dialog, "count").placeholderText().contains("now"));
    QTest::keyClicks(&line(dialog, "count"), "500");
    const nlohmann::json command = dialog.command();
    QVERIFY(command["count"] == 500 && !command.contains("spacing"));
    f.editor().run(command);
    QVERIFY(f.settle());
    QVERIFY(f.surfels() > 400 && f.surfels() < 600);
}

void CommandDialogTest::surfaceShowsWhatTheModelHas() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 2000));
    f.editor().run({{"op", "surface"}, {"frame", "apss"}, {"one-sheet", "on"}});
    QVERIFY(f.settle());
    ui::CommandDialog dialog(session::command("surface"), f.editor().snapshot());
    auto& frame = *dialog.findChild<QComboBox*>("frame");
    QCOMPARE(frame.currentData().toString(), QString("apss"));
    QVERIFY(frame.currentText().contains("APSS") && dialog.findChild<QCheckBox*>("one-sheet")->isChecked());
    QCOMPARE(dialog.command().size(), std::size_t(1)); // nothing edited, nothing asked
    dialog.findChild<QCheckBox*>("one-sheet")->setChecked(false);
    const nlohmann::json command = dialog.command();
    QVERIFY(command.size() == 2 && command["one-sheet"] == "off");
}

void CommandDialogTest::everyLabelIsWordsWithAKey() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    for (const auto& row : session::commandTable()) {
        if (!ui::hasDialog(row))
            continue;
        ui::CommandDialog dialog(row, f.editor().snapshot());
        QSet<QChar> keys;
        const QString buttons = "oc"; // OK and Cancel have these where a desktop draws keys
        QStringList said, without;    // long lists run out of letters
        for (const QLabel* label : dialog.findChildren<QLabel*>()) {
            if (!label->buddy())
                continue;
            const QString text = label->text();
            QVERIFY2(!text.contains('-') && !text.contains('_') && QString(text).remove('&')[0].isUpper(),
                     qPrintable(text));
            const QString words = QString(text).remove('&').section(',', 0, 0);
            QVERIFY2(!said.contains(words), qPrintable(row.op + (": " + words)));
            said << words;
            const qsizetype at = text.indexOf('&');
            if (at < 0) {
                without << text;
                continue;
            }
            QVERIFY2(!keys.contains(text[at + 1].toLower()), qPrintable(row.op + (": " + text)));
            keys.insert(text[at + 1].toLower());
        }
        for (const QString& text : without)
            for (const QChar c : text)
                QVERIFY2(!c.isLetter() || keys.contains(c.toLower()) || buttons.contains(c.toLower()),
                         qPrintable(row.op + (": " + text)));
        // What journals fill in is not asked of a person.
        const auto asked = std::count_if(row.parameters.begin(), row.parameters.end(),
                                         [](const session::CommandParameter& p) { return !p.recorded; });
        QCOMPARE(keys.size() + without.size(), qsizetype(asked));
    }
}

void CommandDialogTest::scannersStandAtThreeNumbers() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    ui::CommandDialog dialog(session::command("normals"), f.editor().snapshot());
    line(dialog, "viewpoint").setText("1, 2.5, -3");
    QVERIFY(dialog.command()["viewpoint"] == (nlohmann::json{1.0, 2.5, -3.0}));
    line(dialog, "viewpoint").setText("1, here");
    QVERIFY_THROWS_EXCEPTION(base::Error, dialog.command());
}

/// The list's completion took the first Return for itself, and nothing happened.
void CommandDialogTest::returnAcceptsFromEveryField() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 500));
    for (const char* field : {"holes", "method", "up_to"}) {
        ui::CommandDialog dialog(session::command("fill"), f.editor().snapshot());
        dialog.show();
        QSignalSpy accepted(&dialog, &QDialog::accepted);
        auto* widget = dialog.findChild<QWidget*>(field);
        widget->setFocus();
        QTest::keyClick(widget, Qt::Key_Return);
        QVERIFY2(accepted.count() == 1, field);
    }
}

void CommandDialogTest::endlessRangesAreNotTold() {
    WindowFixture f;
    for (const session::CommandRow& row : session::commandTable())
        if (ui::hasDialog(row)) {
            const ui::CommandDialog dialog(row, f.editor().snapshot());
            for (const QWidget* each : dialog.findChildren<QWidget*>())
                QVERIFY2(!each->toolTip().contains("e+"), qPrintable(each->toolTip()));
        }
}

static const test::Registered<CommandDialogTest> registered;
#include "command_dialog_test.moc"
