// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// Box, margins and voxel size, with the resulting voxel count and memory; Embed. The full findings of the embedding
/// are shown elsewhere (EmbeddingFindings), as their length varies.
class StockPanel : public QWidget {
    Q_OBJECT
public:
    explicit StockPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const StockState& state); ///< never emits

signals:
    void setupEdited(const burin::Setup& setup); ///< margins or voxel size; the receiver computes `stock`
    void fileRequested();                        ///< the user wants to read the stock from a file
    void embedRequested();

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
