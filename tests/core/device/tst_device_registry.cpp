// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_registry.h"
#include "core/device/device_watch.h"
#include "core/device/simulated_stylus.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <condition_variable>
#include <fstream>
#include <set>
#include <stdexcept>

namespace burin::tst_device_registry {

namespace fs = std::filesystem;

namespace {

StylusDescription plainDescription() {
    StylusDescription description;
    description.name = "plain";
    description.workspaceRadius = {50.0, "made up"};
    return description;
}

class PlainStylus final : public Stylus {
public:
    explicit PlainStylus(StylusDescription description) : description_(std::move(description)) {}
    StylusDescription description() const override { return description_; }
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    StylusState read(double time) noexcept override { return {time, {}, 0, true}; }
    void write(const Wrench&) noexcept override {}

private:
    StylusDescription description_;
};

/// A driver with the devices that a test plugs in. Thread-safe.
class Shelf final : public DeviceDriver {
public:
    std::vector<FoundDevice> find() override {
        const std::lock_guard lock(mutex);
        if (throws) throw std::runtime_error("the bus is gone");
        return devices;
    }
    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        madeId = id;
        madeMode = mode;
        if (throws) throw std::runtime_error("the bus is gone");
        if (id == "none") return AnyStylus(std::unique_ptr<Stylus>());
        return AnyStylus(std::unique_ptr<Stylus>(std::make_unique<PlainStylus>(description)));
    }
    void put(std::vector<FoundDevice> now) {
        const std::lock_guard lock(mutex);
        devices = std::move(now);
    }

    std::mutex mutex;
    std::vector<FoundDevice> devices;
    StylusDescription description = plainDescription();
    std::string madeId, madeMode;
    bool throws = false;
};

struct Fixture {
    Fixture() : registry(fs::path(folder.path().toStdString()) / "none") {
        auto made = std::make_unique<Shelf>();
        shelf = made.get();
        registry.add("shelf", std::move(made));
    }
    QTemporaryDir folder;
    DeviceRegistry registry;
    Shelf* shelf;
};

void plugin(const fs::path& root, const std::string& name, const std::string& metadata) {
    fs::create_directories(root / name);
    std::ofstream(root / name / "plugin.json") << metadata;
}

std::string metadata(const std::string& id, int version) {
    return "{\"id\": \"" + id + "\", \"kind\": \"device\", \"name\": \"N\", \"version\": \"1\", " +
           "\"library\": \"libnone.so\", \"interface_version\": " + std::to_string(version) + "}";
}

} // namespace

class TestDeviceRegistry : public QObject {
    Q_OBJECT
private slots:
    void aDeviceIsFoundByItsIdOrAnUnmistakableName() {
        Fixture test;
        QCOMPARE(test.registry.find("one").error().code, ErrorCode::nameUnknown);
        QVERIFY(test.registry.find("one").error().detail.empty());
        test.shelf->put({{"one", "Pen", {}}, {"two", "Pen", {}}, {"three", "Arm", {}}});
        QCOMPARE(test.registry.find("shelf:two")->id, std::string("shelf:two"));
        QCOMPARE(test.registry.find("Arm")->id, std::string("shelf:three"));
        for (const char* none : {"Pen", "pen", "two", simulatedDevice}) {
            const auto missing = test.registry.find(none);
            QVERIFY(!missing);
            QCOMPARE(missing.error().subject, std::string("device"));
            QCOMPARE(missing.error().place, std::string(none));
            QCOMPARE(missing.error().detail, std::string("shelf:one, shelf:two, shelf:three"));
        }
    }

