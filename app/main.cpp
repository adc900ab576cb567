// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/parse_error.h"
#include "app/workstation.h"
#include "ui/messages/messages.h"

#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <clocale>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace {

constexpr std::array commands{burin::registerImport,  burin::registerEmbed,   burin::registerSetup,
                              burin::registerMill,    burin::registerPath,    burin::registerPost,
                              burin::registerVerify,  burin::registerInfo,    burin::registerCalibrate,
                              burin::registerDemo,    burin::registerBench,   burin::registerDevices,
                              burin::registerPicture, burin::registerMachines};

/// CLI11 would only say that a command is missing.
std::optional<burin::Error> unknownCommand(const CLI::App& program, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return std::nullopt;
    std::string known;
    for (const CLI::App* command : program.get_subcommands({})) {
        if (command->get_name() == argv[1]) return std::nullopt;
        known += (known.empty() ? "" : ", ") + command->get_name();
    }
    return burin::Error{burin::ErrorCode::nameUnknown, "command", argv[1], known};
}

/// The commands as the command line knows them.
bool isCommand(const std::string& word) {
    CLI::App program;
    burin::CommandContext context;
    int status = 0;
    for (const burin::Register registerCommand : commands) registerCommand(program, context, status);
    return std::ranges::any_of(program.get_subcommands({}),
                               [&](const CLI::App* command) { return command->get_name() == word; });
}

/// Translations need an application; the letters in a picture Qt's fonts as well, but no display.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv) {
    const std::string_view command = argc > 1 ? argv[1] : "";
    if (command != "demo" && command != "picture") return std::make_unique<QCoreApplication>(argc, argv);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // What Qt misses without a desktop (a folder for the session) is nothing to trouble a user of commands with.
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
        if (type == QtCriticalMsg || type == QtFatalMsg) std::cerr << text.toStdString() << "\n";
    });
    return std::make_unique<QGuiApplication>(argc, argv);
}

int run(int argc, char** argv) {
    if (burin::asksForWindow(argc, argv, isCommand)) return burin::runWorkstation(argc, argv);
    const std::unique_ptr<QCoreApplication> application = makeApplication(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // Qt took the user's: numbers of arguments and files are the same everywhere
    QCoreApplication::setApplicationName("Burin");
    burin::Messages::install(QLocale::system());

    CLI::App program("Burin: milling tool paths authored by hand", "burin");
    program.set_version_flag("--version", BURIN_VERSION);
    program.set_help_all_flag("--help-all", "Help for all commands");
    program.require_subcommand(1);
    burin::CommandContext context;
    int status = 0;
    for (const burin::Register registerCommand : commands) registerCommand(program, context, status);
    if (const std::optional<burin::Error> unknown = unknownCommand(program, argc, argv)) return context.fail(*unknown);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        if (wrong.get_exit_code() == 0) return program.exit(wrong, std::cout, std::cerr); // --help, --version
        std::cerr << burin::sentenceFor(wrong).toStdString() << std::endl;
        return static_cast<int>(burin::ErrorClass::wrongUse);
    }
    return status;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::cerr << "Burin ran out of memory. Choose a larger voxel.\n";
        return static_cast<int>(burin::ErrorClass::outOfSpaceOrRights);
    } catch (const std::exception& fault) {
        std::cerr << "Internal error in Burin; report this: " << fault.what() << "\n";
        return static_cast<int>(burin::ErrorClass::badInput);
    }
}
