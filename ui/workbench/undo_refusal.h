// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/controller.h"

namespace burin {

/// The error of a change that is refused because an undo or redo is under way.
Error undoUnderWay(const QString& change);

/// Whether a change has to be refused because an undo or redo is under way; the controller's `failed` reports it then.
/// For callers that otherwise would go on as if History had made it.
bool refusedDuringUndo(const Desk& desk, Controller& by, const QString& change);

} // namespace burin
