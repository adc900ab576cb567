// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/work_offset.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_work_offset {

class TestWorkOffset : public QObject {
    Q_OBJECT
private slots:
    void namesAreThoseOfControls() {
        QCOMPARE(workOffsetName(54), std::string("G54"));
        QCOMPARE(workOffsetName(59), std::string("G59"));
        QCOMPARE(workOffsetName(591), std::string("G59.1"));
        QCOMPARE(workOffsetName(593), std::string("G59.3"));
        QCOMPARE(workOffsetName(1001), std::string("P1"));
        QCOMPARE(workOffsetName(1300), std::string("P300"));
    }

    void eachNameIsOfOneNumber() {
        for (const int number : {54, 55, 56, 57, 58, 59, 591, 592, 593})
            QCOMPARE(workOffsetFromName(workOffsetName(number)), std::optional(number));
        for (int further = 1; further <= 300; ++further)
            QCOMPARE(workOffsetFromName(workOffsetName(1000 + further)), std::optional(1000 + further));
        QCOMPARE(workOffsetFromName("g59.2"), std::optional(592));
        QCOMPARE(workOffsetFromName("p7"), std::optional(1007));
    }

    void othersAreNone() {
        for (const char* name :
             {"", "G", "P", "G53", "G60", "G59.4", "G59.0", "P0", "P301", "P-1", "P1x", "P1.5", "54"})
            QVERIFY2(!workOffsetFromName(name), name);
    }
};

BURIN_TEST(TestWorkOffset, NoApplication)

} // namespace burin::tst_work_offset

#include "tst_work_offset.moc"
