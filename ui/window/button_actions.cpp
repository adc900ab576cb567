// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/button_actions.h"

#include <optional>
#include <utility>

namespace burin {

namespace {

/// Empty for an action that the driver does, or none.
std::optional<ActionId> windowAction(ButtonAction action) {
    switch (action) {
    case ButtonAction::none:
    case ButtonAction::mill:
    case ButtonAction::lift:
        break;
    case ButtonAction::undo:
        return ActionId::undo;
    case ButtonAction::redo:
        return ActionId::redo;
    case ButtonAction::clutch:
        return ActionId::clutch;
    case ButtonAction::recentre:
        return ActionId::recentre;
    case ButtonAction::levelAbove:
        return ActionId::levelAbove;
    case ButtonAction::levelBelow:
        return ActionId::levelBelow;
    case ButtonAction::edge:
        return ActionId::nearestEdge;
    case ButtonAction::fit:
        return ActionId::fit;
    }
    return std::nullopt;
}

} // namespace

ButtonActions::ButtonActions(Workbench& workbench, const Actions& actions, QObject* parent)
    : QObject(parent), workbench_(workbench), actions_(actions) {
    connect(&workbench_.session, &SessionRunner::ticked, this, &ButtonActions::follow);
    connect(&workbench_.session, &SessionRunner::ended, this, [this] { pressed_ = 0; });
}

void ButtonActions::follow() {
    const std::uint32_t now = workbench_.session.state().sample.buttons;
    const std::uint32_t fresh = now & ~std::exchange(pressed_, now);
    if (fresh == 0 || !workbench_.hand.device()) return;
    const AxisMap& map = workbench_.hand.device()->axisMap;
    for (std::size_t bit = 1; bit < AxisMap::mostButtons; ++bit) {
        if ((fresh >> bit & 1U) == 0) continue;
        if (const auto action = windowAction(map.buttons[buttonOfBit(map, bit)])) actions_[*action]->trigger();
    }
}

} // namespace burin
