// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/preferences.h"

#include <QUrl>

namespace burin {

namespace {

constexpr const char* themeKey = "theme";
constexpr const char* unitKey = "unit";
constexpr const char* languageKey = "language";
constexpr const char* recentKey = "recent_files";
constexpr const char* geometryKey = "window_geometry";
constexpr const char* panelWidthKey = "panel_width";
constexpr const char* docksKey = "view_docks";
constexpr const char* programDockedKey = "program_docked";
constexpr const char* placementHandlesKey = "placement_handles";
constexpr const char* timelineShownKey = "timeline_shown";
constexpr const char* timelineCurvesKey = "timeline_curves";
constexpr const char* metersKey = "meters_folded";
constexpr const char* parallelKey = "parallel_view";
constexpr const char* transparencyKey = "workpiece_transparency";
constexpr const char* shortcutsKey = "shortcuts";
constexpr const char* deviceKey = "device";
constexpr const char* viewDeviceKey = "viewDevice";
constexpr const char* deviceModeKey = "device_mode";
constexpr const char* penSinksKey = "pen_sinks";
constexpr const char* penSinkSpeedKey = "pen_sink_speed_mm_per_s";
constexpr const char* shareKey = "cutting_force_share";
constexpr const char* frictionKey = "friction";
constexpr const char* assistKey = "assist";
constexpr const char* stiffnessKey = "stiffness_n_per_m";
constexpr const char* dampingKey = "damping_n_s_per_m";
constexpr const char* previousStiffnessKey = "previous_stiffness_n_per_m";
constexpr const char* previousDampingKey = "previous_damping_n_s_per_m";
constexpr const char* ceilingKey = "stiffness_ceiling_n_per_m";
constexpr const char* handleFrictionKey = "handle_friction_n";
constexpr const char* stockLayerKey = "keeps_from_stock";
constexpr const char* stockDistanceKey = "stock_distance_mm";
constexpr const char* axisMapKey = "axis_map";

/// A device's own section of the file; its id may contain characters with a meaning in keys.
QString deviceKeyOf(const std::string& device, const char* key) {
    const QByteArray plain = QUrl::toPercentEncoding(QString::fromStdString(device));
    return QStringLiteral("devices/") + QString::fromLatin1(plain).replace(QLatin1Char('%'), QLatin1Char('+')) +
           QLatin1Char('/') + QLatin1String(key);
}
constexpr const char* folderKey = "last_folder";
constexpr const char* firstJobKey = "first_job_finished";

} // namespace

UserSettings::UserSettings()
    : settings_(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("burin"), QStringLiteral("burin")) {}

Preferences UserSettings::preferences() const {
    Preferences preferences;
    if (settings_.value(themeKey).toString() == QLatin1String("light")) preferences.theme = Theme::light;
    if (settings_.value(unitKey).toString() == QLatin1String("inch")) preferences.unit = LengthUnit::inch;
    preferences.language = settings_.value(languageKey).toString();
    return preferences;
}

void UserSettings::setPreferences(const Preferences& preferences) {
    settings_.setValue(themeKey, preferences.theme == Theme::light ? "light" : "dark");
    settings_.setValue(unitKey, preferences.unit == LengthUnit::inch ? "inch" : "mm");
    settings_.setValue(languageKey, preferences.language);
}

QStringList UserSettings::recentFiles() const {
    return settings_.value(recentKey).toStringList();
}

bool UserSettings::isRecentFile(const QString& file) const {
    return recentFiles().contains(file);
}

void UserSettings::removeRecentFile(const QString& file) {
    QStringList files = recentFiles();
    files.removeAll(file);
    settings_.setValue(recentKey, files);
}

void UserSettings::addRecentFile(const QString& file) {
    QStringList files = settings_.value(recentKey).toStringList();
    files.removeAll(file);
    files.prepend(file);
    if (files.size() > maximumRecentFiles) files.resize(maximumRecentFiles);
    settings_.setValue(recentKey, files);
}

QByteArray UserSettings::windowGeometry() const {
    return settings_.value(geometryKey).toByteArray();
}

void UserSettings::setWindowGeometry(const QByteArray& geometry) {
    settings_.setValue(geometryKey, geometry);
}

QByteArray UserSettings::panelWidth() const {
    return settings_.value(panelWidthKey).toByteArray();
}

void UserSettings::setPanelWidth(const QByteArray& state) {
    settings_.setValue(panelWidthKey, state);
}

QByteArray UserSettings::viewDocks() const {
    return settings_.value(docksKey).toByteArray();
}

void UserSettings::setViewDocks(const QByteArray& state) {
    settings_.setValue(docksKey, state);
}

bool UserSettings::timelineShown() const {
    return settings_.value(timelineShownKey, true).toBool();
}

void UserSettings::setTimelineShown(bool shown) {
    settings_.setValue(timelineShownKey, shown);
}

QStringList UserSettings::timelineCurves() const {
    return settings_.value(timelineCurvesKey, QStringList{QStringLiteral("force")}).toStringList();
}

void UserSettings::setTimelineCurves(const QStringList& curves) {
    settings_.setValue(timelineCurvesKey, curves);
}

bool UserSettings::placementHandles() const {
    return settings_.value(placementHandlesKey, true).toBool();
}

void UserSettings::setPlacementHandles(bool shown) {
    settings_.setValue(placementHandlesKey, shown);
}

bool UserSettings::programDocked() const {
    return settings_.value(programDockedKey).toBool();
}

void UserSettings::setProgramDocked(bool docked) {
    settings_.setValue(programDockedKey, docked);
}

bool UserSettings::metersFolded() const {
    return settings_.value(metersKey, true).toBool();
}

void UserSettings::setMetersFolded(bool folded) {
    settings_.setValue(metersKey, folded);
}

bool UserSettings::parallelView() const {
    return settings_.value(parallelKey).toBool();
}

void UserSettings::setParallelView(bool parallel) {
    settings_.setValue(parallelKey, parallel);
}

QMap<QString, QString> UserSettings::shortcuts() const {
    QMap<QString, QString> shortcuts;
    const QVariantMap stored = settings_.value(shortcutsKey).toMap();
    for (auto at = stored.begin(); at != stored.end(); ++at) shortcuts.insert(at.key(), at.value().toString());
    return shortcuts;
}

void UserSettings::setShortcuts(const QMap<QString, QString>& shortcuts) {
    QVariantMap stored;
    for (auto at = shortcuts.begin(); at != shortcuts.end(); ++at) stored.insert(at.key(), at.value());
    settings_.setValue(shortcutsKey, stored);
}

int UserSettings::transparency() const {
    return settings_.value(transparencyKey).toInt();
}

void UserSettings::setTransparency(int percent) {
    settings_.setValue(transparencyKey, percent);
}

std::pair<std::string, std::string> UserSettings::chosenDevice() const {
    return {settings_.value(deviceKey).toString().toStdString(),
            settings_.value(deviceModeKey).toString().toStdString()};
}

void UserSettings::setChosenDevice(const std::string& id, const std::string& mode) {
    settings_.setValue(deviceKey, QString::fromStdString(id));
    settings_.setValue(deviceModeKey, QString::fromStdString(mode));
}

std::string UserSettings::viewDevice() const {
    return settings_.value(viewDeviceKey).toString().toStdString();
}

void UserSettings::setViewDevice(const std::string& id) {
    settings_.setValue(viewDeviceKey, QString::fromStdString(id));
}

FeltCutting UserSettings::felt(const std::string& device) const {
    const auto number = [&](const char* key, double usual) {
        bool good = false;
        const double value = settings_.value(deviceKeyOf(device, key)).toDouble(&good);
        return good && value >= 0.0 && value <= 1.0 ? value : usual; // the file may have been edited
    };
    FeltCutting felt;
    felt.gain = number(shareKey, felt.gain);
    felt.friction = number(frictionKey, felt.friction);
    felt.assist = number(assistKey, felt.assist);
    return felt;
}

void UserSettings::setFelt(const std::string& device, const FeltCutting& felt) {
    settings_.setValue(deviceKeyOf(device, shareKey), felt.gain);
    settings_.setValue(deviceKeyOf(device, frictionKey), felt.friction);
    settings_.setValue(deviceKeyOf(device, assistKey), felt.assist);
}

KeptGains UserSettings::gains(const std::string& device) const {
    const auto limit = [&](const char* key, double lowest) {
        bool good = false;
        const double value = settings_.value(deviceKeyOf(device, key)).toDouble(&good);
        return good && value >= lowest ? value : GainLimits::none; // the file may have been edited
    };
    KeptGains gains;
    gains.now = {limit(stiffnessKey, GainLimits::softest), limit(dampingKey, 0.0)};
    gains.before = {limit(previousStiffnessKey, GainLimits::softest), limit(previousDampingKey, 0.0)};
    gains.request.ceiling = limit(ceilingKey, GainLimits::softest);
    const double friction = settings_.value(deviceKeyOf(device, handleFrictionKey)).toDouble();
    gains.request.friction = friction > 0.0 && friction <= GainRequest::mostFriction ? friction : 0.0;
    return gains;
}

QString UserSettings::setGains(const std::string& device, const KeptGains& gains) {
    const auto keep = [&](const char* key, double value, bool needed) {
        if (needed)
            settings_.setValue(deviceKeyOf(device, key), value);
        else
            settings_.remove(deviceKeyOf(device, key));
    };
    const auto keepLimit = [&](const char* key, double value) { keep(key, value, value < GainLimits::none); };
    keepLimit(stiffnessKey, gains.now.stiffness);
    keepLimit(dampingKey, gains.now.damping);
    keepLimit(previousStiffnessKey, gains.before.stiffness);
    keepLimit(previousDampingKey, gains.before.damping);
    keepLimit(ceilingKey, gains.request.ceiling);
    keep(handleFrictionKey, gains.request.friction, gains.request.friction > 0.0);
    settings_.sync();
    return settings_.status() == QSettings::NoError ? QString() : settings_.fileName();
}

StockLayer UserSettings::stockLayer() const {
    const double distance = settings_.value(stockDistanceKey, StockLayer::usualDistance).toDouble();
    const auto [low, high] = StockLayer::distances;
    // the file may have been edited
    return {distance >= low && distance <= high ? distance : StockLayer::usualDistance,
            settings_.value(stockLayerKey).toBool()};
}

void UserSettings::setStockLayer(const StockLayer& layer) {
    settings_.setValue(stockDistanceKey, layer.distance);
    settings_.setValue(stockLayerKey, layer.on);
}

bool UserSettings::penSinks() const {
    return settings_.value(penSinksKey).toBool();
}

void UserSettings::setPenSinks(bool sinks) {
    settings_.setValue(penSinksKey, sinks);
}

double UserSettings::penSinkSpeed() const {
    constexpr double usual = 2.0, slowest = 0.1, fastest = 50.0; // mm/s
    const double speed = settings_.value(penSinkSpeedKey, usual).toDouble();
    return speed >= slowest && speed <= fastest ? speed : usual; // the file may have been edited
}

void UserSettings::setPenSinkSpeed(double speed) {
    settings_.setValue(penSinkSpeedKey, speed);
}

std::string UserSettings::axisMap(const std::string& device) const {
    return settings_.value(deviceKeyOf(device, axisMapKey)).toString().toStdString();
}

QString UserSettings::setAxisMap(const std::string& device, const std::string& map) {
    if (map.empty())
        settings_.remove(deviceKeyOf(device, axisMapKey));
    else
        settings_.setValue(deviceKeyOf(device, axisMapKey), QString::fromStdString(map));
    settings_.sync();
    return settings_.status() == QSettings::NoError ? QString() : settings_.fileName();
}

bool UserSettings::firstJobFinished() const {
    return settings_.value(firstJobKey).toBool();
}

void UserSettings::setFirstJobFinished(bool finished) {
    settings_.setValue(firstJobKey, finished);
}

QString UserSettings::lastFolder() const {
    return settings_.value(folderKey).toString();
}

void UserSettings::setLastFolder(const QString& folder) {
    settings_.setValue(folderKey, folder);
}

} // namespace burin
