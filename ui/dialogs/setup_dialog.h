// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/placement.h"

#include <QString>

#include <optional>

class QWidget;

namespace burin {

/// A further setup as requested by the user.
struct RequestedSetup {
    QString name;
    Placement turn; ///< of the part, relative to its present placement
    bool leftStock = true;
};

/// Asks for the parameters of a further setup. Dialog "setupDialog" with "setupNameField", "setupTurn", "setupStock",
/// "confirmButton", "cancelButton". Empty: cancelled.
/// @param name proposed name @param middle centre of the part, mm, which stays in place @param leaves whether there is
/// a workpiece
std::optional<RequestedSetup> askSetup(QWidget* parent, const QString& name, const glm::dvec3& middle, bool leaves);

} // namespace burin
