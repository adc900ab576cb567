// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/job/damaged/trial.h"

#include "core/verify/findings.h"

#include <algorithm>
#include <regex>

namespace burin::test {

namespace {

Verdict verdictOf(const Error& error) {
    Verdict verdict;
    verdict.findings = 1;
    verdict.text = error.place + ": " + error.detail;
    static const std::regex named("line ([0-9]+)");
    const auto end = std::sregex_iterator();
    for (auto at = std::sregex_iterator(verdict.text.begin(), verdict.text.end(), named); at != end; ++at)
        verdict.lines.push_back(static_cast<std::uint32_t>(std::stoul((*at)[1])));
    return verdict;
}

} // namespace

bool Verdict::names(std::uint32_t first, std::uint32_t last) const {
    return std::ranges::any_of(lines, [&](std::uint32_t line) { return line >= first && line <= last; });
}

Verdict judge(const TrayJob& job, const std::string& text, const std::string& dialect) {
    Progress progress;
    const Result<CheckedProgram> checked = checkProgram(job.milling, text, "tray.ngc", job.request(dialect), progress);
    if (!checked) return verdictOf(checked.error());
    Verdict verdict;
    verdict.findings = checked->errorCount();
    for (const Finding& finding : checked->report.findings) {
        verdict.lines.push_back(finding.line);
        verdict.text += std::to_string(finding.line) + " " + idOf(finding.kind) + ", ";
    }
    for (const LintMark& mark : checked->lint) {
        if (mark.severity != LintSeverity::error) continue;
        verdict.lines.push_back(mark.line);
        verdict.text += std::to_string(mark.line) + " " + mark.text + ", ";
    }
    return verdict;
}

} // namespace burin::test
