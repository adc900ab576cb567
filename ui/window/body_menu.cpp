// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/body_menu.h"

#include "ui/panels/role_labels.h"
#include "ui/theme/colour.h"
#include "ui/window/context_menu.h"

#include <QColorDialog>
#include <QCoreApplication>
#include <QMenu>

#include <algorithm>
#include <array>
#include <cstdint>

namespace burin {

namespace {

struct BodyMenu {
    Q_DECLARE_TR_FUNCTIONS(BodyMenu)
};

using Hide = std::function<void(const std::set<std::size_t>&)>;

void addViewEntries(QMenu& menu, const std::vector<std::size_t>& bodies, std::size_t all,
                    const std::set<std::size_t>& hidden, const Hide& hide) {
    const bool one = bodies.size() == 1;
    const bool show = std::ranges::all_of(bodies, [&](std::size_t body) { return hidden.contains(body); });
    const QString tip = show  ? one ? BodyMenu::tr("Draw this body again.") : BodyMenu::tr("Draw these bodies again.")
                         : one ? BodyMenu::tr("Do not draw this body; nothing else changes.")
                              : BodyMenu::tr("Do not draw these bodies; nothing else changes.");
    addEntry(menu, show ? BodyMenu::tr("&Show") : BodyMenu::tr("&Hide"), tip, "hideBodyAction",
             [bodies, hidden, hide, show] {
                 std::set<std::size_t> next = hidden;
                 for (const std::size_t body : bodies) show ? void(next.erase(body)) : void(next.insert(body));
                 hide(next);
             });
    addEntry(menu, one ? BodyMenu::tr("Show this one &alone") : BodyMenu::tr("Show these &alone"),
             BodyMenu::tr("Hide all other bodies."), "isolateBodyAction", [bodies, all, hide] {
                 std::set<std::size_t> others;
                 for (std::size_t i = 0; i < all; ++i) others.insert(i);
                 for (const std::size_t body : bodies) others.erase(body);
                 hide(others);
             });
    if (!hidden.empty())
        addEntry(menu, BodyMenu::tr("Show a&ll"), BodyMenu::tr("Draw all bodies again."), "showBodiesAction",
                 [hide] { hide({}); });
}

void addRoles(QMenu& menu, SetupController& setup, const std::vector<std::size_t>& bodies) {
    QMenu* roles = menu.addMenu(BodyMenu::tr("&Role"));
    roles->setObjectName(QStringLiteral("bodyRoleMenu"));
    roles->menuAction()->setToolTip(setup.locked() ? BodyMenu::tr("Recordings depend on the roles of bodies.")
                                                   : roleToolTip());
    roles->setEnabled(!setup.locked());
    for (const BodyRole role : bodyRoles) {
        const std::string name = "role-" + std::string(idOf(role));
        addEntry(*roles, roleText(role), roleToolTip(), name.c_str(),
                 [&setup, bodies, role] { setup.chooseRoles(bodies, role); });
        QAction* entry = roles->actions().constLast();
        entry->setCheckable(true);
        entry->setChecked(
            std::ranges::all_of(bodies, [&](std::size_t body) { return roleOf(setup.setup(), body) == role; }));
    }
}

void askColour(ModelController& model, const ChosenBodies& chosen, QWidget* parent) {
    const QColor before = colourFrom(model.colours()[chosen.bodies.front()]);
    const QColor colour =
        QColorDialog::getColor(before.isValid() ? before : QColor(Qt::lightGray), parent,
                               BodyMenu::tr("Colour of %1").arg(chosen.title), QColorDialog::DontUseNativeDialog);
    if (!colour.isValid()) return;
    const auto channel = [](int value) { return static_cast<std::uint8_t>(value); };
    model.chooseColour(chosen.bodies,
                       std::array{channel(colour.red()), channel(colour.green()), channel(colour.blue())});
}

void addColours(QMenu& menu, ModelController& model, const ChosenBodies& chosen, QWidget* parent) {
    addEntry(menu, BodyMenu::tr("&Colour…"), BodyMenu::tr("Choose the colour in which the view shows it."),
             "bodyColourAction", [&model, chosen, parent] { askColour(model, chosen, parent); });
    const auto isColoured = [&](std::size_t body) { return model.colours()[body].has_value(); };
    if (std::ranges::any_of(chosen.bodies, isColoured))
        addEntry(menu, BodyMenu::tr("&Without a colour of its own"),
                 BodyMenu::tr("Show it in the colour of parts without a colour."), "noBodyColourAction",
                 [&model, chosen] { model.chooseColour(chosen.bodies, {}); });
}

} // namespace

void showBodyMenu(Workbench& workbench, const ChosenBodies& chosen, const std::set<std::size_t>& hidden,
                  const std::function<void(const std::set<std::size_t>&)>& hide, const QPoint& globalPosition,
                  QWidget* parent) {
    const std::size_t all = workbench.model.colours().size();
    if (chosen.bodies.empty() || std::ranges::max(chosen.bodies) >= all) return;
    QMenu* menu = makeContextMenu("bodyMenu", chosen.title, parent);
    addViewEntries(*menu, chosen.bodies, all, hidden, hide);
    menu->addSeparator();
    addRoles(*menu, workbench.setup, chosen.bodies);
    addColours(*menu, workbench.model, chosen, parent);
    menu->popup(globalPosition);
}

} // namespace burin
