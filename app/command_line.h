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

// Declaration of the command line. Only command_line.cpp depends on the parser library and translates the texts shown
// by --help: every `TextId` is given in English, as marked by BURIN_TEXT. Main thread only.

/// One option, flag or positional argument. A handle: copies refer to the same argument, which is owned by its command.
class Argument {
public:
    explicit Argument(CLI::Option& option) : option_(&option) {}

    Argument required() const;
    /// Makes --help show the present value of the variable as the default.
    Argument showDefault() const;
    /// Limits the value; both limits are allowed.
    Argument range(double low, double high) const;
    Argument range(int low, int high) const;
    Argument choices(const std::vector<std::string>& names) const;
    /// @param allowed what the error asks for if the text is blank
    Argument notBlank(TextId allowed) const;
    /// For lists: one word may contain several values, separated by this character.
    Argument separatedBy(char delimiter) const;
    /// For lists: each use of the option takes one value.
    Argument oneAtATime() const;
    Argument excludes(Argument other) const;
    Argument needs(Argument other) const;
    /// The name of the value in --help, instead of its type.
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

/// A command or a subcommand. A handle, like `Argument`; the `CommandLine` owns the object that it refers to.
class CommandParser {
public:
    explicit CommandParser(CLI::App& app) : app_(&app) {}

    CommandParser command(const char* name, TextId help) const;
    /// A subcommand is required.
    void requireCommand() const;
    /// At most one subcommand may be given.
    void allowOneCommand() const;
    bool commandGiven() const;
    /// Passes unknown arguments on to the parent command.
    void passOn() const;

    /// `value` has to outlive the parsing. T: std::string, double, int, std::int64_t, std::uint32_t, std::uint64_t,
    /// std::optional<double>, std::optional<std::string>, std::vector<std::string>, std::vector<std::int64_t>.
    /// @param names "-o,--output"
    template <class T>
    Argument option(const char* names, T& value, TextId help) const;
    /// As `option`, for a positional argument. @param name as shown by --help and errors
    template <class T>
    Argument positional(TextId name, T& value, TextId help) const;
    /// @param take called with the value while parsing
    Argument option(const char* names, const std::function<void(const std::string&)>& take, TextId help) const;
    Argument flag(const char* names, bool& value, TextId help) const;
    /// Text below the help, already translated.
    void footer(const std::string& text) const;
    /// Called after parsing all arguments, if the command was given.
    void run(const std::function<void()>& callback) const;

private:
    CLI::App* app_;
};

/// The whole command line. Create it after installing translations: texts are translated when they are declared.
class CommandLine {
public:
    CommandLine();
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// The root, to which commands are added.
    CommandParser program() const;
    /// Names of the commands, in the order in which they were added.
    std::vector<std::string> commandNames() const;
    /// Parses, and runs the command that was given. Prints help and version on standard output, and errors as one
    /// sentence on standard error.
    /// @return exit status; empty if a command was run
    std::optional<int> parse(int argc, char** argv) const;

private:
    std::unique_ptr<CLI::App> app_;
};

} // namespace burin
