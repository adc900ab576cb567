// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/setup_presenters.h"

#include "ui/messages/messages.h"

#include <algorithm>

namespace burin {

PartPresenter::PartPresenter(Workbench& workbench, Viewport& viewport, PartPanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.model, &workbench.setup}, parent), viewport_(viewport), panel_(panel) {
    connect(&picker_, &BodyPicker::chosen, &panel, &PartPanel::chooseBody);
    connect(&panel, &PartPanel::roleChosen, &workbench.setup, &SetupController::chooseRole);
}

void PartPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void PartPresenter::setShown(bool shown) {
    shown_ = shown;
    if (shown)
        viewport_.setInteractiveTool(&picker_);
    else if (viewport_.interactiveTool() == &picker_)
        viewport_.setInteractiveTool(nullptr);
}

void PartPresenter::present() {
    picker_.setModel(workbench_.model.preview() ? nullptr : workbench_.setup.part());
    PartState state{workbench_.setup.part(), workbench_.model.importing(), workbench_.model.preview()};
    state.roles = workbench_.setup.setup().roles;
    state.locked = workbench_.setup.locked();
    state.colours = workbench_.model.colours();
    panel_.setState(state);
}

StockPresenter::StockPresenter(Workbench& workbench, StockPanel& panel, EmbeddingFindings& findings, QObject* parent)
    : Presenter(workbench, {&workbench.setup, &workbench.workpiece}, parent), panel_(panel), findings_(findings) {
    connect(&panel, &StockPanel::setupEdited, &workbench.setup, &SetupController::edit);
    connect(&panel, &StockPanel::embedRequested, &workbench.workpiece, &WorkpieceController::embed);
}

void StockPresenter::connectActions(const Actions& actions) {
    WorkpieceController& workpiece = workbench_.workpiece;
    connect(actions[ActionId::embed], &QAction::triggered, &workpiece, [&workpiece] { workpiece.embed(); });
}

void StockPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    findings_.setUnit(unit);
    Presenter::setUnit(unit);
}

void StockPresenter::present() {
    const SetupController& setup = workbench_.setup;
    StockState state;
    state.hasPart = setup.hasPart();
    state.setup = setup.setup();
    state.size = setup.size();
    state.embedded = workbench_.workpiece.embedded();
    state.locked = setup.locked();
    state.busy = workbench_.workpiece.embedding();
    if (setup.problem()) state.problem = Messages::sentence(*setup.problem());
    if (state.embedded) state.findings = workbench_.workpiece.milling()->embedded.findings;
    panel_.setState(state);
    findings_.setFindings(state.findings);
}

MaterialPresenter::MaterialPresenter(Workbench& workbench, MaterialPanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.setup, &workbench.model}, parent), panel_(panel) {
    connect(&panel, &MaterialPanel::stockMaterialChosen, &workbench.setup, &SetupController::chooseStockMaterial);
    connect(&panel, &MaterialPanel::bodyMaterialChosen, &workbench.setup, &SetupController::chooseBodyMaterial);
}

void MaterialPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void MaterialPresenter::present() {
    const SetupController& setup = workbench_.setup;
    MaterialState state;
    state.materials = setup.materials();
    state.stockMaterial = setup.setup().stockMaterial;
    if (workbench_.model.model())
        for (const Body& body : workbench_.model.model()->bodies) state.bodyNames.push_back(body.name);
    state.bodyMaterials = setup.setup().bodyMaterials;
    state.bodyMaterials.resize(state.bodyNames.size());
    state.locked = setup.locked();
    panel_.setState(state);
}

LayerPresenter::LayerPresenter(Workbench& workbench, LayerPanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.setup, &workbench.workpiece}, parent), panel_(panel) {
    connect(&panel, &LayerPanel::layersEdited, &workbench.setup, &SetupController::setRegions);
}

void LayerPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void LayerPresenter::present() {
    const SetupController& setup = workbench_.setup;
    LayerState state;
    state.materials = setup.materials();
    state.layers = setup.setup().regions;
    if (setup.hasPart()) state.stock = setup.setup().stock;
    state.locked = setup.locked();
    if (setup.problem()) state.problem = Messages::sentence(*setup.problem());
    if (workbench_.workpiece.embedded()) {
        const EmbeddedSetup& embedded = workbench_.workpiece.milling()->embedded;
        state.amounts = materialAmounts(embedded);
        state.gradings = embedded.gradings;
        state.nothingPushesBack = embedded.partVolume == 0.0;
    }
    panel_.setState(state);
}

ToolPresenter::ToolPresenter(Workbench& workbench, ToolPanel& panel, QObject* parent)
    : Presenter(workbench,
                {&workbench.tool, &workbench.setup, &workbench.workpiece, &workbench.target, &workbench.mill}, parent)
    , panel_(panel) {
    connect(&panel, &ToolPanel::toolChosen, &workbench.tool, &ToolController::choose);
}

void ToolPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void ToolPresenter::present() {
    const ToolController& tool = workbench_.tool;
    ToolState state;
    state.tools = tool.tools();
    state.current = tool.current().id;
    state.fieldBusy = workbench_.workpiece.fieldBusy();
    state.locked = tool.locked();
    for (const TakeInfo& take : workbench_.mill.takes()) state.ofTakes.push_back(take.toolId);
    if (const Property* material = workbench_.setup.stockMaterial()) {
        if (const auto conditions = tool.conditionsIn(*material, workbench_.target.machine())) {
            state.feed = conditions->feed;
            state.plungeFeed = conditions->plungeFeed;
            state.spindleSpeed = conditions->spindleSpeed;
        }
        if (const CuttingPreset* preset = presetFor(tool.current(), *material)) {
            state.preset = preset->name;
            state.plungeByPreset = preset->plungeFeed > 0.0;
        }
        state.conditionsEstimated =
            std::ranges::any_of(material->values, [](const auto& entry) { return entry.second.estimate; });
    }
    panel_.setState(state);
}

AllowancePresenter::AllowancePresenter(Workbench& workbench, AllowancePanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.mill}, parent), panel_(panel) {
    connect(&panel, &AllowancePanel::allowanceEdited, &workbench.mill, &MillController::setAllowance);
}

void AllowancePresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void AllowancePresenter::present() {
    // The allowance is constant during a recording: it is a property of the take.
    panel_.setState({workbench_.mill.allowance(), WorkpieceController::maximumAllowance, workbench_.mill.recording()});
}

} // namespace burin
