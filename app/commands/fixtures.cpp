// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/setup/fixture_library.h"

#include <algorithm>

namespace burin {

namespace {

using nlohmann::json;

json jsonOf(const FixtureKindRow& row) {
    json parameters = json::array();
    for (const FixtureParameter& parameter : row.parameters)
        parameters.push_back({{"key", parameter.key},
                              {"label", parameter.label.text},
                              {"about", parameter.toolTip.text},
                              {"default_mm", parameter.standard},
                              {"range_mm", {parameter.range.low, parameter.range.high}},
                              {"source", parameter.source},
                              {"follows_stock", parameter.followsStock}});
    return {{"kind", row.id}, {"title", row.title.text}, {"about", row.toolTip.text}, {"parameters", parameters}};
}

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size() + 1, width), ' ');
    return text;
}

std::string textOf(const FixtureParameter& parameter) {
    const TextId form = parameter.followsStock
                            ? BURIN_TEXT("Command", "%1: %2 mm, or fitted to the stock (%3 to %4; %5)")
                            : BURIN_TEXT("Command", "%1: %2 mm (%3 to %4; %5)");
    return worded(form,
                  {worded(parameter.toolTip), formatShortest(parameter.standard), formatShortest(parameter.range.low),
                   formatShortest(parameter.range.high), worded({"Fixture", parameter.source})});
}

std::string textOf(const FixtureKindRow& row) {
    std::string text = padded(row.id, 20) + worded(row.title) + ". " + worded(row.toolTip) + ".";
    for (const FixtureParameter& parameter : row.parameters)
        text += "\n  " + padded(parameter.key, 18) + textOf(parameter);
    return text;
}

int runFixtures(CommandContext& context) {
    json kinds = json::array();
    std::string text;
    for (const FixtureKindRow& row : fixtureKinds) {
        kinds.push_back(jsonOf(row));
        text += (text.empty() ? "" : "\n") + textOf(row);
    }
    context.answer({{"fixtures", kinds}}, text);
    return 0;
}

} // namespace

void registerFixtures(CommandParser program, CommandContext& context, int& status) {
    const CommandParser command =
        program.command("fixtures", BURIN_TEXT("Help", "List the library of fixtures: kinds, sizes, their defaults and "
                                                       "ranges. Add one to a project with burin setup --add-fixture"));
    addJsonFlag(command, context);
    command.run([&context, &status] { status = runFixtures(context); });
}

} // namespace burin
