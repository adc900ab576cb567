// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/mill_options.h"

#include "app/surroundings.h"
#include "core/haptics/operator/virtual_operator.h"

#include <map>

namespace burin {

namespace {

/// The names, in the order used by --help.
const std::map<std::string, OperatorIntent> intents{{"contour", OperatorIntent::contour},
                                                    {"hostile", OperatorIntent::hostile},
                                                    {"passes", OperatorIntent::passes},
                                                    {"scribble", OperatorIntent::scribble}};

void addOperator(CommandParser command, MillArguments& arguments) {
    command.option("--seed", arguments.hand.seed, BURIN_TEXT("Help", "Seed of the operator's random tremor and motion"))
        .showDefault();
    command.option("--grip", arguments.grip, BURIN_TEXT("Help", "Firmness of the operator's grip on the stylus"))
        .choices({"light", "middle", "firm"})
        .showDefault();
    command.option("--intent", arguments.intent, BURIN_TEXT("Help", "Kind of strokes that the operator makes"))
        .choices(keysOf(intents))
        .showDefault();
}

} // namespace

void addMillOptions(CommandParser command, MillArguments& arguments) {
    command
        .positional(BURIN_TEXT("Argument", "PROJECT"), arguments.project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    command.option("--stylus", arguments.stylus, BURIN_TEXT("Help", "Stylus: operator, trace:FILE or device:NAME"))
        .showDefault();
    command.option("--mode", arguments.mode,
                   BURIN_TEXT("Help", "One of a device's modes, as \"burin devices\" lists them"));
    command
        .option("--rate", arguments.rate,
                BURIN_TEXT("Help", "Rate of the haptic loop, Hz; a device with its own clock sets its own rate"))
        .range(1000.0, 4000.0)
        .showDefault();
    command
        .option("--dead-man", arguments.deadMan,
                BURIN_TEXT("Help", "Forces only while this button of the device is held, counted from 1; 0: always"))
        .range(0, 32)
        .showDefault();
    command.option("--from", arguments.from,
                   BURIN_TEXT("Help", "Mill on from a moment (TAKE:SECONDS, or TAKE for its end); what was recorded "
                                      "after it is switched off (\"burin take on\" switches it on again)"));
    command.flag("--no-guides", arguments.noGuides, BURIN_TEXT("Help", "Ignore the project's guides (with a device)"));
    command.option(
        "--trace", arguments.trace,
        BURIN_TEXT("Help",
                   "Also write the motion of the trace or device to this file, which --stylus trace:FILE replays"));
    command.flag(
        "--override", arguments.overrides,
        BURIN_TEXT("Help",
                   "Mill even if bodies are too small for the voxels to be protected, and accept that the operator "
                   "reaches nothing"));
    command.option("--tool", arguments.tool, BURIN_TEXT("Help", "Tool (default: that of the trace, otherwise ball-6)"));
    command.option("--machine", arguments.machine,
                   BURIN_TEXT("Help", "Machine, for its spindle speed and travel (default: the project's)"));
    const Argument realtime = command.flag("--realtime", arguments.realtime, BURIN_TEXT("Help", "Run in real time"));
    command.flag("--fast", arguments.fast, BURIN_TEXT("Help", "Run as fast as the computer can (the default)"))
        .excludes(realtime);
    command
        .option("--seconds", arguments.seconds,
                BURIN_TEXT("Help", "Length of the session, s; 0: as long as the job takes"))
        .range(0.0, 1e6);
    command
        .option("--allowance", arguments.allowance,
                BURIN_TEXT("Help", "Stock to leave on the part, mm; the operator roughs with it (0.5)"))
        .range(0.0, 10.0);
    command
        .option("--press", arguments.hand.press,
                BURIN_TEXT("Help", "Depth to which the operator presses into the part when finishing, mm"))
        .range(0.0, 10.0)
        .showDefault();
    command
        .option("--step-over", arguments.hand.finishingStepOver,
                BURIN_TEXT("Help", "Distance between finishing passes, mm; 0: chosen for the tool"))
        .range(0.0, 100.0);
    command
        .option(
            "--felt", arguments.felt,
            BURIN_TEXT("Help",
                       "Share of the cutting force that is felt with a device, or was felt while a trace was recorded "
                       "that does not state it, 0 to 1"))
        .range(0.0, 1.0);
    command
        .option("--assist", arguments.assist,
                BURIN_TEXT("Help",
                           "Ceiling of a gamepad's vibration or a joystick's force, as a share of its strongest "
                           "effect, 0 to 1; 0: off"))
        .range(0.0, 1.0);
    command
        .option("--stock-distance", arguments.stockDistance,
                BURIN_TEXT("Help", "Distance that shank and holder keep from the stock, mm (default: they are stopped "
                                   "when they touch it)"))
        .range(StockLayer::distances.low, StockLayer::distances.high);
    addAxis(command, arguments.axis);
    addOperator(command, arguments);
}

HandImpedance gripOf(const MillArguments& arguments) {
    if (arguments.grip == "light") return lightHand;
    return arguments.grip == "middle" ? middleHand : firmHand;
}

OperatorIntent intentOf(const MillArguments& arguments) {
    return intents.at(arguments.intent);
}

} // namespace burin
