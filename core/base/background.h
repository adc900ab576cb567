// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

/// Gives the calling thread, and threads that it creates, a lower priority than others of this machine from now on:
/// they get free cores, and a tenth of a core that others want. For long work while a window or a haptic device is in
/// use; never for a thread that starts a loop or a recorder. Cannot be undone without privileges. Never fails.
void workInBackground() noexcept;

/// The same for every thread that works for `parallelFor`, in the whole program; threads that call it keep their
/// priority. One call is enough. Thread-safe.
void helpInBackground();

} // namespace burin
