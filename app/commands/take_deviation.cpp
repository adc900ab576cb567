// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/take_deviation.h"

#include "app/chosen_setup.h"
#include "app/commands/take_command.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/document/companions.h"
#include "core/job/part_distance.h"
#include "core/job/recorded_time.h"
#include "core/job/take_deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace burin {

namespace {

struct TakeDeviationArguments {
    std::string project, output;
    std::int64_t take = 0;
};

struct MeasuredTake {
    TakeInfo info;
    std::vector<float> deviation; ///< mm, see takeDeviation
};

Result<MeasuredTake> measuredTake(const TakeDeviationArguments& arguments, CommandContext& context) {
    const std::array<std::filesystem::path, 1> inputs{arguments.project};
    if (!arguments.output.empty())
        if (Result<void> free = checkOutput("--output", arguments.output, inputs); !free) return free.error();
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Project> project = projectForReading(arguments.project, context);
    if (!project) return project.error();
    const Result<DeviationMatter> matter = deviationMatter(*project, arguments.take, context.progress());
    if (!matter) return matter.error();
    const Result<MeshDistance> part = partDistance(*project);
    if (!part) return part.error();
    context.stage(BURIN_TEXT("Command", "Measuring"));
    Result<std::vector<float>> deviation = takeDeviation(*matter, *part, context.progress());
    if (!deviation) return std::move(deviation).error();
    return MeasuredTake{matter->info, std::move(*deviation)};
}

/// A line for each value: the time of its first sample, s, and the value, mm.
std::string deviationCsv(const MeasuredTake& take) {
    std::string csv = "time_s,deviation_mm\n";
    for (std::size_t i = 0; i < take.deviation.size(); ++i) {
        const double time = static_cast<double>(i * TakeTrack::samplesPerBin) * take.info.tickPeriod;
        const auto value = static_cast<double>(take.deviation[i]);
        csv += formatFixed(time, 4) + "," + (std::isnan(value) ? "" : formatFixed(value, 4)) + "\n";
    }
    return csv;
}

int runTakeDeviation(const TakeDeviationArguments& arguments, CommandContext& context) {
    const Result<MeasuredTake> take = measuredTake(arguments, context);
    if (!take) return context.fail(take.error());
    std::vector<float> known = take->deviation;
    std::erase_if(known, [](float value) { return std::isnan(value); });
    nlohmann::json answer{{"take", take->info.id},
                          {"name", take->info.name},
                          {"values", take->deviation.size()},
                          {"least_mm", nullptr},
                          {"greatest_mm", nullptr}};
    const std::string id = std::to_string(take->info.id);
    std::string text =
        worded(BURIN_TEXT("Command", "take %1 %2: there is no part to measure to"), {id, take->info.name});
    if (!known.empty()) {
        const auto [least, greatest] = std::ranges::minmax(known);
        answer["least_mm"] = least;
        answer["greatest_mm"] = greatest;
        text = worded(BURIN_TEXT("Command", "take %1 %2: the tool is %3 to %4 mm from the part"),
                      {id, take->info.name, formatFixed(static_cast<double>(least), 4),
                       formatFixed(static_cast<double>(greatest), 4)});
    }
    if (!arguments.output.empty()) {
        if (const Result<void> written = writeFileAtomically(arguments.output, deviationCsv(*take)); !written)
            return context.fail(written.error());
        answer["csv"] = std::filesystem::absolute(arguments.output).lexically_normal().string();
    }
    context.answer(answer, text);
    return 0;
}

} // namespace

void addTakeDeviation(CommandParser take, CommandContext& context, int& status) {
    auto arguments = std::make_shared<TakeDeviationArguments>();
    const CommandParser deviation = addTakeCommand(
        take, "deviation",
        BURIN_TEXT("Help", "Measure the distance of its tool from the part over time, negative where the "
                           "tool is in the part; nothing is changed"),
        arguments->project, arguments->take);
    deviation.option("-o,--output", arguments->output,
                     BURIN_TEXT("Help", "Write time and least distance of every ten samples as CSV"));
    deviation.run([arguments, &context, &status] { status = runTakeDeviation(*arguments, context); });
}

} // namespace burin
