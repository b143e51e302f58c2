#include "ui/settings/settings_file.h"

#include "core/render/effects/effect_rows.h"
#include "sculpt/random_options.h"
#include "support/comma_locale.h"
#include "support/registry.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace ui;

class SettingsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatIsWrittenIsReadBack();
    void aDecimalCommaChangesNothing();
    void nonsenseKeepsTheDefaults();
    void recentFilesAreFewAndNewestFirst();
    void strokesTakeWhatThePersonChose();
    void windowsLeaveAloneWhatOthersHaveWritten();
    void listsAreMergedEntryByEntry();
};

static Settings unusual(base::Random& random, test::Part part = test::Part::Within) {
    Settings out;
    const auto& row = sculpt::toolTable().back();
    out.tool = row.id;
    out.shiftTool = sculpt::toolTable().front().id;
    out.radiusUnit = RadiusUnit::Model;
    out.radiusPx = 77.25;
    out.radiusModel = 0.1 + 1e-13;
    test::drawAll({sculpt::Scope::AllTools}, random, part, out.shared);
    out.groups = {{"brush", false}, {"stamp", true}};
    for (const auto& tool : sculpt::toolTable()) {
        sculpt::StrokeSettings& choice = out.edit(tool);
        for (const auto& p : tool.parameters)
            choice.parameters[p.id] = p.min + 0.75 * (p.max - p.min);
        test::drawAll({sculpt::Scope::Tool}, random, part, choice);
    }
    out.shading = render::shadingTable().back().shading;
    out.backdrop = render::backdropTable().back().backdrop;
    out.effects = render::Outline | render::Occlusion;
    out.annotated = render::ScaleBar;
    out.grid = true;
    out.theme = "light";
    out.language = "de";
    out.historyMib = 256;
    out.keys = {{"View > frame-all", "Ctrl+Home"}, {"Edit > undo", ""}};
    out.truth = {true, 2.5, {raycast::Material::Glass, raycast::LightRig::Sun, {}, true, true, true}};
    out.recentFiles = {"/a/b c.ply", "/ü.xyz"};
    out.geometry = QByteArray("\0\1\2geometry", 11);
    out.windowState = "state";
    return out;
}

void SettingsTest::whatIsWrittenIsReadBack() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("s.ini");
    base::Random random(test::seed());
    std::vector<Settings> all{Settings{}};
    for (const test::Part part : {test::Part::Low, test::Part::High, test::Part::Within, test::Part::Within})
        all.push_back(unusual(random, part));
    all.push_back({});
    for (const Settings& settings : all) {
        {
            SettingsFile store(file);
            store.read();
            store.write(settings);
        }
        const QSettings store(file, QSettings::IniFormat);
        QVERIFY2(readSettings(store) == settings, qPrintable(QString("seed %1").arg(test::seed())));
    }
}

