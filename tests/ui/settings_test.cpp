#include "ui/settings/settings.h"

#include "support/registry.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace ui;

class SettingsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatIsWrittenIsReadBack();
    void nonsenseKeepsTheDefaults();
    void recentFilesAreFewAndNewestFirst();
    void strokesTakeWhatThePersonChose();
};

/// Another value than the default, whatever kind the option is.
static void change(const sculpt::StrokeOption& option, sculpt::StrokeSettings& out) {
    const auto set = [&](auto field) {
        auto& value = out.*field;
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, float>)
            value = static_cast<float>((0.9 * option.range.low + 0.1 * option.range.high) / option.range.scale);
        else if constexpr (std::is_same_v<Value, bool>)
            value = !value;
        else if constexpr (std::is_same_v<Value, std::string>)
            value = "/a folder/ö.png";
        else if constexpr (std::is_same_v<Value, sculpt::CurvePoints>)
            value = {{0, 0.25f}, {1.0f / 3, 0.7f}, {1, 0.125f}};
        else if constexpr (std::is_same_v<Value, sculpt::Falloff>)
            value = sculpt::falloffTable().back().falloff;
        else
            value = sculpt::methodTable().back().method;
    };
    std::visit(set, option.field);
}

static Settings unusual() {
    Settings out;
    const auto& row = sculpt::toolTable().back();
    out.tool = row.id;
    out.shiftTool = sculpt::toolTable().front().id;
    out.radiusUnit = RadiusUnit::Model;
    out.radiusPx = 77.25;
    out.radiusModel = 0.1 + 1e-13;
    out.symmetry = {true, false, true, 7, 1};
    out.resample = false;
    out.groups = {{"brush", false}, {"stamp", true}};
    for (const auto& tool : sculpt::toolTable()) {
        sculpt::StrokeSettings& choice = out.edit(tool);
        for (const auto& p : tool.parameters)
            choice.parameters[p.id] = p.min + 0.75 * (p.max - p.min);
        for (const auto& option : sculpt::strokeOptionTable())
            change(option, choice);
    }
    out.shading = render::shadingTable().back().shading;
    out.backdrop = render::backdropTable().back().backdrop;
    out.effects = render::Outline | render::Occlusion;
    out.annotated = render::ScaleBar;
    out.grid = true;
    out.truth = {true, 2.5, {raycast::Material::Glass, raycast::LightRig::Sun, {}, true, true, true}};
    out.recentFiles = {"/a/b c.ply", "/ü.xyz"};
    out.geometry = QByteArray("\0\1\2geometry", 11);
    out.windowState = "state";
    return out;
}

void SettingsTest::whatIsWrittenIsReadBack() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("s.ini");
    for (const Settings& settings : {Settings{}, unusual(), Settings{}}) {
        {
            QSettings store(file, QSettings::IniFormat);
            writeSettings(settings, store);
        }
        const QSettings store(file, QSettings::IniFormat);
        QVERIFY(readSettings(store) == settings);
    }
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
    for (const char* curve : {"0,1", "0,1;1", "0,1;0,0", "a,b;1,1", "0,1;1,7"}) {
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
    const Settings settings = unusual();
    for (const auto& row : sculpt::toolTable()) {
        const auto stroke = strokeSettings(settings, row, 0.25f, false);
        QCOMPARE(stroke.tool, std::string(row.id));
        QCOMPARE(stroke.radius, 0.25f);
        QCOMPARE(stroke.strength, 0.1f);
        QVERIFY(stroke.symmetry == settings.symmetry);
        QVERIFY(stroke.invert && !stroke.resample);
        QVERIFY(stroke.falloff == sculpt::Falloff::Custom && stroke.falloffCurve.size() == 3);
        QVERIFY(stroke.parameters == settings.tools.at(row.id).parameters);
        QVERIFY(!strokeSettings(settings, row, 0.25f, true).invert);
        sculpt::check(stroke);

        const auto plain = strokeSettings(Settings{}, row, 1, false);
        QCOMPARE(plain.strength, static_cast<float>(row.strength));
        for (const auto& p : row.parameters)
            QCOMPARE(plain.parameters.at(p.id), p.fallback);
    }
}

static const test::Registered<SettingsTest> registered;
#include "settings_test.moc"
