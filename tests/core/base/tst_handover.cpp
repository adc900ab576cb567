// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/handover.h"
#include "core/base/mailbox.h"
#include "core/base/progress.h"
#include "core/base/ring.h"
#include "tests/test_program.h"

#include <QtTest>

#include <array>
#include <cstdint>
#include <memory>
#include <thread>

namespace burin::tst_handover {

namespace {

/// A value that reveals when half of it comes from another one.
struct Whole {
    std::array<std::uint64_t, 16> copies{};
    static Whole of(std::uint64_t value) {
        Whole whole;
        whole.copies.fill(value);
        return whole;
    }
    bool intact() const { return copies.front() == copies.back() && *this == of(copies.front()); }
    friend bool operator==(const Whole&, const Whole&) = default;
};

} // namespace

class TestHandover : public QObject {
    Q_OBJECT

private slots:
    void aMailboxGivesTheNewestOnce() {
        Mailbox<int> mailbox;
        int value = -1;
        QVERIFY(!mailbox.take(value));
        mailbox.post(1);
        mailbox.post(2);
        QVERIFY(mailbox.take(value));
        QCOMPARE(value, 2);
        QVERIFY(!mailbox.take(value));
        QCOMPARE(value, 2);
    }

    void aMailboxBetweenThreadsGivesWholeValuesInOrderUpToTheLast() {
        Mailbox<Whole> mailbox;
        constexpr std::uint64_t last = 200000;
        std::jthread writer([&] {
            for (std::uint64_t i = 1; i <= last; ++i) mailbox.post(Whole::of(i));
        });
        std::uint64_t before = 0, torn = 0, backwards = 0;
        while (before < last) {
            Whole value;
            if (!mailbox.take(value)) {
                std::this_thread::yield();
                continue;
            }
            if (!value.intact()) ++torn;
            if (value.copies[0] <= before) ++backwards;
            before = value.copies[0];
        }
        QCOMPARE(torn, std::uint64_t{0});
        QCOMPARE(backwards, std::uint64_t{0});
    }

    void aFullRingRefusesAndKeepsWhatItHas() {
        Ring<int> ring(3); // rounded up to 4
        QCOMPARE(ring.capacity(), std::size_t{4});
        for (int i = 0; i < 4; ++i) QVERIFY(ring.push(i));
        QVERIFY(!ring.push(4));
        QCOMPARE(ring.size(), std::size_t{4});
        std::array<int, 3> taken{};
        QCOMPARE(ring.pop(taken), std::size_t{3});
        QVERIFY((taken == std::array{0, 1, 2}));
        QVERIFY(ring.push(5));
        QCOMPARE(ring.pop(taken), std::size_t{2});
        QCOMPARE(taken[0], 3);
        QCOMPARE(taken[1], 5);
        QCOMPARE(ring.pop(taken), std::size_t{0});
    }

    void aRingBetweenThreadsLosesNothingAndKeepsTheOrder() {
        Ring<Whole> ring(64);
        constexpr std::uint64_t last = 200000;
        std::jthread writer([&] {
            for (std::uint64_t i = 1; i <= last;)
                if (ring.push(Whole::of(i)))
                    ++i;
                else
                    std::this_thread::yield();
        });
        std::array<Whole, 17> taken;
        std::uint64_t expected = 1, wrong = 0;
        while (expected <= last) {
            const std::size_t count = ring.pop(taken);
            if (count == 0) std::this_thread::yield();
            for (std::size_t i = 0; i < count; ++i)
                if (taken[i] != Whole::of(expected++)) ++wrong;
        }
        QCOMPARE(wrong, std::uint64_t{0});
    }

    /// Values that own memory pass from thread to thread complete and in order, and no copy remains in between.
    void aHandoverBetweenThreadsLosesNothing() {
        Handover<std::shared_ptr<std::uint64_t>, 3> handover;
        constexpr std::uint64_t last = 100000;
        std::jthread writer([&] {
            for (std::uint64_t i = 1; i <= last;)
                if (handover.full())
                    std::this_thread::yield();
                else
                    handover.put(std::make_shared<std::uint64_t>(i++));
        });
        std::uint64_t expected = 1, wrong = 0;
        for (std::shared_ptr<std::uint64_t> taken; expected <= last;) {
            if (!handover.take(taken))
                std::this_thread::yield();
            else if (*taken != expected++ || taken.use_count() != 1)
                ++wrong;
        }
        QCOMPARE(wrong, std::uint64_t{0});
        std::shared_ptr<std::uint64_t> none;
        QVERIFY(!handover.take(none) && !none);
    }

    void progressMapsEachStageToItsPartOfTheWhole() {
        Progress progress;
        progress.report(0.5);
        QCOMPARE(progress.fraction(), 0.5);
        progress.stage(0.6, 0.8);
        QCOMPARE(progress.fraction(), 0.6);
        progress.report(2.0);
        QCOMPARE(progress.fraction(), 0.8);
        QVERIFY(!progress.cancelled());
        progress.cancel();
        QVERIFY(progress.cancelled());
    }
};

BURIN_TEST(TestHandover, NoApplication)

} // namespace burin::tst_handover

#include "tst_handover.moc"
