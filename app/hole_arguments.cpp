// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/hole_arguments.h"

#include "app/number_list.h"
#include "app/wording.h"
#include "core/base/units.h"
#include "core/cad/part_holes.h"
#include "core/passes/thread_size.h"

#include <optional>

namespace burin {

namespace {

/// @param texts points in plan, or numbers of holes (or studs) in the order of "info --json"
Result<void> addPlaces(const std::vector<std::string>& texts, bool studs, const Model& part, PassRequest& request) {
    std::optional<std::vector<UprightHole>> holes;
    for (const std::string& text : texts) {
        if (const std::optional<std::vector<double>> place = numbersOf(text, 2)) {
            request.places.emplace_back(place->front(), place->back());
            continue;
        }
        if (!holes) holes = studs ? uprightStuds(part) : uprightHoles(part);
        const std::optional<std::size_t> index = indexOfNumber(text, holes->size());
        if (!index)
            return Error{ErrorCode::argumentInvalid, studs ? "--stud" : "--hole", text,
                         worded(studs
                                    ? BURIN_TEXT("Command", "X,Y in mm, or the number of a stud of the part, 1 to %1")
                                    : BURIN_TEXT("Command", "X,Y in mm, or the number of a hole of the part, 1 to %1"),
                                {std::to_string(holes->size())})};
        request.places.push_back((*holes)[*index].centre);
    }
    return {};
}

} // namespace

void addHoleOptions(CommandParser command, const Argument& pass, HoleArguments& arguments, PassRequest& request) {
    const auto withPass = [&](const Argument& argument) { return argument.needs(pass); };
    const Argument hole = withPass(
        command
            .option("--hole", arguments.holes,
                    BURIN_TEXT("Help", "drill, thread: a hole at X,Y, mm, or by its number in \"info --json\"; can "
                                       "be given several times (default: every upright hole of the part that fits "
                                       "the drill, or has the diameter of the thread)"))
            .oneAtATime());
    withPass(
        command
            .option("--stud", arguments.studs,
                    BURIN_TEXT("Help", "thread: an external thread on the stud at X,Y, mm, or by its number in \"info "
                                       "--json\"; can be given several times"))
            .oneAtATime())
        .excludes(hole);
    withPass(command.flag("--external", request.external,
                          BURIN_TEXT("Help", "thread: on studs of the part instead of in its holes (default: every "
                                             "upright stud that has the minor diameter of the thread)")))
        .excludes(hole);
    const Argument thread =
        withPass(command.option("--thread", arguments.thread,
                                BURIN_TEXT("Help", "thread: a metric size, M3 to M24 or diameter and pitch, M8x1; the "
                                                   "part's holes must be modelled with this diameter, its studs with "
                                                   "the minor diameter that the mill cuts")));
    const Argument pitch =
        withPass(command.option("--pitch", request.pitch, BURIN_TEXT("Help", "thread: pitch, mm"))).excludes(thread);
    withPass(command
                 .option("--tpi", arguments.threadsPerInch,
                         BURIN_TEXT("Help", "thread: instead of --pitch: threads per inch"))
                 .range(1.0, 100.0))
        .excludes(thread)
        .excludes(pitch);
    withPass(
        command.option("--major-diameter", request.majorDiameter,
                       BURIN_TEXT("Help", "thread: major diameter, mm (default: as each --hole or --stud has it)")))
        .excludes(thread);
    withPass(
        command
            .option("--radial-passes", request.radialPasses,
                    BURIN_TEXT("Help", "thread: number of passes along the thread, each deeper than the one before"))
            .range(1, mostRadialPasses));
    withPass(command.flag("--spring-pass", request.springPass, BURIN_TEXT("Help", "thread: once more at full depth")));
    withPass(command.flag("--left-hand", request.leftHand, BURIN_TEXT("Help", "thread: left-handed")));
    withPass(command.flag("--conventional", request.conventional,
                          BURIN_TEXT("Help", "thread: conventional instead of climb milling")));
}

Result<void> addHoles(const HoleArguments& arguments, const Model& part, PassRequest& request) {
    if (arguments.threadsPerInch > 0.0) request.pitch = millimetresPerInch / arguments.threadsPerInch;
    if (!arguments.thread.empty()) {
        const Result<ThreadSize> size = threadSizeNamed(arguments.thread);
        if (!size) return size.error();
        request.pitch = size->pitch;
        request.majorDiameter = size->diameter;
    }
    if (arguments.studs.empty()) return addPlaces(arguments.holes, false, part, request);
    request.external = true;
    return addPlaces(arguments.studs, true, part, request);
}

} // namespace burin
