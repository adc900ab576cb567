// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/csv.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_csv {

namespace {

/// Quotes a field as RFC 4180 does; it may contain anything except line ends.
std::string quoted(const std::string& field) {
    std::string text = "\"";
    for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + "\"";
}

} // namespace

class CsvTest : public QObject {
    Q_OBJECT
private slots:
    void quotedFieldsComeBackAsTheyWere() {
        QVERIFY(rc::check([] {
            const auto fields = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(
                rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab ,\";\t")))));
            std::string line;
            for (const std::string& field : fields) line += (line.empty() ? "" : ",") + quoted(field);
            const auto read = csvFields(line);
            RC_ASSERT(read.has_value());
            RC_ASSERT(*read == fields);
        }));
    }

    void plainFieldsLoseTheBlanksAround() {
        QCOMPARE(csvFields(" a , b c,,\t1.5 ").value(), (std::vector<std::string>{"a", "b c", "", "1.5"}));
        QCOMPARE(csvFields("").value(), std::vector<std::string>{""});
    }

    void brokenQuotesAreSeen() {
        QVERIFY(!csvFields("\"a").has_value());
        QVERIFY(!csvFields("\"a\"b,c").has_value());
        QVERIFY(!csvFields("1,\"\"\"").has_value());
    }

    void linesEndInEitherWay() {
        std::string_view rest = "one\r\ntwo\n\nlast";
        QCOMPARE(takeLine(rest), std::string_view("one"));
        QCOMPARE(takeLine(rest), std::string_view("two"));
        QCOMPARE(takeLine(rest), std::string_view(""));
        QCOMPARE(takeLine(rest), std::string_view("last"));
        QVERIFY(rest.empty());
    }

    void utf8IsTold_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("good");
        QTest::newRow("ASCII") << QByteArray("K = 0.9") << true;
        QTest::newRow("two, three, four bytes") << QByteArray("\xC2\xB5 \xE2\x82\xAC \xF0\x9F\x94\xA7") << true;
        QTest::newRow("last code point") << QByteArray("\xF4\x8F\xBF\xBF") << true;
        QTest::newRow("Latin-1") << QByteArray("\xB5m") << false;
        QTest::newRow("cut off") << QByteArray("\xE2\x82") << false;
        QTest::newRow("overlong") << QByteArray("\xC0\xAF") << false;
        QTest::newRow("overlong, three bytes") << QByteArray("\xE0\x80\xAF") << false;
        QTest::newRow("surrogate") << QByteArray("\xED\xA0\x80") << false;
        QTest::newRow("beyond the last") << QByteArray("\xF4\x90\x80\x80") << false;
    }
    void utf8IsTold() {
        QFETCH(QByteArray, text);
        QFETCH(bool, good);
        QCOMPARE(isUtf8(text.toStdString()), good);
    }
};

BURIN_TEST(CsvTest, NoApplication)

} // namespace burin::tst_csv

#include "tst_csv.moc"
