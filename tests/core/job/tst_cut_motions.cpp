// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/cut_motions.h"
#include "tests/core/document/sample_project.h"
#include "tests/test_program.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <rapidcheck.h>
#include <span>
#include <utility>

namespace burin::tst_cut_motions {

class TestCutMotions : public QObject {
    Q_OBJECT

private slots:
    /// A tool that moves continuously and jumps, and whose axis is upright, tilted or rotating.
    void motionsThatCutComeBackToTheBit() {
        const bool held = rc::check([] {
            const std::array<glm::dvec3, 3> tips{
                glm::dvec3(0.1, 0.2, 0.3), {1.0 / 3.0, -2.0, 1e-300}, {-0.0, 0.0, 5.0}};
            const std::array<glm::dvec3, 2> axes{glm::dvec3(0.0, 0.0, 1.0), {0.0, 0.6, 0.8}};
            std::vector<std::pair<ToolPose, ToolPose>> motions;
            std::vector<std::uint64_t> ends;
            const auto anyPose = [&] { return ToolPose{*rc::gen::elementOf(tips), *rc::gen::elementOf(axes)}; };
            CutMotions kept;
            for (int i = *rc::gen::inRange(0, 30); i > 0; --i) {
                const bool goesOn = !motions.empty() && *rc::gen::inRange(0, 3) > 0;
                motions.emplace_back(goesOn ? motions.back().second : anyPose(), anyPose());
                ends.push_back((ends.empty() ? 0 : ends.back()) + *rc::gen::inRange<std::uint64_t>(1, 4));
                kept.add(motions.back().first, motions.back().second, ends.back());
            }
            RC_ASSERT(kept.count() == motions.size());
            const auto first = *rc::gen::inRange<std::size_t>(0, motions.size() + 1);
            const auto end = *rc::gen::inRange<std::size_t>(first, motions.size() + 2);
            std::size_t next = first;
            const auto same = [](const ToolPose& a, const ToolPose& b) { return a.tip == b.tip && a.axis == b.axis; };
            const auto compare = [&](const ToolPose& from, const ToolPose& to, std::uint64_t sample) -> Result<void> {
                RC_ASSERT(same(from, motions[next].first) && same(to, motions[next].second));
                RC_ASSERT(sample == ends[next] && sample == kept.sampleOf(next));
                ++next;
                return {};
            };
            RC_ASSERT(kept.visit(first, end, compare) && next == std::max(first, std::min(end, motions.size())));
            const auto samples = *rc::gen::inRange<std::uint64_t>(0, 100);
            RC_ASSERT(kept.countWithin(samples) == static_cast<std::uint64_t>(std::ranges::count_if(
                                                       ends, [&](auto each) { return each < samples; })));
        });
        QVERIFY(held);
    }

    /// The first sample ends no motion, and undone samples and those without removal cut nothing; for any division into
    /// parts.
    void whatCutIsFoundInAnyParts() {
        std::vector<Sample> samples = fixture::handSamples(0, 60);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            samples[i].removed = {};
            if (i % 4 != 1) samples[i].removed[3] = {i + 1, 2};
        }
        const std::vector<SampleRange> undone{{8, 5}, {40, 1}};
        for (const std::size_t part : {std::size_t{1}, std::size_t{7}, std::size_t{60}}) {
            CutFinder finder(undone);
            std::vector<std::pair<glm::dvec3, glm::dvec3>> found;
            for (std::span<const Sample> rest(samples); !rest.empty(); rest = rest.subspan(std::min(part, rest.size())))
                QVERIFY(finder.find(rest.first(std::min(part, rest.size())),
                                    [&](const ToolPose& from, const ToolPose& to, std::uint64_t) -> Result<void> {
                                        found.emplace_back(from.tip, to.tip);
                                        return {};
                                    }));
            std::vector<std::pair<glm::dvec3, glm::dvec3>> expected;
            for (std::size_t i = 1; i < samples.size(); ++i)
                if (i % 4 != 1 && !(i >= 8 && i < 13) && i != 40)
                    expected.emplace_back(samples[i - 1].proxy.tip, samples[i].proxy.tip);
            QVERIFY(found == expected);
        }
    }
};

BURIN_TEST(TestCutMotions, NoApplication)

} // namespace burin::tst_cut_motions

#include "tst_cut_motions.moc"
