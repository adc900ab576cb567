// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/device_words.h"

#include "ui/messages/messages.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr double milliseconds = 1e3, percent = 100.0;

QString words(const char* text) {
    return QCoreApplication::translate("DeviceWords", text);
}

template <UnitName unit>
DeviceLimit row(const char* name, TextId label, const Figure<unit>& figure) {
    return {name, label, std::string(Figure<unit>::unit), figure.value, figure.source};
}

QString pressed(std::uint32_t buttons) {
    QStringList numbers;
    for (unsigned int i = 0; i < 32; ++i)
        if ((buttons >> i & 1U) != 0) numbers << QString::number(i + 1);
    return numbers.isEmpty() ? words(QT_TRANSLATE_NOOP("DeviceWords", "none")) : numbers.join(QStringLiteral(", "));
}

constexpr std::array motionNames{BURIN_TEXT("DeviceWords", "nothing"),    BURIN_TEXT("DeviceWords", "X, right"),
                                 BURIN_TEXT("DeviceWords", "Y, away"),    BURIN_TEXT("DeviceWords", "Z, up"),
                                 BURIN_TEXT("DeviceWords", "A, about X"), BURIN_TEXT("DeviceWords", "B, about Y"),
                                 BURIN_TEXT("DeviceWords", "C, about Z")}; // in the order of AxisMotion
constexpr std::array actionNames{BURIN_TEXT("DeviceWords", "nothing"),     BURIN_TEXT("DeviceWords", "mill"),
                                 BURIN_TEXT("DeviceWords", "lift"),        BURIN_TEXT("DeviceWords", "undo"),
                                 BURIN_TEXT("DeviceWords", "redo"),        BURIN_TEXT("DeviceWords", "clutch"),
                                 BURIN_TEXT("DeviceWords", "recentre"),    BURIN_TEXT("DeviceWords", "level above"),
                                 BURIN_TEXT("DeviceWords", "level below"), BURIN_TEXT("DeviceWords", "nearest edge"),
                                 BURIN_TEXT("DeviceWords", "fit the view")}; // in the order of ButtonAction

QString percentText(double share, const QLocale& locale) {
    return locale.toString(percent * share, 'f', 1);
}

QString lineOf(std::size_t number, const DeviceAxis& axis, const AxisUse& use, const QLocale& locale) {
    const QString name = QStringLiteral("%1 %2").arg(number).arg(Messages::text({"Device", axis.name.c_str()}));
    if (use.motion == AxisMotion::none) return QStringLiteral("%1: %2").arg(name, motionName(use.motion));
    const QString line =
        use.reversed
            ? words(QT_TRANSLATE_NOOP("DeviceWords",
                                      "%1: %2, reversed; gain %3; dead zone %4 %; range %5 to %7 %, rest %6 %"))
            : words(QT_TRANSLATE_NOOP("DeviceWords", "%1: %2; gain %3; dead zone %4 %; range %5 to %7 %, rest %6 %"));
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
                << words(QT_TRANSLATE_NOOP("DeviceWords", "button %1: %2")).arg(i + 1).arg(actionName(map.buttons[i]));
    return lines;
}

