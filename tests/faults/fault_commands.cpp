// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/faults/fault_run.h"

QList<FaultCommand> faultCommands() {
    const QString edit = R"({"kind":"smooth","tolerance_mm":0.05,"corner_deg":40})";
    return {
        {"embed",
         {"embed", "part.stl", "-o", "p.burin", "--voxel", "2", "--margin", "2", "--material", "tooling-board",
          "--replace"},
         {},
         false,
         true},
        {"setup", {"setup", "p.burin", "--units", "inch", "--keep-out", "0,0,-20,5,5,-10"}, {}},
        {"setup of an earlier format",
         {"setup", "p.burin", "--units", "inch"},
         {"p.format-3.burin"},
         false,
         false,
         "burin",
         true},
        {"a further setup", {"setup", "p.burin", "--add-setup", "Back", "--turn", "x:180"}, {}},
        {"mill", {"mill", "p.burin", "--intent", "scribble", "--seconds", "1"}, {}, true},
        {"mill a trace",
         {"mill", "p.burin", "--stylus", "trace:hand.csv", "--trace", "again.csv", "--felt", "1", "--seconds", "1"},
         {"again.csv"},
         true},
        {"path new", {"path", "p.burin", "new", "--name", "second"}, {}},
        {"a computed pass", {"path", "p.burin", "new", "--pass", "face", "--tool", "flat-12"}, {}},
        {"path undo", {"path", "p.burin", "undo", "1", "--place", "0"}, {}},
        {"path show", {"path", "p.burin", "show", "1", "-o", "points.csv"}, {"points.csv"}},
        {"path take", {"path", "p.burin", "take", "1", "-o", "take.csv"}, {"take.csv"}},
        {"path trace", {"path", "p.burin", "trace", "1", "-o", "trace.csv"}, {"trace.csv"}},
        {"post", {"post", "p.burin", "-o", "new.ngc", "--override", "a test", "--tolerance", "1"}, {"new.ngc"}},
        {"verify",
         {"verify", "program.ngc", "--project", "p.burin", "--map", "map.vtp", "--tolerance", "10", "--exact", "0"},
         {"map.vtp"}},
        {"picture", {"picture", "p.burin", "-o", "picture.png"}, {"picture.png"}},
        {"sheet", {"sheet", "p.burin", "-o", "sheet.html"}, {"sheet.html"}},
        {"info", {"info", "p.burin"}, {}},
        {"the window's save", {"p.burin"}, {}, true, false, "burin-save-project"},
        {"the window's save under another name", {"p.burin", "q.burin"}, {}, true, false, "burin-save-project"},
    };
}
