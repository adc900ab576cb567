// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

namespace burin {

/// What core calls a kind of thing or a piece of work ("material", "milling"), in the language of the user interface;
/// names that somebody gave stay as they are.
QString subjectText(const std::string& subject);

/// What a device reports (reasons of core/device/device_fault.h), in the language of the user interface; other text
/// stays as it is.
QString deviceReasonText(const std::string& reason);

/// "process 4711", as the project names the owner of a lock, in the language of the user interface.
QString ownerText(const std::string& owner);

} // namespace burin
