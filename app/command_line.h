// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace burin {

// How the command line is declared. Only command_line.cpp knows the library that parses it, and translates there what
// --help shows: every `TextId` is given in English, as BURIN_TEXT marks it. Main thread alone.

/// One option, flag or positional argument. A handle: copies mean the same argument, which its command owns.
class Argument {
public:
    explicit Argument(CLI::Option& option) : option_(&option) {}

    Argument required() const;
    /// --help shows the value that the variable has now as the default.
    Argument showDefault() const;
    /// Both limits are allowed.
    Argument range(double low, double high) const;
    Argument range(int low, int high) const;
    Argument choices(const std::vector<std::string>& names) const;
    /// @param allowed what is asked for where the text is blank
    Argument notBlank(TextId allowed) const;
    /// Of lists: one word may hold several values with this character between them.
    Argument separatedBy(char delimiter) const;
    /// Of lists: each use of the option takes one value.
    Argument oneAtATime() const;
    Argument excludes(Argument other) const;
    Argument needs(Argument other) const;
    /// What --help calls the value, instead of its type.
    Argument valueName(TextId name) const;

private:
    CLI::Option* option_;
};

/// The names of a map, for `Argument::choices`.
template <class T>
std::vector<std::string> keysOf(const std::map<std::string, T>& map) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : map) keys.push_back(key);
    return keys;
}

/// One command, or a command of a command. A handle, as `Argument` is; the `CommandLine` owns what it refers to.
class CommandParser {
public:
    explicit CommandParser(CLI::App& app) : app_(&app) {}

    CommandParser command(const char* name, TextId help) const;
    /// A command of this one has to be given.
    void requireCommand() const;
    /// At most one command of this one may be given.
    void allowOneCommand() const;
    bool commandGiven() const;
    /// What this command does not know is left to the one that it belongs to.
    void passOn() const;

    /// `value` has to outlive the parsing. T: std::string, double, int, std::int64_t, std::uint32_t, std::uint64_t,
    /// std::optional<double>, std::optional<std::string>, std::vector<std::string>, std::vector<std::int64_t>.
    /// @param names "-o,--output"
    template <class T>
    Argument option(const char* names, T& value, TextId help) const;
    /// As `option`, for an argument that is known by its position. @param name as --help and errors show it
    template <class T>
    Argument positional(TextId name, T& value, TextId help) const;
    /// @param take called with the value while parsing
    Argument option(const char* names, const std::function<void(const std::string&)>& take, TextId help) const;
    Argument flag(const char* names, bool& value, TextId help) const;
    /// Text below the help, translated already.
    void footer(const std::string& text) const;
    /// Called when the command was given, once all arguments are parsed.
    void run(const std::function<void()>& callback) const;

private:
    CLI::App* app_;
};

/// The whole command line. Make it once translations are installed: texts are translated as they are declared.
class CommandLine {
public:
    CommandLine();
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// Where the commands are added.
    CommandParser program() const;
    /// Of the commands, in the order in which they were added.
    std::vector<std::string> commandNames() const;
    /// Parses, and runs the command that was given. Prints help and version on standard output, and what is wrong as
    /// one sentence on standard error.
    /// @return exit status; nothing: a command was run
    std::optional<int> parse(int argc, char** argv) const;

private:
    std::unique_ptr<CLI::App> app_;
};

} // namespace burin
