// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "ui/messages/messages.h"

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include <array>
#include <exception>
#include <iostream>

namespace {

constexpr std::array commands{burin::registerImport, burin::registerEmbed,  burin::registerMill, burin::registerPath,
                              burin::registerPost,   burin::registerVerify, burin::registerInfo, burin::registerDemo};

int run(int argc, char** argv) {
    QCoreApplication application(argc, argv); // translations need it
    QCoreApplication::setApplicationName("Burin");
    burin::Messages::install(application);

    CLI::App program("Burin: milling tool paths authored by hand", "burin");
    program.set_version_flag("--version", BURIN_VERSION);
    program.require_subcommand(1);
    burin::CommandContext context;
    int status = 0;
    for (const burin::Register registerCommand : commands) registerCommand(program, context, status);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        const int code = program.exit(wrong, std::cout, std::cerr);
        return code == 0 ? 0 : static_cast<int>(burin::ErrorClass::wrongUse);
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
        std::cerr << "Burin came upon a fault of its own: " << fault.what() << "\n";
        return static_cast<int>(burin::ErrorClass::badInput);
    }
}
