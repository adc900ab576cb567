// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/input/body_picker.h"
#include "ui/panels/allowance_panel.h"
#include "ui/panels/embedding_findings.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/part_panel.h"
#include "ui/panels/stock_panel.h"
#include "ui/panels/tool_panel.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

// The panels of the steps before milling, each with its controller.

class PartPresenter final : public Presenter {
    Q_OBJECT
public:
    PartPresenter(Workbench& workbench, Viewport& viewport, PartPanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// While its step is shown, a click in the viewport selects a body.
    void setShown(bool shown);
    bool pointing() const { return viewport_.interactiveTool() == &picker_; } ///< whether it does

    void setHiddenBodies(const std::set<std::size_t>& bodies) { picker_.setHidden(bodies); }

private:
    void present() override;
    Viewport& viewport_;
    PartPanel& panel_;
    BodyPicker picker_;
    bool shown_ = false;
};

class StockPresenter final : public Presenter {
    Q_OBJECT
public:
    StockPresenter(Workbench& workbench, StockPanel& panel, EmbeddingFindings& findings, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// Embedding.
    void connectActions(const Actions& actions);

private:
    void present() override;
    StockPanel& panel_;
    EmbeddingFindings& findings_;
};

class MaterialPresenter final : public Presenter {
    Q_OBJECT
public:
    MaterialPresenter(Workbench& workbench, MaterialPanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;

private:
    void present() override;
    MaterialPanel& panel_;
};

class LayerPresenter final : public Presenter {
    Q_OBJECT
public:
    LayerPresenter(Workbench& workbench, LayerPanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;

private:
    void present() override;
    LayerPanel& panel_;
};

class ToolPresenter final : public Presenter {
    Q_OBJECT
public:
    ToolPresenter(Workbench& workbench, ToolPanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;

private:
    void present() override;
    ToolPanel& panel_;
};

class AllowancePresenter final : public Presenter {
    Q_OBJECT
public:
    AllowancePresenter(Workbench& workbench, AllowancePanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;

private:
    void present() override;
    AllowancePanel& panel_;
};

} // namespace burin
