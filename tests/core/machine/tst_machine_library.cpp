// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/resource_folder.h"
#include "core/machine/machine_library.h"
#include "tests/test_program.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_machine_library {

namespace {

/// Only the keys that are required.
const char* const shortProfile =
    "{\"id\": \"own\", \"name\": \"own\", \"source\": \"measured\", \"travel_mm\": [300, 200, 100],"
    "\"maximum_feed_mm_per_min\": 1000, \"rapid_feed_mm_per_min\": 3000, \"minimum_spindle_speed_rpm\": 0,"
    "\"maximum_spindle_speed_rpm\": 8000, \"acceleration_mm_per_s2\": 250, \"tool_change_height_mm\": 20,"
    "\"coordinate_decimals\": 3, \"maximum_line_length\": 80}";

/// With every key that a file may have, none of them at its default.
const char* const fullProfile = R"({
  "id": "full", "name": "All keys", "source": "nameplate", "sources": {"travel_mm": "measured", "coolant": "fitted"},
  "dialect": "haas", "travel_mm": [301.5, 202, 103], "maximum_feed_mm_per_min": 1000, "rapid_feed_mm_per_min": 3000,
  "axis_rates_mm_per_min": [3000, 2900, 1500], "acceleration_mm_per_s2": 250,
  "axis_accelerations_mm_per_s2": [240, 230, 120.5], "axis_jerks_mm_per_s3": [9000, 8000, 7000],
  "blocks_per_second": 40, "rapids": "tip", "junctions": {"rule": "deviation", "tolerance_mm": 0.015},
  "minimum_spindle_speed_rpm": 100, "maximum_spindle_speed_rpm": 8000, "spindle_power_w": 750,
  "spindle_torque": [{"speed_rpm": 500, "torque_nm": 12.5}, {"speed_rpm": 8000, "torque_nm": 0.9}],
  "tool_change_height_mm": 20, "tool_change_s": 7.5, "home_mm": [-10, 201.5, 0],
  "arcs": {"largest_sweep_deg": 355, "smallest_radius_mm": 0.05, "largest_radius_mm": 900, "radius_mismatch_mm": 0.004},
  "rotary_axes": [{"axis": "C", "reversed": true, "rate_deg_per_min": 7200},
                  {"axis": "B", "low_deg": -30.5, "high_deg": 110, "acceleration_deg_per_s2": 250}],
  "coolant": {"mist": true, "flood": false}, "coordinate_decimals": 4, "maximum_line_length": 80})";

/// A file as plain JSON, parsed only by the JSON library.
nlohmann::json plain(const std::string& text) {
    return nlohmann::json::parse(text);
}

} // namespace

class MachineLibraryTest : public QObject {
    Q_OBJECT

    QTemporaryDir userData_;

private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", userData_.path().toUtf8()); }

    void everyShippedMachineLoads() {
        QVERIFY(!machineIds().empty());
        for (const std::string& id : machineIds()) {
            const Result<MachineProfile> machine = loadMachine(id);
            QVERIFY2(machine.hasValue(), machine ? "" : (id + ": " + machine.error().place).c_str());
            QCOMPARE(machine->id, id);
            QVERIFY(machine->rapidFeed >= machine->maximumFeed);
            QVERIFY(machine->toolChangeHeight < machine->travel.z);
            QVERIFY(!machine->dialect.empty());
            for (int axis = 0; axis < 3; ++axis) {
                QVERIFY(machine->axisRate(axis) > 0.0 && machine->axisRate(axis) <= machine->rapidFeed);
                QVERIFY(machine->axisAcceleration(axis) > 0.0);
            }
        }
    }

    void thereIsOneToStartFromForEveryKindOfControl() {
        const std::vector<std::string> ids = machineIds();
        for (const char* id : {"linuxcnc-mill", "grbl-router", "grblhal-router", "haas-mill", "fanuc-mill", "mach-mill",
                               "linuxcnc-five-axis"})
            QVERIFY2(std::find(ids.begin(), ids.end(), id) != ids.end(), id);
    }