static QByteArray written(const Settings& settings) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("s.ini");
    SettingsFile(path).write(settings);
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void SettingsTest::aDecimalCommaChangesNothing() {
    base::Random random(test::seed());
    const Settings settings = unusual(random);
    const QByteArray usual = written(settings);
    QVERIFY(usual.contains("77.25"));
    const test::CommaLocale comma;
    QVERIFY(comma.works());
    QCOMPARE(written(settings), usual);
    const QTemporaryDir folder;
    QFile file(folder.filePath("s.ini"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(usual) == usual.size());
    file.close();
    QVERIFY(readSettings(QSettings(file.fileName(), QSettings::IniFormat)) == settings);
}

void SettingsTest::nonsenseKeepsTheDefaults() {
    const QTemporaryDir folder;
    QSettings store(folder.filePath("s.ini"), QSettings::IniFormat);
    store.setValue("brush/tool", "no such tool");
    store.setValue("brush/radiusPx", -4);
    store.setValue("brush/radiusModel", "nan");
    store.setValue("brush/radial", 1000);
    const QString group = QString("tools/%1/").arg(sculpt::toolTable().front().id);
    store.setValue(group + "spacing", "wide");
    store.setValue(group + "falloff", 17);
    store.setValue(group + "method", "none");
    for (const char* curve : {"0,1", "[[0,1],[1]]", "[[0,1],[0,0]]", "[[\"a\",1],[1,1]]", "[[0,1],[1,7]]"}) {
        store.setValue(group + "falloff-curve", curve);
        QVERIFY2(readSettings(store) == Settings{}, curve);
    }
    store.setValue("view/shading", "");
    store.setValue(QString("tools/%1/strength").arg(sculpt::toolTable().front().id), 40);
    QVERIFY(readSettings(store) == Settings{});
}

void SettingsTest::recentFilesAreFewAndNewestFirst() {
    Settings settings;
    for (int k = 0; k < 30; ++k)
        settings.remember("/file" + std::to_string(k % 15));
    QCOMPARE(settings.recentFiles.size(), Settings::recentLimit);
    QCOMPARE(settings.recentFiles.front(), std::string("/file14"));
    settings.remember("/file10");
    QCOMPARE(settings.recentFiles.size(), Settings::recentLimit);
    QCOMPARE(settings.recentFiles.front(), std::string("/file10"));
    QCOMPARE(std::count(settings.recentFiles.begin(), settings.recentFiles.end(), "/file10"), 1);
}

void SettingsTest::strokesTakeWhatThePersonChose() {
    base::Random random(test::seed());
    const Settings settings = unusual(random);
    for (const auto& row : sculpt::toolTable()) {
        const auto stroke = strokeSettings(settings, row, 0.25f, false);
        QCOMPARE(stroke.tool, std::string(row.id));
        QCOMPARE(stroke.radius, 0.25f);
        const sculpt::StrokeSettings& own = settings.tools.at(row.id);
        sculpt::StrokeSettings wanted = own;
        wanted.radius = 0.25f;
        wanted.symmetry = settings.shared.symmetry;
        wanted.resample = settings.shared.resample;
        QVERIFY2(stroke == wanted, qPrintable(QString("seed %1").arg(test::seed())));
        QVERIFY(stroke.parameters == own.parameters);
        QCOMPARE(strokeSettings(settings, row, 0.25f, true).invert, !own.invert);
        sculpt::check(stroke);

        const auto plain = strokeSettings(Settings{}, row, 1, false);
        QCOMPARE(plain.strength, static_cast<float>(row.strength));
        for (const auto& p : row.parameters)
            QCOMPARE(plain.parameters.at(p.id), p.fallback);
    }
}

void SettingsTest::windowsLeaveAloneWhatOthersHaveWritten() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("s.ini");
    SettingsFile one(path), other(path);
    Settings first = one.read(), second = other.read();
    first.radiusPx = 30;
    first.edit(sculpt::toolTable().front()).strength = 0.25f;
    first.remember("/one.ply");
    one.write(first);
    second.grid = true;
    second.radiusModel = 7;
    second.remember("/other.ply");
    other.write(second);
    first.truth.on = true;
    one.write(first);
    const Settings both = SettingsFile(path).read();
    QCOMPARE(both.radiusPx, 30.0);
    QCOMPARE(both.radiusModel, 7.0);
    QVERIFY(both.grid && both.truth.on);
    QCOMPARE(both.tools.at(sculpt::toolTable().front().id).strength, 0.25f);
    QCOMPARE(both.recentFiles, (std::vector<std::string>{"/other.ply", "/one.ply"}));
    first.tools.clear(); // back to the default, and gone from the file
    one.write(first);
    QVERIFY(SettingsFile(path).read().tools.empty());
    QVERIFY(SettingsFile(path).read().grid);
}

void SettingsTest::listsAreMergedEntryByEntry() {
    QCOMPARE(merged({"a", "b"}, {"c", "a", "b"}, {"a", "b"}), (QStringList{"c", "a", "b"}));
    QCOMPARE(merged({"a", "b"}, {"c", "a", "b"}, {"d", "a", "b"}), (QStringList{"c", "a", "b", "d"}));
    QCOMPARE(merged({"a", "b"}, {"b"}, {"a", "b", "d"}), (QStringList{"b", "d"}));
    QCOMPARE(merged({"a", "b"}, {"a", "b", "c"}, {"b"}), (QStringList{"b", "c"}));
    QCOMPARE(merged({}, {"a"}, {"a"}), QStringList{"a"});
}

static const test::Registered<SettingsTest> registered;
#include "settings_test.moc"
