// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/session_traces.h"

#include <string>
#include <system_error>
#include <utility>

namespace burin {

void SessionTraces::choose(const std::filesystem::path& file) {
    chosen_ = file;
    number_ = 1;
}

std::filesystem::path SessionTraces::begin() {
    now_ = chosen_;
    std::error_code unseen;
    for (; number_ > 1 && !chosen_.empty(); ++number_) {
        now_ = chosen_;
        now_.replace_filename(chosen_.stem().string() + "-" + std::to_string(number_) + chosen_.extension().string());
        if (!std::filesystem::exists(now_, unseen)) break;
    }
    return now_;
}

std::filesystem::path SessionTraces::end() {
    const std::filesystem::path file = std::exchange(now_, {});
    if (file.empty()) return {};
    ++number_;
    std::error_code unseen;
    return std::filesystem::exists(file, unseen) ? file : std::filesystem::path();
}

} // namespace burin