    void theSimulatedStylusIsAlwaysThere() {
        QTemporaryDir folder;
        DeviceRegistry registry(fs::path(folder.path().toStdString()) / "none");
        const auto found = registry.scan();
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].id, std::string(simulatedDevice));
        auto stylus = registry.make(simulatedDevice);
        QVERIFY(stylus);
        auto* called = std::get_if<std::unique_ptr<Stylus>>(&*stylus);
        QVERIFY(called != nullptr && dynamic_cast<SimulatedStylus*>(called->get()) != nullptr);
        QVERIFY((*called)->open());
        QVERIFY((*called)->read(0.0).valid);
        QVERIFY(registry.takeFaults().empty()); // a missing folder of plugins is no fault
    }

    void devicesAreNamedAfterTheirDriver() {
        Fixture test;
        test.shelf->put({{"a", "A", {}}, {"b:c", "B", {{"rate", {}}}}});
        const auto found = test.registry.scan();
        QCOMPARE(found.size(), std::size_t{3});
        QCOMPARE(found[1].id, std::string("shelf:a"));
        QCOMPARE(found[2].id, std::string("shelf:b:c"));
        QVERIFY(test.registry.make("shelf:b:c", "rate"));
        QCOMPARE(test.shelf->madeId, std::string("b:c"));
        QCOMPARE(test.shelf->madeMode, std::string("rate"));
    }

    void anUnknownDriverIsNotFound() {
        Fixture test;
        const auto made = test.registry.make("attic:a");
        QVERIFY(!made);
        QCOMPARE(made.error().code, ErrorCode::deviceNotFound);
        QCOMPARE(made.error().subject, std::string("attic:a"));
    }

    void aDescriptionThatBreaksARuleIsNotLetIn() {
        Fixture test;
        test.shelf->description.maximumForce = {3.0, ""};
        const auto made = test.registry.make("shelf:a");
        QVERIFY(!made);
        QCOMPARE(made.error().code, ErrorCode::pluginInvalid);
        QVERIFY(made.error().detail.find("maximum force") != std::string::npos);
        QCOMPARE(test.registry.make("shelf:none").error().code, ErrorCode::pluginInvalid);
    }

    void foreignCodeThatThrowsCostsAMessage() {
        Fixture test;
        test.shelf->throws = true;
        QCOMPARE(test.registry.scan().size(), std::size_t{1});
        const auto faults = test.registry.takeFaults();
        QCOMPARE(faults.size(), std::size_t{1});
        QVERIFY(faults[0].detail.find("the bus is gone") != std::string::npos);
        QVERIFY(test.registry.takeFaults().empty());
        QCOMPARE(test.registry.make("shelf:a").error().code, ErrorCode::pluginInvalid);
    }

    void aBrokenPluginDoesNotKeepTheOthersAway() {
        QTemporaryDir folder;
        const fs::path root = folder.path().toStdString();
        plugin(root, "broken", "{");
        plugin(root, "newer", metadata("newer", DeviceDriver::interfaceVersion + 1));
        plugin(root, "missing", metadata("missing", DeviceDriver::interfaceVersion));
        plugin(root, "twice", metadata("missing", DeviceDriver::interfaceVersion));
        plugin(root, "dialect", R"({"id": "d", "kind": "dialect", "name": "N", "version": "1", "library": "l.so",
                                    "interface_version": 1})");
        DeviceRegistry registry(root);
        QCOMPARE(registry.scan().size(), std::size_t{1}); // the simulated stylus
        std::multiset<ErrorCode> codes;
        for (const Error& fault : registry.takeFaults()) codes.insert(fault.code);
        const std::multiset<ErrorCode> expected{ErrorCode::pluginInvalid, ErrorCode::pluginInvalid,
                                                ErrorCode::pluginInvalid, ErrorCode::pluginInvalid,
                                                ErrorCode::pluginIncompatible};
        QVERIFY(codes == expected);
    }

    void aPluginOfOtherHeadersIsNotRun() {
        QTemporaryDir folder;
        const fs::path root = folder.path().toStdString();
        std::string text = metadata("strange", DeviceDriver::interfaceVersion);
        plugin(root, "strange", text.replace(text.find("libnone.so"), 10, "libstrange.so"));
        fs::copy_file(fs::path(BURIN_BUILD_DIRECTORY) / "stand-ins/strange/libstrange.so",
                      root / "strange/libstrange.so");
        DeviceRegistry registry(root);
        const std::vector<Error> faults = registry.takeFaults();
        QCOMPARE(faults.size(), std::size_t{1});
        QCOMPARE(faults[0].code, ErrorCode::pluginInvalid);
        QVERIFY2(faults[0].detail.find("StylusState") != std::string::npos, faults[0].detail.c_str());
    }

    void theUsersOwnPluginsStandFirst() {
        QTemporaryDir home;
        qputenv("XDG_DATA_HOME", home.path().toUtf8());
        const fs::path own = fs::path(home.path().toStdString()) / "burin/plugins/devices/mine";
        fs::create_directories(own.parent_path());
        fs::copy(fs::path(BURIN_BUILD_DIRECTORY) / "plugins/devices/spacenav", own);
        DeviceRegistry registry;
        for (const Error& fault : registry.takeFaults()) QFAIL(fault.detail.c_str());
        std::vector<std::string> ids;
        for (const DriverState& driver : registry.drivers()) ids.push_back(driver.id);
        QVERIFY(ids.size() >= 2 && ids[1] == "spacenav"); // before those of the build, and only once
        QCOMPARE(std::ranges::count(ids, std::string("spacenav")), 1);
        qunsetenv("XDG_DATA_HOME");
    }

    void thePluginsOfThisBuildLoad() {
        DeviceRegistry registry(fs::path(BURIN_BUILD_DIRECTORY) / "plugins/devices");
        for (const Error& fault : registry.takeFaults()) qWarning("%s", fault.detail.c_str());
        // Two more drivers than the simulated one handle their own ids, which are not reported as unknown.
        QCOMPARE(registry.make("spacemouse:nothing").error().subject, std::string("nothing"));
        QCOMPARE(registry.make("open_stylus:nothing").error().subject, std::string("nothing"));
    }

    void changesAreTold() {
        const FoundDevice a{"a", "A", {}}, b{"b", "B", {}}, c{"c", "C", {}};
        const auto changes = changesBetween({a, b}, {b, c});
        QCOMPARE(changes.size(), std::size_t{2});
        QVERIFY(!changes[0].arrived && changes[0].device.id == "a");
        QVERIFY(changes[1].arrived && changes[1].device.id == "c");
        QVERIFY(changesBetween({a, b}, {b, a}).empty());
    }

    void theWatchTellsWhatIsPluggedInAndOut() {
        Fixture test;
        test.shelf->put({{"a", "A", {}}});
        std::mutex mutex;
        std::condition_variable told;
        std::vector<std::string> heard;
        const auto waitFor = [&](std::size_t count) {
            std::unique_lock lock(mutex);
            return told.wait_for(lock, std::chrono::seconds(20), [&] { return heard.size() >= count; });
        };
        {
            const DeviceWatch watch(
                test.registry,
                [&](const DeviceChange& change) {
                    const std::lock_guard lock(mutex);
                    heard.push_back((change.arrived ? "+" : "-") + change.device.id);
                    told.notify_all();
                },
                std::chrono::milliseconds(5));
            QVERIFY(waitFor(1));
            test.shelf->put({{"b", "B", {}}});
            QVERIFY(waitFor(3));
            test.shelf->put({});
            QVERIFY(waitFor(4));
        }
        QCOMPARE(heard, (std::vector<std::string>{"+shelf:a", "-shelf:a", "+shelf:b", "-shelf:b"}));
    }
};

BURIN_TEST(TestDeviceRegistry, NoApplication)

} // namespace burin::tst_device_registry

#include "tst_device_registry.moc"
