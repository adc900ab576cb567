// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// Box, margins, voxel size, with the voxel count and the memory they would take; Embed. What embedding found in whole
/// is said elsewhere (EmbeddingFindings): it is as long as it is.
class StockPanel : public QWidget {
    Q_OBJECT
public:
    explicit StockPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const StockState& state); ///< never emits

signals:
    void setupEdited(const burin::Setup& setup); ///< margins or voxel; `stock` is for the receiver to fill
    void fileRequested();                        ///< to read the stock from
    void embedRequested();

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
