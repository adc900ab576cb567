// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/library_command.h"

#include "app/command.h"

namespace burin {

CommandParser registerLibrary(CommandParser program, CommandContext& context, int& status,
                              const LibraryCommand& library, std::shared_ptr<LibraryArguments> arguments) {
    const CommandParser command = program.command(library.name, library.about);
    command.requireCommand();
    addJsonFlag(command, context);
    const auto add = [&](const char* name, TextId help, LibraryCommand::Run run) {
        const CommandParser one = command.command(name, help);
        one.passOn();
        one.run([arguments, run, &context, &status] { status = run(*arguments, context); });
        return one;
    };
    const auto addId = [&](CommandParser to, TextId help) {
        to.positional(BURIN_TEXT("Argument", "ID"), arguments->id, help).required();
    };
    const auto addReplace = [&](CommandParser to) { to.flag("--replace", arguments->replace, library.replace); };
    add("list", library.list, library.runList);
    addId(add("show", library.show, library.runShow), library.item);
    const CommandParser added = add("add", library.add, library.runAdd);
    added.positional(BURIN_TEXT("Argument", "FILE"), arguments->file, library.addedFile).required();
    addReplace(added);
    const CommandParser copied = add("copy", library.copy, library.runCopy);
    addId(copied, library.copied);
    copied
        .positional(BURIN_TEXT("Argument", "NEW"), arguments->newId,
                    BURIN_TEXT("Help", "ID of the copy: letters, digits, '-', '_' and '.'"))
        .required();
    copied.option("--name", arguments->name, BURIN_TEXT("Help", "Name of the copy (default: its ID)"));
    addReplace(copied);
    addId(add("remove", library.remove, library.runRemove), library.item);
    return command;
}

} // namespace burin