    /// Values of GRBL's own defaults for that router, and rules stated in its documentation.
    void theGrblRouterIsAsGrblSaysItIs() {
        const Result<MachineProfile> router = loadMachine("grbl-router");
        QVERIFY(router.hasValue());
        QCOMPARE(router->travel, glm::dvec3(425.0, 465.0, 80.0));
        QCOMPARE(router->axisRate(2), 5000.0);
        QCOMPARE(router->axisAcceleration(0), 400.0);
        QVERIFY(router->junctions == JunctionRule::deviation);
        QCOMPARE(router->junctionTolerance, 0.02);
        QVERIFY(router->rapids == RapidMode::synchronised);
        QCOMPARE(router->maximumLineLength, 79);
        QVERIFY(router->arcs.radiusMismatch <= 0.005);
        QVERIFY(router->has(Coolant::off) && !router->has(Coolant::mist) && !router->has(Coolant::flood));
        QVERIFY(router->sources.at("travel_mm").find("SHAPEOKO_3") != std::string::npos);
    }

    /// Each axis moves at its own rate unless a parameter changes that: the classic dog-leg.
    void largeControlsBendTheirRapids() {
        for (const char* id : {"haas-mill", "fanuc-mill"}) QVERIFY(loadMachine(id)->rapids == RapidMode::independent);
    }

    void aControlMayStateItsBlockRate() {
        QCOMPARE(loadMachine("haas-mill")->blocksPerSecond, 1000.0);
        QCOMPARE(loadMachine("fanuc-mill")->blocksPerSecond, 0.0);
    }

    /// Constant torque up to 1000 1/min, then constant power, then falling: P = M · 2 pi n / 60 by hand.
    void aSpindleGivesWhatItsCurveSays() {
        QString text = QString::fromUtf8(shortProfile);
        text.insert(1, "\"spindle_power_w\": 5000, \"spindle_torque\": [{\"speed_rpm\": 1000, \"torque_nm\": 30},"
                       "{\"speed_rpm\": 3000, \"torque_nm\": 10}, {\"speed_rpm\": 6000, \"torque_nm\": 2.5}],");
        const Result<MachineProfile> own = machineFromJson(text.toStdString(), "own.json");
        QVERIFY(own.hasValue());
        QCOMPARE(own->torqueAt(200.0), 30.0);
        QVERIFY(std::abs(own->powerAt(200.0) - 628.3) < 0.1);
        QVERIFY(std::abs(own->powerAt(1500.0) - 3141.6) < 0.1); // between the first two: constant power
        QVERIFY(std::abs(own->torqueAt(1500.0) - 20.0) < 1e-9);
        QVERIFY(std::abs(own->powerAt(4500.0) - 0.5 * (3141.6 + 1570.8)) < 0.1);
        QVERIFY(std::abs(own->powerAt(8000.0) - 1570.8) < 0.1); // beyond the last point the power is constant
        QVERIFY(std::abs(own->torqueAt(8000.0) - 1.875) < 1e-9);

        const Result<MachineProfile> without = machineFromJson(shortProfile, "own.json");
        QCOMPARE(without->torqueAt(1000.0), 0.0); // not stated
        QCOMPARE(without->powerAt(1000.0), 0.0);
    }
    /// The curve of a shipped machine does not exceed the machine's stated power.
    void torqueAndPowerOfAShippedMachineAgree() {
        for (const std::string& id : machineIds()) {
            const Result<MachineProfile> machine = loadMachine(id);
            for (const SpindlePoint& point : machine->spindleTorque)
                QVERIFY2(point.torque * point.speed * 2.0 * pi / 60.0 <= 1.01 * machine->spindlePower, id.c_str());
        }
    }

    void whatAMachineDoesNotStateHasItsDefault() {
        const Result<MachineProfile> own = machineFromJson(shortProfile, "own.json");
        QVERIFY(own.hasValue());
        QCOMPARE(own->axisRate(1), 3000.0);
        QCOMPARE(own->axisAcceleration(2), 250.0);
        QCOMPARE(own->axisJerks, glm::dvec3(0.0));
        QCOMPARE(own->blocksPerSecond, 0.0);
        QCOMPARE(own->arcs.largestSweep, 2.0 * pi);
        QCOMPARE(own->toolChangeSeconds, 0.0);
        QVERIFY(own->has(Coolant::mist) && own->has(Coolant::flood)); // not excluded by the file
        QVERIFY(own->dialect.empty() && own->sources.empty());
    }

