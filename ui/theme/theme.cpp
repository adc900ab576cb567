// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/theme.h"

#include "core/base/json_object.h"
#include "core/base/resource_folder.h"
#include "ui/theme/colour.h"
#include "ui/theme/restyling.h"
#include "ui/theme/style_sheet.h"

#include <QApplication>
#include <QFont>
#include <QFontDatabase>
#include <QPalette>
#include <QStyleFactory>

#include <algorithm>
#include <optional>
#include <utility>

namespace burin {

namespace {

constexpr ResourceKind themeResource{"theme", "themes"};
constexpr double smallestPointSize = 10.0;

/// Roles that a user's theme may lack because it was written before they were added, with their default values.
constexpr std::array<std::pair<ColourRole, const char*>, 6> laterRoles{{{&Palette::conventionalPath, "#ff9cf2"},
                                                                        {&Palette::rapidPath, "#c9c4bb"},
                                                                        {&Palette::plungePath, "#f4f6f8"},
                                                                        {&Palette::chosenPath, "#fff04a"},
                                                                        {&Palette::comparedPath, "#38f5e8"},
                                                                        {&Palette::pathHalo, "#07090c"}}};

std::optional<Palette>& applied() {
    static std::optional<Palette> palette;
    return palette;
}

const char* idOf(Theme theme) {
    return theme == Theme::light ? "light" : "dark";
}

/// Whether a text is an opaque colour such as "#1b2026".
bool isColour(const std::string& text) {
    return text.size() == 7 && text[0] == '#' &&
           std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
}

Palette systemRoles() {
    const QPalette system = QGuiApplication::palette();
    Palette palette;
    for (const auto& [key, role] : colourRoles) palette.*role = system.color(QPalette::WindowText);
    palette.window = palette.panel = palette.sceneTop = palette.sceneBottom = system.color(QPalette::Window);
    palette.field = system.color(QPalette::Base);
    palette.border = palette.grid = system.color(QPalette::Mid);
    return palette;
}

/// The desktop's font. If there is none ("Sans Serif" and similar names stand for whatever is installed), the first
/// available of some families that are legible at small sizes and have digits of equal width.
QFont windowFont(QFont font) {
    const QString family = font.family();
    const bool chosen = !family.isEmpty() && !family.startsWith(QStringLiteral("sans"), Qt::CaseInsensitive);
    for (const char* preferred : {"Roboto", "Noto Sans", "Open Sans"}) {
        if (chosen || !QFontDatabase::hasFamily(QLatin1String(preferred))) continue;
        font.setFamilies(QStringList{QLatin1String(preferred), family});
        break;
    }
    // Some systems without a desktop report 9 points, which is too small for a screen that is viewed from a machine.
    if (font.pointSizeF() < smallestPointSize) font.setPointSizeF(smallestPointSize);
    return font;
}

QPalette systemPalette(const Palette& roles) {
    QPalette palette;
    const auto set = [&palette](QPalette::ColorRole role, const QColor& colour) { palette.setColor(role, colour); };
    set(QPalette::Window, roles.panel);
    set(QPalette::WindowText, roles.text);
    set(QPalette::Base, roles.field);
    set(QPalette::AlternateBase, mixed(roles.field, roles.panel, 0.5));
    set(QPalette::Text, roles.text);
    set(QPalette::PlaceholderText, roles.quietText);
    set(QPalette::Button, mixed(roles.panel, roles.text, 0.08));
    set(QPalette::ButtonText, roles.text);
    set(QPalette::BrightText, roles.force);
    set(QPalette::Light, mixed(roles.panel, roles.text, 0.15));
    set(QPalette::Midlight, mixed(roles.panel, roles.text, 0.1));
    set(QPalette::Mid, roles.border);
    set(QPalette::Dark, mixed(roles.panel, Qt::black, 0.3));
    set(QPalette::Shadow, mixed(roles.panel, Qt::black, 0.6));
    set(QPalette::Highlight, roles.accent);
    set(QPalette::HighlightedText, readableOn(roles.accent));
    set(QPalette::Link, roles.part);
    set(QPalette::LinkVisited, roles.part);
    set(QPalette::ToolTipBase, roles.field);
    set(QPalette::ToolTipText, roles.text);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, mixed(roles.panel, roles.quietText, 0.6));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, roles.border);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, roles.quietText);
    return palette;
}

} // namespace

Result<Palette> paletteFromJson(std::string_view text, const std::string& origin) {
    Result<JsonObject> file = JsonObject::parse(text, origin);
    if (!file) return file.error();
    file->text("id");
    Palette palette;
    file->object("colours", [&palette](JsonObject& colours) {
        for (const auto& [role, colour] : laterRoles) palette.*role = QColor(QLatin1String(colour));
        for (const auto& [key, role] : colourRoles) {
            if ((palette.*role).isValid() && !colours.has(key)) continue;
            const std::string colour = colours.text(key);
            if (isColour(colour))
                palette.*role = QColor(QString::fromStdString(colour));
            else
                colours.fail(key, "has to be a colour such as \"#1b2026\"");
        }
    });
    if (Result<void> read = file->finish(); !read) return read.error();
    return palette;
}

Result<Palette> loadPalette(Theme theme) {
    Result<ResourceText> file = findResource(themeResource, idOf(theme));
    if (!file) {
        if (file.error().code != ErrorCode::nameUnknown) return file.error();
        const std::filesystem::path missing = resourceSearchPath(themeResource).back() / idOf(theme);
        return Error{ErrorCode::fileNotFound, missing.string() + ".json", {}, {}};
    }
    return paletteFromJson(file->text, file->file);
}

void applyTheme(QApplication& application, const Palette& palette) {
    // Setting the style, the font or the style sheet visits every existing widget; style and font are the same in all
    // themes.
    if (!std::exchange(applied(), palette)) {
        application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
        application.setFont(windowFont(QFontDatabase::systemFont(QFontDatabase::GeneralFont)));
    }
    application.setPalette(systemPalette(palette));
    static QPointer<Restyling> restyling; // destroyed with the application
    if (!restyling) restyling = new Restyling(application);
    restyling->begin(styleSheet(palette));
}

const Palette& activePalette() {
    if (applied()) return *applied();
    static const Palette system = systemRoles();
    return system;
}

} // namespace burin
