// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

/// The calling thread, and threads that it makes, work behind others of this machine from now on: they get a core that
/// is free, and a tenth of one that others want. For long work beside a window, or beside a hand; never for a thread
/// that starts a loop or a recorder. Can't be taken back without rights. Never fails.
void workInBackground() noexcept;

/// The same for every thread that helps with `parallelFor`, in all of the program; those that ask for it stay as they
/// are. Once is enough. Thread: any.
void helpInBackground();

} // namespace burin
