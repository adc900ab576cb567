// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/placement.h"

#include <QString>

#include <optional>

class QWidget;

namespace burin {

/// A further setup, as the user wants it.
struct WantedSetup {
    QString name;
    Placement turn; ///< of the part, from how it lies now
    bool leftStock = true;
};

/// Asks how a further setup is to be. Dialog "setupDialog" with "setupNameField", "setupTurn", "setupStock",
/// "confirmButton", "cancelButton". Nothing: cancelled.
/// @param name proposed @param middle mm: of the part, which stays where it is @param leaves the workpiece is there
std::optional<WantedSetup> askSetup(QWidget* parent, const QString& name, const glm::dvec3& middle, bool leaves);

} // namespace burin