std::vector<DeviceLimit> limitsOf(const StylusDescription& stylus) {
    std::vector<DeviceLimit> limits{
        row("rate_hz", BURIN_TEXT("DeviceWords", "rate"), stylus.rate),
        row("delay_s", BURIN_TEXT("DeviceWords", "delay"), stylus.delay),
        row("force_max_n", BURIN_TEXT("DeviceWords", "maximum force"), stylus.maximumForce),
        row("force_continuous_n", BURIN_TEXT("DeviceWords", "continuous force"), stylus.continuousForce),
        row("torque_max_n_mm", BURIN_TEXT("DeviceWords", "maximum torque"), stylus.maximumTorque),
        row("stiffness_max_n_per_m", BURIN_TEXT("DeviceWords", "maximum stiffness"), stylus.maximumStiffness),
        row("damping_max_n_s_per_m", BURIN_TEXT("DeviceWords", "maximum damping"), stylus.maximumDamping),
        row("turning_stiffness_max_n_mm_per_rad", BURIN_TEXT("DeviceWords", "maximum rotational stiffness"),
            stylus.maximumTurningStiffness),
        row("workspace_radius_mm", BURIN_TEXT("DeviceWords", "workspace radius"), stylus.workspaceRadius),
        row("position_step_mm", BURIN_TEXT("DeviceWords", "position step"), stylus.positionStep),
        row("rotation_step_rad", BURIN_TEXT("DeviceWords", "rotation step"), stylus.rotationStep),
        row("speed_max_mm_per_s", BURIN_TEXT("DeviceWords", "maximum speed"), stylus.maximumSpeed),
        row("handle_mass_kg", BURIN_TEXT("DeviceWords", "mass of the handle"), stylus.handleMass)};
    std::erase_if(limits, [](const DeviceLimit& limit) { return limit.value <= 0.0; });
    return limits;
}

QStringList limitLines(const StylusDescription& stylus, const QLocale& locale) {
    QLocale plain = locale;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    QStringList lines;
    lines << words(QT_TRANSLATE_NOOP("DeviceWords", "axes: %1 sensed, %2 driven; buttons: %3"))
                 .arg(stylus.sensed.translations + stylus.sensed.rotations)
                 .arg(stylus.actuated.translations + stylus.actuated.rotations)
                 .arg(stylus.buttons);
    for (const DeviceLimit& limit : limitsOf(stylus))
        lines << QStringLiteral("%1 %2 %3 (%4)")
                     .arg(Messages::text(limit.label), plain.toString(limit.value, 'g', QLocale::FloatingPointShortest),
                          QString::fromStdString(limit.unit), Messages::text({"Device", limit.source.c_str()}));
    return lines;
}

QStringList trialLines(const TrialFigures& figures, const QLocale& locale) {
    const auto number = [&locale](double value, int digits) { return locale.toString(value, 'f', digits); };
    const glm::dvec3 span = figures.highest - figures.lowest;
    QStringList lines;
    lines << words(QT_TRANSLATE_NOOP("DeviceWords", "Rate: %1 Hz; interval: median %2 ms, maximum %3 ms"))
                 .arg(number(figures.rate, 0), number(milliseconds * figures.medianInterval, 2),
                      number(milliseconds * figures.maximumInterval, 1))
          << words(QT_TRANSLATE_NOOP("DeviceWords", "Position: X %1, Y %2, Z %3 mm"))
                 .arg(number(figures.position.x, 1), number(figures.position.y, 1), number(figures.position.z, 1))
          << words(QT_TRANSLATE_NOOP("DeviceWords", "Motion: %1 × %2 × %3 mm; smallest step %4 mm"))
                 .arg(number(span.x, 1), number(span.y, 1), number(span.z, 1), number(figures.smallestStep, 4))
          << words(QT_TRANSLATE_NOOP("DeviceWords", "Rotation: %1°"))
                 .arg(number(glm::degrees(figures.maximumRotation), 0))
          << words(QT_TRANSLATE_NOOP("DeviceWords", "Buttons pressed: %1")).arg(pressed(figures.buttons))
          << words(QT_TRANSLATE_NOOP("DeviceWords", "Maximum force commanded: %1 N"))
                 .arg(number(figures.maximumForce, 2));
    if (figures.health.motorHeat)
        lines << words(QT_TRANSLATE_NOOP("DeviceWords", "Motor temperature: %1 % of the limit"))
                     .arg(number(percent * *figures.health.motorHeat, 0));
    if (figures.health.batteryShare)
        lines << words(QT_TRANSLATE_NOOP("DeviceWords", "Battery: %1 %"))
                     .arg(number(percent * *figures.health.batteryShare, 0));
    if (figures.invalid > 0)
        lines << words(QT_TRANSLATE_NOOP("DeviceWords", "Invalid readings: %1")).arg(figures.invalid);
    for (const Error& fault : figures.faults) lines << Messages::sentence(fault);
    return lines;
}

} // namespace burin
