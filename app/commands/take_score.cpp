// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/take_score.h"

#include "app/chosen_setup.h"
#include "app/commands/take_command.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/job/take_score.h"

#include <limits>
#include <utility>

namespace burin {

namespace {

constexpr std::int64_t noTake = std::numeric_limits<std::int64_t>::min();

struct TakeScoreArguments {
    std::string project;
    std::int64_t take = 0;
    std::int64_t reference = noTake;
};

/// Returns the score of the take, then that of its reference, if any.
Result<std::vector<TakeScore>> scoresOf(const TakeScoreArguments& arguments, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return project.error();
    const auto reference = arguments.reference == noTake ? std::nullopt : std::optional(arguments.reference);
    Result<std::vector<ScoreMatter>> matters = scoreMatters(*project, arguments.take, reference, context.progress());
    if (!matters) return std::move(matters).error();
    const Result<MillingContext> milling =
        makeMillingContext(*project, matters->front().tool, machineFor(*project, {}, context), context.progress());
    if (!milling) return milling.error();
    context.stage(BURIN_TEXT("Command", "Scoring"));
    return takeScores(std::move(*matters), *milling, context.progress());
}

nlohmann::json scoreJson(const TakeScore& score) {
    nlohmann::json object{{"take", score.take}, {"name", score.name}};
    for (const ScoreValue value : allScoreValues) {
        nlohmann::json& entry = object[std::string(keyOf(value))];
        if (const std::optional<double>& number = score[value]; value == ScoreValue::gougeTries && number)
            entry = static_cast<std::int64_t>(*number);
        else if (number)
            entry = *number;
    }
    return object;
}

const char* idOf(ScoreVerdict::Kind kind) {
    switch (kind) {
    case ScoreVerdict::Kind::none:
        break;
    case ScoreVerdict::Kind::same:
        return "same";
    case ScoreVerdict::Kind::better:
        return "better";
    case ScoreVerdict::Kind::worse:
        return "worse";
    }
    return "none";
}

nlohmann::json scoreJson(const std::vector<TakeScore>& scores) {
    nlohmann::json object{{"score", scoreJson(scores.front())}, {"reference", nullptr}, {"comparison", nullptr}};
    if (scores.size() == 1) return object;
    object["reference"] = scoreJson(scores.back());
    for (const ScoreValue value : allScoreValues) {
        const ScoreVerdict verdict = verdictOf(value, scores.front(), scores.back());
        nlohmann::json& entry = object["comparison"][std::string(keyOf(value))];
        entry = {{"verdict", idOf(verdict.kind)}, {"difference", nullptr}, {"ratio", nullptr}};
        if (verdict.kind != ScoreVerdict::Kind::none) entry["difference"] = verdict.difference;
        if (verdict.ratio) entry["ratio"] = *verdict.ratio;
    }
    return object;
}

/// "12.300 s"; "–" for an empty value.
std::string amountText(ScoreValue value, const std::optional<double>& number) {
    if (!number) return "–";
    const std::string text = formatFixed(*number, value == ScoreValue::gougeTries ? 0 : 3);
    return unitOf(value).empty() ? text : text + " " + std::string(unitOf(value));
}

std::string verdictText(ScoreValue value, const ScoreVerdict& verdict) {
    const std::string difference = amountText(value, verdict.difference);
    switch (verdict.kind) {
    case ScoreVerdict::Kind::none:
        break;
    case ScoreVerdict::Kind::same:
        return worded(BURIN_TEXT("Command", "the same"));
    case ScoreVerdict::Kind::better:
        return worded(BURIN_TEXT("Command", "better by %1"), {difference});
    case ScoreVerdict::Kind::worse:
        return worded(BURIN_TEXT("Command", "worse by %1"), {difference});
    }
    return worded(BURIN_TEXT("Command", "not comparable"));
}

/// Returns a line for each value.
std::string scoreText(const std::vector<TakeScore>& scores) {
    const TakeScore &take = scores.front(), &reference = scores.back();
    const std::string number = std::to_string(take.take);
    const bool compared = scores.size() > 1;
    std::string text = compared ? worded(BURIN_TEXT("Command", "take %1 %2, compared with take %3 %4"),
                                         {number, take.name, std::to_string(reference.take), reference.name})
                                : worded(BURIN_TEXT("Command", "take %1 %2"), {number, take.name});
    for (const ScoreValue value : allScoreValues) {
        const std::string title = worded(titleOf(value)), own = amountText(value, take[value]);
        text += "\n  ";
        if (!compared) {
            text += worded(BURIN_TEXT("Command", "%1: %2"), {title, own});
            continue;
        }
        const ScoreVerdict verdict = verdictOf(value, take, reference);
        text += worded(BURIN_TEXT("Command", "%1: %2, reference %3, ratio %4: %5"),
                       {title, own, amountText(value, reference[value]),
                        verdict.ratio ? formatFixed(*verdict.ratio, 3) : "–", verdictText(value, verdict)});
    }
    return text;
}

int runTakeScore(const TakeScoreArguments& arguments, CommandContext& context) {
    const Result<std::vector<TakeScore>> scores = scoresOf(arguments, context);
    if (!scores) return context.fail(scores.error());
    context.answer(scoreJson(*scores), scoreText(*scores));
    return 0;
}

} // namespace

void addTakeScore(CommandParser take, CommandContext& context, int& status) {
    auto arguments = std::make_shared<TakeScoreArguments>();
    const CommandParser score = addTakeCommand(
        take, "score",
        BURIN_TEXT("Help", "State how well it was milled: times, tries to gouge, smoothness, force, removal "
                           "and stock left, compared with a reference; nothing is changed"),
        arguments->project, arguments->take);
    score.option("--reference", arguments->reference,
                 BURIN_TEXT("Help", "Take to compare it with, by its number; it may be switched off"));
    score.run([arguments, &context, &status] { status = runTakeScore(*arguments, context); });
}

} // namespace burin
