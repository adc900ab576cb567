// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/path_colours.h"

#include <QAction>
#include <QCoreApplication>

#include <algorithm>

namespace burin {

PathColours::PathColours(Workbench& workbench, Viewport& viewport, ViewBar& bar, const Actions& actions,
                         QObject* parent)
    : QObject(parent), workbench_(workbench), viewport_(viewport), bar_(bar), next_(*actions[ActionId::pathColours]) {
    QStringList names{tr("Kind of move")};
    for (const PathQuantity quantity : pathQuantities) {
        const TextId title = titleOf(quantity);
        names << QCoreApplication::translate(title.context, title.text);
    }
    bar.setPathColours(names);
    connect(&bar, &ViewBar::pathColourChosen, this, &PathColours::choose);
    connect(&next_, &QAction::triggered, this, [this] {
        const auto chosen = workbench_.pathValuer.chosen();
        const auto place = chosen ? std::ranges::find(pathQuantities, *chosen) - pathQuantities.begin() + 1 : 0;
        choose(static_cast<int>((place + 1) % (static_cast<std::ptrdiff_t>(pathQuantities.size()) + 1)));
    });
    for (const Controller* controller :
         {static_cast<const Controller*>(&workbench.pathValuer), static_cast<const Controller*>(&workbench.path)})
        connect(controller, &Controller::changed, this, &PathColours::show);
    show();
}

void PathColours::choose(int place) {
    workbench_.pathValuer.choose(place > 0 ? std::optional(pathQuantities[static_cast<std::size_t>(place) - 1])
                                           : std::nullopt);
}

void PathColours::show() {
    const bool exists = workbench_.path.evaluated() != nullptr;
    const auto chosen = workbench_.pathValuer.chosen();
    const auto place = chosen ? std::ranges::find(pathQuantities, *chosen) - pathQuantities.begin() + 1 : 0;
    next_.setEnabled(exists);
    bar_.showPathColour(exists ? std::optional(static_cast<int>(place)) : std::nullopt);
    viewport_.setPathValues(workbench_.pathValuer.values());
}

} // namespace burin
