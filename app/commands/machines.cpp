// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/report.h"
#include "core/base/file.h"
#include "core/machine/machine_library.h"

#include <CLI/CLI.hpp>

namespace burin {

namespace {

using nlohmann::json;

struct MachineArguments {
    std::string id, file, newId, name;
    bool replace = false;
};

int runList(CommandContext& context) {
    json machines = json::array();
    std::string text;
    int status = 0;
    for (const std::string& id : machineIds()) {
        const Result<MachineProfile> machine = loadMachine(id);
        if (!machine) { // the others can be used all the same
            status = context.fail(machine.error());
            continue;
        }
        machines.push_back(jsonOf(*machine));
        text += (text.empty() ? "" : "\n") + id + std::string(id.size() < 20 ? 20 - id.size() : 1, ' ') +
                (isTypicalMachine(id) ? "typical  " : "own      ") + machine->name;
    }
    if (status == 0) context.answer({{"machines", machines}}, text);
    return status;
}

int runShow(const MachineArguments& arguments, CommandContext& context) {
    const Result<MachineProfile> machine = loadMachine(arguments.id);
    if (!machine) return context.fail(machine.error());
    std::string text = toJson(*machine);
    text.pop_back(); // the answer ends its line itself
    context.answer(json::parse(text), text);
    return 0;
}

int keep(const MachineProfile& machine, bool replace, CommandContext& context) {
    const Result<std::filesystem::path> file = saveMachine(machine, replace);
    if (!file) return context.fail(file.error());
    json answer = jsonOf(machine);
    answer["file"] = file->string();
    context.answer(answer, machine.id + ": " + file->string());
    return 0;
}

int runAdd(const MachineArguments& arguments, CommandContext& context) {
    const Result<std::string> text = readFile(arguments.file);
    if (!text) return context.fail(text.error());
    const Result<MachineProfile> machine = machineFromJson(*text, arguments.file);
    if (!machine) return context.fail(machine.error());
    return keep(*machine, arguments.replace, context);
}

int runCopy(const MachineArguments& arguments, CommandContext& context) {
    const Result<MachineProfile> machine = loadMachine(arguments.id);
    if (!machine) return context.fail(machine.error());
    return keep(copyOf(*machine, arguments.newId, arguments.name.empty() ? arguments.newId : arguments.name),
                arguments.replace, context);
}

int runRemove(const MachineArguments& arguments, CommandContext& context) {
    if (const Result<void> removed = removeMachine(arguments.id); !removed) return context.fail(removed.error());
    context.answer({{"removed", arguments.id}}, arguments.id + ": removed");
    return 0;
}

} // namespace

void registerMachines(CLI::App& program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<MachineArguments>();
    CLI::App* command = program.add_subcommand(
        "machines", "List and show machines; copy, add and delete your own. The machines that Burin is shipped with "
                    "have typical values of their class: copy one and enter those of your machine");
    command->require_subcommand(1);
    addJsonFlag(*command, context);
    const auto add = [&](const char* name, const char* help, int (*run)(const MachineArguments&, CommandContext&)) {
        CLI::App* one = command->add_subcommand(name, help)->fallthrough();
        one->callback([arguments, run, &context, &status] { status = run(*arguments, context); });
        return one;
    };
    add("list", "All machines, with their names; typical: shipped with Burin",
        [](const MachineArguments&, CommandContext& to) { return runList(to); });
    const auto addReplace = [&](CLI::App& to) {
        to.add_flag("--replace", arguments->replace, "Replace your machine of this ID");
    };
    add("show", "The machine's file (JSON), as add reads it", &runShow)
        ->add_option("ID", arguments->id, "Machine")
        ->required();
    CLI::App* added = add("add", "Add a machine to your own; every value is checked", &runAdd);
    added->add_option("FILE", arguments->file, "Machine file (JSON)")->required();
    addReplace(*added);
    CLI::App* copied = add("copy", "Copy a machine to one of your own", &runCopy);
    copied->add_option("ID", arguments->id, "Machine to copy")->required();
    copied->add_option("NEW", arguments->newId, "ID of the copy: letters, digits, '-', '_' and '.'")->required();
    copied->add_option("--name", arguments->name, "Name of the copy; without it its ID");
    addReplace(*copied);
    add("remove", "Delete one of your own machines", &runRemove)
        ->add_option("ID", arguments->id, "Machine")
        ->required();
}

} // namespace burin
