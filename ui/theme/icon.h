// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

#include <QIcon>
#include <QStringList>

namespace burin {

/// An icon of resources/icons in the colour of a role, sharp at any scale. It looks the colour up when it paints, so it
/// follows a change of theme; disabled it is drawn in half its strength. Empty (`isNull`) when there is none of that
/// name.
QIcon themedIcon(const QString& name, ColourRole role = &Palette::text);

/// Names of all icons there are, sorted.
QStringList iconNames();

} // namespace burin
