// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/recorded_removal.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_recorded_removal {

class TestRecordedRemoval : public QObject {
    Q_OBJECT

private slots:
    /// As many materials as a list may hold, and grades up to the limit: no removed amount is lost.
    void gradesCountAsTheirMaterial() {
        PropertyList list;
        Property property;
        for (int i = 0; i < maximumMachinableMaterials; ++i) {
            property.id = "m" + std::to_string(i);
            QVERIFY(list.add(property));
        }
        for (int i = maximumMachinableMaterials; i < maximumMachinableProperties; ++i) {
            property.id = "g" + std::to_string(i);
            property.base = "m" + std::to_string(i % 5);
            QVERIFY(list.add(property));
        }
        CutResult cut;
        std::array<std::uint64_t, 256> expected{};
        for (std::size_t i = 0; i < cut.removed.size(); ++i) {
            const auto entry = static_cast<PropertyIndex>(i + 1);
            cut.removed[i] = {entry, 1000 + 7 * i, 0.0, 0.0};
            const auto material = entry <= maximumMachinableMaterials ? entry : static_cast<PropertyIndex>(i % 5 + 1);
            expected[material] += cut.removed[i].units;
        }
        Sample sample;
        recordRemoval(cut, list, sample);
        std::array<std::uint64_t, 256> found{};
        for (const RemovedMaterial& entry : sample.removed) found[entry.property] += entry.units;
        QVERIFY(found == expected);
    }

    void whatWasNotUsedStaysFree() {
        PropertyList list;
        Property property;
        property.id = "stock";
        QVERIFY(list.add(property));
        CutResult cut;
        cut.removed[0] = {1, 55, 0.0, 0.0};
        Sample sample;
        recordRemoval(cut, list, sample);
        QCOMPARE(sample.removed[0].units, std::uint64_t{55});
        QCOMPARE(sample.removed[0].property, std::uint8_t{1});
        QCOMPARE(sample.removed[1].property, std::uint8_t{0});
    }
};

BURIN_TEST(TestRecordedRemoval, NoApplication)

} // namespace burin::tst_recorded_removal

#include "tst_recorded_removal.moc"
