// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/device_labels.h"

#include "ui/messages/messages.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr double milliseconds = 1e3, percent = 100.0;

QString words(const char* text) {
    return QCoreApplication::translate("DeviceLabels", text);
}

template <UnitName unit>
DeviceLimit row(const char* name, TextId label, const Figure<unit>& figure) {
    return {name, label, std::string(Figure<unit>::unit), figure.value, figure.source};
}

QString pressed(std::uint32_t buttons) {
    QStringList numbers;
    for (unsigned int i = 0; i < 32; ++i)
        if ((buttons >> i & 1U) != 0) numbers << QString::number(i + 1);
    return numbers.isEmpty() ? words(QT_TRANSLATE_NOOP("DeviceLabels", "none")) : numbers.join(QStringLiteral(", "));
}

constexpr std::array motionNames{BURIN_TEXT("DeviceLabels", "nothing"),    BURIN_TEXT("DeviceLabels", "X, right"),
                                 BURIN_TEXT("DeviceLabels", "Y, away"),    BURIN_TEXT("DeviceLabels", "Z, up"),
                                 BURIN_TEXT("DeviceLabels", "A, about X"), BURIN_TEXT("DeviceLabels", "B, about Y"),
                                 BURIN_TEXT("DeviceLabels", "C, about Z")}; // in the order of AxisMotion
constexpr std::array actionNames{BURIN_TEXT("DeviceLabels", "nothing"),     BURIN_TEXT("DeviceLabels", "mill"),
                                 BURIN_TEXT("DeviceLabels", "lift"),        BURIN_TEXT("DeviceLabels", "undo"),
                                 BURIN_TEXT("DeviceLabels", "redo"),        BURIN_TEXT("DeviceLabels", "clutch"),
                                 BURIN_TEXT("DeviceLabels", "recentre"),    BURIN_TEXT("DeviceLabels", "level above"),
                                 BURIN_TEXT("DeviceLabels", "level below"), BURIN_TEXT("DeviceLabels", "nearest edge"),
                                 BURIN_TEXT("DeviceLabels", "fit the view")}; // in the order of ButtonAction

/// Empty if the device does not assist.
QStringList assistLines(const AssistAbilities& assist) {
    QStringList lines;
    if (assist.rumble) lines << words(QT_TRANSLATE_NOOP("DeviceLabels", "assist: vibrates"));
    if (assist.forceAxes == 1)
        lines << words(
            QT_TRANSLATE_NOOP("DeviceLabels", "assist: pushes 1 axis of its stick, too weakly to hold the hand"));
    if (assist.forceAxes > 1)
        lines << words(QT_TRANSLATE_NOOP("DeviceLabels",
                                         "assist: pushes %1 axes of its stick, too weakly to hold the hand"))
                     .arg(assist.forceAxes);
    if (!lines.isEmpty() && !assist.permitted)
        lines << words(QT_TRANSLATE_NOOP("DeviceLabels",
                                         "assist: off, as you have no permission to write to the device; "
                                         "install Burin's udev rule and plug it in again"));
    return lines;
}

QString percentText(double share, const QLocale& locale) {
    return locale.toString(percent * share, 'f', 1);
}

QString lineOf(std::size_t number, const DeviceAxis& axis, const AxisUse& use, const QLocale& locale) {
    const QString name = QStringLiteral("%1 %2").arg(number).arg(Messages::text({"Device", axis.name.c_str()}));
    if (use.motion == AxisMotion::none) return QStringLiteral("%1: %2").arg(name, motionName(use.motion));
    const QString line =
        use.reversed
            ? words(QT_TRANSLATE_NOOP("DeviceLabels",
                                      "%1: %2, reversed; gain %3; dead zone %4 %; range %5 to %7 %, rest %6 %"))
            : words(QT_TRANSLATE_NOOP("DeviceLabels", "%1: %2; gain %3; dead zone %4 %; range %5 to %7 %, rest %6 %"));
    return line.arg(name, motionName(use.motion), locale.toString(use.gain, 'f', 2), percentText(use.deadZone, locale),
                    percentText(use.low, locale), percentText(use.rest, locale), percentText(use.high, locale));
}

} // namespace

QString motionName(AxisMotion motion) {
    return Messages::text(motionNames[static_cast<std::size_t>(motion)]);
}

QString actionName(ButtonAction action) {
    return Messages::text(actionNames[static_cast<std::size_t>(action)]);
}

QStringList axisLines(const MappableDevice& device, const AxisMap& map, const QLocale& locale) {
    QStringList lines;
    for (std::size_t i = 0; i < device.axes.size(); ++i) lines << lineOf(i + 1, device.axes[i], map.axes[i], locale);
    for (std::size_t i = 0; i < device.buttons; ++i)
        if (map.buttons[i] != ButtonAction::none)
            lines
                << words(QT_TRANSLATE_NOOP("DeviceLabels", "button %1: %2")).arg(i + 1).arg(actionName(map.buttons[i]));
    return lines;
}

