// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>

namespace burin {

/// The texts of a setup sheet.
class SheetText {
    Q_DECLARE_TR_FUNCTIONS(burin::SheetText)
};

} // namespace burin
