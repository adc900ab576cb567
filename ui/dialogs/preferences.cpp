// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/preferences.h"

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
constexpr const char* metersKey = "meters_folded";
constexpr const char* parallelKey = "parallel_view";
constexpr const char* transparencyKey = "workpiece_transparency";
constexpr const char* folderKey = "last_folder";

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

int UserSettings::transparency() const {
    return settings_.value(transparencyKey).toInt();
}

void UserSettings::setTransparency(int percent) {
    settings_.setValue(transparencyKey, percent);
}

QString UserSettings::lastFolder() const {
    return settings_.value(folderKey).toString();
}

void UserSettings::setLastFolder(const QString& folder) {
    settings_.setValue(folderKey, folder);
}

} // namespace burin
