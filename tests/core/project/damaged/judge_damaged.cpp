// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Gives damaged programs to the check and tells which it catches at the right line: burin_judge_damaged [each of a
// kind]
#include "tests/core/project/damaged/trial.h"

#include <cstdio>
#include <cstdlib>
#include <map>

using namespace burin::test;

int main(int count, char** arguments) {
    const std::uint32_t each = count > 1 ? static_cast<std::uint32_t>(std::atoi(arguments[1])) : 12;
    const std::string only = count > 2 ? arguments[2] : "";
    const TrayJob job;
    std::map<std::string, std::string> sound;
    int alarms = 0;
    for (const char* dialect : {"linuxcnc", "fanuc", "haas", "mach", "grblhal", "grbl"}) {
        sound[dialect] = job.post(dialect);
        const Verdict verdict = judge(job, sound[dialect], dialect);
        if (verdict.passed()) continue;
        ++alarms;
        std::printf("FALSE ALARM %s: %s\n", dialect, verdict.text.c_str());
    }
    std::uint32_t made = 0, caught = 0, at = 0;
    std::size_t findings = 0;
    for (const DamageKind& kind : damageKinds()) {
        if (!only.empty() && kind.name != only) continue;
        std::uint32_t ofKind = 0, caughtOfKind = 0, atOfKind = 0;
        for (std::uint32_t i = 0; i < each; ++i) {
            const std::string dialect(kind.dialects[i % kind.dialects.size()]);
            const Damaged damaged = kind.make(sound[dialect], dialect, i);
            if (damaged.last == 0) continue;
            const Verdict verdict = judge(job, damaged.text, dialect);
            ++ofKind;
            findings += verdict.findings;
            if (!verdict.passed()) ++caughtOfKind;
            if (verdict.names(damaged.first, damaged.last)) {
                ++atOfKind;
                if (verdict.findings <= 3) continue;
            }
            std::printf("%s %s %u (%s, lines %u-%u): %zu: %.200s\n",
                        verdict.passed()                             ? "MISSED"
                        : verdict.names(damaged.first, damaged.last) ? "many"
                                                                     : "ELSEWHERE",
                        std::string(kind.name).c_str(), i, damaged.what.c_str(), damaged.first, damaged.last,
                        verdict.findings, verdict.text.c_str());
        }
        std::printf("%-32s %3u made, %3u caught, %3u at the right line\n", std::string(kind.name).c_str(), ofKind,
                    caughtOfKind, atOfKind);
        made += ofKind;
        caught += caughtOfKind;
        at += atOfKind;
    }
    std::printf("%u damaged programs, %u caught, %u at the right line (%.1f %%), %zu findings; %d false alarms\n", made,
                caught, at, made > 0 ? 100.0 * at / made : 0.0, findings, alarms);
    return alarms == 0 && at >= 0.97 * made ? 0 : 1;
}
