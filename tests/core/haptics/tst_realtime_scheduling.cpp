// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/loop_clock.h"
#include "core/haptics/loop/realtime_kit.h"
#include "core/haptics/loop/realtime_scheduling.h"
#include "core/haptics/loop/tick_thread.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QProcess>
#include <QtTest>

#include <atomic>
#include <linux/capability.h>
#include <mutex>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <systemd/sd-bus.h>
#include <thread>
#include <unistd.h>

namespace burin::tst_realtime_scheduling {

namespace {

/// The calling thread loses the right to raise any priority; other threads keep it.
void giveUpTheRight() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    std::array<__user_cap_data_struct, 2> data{};
    if (syscall(SYS_capget, &header, data.data()) != 0) return;
    data[0].effective &= ~(1U << CAP_SYS_NICE);
    data[0].permitted &= ~(1U << CAP_SYS_NICE);
    syscall(SYS_capset, &header, data.data());
}

/// Simulates RealtimeKit on a bus of the test's own: the same name, object, methods and properties, and the conditions
/// that it checks before it grants anything. Actually grants the class if this process may.
class StandIn {
public:
    StandIn() : thread_([this](const std::stop_token& stop) { serve(stop); }) {
        while (!ready_) std::this_thread::yield();
    }

    std::atomic<int> maximumPriority{20}, minimumNice{-15};
    std::atomic<bool> refusesRealtime{false};
    std::atomic<int> priority{0}, nice{0};
    std::atomic<bool> reallyGranted{false};

private:
    static int realtime(sd_bus_message* message, void* self, sd_bus_error* error) {
        auto& kit = *static_cast<StandIn*>(self);
        std::uint64_t thread = 0;
        std::uint32_t priority = 0;
        if (const int read = sd_bus_message_read(message, "tu", &thread, &priority); read < 0) return read;
        rlimit unbroken{};
        getrlimit(RLIMIT_RTTIME, &unbroken);
        const int policy = sched_getscheduler(static_cast<pid_t>(thread));
        if (kit.refusesRealtime || int(priority) > kit.maximumPriority || unbroken.rlim_max > 200'000 || policy < 0 ||
            (policy & SCHED_RESET_ON_FORK) == 0)
            return sd_bus_error_set_const(error, SD_BUS_ERROR_ACCESS_DENIED, "no");
        kit.priority = static_cast<int>(priority);
        const sched_param wanted{static_cast<int>(priority)};
        kit.reallyGranted =
            sched_setscheduler(static_cast<pid_t>(thread), SCHED_RR | SCHED_RESET_ON_FORK, &wanted) == 0;
        return sd_bus_reply_method_return(message, "");
    }
    static int high(sd_bus_message* message, void* self, sd_bus_error*) {
        auto& kit = *static_cast<StandIn*>(self);
        std::uint64_t thread = 0;
        int nice = 0;
        if (const int read = sd_bus_message_read(message, "ti", &thread, &nice); read < 0) return read;
        kit.nice = nice;
        kit.reallyGranted = setpriority(PRIO_PROCESS, static_cast<id_t>(thread), nice) == 0;
        return sd_bus_reply_method_return(message, "");
    }
    static int number(sd_bus*, const char*, const char*, const char* property, sd_bus_message* reply, void* self,
                      sd_bus_error*) {
        const auto& kit = *static_cast<StandIn*>(self);
        if (std::string_view(property) == "RTTimeUSecMax")
            return sd_bus_message_append(reply, "x", std::int64_t{200'000});
        const bool priority = std::string_view(property) == "MaxRealtimePriority";
        return sd_bus_message_append(reply, "i", priority ? kit.maximumPriority.load() : kit.minimumNice.load());
    }

    void serve(const std::stop_token& stop) {
        static const sd_bus_vtable table[] = {
            SD_BUS_VTABLE_START(0),
            SD_BUS_METHOD("MakeThreadRealtime", "tu", "", realtime, SD_BUS_VTABLE_UNPRIVILEGED),
            SD_BUS_METHOD("MakeThreadHighPriority", "ti", "", high, SD_BUS_VTABLE_UNPRIVILEGED),
            SD_BUS_PROPERTY("MaxRealtimePriority", "i", number, 0, SD_BUS_VTABLE_PROPERTY_CONST),
            SD_BUS_PROPERTY("MinNiceLevel", "i", number, 0, SD_BUS_VTABLE_PROPERTY_CONST),
            SD_BUS_PROPERTY("RTTimeUSecMax", "x", number, 0, SD_BUS_VTABLE_PROPERTY_CONST),
            SD_BUS_VTABLE_END};
        sd_bus* bus = nullptr;
        if (sd_bus_open_system(&bus) < 0 ||
            sd_bus_add_object_vtable(bus, nullptr, "/org/freedesktop/RealtimeKit1", "org.freedesktop.RealtimeKit1",
                                     table, this) < 0 ||
            sd_bus_request_name(bus, "org.freedesktop.RealtimeKit1", 0) < 0)
            std::abort(); // the test's own set-up
        ready_ = true;
        while (!stop.stop_requested())
            if (sd_bus_process(bus, nullptr) == 0) sd_bus_wait(bus, 10'000);
        sd_bus_flush_close_unref(bus);
    }

    std::atomic<bool> ready_{false};
    std::jthread thread_;
};

struct Observed {
    SchedulingClass obtained = SchedulingClass::normal;
    int policy = 0, priority = 0, nice = 0;
    int policyAfter = 0, niceAfter = 0;
};

/// The result for a thread without rights of its own.
template <class Work>
Observed withoutRights(Work&& work) {
    Observed seen;
    std::thread([&] {
        giveUpTheRight();
        {
            const RealtimeScheduling scheduling(RealtimeScheduling::Role::loop);
            seen.obtained = scheduling.obtained();
            sched_param parameters{};
            sched_getparam(0, &parameters);
            seen.policy = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
            seen.priority = parameters.sched_priority;
            seen.nice = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
            work(scheduling);
        }
        seen.policyAfter = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
        seen.niceAfter = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
    }).join();
    return seen;
}

const auto nothing = [](const RealtimeScheduling&) {};

} // namespace

/// Scheduling that the system grants the loop's thread, requested in the order of preference.
class TestRealtimeScheduling : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        rlimit priority{};
        getrlimit(RLIMIT_RTPRIO, &priority);
        if (priority.rlim_cur > 0) QSKIP("the limits in force grant SCHED_FIFO to anybody");
        bus_.start("dbus-daemon", {"--session", "--nofork", "--nopidfile", "--print-address"});
        QVERIFY2(bus_.waitForStarted(), "dbus-daemon is missing");
        QVERIFY(bus_.waitForReadyRead());
        qputenv("DBUS_SYSTEM_BUS_ADDRESS", bus_.readLine().trimmed());
    }
    void cleanupTestCase() {
        bus_.kill();
        bus_.waitForFinished();
    }

