// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/curve_edit_rows.h"
#include "core/path/machine_edit_rows.h"
#include "core/path/recording_edit_rows.h"
#include "core/path/surface_edit_rows.h"

/// The table of all kinds of edits, a row each: id, title, step, what it does to the path's guarantees, and its
/// parameters with their ranges and the words that the user reads. Files, validation, the order and the user interface
/// read it here. A new kind: its parameters, its `apply` and its name in the list in one of the ..._edits.h, its row in
/// the file beside, and what it does in a source of its own.
