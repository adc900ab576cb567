// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/device_words.h"

#include "ui/messages/messages.h"
#include "ui/panels/quantity.h"

#include <QCoreApplication>

namespace burin {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("DeviceWords", text);
}

template <UnitName unit>
void addLimit(QStringList& lines, const char* label, const Figure<unit>& figure) {
    if (figure.value <= 0.0) return;
    const std::string_view name = Figure<unit>::unit;
    lines << QStringLiteral("%1: %2 %3")
                 .arg(words(label), QLocale().toString(figure.value, 'g', 4),
                      QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
}

QString number(double value, int digits) {
    return QLocale().toString(value, 'f', digits);
}

QString pressed(std::uint32_t buttons) {
    QStringList numbers;
    for (unsigned int i = 0; i < 32; ++i)
        if ((buttons >> i & 1U) != 0) numbers << QString::number(i + 1);
    return numbers.isEmpty() ? words(QT_TRANSLATE_NOOP("DeviceWords", "none yet")) : numbers.join(QStringLiteral(", "));
}

} // namespace

QStringList limitLines(const StylusDescription& stylus) {
    QStringList lines;
    lines << words(QT_TRANSLATE_NOOP("DeviceWords", "Axes sensed: %1, driven: %2; buttons: %3"))
                 .arg(stylus.sensed.translations + stylus.sensed.rotations)
                 .arg(stylus.actuated.translations + stylus.actuated.rotations)
                 .arg(stylus.buttons);
    addLimit(lines, QT_TRANSLATE_NOOP("DeviceWords", "Maximum force"), stylus.maximumForce);
    addLimit(lines, QT_TRANSLATE_NOOP("DeviceWords", "Continuous force"), stylus.continuousForce);
    addLimit(lines, QT_TRANSLATE_NOOP("DeviceWords", "Maximum torque"), stylus.maximumTorque);
    addLimit(lines, QT_TRANSLATE_NOOP("DeviceWords", "Maximum stiffness"), stylus.maximumStiffness);
    addLimit(lines, QT_TRANSLATE_NOOP("DeviceWords", "Maximum damping"), stylus.maximumDamping);
    addLimit(lines, QT_TRANSLATE_NOOP("DeviceWords", "Workspace radius"), stylus.workspaceRadius);
    addLimit(lines, QT_TRANSLATE_NOOP("DeviceWords", "Device rate"), stylus.rate);
    return lines;
}

QStringList trialLines(const TrialFigures& figures) {
    constexpr double milliseconds = 1e3, percent = 100.0;
    const glm::dvec3 span = figures.highest - figures.lowest;
    QStringList lines;
    lines << words(QT_TRANSLATE_NOOP("DeviceWords", "Rate: %1 Hz; interval: median %2 ms, maximum %3 ms"))
                 .arg(number(figures.rate, 0), number(milliseconds * figures.medianInterval, 2),
                      number(milliseconds * figures.maximumInterval, 1))
          << words(QT_TRANSLATE_NOOP("DeviceWords", "Position: X %1, Y %2, Z %3 mm"))
                 .arg(number(figures.position.x, 1), number(figures.position.y, 1), number(figures.position.z, 1))
          << words(QT_TRANSLATE_NOOP("DeviceWords", "Motion so far: %1 × %2 × %3 mm; smallest step %4 mm"))
                 .arg(number(span.x, 1), number(span.y, 1), number(span.z, 1), number(figures.smallestStep, 4))
          << words(QT_TRANSLATE_NOOP("DeviceWords", "Rotation so far: %1°"))
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
