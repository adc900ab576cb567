// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/allowance_panel.h"
#include "ui/panels/bounds_panel.h"
#include "ui/panels/embedding_findings.h"
#include "ui/panels/guide_panel.h"
#include "ui/panels/hand_panel.h"
#include "ui/panels/job_states.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/meters.h"
#include "ui/panels/mill_panel.h"
#include "ui/panels/part_panel.h"
#include "ui/panels/path_panel.h"
#include "ui/panels/program_panel.h"
#include "ui/panels/setup_panel.h"
#include "ui/panels/stock_panel.h"
#include "ui/panels/surroundings_panel.h"
#include "ui/panels/tool_panel.h"
#include "ui/panels/zero_panel.h"

#include <QFrame>

#include <array>

class QStackedWidget;

namespace burin {

/// The right side: the panel of the step shown, with the meters at the bottom while the tool moves.
class PanelStack final : public QFrame {
    Q_OBJECT
public:
    explicit PanelStack(QWidget* parent = nullptr);
    void showStep(JobStep step);
    void showPanel(QWidget* panel); ///< scrolls to a panel of the step shown

    PartPanel* part;
    SetupPanel* setup; ///< below the part
    StockPanel* stock;
    ZeroPanel* zero;                 ///< below the stock
    SurroundingsPanel* surroundings; ///< below program zero
    EmbeddingFindings* findings;     ///< below the fixtures and limits
    MaterialPanel* material;
    LayerPanel* layers;
    ToolPanel* tool;
    AllowancePanel* allowance;
    MillPanel* mill;
    GuidePanel* guides;  ///< below the mill panel
    BoundsPanel* bounds; ///< below the guides
    HandPanel* hand;     ///< below the bounds
    PathPanel* path;
    ProgramPanel* program;
    Meters* meters;

private:
    QStackedWidget* stack_;
};

} // namespace burin
