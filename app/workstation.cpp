// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/workstation.h"

#include "app/wording.h"
#include "core/base/error.h"
#include "ui/dialogs/preferences.h"
#include "ui/messages/messages.h"
#include "ui/scene/surface_format.h"
#include "ui/theme/icon.h"
#include "ui/window/main_window.h"
#include "ui/window/unix_signals.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QTranslator>

#include <atomic>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>

namespace burin {

namespace {

std::atomic<bool> atWork{false};

/// When the X server dies, its library calls exit() at any point. Threads are still running then; destroying static
/// objects that they use would only do harm, and everything recorded is on the disk already.
void leaveAtOnce() {
    if (atWork) std::_Exit(EXIT_FAILURE);
}

bool hasDisplay() {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    const char* platform = std::getenv("QT_QPA_PLATFORM");
    const std::string_view requested = platform != nullptr ? platform : "";
    if (requested == "offscreen" || requested == "minimal") return false; // these cannot draw with OpenGL
    return set("DISPLAY") || set("WAYLAND_DISPLAY") || !requested.empty();
}

void installLanguage() {
    const QString language = UserSettings().preferences().language;
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    QLocale::setDefault(locale);
    Messages::install(locale);
    auto* qt = new QTranslator(QCoreApplication::instance()); // texts of Qt's own dialogs
    if (qt->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                 QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(qt);
}

} // namespace

bool asksForWindow(int argc, char** argv, bool (*isCommand)(const std::string& word)) {
    if (argc == 1) return true;
    if (argc != 2 || argv[1][0] == '-' || isCommand(argv[1])) return false;
    std::error_code ignored;
    return std::filesystem::exists(argv[1], ignored);
}

int runWorkstation(int argc, char** argv) {
    if (!hasDisplay()) {
        const QCoreApplication application(argc, argv); // translations need one
        Messages::install(QLocale::system());
        std::cerr << worded(BURIN_TEXT("Command", "There is no display to open the window on; log in to a desktop, set "
                                                  "DISPLAY, or use a command: \"burin demo\" does the whole job "
                                                  "without one, \"burin --help\" lists the others."))
                  << "\n";
        return static_cast<int>(ErrorClass::wrongUse);
    }
    QSurfaceFormat::setDefaultFormat(sceneSurfaceFormat()); // the window's context shares with that of the view
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // Qt set the user's locale, but files are the same everywhere
    QCoreApplication::setApplicationName(QStringLiteral("Burin"));
    QCoreApplication::setApplicationVersion(QStringLiteral(BURIN_VERSION));
    QGuiApplication::setWindowIcon(themedIcon(QStringLiteral("mill"), &Palette::accent));
    QGuiApplication::setDesktopFileName(QStringLiteral("org.burin.Burin")); // for its icon, also on Wayland
    installLanguage();

    MainWindow window;
    const UnixSignals signals_;
    QObject::connect(&signals_, &UnixSignals::endRequested, &window, &MainWindow::endQuietly);
    window.show();
    if (argc > 1) window.openFile(QString::fromLocal8Bit(argv[1]));
    std::atexit(leaveAtOnce);
    atWork = true;
    const int status = QApplication::exec();
    atWork = false;
    return status;
}

} // namespace burin