std::vector<DeviceLimit> limitsOf(const StylusDescription& stylus) {
    std::vector<DeviceLimit> limits{
        row("rate_hz", BURIN_TEXT("DeviceLabels", "rate"), stylus.rate),
        row("delay_s", BURIN_TEXT("DeviceLabels", "delay"), stylus.delay),
        row("force_max_n", BURIN_TEXT("DeviceLabels", "maximum force"), stylus.maximumForce),
        row("force_continuous_n", BURIN_TEXT("DeviceLabels", "continuous force"), stylus.continuousForce),
        row("torque_max_n_mm", BURIN_TEXT("DeviceLabels", "maximum torque"), stylus.maximumTorque),
        row("stiffness_max_n_per_m", BURIN_TEXT("DeviceLabels", "maximum stiffness"), stylus.maximumStiffness),
        row("damping_max_n_s_per_m", BURIN_TEXT("DeviceLabels", "maximum damping"), stylus.maximumDamping),
        row("turning_stiffness_max_n_mm_per_rad", BURIN_TEXT("DeviceLabels", "maximum rotational stiffness"),
            stylus.maximumTurningStiffness),
        row("workspace_radius_mm", BURIN_TEXT("DeviceLabels", "workspace radius"), stylus.workspaceRadius),
        row("position_step_mm", BURIN_TEXT("DeviceLabels", "position step"), stylus.positionStep),
        row("rotation_step_rad", BURIN_TEXT("DeviceLabels", "rotation step"), stylus.rotationStep),
        row("speed_max_mm_per_s", BURIN_TEXT("DeviceLabels", "maximum speed"), stylus.maximumSpeed),
        row("handle_mass_kg", BURIN_TEXT("DeviceLabels", "mass of the handle"), stylus.handleMass)};
    std::erase_if(limits, [](const DeviceLimit& limit) { return limit.value <= 0.0; });
    return limits;
}

QStringList limitLines(const StylusDescription& stylus, const QLocale& locale) {
    QLocale plain = locale;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    QStringList lines;
    lines << words(QT_TRANSLATE_NOOP("DeviceLabels", "axes: %1 sensed, %2 driven; buttons: %3"))
                 .arg(stylus.sensed.translations + stylus.sensed.rotations)
                 .arg(stylus.actuated.translations + stylus.actuated.rotations)
                 .arg(stylus.buttons);
    for (const DeviceLimit& limit : limitsOf(stylus))
        lines << QStringLiteral("%1 %2 %3 (%4)")
                     .arg(Messages::text(limit.label), plain.toString(limit.value, 'g', QLocale::FloatingPointShortest),
                          QString::fromStdString(limit.unit), Messages::text({"Device", limit.source.c_str()}));
    return lines + assistLines(stylus.assist);
}

QStringList trialLines(const TrialFigures& figures, const QLocale& locale) {
    const auto number = [&locale](double value, int digits) { return locale.toString(value, 'f', digits); };
    const glm::dvec3 span = figures.highest - figures.lowest;
    QStringList lines;
    lines << words(QT_TRANSLATE_NOOP("DeviceLabels", "Rate: %1 Hz; interval: median %2 ms, maximum %3 ms"))
                 .arg(number(figures.rate, 0), number(milliseconds * figures.medianInterval, 2),
                      number(milliseconds * figures.maximumInterval, 1))
          << words(QT_TRANSLATE_NOOP("DeviceLabels", "Position: X %1, Y %2, Z %3 mm"))
                 .arg(number(figures.position.x, 1), number(figures.position.y, 1), number(figures.position.z, 1))
          << words(QT_TRANSLATE_NOOP("DeviceLabels", "Motion: %1 × %2 × %3 mm; smallest step %4 mm"))
                 .arg(number(span.x, 1), number(span.y, 1), number(span.z, 1), number(figures.smallestStep, 4))
          << words(QT_TRANSLATE_NOOP("DeviceLabels", "Rotation: %1°"))
                 .arg(number(glm::degrees(figures.maximumRotation), 0))
          << words(QT_TRANSLATE_NOOP("DeviceLabels", "Buttons pressed: %1")).arg(pressed(figures.buttons))
          << words(QT_TRANSLATE_NOOP("DeviceLabels", "Maximum force commanded: %1 N"))
                 .arg(number(figures.maximumForce, 2));
    if (figures.usualInterval > 0.0)
        lines.insert(1, words(QT_TRANSLATE_NOOP("DeviceLabels", "99 of 100 intervals are shorter than %1 ms"))
                            .arg(number(milliseconds * figures.usualInterval, 2)));
    if (figures.latency > 0.0)
        lines.insert(2, words(QT_TRANSLATE_NOOP("DeviceLabels", "Latency from reading to force: at most %1 ms"))
                            .arg(number(milliseconds * figures.latency, 2)));
    if (figures.maximumAssist > 0.0)
        lines << words(QT_TRANSLATE_NOOP("DeviceLabels", "Maximum strength commanded: %1 %"))
                     .arg(number(percent * figures.maximumAssist, 0));
    if (figures.health.motorHeat)
        lines << words(QT_TRANSLATE_NOOP("DeviceLabels", "Motor temperature: %1 % of the limit"))
                     .arg(number(percent * *figures.health.motorHeat, 0));
    if (figures.health.batteryShare)
        lines << words(QT_TRANSLATE_NOOP("DeviceLabels", "Battery: %1 %"))
                     .arg(number(percent * *figures.health.batteryShare, 0));
    if (figures.invalid > 0)
        lines << words(QT_TRANSLATE_NOOP("DeviceLabels", "Invalid readings: %1")).arg(figures.invalid);
    for (const Error& fault : figures.faults) lines << Messages::sentence(fault);
    return lines;
}

