// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/report.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/machine/machine_library.h"

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
        text +=
            (text.empty() ? "" : "\n") + id + std::string(id.size() < 20 ? 20 - id.size() : 1, ' ') +
            worded(isTypicalMachine(id) ? BURIN_TEXT("Command", "typical  %1") : BURIN_TEXT("Command", "own      %1"),
                   {resourceName(machine->name)});
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
    context.answer({{"removed", arguments.id}}, worded(BURIN_TEXT("Command", "%1: removed"), {arguments.id}));
    return 0;
}

} // namespace

void registerMachines(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<MachineArguments>();
    const CommandParser command = program.command(
        "machines",
        BURIN_TEXT("Help",
                   "List and show machines; copy, add and delete your own. The machines that Burin is shipped with "
                   "have typical values of their class: copy one and enter those of your machine"));
    command.requireCommand();
    addJsonFlag(command, context);
    const auto add = [&](const char* name, TextId help, int (*run)(const MachineArguments&, CommandContext&)) {
        const CommandParser one = command.command(name, help);
        one.passOn();
        one.run([arguments, run, &context, &status] { status = run(*arguments, context); });
        return one;
    };
    add("list", BURIN_TEXT("Help", "List all machines with their names; typical: shipped with Burin"),
        [](const MachineArguments&, CommandContext& to) { return runList(to); });
    const auto addReplace = [&](CommandParser to) {
        to.flag("--replace", arguments->replace, BURIN_TEXT("Help", "Replace your machine of this ID"));
    };
    add("show", BURIN_TEXT("Help", "Print the file of a machine (JSON), in the form that add reads"), &runShow)
        .positional(BURIN_TEXT("Argument", "ID"), arguments->id, BURIN_TEXT("Help", "Machine"))
        .required();
    const CommandParser added =
        add("add", BURIN_TEXT("Help", "Add a machine to your own; every value is checked"), &runAdd);
    added.positional(BURIN_TEXT("Argument", "FILE"), arguments->file, BURIN_TEXT("Help", "Machine file (JSON)"))
        .required();
    addReplace(added);
    const CommandParser copied = add("copy", BURIN_TEXT("Help", "Copy a machine to one of your own"), &runCopy);
    copied.positional(BURIN_TEXT("Argument", "ID"), arguments->id, BURIN_TEXT("Help", "Machine to copy")).required();
    copied
        .positional(BURIN_TEXT("Argument", "NEW"), arguments->newId,
                    BURIN_TEXT("Help", "ID of the copy: letters, digits, '-', '_' and '.'"))
        .required();
    copied.option("--name", arguments->name, BURIN_TEXT("Help", "Name of the copy (default: its ID)"));
    addReplace(copied);
    add("remove", BURIN_TEXT("Help", "Delete one of your own machines"), &runRemove)
        .positional(BURIN_TEXT("Argument", "ID"), arguments->id, BURIN_TEXT("Help", "Machine"))
        .required();
}

} // namespace burin
