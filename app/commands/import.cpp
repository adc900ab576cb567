// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/import.h"
#include "app/command.h"
#include "app/report.h"

#include <CLI/CLI.hpp>

namespace burin {

namespace {

struct ImportArguments {
    std::string model;
    double chord = 0.005;
    double stlUnit = 1.0;
    double seconds = 120.0;
    double memory = 4096.0;
};

int runImport(const ImportArguments& arguments, CommandContext& context) {
    ImportOptions options;
    options.meshChord = arguments.chord;
    options.stlUnit = arguments.stlUnit;
    options.limits.waitSeconds *= arguments.seconds / options.limits.seconds;
    options.limits.seconds = arguments.seconds;
    options.limits.memoryBytes = static_cast<std::size_t>(arguments.memory * 1e6);
    context.stage("Importing");
    const Result<Model> model = importModel(arguments.model, options, context.progress());
    if (!model) return context.fail(model.error());
    context.answer(jsonOf(*model), textOf(*model));
    return 0;
}

} // namespace

void registerImport(CLI::App& program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<ImportArguments>();
    CLI::App* command = program.add_subcommand("import", "Read a CAD model and report what it holds");
    command->add_option("MODEL", arguments->model, "STEP, IGES, BREP or STL file")->required();
    command->add_option("--chord", arguments->chord, "Chord of the mesh, mm")
        ->check(CLI::Range(1e-4, 10.0))
        ->capture_default_str();
    command->add_option("--stl-unit", arguments->stlUnit, "Millimetres per unit of an STL file")
        ->check(CLI::Range(1e-6, 1e6))
        ->capture_default_str();
    command
        ->add_option("--seconds", arguments->seconds,
                     "Limit of the import's processor time, s; ten times as long if it waits")
        ->check(CLI::Range(0.1, 86400.0))
        ->capture_default_str();
    command->add_option("--memory", arguments->memory, "Memory limit of the import, MB")
        ->check(CLI::Range(64.0, 1e6))
        ->capture_default_str();
    addJsonFlag(*command, context);
    command->callback([arguments, &context, &status] { status = runImport(*arguments, context); });
}

} // namespace burin