namespace {

constexpr double newtonsPerMetre = 1e3; // in N/mm

/// Stiffness that steps of the encoders permit, etc.: a sentence each, so that none is put together from parts.
QString stiffnessLine(const SuggestedGains& gains, const QLocale& locale) {
    const auto number = [&locale](double value, int digits) { return locale.toString(value, 'f', digits); };
    const auto line = [&](const char* text) { return words(text).arg(number(gains.stiffness / newtonsPerMetre, 3)); };
    switch (gains.bound) {
    case GainBound::rate:
        return line(
                   QT_TRANSLATE_NOOP("DeviceLabels", "Suggested stiffness: %1 N/mm, limited by %2 ms between readings"))
            .arg(number(milliseconds * gains.hold, 2));
    case GainBound::jitter:
        return line(QT_TRANSLATE_NOOP("DeviceLabels",
                                      "Suggested stiffness: %1 N/mm, limited by readings up to %2 ms late"))
            .arg(number(milliseconds * gains.jitter, 2));
    case GainBound::latency:
        return line(QT_TRANSLATE_NOOP("DeviceLabels", "Suggested stiffness: %1 N/mm, limited by %2 ms latency"))
            .arg(number(milliseconds * gains.latency, 2));
    case GainBound::encoders:
        return line(QT_TRANSLATE_NOOP("DeviceLabels",
                                      "Suggested stiffness: %1 N/mm, limited by steps of %2 mm at %3 N of friction"))
            .arg(number(gains.step, 4), number(gains.friction, 3));
    case GainBound::ceiling:
        return line(QT_TRANSLATE_NOOP("DeviceLabels", "Suggested stiffness: %1 N/mm, limited by your own maximum"));
    case GainBound::device:
        break;
    }
    return line(QT_TRANSLATE_NOOP("DeviceLabels", "Suggested stiffness: %1 N/mm, limited by the device itself"));
}

} // namespace

QStringList gainLines(const SuggestedGains& gains, const QLocale& locale) {
    QStringList lines;
    lines << stiffnessLine(gains, locale)
          << words(QT_TRANSLATE_NOOP("DeviceLabels", "Suggested damping: %1 N·s/m"))
                 .arg(locale.toString(gains.damping, 'f', 2))
          << words(QT_TRANSLATE_NOOP("DeviceLabels",
                                     "Safety margin: %1 % below what is stable for a handle that nobody holds"))
                 .arg(locale.toString(percent * gainMargin, 'f', 0));
    if (!gains.latencyMeasured)
        lines << (gains.latency > 0.0
                      ? words(QT_TRANSLATE_NOOP("DeviceLabels", "Latency: %1 ms, as the device states; not measured"))
                            .arg(locale.toString(milliseconds * gains.latency, 'f', 2))
                      : words(QT_TRANSLATE_NOOP("DeviceLabels",
                                                "Latency: unknown, as the device neither states nor reports it")));
    return lines;
}

QString gainsInUse(const GainLimits& gains, const QLocale& locale) {
    const auto number = [&locale](double value, int digits) { return locale.toString(value, 'f', digits); };
    const bool stiffness = gains.stiffness < GainLimits::none, damping = gains.damping < GainLimits::none;
    if (stiffness && damping)
        return words(QT_TRANSLATE_NOOP("DeviceLabels", "In use: stiffness up to %1 N/mm, damping up to %2 N·s/m"))
            .arg(number(gains.stiffness / newtonsPerMetre, 3), number(gains.damping, 2));
    if (stiffness)
        return words(QT_TRANSLATE_NOOP("DeviceLabels", "In use: stiffness up to %1 N/mm, damping of the device"))
            .arg(number(gains.stiffness / newtonsPerMetre, 3));
    return words(QT_TRANSLATE_NOOP("DeviceLabels", "In use: stiffness and damping of the device"));
}

} // namespace burin
