// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/tool_order.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QTest>

#include <algorithm>
#include <numeric>

namespace burin::tst_tool_order {

namespace {

std::size_t changesIn(const std::vector<ToolPass>& passes, const std::vector<std::size_t>& order) {
    std::size_t changes = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
        if (passes[order[i]].toolId != passes[order[i - 1]].toolId) ++changes;
    return changes;
}

/// Roughing first, then by diameter.
bool isSensible(const std::vector<ToolPass>& passes, const std::vector<std::size_t>& order) {
    for (std::size_t i = 1; i < order.size(); ++i) {
        const ToolPass &before = passes[order[i - 1]], &pass = passes[order[i]];
        const bool rough = pass.allowance > 0.0, roughBefore = before.allowance > 0.0;
        if (rough && !roughBefore) return false;
        if (rough == roughBefore && pass.diameter > before.diameter) return false;
    }
    return true;
}

std::vector<std::size_t> indicesOf(const std::vector<OrderedPass>& ordered) {
    std::vector<std::size_t> indices;
    for (const OrderedPass& pass : ordered) indices.push_back(pass.pass);
    return indices;
}

} // namespace

class TestToolOrder : public QObject {
    Q_OBJECT

private slots:
    void aShopWouldOrderThemSo() {
        const std::vector<ToolPass> passes{
            {"ball-6", 6, 0.0}, {"flat-6", 6, 0.3}, {"flat-12", 12, 0.5}, {"ball-6", 6, 0.0}, {"flat-6", 6, 0.0}};
        const std::vector<OrderedPass> ordered = orderPasses(passes);
        QVERIFY((indicesOf(ordered) == std::vector<std::size_t>{2, 1, 4, 0, 3}));
        QVERIFY(ordered[0].reason == OrderReason::first && ordered[1].reason == OrderReason::smallerTool);
        QVERIFY(ordered[2].reason == OrderReason::finishingAfterRough && ordered[4].reason == OrderReason::sameTool);
        QVERIFY(orderPasses({}).empty());
    }

    void noSensibleOrderHasFewerChanges() {
        QVERIFY(rc::check("among all orders of a handful of paths", [] {
            std::vector<ToolPass> passes;
            const int count = *rc::gen::inRange(1, 7);
            for (int i = 0; i < count; ++i) {
                const int tool = *rc::gen::inRange(0, 4); // two sizes, two tools of each
                passes.push_back(
                    {"tool-" + std::to_string(tool), tool < 2 ? 6.0 : 10.0, *rc::gen::element(0.0, 0.0, 0.2, 0.5)});
            }
            const std::vector<std::size_t> ordered = indicesOf(orderPasses(passes));
            RC_ASSERT(isSensible(passes, ordered));
            std::vector<std::size_t> any(passes.size());
            std::iota(any.begin(), any.end(), std::size_t{0});
            RC_ASSERT(std::ranges::is_permutation(ordered, any));
            std::size_t fewest = passes.size();
            do {
                if (isSensible(passes, any)) fewest = std::min(fewest, changesIn(passes, any));
            } while (std::ranges::next_permutation(any).found);
            RC_ASSERT(changesIn(passes, ordered) == fewest);
        }));
    }
};

BURIN_TEST(TestToolOrder, NoApplication)

} // namespace burin::tst_tool_order

#include "tst_tool_order.moc"
