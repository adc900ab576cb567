// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/loop_figures.h"

namespace burin {

bool LoopFigures::add(const TickTiming& timing) noexcept {
    if (ticks_ == 0) {
        marks_.fill({timing.over, 0});
        due_ = timing.over + interval;
    } else {
        work_.add(timing.work);
        cpu_.add(timing.cpu);
    }
    if (timing.interval > 0) interval_.add(timing.interval);
    ++ticks_;
    if (timing.over < due_) return false;
    due_ = timing.over + interval;
    Mark& oldest = marks_[next_++ % marks];
    const double seconds = static_cast<double>(timing.over - oldest.when) * 1e-9;
    figures_.rateHz = seconds > 0.0 ? static_cast<double>(ticks_ - 1 - oldest.ticks) / seconds : 0.0;
    oldest = {timing.over, ticks_ - 1};
    figures_.cpuP999 = cpu_.quantileMicroseconds(0.999);
    figures_.workP999 = work_.quantileMicroseconds(0.999);
    figures_.intervalP999 = interval_.quantileMicroseconds(0.999);
    figures_.ticks = ticks_;
    figures_.missed = timing.missed;
    figures_.late = timing.late;
    figures_.scheduling = timing.scheduling;
    return true;
}

} // namespace burin
