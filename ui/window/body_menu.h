// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/workbench.h"

#include <QPoint>
#include <QString>

#include <cstddef>
#include <functional>
#include <set>
#include <vector>

class QWidget;

namespace burin {

/// A body, or all bodies of an assembly, whose menu is shown.
struct ChosenBodies {
    QString title;
    std::vector<std::size_t> bodies; ///< of the model, not empty
};

/// Shows the menu of bodies: hide and show, role, colour. Each choice changes all of them at once.
/// @param hidden bodies of the model that are not drawn now @param hide called with those to hide from now on
void showBodyMenu(Workbench& workbench, const ChosenBodies& chosen, const std::set<std::size_t>& hidden,
                  const std::function<void(const std::set<std::size_t>&)>& hide, const QPoint& globalPosition,
                  QWidget* parent);

} // namespace burin
