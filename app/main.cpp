// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/wording.h"
#include "app/workstation.h"
#include "ui/messages/messages.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <clocale>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace {

constexpr std::array commands{burin::registerImport,   burin::registerEmbed,     burin::registerSetup,
                              burin::registerMill,     burin::registerPath,      burin::registerPost,
                              burin::registerVerify,   burin::registerInfo,      burin::registerCalibrate,
                              burin::registerDemo,     burin::registerBench,     burin::registerDevices,
                              burin::registerMeasure,  burin::registerPicture,   burin::registerSheet,
                              burin::registerMachines, burin::registerMaterials, burin::registerTools,
                              burin::registerTake,     burin::registerVolume,    burin::registerFixtures};

void addCommands(const burin::CommandLine& line, burin::CommandContext& context, int& status) {
    for (const burin::Register registerCommand : commands) registerCommand(line.program(), context, status);
}

/// An error that names the unknown command; the parser would only report a missing command.
std::optional<burin::Error> unknownCommand(const burin::CommandLine& line, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return std::nullopt;
    std::string known;
    for (const std::string& name : line.commandNames()) {
        if (name == argv[1]) return std::nullopt;
        known += (known.empty() ? "" : ", ") + name;
    }
    return burin::Error{burin::ErrorCode::nameUnknown, "command", argv[1], known};
}

/// Whether a word is a command of the command line.
bool isCommand(const std::string& word) {
    const burin::CommandLine line;
    burin::CommandContext context;
    int status = 0;
    addCommands(line, context, status);
    return std::ranges::count(line.commandNames(), word) > 0;
}

/// Translations need an application, and text in pictures needs Qt's fonts, but no display.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv) {
    const std::string_view command = argc > 1 ? argv[1] : "";
    if (command != "demo" && command != "picture" && command != "sheet")
        return std::make_unique<QCoreApplication>(argc, argv);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Warnings of Qt about a missing desktop (such as a session folder) are irrelevant to users of commands.
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
        if (type == QtCriticalMsg || type == QtFatalMsg) std::cerr << text.toStdString() << "\n";
    });
    return std::make_unique<QGuiApplication>(argc, argv);
}

/// Returns the result of `work`, or the exit status after reporting an exception in one sentence.
int guarded(const std::function<int()>& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        std::cerr << burin::worded(BURIN_TEXT("Command", "Burin ran out of memory. Choose a larger voxel.")) << "\n";
        return static_cast<int>(burin::ErrorClass::outOfSpaceOrRights);
    } catch (const std::exception& fault) {
        std::cerr << burin::worded(BURIN_TEXT("Command", "Internal error in Burin; report this: %1"), {fault.what()})
                  << "\n";
        return static_cast<int>(burin::ErrorClass::badInput);
    }
}

int runCommand(int argc, char** argv) {
    const burin::CommandLine line;
    burin::CommandContext context;
    int status = 0;
    addCommands(line, context, status);
    if (const std::optional<burin::Error> unknown = unknownCommand(line, argc, argv)) return context.fail(*unknown);
    return line.parse(argc, argv).value_or(status);
}

int run(int argc, char** argv) {
    if (burin::asksForWindow(argc, argv, isCommand)) return burin::runWorkstation(argc, argv);
    const std::unique_ptr<QCoreApplication> application = makeApplication(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // Qt set the user's locale; numbers in arguments and files are the same everywhere
    QCoreApplication::setApplicationName("Burin");
    burin::Messages::install(QLocale::system());
    QLocale::setDefault(QLocale::c()); // a decimal point in every language, as in arguments and files

    return guarded([&] { return runCommand(argc, argv); }); // messages are in the user's language from here on
}

} // namespace

int main(int argc, char** argv) {
    return guarded([&] { return run(argc, argv); });
}
