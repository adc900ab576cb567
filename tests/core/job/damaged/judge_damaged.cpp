// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Runs the check on damaged programs and reports which faults it finds at the right line, and findings in valid ones:
// burin_judge_damaged [how many of each kind [the kind]]. Status 1 below 97 %, or with a false alarm.
#include "tests/core/job/damaged/trial.h"

#include <cstdio>
#include <cstdlib>
#include <map>

using namespace burin::test;

namespace {

struct Tally {
    std::uint32_t made = 0, found = 0, atLine = 0;
    std::size_t findings = 0;

    void add(const Tally& other) {
        made += other.made;
        found += other.found;
        atLine += other.atLine;
        findings += other.findings;
    }
};

using Texts = std::map<std::string, std::string>; ///< by dialect

/// The valid programs. @param alarms number of them that the check refuses
Texts soundTexts(const TrayJob& job, int& alarms) {
    Texts sound;
    for (const char* dialect : {"linuxcnc", "fanuc", "haas", "mach", "grblhal", "grbl"}) {
        sound[dialect] = job.post(dialect);
        const Verdict verdict = judge(job, sound[dialect], dialect);
        if (verdict.passed()) continue;
        ++alarms;
        std::printf("FALSE ALARM %s: %s\n", dialect, verdict.text.c_str());
    }
    return sound;
}

void tell(const char* how, const DamageKind& kind, std::uint32_t number, const Damaged& damaged,
          const Verdict& verdict) {
    std::printf("%s: %s %u (%s, lines %u to %u): %.200s\n", how, std::string(kind.name).c_str(), number,
                damaged.what.c_str(), damaged.first, damaged.last, verdict.text.c_str());
}

Tally tryKind(const TrayJob& job, const Texts& sound, const DamageKind& kind, std::uint32_t each) {
    constexpr std::size_t many = 6; // findings of one damage
    Tally tally;
    for (std::uint32_t i = 0; i < each; ++i) {
        const std::string dialect(kind.dialects[i % kind.dialects.size()]);
        const Damaged damaged = kind.make(sound.at(dialect), dialect, i);
        if (damaged.last == 0) continue;
        const Verdict verdict = judge(job, damaged.text, dialect);
        const bool atLine = verdict.names(damaged.first, damaged.last);
        tally.add({1, verdict.passed() ? 0U : 1U, atLine ? 1U : 0U, verdict.findings});
        if (verdict.passed())
            tell("MISSED", kind, i, damaged, verdict);
        else if (!atLine)
            tell("ELSEWHERE", kind, i, damaged, verdict);
        else if (verdict.findings > many)
            tell("many findings", kind, i, damaged, verdict);
    }
    return tally;
}

} // namespace

int main(int count, char** arguments) {
    const std::uint32_t each = count > 1 ? static_cast<std::uint32_t>(std::atoi(arguments[1])) : 12;
    const std::string only = count > 2 ? arguments[2] : "";
    const TrayJob job;
    int alarms = 0;
    const Texts sound = soundTexts(job, alarms);
    Tally all;
    for (const DamageKind& kind : damageKinds()) {
        if (!only.empty() && kind.name != only) continue;
        const Tally tally = tryKind(job, sound, kind, each);
        std::printf("%-32s %3u made, %3u found, %3u at the right line\n", std::string(kind.name).c_str(), tally.made,
                    tally.found, tally.atLine);
        all.add(tally);
    }
    std::printf("%u damaged programs, %u found, %u at the right line (%.1f %%), %zu findings; %d false alarms\n",
                all.made, all.found, all.atLine, all.made > 0 ? 100.0 * all.atLine / all.made : 0.0, all.findings,
                alarms);
    return alarms == 0 && all.atLine >= 0.97 * all.made ? 0 : 1;
}
