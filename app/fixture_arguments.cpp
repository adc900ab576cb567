// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/fixture_arguments.h"

#include "app/number_list.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/setup/fixture_library.h"
#include "core/setup/obstacle_motion.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace burin {

namespace {

constexpr const char *addOption = "--add-fixture", *changeOption = "--change-fixture";

/// What the user states about a fixture.
struct StatedFixture {
    std::optional<glm::dvec3> at, place; ///< a click, and the origin itself
    std::optional<double> turn;          ///< rad
    std::vector<std::pair<std::string, double>> values;
};

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words = partsOf(text, ' ');
    std::erase(words, std::string());
    return words;
}

std::string keysOf(FixtureKind kind) {
    std::string keys = "at, place, turn";
    for (const FixtureParameter& parameter : rowOf(kind).parameters) keys += std::string(", ") + parameter.key;
    return keys;
}

/// X,Y or X,Y,Z
std::optional<glm::dvec3> clickOf(const std::string& text) {
    if (const std::optional<std::vector<double>> plan = numbersOf(text, 2))
        return glm::dvec3((*plan)[0], (*plan)[1], 0.0);
    return vectorOf(text);
}

/// Takes one word, "KEY=VALUE".
Result<void> take(StatedFixture& stated, FixtureKind kind, const std::string& word, const char* option) {
    const std::size_t sign = word.find('=');
    const std::string key = word.substr(0, sign), value = sign == std::string::npos ? "" : word.substr(sign + 1);
    if (key == "at") {
        stated.at = clickOf(value);
        if (!stated.at) return wrongArgument(option, word, BURIN_TEXT("Command", "at=X,Y in mm"));
    } else if (key == "place") {
        stated.place = vectorOf(value);
        if (!stated.place) return wrongArgument(option, word, BURIN_TEXT("Command", "place=X,Y,Z in mm"));
    } else if (key == "turn") {
        const std::optional<double> angle = parseNumber(value);
        if (!angle) return wrongArgument(option, word, BURIN_TEXT("Command", "turn=DEGREES"));
        stated.turn = glm::radians(*angle);
    } else if (indexOf(kind, key)) {
        const std::optional<double> length = parseNumber(value);
        if (!length) return wrongArgument(option, word, BURIN_TEXT("Command", "a size and its length in mm: SIZE=MM"));
        stated.values.emplace_back(key, *length);
    } else {
        return Error{ErrorCode::nameUnknown, "size of a fixture", key, keysOf(kind)};
    }
    return {};
}

Result<StatedFixture> statedIn(std::span<const std::string> words, FixtureKind kind, const char* option) {
    StatedFixture stated;
    for (const std::string& word : words)
        if (Result<void> taken = take(stated, kind, word, option); !taken) return std::move(taken).error();
    return stated;
}

/// A click comes first: what is stated besides it replaces what the click sets.
void apply(FixtureDesign& design, const StatedFixture& stated, const FixtureSite& site) {
    std::set<std::string> given;
    for (const auto& [key, value] : stated.values) {
        setValue(design, key, value);
        given.insert(key);
    }
    if (stated.at) design = placedAt(std::move(design), given, site, *stated.at);
    if (stated.place) design.place = *stated.place;
    if (stated.turn) design.turn = *stated.turn;
}

Result<Obstacle> addedFixture(const std::string& text, const FixtureSite& site, double clearance) {
    const std::vector<std::string> words = wordsOf(text);
    std::string known;
    for (const FixtureKindRow& row : fixtureKinds) known += (known.empty() ? "" : ", ") + std::string(row.id);
    const std::string id = words.empty() ? "" : words.front();
    const std::optional<FixtureKind> kind = fixtureKindFromId(id);
    if (!kind) return Error{ErrorCode::nameUnknown, "kind of fixture", id, known};
    Result<StatedFixture> stated = statedIn(std::span(words).subspan(1), *kind, addOption);
    if (!stated) return std::move(stated).error();
    if (!stated->at) stated->at = firstPoint(*kind, site.stock.box());
    FixtureDesign design = standardFixture(*kind);
    apply(design, *stated, site);
    return fixtureOf(design, site.stock, worded(rowOf(*kind).title), clearance);
}

