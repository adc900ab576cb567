// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/curve_edit_rows.h"
#include "core/path/machine_edit_rows.h"
#include "core/path/recording_edit_rows.h"
#include "core/path/surface_edit_rows.h"

/// The table of all kinds of edits, one row each: id, title, step, effect on the path's guarantees, and parameters with
/// their ranges and user-visible texts. Files, validation, the order of edits and the user interface read this table.
/// A new kind needs its parameters, its `apply` and its name in the list in one of the ..._edits.h, its row in the
/// matching ..._edit_rows.h, and its implementation in a source file of its own.
