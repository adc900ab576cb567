// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <limits>

namespace burin::tst_numbers {

class TestNumbers : public QObject {
    Q_OBJECT

private slots:
    void fixedText_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("decimals");
        QTest::addColumn<QString>("text");
        QTest::newRow("rounds") << 12.34567 << 3 << "12.346";
        QTest::newRow("fills with zeros") << 5.0 << 3 << "5.000";
        QTest::newRow("no digits behind the point") << 2.4 << 0 << "2";
        QTest::newRow("a tie goes to the even digit") << 0.125 << 2 << "0.12";
        QTest::newRow("negative") << -0.5 << 1 << "-0.5";
        QTest::newRow("no minus before zero") << -0.0004 << 3 << "0.000";
        QTest::newRow("minus zero") << -0.0 << 1 << "0.0";
        QTest::newRow("no exponent, however large") << 1e22 << 0 << "10000000000000000000000";
        QTest::newRow("largest") << std::numeric_limits<double>::max() << 0
                                 << QString::number(std::numeric_limits<double>::max(), 'f', 0);
    }
    void fixedText() {
        QFETCH(double, value);
        QFETCH(int, decimals);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(formatFixed(value, decimals)), text);
    }

    void aLimitIsNeverUnderstated() {
        QCOMPARE(formatLimit(0.12349, 2), std::string("0.13"));
        QCOMPARE(formatLimit(0.1199, 2), std::string("0.12"));
        QCOMPARE(formatLimit(0.12, 2), std::string("0.12"));
        QCOMPARE(formatLimit(1e-13, 4), std::string("0.0001"));
        QCOMPARE(formatLimit(0.0, 4), std::string("0.0000"));
    }

    void aNumberHasItsUnit() {
        const auto read = [](const char* text) {
            const NumberWithUnit made = numberWithUnit(text);
            return std::pair(made.value.value_or(-1.0), made.unit);
        };
        QVERIFY(read(" 270 m/min ") == std::pair(270.0, std::string("m/min")));
        QVERIFY(read("0.5in") == std::pair(0.5, std::string("in")));
        QVERIFY(read("5") == std::pair(5.0, std::string()));
        QVERIFY(read("") == std::pair(-1.0, std::string()));
        QVERIFY(read("mm") == std::pair(-1.0, std::string("mm")));
        QVERIFY(read("  ") == std::pair(-1.0, std::string()));
    }

    void shortestTextReadsBackAsTheSameNumber() {
        const bool held = rc::check("any finite double", [] {
            const auto value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
            RC_PRE(std::isfinite(value));
            const auto read = parseNumber(formatShortest(value));
            RC_ASSERT(read.has_value());
            RC_ASSERT(std::bit_cast<std::uint64_t>(*read) == std::bit_cast<std::uint64_t>(value));
        });
        QVERIFY(held);
        QCOMPARE(formatShortest(0.1), std::string("0.1"));
    }

    void whatIsANumber_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("good");
        QTest::addColumn<double>("value");
        const auto row = [](const char* text, bool good, double value) {
            QTest::newRow(text) << text << good << value;
        };
        row("1.5", true, 1.5);
        row("+1.5", true, 1.5);
        row("-.5", true, -0.5);
        row("2.", true, 2.0);
        row("1e-3", true, 0.001);
        row("", false, 0);
        row("+", false, 0);
        row("+-1", false, 0);
        row("1,5", false, 0);
        row("1.5 ", false, 0);
        row(" 1.5", false, 0);
        row("1.5mm", false, 0);
        row("nan", false, 0);
        row("inf", false, 0);
        row("1e999", false, 0);
        row("0x10", false, 0);
    }
    void whatIsANumber() {
        QFETCH(QString, text);
        QFETCH(bool, good);
        QFETCH(double, value);
        const auto read = parseNumber(text.toStdString());
        QCOMPARE(read.has_value(), good);
        if (good) QCOMPARE(*read, value);
    }
};

BURIN_TEST(TestNumbers, NoApplication)

} // namespace burin::tst_numbers

#include "tst_numbers.moc"