/// Moves an obstacle that is not of the library: "by", "place" for the lower corner of the box around it, "turn" about
/// Z through the middle of that box.
Result<void> moveObstacle(Obstacle& obstacle, std::span<const std::string> words) {
    for (const std::string& word : words) {
        const std::size_t sign = word.find('=');
        const std::string key = word.substr(0, sign), value = sign == std::string::npos ? "" : word.substr(sign + 1);
        const Box box = boundsOf(obstacle);
        Placement by;
        if (key == "turn") {
            const std::optional<double> angle = parseNumber(value);
            if (!angle) return wrongArgument(changeOption, word, BURIN_TEXT("Command", "turn=DEGREES"));
            by = turnedAbout({0.0, 0.0, 1.0}, glm::radians(*angle), box.centre());
        } else if (key == "by" || key == "place") {
            const std::optional<glm::dvec3> stated = vectorOf(value);
            if (!stated)
                return wrongArgument(changeOption, word,
                                     key == "by" ? BURIN_TEXT("Command", "by=X,Y,Z in mm")
                                                 : BURIN_TEXT("Command", "place=X,Y,Z in mm"));
            by = movedBy(key == "by" ? *stated : *stated - box.low);
        } else {
            return Error{ErrorCode::nameUnknown, "change of a fixture", key, "by, place, turn"};
        }
        Result<Obstacle> changed = moved(obstacle, by);
        if (!changed) return std::move(changed).error();
        obstacle = std::move(*changed);
        if (Result<void> usable = checkObstacle(obstacle); !usable) return usable;
    }
    return {};
}

/// "NAME: KEY=VALUE …"; of several names that fit, as one may contain a colon, the longest is meant.
Result<void> changeFixture(std::vector<Obstacle>& obstacles, const std::string& text, const FixtureSite& site) {
    auto found = obstacles.end();
    for (auto one = obstacles.begin(); one != obstacles.end(); ++one)
        if (text.starts_with(one->name + ":") && (found == obstacles.end() || one->name.size() > found->name.size()))
            found = one;
    if (found == obstacles.end()) {
        std::string known;
        for (const Obstacle& one : obstacles) known += (known.empty() ? "" : ", ") + one.name;
        return Error{ErrorCode::nameUnknown, "obstacle", text.substr(0, text.find(':')), known};
    }
    const std::vector<std::string> words = wordsOf(text.substr(found->name.size() + 1));
    if (!found->design) return moveObstacle(*found, words);
    const Result<StatedFixture> stated = statedIn(words, found->design->kind, changeOption);
    if (!stated) return stated.error();
    FixtureDesign design = *found->design;
    apply(design, *stated, site);
    Result<Obstacle> changed = fixtureOf(design, site.stock, found->name, found->margin);
    if (!changed) return std::move(changed).error();
    changed->on = found->on;
    changed->kind = found->kind;
    *found = std::move(*changed);
    return {};
}

} // namespace

void addFixtures(CommandParser command, FixtureArguments& arguments) {
    command
        .option(addOption, arguments.add,
                BURIN_TEXT("Help",
                           "Fixture of the library: its kind, then where it would be clicked on, and sizes: "
                           "\"step-clamp at=X,Y turn=DEGREES SIZE=MM\"; place=X,Y,Z moves its origin. Kinds and "
                           "sizes: burin fixtures; may be repeated"))
        .oneAtATime();
    command
        .option(changeOption, arguments.change,
                BURIN_TEXT("Help", "Change a fixture of the library: \"NAME: SIZE=MM\", with the same words; any other "
                                   "is moved: by=X,Y,Z, place=X,Y,Z (its lower corner), turn=DEGREES about Z through "
                                   "its middle; may be repeated"))
        .oneAtATime();
}

Result<void> changeFixtures(std::vector<Obstacle>& obstacles, const FixtureArguments& arguments,
                            const StockSolid& stock, double clearance) {
    std::vector<Obstacle> changed = obstacles;
    for (const std::string& text : arguments.change)
        if (Result<void> done = changeFixture(changed, text, siteOf(stock, changed)); !done) return done;
    for (const std::string& text : arguments.add) {
        Result<Obstacle> fixture = addedFixture(text, siteOf(stock, changed), clearance);
        if (!fixture) return std::move(fixture).error();
        changed = joined(std::move(changed), {std::move(*fixture)});
    }
    obstacles = std::move(changed);
    return {};
}

nlohmann::json jsonOf(const FixtureDesign& design) {
    const FixtureKindRow& row = rowOf(design.kind);
    nlohmann::json values = nlohmann::json::object();
    for (std::size_t i = 0; i < row.parameters.size(); ++i) values[row.parameters[i].key] = design.values[i];
    return {{"kind", row.id},
            {"values_mm", values},
            {"place_mm", jsonOf(design.place)},
            {"turn_deg", glm::degrees(design.turn)}};
}

} // namespace burin
