// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/undo_refusal.h"

#include "ui/messages/undo_detail.h"

#include <string>

namespace burin {

Error undoUnderWay(const QString& change) {
    return {ErrorCode::cancelled, change.toStdString(), {}, std::string(undoUnderWayDetail)};
}

bool refusedDuringUndo(const Desk& desk, Controller& by, const QString& change) {
    if (!desk.undo.busy()) return false;
    emit by.failed(undoUnderWay(change));
    return true;
}

} // namespace burin