    void theExampleMillTakesTheSamplePart() {
        const Result<MachineProfile> mill = loadMachine("linuxcnc-mill");
        QVERIFY(mill.hasValue());
        QVERIFY(mill->travel.x >= 150.0 && mill->travel.y >= 100.0 && mill->travel.z >= 150.0);
        QCOMPARE(mill->maximumSpindleSpeed, 24000.0);
        QCOMPARE(mill->maximumLineLength, 255);
        QVERIFY(mill->source.find("example") != std::string::npos);
    }

    /// Nothing in a file is lost, whatever it contains: written again it is the same, key by key.
    void aWrittenMachineIsTheOneThatWasRead() {
        const Result<MachineProfile> full = machineFromJson(fullProfile, "full.json");
        QVERIFY2(full.hasValue(), full ? "" : full.error().place.c_str());
        QVERIFY(plain(toJson(*full)) == plain(fullProfile));
        for (const std::string& id : machineIds()) {
            const Result<ResourceText> file = findResource(machineResource, id);
            QVERIFY(file.hasValue());
            const nlohmann::json written = plain(toJson(*loadMachine(id)));
            const nlohmann::json read = plain(file->text);
            for (const auto& [key, value] : read.items())
                QVERIFY2(written.contains(key) && written.at(key) == value, (id + ": " + key).c_str());
        }
        const Result<MachineProfile> brief = machineFromJson(shortProfile, "own.json");
        const Result<MachineProfile> again = machineFromJson(toJson(*brief), "again.json");
        QVERIFY(again.hasValue());
        QCOMPARE(again->spindlePower, 0.0);
        QVERIFY(!again->coolants && again->dialect.empty());
        QCOMPARE(toJson(*again), toJson(*brief));
    }

    void aMachineOfTheUserIsKeptChangedAndDeleted() {
        MachineProfile own = copyOf(*loadMachine("haas-mill"), "shop-vf2", "VF-2 in the shop");
        QVERIFY(own.source.find("haas-mill") != std::string::npos);
        QVERIFY(saveMachine(own, false).hasValue());
        QVERIFY(!isTypicalMachine("shop-vf2"));
        QCOMPARE(loadMachine("shop-vf2")->name, std::string("VF-2 in the shop"));
        QVERIFY(saveMachine(own, false).error().code == ErrorCode::argumentInvalid); // it already exists
        own.maximumSpindleSpeed = 7500.0;
        QVERIFY(saveMachine(own, true).hasValue());
        QCOMPARE(loadMachine("shop-vf2")->maximumSpindleSpeed, 7500.0);
        QCOMPARE(QDir(userData_.filePath("burin/machines")).entryList(QDir::Files | QDir::Hidden),
                 QStringList{"shop-vf2.json"}); // no other file is left
        QVERIFY(removeMachine("shop-vf2").hasValue());
        QVERIFY(loadMachine("shop-vf2").error().code == ErrorCode::nameUnknown);
        QVERIFY(removeMachine("shop-vf2").error().code == ErrorCode::nameUnknown);
    }

    void aShippedMachineStaysAsItIs() {
        MachineProfile shipped = *loadMachine("haas-mill");
        QVERIFY(isTypicalMachine("haas-mill"));
        shipped.maximumFeed = 1.0;
        QVERIFY(saveMachine(shipped, true).error().code == ErrorCode::argumentInvalid);
        QVERIFY(removeMachine("haas-mill").error().code == ErrorCode::argumentInvalid);
        QVERIFY(loadMachine("haas-mill")->maximumFeed > 1.0);
    }

    /// Values that a file may not contain are not stored either, and the parts of the message name the file, the key
    /// and the permitted values.
    void aMachineOutOfRangeIsNotKept() {
        MachineProfile own = copyOf(*loadMachine("haas-mill"), "wrong", "wrong");
        own.acceleration = 0.0;
        const Result<std::filesystem::path> kept = saveMachine(own, false);
        QVERIFY(!kept.hasValue());
        QCOMPARE(kept.error().subject, std::string("wrong.json"));
        QCOMPARE(kept.error().place, std::string("acceleration_mm_per_s2"));
        QVERIFY(kept.error().detail.find("1") != std::string::npos);
        own.acceleration = 1000.0;
        own.id = "../wrong";
        QVERIFY(saveMachine(own, false).error().code == ErrorCode::argumentInvalid);
        QVERIFY(!QDir(userData_.path()).exists("burin/machines/wrong.json"));
    }

