// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

#include <QIcon>
#include <QStringList>

namespace burin {

/// An icon from resources/icons in the colour of a role, sharp at any scale. The colour is looked up when the icon is
/// painted, so it follows a change of theme; a disabled icon is drawn at half opacity. Null (`isNull`) if there is no
/// icon of that name.
QIcon themedIcon(const QString& name, ColourRole role = &Palette::text);

/// The names of all available icons, sorted.
QStringList iconNames();

} // namespace burin