    void withoutTheServiceTheThreadStaysAsItIs() {
        const Observed seen = withoutRights(nothing);
        QCOMPARE(seen.obtained, SchedulingClass::normal);
        QCOMPARE(seen.policy, SCHED_OTHER);
    }

    void theServiceGrantsRoundRobin() {
        StandIn kit;
        const Observed seen = withoutRights(nothing);
        QCOMPARE(seen.obtained, SchedulingClass::roundRobin);
        QCOMPARE(kit.priority.load(), 19);
        QCOMPARE(seen.policyAfter, SCHED_OTHER); // restored
        if (!kit.reallyGranted) return;          // without rights of our own the simulated service can only report it
        QCOMPARE(seen.policy, SCHED_RR);
        QCOMPARE(seen.priority, 19);
    }

    void notMoreIsAskedForThanItGrants() {
        StandIn kit;
        kit.maximumPriority = 7;
        QCOMPARE(withoutRights(nothing).obtained, SchedulingClass::roundRobin);
        QCOMPARE(kit.priority.load(), 7);
    }

    void whoIsRefusedGetsANiceLevel() {
        StandIn kit;
        kit.refusesRealtime = true;
        const Observed seen = withoutRights(nothing);
        QCOMPARE(seen.obtained, SchedulingClass::nice);
        QCOMPARE(kit.nice.load(), -15);
        QCOMPARE(seen.niceAfter, 0);
        if (kit.reallyGranted) QCOMPARE(seen.nice, -15);
    }

    /// The kernel's warning would end the program: instead the thread loses its scheduling class, and that is reported.
    void aThreadThatNeverRestsLosesItsClassNotTheProgram() {
        StandIn kit;
        bool demoted = false;
        SchedulingClass after = SchedulingClass::roundRobin;
        const Observed seen = withoutRights([&](const RealtimeScheduling& scheduling) {
            if (!kit.reallyGranted) return;
            const std::int64_t until = now() + nanoseconds(5.0);
            while (scheduling.obtained() == SchedulingClass::roundRobin && now() < until) continue;
            demoted = (sched_getscheduler(0) & ~SCHED_RESET_ON_FORK) == SCHED_OTHER;
            after = scheduling.obtained();
        });
        QCOMPARE(seen.obtained, SchedulingClass::roundRobin);
        if (!kit.reallyGranted) QSKIP("nobody here may grant SCHED_RR");
        QVERIFY(demoted);
        QCOMPARE(after, SchedulingClass::normal);
    }

    void denormalsCountAsZeroWhereTheLoopRuns() {
        volatile double tiny = 1e-308, factor = 0.01;
        const double usual = tiny * factor;
        double inTheLoop = 1.0;
        {
            const DenormalsAreZero mode;
            inTheLoop = tiny * factor;
        }
        QVERIFY(usual > 0.0);
        QCOMPARE(inTheLoop, 0.0);
        QVERIFY(tiny * factor > 0.0); // restored
    }

    void whatIsLockedStaysInMemory() {
        std::vector<char> memory(64 * 1024);
        const auto locked = [] {
            QFile status(QStringLiteral("/proc/self/status"));
            if (!status.open(QIODevice::ReadOnly)) return -1;
            for (const QByteArray& line : status.readAll().split('\n'))
                if (line.startsWith("VmLck:")) return line.mid(6).trimmed().split(' ').front().toInt();
            return -1;
        };
        const int before = locked();
        {
            const LockedMemory lock(memory.data(), memory.size());
            QVERIFY(lock.locked());
            QVERIFY(locked() >= before + 60);
        }
        QCOMPARE(locked(), before);
    }

private:
    QProcess bus_;
};

BURIN_TEST(TestRealtimeScheduling, QCoreApplication)

} // namespace burin::tst_realtime_scheduling

#include "tst_realtime_scheduling.moc"
