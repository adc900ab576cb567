// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/json_object.h"
#include "tests/test_program.h"

#include <QElapsedTimer>
#include <QtTest>

#include <clocale>

namespace burin::tst_json_object {

namespace {

std::string faultyKey(const std::string& text, const std::function<void(JsonObject&)>& read) {
    Result<JsonObject> object = JsonObject::parse(text, "file.json");
    if (!object) return object.error().place;
    read(*object);
    const Result<void> finished = object->finish();
    return finished ? "none" : finished.error().place;
}

} // namespace

class JsonObjectTest : public QObject {
    Q_OBJECT

private slots:
    void readsEachKind() {
        const std::string text = R"({"n": 2.5, "i": 3, "b": true, "t": "word", "c": "two", "l": [1, 2, 3],
                                     "o": {"x": 1}, "s": [{"x": 1}, {"x": 2}], "m": {"k": {"x": 4}}})";
        Result<JsonObject> object = JsonObject::parse(text, "file.json");
        QVERIFY(object.hasValue());
        QCOMPARE(object->number("n", {0.0, 3.0}), 2.5);
        QCOMPARE(object->integer("i", 0, 5), 3);
        QVERIFY(object->boolean("b"));
        QCOMPARE(object->text("t"), std::string("word"));
        QCOMPARE(object->choice("c", {"one", "two"}), std::size_t{1});
        QCOMPARE(object->numbers("l", 3), (std::vector<double>{1.0, 2.0, 3.0}));
        double sum = 0.0;
        const auto add = [&](JsonObject& nested) { sum += nested.number("x"); };
        object->object("o", add);
        object->objects("s", add);
        object->objectsByName("m", [&](const std::string& name, JsonObject& nested) {
            QCOMPARE(name, std::string("k"));
            add(nested);
        });
        QCOMPARE(sum, 8.0);
        QCOMPARE(object->numberOr("absent", 7.0), 7.0);
        QVERIFY(object->booleanOr("absent", true));
        QVERIFY(object->finish().hasValue());
    }

    /// Any file of 1 MB must be read within a minute; this one takes a fraction of a second.
    void aLongListEndsInTime() {
        std::string text = R"({"list": [{})";
        std::size_t expected = 1, count = 0;
        for (; text.size() < 1'000'000; ++expected) text += ",{}";
        QElapsedTimer clock;
        clock.start();
        Result<JsonObject> object = JsonObject::parse(text + "]}", "file.json");
        QVERIFY(object.hasValue());
        object->objects("list", [&](JsonObject&) { ++count; });
        QVERIFY(object->finish().hasValue());
        QCOMPARE(count, expected);
        QVERIFY(clock.elapsed() < 60'000);
    }

    void keepsTheFirstFaultWithItsWayFromTheTop() {
        const std::string text = R"({"list": [{"x": 1}, {"x": "no"}], "late": "no"})";
        const std::string key = faultyKey(text, [](JsonObject& object) {
            object.objects("list", [](JsonObject& nested) { (void)nested.number("x"); });
            (void)object.number("late");
        });
        QCOMPARE(key, std::string("list[1].x"));
    }

    void findsWhatNobodyAskedFor() {
        QCOMPARE(faultyKey(R"({"a": 1, "b": 2})", [](JsonObject& object) { (void)object.number("a"); }),
                 std::string("b"));
        QCOMPARE(faultyKey(R"({"a": {"b": 2}})", [](JsonObject& object) { object.object("a", [](JsonObject&) {}); }),
                 std::string("a.b"));
    }

    void refusesWhatIsNotAnObject_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("empty") << "";
        QTest::newRow("list") << "[1]";
        QTest::newRow("cut off") << R"({"a": 1)";
        QTest::newRow("comment") << R"({"a": 1} // no)";
        QTest::newRow("key twice") << R"({"a": 1, "a": 2})";
        QTest::newRow("not a number") << R"({"a": NaN})";
        QTest::newRow("broken UTF-8") << QString::fromLatin1("{\"a\": \"\xff\"}");
    }
    void refusesWhatIsNotAnObject() {
        QFETCH(QString, text);
        const Result<JsonObject> object = JsonObject::parse(text.toLatin1().toStdString(), "file.json");
        QVERIFY(!object.hasValue());
        QVERIFY(object.error().code == ErrorCode::resourceInvalid);
        QCOMPARE(object.error().subject, std::string("file.json"));
    }

    /// Counted by hand, from 1, in bytes.
    void whereItStopsBeingJsonIsSaid() {
        const auto nothing = [](JsonObject&) {};
        QCOMPARE(faultyKey("x", nothing), std::string("line 1, column 1"));
        QCOMPARE(faultyKey("{\"a\": 1}]", nothing), std::string("line 1, column 9"));
        QCOMPARE(faultyKey("{\n  \"a\": 1,\n  b\n}", nothing), std::string("line 3, column 3"));
    }

    void wholeNumbersAreNeverCutOff_data() {
        QTest::addColumn<QString>("number");
        QTest::addColumn<bool>("fits"); // into -5 … 5
        QTest::newRow("lowest") << "-5" << true;
        QTest::newRow("highest") << "5" << true;
        QTest::newRow("below") << "-6" << false;
        QTest::newRow("above") << "6" << false;
        QTest::newRow("1 in its lower 32 bits") << "4294967297" << false;
        QTest::newRow("-1 in its 64 bits") << "18446744073709551615" << false;
        QTest::newRow("beyond 64 bits") << "18446744073709551617" << false;
        QTest::newRow("lowest of 64 bits") << "-9223372036854775808" << false;
        QTest::newRow("with a fraction") << "1.0" << false;
    }
    void wholeNumbersAreNeverCutOff() {
        QFETCH(QString, number);
        QFETCH(bool, fits);
        Result<JsonObject> object = JsonObject::parse(R"({"i": )" + number.toStdString() + "}", "file.json");
        const int found = object->integer("i", -5, 5);
        QCOMPARE(object->finish().hasValue(), fits);
        QCOMPARE(found, fits ? number.toInt() : -5);
    }

    /// In locales with a decimal comma, files still use a point.
    void numbersDoNotDependOnTheLocale() {
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
            if (std::setlocale(LC_ALL, name) != nullptr) break;
        Result<JsonObject> object = JsonObject::parse(R"({"a": 1.25})", "file.json");
        QCOMPARE(object->number("a"), 1.25);
        std::setlocale(LC_ALL, "C");
    }
};

BURIN_TEST(JsonObjectTest, NoApplication)

} // namespace burin::tst_json_object

#include "tst_json_object.moc"
