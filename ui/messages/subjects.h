// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

namespace burin {

/// Translates core's name for a kind of object or of work ("material", "milling") to the language of the user
/// interface; names given by users are returned unchanged.
QString subjectText(const std::string& subject);

/// Translates a device's reason for a fault (core/device/device_fault.h) to the language of the user interface; other
/// text is returned unchanged.
QString deviceReasonText(const std::string& reason);

/// Translates "process 4711", the project's name for the owner of a lock, to the language of the user interface.
QString ownerText(const std::string& owner);

} // namespace burin