    void anUnknownMachineNamesThoseThereAre() {
        const Result<MachineProfile> machine = loadMachine("dmu-50");
        QVERIFY(!machine.hasValue());
        QVERIFY(machine.error().code == ErrorCode::nameUnknown);
        QCOMPARE(machine.error().subject, std::string("machine"));
        QVERIFY(machine.error().detail.find("linuxcnc-mill") != std::string::npos);
    }

    void aBrokenFileNamesItsKey_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("key");
        QTest::newRow("two axes") << "[500, 400, 250]"
                                  << "[500, 400]"
                                  << "travel_mm";
        QTest::newRow("an axis of text") << "[500, 400, 250]"
                                         << R"([500, "400", 250])"
                                         << "travel_mm[1]";
        QTest::newRow("negative feed") << R"("maximum_feed_mm_per_min": 4000)"
                                       << R"("maximum_feed_mm_per_min": -1)"
                                       << "maximum_feed_mm_per_min";
        QTest::newRow("spindle upside down") << R"("minimum_spindle_speed_rpm": 3000)"
                                             << R"("minimum_spindle_speed_rpm": 30000)"
                                             << "minimum_spindle_speed_rpm";
        QTest::newRow("rapids of no kind") << R"("synchronised")"
                                           << R"("diagonal")"
                                           << "rapids";
        QTest::newRow("an axis beyond the rapids") << "[6000, 6000, 3000]"
                                                   << "[6000, 7000, 3000]"
                                                   << "axis_rates_mm_per_min[1]";
        QTest::newRow("torque upside down") << "\"spindle_power_w\": 2200,"
                                            << "\"spindle_torque\": [{\"speed_rpm\": 9000, \"torque_nm\": 1},"
                                               "{\"speed_rpm\": 8000, \"torque_nm\": 1}],"
                                            << "spindle_torque[1].speed_rpm";
        QTest::newRow("a blend by nothing") << R"("tolerance_mm": 0.01)"
                                            << R"("tolerance_mm": 0)"
                                            << "junctions.tolerance_mm";
        QTest::newRow("arcs upside down") << R"("smallest_radius_mm": 0.02)"
                                          << R"("smallest_radius_mm": 2000)"
                                          << "arcs.smallest_radius_mm";
        QTest::newRow("a source of nothing") << "\"rapids\": \"EMC"
                                             << "\"jerk\": \"EMC"
                                             << "sources.jerk";
        QTest::newRow("a tool change above the travel") << R"("tool_change_height_mm": 60)"
                                                        << R"("tool_change_height_mm": 260)"
                                                        << "tool_change_height_mm";
        QTest::newRow("a home beyond the travel") << R"("coordinate_decimals": 3)"
                                                  << R"("home_mm": [-500, -401, 0], "coordinate_decimals": 3)"
                                                  << "home_mm[1]";
        QTest::newRow("missing") << R"("coordinate_decimals": 3,)"
                                 << ""
                                 << "coordinate_decimals";
        QTest::newRow("unknown") << R"("coordinate_decimals")"
                                 << R"("axes": 5, "coordinate_decimals")"
                                 << "axes";
    }
    void aBrokenFileNamesItsKey() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, key);
        QString text = QString::fromStdString(findResource(machineResource, "linuxcnc-mill")->text);
        QVERIFY(text.contains(from));
        const Result<MachineProfile> machine = machineFromJson(text.replace(from, to).toStdString(), "bad.json");
        QVERIFY(!machine.hasValue());
        QVERIFY(machine.error().code == ErrorCode::resourceInvalid);
        QCOMPARE(QString::fromStdString(machine.error().place), key);
    }
};

BURIN_TEST(MachineLibraryTest, NoApplication)

} // namespace burin::tst_machine_library

#include "tst_machine_library.moc"
