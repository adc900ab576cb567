// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command_line.h"

#include "app/parse_error.h"
#include "app/wording.h"
#include "core/base/error.h"

#include <CLI/CLI.hpp>

#include <array>
#include <iostream>
#include <sstream>

namespace burin {

namespace {

/// Words that the parser itself uses in --help.
constexpr std::array parserWords{
    BURIN_TEXT("Help", "Usage"),       BURIN_TEXT("Help", "OPTIONS"),  BURIN_TEXT("Help", "SUBCOMMAND"),
    BURIN_TEXT("Help", "SUBCOMMANDS"), BURIN_TEXT("Help", "Options"),  BURIN_TEXT("Help", "Positionals"),
    BURIN_TEXT("Help", "Subcommands"), BURIN_TEXT("Help", "REQUIRED"), BURIN_TEXT("Help", "Needs"),
    BURIN_TEXT("Help", "Excludes"),    BURIN_TEXT("Help", "TEXT"),     BURIN_TEXT("Help", "INT"),
    BURIN_TEXT("Help", "UINT"),        BURIN_TEXT("Help", "FLOAT"),
};

/// One of `parserWords` in the user's language; other text is unchanged.
std::string parserWord(const std::string& word) {
    for (const TextId& known : parserWords)
        if (word == known.text) return worded(known);
    return word;
}

class TranslatedFormatter : public CLI::Formatter {
public:
    TranslatedFormatter() {
        for (const TextId& word : parserWords) label(word.text, worded(word));
    }
    std::string make_group(std::string group, bool isPositional,
                           std::vector<const CLI::Option*> options) const override {
        return CLI::Formatter::make_group(parserWord(group), isPositional, std::move(options));
    }
};

/// Translates the type shown by --help.
CLI::Option& translated(CLI::Option& option) {
    option.type_name(parserWord(option.get_type_name()));
    return option;
}

template <class T>
std::string rangeText(const char* type, T low, T high) {
    const auto written = [](T value) {
        std::ostringstream text;
        text << value;
        return text.str();
    };
    return worded(BURIN_TEXT("Help", "%1 in [%2 - %3]"), {parserWord(type), written(low), written(high)});
}

} // namespace

Argument Argument::required() const {
    option_->required();
    return *this;
}

Argument Argument::showDefault() const {
    option_->capture_default_str();
    return *this;
}

Argument Argument::range(double low, double high) const {
    option_->check(CLI::Range(low, high).description(rangeText("FLOAT", low, high)));
    return *this;
}

Argument Argument::range(int low, int high) const {
    option_->check(CLI::Range(low, high).description(rangeText("INT", low, high)));
    return *this;
}

Argument Argument::choices(const std::vector<std::string>& names) const {
    option_->check(CLI::IsMember(names));
    return *this;
}

Argument Argument::notBlank(TextId allowed) const {
    option_->check([allowed](const std::string& text) {
        return text.find_first_not_of(" \t\n") == std::string::npos ? worded(allowed) : std::string();
    });
    return *this;
}

Argument Argument::separatedBy(char delimiter) const {
    option_->delimiter(delimiter);
    return *this;
}

Argument Argument::oneAtATime() const {
    option_->allow_extra_args(false);
    return *this;
}

Argument Argument::excludes(Argument other) const {
    option_->excludes(other.option_);
    return *this;
}

Argument Argument::needs(Argument other) const {
    option_->needs(other.option_);
    return *this;
}

Argument Argument::valueName(TextId name) const {
    option_->type_name(worded(name));
    return *this;
}

CommandParser CommandParser::command(const char* name, TextId help) const {
    CLI::App* const command = app_->add_subcommand(name, worded(help));
    command->group(worded(BURIN_TEXT("Help", "Subcommands")));
    return CommandParser(*command);
}

void CommandParser::requireCommand() const {
    app_->require_subcommand(1);
}

void CommandParser::allowOneCommand() const {
    app_->require_subcommand(0, 1);
}

bool CommandParser::commandGiven() const {
    return !app_->get_subcommands().empty();
}

void CommandParser::passOn() const {
    app_->fallthrough();
}

template <class T>
Argument CommandParser::option(const char* names, T& value, TextId help) const {
    return Argument(translated(*app_->add_option(names, value, worded(help))));
}

template Argument CommandParser::option(const char*, std::string&, TextId) const;
template Argument CommandParser::option(const char*, double&, TextId) const;
template Argument CommandParser::option(const char*, int&, TextId) const;
template Argument CommandParser::option(const char*, std::int64_t&, TextId) const;
template Argument CommandParser::option(const char*, std::uint32_t&, TextId) const;
template Argument CommandParser::option(const char*, std::uint64_t&, TextId) const;
template Argument CommandParser::option(const char*, std::optional<double>&, TextId) const;
template Argument CommandParser::option(const char*, std::optional<std::string>&, TextId) const;
template Argument CommandParser::option(const char*, std::vector<std::string>&, TextId) const;
template Argument CommandParser::option(const char*, std::vector<std::int64_t>&, TextId) const;

template <class T>
Argument CommandParser::positional(TextId name, T& value, TextId help) const {
    return option(worded(name).c_str(), value, help);
}

template Argument CommandParser::positional(TextId, std::string&, TextId) const;
template Argument CommandParser::positional(TextId, std::int64_t&, TextId) const;
template Argument CommandParser::positional(TextId, std::vector<std::string>&, TextId) const;

Argument CommandParser::option(const char* names, const std::function<void(const std::string&)>& take,
                               TextId help) const {
    return Argument(translated(*app_->add_option_function<std::string>(names, take, worded(help))));
}

Argument CommandParser::flag(const char* names, bool& value, TextId help) const {
    return Argument(*app_->add_flag(names, value, worded(help)));
}

void CommandParser::footer(const std::string& text) const {
    app_->footer(text);
}

void CommandParser::run(const std::function<void()>& callback) const {
    app_->callback(callback);
}

CommandLine::CommandLine()
    : app_(std::make_unique<CLI::App>(worded(BURIN_TEXT("Help", "Burin: milling tool paths authored by hand")),
                                      "burin")) {
    app_->formatter(std::make_shared<TranslatedFormatter>());
    app_->set_help_flag("-h,--help", worded(BURIN_TEXT("Help", "Print this help message and exit")));
    app_->set_version_flag("--version", BURIN_VERSION,
                           worded(BURIN_TEXT("Help", "Display program version information and exit")));
    app_->set_help_all_flag("--help-all", worded(BURIN_TEXT("Help", "Help for all commands")));
    app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

CommandParser CommandLine::program() const {
    return CommandParser(*app_);
}

std::vector<std::string> CommandLine::commandNames() const {
    std::vector<std::string> names;
    for (const CLI::App* command : app_->get_subcommands({})) names.push_back(command->get_name());
    return names;
}

std::optional<int> CommandLine::parse(int argc, char** argv) const {
    try {
        app_->parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        if (wrong.get_exit_code() == 0) return app_->exit(wrong, std::cout, std::cerr); // --help, --version
        std::cerr << sentenceFor(wrong.what()).toStdString() << std::endl;
        return static_cast<int>(ErrorClass::wrongUse);
    }
    return std::nullopt;
}

} // namespace burin
