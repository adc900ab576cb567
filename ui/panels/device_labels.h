// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"
#include "core/device/axis_map_json.h"
#include "core/device/device_trial.h"
#include "core/haptics/force/suggested_gains.h"

#include <QLocale>
#include <QStringList>

#include <string>
#include <vector>

namespace burin {

/// A limit stated by a device.
struct DeviceLimit {
    std::string name; ///< JSON key, with its unit
    TextId label;
    std::string unit;
    double value = 0.0; ///< > 0
    std::string source; ///< English, context "Device"
};
/// The limits that are known.
std::vector<DeviceLimit> limitsOf(const StylusDescription& stylus);

/// The limits with their sources, one per line. @param locale of the numbers
QStringList limitLines(const StylusDescription& stylus, const QLocale& locale);
/// The measurements of a trial, one per line. @param locale of the numbers
QStringList trialLines(const TrialFigures& figures, const QLocale& locale);

/// Gains suggested for a device, with what limits them and the safety margin, one per line. @param locale of the
/// numbers
QStringList gainLines(const SuggestedGains& gains, const QLocale& locale);
/// The gains in use, in a line. @param locale of the numbers
QString gainsInUse(const GainLimits& gains, const QLocale& locale);

/// What an axis moves, what a button does: the text of a choice.
QString motionName(AxisMotion motion);
QString actionName(ButtonAction action);
/// The axes of a device with their assignment and calibration, one per line, numbered from 1, then the buttons that do
/// something. @param locale of the numbers
QStringList axisLines(const MappableDevice& device, const AxisMap& map, const QLocale& locale);

} // namespace burin
