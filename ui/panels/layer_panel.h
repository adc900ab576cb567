// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/material_amount.h"
#include "core/setup/setup.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

#include <vector>

namespace burin {

struct LayerState {
    std::vector<Property> materials; ///< of the library
    std::vector<MaterialRegion> layers;
    Box stock;                           ///< mm; empty: no stock yet
    std::vector<MaterialAmount> amounts; ///< of the embedded stock; empty if none is embedded
    std::vector<RegionGrading> gradings; ///< of the embedded stock
    bool locked = false;                 ///< whether there are recordings
    bool nothingPushesBack = false;      ///< whether the workpiece contains no part
    QString problem;                     ///< why this can't be embedded; empty: it can
};

/// The layers of the stock in the order of their priority, one of them editable, and the contents of the stock: each
/// material with volume and mass.
class LayerPanel : public QWidget {
    Q_OBJECT
public:
    explicit LayerPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const LayerState& state); ///< never emits

signals:
    void layersEdited(const std::vector<burin::MaterialRegion>& layers);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
