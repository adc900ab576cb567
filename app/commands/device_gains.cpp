// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/device_gains.h"

#include "app/wording.h"
#include "core/base/units.h"
#include "core/device/device_registry.h"
#include "ui/dialogs/preferences.h"
#include "ui/panels/device_labels.h"

#include <QLocale>

#include <array>

namespace burin {

namespace {

using nlohmann::json;

constexpr double stiffestArgument = 20.0; // N/mm

const char* nameOf(GainBound bound) {
    constexpr std::array names{"device",  "rate",     "jitter",
                               "latency", "encoders", "ceiling"}; // in the order of GainBound
    return names[static_cast<std::size_t>(bound)];
}

json limitOf(double value) {
    return value < GainLimits::none ? json(value) : json(nullptr);
}

json jsonOf(const GainLimits& gains) {
    return {{"stiffness_n_per_m", limitOf(gains.stiffness)}, {"damping_n_s_per_m", limitOf(gains.damping)}};
}

json jsonOf(const SuggestedGains& gains) {
    return {{"stiffness_n_per_m", gains.stiffness}, {"damping_n_s_per_m", gains.damping},
            {"limited_by", nameOf(gains.bound)},    {"safety_margin", gainMargin},
            {"interval_p99_s", gains.hold},         {"jitter_s", gains.jitter},
            {"latency_s", gains.latency},           {"latency_measured", gains.latencyMeasured},
            {"position_step_mm", gains.step},       {"friction_n", gains.friction}};
}

Result<void> keepGains(const std::string& device, const KeptGains& gains) {
    const QString unwritten = UserSettings().setGains(device, gains);
    if (unwritten.isEmpty()) return {};
    return Error{ErrorCode::fileNotWritable, unwritten.toStdString(), {}, {}};
}

void addGainsInUse(const KeptGains& gains, json& answer, std::string& text) {
    answer["gains_in_use"] = jsonOf(gains.inForce());
    answer["gains_in_use"]["previous"] = jsonOf(gains.before);
    answer["gains_in_use"]["stiffness_ceiling_n_per_m"] = limitOf(gains.request.ceiling);
    text += (text.empty() ? "" : "\n") + gainsInUse(gains.inForce(), QLocale::c()).toStdString();
}

} // namespace

void addGainOptions(CommandParser command, GainArguments& arguments, Argument test) {
    const Argument keep = command
                              .flag("--keep-gains", arguments.keeps,
                                    BURIN_TEXT("Help", "Use the suggested gains for this device from now on, in the "
                                                       "window and with \"mill\""))
                              .needs(test);
    command
        .option("--stiffness-ceiling", arguments.ceiling,
                BURIN_TEXT("Help", "Never suggest a stiffness above this, N/mm; 0: no maximum of your own. Kept with "
                                   "--keep-gains"))
        .range(0.0, stiffestArgument)
        .needs(test);
    command
        .option("--friction", arguments.friction,
                BURIN_TEXT("Help", "Friction of the handle with the motors off, N, as a spring balance shows it; it "
                                   "limits the suggested stiffness. 0: not measured. Kept with --keep-gains"))
        .range(0.0, GainRequest::mostFriction)
        .needs(test);
    command
        .option("--previous-gains", arguments.restored,
                BURIN_TEXT("Help", "Use the gains of this device again that were in use before the last change"))
        .excludes(test)
        .excludes(keep);
}

Result<void> answerGains(const std::string& device, const StylusDescription& stylus, const TrialFigures& figures,
                         const GainArguments& arguments, json& answer, std::string& text) {
    KeptGains gains = UserSettings().gains(device);
    if (arguments.ceiling) {
        const double ceiling = millimetresPerMetre * *arguments.ceiling;
        gains.request.ceiling = ceiling >= GainLimits::softest ? ceiling : GainLimits::none;
    }
    if (arguments.friction) gains.request.friction = *arguments.friction;
    const std::optional<SuggestedGains> suggested = suggestGains(stylus, figures, gains.request);
    answer["suggested_gains"] = suggested ? jsonOf(*suggested) : json(nullptr);
    if (suggested) text += "\n" + gainLines(*suggested, QLocale::c()).join(QLatin1Char('\n')).toStdString();
    if (!arguments.keeps) {
        if (stylus.hasMotors()) addGainsInUse(UserSettings().gains(device), answer, text);
        return {};
    }
    if (!suggested)
        return Error{ErrorCode::argumentInvalid, "--keep-gains", device,
                     worded(BURIN_TEXT("Command", "a device with motors, and a test of 200 readings or more"))};
    gains.use(suggested->limits());
    if (Result<void> kept = keepGains(device, gains); !kept) return kept;
    addGainsInUse(gains, answer, text);
    return {};
}

int restoreGains(const GainArguments& arguments, CommandContext& context) {
    DeviceRegistry registry;
    const Result<FoundDevice> device = registry.find(arguments.restored);
    if (!device) return context.fail(device.error());
    KeptGains gains = UserSettings().gains(device->id);
    gains.restore();
    if (const Result<void> kept = keepGains(device->id, gains); !kept) return context.fail(kept.error());
    json answer{{"device", device->id}};
    std::string text;
    addGainsInUse(gains, answer, text);
    context.answer(answer, text);
    return 0;
}

} // namespace burin
