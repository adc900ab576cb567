<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Begin a new, empty project.</source>
        <translation>Beginnt ein neues, leeres Projekt.</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen…</translation>
    </message>
    <message>
        <source>&amp;Import a part…</source>
        <translation>Teil &amp;importieren…</translation>
    </message>
    <message>
        <source>Sample &amp;part</source>
        <translation>Beispiel&amp;teil</translation>
    </message>
    <message>
        <source>Import the part that Burin is shipped with.</source>
        <translation>Importiert das Teil, das Burin mitbringt.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the project.</source>
        <translation>Speichert das Projekt.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the project under another name and continue with it.</source>
        <translation>Speichert das Projekt unter anderem Namen und arbeitet dort weiter.</translation>
    </message>
    <message>
        <source>&amp;Export the program…</source>
        <translation>Programm &amp;exportieren…</translation>
    </message>
    <message>
        <source>Write the program that passed its check to a file.</source>
        <translation>Schreibt das geprüfte Programm in eine Datei.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last change.</source>
        <translation>Macht die letzte Änderung rückgängig.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Wieder&amp;herstellen</translation>
    </message>
    <message>
        <source>Redo the change that was undone last.</source>
        <translation>Stellt die zuletzt rückgängig gemachte Änderung wieder her.</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Unit, theme and language.</source>
        <translation>Einheit, Farben und Sprache.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Show everything.</source>
        <translation>Zeigt alles.</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isometrisch</translation>
    </message>
    <message>
        <source>Look from a corner.</source>
        <translation>Blick von einer Ecke.</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Von &amp;oben</translation>
    </message>
    <message>
        <source>Look along the tool.</source>
        <translation>Blick entlang des Werkzeugs.</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>Von &amp;unten</translation>
    </message>
    <message>
        <source>Look from below.</source>
        <translation>Blick von unten.</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>Look from the front.</source>
        <translation>Blick von vorn.</translation>
    </message>
    <message>
        <source>B&amp;ack</source>
        <translation>Von &amp;hinten</translation>
    </message>
    <message>
        <source>Look from the back.</source>
        <translation>Blick von hinten.</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Von &amp;links</translation>
    </message>
    <message>
        <source>Look from the left.</source>
        <translation>Blick von links.</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>Von &amp;rechts</translation>
    </message>
    <message>
        <source>Look from the right.</source>
        <translation>Blick von rechts.</translation>
    </message>
    <message>
        <source>&amp;Part</source>
        <translation>&amp;Teil</translation>
    </message>
    <message>
        <source>Draw the part together with the workpiece.</source>
        <translation>Zeichnet zusammen mit dem Werkstück auch das Teil.</translation>
    </message>
    <message>
        <source>&amp;Workpiece</source>
        <translation>&amp;Werkstück</translation>
    </message>
    <message>
        <source>Draw the workpiece.</source>
        <translation>Zeichnet das Werkstück.</translation>
    </message>
    <message>
        <source>T&amp;ool</source>
        <translation>Werk&amp;zeug</translation>
    </message>
    <message>
        <source>Draw the tool.</source>
        <translation>Zeichnet das Werkzeug.</translation>
    </message>
    <message>
        <source>Pat&amp;h</source>
        <translation>Bah&amp;n</translation>
    </message>
    <message>
        <source>Draw the edited path.</source>
        <translation>Zeichnet die bearbeitete Bahn.</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>Nä&amp;chster Schritt</translation>
    </message>
    <message>
        <source>Open the next step of the job.</source>
        <translation>Öffnet den nächsten Arbeitsschritt.</translation>
    </message>
    <message>
        <source>Pre&amp;vious step</source>
        <translation>Vorheri&amp;ger Schritt</translation>
    </message>
    <message>
        <source>Open the step of the job before this one.</source>
        <translation>Öffnet den vorherigen Arbeitsschritt.</translation>
    </message>
    <message>
        <source>&amp;Embed the part</source>
        <translation>Teil &amp;einbetten</translation>
    </message>
    <message>
        <source>Embed the part in its stock; this makes the workpiece.</source>
        <translation>Bettet das Teil in sein Rohteil ein; so entsteht das Werkstück.</translation>
    </message>
    <message>
        <source>&amp;Show me</source>
        <translation>&amp;Vorführen</translation>
    </message>
    <message>
        <source>Watch a virtual operator mill this part.</source>
        <translation>Ein virtueller Bediener fräst dieses Teil.</translation>
    </message>
    <message>
        <source>S&amp;top the virtual operator</source>
        <translation>Virtuellen Bediener an&amp;halten</translation>
    </message>
    <message>
        <source>Stop; the recording is kept.</source>
        <translation>Hält an; das Aufgezeichnete bleibt erhalten.</translation>
    </message>
    <message>
        <source>&amp;New path</source>
        <translation>&amp;Neue Bahn</translation>
    </message>
    <message>
        <source>Make a path from the takes, with the standard edits.</source>
        <translation>Macht aus den Aufnahmen eine Bahn mit den üblichen Bearbeitungen.</translation>
    </message>
    <message>
        <source>&amp;Update path</source>
        <translation>Bahn &amp;aktualisieren</translation>
    </message>
    <message>
        <source>Apply the edits to the takes again.</source>
        <translation>Wendet die Bearbeitungen neu auf die Aufnahmen an.</translation>
    </message>
    <message>
        <source>&amp;Post and check</source>
        <translation>&amp;Ausgeben und prüfen</translation>
    </message>
    <message>
        <source>Make the program, read it back and check it.</source>
        <translation>Erzeugt das Programm, liest es zurück und prüft es.</translation>
    </message>
    <message>
        <source>&amp;Welcome page</source>
        <translation>&amp;Willkommensseite</translation>
    </message>
    <message>
        <source>Show how to begin.</source>
        <translation>Zeigt, wie man beginnt.</translation>
    </message>
    <message>
        <source>&amp;About Burin</source>
        <translation>&amp;Über Burin</translation>
    </message>
    <message>
        <source>Version, licence and sources.</source>
        <translation>Version, Lizenz und Quellen.</translation>
    </message>
    <message>
        <source>Quit Burin.</source>
        <translation>Beendet Burin.</translation>
    </message>
    <message>
        <source>&amp;Guides on</source>
        <translation>&amp;Führungen ein</translation>
    </message>
    <message>
        <source>Switch all guides of the hand on or off.</source>
        <translation>Schaltet alle Führungen der Hand ein oder aus.</translation>
    </message>
    <message>
        <source>Guide along the nearest &amp;edge</source>
        <translation>Führung an der nächsten &amp;Kante</translation>
    </message>
    <message>
        <source>Lead the hand along the edge of the part that is nearest to the tool.</source>
        <translation>Führt die Hand an der Kante des Teils entlang, die dem Werkzeug am nächsten ist.</translation>
    </message>
    <message>
        <source>Level &amp;above</source>
        <translation>Ebene &amp;darüber</translation>
    </message>
    <message>
        <source>The guide takes the next level above, or ends the pass.</source>
        <translation>Die Führung nimmt die nächste Ebene darüber oder beendet die Zeile.</translation>
    </message>
    <message>
        <source>Level &amp;below</source>
        <translation>Ebene da&amp;runter</translation>
    </message>
    <message>
        <source>The guide takes the next level below, or ends the pass.</source>
        <translation>Die Führung nimmt die nächste Ebene darunter oder beendet die Zeile.</translation>
    </message>
    <message>
        <source>&amp;Clutch</source>
        <translation>Aus&amp;kuppeln</translation>
    </message>
    <message>
        <source>The hand moves, the tool stays.</source>
        <translation>Die Hand bewegt sich, das Werkzeug bleibt stehen.</translation>
    </message>
    <message>
        <source>Re&amp;centre</source>
        <translation>&amp;Zentrieren</translation>
    </message>
    <message>
        <source>Brings the hand back to the centre of the device&apos;s workspace while you work.</source>
        <translation>Bringt die Hand während der Arbeit in die Mitte des Arbeitsraums des Geräts zurück.</translation>
    </message>
    <message>
        <source>A&amp;lign the hand with the view</source>
        <translation>Hand an der Ansicht a&amp;usrichten</translation>
    </message>
    <message>
        <source>A hand movement to the right moves the tool to the right in the view.</source>
        <translation>Eine Handbewegung nach rechts bewegt das Werkzeug in der Ansicht nach rechts.</translation>
    </message>
    <message>
        <source>G&amp;uides</source>
        <translation>F&amp;ührungen</translation>
    </message>
    <message>
        <source>Draw the guides of the hand that are on.</source>
        <translation>Zeichnet die Führungen der Hand, die eingeschaltet sind.</translation>
    </message>
    <message>
        <source>Fixture from a &amp;file…</source>
        <translation>Vorrichtung aus einer &amp;Datei…</translation>
    </message>
    <message>
        <source>Tool a&amp;xis along the view</source>
        <translation>Werkzeuga&amp;chse in Blickrichtung</translation>
    </message>
    <message>
        <source>Sets the tool axis to the view direction (3+2 milling).</source>
        <translation>Setzt die Werkzeugachse in die Blickrichtung (3+2-Fräsen).</translation>
    </message>
    <message>
        <source>Fi&amp;ner hand</source>
        <translation>Fei&amp;nere Hand</translation>
    </message>
    <message>
        <source>Smaller tool movement for the same hand movement.</source>
        <translation>Kleinere Bewegung des Werkzeugs bei gleicher Bewegung der Hand.</translation>
    </message>
    <message>
        <source>C&amp;oarser hand</source>
        <translation>&amp;Gröbere Hand</translation>
    </message>
    <message>
        <source>Larger tool movement for the same hand movement.</source>
        <translation>Größere Bewegung des Werkzeugs bei gleicher Bewegung der Hand.</translation>
    </message>
    <message>
        <source>The hand sets the spee&amp;d</source>
        <translation>Die Hand gibt das &amp;Tempo vor</translation>
    </message>
    <message>
        <source>A stylus without motors sets the tool&apos;s speed, not its position.</source>
        <translation>Ein Stift ohne Motoren gibt das Tempo des Werkzeugs vor, nicht seine Position.</translation>
    </message>
    <message>
        <source>&amp;Draw instead</source>
        <translation>Stattdessen &amp;zeichnen</translation>
    </message>
    <message>
        <source>Draw a stroke in the view that replaces the selected part of the path.</source>
        <translation>Einen Zug in der Ansicht zeichnen, der den ausgewählten Abschnitt der Bahn ersetzt.</translation>
    </message>
    <message>
        <source>&amp;Find in the program</source>
        <translation>Im Programm &amp;suchen</translation>
    </message>
    <message>
        <source>Look for a text in the program.</source>
        <translation>Einen Text im Programm suchen.</translation>
    </message>
    <message>
        <source>&amp;Override the check…</source>
        <translation>Prüfung ü&amp;bergehen…</translation>
    </message>
    <message>
        <source>Export a program that failed its check; you must state a reason.</source>
        <translation>Ein Programm exportieren, das seine Prüfung nicht bestanden hat; dafür ist ein Grund anzugeben.</translation>
    </message>
    <message>
        <source>Paths of other tool&amp;s</source>
        <translation>Bahnen anderer &amp;Werkzeuge</translation>
    </message>
    <message>
        <source>Draw the paths of the job&apos;s other tools.</source>
        <translation>Zeichnet die Bahnen der anderen Werkzeuge des Auftrags.</translation>
    </message>
    <message>
        <source>Draw for an ed&amp;it</source>
        <translation>Für eine Bearbeitung zei&amp;chnen</translation>
    </message>
    <message>
        <source>Draw the area, the guide or the mirror plane of the last edit that has one.</source>
        <translation>Zeichnet den Bereich, die Führung oder die Spiegelebene der letzten Bearbeitung, die so etwas hat.</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>All keyboard shortcuts and mouse actions.</source>
        <translation>Alle Tastenkürzel und Mausaktionen.</translation>
    </message>
    <message>
        <source>&amp;Mill</source>
        <translation>&amp;Fräsen</translation>
    </message>
    <message>
        <source>Start or stop milling. Everything that is cut is recorded.</source>
        <translation>Beginnt oder beendet das Fräsen. Alles, was geschnitten wird, wird aufgezeichnet.</translation>
    </message>
    <message>
        <source>Ras&amp;ter</source>
        <translation>Ras&amp;ter</translation>
    </message>
    <message>
        <source>Drag a rectangle; it is milled in rows at the step-over.</source>
        <translation>Ein Rechteck aufziehen; es wird in Zeilen im Zeilenabstand gefräst.</translation>
    </message>
    <message>
        <source>Repeat &amp;lower</source>
        <translation>&amp;Tiefer wiederholen</translation>
    </message>
    <message>
        <source>Repeat the last stroke, lower by the depth of cut.</source>
        <translation>Den letzten Zug noch einmal fräsen, um die Zustellung tiefer.</translation>
    </message>
    <message>
        <source>Repeat beside, le&amp;ft</source>
        <translation>Links &amp;daneben wiederholen</translation>
    </message>
    <message>
        <source>Repeat the last stroke one step-over to the left of its direction.</source>
        <translation>Den letzten Zug noch einmal fräsen, einen Zeilenabstand links von seiner Richtung.</translation>
    </message>
    <message>
        <source>Repeat beside, ri&amp;ght</source>
        <translation>&amp;Rechts daneben wiederholen</translation>
    </message>
    <message>
        <source>Repeat the last stroke one step-over to the right of its direction.</source>
        <translation>Den letzten Zug noch einmal fräsen, einen Zeilenabstand rechts von seiner Richtung.</translation>
    </message>
    <message>
        <source>Parallel pro&amp;jection</source>
        <translation>Parallelpro&amp;jektion</translation>
    </message>
    <message>
        <source>Parallel edges stay parallel in every view. Views along an axis always are so.</source>
        <translation>Parallele Kanten bleiben in jeder Ansicht parallel. Ansichten entlang einer Achse sind es immer.</translation>
    </message>
    <message>
        <source>Transpare&amp;nt workpiece</source>
        <translation>&amp;Durchsichtiges Werkstück</translation>
    </message>
    <message>
        <source>Show the part through the workpiece.</source>
        <translation>Zeigt das Teil durch das Werkstück hindurch.</translation>
    </message>
    <message>
        <source>S&amp;ection</source>
        <translation>S&amp;chnitt</translation>
    </message>
    <message>
        <source>Section the part and the workpiece in the view.</source>
        <translation>Schneidet Teil und Werkstück in der Ansicht auf, um hineinzusehen.</translation>
    </message>
    <message>
        <source>Fl&amp;ip</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Show the other side of the section plane.</source>
        <translation>Zeigt die andere Seite der Schnittebene.</translation>
    </message>
    <message>
        <source>&amp;Text next to the view</source>
        <translation>&amp;Text neben der Ansicht</translation>
    </message>
    <message>
        <source>Show the program&apos;s text and findings next to the view instead of in the panel.</source>
        <translation>Text und Befunde des Programms neben der Ansicht statt im Bedienfeld zeigen.</translation>
    </message>
    <message>
        <source>&amp;Restart at the selected line…</source>
        <translation>Ab der gewählten Zeile &amp;neu beginnen …</translation>
    </message>
    <message>
        <source>&amp;Machines…</source>
        <translation>&amp;Maschinen …</translation>
    </message>
    <message>
        <source>Look at the machines; copy, change and delete your own.</source>
        <translation>Die Maschinen ansehen; eigene kopieren, ändern und löschen.</translation>
    </message>
    <message>
        <source>Export the rest of the program from the selected line, with a safe re-entry into the cut, for example after tool breakage.</source>
        <translation>Den Rest des Programms ab der gewählten Zeile ausgeben, mit einem sicheren Wiedereintritt in den Schnitt, etwa nach einem Werkzeugbruch.</translation>
    </message>
    <message>
        <source>Export the &amp;workpiece…</source>
        <translation>&amp;Werkstück exportieren…</translation>
    </message>
    <message>
        <source>Write the workpiece as a surface (STL, PLY, 3MF) or as voxels.</source>
        <translation>Das Werkstück als Oberfläche (STL, PLY, 3MF) oder als Voxel schreiben.</translation>
    </message>
    <message>
        <source>Stoc&amp;k from a file…</source>
        <translation>Rohteil aus einer &amp;Datei …</translation>
    </message>
    <message>
        <source>Read the stock from a volume file, a voxel array (a scan) or a model.</source>
        <translation>Liest das Rohteil aus einer Volumendatei, einem Voxelfeld (einem Scan) oder einem Modell.</translation>
    </message>
    <message>
        <source>Mate&amp;rials…</source>
        <translation>&amp;Werkstoffe …</translation>
    </message>
    <message>
        <source>Look at, copy, change, add and calibrate materials.</source>
        <translation>Werkstoffe ansehen, kopieren, ändern, hinzufügen und kalibrieren.</translation>
    </message>
    <message>
        <source>Too&amp;l from models…</source>
        <translation>&amp;Werkzeug aus Modellen …</translation>
    </message>
    <message>
        <source>Make a tool of models of its flutes and its shank: a form tool, a worn cutter.</source>
        <translation>Macht ein Werkzeug aus Modellen seiner Schneiden und seines Schafts: ein Formwerkzeug, einen abgenutzten Fräser.</translation>
    </message>
    <message>
        <source>&amp;Tools…</source>
        <translation>&amp;Werkzeuge …</translation>
    </message>
    <message>
        <source>Look at the tools; copy, change, add and delete your own.</source>
        <translation>Werkzeuge ansehen; eigene kopieren, ändern, hinzufügen und löschen.</translation>
    </message>
    <message>
        <source>Read a part from a CAD file (STEP, IGES, BREP) or a mesh (STL, 3MF, OBJ, PLY, AMF, OFF).</source>
        <translation>Liest ein Teil aus einer CAD-Datei (STEP, IGES, BREP) oder einem Netz (STL, 3MF, OBJ, PLY, AMF, OFF).</translation>
    </message>
    <message>
        <source>&amp;Add a setup…</source>
        <translation>Aufspannung &amp;hinzufügen …</translation>
    </message>
    <message>
        <source>Add a setup for another side of the part. Its stock is the workpiece that this setup leaves.</source>
        <translation>Fügt eine Aufspannung für eine andere Seite des Teils hinzu. Ihr Rohteil ist das Werkstück, das diese übrig lässt.</translation>
    </message>
    <message>
        <source>&amp;Next setup</source>
        <translation>&amp;Nächste Aufspannung</translation>
    </message>
    <message>
        <source>Switch to the next setup.</source>
        <translation>Wechselt zur nächsten Aufspannung.</translation>
    </message>
    <message>
        <source>Pre&amp;vious setup</source>
        <translation>&amp;Vorige Aufspannung</translation>
    </message>
    <message>
        <source>Switch to the previous setup.</source>
        <translation>Wechselt zur vorigen Aufspannung.</translation>
    </message>
    <message>
        <source>Orient a face &amp;down</source>
        <translation>Eine Fläche nach &amp;unten ausrichten</translation>
    </message>
    <message>
        <source>Click a face of the part in the view. The part is rotated so that this face points down.</source>
        <translation>Klicken Sie in der Ansicht auf eine Fläche des Teils. Das Teil wird so gedreht, dass sie nach unten zeigt.</translation>
    </message>
    <message>
        <source>Rotate by 90° about &amp;X</source>
        <translation>Um 90° um &amp;X drehen</translation>
    </message>
    <message>
        <source>Rotate the part by 90° about X, through its centre.</source>
        <translation>Dreht das Teil um 90° um X, durch seine Mitte.</translation>
    </message>
    <message>
        <source>Rotate by 90° about &amp;Y</source>
        <translation>Um 90° um &amp;Y drehen</translation>
    </message>
    <message>
        <source>Rotate the part by 90° about Y, through its centre.</source>
        <translation>Dreht das Teil um 90° um Y, durch seine Mitte.</translation>
    </message>
    <message>
        <source>Rotate by 90° about &amp;Z</source>
        <translation>Um 90° um &amp;Z drehen</translation>
    </message>
    <message>
        <source>Rotate the part by 90° about Z, through its centre.</source>
        <translation>Dreht das Teil um 90° um Z, durch seine Mitte.</translation>
    </message>
    <message>
        <source>Import a fixture in the coordinates of the setup; the tool keeps clear of it.</source>
        <translation>Importiert ein Spannmittel in den Koordinaten der Aufspannung; das Werkzeug weicht ihm aus.</translation>
    </message>
    <message>
        <source>&amp;Pick program zero</source>
        <translation>Nullpunkt &amp;anklicken</translation>
    </message>
    <message>
        <source>Click a vertex, an edge or a circle of the part, or a corner of the stock.</source>
        <translation>Klicken Sie auf einen Eckpunkt, eine Kante oder einen Kreis des Teils oder auf eine Ecke des Rohteils.</translation>
    </message>
    <message>
        <source>Export the setup s&amp;heet…</source>
        <translation>Einric&amp;hteblatt exportieren…</translation>
    </message>
    <message>
        <source>Write a page for the machine: pictures, zero, fixtures, tools, times, findings.</source>
        <translation>Eine Seite für die Maschine schreiben: Bilder, Nullpunkt, Spannmittel, Werkzeuge, Zeiten, Befunde.</translation>
    </message>
    <message>
        <source>&amp;Touch off program zero</source>
        <translation>Nullpunkt an&amp;tasten</translation>
    </message>
    <message>
        <source>&amp;Compute a pass…</source>
        <translation>Durchgang &amp;berechnen…</translation>
    </message>
    <message>
        <source>Paint the area of the next pass on the part; Shift erases.</source>
        <translation>Den Bereich des nächsten Durchgangs auf das Teil malen; Umschalt radiert.</translation>
    </message>
    <message>
        <source>Draw round the area of the next pass; Shift erases.</source>
        <translation>Den Bereich des nächsten Durchgangs umfahren; Umschalt radiert.</translation>
    </message>
    <message>
        <source>Pick &amp;faces as the area</source>
        <translation>&amp;Flächen als Bereich wählen</translation>
    </message>
    <message>
        <source>Click faces of the part for the next pass; Shift removes them.</source>
        <translation>Flächen des Teils für den nächsten Durchgang anklicken; Umschalt entfernt sie.</translation>
    </message>
    <message>
        <source>Clea&amp;r the area</source>
        <translation>Be&amp;reich löschen</translation>
    </message>
    <message>
        <source>The next pass goes over the whole part again.</source>
        <translation>Der nächste Durchgang geht wieder über das ganze Teil.</translation>
    </message>
    <message>
        <source>Paint an area with the &amp;brush</source>
        <translation>Bereich mit dem &amp;Pinsel malen</translation>
    </message>
    <message>
        <source>Draw an area with the &amp;lasso</source>
        <translation>Bereich mit dem &amp;Lasso umfahren</translation>
    </message>
    <message>
        <source>&amp;Measure the passes</source>
        <translation>Durchgänge &amp;messen</translation>
    </message>
    <message>
        <source>Length, time, share of air and engagement of each pass, and the stock that it leaves.</source>
        <translation>Länge, Zeit, Luftanteil und Eingriff jedes Durchgangs und das Material, das er übrig lässt.</translation>
    </message>
    <message>
        <source>De&amp;vices…</source>
        <translation>&amp;Geräte…</translation>
    </message>
    <message>
        <source>List the styluses that were found, and test them before milling.</source>
        <translation>Gefundene Eingabestifte auflisten und vor dem Fräsen testen.</translation>
    </message>
    <message>
        <source>&amp;Update the part</source>
        <translation>Teil &amp;aktualisieren</translation>
    </message>
    <message>
        <source>Read the part again after it was changed in the CAD system. Setups, roles, materials, recordings and paths stay.</source>
        <translation>Liest das Teil neu ein, nachdem es im CAD-System geändert wurde. Aufspannungen, Rollen, Materialien, Aufzeichnungen und Pfade bleiben.</translation>
    </message>
    <message>
        <source>Time&amp;line</source>
        <translation>&amp;Zeitleiste</translation>
    </message>
    <message>
        <source>Show the takes along their time below the view.</source>
        <translation>Zeigt die Takes entlang ihrer Zeit unter der Ansicht.</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>Ab&amp;spielen oder anhalten</translation>
    </message>
    <message>
        <source>Show the workpiece as it is now.</source>
        <translation>Zeigt das Werkstück, wie es jetzt ist.</translation>
    </message>
    <message>
        <source>P&amp;unch in</source>
        <translation>Hier &amp;einsteigen</translation>
    </message>
    <message>
        <source>Add a mar&amp;ker…</source>
        <translation>Mar&amp;ke setzen …</translation>
    </message>
    <message>
        <source>Open a project, or a program to check and play.</source>
        <translation>Öffnet ein Projekt oder ein Programm, um es zu prüfen und abzuspielen.</translation>
    </message>
    <message>
        <source>Play the takes, or the program, from the time shown; the workpiece follows.</source>
        <translation>Spielt die Aufnahmen oder das Programm ab der gezeigten Zeit ab; das Werkstück folgt.</translation>
    </message>
    <message>
        <source>Back to the &amp;current state</source>
        <translation>Zurück zum &amp;aktuellen Stand</translation>
    </message>
    <message>
        <source>Continue milling from the time shown. Everything recorded after it is switched off, and can be switched on again.</source>
        <translation>Fräst ab der gezeigten Zeit weiter. Alles, was danach aufgenommen wurde, wird ausgeschaltet und kann wieder eingeschaltet werden.</translation>
    </message>
    <message>
        <source>Set a named marker at the time shown on the timeline.</source>
        <translation>Setzt eine benannte Marke an der gezeigten Zeit.</translation>
    </message>
    <message>
        <source>Next path &amp;colours</source>
        <translation>Nächste Bahn&amp;farben</translation>
    </message>
    <message>
        <source>Colour the path by its feed, spindle speed, height, removal rate, force or deviation from the recording, in turn.</source>
        <translation>Färbt die Bahn der Reihe nach nach Vorschub, Drehzahl, Höhe, Zeitspanvolumen, Kraft oder Abweichung von der Aufnahme.</translation>
    </message>
    <message>
        <source>Path from a pro&amp;gram…</source>
        <translation>Bahn aus einem Pro&amp;gramm…</translation>
    </message>
    <message>
        <source>Edit a program of another system (G-code or APT/CL) as a path: its moves, feeds and speeds; Burin links them anew.</source>
        <translation>Ein Programm eines anderen Systems (G-Code oder APT/CL) als Bahn bearbeiten: seine Bewegungen, Vorschübe und Drehzahlen; Burin verbindet sie neu.</translation>
    </message>
    <message>
        <source>H&amp;istory</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>Show all changes next to the view; a click goes back to one, or forward again.</source>
        <translation>Alle Änderungen neben der Ansicht zeigen; ein Klick geht zu einer zurück oder wieder vor.</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Reset the &amp;window layout</source>
        <translation>&amp;Fensteraufteilung zurücksetzen</translation>
    </message>
    <message>
        <source>Put docks and panels back to where they were at first.</source>
        <translation>Andockfenster und Bereiche wieder dorthin legen, wo sie anfangs waren.</translation>
    </message>
    <message>
        <source>Export a p&amp;icture…</source>
        <translation>B&amp;ild exportieren…</translation>
    </message>
    <message>
        <source>Write what the view shows to a PNG file.</source>
        <translation>Was die Ansicht zeigt, in eine PNG-Datei schreiben.</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>&amp;Tastenkürzel…</translation>
    </message>
    <message>
        <source>Pro&amp;ject tree</source>
        <translation>Pro&amp;jektbaum</translation>
    </message>
    <message>
        <source>Show setups, bodies, fixtures, tools, takes, paths and program as a tree.</source>
        <translation>Aufspannungen, Körper, Vorrichtungen, Werkzeuge, Aufnahmen, Bahnen und Programm als Baum zeigen.</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Show the help on the current step.</source>
        <translation>Die Hilfe zum aktuellen Schritt zeigen.</translation>
    </message>
    <message>
        <source>Click points on the part: diameter, wall thickness, area, distances and angle.</source>
        <translation>Punkte auf dem Teil anklicken: Durchmesser, Wandstärke, Fläche, Abstände und Winkel.</translation>
    </message>
    <message>
        <source>Change the shortcuts of actions.</source>
        <translation>Die Tastenkürzel von Befehlen ändern.</translation>
    </message>
    <message>
        <source>E&amp;xcess stock</source>
        <translation>&amp;Restmaterial</translation>
    </message>
    <message>
        <source>Colour the workpiece by the stock that is left on the part, during milling, too. Rest the pointer on it to read how much.</source>
        <translation>Färbt das Werkstück nach dem Aufmaß, das noch auf dem Teil steht, auch beim Fräsen. Der Zeiger zeigt dort, wo er ruht, wie viel es ist.</translation>
    </message>
    <message>
        <source>&amp;Breakpoint</source>
        <translation>&amp;Haltepunkt</translation>
    </message>
    <message>
        <source>Stop a play of the program before the line of the cursor, or no longer. A click on the line&apos;s number does the same.</source>
        <translation>Das Abspielen des Programms vor der Zeile des Cursors anhalten, oder nicht mehr. Ein Klick auf die Nummer der Zeile tut dasselbe.</translation>
    </message>
    <message>
        <source>State how well a take was milled, and compare it with a reference, for training.</source>
        <translation>Zeigt, wie gut eine Aufnahme gefräst ist, und vergleicht sie mit einer Referenz, zum Üben.</translation>
    </message>
    <message>
        <source>&amp;First job</source>
        <translation>&amp;Erster Auftrag</translation>
    </message>
    <message>
        <source>Start a guide through a complete job on the sample part, step by step.</source>
        <translation>Schritt für Schritt durch einen ganzen Auftrag am Beispielteil geführt werden.</translation>
    </message>
    <message>
        <source>F&amp;aces of the part…</source>
        <translation>Fl&amp;ächen des Teils…</translation>
    </message>
    <message>
        <source>List the faces of the part with the gouges and the stock that the program leaves on each; a click shows the worst point.</source>
        <translation>Die Flächen des Teils mit den Konturverletzungen und dem Restmaterial auflisten, die das Programm auf jeder hinterlässt; ein Klick zeigt die schlimmste Stelle.</translation>
    </message>
    <message>
        <source>Mo&amp;ve the take up</source>
        <translation>Aufnahme nach &amp;oben</translation>
    </message>
    <message>
        <source>Replay the take that is selected in the project tree or on the timeline before the take above it. The workpiece at the end and the paths stay as they are.</source>
        <translation>Die im Projektbaum oder auf der Zeitleiste gewählte Aufnahme vor der darüber abspielen. Das Werkstück am Ende und die Bahnen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Move the take do&amp;wn</source>
        <translation>Aufnah&amp;me nach unten</translation>
    </message>
    <message>
        <source>Replay the take that is selected in the project tree or on the timeline after the take below it. The workpiece at the end and the paths stay as they are.</source>
        <translation>Die im Projektbaum oder auf der Zeitleiste gewählte Aufnahme nach der darunter abspielen. Das Werkstück am Ende und die Bahnen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Copy the selected take with its strokes and what is switched off. No path mills the copy until its menu adds it.</source>
        <translation>Die gewählte Aufnahme mit ihren Zügen und dem, was ausgeschaltet ist, kopieren. Keine Bahn fräst die Kopie, bis ihr Menü sie aufnimmt.</translation>
    </message>
    <message>
        <source>C&amp;ompare paths…</source>
        <translation>Bahnen &amp;vergleichen…</translation>
    </message>
    <message>
        <source>Compare the path with another one, with the recording or with itself without an edit: lengths, time and deviation.</source>
        <translation>Vergleicht die Bahn mit einer anderen, mit der Aufnahme oder mit sich selbst ohne eine Bearbeitung: Längen, Zeit und Abweichung.</translation>
    </message>
    <message>
        <source>Sco&amp;re a take…</source>
        <translation>Aufnahme &amp;bewerten…</translation>
    </message>
    <message>
        <source>Dupl&amp;icate the take</source>
        <translation>Aufnahme du&amp;plizieren</translation>
    </message>
    <message>
        <source>A&amp;dd a fixture…</source>
        <translation>Vorrichtung hinzu&amp;fügen…</translation>
    </message>
    <message>
        <source>Compute roughing, finishing, a pocket, a profile, drilling, threads or engraving with the loaded tool.</source>
        <translation>Schruppen, Schlichten, eine Tasche, eine Kontur, Bohren, Gewinde oder Gravieren mit dem geladenen Werkzeug berechnen.</translation>
    </message>
    <message>
        <source>Pick &amp;holes for a pass</source>
        <translation>Bo&amp;hrungen für einen Durchgang wählen</translation>
    </message>
    <message>
        <source>Insert a &amp;point</source>
        <translation>Punkt &amp;einfügen</translation>
    </message>
    <message>
        <source>Insert a point where the path is selected. Drag it in the view to move it; the stroke follows it smoothly.</source>
        <translation>Einen Punkt einfügen, wo die Bahn ausgewählt ist. Ziehen Sie ihn in der Ansicht, um ihn zu verschieben; der Zug folgt ihm glatt.</translation>
    </message>
    <message>
        <source>Place a vise, clamp, screw, parallels or plate of the library with the mouse; the tool keeps clear of it.</source>
        <translation>Schraubstock, Spanneisen, Schraube, Parallelunterlagen oder Platte der Bibliothek mit der Maus platzieren; das Werkzeug hält Abstand.</translation>
    </message>
    <message>
        <source>&amp;Handles in the view</source>
        <translation>&amp;Griffe in der Ansicht</translation>
    </message>
    <message>
        <source>Show arrows, squares and rings that move and rotate the part, or the fixture that is being placed, by the mouse. Shift: fine; Ctrl: in steps.</source>
        <translation>Zeigt Pfeile, Quadrate und Ringe, die das Teil oder die Vorrichtung, die platziert wird, mit der Maus verschieben und drehen. Umschalt: fein; Strg: in Schritten.</translation>
    </message>
    <message>
        <source>&amp;Stop the tool at the stock</source>
        <translation>Werkzeug am Rohteil auf&amp;halten</translation>
    </message>
    <message>
        <source>The face of the part or stock that the tool touches becomes zero along its axis, as with an edge finder.</source>
        <translation>Die Fläche von Teil oder Rohteil, die das Werkzeug berührt, wird Null auf ihrer Achse, wie mit einem Kantentaster.</translation>
    </message>
    <message>
        <source>&amp;Keep from the stock</source>
        <translation>&amp;Abstand zum Rohteil halten</translation>
    </message>
    <message>
        <source>Shank and holder push back before they touch the stock. The distance is set with the devices.</source>
        <translation>Schaft und Halter drücken zurück, bevor sie das Rohteil berühren. Der Abstand wird bei den Geräten eingestellt.</translation>
    </message>
    <message>
        <source>Compute ou&amp;tdated passes again</source>
        <translation>Veraltete &amp;Durchgänge neu berechnen</translation>
    </message>
    <message>
        <source>Compute those passes of the path again whose strokes have changed; all others stay as they are.</source>
        <translation>Berechnet die Durchgänge der Bahn neu, deren Züge sich geändert haben; alle anderen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Edit with the st&amp;ylus</source>
        <translation>Mit dem S&amp;tift bearbeiten</translation>
    </message>
    <message>
        <source>Move points of the path with the chosen stylus, and feel part and fixtures.</source>
        <translation>Punkte der Bahn mit dem gewählten Stift verschieben und dabei Teil und Vorrichtungen fühlen.</translation>
    </message>
    <message>
        <source>Measure the wor&amp;kpiece</source>
        <translation>Wer&amp;kstück messen</translation>
    </message>
    <message>
        <source>Click points on the workpiece as it is milled: thickness, depth, width, diameter, stock left on the part, distances and angle.</source>
        <translation>Punkte auf dem Werkstück anklicken, wie es gefräst ist: Dicke, Tiefe, Weite, Durchmesser, Restmaterial auf dem Teil, Abstände und Winkel.</translation>
    </message>
    <message>
        <source>Until a recording starts, the stock stops the tool, as it was before milling, so that its sides can be touched off.</source>
        <translation>Bis eine Aufnahme beginnt, hält das Rohteil, wie es vor dem Fräsen war, das Werkzeug auf, sodass seine Seiten angetastet werden können.</translation>
    </message>
    <message>
        <source>Record a session trace…</source>
        <translation>Spur der Sitzung aufzeichnen…</translation>
    </message>
    <message>
        <source>Write every reading of the stylus, from entering mill mode until leaving it, to a file that &quot;burin mill&quot; replays to the bit.</source>
        <translation>Jeden Messwert des Stifts vom Beginn bis zum Ende des Fräsens in eine Datei schreiben, die „burin mill“ bitgenau wiedergibt.</translation>
    </message>
    <message>
        <source>Click holes of the part for drilling or thread milling with the loaded tool, or studs for external threads.</source>
        <translation>Bohrungen des Teils anklicken, die mit dem geladenen Werkzeug gebohrt werden oder ein Gewinde erhalten, oder Zapfen für Außengewinde.</translation>
    </message>
</context>
<context>
    <name>Argument</name>
    <message>
        <source>NAME</source>
        <translation>NAME</translation>
    </message>
    <message>
        <source>FORCES</source>
        <translation>MESSWERTE</translation>
    </message>
    <message>
        <source>MODEL</source>
        <translation>MODELL</translation>
    </message>
    <message>
        <source>PROJECT</source>
        <translation>PROJEKT</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>KENNUNG</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>DATEI</translation>
    </message>
    <message>
        <source>NEW</source>
        <translation>NEU</translation>
    </message>
    <message>
        <source>PATH</source>
        <translation>BAHN</translation>
    </message>
    <message>
        <source>TAKE</source>
        <translation>AUFNAHME</translation>
    </message>
    <message>
        <source>LINE</source>
        <translation>ZEILE</translation>
    </message>
    <message>
        <source>PROGRAM</source>
        <translation>PROGRAMM</translation>
    </message>
    <message>
        <source>OTHER</source>
        <translation>ANDERE</translation>
    </message>
    <message>
        <source>FLUTES</source>
        <translation>SCHNEIDEN</translation>
    </message>
</context>
<context>
    <name>BodyMenu</name>
    <message>
        <source>Draw this body again.</source>
        <translation>Diesen Körper wieder zeichnen.</translation>
    </message>
    <message>
        <source>Draw these bodies again.</source>
        <translation>Diese Körper wieder zeichnen.</translation>
    </message>
    <message>
        <source>Do not draw this body; nothing else changes.</source>
        <translation>Diesen Körper nicht zeichnen; sonst ändert sich nichts.</translation>
    </message>
    <message>
        <source>Do not draw these bodies; nothing else changes.</source>
        <translation>Diese Körper nicht zeichnen; sonst ändert sich nichts.</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Ausblenden</translation>
    </message>
    <message>
        <source>Show this one &amp;alone</source>
        <translation>&amp;Nur diesen zeigen</translation>
    </message>
    <message>
        <source>Show these &amp;alone</source>
        <translation>&amp;Nur diese zeigen</translation>
    </message>
    <message>
        <source>Hide all other bodies.</source>
        <translation>Alle anderen Körper ausblenden.</translation>
    </message>
    <message>
        <source>Show a&amp;ll</source>
        <translation>A&amp;lle zeigen</translation>
    </message>
    <message>
        <source>Draw all bodies again.</source>
        <translation>Alle Körper wieder zeichnen.</translation>
    </message>
    <message>
        <source>&amp;Role</source>
        <translation>&amp;Rolle</translation>
    </message>
    <message>
        <source>Recordings depend on the roles of bodies.</source>
        <translation>Aufnahmen hängen von den Rollen der Körper ab.</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>&amp;Colour…</source>
        <translation>&amp;Farbe…</translation>
    </message>
    <message>
        <source>Choose the colour in which the view shows it.</source>
        <translation>Die Farbe wählen, in der die Ansicht ihn zeigt.</translation>
    </message>
    <message>
        <source>&amp;Without a colour of its own</source>
        <translation>&amp;Ohne eigene Farbe</translation>
    </message>
    <message>
        <source>Show it in the colour of parts without a colour.</source>
        <translation>In der Farbe von Teilen ohne eigene Farbe zeigen.</translation>
    </message>
</context>
<context>
    <name>BodyRows</name>
    <message>
        <source>Tick: shown in the view.</source>
        <translation>Häkchen: in der Ansicht gezeigt.</translation>
    </message>
    <message>
        <source>several roles</source>
        <translation>mehrere Rollen</translation>
    </message>
    <message>
        <source>1 body. Tick: shown in the view.</source>
        <translation>1 Körper. Häkchen: in der Ansicht gezeigt.</translation>
    </message>
    <message numerus="yes">
        <source>%n bodies. Tick: shown in the view.</source>
        <translation>
            <numerusform>%n Körper. Häkchen: in der Ansicht gezeigt.</numerusform>
            <numerusform>%n Körper. Häkchen: in der Ansicht gezeigt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Buttons</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window.</source>
        <translation>Dieses Fenster schließen.</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>neither &quot;%1&quot; nor the project was changed</source>
        <translation>weder „%1“ noch das Projekt wurde geändert</translation>
    </message>
    <message>
        <source>state a reason</source>
        <translation>ein Grund</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a value.</source>
        <translation>„%1“ braucht einen Wert.</translation>
    </message>
    <message>
        <source>A command is missing; &quot;burin --help&quot; lists the commands.</source>
        <translation>Ein Befehl fehlt; „burin --help“ nennt die Befehle.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing; &quot;burin COMMAND --help&quot; shows what a command needs.</source>
        <translation>„%1“ fehlt; „burin BEFEHL --help“ zeigt, was ein Befehl braucht.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no argument of this command; &quot;burin COMMAND --help&quot; lists them.</source>
        <translation>„%1“ ist kein Argument dieses Befehls; „burin BEFEHL --help“ nennt sie.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; can&apos;t be used together.</source>
        <translation>„%1“ und „%2“ schließen einander aus.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can only be used with &quot;%2&quot;.</source>
        <translation>„%1“ geht nur zusammen mit „%2“.</translation>
    </message>
    <message>
        <source>The arguments can&apos;t be understood (%1).</source>
        <translation>Die Argumente sind nicht zu verstehen (%1).</translation>
    </message>
    <message>
        <source>The tool can&apos;t reach anything to mill. Use a smaller or longer tool, or accept it with --override.</source>
        <translation>Das Werkzeug erreicht nichts, was zu fräsen wäre. Ein kleineres oder längeres Werkzeug verwenden oder es mit --override hinnehmen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was written already</source>
        <translation>„%1“ ist schon geschrieben</translation>
    </message>
    <message>
        <source>the S-RLE engine and cutting, compared with the paper&apos;s method, dense grids, OpenVDB and VTK</source>
        <translation>S-RLE und Schneiden, verglichen mit dem Verfahren des Fachartikels, dichten Gittern, OpenVDB und VTK</translation>
    </message>
    <message>
        <source>reading programs back and judging them, compared with CAMotics, and where the time goes</source>
        <translation>Zurücklesen und Prüfen von Programmen, verglichen mit CAMotics, und wo die Zeit bleibt</translation>
    </message>
    <message>
        <source>CPU time and memory at three sizes of recordings, programs, paths, stocks and models, and how they grow</source>
        <translation>Rechenzeit und Speicher bei drei Größen von Aufzeichnungen, Programmen, Bahnen, Rohteilen und Modellen, und wie beide wachsen</translation>
    </message>
    <message>
        <source>the haptic loop: cost of a tick, push-back, stability, guards</source>
        <translation>die Haptikschleife: Kosten eines Takts, Gegenkraft, Stabilität, Wächter</translation>
    </message>
    <message>
        <source>(not built: tests/run --bench builds it)</source>
        <translation>(nicht gebaut: tests/run --bench baut ihn)</translation>
    </message>
    <message>
        <source>%1: %2 of %3 records, noise %4 N tangential, %5 N radial</source>
        <translation>%1: %2 von %3 Messungen, Rauschen %4 N tangential, %5 N radial</translation>
    </message>
    <message>
        <source>%1 J/mm^3, chips of %2 mm</source>
        <translation>%1 J/mm^3, Späne von %2 mm</translation>
    </message>
    <message>
        <source>line %1 left out: %2</source>
        <translation>Zeile %1 weggelassen: %2</translation>
    </message>
    <message>
        <source>not written (--dry-run)</source>
        <translation>nicht geschrieben (--dry-run)</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Making the project</source>
        <translation>Projekt anlegen</translation>
    </message>
    <message>
        <source>Embedding</source>
        <translation>Einbetten</translation>
    </message>
    <message>
        <source>Computing the tool&apos;s boundary</source>
        <translation>Grenzfläche des Werkzeugs berechnen</translation>
    </message>
    <message>
        <source>Milling</source>
        <translation>Fräsen</translation>
    </message>
    <message>
        <source>Editing</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Posting and checking</source>
        <translation>Ausgeben und prüfen</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>project  %1</source>
        <translation>Projekt  %1</translation>
    </message>
    <message>
        <source>program  %1, %2 blocks</source>
        <translation>Programm %1, %2 Sätze</translation>
    </message>
    <message>
        <source>program  refused, %1 blocks</source>
        <translation>Programm abgelehnt, %1 Sätze</translation>
    </message>
    <message>
        <source>picture  %1</source>
        <translation>Bild     %1</translation>
    </message>
    <message>
        <source>report   %1</source>
        <translation>Bericht  %1</translation>
    </message>
    <message>
        <source>mode %1: %2</source>
        <translation>Betriebsart %1: %2</translation>
    </message>
    <message>
        <source>BODY=NAME</source>
        <translation>KÖRPER=NAME</translation>
    </message>
    <message>
        <source>no project was made</source>
        <translation>kein Projekt angelegt</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>part %1 mm^3 in stock %2 mm^3, %3 x %4 x %5 voxels of %6 mm</source>
        <translation>Teil %1 mm^3 im Rohteil %2 mm^3, %3 x %4 x %5 Voxel von %6 mm</translation>
    </message>
    <message>
        <source>verdict  out of date: inputs of the program&apos;s check have changed; post it again</source>
        <translation>Urteil   veraltet: was geprüft wurde, hat sich geändert; geben Sie das Programm neu aus</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>overridden</source>
        <translation>übergangen</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>verdict  %2: gouge %3 mm (tolerance %4 mm), %1 error</source>
        <translation>Urteil   %2: Konturverletzung %3 mm (Toleranz %4 mm), %1 Fehler</translation>
    </message>
    <message>
        <source>verdict  %2: gouge %3 mm (tolerance %4 mm), %1 errors</source>
        <translation>Urteil   %2: Konturverletzung %3 mm (Toleranz %4 mm), %1 Fehler</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>take     %1 %2: %3 samples, %4, tool %5</source>
        <translation>Aufnahme %1 %2: %3 Messpunkte, %4, Werkzeug %5</translation>
    </message>
    <message>
        <source>take     %1 %2: %3 samples, %4, tool %5, incomplete</source>
        <translation>Aufnahme %1 %2: %3 Messpunkte, %4, Werkzeug %5, unvollständig</translation>
    </message>
    <message>
        <source>path     %1 %2: %3 takes, %4 edits</source>
        <translation>Bahn     %1 %2: Aufnahmen: %3, Bearbeitungen: %4</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>(recovered from a run that was interrupted)</source>
        <translation>(nach einem unterbrochenen Lauf wiederhergestellt)</translation>
    </message>
    <message>
        <source>stock    %1, voxel %2 mm</source>
        <translation>Rohteil  %1, Voxel %2 mm</translation>
    </message>
    <message>
        <source>axis     %1</source>
        <translation>Achse    %1</translation>
    </message>
    <message>
        <source>program  %1 (%2, %3)</source>
        <translation>Programm %1 (%2, %3)</translation>
    </message>
    <message>
        <source>typical  %1</source>
        <translation>typisch  %1</translation>
    </message>
    <message>
        <source>own      %1</source>
        <translation>eigene   %1</translation>
    </message>
    <message>
        <source>%1: removed</source>
        <translation>%1: gelöscht</translation>
    </message>
    <message>
        <source>; shank or holder touched in %1 ticks</source>
        <translation>; Schaft oder Halter berührten etwas in %1 Takten</translation>
    </message>
    <message>
        <source>; %2 held the tool in %1 ticks</source>
        <translation>; %2 hielt das Werkzeug in %1 Takten</translation>
    </message>
    <message>
        <source>; the axis was held in %1 ticks</source>
        <translation>; die Achse wurde in %1 Takten gehalten</translation>
    </message>
    <message>
        <source>take %1: %2 samples, %3 s, removed %4 mm^3; tick %5 us (p50), %6 us (p99.9), %7 Hz</source>
        <translation>Aufnahme %1: %2 Messpunkte, %3 s, abgetragen %4 mm^3; Takt %5 us (p50), %6 us (p99.9), %7 Hz</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not state how much of the cutting force was felt: %2 of it is assumed, as for the virtual operator. Set it with --felt; positions and the removed material don&apos;t depend on it, forces do.</source>
        <translation>„%1“ gibt nicht an, wie viel von der Schnittkraft zu fühlen war: angenommen wird ein Anteil von %2, wie beim virtuellen Bediener. Setzen Sie ihn mit --felt; Positionen und abgetragenes Material hängen nicht davon ab, die Kräfte schon.</translation>
    </message>
    <message>
        <source>%1, as when the trace was recorded</source>
        <translation>%1, wie bei der Aufnahme der Spur</translation>
    </message>
    <message>
        <source>with --felt, a trace that does not state how much of the cutting force was felt</source>
        <translation>zusammen mit --felt eine Spur, die nicht angibt, wie viel von der Schnittkraft zu fühlen war</translation>
    </message>
    <message>
        <source>--realtime with a device</source>
        <translation>--realtime, bei einem Gerät</translation>
    </message>
    <message>
        <source>operator, trace:FILE, device:NAME</source>
        <translation>operator, trace:DATEI, device:NAME</translation>
    </message>
    <message>
        <source>no file with the operator; one if --stylus is a trace or a device</source>
        <translation>keine Datei beim Bediener; eine, wenn --stylus eine Spur oder ein Gerät ist</translation>
    </message>
    <message>
        <source>the recording is kept, and the next command that opens the project recovers it</source>
        <translation>die Aufzeichnung ist erhalten; der nächste Befehl, der das Projekt öffnet, stellt sie wieder her</translation>
    </message>
    <message>
        <source>nothing was milled</source>
        <translation>nichts gefräst</translation>
    </message>
    <message>
        <source>path %1 %2, takes%3</source>
        <translation>Bahn %1 %2, Aufnahmen%3</translation>
    </message>
    <message>
        <source>no paths</source>
        <translation>keine Bahnen</translation>
    </message>
    <message>
        <source>recordings made with %1, as the first one</source>
        <translation>Aufnahmen mit dem Werkzeug %1, wie die erste</translation>
    </message>
    <message>
        <source>0 to %1 (exclusive)</source>
        <translation>0 bis %1 (ausschließlich)</translation>
    </message>
    <message>
        <source>an edit of an earlier version; this one is current</source>
        <translation>eine Bearbeitung einer früheren Version; diese ist aktuell</translation>
    </message>
    <message>
        <source>%1 points, error budget %2 mm, climb %3 mm, conventional %4 mm</source>
        <translation>%1 Punkte, Fehlerbudget %2 mm, Gleichlauf %3 mm, Gegenlauf %4 mm</translation>
    </message>
    <message>
        <source>%1: %2 -&gt; %3 points, at most %4 mm</source>
        <translation>%1: %2 -&gt; %3 Punkte, höchstens %4 mm</translation>
    </message>
    <message>
        <source>%1: %2 samples</source>
        <translation>%1: %2 Messpunkte</translation>
    </message>
    <message>
        <source>Replaying the takes</source>
        <translation>Aufnahmen wiederholen</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>%1: %2 blocks</source>
        <translation>%1: %2 Sätze</translation>
    </message>
    <message>
        <source>The project changed after its program was posted; the restart is judged by the project as it is now.</source>
        <translation>Das Projekt wurde nach der Ausgabe seines Programms geändert; der Neubeginn wird nach dem jetzigen Stand des Projekts beurteilt.</translation>
    </message>
    <message>
        <source>first cut: line %1 of the interrupted program, from %2 mm of path before it; the tool comes down at %3</source>
        <translation>erster Schnitt: Zeile %1 des unterbrochenen Programms, ab %2 mm Bahn davor; das Werkzeug senkt sich bei %3</translation>
    </message>
    <message>
        <source>Restarting and checking</source>
        <translation>Neu beginnen und prüfen</translation>
    </message>
    <message>
        <source>Reading fixtures</source>
        <translation>Vorrichtungen lesen</translation>
    </message>
    <message>
        <source>machine  %1</source>
        <translation>Maschine %1</translation>
    </message>
    <message>
        <source>machine  %1, dialect %2</source>
        <translation>Maschine %1, Dialekt %2</translation>
    </message>
    <message>
        <source>units    %1</source>
        <translation>Einheit  %1</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Burin ran out of memory. Choose a larger voxel.</source>
        <translation>Burin hat keinen Speicher mehr. Wählen Sie größere Voxel.</translation>
    </message>
    <message>
        <source>Internal error in Burin; report this: %1</source>
        <translation>Interner Fehler in Burin; melden Sie dies: %1</translation>
    </message>
    <message>
        <source>X=, Y= or Z= and a position in mm, such as X=12.5</source>
        <translation>X=, Y= oder Z= und eine Position in mm, etwa X=12.5</translation>
    </message>
    <message>
        <source>a position between %1 and %2 mm</source>
        <translation>eine Position zwischen %1 und %2 mm</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>body     %1: %2 mm^3, %3 mm^2, %4 faces, %5 triangles</source>
        <translation>Körper   %1: %2 mm^3, %3 mm^2, %4 Flächen, %5 Dreiecke</translation>
    </message>
    <message>
        <source>, open</source>
        <translation>, offen</translation>
    </message>
    <message>
        <source>warning  %1</source>
        <translation>Warnung  %1</translation>
    </message>
    <message>
        <source>note     %1</source>
        <translation>Hinweis  %1</translation>
    </message>
    <message>
        <source>format   %1, unit %2</source>
        <translation>Format   %1, Einheit %2</translation>
    </message>
    <message>
        <source>size     %1 x %2 x %3 mm</source>
        <translation>Größe    %1 x %2 x %3 mm</translation>
    </message>
    <message>
        <source>volume   %1 mm^3</source>
        <translation>Volumen  %1 mm^3</translation>
    </message>
    <message>
        <source>Bodies too small for the voxels to be protected: %1. Choose smaller voxels, or continue nevertheless with --override.</source>
        <translation>Körper, die zu klein sind, um mit diesen Voxeln geschützt zu werden: %1. Wählen Sie kleinere Voxel, oder fahren Sie mit --override trotzdem fort.</translation>
    </message>
    <message>
        <source>warning: %1</source>
        <translation>Warnung: %1</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 von %3</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>%1: %2 at %3</source>
        <translation>%1: %2 bei %3</translation>
    </message>
    <message>
        <source>%2, and on %1 more line</source>
        <translation>%2, und in %1 weiterer Zeile</translation>
    </message>
    <message>
        <source>%2, and on %1 more lines</source>
        <translation>%2, und in %1 weiteren Zeilen</translation>
    </message>
    <message>
        <source>line %1, column %2: rejected by the control: %3</source>
        <translation>Zeile %1, Spalte %2: von der Steuerung abgelehnt: %3</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not written: the program failed its check. To write it nevertheless, state a reason with --override; the program&apos;s header shows the reason.</source>
        <translation>„%1“ wurde nicht geschrieben: Das Programm hat seine Prüfung nicht bestanden. Um es trotzdem zu schreiben, geben Sie mit --override einen Grund an; er steht im Kopf des Programms.</translation>
    </message>
    <message>
        <source>left out by %2: %3 mm of %4 mm, %1 part</source>
        <translation>weggelassen von %2: %3 mm von %4 mm, %1 Abschnitt</translation>
    </message>
    <message>
        <source>left out by %2: %3 mm of %4 mm, %1 parts</source>
        <translation>weggelassen von %2: %3 mm von %4 mm, %1 Abschnitte</translation>
    </message>
    <message>
        <source>%1 mm from %2: %3</source>
        <translation>%1 mm ab %2: %3</translation>
    </message>
    <message>
        <source>%1: of %2 entries into material %3 by ramp, %4 by helix, %5 by plunge</source>
        <translation>%1: Eintritte ins Material: %2, davon Rampen: %3, Helices: %4, Eintauchen: %5</translation>
    </message>
    <message>
        <source>plunge of %1 mm to %2: no room for a ramp or helix</source>
        <translation>Eintauchen um %1 mm bis %2: kein Platz für eine Rampe oder Helix</translation>
    </message>
    <message>
        <source>passed: gouge %1 mm (tolerance %2 mm, %3 points, %4 of them on exact geometry)</source>
        <translation>bestanden: Konturverletzung %1 mm (Toleranz %2 mm, %3 Punkte, davon %4 auf der genauen Geometrie)</translation>
    </message>
    <message>
        <source>refused: gouge %1 mm (tolerance %2 mm, %3 points, %4 of them on exact geometry)</source>
        <translation>abgelehnt: Konturverletzung %1 mm (Toleranz %2 mm, %3 Punkte, davon %4 auf der genauen Geometrie)</translation>
    </message>
    <message>
        <source>excess   %1 mm at most, %2 mm on average, where the tool can reach</source>
        <translation>Rest     höchstens %1 mm, im Mittel %2 mm, wo das Werkzeug hinkommt</translation>
    </message>
    <message>
        <source>excess   %1 mm or more, %2 mm on average, where the tool can reach</source>
        <translation>Rest     %1 mm oder mehr, im Mittel %2 mm, wo das Werkzeug hinkommt</translation>
    </message>
    <message>
        <source>removed  %2 mm^3 in %3 s, with accelerations, corners, dwells and %1 tool change (%4 s at the programmed feeds alone)</source>
        <translation>Abtrag   %2 mm^3 in %3 s, mit Beschleunigungen, Ecken, Verweilzeiten und %1 Werkzeugwechsel (%4 s allein mit den programmierten Vorschüben)</translation>
    </message>
    <message>
        <source>removed  %2 mm^3 in %3 s, with accelerations, corners, dwells and %1 tool changes (%4 s at the programmed feeds alone)</source>
        <translation>Abtrag   %2 mm^3 in %3 s, mit Beschleunigungen, Ecken, Verweilzeiten und %1 Werkzeugwechseln (%4 s allein mit den programmierten Vorschüben)</translation>
    </message>
    <message>
        <source>%2; without %1 move whose start the program does not state (approach, return)</source>
        <translation>%2; ohne %1 Bewegung, deren Anfang das Programm nicht angibt (Anfahrt, Rückkehr)</translation>
    </message>
    <message>
        <source>%2; without %1 moves whose start the program does not state (approach, return)</source>
        <translation>%2; ohne %1 Bewegungen, deren Anfang das Programm nicht angibt (Anfahrt, Rückkehr)</translation>
    </message>
    <message>
        <source>machine  %1: typical values, not those of your machine (burin machines copy)</source>
        <translation>Maschine %1: typische Werte, nicht die Ihrer Maschine (burin machines copy)</translation>
    </message>
    <message>
        <source>load     peak %1 N, %2 W, %3 N m on line %4 at %5 s</source>
        <translation>Last     höchstens %1 N, %2 W, %3 N m in Zeile %4 bei %5 s</translation>
    </message>
    <message>
        <source>exact stop after every block</source>
        <translation>Genauhalt nach jedem Satz</translation>
    </message>
    <message>
        <source>exact path, stops at corners</source>
        <translation>genaue Bahn, Halt an Ecken</translation>
    </message>
    <message>
        <source>blended within %1 mm</source>
        <translation>verschliffen innerhalb von %1 mm</translation>
    </message>
    <message>
        <source>blended without limit</source>
        <translation>verschliffen ohne Grenze</translation>
    </message>
    <message>
        <source>line %1: %2 %3 mm at %4</source>
        <translation>Zeile %1: %2 %3 mm bei %4</translation>
    </message>
    <message>
        <source>%1; %2 lines within %3 mm of that point</source>
        <translation>%1; %2 Zeilen innerhalb von %3 mm um diesen Punkt</translation>
    </message>
    <message>
        <source>feeds    reduced on %1 move to the limits of spindle and tool (feed by engagement)</source>
        <translation>Vorschub bei %1 Bewegung auf die Grenzen von Spindel und Werkzeug gesenkt (Vorschub nach Eingriff)</translation>
    </message>
    <message>
        <source>feeds    reduced on %1 moves to the limits of spindle and tool (feed by engagement)</source>
        <translation>Vorschub bei %1 Bewegungen auf die Grenzen von Spindel und Werkzeug gesenkt (Vorschub nach Eingriff)</translation>
    </message>
    <message>
        <source>corners  from line %1 on, as the program states: %2</source>
        <translation>Ecken    ab Zeile %1, wie das Programm angibt: %2</translation>
    </message>
    <message>
        <source>remedy   %1: %2</source>
        <translation>Abhilfe  %1: %2</translation>
    </message>
    <message>
        <source>and %1 more warnings</source>
        <translation>und %1 weitere Warnungen</translation>
    </message>
    <message>
        <source>and %1 more points with warnings</source>
        <translation>und %1 weitere Punkte mit Warnungen</translation>
    </message>
    <message>
        <source>X0,Y0,Z0,X1,Y1,Z1 in mm, each of the last three above its counterpart</source>
        <translation>X0,Y0,Z0,X1,Y1,Z1 in mm, jeder der letzten drei Werte über seinem Gegenstück</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>Vorrichtung</translation>
    </message>
    <message>
        <source>keep-out</source>
        <translation>Sperrraum</translation>
    </message>
    <message>
        <source>fixed, free, or X,Y,Z that are not all zero</source>
        <translation>fixed, free oder X,Y,Z, die nicht alle null sind</translation>
    </message>
    <message>
        <source>middle, off, or X,Y,Z in mm</source>
        <translation>middle, off oder X,Y,Z in mm</translation>
    </message>
    <message>
        <source>The project&apos;s machine &quot;%1&quot; is not on this computer; &quot;%2&quot; is used in its place. Choose another with --machine, or with burin setup --machine.</source>
        <translation>Die Maschine „%1“ des Projekts gibt es auf diesem Rechner nicht; stattdessen gilt „%2“. Wählen Sie eine andere mit --machine oder mit burin setup --machine.</translation>
    </message>
    <message>
        <source>free, with the stylus</source>
        <translation>frei, mit dem Stift</translation>
    </message>
    <message>
        <source>fixed, +Z</source>
        <translation>fest, +Z</translation>
    </message>
    <message>
        <source>chosen, %1</source>
        <translation>gewählt, %1</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: %3 from (%4) to (%5) mm, clearance %6 mm</source>
        <translation>%1 „%2“: %3 von (%4) bis (%5) mm, Abstand %6 mm</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: %3 from (%4) to (%5) mm, clearance %6 mm, off</source>
        <translation>%1 „%2“: %3 von (%4) bis (%5) mm, Abstand %6 mm, aus</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>das Teil</translation>
    </message>
    <message>
        <source>the machine&apos;s travel</source>
        <translation>der Verfahrweg der Maschine</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;</source>
        <translation>%1 „%2“</translation>
    </message>
    <message>
        <source>There is no display to open the window on; log in to a desktop, set DISPLAY, or use a command: &quot;burin demo&quot; does the whole job without one, &quot;burin --help&quot; lists the others.</source>
        <translation>Es gibt keinen Bildschirm für das Fenster; melden Sie sich an einer Arbeitsfläche an, setzen Sie DISPLAY, oder verwenden Sie einen Befehl: „burin demo“ erledigt den ganzen Auftrag ohne Bildschirm, „burin --help“ nennt die übrigen.</translation>
    </message>
    <message>
        <source>An earlier version of Burin saved this project; the previous file is kept as &quot;%1&quot;.</source>
        <translation>Dieses Projekt wurde mit einer früheren Fassung von Burin gespeichert; die bisherige Datei bleibt als „%1“ erhalten.</translation>
    </message>
    <message>
        <source>a model file, or --free-carving</source>
        <translation>eine Modelldatei oder --free-carving</translation>
    </message>
    <message>
        <source>shipped  K %1 J/mm^3  %2</source>
        <translation>mitgeliefert  K %1 J/mm^3  %2</translation>
    </message>
    <message>
        <source>own      K %1 J/mm^3  %2</source>
        <translation>eigener       K %1 J/mm^3  %2</translation>
    </message>
    <message>
        <source>%1 voxels of %2 mm</source>
        <translation>%1 Voxel von %2 mm</translation>
    </message>
    <message>
        <source>  %1: %2 mm^3, %3 g, centre (%4, %5, %6) mm</source>
        <translation>  %1: %2 mm^3, %3 g, Schwerpunkt (%4, %5, %6) mm</translation>
    </message>
    <message>
        <source>%1: %2 voxels of %3 mm</source>
        <translation>%1: %2 Voxel von %3 mm</translation>
    </message>
    <message>
        <source>%1: %2 triangles</source>
        <translation>%1: %2 Dreiecke</translation>
    </message>
    <message>
        <source>its table: %1</source>
        <translation>seine Tabelle: %1</translation>
    </message>
    <message>
        <source>%1 run ends within voxels were rounded to whole voxels; a volume file keeps them</source>
        <translation>%1 Laufenden innerhalb von Voxeln wurden auf ganze Voxel gerundet; eine Volumendatei behält sie</translation>
    </message>
    <message>
        <source>intersecting: they share space</source>
        <translation>überschneidend: sie haben gemeinsamen Raum</translation>
    </message>
    <message>
        <source>adjacent: they touch and share no space</source>
        <translation>angrenzend: sie berühren sich, ohne gemeinsamen Raum</translation>
    </message>
    <message>
        <source>separate: there is a gap between them</source>
        <translation>getrennt: zwischen ihnen ist eine Lücke</translation>
    </message>
    <message>
        <source>part, stock, insert, protected-insert, fixture or ignored</source>
        <translation>part, stock, insert, protected-insert, fixture oder ignored</translation>
    </message>
    <message>
        <source>x, y, z, or X,Y,Z</source>
        <translation>x, y, z oder X,Y,Z</translation>
    </message>
    <message>
        <source>X,Y,Z,AX,AY,AZ,RADIUS,HEIGHT in mm: middle of an end face, direction of the axis, radius and height</source>
        <translation>X,Y,Z,AX,AY,AZ,RADIUS,HÖHE in mm: Mitte einer Stirnfläche, Richtung der Achse, Radius und Höhe</translation>
    </message>
    <message>
        <source>NAME=MATERIAL,AXIS,FROM,TO: x, y or z, and two positions in mm, of which one may be left out</source>
        <translation>NAME=WERKSTOFF,ACHSE,VON,BIS: x, y oder z und zwei Positionen in mm, von denen eine fehlen darf</translation>
    </message>
    <message>
        <source>LAYER:VALUE=FORMULA of X, Y and Z</source>
        <translation>SCHICHT:WERT=FORMEL aus X, Y und Z</translation>
    </message>
    <message>
        <source>LAYER:VALUE=AXIS:POSITION,VALUE;POSITION,VALUE…</source>
        <translation>SCHICHT:WERT=ACHSE:POSITION,WERT;POSITION,WERT…</translation>
    </message>
    <message>
        <source>mass not known</source>
        <translation>Masse unbekannt</translation>
    </message>
    <message>
        <source>  %1: %2 mm^3, %3, protected</source>
        <translation>  %1: %2 mm^3, %3, geschützt</translation>
    </message>
    <message>
        <source>  %1: %2 mm^3, %3</source>
        <translation>  %1: %2 mm^3, %3</translation>
    </message>
    <message>
        <source>  %1: %2 from %3 to %4 %5 in %6 bands, each place within %7 %5</source>
        <translation>  %1: %2 von %3 bis %4 %5 in %6 Stufen, jede Stelle auf %7 %5 genau</translation>
    </message>
    <message>
        <source>free carving: there is no part, so nothing pushes the tool back</source>
        <translation>freies Schnitzen: Es gibt kein Teil, also hält nichts das Werkzeug zurück</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>form     %1</source>
        <translation>Form     %1</translation>
    </message>
    <message>
        <source>role     %1: %2</source>
        <translation>Rolle    %1: %2</translation>
    </message>
    <message>
        <source>layer    %1: %2, %3 from %4 to %5 mm</source>
        <translation>Schicht  %1: %2, %3 von %4 bis %5 mm</translation>
    </message>
    <message>
        <source>--stock-file FILE</source>
        <translation>--stock-file DATEI</translation>
    </message>
    <message>
        <source>Reading the stock</source>
        <translation>Rohteil wird gelesen</translation>
    </message>
    <message>
        <source>no part</source>
        <translation>kein Bauteil</translation>
    </message>
    <message>
        <source>touched  line %1: with the tip at %2 shank and holder touch %3 voxels of %4 mm</source>
        <translation>berührt  Zeile %1: mit der Spitze bei %2 berühren Schaft und Halter %3 Voxel von %4 mm</translation>
    </message>
    <message>
        <source>a known material, or --like MATERIAL</source>
        <translation>ein bekannter Werkstoff oder --like WERKSTOFF</translation>
    </message>
    <message>
        <source>shipped  T%1  %2 mm  %3</source>
        <translation>mitgeliefert  T%1  %2 mm  %3</translation>
    </message>
    <message>
        <source>own      T%1  %2 mm  %3</source>
        <translation>eigenes       T%1  %2 mm  %3</translation>
    </message>
    <message>
        <source>profile of %1 lines, at most %2 mm wider than what the flutes sweep in a turn, never narrower</source>
        <translation>Profil aus %1 Linien, höchstens %2 mm weiter als das, was die Schneiden in einer Umdrehung überstreichen, nie enger</translation>
    </message>
    <message>
        <source>moved along Z by %1 mm, so that the tip is at 0</source>
        <translation>um %1 mm längs Z verschoben, sodass die Spitze bei 0 liegt</translation>
    </message>
    <message>
        <source>%1 gives no unit of length; it was read in mm.</source>
        <translation>%1 nennt keine Längeneinheit; es wurde in mm gelesen.</translation>
    </message>
    <message>
        <source>coarser than --tolerance asks for: a finer profile has more lines than a tool can have</source>
        <translation>gröber, als --tolerance verlangt: Ein feineres Profil hat mehr Linien, als ein Werkzeug haben kann</translation>
    </message>
    <message>
        <source>setup %1</source>
        <translation>Aufspannung %1</translation>
    </message>
    <message>
        <source>the number of a setup</source>
        <translation>die Nummer einer Aufspannung</translation>
    </message>
    <message>
        <source>X,Y,Z=AXIS: a point on a face in mm, and x, -x, y, -y, z, -z or a direction that the face is to point along</source>
        <translation>X,Y,Z=ACHSE: ein Punkt auf einer Fläche in mm, und x, -x, y, -y, z, -z oder eine Richtung, in die die Fläche zeigen soll</translation>
    </message>
    <message>
        <source>AXIS:DEGREES: x, y, z or X,Y,Z, and an angle</source>
        <translation>ACHSE:GRAD: x, y, z oder X,Y,Z, und ein Winkel</translation>
    </message>
    <message>
        <source>X,Y,Z in mm</source>
        <translation>X,Y,Z in mm</translation>
    </message>
    <message>
        <source>rotated by %1 degrees about %2</source>
        <translation>um %1 Grad um %2 gedreht</translation>
    </message>
    <message>
        <source>moved by %1 mm</source>
        <translation>um %1 mm verschoben</translation>
    </message>
    <message>
        <source>its stock is the workpiece after the checked program</source>
        <translation>ihr Rohteil ist das Werkstück nach dem geprüften Programm</translation>
    </message>
    <message>
        <source>its stock is the workpiece after the recordings, because there is no checked program that is up to date</source>
        <translation>ihr Rohteil ist das Werkstück nach den Aufnahmen, denn es gibt kein geprüftes Programm, das noch gilt</translation>
    </message>
    <message>
        <source>the rotation is not a multiple of 90 degrees: faces of the stock may be off by up to %1 mm</source>
        <translation>die Drehung ist kein Vielfaches von 90 Grad: Flächen des Rohteils können um bis zu %1 mm abweichen</translation>
    </message>
    <message>
        <source>Preparing the stock</source>
        <translation>Rohteil wird vorbereitet</translation>
    </message>
    <message>
        <source>setup    %1 %2</source>
        <translation>Aufspannung %1 %2</translation>
    </message>
    <message>
        <source>its stock is the workpiece of setup %1, which has changed since (update it with --update-stock)</source>
        <translation>ihr Rohteil ist das Werkstück von Aufspannung %1, die sich seither geändert hat (--update-stock aktualisiert es)</translation>
    </message>
    <message>
        <source>its stock is the workpiece of setup %1</source>
        <translation>ihr Rohteil ist das Werkstück von Aufspannung %1</translation>
    </message>
    <message>
        <source>0 to %1 mm, the travel of the machine &quot;%2&quot;</source>
        <translation>0 bis %1 mm, der Verfahrweg der Maschine „%2“</translation>
    </message>
    <message>
        <source>zero     %1</source>
        <translation>Null     %1</translation>
    </message>
    <message>
        <source>stock:X,Y,Z or part:X,Y,Z with low, middle or high for each axis, near:X,Y,Z or X,Y,Z in mm</source>
        <translation>stock:X,Y,Z oder part:X,Y,Z mit low, middle oder high für jede Achse, near:X,Y,Z oder X,Y,Z in mm</translation>
    </message>
    <message>
        <source>low</source>
        <translation>unteres Ende</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>high</source>
        <translation>oberes Ende</translation>
    </message>
    <message>
        <source>G54 to G59, G59.1 to G59.3, or P1 to P300</source>
        <translation>G54 bis G59, G59.1 bis G59.3 oder P1 bis P300</translation>
    </message>
    <message>
        <source>%1, at X %2, Y %3, Z %4 mm</source>
        <translation>%1, bei X %2, Y %3, Z %4 mm</translation>
    </message>
    <message>
        <source>%1, on the stock: X %2, Y %3, Z %4</source>
        <translation>%1, am Rohteil: X %2, Y %3, Z %4</translation>
    </message>
    <message>
        <source>%1, on the part: X %2, Y %3, Z %4</source>
        <translation>%1, am Teil: X %2, Y %3, Z %4</translation>
    </message>
    <message>
        <source>setup sheet  %1</source>
        <translation>Einrichteblatt  %1</translation>
    </message>
    <message>
        <source>an ID that is free, or --replace for one of your own</source>
        <translation>eine freie ID, oder --replace für eines Ihrer eigenen</translation>
    </message>
    <message>
        <source>left out:</source>
        <translation>ausgelassen:</translation>
    </message>
    <message>
        <source>path %1 %2</source>
        <translation>Bahn %1 %2</translation>
    </message>
    <message>
        <source>a tool for the pass</source>
        <translation>ein Werkzeug für den Durchgang</translation>
    </message>
    <message>
        <source>Computing the pass</source>
        <translation>Der Durchgang wird berechnet</translation>
    </message>
    <message>
        <source>%1 mm in %2 strokes</source>
        <translation>%1 mm in %2 Zügen</translation>
    </message>
    <message>
        <source>X,Y in mm</source>
        <translation>X,Y in mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not state its unit: one unit is taken as %2 mm. Set it with --unit.</source>
        <translation>„%1“ nennt keine Einheit: eine Einheit gilt als %2 mm. Mit --unit lässt sie sich angeben.</translation>
    </message>
    <message>
        <source>another file, or --replace (recordings and passes in the project there: %1)</source>
        <translation>eine andere Datei, oder --replace (Aufnahmen und Durchgänge im Projekt dort: %1)</translation>
    </message>
    <message>
        <source>%1 recordings and passes</source>
        <translation>%1 Aufnahmen und Durchgänge</translation>
    </message>
    <message>
        <source>a setup without recordings and passes, or --add-setup</source>
        <translation>eine Aufspannung ohne Aufnahmen und Durchgänge, oder --add-setup</translation>
    </message>
    <message>
        <source>%1, the tool of this path; make a new path for another tool</source>
        <translation>%1, das Werkzeug dieser Bahn; für ein anderes Werkzeug eine neue Bahn anlegen</translation>
    </message>
    <message>
        <source>path %1 was deleted</source>
        <translation>Bahn %1 wurde gelöscht</translation>
    </message>
    <message>
        <source>0.1 to 1000 mm</source>
        <translation>0,1 bis 1000 mm</translation>
    </message>
    <message>
        <source>pass %1: %2 mm in %3 s, %4 % of it in air; %5 mm³ removed; engagement within %6° for 95 % of the cut, at most %7°</source>
        <translation>Durchgang %1: %2 mm in %3 s, davon %4 % in der Luft; %5 mm³ abgetragen; Eingriff auf 95 % des Schnitts höchstens %6°, überall höchstens %7°</translation>
    </message>
    <message>
        <source>%1 mm were skipped: too much stock is in the way of the tool. Rough it first, or use a longer tool.</source>
        <translation>%1 mm wurden ausgelassen: zu viel Rohteil ist dem Werkzeug im Weg. Zuerst schruppen oder ein längeres Werkzeug verwenden.</translation>
    </message>
    <message>
        <source>%1 mm were skipped: fixtures or keep-out volumes are in the way.</source>
        <translation>%1 mm wurden ausgelassen: Spannmittel oder Sperrräume sind im Weg.</translation>
    </message>
    <message>
        <source>a path with a computed pass</source>
        <translation>eine Bahn mit einem berechneten Durchgang</translation>
    </message>
    <message>
        <source>Computing the preview</source>
        <translation>Vorschau wird berechnet</translation>
    </message>
    <message>
        <source>holes    %1</source>
        <translation>Bohrungen %1</translation>
    </message>
    <message>
        <source>; stock left on 99 % of the reachable part: at most %1 mm (most: %2 mm)</source>
        <translation>; auf 99 % des erreichbaren Teils bleibt höchstens %1 mm Material (größter Wert: %2 mm)</translation>
    </message>
    <message>
        <source>about %1 mm in %2 s at the feed of tool and material, without links</source>
        <translation>etwa %1 mm in %2 s mit dem Vorschub von Werkzeug und Werkstoff, ohne Verbindungen</translation>
    </message>
    <message>
        <source>Testing the device</source>
        <translation>Das Gerät wird getestet</translation>
    </message>
    <message>
        <source>no value, unless --stylus is a device or a trace that does not state how much of the cutting force was felt</source>
        <translation>kein Wert, außer wenn --stylus ein Gerät ist oder eine Spur, die nicht angibt, wie viel der Schnittkraft zu spüren war</translation>
    </message>
    <message>
        <source>; heaviest cut: %1 mm^2 of %2, engagement %3 degrees, depth %4 mm; feed for it: %5 mm/min at %6 rpm</source>
        <translation>; schwerster Schnitt: %1 mm^2 %2, Eingriff %3 Grad, Tiefe %4 mm; Vorschub dafür: %5 mm/min bei %6 1/min</translation>
    </message>
    <message>
        <source>Active guides of the project: %1</source>
        <translation>Aktive Führungen des Projekts: %1</translation>
    </message>
    <message>
        <source>changed bodies: %1</source>
        <translation>geänderte Körper: %1</translation>
    </message>
    <message>
        <source>new bodies: %1</source>
        <translation>neue Körper: %1</translation>
    </message>
    <message>
        <source>removed bodies: %1</source>
        <translation>entfernte Körper: %1</translation>
    </message>
    <message>
        <source>the part has not changed</source>
        <translation>das Teil hat sich nicht geändert</translation>
    </message>
    <message>
        <source>stock and program zero stay where they are, as there are recordings or passes; check the programs again</source>
        <translation>Rohteil und Programmnullpunkt bleiben, wo sie sind, da es Aufzeichnungen oder Durchgänge gibt; prüfen Sie die Programme neu</translation>
    </message>
    <message>
        <source>take %1 %2: %3 s switched off</source>
        <translation>Aufnahme %1 %2: %3 s ausgeschaltet</translation>
    </message>
    <message>
        <source>hash %1</source>
        <translation>Prüfwert %1</translation>
    </message>
    <message>
        <source>Rapids were left out: links replace them.</source>
        <translation>Eilgänge wurden weggelassen: Verbindungen ersetzen sie.</translation>
    </message>
    <message>
        <source>%1 dwell was left out.</source>
        <translation>%1 Verweilzeit wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 dwells were left out.</source>
        <translation>%1 Verweilzeiten wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1 move was left out: the program does not state where it begins.</source>
        <translation>%1 Bewegung wurde weggelassen: Das Programm nennt nicht, wo sie beginnt.</translation>
    </message>
    <message>
        <source>%1 moves were left out: the program does not state where they begin.</source>
        <translation>%1 Bewegungen wurden weggelassen: Das Programm nennt nicht, wo sie beginnen.</translation>
    </message>
    <message>
        <source>a tool for the program</source>
        <translation>ein Werkzeug für das Programm</translation>
    </message>
    <message>
        <source>Reading the program</source>
        <translation>Programm wird gelesen</translation>
    </message>
    <message>
        <source>X,Y,Z in mm, on the part</source>
        <translation>X,Y,Z in mm, auf dem Teil</translation>
    </message>
    <message>
        <source>%1 arc was converted to lines within 0.001 mm; fit-arcs restores it.</source>
        <translation>%1 Bogen wurde innerhalb von 0,001 mm in Geraden zerlegt; fit-arcs stellt ihn wieder her.</translation>
    </message>
    <message>
        <source>%1 arcs were converted to lines within 0.001 mm; fit-arcs restores them.</source>
        <translation>%1 Bögen wurden innerhalb von 0,001 mm in Geraden zerlegt; fit-arcs stellt sie wieder her.</translation>
    </message>
    <message>
        <source>%1 mm of feed moves</source>
        <translation>%1 mm Vorschubbewegungen</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>better by %1</source>
        <translation>um %1 besser</translation>
    </message>
    <message>
        <source>worse by %1</source>
        <translation>um %1 schlechter</translation>
    </message>
    <message>
        <source>not comparable</source>
        <translation>nicht vergleichbar</translation>
    </message>
    <message>
        <source>take %1 %2, compared with take %3 %4</source>
        <translation>Aufnahme %1 %2, verglichen mit Aufnahme %3 %4</translation>
    </message>
    <message>
        <source>take %1 %2</source>
        <translation>Aufnahme %1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, reference %3, ratio %4: %5</source>
        <translation>%1: %2, Referenz %3, Verhältnis %4: %5</translation>
    </message>
    <message>
        <source>Inspecting the faces</source>
        <translation>Flächen werden geprüft</translation>
    </message>
    <message>
        <source>face %1  gouge %2 mm  left %3 mm  in tolerance %4 %  area %5 mm^2  %6</source>
        <translation>Fläche %1  Konturverletzung %2 mm  Rest %3 mm  in Toleranz %4 %  Inhalt %5 mm^2  %6</translation>
    </message>
    <message>
        <source>an edit, a pass with --pass, or a take with --take</source>
        <translation>eine Bearbeitung, ein Durchgang mit --pass oder eine Aufnahme mit --take</translation>
    </message>
    <message>
        <source>order of the takes: %1</source>
        <translation>Reihenfolge der Aufnahmen: %1</translation>
    </message>
    <message>
        <source>a position from 1, or --before TAKE</source>
        <translation>eine Position ab 1 oder --before AUFNAHME</translation>
    </message>
    <message>
        <source>take %1 is a copy of take %2</source>
        <translation>Aufnahme %1 ist eine Kopie von Aufnahme %2</translation>
    </message>
    <message>
        <source>without edit %1 (%2)</source>
        <translation>ohne Bearbeitung %1 (%2)</translation>
    </message>
    <message>
        <source>a second path, --without or --recorded</source>
        <translation>eine zweite Bahn, --without oder --recorded</translation>
    </message>
    <message>
        <source>without edits</source>
        <translation>ohne Bearbeitungen</translation>
    </message>
    <message>
        <source>%1 and %2 (%3)</source>
        <translation>%1 und %2 (%3)</translation>
    </message>
    <message>
        <source>at most %1 mm at (%2) mm, mean %3 mm; %4 % of its cuts (%5 mm) are farther</source>
        <translation>höchstens %1 mm bei (%2) mm, im Mittel %3 mm; %4 % ihrer Schnitte (%5 mm) liegen weiter entfernt</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Plunges</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>Rapids and retracts</source>
        <translation>Eilgänge und Rückzüge</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>Time at feed</source>
        <translation>Zeit im Vorschub</translation>
    </message>
    <message>
        <source>Time at feed: unknown, as a path has moves without a feed</source>
        <translation>Zeit im Vorschub: unbekannt, da eine Bahn Bewegungen ohne Vorschub hat</translation>
    </message>
    <message>
        <source>No deviation: one of the paths has no cuts</source>
        <translation>Keine Abweichung: eine der Bahnen hat keine Schnitte</translation>
    </message>
    <message>
        <source>First from second</source>
        <translation>Erste von der zweiten</translation>
    </message>
    <message>
        <source>Second from first</source>
        <translation>Zweite von der ersten</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>%1 and %2, tolerance %3 mm</source>
        <translation>%1 und %2, Toleranz %3 mm</translation>
    </message>
    <message>
        <source>the path has no edits</source>
        <translation>die Bahn hat keine Bearbeitungen</translation>
    </message>
    <message>
        <source>0 to %1</source>
        <translation>0 bis %1</translation>
    </message>
    <message>
        <source>assembly %2: %1 body, %3 mm^3</source>
        <translation>Baugruppe %2: %1 Körper, %3 mm^3</translation>
    </message>
    <message>
        <source>assembly %2: %1 bodies, %3 mm^3</source>
        <translation>Baugruppe %2: %1 Körper, %3 mm^3</translation>
    </message>
    <message>
        <source>body     %1: %2</source>
        <translation>Körper   %1: %2</translation>
    </message>
    <message>
        <source>N=MOTION[,reversed][,gain=G][,dead=SHARE] with N from 1 to %1 and one of the motions %2</source>
        <translation>N=BEWEGUNG[,reversed][,gain=G][,dead=ANTEIL] mit N von 1 bis %1 und einer der Bewegungen %2</translation>
    </message>
    <message>
        <source>N=ACTION with N from 1 to %1 and one of the actions %2</source>
        <translation>N=AKTION mit N von 1 bis %1 und einer der Aktionen %2</translation>
    </message>
    <message>
        <source>Leave the device at rest.</source>
        <translation>Berühren Sie das Gerät nicht.</translation>
    </message>
    <message>
        <source>Move every axis to both of its ends.</source>
        <translation>Bewegen Sie jede Achse bis an ihre beiden Enden.</translation>
    </message>
    <message>
        <source>%1: %2 mm (%3 to %4; %5)</source>
        <translation>%1: %2 mm (%3 bis %4; %5)</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>take %1 %2: there is no part to measure to</source>
        <translation>Aufnahme %1 %2: Es gibt kein Teil, zu dem gemessen werden kann</translation>
    </message>
    <message>
        <source>take %1 %2: the tool is %3 to %4 mm from the part</source>
        <translation>Aufnahme %1 %2: Das Werkzeug ist %3 bis %4 mm vom Teil entfernt</translation>
    </message>
    <message>
        <source>library &quot;%1&quot;:</source>
        <translation>Bibliothek „%1“:</translation>
    </message>
    <message>
        <source>%2: %1 tool</source>
        <translation>%2: %1 Werkzeug</translation>
    </message>
    <message>
        <source>%2: %1 tools</source>
        <translation>%2: %1 Werkzeuge</translation>
    </message>
    <message>
        <source>library &quot;%1&quot; added</source>
        <translation>Bibliothek „%1“ angelegt</translation>
    </message>
    <message>
        <source>an empty library, or --with-tools to delete its tools</source>
        <translation>eine leere Bibliothek, oder --with-tools, um ihre Werkzeuge zu löschen</translation>
    </message>
    <message>
        <source>library &quot;%2&quot; and %1 tool removed</source>
        <translation>Bibliothek „%2“ und %1 Werkzeug gelöscht</translation>
    </message>
    <message>
        <source>library &quot;%2&quot; and %1 tools removed</source>
        <translation>Bibliothek „%2“ und %1 Werkzeuge gelöscht</translation>
    </message>
    <message>
        <source>mine, or a library of your own</source>
        <translation>mine oder eine eigene Bibliothek</translation>
    </message>
    <message>
        <source>a tool of your own, or --copy</source>
        <translation>ein eigenes Werkzeug, oder --copy</translation>
    </message>
    <message>
        <source>%1: in the library &quot;%2&quot;</source>
        <translation>%1: in der Bibliothek „%2“</translation>
    </message>
    <message>
        <source>%1 (%2): %3 1/min, %4 mm/min</source>
        <translation>%1 (%2): %3 1/min, %4 mm/min</translation>
    </message>
    <message>
        <source>any material</source>
        <translation>jeder Werkstoff</translation>
    </message>
    <message>
        <source>no value, unless --fixed states that the tool does not turn</source>
        <translation>kein Wert, außer wenn --fixed angibt, dass sich das Werkzeug nicht dreht</translation>
    </message>
    <message>
        <source>does not turn: the models cut and touch the stock, with X at %1 degrees from X of the setup; the profile keeps them out of the part</source>
        <translation>dreht sich nicht: die Modelle schneiden und berühren das Rohteil, mit X um %1 Grad zu X der Aufspannung; das Profil hält sie vom Teil ab</translation>
    </message>
    <message>
        <source>at=X,Y in mm</source>
        <translation>at=X,Y in mm</translation>
    </message>
    <message>
        <source>place=X,Y,Z in mm</source>
        <translation>place=X,Y,Z in mm</translation>
    </message>
    <message>
        <source>turn=DEGREES</source>
        <translation>turn=GRAD</translation>
    </message>
    <message>
        <source>a size and its length in mm: SIZE=MM</source>
        <translation>ein Maß und seine Länge in mm: MASS=MM</translation>
    </message>
    <message>
        <source>X,Y in mm, or the number of a hole of the part, 1 to %1</source>
        <translation>X,Y in mm oder die Nummer einer Bohrung des Teils, 1 bis %1</translation>
    </message>
    <message>
        <source>stated   unit %1: %2</source>
        <translation>laut Datei Einheit %1: %2</translation>
    </message>
    <message>
        <source>#RRGGBB, such as #3070c0</source>
        <translation>#RRGGBB, zum Beispiel #3070c0</translation>
    </message>
    <message>
        <source>mm, cm, dm, m, km, µm, inch, foot, yard, mil, stated, or mm per unit from 0.000001 to 1000000</source>
        <translation>mm, cm, dm, m, km, µm, inch, foot, yard, mil, stated oder mm je Einheit von 0.000001 bis 1000000</translation>
    </message>
    <message>
        <source>already deleted: %1</source>
        <translation>bereits gelöscht: %1</translation>
    </message>
    <message>
        <source>already in the library: %1</source>
        <translation>bereits in der Bibliothek: %1</translation>
    </message>
    <message>
        <source>Axes whose readings at rest were all 0 keep their rest and dead zone (%1). If the device reports an axis only once it was moved, move every axis once, then calibrate again.</source>
        <translation>Achsen, deren Messwerte in Ruhe alle 0 waren, behalten Ruhelage und Totzone (%1). Meldet das Gerät eine Achse erst, nachdem sie bewegt wurde, bewegen Sie jede Achse einmal und kalibrieren Sie dann erneut.</translation>
    </message>
    <message>
        <source>%1: %2 mm, or fitted to the stock (%3 to %4; %5)</source>
        <translation>%1: %2 mm, oder dem Rohteil angepasst (%3 bis %4; %5)</translation>
    </message>
    <message>
        <source>library &quot;%1&quot; renamed to &quot;%2&quot;</source>
        <translation>Bibliothek „%1“ in „%2“ umbenannt</translation>
    </message>
    <message>
        <source>; shank or holder were kept away from the stock in %1 ticks</source>
        <translation>; Schaft oder Halter wurden in %1 Takten vom Rohteil ferngehalten</translation>
    </message>
    <message>
        <source>with --stock-distance, a trace that does not state this distance itself</source>
        <translation>mit --stock-distance eine Spur, die diesen Abstand nicht selbst angibt</translation>
    </message>
    <message>
        <source>no value, unless --stylus is a device</source>
        <translation>kein Wert, außer wenn --stylus ein Gerät ist</translation>
    </message>
    <message>
        <source>all passes are up to date</source>
        <translation>alle Durchgänge sind aktuell</translation>
    </message>
    <message>
        <source>hollow, %1 mm in diameter and %2 mm deep (at most %3 mm narrower than the model): a core stands in it; the tool stays upright</source>
        <translation>hohl, %1 mm im Durchmesser und %2 mm tief (höchstens %3 mm enger als das Modell): darin bleibt ein Kern stehen; das Werkzeug bleibt aufrecht</translation>
    </message>
    <message>
        <source>the stock</source>
        <translation>das Rohteil</translation>
    </message>
    <message>
        <source>X,Y,Z=AXIS: a point in mm, and x, -x, y, -y or -z</source>
        <translation>X,Y,Z=ACHSE: ein Punkt in mm, und x, -x, y, -y oder -z</translation>
    </message>
    <message>
        <source>a point from which the tool meets a side of the stock squarely, a ball with its middle below the upper edge</source>
        <translation>ein Punkt, von dem aus das Werkzeug gerade auf eine Seite des Rohteils trifft, eine Kugel mit ihrer Mitte unter der oberen Kante</translation>
    </message>
    <message>
        <source>%1 mm were skipped: already finished by hand strokes.</source>
        <translation>%1 mm wurden ausgelassen: von Zügen der Hand bereits fertig bearbeitet.</translation>
    </message>
    <message>
        <source>pass %1 is out of date: hand strokes that it depends on have changed. Compute it again with &quot;recompute --outdated&quot;.</source>
        <translation>Durchgang %1 ist veraltet: Züge der Hand, von denen er abhängt, haben sich geändert. Mit „recompute --outdated“ neu berechnen.</translation>
    </message>
    <message>
        <source>a device with motors, and a test of 200 readings or more</source>
        <translation>ein Gerät mit Motoren und ein Test mit mindestens 200 Messwerten</translation>
    </message>
    <message>
        <source>used with --workpiece or --workpiece-file</source>
        <translation>zusammen mit --workpiece oder --workpiece-file</translation>
    </message>
    <message>
        <source>by=X,Y,Z in mm</source>
        <translation>by=X,Y,Z in mm</translation>
    </message>
    <message>
        <source>X,Y in mm, or the number of a stud of the part, 1 to %1</source>
        <translation>X,Y in mm oder die Nummer eines Zapfens des Teils, 1 bis %1</translation>
    </message>
    <message>
        <source>studs    %1</source>
        <translation>Zapfen    %1</translation>
    </message>
    <message>
        <source>touched  %1 %2 mm, within %3 mm</source>
        <translation>angetastet  %1 %2 mm, auf %3 mm genau</translation>
    </message>
    <message>
        <source>touched  %1 %2 mm</source>
        <translation>angetastet  %1 %2 mm</translation>
    </message>
</context>
<context>
    <name>Detail</name>
    <message>
        <source>an id that no shipped machine has; shipped machines can be copied, not changed</source>
        <translation>eine Kennung, die keine mitgelieferte Maschine hat; mitgelieferte Maschinen lassen sich kopieren, nicht ändern</translation>
    </message>
    <message>
        <source>an id that no machine has yet, or --replace</source>
        <translation>eine Kennung, die noch keine Maschine hat, oder --replace</translation>
    </message>
    <message>
        <source>an id that no material has yet, or --replace</source>
        <translation>eine Kennung, die noch kein Werkstoff hat, oder --replace</translation>
    </message>
    <message>
        <source>a machine of your own; those that Burin is shipped with can&apos;t be deleted</source>
        <translation>eine eigene Maschine; mitgelieferte lassen sich nicht löschen</translation>
    </message>
    <message>
        <source>letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;, a letter or digit first</source>
        <translation>Buchstaben, Ziffern, „-“, „_“ und „.“, zuerst ein Buchstabe oder eine Ziffer</translation>
    </message>
    <message>
        <source>a file other than &quot;%1&quot; and those that Burin keeps beside it</source>
        <translation>eine andere Datei als „%1“ und die, die Burin daneben ablegt</translation>
    </message>
    <message>
        <source>there is no home folder</source>
        <translation>es gibt keinen Benutzerordner</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>is no plain file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>the system states no reason</source>
        <translation>das System nennt keinen Grund</translation>
    </message>
    <message>
        <source>%1; the new content stands there all the same</source>
        <translation>%1; der neue Inhalt steht trotzdem dort</translation>
    </message>
    <message>
        <source>%1 is in the way</source>
        <translation>%1 ist im Weg</translation>
    </message>
    <message>
        <source>its folder is protected</source>
        <translation>ihr Ordner ist geschützt</translation>
    </message>
    <message>
        <source>it was changed while it was read</source>
        <translation>sie wurde während des Lesens geändert</translation>
    </message>
    <message>
        <source>a take that no path uses (this one: %1)</source>
        <translation>eine Aufnahme, die keine Bahn verwendet (diese: %1)</translation>
    </message>
    <message>
        <source>take %1, undone samples</source>
        <translation>Aufnahme %1, zurückgenommene Messpunkte</translation>
    </message>
    <message>
        <source>take %1, sample %2</source>
        <translation>Aufnahme %1, Messpunkt %2</translation>
    </message>
    <message>
        <source>path %1, edit %2</source>
        <translation>Bahn %1, Bearbeitung %2</translation>
    </message>
    <message>
        <source>take %1; the path is for %2</source>
        <translation>Aufnahme %1; die Bahn ist für %2</translation>
    </message>
    <message>
        <source>is not JSON</source>
        <translation>ist kein JSON</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>stands twice</source>
        <translation>steht zweimal da</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is not known</source>
        <translation>ist unbekannt</translation>
    </message>
    <message>
        <source>has to be the file&apos;s name</source>
        <translation>muss der Name der Datei sein</translation>
    </message>
    <message>
        <source>differs from the file&apos;s name</source>
        <translation>weicht vom Namen der Datei ab</translation>
    </message>
    <message>
        <source>names no key of this file</source>
        <translation>nennt keinen Schlüssel dieser Datei</translation>
    </message>
    <message>
        <source>has to be above 0 with this rule</source>
        <translation>muss mit dieser Regel über 0 sein</translation>
    </message>
    <message>
        <source>has to be below largest_radius_mm</source>
        <translation>muss unter largest_radius_mm liegen</translation>
    </message>
    <message>
        <source>has to be above 0 and above the one before</source>
        <translation>muss über 0 und über dem vorigen Wert liegen</translation>
    </message>
    <message>
        <source>has to hold a point at least</source>
        <translation>muss mindestens einen Punkt enthalten</translation>
    </message>
    <message>
        <source>has to be above 0</source>
        <translation>muss über 0 sein</translation>
    </message>
    <message>
        <source>has to be at most maximum_spindle_speed_rpm</source>
        <translation>darf höchstens maximum_spindle_speed_rpm sein</translation>
    </message>
    <message>
        <source>has to be at most rapid_feed_mm_per_min, the greatest feed of all</source>
        <translation>darf höchstens rapid_feed_mm_per_min sein, der größte Vorschub überhaupt</translation>
    </message>
    <message>
        <source>has to be below the travel of Z</source>
        <translation>muss unter dem Verfahrweg von Z liegen</translation>
    </message>
    <message>
        <source>has to be at most travel_mm[%1] from the machine&apos;s zero</source>
        <translation>darf höchstens travel_mm[%1] vom Maschinennullpunkt entfernt sein</translation>
    </message>
    <message>
        <source>has {%1}, which is none of {%2}</source>
        <translation>enthält {%1}, das nicht zu {%2} gehört</translation>
    </message>
    <message>
        <source>has to hold one of {%1}</source>
        <translation>muss eines von {%1} enthalten</translation>
    </message>
    <message>
        <source>has to be one line</source>
        <translation>muss eine Zeile sein</translation>
    </message>
    <message>
        <source>has more than %1, which has to stand alone</source>
        <translation>enthält mehr als %1, das allein stehen muss</translation>
    </message>
    <message>
        <source>has to be one of: %1</source>
        <translation>muss eines davon sein: %1</translation>
    </message>
    <message>
        <source>has to be a whole number from %1 to %2</source>
        <translation>muss eine ganze Zahl von %1 bis %2 sein</translation>
    </message>
    <message>
        <source>has to be whole numbers</source>
        <translation>muss aus ganzen Zahlen bestehen</translation>
    </message>
    <message>
        <source>has to be true or false</source>
        <translation>muss true oder false sein</translation>
    </message>
    <message>
        <source>has to be a text that is not empty</source>
        <translation>muss ein Text sein, der nicht leer ist</translation>
    </message>
    <message>
        <source>has to be a list of texts</source>
        <translation>muss eine Liste von Texten sein</translation>
    </message>
    <message>
        <source>has to be a list of %1 numbers</source>
        <translation>muss eine Liste von %1 Zahlen sein</translation>
    </message>
    <message>
        <source>has to be a list</source>
        <translation>muss eine Liste sein</translation>
    </message>
    <message>
        <source>has to be an object</source>
        <translation>muss ein Objekt sein</translation>
    </message>
    <message>
        <source>has to be a number</source>
        <translation>muss eine Zahl sein</translation>
    </message>
    <message>
        <source>has to be a number of at least %1</source>
        <translation>muss eine Zahl von mindestens %1 sein</translation>
    </message>
    <message>
        <source>has to be a number of at most %1</source>
        <translation>muss eine Zahl von höchstens %1 sein</translation>
    </message>
    <message>
        <source>has to be a number from %1 to %2</source>
        <translation>muss eine Zahl von %1 bis %2 sein</translation>
    </message>
    <message>
        <source>has to be %1</source>
        <translation>muss so sein: %1</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number of at least %1</source>
        <translation>eine Zahl von mindestens %1</translation>
    </message>
    <message>
        <source>a number of at most %1</source>
        <translation>eine Zahl von höchstens %1</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>the material needs a value above 0</source>
        <translation>der Werkstoff braucht einen Wert über 0</translation>
    </message>
    <message>
        <source>left out: this type has none</source>
        <translation>weggelassen: diese Art hat keinen</translation>
    </message>
    <message>
        <source>half the diameter for a ball end or lollipop</source>
        <translation>der halbe Durchmesser bei Kugel- und Kugelkopffräsern</translation>
    </message>
    <message>
        <source>above 0 and below half the diameter</source>
        <translation>über 0 und unter dem halben Durchmesser</translation>
    </message>
    <message>
        <source>0 for a sharp end</source>
        <translation>0 bei scharfer Ecke</translation>
    </message>
    <message>
        <source>above 0, at most 89</source>
        <translation>über 0, höchstens 89</translation>
    </message>
    <message>
        <source>at least 0 and below the diameter</source>
        <translation>mindestens 0 und unter dem Durchmesser</translation>
    </message>
    <message>
        <source>small enough to round the edge of the tip</source>
        <translation>klein genug, um die Kante der Spitze zu runden</translation>
    </message>
    <message>
        <source>small enough to leave a cone</source>
        <translation>klein genug, um einen Kegel übrig zu lassen</translation>
    </message>
    <message>
        <source>at most what the cone reaches at the end of the flutes (%1)</source>
        <translation>höchstens, was der Kegel am Ende der Schneiden erreicht (%1)</translation>
    </message>
    <message>
        <source>above half the diameter and below the diameter: where the ball ends and the shank begins</source>
        <translation>über dem halben und unter dem ganzen Durchmesser: wo die Kugel endet und der Schaft beginnt</translation>
    </message>
    <message>
        <source>at least half the distance of the arc&apos;s ends</source>
        <translation>mindestens der halbe Abstand der Bogenenden</translation>
    </message>
    <message>
        <source>an arc that rises all the way from its beginning to its end and stays off the axis</source>
        <translation>ein Bogen, der von Anfang bis Ende steigt und die Achse nicht erreicht</translation>
    </message>
    <message>
        <source>at least one line or arc</source>
        <translation>mindestens eine Linie oder ein Bogen</translation>
    </message>
    <message>
        <source>at least the height at which the element begins: profiles never fall, so a cupped tip can&apos;t be drawn</source>
        <translation>mindestens die Höhe, in der das Element beginnt: Profile fallen nie, eine hohle Spitze ist also nicht möglich</translation>
    </message>
    <message>
        <source>a point other than the element&apos;s beginning</source>
        <translation>ein anderer Punkt als der Anfang des Elements</translation>
    </message>
    <message>
        <source>the height at which the profile ends</source>
        <translation>die Höhe, in der das Profil endet</translation>
    </message>
    <message>
        <source>twice the profile&apos;s largest radius</source>
        <translation>das Doppelte des größten Radius des Profils</translation>
    </message>
    <message>
        <source>&gt; 0 and at least the corner radius</source>
        <translation>&gt; 0 und mindestens der Eckenradius</translation>
    </message>
    <message>
        <source>at least the length of the flutes</source>
        <translation>mindestens die Länge der Schneiden</translation>
    </message>
    <message>
        <source>&gt; 0 and at most the length of the flutes</source>
        <translation>&gt; 0 und höchstens die Länge der Schneiden</translation>
    </message>
    <message>
        <source>not empty</source>
        <translation>nicht leer</translation>
    </message>
    <message>
        <source>at least 0</source>
        <translation>mindestens 0</translation>
    </message>
    <message>
        <source>at least 1</source>
        <translation>mindestens 1</translation>
    </message>
    <message>
        <source>above 0</source>
        <translation>über 0</translation>
    </message>
    <message>
        <source>two finite corners, each coordinate of the second above the first&apos;s</source>
        <translation>zwei endliche Ecken, jede Koordinate der zweiten über der der ersten</translation>
    </message>
    <message>
        <source>a finite length above 0 mm</source>
        <translation>eine endliche Länge über 0 mm</translation>
    </message>
    <message>
        <source>a finite length of 0 mm or more</source>
        <translation>eine endliche Länge ab 0 mm</translation>
    </message>
    <message>
        <source>finite lengths of 0 mm or more</source>
        <translation>endliche Längen ab 0 mm</translation>
    </message>
    <message>
        <source>finite lengths</source>
        <translation>endliche Längen</translation>
    </message>
    <message>
        <source>a finite box</source>
        <translation>ein endlicher Quader</translation>
    </message>
    <message>
        <source>a model with at least one body</source>
        <translation>ein Modell mit mindestens einem Körper</translation>
    </message>
    <message>
        <source>%1 voxels on one axis</source>
        <translation>%1 Voxel auf einer Achse</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 Voxel</translation>
    </message>
    <message>
        <source>its triangles face inwards</source>
        <translation>ihre Dreiecke zeigen nach innen</translation>
    </message>
    <message>
        <source>no body</source>
        <translation>kein Körper</translation>
    </message>
    <message>
        <source>%1 open edges</source>
        <translation>%1 offene Kanten</translation>
    </message>
    <message>
        <source>the end of the file is missing</source>
        <translation>das Ende der Datei fehlt</translation>
    </message>
    <message>
        <source>it refers to itself</source>
        <translation>sie verweist auf sich selbst</translation>
    </message>
    <message>
        <source>parts in other folders</source>
        <translation>Teile in anderen Ordnern</translation>
    </message>
    <message>
        <source>a tessellation alone</source>
        <translation>nur ein Dreiecksnetz</translation>
    </message>
    <message>
        <source>no shape</source>
        <translation>keine Form</translation>
    </message>
    <message>
        <source>no faces</source>
        <translation>keine Flächen</translation>
    </message>
    <message>
        <source>no triangles</source>
        <translation>keine Dreiecke</translation>
    </message>
    <message>
        <source>triangle %1 of %2</source>
        <translation>Dreieck %1 von %2</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>%1 of %2 faces of &quot;%3&quot;</source>
        <translation>%1 von %2 Flächen von „%3“</translation>
    </message>
    <message>
        <source>%1 triangles with %2 open edges</source>
        <translation>%1 Dreiecke mit %2 offenen Kanten</translation>
    </message>
    <message>
        <source>1 face with %1</source>
        <translation>1 Fläche mit %1</translation>
    </message>
    <message>
        <source>%1 faces with %2</source>
        <translation>%1 Flächen mit %2</translation>
    </message>
    <message>
        <source>1 open edge</source>
        <translation>1 offene Kante</translation>
    </message>
    <message>
        <source>1 edge</source>
        <translation>1 Kante</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 Kanten</translation>
    </message>
    <message>
        <source>it answered something else</source>
        <translation>es antwortete etwas anderes</translation>
    </message>
    <message>
        <source>its answer is damaged</source>
        <translation>seine Antwort ist beschädigt</translation>
    </message>
    <message>
        <source>its answer has no end</source>
        <translation>seine Antwort hat kein Ende</translation>
    </message>
    <message>
        <source>signal %1 (%2)</source>
        <translation>Signal %1 (%2)</translation>
    </message>
    <message>
        <source>exit status %1 without an answer</source>
        <translation>Rückgabewert %1 ohne Antwort</translation>
    </message>
    <message>
        <source>its end was lost</source>
        <translation>sein Ende ging verloren</translation>
    </message>
    <message>
        <source>noise hides the cutting force; measure deeper cuts or more of them</source>
        <translation>Rauschen verdeckt die Schnittkraft; messen Sie tiefere Schnitte oder mehr davon</translation>
    </message>
    <message>
        <source>the forces on the workpiece point against the feed; are they those on the tool?</source>
        <translation>die Kräfte auf das Werkstück zeigen gegen den Vorschub; sind es die auf das Werkzeug?</translation>
    </message>
    <message>
        <source>the forces on the tool point along the feed; are they those on the workpiece (--on-workpiece)?</source>
        <translation>die Kräfte auf das Werkzeug zeigen in Vorschubrichtung; sind es die auf das Werkstück (--on-workpiece)?</translation>
    </message>
    <message>
        <source>the records disagree too much; look for air cuts, chatter or wrong conditions in them</source>
        <translation>die Messungen streuen zu sehr; suchen Sie darin nach Luftschnitten, Rattern oder falschen Bedingungen</translation>
    </message>
    <message>
        <source>the force of the edge comes out negative; use another law (--law kienzle or constant)</source>
        <translation>die Kraft der Schneide wird negativ; verwenden Sie ein anderes Gesetz (--law kienzle oder constant)</translation>
    </message>
    <message>
        <source>the radial force pulls the tool into the material; use another projection (--projection)</source>
        <translation>die Radialkraft zieht das Werkzeug ins Material; verwenden Sie eine andere Projektion (--projection)</translation>
    </message>
    <message>
        <source>only %1 records can be used; measure %2 or more</source>
        <translation>nur %1 Messungen sind brauchbar; messen Sie mindestens %2</translation>
    </message>
    <message>
        <source>the edge&apos;s force needs chips of different thickness; measure feeds that differ by a factor of %1 or more, or use another law (--law constant)</source>
        <translation>die Kraft der Schneide braucht verschieden dicke Späne; messen Sie Vorschübe, die sich mindestens um den Faktor %1 unterscheiden, oder verwenden Sie ein anderes Gesetz (--law constant)</translation>
    </message>
    <message>
        <source>an exponent needs chips of different thickness; measure feeds that differ by a factor of %1 or more</source>
        <translation>ein Exponent braucht verschieden dicke Späne; messen Sie Vorschübe, die sich mindestens um den Faktor %1 unterscheiden</translation>
    </message>
    <message>
        <source>noise hides the exponent; measure feeds that differ more, or more of them, or use a constant K</source>
        <translation>Rauschen verdeckt den Exponenten; messen Sie Vorschübe, die sich stärker unterscheiden, oder mehr davon, oder verwenden Sie ein konstantes K</translation>
    </message>
    <message>
        <source>far off: %1 N tangential, %2 N radial deviation from the fit; %3 N and %4 N would count</source>
        <translation>Ausreißer: %1 N tangentiale, %2 N radiale Abweichung von der Anpassung; %3 N und %4 N würden zählen</translation>
    </message>
    <message>
        <source>far off: %1 N deviation from the fit; %2 N would count</source>
        <translation>Ausreißer: %1 N Abweichung von der Anpassung; %2 N würden zählen</translation>
    </message>
    <message>
        <source>nothing was removed</source>
        <translation>nichts wurde abgetragen</translation>
    </message>
    <message>
        <source>the feed is along the tool axis</source>
        <translation>der Vorschub liegt in der Werkzeugachse</translation>
    </message>
    <message>
        <source>the column immersion does not say up or down</source>
        <translation>die Spalte immersion sagt nicht up oder down</translation>
    </message>
    <message>
        <source>is missing; write a number</source>
        <translation>fehlt; schreiben Sie eine Zahl</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number with a decimal point</source>
        <translation>„%1“ ist keine Zahl mit Dezimalpunkt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range; %2 to %3</source>
        <translation>„%1“ liegt außerhalb des Bereichs; %2 bis %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to be above 0</source>
        <translation>„%1“ muss über 0 sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no id; letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;, a letter or digit first</source>
        <translation>„%1“ ist keine Kennung; Buchstaben, Ziffern, „-“, „_“ und „.“, zuerst ein Buchstabe oder eine Ziffer</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to be a whole number from 1 to 1000</source>
        <translation>„%1“ muss eine ganze Zahl von 1 bis 1000 sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to be slot, up, down or empty</source>
        <translation>„%1“ muss slot, up, down oder leer sein</translation>
    </message>
    <message>
        <source>there is no row below the heading</source>
        <translation>unter der Kopfzeile steht keine Zeile</translation>
    </message>
    <message>
        <source>is not UTF-8; save the table as CSV UTF-8</source>
        <translation>ist kein UTF-8; speichern Sie die Tabelle als CSV UTF-8</translation>
    </message>
    <message>
        <source>a quotation mark does not end</source>
        <translation>ein Anführungszeichen endet nicht</translation>
    </message>
    <message>
        <source>has semicolons; save the table with commas and decimal points</source>
        <translation>enthält Semikolons; speichern Sie die Tabelle mit Kommas und Dezimalpunkten</translation>
    </message>
    <message>
        <source>is not known; call columns that are for people note…</source>
        <translation>ist unbekannt; nennen Sie Spalten für Menschen note…</translation>
    </message>
    <message>
        <source>is there twice</source>
        <translation>ist zweimal da</translation>
    </message>
    <message>
        <source>is missing; the first line has to name it</source>
        <translation>fehlt; die erste Zeile muss sie nennen</translation>
    </message>
    <message>
        <source>the row has %1 values, the heading %2; write decimal points, not commas</source>
        <translation>die Zeile hat %1 Werte, die Kopfzeile %2; schreiben Sie Dezimalpunkte, keine Kommas</translation>
    </message>
    <message>
        <source>the tool axis has no length</source>
        <translation>die Werkzeugachse hat keine Länge</translation>
    </message>
    <message>
        <source>the feed has no direction</source>
        <translation>der Vorschub hat keine Richtung</translation>
    </message>
    <message>
        <source>is more than the diameter</source>
        <translation>ist mehr als der Durchmesser</translation>
    </message>
    <message>
        <source>a slot&apos;s radial depth is the diameter; write up or down</source>
        <translation>die radiale Tiefe einer Nut ist der Durchmesser; schreiben Sie up oder down</translation>
    </message>
    <message>
        <source>its conditions differ from line %1 of the same cut; give it a name of its own</source>
        <translation>seine Bedingungen weichen von Zeile %1 desselben Schnitts ab; geben Sie ihm einen eigenen Namen</translation>
    </message>
    <message>
        <source>value %1 is not a number</source>
        <translation>Wert %1 ist keine Zahl</translation>
    </message>
    <message>
        <source>buttons is not a whole number from 0 to 4294967295</source>
        <translation>buttons ist keine ganze Zahl von 0 bis 4294967295</translation>
    </message>
    <message>
        <source>not %1 values between commas</source>
        <translation>nicht %1 Werte zwischen Kommas</translation>
    </message>
    <message>
        <source>value 11 is neither 0 nor 1</source>
        <translation>Wert 11 ist weder 0 noch 1</translation>
    </message>
    <message>
        <source>value 12 is not a number of at least 0</source>
        <translation>Wert 12 ist keine Zahl ab 0</translation>
    </message>
    <message>
        <source>the quaternion&apos;s length is not 1</source>
        <translation>die Länge der Quaternion ist nicht 1</translation>
    </message>
    <message>
        <source>the first line must be %1</source>
        <translation>die erste Zeile muss so lauten: %1</translation>
    </message>
    <message>
        <source>the second line must be %1</source>
        <translation>die zweite Zeile muss so lauten: %1</translation>
    </message>
    <message>
        <source>the time is not later than in the line before</source>
        <translation>die Zeit ist nicht später als in der Zeile davor</translation>
    </message>
    <message>
        <source>no reading follows</source>
        <translation>kein Messwert folgt</translation>
    </message>
    <message>
        <source>a session begins once, before its first reading</source>
        <translation>eine Sitzung beginnt nur einmal, vor ihrem ersten Messwert</translation>
    </message>
    <message>
        <source>the workpiece was changed there by something else than milling</source>
        <translation>dort wurde das Werkstück durch etwas anderes als Fräsen verändert</translation>
    </message>
    <message>
        <source>the boundary that this project&apos;s tool has is made of fewer</source>
        <translation>die Grenzfläche des Werkzeugs in diesem Projekt besteht aus weniger</translation>
    </message>
    <message>
        <source>tile %1</source>
        <translation>Kachel %1</translation>
    </message>
    <message>
        <source>at least one reading</source>
        <translation>mindestens ein Messwert</translation>
    </message>
    <message>
        <source>times that rise</source>
        <translation>steigende Zeiten</translation>
    </message>
    <message>
        <source>realtime with a device that keeps its own time</source>
        <translation>Echtzeit, bei einem Gerät mit eigenem Takt</translation>
    </message>
    <message>
        <source>%1; its start is set by line %2 and line %3</source>
        <translation>%1; seinen Anfang setzen Zeile %2 und Zeile %3</translation>
    </message>
    <message>
        <source>%1; its start is set by line %2</source>
        <translation>%1; seinen Anfang setzt Zeile %2</translation>
    </message>
    <message>
        <source>%1; distances are incremental since line %2</source>
        <translation>%1; seit Zeile %2 sind Wege inkremental</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>a move of %1 mm, and up to %2 mm are checked</source>
        <translation>eine Bewegung von %1 mm, und bis zu %2 mm werden geprüft</translation>
    </message>
    <message>
        <source>all moves up to here are longer than the %1 mm that are checked</source>
        <translation>alle Bewegungen bis hier sind länger als die %1 mm, die geprüft werden</translation>
    </message>
    <message>
        <source>a number of its own for each tool of a program</source>
        <translation>eine eigene Nummer für jedes Werkzeug eines Programms</translation>
    </message>
    <message>
        <source>has to begin with a rapid move; link it first</source>
        <translation>muss mit einer Eilgangbewegung beginnen; verbinden Sie zuerst</translation>
    </message>
    <message>
        <source>has to begin with a rapid move</source>
        <translation>muss mit einer Eilgangbewegung beginnen</translation>
    </message>
    <message>
        <source>its tool has no number</source>
        <translation>ihr Werkzeug hat keine Nummer</translation>
    </message>
    <message>
        <source>missing at point %1</source>
        <translation>fehlt an Punkt %1</translation>
    </message>
    <message>
        <source>point %1 is not finite</source>
        <translation>Punkt %1 ist nicht endlich</translation>
    </message>
    <message>
        <source>point %1 can&apos;t be the end of an arc</source>
        <translation>Punkt %1 kann nicht das Ende eines Bogens sein</translation>
    </message>
    <message>
        <source>%1 characters, limit %2</source>
        <translation>%1 Zeichen, Grenze %2</translation>
    </message>
    <message>
        <source>%1, limit %2</source>
        <translation>%1, Grenze %2</translation>
    </message>
    <message>
        <source>not a time</source>
        <translation>keine Zeit</translation>
    </message>
    <message>
        <source>coordinate is not a valid position</source>
        <translation>die Koordinate ist keine gültige Position</translation>
    </message>
    <message>
        <source>centre is not a valid position</source>
        <translation>der Mittelpunkt ist keine gültige Position</translation>
    </message>
    <message>
        <source>one program a tool</source>
        <translation>ein Programm je Werkzeug</translation>
    </message>
    <message>
        <source>G54 to G59</source>
        <translation>G54 bis G59</translation>
    </message>
    <message>
        <source>a line with no cut from an unknown position behind it (line %1)</source>
        <translation>eine Zeile ohne Schnitt ab unbekannter Position dahinter (Zeile %1)</translation>
    </message>
    <message>
        <source>a line with no cut without a feed behind it (line %1)</source>
        <translation>eine Zeile ohne Schnitt ohne Vorschub dahinter (Zeile %1)</translation>
    </message>
    <message>
        <source>a line with no cut without a spindle behind it (line %1)</source>
        <translation>eine Zeile ohne Schnitt ohne Spindel dahinter (Zeile %1)</translation>
    </message>
    <message>
        <source>none; the program cuts nothing</source>
        <translation>keine; das Programm schneidet nichts</translation>
    </message>
    <message>
        <source>1 to %1, the line of the last cut</source>
        <translation>1 bis %1, die Zeile des letzten Schnitts</translation>
    </message>
    <message>
        <source>%1 to %2, a whole number</source>
        <translation>%1 bis %2, eine ganze Zahl</translation>
    </message>
    <message>
        <source>coordinates from %1 to %2</source>
        <translation>Koordinaten von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 to %2 points</source>
        <translation>%1 bis %2 Punkte</translation>
    </message>
    <message>
        <source>coordinates up to %1</source>
        <translation>Koordinaten bis %1</translation>
    </message>
    <message>
        <source>a take and a tick of it, from 0</source>
        <translation>eine Aufnahme und einer ihrer Takte, ab 0</translation>
    </message>
    <message>
        <source>a take and two ticks of it, the earlier one first</source>
        <translation>eine Aufnahme und zwei ihrer Takte, der frühere zuerst</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>eines davon: %1</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>drei Zahlen</translation>
    </message>
    <message>
        <source>a list of points, three numbers each</source>
        <translation>eine Liste von Punkten zu je drei Zahlen</translation>
    </message>
    <message>
        <source>no parameter of %1</source>
        <translation>kein Parameter von %1</translation>
    </message>
    <message>
        <source>a JSON object</source>
        <translation>ein JSON-Objekt</translation>
    </message>
    <message>
        <source>below half of the recording&apos;s rate</source>
        <translation>unter der halben Rate der Aufzeichnung</translation>
    </message>
    <message>
        <source>no more than %1 of so long a path</source>
        <translation>höchstens %1 von einer so langen Bahn</translation>
    </message>
    <message>
        <source>moments that the path still has</source>
        <translation>Zeitpunkte, die die Bahn noch hat</translation>
    </message>
    <message>
        <source>takes milled with the axis fixed at +Z (--axis fixed), unlike take %1</source>
        <translation>Aufnahmen, die mit der Achse +Z gefräst wurden (--axis fixed), anders als Aufnahme %1</translation>
    </message>
    <message>
        <source>set-feed, then level-feed</source>
        <translation>set-feed, dann level-feed</translation>
    </message>
    <message>
        <source>one that has not ended</source>
        <translation>eine, die nicht beendet ist</translation>
    </message>
    <message>
        <source>none: the part alone is there</source>
        <translation>keine: nur das Teil ist da</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to be a text</source>
        <translation>„%1“ muss ein Text sein</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>unbekannter Schlüssel „%1“</translation>
    </message>
    <message>
        <source>not a JSON object</source>
        <translation>kein JSON-Objekt</translation>
    </message>
    <message>
        <source>not JSON</source>
        <translation>kein JSON</translation>
    </message>
    <message>
        <source>&quot;interface_version&quot; has to be a whole number</source>
        <translation>„interface_version“ muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>&quot;kind&quot; has to be &quot;%1&quot;</source>
        <translation>„kind“ muss „%1“ sein</translation>
    </message>
    <message>
        <source>id &quot;%1&quot; is taken already</source>
        <translation>die Kennung „%1“ ist schon vergeben</translation>
    </message>
    <message>
        <source>unknown reason</source>
        <translation>Grund unbekannt</translation>
    </message>
    <message>
        <source>its entry point threw</source>
        <translation>sein Einstiegspunkt hat eine Ausnahme geworfen</translation>
    </message>
    <message>
        <source>its entry point gave nothing</source>
        <translation>sein Einstiegspunkt lieferte nichts</translation>
    </message>
    <message>
        <source>it made nothing</source>
        <translation>er lieferte nichts</translation>
    </message>
    <message>
        <source>it threw: %1</source>
        <translation>er warf eine Ausnahme: %1</translation>
    </message>
    <message>
        <source>it threw</source>
        <translation>er warf eine Ausnahme</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>takes of the path&apos;s own setup</source>
        <translation>Aufnahmen aus der Aufspannung der Bahn</translation>
    </message>
    <message>
        <source>a tool that cuts sideways and is nowhere wider below than above</source>
        <translation>ein Werkzeug, das seitlich schneidet und unten nirgends breiter ist als oben</translation>
    </message>
    <message>
        <source>%1 must be file names without a folder</source>
        <translation>%1 müssen Dateinamen ohne Ordner sein</translation>
    </message>
    <message>
        <source>at least one body whose role is part, or free carving</source>
        <translation>mindestens ein Körper mit der Rolle Bauteil, oder freies Schnitzen</translation>
    </message>
    <message>
        <source>a box whose second corner lies above the first along each axis</source>
        <translation>ein Quader, dessen zweite Ecke auf jeder Achse über der ersten liegt</translation>
    </message>
    <message>
        <source>a direction</source>
        <translation>eine Richtung</translation>
    </message>
    <message>
        <source>a finite base, a radius and a height above 0 mm</source>
        <translation>ein endlicher Fußpunkt, Radius und Höhe über 0 mm</translation>
    </message>
    <message>
        <source>solids where a body has the role stock, a box or a cylinder</source>
        <translation>solids, wo ein Körper die Rolle Rohteil hat, ein Quader oder ein Zylinder</translation>
    </message>
    <message>
        <source>a file where one was read, a box, a cylinder or solids</source>
        <translation>eine Datei, wo eine gelesen wurde, ein Quader, ein Zylinder oder Körper</translation>
    </message>
    <message>
        <source>a stated box or cylinder, as there is no body to lay one around</source>
        <translation>ein angegebener Quader oder Zylinder, da es keinen Körper gibt, um den einer gelegt werden könnte</translation>
    </message>
    <message>
        <source>a volume that is not air all over</source>
        <translation>ein Volumen, das nicht überall Luft ist</translation>
    </message>
    <message>
        <source>a closed surface; close its holes</source>
        <translation>eine geschlossene Oberfläche; schließen Sie ihre Löcher</translation>
    </message>
    <message>
        <source>a table of what the values of the array mean</source>
        <translation>eine Tabelle, was die Werte des Felds bedeuten</translation>
    </message>
    <message>
        <source>a body that a scanline meets; smaller voxels may help</source>
        <translation>ein Körper, den eine Abtastzeile trifft; kleinere Voxel können helfen</translation>
    </message>
    <message>
        <source>a first plane below the second</source>
        <translation>eine erste Ebene unter der zweiten</translation>
    </message>
    <message>
        <source>a formula or table whose values are above 0 all over the layer</source>
        <translation>eine Formel oder Tabelle, deren Werte in der ganzen Schicht über 0 liegen</translation>
    </message>
    <message>
        <source>a name that is not empty</source>
        <translation>ein Name, der nicht leer ist</translation>
    </message>
    <message>
        <source>a name that no other layer has</source>
        <translation>ein Name, den keine andere Schicht hat</translation>
    </message>
    <message>
        <source>planes between which there is stock</source>
        <translation>Ebenen, zwischen denen Rohteil liegt</translation>
    </message>
    <message>
        <source>positions that rise</source>
        <translation>steigende Positionen</translation>
    </message>
    <message>
        <source>the id of a material</source>
        <translation>die Kennung eines Werkstoffs</translation>
    </message>
    <message>
        <source>the name of one of the material&apos;s values</source>
        <translation>der Name eines der Werte des Werkstoffs</translation>
    </message>
    <message>
        <source>two lines or more, each a position in mm and a value</source>
        <translation>zwei Zeilen oder mehr, jede eine Position in mm und ein Wert</translation>
    </message>
    <message>
        <source>values that one entry alone has</source>
        <translation>Werte, die nur ein Eintrag hat</translation>
    </message>
    <message>
        <source>a material that is milled needs a value above 0</source>
        <translation>ein Werkstoff, der zerspant wird, braucht einen Wert über 0</translation>
    </message>
    <message>
        <source>a material of your own; those that Burin is shipped with can&apos;t be deleted</source>
        <translation>ein eigener Werkstoff; mitgelieferte können nicht gelöscht werden</translation>
    </message>
    <message>
        <source>has to be a finite number</source>
        <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>has to be letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>muss aus Buchstaben, Ziffern, „-“, „_“ und „.“ bestehen</translation>
    </message>
    <message>
        <source>has to be there</source>
        <translation>muss vorhanden sein</translation>
    </message>
    <message>
        <source>has to be there, as the other half of Kienzle&apos;s law is</source>
        <translation>muss vorhanden sein, da die andere Hälfte des Kienzle-Gesetzes es ist</translation>
    </message>
    <message>
        <source>has to be there, or Kienzle&apos;s law: without it nothing is felt</source>
        <translation>muss vorhanden sein, oder das Kienzle-Gesetz: Ohne sie ist nichts zu spüren</translation>
    </message>
    <message>
        <source>has to be there: feeds and speeds come from it</source>
        <translation>muss vorhanden sein: Aus ihm kommen Vorschübe und Drehzahlen</translation>
    </message>
    <message>
        <source>is out of what can be milled</source>
        <translation>liegt außerhalb dessen, was zerspant werden kann</translation>
    </message>
    <message>
        <source>material has to be an id, null or a material</source>
        <translation>Werkstoff muss eine Kennung, null oder ein Werkstoff sein</translation>
    </message>
    <message>
        <source>has to have a value, or from and to that rise</source>
        <translation>muss einen Wert haben, oder from und to, die steigen</translation>
    </message>
    <message>
        <source>has to name a material</source>
        <translation>muss einen Werkstoff nennen</translation>
    </message>
    <message>
        <source>the same spacing along all axes</source>
        <translation>derselbe Abstand auf allen Achsen</translation>
    </message>
    <message>
        <source>three dimensions</source>
        <translation>drei Dimensionen</translation>
    </message>
    <message>
        <source>axes along +X, +Y and +Z</source>
        <translation>Achsen längs +X, +Y und +Z</translation>
    </message>
    <message>
        <source>raw or gzip</source>
        <translation>raw oder gzip</translation>
    </message>
    <message>
        <source>one file beside the header</source>
        <translation>eine Datei neben dem Kopf</translation>
    </message>
    <message>
        <source>data that begin at once</source>
        <translation>Daten, die sofort beginnen</translation>
    </message>
    <message>
        <source>little or big</source>
        <translation>little oder big</translation>
    </message>
    <message>
        <source>a known material, or one that a new material is like</source>
        <translation>ein bekannter Werkstoff, oder einer, dem ein neuer gleicht</translation>
    </message>
    <message>
        <source>FlatRadius was read as the radius of the flat: a corner radius of %1 mm.</source>
        <translation>FlatRadius wurde als Radius der Fläche gelesen: ein Eckenradius von %1 mm.</translation>
    </message>
    <message>
        <source>The bit has no length of the flutes: %1 mm of %2 were taken.</source>
        <translation>Das Bit hat keine Länge der Schneiden: %1 mm von %2 wurden genommen.</translation>
    </message>
    <message>
        <source>Stick-out, holder, number and limits are those of %1: enter your own.</source>
        <translation>Auskragung, Halter, Nummer und Grenzen sind die von %1: Geben Sie Ihre eigenen ein.</translation>
    </message>
    <message>
        <source>The bit has no number of flutes: %1 were taken.</source>
        <translation>Das Bit hat keine Zahl der Schneiden: %1 wurden genommen.</translation>
    </message>
    <message>
        <source>Length is the stick-out, as far as Burin knows the tool.</source>
        <translation>Length ist die Auskragung, so weit Burin das Werkzeug kennt.</translation>
    </message>
    <message>
        <source>Holder, number and limits have no place in a bit and were left out.</source>
        <translation>Halter, Nummer und Grenzen haben in einem Bit keinen Platz und wurden weggelassen.</translation>
    </message>
    <message>
        <source>Lengths are 0: measure them on the machine.</source>
        <translation>Die Längen sind 0: Messen Sie sie an der Maschine.</translation>
    </message>
    <message>
        <source>a number that no other tool has (%1 has it)</source>
        <translation>eine Nummer, die kein anderes Werkzeug hat (%1 hat sie)</translation>
    </message>
    <message>
        <source>is no number with a unit that is known: &quot;%1&quot;</source>
        <translation>ist keine Zahl mit einer bekannten Einheit: „%1“</translation>
    </message>
    <message>
        <source>has to be a count from 1 to 100</source>
        <translation>muss eine Anzahl von 1 bis 100 sein</translation>
    </message>
    <message>
        <source>has to have a letter or a digit</source>
        <translation>muss einen Buchstaben oder eine Ziffer haben</translation>
    </message>
    <message>
        <source>has to be there, above 0</source>
        <translation>muss da sein, über 0</translation>
    </message>
    <message>
        <source>has to be there, above 0 and below half the diameter</source>
        <translation>muss da sein, über 0 und unter dem halben Durchmesser</translation>
    </message>
    <message>
        <source>The bit has no TipAngle; 118° is used.</source>
        <translation>Das Bit hat keinen TipAngle; es gilt 118°.</translation>
    </message>
    <message>
        <source>1 to 1000: it is the pocket, too</source>
        <translation>1 bis 1000: sie ist auch der Magazinplatz</translation>
    </message>
    <message>
        <source>another library (%1)</source>
        <translation>eine andere Bibliothek (%1)</translation>
    </message>
    <message>
        <source>the archive can&apos;t be unpacked</source>
        <translation>das Archiv lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>a number that no other tool has</source>
        <translation>eine Nummer, die kein anderes Werkzeug hat</translation>
    </message>
    <message>
        <source>No tool number: T%1 is used.</source>
        <translation>Keine Werkzeugnummer: T%1 gilt.</translation>
    </message>
    <message>
        <source>No flute length: the one of %1 is used.</source>
        <translation>Keine Schneidenlänge: die von %1 gilt.</translation>
    </message>
    <message>
        <source>No length below the holder: the stick-out of %1 is used.</source>
        <translation>Keine Länge unter dem Halter: die Auskragung von %1 gilt.</translation>
    </message>
    <message>
        <source>The shaft has steps: its largest diameter is used for the whole shank.</source>
        <translation>Der Schaft ist gestuft: sein größter Durchmesser gilt für den ganzen Schaft.</translation>
    </message>
    <message>
        <source>No holder: the one of %1 is used.</source>
        <translation>Kein Halter: der von %1 gilt.</translation>
    </message>
    <message>
        <source>Limits and strength are those of %1: enter your own.</source>
        <translation>Grenzen und Festigkeit sind die von %1: Geben Sie Ihre eigenen ein.</translation>
    </message>
    <message>
        <source>Expressions were not imported, only the numbers.</source>
        <translation>Ausdrücke wurden nicht übernommen, nur die Zahlen.</translation>
    </message>
    <message>
        <source>%1: Burin does not support this shape.</source>
        <translation>%1: Diese Form unterstützt Burin nicht.</translation>
    </message>
    <message>
        <source>%1: Fusion does not support this shape.</source>
        <translation>%1: Diese Form unterstützt Fusion nicht.</translation>
    </message>
    <message>
        <source>%1: CAMotics does not support this shape.</source>
        <translation>%1: Diese Form unterstützt CAMotics nicht.</translation>
    </message>
    <message>
        <source>%1: the diameter is missing.</source>
        <translation>%1: Der Durchmesser fehlt.</translation>
    </message>
    <message>
        <source>%1: the tool bit was not found next to the library.</source>
        <translation>%1: Das Werkzeug wurde neben der Bibliothek nicht gefunden.</translation>
    </message>
    <message>
        <source>%1: CAMotics stores only the cone, not the cylinder above it.</source>
        <translation>%1: CAMotics speichert nur den Kegel, nicht den Zylinder darüber.</translation>
    </message>
    <message>
        <source>Limits, strength and sources of values can&apos;t be stored in this format.</source>
        <translation>Grenzen, Festigkeit und Quellen der Werte lassen sich in diesem Format nicht speichern.</translation>
    </message>
    <message>
        <source>Flutes, shank, holder and limits can&apos;t be stored in this format.</source>
        <translation>Schneidenzahl, Schaft, Halter und Grenzen lassen sich in diesem Format nicht speichern.</translation>
    </message>
    <message>
        <source>Number of flutes, stick-out, holder and limits are those of %1, and the shank is as wide as the cutter: enter your own.</source>
        <translation>Schneidenzahl, Auskragung, Halter und Grenzen sind die von %1, und der Schaft ist so breit wie die Schneide: Geben Sie Ihre eigenen Werte ein.</translation>
    </message>
    <message>
        <source>The table gives only number, diameter and name. Everything else is that of %1, and the shank is as wide as the cutter: enter your own.</source>
        <translation>Die Tabelle enthält nur Nummer, Durchmesser und Name. Alles andere ist das von %1, und der Schaft ist so breit wie die Schneide: Geben Sie Ihre eigenen Werte ein.</translation>
    </message>
    <message>
        <source>it has no stroke</source>
        <translation>sie hat keinen Zug</translation>
    </message>
    <message>
        <source>at most the cutter&apos;s radius, %1 mm</source>
        <translation>höchstens der Radius des Fräsers, %1 mm</translation>
    </message>
    <message>
        <source>below the top of what is to be taken away, %1 mm</source>
        <translation>unter der Oberkante dessen, was abgetragen wird, %1 mm</translation>
    </message>
    <message>
        <source>below the top, %1</source>
        <translation>unter der Oberkante, %1</translation>
    </message>
    <message>
        <source>a part to lay rows on; there is none</source>
        <translation>ein Teil, auf das Zeilen gelegt werden; es gibt keins</translation>
    </message>
    <message>
        <source>a part to go along; there is none</source>
        <translation>ein Teil, an dem es entlanggeht; es gibt keins</translation>
    </message>
    <message>
        <source>less than the rounding of the tool&apos;s end, %1 mm</source>
        <translation>weniger als die Rundung des Werkzeugendes, %1 mm</translation>
    </message>
    <message>
        <source>a tool with a rounded end; give a step-over for this one</source>
        <translation>ein Werkzeug mit gerundetem Ende; für dieses einen Zeilenabstand angeben</translation>
    </message>
    <message>
        <source>rings of 3 corners at least</source>
        <translation>Ringe aus mindestens 3 Ecken</translation>
    </message>
    <message>
        <source>places within 1e5 mm</source>
        <translation>Orte innerhalb von 1e5 mm</translation>
    </message>
    <message>
        <source>an area: there is no pocket without one</source>
        <translation>ein Bereich: ohne ihn gibt es keine Tasche</translation>
    </message>
    <message>
        <source>lines of 2 places at least</source>
        <translation>Linien aus mindestens 2 Orten</translation>
    </message>
    <message>
        <source>a line at least: a stroke or curves of a file</source>
        <translation>mindestens eine Linie: ein Zug oder Kurven einer Datei</translation>
    </message>
    <message>
        <source>it is a binary DXF; save it as ASCII</source>
        <translation>sie ist eine binäre DXF; als ASCII speichern</translation>
    </message>
    <message>
        <source>it is neither a DXF nor an SVG drawing</source>
        <translation>sie ist weder eine DXF- noch eine SVG-Zeichnung</translation>
    </message>
    <message>
        <source>there is no curve in it</source>
        <translation>sie enthält keine Kurve</translation>
    </message>
    <message>
        <source>it is larger than 64 MB</source>
        <translation>sie ist größer als 64 MB</translation>
    </message>
    <message>
        <source>a closed curve at least, as border of an area</source>
        <translation>mindestens eine geschlossene Kurve als Rand eines Bereichs</translation>
    </message>
    <message>
        <source>its curves</source>
        <translation>ihre Kurven</translation>
    </message>
    <message>
        <source>ends before its EOF</source>
        <translation>endet vor ihrem EOF</translation>
    </message>
    <message>
        <source>line %1: a group code was expected</source>
        <translation>Zeile %1: erwartet wurde ein Gruppencode</translation>
    </message>
    <message>
        <source>has a place farther than 1e5 mm from its origin</source>
        <translation>hat einen Ort weiter als 1e5 mm von ihrem Ursprung</translation>
    </message>
    <message>
        <source>has more than two million places</source>
        <translation>hat mehr als zwei Millionen Orte</translation>
    </message>
    <message>
        <source>has a point that is too far, or too many of them</source>
        <translation>hat einen Punkt, der zu weit weg liegt, oder zu viele</translation>
    </message>
    <message>
        <source>its viewBox can&apos;t be read</source>
        <translation>ihre viewBox ist nicht lesbar</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a transform that can&apos;t be read</source>
        <translation>Byte %1: &lt;%2&gt; hat eine transform, die nicht lesbar ist</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a length &quot;%3&quot; that can&apos;t be read</source>
        <translation>Byte %1: &lt;%2&gt; hat eine Länge „%3“, die nicht lesbar ist</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has points that can&apos;t be read</source>
        <translation>Byte %1: &lt;%2&gt; hat Punkte, die nicht lesbar sind</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a path that does not begin with M</source>
        <translation>Byte %1: &lt;%2&gt; hat einen Pfad, der nicht mit M beginnt</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a path with numbers behind Z</source>
        <translation>Byte %1: &lt;%2&gt; hat einen Pfad mit Zahlen hinter Z</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a path with wrong numbers behind %3</source>
        <translation>Byte %1: &lt;%2&gt; hat einen Pfad mit falschen Zahlen hinter %3</translation>
    </message>
    <message>
        <source>figures that do not lie in the XY plane are left out</source>
        <translation>Figuren, die nicht in der XY-Ebene liegen, sind ausgelassen</translation>
    </message>
    <message>
        <source>a mesh of polygons is left out</source>
        <translation>ein Netz aus Polygonen ist ausgelassen</translation>
    </message>
    <message>
        <source>a spline that states fit points alone is left out</source>
        <translation>ein Spline, der nur Stützpunkte nennt, ist ausgelassen</translation>
    </message>
    <message>
        <source>a spline with wrong knots or weights is left out</source>
        <translation>ein Spline mit falschen Knoten oder Gewichten ist ausgelassen</translation>
    </message>
    <message>
        <source>a block that the file does not define is left out</source>
        <translation>ein Block, den die Datei nicht definiert, ist ausgelassen</translation>
    </message>
    <message>
        <source>blocks within blocks deeper than 16 are left out</source>
        <translation>Blöcke in Blöcken, tiefer als 16, sind ausgelassen</translation>
    </message>
    <message>
        <source>more than 100,000 blocks are left out</source>
        <translation>mehr als 100.000 Blöcke sind ausgelassen</translation>
    </message>
    <message>
        <source>elements nested deeper than 100 are left out</source>
        <translation>Elemente, tiefer als 100 verschachtelt, sind ausgelassen</translation>
    </message>
    <message>
        <source>&lt;use&gt; of another file is left out</source>
        <translation>&lt;use&gt; einer anderen Datei ist ausgelassen</translation>
    </message>
    <message>
        <source>more than 10,000 &lt;use&gt; are left out</source>
        <translation>mehr als 10.000 &lt;use&gt; sind ausgelassen</translation>
    </message>
    <message>
        <source>&lt;use&gt; of something that is not there is left out</source>
        <translation>&lt;use&gt; von etwas, das es nicht gibt, ist ausgelassen</translation>
    </message>
    <message>
        <source>%1 is left out</source>
        <translation>%1 ist ausgelassen</translation>
    </message>
    <message>
        <source>%1 recordings and passes</source>
        <translation>%1 Aufnahmen und Durchgänge</translation>
    </message>
    <message>
        <source>another tool was loaded before it was computed</source>
        <translation>ein anderes Werkzeug wurde geladen, bevor er berechnet war</translation>
    </message>
    <message>
        <source>fixtures or keep-out volumes are in the way: move them</source>
        <translation>Spannmittel oder Sperrräume sind im Weg: versetzen</translation>
    </message>
    <message>
        <source>too much stock is in the way of the tool: rough it first, or use a longer tool</source>
        <translation>zu viel Rohteil ist dem Werkzeug im Weg: zuerst schruppen, oder ein längeres Werkzeug verwenden</translation>
    </message>
    <message>
        <source>no stock is left there</source>
        <translation>dort ist kein Rohteil übrig</translation>
    </message>
    <message>
        <source>a part with edges to follow; there is none</source>
        <translation>ein Teil mit Kanten, denen zu folgen ist; es gibt keines</translation>
    </message>
    <message>
        <source>the part has no concave edge for this tool there</source>
        <translation>das Teil hat dort keine konkave Kante für dieses Werkzeug</translation>
    </message>
    <message>
        <source>a point on the part, within 1 mm</source>
        <translation>ein Punkt auf dem Teil, auf 1 mm genau</translation>
    </message>
    <message>
        <source>a face that is visible from above</source>
        <translation>eine Fläche, die von oben sichtbar ist</translation>
    </message>
    <message>
        <source>its beginning</source>
        <translation>sein Anfang</translation>
    </message>
    <message>
        <source>the part has no upright hole there that fits this drill and is not drilled yet</source>
        <translation>das Teil hat dort keine senkrechte Bohrung, die zu diesem Bohrer passt und noch nicht gebohrt ist</translation>
    </message>
    <message>
        <source>a round upright hole of the part, or a depth</source>
        <translation>eine runde senkrechte Bohrung des Teils oder eine Tiefe</translation>
    </message>
    <message>
        <source>a drill of at most %1 mm for that hole</source>
        <translation>ein Bohrer von höchstens %1 mm für diese Bohrung</translation>
    </message>
    <message>
        <source>the part is in the way of the drill, or the drill is too short</source>
        <translation>das Teil ist dem Bohrer im Weg, oder der Bohrer ist zu kurz</translation>
    </message>
    <message>
        <source>it has no move at feed</source>
        <translation>es hat keine Bewegung im Vorschub</translation>
    </message>
    <message>
        <source>a path has one work offset, and the program uses another one from here on</source>
        <translation>eine Bahn hat eine Nullpunktverschiebung, und das Programm verwendet ab hier eine andere</translation>
    </message>
    <message>
        <source>a record that Burin can&apos;t follow: %1</source>
        <translation>ein Satz, dem Burin nicht folgen kann: %1</translation>
    </message>
    <message>
        <source>a tool axis other than +Z</source>
        <translation>eine andere Werkzeugachse als +Z</translation>
    </message>
    <message>
        <source>numbers are missing</source>
        <translation>es fehlen Zahlen</translation>
    </message>
    <message>
        <source>a step from a position that is not stated</source>
        <translation>ein Schritt von einer Position, die nicht angegeben ist</translation>
    </message>
    <message>
        <source>a move without a feed</source>
        <translation>eine Bewegung ohne Vorschub</translation>
    </message>
    <message>
        <source>an arc from a position that is not stated</source>
        <translation>ein Bogen von einer Position, die nicht angegeben ist</translation>
    </message>
    <message>
        <source>an arc whose ends do not lie on its circle</source>
        <translation>ein Bogen, dessen Enden nicht auf seinem Kreis liegen</translation>
    </message>
    <message>
        <source>an arc about an axis other than Z</source>
        <translation>ein Bogen um eine andere Achse als Z</translation>
    </message>
    <message>
        <source>a feed by inverse time</source>
        <translation>ein zeitreziproker Vorschub</translation>
    </message>
    <message>
        <source>a feed that is not above 0</source>
        <translation>ein Vorschub, der nicht größer als 0 ist</translation>
    </message>
    <message>
        <source>a spindle speed as surface speed</source>
        <translation>eine Drehzahl als Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>a spindle speed below 0</source>
        <translation>eine Drehzahl unter 0</translation>
    </message>
    <message>
        <source>a unit other than MM and INCHES</source>
        <translation>eine andere Einheit als MM und INCHES</translation>
    </message>
    <message>
        <source>a tool number that is not whole</source>
        <translation>eine Werkzeugnummer, die nicht ganzzahlig ist</translation>
    </message>
    <message>
        <source>a finite feed and speed</source>
        <translation>endlicher Vorschub und endliche Drehzahl</translation>
    </message>
    <message>
        <source>a feed beyond 1e9 mm/min</source>
        <translation>ein Vorschub von mehr als 1e9 mm/min</translation>
    </message>
    <message>
        <source>a position more than 1e6 mm away</source>
        <translation>eine Position, die mehr als 1e6 mm entfernt ist</translation>
    </message>
    <message>
        <source>another take than the one that is scored</source>
        <translation>eine andere Aufnahme als die, die bewertet wird</translation>
    </message>
    <message>
        <source>another take of the setup of take %1</source>
        <translation>eine andere Aufnahme der Aufspannung von Aufnahme %1</translation>
    </message>
    <message>
        <source>a take made with %1 that path %2 does not have</source>
        <translation>eine Aufnahme mit %1, die Bahn %2 nicht hat</translation>
    </message>
    <message>
        <source>one of several sources of path %1</source>
        <translation>eine von mehreren Quellen von Bahn %1</translation>
    </message>
    <message>
        <source>each take once</source>
        <translation>jede Aufnahme einmal</translation>
    </message>
    <message>
        <source>set-feed, then section</source>
        <translation>set-feed, dann section</translation>
    </message>
    <message>
        <source>at most %1 1/min, the limit of the tool %2</source>
        <translation>höchstens %1 1/min, die Grenze des Werkzeugs %2</translation>
    </message>
    <message>
        <source>a tool that turns</source>
        <translation>ein Werkzeug, das sich dreht</translation>
    </message>
    <message>
        <source>no feeds, and links at the safe height without ramps: the tool doesn&apos;t turn</source>
        <translation>keine Vorschübe, und Verbindungen auf Sicherheitshöhe ohne Rampen: das Werkzeug dreht sich nicht</translation>
    </message>
    <message>
        <source>profile: the tool doesn&apos;t turn</source>
        <translation>profile: das Werkzeug dreht sich nicht</translation>
    </message>
    <message>
        <source>%1 to %2 triangles</source>
        <translation>%1 bis %2 Dreiecke</translation>
    </message>
    <message>
        <source>triangles of the vertices that are there</source>
        <translation>Dreiecke aus den vorhandenen Eckpunkten</translation>
    </message>
    <message>
        <source>the height of the model of the shank</source>
        <translation>die Höhe des Modells des Schafts</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot; was left out: no material can be called &quot;%2&quot;.</source>
        <translation>Die Vorgabe „%1“ wurde weggelassen: Kein Werkstoff kann „%2“ heißen.</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot; is for &quot;%2&quot;, a material that Burin does not have: choose its material.</source>
        <translation>Die Vorgabe „%1“ gilt für „%2“, einen Werkstoff, den Burin nicht hat: Wählen Sie ihren Werkstoff.</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot;: the step-down of %2 mm was left out, as the tool allows %3 mm.</source>
        <translation>Vorgabe „%1“: Die Zustellung von %2 mm wurde weggelassen, da das Werkzeug %3 mm zulässt.</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot;: the step-over of %2 mm was left out, as the tool allows %3 mm.</source>
        <translation>Vorgabe „%1“: Der Zeilenabstand von %2 mm wurde weggelassen, da das Werkzeug %3 mm zulässt.</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot; was left out: %2 has to be %3.</source>
        <translation>Die Vorgabe „%1“ wurde weggelassen: „%2“ muss sein: %3.</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot; is for one operation (%2): Burin uses it for all passes.</source>
        <translation>Die Vorgabe „%1“ gilt für eine Operation (%2): Burin verwendet sie für alle Durchgänge.</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot;: its remarks were not imported.</source>
        <translation>Vorgabe „%1“: Ihre Bemerkungen wurden nicht importiert.</translation>
    </message>
    <message>
        <source>Coolant &quot;%1&quot; of a preset was not imported.</source>
        <translation>Das Kühlmittel „%1“ einer Vorgabe wurde nicht importiert.</translation>
    </message>
    <message>
        <source>Feeds of presets for ramps, leads and transitions were not imported.</source>
        <translation>Vorschübe von Vorgaben für Rampen, An- und Abfahrten und Übergänge wurden nicht importiert.</translation>
    </message>
    <message>
        <source>Presets of feeds and speeds can&apos;t be stored in this format.</source>
        <translation>Vorgaben von Schnittwerten können in diesem Format nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>%1: FreeCAD does not support this shape.</source>
        <translation>%1: FreeCAD kennt diese Form nicht.</translation>
    </message>
    <message>
        <source>The bits are in the folder Bit next to the library. FreeCAD finds them if the library itself is in a folder Library next to that folder.</source>
        <translation>Die Werkzeuge sind im Ordner Bit neben der Bibliothek. FreeCAD findet sie, wenn die Bibliothek selbst in einem Ordner Library neben diesem Ordner liegt.</translation>
    </message>
    <message>
        <source>one; several go into *.fctl, *.tbl, *.tools or *.ctbl</source>
        <translation>eines; mehrere kommen in *.fctl, *.tbl, *.tools oder *.ctbl</translation>
    </message>
    <message>
        <source>*.fctl, *.fctb, *.tbl, *.tools, *.ctbl or *.json</source>
        <translation>*.fctl, *.fctb, *.tbl, *.tools, *.ctbl oder *.json</translation>
    </message>
    <message>
        <source>a short line of text other than all, starter and mine, without spaces around it</source>
        <translation>eine kurze Zeile Text außer all, starter und mine, ohne Leerzeichen am Rand</translation>
    </message>
    <message>
        <source>mine, or a library of your own</source>
        <translation>mine oder eine eigene Bibliothek</translation>
    </message>
    <message>
        <source>a name that no library has yet</source>
        <translation>ein Name, den noch keine Bibliothek hat</translation>
    </message>
    <message>
        <source>at most maximum_depth_of_cut_mm (%1)</source>
        <translation>höchstens maximum_depth_of_cut_mm (%1)</translation>
    </message>
    <message>
        <source>at most half of diameter_mm (%1)</source>
        <translation>höchstens die Hälfte von diameter_mm (%1)</translation>
    </message>
    <message>
        <source>one line of text that is not empty</source>
        <translation>eine Zeile Text, die nicht leer ist</translation>
    </message>
    <message>
        <source>a name that no other preset of the tool has</source>
        <translation>ein Name, den keine andere Vorgabe des Werkzeugs hat</translation>
    </message>
    <message>
        <source>take %1, tick %2</source>
        <translation>Aufnahme %1, Takt %2</translation>
    </message>
    <message>
        <source>pass %1, tick %2</source>
        <translation>Durchgang %1, Takt %2</translation>
    </message>
    <message>
        <source>the part has no upright hole of the thread&apos;s major diameter there</source>
        <translation>das Teil hat dort keine senkrechte Bohrung mit dem Nenndurchmesser des Gewindes</translation>
    </message>
    <message>
        <source>a round upright hole of the part</source>
        <translation>eine runde senkrechte Bohrung des Teils</translation>
    </message>
    <message>
        <source>a model whose facets are at most %1 mm inside of that hole&apos;s circle</source>
        <translation>ein Modell, dessen Facetten höchstens %1 mm innerhalb des Kreises dieser Bohrung liegen</translation>
    </message>
    <message>
        <source>a thread mill of at most %1 mm for that hole</source>
        <translation>ein Gewindefräser von höchstens %1 mm für diese Bohrung</translation>
    </message>
    <message>
        <source>a thread mill with one tooth for a pitch of %1 mm</source>
        <translation>ein Gewindefräser mit einem Zahn für die Steigung %1 mm</translation>
    </message>
    <message>
        <source>a thread mill with a neck of at most %1 mm</source>
        <translation>ein Gewindefräser mit einem Hals von höchstens %1 mm</translation>
    </message>
    <message>
        <source>a thread mill</source>
        <translation>ein Gewindefräser</translation>
    </message>
    <message>
        <source>a drill</source>
        <translation>ein Bohrer</translation>
    </message>
    <message>
        <source>0 for a thread</source>
        <translation>0 bei einem Gewinde</translation>
    </message>
    <message>
        <source>below half of the diameter</source>
        <translation>unter dem halben Durchmesser</translation>
    </message>
    <message>
        <source>a value for each parameter</source>
        <translation>ein Wert für jeden Parameter</translation>
    </message>
    <message>
        <source>a finite angle</source>
        <translation>ein endlicher Winkel</translation>
    </message>
    <message>
        <source>a length of %1 to %2 mm</source>
        <translation>eine Länge von %1 bis %2 mm</translation>
    </message>
    <message>
        <source>a device with axes to assign</source>
        <translation>ein Gerät, dessen Achsen sich belegen lassen</translation>
    </message>
    <message>
        <source>low end, rest and high end in ascending order, from -4 to 4</source>
        <translation>unteres Ende, Ruhe und oberes Ende in aufsteigender Reihenfolge, von -4 bis 4</translation>
    </message>
    <message>
        <source>the holes are not drilled as deep as the thread: drill them first, with the full diameter down to Z %1 mm in the coordinates of the setup</source>
        <translation>die Bohrungen sind nicht so tief vorgebohrt wie das Gewinde: Bohren Sie sie zuerst, mit vollem Durchmesser bis Z %1 mm in den Koordinaten der Aufspannung</translation>
    </message>
    <message>
        <source>above %1 and at most %2 mm for the hole at %3, %4</source>
        <translation>über %1 und höchstens %2 mm für die Bohrung bei %3, %4</translation>
    </message>
    <message>
        <source>inside the profile: make the tool from its models again</source>
        <translation>innerhalb des Profils: Erzeugen Sie das Werkzeug noch einmal aus seinen Modellen</translation>
    </message>
    <message>
        <source>inside the shank: make the tool from its models again</source>
        <translation>innerhalb des Schafts: Erzeugen Sie das Werkzeug noch einmal aus seinen Modellen</translation>
    </message>
    <message>
        <source>required without chip_load_mm, not allowed with it</source>
        <translation>nötig ohne chip_load_mm, nicht erlaubt mit chip_load_mm</translation>
    </message>
    <message>
        <source>%1 mm or more for the other sizes of this fixture</source>
        <translation>%1 mm oder mehr bei den übrigen Maßen dieser Vorrichtung</translation>
    </message>
    <message>
        <source>a moment that is still in the path</source>
        <translation>ein Zeitpunkt, den die Bahn noch hat</translation>
    </message>
    <message>
        <source>a hole modelled with the major diameter, %1 mm, not with %2 mm</source>
        <translation>eine Bohrung, die mit dem Nenndurchmesser %1 mm modelliert ist, nicht mit %2 mm</translation>
    </message>
    <message>
        <source>at least one button that mills</source>
        <translation>mindestens eine Taste, die fräst</translation>
    </message>
    <message>
        <source>Step-down, step-over and coolant of presets can&apos;t be stored in a FreeCAD tool bit.</source>
        <translation>Zustellung, Zeilenabstand und Kühlmittel von Vorgaben können in einem FreeCAD-Werkzeug nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Holders and limits can&apos;t be stored in a FreeCAD library and were left out.</source>
        <translation>Halter und Grenzen können in einer FreeCAD-Bibliothek nicht gespeichert werden und wurden weggelassen.</translation>
    </message>
    <message>
        <source>profile: the tip is hollow</source>
        <translation>profile: die Spitze ist hohl</translation>
    </message>
    <message>
        <source>a tool without a hollow</source>
        <translation>ein Werkzeug ohne Höhlung</translation>
    </message>
    <message>
        <source>3 corners or more in each ring</source>
        <translation>mindestens 3 Ecken in jedem Ring</translation>
    </message>
    <message>
        <source>at most %1 corners</source>
        <translation>höchstens %1 Ecken</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>eine Fläche</translation>
    </message>
    <message>
        <source>has to hold a ring at least</source>
        <translation>muss mindestens einen Ring enthalten</translation>
    </message>
    <message>
        <source>another one during a recording</source>
        <translation>eine andere während einer Aufnahme</translation>
    </message>
    <message>
        <source>a tip from which the tool is clear of the stock</source>
        <translation>eine Spitze, bei der das Werkzeug frei vom Rohteil ist</translation>
    </message>
    <message>
        <source>a tip from which the tool meets the stock in this direction</source>
        <translation>eine Spitze, von der aus das Werkzeug in dieser Richtung auf das Rohteil trifft</translation>
    </message>
    <message>
        <source>strokes of the hand have finished the part there</source>
        <translation>Züge der Hand haben das Teil dort fertig bearbeitet</translation>
    </message>
    <message>
        <source>a stroke of the hand before it in its path that has finished the part</source>
        <translation>ein Zug der Hand davor in seiner Bahn, der das Teil fertig bearbeitet hat</translation>
    </message>
    <message>
        <source>ignore: only passes on the surface of the part heed strokes of the hand</source>
        <translation>ignore: Nur Durchgänge auf der Oberfläche des Teils beachten Züge der Hand</translation>
    </message>
    <message>
        <source>ignore, keep-off or blend; only flow extends strokes of the hand</source>
        <translation>ignore, keep-off oder blend; nur flow setzt Züge der Hand fort</translation>
    </message>
    <message>
        <source>no lines to follow: the rows follow the strokes of the path</source>
        <translation>keine Linien, denen zu folgen ist: Die Zeilen folgen den Zügen der Bahn</translation>
    </message>
    <message>
        <source>keep-off, blend or extend</source>
        <translation>keep-off, blend oder extend</translation>
    </message>
    <message>
        <source>at most %1, the number of lines</source>
        <translation>höchstens %1, die Anzahl der Linien</translation>
    </message>
    <message>
        <source>a stroke is undone or redone there that the trace does not contain</source>
        <translation>dort wird ein Zug rückgängig gemacht oder wiederhergestellt, den die Spur nicht enthält</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>Messwert %1</translation>
    </message>
    <message>
        <source>one that the session has</source>
        <translation>eine, die die Sitzung hat</translation>
    </message>
    <message>
        <source>a workpiece with material</source>
        <translation>ein Werkstück mit Material</translation>
    </message>
    <message>
        <source>the disk could not keep up</source>
        <translation>der Datenträger kam nicht nach</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>one that was recorded with the fixtures, keep-out volumes and machine of this project</source>
        <translation>eine, die mit den Vorrichtungen, Sperrräumen und der Maschine dieses Projekts aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>a stock with a surface</source>
        <translation>ein Rohteil mit einer Oberfläche</translation>
    </message>
    <message>
        <source>a rotation by a multiple of 90 degrees: the edges of a box stay parallel to the axes</source>
        <translation>eine Drehung um ein Vielfaches von 90 Grad: Die Kanten eines Quaders bleiben parallel zu den Achsen</translation>
    </message>
    <message>
        <source>a rotation about Z: the fixture stands upright</source>
        <translation>eine Drehung um Z: Die Vorrichtung steht aufrecht</translation>
    </message>
    <message>
        <source>the studs are milled to %1 mm, too narrow for the thread&apos;s major diameter, %2 mm</source>
        <translation>die Zapfen sind auf %1 mm gefräst, zu schmal für den Nenndurchmesser des Gewindes, %2 mm</translation>
    </message>
    <message>
        <source>the stock around the studs is in the way: mill it to the thread&apos;s major diameter first, %1 mm, down to Z %2 mm in the coordinates of the setup</source>
        <translation>das Material um die Zapfen ist im Weg: Fräsen Sie es zuerst auf den Nenndurchmesser des Gewindes, %1 mm, bis Z %2 mm in den Koordinaten der Aufspannung</translation>
    </message>
    <message>
        <source>the part is in the way of the tool around its studs, or it is too short</source>
        <translation>das Teil ist dem Werkzeug um seine Zapfen im Weg, oder das Werkzeug ist zu kurz</translation>
    </message>
    <message>
        <source>the part has no upright stud of the thread&apos;s minor diameter there</source>
        <translation>das Teil hat dort keinen senkrechten Zapfen mit dem Kerndurchmesser des Gewindes</translation>
    </message>
    <message>
        <source>a round upright stud of the part</source>
        <translation>ein runder senkrechter Zapfen des Teils</translation>
    </message>
    <message>
        <source>a stud modelled with the minor diameter that this mill cuts, %1 mm, not with %2 mm</source>
        <translation>ein Zapfen, der mit dem Kerndurchmesser modelliert ist, den dieser Fräser schneidet, %1 mm, nicht mit %2 mm</translation>
    </message>
    <message>
        <source>above %1 and at most %2 mm for the stud at %3, %4</source>
        <translation>über %1 und höchstens %2 mm für den Zapfen bei %3, %4</translation>
    </message>
    <message>
        <source>above 0, or the holes or studs of the thread</source>
        <translation>über 0, oder die Bohrungen oder Zapfen des Gewindes</translation>
    </message>
    <message>
        <source>has to be above low_deg</source>
        <translation>muss über low_deg liegen</translation>
    </message>
    <message>
        <source>has to leave 0 within the limits</source>
        <translation>muss 0 innerhalb der Grenzen lassen</translation>
    </message>
    <message>
        <source>has to be A or B, or two different axes of which A or B is the second</source>
        <translation>muss A oder B sein oder zwei verschiedene Achsen, deren zweite A oder B ist</translation>
    </message>
    <message>
        <source>has to be synchronised or tip with rotary_axes</source>
        <translation>muss mit rotary_axes synchronised oder tip sein</translation>
    </message>
    <message>
        <source>link, then tool-axis</source>
        <translation>link, dann tool-axis</translation>
    </message>
    <message>
        <source>a machine with rotary axes</source>
        <translation>eine Maschine mit Drehachsen</translation>
    </message>
    <message>
        <source>programs of X, Y and Z</source>
        <translation>Programme mit X, Y und Z</translation>
    </message>
    <message>
        <source>tools that turn and are not hollow, unlike %1</source>
        <translation>Werkzeuge, die sich drehen und nicht hohl sind, anders als %1</translation>
    </message>
    <message>
        <source>moves of a ball end mill, or upright ones</source>
        <translation>Bewegungen eines Kugelfräsers oder senkrechte</translation>
    </message>
    <message>
        <source>a path of a program that tilts the tool</source>
        <translation>eine Bahn aus einem Programm, das das Werkzeug neigt</translation>
    </message>
    <message>
        <source>a part of the path that is no farther than 2 mm from the part</source>
        <translation>ein Teil der Bahn, der höchstens 2 mm vom Werkstück entfernt ist</translation>
    </message>
    <message>
        <source>the tool comes %1 too near to the part at %2</source>
        <translation>das Werkzeug kommt dem Werkstück bei %2 um %1 zu nahe</translation>
    </message>
    <message>
        <source>the tool comes %1 too near to a fixture at %2</source>
        <translation>das Werkzeug kommt einer Vorrichtung bei %2 um %1 zu nahe</translation>
    </message>
    <message>
        <source>a tool axis that the machine can&apos;t reach</source>
        <translation>eine Werkzeugachse, die die Maschine nicht erreicht</translation>
    </message>
    <message>
        <source>a tool axis that is not of unit length</source>
        <translation>eine Werkzeugachse, die nicht die Länge eins hat</translation>
    </message>
    <message>
        <source>a tilted tool axis; paths tilt ball end mills only</source>
        <translation>eine geneigte Werkzeugachse; Bahnen neigen nur Kugelfräser</translation>
    </message>
</context>
<context>
    <name>Device</name>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>simulated: no force is felt; values of a 3D Systems Touch (CHAI3D device table) scale the force that is shown</source>
        <translation>simuliert: keine Kraft ist zu spüren; die angezeigte Kraft folgt den Kennwerten eines 3D Systems Touch (Gerätetabelle von CHAI3D)</translation>
    </message>
    <message>
        <source>The cap sets the speed</source>
        <translation>Die Kappe gibt das Tempo vor</translation>
    </message>
    <message>
        <source>The cap sets the position</source>
        <translation>Die Kappe gibt die Position vor</translation>
    </message>
    <message>
        <source>CHAI3D 3.3, table of devices</source>
        <translation>CHAI3D 3.3, Gerätetabelle</translation>
    </message>
    <message>
        <source>the device itself</source>
        <translation>das Gerät selbst</translation>
    </message>
    <message>
        <source>CHAI3D 3.3, table of devices: Premium 6DOF</source>
        <translation>CHAI3D 3.3, Gerätetabelle: Premium 6DOF</translation>
    </message>
    <message>
        <source>Haply&apos;s tutorial</source>
        <translation>Haplys Anleitung</translation>
    </message>
    <message>
        <source>one message of the service</source>
        <translation>eine Nachricht des Dienstes</translation>
    </message>
    <message>
        <source>Calibrated devices only</source>
        <translation>Nur wenn kalibriert</translation>
    </message>
    <message>
        <source>Self-calibrating: the device moves by itself</source>
        <translation>Selbstkalibrierend: das Gerät bewegt sich von selbst</translation>
    </message>
    <message>
        <source>conservative estimate</source>
        <translation>vorsichtige Schätzung</translation>
    </message>
    <message>
        <source>set by Burin</source>
        <translation>von Burin vorgegeben</translation>
    </message>
    <message>
        <source>right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>towards the user</source>
        <translation>zum Benutzer hin</translation>
    </message>
    <message>
        <source>down</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>tilt back and forth</source>
        <translation>Kippen vor und zurück</translation>
    </message>
    <message>
        <source>tilt sideways</source>
        <translation>Kippen zur Seite</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>RX</source>
        <translation>RX</translation>
    </message>
    <message>
        <source>RY</source>
        <translation>RY</translation>
    </message>
    <message>
        <source>RZ</source>
        <translation>RZ</translation>
    </message>
    <message>
        <source>hat X</source>
        <translation>Kreuz X</translation>
    </message>
    <message>
        <source>hat Y</source>
        <translation>Kreuz Y</translation>
    </message>
    <message>
        <source>throttle</source>
        <translation>Schubregler</translation>
    </message>
    <message>
        <source>rudder</source>
        <translation>Seitenruder</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Lenkrad</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>position to the right</source>
        <translation>Position nach rechts</translation>
    </message>
    <message>
        <source>position away from the user</source>
        <translation>Position vom Benutzer weg</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>tilt to the right</source>
        <translation>Neigung nach rechts</translation>
    </message>
    <message>
        <source>tilt away from the user</source>
        <translation>Neigung vom Benutzer weg</translation>
    </message>
    <message>
        <source>brake</source>
        <translation>Bremse</translation>
    </message>
</context>
<context>
    <name>DeviceLabels</name>
    <message>
        <source>Position: X %1, Y %2, Z %3 mm</source>
        <translation>Position: X %1, Y %2, Z %3 mm</translation>
    </message>
    <message>
        <source>Buttons pressed: %1</source>
        <translation>Gedrückte Tasten: %1</translation>
    </message>
    <message>
        <source>Battery: %1 %</source>
        <translation>Akku: %1 %</translation>
    </message>
    <message>
        <source>Rate: %1 Hz; interval: median %2 ms, maximum %3 ms</source>
        <translation>Takt: %1 Hz; Abstand: Median %2 ms, höchstens %3 ms</translation>
    </message>
    <message>
        <source>Maximum force commanded: %1 N</source>
        <translation>Größte ausgegebene Kraft: %1 N</translation>
    </message>
    <message>
        <source>Motor temperature: %1 % of the limit</source>
        <translation>Motortemperatur: %1 % der Grenze</translation>
    </message>
    <message>
        <source>Invalid readings: %1</source>
        <translation>Ungültige Messwerte: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>maximum force</source>
        <translation>größte Kraft</translation>
    </message>
    <message>
        <source>continuous force</source>
        <translation>Dauerkraft</translation>
    </message>
    <message>
        <source>maximum torque</source>
        <translation>größtes Drehmoment</translation>
    </message>
    <message>
        <source>maximum stiffness</source>
        <translation>größte Steifigkeit</translation>
    </message>
    <message>
        <source>maximum damping</source>
        <translation>größte Dämpfung</translation>
    </message>
    <message>
        <source>maximum rotational stiffness</source>
        <translation>größte Drehsteifigkeit</translation>
    </message>
    <message>
        <source>workspace radius</source>
        <translation>Radius des Arbeitsraums</translation>
    </message>
    <message>
        <source>position step</source>
        <translation>Positionsauflösung</translation>
    </message>
    <message>
        <source>rotation step</source>
        <translation>Winkelauflösung</translation>
    </message>
    <message>
        <source>maximum speed</source>
        <translation>größte Geschwindigkeit</translation>
    </message>
    <message>
        <source>mass of the handle</source>
        <translation>Masse des Griffs</translation>
    </message>
    <message>
        <source>axes: %1 sensed, %2 driven; buttons: %3</source>
        <translation>Achsen: %1 erfasst, %2 angetrieben; Tasten: %3</translation>
    </message>
    <message>
        <source>Motion: %1 × %2 × %3 mm; smallest step %4 mm</source>
        <translation>Bewegung: %1 × %2 × %3 mm; kleinster Schritt %4 mm</translation>
    </message>
    <message>
        <source>Rotation: %1°</source>
        <translation>Drehung: %1°</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>X, right</source>
        <translation>X, nach rechts</translation>
    </message>
    <message>
        <source>Y, away</source>
        <translation>Y, vom Benutzer weg</translation>
    </message>
    <message>
        <source>Z, up</source>
        <translation>Z, nach oben</translation>
    </message>
    <message>
        <source>A, about X</source>
        <translation>A, um X</translation>
    </message>
    <message>
        <source>B, about Y</source>
        <translation>B, um Y</translation>
    </message>
    <message>
        <source>C, about Z</source>
        <translation>C, um Z</translation>
    </message>
    <message>
        <source>mill</source>
        <translation>fräsen</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>abheben</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>rückgängig</translation>
    </message>
    <message>
        <source>redo</source>
        <translation>wiederherstellen</translation>
    </message>
    <message>
        <source>clutch</source>
        <translation>auskuppeln</translation>
    </message>
    <message>
        <source>recentre</source>
        <translation>zentrieren</translation>
    </message>
    <message>
        <source>level above</source>
        <translation>Ebene darüber</translation>
    </message>
    <message>
        <source>level below</source>
        <translation>Ebene darunter</translation>
    </message>
    <message>
        <source>nearest edge</source>
        <translation>nächste Kante</translation>
    </message>
    <message>
        <source>fit the view</source>
        <translation>alles zeigen</translation>
    </message>
    <message>
        <source>button %1: %2</source>
        <translation>Taste %1: %2</translation>
    </message>
    <message>
        <source>%1: %2, reversed; gain %3; dead zone %4 %; range %5 to %7 %, rest %6 %</source>
        <translation>%1: %2, umgekehrt; Verstärkung %3; Totzone %4 %; Bereich %5 bis %7 %, Ruhe %6 %</translation>
    </message>
    <message>
        <source>%1: %2; gain %3; dead zone %4 %; range %5 to %7 %, rest %6 %</source>
        <translation>%1: %2; Verstärkung %3; Totzone %4 %; Bereich %5 bis %7 %, Ruhe %6 %</translation>
    </message>
    <message>
        <source>assist: vibrates</source>
        <translation>Unterstützung: vibriert</translation>
    </message>
    <message>
        <source>assist: pushes 1 axis of its stick, too weakly to hold the hand</source>
        <translation>Unterstützung: drückt 1 Achse seines Hebels, zu schwach, um die Hand zu halten</translation>
    </message>
    <message>
        <source>assist: pushes %1 axes of its stick, too weakly to hold the hand</source>
        <translation>Unterstützung: drückt %1 Achsen seines Hebels, zu schwach, um die Hand zu halten</translation>
    </message>
    <message>
        <source>assist: off, as you have no permission to write to the device; install Burin&apos;s udev rule and plug it in again</source>
        <translation>Unterstützung: aus, weil Sie nicht auf das Gerät schreiben dürfen; richten Sie Burins udev-Regel ein und schließen Sie es neu an</translation>
    </message>
    <message>
        <source>Maximum strength commanded: %1 %</source>
        <translation>Größte ausgegebene Stärke: %1 %</translation>
    </message>
    <message>
        <source>99 of 100 intervals are shorter than %1 ms</source>
        <translation>99 von 100 Abständen sind kürzer als %1 ms</translation>
    </message>
    <message>
        <source>Latency from reading to force: at most %1 ms</source>
        <translation>Verzögerung vom Messwert zur Kraft: höchstens %1 ms</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by %2 ms between readings</source>
        <translation>Vorgeschlagene Steifigkeit: %1 N/mm, begrenzt durch %2 ms zwischen den Messwerten</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by readings up to %2 ms late</source>
        <translation>Vorgeschlagene Steifigkeit: %1 N/mm, begrenzt durch Messwerte, die bis zu %2 ms zu spät kommen</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by %2 ms latency</source>
        <translation>Vorgeschlagene Steifigkeit: %1 N/mm, begrenzt durch %2 ms Verzögerung</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by steps of %2 mm at %3 N of friction</source>
        <translation>Vorgeschlagene Steifigkeit: %1 N/mm, begrenzt durch Schritte von %2 mm bei %3 N Reibung</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by your own maximum</source>
        <translation>Vorgeschlagene Steifigkeit: %1 N/mm, begrenzt durch Ihren eigenen Höchstwert</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by the device itself</source>
        <translation>Vorgeschlagene Steifigkeit: %1 N/mm, begrenzt durch das Gerät selbst</translation>
    </message>
    <message>
        <source>Suggested damping: %1 N·s/m</source>
        <translation>Vorgeschlagene Dämpfung: %1 N·s/m</translation>
    </message>
    <message>
        <source>Safety margin: %1 % below what is stable for a handle that nobody holds</source>
        <translation>Sicherheitsabstand: %1 % unter dem, was bei einem Griff stabil ist, den niemand hält</translation>
    </message>
    <message>
        <source>Latency: %1 ms, as the device states; not measured</source>
        <translation>Verzögerung: %1 ms, wie das Gerät angibt; nicht gemessen</translation>
    </message>
    <message>
        <source>Latency: unknown, as the device neither states nor reports it</source>
        <translation>Verzögerung: unbekannt, da das Gerät sie weder angibt noch meldet</translation>
    </message>
    <message>
        <source>In use: stiffness up to %1 N/mm, damping up to %2 N·s/m</source>
        <translation>In Gebrauch: Steifigkeit bis %1 N/mm, Dämpfung bis %2 N·s/m</translation>
    </message>
    <message>
        <source>In use: stiffness up to %1 N/mm, damping of the device</source>
        <translation>In Gebrauch: Steifigkeit bis %1 N/mm, Dämpfung des Geräts</translation>
    </message>
    <message>
        <source>In use: stiffness and damping of the device</source>
        <translation>In Gebrauch: Steifigkeit und Dämpfung des Geräts</translation>
    </message>
</context>
<context>
    <name>DeviceReason</name>
    <message>
        <source>it is not plugged in</source>
        <translation>es ist nicht angeschlossen</translation>
    </message>
    <message>
        <source>it sends nothing</source>
        <translation>es sendet nichts</translation>
    </message>
    <message>
        <source>it is not calibrated yet</source>
        <translation>es ist noch nicht kalibriert</translation>
    </message>
    <message>
        <source>its motors are too hot</source>
        <translation>seine Motoren sind zu heiß</translation>
    </message>
    <message>
        <source>its motors were overloaded</source>
        <translation>seine Motoren waren überlastet</translation>
    </message>
    <message>
        <source>it moved too fast</source>
        <translation>es hat sich zu schnell bewegt</translation>
    </message>
    <message>
        <source>its stop button is pressed</source>
        <translation>sein Halteknopf ist gedrückt</translation>
    </message>
    <message>
        <source>a sensor or a drive failed</source>
        <translation>ein Sensor oder ein Antrieb ist ausgefallen</translation>
    </message>
    <message>
        <source>it does not identify itself</source>
        <translation>es gibt sich nicht zu erkennen</translation>
    </message>
    <message>
        <source>its limits are out of range</source>
        <translation>seine Grenzwerte sind unglaubwürdig</translation>
    </message>
    <message>
        <source>the computer was late with its force</source>
        <translation>der Rechner kam mit seiner Kraft zu spät</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>seine Daten sind beschädigt</translation>
    </message>
    <message>
        <source>it does not accept data</source>
        <translation>es nimmt keine Daten an</translation>
    </message>
    <message>
        <source>it received nothing from the computer for too long</source>
        <translation>es hat zu lange nichts vom Rechner empfangen</translation>
    </message>
    <message>
        <source>the computer did not respond, so its motors were switched off</source>
        <translation>der Rechner reagierte nicht, deshalb wurden die Motoren abgeschaltet</translation>
    </message>
    <message>
        <source>another program uses it</source>
        <translation>ein anderes Programm benutzt es</translation>
    </message>
    <message>
        <source>OpenHaptics has no licence</source>
        <translation>OpenHaptics hat keine Lizenz</translation>
    </message>
    <message>
        <source>its model is not supported</source>
        <translation>sein Modell wird nicht unterstützt</translation>
    </message>
    <message>
        <source>it is not calibrated; choose its self-calibrating mode</source>
        <translation>es ist nicht kalibriert; die selbstkalibrierende Betriebsart wählen</translation>
    </message>
    <message>
        <source>put its stylus into the inkwell to calibrate it</source>
        <translation>zum Kalibrieren den Stift in die Halterung stecken</translation>
    </message>
</context>
<context>
    <name>Edit</name>
    <message>
        <source>Drop air cuts</source>
        <translation>Luftschnitte entfernen</translation>
    </message>
    <message>
        <source>Drop dwells</source>
        <translation>Verweilen entfernen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Keep out of the part</source>
        <translation>Vom Teil fernhalten</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Vereinfachen</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Set feed and speed</source>
        <translation>Schnittwerte setzen</translation>
    </message>
    <message>
        <source>Smooth by a spline in time (earlier version)</source>
        <translation>Mit einem Spline über der Zeit glätten (frühere Fassung)</translation>
    </message>
    <message>
        <source>Delete part of the path</source>
        <translation>Bahnabschnitt löschen</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Kürzen</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Zusammenfügen</translation>
    </message>
    <message>
        <source>Reorder</source>
        <translation>Umordnen</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Vervielfältigen</translation>
    </message>
    <message>
        <source>Move points</source>
        <translation>Punkte verschieben</translation>
    </message>
    <message>
        <source>Replace part of the path</source>
        <translation>Bahnabschnitt ersetzen</translation>
    </message>
    <message>
        <source>Delete in an area</source>
        <translation>Im Bereich löschen</translation>
    </message>
    <message>
        <source>Retract in an area</source>
        <translation>Im Bereich anheben</translation>
    </message>
    <message>
        <source>Project onto the part</source>
        <translation>Auf das Teil projizieren</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versetzen</translation>
    </message>
    <message>
        <source>Rows along a guide</source>
        <translation>Zeilen entlang einer Führung</translation>
    </message>
    <message>
        <source>Fit arcs</source>
        <translation>Bögen einpassen</translation>
    </message>
    <message>
        <source>Round corners</source>
        <translation>Ecken runden</translation>
    </message>
    <message>
        <source>Lead in</source>
        <translation>Anfahren</translation>
    </message>
    <message>
        <source>Lead out</source>
        <translation>Abfahren</translation>
    </message>
    <message>
        <source>Feed by engagement</source>
        <translation>Vorschub nach Eingriff</translation>
    </message>
    <message>
        <source>Feed in an area</source>
        <translation>Vorschub in einem Bereich</translation>
    </message>
    <message>
        <source>Smooth in time (earlier version)</source>
        <translation>Über der Zeit glätten (frühere Fassung)</translation>
    </message>
    <message>
        <source>Feed of strokes</source>
        <translation>Vorschub von Zügen</translation>
    </message>
    <message>
        <source>Extend</source>
        <translation>Verlängern</translation>
    </message>
    <message>
        <source>Holding tabs</source>
        <translation>Haltestege</translation>
    </message>
    <message>
        <source>Spindle and coolant</source>
        <translation>Spindel und Kühlung</translation>
    </message>
    <message>
        <source>Insert a point</source>
        <translation>Punkt einfügen</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>Werkzeugachse</translation>
    </message>
</context>
<context>
    <name>EditParameterLabels</name>
    <message>
        <source>Shortest</source>
        <translation>Mindestlänge</translation>
    </message>
    <message>
        <source>Shorter air cuts are kept</source>
        <translation>Kürzere Luftschnitte bleiben</translation>
    </message>
    <message>
        <source>Slower than</source>
        <translation>Langsamer als</translation>
    </message>
    <message>
        <source>Tool speed below which the hand counts as resting</source>
        <translation>Geschwindigkeit des Werkzeugs, unter der die Hand als ruhend gilt</translation>
    </message>
    <message>
        <source>Longer than</source>
        <translation>Länger als</translation>
    </message>
    <message>
        <source>Shorter dwells are kept</source>
        <translation>Kürzeres Verweilen bleibt</translation>
    </message>
    <message>
        <source>Tremor above it is removed</source>
        <translation>Zittern oberhalb davon wird entfernt</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Largest deviation from the recording</source>
        <translation>Größte Abweichung von der Aufnahme</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance from the part, in addition to the allowance</source>
        <translation>Abstand vom Teil, zusätzlich zum Aufmaß</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>Distance between the points at which the path is kept out of the part</source>
        <translation>Abstand der Punkte, an denen die Bahn vom Teil ferngehalten wird</translation>
    </message>
    <message>
        <source>Largest deviation of the points that are left out</source>
        <translation>Größte Abweichung der weggelassenen Punkte</translation>
    </message>
    <message>
        <source>Clearance above</source>
        <translation>Sicherheitshöhe</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Anfahrweg</translation>
    </message>
    <message>
        <source>Height of rapid moves above the top of the stock</source>
        <translation>Höhe des Eilgangs über der Oberkante des Rohteils</translation>
    </message>
    <message>
        <source>Height above the remaining stock at which the plunge begins</source>
        <translation>Höhe über dem verbliebenen Material, in der das Eintauchen beginnt</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>Gilt für</translation>
    </message>
    <message>
        <source>Strokes to edit. Select them in the view first</source>
        <translation>Züge, die bearbeitet werden. Zuerst in der Ansicht auswählen</translation>
    </message>
    <message>
        <source>Part of the path to delete. Select it in the view first</source>
        <translation>Abschnitt der Bahn, der gelöscht wird. Zuerst in der Ansicht auswählen</translation>
    </message>
    <message>
        <source>Points that are moved</source>
        <translation>Punkte, die verschoben werden</translation>
    </message>
    <message>
        <source>Part of the path that the drawn stroke replaces</source>
        <translation>Abschnitt der Bahn, den der gezeichnete Zug ersetzt</translation>
    </message>
    <message>
        <source>From the start</source>
        <translation>Vom Anfang</translation>
    </message>
    <message>
        <source>Cut off where each stroke begins</source>
        <translation>Wird am Anfang jedes Zuges abgeschnitten</translation>
    </message>
    <message>
        <source>From the end</source>
        <translation>Vom Ende</translation>
    </message>
    <message>
        <source>Cut off where each stroke ends</source>
        <translation>Wird am Ende jedes Zuges abgeschnitten</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>The stroke is split here</source>
        <translation>Hier wird der Zug geteilt</translation>
    </message>
    <message>
        <source>Largest gap</source>
        <translation>Größte Lücke</translation>
    </message>
    <message>
        <source>Ends no farther apart than this are joined</source>
        <translation>Enden, die nicht weiter auseinanderliegen, werden zusammengefügt</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>The stroke that is moved in the order</source>
        <translation>Der Zug, der in der Reihenfolge wandert</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>The stroke that it comes before; none: it comes last</source>
        <translation>Der Zug, vor den er kommt; keiner: Er kommt zuletzt</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer zu</translation>
    </message>
    <message>
        <source>Axis perpendicular to the mirror plane</source>
        <translation>Achse, zu der die Spiegelebene senkrecht steht</translation>
    </message>
    <message>
        <source>Plane at</source>
        <translation>Ebene bei</translation>
    </message>
    <message>
        <source>Keep the originals</source>
        <translation>Originale behalten</translation>
    </message>
    <message>
        <source>They are cut before their images</source>
        <translation>Sie werden vor ihren Bildern gefräst</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Anticlockwise as seen from above</source>
        <translation>Gegen den Uhrzeigersinn, von oben gesehen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>From each copy to the next</source>
        <translation>Von jeder Kopie zur nächsten</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>From each copy to the next, anticlockwise as seen from above</source>
        <translation>Von jeder Kopie zur nächsten, von oben gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopien</translation>
    </message>
    <message>
        <source>Besides the original</source>
        <translation>Außer dem Original</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Um</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>Auslauf</translation>
    </message>
    <message>
        <source>Points along the stroke within this distance follow by less and less</source>
        <translation>Punkte entlang des Zuges bis zu diesem Abstand folgen, immer weniger</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Freely, or along the part&apos;s surface with the same distance from it</source>
        <translation>Frei, oder an der Oberfläche des Teils entlang mit gleichem Abstand</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Points of the drawn stroke</source>
        <translation>Punkte des gezeichneten Zuges</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Corners of the area, seen from above</source>
        <translation>Ecken des Bereichs von oben</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Up to</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>Rückzug</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Feeds inside the area are multiplied by this</source>
        <translation>Damit werden Vorschübe im Bereich malgenommen</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Stock left on the part</source>
        <translation>Material, das auf dem Teil stehen bleibt</translation>
    </message>
    <message>
        <source>Distance between the points that are projected onto the part</source>
        <translation>Abstand der Punkte, die auf das Teil projiziert werden</translation>
    </message>
    <message>
        <source>Down the tool&apos;s axis, or along the part&apos;s normal</source>
        <translation>Die Werkzeugachse hinab, oder entlang der Flächennormale</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>To the left of the motion; negative to the right</source>
        <translation>Links der Bewegung; negativ rechts</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>Points of a drawn guide; none: the selected strokes</source>
        <translation>Punkte einer gezeichneten Führung; keine: die ausgewählten Züge</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>Zeilenabstand</translation>
    </message>
    <message>
        <source>Between rows, seen from above</source>
        <translation>Zwischen Zeilen, von oben gesehen</translation>
    </message>
    <message>
        <source>Rows to the left</source>
        <translation>Zeilen links</translation>
    </message>
    <message>
        <source>Beside the guide, in its direction</source>
        <translation>Neben der Führung, in ihrer Richtung</translation>
    </message>
    <message>
        <source>Rows to the right</source>
        <translation>Zeilen rechts</translation>
    </message>
    <message>
        <source>Largest deviation of an arc from the path</source>
        <translation>Größte Abweichung eines Bogens von der Bahn</translation>
    </message>
    <message>
        <source>Largest sweep</source>
        <translation>Größter Winkel</translation>
    </message>
    <message>
        <source>Arcs of a larger angle are split</source>
        <translation>Bögen mit größerem Winkel werden geteilt</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>Kleinster Radius</translation>
    </message>
    <message>
        <source>Largest radius</source>
        <translation>Größter Radius</translation>
    </message>
    <message>
        <source>Radius mismatch</source>
        <translation>Radiusabweichung</translation>
    </message>
    <message>
        <source>How far the radii at both ends may differ once values are rounded</source>
        <translation>Wie weit die Radien beider Enden nach dem Runden der Werte auseinanderliegen dürfen</translation>
    </message>
    <message>
        <source>Largest deviation of a rounded corner from the sharp one</source>
        <translation>Größte Abweichung einer gerundeten Ecke von der scharfen</translation>
    </message>
    <message>
        <source>Smallest turn</source>
        <translation>Kleinster Knick</translation>
    </message>
    <message>
        <source>Strokes that get a lead-in. Select them in the view first</source>
        <translation>Züge, die eine Anfahrt bekommen. Zuerst in der Ansicht auswählen</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Length of a line or ramp, radius of an arc or helix</source>
        <translation>Länge einer Geraden oder Rampe, Radius eines Bogens oder einer Helix</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Largest descent angle of a helix</source>
        <translation>Größter Winkel, in dem eine Helix hinabgeht</translation>
    </message>
    <message>
        <source>Length of a line, radius of an arc</source>
        <translation>Länge einer Geraden, Radius eines Bogens</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Ausgleichen</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Smallest chip</source>
        <translation>Kleinster Span</translation>
    </message>
    <message>
        <source>A tooth never takes less</source>
        <translation>Weniger nimmt kein Zahn</translation>
    </message>
    <message>
        <source>Largest chip</source>
        <translation>Größter Span</translation>
    </message>
    <message>
        <source>A tooth never takes more</source>
        <translation>Mehr nimmt kein Zahn</translation>
    </message>
    <message>
        <source>Least change</source>
        <translation>Kleinste Änderung</translation>
    </message>
    <message>
        <source>Change of the feed; smaller changes are left out</source>
        <translation>Änderung des Vorschubs; kleinere entfallen</translation>
    </message>
    <message>
        <source>Distance between the points at which moves are evaluated</source>
        <translation>Abstand der Punkte, an denen Bewegungen ausgewertet werden</translation>
    </message>
    <message>
        <source>a straight line</source>
        <translation>eine Gerade</translation>
    </message>
    <message>
        <source>an arc</source>
        <translation>ein Bogen</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>eine Rampe</translation>
    </message>
    <message>
        <source>a helix</source>
        <translation>eine Helix</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>freely</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>the part&apos;s surface</source>
        <translation>die Oberfläche des Teils</translation>
    </message>
    <message>
        <source>the tool&apos;s axis</source>
        <translation>die Werkzeugachse</translation>
    </message>
    <message>
        <source>the part&apos;s normal</source>
        <translation>die Flächennormale</translation>
    </message>
    <message>
        <source>full height</source>
        <translation>volle Höhe</translation>
    </message>
    <message>
        <source>lowest safe height</source>
        <translation>tiefste sichere Höhe</translation>
    </message>
    <message>
        <source>the force</source>
        <translation>die Kraft</translation>
    </message>
    <message>
        <source>the removal rate</source>
        <translation>das Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>Chip load</source>
        <translation>Zahnvorschub</translation>
    </message>
    <message>
        <source>Share of the table value; feeds change with it</source>
        <translation>Anteil am Tabellenwert; Vorschübe ändern sich mit</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlung</translation>
    </message>
    <message>
        <source>as advised</source>
        <translation>wie geraten</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>mist (M7)</source>
        <translation>Nebel (M7)</translation>
    </message>
    <message>
        <source>flood (M8)</source>
        <translation>Schwall (M8)</translation>
    </message>
    <message>
        <source>Retract: full height, lowest safe height, or around obstacles</source>
        <translation>Rückzug: volle Höhe, tiefste sichere Höhe oder um Hindernisse herum</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>Largest length of either move that a rounded corner of a link may replace; none: sharp corners</source>
        <translation>Größte Länge, die eine gerundete Ecke einer Verbindung von jeder der beiden Bewegungen ersetzen darf; keine: scharfe Ecken</translation>
    </message>
    <message>
        <source>around obstacles</source>
        <translation>um Hindernisse herum</translation>
    </message>
    <message>
        <source>0: the mean of the path&apos;s cutting moves</source>
        <translation>0: der Mittelwert der Schnittbewegungen der Bahn</translation>
    </message>
    <message>
        <source>Position of the mirror plane, from program zero; it can be drawn in the view, as a line</source>
        <translation>Position der Spiegelebene, vom Programmnullpunkt aus; sie lässt sich in der Ansicht als Linie zeichnen</translation>
    </message>
    <message>
        <source>Position of the vertical axis of rotation, from program zero</source>
        <translation>Position der senkrechten Drehachse, vom Programmnullpunkt aus</translation>
    </message>
    <message>
        <source>Lowest height of the area, from program zero</source>
        <translation>Unterste Höhe des Bereichs, vom Programmnullpunkt aus</translation>
    </message>
    <message>
        <source>Greatest height of the area, from program zero</source>
        <translation>Oberste Höhe des Bereichs, vom Programmnullpunkt aus</translation>
    </message>
    <message>
        <source>Cut-off wavelength</source>
        <translation>Grenzwellenlänge</translation>
    </message>
    <message>
        <source>Tremor across the path with a shorter wavelength is removed</source>
        <translation>Zittern quer zur Bahn mit kürzerer Wellenlänge wird entfernt</translation>
    </message>
    <message>
        <source>Cut-off frequency</source>
        <translation>Grenzfrequenz</translation>
    </message>
    <message>
        <source>within the limits alone</source>
        <translation>nur innerhalb der Grenzen</translation>
    </message>
    <message>
        <source>Into material</source>
        <translation>Ins Material</translation>
    </message>
    <message>
        <source>Ramp angle</source>
        <translation>Rampenwinkel</translation>
    </message>
    <message>
        <source>Largest descent angle of ramps and helices; 0: by material and tool</source>
        <translation>Größter Eintauchwinkel von Rampen und Helices; 0: nach Werkstoff und Werkzeug</translation>
    </message>
    <message>
        <source>Direction by</source>
        <translation>Richtung nach</translation>
    </message>
    <message>
        <source>By the recording, leads keep their side when other edits change</source>
        <translation>Nach der Aufnahme behalten An- und Abfahrten ihre Seite, wenn sich andere Bearbeitungen ändern</translation>
    </message>
    <message>
        <source>straight down</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>a ramp or helix</source>
        <translation>Rampe oder Helix</translation>
    </message>
    <message>
        <source>the first move</source>
        <translation>der ersten Bewegung</translation>
    </message>
    <message>
        <source>the recording</source>
        <translation>der Aufnahme</translation>
    </message>
    <message>
        <source>Curves with a smaller radius stay straight moves</source>
        <translation>Kurven mit kleinerem Radius bleiben gerade Bewegungen</translation>
    </message>
    <message>
        <source>Curves with a larger radius stay straight moves</source>
        <translation>Kurven mit größerem Radius bleiben gerade Bewegungen</translation>
    </message>
    <message>
        <source>Corners with a smaller angle are kept</source>
        <translation>Ecken mit kleinerem Winkel bleiben</translation>
    </message>
    <message>
        <source>Motion onto the stroke, or away from it</source>
        <translation>Bewegung auf den Zug hin oder von ihm weg</translation>
    </message>
    <message>
        <source>Height of a ramp or helix</source>
        <translation>Höhe einer Rampe oder Helix</translation>
    </message>
    <message>
        <source>Entry into a stroke that begins in material: plunge, or a ramp along the stroke, else a helix beside it</source>
        <translation>Eintritt in einen Zug, der im Material beginnt: Eintauchen, oder eine Rampe entlang des Zugs, sonst eine Helix daneben</translation>
    </message>
    <message>
        <source>Share of the table value; feeds change with it, the chip load does not</source>
        <translation>Anteil am Tabellenwert; die Vorschübe ändern sich mit, die Spandicke nicht</translation>
    </message>
    <message>
        <source>Value to keep constant: the force or the removal rate. With the limits, feeds are only reduced where the cut exceeds a limit of spindle or tool</source>
        <translation>Wert, der gleich bleibt: die Kraft oder das Zeitspanvolumen. Bei den Grenzen sinken Vorschübe nur, wo der Schnitt eine Grenze von Spindel oder Werkzeug überschreitet</translation>
    </message>
    <message>
        <source>Displacement of the points</source>
        <translation>Verschiebung der Punkte</translation>
    </message>
    <message>
        <source>Height of the retraction inside the area</source>
        <translation>Höhe des Rückzugs im Bereich</translation>
    </message>
    <message>
        <source>one speed</source>
        <translation>eine Drehzahl</translation>
    </message>
    <message>
        <source>by material</source>
        <translation>nach Werkstoff</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>In several materials: one speed, the least that any of them allows, or the speed of each, which changes at their borders; feeds follow in both</source>
        <translation>In mehreren Werkstoffen: eine Drehzahl, die kleinste, die einer von ihnen erlaubt, oder die Drehzahl von jedem, die an ihren Grenzen wechselt; die Vorschübe folgen in beiden Fällen</translation>
    </message>
    <message>
        <source>from the tables</source>
        <translation>aus den Tabellen</translation>
    </message>
    <message>
        <source>as the program states them</source>
        <translation>wie im Programm angegeben</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>Vorschübe</translation>
    </message>
    <message>
        <source>From the tables of tool and material, or as the program states them that the path is made of, within the limits of machine and tool; links are fed from the tables, but no faster than the moves that they join</source>
        <translation>Aus den Tabellen von Werkzeug und Werkstoff, oder wie sie das Programm angibt, aus dem die Bahn entstand, innerhalb der Grenzen von Maschine und Werkzeug; Verbindungen fahren mit Tabellenwerten, aber nicht schneller als die Bewegungen, die sie verbinden</translation>
    </message>
    <message>
        <source>Feeds of these strokes are multiplied by this</source>
        <translation>Vorschübe dieser Züge werden damit multipliziert</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Am Anfang</translation>
    </message>
    <message>
        <source>Added straight before the start of each stroke</source>
        <translation>Gerade vor dem Anfang jedes Zuges angefügt</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>Added straight behind the end of each stroke</source>
        <translation>Gerade hinter dem Ende jedes Zuges angefügt</translation>
    </message>
    <message>
        <source>Points in plan at which the path leaves a tab. Draw them in the view</source>
        <translation>Punkte im Grundriss, an denen die Bahn einen Steg stehen lässt. Zeichnen Sie sie in der Ansicht</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width of the tab that the cutter leaves</source>
        <translation>Breite des Stegs, den der Fräser stehen lässt</translation>
    </message>
    <message>
        <source>Height of the tab above the lowest stroke there</source>
        <translation>Höhe des Stegs über dem tiefsten Zug dort</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>Of these strokes; feeds stay as they are. 0: unchanged</source>
        <translation>Dieser Züge; die Vorschübe bleiben. 0: unverändert</translation>
    </message>
    <message>
        <source>Share of the speed</source>
        <translation>Anteil der Drehzahl</translation>
    </message>
    <message>
        <source>Spindle speeds of these strokes are multiplied by this</source>
        <translation>Drehzahlen dieser Züge werden damit multipliziert</translation>
    </message>
    <message>
        <source>Of these strokes, if the machine has it</source>
        <translation>Dieser Züge, wenn die Maschine sie hat</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>The point is inserted here. Select a point of the path first</source>
        <translation>Hier wird der Punkt eingefügt. Wählen Sie vorher einen Punkt der Bahn</translation>
    </message>
    <message>
        <source>Farther along</source>
        <translation>Weiter entlang</translation>
    </message>
    <message>
        <source>Distance along the stroke from that position to the point</source>
        <translation>Abstand des Punktes von dieser Position, entlang des Zuges</translation>
    </message>
    <message>
        <source>Displacement of the point from the stroke</source>
        <translation>Verschiebung des Punktes gegenüber dem Zug</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>The stroke follows the point within this length on either side; 0: the point alone moves</source>
        <translation>Bis zu dieser Länge auf beiden Seiten folgt der Zug dem Punkt; 0: Nur der Punkt bewegt sich</translation>
    </message>
    <message>
        <source>How the stroke leads to the point: in a smooth curve, or in straight lines to a corner</source>
        <translation>Wie der Zug zum Punkt führt: in einer glatten Kurve, oder in Geraden zu einer Ecke</translation>
    </message>
    <message>
        <source>as the program states it</source>
        <translation>wie im Programm angegeben</translation>
    </message>
    <message>
        <source>As advised for the material if the machine has it, as chosen here, or as the program that the path is made of switches it</source>
        <translation>Wie für den Werkstoff empfohlen, falls die Maschine sie hat, wie hier gewählt, oder wie das Programm sie schaltet, aus dem die Bahn gemacht ist</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>a fixed direction</source>
        <translation>eine feste Richtung</translation>
    </message>
    <message>
        <source>the program</source>
        <translation>das Programm</translation>
    </message>
    <message>
        <source>turned in the links</source>
        <translation>in den Verbindungen gedreht</translation>
    </message>
    <message>
        <source>turned in the stroke</source>
        <translation>im Zug gedreht</translation>
    </message>
    <message>
        <source>the contact</source>
        <translation>die Berührung</translation>
    </message>
    <message>
        <source>the tip</source>
        <translation>die Spitze</translation>
    </message>
    <message>
        <source>Axis from</source>
        <translation>Achse von</translation>
    </message>
    <message>
        <source>Direction from which lead and tilt are counted: upright, or the normal of the part; or a fixed direction; or the axis that the program states of which the path is made</source>
        <translation>Richtung, von der aus Voreilwinkel und Neigung gezählt werden: senkrecht oder die Normale des Teils; oder eine feste Richtung; oder die Achse, die das Programm angibt, aus dem die Bahn gemacht ist</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Voreilwinkel</translation>
    </message>
    <message>
        <source>Angle in the direction of motion; above 0: the holder leans ahead</source>
        <translation>Winkel in Bewegungsrichtung; über 0: Der Halter neigt sich nach vorn</translation>
    </message>
    <message>
        <source>Side tilt</source>
        <translation>Seitliche Neigung</translation>
    </message>
    <message>
        <source>Angle across the direction of motion; above 0: the holder leans to the left</source>
        <translation>Winkel quer zur Bewegungsrichtung; über 0: Der Halter neigt sich nach links</translation>
    </message>
    <message>
        <source>Inclination</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Of a fixed direction: its angle from +Z</source>
        <translation>Einer festen Richtung: ihr Winkel zu +Z</translation>
    </message>
    <message>
        <source>Towards</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Of a fixed direction: where the holder leans in plan, anticlockwise from +X</source>
        <translation>Einer festen Richtung: wohin sich der Halter im Grundriss neigt, gegen den Uhrzeigersinn ab +X</translation>
    </message>
    <message>
        <source>Length over which the axis turns at the borders of the part of the path, and over which direction and normal are averaged</source>
        <translation>Länge, über die sich die Achse an den Grenzen des Bahnteils dreht und über die Richtung und Normale gemittelt werden</translation>
    </message>
    <message>
        <source>At ends of strokes</source>
        <translation>An Enden von Zügen</translation>
    </message>
    <message>
        <source>Where the axis turns: in the rapids before and after the stroke, or inside it</source>
        <translation>Wo sich die Achse dreht: in den Eilgängen vor und nach dem Zug oder in ihm</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Beibehalten</translation>
    </message>
    <message>
        <source>The contact with the part while the tool tilts: the centre of a ball, or the plane that another tool touches; or the tip</source>
        <translation>Die Berührung mit dem Teil, während sich das Werkzeug neigt: die Mitte einer Kugel oder die Ebene, die ein anderes Werkzeug berührt; oder die Spitze</translation>
    </message>
</context>
<context>
    <name>EmbeddingLabels</name>
    <message>
        <source>scanlines: %1</source>
        <translation>Abtastlinien: %1</translation>
    </message>
    <message>
        <source>%1&#xa0;%2 to %3</source>
        <comment>X 0.000 to 10.000 mm</comment>
        <translation>%1&#xa0;%2 bis %3</translation>
    </message>
    <message>
        <source>The surface of “%1” is open (edges: %2), but no scanline meets a gap.</source>
        <translation>Die Oberfläche von „%1“ ist offen (Kanten: %2), aber keine Abtastlinie trifft eine Lücke.</translation>
    </message>
    <message>
        <source>Faces of “%1” do not agree on which side is outside, so every second interval between them was filled (%2); make their normals agree in the CAD program.</source>
        <translation>Flächen von „%1“ sind sich nicht einig, was außen ist; jeder zweite Abschnitt zwischen ihnen wurde gefüllt (%2). Richten Sie ihre Normalen im CAD-Programm gleich aus.</translation>
    </message>
    <message>
        <source>Shells of “%1” overlap, so everything inside any of them was filled (%2).</source>
        <translation>Schalen von „%1“ überlappen sich; gefüllt wurde alles, was in einer von ihnen liegt (%2).</translation>
    </message>
    <message>
        <source>“%1” is too small for the voxels, so nothing of it is protected; choose smaller voxels.</source>
        <translation>„%1“ ist zu klein für die Voxel, nichts davon ist geschützt; wählen Sie kleinere Voxel.</translation>
    </message>
    <message>
        <source>“%1” overlaps “%2” in %3; there the later body counts.</source>
        <translation>„%1“ überlappt „%2“ in %3; dort gilt der spätere Körper.</translation>
    </message>
    <message>
        <source>The surface of “%1” is open (edges: %2, rims: %3), so its inside is uncertain there (%4); close it in the CAD program.</source>
        <translation>Die Oberfläche von „%1“ ist offen (Kanten: %2, Ränder: %3), deshalb ist ihr Inneres dort ungewiss (%4); schließen Sie sie im CAD-Programm.</translation>
    </message>
    <message>
        <source>A shell of “%1” is inside out and was filled as well (%2); a cavity has to lie within another shell.</source>
        <translation>Eine Schale von „%1“ ist nach innen gewendet und wurde ebenfalls gefüllt (%2); ein Hohlraum muss in einer anderen Schale liegen.</translation>
    </message>
    <message>
        <source>Duplicate triangles of “%1” were counted once (%2).</source>
        <translation>Doppelte Dreiecke von „%1“ wurden einmal gezählt (%2).</translation>
    </message>
</context>
<context>
    <name>EntryLabels</name>
    <message>
        <source>plunges %1</source>
        <translation>Eintauchen %1</translation>
    </message>
    <message>
        <source>ramps %1</source>
        <translation>Rampen %1</translation>
    </message>
    <message>
        <source>helices %1</source>
        <translation>Helices %1</translation>
    </message>
    <message>
        <source>Plunge of %1 to X %2, Y %3, Z %4: no room for a ramp or helix</source>
        <translation>Eintauchen um %1 bis X %2, Y %3, Z %4: kein Platz für eine Rampe oder Helix</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open a project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Burin projects (*.burin)</source>
        <translation>Burin-Projekte (*.burin)</translation>
    </message>
    <message>
        <source>Import a part</source>
        <translation>Teil importieren</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Export the program</source>
        <translation>Programm exportieren</translation>
    </message>
    <message>
        <source>Import a fixture</source>
        <translation>Vorrichtung importieren</translation>
    </message>
    <message>
        <source>Add a machine</source>
        <translation>Maschine hinzufügen</translation>
    </message>
    <message>
        <source>Machines (*.json)</source>
        <translation>Maschinen (*.json)</translation>
    </message>
    <message>
        <source>Programs (*.ngc *.nc *.tap);;All files (*)</source>
        <translation>Programme (*.ngc *.nc *.tap);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Parts (%1);;All files (*)</source>
        <translation>Teile (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export the workpiece</source>
        <translation>Werkstück exportieren</translation>
    </message>
    <message>
        <source>Surfaces and voxels (*.stl *.ply *.3mf *.srle *.nrrd)</source>
        <translation>Oberflächen und Voxel (*.stl *.ply *.3mf *.srle *.nrrd)</translation>
    </message>
    <message>
        <source>Stock from a file</source>
        <translation>Rohteil aus einer Datei</translation>
    </message>
    <message>
        <source>Volumes, voxel arrays and models (%1);;All files (*)</source>
        <translation>Volumen, Voxelfelder und Modelle (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Materials of the values in %1</source>
        <translation>Werkstoffe der Werte in %1</translation>
    </message>
    <message>
        <source>Tables (*.json);;All files (*)</source>
        <translation>Tabellen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation>Werkstoff hinzufügen</translation>
    </message>
    <message>
        <source>Materials (*.json *.FCMat);;All files (*)</source>
        <translation>Werkstoffe (*.json *.FCMat);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Measured forces</source>
        <translation>Gemessene Kräfte</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tabellen (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Models (%1);;All files (*)</source>
        <translation>Modelle (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add a tool</source>
        <translation>Werkzeug hinzufügen</translation>
    </message>
    <message>
        <source>Export tools</source>
        <translation>Werkzeuge exportieren</translation>
    </message>
    <message>
        <source>Export the setup sheet</source>
        <translation>Einrichteblatt exportieren</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>Tools (*.json *.tools *.fctb *.fctl *.ctbl *.tbl);;All files (*)</source>
        <translation>Werkzeuge (*.json *.tools *.fctb *.fctl *.ctbl *.tbl);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>Drawings (*.dxf *.svg *.DXF *.SVG);;All files (*)</source>
        <translation>Zeichnungen (*.dxf *.svg *.DXF *.SVG);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>NC programs (%1)</source>
        <translation>NC-Programme (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Path from a program</source>
        <translation>Bahn aus einem Programm</translation>
    </message>
    <message>
        <source>Programs and cutter locations (%1);;All files (*)</source>
        <translation>Programme und CL-Daten (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Export the table of faces</source>
        <translation>Tabelle der Flächen exportieren</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Tools for other programs (*.fctl *.fctb *.tbl *.tools *.ctbl *.json)</source>
        <translation>Werkzeuge für andere Programme (*.fctl *.fctb *.tbl *.tools *.ctbl *.json)</translation>
    </message>
    <message>
        <source>Record a session trace</source>
        <translation>Spur der Sitzung aufzeichnen</translation>
    </message>
    <message>
        <source>Traces (*.csv)</source>
        <translation>Spuren (*.csv)</translation>
    </message>
</context>
<context>
    <name>FileUnits</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>%1 (stated)</source>
        <translation>%1 (angegeben)</translation>
    </message>
    <message>
        <source>%1 (assumed)</source>
        <translation>%1 (angenommen)</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>retract above the material before this move</source>
        <translation>vor dieser Bewegung über das Material zurückziehen</translation>
    </message>
    <message>
        <source>mill the material around it first, or use a tool with longer flutes</source>
        <translation>zuerst das Material ringsum fräsen oder ein Werkzeug mit längeren Schneiden nehmen</translation>
    </message>
    <message>
        <source>mill the material around it first, or use a tool with a longer stick-out</source>
        <translation>zuerst das Material ringsum fräsen oder ein Werkzeug mit größerer Auskragung nehmen</translation>
    </message>
    <message>
        <source>start the spindle before this move</source>
        <translation>die Spindel vor dieser Bewegung einschalten</translation>
    </message>
    <message>
        <source>place the part elsewhere on the table, or use a machine with more travel</source>
        <translation>das Teil an einer anderen Stelle aufspannen oder eine Maschine mit größerem Verfahrweg nehmen</translation>
    </message>
    <message>
        <source>state X, Y and Z before this move</source>
        <translation>vor dieser Bewegung X, Y und Z angeben</translation>
    </message>
    <message>
        <source>move the fixture, or retract the path above it</source>
        <translation>das Spannmittel versetzen oder die Bahn darüber heben</translation>
    </message>
    <message>
        <source>mill it in more levels or with a smaller step-over, or use a stronger machine</source>
        <translation>in mehr Ebenen oder mit kleinerem Zeilenabstand fräsen, oder eine stärkere Maschine nehmen</translation>
    </message>
    <message>
        <source>mill it in more levels or with a smaller step-over, or use a thicker or shorter tool</source>
        <translation>in mehr Ebenen oder mit kleinerem Zeilenabstand fräsen, oder ein dickeres oder kürzeres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>lower the feed</source>
        <translation>den Vorschub senken</translation>
    </message>
    <message>
        <source>mill it in more levels</source>
        <translation>in mehr Ebenen fräsen</translation>
    </message>
    <message>
        <source>use a smaller step-over</source>
        <translation>einen kleineren Zeilenabstand nehmen</translation>
    </message>
    <message>
        <source>begin beside the material, or use a centre-cutting tool</source>
        <translation>neben dem Material beginnen oder ein Werkzeug nehmen, das über die Mitte schneidet</translation>
    </message>
    <message>
        <source>add the tool to the project with this number, or correct the number</source>
        <translation>das Werkzeug mit dieser Nummer in das Projekt aufnehmen oder die Nummer berichtigen</translation>
    </message>
    <message>
        <source>load the tool with M6 before this move</source>
        <translation>das Werkzeug vor dieser Bewegung mit M6 einwechseln</translation>
    </message>
    <message>
        <source>correct the shift or the coordinates, or post the path again</source>
        <translation>die Verschiebung oder die Koordinaten berichtigen oder die Bahn neu ausgeben</translation>
    </message>
    <message>
        <source>choose smaller voxels</source>
        <translation>kleinere Voxel wählen</translation>
    </message>
    <message>
        <source>add G43 with the tool&apos;s H number after the tool change</source>
        <translation>nach dem Werkzeugwechsel G43 mit der H-Nummer des Werkzeugs hinzufügen</translation>
    </message>
    <message>
        <source>use the H number of the tool in the spindle</source>
        <translation>die H-Nummer des Werkzeugs in der Spindel verwenden</translation>
    </message>
    <message>
        <source>use the work offset in which the project&apos;s zero is stored</source>
        <translation>die Nullpunktverschiebung verwenden, in der der Nullpunkt des Projekts steht</translation>
    </message>
    <message>
        <source>use M3: the tool is right-handed</source>
        <translation>M3 verwenden: das Werkzeug ist rechtsschneidend</translation>
    </message>
    <message>
        <source>use G64 with a small P, or G61</source>
        <translation>G64 mit einem kleinen P oder G61 verwenden</translation>
    </message>
    <message>
        <source>retract or delete this part of the path, or mill it with a smaller tool</source>
        <translation>in diesem Teil der Bahn zurückziehen, ihn löschen oder mit einem kleineren Werkzeug fräsen</translation>
    </message>
    <message>
        <source>lower the feed to the machine&apos;s maximum</source>
        <translation>den Vorschub auf den größten der Maschine senken</translation>
    </message>
    <message>
        <source>use a spindle speed within the machine&apos;s range</source>
        <translation>eine Drehzahl im Bereich der Maschine verwenden</translation>
    </message>
    <message>
        <source>stop the spindle before this move, and hold it: the tool doesn&apos;t turn</source>
        <translation>die Spindel vor dieser Bewegung anhalten und festhalten: das Werkzeug dreht sich nicht</translation>
    </message>
    <message>
        <source>tilt the tool less, or use a machine whose rotary axes turn farther</source>
        <translation>das Werkzeug weniger neigen oder eine Maschine wählen, deren Drehachsen weiter drehen</translation>
    </message>
</context>
<context>
    <name>FindingName</name>
    <message>
        <source>gouge</source>
        <translation>Konturverletzung</translation>
    </message>
    <message>
        <source>rapid_in_stock</source>
        <translation>Eilgang im Material</translation>
    </message>
    <message>
        <source>shank_collision</source>
        <translation>Kollision des Schafts</translation>
    </message>
    <message>
        <source>holder_collision</source>
        <translation>Kollision des Halters</translation>
    </message>
    <message>
        <source>spindle_off</source>
        <translation>Spindel steht</translation>
    </message>
    <message>
        <source>travel_limit</source>
        <translation>Verfahrweg überschritten</translation>
    </message>
    <message>
        <source>feed_limit</source>
        <translation>Vorschubgrenze</translation>
    </message>
    <message>
        <source>spindle_limit</source>
        <translation>Drehzahlgrenze</translation>
    </message>
    <message>
        <source>unknown_start</source>
        <translation>unbekannter Anfang</translation>
    </message>
    <message>
        <source>obstacle_collision</source>
        <translation>Kollision mit Vorrichtung</translation>
    </message>
    <message>
        <source>spindle_power</source>
        <translation>Spindelleistung</translation>
    </message>
    <message>
        <source>spindle_torque</source>
        <translation>Spindelmoment</translation>
    </message>
    <message>
        <source>tool_breakage</source>
        <translation>Werkzeugbruch</translation>
    </message>
    <message>
        <source>tool_bending</source>
        <translation>Werkzeugbiegung</translation>
    </message>
    <message>
        <source>chip_load</source>
        <translation>Spandicke</translation>
    </message>
    <message>
        <source>depth_of_cut</source>
        <translation>Schnitttiefe</translation>
    </message>
    <message>
        <source>width_of_cut</source>
        <translation>Schnittbreite</translation>
    </message>
    <message>
        <source>plunge_without_centre</source>
        <translation>Eintauchen ohne Zentrumsschneide</translation>
    </message>
    <message>
        <source>tool_unknown</source>
        <translation>unbekanntes Werkzeug</translation>
    </message>
    <message>
        <source>tool_not_loaded</source>
        <translation>Werkzeug nicht eingewechselt</translation>
    </message>
    <message>
        <source>length_offset_missing</source>
        <translation>Längenkorrektur fehlt</translation>
    </message>
    <message>
        <source>length_offset_of_another_tool</source>
        <translation>Längenkorrektur eines anderen Werkzeugs</translation>
    </message>
    <message>
        <source>other_work_offset</source>
        <translation>andere Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>spindle_reversed</source>
        <translation>Spindel dreht verkehrt</translation>
    </message>
    <message>
        <source>corner_gouge</source>
        <translation>Konturverletzung in Ecke</translation>
    </message>
    <message>
        <source>corner_excess</source>
        <translation>Aufmaß in Ecke</translation>
    </message>
    <message>
        <source>allowance_differs</source>
        <translation>abweichendes Aufmaß</translation>
    </message>
    <message>
        <source>part_not_protected</source>
        <translation>Teil nicht geschützt</translation>
    </message>
    <message>
        <source>shank_near_stock</source>
        <translation>Schaft nahe am Rohteil</translation>
    </message>
    <message>
        <source>shank_near_part</source>
        <translation>Schaft nahe am Teil</translation>
    </message>
    <message>
        <source>shank_near_obstacle</source>
        <translation>Schaft nahe an Vorrichtung</translation>
    </message>
    <message>
        <source>holder_near_stock</source>
        <translation>Halter nahe am Rohteil</translation>
    </message>
    <message>
        <source>holder_near_part</source>
        <translation>Halter nahe am Teil</translation>
    </message>
    <message>
        <source>holder_near_obstacle</source>
        <translation>Halter nahe an Vorrichtung</translation>
    </message>
    <message>
        <source>spindle_on</source>
        <translation>Spindel dreht</translation>
    </message>
</context>
<context>
    <name>FirstJob</name>
    <message>
        <source>Open the sample part</source>
        <translation>Beispielteil öffnen</translation>
    </message>
    <message>
        <source>Press “Try the sample part”. It is a computer mouse, 110 mm long. A part of your own does as well.</source>
        <translation>Drücken Sie „Mit dem Beispielteil probieren“. Es ist eine Computermaus, 110 mm lang. Ein eigenes Teil geht auch.</translation>
    </message>
    <message>
        <source>Choose the stock</source>
        <translation>Rohteil festlegen</translation>
    </message>
    <message>
        <source>The margins state how much stock is around the part. Enter %1 as the voxel size: large voxels are coarse, but quick.</source>
        <translation>Die Aufmaße geben an, wie viel Rohteil um das Teil ist. Geben Sie %1 als Voxelgröße ein: Große Voxel sind grob, aber schnell.</translation>
    </message>
    <message>
        <source>Embed the part</source>
        <translation>Teil einbetten</translation>
    </message>
    <message>
        <source>Press “Embed the part”. Burin puts the part in its stock; this makes the workpiece.</source>
        <translation>Drücken Sie „Teil einbetten“. Burin setzt das Teil in sein Rohteil; so entsteht das Werkstück.</translation>
    </message>
    <message>
        <source>Choose a tool</source>
        <translation>Werkzeug wählen</translation>
    </message>
    <message>
        <source>Click “%1” in the list. Any other tool will do.</source>
        <translation>Klicken Sie in der Liste auf „%1“. Jedes andere Werkzeug geht auch.</translation>
    </message>
    <message>
        <source>Start milling</source>
        <translation>Fräsen beginnen</translation>
    </message>
    <message>
        <source>Press “Mill”. From then on the left mouse button cuts in the view, and everything that is cut is recorded.</source>
        <translation>Drücken Sie „Fräsen“. Von da an schneidet die linke Maustaste in der Ansicht, und alles, was geschnitten wird, wird aufgenommen.</translation>
    </message>
    <message>
        <source>Mill a stroke</source>
        <translation>Einen Zug fräsen</translation>
    </message>
    <message>
        <source>Hold the left mouse button and drag over the stock. The tool cuts where you drag, and stops at the part.</source>
        <translation>Halten Sie die linke Maustaste und ziehen Sie über das Rohteil. Das Werkzeug schneidet, wo Sie ziehen, und hält am Teil an.</translation>
    </message>
    <message>
        <source>Stop milling</source>
        <translation>Fräsen beenden</translation>
    </message>
    <message>
        <source>Press the button again. What you milled is listed as a take.</source>
        <translation>Drücken Sie den Knopf noch einmal. Was Sie gefräst haben, steht als Aufnahme in der Liste.</translation>
    </message>
    <message>
        <source>Make a path</source>
        <translation>Bahn erstellen</translation>
    </message>
    <message>
        <source>Press “New path from the takes”. The take becomes a tool path with the standard edits.</source>
        <translation>Drücken Sie „Neue Bahn aus den Aufnahmen“. Aus der Aufnahme wird eine Werkzeugbahn mit den üblichen Bearbeitungen.</translation>
    </message>
    <message>
        <source>Add an edit</source>
        <translation>Bearbeitung hinzufügen</translation>
    </message>
    <message>
        <source>Press “Add an edit” and choose “Smooth” under “Smoother, fewer moves”. Any other edit does as well.</source>
        <translation>Drücken Sie „Bearbeitung hinzufügen“ und wählen Sie „Glätten“ unter „Glätten und ausdünnen“. Jede andere Bearbeitung geht auch.</translation>
    </message>
    <message>
        <source>Post and check</source>
        <translation>Ausgeben und prüfen</translation>
    </message>
    <message>
        <source>Press “Post and check”. Burin makes the NC program, reads it back and mills it again on the stock.</source>
        <translation>Drücken Sie „Ausgeben und prüfen“. Burin erzeugt das NC-Programm, liest es zurück und fräst es am Rohteil noch einmal.</translation>
    </message>
    <message>
        <source>Export the program (optional)</source>
        <translation>Programm exportieren (optional)</translation>
    </message>
    <message>
        <source>Press “Export…” and choose a file, or skip this step.</source>
        <translation>Drücken Sie „Exportieren…“ und wählen Sie eine Datei, oder überspringen Sie diesen Schritt.</translation>
    </message>
    <message>
        <source>Return to the project.</source>
        <translation>Kehren Sie zum Projekt zurück.</translation>
    </message>
    <message>
        <source>Click “%1” at the top of the window.</source>
        <translation>Klicken Sie oben im Fenster auf „%1“.</translation>
    </message>
</context>
<context>
    <name>Fixture</name>
    <message>
        <source>estimate</source>
        <translation>Schätzwert</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Distance between the jaws: the width of the stock</source>
        <translation>Abstand der Backen: die Breite des Rohteils</translation>
    </message>
    <message>
        <source>Depth of grip</source>
        <translation>Spanntiefe</translation>
    </message>
    <message>
        <source>Height of the stock that is between the jaws</source>
        <translation>Höhe des Rohteils, die zwischen den Backen liegt</translation>
    </message>
    <message>
        <source>Jaw width</source>
        <translation>Backenbreite</translation>
    </message>
    <message>
        <source>Length of the jaws along the stock</source>
        <translation>Länge der Backen entlang des Rohteils</translation>
    </message>
    <message>
        <source>Jaw height</source>
        <translation>Backenhöhe</translation>
    </message>
    <message>
        <source>From the bed of the vise to the top of the jaws</source>
        <translation>Vom Bett des Schraubstocks bis zur Oberkante der Backen</translation>
    </message>
    <message>
        <source>Jaw depth</source>
        <translation>Backentiefe</translation>
    </message>
    <message>
        <source>Thickness of each jaw in the direction of clamping</source>
        <translation>Dicke jeder Backe in Spannrichtung</translation>
    </message>
    <message>
        <source>Body width</source>
        <translation>Körperbreite</translation>
    </message>
    <message>
        <source>Width of the body, in the direction of the jaws</source>
        <translation>Breite des Körpers in Richtung der Backen</translation>
    </message>
    <message>
        <source>Body height</source>
        <translation>Körperhöhe</translation>
    </message>
    <message>
        <source>From the table to the bed of the vise</source>
        <translation>Vom Tisch bis zum Bett des Schraubstocks</translation>
    </message>
    <message>
        <source>Clamping height</source>
        <translation>Spannhöhe</translation>
    </message>
    <message>
        <source>From the table to the lower side of the bar</source>
        <translation>Vom Tisch bis zur Unterseite des Eisens</translation>
    </message>
    <message>
        <source>Bar length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of the bar</source>
        <translation>Länge des Eisens</translation>
    </message>
    <message>
        <source>Bar width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width of the bar</source>
        <translation>Breite des Eisens</translation>
    </message>
    <message>
        <source>Bar thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Height of the bar</source>
        <translation>Höhe des Eisens</translation>
    </message>
    <message>
        <source>Contact length</source>
        <translation>Auflagelänge</translation>
    </message>
    <message>
        <source>Length of the bar&apos;s nose that presses on the stock</source>
        <translation>Länge der Nase des Eisens, die auf das Rohteil drückt</translation>
    </message>
    <message>
        <source>Stud distance</source>
        <translation>Abstand der Stiftschraube</translation>
    </message>
    <message>
        <source>Stud diameter</source>
        <translation>Stiftschraubendurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the stud&apos;s thread</source>
        <translation>Durchmesser des Gewindes der Stiftschraube</translation>
    </message>
    <message>
        <source>Slot width</source>
        <translation>Schlitzbreite</translation>
    </message>
    <message>
        <source>Width of the hole in the bar around the stud</source>
        <translation>Breite des Lochs im Eisen um die Stiftschraube</translation>
    </message>
    <message>
        <source>Washer diameter</source>
        <translation>Scheibendurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the washer below the nut</source>
        <translation>Durchmesser der Scheibe unter der Mutter</translation>
    </message>
    <message>
        <source>Washer thickness</source>
        <translation>Scheibendicke</translation>
    </message>
    <message>
        <source>Thickness of the washer</source>
        <translation>Dicke der Scheibe</translation>
    </message>
    <message>
        <source>Nut width</source>
        <translation>Schlüsselweite der Mutter</translation>
    </message>
    <message>
        <source>Nut height</source>
        <translation>Mutternhöhe</translation>
    </message>
    <message>
        <source>Height of the nut</source>
        <translation>Höhe der Mutter</translation>
    </message>
    <message>
        <source>Stud end</source>
        <translation>Überstand der Stiftschraube</translation>
    </message>
    <message>
        <source>How far the stud reaches above the nut</source>
        <translation>Wie weit die Stiftschraube über die Mutter reicht</translation>
    </message>
    <message>
        <source>Step block length</source>
        <translation>Treppenbocklänge</translation>
    </message>
    <message>
        <source>Length of the step block below the end of the bar; it has three steps</source>
        <translation>Länge des Treppenbocks unter dem Ende des Eisens; er hat drei Stufen</translation>
    </message>
    <message>
        <source>Nose height</source>
        <translation>Nasenhöhe</translation>
    </message>
    <message>
        <source>From the table to the top of the nose</source>
        <translation>Vom Tisch bis zur Oberkante der Nase</translation>
    </message>
    <message>
        <source>Nose thickness</source>
        <translation>Nasendicke</translation>
    </message>
    <message>
        <source>Height of the nose that presses on the side of the stock</source>
        <translation>Höhe der Nase, die auf die Seite des Rohteils drückt</translation>
    </message>
    <message>
        <source>Nose length</source>
        <translation>Nasenlänge</translation>
    </message>
    <message>
        <source>Nose width</source>
        <translation>Nasenbreite</translation>
    </message>
    <message>
        <source>Width of the nose along the side of the stock</source>
        <translation>Breite der Nase entlang der Seite des Rohteils</translation>
    </message>
    <message>
        <source>Body length</source>
        <translation>Körperlänge</translation>
    </message>
    <message>
        <source>Length of the body, away from the stock</source>
        <translation>Länge des Körpers, vom Rohteil weg</translation>
    </message>
    <message>
        <source>Width of the body along the side of the stock</source>
        <translation>Breite des Körpers entlang der Seite des Rohteils</translation>
    </message>
    <message>
        <source>From the table to the top of the body</source>
        <translation>Vom Tisch bis zur Oberkante des Körpers</translation>
    </message>
    <message>
        <source>Thread diameter</source>
        <translation>Gewindedurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the screw&apos;s thread</source>
        <translation>Durchmesser des Gewindes der Schraube</translation>
    </message>
    <message>
        <source>Head height</source>
        <translation>Kopfhöhe</translation>
    </message>
    <message>
        <source>Height of the head</source>
        <translation>Höhe des Kopfes</translation>
    </message>
    <message>
        <source>Screw length</source>
        <translation>Schraubenlänge</translation>
    </message>
    <message>
        <source>How far the screw reaches below the washer</source>
        <translation>Wie weit die Schraube unter die Scheibe reicht</translation>
    </message>
    <message>
        <source>Diameter of the washer below the head</source>
        <translation>Durchmesser der Scheibe unter dem Kopf</translation>
    </message>
    <message>
        <source>Head width</source>
        <translation>Schlüsselweite</translation>
    </message>
    <message>
        <source>Head diameter</source>
        <translation>Kopfdurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the head with its socket</source>
        <translation>Durchmesser des Kopfes mit Innensechskant</translation>
    </message>
    <message>
        <source>Length of each of the two bars</source>
        <translation>Länge jeder der beiden Leisten</translation>
    </message>
    <message>
        <source>Width of each bar, across its length</source>
        <translation>Breite jeder Leiste, quer zu ihrer Länge</translation>
    </message>
    <message>
        <source>Bar height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>From the table to the stock</source>
        <translation>Vom Tisch bis zum Rohteil</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Between the middles of both bars</source>
        <translation>Zwischen den Mitten beider Leisten</translation>
    </message>
    <message>
        <source>Plate length</source>
        <translation>Plattenlänge</translation>
    </message>
    <message>
        <source>Along its X axis</source>
        <translation>Entlang ihrer X-Achse</translation>
    </message>
    <message>
        <source>Plate width</source>
        <translation>Plattenbreite</translation>
    </message>
    <message>
        <source>Along its Y axis</source>
        <translation>Entlang ihrer Y-Achse</translation>
    </message>
    <message>
        <source>Plate thickness</source>
        <translation>Plattendicke</translation>
    </message>
    <message>
        <source>From its lower to its upper face</source>
        <translation>Von ihrer Unter- bis zu ihrer Oberseite</translation>
    </message>
    <message>
        <source>Vise</source>
        <translation>Schraubstock</translation>
    </message>
    <message>
        <source>Closes on the clicked side of the stock and the opposite one</source>
        <translation>Spannt die angeklickte Seite des Rohteils und die gegenüberliegende</translation>
    </message>
    <message>
        <source>Step clamp</source>
        <translation>Spanneisen</translation>
    </message>
    <message>
        <source>A bar with stud and step block that presses on the top of the stock</source>
        <translation>Ein Spanneisen mit Stiftschraube und Treppenbock, das auf die Oberseite des Rohteils drückt</translation>
    </message>
    <message>
        <source>Toe clamp</source>
        <translation>Niederzugspanner</translation>
    </message>
    <message>
        <source>Presses on a side of the stock and leaves its top free</source>
        <translation>Drückt auf eine Seite des Rohteils und lässt seine Oberseite frei</translation>
    </message>
    <message>
        <source>Hexagon screw</source>
        <translation>Sechskantschraube</translation>
    </message>
    <message>
        <source>A screw through the stock with hexagon head and washer</source>
        <translation>Eine Schraube durch das Rohteil mit Sechskantkopf und Scheibe</translation>
    </message>
    <message>
        <source>Socket screw</source>
        <translation>Zylinderschraube</translation>
    </message>
    <message>
        <source>A screw through the stock with socket head and washer</source>
        <translation>Eine Schraube durch das Rohteil mit Innensechskant und Scheibe</translation>
    </message>
    <message>
        <source>Two bars below the stock</source>
        <translation>Zwei Leisten unter dem Rohteil</translation>
    </message>
    <message>
        <source>A plate below the stock; its top is the table for clamps that are placed later</source>
        <translation>Eine Platte unter dem Rohteil; ihre Oberseite ist der Tisch für Spannmittel, die später platziert werden</translation>
    </message>
    <message>
        <source>Rear overhang</source>
        <translation>Überstand hinten</translation>
    </message>
    <message>
        <source>How far the body and the screw of the vise extend behind the movable jaw</source>
        <translation>Wie weit Körper und Spindel des Schraubstocks hinter der beweglichen Backe vorstehen</translation>
    </message>
    <message>
        <source>From the clamping point to the axis of the stud</source>
        <translation>Vom Spannpunkt bis zur Achse der Stiftschraube</translation>
    </message>
    <message>
        <source>Width across flats; the tool keeps clear of the width across corners, in any position of the nut</source>
        <translation>Schlüsselweite; das Werkzeug hält Abstand vom Eckenmaß, in jeder Stellung der Mutter</translation>
    </message>
    <message>
        <source>How far the nose extends from the body</source>
        <translation>Wie weit die Nase aus dem Körper vorsteht</translation>
    </message>
    <message>
        <source>Width across flats; the tool keeps clear of the width across corners, in any position of the head</source>
        <translation>Schlüsselweite; das Werkzeug hält Abstand vom Eckenmaß, in jeder Stellung des Kopfes</translation>
    </message>
    <message>
        <source>Parallels (pair)</source>
        <translation>Parallelunterlagen (Paar)</translation>
    </message>
    <message>
        <source>Base plate</source>
        <translation>Grundplatte</translation>
    </message>
</context>
<context>
    <name>FixtureLabels</name>
    <message>
        <source>“%1” is %2 deep in the stock; change its position or size.</source>
        <translation>„%1“ steckt %2 tief im Rohteil; ändern Sie Lage oder Maße.</translation>
    </message>
    <message>
        <source>There is no stock where “%1” clamps; change its position or size.</source>
        <translation>Wo „%1“ spannt, ist kein Rohteil; ändern Sie Lage oder Maße.</translation>
    </message>
    <message>
        <source>“%1” doesn&apos;t touch the stock: a gap of %2 remains.</source>
        <translation>„%1“ berührt das Rohteil nicht: Es bleibt ein Spalt von %2.</translation>
    </message>
</context>
<context>
    <name>GuideLabels</name>
    <message>
        <source>%1 apart</source>
        <translation>Abstand %1</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Edge of the part</source>
        <translation>Kante des Teils</translation>
    </message>
    <message>
        <source>Distance from the part</source>
        <translation>Abstand vom Teil</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>Zeilenabstand</translation>
    </message>
    <message>
        <source>Lead and tilt</source>
        <translation>Vorlauf und Neigung</translation>
    </message>
</context>
<context>
    <name>HandTimeLabels</name>
    <message>
        <source>take %1</source>
        <translation>Aufnahme %1</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>Messpunkt %1</translation>
    </message>
    <message>
        <source>≈ %1 s</source>
        <translation>≈ %1 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1 ab %2</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 bis %3</translation>
    </message>
    <message>
        <source>pass %1</source>
        <translation>Durchgang %1</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>Bewegung %1</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Print one JSON object on standard output</source>
        <translation>Ein JSON-Objekt auf die Standardausgabe schreiben</translation>
    </message>
    <message>
        <source>Usage</source>
        <translation>Aufruf</translation>
    </message>
    <message>
        <source>OPTIONS</source>
        <translation>OPTIONEN</translation>
    </message>
    <message>
        <source>SUBCOMMAND</source>
        <translation>BEFEHL</translation>
    </message>
    <message>
        <source>SUBCOMMANDS</source>
        <translation>BEFEHLE</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Positionals</source>
        <translation>Argumente</translation>
    </message>
    <message>
        <source>Subcommands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>REQUIRED</source>
        <translation>ERFORDERLICH</translation>
    </message>
    <message>
        <source>Needs</source>
        <translation>Nur mit</translation>
    </message>
    <message>
        <source>Excludes</source>
        <translation>Nicht mit</translation>
    </message>
    <message>
        <source>TEXT</source>
        <translation>TEXT</translation>
    </message>
    <message>
        <source>INT</source>
        <translation>GANZZAHL</translation>
    </message>
    <message>
        <source>UINT</source>
        <translation>GANZZAHL</translation>
    </message>
    <message>
        <source>FLOAT</source>
        <translation>ZAHL</translation>
    </message>
    <message>
        <source>%1 in [%2 - %3]</source>
        <translation>%1 in [%2 - %3]</translation>
    </message>
    <message>
        <source>Burin: milling tool paths authored by hand</source>
        <translation>Burin: von Hand erstellte Werkzeugbahnen zum Fräsen</translation>
    </message>
    <message>
        <source>Print this help message and exit</source>
        <translation>Diese Hilfe anzeigen und beenden</translation>
    </message>
    <message>
        <source>Display program version information and exit</source>
        <translation>Die Version anzeigen und beenden</translation>
    </message>
    <message>
        <source>Help for all commands</source>
        <translation>Hilfe zu allen Befehlen</translation>
    </message>
    <message>
        <source>Run Burin&apos;s benchmarks</source>
        <translation>Burins Benchmarks ausführen</translation>
    </message>
    <message>
        <source>Benchmark to run (default: list the benchmarks)</source>
        <translation>Benchmark, der ausgeführt wird (Vorgabe: die Benchmarks auflisten)</translation>
    </message>
    <message>
        <source>Only figures whose names begin with this</source>
        <translation>Nur Werte, deren Namen so beginnen</translation>
    </message>
    <message>
        <source>Number of rounds in which everything is measured</source>
        <translation>Anzahl der Durchgänge, in denen alles gemessen wird</translation>
    </message>
    <message>
        <source>FORCES is CSV with one row per cut, or per sample of a cut (column cut), and the columns
  %1
and, where they are needed,
  %2.
Forces are means over whole revolutions; the axis points from tip to holder; any frame. Columns named note… are ignored.</source>
        <translation>MESSWERTE ist CSV mit einer Zeile je Schnitt oder je Messpunkt eines Schnitts (Spalte cut) und den Spalten
  %1
und, wo nötig,
  %2.
Kräfte sind Mittelwerte über ganze Umdrehungen; die Achse zeigt von der Spitze zum Halter; das Koordinatensystem ist beliebig. Spalten namens note… werden übergangen.</translation>
    </message>
    <message>
        <source>Fit K, Kr and edge forces of materials to measured forces and add them to your own library</source>
        <translation>K, Kr und Schneidenkräfte von Werkstoffen an gemessene Kräfte anpassen und in die eigene Bibliothek aufnehmen</translation>
    </message>
    <message>
        <source>Force records (.csv)</source>
        <translation>Gemessene Kräfte (.csv)</translation>
    </message>
    <message>
        <source>Only this one of the materials in the file</source>
        <translation>Nur dieser der Werkstoffe in der Datei</translation>
    </message>
    <message>
        <source>edge: K and the force of the edge, Kte and Kre; constant: K alone; kienzle: K falling with the chip&apos;s thickness</source>
        <translation>edge: K und die Kraft der Schneide, Kte und Kre; constant: nur K; kienzle: K, das mit der Spandicke fällt</translation>
    </message>
    <message>
        <source>teeth: resolved for rotating teeth, for forces of a dynamometer; paper: tangential against the feed, radial along the axis, for the force that the hand feels</source>
        <translation>teeth: aufgelöst für umlaufende Zähne, für Kräfte eines Dynamometers; paper: tangential gegen den Vorschub, radial entlang der Achse, für die Kraft, die die Hand fühlt</translation>
    </message>
    <message>
        <source>The measured forces act on the workpiece, not on the tool</source>
        <translation>Die gemessenen Kräfte wirken auf das Werkstück, nicht auf das Werkzeug</translation>
    </message>
    <message>
        <source>Material from which a new one takes its other values</source>
        <translation>Werkstoff, von dem ein neuer seine übrigen Werte übernimmt</translation>
    </message>
    <message>
        <source>Replace a material of that name</source>
        <translation>Einen Werkstoff dieses Namens ersetzen</translation>
    </message>
    <message>
        <source>Fit and report, but write nothing</source>
        <translation>Anpassen und berichten, aber nichts schreiben</translation>
    </message>
    <message>
        <source>Do the whole job on the sample part with a virtual operator</source>
        <translation>Den ganzen Auftrag am Beispielteil mit einem virtuellen Bediener ausführen</translation>
    </message>
    <message>
        <source>Mill the block of the paper&apos;s figure 13 (b) instead</source>
        <translation>Stattdessen den Block aus Bild 13 (b) des Fachartikels fräsen</translation>
    </message>
    <message>
        <source>Tool (ball-6; ball-1 with --block)</source>
        <translation>Werkzeug (ball-6; mit --block ball-1)</translation>
    </message>
    <message>
        <source>Edge of a voxel, mm (0.5; 0.1 with --block)</source>
        <translation>Kante eines Voxels, mm (0.5; mit --block 0.1)</translation>
    </message>
    <message>
        <source>Time limit of the operator, s; 0: none</source>
        <translation>Zeitgrenze des Bedieners, s; 0: keine</translation>
    </message>
    <message>
        <source>Stock around the part, mm</source>
        <translation>Zugabe um das Teil, mm</translation>
    </message>
    <message>
        <source>Material of the stock</source>
        <translation>Werkstoff des Rohteils</translation>
    </message>
    <message>
        <source>Seed of the operator&apos;s random tremor</source>
        <translation>Startwert für das zufällige Zittern des Bedieners</translation>
    </message>
    <message>
        <source>Folder for project, program, picture and report</source>
        <translation>Ordner für Projekt, Programm, Bild und Bericht</translation>
    </message>
    <message>
        <source>List the styluses that are plugged in, and their limits</source>
        <translation>Die angeschlossenen Stifte und ihre Grenzwerte auflisten</translation>
    </message>
    <message>
        <source>Embed a CAD model in stock and make a project</source>
        <translation>Ein CAD-Modell in ein Rohteil einbetten und ein Projekt anlegen</translation>
    </message>
    <message>
        <source>Project file to write (.burin)</source>
        <translation>Projektdatei, die geschrieben wird (.burin)</translation>
    </message>
    <message>
        <source>Replace a project that holds recordings</source>
        <translation>Ein Projekt ersetzen, das Aufzeichnungen enthält</translation>
    </message>
    <message>
        <source>Make the project even if bodies are too small for the voxels to be protected</source>
        <translation>Das Projekt auch anlegen, wenn Körper zu klein sind, um mit diesen Voxeln geschützt zu werden</translation>
    </message>
    <message>
        <source>Edge of a voxel, mm</source>
        <translation>Kante eines Voxels, mm</translation>
    </message>
    <message>
        <source>Stock around the part on every side, mm</source>
        <translation>Zugabe um das Teil auf jeder Seite, mm</translation>
    </message>
    <message>
        <source>Read a CAD model and report its contents</source>
        <translation>Ein CAD-Modell lesen und über seinen Inhalt berichten</translation>
    </message>
    <message>
        <source>Chord of the mesh, mm</source>
        <translation>Sehnenfehler des Netzes, mm</translation>
    </message>
    <message>
        <source>Limit of the import&apos;s processor time, s; its elapsed time may be ten times as long</source>
        <translation>Grenze der Rechenzeit des Imports, s; er darf insgesamt zehnmal so lange dauern</translation>
    </message>
    <message>
        <source>Memory limit of the import, MB</source>
        <translation>Speichergrenze des Imports, MB</translation>
    </message>
    <message>
        <source>Report the contents of a project</source>
        <translation>Über den Inhalt eines Projekts berichten</translation>
    </message>
    <message>
        <source>Project file (.burin)</source>
        <translation>Projektdatei (.burin)</translation>
    </message>
    <message>
        <source>List and show machines; copy, add and delete your own. The machines that Burin is shipped with have typical values of their class: copy one and enter those of your machine</source>
        <translation>Maschinen auflisten und anzeigen; eigene kopieren, hinzufügen und löschen. Die mitgelieferten Maschinen haben typische Werte ihrer Klasse: Kopieren Sie eine und geben Sie die Werte Ihrer Maschine ein</translation>
    </message>
    <message>
        <source>List all machines with their names; typical: shipped with Burin</source>
        <translation>Alle Maschinen mit ihren Namen auflisten; typisch: mitgeliefert</translation>
    </message>
    <message>
        <source>Replace your machine of this ID</source>
        <translation>Die eigene Maschine dieser Kennung ersetzen</translation>
    </message>
    <message>
        <source>Print the file of a machine (JSON), in the form that add reads</source>
        <translation>Die Datei einer Maschine (JSON) ausgeben, so wie add sie liest</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Add a machine to your own; every value is checked</source>
        <translation>Den eigenen Maschinen eine hinzufügen; jeder Wert wird geprüft</translation>
    </message>
    <message>
        <source>Machine file (JSON)</source>
        <translation>Maschinendatei (JSON)</translation>
    </message>
    <message>
        <source>Copy a machine to one of your own</source>
        <translation>Eine Maschine als eigene kopieren</translation>
    </message>
    <message>
        <source>Machine to copy</source>
        <translation>Maschine, die kopiert wird</translation>
    </message>
    <message>
        <source>ID of the copy: letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>Kennung der Kopie: Buchstaben, Ziffern, „-“, „_“ und „.“</translation>
    </message>
    <message>
        <source>Name of the copy (default: its ID)</source>
        <translation>Name der Kopie (Vorgabe: ihre Kennung)</translation>
    </message>
    <message>
        <source>Delete one of your own machines</source>
        <translation>Eine der eigenen Maschinen löschen</translation>
    </message>
    <message>
        <source>Mill a project&apos;s workpiece with a stylus and record it</source>
        <translation>Das Werkstück eines Projekts mit einem Stift fräsen und dies aufzeichnen</translation>
    </message>
    <message>
        <source>Seed of the operator&apos;s random tremor and motion</source>
        <translation>Startwert für das zufällige Zittern und die Bewegung des Bedieners</translation>
    </message>
    <message>
        <source>Firmness of the operator&apos;s grip on the stylus</source>
        <translation>Festigkeit, mit der der Bediener den Stift hält</translation>
    </message>
    <message>
        <source>Kind of strokes that the operator makes</source>
        <translation>Art der Züge, die der Bediener macht</translation>
    </message>
    <message>
        <source>Stylus: operator, trace:FILE or device:NAME</source>
        <translation>Stift: operator, trace:DATEI oder device:NAME</translation>
    </message>
    <message>
        <source>One of a device&apos;s modes, as &quot;burin devices&quot; lists them</source>
        <translation>Eine der Betriebsarten eines Geräts, die „burin devices“ auflistet</translation>
    </message>
    <message>
        <source>Rate of the haptic loop, Hz; a device with its own clock sets its own rate</source>
        <translation>Rate der Haptikschleife, Hz; ein Gerät mit eigenem Takt gibt seine Rate vor</translation>
    </message>
    <message>
        <source>Forces only while this button of the device is held, counted from 1; 0: always</source>
        <translation>Kräfte nur, während dieser Knopf des Geräts gedrückt ist, gezählt ab 1; 0: immer</translation>
    </message>
    <message>
        <source>Also write the motion of the trace or device to this file, which --stylus trace:FILE replays</source>
        <translation>Die Bewegung der Spur oder des Geräts auch in diese Datei schreiben, die --stylus trace:DATEI abspielt</translation>
    </message>
    <message>
        <source>Mill even if bodies are too small for the voxels to be protected, and accept that the operator reaches nothing</source>
        <translation>Auch fräsen, wenn Körper zu klein sind, um mit diesen Voxeln geschützt zu werden, und hinnehmen, dass der Bediener nichts erreicht</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Machine, for its spindle speed and travel (default: the project&apos;s)</source>
        <translation>Maschine, wegen Drehzahl und Verfahrweg (Vorgabe: die des Projekts)</translation>
    </message>
    <message>
        <source>Run in real time</source>
        <translation>In Echtzeit ablaufen</translation>
    </message>
    <message>
        <source>Run as fast as the computer can (the default)</source>
        <translation>So schnell ablaufen, wie der Rechner kann (Vorgabe)</translation>
    </message>
    <message>
        <source>Length of the session, s; 0: as long as the job takes</source>
        <translation>Dauer der Sitzung, s; 0: so lange, wie der Auftrag braucht</translation>
    </message>
    <message>
        <source>Stock to leave on the part, mm; the operator roughs with it (0.5)</source>
        <translation>Aufmaß auf dem Teil, mm; der Bediener schruppt damit (0.5)</translation>
    </message>
    <message>
        <source>Depth to which the operator presses into the part when finishing, mm</source>
        <translation>Tiefe, bis zu der der Bediener beim Schlichten ins Teil drückt, mm</translation>
    </message>
    <message>
        <source>Distance between finishing passes, mm; 0: chosen for the tool</source>
        <translation>Abstand der Schlichtzeilen, mm; 0: passend zum Werkzeug</translation>
    </message>
    <message>
        <source>List, make, edit and export paths</source>
        <translation>Bahnen auflisten, erstellen, bearbeiten und exportieren</translation>
    </message>
    <message>
        <source>Number of the path</source>
        <translation>Nummer der Bahn</translation>
    </message>
    <message>
        <source>List the paths and their edits</source>
        <translation>Die Bahnen und ihre Bearbeitungen auflisten</translation>
    </message>
    <message>
        <source>Takes in order, all of one tool (default: all takes of the last tool that milled)</source>
        <translation>Aufnahmen in ihrer Reihenfolge, alle von einem Werkzeug (Vorgabe: alle Aufnahmen des Werkzeugs, das zuletzt fräste)</translation>
    </message>
    <message>
        <source>Evaluate a path and report what each edit did</source>
        <translation>Eine Bahn auswerten und die Wirkung jeder Bearbeitung berichten</translation>
    </message>
    <message>
        <source>Write the points as CSV</source>
        <translation>Die Punkte als CSV schreiben</translation>
    </message>
    <message>
        <source>The same as --output</source>
        <translation>Dasselbe wie --output</translation>
    </message>
    <message>
        <source>Machine (default: the project&apos;s)</source>
        <translation>Maschine (Vorgabe: die des Projekts)</translation>
    </message>
    <message>
        <source>The edit as JSON, as &quot;burin path P list --json&quot; shows them</source>
        <translation>Die Bearbeitung als JSON, wie „burin path P list --json“ sie anzeigt</translation>
    </message>
    <message>
        <source>Position in the list of edits, from 0</source>
        <translation>Position in der Liste der Bearbeitungen, ab 0</translation>
    </message>
    <message>
        <source>Delete an edit from a path</source>
        <translation>Eine Bearbeitung aus einer Bahn löschen</translation>
    </message>
    <message>
        <source>Position of the edit in the list, from 0</source>
        <translation>Position der Bearbeitung in der Liste, ab 0</translation>
    </message>
    <message>
        <source>Bring an edit of an earlier version up to date</source>
        <translation>Eine Bearbeitung einer früheren Version aktualisieren</translation>
    </message>
    <message>
        <source>Write the stylus motion of a take as a trace that &quot;burin mill&quot; replays</source>
        <translation>Die Bewegung des Stifts in einer Aufnahme als Spur schreiben, die „burin mill“ abspielt</translation>
    </message>
    <message>
        <source>Write a take as CSV</source>
        <translation>Eine Aufnahme als CSV schreiben</translation>
    </message>
    <message>
        <source>Number of the take</source>
        <translation>Nummer der Aufnahme</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>Datei, die geschrieben wird</translation>
    </message>
    <message>
        <source>Draw a project&apos;s workpiece as its takes left it</source>
        <translation>Das Werkstück eines Projekts zeichnen, wie es nach den Aufnahmen ist</translation>
    </message>
    <message>
        <source>Picture to write (.png)</source>
        <translation>Bild, das geschrieben wird (.png)</translation>
    </message>
    <message>
        <source>Paths to draw, the first in the colours of its moves</source>
        <translation>Bahnen, die gezeichnet werden, die erste in den Farben ihrer Bewegungen</translation>
    </message>
    <message>
        <source>Write a path as a program, once the program passes its check</source>
        <translation>Eine Bahn als Programm schreiben, sobald es die Prüfung besteht</translation>
    </message>
    <message>
        <source>Program to write</source>
        <translation>Programm, das geschrieben wird</translation>
    </message>
    <message>
        <source>Units of the program: mm (G21) or inch (G20) (default: the project&apos;s)</source>
        <translation>Einheit des Programms: mm (G21) oder inch (G20) (Vorgabe: die des Projekts)</translation>
    </message>
    <message>
        <source>Dialect of the control (default: the project&apos;s, or the machine&apos;s)</source>
        <translation>Dialekt der Steuerung (Vorgabe: der des Projekts oder der Maschine)</translation>
    </message>
    <message>
        <source>Paths of the program, which may have different tools (default: the first path of each tool that milled)</source>
        <translation>Bahnen des Programms, auch mit verschiedenen Werkzeugen (Vorgabe: die erste Bahn jedes Werkzeugs, das gefräst hat)</translation>
    </message>
    <message>
        <source>Deepest gouge that passes, mm</source>
        <translation>Tiefste Konturverletzung, die noch zugelassen wird, mm</translation>
    </message>
    <message>
        <source>Restart after a broken tool: line of the program that was posted last; the lines before it are done. Writes the rest, which leads back into the cut and is checked on the stock that is left</source>
        <translation>Neubeginn nach einem Werkzeugbruch: Zeile des zuletzt ausgegebenen Programms; die Zeilen davor sind erledigt. Schreibt den Rest, der in den Schnitt zurückführt und am verbliebenen Material geprüft wird</translation>
    </message>
    <message>
        <source>With --from: the interrupted program (default: the one that the project posted last)</source>
        <translation>Mit --from: das unterbrochene Programm (Vorgabe: das zuletzt vom Projekt ausgegebene)</translation>
    </message>
    <message>
        <source>Write the program even if its check refuses it; states this reason in its header</source>
        <translation>Das Programm auch schreiben, wenn die Prüfung es ablehnt; dieser Grund steht dann in seinem Kopf</translation>
    </message>
    <message>
        <source>Name of a fixture or keep-out volume to delete; may be repeated</source>
        <translation>Name einer Vorrichtung oder eines Sperrraums zum Löschen; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Name of a fixture or keep-out volume to switch off; it stays in the project; may be repeated</source>
        <translation>Name einer Vorrichtung oder eines Sperrraums zum Ausschalten; bleibt im Projekt; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Name of a fixture or keep-out volume to switch on again; may be repeated</source>
        <translation>Name einer Vorrichtung oder eines Sperrraums zum Wiedereinschalten; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Machine of its programs</source>
        <translation>Maschine seiner Programme</translation>
    </message>
    <message>
        <source>Dialect of its programs (default: the machine&apos;s)</source>
        <translation>Dialekt seiner Programme (Vorgabe: der der Maschine)</translation>
    </message>
    <message>
        <source>Units of its programs: mm or inch</source>
        <translation>Einheit seiner Programme: mm oder inch</translation>
    </message>
    <message>
        <source>Re-simulate a program on a project&apos;s setup and judge it</source>
        <translation>Ein Programm in der Aufspannung eines Projekts nachfräsen und beurteilen</translation>
    </message>
    <message>
        <source>NC program</source>
        <translation>NC-Programm</translation>
    </message>
    <message>
        <source>Tool of the whole program (default: the project&apos;s tools by their numbers, or the tool of the first take)</source>
        <translation>Werkzeug des ganzen Programms (Vorgabe: die Werkzeuge des Projekts nach ihren Nummern oder das Werkzeug der ersten Aufnahme)</translation>
    </message>
    <message>
        <source>Dialect of the program (default: the project&apos;s, or the machine&apos;s)</source>
        <translation>Dialekt des Programms (Vorgabe: der des Projekts oder der Maschine)</translation>
    </message>
    <message>
        <source>Largest allowed difference between the stock left on the part and what the project&apos;s paths leave, and largest excess at blended corners, mm; 0: not judged (default: 0.1, and the project&apos;s paths count only for programs that Burin posted)</source>
        <translation>Größter zulässiger Unterschied zwischen dem verbleibenden Aufmaß und dem, was die Bahnen des Projekts stehen lassen, und größtes Aufmaß an verschliffenen Ecken, mm; 0: wird nicht beurteilt (Vorgabe: 0.1, und die Bahnen des Projekts zählen nur bei Programmen, die Burin ausgegeben hat)</translation>
    </message>
    <message>
        <source>Number of worst points that are judged on exact geometry</source>
        <translation>Anzahl der schlechtesten Punkte, die auf der genauen Geometrie beurteilt werden</translation>
    </message>
    <message>
        <source>Write the deviation map as a VTK file (.vtp), in the colours of the window</source>
        <translation>Die Abweichungskarte als VTK-Datei (.vtp) schreiben, in den Farben des Fensters</translation>
    </message>
    <message>
        <source>View direction of the picture</source>
        <translation>Blickrichtung des Bildes</translation>
    </message>
    <message>
        <source>Section plane: X=, Y= or Z= and its position, mm; the side towards the viewer is hidden</source>
        <translation>Schnittebene: X=, Y= oder Z= und ihre Position, mm; die Seite zum Betrachter hin wird ausgeblendet</translation>
    </message>
    <message>
        <source>Transparency of the workpiece, %; shows the part inside it</source>
        <translation>Durchsichtigkeit des Werkstücks, %; zeigt das Teil darin</translation>
    </message>
    <message>
        <source>Tool axis: fixed (+Z), X,Y,Z towards the holder (3+2), or free (it follows the stylus)</source>
        <translation>Werkzeugachse: fixed (+Z), X,Y,Z zum Halter hin (3+2) oder free (sie folgt dem Stift)</translation>
    </message>
    <message>
        <source>Clearance between the tool and the added fixtures and keep-out volumes, mm</source>
        <translation>Abstand zwischen dem Werkzeug und den hinzugefügten Vorrichtungen und Sperrräumen, mm</translation>
    </message>
    <message>
        <source>Position of program zero in the machine&apos;s travel: X,Y,Z of the tip from its low end, mm; middle (of X and Y, Z up to the tool change height); or off</source>
        <translation>Lage des Programmnullpunkts im Verfahrweg der Maschine: X,Y,Z der Spitze von dessen unterem Ende, mm; middle (Mitte von X und Y, Z bis zur Werkzeugwechselhöhe) oder off</translation>
    </message>
    <message>
        <source>List and show materials; copy, add and delete your own. Every value states its source or that it is an estimate</source>
        <translation>Werkstoffe auflisten und zeigen; eigene kopieren, hinzufügen und löschen. Jeder Wert nennt seine Quelle oder dass er geschätzt ist</translation>
    </message>
    <message>
        <source>List all materials with their specific cutting energies</source>
        <translation>Alle Werkstoffe mit ihrer spezifischen Schnittenergie auflisten</translation>
    </message>
    <message>
        <source>Print the file of a material (JSON), in the form that add reads</source>
        <translation>Die Datei eines Werkstoffs ausgeben (JSON), in der Form, die add liest</translation>
    </message>
    <message>
        <source>Add a material to your own; what a card lacks is filled with estimates and told</source>
        <translation>Einen Werkstoff zu den eigenen hinzufügen; was einer Karte fehlt, wird geschätzt und gemeldet</translation>
    </message>
    <message>
        <source>Material file (JSON), or material card of FreeCAD (.FCMat)</source>
        <translation>Werkstoffdatei (JSON) oder Werkstoffkarte von FreeCAD (.FCMat)</translation>
    </message>
    <message>
        <source>Copy a material to one of your own</source>
        <translation>Einen Werkstoff in einen eigenen kopieren</translation>
    </message>
    <message>
        <source>Material to copy</source>
        <translation>Zu kopierender Werkstoff</translation>
    </message>
    <message>
        <source>Delete one of your own materials</source>
        <translation>Einen der eigenen Werkstoffe löschen</translation>
    </message>
    <message>
        <source>Replace a material that has this ID already</source>
        <translation>Einen Werkstoff ersetzen, der diese ID schon hat</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>File to write: .srle (volume file), .nrrd with a table beside it, .stl, .ply or .3mf (surface)</source>
        <translation>Zu schreibende Datei: .srle (Volumendatei), .nrrd mit einer Tabelle daneben, .stl, .ply oder .3mf (Oberfläche)</translation>
    </message>
    <message>
        <source>Axis that the runs lie along: x, y or z</source>
        <translation>Achse, entlang der die Läufe liegen: x, y oder z</translation>
    </message>
    <message>
        <source>The stock before anything was milled</source>
        <translation>Das Rohteil, bevor etwas gefräst wurde</translation>
    </message>
    <message>
        <source>Volume file, or voxel array</source>
        <translation>Volumendatei oder Voxelfeld</translation>
    </message>
    <message>
        <source>Table of the materials that the values of a voxel array mean (JSON)</source>
        <translation>Tabelle der Werkstoffe, die die Werte eines Voxelfeldes bedeuten (JSON)</translation>
    </message>
    <message>
        <source>Convert, combine and measure volumes of voxels; export the workpiece</source>
        <translation>Voxelvolumen umwandeln, verknüpfen und messen; das Werkstück exportieren</translation>
    </message>
    <message>
        <source>Volume file, or voxel array (NRRD, or raw with a header in JSON)</source>
        <translation>Volumendatei oder Voxelfeld (NRRD oder Rohdaten mit einem Kopf in JSON)</translation>
    </message>
    <message>
        <source>Write a volume in another form</source>
        <translation>Ein Volumen in einer anderen Form schreiben</translation>
    </message>
    <message>
        <source>What belongs to one volume or the other</source>
        <translation>Was zum einen oder zum anderen Volumen gehört</translation>
    </message>
    <message>
        <source>What belongs to both volumes</source>
        <translation>Was zu beiden Volumen gehört</translation>
    </message>
    <message>
        <source>What belongs to the first volume alone</source>
        <translation>Was allein zum ersten Volumen gehört</translation>
    </message>
    <message>
        <source>The voxels that have an empty neighbour</source>
        <translation>Die Voxel, die einen leeren Nachbarn haben</translation>
    </message>
    <message>
        <source>The same volume with its runs along another axis</source>
        <translation>Dasselbe Volumen mit Läufen entlang einer anderen Achse</translation>
    </message>
    <message>
        <source>The workpiece of a project, as its takes left it</source>
        <translation>Das Werkstück eines Projekts, wie seine Aufnahmen es hinterlassen haben</translation>
    </message>
    <message>
        <source>Volume, mass, centre and inertia of each material</source>
        <translation>Volumen, Masse, Schwerpunkt und Trägheit jedes Werkstoffs</translation>
    </message>
    <message>
        <source>Whether two volumes share space, touch or are apart</source>
        <translation>Ob zwei Volumen sich überschneiden, berühren oder getrennt sind</translation>
    </message>
    <message>
        <source>Box of the stock whatever the part: X0,Y0,Z0,X1,Y1,Z1, mm</source>
        <translation>Quader des Rohteils unabhängig vom Teil: X0,Y0,Z0,X1,Y1,Z1, mm</translation>
    </message>
    <message>
        <source>Round stock whatever the part: X,Y,Z,AX,AY,AZ,RADIUS,HEIGHT, mm</source>
        <translation>Rundes Rohteil unabhängig vom Teil: X,Y,Z,AX,AY,AZ,RADIUS,HÖHE, mm</translation>
    </message>
    <message>
        <source>Axis of a cylinder around the part: x, y, z, or X,Y,Z</source>
        <translation>Achse eines Zylinders um das Teil: x, y, z oder X,Y,Z</translation>
    </message>
    <message>
        <source>Layer of the stock: NAME=MATERIAL,AXIS,FROM,TO, mm; a later one has the place; may be repeated</source>
        <translation>Schicht des Rohteils: NAME=WERKSTOFF,ACHSE,VON,BIS, mm; eine spätere hat Vorrang; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Value of a layer that changes: LAYER:VALUE=FORMULA of X, Y and Z, mm; may be repeated</source>
        <translation>Wert einer Schicht, der sich ändert: SCHICHT:WERT=FORMEL aus X, Y und Z, mm; darf wiederholt werden</translation>
    </message>
    <message>
        <source>The same by a table: LAYER:VALUE=AXIS:POSITION,VALUE;POSITION,VALUE…; may be repeated</source>
        <translation>Dasselbe durch eine Tabelle: SCHICHT:WERT=ACHSE:POSITION,WERT;POSITION,WERT…; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Bands that the values of a graded layer are sorted into</source>
        <translation>Stufen, in die die Werte einer abgestuften Schicht eingeteilt werden</translation>
    </message>
    <message>
        <source>No part is needed: nothing pushes the tool back</source>
        <translation>Ein Teil ist nicht nötig: Nichts hält das Werkzeug zurück</translation>
    </message>
    <message>
        <source>Shape of the stock: box, cylinder, solids or file</source>
        <translation>Form des Rohteils: box, cylinder, solids oder file</translation>
    </message>
    <message>
        <source>Stock as a file has it: a volume file (.srle), a voxel array (NRRD, or raw data with a JSON header), or a model whose solids are of --material</source>
        <translation>Rohteil, wie eine Datei es enthält: eine Volumendatei (.srle), ein Voxelfeld (NRRD, oder Rohdaten mit JSON-Kopf) oder ein Modell, dessen Körper aus --material sind</translation>
    </message>
    <message>
        <source>JSON table of the materials that the values of a voxel array mean</source>
        <translation>JSON-Tabelle der Werkstoffe, die die Werte eines Voxelfelds bedeuten</translation>
    </message>
    <message>
        <source>Make a tool of models of its flutes and its shank: what they sweep while the spindle turns. Axis +Z through the origin, towards the holder</source>
        <translation>Macht ein Werkzeug aus Modellen seiner Schneiden und seines Schafts: was sie überstreichen, während die Spindel dreht. Achse +Z durch den Ursprung, zum Halter hin</translation>
    </message>
    <message>
        <source>ID of the new tool</source>
        <translation>ID des neuen Werkzeugs</translation>
    </message>
    <message>
        <source>The same of the shank (default: the shank of --like)</source>
        <translation>Dasselbe für den Schaft (ohne: der Schaft von --like)</translation>
    </message>
    <message>
        <source>Tool from which the new one takes number, teeth, limits and holder</source>
        <translation>Werkzeug, von dem das neue Nummer, Zähne, Grenzen und Halter übernimmt</translation>
    </message>
    <message>
        <source>Name of the tool (default: its ID)</source>
        <translation>Name des Werkzeugs (ohne: seine ID)</translation>
    </message>
    <message>
        <source>T word (default: that of --like)</source>
        <translation>T-Wort (ohne: das von --like)</translation>
    </message>
    <message>
        <source>Distance of the profile from what the flutes sweep, mm, at most; more where 48 lines don&apos;t do</source>
        <translation>Größter Abstand des Profils von dem, was die Schneiden überstreichen, mm; mehr, wo 48 Linien nicht reichen</translation>
    </message>
    <message>
        <source>Replace your tool of this ID</source>
        <translation>Ersetzt Ihr Werkzeug dieser ID</translation>
    </message>
    <message>
        <source>List all tools with their numbers and diameters</source>
        <translation>Alle Werkzeuge mit Nummer und Durchmesser auflisten</translation>
    </message>
    <message>
        <source>Print the file of a tool (JSON), in the form that add reads</source>
        <translation>Die Datei eines Werkzeugs ausgeben (JSON), in der Form, die add liest</translation>
    </message>
    <message>
        <source>Add a tool to your own; every value is checked</source>
        <translation>Fügt ein Werkzeug Ihren eigenen hinzu; jeder Wert wird geprüft</translation>
    </message>
    <message>
        <source>Copy a tool to one of your own</source>
        <translation>Kopiert ein Werkzeug in ein eigenes</translation>
    </message>
    <message>
        <source>Tool to copy</source>
        <translation>Werkzeug, das kopiert wird</translation>
    </message>
    <message>
        <source>Delete one of your own tools</source>
        <translation>Löscht eines Ihrer eigenen Werkzeuge</translation>
    </message>
    <message>
        <source>Unit of the machine that reads the table</source>
        <translation>Einheit der Maschine, die die Tabelle liest</translation>
    </message>
    <message>
        <source>Tool file (JSON), or a FreeCAD tool bit (*.fctb)</source>
        <translation>Werkzeugdatei (JSON) oder ein Werkzeug-Bit von FreeCAD (*.fctb)</translation>
    </message>
    <message>
        <source>Number or name of the setup to work in (default: the first)</source>
        <translation>Nummer oder Name der Aufspannung, in der gearbeitet wird (Vorgabe: die erste)</translation>
    </message>
    <message>
        <source>Another part: STEP, IGES, BREP, or a mesh</source>
        <translation>Ein anderes Teil: STEP, IGES, BREP oder ein Netz</translation>
    </message>
    <message>
        <source>STEP, IGES, BREP, STL, 3MF, OBJ, PLY, AMF or OFF file; with --free-carving it may be left out</source>
        <translation>Datei im Format STEP, IGES, BREP, STL, 3MF, OBJ, PLY, AMF oder OFF; mit --free-carving kann sie fehlen</translation>
    </message>
    <message>
        <source>Mirror the part across x, y or z first. It is then another part than the one in the file</source>
        <translation>Das Teil zuerst an x, y oder z spiegeln. Es ist dann ein anderes Teil als das der Datei</translation>
    </message>
    <message>
        <source>Millimetres per unit of a file that states none (STL, OBJ, PLY, OFF)</source>
        <translation>Millimeter je Einheit einer Datei, die keine angibt (STL, OBJ, PLY, OFF)</translation>
    </message>
    <message>
        <source>STEP, IGES, BREP, STL, 3MF, OBJ, PLY, AMF or OFF file</source>
        <translation>Datei im Format STEP, IGES, BREP, STL, 3MF, OBJ, PLY, AMF oder OFF</translation>
    </message>
    <message>
        <source>Show and change the setups of a project: placement of the part, fixtures, keep-out volumes, tool axis, machine and travel</source>
        <translation>Die Aufspannungen eines Projekts zeigen und ändern: Lage des Teils, Spannmittel, Sperrvolumen, Werkzeugachse, Maschine und Verfahrweg</translation>
    </message>
    <message>
        <source>STEP, IGES, BREP or mesh file of the flutes, closed</source>
        <translation>STEP-, IGES-, BREP- oder Netzdatei der Schneiden, geschlossen</translation>
    </message>
    <message>
        <source>Rotate the part so that a face points along an axis: X,Y,Z=AXIS with a point on the face in mm and x, -x, y, -y, z or -z (down). For a cylinder or cone its axis is used; may be repeated</source>
        <translation>Das Teil so drehen, dass eine Fläche entlang einer Achse zeigt: X,Y,Z=ACHSE mit einem Punkt auf der Fläche in mm und x, -x, y, -y, z oder -z (nach unten). Bei Zylinder und Kegel gilt die Achse; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Rotate the part about the centre of its bounding box: AXIS:DEGREES with x, y, z or X,Y,Z; after --align; may be repeated</source>
        <translation>Das Teil um die Mitte seiner Hülle drehen: ACHSE:GRAD mit x, y, z oder X,Y,Z; nach --align; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Move the part by X,Y,Z mm, after --turn</source>
        <translation>Das Teil um X,Y,Z mm verschieben, nach --turn</translation>
    </message>
    <message>
        <source>Add a setup of this name. --align, --turn and --move place the part in it, relative to the setup before; its stock is the workpiece of that setup</source>
        <translation>Eine Aufspannung dieses Namens hinzufügen. --align, --turn und --move setzen die Lage des Teils darin, bezogen auf die vorige; ihr Rohteil ist das Werkstück der vorigen</translation>
    </message>
    <message>
        <source>Number or name of the setup that precedes the new one (default: --setup)</source>
        <translation>Nummer oder Name der Aufspannung, die der neuen vorangeht (Vorgabe: --setup)</translation>
    </message>
    <message>
        <source>Give the new setup a new stock with the same margins</source>
        <translation>Der neuen Aufspannung ein neues Rohteil mit denselben Aufmaßen geben</translation>
    </message>
    <message>
        <source>Update the stock from the setup that it comes from</source>
        <translation>Das Rohteil aus der Aufspannung aktualisieren, aus der es stammt</translation>
    </message>
    <message>
        <source>Name of the setup</source>
        <translation>Name der Aufspannung</translation>
    </message>
    <message>
        <source>Number or name of a setup to delete; only one without recordings, paths and programs</source>
        <translation>Nummer oder Name einer Aufspannung, die gelöscht wird; nur eine ohne Aufnahmen, Bahnen und Programme</translation>
    </message>
    <message>
        <source>Model of a fixture in the setup&apos;s frame (STEP, IGES, BREP, or a mesh); may be repeated</source>
        <translation>Modell eines Spannmittels in den Koordinaten der Aufspannung (STEP, IGES, BREP oder ein Netz); darf wiederholt werden</translation>
    </message>
    <message>
        <source>Box that the tool must not enter, X0,Y0,Z0,X1,Y1,Z1 in the setup&apos;s frame, mm; may be repeated</source>
        <translation>Quader, den das Werkzeug nicht berühren darf, X0,Y0,Z0,X1,Y1,Z1 in den Koordinaten der Aufspannung, mm; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Program zero: stock:X,Y,Z or part:X,Y,Z, each low, middle or high of its bounding box (stock:low,low,high is a corner of its top face); near:X,Y,Z, the part&apos;s vertex, middle of an edge or centre of a circle that is nearest; or coordinates X,Y,Z; all in the setup&apos;s frame, mm</source>
        <translation>Nullpunkt des Programms: stock:X,Y,Z oder part:X,Y,Z, jeweils low, middle oder high des umschließenden Quaders (stock:low,low,high ist eine Ecke der Oberseite); near:X,Y,Z, der nächste Eckpunkt, die nächste Kantenmitte oder Kreismitte des Teils; oder Koordinaten X,Y,Z; alles im Koordinatensystem der Aufspannung, mm</translation>
    </message>
    <message>
        <source>Work offset that stores program zero: G54 to G59, G59.1 to G59.3, or P1 to P300 (G54.1 P or G154 P)</source>
        <translation>Nullpunktverschiebung, in der der Nullpunkt steht: G54 bis G59, G59.1 bis G59.3 oder P1 bis P300 (G54.1 P oder G154 P)</translation>
    </message>
    <message>
        <source>Write the setup sheet of a project as one HTML page: pictures, zero, stock, fixtures, tools, times and findings</source>
        <translation>Das Einrichteblatt eines Projekts als eine HTML-Seite schreiben: Bilder, Nullpunkt, Rohteil, Spannmittel, Werkzeuge, Zeiten und Befunde</translation>
    </message>
    <message>
        <source>Page to write (.html)</source>
        <translation>Zu schreibende Seite (.html)</translation>
    </message>
    <message>
        <source>Units of the page: mm or inch (default: the program&apos;s)</source>
        <translation>Einheit der Seite: mm oder inch (Vorgabe: die des Programms)</translation>
    </message>
    <message>
        <source>File to read</source>
        <translation>Zu lesende Datei</translation>
    </message>
    <message>
        <source>Tool that lends what the file does not say: holder, stick-out, limits; of a LinuxCNC table the form</source>
        <translation>Werkzeug, von dem kommt, was die Datei nicht sagt: Halter, Auskragung, Grenzen; bei einer LinuxCNC-Tabelle die Form</translation>
    </message>
    <message>
        <source>Unit of a LinuxCNC table, which states none</source>
        <translation>Einheit einer LinuxCNC-Tabelle, die keine nennt</translation>
    </message>
    <message>
        <source>Replace your own tools of these IDs</source>
        <translation>Ihre eigenen Werkzeuge mit diesen IDs ersetzen</translation>
    </message>
    <message>
        <source>List what would be added; keep nothing</source>
        <translation>Aufzählen, was hinzukäme; nichts behalten</translation>
    </message>
    <message>
        <source>Make a path from takes or of a computed pass, with the standard edits</source>
        <translation>Eine Bahn aus Aufnahmen oder einem berechneten Durchgang anlegen, mit den üblichen Bearbeitungen</translation>
    </message>
    <message>
        <source>Name of the path (default: &quot;path&quot;, or what the pass is)</source>
        <translation>Name der Bahn (Vorgabe: „path“, oder was der Durchgang ist)</translation>
    </message>
    <message>
        <source>Tool of the pass (default: the tool of the path)</source>
        <translation>Werkzeug des Durchgangs (Vorgabe: das der Bahn)</translation>
    </message>
    <message>
        <source>Stock to leave on the part, mm</source>
        <translation>Aufmaß auf dem Teil, mm</translation>
    </message>
    <message>
        <source>Instead of --step-over: height of the ridges between rows, mm</source>
        <translation>Statt --step-over: Höhe der Grate zwischen Zeilen, mm</translation>
    </message>
    <message>
        <source>Direction of parallel rows, degrees from X</source>
        <translation>Richtung paralleler Zeilen, Grad von X aus</translation>
    </message>
    <message>
        <source>Move the drawing by X,Y, mm</source>
        <translation>Die Zeichnung um X,Y verschieben, mm</translation>
    </message>
    <message>
        <source>Id of the pass, as &quot;path P list --json&quot; shows it</source>
        <translation>Nummer des Durchgangs, wie „path P list --json“ sie zeigt</translation>
    </message>
    <message>
        <source>Distance between rows or loops, or between the heights of a waterline, mm (default: 0.4 of the diameter for roughing, 1/15 for finishing)</source>
        <translation>Abstand der Zeilen oder Schleifen, oder der Höhen von Höhenlinien, mm (Vorgabe: 0,4 des Durchmessers zum Schruppen, 1/15 zum Schlichten)</translation>
    </message>
    <message>
        <source>levels: largest height of the steps left on slopes, mm (default: a tenth of the diameter)</source>
        <translation>levels: größte Höhe der Stufen, die auf Schrägen bleiben, mm (Vorgabe: ein Zehntel des Durchmessers)</translation>
    </message>
    <message>
        <source>Only where the part is at least this steep, degrees</source>
        <translation>Nur wo das Teil mindestens so steil ist, Grad</translation>
    </message>
    <message>
        <source>Only where the part is at most this steep, degrees</source>
        <translation>Nur wo das Teil höchstens so steil ist, Grad</translation>
    </message>
    <message>
        <source>Height at which the pass begins, mm (default: the top of the stock)</source>
        <translation>Höhe, in der der Durchgang beginnt, mm (Vorgabe: Oberkante des Rohteils)</translation>
    </message>
    <message>
        <source>Lowest height of the tip, mm (default: the lowest point of the part; for face its top)</source>
        <translation>Tiefste Höhe der Spitze, mm (Vorgabe: tiefster Punkt des Teils; bei face sein höchster)</translation>
    </message>
    <message>
        <source>Cut all rows in one direction</source>
        <translation>Alle Zeilen in eine Richtung fräsen</translation>
    </message>
    <message>
        <source>profile: inside the outline of --area instead of around it</source>
        <translation>profile: innen am Umriss von --area statt außen herum</translation>
    </message>
    <message>
        <source>Only rows where stock is left</source>
        <translation>Nur Zeilen, wo Rohteil übrig ist</translation>
    </message>
    <message>
        <source>Area of the pass, in the coordinates of the setup: closed curves of a DXF or SVG drawing, or a JSON file with a request as &quot;path list --json&quot; prints it</source>
        <translation>Bereich des Durchgangs, in den Koordinaten der Aufspannung: geschlossene Kurven einer DXF- oder SVG-Zeichnung, oder eine JSON-Datei mit einer Anfrage, wie „path list --json“ sie ausgibt</translation>
    </message>
    <message>
        <source>Unit of the drawing (default: the unit that it states)</source>
        <translation>Einheit der Zeichnung (Vorgabe: die angegebene)</translation>
    </message>
    <message>
        <source>Diameter of the brush of --paint, mm</source>
        <translation>Durchmesser des Pinsels von --paint, mm</translation>
    </message>
    <message>
        <source>The area limits where rows touch the part, not where the tip goes (always with --face and --paint)</source>
        <translation>Der Bereich begrenzt, wo Zeilen das Teil berühren, nicht, wo die Spitze verläuft (immer bei --face und --paint)</translation>
    </message>
    <message>
        <source>Compute the passes of a path again, as each was asked for</source>
        <translation>Die Durchgänge einer Bahn noch einmal berechnen, wie sie verlangt wurden</translation>
    </message>
    <message>
        <source>Compute it in place of the pass with this id</source>
        <translation>An der Stelle des Durchgangs mit dieser Nummer berechnen</translation>
    </message>
    <message>
        <source>Area: the face of the part at X,Y,Z, mm, within 1 mm; can be given several times</source>
        <translation>Bereich: die Fläche des Teils bei X,Y,Z, mm, auf 1 mm genau; mehrmals möglich</translation>
    </message>
    <message>
        <source>Area: painted by the strokes of these takes, as wide as --brush</source>
        <translation>Bereich: von den Zügen dieser Aufnahmen gemalt, so breit wie --brush</translation>
    </message>
    <message>
        <source>Largest depth of a level, or of a peck when drilling, mm (default: what material, tool and spindle can take; holes deeper than 3 diameters: one diameter)</source>
        <translation>Größte Tiefe einer Ebene oder beim Bohren eines Hubes, mm (Vorgabe: was Werkstoff, Werkzeug und Spindel vertragen; Bohrungen tiefer als 3 Durchmesser: ein Durchmesser)</translation>
    </message>
    <message>
        <source>profile: number of holding tabs left on each outline</source>
        <translation>profile: Anzahl der Haltestege, die an jedem Umriss bleiben</translation>
    </message>
    <message>
        <source>Width of a holding tab, mm</source>
        <translation>Breite eines Haltestegs, mm</translation>
    </message>
    <message>
        <source>Height of a holding tab above the lowest level, mm</source>
        <translation>Höhe eines Haltestegs über der untersten Ebene, mm</translation>
    </message>
    <message>
        <source>pocket, profile: cut into the inner corners of the area, so that a part with square corners fits</source>
        <translation>pocket, profile: in die Innenecken des Bereichs schneiden, damit ein Teil mit scharfen Ecken hineinpasst</translation>
    </message>
    <message>
        <source>Curves to engrave, that the rows of flow follow, or beside which pencil looks for edges: DXF, SVG or JSON</source>
        <translation>Kurven, die graviert werden, denen die Bahnen von flow folgen oder neben denen pencil Kanten sucht: DXF, SVG oder JSON</translation>
    </message>
    <message>
        <source>Takes whose strokes the rows of flow follow, or beside which pencil looks for edges</source>
        <translation>Aufnahmen, deren Strichen die Bahnen von flow folgen oder neben denen pencil Kanten sucht</translation>
    </message>
    <message>
        <source>Only estimate the length and time of the pass; change nothing</source>
        <translation>Länge und Zeit des Durchgangs nur schätzen; nichts ändern</translation>
    </message>
    <message>
        <source>Move a pass or take to another position in its path</source>
        <translation>Einen Durchgang oder eine Aufnahme an eine andere Stelle der Bahn setzen</translation>
    </message>
    <message>
        <source>Position, from 0: the first is milled first</source>
        <translation>Stelle, ab 0: die erste wird zuerst gefräst</translation>
    </message>
    <message>
        <source>One of the device&apos;s modes</source>
        <translation>Eine der Betriebsarten des Geräts</translation>
    </message>
    <message>
        <source>Share of the cutting force that is felt with a device, or was felt while a trace was recorded that does not state it, 0 to 1</source>
        <translation>Anteil der Schnittkraft, der mit einem Gerät zu spüren ist oder beim Aufzeichnen einer Spur zu spüren war, die ihn nicht angibt, 0 bis 1</translation>
    </message>
    <message>
        <source>Test this device: reads it and reports rate, intervals, motion and buttons</source>
        <translation>Dieses Gerät testen: liest es aus und meldet Takt, Abstände, Bewegung und Tasten</translation>
    </message>
    <message>
        <source>Duration, s</source>
        <translation>Dauer, s</translation>
    </message>
    <message>
        <source>Push up with this force, N, while its first button is held; at most a fifth of its maximum force</source>
        <translation>Mit dieser Kraft, N, nach oben drücken, solange die erste Taste gehalten wird; höchstens ein Fünftel der größten Kraft</translation>
    </message>
    <message>
        <source>Ignore the project&apos;s guides (with a device)</source>
        <translation>Die Führungen des Projekts nicht beachten (mit einem Gerät)</translation>
    </message>
    <message>
        <source>Read the part again from this file: roles and materials of bodies stay by their names, and so do setups, recordings and paths</source>
        <translation>Das Teil aus dieser Datei neu einlesen: Rollen und Materialien der Körper bleiben nach ihren Namen, ebenso Aufspannungen, Aufzeichnungen und Pfade</translation>
    </message>
    <message>
        <source>Mill on from a moment (TAKE:SECONDS, or TAKE for its end); what was recorded after it is switched off (&quot;burin take on&quot; switches it on again)</source>
        <translation>Ab einem Zeitpunkt weiterfräsen (AUFNAHME:SEKUNDEN, oder AUFNAHME für ihr Ende); was danach aufgenommen wurde, wird ausgeschaltet („burin take on“ schaltet es wieder ein)</translation>
    </message>
    <message>
        <source>Take, by its number in &quot;burin info&quot;</source>
        <translation>Aufnahme, nach ihrer Nummer in „burin info“</translation>
    </message>
    <message>
        <source>Workpiece and paths are made without it, until it is switched on again; nothing is erased</source>
        <translation>Werkstück und Bahnen entstehen ohne sie, bis sie wieder eingeschaltet wird; nichts wird gelöscht</translation>
    </message>
    <message>
        <source>It counts again</source>
        <translation>Sie zählt wieder</translation>
    </message>
    <message>
        <source>Its new name</source>
        <translation>Ihr neuer Name</translation>
    </message>
    <message>
        <source>The workpiece at a moment: TAKE:SECONDS, or TAKE for its end</source>
        <translation>Das Werkstück zu einem Zeitpunkt: AUFNAHME:SEKUNDEN, oder AUFNAHME für ihr Ende</translation>
    </message>
    <message>
        <source>Write the workpiece that the program leaves, in the forms of &quot;volume export&quot;</source>
        <translation>Das Werkstück schreiben, das das Programm hinterlässt, in den Formen von „volume export“</translation>
    </message>
    <message>
        <source>With --workpiece: as it stands at this time of the program, s</source>
        <translation>Mit --workpiece: wie es zu dieser Zeit des Programms steht, s</translation>
    </message>
    <message>
        <source>Beginning of the part, s from the start of the take (default: its start)</source>
        <translation>Beginn des Teils, s ab Beginn der Aufnahme (Vorgabe: ihr Beginn)</translation>
    </message>
    <message>
        <source>End of the part, s from the start of the take (default: its end)</source>
        <translation>Ende des Teils, s ab Beginn der Aufnahme (Vorgabe: ihr Ende)</translation>
    </message>
    <message>
        <source>Rename it</source>
        <translation>Sie umbenennen</translation>
    </message>
    <message>
        <source>Make paths of a program of another system (G-code or APT/CL), one for each tool</source>
        <translation>Bahnen aus einem Programm eines anderen Systems (G-Code oder APT/CL) machen, eine für jedes Werkzeug</translation>
    </message>
    <message>
        <source>Program to read</source>
        <translation>Programm, das gelesen wird</translation>
    </message>
    <message>
        <source>Tool of the whole program (default: the project&apos;s tools by their numbers)</source>
        <translation>Werkzeug des ganzen Programms (Vorgabe: die Werkzeuge des Projekts nach ihren Nummern)</translation>
    </message>
    <message>
        <source>Name of the path (default: the program&apos;s file)</source>
        <translation>Name der Bahn (Vorgabe: die Datei des Programms)</translation>
    </message>
    <message>
        <source>Colour the first path by this quantity, with a scale, instead of by its moves</source>
        <translation>Die erste Bahn nach dieser Größe färben, mit Skala, statt nach ihren Bewegungen</translation>
    </message>
    <message>
        <source>X,Y,Z on the part, mm, in the coordinates of the setup; the nearest face is measured</source>
        <translation>X,Y,Z auf dem Teil, mm, in den Koordinaten der Aufspannung; gemessen wird die nächste Fläche</translation>
    </message>
    <message>
        <source>The same of a second face: distances and angle</source>
        <translation>Dasselbe einer zweiten Fläche: Abstände und Winkel</translation>
    </message>
    <message>
        <source>Colour the workpiece by the stock that is left on the part, with a scale</source>
        <translation>Das Werkstück nach dem Restmaterial auf dem Teil färben, mit Skala</translation>
    </message>
    <message>
        <source>State how well it was milled: times, tries to gouge, smoothness, force, removal and stock left, compared with a reference; nothing is changed</source>
        <translation>Angeben, wie gut sie gefräst ist: Zeiten, versuchte Konturverletzungen, Gleichmäßigkeit, Kraft, Abtrag und Restmaterial, verglichen mit einer Referenz; nichts wird geändert</translation>
    </message>
    <message>
        <source>Take to compare it with, by its number; it may be switched off</source>
        <translation>Aufnahme, mit der sie verglichen wird, nach ihrer Nummer; sie darf ausgeschaltet sein</translation>
    </message>
    <message>
        <source>Add an edit, a computed pass or a take to a path</source>
        <translation>Einer Bahn eine Bearbeitung, einen berechneten Durchgang oder eine Aufnahme hinzufügen</translation>
    </message>
    <message>
        <source>Replay it earlier or later among the takes of its setup; the workpiece at the end and the paths stay</source>
        <translation>Sie unter den Aufnahmen ihrer Aufspannung früher oder später abspielen; das Werkstück am Ende und die Bahnen bleiben</translation>
    </message>
    <message>
        <source>Just before this take, by its number</source>
        <translation>Unmittelbar vor diese Aufnahme, nach ihrer Nummer</translation>
    </message>
    <message>
        <source>To this position in the order of the takes, from 1</source>
        <translation>An diese Position in der Reihenfolge der Aufnahmen, ab 1</translation>
    </message>
    <message>
        <source>Number of the path to compare with</source>
        <translation>Nummer der Bahn, mit der verglichen wird</translation>
    </message>
    <message>
        <source>Compare with the path without this edit: its position in the list, from 0</source>
        <translation>Mit der Bahn ohne diesen Schritt vergleichen: seine Stelle in der Liste, ab 0</translation>
    </message>
    <message>
        <source>Compare with the path without its edits, as it was recorded or computed</source>
        <translation>Mit der Bahn ohne ihre Bearbeitungen vergleichen, wie sie aufgenommen oder berechnet wurde</translation>
    </message>
    <message>
        <source>Compare a path with another one, or with a version of itself</source>
        <translation>Eine Bahn mit einer anderen oder mit einer Fassung ihrer selbst vergleichen</translation>
    </message>
    <message>
        <source>Distance in mm beyond which parts of the paths count as different</source>
        <translation>Abstand in mm, ab dem Teile der Bahnen als verschieden gelten</translation>
    </message>
    <message>
        <source>List the faces of the part with gouge, stock left and share in tolerance, the worst first</source>
        <translation>Die Flächen des Teils mit Konturverletzung, Restmaterial und Anteil in der Toleranz auflisten, die schlechteste zuerst</translation>
    </message>
    <message>
        <source>Write the list of --faces as a table (.csv)</source>
        <translation>Die Liste von --faces als Tabelle (.csv) schreiben</translation>
    </message>
    <message>
        <source>Stock to leave on the part, mm: within tolerance in the map&apos;s colours and on faces</source>
        <translation>Aufmaß auf dem Teil, mm: in den Farben der Karte und auf Flächen innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Take to mill last in the path; copies of takes are added to a path only this way</source>
        <translation>Aufnahme, die in der Bahn zuletzt gefräst wird; Kopien von Aufnahmen kommen nur so in eine Bahn</translation>
    </message>
    <message>
        <source>Delete a path with its computed passes, or remove one pass or one take from it; takes stay in the project</source>
        <translation>Eine Bahn mit ihren berechneten Durchgängen löschen, oder einen Durchgang oder eine Aufnahme aus ihr entfernen; Aufnahmen bleiben im Projekt</translation>
    </message>
    <message>
        <source>Take to remove from the path</source>
        <translation>Aufnahme, die aus der Bahn entfernt wird</translation>
    </message>
    <message>
        <source>Copy it with its strokes and what is switched off, after all other takes; no path mills the copy until &quot;burin path P apply PATH --take&quot; adds it</source>
        <translation>Sie mit ihren Zügen und dem, was ausgeschaltet ist, hinter alle anderen Aufnahmen kopieren; keine Bahn fräst die Kopie, bis „burin path P apply PATH --take“ sie aufnimmt</translation>
    </message>
    <message>
        <source>Show what the axes and buttons of this device do; changes are kept for the window and the command mill</source>
        <translation>Zeigen, was die Achsen und Tasten dieses Geräts tun; Änderungen gelten auch für das Fenster und den Befehl mill</translation>
    </message>
    <message>
        <source>Assign an axis: N=MOTION[,reversed][,gain=G][,dead=SHARE], for example 2=z,reversed,gain=0.5,dead=0.1</source>
        <translation>Eine Achse belegen: N=BEWEGUNG[,reversed][,gain=G][,dead=ANTEIL], zum Beispiel 2=z,reversed,gain=0.5,dead=0.1</translation>
    </message>
    <message>
        <source>Assign a button: N=ACTION, for example 2=lift; mill, undo, clutch and others</source>
        <translation>Eine Taste belegen: N=AKTION, zum Beispiel 2=lift; mill, undo, clutch und andere</translation>
    </message>
    <message>
        <source>Begin with the usual assignment and without calibration</source>
        <translation>Mit der üblichen Belegung und ohne Kalibrierung beginnen</translation>
    </message>
    <message>
        <source>Measure the axes of this device: two seconds at rest, then in motion; rest, ends and dead zone are kept</source>
        <translation>Die Achsen dieses Geräts messen: zwei Sekunden in Ruhe, dann in Bewegung; Ruhelage, Enden und Totzone werden behalten</translation>
    </message>
    <message>
        <source>Time for moving every axis to its ends, s</source>
        <translation>Zeit, um jede Achse an ihre Enden zu bewegen, s</translation>
    </message>
    <message>
        <source>Colour of a body, or of all bodies of an assembly: BODY=#RRGGBB; may be repeated</source>
        <translation>Farbe eines Körpers oder aller Körper einer Baugruppe: KÖRPER=#RRGGBB; darf wiederholt werden</translation>
    </message>
    <message>
        <source>List the library of fixtures: kinds, sizes, their defaults and ranges. Add one to a project with burin setup --add-fixture</source>
        <translation>Die Bibliothek der Vorrichtungen auflisten: Arten, Maße, ihre Vorgaben und Bereiche. Einem Projekt fügt burin setup --add-fixture eine hinzu</translation>
    </message>
    <message>
        <source>Switch takes, or parts of them, off and on; rename, move, copy, score and measure them</source>
        <translation>Aufnahmen oder Teile davon aus- und einschalten, umbenennen, verschieben, kopieren, bewerten und messen</translation>
    </message>
    <message>
        <source>Measure the distance of its tool from the part over time, negative where the tool is in the part; nothing is changed</source>
        <translation>Den Abstand ihres Werkzeugs vom Teil über die Zeit messen, negativ, wo das Werkzeug im Teil ist; nichts wird geändert</translation>
    </message>
    <message>
        <source>Write time and least distance of every ten samples as CSV</source>
        <translation>Zeit und kleinsten Abstand von je zehn Messpunkten als CSV schreiben</translation>
    </message>
    <message>
        <source>Write tools for other programs: a LinuxCNC tool table (*.tbl), a Fusion library (*.tools), a CAMotics table (*.ctbl), a FreeCAD library with its bits in a folder Bit (*.fctl), a FreeCAD tool bit (*.fctb), or Burin&apos;s own form (*.json)</source>
        <translation>Werkzeuge für andere Programme schreiben: eine Werkzeugtabelle für LinuxCNC (*.tbl), eine Fusion-Bibliothek (*.tools), eine CAMotics-Tabelle (*.ctbl), eine FreeCAD-Bibliothek mit ihren Werkzeugen im Ordner Bit (*.fctl), ein Werkzeug für FreeCAD (*.fctb) oder Burins eigene Form (*.json)</translation>
    </message>
    <message>
        <source>Tools (default: all, or those of --library)</source>
        <translation>Werkzeuge (Standard: alle, oder die von --library)</translation>
    </message>
    <message>
        <source>Tool library</source>
        <translation>Werkzeugbibliothek</translation>
    </message>
    <message>
        <source>List the tool libraries with the number of their tools</source>
        <translation>Die Werkzeugbibliotheken mit der Zahl ihrer Werkzeuge auflisten</translation>
    </message>
    <message>
        <source>Add a tool library</source>
        <translation>Eine Werkzeugbibliothek anlegen</translation>
    </message>
    <message>
        <source>Rename one of your tool libraries</source>
        <translation>Eine Ihrer Werkzeugbibliotheken umbenennen</translation>
    </message>
    <message>
        <source>Delete one of your tool libraries</source>
        <translation>Eine Ihrer Werkzeugbibliotheken löschen</translation>
    </message>
    <message>
        <source>Delete its tools as well</source>
        <translation>Auch ihre Werkzeuge löschen</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Add or change a preset of feeds and speeds of one of your own tools. Paths use the first preset for the material of the stock, without one the first for any material, without one the values that the material states</source>
        <translation>Eine Vorgabe von Schnittwerten eines eigenen Werkzeugs hinzufügen oder ändern. Bahnen verwenden die erste Vorgabe für den Werkstoff des Rohteils, ohne eine solche die erste für jeden Werkstoff, sonst die Werte des Werkstoffs</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Name der Vorgabe</translation>
    </message>
    <message>
        <source>Material that it is for, or any</source>
        <translation>Werkstoff, für den sie gilt, oder any</translation>
    </message>
    <message>
        <source>Speed of the spindle, 1/min</source>
        <translation>Drehzahl der Spindel, 1/min</translation>
    </message>
    <message>
        <source>Feed, mm/min</source>
        <translation>Vorschub, mm/min</translation>
    </message>
    <message>
        <source>Feed per tooth instead, mm</source>
        <translation>Stattdessen Vorschub je Zahn, mm</translation>
    </message>
    <message>
        <source>Plunge feed, mm/min; 0: the share of the feed that the material states</source>
        <translation>Eintauchvorschub, mm/min; 0: der Anteil am Vorschub, den der Werkstoff angibt</translation>
    </message>
    <message>
        <source>Depth of a level, mm; 0: what material, tool and spindle can take</source>
        <translation>Tiefe einer Ebene, mm; 0: was Werkstoff, Werkzeug und Spindel aushalten</translation>
    </message>
    <message>
        <source>Distance between the loops of a level, mm; 0: a share of the diameter</source>
        <translation>Abstand der Umläufe einer Ebene, mm; 0: ein Anteil des Durchmessers</translation>
    </message>
    <message>
        <source>Coolant, or what the material advises</source>
        <translation>Kühlmittel, oder was der Werkstoff empfiehlt</translation>
    </message>
    <message>
        <source>Prefer it to the tool&apos;s other presets</source>
        <translation>Sie den anderen Vorgaben des Werkzeugs vorziehen</translation>
    </message>
    <message>
        <source>Delete the preset</source>
        <translation>Die Vorgabe löschen</translation>
    </message>
    <message>
        <source>The tool does not turn (scraper, planing blade): the models themselves cut, and the profile only keeps them out of the part</source>
        <translation>Das Werkzeug dreht sich nicht (Schaber, Hobelmesser): die Modelle selbst schneiden, und das Profil hält sie nur vom Teil ab</translation>
    </message>
    <message>
        <source>With --fixed: angle from X of the setup to X of the models, degrees, counterclockwise seen from above</source>
        <translation>Mit --fixed: Winkel von X der Aufspannung zu X der Modelle in Grad, von oben gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>List and show tools; copy, add and delete your own, and make them of models. Tools form libraries. Every tool states the source of its values</source>
        <translation>Werkzeuge auflisten und zeigen; eigene kopieren, hinzufügen, löschen und aus Modellen machen. Werkzeuge bilden Bibliotheken. Jedes nennt die Quelle seiner Werte</translation>
    </message>
    <message>
        <source>Tool library: all, starter (what Burin is shipped with), mine (your own tools that are in no other), or one that you have named (default: all; of new tools mine)</source>
        <translation>Werkzeugbibliothek: all (alle), starter (die mitgelieferten), mine (eigene, die in keiner anderen sind) oder eine, die Sie benannt haben (Standard: all; für neue Werkzeuge mine)</translation>
    </message>
    <message>
        <source>Fixture of the library: its kind, then where it would be clicked on, and sizes: &quot;step-clamp at=X,Y turn=DEGREES SIZE=MM&quot;; place=X,Y,Z moves its origin. Kinds and sizes: burin fixtures; may be repeated</source>
        <translation>Vorrichtung der Bibliothek: ihre Art, dann wo sie angeklickt würde, und Maße: &quot;step-clamp at=X,Y turn=GRAD MASS=MM&quot;; place=X,Y,Z versetzt ihren Ursprung. Arten und Maße: burin fixtures; darf wiederholt werden</translation>
    </message>
    <message>
        <source>drill, thread: a hole at X,Y, mm, or by its number in &quot;info --json&quot;; can be given several times (default: every upright hole of the part that fits the drill, or has the diameter of the thread)</source>
        <translation>drill, thread: eine Bohrung bei X,Y, mm, oder nach ihrer Nummer in „info --json“; mehrmals möglich (Vorgabe: jede senkrechte Bohrung des Teils, die zum Bohrer passt oder den Durchmesser des Gewindes hat)</translation>
    </message>
    <message>
        <source>thread: pitch, mm</source>
        <translation>thread: Steigung, mm</translation>
    </message>
    <message>
        <source>thread: instead of --pitch: threads per inch</source>
        <translation>thread: statt --pitch: Gänge je Zoll</translation>
    </message>
    <message>
        <source>thread: once more at full depth</source>
        <translation>thread: noch einmal in voller Tiefe</translation>
    </message>
    <message>
        <source>thread: left-handed</source>
        <translation>thread: Linksgewinde</translation>
    </message>
    <message>
        <source>thread: conventional instead of climb milling</source>
        <translation>thread: Gegenlauf statt Gleichlauf</translation>
    </message>
    <message>
        <source>Compute a pass: levels (roughing), pocket, profile, face, parallel, radial, spiral, flow (rows that follow --lead or --lines), waterline, scallop, pencil (concave edges), rest (what is left), engrave, drill, thread</source>
        <translation>Durchgang berechnen: levels (Schruppen), pocket (Tasche), profile (Kontur), face (Planfräsen), parallel, radial, spiral, flow (Bahnen, die --lead oder --lines folgen), waterline (Höhenlinien), scallop (gleichmäßiger Abstand), pencil (konkave Kanten), rest (Restmaterial), engrave (Gravieren), drill (Bohren), thread (Gewindefräsen)</translation>
    </message>
    <message>
        <source>Role of a body, or of all bodies of an assembly (by its path): BODY=part, stock, insert, protected-insert, fixture or ignored; may be repeated</source>
        <translation>Rolle eines Körpers oder aller Körper einer Baugruppe (nach ihrem Pfad): KÖRPER=part, stock, insert, protected-insert, fixture oder ignored; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Material of a body, or of all bodies of an assembly: BODY=NAME; may be repeated</source>
        <translation>Werkstoff eines Körpers oder aller Körper einer Baugruppe: KÖRPER=NAME; darf wiederholt werden</translation>
    </message>
    <message>
        <source>Unit of the model, whatever its file states: mm, cm, m, inch, foot, mil, a number of mm, or stated</source>
        <translation>Einheit des Modells, was auch seine Datei angibt: mm, cm, m, inch, foot, mil, eine Zahl von mm oder stated</translation>
    </message>
    <message>
        <source>Add tools of another program to your own: a Fusion library (*.tools, *.json), a FreeCAD library or bit (*.fctl, *.fctb), a CAMotics table (*.ctbl), a LinuxCNC table (*.tbl). Several tools become a library that has the name of the file, or are put into --library, which need not exist yet. What can&apos;t be held is listed</source>
        <translation>Werkzeuge eines anderen Programms zu Ihren eigenen hinzufügen: eine Fusion-Bibliothek (*.tools, *.json), eine FreeCAD-Bibliothek oder ein Werkzeug daraus (*.fctl, *.fctb), eine CAMotics-Tabelle (*.ctbl), eine LinuxCNC-Tabelle (*.tbl). Mehrere Werkzeuge werden zu einer Bibliothek, die wie die Datei heißt, oder kommen in die von --library, die es noch nicht geben muss. Was nicht übernommen werden kann, wird aufgezählt</translation>
    </message>
    <message>
        <source>Move your own tools to the library given by --library</source>
        <translation>Eigene Werkzeuge in die mit --library angegebene Bibliothek verschieben</translation>
    </message>
    <message>
        <source>Copy them instead; tools that Burin is shipped with can be copied, too</source>
        <translation>Sie stattdessen kopieren; auch mitgelieferte Werkzeuge lassen sich kopieren</translation>
    </message>
    <message>
        <source>thread: number of passes along the thread, each deeper than the one before</source>
        <translation>thread: Anzahl der Durchgänge entlang des Gewindes, jeder tiefer als der vorige</translation>
    </message>
    <message>
        <source>Let a gamepad vibrate or a joystick push while its first button is held: the strength rises to this share of its strongest effect within each second, 0 to 1</source>
        <translation>Ein Gamepad vibrieren oder einen Joystick drücken lassen, solange die erste Taste gehalten wird: Die Stärke steigt in jeder Sekunde auf diesen Anteil seiner stärksten Wirkung, 0 bis 1</translation>
    </message>
    <message>
        <source>Ceiling of a gamepad&apos;s vibration or a joystick&apos;s force, as a share of its strongest effect, 0 to 1; 0: off</source>
        <translation>Obergrenze für die Vibration eines Gamepads oder die Kraft eines Joysticks, als Anteil seiner stärksten Wirkung, 0 bis 1; 0: aus</translation>
    </message>
    <message>
        <source>Distance that shank and holder keep from the stock, mm (default: they are stopped when they touch it)</source>
        <translation>Abstand, den Schaft und Halter zum Rohteil halten, mm (Vorgabe: Sie werden angehalten, wenn sie es berühren)</translation>
    </message>
    <message>
        <source>Only the passes whose strokes (--lead, --hand) have changed since they were computed, as &quot;path P show&quot; reports them</source>
        <translation>Nur die Durchgänge, deren Züge (--lead, --hand) sich seit ihrer Berechnung geändert haben, wie &quot;path P show&quot; sie meldet</translation>
    </message>
    <message>
        <source>What rows do where takes earlier in the path have finished the part: ignore (default), keep-off, blend (go on over its border by --overlap, without a step), extend (flow: its rows continue those strokes sideways)</source>
        <translation>Was Zeilen tun, wo Aufnahmen weiter vorn in der Bahn das Teil fertig bearbeitet haben: ignore (nichts Besonderes, Vorgabe), keep-off (fernbleiben), blend (um --overlap über den Rand hinausgehen, ohne Absatz), extend (flow: die Zeilen setzen diese Züge seitlich fort)</translation>
    </message>
    <message>
        <source>--hand blend: how far rows go on over the border, mm (default: 0.5)</source>
        <translation>--hand blend: wie weit Zeilen über den Rand hinausgehen, mm (Vorgabe: 0.5)</translation>
    </message>
    <message>
        <source>--hand: largest height that takes may have left on what counts as finished, mm (default: 0.02)</source>
        <translation>--hand: größte Höhe, die Aufnahmen auf dem stehen gelassen haben dürfen, was als fertig gilt, mm (Vorgabe: 0.02)</translation>
    </message>
    <message>
        <source>Touch off program zero as with an edge finder: X,Y,Z=AXIS moves the tip of the tool from a point in mm along x, -x, y, -y or -z until the stock stops it; the side that it touches becomes zero along this axis; may be repeated</source>
        <translation>Den Programmnullpunkt antasten wie mit einem Kantentaster: X,Y,Z=ACHSE bewegt die Spitze des Werkzeugs von einem Punkt in mm entlang x, -x, y, -y oder -z, bis das Rohteil sie aufhält; die berührte Seite wird Null auf dieser Achse; mehrfach möglich</translation>
    </message>
    <message>
        <source>Tool for --touch</source>
        <translation>Werkzeug für --touch</translation>
    </message>
    <message>
        <source>Use the suggested gains for this device from now on, in the window and with &quot;mill&quot;</source>
        <translation>Die vorgeschlagenen Werte ab jetzt für dieses Gerät verwenden, im Fenster und mit „mill“</translation>
    </message>
    <message>
        <source>Never suggest a stiffness above this, N/mm; 0: no maximum of your own. Kept with --keep-gains</source>
        <translation>Nie eine größere Steifigkeit als diese vorschlagen, N/mm; 0: kein eigener Höchstwert. Wird mit --keep-gains behalten</translation>
    </message>
    <message>
        <source>Friction of the handle with the motors off, N, as a spring balance shows it; it limits the suggested stiffness. 0: not measured. Kept with --keep-gains</source>
        <translation>Reibung des Griffs bei abgeschalteten Motoren, N, wie eine Federwaage sie zeigt; sie begrenzt die vorgeschlagene Steifigkeit. 0: nicht gemessen. Wird mit --keep-gains behalten</translation>
    </message>
    <message>
        <source>Use the gains of this device again that were in use before the last change</source>
        <translation>Wieder die Werte dieses Geräts von vor der letzten Änderung verwenden</translation>
    </message>
    <message>
        <source>Measure the part or the workpiece: a face, its wall thickness, or how two faces lie to each other</source>
        <translation>Das Teil oder das Werkstück messen: eine Fläche, ihre Wandstärke oder wie zwei Flächen zueinander liegen</translation>
    </message>
    <message>
        <source>Measure the workpiece as the takes left it: also its depth below the top of the stock, the width to the opposite side and the stock left on the part, each with its uncertainty</source>
        <translation>Das Werkstück messen, wie die Aufnahmen es hinterlassen haben: auch die Tiefe unter der Oberkante des Rohteils, die Weite bis zur Gegenseite und das Restmaterial auf dem Teil, jeweils mit Unsicherheit</translation>
    </message>
    <message>
        <source>Measure the workpiece of a volume file (.srle), as verify writes it</source>
        <translation>Das Werkstück einer Volumendatei (.srle) messen, wie verify sie schreibt</translation>
    </message>
    <message>
        <source>X,Y,Z into the workpiece: its thickness along this direction, too</source>
        <translation>X,Y,Z in das Werkstück hinein: auch seine Dicke in dieser Richtung</translation>
    </message>
    <message>
        <source>Tool (default: that of the trace, otherwise ball-6)</source>
        <translation>Werkzeug (Vorgabe: das der Spur, sonst ball-6)</translation>
    </message>
    <message>
        <source>Change a fixture of the library: &quot;NAME: SIZE=MM&quot;, with the same words; any other is moved: by=X,Y,Z, place=X,Y,Z (its lower corner), turn=DEGREES about Z through its middle; may be repeated</source>
        <translation>Eine Vorrichtung der Bibliothek ändern: &quot;NAME: MASS=MM&quot;, mit denselben Wörtern; jede andere wird verschoben: by=X,Y,Z, place=X,Y,Z (ihre untere Ecke), turn=GRAD um Z durch ihre Mitte; darf wiederholt werden</translation>
    </message>
    <message>
        <source>thread: an external thread on the stud at X,Y, mm, or by its number in &quot;info --json&quot;; can be given several times</source>
        <translation>thread: ein Außengewinde auf dem Zapfen bei X,Y, mm, oder nach seiner Nummer in „info --json“; mehrmals möglich</translation>
    </message>
    <message>
        <source>thread: on studs of the part instead of in its holes (default: every upright stud that has the minor diameter of the thread)</source>
        <translation>thread: auf Zapfen des Teils statt in seinen Bohrungen (Vorgabe: jeder senkrechte Zapfen mit dem Kerndurchmesser des Gewindes)</translation>
    </message>
    <message>
        <source>thread: a metric size, M3 to M24 or diameter and pitch, M8x1; the part&apos;s holes must be modelled with this diameter, its studs with the minor diameter that the mill cuts</source>
        <translation>thread: metrische Größe, M3 bis M24 oder Durchmesser und Steigung, M8x1; die Bohrungen des Teils müssen mit diesem Durchmesser modelliert sein, seine Zapfen mit dem Kerndurchmesser, den der Fräser schneidet</translation>
    </message>
    <message>
        <source>thread: major diameter, mm (default: as each --hole or --stud has it)</source>
        <translation>thread: Nenndurchmesser, mm (Vorgabe: wie jede --hole oder jeder --stud ihn hat)</translation>
    </message>
    <message>
        <source>engrave, drill: depth below the top of the stock, mm; thread: below the top of its hole or stud (default of drill and thread: to the bottom of the part&apos;s hole, or as far as the tool has room around the stud)</source>
        <translation>engrave, drill: Tiefe unter der Oberkante des Rohteils, mm; thread: unter der Oberkante der Bohrung oder des Zapfens (Vorgabe bei drill und thread: bis zum Grund der Bohrung des Teils, oder so weit das Werkzeug um den Zapfen Platz hat)</translation>
    </message>
</context>
<context>
    <name>HoleLabels</name>
    <message>
        <source>⌀ %1, %2 deep</source>
        <translation>⌀ %1, %2 tief</translation>
    </message>
    <message>
        <source>%1 at X %2, Y %3</source>
        <translation>%1 bei X %2, Y %3</translation>
    </message>
    <message>
        <source>stud ⌀ %1, %2 high</source>
        <translation>Zapfen ⌀ %1, %2 hoch</translation>
    </message>
    <message>
        <source>no hole or stud of the part</source>
        <translation>keine Bohrung und kein Zapfen des Teils</translation>
    </message>
</context>
<context>
    <name>ImportFormat</name>
    <message>
        <source>STL binary</source>
        <translation>STL binär</translation>
    </message>
</context>
<context>
    <name>ImportNote</name>
    <message>
        <source>Lengths in %1 were converted: 1 %2 = %3 mm.</source>
        <translation>Längen in %1 wurden umgerechnet: 1 %2 = %3 mm.</translation>
    </message>
    <message>
        <source>The file mixes %1 length units; each part was converted by its own.</source>
        <translation>Die Datei mischt %1 Längeneinheiten; jedes Teil wurde mit seiner eigenen umgerechnet.</translation>
    </message>
    <message>
        <source>A BREP file states no unit; millimetres were taken.</source>
        <translation>Eine BREP-Datei nennt keine Einheit; angenommen wurden Millimeter.</translation>
    </message>
    <message>
        <source>An STL file states no unit; 1 unit = %1 mm was taken.</source>
        <translation>Eine STL-Datei nennt keine Einheit; angenommen wurde 1 Einheit = %1 mm.</translation>
    </message>
    <message>
        <source>The part is %1 mm long: perhaps its unit is another one.</source>
        <translation>Das Teil ist %1 mm lang: Vielleicht hat es eine andere Einheit.</translation>
    </message>
    <message>
        <source>%1 was invalid and was repaired.</source>
        <translation>%1 war ungültig und wurde repariert.</translation>
    </message>
    <message>
        <source>%1 is not fully valid, even after repair.</source>
        <translation>%1 ist auch nach der Reparatur nicht ganz gültig.</translation>
    </message>
    <message>
        <source>%1 does not close, so its inside is not certain.</source>
        <translation>%1 ist nicht geschlossen, deshalb ist sein Inneres nicht sicher.</translation>
    </message>
    <message>
        <source>%1 was inside out and was turned.</source>
        <translation>%1 war nach innen gewendet und wurde umgedreht.</translation>
    </message>
    <message>
        <source>1 loose face was sewn to a solid.</source>
        <translation>1 lose Fläche wurde zu einem Volumenkörper vernäht.</translation>
    </message>
    <message>
        <source>%1 loose faces were sewn to a solid.</source>
        <translation>%1 lose Flächen wurden zu einem Volumenkörper vernäht.</translation>
    </message>
    <message>
        <source>1 face outside of every solid was left out.</source>
        <translation>1 Fläche außerhalb aller Volumenkörper wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 faces outside of every solid were left out.</source>
        <translation>%1 Flächen außerhalb aller Volumenkörper wurden weggelassen.</translation>
    </message>
    <message>
        <source>Curves outside of every solid were left out.</source>
        <translation>Kurven außerhalb aller Volumenkörper wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1: %2 plane faces that the mesher left incomplete were filled.</source>
        <translation>%1: %2 ebene Flächen, die die Vernetzung unvollständig ließ, wurden gefüllt.</translation>
    </message>
    <message>
        <source>%1 is not closed: %2 open edges. Its inside is not certain.</source>
        <translation>%1 ist nicht geschlossen: %2 offene Kanten. Sein Inneres ist nicht sicher.</translation>
    </message>
    <message>
        <source>%1: its mesh encloses %2 mm³, its exact surface %3 mm³.</source>
        <translation>%1: Sein Netz umschließt %2 mm³, seine exakte Oberfläche %3 mm³.</translation>
    </message>
    <message>
        <source>%1: its faces meet with gaps of up to %2 mm; there the mesh may be off by as much.</source>
        <translation>%1: Seine Flächen stoßen mit Spalten bis %2 mm aneinander; dort kann das Netz um ebenso viel abweichen.</translation>
    </message>
    <message>
        <source>%1: %2 triangles were turned.</source>
        <translation>%1: %2 Dreiecke wurden umgedreht.</translation>
    </message>
    <message>
        <source>%1 is not closed: %2 open edges. Its inside and volume are not certain.</source>
        <translation>%1 ist nicht geschlossen: %2 offene Kanten. Sein Inneres und sein Volumen sind nicht sicher.</translation>
    </message>
    <message>
        <source>%1 consists of %2 pieces that are not connected. Where they overlap, its volume counts twice.</source>
        <translation>%1 besteht aus %2 Stücken, die nicht verbunden sind. Wo sie sich überlappen, zählt das Volumen doppelt.</translation>
    </message>
    <message>
        <source>Data after the last triangle was left out.</source>
        <translation>Daten nach dem letzten Dreieck wurden weggelassen.</translation>
    </message>
    <message>
        <source>Body %1</source>
        <translation>Körper %1</translation>
    </message>
    <message>
        <source>Solid %1</source>
        <translation>Volumenkörper %1</translation>
    </message>
    <message>
        <source>The file ends without &quot;endsolid&quot;; what was read of it is whole.</source>
        <translation>Die Datei endet ohne „endsolid“; was daraus gelesen wurde, ist vollständig.</translation>
    </message>
    <message>
        <source>%1 has no volume, so nothing of it can be protected.</source>
        <translation>%1 hat kein Volumen, also kann nichts davon geschützt werden.</translation>
    </message>
    <message>
        <source>Parts are missing because they are in other files: %1. Copy those files into the folder of the model and import it again.</source>
        <translation>Teile fehlen, weil sie in anderen Dateien stehen: %1. Diese Dateien in den Ordner des Modells kopieren und es erneut importieren.</translation>
    </message>
    <message>
        <source>The file ends without &quot;endsolid&quot;; what was read of it is complete.</source>
        <translation>Die Datei endet ohne „endsolid“; das Gelesene ist vollständig.</translation>
    </message>
    <message>
        <source>%1 has no faces and was left out.</source>
        <translation>%1 hat keine Flächen und wurde ausgelassen.</translation>
    </message>
    <message>
        <source>The file states no unit; 1 unit = %1 mm was assumed.</source>
        <translation>Die Datei gibt keine Einheit an; 1 Einheit = %1 mm wurde angenommen.</translation>
    </message>
    <message>
        <source>Colours are stored in another file, %1, and were not imported.</source>
        <translation>Farben stehen in einer anderen Datei, %1, und wurden nicht importiert.</translation>
    </message>
    <message>
        <source>The file states the unit %1 (%2 mm); 1 unit = %3 mm was used instead.</source>
        <translation>Die Datei gibt die Einheit %1 (%2 mm) an; stattdessen wurde 1 Einheit = %3 mm verwendet.</translation>
    </message>
    <message>
        <source>The transparency of colours was not imported.</source>
        <translation>Die Durchsichtigkeit von Farben wurde nicht importiert.</translation>
    </message>
    <message>
        <source>Layers were not imported (number of layers: %1).</source>
        <translation>Ebenen wurden nicht importiert (Anzahl der Ebenen: %1).</translation>
    </message>
    <message>
        <source>Dimensions, tolerances and other annotations (PMI) were not imported (number of entries: %1).</source>
        <translation>Maße, Toleranzen und andere Anmerkungen (PMI) wurden nicht importiert (Anzahl der Einträge: %1).</translation>
    </message>
    <message>
        <source>Assembly %1</source>
        <translation>Baugruppe %1</translation>
    </message>
    <message>
        <source>1 face has a colour of its own, which is not shown; Burin shows each body in one colour.</source>
        <translation>1 Fläche hat eine eigene Farbe, die nicht gezeigt wird; Burin zeigt jeden Körper in einer Farbe.</translation>
    </message>
    <message>
        <source>%1 faces have colours of their own, which are not shown; Burin shows each body in one colour.</source>
        <translation>%1 Flächen haben eigene Farben, die nicht gezeigt werden; Burin zeigt jeden Körper in einer Farbe.</translation>
    </message>
    <message>
        <source>The colour of 1 face was lost when the face was repaired.</source>
        <translation>Die Farbe von 1 Fläche ging verloren, als die Fläche repariert wurde.</translation>
    </message>
    <message>
        <source>The colours of %1 faces were lost when these faces were repaired.</source>
        <translation>Die Farben von %1 Flächen gingen verloren, als diese Flächen repariert wurden.</translation>
    </message>
</context>
<context>
    <name>ImportStage</name>
    <message>
        <source>reading the file, %1 of %2 MB</source>
        <translation>Datei wird gelesen, %1 von %2 MB</translation>
    </message>
    <message>
        <source>reading the file of %2 MB (this step cannot be measured)</source>
        <translation>Datei mit %2 MB wird gelesen (dieser Schritt ist nicht messbar)</translation>
    </message>
    <message>
        <source>interpreting the file (this step cannot be measured)</source>
        <translation>Datei wird ausgewertet (dieser Schritt ist nicht messbar)</translation>
    </message>
    <message>
        <source>converting the shapes</source>
        <translation>Formen werden umgewandelt</translation>
    </message>
    <message>
        <source>checking the solids, %1 of %2</source>
        <translation>Volumenkörper werden geprüft, %1 von %2</translation>
    </message>
    <message>
        <source>meshing, body %1 of %2</source>
        <translation>Vernetzung, Körper %1 von %2</translation>
    </message>
</context>
<context>
    <name>ImportUnit</name>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>yard</source>
        <translation>Yard</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>MeasureLabels</name>
    <message>
        <source>X %1, Y %2, Z %3</source>
        <translation>X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Plane.</source>
        <translation>Ebene.</translation>
    </message>
    <message>
        <source>Cylinder, Ø %1.</source>
        <translation>Zylinder, Ø %1.</translation>
    </message>
    <message>
        <source>Cone, Ø %1 there, half angle %2.</source>
        <translation>Kegel, dort Ø %1, halber Winkel %2.</translation>
    </message>
    <message>
        <source>Sphere, radius %1.</source>
        <translation>Kugel, Radius %1.</translation>
    </message>
    <message>
        <source>Torus, radius of the tube %1.</source>
        <translation>Torus, Radius des Rohrs %1.</translation>
    </message>
    <message>
        <source>Free-form face.</source>
        <translation>Freiformfläche.</translation>
    </message>
    <message>
        <source>Position %1.</source>
        <translation>Position %1.</translation>
    </message>
    <message>
        <source>Wall thickness %1.</source>
        <translation>Wandstärke %1.</translation>
    </message>
    <message>
        <source>Parallel, %1 apart.</source>
        <translation>Parallel, %1 Abstand.</translation>
    </message>
    <message>
        <source>Angle %1.</source>
        <translation>Winkel %1.</translation>
    </message>
    <message>
        <source>Face area %1.</source>
        <translation>Flächeninhalt %1.</translation>
    </message>
    <message>
        <source>Distance between the points: %1 (%2).</source>
        <translation>Abstand der Punkte: %1 (%2).</translation>
    </message>
    <message>
        <source>Smallest distance between the faces: %1.</source>
        <translation>Kleinster Abstand der Flächen: %1.</translation>
    </message>
    <message>
        <source>Distance between the nearest corners or circle centres: %1.</source>
        <translation>Abstand der nächsten Ecken oder Kreismitten: %1.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Cylinder, Ø %1</source>
        <translation>Zylinder, Ø %1</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Sphere, Ø %1</source>
        <translation>Kugel, Ø %1</translation>
    </message>
    <message>
        <source>Torus, tube Ø %1</source>
        <translation>Torus, Rohr Ø %1</translation>
    </message>
    <message>
        <source>Free-form face</source>
        <translation>Freiformfläche</translation>
    </message>
    <message>
        <source>Cut into the part: %1.</source>
        <translation>In das Teil geschnitten: %1.</translation>
    </message>
    <message>
        <source>Stock left on the part: %1.</source>
        <translation>Restmaterial auf dem Teil: %1.</translation>
    </message>
    <message>
        <source>Position %1, within %2.</source>
        <translation>Position %1, auf %2 genau.</translation>
    </message>
    <message>
        <source>Depth below the top of the stock: %1.</source>
        <translation>Tiefe unter der Oberkante des Rohteils: %1.</translation>
    </message>
    <message>
        <source>Thickness along the line of sight: %1.</source>
        <translation>Dicke in Blickrichtung: %1.</translation>
    </message>
    <message>
        <source>Width to the opposite side: %1.</source>
        <translation>Weite bis zur Gegenseite: %1.</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>no details are known</source>
        <translation>Näheres ist nicht bekannt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was cancelled; start it again to finish it.</source>
        <translation>„%1“ wurde abgebrochen; starten Sie es erneut, um es abzuschließen.</translation>
    </message>
    <message>
        <source>There is not enough memory for &quot;%1&quot;; close other programs or choose larger voxels.</source>
        <translation>Der Arbeitsspeicher reicht nicht für „%1“; schließen Sie andere Programme oder wählen Sie größere Voxel.</translation>
    </message>
    <message>
        <source>Internal error in &quot;%1&quot; (%2); save your work under another name and report this.</source>
        <translation>Interner Fehler in „%1“ (%2); speichern Sie Ihre Arbeit unter anderem Namen und melden Sie dies.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not exist; check its name and its folder.</source>
        <translation>„%1“ gibt es nicht; prüfen Sie Namen und Ordner.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be written (%2); check the permissions of the file and its folder or choose another location.</source>
        <translation>„%1“ lässt sich nicht schreiben (%2); prüfen Sie die Zugriffsrechte von Datei und Ordner oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>The disk is full, so &quot;%1&quot; was not written; make room and try again.</source>
        <translation>Der Datenträger ist voll, „%1“ wurde deshalb nicht geschrieben; schaffen Sie Platz und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty; export or copy it again.</source>
        <translation>„%1“ ist leer; exportieren oder kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no format that Burin reads; export it in another one, a model as STEP.</source>
        <translation>„%1“ hat kein Format, das Burin lesen kann; exportieren Sie die Datei in einem anderen, ein Modell als STEP.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged; use a backup, or export or copy it again.</source>
        <translation>„%1“ ist beschädigt; verwenden Sie eine Sicherungskopie oder exportieren oder kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2); use a backup, or export or copy it again.</source>
        <translation>„%1“ ist beschädigt (%2); verwenden Sie eine Sicherungskopie oder exportieren oder kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The value of &quot;%1&quot; can&apos;t be used; allowed is: %2.</source>
        <translation>Der Wert von „%1“ ist nicht verwendbar; erlaubt ist: %2.</translation>
    </message>
    <message>
        <source>The value &quot;%2&quot; of &quot;%1&quot; can&apos;t be used; allowed is: %3.</source>
        <translation>Der Wert „%2“ von „%1“ ist nicht verwendbar; erlaubt ist: %3.</translation>
    </message>
    <message>
        <source>No %1 is called &quot;%2&quot;; check the name.</source>
        <translation>Den Namen „%2“ gibt es nicht (%1); prüfen Sie die Schreibweise.</translation>
    </message>
    <message>
        <source>No %1 is called &quot;%2&quot;; choose one of these: %3.</source>
        <translation>Den Namen „%2“ gibt es nicht (%1); zur Wahl stehen: %3.</translation>
    </message>
    <message>
        <source>This version does not support &quot;%1&quot;; do without it.</source>
        <translation>Diese Version unterstützt „%1“ nicht; verzichten Sie darauf.</translation>
    </message>
    <message>
        <source>This version does not support &quot;%1&quot;; use &quot;%2&quot; instead.</source>
        <translation>Diese Version unterstützt „%1“ nicht; verwenden Sie stattdessen „%2“.</translation>
    </message>
    <message>
        <source>Reading &quot;%1&quot; took longer than %2 and was stopped; simplify the model or allow more time.</source>
        <translation>Das Lesen von „%1“ dauerte länger als %2 und wurde abgebrochen; vereinfachen Sie das Modell oder lassen Sie mehr Zeit zu.</translation>
    </message>
    <message>
        <source>Reading &quot;%1&quot; took more memory than %2 and was stopped; simplify the model or allow more memory.</source>
        <translation>Das Lesen von „%1“ brauchte mehr Speicher als %2 und wurde abgebrochen; vereinfachen Sie das Modell oder lassen Sie mehr Speicher zu.</translation>
    </message>
    <message>
        <source>The CAD reader failed on &quot;%1&quot; (%2); export the model again, if possible as STEP.</source>
        <translation>Der CAD-Leser ist an „%1“ gescheitert (%2); exportieren Sie das Modell noch einmal, möglichst als STEP.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; contains no solid, but: %2; export a closed solid.</source>
        <translation>„%1“ enthält keinen Volumenkörper, sondern: %2; exportieren Sie einen geschlossenen Körper.</translation>
    </message>
    <message>
        <source>The surface of &quot;%1&quot; is open (%2); close it in your CAD program and export it again.</source>
        <translation>Die Oberfläche von „%1“ ist offen (%2); schließen Sie sie im CAD-Programm und exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Some faces of &quot;%1&quot; can&apos;t be meshed (%2); repair them in your CAD program and export it again.</source>
        <translation>Einige Flächen von „%1“ lassen sich nicht vernetzen (%2); reparieren Sie sie im CAD-Programm und exportieren Sie das Modell noch einmal.</translation>
    </message>
    <message>
        <source>A stock of %1 is too large for the limit of %2; choose larger voxels or a smaller stock.</source>
        <translation>Ein Rohteil von %1 übersteigt die Grenze von %2; wählen Sie größere Voxel oder ein kleineres Rohteil.</translation>
    </message>
    <message>
        <source>The memory reserved for the workpiece (%1 bytes) is used up; save, and go on with larger voxels.</source>
        <translation>Der für das Werkstück reservierte Speicher (%1 Byte) ist aufgebraucht; speichern Sie und arbeiten Sie mit größeren Voxeln weiter.</translation>
    </message>
    <message>
        <source>The stock&apos;s &quot;%1&quot; can&apos;t be used; allowed is: %2.</source>
        <translation>„%1“ des Rohteils ist nicht verwendbar; erlaubt ist: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be used because of &quot;%2&quot; (%3); correct the file.</source>
        <translation>„%1“ ist wegen „%2“ nicht verwendbar (%3); berichtigen Sie die Datei.</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; was not found; check its cable and its driver.</source>
        <translation>Das Gerät „%1“ wurde nicht gefunden; prüfen Sie Kabel und Treiber.</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; reports a fault (%2); its forces are off until you connect it again.</source>
        <translation>Das Gerät „%1“ meldet einen Fehler (%2); seine Kräfte bleiben abgeschaltet, bis Sie es neu verbinden.</translation>
    </message>
    <message>
        <source>The trace &quot;%1&quot; can&apos;t be used (%2); correct it or record it again.</source>
        <translation>Die Spur „%1“ ist nicht verwendbar (%2); berichtigen Sie sie oder zeichnen Sie sie neu auf.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a Burin project; choose a file that Burin saved.</source>
        <translation>„%1“ ist kein Burin-Projekt; wählen Sie eine Datei, die Burin gespeichert hat.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was saved by a newer Burin (format %2); update Burin to open it.</source>
        <translation>„%1“ wurde von einem neueren Burin gespeichert (Format %2); aktualisieren Sie Burin, um die Datei zu öffnen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another program (%2); close it there first.</source>
        <translation>„%1“ ist in einem anderen Programm geöffnet (%2); schließen Sie die Datei zuerst dort.</translation>
    </message>
    <message>
        <source>The project lacks &quot;%1&quot;; supply it with &quot;%2&quot;.</source>
        <translation>Im Projekt fehlt „%1“; ergänzen Sie es mit „%2“.</translation>
    </message>
    <message>
        <source>The disk could not keep up, so the recording ended after %1 samples; use a faster disk.</source>
        <translation>Der Datenträger kam nicht nach, die Aufzeichnung endete deshalb nach %1 Messpunkten; verwenden Sie einen schnelleren.</translation>
    </message>
    <message>
        <source>The path &quot;%1&quot; contains no move; add a take that cuts, or switch off the edit that drops everything.</source>
        <translation>Die Bahn „%1“ enthält keine Bewegung; fügen Sie eine Aufnahme hinzu, die schneidet, oder schalten Sie die Bearbeitung ab, die alles entfernt.</translation>
    </message>
    <message>
        <source>No dialect is called &quot;%1&quot;; choose one of these: %2.</source>
        <translation>Den Dialekt „%1“ gibt es nicht; zur Wahl stehen: %2.</translation>
    </message>
    <message>
        <source>The plugin &quot;%1&quot; has interface version %2, but this Burin needs %3; install the one made for it.</source>
        <translation>Die Erweiterung „%1“ hat die Schnittstellenversion %2, dieses Burin braucht aber %3; installieren Sie die passende.</translation>
    </message>
    <message>
        <source>The plugin &quot;%1&quot; can&apos;t be loaded (%2); install it again.</source>
        <translation>Die Erweiterung „%1“ lässt sich nicht laden (%2); installieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The program &quot;%1&quot; can&apos;t be understood at %2 (%3); correct it there.</source>
        <translation>Das Programm „%1“ ist bei %2 nicht verständlich (%3); berichtigen Sie es dort.</translation>
    </message>
    <message>
        <source>The machine&apos;s limit of &quot;%1&quot; is exceeded (%2); change the path or choose another machine.</source>
        <translation>Die Grenze der Maschine für „%1“ wird überschritten (%2); ändern Sie die Bahn oder wählen Sie eine andere Maschine.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; did not pass the check (%2); correct the path and check it again.</source>
        <translation>„%1“ hat die Prüfung nicht bestanden (%2); berichtigen Sie die Bahn und prüfen Sie erneut.</translation>
    </message>
    <message>
        <source>An unknown fault occurred in &quot;%1&quot;; report this.</source>
        <translation>In „%1“ ist ein unbekannter Fehler aufgetreten; melden Sie ihn.</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; was unplugged, so its forces are off; plug it in again to go on.</source>
        <translation>Das Gerät „%1“ wurde abgezogen, deshalb sind seine Kräfte aus; schließen Sie es wieder an, um fortzufahren.</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; has its forces off for now (%2); they fade in again when that is over.</source>
        <translation>Das Gerät „%1“ hat seine Kräfte vorerst aus (%2); sie setzen sanft wieder ein, wenn das vorbei ist.</translation>
    </message>
    <message>
        <source>You have no permission to use the device &quot;%1&quot; (%2); install Burin&apos;s udev rule and plug it in again.</source>
        <translation>Sie dürfen das Gerät „%1“ nicht benutzen (%2); richten Sie Burins udev-Regel ein und schließen Sie es neu an.</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; speaks version %2 of its protocol, but this Burin needs %3; update its firmware.</source>
        <translation>Das Gerät „%1“ spricht Version %2 seines Protokolls, dieses Burin braucht aber %3; bringen Sie seine Firmware auf den neuesten Stand.</translation>
    </message>
    <message>
        <source> (details are in &quot;%1&quot;).</source>
        <translation> (Einzelheiten stehen in „%1“).</translation>
    </message>
    <message>
        <source>The motors of &quot;%1&quot; are hot, so its forces go down to half; press less until they have cooled.</source>
        <translation>Die Motoren von „%1“ sind heiß, darum sinken die Kräfte auf die Hälfte; drücken Sie weniger, bis sie abgekühlt sind.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to come before &quot;%2&quot; in the list of edits; move it there.</source>
        <translation>„%1“ muss in der Liste vor „%2“ stehen; verschieben Sie es dorthin.</translation>
    </message>
    <message>
        <source>A path can have only one &quot;%1&quot;; delete the other one.</source>
        <translation>Eine Bahn kann „%1“ nur einmal haben; löschen Sie die andere Bearbeitung.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; may lead the tool into the part; put &quot;%2&quot; between it and &quot;%3&quot;.</source>
        <translation>„%1“ kann das Werkzeug ins Teil führen; setzen Sie „%2“ zwischen dies und „%3“.</translation>
    </message>
    <message>
        <source>There is not enough memory for &quot;%1&quot; (needed and free: %2); close other programs or choose larger voxels.</source>
        <translation>Für „%1“ reicht der Speicher nicht (nötig und frei: %2); andere Programme schließen oder größere Voxel wählen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; reaches %2 from its origin, and a part may reach %3; choose its unit, or export it again.</source>
        <translation>„%1“ reicht %2 vom Ursprung weg, und ein Teil darf %3 weit reichen; wählen Sie seine Einheit oder exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be read (%2); check that it is the right one and that you have permission to read it.</source>
        <translation>„%1“ lässt sich nicht lesen (%2); prüfen Sie, ob es das Richtige ist und ob Sie es lesen dürfen.</translation>
    </message>
    <message>
        <source>No part of the path &quot;%1&quot; can be milled (%2); %3.</source>
        <translation>Kein Abschnitt der Bahn „%1“ kann gefräst werden (%2); %3.</translation>
    </message>
    <message>
        <source>look at what its edits leave out</source>
        <translation>sehen Sie nach, was ihre Bearbeitungen auslassen</translation>
    </message>
    <message>
        <source>There is not enough memory for &quot;%1&quot; (needed and free: %2); make a path of fewer or shorter takes, or close other programs.</source>
        <translation>Für „%1“ reicht der Speicher nicht (nötig und frei: %2); die Bahn aus weniger oder kürzeren Aufnahmen machen oder andere Programme schließen.</translation>
    </message>
    <message>
        <source>Reading &quot;%1&quot; took more than %2 of processor time and was stopped; simplify the model or allow more time.</source>
        <translation>Das Lesen von „%1“ brauchte mehr als %2 Rechenzeit und wurde abgebrochen; vereinfachen Sie das Modell oder lassen Sie mehr Zeit zu.</translation>
    </message>
    <message>
        <source>The parts of &quot;%1&quot; are in other files that are not in its folder (%2); copy them there, or export the assembly as one file.</source>
        <translation>Die Teile von „%1“ stehen in anderen Dateien, die nicht in seinem Ordner liegen (%2); kopieren Sie sie dorthin, oder exportieren Sie die Baugruppe als eine Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; reaches out of the stock (%2); enlarge the stock or its margin.</source>
        <translation>„%1“ ragt aus dem Rohteil heraus (%2); vergrößern Sie das Rohteil oder seine Zugabe.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no moves: %2.</source>
        <translation>„%1“ hat keine Bewegungen: %2.</translation>
    </message>
    <message>
        <source>The devices of %1 need %2, which is in none of these folders: %3; install it.</source>
        <translation>Die Geräte von %1 brauchen %2, in keinem dieser Ordner gefunden: %3; bitte installieren.</translation>
    </message>
    <message>
        <source>The library &quot;%1&quot; can&apos;t be used (%2); install %3.</source>
        <translation>Die Bibliothek „%1“ ist nicht verwendbar (%2); bitte %3 installieren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would be %2 deep in the stock; move it, or change its sizes.</source>
        <translation>„%1“ würde %2 tief im Rohteil stecken; verschieben Sie es, oder ändern Sie seine Maße.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not done, because an undo or redo is still under way; do it again in a moment.</source>
        <translation>„%1“ wurde nicht ausgeführt, weil noch etwas rückgängig gemacht oder wiederholt wird; führen Sie es gleich noch einmal aus.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be used (%2); correct the file.</source>
        <translation>„%1“ kann nicht verwendet werden (%2); die Datei muss berichtigt werden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; moves the tool, but neither vibrates nor pushes, as you have no permission to write to it (%2); install Burin&apos;s udev rule and plug it in again.</source>
        <translation>„%1“ bewegt das Werkzeug, vibriert und drückt aber nicht, weil Sie nicht darauf schreiben dürfen (%2); richten Sie Burins udev-Regel ein und schließen Sie es neu an.</translation>
    </message>
    <message>
        <source>The trace &quot;%1&quot; could not be written (%2) and was discarded; milling goes on without it.</source>
        <translation>Die Spur „%1“ konnte nicht geschrieben werden (%2) und wurde verworfen; das Fräsen geht ohne sie weiter.</translation>
    </message>
    <message>
        <source>The tool can&apos;t be tilted like this (%1); tilt it less, or on another part of the path.</source>
        <translation>So lässt sich das Werkzeug nicht neigen (%1); neigen Sie es weniger oder auf einem anderen Teil der Bahn.</translation>
    </message>
</context>
<context>
    <name>Migration</name>
    <message>
        <source>Strokes of a take can be undone.</source>
        <translation>Züge einer Aufnahme lassen sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Fixtures, the tool axis and guides are kept.</source>
        <translation>Vorrichtungen, Werkzeugachse und Führungen werden mit gespeichert.</translation>
    </message>
    <message>
        <source>A job may have several setups.</source>
        <translation>Ein Auftrag kann mehrere Aufspannungen haben.</translation>
    </message>
    <message>
        <source>Bodies have roles, and the stock a form and layers.</source>
        <translation>Körper haben Rollen, das Rohteil eine Form und Schichten.</translation>
    </message>
    <message>
        <source>The stock may come from a file.</source>
        <translation>Das Rohteil darf aus einer Datei kommen.</translation>
    </message>
    <message>
        <source>The part can be rotated, and each setup has its own program.</source>
        <translation>Das Teil kann gedreht werden, und jede Aufspannung hat ihr eigenes Programm.</translation>
    </message>
    <message>
        <source>Program zero and its work offset can be chosen.</source>
        <translation>Nullpunkt und Nullpunktverschiebung sind wählbar.</translation>
    </message>
    <message>
        <source>Paths can be computed, and keep what was asked for.</source>
        <translation>Bahnen lassen sich berechnen und behalten, was verlangt war.</translation>
    </message>
    <message>
        <source>Takes can be switched off from a moment on, and the workpiece is kept.</source>
        <translation>Aufnahmen lassen sich ab einem Zeitpunkt ausschalten, und das Werkstück wird aufbewahrt.</translation>
    </message>
    <message>
        <source>Paths can be made of programs, and keep their feeds.</source>
        <translation>Bahnen können aus Programmen entstehen und behalten deren Vorschübe.</translation>
    </message>
    <message>
        <source>Recordings keep the torque that a device gave.</source>
        <translation>Aufnahmen behalten das Drehmoment, das ein Gerät ausgeübt hat.</translation>
    </message>
    <message>
        <source>Paths of programs keep the coolant of each move.</source>
        <translation>Bahnen aus Programmen behalten die Kühlung jeder Bewegung.</translation>
    </message>
</context>
<context>
    <name>MillLabels</name>
    <message>
        <source>the workpiece</source>
        <translation>das Werkstück</translation>
    </message>
    <message>
        <source>The shank touches the part.</source>
        <translation>Der Schaft berührt das Teil.</translation>
    </message>
    <message>
        <source>The holder touches the part.</source>
        <translation>Der Halter berührt das Teil.</translation>
    </message>
    <message>
        <source>The shank touches %1.</source>
        <translation>Der Schaft berührt %1.</translation>
    </message>
    <message>
        <source>The holder touches %1.</source>
        <translation>Der Halter berührt %1.</translation>
    </message>
    <message>
        <source>The machine&apos;s travel ends here.</source>
        <translation>Hier endet der Verfahrweg der Maschine.</translation>
    </message>
    <message>
        <source>“%1” holds the tool.</source>
        <translation>„%1“ hält das Werkzeug auf.</translation>
    </message>
    <message>
        <source>The memory for the workpiece is used up, so nothing is cut; save, and go on with larger voxels.</source>
        <translation>Der Speicher für das Werkstück ist voll, darum wird nichts abgetragen; speichern Sie und arbeiten Sie mit größeren Voxeln weiter.</translation>
    </message>
    <message>
        <source>The stylus gives no readings: the tool does not move, and there is no force.</source>
        <translation>Der Stift liefert keine Werte: Das Werkzeug steht, und es gibt keine Kraft.</translation>
    </message>
    <message>
        <source>There is force while button %1 is held.</source>
        <translation>Kraft gibt es, solange Taste %1 gehalten wird.</translation>
    </message>
    <message>
        <source>Forces fade in, once the tool is clear of the part.</source>
        <translation>Die Kräfte setzen ein, sobald das Werkzeug vom Teil frei ist.</translation>
    </message>
    <message>
        <source>The force is at the device&apos;s limit.</source>
        <translation>Die Kraft ist an der Grenze des Geräts.</translation>
    </message>
    <message>
        <source>The motors are hot: forces go down until they have cooled.</source>
        <translation>Die Motoren sind heiß: Die Kräfte gehen zurück, bis sie abgekühlt sind.</translation>
    </message>
    <message>
        <source>There is no room to tilt the tool like the hand: its axis does not follow.</source>
        <translation>Es ist kein Platz, das Werkzeug wie die Hand zu neigen: Seine Achse folgt nicht.</translation>
    </message>
    <message>
        <source>Shank or holder keep their distance from the stock.</source>
        <translation>Schaft oder Halter halten Abstand zum Rohteil.</translation>
    </message>
    <message>
        <source>The stock holds the tool.</source>
        <translation>Das Rohteil hält das Werkzeug auf.</translation>
    </message>
</context>
<context>
    <name>Omission</name>
    <message>
        <source>The shank would enter material here. Mill the material around it first, or use a tool with longer flutes.</source>
        <translation>Der Schaft würde hier in Material eindringen. Fräsen Sie zuerst das Material ringsum, oder nehmen Sie ein Werkzeug mit längeren Schneiden.</translation>
    </message>
    <message>
        <source>The holder would enter material here. Mill the material around it first, or use a tool with a longer stick-out.</source>
        <translation>Der Halter würde hier in Material eindringen. Fräsen Sie zuerst das Material ringsum, oder nehmen Sie ein Werkzeug mit größerer Auskragung.</translation>
    </message>
    <message>
        <source>use a smaller tool or a smaller allowance</source>
        <translation>nehmen Sie ein kleineres Werkzeug oder ein kleineres Aufmaß</translation>
    </message>
    <message>
        <source>use a smaller tool, or mill it from another side</source>
        <translation>nehmen Sie ein kleineres Werkzeug, oder fräsen Sie es von einer anderen Seite</translation>
    </message>
    <message>
        <source>mill the material around it first, or use a tool with longer flutes</source>
        <translation>fräsen Sie zuerst das Material ringsum, oder nehmen Sie ein Werkzeug mit längeren Schneiden</translation>
    </message>
    <message>
        <source>mill the material around it first, or use a tool with a longer stick-out</source>
        <translation>fräsen Sie zuerst das Material ringsum, oder nehmen Sie ein Werkzeug mit größerer Auskragung</translation>
    </message>
    <message>
        <source>There is no room for a ramp or helix down into the material here, and the tool cannot plunge. Begin beside the material, or use a centre-cutting tool.</source>
        <translation>Hier ist kein Platz für eine Rampe oder Helix ins Material, und das Werkzeug kann nicht eintauchen. Beginnen Sie neben dem Material, oder verwenden Sie ein Werkzeug mit Zentrumsschnitt.</translation>
    </message>
    <message>
        <source>begin beside the material, or use a centre-cutting tool</source>
        <translation>beginnen Sie neben dem Material, oder verwenden Sie ein Werkzeug mit Zentrumsschnitt</translation>
    </message>
    <message>
        <source>There is no tool motion past the part here. Use a smaller tool or a smaller allowance.</source>
        <translation>Hier führt keine Werkzeugbewegung am Teil vorbei. Verwenden Sie ein kleineres Werkzeug oder ein kleineres Aufmaß.</translation>
    </message>
    <message>
        <source>The tool cannot reach this point from above without entering the part. Use a smaller tool, or mill it from another side.</source>
        <translation>Das Werkzeug erreicht diesen Punkt von oben nicht, ohne in das Teil einzudringen. Verwenden Sie ein kleineres Werkzeug, oder fräsen Sie ihn von einer anderen Seite.</translation>
    </message>
</context>
<context>
    <name>OmissionLabels</name>
    <message>
        <source>%1 from X %2, Y %3, Z %4: %5</source>
        <translation>%1 ab X %2, Y %3, Z %4: %5</translation>
    </message>
    <message>
        <source>%1 left out</source>
        <translation>%1 ausgelassen</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>%1 of the path are left out (red in the view).</source>
        <translation>%1 der Bahn sind ausgelassen (rot in der Ansicht).</translation>
    </message>
    <message>
        <source>One hole was not threaded: it is not drilled deep enough, or the part is in the way. Drill it deeper first.</source>
        <translation>Eine Bohrung erhielt kein Gewinde: Sie ist nicht tief genug vorgebohrt, oder das Teil ist im Weg. Bohren Sie sie zuerst tiefer.</translation>
    </message>
    <message>
        <source>%1 holes were not threaded: they are not drilled deep enough, or the part is in the way. Drill them deeper first.</source>
        <translation>%1 Bohrungen erhielten kein Gewinde: Sie sind nicht tief genug vorgebohrt, oder das Teil ist im Weg. Bohren Sie sie zuerst tiefer.</translation>
    </message>
    <message>
        <source>One hole is not drilled to full depth: the part is in the way, or the drill is too short.</source>
        <translation>Eine Bohrung wird nicht auf volle Tiefe gebohrt: Das Teil ist im Weg, oder der Bohrer ist zu kurz.</translation>
    </message>
    <message>
        <source>%1 holes are not drilled to full depth: the part is in the way, or the drill is too short.</source>
        <translation>%1 Bohrungen werden nicht auf volle Tiefe gebohrt: Das Teil ist im Weg, oder der Bohrer ist zu kurz.</translation>
    </message>
    <message>
        <source>One stud was not threaded: it is not milled to the major diameter, or part or stock around it are in the way of the tool. Mill it first.</source>
        <translation>Ein Zapfen erhielt kein Gewinde: Er ist nicht auf den Nenndurchmesser gefräst, oder Teil oder Material um ihn sind dem Werkzeug im Weg. Fräsen Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>%1 studs were not threaded: they are not milled to the major diameter, or part or stock around them are in the way of the tool. Mill them first.</source>
        <translation>%1 Zapfen erhielten kein Gewinde: Sie sind nicht auf den Nenndurchmesser gefräst, oder Teil oder Material um sie sind dem Werkzeug im Weg. Fräsen Sie sie zuerst.</translation>
    </message>
</context>
<context>
    <name>PanelLabels</name>
    <message>
        <source>1 flute</source>
        <translation>1 Schneide</translation>
    </message>
    <message numerus="yes">
        <source>%n flutes</source>
        <translation>
            <numerusform>%n Schneide</numerusform>
            <numerusform>%n Schneiden</numerusform>
        </translation>
    </message>
    <message>
        <source>Specific cutting energy</source>
        <translation>Spez. Schnittenergie</translation>
    </message>
    <message>
        <source>Radial force ratio</source>
        <translation>Radialkraftverhältnis</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Surface speed</source>
        <translation>Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>Chip load per diameter</source>
        <translation>Zahnvorschub je Ø</translation>
    </message>
    <message>
        <source>Plunge feed ratio</source>
        <translation>Anteil Eintauchvorschub</translation>
    </message>
    <message>
        <source>Gouge of %1</source>
        <translation>Konturverletzung %1</translation>
    </message>
    <message>
        <source>Rapid through %1</source>
        <translation>Eilgang durch %1</translation>
    </message>
    <message>
        <source>Shank collision, %1</source>
        <translation>Schaftkollision, %1</translation>
    </message>
    <message>
        <source>Holder collision, %1</source>
        <translation>Halterkollision, %1</translation>
    </message>
    <message>
        <source>Spindle off in %1</source>
        <translation>Spindel steht in %1</translation>
    </message>
    <message>
        <source>Travel of %1 needed</source>
        <translation>Verfahrweg %1 nötig</translation>
    </message>
    <message>
        <source>Feed of %1 mm/min</source>
        <translation>Vorschub %1 mm/min</translation>
    </message>
    <message>
        <source>Spindle at %1 rpm</source>
        <translation>Drehzahl %1 1/min</translation>
    </message>
    <message>
        <source>Cuts from an unknown position</source>
        <translation>Schnitt ab unbekannter Position</translation>
    </message>
    <message>
        <source>Specific cutting force kc1.1</source>
        <translation>Spezifische Schnittkraft kc1.1</translation>
    </message>
    <message>
        <source>Kienzle exponent mc</source>
        <translation>Kienzle-Exponent mc</translation>
    </message>
    <message>
        <source>In a fixture by %1</source>
        <translation>%1 tief in einer Vorrichtung</translation>
    </message>
    <message>
        <source>Shank passes the stock at %1</source>
        <translation>Schaft geht in %1 am Rohteil vorbei</translation>
    </message>
    <message>
        <source>Holder passes the stock at %1</source>
        <translation>Halter geht in %1 am Rohteil vorbei</translation>
    </message>
    <message>
        <source>Shank passes the part at %1</source>
        <translation>Schaft geht in %1 am Teil vorbei</translation>
    </message>
    <message>
        <source>Holder passes the part at %1</source>
        <translation>Halter geht in %1 am Teil vorbei</translation>
    </message>
    <message>
        <source>Shank passes a fixture at %1</source>
        <translation>Schaft geht in %1 an einer Vorrichtung vorbei</translation>
    </message>
    <message>
        <source>Holder passes a fixture at %1</source>
        <translation>Halter geht in %1 an einer Vorrichtung vorbei</translation>
    </message>
    <message>
        <source>The cut takes %1 W, the spindle has %2 W</source>
        <translation>Der Schnitt braucht %1 W, die Spindel hat %2 W</translation>
    </message>
    <message>
        <source>The cut takes %1 N m, the spindle has %2 N m at this speed</source>
        <translation>Der Schnitt braucht %1 N m, die Spindel hat bei dieser Drehzahl %2 N m</translation>
    </message>
    <message>
        <source>The tool bends by %1, the tolerance is %2</source>
        <translation>Das Werkzeug biegt sich um %1, die Toleranz ist %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 (and on %n more lines)</source>
        <translation>
            <numerusform>%1 (und in %n weiterer Zeile)</numerusform>
            <numerusform>%1 (und in %n weiteren Zeilen)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines near there</source>
        <comment>near pass</comment>
        <translation>
            <numerusform>%n Zeile in der Nähe</numerusform>
            <numerusform>%n Zeilen in der Nähe</numerusform>
        </translation>
    </message>
    <message>
        <source>Plunge of %1: the tool does not cut at its centre</source>
        <translation>Eintauchen um %1: Das Werkzeug schneidet nicht über die Mitte</translation>
    </message>
    <message>
        <source>T%1 is not in the project; nothing after it was checked</source>
        <translation>T%1 ist nicht im Projekt; was folgt, wurde nicht geprüft</translation>
    </message>
    <message>
        <source>Feed move before the tool is loaded</source>
        <translation>Vorschubbewegung, bevor das Werkzeug eingewechselt ist</translation>
    </message>
    <message>
        <source>The length offset of T%1 is not in force</source>
        <translation>Die Längenkorrektur von T%1 ist nicht wirksam</translation>
    </message>
    <message>
        <source>H%1 is the length offset of another tool</source>
        <translation>H%1 ist die Längenkorrektur eines anderen Werkzeugs</translation>
    </message>
    <message>
        <source>Not the project&apos;s work offset</source>
        <translation>Nicht die Nullpunktverschiebung des Projekts</translation>
    </message>
    <message>
        <source>Blended corners gouge by %1</source>
        <translation>Verschliffene Ecken verletzen das Teil um %1</translation>
    </message>
    <message>
        <source>Blended corners leave %1 of stock</source>
        <translation>Verschliffene Ecken lassen %1 Aufmaß stehen</translation>
    </message>
    <message>
        <source>Leaves %1 on the part, the path leaves %2</source>
        <translation>Lässt %1 auf dem Teil, die Bahn lässt %2</translation>
    </message>
    <message>
        <source>Bodies too small for the voxels, not protected: %1</source>
        <translation>Körper, die für die Voxel zu klein und nicht geschützt sind: %1</translation>
    </message>
    <message>
        <source>The tool may break: bending stress of %1 N/mm², limit %2 N/mm²</source>
        <translation>Das Werkzeug kann brechen: Biegespannung %1 N/mm², Grenze %2 N/mm²</translation>
    </message>
    <message>
        <source>Chip load of %1 per tooth, limit %2</source>
        <translation>Spandicke %1 je Zahn, Grenze %2</translation>
    </message>
    <message>
        <source>Depth of cut of %1, limit %2</source>
        <translation>Schnitttiefe %1, Grenze %2</translation>
    </message>
    <message>
        <source>Width of cut of %1, limit %2</source>
        <translation>Schnittbreite %1, Grenze %2</translation>
    </message>
    <message>
        <source>Spindle rotates anticlockwise; the tool is right-handed</source>
        <translation>Die Spindel dreht linksherum; das Werkzeug ist rechtsschneidend</translation>
    </message>
    <message>
        <source>%1, ball end mills</source>
        <translation>%1, Kugelfräser</translation>
    </message>
    <message>
        <source>%1, flat end mills</source>
        <translation>%1, Schaftfräser</translation>
    </message>
    <message>
        <source>%1, bull-nose end mills</source>
        <translation>%1, Torusfräser</translation>
    </message>
    <message>
        <source>%1, tapered end mills</source>
        <translation>%1, Kegelfräser</translation>
    </message>
    <message>
        <source>%1, tapered ball end mills</source>
        <translation>%1, konische Kugelfräser</translation>
    </message>
    <message>
        <source>%1, drills</source>
        <translation>%1, Bohrer</translation>
    </message>
    <message>
        <source>%1, chamfer mills</source>
        <translation>%1, Fasenfräser</translation>
    </message>
    <message>
        <source>%1, lollipop mills</source>
        <translation>%1, Lollipop-Fräser</translation>
    </message>
    <message>
        <source>%1, form tools</source>
        <translation>%1, Formwerkzeuge</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>Spindle on in %1</source>
        <translation>Spindel dreht in %1</translation>
    </message>
    <message>
        <source>doesn&apos;t turn</source>
        <translation>dreht sich nicht</translation>
    </message>
    <message>
        <source>hollow Ø %1 × %2</source>
        <translation>hohl Ø %1 × %2</translation>
    </message>
    <message>
        <source>Rotary axis at %1°, beyond its limits</source>
        <translation>Drehachse bei %1°, jenseits ihrer Grenzen</translation>
    </message>
</context>
<context>
    <name>Pass</name>
    <message>
        <source>Levels</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>Tasche</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Planen</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Finishing: parallel rows on the part</source>
        <translation>Schlichten: parallele Zeilen auf dem Teil</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Fluss</translation>
    </message>
    <message>
        <source>Finishing: rows on the part that follow a stroke, or are blended from one stroke to the next</source>
        <translation>Schlichten: Zeilen auf dem Teil, die einem Zug folgen oder von einem Zug zum nächsten übergehen</translation>
    </message>
    <message>
        <source>Waterline</source>
        <translation>Höhenlinien</translation>
    </message>
    <message>
        <source>Engraving</source>
        <translation>Gravur</translation>
    </message>
    <message>
        <source>Roughing: clears the stock level by level, in loops along the part</source>
        <translation>Schruppen: räumt das Rohteil Ebene für Ebene, in Schleifen am Teil entlang</translation>
    </message>
    <message>
        <source>Clears an area level by level; the cutter stays inside it</source>
        <translation>Räumt einen Bereich Ebene für Ebene; der Fräser bleibt darin</translation>
    </message>
    <message>
        <source>Follows the outline of an area, or of the part, level by level</source>
        <translation>Folgt dem Umriss eines Bereichs oder des Teils, Ebene für Ebene</translation>
    </message>
    <message>
        <source>Clears the stock above the part</source>
        <translation>Räumt das Rohteil über dem Teil</translation>
    </message>
    <message>
        <source>Finishing: rows on the part from the centre outwards</source>
        <translation>Schlichten: Zeilen auf dem Teil von der Mitte nach außen</translation>
    </message>
    <message>
        <source>Finishing: one spiral row on the part from the centre outwards</source>
        <translation>Schlichten: eine spiralförmige Zeile auf dem Teil von der Mitte nach außen</translation>
    </message>
    <message>
        <source>Finishing of steep faces: contours of the part at constant Z</source>
        <translation>Schlichten steiler Flächen: Konturen des Teils in gleicher Höhe</translation>
    </message>
    <message>
        <source>Cuts along lines at a given depth below the top of the stock</source>
        <translation>Fräst Linien entlang, in einer Tiefe unter der Oberkante des Rohteils</translation>
    </message>
    <message>
        <source>Scallop</source>
        <translation>Gleichmäßige Rautiefe</translation>
    </message>
    <message>
        <source>Finishing: rows that are evenly far apart on the part, from the border of the area inwards</source>
        <translation>Schlichten: Zeilen in gleichmäßigem Abstand auf dem Teil, vom Rand des Bereichs nach innen</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Restkanten</translation>
    </message>
    <message>
        <source>Follows the concave edges of the part</source>
        <translation>Folgt den konkaven Kanten des Teils</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>Finishing only where stock is left: rows on flat faces, contours on steep ones</source>
        <translation>Schlichten nur dort, wo Rohteil übrig ist: Zeilen auf flachen, Höhenlinien auf steilen Flächen</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Drills the upright holes of the part that fit the drill, or at given places</source>
        <translation>Bohrt die senkrechten Bohrungen des Teils, die zum Bohrer passen, oder an angegebenen Stellen</translation>
    </message>
    <message>
        <source>Thread milling</source>
        <translation>Gewindefräsen</translation>
    </message>
    <message>
        <source>Mills threads in drilled holes that are modelled with the thread&apos;s major diameter, or on studs that are modelled with its minor diameter</source>
        <translation>Fräst Gewinde in vorgebohrte Bohrungen, die mit dem Nenndurchmesser des Gewindes modelliert sind, oder auf Zapfen, die mit seinem Kerndurchmesser modelliert sind</translation>
    </message>
</context>
<context>
    <name>PathQuantity</name>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Height above zero</source>
        <translation>Höhe über Nullpunkt</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Cutting force</source>
        <translation>Schnittkraft</translation>
    </message>
    <message>
        <source>Deviation from the recording</source>
        <translation>Abweichung von der Aufnahme</translation>
    </message>
</context>
<context>
    <name>PlacementLabels</name>
    <message>
        <source>As in the file.</source>
        <translation>Wie in der Datei.</translation>
    </message>
    <message>
        <source>Moved by %1.</source>
        <translation>Um %1 verschoben.</translation>
    </message>
    <message>
        <source>Rotated by %1° about %2, then moved by %3.</source>
        <translation>Um %1° um %2 gedreht, dann um %3 verschoben.</translation>
    </message>
</context>
<context>
    <name>ProgramProblem</name>
    <message>
        <source>character is not allowed</source>
        <translation>Zeichen ist nicht erlaubt</translation>
    </message>
    <message>
        <source>comment is not closed</source>
        <translation>Kommentar ist nicht geschlossen</translation>
    </message>
    <message>
        <source>comment inside a comment</source>
        <translation>Kommentar in einem Kommentar</translation>
    </message>
    <message>
        <source>the control does not read %</source>
        <translation>die Steuerung liest kein %</translation>
    </message>
    <message>
        <source>the control does not read this word</source>
        <translation>dieses Wort liest die Steuerung nicht</translation>
    </message>
    <message>
        <source>no other word of the block uses this one</source>
        <translation>kein anderes Wort des Satzes gebraucht dieses</translation>
    </message>
    <message>
        <source>word without a number</source>
        <translation>Wort ohne Zahl</translation>
    </message>
    <message>
        <source>number is out of range</source>
        <translation>Zahl liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>negative number</source>
        <translation>negative Zahl</translation>
    </message>
    <message>
        <source>decimal point is missing: the control would take the number for its smallest steps</source>
        <translation>Dezimalpunkt fehlt: Die Steuerung hielte die Zahl für ihre kleinsten Schritte</translation>
    </message>
    <message>
        <source>two words of one modal group</source>
        <translation>zwei Wörter einer modalen Gruppe</translation>
    </message>
    <message>
        <source>the control reads no parameters or expressions</source>
        <translation>die Steuerung liest keine Parameter und Ausdrücke</translation>
    </message>
    <message>
        <source>expression is not complete</source>
        <translation>Ausdruck ist unvollständig</translation>
    </message>
    <message>
        <source>expression has no value</source>
        <translation>Ausdruck hat keinen Wert</translation>
    </message>
    <message>
        <source>there is no such parameter, or it can&apos;t be set</source>
        <translation>diesen Parameter gibt es nicht, oder er lässt sich nicht setzen</translation>
    </message>
    <message>
        <source>the program has more moves than can be kept (20 million)</source>
        <translation>das Programm hat mehr Bewegungen, als behalten werden können (20 Millionen)</translation>
    </message>
    <message>
        <source>tool change without a tool</source>
        <translation>Werkzeugwechsel ohne Werkzeug</translation>
    </message>
    <message>
        <source>work offset is missing</source>
        <translation>Nullpunkt fehlt</translation>
    </message>
    <message>
        <source>length offset is missing</source>
        <translation>Längenkorrektur fehlt</translation>
    </message>
    <message>
        <source>feed together with a change of units</source>
        <translation>Vorschub zusammen mit einem Wechsel der Einheit</translation>
    </message>
    <message>
        <source>feed is missing</source>
        <translation>Vorschub fehlt</translation>
    </message>
    <message>
        <source>each move needs its F while G93 is in force</source>
        <translation>unter G93 braucht jede Bewegung ihr F</translation>
    </message>
    <message>
        <source>dwell without its time</source>
        <translation>Verweilen ohne Zeit</translation>
    </message>
    <message>
        <source>dwell and motion in one block</source>
        <translation>Verweilen und Bewegung in einem Satz</translation>
    </message>
    <message>
        <source>axis word is missing</source>
        <translation>Achswort fehlt</translation>
    </message>
    <message>
        <source>axis word without a motion in force</source>
        <translation>Achswort ohne gültige Bewegungsart</translation>
    </message>
    <message>
        <source>G53 needs G0 or G1</source>
        <translation>G53 braucht G0 oder G1</translation>
    </message>
    <message>
        <source>arc without its centre or radius</source>
        <translation>Bogen ohne Mitte und Radius</translation>
    </message>
    <message>
        <source>arc offset without an arc</source>
        <translation>Mittelpunktwort ohne Bogen</translation>
    </message>
    <message>
        <source>arc of radius zero</source>
        <translation>Bogen mit Radius null</translation>
    </message>
    <message>
        <source>radius at the end of the arc differs from the radius at its start</source>
        <translation>der Radius am Ende des Bogens weicht vom Radius am Anfang ab</translation>
    </message>
    <message>
        <source>radius is too small to reach the end of the arc</source>
        <translation>der Radius ist zu klein für das Ende des Bogens</translation>
    </message>
    <message>
        <source>arc by radius that ends where it begins</source>
        <translation>Bogen über den Radius, der endet, wo er beginnt</translation>
    </message>
    <message>
        <source>arc by radius and by centre</source>
        <translation>Bogen über Radius und Mitte</translation>
    </message>
    <message>
        <source>canned cycle with inverse time feed</source>
        <translation>Festzyklus mit Zeitvorschub</translation>
    </message>
    <message>
        <source>canned cycle without R</source>
        <translation>Festzyklus ohne R</translation>
    </message>
    <message>
        <source>canned cycle without its depth</source>
        <translation>Festzyklus ohne Tiefe</translation>
    </message>
    <message>
        <source>R of the canned cycle lies below its depth</source>
        <translation>R des Festzyklus liegt unter seiner Tiefe</translation>
    </message>
    <message>
        <source>canned cycle lacks a word</source>
        <translation>dem Festzyklus fehlt ein Wort</translation>
    </message>
    <message>
        <source>Q has to be above 0, and large enough for the depth</source>
        <translation>Q muss größer als 0 sein und groß genug für die Tiefe</translation>
    </message>
    <message>
        <source>program end is missing</source>
        <translation>Programmende fehlt</translation>
    </message>
    <message>
        <source>feed is above the machine&apos;s</source>
        <translation>Vorschub liegt über dem der Maschine</translation>
    </message>
    <message>
        <source>spindle speed is beyond the machine&apos;s</source>
        <translation>Drehzahl liegt außerhalb der Maschine</translation>
    </message>
    <message>
        <source>the program does not state its units</source>
        <translation>das Programm nennt seine Einheit nicht</translation>
    </message>
    <message>
        <source>feed without a decimal point</source>
        <translation>Vorschub ohne Dezimalpunkt</translation>
    </message>
    <message>
        <source>the line is too long for the control</source>
        <translation>die Zeile ist zu lang für die Steuerung</translation>
    </message>
    <message>
        <source>% has to be alone on its line</source>
        <translation>% muss allein in seiner Zeile stehen</translation>
    </message>
    <message>
        <source>the control accepts % only in the first line, and after the program only if the first line has one</source>
        <translation>die Steuerung nimmt % nur in der ersten Zeile an, und nach dem Programm nur, wenn es in der ersten Zeile steht</translation>
    </message>
    <message>
        <source>line number has to come first</source>
        <translation>die Zeilennummer muss zuerst kommen</translation>
    </message>
    <message>
        <source>word is repeated</source>
        <translation>das Wort kommt zweimal vor</translation>
    </message>
    <message>
        <source>number is not an integer</source>
        <translation>die Zahl ist nicht ganz</translation>
    </message>
    <message>
        <source>code is not supported</source>
        <translation>der Code wird nicht unterstützt</translation>
    </message>
    <message>
        <source>more M words than the control allows in a block</source>
        <translation>mehr M-Wörter, als die Steuerung in einem Satz zulässt</translation>
    </message>
    <message>
        <source>two codes of the block use its axis words</source>
        <translation>zwei Codes des Satzes verwenden seine Achswörter</translation>
    </message>
    <message>
        <source>the value of the parameter is unknown</source>
        <translation>der Wert des Parameters ist unbekannt</translation>
    </message>
    <message>
        <source>cutter radius compensation is not supported: program the centre of the tool</source>
        <translation>Fräserradiuskorrektur wird nicht unterstützt: Programmieren Sie die Werkzeugmitte</translation>
    </message>
    <message>
        <source>subprograms and flow control are not supported</source>
        <translation>Unterprogramme und Ablaufsteuerung werden nicht unterstützt</translation>
    </message>
    <message>
        <source>feed per revolution with the spindle stopped</source>
        <translation>Vorschub je Umdrehung bei stehender Spindel</translation>
    </message>
    <message>
        <source>the start position is unknown</source>
        <translation>die Anfangsposition ist unbekannt</translation>
    </message>
    <message>
        <source>arc offset perpendicular to the arc&apos;s plane</source>
        <translation>Bogenmaß senkrecht zur Ebene des Bogens</translation>
    </message>
    <message>
        <source>number of turns has to be an integer above 0</source>
        <translation>die Anzahl der Umläufe muss eine ganze Zahl über 0 sein</translation>
    </message>
    <message>
        <source>canned cycle with the spindle stopped, or rotating in the wrong direction</source>
        <translation>Festzyklus mit stehender oder verkehrt drehender Spindel</translation>
    </message>
    <message>
        <source>number of repeats has to be an integer from 1 to 10000</source>
        <translation>die Anzahl der Wiederholungen muss eine ganze Zahl von 1 bis 10000 sein</translation>
    </message>
    <message>
        <source>whether arc centres are absolute is a setting of this control: state G91.1</source>
        <translation>ob Bogenmittelpunkte absolut sind, ist eine Einstellung dieser Steuerung: Geben Sie G91.1 an</translation>
    </message>
</context>
<context>
    <name>Questions</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>„%1“ hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Do you want to save them?</source>
        <translation>Möchten Sie sie speichern?</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the project, then go on.</source>
        <translation>Speichert das Projekt und macht dann weiter.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Go on; the changes are lost.</source>
        <translation>Macht weiter; die Änderungen gehen verloren.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change nothing.</source>
        <translation>Ändert nichts.</translation>
    </message>
    <message>
        <source>Burin</source>
        <translation>Burin</translation>
    </message>
    <message>
        <source>About Burin</source>
        <translation>Über Burin</translation>
    </message>
    <message>
        <source>Burin %1</source>
        <translation>Burin %1</translation>
    </message>
    <message>
        <source>Milling tool paths authored by hand.

The method follows Chen and Yang, “Haptic rendering based on spatial run-length encoding”, Robotics and Computer-Integrated Manufacturing 20 (2004) 237–246.

Free software under the Apache License 2.0. Made with Qt, VTK, OpenCASCADE, oneTBB, SQLite and Zstandard.</source>
        <translation>Fräsbahnen, von Hand geschaffen.

Das Verfahren folgt Chen und Yang, „Haptic rendering based on spatial run-length encoding“, Robotics and Computer-Integrated Manufacturing 20 (2004) 237–246.

Freie Software unter der Apache-Lizenz 2.0. Gebaut mit Qt, VTK, OpenCASCADE, oneTBB, SQLite und Zstandard.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Override the check</source>
        <translation>Prüfung übergehen</translation>
    </message>
    <message>
        <source>Its check found 1 problem that can damage a tool, the part or the machine.</source>
        <translation>Die Prüfung fand 1 Fehler, der Werkzeug, Teil oder Maschine beschädigen kann.</translation>
    </message>
    <message numerus="yes">
        <source>Its check found %n problems that can damage a tool, the part or the machine.</source>
        <translation>
            <numerusform>Die Prüfung fand %n Fehler, der Werkzeug, Teil oder Maschine beschädigen kann.</numerusform>
            <numerusform>Die Prüfung fand %n Fehler, die Werkzeug, Teil oder Maschine beschädigen können.</numerusform>
        </translation>
    </message>
    <message>
        <source>Your reason. It goes into the program&apos;s header together with the findings.</source>
        <translation>Ihr Grund. Er steht mit den Befunden im Kopf des Programms.</translation>
    </message>
    <message>
        <source>Export a program that was refused?</source>
        <translation>Ein abgelehntes Programm exportieren?</translation>
    </message>
    <message>
        <source>Close this window.</source>
        <translation>Dieses Fenster schließen.</translation>
    </message>
</context>
<context>
    <name>Resource</name>
    <message>
        <source>Aluminium 6061-T6</source>
        <translation>Aluminium 6061-T6</translation>
    </message>
    <message>
        <source>Machinable wax</source>
        <translation>Fräswachs</translation>
    </message>
    <message>
        <source>Tooling board (polyurethane)</source>
        <translation>Modellbauplatte (Polyurethan)</translation>
    </message>
    <message>
        <source>Ball-end mill 1 mm</source>
        <translation>Kugelfräser 1 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 10 mm</source>
        <translation>Kugelfräser 10 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 3 mm</source>
        <translation>Kugelfräser 3 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 6 mm</source>
        <translation>Kugelfräser 6 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 10 mm, corner radius 2 mm</source>
        <translation>Torusfräser 10 mm, Eckenradius 2 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 16 mm, corner radius 3 mm</source>
        <translation>Torusfräser 16 mm, Eckenradius 3 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 6 mm, corner radius 1 mm</source>
        <translation>Torusfräser 6 mm, Eckenradius 1 mm</translation>
    </message>
    <message>
        <source>End mill 10 mm</source>
        <translation>Schaftfräser 10 mm</translation>
    </message>
    <message>
        <source>End mill 3 mm</source>
        <translation>Schaftfräser 3 mm</translation>
    </message>
    <message>
        <source>End mill 6 mm</source>
        <translation>Schaftfräser 6 mm</translation>
    </message>
    <message>
        <source>Chamfer mill 6 mm, 90°</source>
        <translation>Fasenfräser 6 mm, 90°</translation>
    </message>
    <message>
        <source>Drill 5 mm</source>
        <translation>Bohrer 5 mm</translation>
    </message>
    <message>
        <source>Lollipop mill 6 mm</source>
        <translation>Kugelkopffräser 6 mm</translation>
    </message>
    <message>
        <source>Taper ball mill 1 mm, 5° a side</source>
        <translation>Kegelkugelfräser 1 mm, 5° je Seite</translation>
    </message>
    <message>
        <source>Ball-screw router with grblHAL (typical)</source>
        <translation>Fräse mit Kugelgewindetrieben und grblHAL (typisch)</translation>
    </message>
    <message>
        <source>Desktop router with GRBL 1.1 (Shapeoko 3 settings)</source>
        <translation>Tischfräse mit GRBL 1.1 (Einstellungen der Shapeoko 3)</translation>
    </message>
    <message>
        <source>Hobby mill with Mach3 (typical)</source>
        <translation>Hobbyfräse mit Mach3 (typisch)</translation>
    </message>
    <message>
        <source>Three-axis mill with LinuxCNC (example)</source>
        <translation>Dreiachsfräse mit LinuxCNC (Beispiel)</translation>
    </message>
    <message>
        <source>Vertical machining centre with a Fanuc control (typical)</source>
        <translation>Vertikales Bearbeitungszentrum mit Fanuc-Steuerung (typisch)</translation>
    </message>
    <message>
        <source>Vertical machining centre with a Haas control (typical)</source>
        <translation>Vertikales Bearbeitungszentrum mit Haas-Steuerung (typisch)</translation>
    </message>
    <message>
        <source>Haas mill</source>
        <translation>Haas-Fräsmaschine</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS</translation>
    </message>
    <message>
        <source>Acrylic (PMMA)</source>
        <translation>Acrylglas (PMMA)</translation>
    </message>
    <message>
        <source>Aluminium 2007 (free-cutting)</source>
        <translation>Aluminium 2007 (Automatenlegierung)</translation>
    </message>
    <message>
        <source>Aluminium 7075-T6</source>
        <translation>Aluminium 7075-T6</translation>
    </message>
    <message>
        <source>Beech</source>
        <translation>Buche</translation>
    </message>
    <message>
        <source>Brass CuZn39Pb3</source>
        <translation>Messing CuZn39Pb3</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>MDF</translation>
    </message>
    <message>
        <source>Oak</source>
        <translation>Eiche</translation>
    </message>
    <message>
        <source>POM (acetal)</source>
        <translation>POM (Acetal)</translation>
    </message>
    <message>
        <source>Polyurethane foam</source>
        <translation>Polyurethanschaum</translation>
    </message>
    <message>
        <source>Stainless steel 304 (1.4301)</source>
        <translation>Nichtrostender Stahl 304 (1.4301)</translation>
    </message>
    <message>
        <source>Steel 1045 (C45)</source>
        <translation>Stahl 1045 (C45)</translation>
    </message>
    <message>
        <source>Steel S235JR</source>
        <translation>Stahl S235JR</translation>
    </message>
    <message>
        <source>Titanium Ti-6Al-4V</source>
        <translation>Titan Ti-6Al-4V</translation>
    </message>
    <message>
        <source>ER11 collet in a 52 mm spindle</source>
        <translation>ER11-Spannzange in einer 52-mm-Spindel</translation>
    </message>
    <message>
        <source>ER16 collet chuck</source>
        <translation>ER16-Spannzangenfutter</translation>
    </message>
    <message>
        <source>ER20 collet chuck</source>
        <translation>ER20-Spannzangenfutter</translation>
    </message>
    <message>
        <source>ER20 collet in an 80 mm spindle</source>
        <translation>ER20-Spannzange in einer 80-mm-Spindel</translation>
    </message>
    <message>
        <source>ER25 collet chuck, BT30</source>
        <translation>ER25-Spannzangenfutter, BT30</translation>
    </message>
    <message>
        <source>ER32 collet chuck, BT40</source>
        <translation>ER32-Spannzangenfutter, BT40</translation>
    </message>
    <message>
        <source>Hydraulic chuck 12 mm, BT40</source>
        <translation>Hydrodehnspannfutter 12 mm, BT40</translation>
    </message>
    <message>
        <source>Shrink chuck 6 mm, HSK-A63</source>
        <translation>Schrumpffutter 6 mm, HSK-A63</translation>
    </message>
    <message>
        <source>End mill 1 mm</source>
        <translation>Schaftfräser 1 mm</translation>
    </message>
    <message>
        <source>End mill 1.5 mm</source>
        <translation>Schaftfräser 1,5 mm</translation>
    </message>
    <message>
        <source>End mill 2 mm</source>
        <translation>Schaftfräser 2 mm</translation>
    </message>
    <message>
        <source>End mill 2.5 mm</source>
        <translation>Schaftfräser 2,5 mm</translation>
    </message>
    <message>
        <source>End mill 4 mm</source>
        <translation>Schaftfräser 4 mm</translation>
    </message>
    <message>
        <source>End mill 5 mm</source>
        <translation>Schaftfräser 5 mm</translation>
    </message>
    <message>
        <source>End mill 8 mm</source>
        <translation>Schaftfräser 8 mm</translation>
    </message>
    <message>
        <source>End mill 12 mm</source>
        <translation>Schaftfräser 12 mm</translation>
    </message>
    <message>
        <source>End mill 16 mm</source>
        <translation>Schaftfräser 16 mm</translation>
    </message>
    <message>
        <source>End mill 20 mm</source>
        <translation>Schaftfräser 20 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 1.5 mm</source>
        <translation>Kugelfräser 1,5 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 2 mm</source>
        <translation>Kugelfräser 2 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 4 mm</source>
        <translation>Kugelfräser 4 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 5 mm</source>
        <translation>Kugelfräser 5 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 8 mm</source>
        <translation>Kugelfräser 8 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 12 mm</source>
        <translation>Kugelfräser 12 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 16 mm</source>
        <translation>Kugelfräser 16 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 3 mm, corner radius 0.5 mm</source>
        <translation>Torusfräser 3 mm, Eckenradius 0,5 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 4 mm, corner radius 0.5 mm</source>
        <translation>Torusfräser 4 mm, Eckenradius 0,5 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 6 mm, corner radius 0.5 mm</source>
        <translation>Torusfräser 6 mm, Eckenradius 0,5 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 8 mm, corner radius 1 mm</source>
        <translation>Torusfräser 8 mm, Eckenradius 1 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 8 mm, corner radius 2 mm</source>
        <translation>Torusfräser 8 mm, Eckenradius 2 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 10 mm, corner radius 1 mm</source>
        <translation>Torusfräser 10 mm, Eckenradius 1 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 12 mm, corner radius 1 mm</source>
        <translation>Torusfräser 12 mm, Eckenradius 1 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 12 mm, corner radius 3 mm</source>
        <translation>Torusfräser 12 mm, Eckenradius 3 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 16 mm, corner radius 2 mm</source>
        <translation>Torusfräser 16 mm, Eckenradius 2 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 20 mm, corner radius 3 mm</source>
        <translation>Torusfräser 20 mm, Eckenradius 3 mm</translation>
    </message>
    <message>
        <source>Drill 1 mm</source>
        <translation>Bohrer 1 mm</translation>
    </message>
    <message>
        <source>Drill 1.5 mm</source>
        <translation>Bohrer 1,5 mm</translation>
    </message>
    <message>
        <source>Drill 2 mm</source>
        <translation>Bohrer 2 mm</translation>
    </message>
    <message>
        <source>Drill 2.5 mm</source>
        <translation>Bohrer 2,5 mm</translation>
    </message>
    <message>
        <source>Drill 3 mm</source>
        <translation>Bohrer 3 mm</translation>
    </message>
    <message>
        <source>Drill 3.3 mm</source>
        <translation>Bohrer 3,3 mm</translation>
    </message>
    <message>
        <source>Drill 4 mm</source>
        <translation>Bohrer 4 mm</translation>
    </message>
    <message>
        <source>Drill 4.2 mm</source>
        <translation>Bohrer 4,2 mm</translation>
    </message>
    <message>
        <source>Drill 6 mm</source>
        <translation>Bohrer 6 mm</translation>
    </message>
    <message>
        <source>Drill 6.8 mm</source>
        <translation>Bohrer 6,8 mm</translation>
    </message>
    <message>
        <source>Drill 8 mm</source>
        <translation>Bohrer 8 mm</translation>
    </message>
    <message>
        <source>Drill 8.5 mm</source>
        <translation>Bohrer 8,5 mm</translation>
    </message>
    <message>
        <source>Drill 10 mm</source>
        <translation>Bohrer 10 mm</translation>
    </message>
    <message>
        <source>Drill 10.2 mm</source>
        <translation>Bohrer 10,2 mm</translation>
    </message>
    <message>
        <source>Drill 12 mm</source>
        <translation>Bohrer 12 mm</translation>
    </message>
    <message>
        <source>Chamfer mill 8 mm, 90°</source>
        <translation>Fasenfräser 8 mm, 90°</translation>
    </message>
    <message>
        <source>Chamfer mill 10 mm, 90°</source>
        <translation>Fasenfräser 10 mm, 90°</translation>
    </message>
    <message>
        <source>Chamfer mill 12 mm, 90°</source>
        <translation>Fasenfräser 12 mm, 90°</translation>
    </message>
    <message>
        <source>Chamfer mill 10 mm, 60°</source>
        <translation>Fasenfräser 10 mm, 60°</translation>
    </message>
    <message>
        <source>Engraving cutter 6 mm, 30°, tip 0.2 mm</source>
        <translation>Gravierstichel 6 mm, 30°, Spitze 0,2 mm</translation>
    </message>
    <message>
        <source>Taper ball mill 2 mm, 3° a side</source>
        <translation>Kegelkugelfräser 2 mm, 3° je Seite</translation>
    </message>
    <message>
        <source>Taper ball mill 0.5 mm, 10° a side</source>
        <translation>Kegelkugelfräser 0,5 mm, 10° je Seite</translation>
    </message>
    <message>
        <source>Tapered end mill 2 mm, 3° a side</source>
        <translation>Kegelfräser 2 mm, 3° je Seite</translation>
    </message>
    <message>
        <source>Tapered end mill 2 mm, 5° a side</source>
        <translation>Kegelfräser 2 mm, 5° je Seite</translation>
    </message>
    <message>
        <source>Lollipop mill 4 mm</source>
        <translation>Kugelkopffräser 4 mm</translation>
    </message>
    <message>
        <source>Lollipop mill 8 mm</source>
        <translation>Kugelkopffräser 8 mm</translation>
    </message>
    <message>
        <source>Lollipop mill 10 mm</source>
        <translation>Kugelkopffräser 10 mm</translation>
    </message>
    <message>
        <source>Thread mill M3 × 0.5</source>
        <translation>Gewindefräser M3 × 0,5</translation>
    </message>
    <message>
        <source>Thread mill M4 × 0.7</source>
        <translation>Gewindefräser M4 × 0,7</translation>
    </message>
    <message>
        <source>Thread mill M5 × 0.8</source>
        <translation>Gewindefräser M5 × 0,8</translation>
    </message>
    <message>
        <source>Thread mill M6 × 1</source>
        <translation>Gewindefräser M6 × 1</translation>
    </message>
    <message>
        <source>Thread mill M8 × 1.25</source>
        <translation>Gewindefräser M8 × 1,25</translation>
    </message>
    <message>
        <source>Thread mill M10 × 1.5</source>
        <translation>Gewindefräser M10 × 1,5</translation>
    </message>
    <message>
        <source>Thread mill M12 × 1.75</source>
        <translation>Gewindefräser M12 × 1,75</translation>
    </message>
    <message>
        <source>Five-axis mill with LinuxCNC, tilting rotary table (example)</source>
        <translation>Fünfachsige Fräsmaschine mit LinuxCNC, Dreh-Schwenktisch (Beispiel)</translation>
    </message>
</context>
<context>
    <name>RestartDialog</name>
    <message>
        <source>The first cut is line %1 of the interrupted program; all lines before it count as done.</source>
        <translation>Der erste Schnitt ist Zeile %1 des unterbrochenen Programms; alle Zeilen davor gelten als erledigt.</translation>
    </message>
    <message>
        <source>The last %1 of the path before that line are cut again.</source>
        <translation>Die letzten %1 der Bahn vor dieser Zeile werden noch einmal gefräst.</translation>
    </message>
    <message>
        <source>Tool %1%2 at %3. Measure the new tool first.</source>
        <translation>Werkzeug %1%2 mit %3. Vermessen Sie zuerst das neue Werkzeug.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Passed its check on the stock that is left.</source>
        <translation>Hat die Prüfung auf dem verbliebenen Rohteil bestanden.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Wiederanlauf</translation>
    </message>
    <message>
        <source>Restart at line %1</source>
        <translation>Wiederanlauf bei Zeile %1</translation>
    </message>
    <message>
        <source>The rest of the program</source>
        <translation>Der Rest des Programms</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Write nothing; the program stays as it is (Esc)</source>
        <translation>Nichts schreiben; das Programm bleibt, wie es ist (Esc)</translation>
    </message>
    <message>
        <source>Write the rest as a program of its own; the program of the project stays as it is</source>
        <translation>Den Rest als eigenes Programm schreiben; das Programm des Projekts bleibt, wie es ist</translation>
    </message>
    <message>
        <source>The tool comes down from above to X %1, Y %2, Z %3.</source>
        <translation>Das Werkzeug kommt von oben herab auf X %1, Y %2, Z %3.</translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation>Programm: %1</translation>
    </message>
    <message>
        <source>Did not pass its check on the stock that is left (1 finding). Choose an earlier line, or override the check with a reason.</source>
        <translation>Hat die Prüfung auf dem verbliebenen Rohteil nicht bestanden (1 Befund). Wählen Sie eine frühere Zeile, oder übergehen Sie die Prüfung mit einem Grund.</translation>
    </message>
    <message numerus="yes">
        <source>Did not pass its check on the stock that is left (%n findings). Choose an earlier line, or override the check with a reason.</source>
        <translation>
            <numerusform>Hat die Prüfung auf dem verbliebenen Rohteil nicht bestanden (%n Befund). Wählen Sie eine frühere Zeile, oder übergehen Sie die Prüfung mit einem Grund.</numerusform>
            <numerusform>Hat die Prüfung auf dem verbliebenen Rohteil nicht bestanden (%n Befunde). Wählen Sie eine frühere Zeile, oder übergehen Sie die Prüfung mit einem Grund.</numerusform>
        </translation>
    </message>
    <message>
        <source>Override the check…</source>
        <translation>Prüfung übergehen…</translation>
    </message>
    <message>
        <source>Write the rest nevertheless; its header shows your reason</source>
        <translation>Den Rest trotzdem schreiben; sein Kopf zeigt Ihren Grund</translation>
    </message>
</context>
<context>
    <name>ScoreLabels</name>
    <message>
        <source>the same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>▲ better by %1</source>
        <translation>▲ um %1 besser</translation>
    </message>
    <message>
        <source>▼ worse by %1</source>
        <translation>▼ um %1 schlechter</translation>
    </message>
    <message>
        <source>▲ better by %1 (%2)</source>
        <translation>▲ um %1 besser (%2)</translation>
    </message>
    <message>
        <source>▼ worse by %1 (%2)</source>
        <translation>▼ um %1 schlechter (%2)</translation>
    </message>
</context>
<context>
    <name>ScoreValue</name>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Time of the whole recording</source>
        <translation>Zeit der ganzen Aufnahme</translation>
    </message>
    <message>
        <source>Milling time</source>
        <translation>Fräszeit</translation>
    </message>
    <message>
        <source>Time with the spindle turning</source>
        <translation>Zeit mit drehender Spindel</translation>
    </message>
    <message>
        <source>Tries to gouge</source>
        <translation>Versuchte Konturverletzungen</translation>
    </message>
    <message>
        <source>Largest push</source>
        <translation>Größtes Eindrücken</translation>
    </message>
    <message>
        <source>How far the hand pushed into the part at most</source>
        <translation>Wie weit die Hand höchstens in das Teil drückte</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>Gleichmäßigkeit</translation>
    </message>
    <message>
        <source>Mean force</source>
        <translation>Mittlere Kraft</translation>
    </message>
    <message>
        <source>Mean cutting force while material is removed</source>
        <translation>Mittlere Schnittkraft, während Material abgetragen wird</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Largest cutting force</source>
        <translation>Größte Schnittkraft</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Abgetragen</translation>
    </message>
    <message>
        <source>Volume that the take removed when it was recorded</source>
        <translation>Volumen, das die Aufnahme beim Aufnehmen abgetragen hat</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Volume removed, divided by the milling time</source>
        <translation>Abgetragenes Volumen, geteilt durch die Fräszeit</translation>
    </message>
    <message>
        <source>Stock left, mean</source>
        <translation>Restmaterial, mittel</translation>
    </message>
    <message>
        <source>Stock on the part after the take, on average where its tool can reach</source>
        <translation>Restmaterial auf dem Teil nach der Aufnahme, im Mittel, wo ihr Werkzeug hinkommt</translation>
    </message>
    <message>
        <source>Stock left, largest</source>
        <translation>Restmaterial, max.</translation>
    </message>
    <message>
        <source>The thickest stock there; 20 mm means 20 mm or more</source>
        <translation>Das dickste Restmaterial dort; 20 mm bedeutet 20 mm oder mehr</translation>
    </message>
    <message>
        <source>Spectral arc length (SPARC) of the tip&apos;s speed while milling, without pauses: one smooth movement has -1.41, a lower value means more tremor and interruptions</source>
        <translation>Spektrale Bogenlänge (SPARC) der Geschwindigkeit der Spitze beim Fräsen, ohne Pausen: eine gleichmäßige Bewegung hat -1,41, ein niedrigerer Wert bedeutet mehr Zittern und Unterbrechungen</translation>
    </message>
    <message>
        <source>How often the hand pushed the tool more than 0.1 mm against the part, which stopped it</source>
        <translation>Wie oft die Hand das Werkzeug mehr als 0,1 mm gegen das Teil drückte, das es aufhielt</translation>
    </message>
</context>
<context>
    <name>SetupDialog</name>
    <message>
        <source>rotated by 180° about X</source>
        <translation>um 180° um X gedreht</translation>
    </message>
    <message>
        <source>rotated by 180° about Y</source>
        <translation>um 180° um Y gedreht</translation>
    </message>
    <message>
        <source>rotated by 90° about X</source>
        <translation>um 90° um X gedreht</translation>
    </message>
    <message>
        <source>rotated by -90° about X</source>
        <translation>um -90° um X gedreht</translation>
    </message>
    <message>
        <source>rotated by 90° about Y</source>
        <translation>um 90° um Y gedreht</translation>
    </message>
    <message>
        <source>rotated by -90° about Y</source>
        <translation>um -90° um Y gedreht</translation>
    </message>
    <message>
        <source>not rotated</source>
        <translation>nicht gedreht</translation>
    </message>
    <message>
        <source>Add a setup</source>
        <translation>Aufspannung hinzufügen</translation>
    </message>
    <message>
        <source>Name of the setup, shown in lists and in the file name of its program</source>
        <translation>Name der Aufspannung, in Listen und im Dateinamen ihres Programms</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Rotation about the centre of the part, relative to this setup. You can change it later</source>
        <translation>Drehung um die Mitte des Teils, bezogen auf diese Aufspannung. Sie können sie später ändern</translation>
    </message>
    <message>
        <source>The part is</source>
        <translation>Das Teil ist</translation>
    </message>
    <message>
        <source>the workpiece of this setup</source>
        <translation>das Werkstück dieser Aufspannung</translation>
    </message>
    <message>
        <source>new stock with the same margins</source>
        <translation>ein neues mit denselben Aufmaßen</translation>
    </message>
    <message>
        <source>The workpiece after the checked program of this setup. Without one: after its recordings</source>
        <translation>Das Werkstück nach dem geprüften Programm dieser Aufspannung. Ohne eines: nach ihren Aufnahmen</translation>
    </message>
    <message>
        <source>Its stock is</source>
        <translation>Ihr Rohteil ist</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add the setup and switch to it</source>
        <translation>Die Aufspannung hinzufügen und zu ihr wechseln</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Nichts ändern</translation>
    </message>
</context>
<context>
    <name>Subject</name>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>embedded stock</source>
        <translation>eingebettetes Rohteil</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>eine Aufzeichnung</translation>
    </message>
    <message>
        <source>a tool</source>
        <translation>ein Werkzeug</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>edit</source>
        <translation>Bearbeitung</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>stylus</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>take</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>boundary field of a tool</source>
        <translation>Abstandsfeld eines Werkzeugs</translation>
    </message>
    <message>
        <source>exact distances</source>
        <translation>Genaue Abstände</translation>
    </message>
    <message>
        <source>milling</source>
        <translation>Fräsen</translation>
    </message>
    <message>
        <source>replaying takes</source>
        <translation>Wiederholen der Aufnahmen</translation>
    </message>
    <message>
        <source>verification</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>voxelisation</source>
        <translation>Voxelisierung</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>tilted tool axis</source>
        <translation>geneigte Werkzeugachse</translation>
    </message>
    <message>
        <source>a program with a tool change</source>
        <translation>ein Programm mit Werkzeugwechsel</translation>
    </message>
    <message>
        <source>another process</source>
        <translation>anderer Prozess</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>Prozess %1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>benchmark</source>
        <translation>Benchmark</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>Hindernis</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>a restart of a program that sets its own zero</source>
        <translation>ein Neubeginn in einem Programm mit eigenem Nullpunkt</translation>
    </message>
    <message>
        <source>a restart over a change of the path mode (G61, G64)</source>
        <translation>ein Neubeginn über einen Wechsel des Bahnmodus (G61, G64) hinweg</translation>
    </message>
    <message>
        <source>a restart over a change of the work offset</source>
        <translation>ein Neubeginn über einen Wechsel der Nullpunktverschiebung hinweg</translation>
    </message>
    <message>
        <source>restart line</source>
        <translation>Zeile des Neubeginns</translation>
    </message>
    <message>
        <source>plunge feed</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>maximum feed</source>
        <translation>größter Vorschub</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>maximum spindle speed</source>
        <translation>größte Drehzahl</translation>
    </message>
    <message>
        <source>X travel</source>
        <translation>Verfahrweg X</translation>
    </message>
    <message>
        <source>Y travel</source>
        <translation>Verfahrweg Y</translation>
    </message>
    <message>
        <source>Z travel</source>
        <translation>Verfahrweg Z</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>Verweilzeit</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>interrupted program</source>
        <translation>unterbrochenes Programm</translation>
    </message>
    <message>
        <source>MODEL</source>
        <translation>MODELL</translation>
    </message>
    <message>
        <source>FORCES</source>
        <translation>MESSWERTE</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>Spur</translation>
    </message>
    <message>
        <source>paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>tool number</source>
        <translation>Werkzeugnummer</translation>
    </message>
    <message>
        <source>voxel</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>Zugabe</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>the virtual operator with this kind of tool</source>
        <translation>den virtuellen Bediener mit dieser Art von Werkzeug</translation>
    </message>
    <message>
        <source>tilt of the tool axis</source>
        <translation>Neigung der Werkzeugachse</translation>
    </message>
    <message>
        <source>axes other than X, Y and Z</source>
        <translation>Achsen außer X, Y und Z</translation>
    </message>
    <message>
        <source>insert</source>
        <translation>Einlage</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>checked program</source>
        <translation>geprüftes Programm</translation>
    </message>
    <message>
        <source>generated moves</source>
        <translation>berechneter Durchgang</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>this pass with this kind of tool</source>
        <translation>dieser Durchgang mit dieser Art von Werkzeug</translation>
    </message>
    <message>
        <source>test force</source>
        <translation>Testkraft</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>scoring a take</source>
        <translation>Bewerten einer Aufnahme</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>kind of fixture</source>
        <translation>Art von Vorrichtung</translation>
    </message>
    <message>
        <source>size of a fixture</source>
        <translation>Maß einer Vorrichtung</translation>
    </message>
    <message>
        <source>library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>a computed pass with a tool that doesn&apos;t turn</source>
        <translation>einen berechneten Durchgang mit einem Werkzeug, das sich nicht dreht</translation>
    </message>
    <message>
        <source>the virtual operator with a tool that doesn&apos;t turn</source>
        <translation>den virtuellen Bediener mit einem Werkzeug, das sich nicht dreht</translation>
    </message>
    <message>
        <source>a program for a tool that doesn&apos;t turn</source>
        <translation>ein Programm für ein Werkzeug, das sich nicht dreht</translation>
    </message>
    <message>
        <source>a tilted axis of a tool that doesn&apos;t turn</source>
        <translation>eine geneigte Achse eines Werkzeugs, das sich nicht dreht</translation>
    </message>
    <message>
        <source>gain of axis</source>
        <translation>Verstärkung der Achse</translation>
    </message>
    <message>
        <source>dead zone of axis</source>
        <translation>Totzone der Achse</translation>
    </message>
    <message>
        <source>rest of axis</source>
        <translation>Ruhe der Achse</translation>
    </message>
    <message>
        <source>buttons</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>a path of a program for a tool that doesn&apos;t turn</source>
        <translation>eine Bahn aus einem Programm für ein Werkzeug, das sich nicht dreht</translation>
    </message>
    <message>
        <source>a tilted axis of a tool with a hollow tip</source>
        <translation>eine geneigte Achse bei einem Werkzeug mit hohler Spitze</translation>
    </message>
    <message>
        <source>test strength</source>
        <translation>Teststärke</translation>
    </message>
    <message>
        <source>change of a fixture</source>
        <translation>Änderung einer Vorrichtung</translation>
    </message>
    <message>
        <source>tool axis</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>a tilted tool on %1</source>
        <translation>ein geneigtes Werkzeug auf %1</translation>
    </message>
    <message>
        <source>a restart of a program that tilts the tool</source>
        <translation>ein Neustart eines Programms, das das Werkzeug neigt</translation>
    </message>
</context>
<context>
    <name>Take</name>
    <message>
        <source>free hand</source>
        <translation>freihändig</translation>
    </message>
    <message>
        <source>roughing</source>
        <translation>Schruppen</translation>
    </message>
    <message>
        <source>finishing</source>
        <translation>Schlichten</translation>
    </message>
    <message>
        <source>scribble</source>
        <translation>Gekritzel</translation>
    </message>
    <message>
        <source>contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>hostile hand</source>
        <translation>rohe Hand</translation>
    </message>
    <message>
        <source>take %1</source>
        <translation>Aufnahme %1</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (Kopie)</translation>
    </message>
</context>
<context>
    <name>TakeMenu</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Switch &amp;on</source>
        <translation>&amp;Einschalten</translation>
    </message>
    <message>
        <source>Switch the &amp;stroke off</source>
        <translation>&amp;Zug ausschalten</translation>
    </message>
    <message>
        <source>The workpiece and the paths are made without it, until it is switched on again.</source>
        <translation>Werkstück und Bahnen entstehen ohne das, bis es wieder eingeschaltet wird.</translation>
    </message>
    <message>
        <source>Switch the &amp;take off</source>
        <translation>&amp;Aufnahme ausschalten</translation>
    </message>
    <message>
        <source>Switch &amp;all of the take on</source>
        <translation>&amp;Ganze Aufnahme einschalten</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen …</translation>
    </message>
    <message>
        <source>Rename the take</source>
        <translation>Aufnahme umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>The workpiece is milled again without it.</source>
        <translation>Das Werkstück wird ohne sie neu gefräst.</translation>
    </message>
    <message>
        <source>Rename the marker</source>
        <translation>Marke umbenennen</translation>
    </message>
    <message>
        <source>Delete the marker.</source>
        <translation>Löscht die Marke.</translation>
    </message>
    <message>
        <source>Add a marker</source>
        <translation>Marke setzen</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>It counts again, milled on top of the current workpiece.</source>
        <translation>Es zählt wieder und wird zusätzlich auf dem aktuellen Werkstück gefräst.</translation>
    </message>
    <message>
        <source>Rename the take.</source>
        <translation>Benennt die Aufnahme um.</translation>
    </message>
    <message>
        <source>Rename the marker.</source>
        <translation>Benennt die Marke um.</translation>
    </message>
    <message>
        <source>State how well the take was milled, and compare it with a reference.</source>
        <translation>Zeigt, wie gut die Aufnahme gefräst ist, und vergleicht sie mit einer Referenz.</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Replay it before the take above it.</source>
        <translation>Sie vor der Aufnahme darüber abspielen.</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>Nach u&amp;nten</translation>
    </message>
    <message>
        <source>Replay it after the take below it.</source>
        <translation>Sie nach der Aufnahme darunter abspielen.</translation>
    </message>
    <message>
        <source>Dupli&amp;cate</source>
        <translation>Du&amp;plizieren</translation>
    </message>
    <message>
        <source>Copy it with its strokes and what is switched off. No path mills the copy until its menu adds it.</source>
        <translation>Sie mit ihren Zügen und dem, was ausgeschaltet ist, kopieren. Keine Bahn fräst die Kopie, bis ihr Menü sie aufnimmt.</translation>
    </message>
    <message>
        <source>Take out of the &amp;path</source>
        <translation>Aus der &amp;Bahn nehmen</translation>
    </message>
    <message>
        <source>Mill in the &amp;path</source>
        <translation>In der &amp;Bahn fräsen</translation>
    </message>
    <message>
        <source>The path of its tool mills this copy no longer.</source>
        <translation>Die Bahn ihres Werkzeugs fräst diese Kopie nicht mehr.</translation>
    </message>
    <message>
        <source>The path of its tool mills this copy as well, after its other takes.</source>
        <translation>Die Bahn ihres Werkzeugs fräst auch diese Kopie, nach ihren anderen Aufnahmen.</translation>
    </message>
    <message>
        <source>Scor&amp;e…</source>
        <translation>Be&amp;werten…</translation>
    </message>
</context>
<context>
    <name>TimelineCurveLabels</name>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Engagement</source>
        <translation>Eingriff</translation>
    </message>
    <message>
        <source>Push-back</source>
        <translation>Gegendruck</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
</context>
<context>
    <name>ViewCube</name>
    <message>
        <source>TOP</source>
        <translation>OBEN</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>UNTEN</translation>
    </message>
    <message>
        <source>FRONT</source>
        <translation>VORN</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>HINTEN</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>LINKS</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>RECHTS</translation>
    </message>
</context>
<context>
    <name>burin::ActionStates</name>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>Wieder&amp;herstellen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Wieder&amp;herstellen</translation>
    </message>
</context>
<context>
    <name>burin::AllowancePanel</name>
    <message>
        <source>Allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Stock to leave</source>
        <translation>Aufmaß am Teil</translation>
    </message>
    <message>
        <source>The allowance can&apos;t be changed while recording.</source>
        <translation>Während der Aufzeichnung lässt sich das Aufmaß nicht ändern.</translation>
    </message>
    <message>
        <source>Distance of the boundary from the part</source>
        <translation>Abstand der Grenzfläche vom Teil</translation>
    </message>
    <message>
        <source>Smallest distance between the tool and the part. Leave some stock while roughing; with 0 the cutter may touch the part and finish it.</source>
        <translation>Kleinster Abstand zwischen Werkzeug und Teil. Lassen Sie beim Schruppen etwas Aufmaß; mit 0 darf der Fräser das Teil berühren und schlichten.</translation>
    </message>
</context>
<context>
    <name>burin::AreaCard</name>
    <message>
        <source>Clear the area: the next pass goes over the whole part</source>
        <translation>Bereich löschen: Der nächste Durchgang geht über das ganze Teil</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Brush diameter</source>
        <translation>Pinseldurchmesser</translation>
    </message>
    <message>
        <source>Ctrl+wheel in the view changes it, too</source>
        <translation>Strg+Rad in der Ansicht ändert ihn auch</translation>
    </message>
    <message>
        <source>Area of the next pass: %1</source>
        <translation>Bereich des nächsten Durchgangs: %1</translation>
    </message>
    <message>
        <source>Area of the next pass: whole part</source>
        <translation>Bereich des nächsten Durchgangs: ganzes Teil</translation>
    </message>
    <message>
        <source>Paint on the part; Shift erases</source>
        <translation>Auf das Teil malen; Umschalt radiert</translation>
    </message>
    <message>
        <source>Draw round an area; Shift erases</source>
        <translation>Einen Bereich umfahren; Umschalt radiert</translation>
    </message>
    <message>
        <source>Click faces of the part; Shift removes</source>
        <translation>Flächen des Teils anklicken; Umschalt entfernt</translation>
    </message>
    <message>
        <source>There is no part to paint on yet.</source>
        <translation>Es gibt noch kein Teil zum Bemalen.</translation>
    </message>
    <message>
        <source>Paint the area of the next pass on the part with a brush; Shift erases</source>
        <translation>Den Bereich des nächsten Durchgangs mit einem Pinsel auf das Teil malen; Umschalt radiert</translation>
    </message>
    <message>
        <source>Draw round the area of the next pass; Shift erases</source>
        <translation>Den Bereich des nächsten Durchgangs umfahren; Umschalt radiert</translation>
    </message>
    <message>
        <source>Click faces of the part for the next pass; Shift removes them</source>
        <translation>Flächen des Teils für den nächsten Durchgang anklicken; Umschalt entfernt sie</translation>
    </message>
</context>
<context>
    <name>burin::AreaController</name>
    <message>
        <source>painting an area</source>
        <translation>Malen eines Bereichs</translation>
    </message>
    <message>
        <source>erasing from an area</source>
        <translation>Radieren aus einem Bereich</translation>
    </message>
    <message>
        <source>clearing the area</source>
        <translation>Löschen des Bereichs</translation>
    </message>
</context>
<context>
    <name>burin::AreaPainter</name>
    <message>
        <source>Esc: discard this stroke</source>
        <translation>Esc: diesen Strich verwerfen</translation>
    </message>
    <message>
        <source>Esc: stop painting</source>
        <translation>Esc: Malen beenden</translation>
    </message>
</context>
<context>
    <name>burin::AxisDialog</name>
    <message>
        <source>Axes and buttons: %1</source>
        <translation>Achsen und Tasten: %1</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Stop calibrating</source>
        <translation>Kalibrieren beenden</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Usual assignment</source>
        <translation>Übliche Belegung</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>The device is not connected.</source>
        <translation>Das Gerät ist nicht verbunden.</translation>
    </message>
    <message>
        <source>Leave the device at rest for two seconds.</source>
        <translation>Lassen Sie das Gerät zwei Sekunden in Ruhe.</translation>
    </message>
    <message>
        <source>Move every axis to both of its ends, then press Finish.</source>
        <translation>Bewegen Sie jede Achse bis an ihre beiden Enden, dann drücken Sie „Fertig“.</translation>
    </message>
    <message>
        <source>Connecting the device…</source>
        <translation>Das Gerät wird verbunden …</translation>
    </message>
    <message>
        <source>Move the device: each bar shows its axis, a dot the pressed buttons.</source>
        <translation>Bewegen Sie das Gerät: Jeder Balken zeigt seine Achse, ein Punkt die gedrückten Tasten.</translation>
    </message>
    <message>
        <source>Axes that were not moved before the measurement keep their rest and dead zone (%1); move every axis once first, then calibrate again.</source>
        <translation>Achsen, die vor der Messung nicht bewegt wurden, behalten Ruhelage und Totzone (%1); bewegen Sie zuerst jede Achse einmal und kalibrieren Sie dann erneut.</translation>
    </message>
    <message>
        <source>The rest position is being measured.</source>
        <translation>Die Ruhelage wird gemessen.</translation>
    </message>
    <message>
        <source>Press this when every axis has been at both of its ends</source>
        <translation>Drücken, wenn jede Achse an ihren beiden Enden war</translation>
    </message>
    <message>
        <source>Measure rest position, noise and ends of the axes: two seconds at rest, then move them</source>
        <translation>Ruhelage, Rauschen und Enden der Achsen messen: zwei Sekunden in Ruhe, dann bewegen</translation>
    </message>
</context>
<context>
    <name>burin::AxisRows</name>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Messwert</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Bewegt</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Totzone</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>What this axis moves, as seen from the user</source>
        <translation>Was diese Achse bewegt, vom Benutzer aus gesehen</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>umgekehrt</translation>
    </message>
    <message>
        <source>The axis moves the other way</source>
        <translation>Die Achse bewegt in die andere Richtung</translation>
    </message>
    <message>
        <source>Share of the full motion at full deflection; more than 1 reaches it earlier</source>
        <translation>Anteil der vollen Bewegung bei voller Auslenkung; mehr als 1 erreicht sie früher</translation>
    </message>
    <message>
        <source>Share of the deflection from rest that has no effect</source>
        <translation>Anteil der Auslenkung aus der Ruhe, der keine Wirkung hat</translation>
    </message>
    <message>
        <source>Lower end, rest and upper end of the axis, % of its nominal range</source>
        <translation>Unteres Ende, Ruhe und oberes Ende der Achse, % ihres Nennbereichs</translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation>Taste %1</translation>
    </message>
    <message>
        <source>What this button does while the device mills</source>
        <translation>Was diese Taste tut, während das Gerät fräst</translation>
    </message>
    <message>
        <source>%1 to %3 %, rest %2 %</source>
        <translation>%1 bis %3 %, Ruhe %2 %</translation>
    </message>
</context>
<context>
    <name>burin::AxisTuner</name>
    <message>
        <source>Reading the axes of %1</source>
        <translation>Achsen von %1 werden gelesen</translation>
    </message>
</context>
<context>
    <name>burin::BoundsPanel</name>
    <message>
        <source>Fixtures and limits</source>
        <translation>Vorrichtungen und Grenzen</translation>
    </message>
    <message>
        <source>Whether it keeps the tool out. If the tool is inside, it waits until the tool is clear</source>
        <translation>Ob es das Werkzeug fernhält. Steckt das Werkzeug darin, wartet es, bis das Werkzeug frei ist</translation>
    </message>
    <message>
        <source>Machine&apos;s travel</source>
        <translation>Verfahrweg der Maschine</translation>
    </message>
</context>
<context>
    <name>burin::CalibrationDialog</name>
    <message>
        <source>%1: %2 of %3 records, noise %4 N tangential, %5 N radial</source>
        <translation>%1: %2 von %3 Messungen, Rauschen %4 N tangential, %5 N radial</translation>
    </message>
    <message>
        <source>K = %1 J/mm³ at chips of %2 mm</source>
        <translation>K = %1 J/mm³ bei Spänen von %2 mm</translation>
    </message>
    <message>
        <source>Kr = %1</source>
        <translation>Kr = %1</translation>
    </message>
    <message>
        <source>kc1.1 = %1 N/mm², mc = %2</source>
        <translation>kc1.1 = %1 N/mm², mc = %2</translation>
    </message>
    <message>
        <source>Kte = %1 N/mm, Kre = %2 N/mm</source>
        <translation>Kte = %1 N/mm, Kre = %2 N/mm</translation>
    </message>
    <message>
        <source>Line %1 left out: %2</source>
        <translation>Zeile %1 ausgelassen: %2</translation>
    </message>
    <message>
        <source>Calibrate materials</source>
        <translation>Werkstoffe kalibrieren</translation>
    </message>
    <message>
        <source>No other material</source>
        <translation>Keinem anderen Werkstoff</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Measured forces</source>
        <translation>Gemessene Kräfte</translation>
    </message>
    <message>
        <source>CSV with a row for each cut; `burin calibrate --help` lists the columns</source>
        <translation>CSV mit einer Zeile je Schnitt; `burin calibrate --help` nennt die Spalten</translation>
    </message>
    <message>
        <source>K and the force of the edge</source>
        <translation>K und die Kraft der Schneide</translation>
    </message>
    <message>
        <source>K alone</source>
        <translation>K allein</translation>
    </message>
    <message>
        <source>Kienzle: K falls with the chip</source>
        <translation>Kienzle: K fällt mit dem Span</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>Gesetz</translation>
    </message>
    <message>
        <source>How the force depends on the thickness of the chip</source>
        <translation>Wie die Kraft von der Spandicke abhängt</translation>
    </message>
    <message>
        <source>Rotating teeth</source>
        <translation>Drehende Zähne</translation>
    </message>
    <message>
        <source>Feed and axis</source>
        <translation>Vorschub und Achse</translation>
    </message>
    <message>
        <source>Forces resolved for</source>
        <translation>Kräfte zerlegt nach</translation>
    </message>
    <message>
        <source>Rotating teeth: forces of a dynamometer. Feed and axis: the force that the hand feels against its motion</source>
        <translation>Drehende Zähne: Kräfte eines Dynamometers. Vorschub und Achse: die Kraft, die die Hand gegen ihre Bewegung spürt</translation>
    </message>
    <message>
        <source>New materials are like</source>
        <translation>Neue Werkstoffe gleichen</translation>
    </message>
    <message>
        <source>Whose other values a material takes over that is not in the library</source>
        <translation>Wessen übrige Werte ein Werkstoff übernimmt, der nicht in der Bibliothek ist</translation>
    </message>
    <message>
        <source>On: the forces act on the workpiece, as a dynamometer below it measures. Off: on the tool</source>
        <translation>Ein: Die Kräfte wirken auf das Werkstück, wie ein Dynamometer darunter sie misst. Aus: auf das Werkzeug</translation>
    </message>
    <message>
        <source>Forces on the workpiece</source>
        <translation>Kräfte auf das Werkstück</translation>
    </message>
    <message>
        <source>Keep in the library</source>
        <translation>In der Bibliothek behalten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose a file of measured forces first.</source>
        <translation>Wählen Sie zuerst eine Datei gemessener Kräfte.</translation>
    </message>
    <message>
        <source>There is nothing to keep yet.</source>
        <translation>Es gibt noch nichts zu behalten.</translation>
    </message>
    <message>
        <source>In brackets: the interval that holds the true value in 95 % of such measurements.</source>
        <translation>In Klammern: das Intervall, das in 95&#xa0;% solcher Messungen den wahren Wert enthält.</translation>
    </message>
    <message>
        <source>Keep these materials as your own; Undo takes each back</source>
        <translation>Diese Werkstoffe als eigene behalten; Rückgängig nimmt jeden zurück</translation>
    </message>
    <message>
        <source>Result of the calibration</source>
        <translation>Ergebnis der Kalibrierung</translation>
    </message>
</context>
<context>
    <name>burin::Coach</name>
    <message>
        <source>Key: %1</source>
        <translation>Taste: %1</translation>
    </message>
    <message>
        <source>Wait until Burin has done this.</source>
        <translation>Warten Sie, bis Burin damit fertig ist.</translation>
    </message>
    <message>
        <source>The check refused the program: its findings say why. Delete your edit or mill anew, then post again.</source>
        <translation>Die Prüfung hat das Programm abgelehnt; ihre Befunde nennen den Grund. Löschen Sie Ihre Bearbeitung oder fräsen Sie neu, und geben Sie es noch einmal aus.</translation>
    </message>
    <message>
        <source>Your first job is done</source>
        <translation>Ihr erster Auftrag ist fertig</translation>
    </message>
    <message>
        <source>You milled by hand, and the machine can repeat it. The help has more on every step.</source>
        <translation>Sie haben von Hand gefräst, und die Maschine kann es wiederholen. Die Hilfe sagt mehr zu jedem Schritt.</translation>
    </message>
    <message>
        <source>You have done this step.</source>
        <translation>Diesen Schritt haben Sie schon gemacht.</translation>
    </message>
</context>
<context>
    <name>burin::CoachPanel</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Show the previous step</source>
        <translation>Den vorigen Schritt zeigen</translation>
    </message>
    <message>
        <source>First job</source>
        <translation>Erster Auftrag</translation>
    </message>
    <message>
        <source>First job: step %1 of %2</source>
        <translation>Erster Auftrag: Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Skip this step</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Go on to the step that is not done yet</source>
        <translation>Weiter zu dem Schritt, der noch nicht gemacht ist</translation>
    </message>
    <message>
        <source>Go on without this step</source>
        <translation>Ohne diesen Schritt weitermachen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Close the first job (Esc)</source>
        <translation>Den ersten Auftrag schließen (Esc)</translation>
    </message>
    <message>
        <source>End the first job; the project stays (Esc)</source>
        <translation>Den ersten Auftrag beenden; das Projekt bleibt (Esc)</translation>
    </message>
</context>
<context>
    <name>burin::ComparisonDialog</name>
    <message>
        <source>Compare paths</source>
        <translation>Bahnen vergleichen</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>This path in another version, or another path of the setup</source>
        <translation>Diese Bahn in einer anderen Fassung oder eine andere Bahn der Aufspannung</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Cuts farther apart than this are marked red in the view</source>
        <translation>Schnitte, die weiter auseinanderliegen, sind in der Ansicht rot markiert</translation>
    </message>
    <message>
        <source>This path</source>
        <translation>Diese Bahn</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Plunges</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>Rapids and retracts</source>
        <translation>Eilgänge und Rückzüge</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>Time at feed</source>
        <translation>Zeit im Vorschub</translation>
    </message>
    <message>
        <source>Mean deviation</source>
        <translation>Mittlere Abweichung</translation>
    </message>
    <message>
        <source>Farther than the tolerance</source>
        <translation>Jenseits der Toleranz</translation>
    </message>
    <message>
        <source>The other path is drawn thin, in turquoise. Deviations are those of the cuts of either path from the cuts of the other.</source>
        <translation>Die andere Bahn ist dünn und türkis gezeichnet. Abweichungen sind die der Schnitte jeder Bahn von den Schnitten der anderen.</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>Largest deviation of the other path</source>
        <translation>Größte Abweichung der anderen Bahn</translation>
    </message>
    <message>
        <source>Largest deviation of this path</source>
        <translation>Größte Abweichung dieser Bahn</translation>
    </message>
    <message>
        <source>There is no deviation to show</source>
        <translation>Es gibt keine Abweichung zu zeigen</translation>
    </message>
    <message>
        <source>Show the point in the view</source>
        <translation>Den Punkt in der Ansicht zeigen</translation>
    </message>
</context>
<context>
    <name>burin::ComparisonPresenter</name>
    <message>
        <source>The paths are being compared.</source>
        <translation>Die Bahnen werden verglichen.</translation>
    </message>
    <message>
        <source>Waits until both paths are up to date.</source>
        <translation>Wartet, bis beide Bahnen aktuell sind.</translation>
    </message>
    <message>
        <source>One of the paths has no cuts: there is no deviation.</source>
        <translation>Eine der Bahnen hat keine Schnitte: es gibt keine Abweichung.</translation>
    </message>
    <message>
        <source>itself without edits, as recorded or computed</source>
        <translation>sich selbst ohne Bearbeitungen, wie aufgenommen oder berechnet</translation>
    </message>
    <message>
        <source>itself without edit %1: %2</source>
        <translation>sich selbst ohne Bearbeitung %1: %2</translation>
    </message>
    <message>
        <source>path %1, %2: %3</source>
        <translation>Bahn %1, %2: %3</translation>
    </message>
</context>
<context>
    <name>burin::DeviationCard</name>
    <message>
        <source>Show the deviation</source>
        <translation>Abweichung zeigen</translation>
    </message>
    <message>
        <source>Bands of deviation and their shares of the part</source>
        <translation>Stufen der Abweichung und ihre Anteile am Teil</translation>
    </message>
    <message>
        <source>Gouge deeper than %1</source>
        <translation>Tiefer verletzt als %1</translation>
    </message>
    <message>
        <source>Within %1</source>
        <translation>Innerhalb %1</translation>
    </message>
    <message>
        <source>More is left</source>
        <translation>Mehr steht noch</translation>
    </message>
    <message>
        <source>Out of the tool&apos;s reach</source>
        <translation>Vom Werkzeug unerreichbar</translation>
    </message>
    <message>
        <source>Here: %1 too deep</source>
        <translation>Hier: %1 zu tief</translation>
    </message>
    <message>
        <source>Here: %1 left</source>
        <translation>Hier: %1 stehen noch</translation>
    </message>
    <message>
        <source>out of the tool&apos;s reach</source>
        <translation>vom Werkzeug unerreichbar</translation>
    </message>
    <message>
        <source>Colours the part by the excess stock that the program leaves, or by the depth of its gouges</source>
        <translation>Färbt das Teil danach, wie viel Material das Programm stehen lässt oder wie tief es hineinschneidet</translation>
    </message>
    <message>
        <source>Move the pointer over the part to read the deviation.</source>
        <translation>Auf das Teil zeigen, um den Wert dort abzulesen.</translation>
    </message>
    <message>
        <source>Faces…</source>
        <translation>Flächen…</translation>
    </message>
    <message>
        <source>Something has changed since the check; post and check it again</source>
        <translation>Seit der Prüfung hat sich etwas geändert; geben Sie das Programm neu aus und prüfen Sie es</translation>
    </message>
    <message>
        <source>Lists the faces of the part with gouges and stock left on each</source>
        <translation>Listet die Flächen des Teils mit Konturverletzungen und Restmaterial auf</translation>
    </message>
</context>
<context>
    <name>burin::DeviationLegend</name>
    <message>
        <source>Scale of the deviation</source>
        <translation>Farbskala der Abweichung</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>zu tief</translation>
    </message>
    <message>
        <source>within tolerance</source>
        <translation>in der Toleranz</translation>
    </message>
    <message>
        <source>too much left</source>
        <translation>zu viel steht noch</translation>
    </message>
    <message>
        <source>not measured, or out of the tool&apos;s reach</source>
        <translation>nicht gemessen oder außer Reichweite des Werkzeugs</translation>
    </message>
</context>
<context>
    <name>burin::DeviceDialog</name>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Test force</source>
        <translation>Testkraft</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Mouse and keyboard, always there</source>
        <translation>Maus und Tastatur, immer da</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Not plugged in</source>
        <translation>Nicht angeschlossen</translation>
    </message>
    <message>
        <source>library missing</source>
        <translation>Bibliothek fehlt</translation>
    </message>
    <message>
        <source>Stop the test</source>
        <translation>Test beenden</translation>
    </message>
    <message>
        <source>Read the device while you move it: rate, position, buttons</source>
        <translation>Das Gerät auslesen, während Sie es bewegen: Takt, Position, Tasten</translation>
    </message>
    <message>
        <source>Cutting force felt</source>
        <translation>Spürbare Schnittkraft</translation>
    </message>
    <message>
        <source>Friction felt</source>
        <translation>Spürbare Reibung</translation>
    </message>
    <message>
        <source>Mill with this device</source>
        <translation>Mit diesem Gerät fräsen</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>ausgewählt</translation>
    </message>
    <message>
        <source>Select a device that is plugged in.</source>
        <translation>Ein angeschlossenes Gerät auswählen.</translation>
    </message>
    <message>
        <source>Select a device or the mouse.</source>
        <translation>Ein Gerät oder die Maus auswählen.</translation>
    </message>
    <message>
        <source>Use this device the next time you start milling</source>
        <translation>Dieses Gerät beim nächsten Fräsen verwenden</translation>
    </message>
    <message>
        <source>Move the device through its whole workspace and press every button.</source>
        <translation>Das Gerät durch seinen ganzen Arbeitsraum bewegen und jede Taste drücken.</translation>
    </message>
    <message>
        <source>The device pushes up with this force while you hold its first button. It fades in over one second and is limited to a fifth of the maximum force. 0: motors off</source>
        <translation>Mit dieser Kraft drückt das Gerät nach oben, solange Sie seine erste Taste halten. Sie wird über eine Sekunde eingeblendet und ist auf ein Fünftel der größten Kraft begrenzt. 0: Motoren aus</translation>
    </message>
    <message>
        <source>1: a reference cut in the hardest material gives 60 % of the maximum force. 0: only the part is felt, not the cutting</source>
        <translation>1: ein Referenzschnitt im härtesten Werkstoff ergibt 60 % der größten Kraft. 0: nur das Teil ist zu spüren, nicht das Schneiden</translation>
    </message>
    <message>
        <source>Friction coefficient where the tool slides without cutting</source>
        <translation>Reibungszahl, wo das Werkzeug gleitet, ohne zu schneiden</translation>
    </message>
    <message>
        <source>Stop milling first.</source>
        <translation>Zuerst das Fräsen beenden.</translation>
    </message>
    <message>
        <source>moves the view</source>
        <translation>bewegt die Ansicht</translation>
    </message>
    <message>
        <source>Stop moving the view</source>
        <translation>Ansicht nicht mehr bewegen</translation>
    </message>
    <message>
        <source>Move the view with this device</source>
        <translation>Ansicht mit diesem Gerät bewegen</translation>
    </message>
    <message>
        <source>Select a 3D mouse, gamepad or joystick.</source>
        <translation>Wählen Sie eine 3D-Maus, ein Gamepad oder einen Joystick.</translation>
    </message>
    <message>
        <source>Pan, zoom and rotate the view with this device, beside the stylus. Its first button fits the view. While it moves the tool, the view stays</source>
        <translation>Verschiebt, zoomt und dreht die Ansicht mit diesem Gerät, neben dem Stylus. Seine erste Taste zeigt alles. Solange es das Werkzeug bewegt, bleibt die Ansicht stehen</translation>
    </message>
    <message>
        <source>Axes and buttons…</source>
        <translation>Achsen und Tasten …</translation>
    </message>
    <message>
        <source>Stop the test first.</source>
        <translation>Beenden Sie zuerst den Test.</translation>
    </message>
    <message>
        <source>What the axes and buttons of a gamepad, joystick, tablet or 3D mouse do, and their calibration</source>
        <translation>Was die Achsen und Tasten eines Gamepads, Joysticks, Grafiktabletts oder einer 3D-Maus tun, und ihre Kalibrierung</translation>
    </message>
    <message>
        <source>Strength of the assist</source>
        <translation>Stärke der Unterstützung</translation>
    </message>
    <message>
        <source>Ceiling of a gamepad&apos;s vibration or a joystick&apos;s force, as a share of its strongest effect. Vibration: the strong motor shows how deep you push, the weak one how hard the tool cuts. A joystick pushes only while a button is held, in the test the first one. 0: off</source>
        <translation>Obergrenze für die Vibration eines Gamepads oder die Kraft eines Joysticks, als Anteil seiner stärksten Wirkung. Vibration: Der starke Motor zeigt, wie tief Sie drücken, der schwache, wie schwer das Werkzeug schneidet. Ein Joystick drückt nur, solange eine Taste gehalten wird, beim Test die erste. 0: aus</translation>
    </message>
    <message>
        <source>Distance from the stock</source>
        <translation>Abstand zum Rohteil</translation>
    </message>
    <message>
        <source>Distance that shank and holder keep from the stock, counted from the centres of its voxels, with every stylus, while “Keep from the stock” is on in the menu Mill. A change restarts milling.</source>
        <translation>Abstand, den Schaft und Halter zum Rohteil halten, gezählt von den Mitten seiner Voxel, mit jedem Stift, solange im Menü Fräsen „Abstand zum Rohteil halten“ eingeschaltet ist. Eine Änderung startet das Fräsen neu.</translation>
    </message>
</context>
<context>
    <name>burin::DeviceGains</name>
    <message>
        <source>Maximum stiffness</source>
        <translation>Größte Steifigkeit</translation>
    </message>
    <message>
        <source>The part never feels stiffer than this, whatever the device allows. 0: as stiff as it allows</source>
        <translation>Das Werkstück fühlt sich nie steifer an, was das Gerät auch erlaubt. 0: so steif, wie es erlaubt</translation>
    </message>
    <message>
        <source>Friction of the handle</source>
        <translation>Reibung des Griffs</translation>
    </message>
    <message>
        <source>Force with which a spring balance just moves the handle while the motors are off. It absorbs the steps of the encoders, and limits the suggested stiffness. 0: not measured</source>
        <translation>Kraft, mit der eine Federwaage den Griff bei abgeschalteten Motoren gerade bewegt. Sie nimmt die Schritte der Geber auf und begrenzt die vorgeschlagene Steifigkeit. 0: nicht gemessen</translation>
    </message>
    <message>
        <source>Use the suggested gains</source>
        <translation>Vorgeschlagene Werte verwenden</translation>
    </message>
    <message>
        <source>Previous gains</source>
        <translation>Vorherige Werte</translation>
    </message>
    <message>
        <source>Test a device with motors first: its rate and latency are measured for this.</source>
        <translation>Zuerst ein Gerät mit Motoren testen: Dafür werden seine Rate und Verzögerung gemessen.</translation>
    </message>
    <message>
        <source>The suggested gains are in use.</source>
        <translation>Die vorgeschlagenen Werte sind in Gebrauch.</translation>
    </message>
    <message>
        <source>Use the stiffness and damping that the test suggests for this device, the next time you mill. “Previous gains” takes it back.</source>
        <translation>Beim nächsten Fräsen die Steifigkeit und Dämpfung verwenden, die der Test für dieses Gerät vorschlägt. „Vorherige Werte“ nimmt es zurück.</translation>
    </message>
    <message>
        <source>The gains of this device were not changed.</source>
        <translation>Die Werte dieses Geräts wurden nicht geändert.</translation>
    </message>
    <message>
        <source>Use the stiffness and damping from before the last change again</source>
        <translation>Wieder die Steifigkeit und Dämpfung von vor der letzten Änderung verwenden</translation>
    </message>
</context>
<context>
    <name>burin::DeviceTester</name>
    <message>
        <source>Looking for devices</source>
        <translation>Geräte werden gesucht</translation>
    </message>
    <message>
        <source>Testing %1</source>
        <translation>%1 wird getestet</translation>
    </message>
</context>
<context>
    <name>burin::DocumentController</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
</context>
<context>
    <name>burin::DocumentFlow</name>
    <message>
        <source>The file was moved, renamed or deleted, or its drive is not connected.</source>
        <translation>Die Datei wurde verschoben, umbenannt oder gelöscht, oder ihr Laufwerk ist nicht verbunden.</translation>
    </message>
    <message>
        <source>Remove “%1” from the list of recent files?</source>
        <translation>„%1“ aus der Liste der zuletzt benutzten Dateien entfernen?</translation>
    </message>
    <message>
        <source>Remove it from the list</source>
        <translation>Aus der Liste entfernen</translation>
    </message>
    <message>
        <source>workpiece</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>“%1” is an NC program: open its project or embed its part first, then open the program again.</source>
        <translation>„%1“ ist ein NC-Programm: Zuerst sein Projekt öffnen oder sein Teil einbetten, dann das Programm erneut öffnen.</translation>
    </message>
    <message>
        <source>“%1” becomes a path of a job: open its project or embed its part first, then open it again.</source>
        <translation>„%1“ wird eine Bahn eines Auftrags: Öffnen Sie zuerst das Projekt oder betten Sie das Teil ein, dann öffnen Sie die Datei noch einmal.</translation>
    </message>
</context>
<context>
    <name>burin::EditCard</name>
    <message>
        <source>Switch this edit on or off</source>
        <translation>Diese Bearbeitung ein- oder ausschalten</translation>
    </message>
    <message>
        <source>%1 → %2 points</source>
        <translation>%1 → %2 Punkte</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>Abweichung %1</translation>
    </message>
    <message>
        <source>Apply this edit earlier</source>
        <translation>Diese Bearbeitung früher anwenden</translation>
    </message>
    <message>
        <source>Apply this edit later</source>
        <translation>Diese Bearbeitung später anwenden</translation>
    </message>
    <message>
        <source>Delete this edit</source>
        <translation>Diese Bearbeitung löschen</translation>
    </message>
    <message>
        <source>Update this edit to its current version; its result changes</source>
        <translation>Diese Bearbeitung auf ihre heutige Fassung bringen; ihr Ergebnis ändert sich</translation>
    </message>
    <message>
        <source>Show in the view where the error is the largest</source>
        <translation>In der Ansicht zeigen, wo der Fehler am größten ist</translation>
    </message>
</context>
<context>
    <name>burin::EditFieldEditor</name>
    <message>
        <source>Draw it in the view; Esc leaves it as it is</source>
        <translation>In der Ansicht zeichnen; Esc lässt es, wie es ist</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <translation>%1 zeichnen</translation>
    </message>
</context>
<context>
    <name>burin::EmbeddingFindings</name>
    <message>
        <source>Findings of embedding</source>
        <translation>Befunde beim Einbetten</translation>
    </message>
    <message>
        <source>And %1 more, which “burin embed” lists.</source>
        <translation>Und %1 weitere, die „burin embed“ auflistet.</translation>
    </message>
</context>
<context>
    <name>burin::ExcessPresenter</name>
    <message>
        <source>%1 left on the part</source>
        <translation>%1 Restmaterial auf dem Teil</translation>
    </message>
</context>
<context>
    <name>burin::FaceController</name>
    <message>
        <source>Inspecting the faces</source>
        <translation>Flächen werden geprüft</translation>
    </message>
</context>
<context>
    <name>burin::FaceDialog</name>
    <message>
        <source>Faces of the part</source>
        <translation>Flächen des Teils</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop inspecting the faces</source>
        <translation>Das Prüfen der Flächen abbrechen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the table in its order, in mm, to paste it into a spreadsheet (Ctrl+C)</source>
        <translation>Die Tabelle in ihrer Reihenfolge und in mm kopieren, um sie in eine Tabellenkalkulation einzufügen (Strg+C)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Write the table in its order, in mm, as a CSV file</source>
        <translation>Die Tabelle in ihrer Reihenfolge und in mm als CSV-Datei schreiben</translation>
    </message>
    <message>
        <source>What the program leaves on each face of the part.</source>
        <translation>Was das Programm auf jeder Fläche des Teils hinterlässt.</translation>
    </message>
    <message>
        <source>Faces: %1. With gouges: %2. With too much stock: %3. Select a face to see its worst point.</source>
        <translation>Flächen: %1. Mit Konturverletzungen: %2. Mit zu viel Material: %3. Wählen Sie eine Fläche, um ihre schlimmste Stelle zu sehen.</translation>
    </message>
    <message>
        <source>Inspecting the faces</source>
        <translation>Flächen werden geprüft</translation>
    </message>
</context>
<context>
    <name>burin::FacePicker</name>
    <message>
        <source>Esc: cancel the selection of a face</source>
        <translation>Esc: Auswahl der Fläche abbrechen</translation>
    </message>
</context>
<context>
    <name>burin::FacePresenter</name>
    <message>
        <source>There is no checked program, or something has changed since; post and check it again.</source>
        <translation>Es gibt kein geprüftes Programm, oder seither hat sich etwas geändert; geben Sie es neu aus und prüfen Sie es.</translation>
    </message>
    <message>
        <source>Face %1: %2 too deep</source>
        <translation>Fläche %1: %2 zu tief</translation>
    </message>
    <message>
        <source>Face %1: %2 left</source>
        <translation>Fläche %1: %2 Rest</translation>
    </message>
    <message>
        <source>Face %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>Cancelled; open the table again to inspect the faces.</source>
        <translation>Abgebrochen; öffnen Sie die Tabelle neu, um die Flächen zu prüfen.</translation>
    </message>
</context>
<context>
    <name>burin::FaceTableModel</name>
    <message>
        <source>Too small for the voxels: no point of this face was looked at; use smaller voxels</source>
        <translation>Zu klein für die Voxel: kein Punkt dieser Fläche wurde betrachtet; verwenden Sie kleinere Voxel</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Number in the order of the part&apos;s file</source>
        <translation>Nummer in der Reihenfolge der Datei des Teils</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Shape of the face, with its diameter</source>
        <translation>Form der Fläche, mit ihrem Durchmesser</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Area of the whole face</source>
        <translation>Inhalt der ganzen Fläche</translation>
    </message>
    <message>
        <source>Worst gouge</source>
        <translation>Tiefste Verletzung</translation>
    </message>
    <message>
        <source>Deepest cut into the part on this face</source>
        <translation>Tiefster Schnitt in das Teil auf dieser Fläche</translation>
    </message>
    <message>
        <source>Most left</source>
        <translation>Größter Rest</translation>
    </message>
    <message>
        <source>Most stock beyond the allowance, where a tool of the program could reach it</source>
        <translation>Größtes Restmaterial über das Aufmaß hinaus, wo ein Werkzeug des Programms hinkommt</translation>
    </message>
    <message>
        <source>In tolerance</source>
        <translation>In Toleranz</translation>
    </message>
    <message>
        <source>Share of the face that is within tolerance</source>
        <translation>Anteil der Fläche, der innerhalb der Toleranz liegt</translation>
    </message>
    <message>
        <source>Gouged</source>
        <translation>Verletzt</translation>
    </message>
    <message>
        <source>Too much left</source>
        <translation>Zu viel Rest</translation>
    </message>
    <message>
        <source>Share of the face with more stock than the tolerance allows</source>
        <translation>Anteil der Fläche mit mehr Material, als die Toleranz erlaubt</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>Unerreichbar</translation>
    </message>
    <message>
        <source>Share of the face with stock that no tool of the program can reach</source>
        <translation>Anteil der Fläche mit Material, zu dem kein Werkzeug des Programms kommt</translation>
    </message>
    <message>
        <source>Share of the face&apos;s points where a gouge deeper than the tolerance is marked. Each position of the tool marks the point that is nearest to its deepest one, so more of the face may be cut into</source>
        <translation>Anteil der Punkte der Fläche, an denen eine Konturverletzung tiefer als die Toleranz vermerkt ist. Jede Stellung des Werkzeugs vermerkt den Punkt, der ihrem tiefsten am nächsten liegt; verletzt sein kann also mehr von der Fläche</translation>
    </message>
</context>
<context>
    <name>burin::FixtureDialog</name>
    <message>
        <source>Click the stock or the table in the view, or drag, to place it. In the view, the arrow keys move it by 1 mm (Shift: 0.1 mm, Ctrl: 10 mm), R rotates it by 15° (Shift: 90°), Enter accepts it.</source>
        <translation>Klicken Sie in der Ansicht auf das Rohteil oder den Tisch, oder ziehen Sie, um sie zu platzieren. In der Ansicht verschieben die Pfeiltasten sie um 1 mm (Umschalt: 0,1 mm, Strg: 10 mm), R dreht sie um 15° (Umschalt: 90°), die Eingabetaste übernimmt sie.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Kind of fixture of the library</source>
        <translation>Art der Vorrichtung aus der Bibliothek</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Origin of the fixture, from program zero</source>
        <translation>Ursprung der Vorrichtung, vom Programmnullpunkt aus</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>About Z, through its origin</source>
        <translation>Um Z durch ihren Ursprung</translation>
    </message>
    <message>
        <source>Rotate it about Z</source>
        <translation>Um Z drehen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Nichts ändern</translation>
    </message>
    <message>
        <source>Change a fixture</source>
        <translation>Vorrichtung ändern</translation>
    </message>
    <message>
        <source>Add a fixture</source>
        <translation>Vorrichtung hinzufügen</translation>
    </message>
    <message>
        <source>%1 X, Y, Z, in %2</source>
        <translation>%1 X, Y, Z in %2</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Change the fixture of the setup</source>
        <translation>Die Vorrichtung der Aufspannung ändern</translation>
    </message>
    <message>
        <source>Add the fixture to the setup</source>
        <translation>Die Vorrichtung zur Aufspannung hinzufügen</translation>
    </message>
    <message>
        <source>Sizes of the fixture</source>
        <translation>Maße der Vorrichtung</translation>
    </message>
    <message>
        <source>There is no stock where the fixture clamps.</source>
        <translation>Wo die Vorrichtung spannt, ist kein Rohteil.</translation>
    </message>
    <message>
        <source>The fixture doesn&apos;t touch the stock: a gap of %1 remains.</source>
        <translation>Die Vorrichtung berührt das Rohteil nicht: Es bleibt ein Spalt von %1.</translation>
    </message>
</context>
<context>
    <name>burin::FixtureDrawing</name>
    <message>
        <source>Drawing of the fixture, to scale</source>
        <translation>Maßstäbliche Zeichnung der Vorrichtung</translation>
    </message>
</context>
<context>
    <name>burin::FixturePlacer</name>
    <message>
        <source>Esc: cancel placing the fixture</source>
        <translation>Esc: Platzieren der Vorrichtung abbrechen</translation>
    </message>
</context>
<context>
    <name>burin::GizmoTool</name>
    <message>
        <source>Esc: back to where it was</source>
        <translation>Esc: zurück an die vorige Lage</translation>
    </message>
</context>
<context>
    <name>burin::GuideCard</name>
    <message>
        <source>Step-over</source>
        <translation>Zeilenabstand</translation>
    </message>
    <message>
        <source>Switch this guide on or off</source>
        <translation>Diese Führung ein- oder ausschalten</translation>
    </message>
    <message>
        <source>Delete this guide</source>
        <translation>Diese Führung löschen</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer zu</translation>
    </message>
    <message>
        <source>Where the plane is</source>
        <translation>Wo die Ebene liegt</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Where the line is</source>
        <translation>Wo die Gerade liegt</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance of the cutter from the part</source>
        <translation>Abstand des Fräsers vom Teil</translation>
    </message>
    <message>
        <source>Distance of the next pass from the last one</source>
        <translation>Abstand der nächsten Zeile von der letzten</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Vorlauf</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>From the part&apos;s surface</source>
        <translation>Von der Oberfläche des Teils</translation>
    </message>
    <message>
        <source>Lead and tilt start from the part&apos;s surface, else from the Z axis</source>
        <translation>Vorlauf und Neigung gehen von der Oberfläche des Teils aus, sonst von der Z-Achse</translation>
    </message>
    <message>
        <source>active on level %1</source>
        <translation>aktiv auf Ebene %1</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>waits for another</source>
        <translation>wartet auf eine andere</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 entfernt</translation>
    </message>
    <message>
        <source>Axis of the setup along which the levels follow each other</source>
        <translation>Achse der Aufspannung, entlang der die Ebenen aufeinander folgen</translation>
    </message>
    <message>
        <source>Distance between levels</source>
        <translation>Abstand der Ebenen</translation>
    </message>
    <message>
        <source>Position of one of the levels</source>
        <translation>Lage einer der Ebenen</translation>
    </message>
    <message>
        <source>Lead angle: the tool leans in the direction of motion</source>
        <translation>Voreilwinkel: Das Werkzeug neigt sich in Bewegungsrichtung</translation>
    </message>
    <message>
        <source>Tilt angle: the tool leans to the left of the direction of motion</source>
        <translation>Seitenwinkel: Das Werkzeug neigt sich links der Bewegungsrichtung</translation>
    </message>
</context>
<context>
    <name>burin::GuideController</name>
    <message>
        <source>Following the part&apos;s edges</source>
        <translation>Kanten des Teils werden verfolgt</translation>
    </message>
    <message>
        <source>new guide</source>
        <translation>neue Führung</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>guide deleted</source>
        <translation>Führung gelöscht</translation>
    </message>
</context>
<context>
    <name>burin::GuidePanel</name>
    <message>
        <source>Guides</source>
        <translation>Führungen</translation>
    </message>
    <message>
        <source>There is no guide yet. A guide attracts the tool nearby, and releases it when it is pushed away.</source>
        <translation>Noch gibt es keine Führung. Eine Führung zieht das Werkzeug in ihrer Nähe an und gibt es frei, wenn es weggedrückt wird.</translation>
    </message>
    <message>
        <source>Guides on</source>
        <translation>Führungen ein</translation>
    </message>
    <message>
        <source>Switch all guides on or off</source>
        <translation>Alle Führungen ein- oder ausschalten</translation>
    </message>
    <message>
        <source>Kind of guide</source>
        <translation>Art der Führung</translation>
    </message>
    <message>
        <source>Kind of guide to add</source>
        <translation>Art der Führung, die hinzukommt</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Level above</source>
        <translation>Ebene darüber</translation>
    </message>
    <message>
        <source>Level below</source>
        <translation>Ebene darunter</translation>
    </message>
    <message>
        <source>No more guides can be added. Delete one first.</source>
        <translation>Mehr Führungen sind nicht möglich. Löschen Sie zuerst eine.</translation>
    </message>
    <message>
        <source>This part is a mesh, which has no edges to follow.</source>
        <translation>Dieses Teil ist ein Netz; es hat keine Kanten, denen man folgen könnte.</translation>
    </message>
    <message>
        <source>A guide along the edge of the part that is nearest to the tool</source>
        <translation>Eine Führung an der Kante des Teils, die dem Werkzeug am nächsten ist</translation>
    </message>
    <message>
        <source>Adds a guide. If guides contradict each other, the upper one applies</source>
        <translation>Fügt eine Führung hinzu. Widersprechen sich Führungen, so gilt die obere</translation>
    </message>
    <message>
        <source>No guide has levels or passes.</source>
        <translation>Keine Führung hat Ebenen oder Zeilen.</translation>
    </message>
    <message>
        <source>Press Mill first.</source>
        <translation>Drücken Sie zuerst „Fräsen“.</translation>
    </message>
    <message>
        <source>The guide takes the next level above, or ends the pass</source>
        <translation>Die Führung nimmt die nächste Ebene darüber oder beendet die Zeile</translation>
    </message>
    <message>
        <source>The guide takes the next level below, or ends the pass</source>
        <translation>Die Führung nimmt die nächste Ebene darunter oder beendet die Zeile</translation>
    </message>
</context>
<context>
    <name>burin::HandController</name>
    <message>
        <source>scale of the hand</source>
        <translation>Maßstab der Hand</translation>
    </message>
    <message>
        <source>alignment of the hand</source>
        <translation>Ausrichtung der Hand</translation>
    </message>
    <message>
        <source>control of the hand</source>
        <translation>Steuerung der Hand</translation>
    </message>
    <message>
        <source>clutch button</source>
        <translation>Kupplungstaste</translation>
    </message>
    <message>
        <source>level button</source>
        <translation>Ebenentaste</translation>
    </message>
    <message>
        <source>force button</source>
        <translation>Krafttaste</translation>
    </message>
</context>
<context>
    <name>burin::HandKeys</name>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Moves the tool above the workpiece.</source>
        <translation>Bewegt das Werkzeug über dem Werkstück.</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Links ziehen</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>Raises and lowers the tool.</source>
        <translation>Hebt und senkt das Werkzeug.</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Rechts ziehen</translation>
    </message>
    <message>
        <source>Rotates the view.</source>
        <translation>Dreht die Ansicht.</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>Move the tool by a voxel.</source>
        <translation>Bewegen das Werkzeug um ein Voxel.</translation>
    </message>
    <message>
        <source>Page up, down</source>
        <translation>Bild auf, ab</translation>
    </message>
    <message>
        <source>Raise and lower the tool.</source>
        <translation>Heben und senken das Werkzeug.</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Keeps the spindle on.</source>
        <translation>Lässt die Spindel laufen.</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Selects a point of the path, or a move of the program.</source>
        <translation>Wählt einen Punkt der Bahn oder eine Bewegung des Programms aus.</translation>
    </message>
    <message>
        <source>Shift and click</source>
        <translation>Umschalt und Klick</translation>
    </message>
    <message>
        <source>Selects everything from the last selected point to this one.</source>
        <translation>Wählt alles vom zuletzt ausgewählten Punkt bis zu diesem aus.</translation>
    </message>
    <message>
        <source>Moves the point; while something is drawn, draws it.</source>
        <translation>Verschiebt den Punkt; wird gerade gezeichnet, zeichnet es.</translation>
    </message>
    <message>
        <source>Cancels the current action, else clears the selection.</source>
        <translation>Bricht ab, was im Gange ist, oder hebt die Auswahl auf.</translation>
    </message>
    <message>
        <source>Right or middle drag</source>
        <translation>Rechts oder Mitte ziehen</translation>
    </message>
    <message>
        <source>Rotates the view about the point under the pointer.</source>
        <translation>Dreht die Ansicht um den Punkt unter dem Zeiger.</translation>
    </message>
    <message>
        <source>Shift and middle drag</source>
        <translation>Umschalt und Mitte ziehen</translation>
    </message>
    <message>
        <source>Pans the view; so does a drag with both buttons.</source>
        <translation>Verschiebt die Ansicht; Ziehen mit beiden Tasten auch.</translation>
    </message>
    <message>
        <source>Zooms in on the point under the pointer.</source>
        <translation>Holt den Punkt unter dem Zeiger näher.</translation>
    </message>
    <message>
        <source>Click on the cube</source>
        <translation>Klick auf den Würfel</translation>
    </message>
    <message>
        <source>Looks at that side.</source>
        <translation>Blickt auf diese Seite.</translation>
    </message>
    <message>
        <source>Cuts a stroke, or draws the rectangle of a raster.</source>
        <translation>Schneidet einen Zug oder zieht das Rechteck eines Rasters auf.</translation>
    </message>
    <message>
        <source>Cuts a straight line from the end of the last stroke.</source>
        <translation>Schneidet gerade weiter vom Ende des letzten Zugs.</translation>
    </message>
    <message>
        <source>X, Y</source>
        <translation>X, Y</translation>
    </message>
    <message>
        <source>Locks strokes to X or to Y; again to unlock.</source>
        <translation>Legt Züge auf X oder Y fest; noch einmal gibt sie frei.</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Locks strokes to their direction; again to unlock.</source>
        <translation>Legt Züge auf ihre Richtung fest; noch einmal gibt sie frei.</translation>
    </message>
    <message>
        <source>Fine motion of a stroke and of the wheel.</source>
        <translation>Feine Bewegung von Zug und Rad.</translation>
    </message>
    <message>
        <source>Ends the stroke, then stops milling.</source>
        <translation>Beendet den Zug, dann das Fräsen.</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>Opens the menu of a point of the path.</source>
        <translation>Öffnet das Menü eines Punktes der Bahn.</translation>
    </message>
    <message>
        <source>Click, left drag</source>
        <translation>Klick, links ziehen</translation>
    </message>
    <message>
        <source>Places the fixture on the stock, or on the table beside it.</source>
        <translation>Platziert die Vorrichtung auf dem Rohteil oder auf dem Tisch daneben.</translation>
    </message>
    <message>
        <source>Move it by 1 mm; with Shift by 0.1 mm, with Ctrl by 10 mm.</source>
        <translation>Verschieben sie um 1 mm; mit Umschalt um 0,1 mm, mit Strg um 10 mm.</translation>
    </message>
    <message>
        <source>Raise and lower it, by the same steps.</source>
        <translation>Heben und senken sie in denselben Schritten.</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Rotates it by 15°; with Shift by 90°.</source>
        <translation>Dreht sie um 15°; mit Umschalt um 90°.</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Adds it to the setup.</source>
        <translation>Fügt sie zur Aufspannung hinzu.</translation>
    </message>
    <message>
        <source>Cancels placing.</source>
        <translation>Bricht das Platzieren ab.</translation>
    </message>
    <message>
        <source>Drag a handle</source>
        <translation>Griff ziehen</translation>
    </message>
    <message>
        <source>Moves or rotates the part or a fixture; with Shift finely, with Ctrl in steps. Esc takes it back.</source>
        <translation>Verschiebt oder dreht das Teil oder eine Vorrichtung; mit Umschalt fein, mit Strg in Schritten. Esc nimmt es zurück.</translation>
    </message>
</context>
<context>
    <name>burin::HandPanel</name>
    <message>
        <source>Hand and tool</source>
        <translation>Hand und Werkzeug</translation>
    </message>
    <message>
        <source>Clutch button</source>
        <translation>Kupplungstaste</translation>
    </message>
    <message>
        <source>Level button</source>
        <translation>Ebenentaste</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Dead man&apos;s switch: the stylus has forces only while this button is held</source>
        <translation>Totmannschalter: Der Stift hat nur Kraft, solange diese Taste gehalten wird</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Heat of the motors</source>
        <translation>Wärme der Motoren</translation>
    </message>
    <message>
        <source>Share of the motors&apos; limit, as the device reports it</source>
        <translation>Anteil an der Grenze der Motoren, wie das Gerät ihn meldet</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Tool movement divided by hand movement</source>
        <translation>Bewegung des Werkzeugs geteilt durch die Bewegung der Hand</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>Auskuppeln</translation>
    </message>
    <message>
        <source>Recentre</source>
        <translation>Zentrieren</translation>
    </message>
    <message>
        <source>Align with the view</source>
        <translation>An der Ansicht ausrichten</translation>
    </message>
    <message>
        <source>By position</source>
        <translation>Nach Position</translation>
    </message>
    <message>
        <source>The tool follows the position of the hand</source>
        <translation>Das Werkzeug folgt der Position der Hand</translation>
    </message>
    <message>
        <source>By speed</source>
        <translation>Nach Tempo</translation>
    </message>
    <message>
        <source>The farther the stylus is from its centre, the faster the tool moves</source>
        <translation>Je weiter der Stift von seiner Mitte entfernt ist, desto schneller bewegt sich das Werkzeug</translation>
    </message>
    <message>
        <source>while button %1 is held (spindle)</source>
        <translation>solange Taste %1 gehalten wird (Spindel)</translation>
    </message>
    <message>
        <source>button %1</source>
        <translation>Taste %1</translation>
    </message>
    <message>
        <source>The hand moves, the tool stays</source>
        <translation>Die Hand bewegt sich, das Werkzeug bleibt stehen</translation>
    </message>
    <message>
        <source>A hand movement to the right moves the tool to the right in the view</source>
        <translation>Eine Handbewegung nach rechts bewegt das Werkzeug in der Ansicht nach rechts</translation>
    </message>
    <message>
        <source>Brings the hand back to the centre of the device&apos;s workspace while you work</source>
        <translation>Bringt die Hand während der Arbeit in die Mitte des Arbeitsraums des Geräts zurück</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>always</source>
        <translation>immer</translation>
    </message>
    <message>
        <source>Stop the recording first.</source>
        <translation>Beenden Sie zuerst die Aufzeichnung.</translation>
    </message>
    <message>
        <source>%1, charging</source>
        <translation>%1, lädt</translation>
    </message>
    <message>
        <source>The mouse points into the view directly. The movements of a device are scaled here.</source>
        <translation>Die Maus zeigt direkt in die Ansicht. Die Bewegungen eines Geräts werden hier skaliert.</translation>
    </message>
    <message>
        <source>The tool does not move while this button of the stylus is held</source>
        <translation>Das Werkzeug bewegt sich nicht, während dieser Knopf des Stifts gedrückt ist</translation>
    </message>
    <message>
        <source>This button of the stylus requests the next lower level, or ends a pass</source>
        <translation>Dieser Knopf des Stifts fordert die nächsttiefere Ebene an oder beendet eine Zeile</translation>
    </message>
    <message>
        <source>with button 1</source>
        <translation>mit Taste 1</translation>
    </message>
</context>
<context>
    <name>burin::HelpDialog</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>In der Hilfe suchen</translation>
    </message>
    <message>
        <source>Only topics that contain these words are shown.</source>
        <translation>Nur Themen, die diese Wörter enthalten, werden gezeigt.</translation>
    </message>
    <message>
        <source>Topics</source>
        <translation>Themen</translation>
    </message>
    <message>
        <source>Page of the help</source>
        <translation>Seite der Hilfe</translation>
    </message>
    <message>
        <source>No topic contains these words.</source>
        <translation>Kein Thema enthält diese Wörter.</translation>
    </message>
</context>
<context>
    <name>burin::HolePicker</name>
    <message>
        <source>Esc or Enter: back to the pass</source>
        <translation>Esc oder Eingabe: zurück zum Durchgang</translation>
    </message>
</context>
<context>
    <name>burin::HolePresenter</name>
    <message>
        <source>Click the holes of the pass; a second click removes a hole. Enter or Esc goes back to the pass.</source>
        <translation>Klicken Sie die Bohrungen des Durchgangs an; ein zweiter Klick entfernt eine. Eingabe oder Esc führt zum Durchgang zurück.</translation>
    </message>
    <message>
        <source>Removed: %1.</source>
        <translation>Entfernt: %1.</translation>
    </message>
    <message>
        <source>Picked: %1.</source>
        <translation>Gewählt: %1.</translation>
    </message>
    <message>
        <source>1 hole is picked.</source>
        <translation>1 Bohrung ist gewählt.</translation>
    </message>
    <message numerus="yes">
        <source>%n holes are picked.</source>
        <translation>
            <numerusform>%n Bohrung ist gewählt.</numerusform>
            <numerusform>%n Bohrungen sind gewählt.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no round upright hole here. Click the wall of a hole, or inside it.</source>
        <translation>Hier ist keine runde senkrechte Bohrung. Klicken Sie auf die Wand einer Bohrung oder in sie hinein.</translation>
    </message>
    <message>
        <source>There is no round upright hole or stud here. Click the wall of a hole, inside it, or a stud.</source>
        <translation>Hier ist weder eine runde senkrechte Bohrung noch ein Zapfen. Klicken Sie auf die Wand einer Bohrung, in sie hinein oder auf einen Zapfen.</translation>
    </message>
    <message>
        <source>Click the holes or the studs of the pass; a second click removes one. Enter or Esc goes back to the pass.</source>
        <translation>Klicken Sie auf die Bohrungen oder die Zapfen des Durchgangs; ein zweiter Klick entfernt eine Wahl. Eingabe oder Esc führt zum Durchgang zurück.</translation>
    </message>
    <message>
        <source>1 stud is picked.</source>
        <translation>1 Zapfen ist gewählt.</translation>
    </message>
    <message numerus="yes">
        <source>%n studs are picked.</source>
        <translation>
            <numerusform>%n Zapfen ist gewählt.</numerusform>
            <numerusform>%n Zapfen sind gewählt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>burin::JobEvaluation</name>
    <message>
        <source>Editing the path</source>
        <translation>Bahn wird bearbeitet</translation>
    </message>
</context>
<context>
    <name>burin::JobPresenter</name>
    <message>
        <source>importing</source>
        <translation>wird importiert</translation>
    </message>
    <message>
        <source>import one</source>
        <translation>importieren</translation>
    </message>
    <message>
        <source>no part yet</source>
        <translation>noch kein Teil</translation>
    </message>
    <message>
        <source>can&apos;t be embedded</source>
        <translation>nicht einbettbar</translation>
    </message>
    <message>
        <source>embedding</source>
        <translation>wird eingebettet</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>virtual operator</source>
        <translation>virtueller Bediener</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung läuft</translation>
    </message>
    <message>
        <source>no take yet</source>
        <translation>keine Aufnahme</translation>
    </message>
    <message>
        <source>wait for the boundary</source>
        <translation>Grenzfläche fehlt</translation>
    </message>
    <message>
        <source>embed first</source>
        <translation>erst einbetten</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>nicht möglich</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>Abw. %1</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>wird geprüft</translation>
    </message>
    <message>
        <source>no path yet</source>
        <translation>noch keine Bahn</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>1 take</source>
        <translation>1 Aufnahme</translation>
    </message>
    <message numerus="yes">
        <source>%n takes</source>
        <translation>
            <numerusform>%n Aufnahme</numerusform>
            <numerusform>%n Aufnahmen</numerusform>
        </translation>
    </message>
    <message>
        <source>being made</source>
        <translation>in Arbeit</translation>
    </message>
    <message>
        <source>waits for the workpiece</source>
        <translation>wartet auf Werkstück</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>bearbeitet</translation>
    </message>
    <message>
        <source>overridden</source>
        <translation>übergangen</translation>
    </message>
    <message>
        <source>no boundary</source>
        <translation>keine Grenzfläche</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>ungeprüft</translation>
    </message>
    <message>
        <source>part doubtful</source>
        <translation>Teil zweifelhaft</translation>
    </message>
    <message>
        <source>1 path</source>
        <translation>1 Bahn</translation>
    </message>
    <message numerus="yes">
        <source>%n paths</source>
        <translation>
            <numerusform>%n Bahn</numerusform>
            <numerusform>%n Bahnen</numerusform>
        </translation>
    </message>
    <message>
        <source>preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>burin::KeyList</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Search for a key or its effect</source>
        <translation>Nach einer Taste oder ihrer Wirkung suchen</translation>
    </message>
    <message>
        <source>Only lines that contain this text are shown.</source>
        <translation>Nur Zeilen mit diesem Text werden gezeigt.</translation>
    </message>
    <message>
        <source>No key does that.</source>
        <translation>Das tut keine Taste.</translation>
    </message>
</context>
<context>
    <name>burin::LayerFields</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the layer, each once</source>
        <translation>Name der Schicht, jeder nur einmal</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Material of the layer</source>
        <translation>Werkstoff der Schicht</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer zu</translation>
    </message>
    <message>
        <source>Axis that both planes of the layer stand across</source>
        <translation>Achse, zu der beide Ebenen der Schicht quer stehen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Position of the plane, in the model&apos;s frame</source>
        <translation>Position der Ebene, im Koordinatensystem des Modells</translation>
    </message>
    <message>
        <source>Its values</source>
        <translation>Ihre Werte</translation>
    </message>
    <message>
        <source>The same everywhere, or changing from place to place</source>
        <translation>Überall gleich oder von Stelle zu Stelle anders</translation>
    </message>
    <message>
        <source>The same everywhere</source>
        <translation>Überall gleich</translation>
    </message>
    <message>
        <source>By a formula</source>
        <translation>Nach einer Formel</translation>
    </message>
    <message>
        <source>By a table</source>
        <translation>Nach einer Tabelle</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Was sich ändert</translation>
    </message>
    <message>
        <source>Value of the material that changes</source>
        <translation>Wert des Werkstoffs, der sich ändert</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Axis that the positions of the table lie on</source>
        <translation>Achse, auf der die Positionen der Tabelle liegen</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>Of X, Y and Z in mm, as 0.4 + 0.02 * Z; or a table: position value; position value; …</source>
        <translation>Aus X, Y und Z in mm, etwa 0.4 + 0.02 * Z; oder eine Tabelle: Position Wert; Position Wert; …</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Equally high bands that the values are sorted into</source>
        <translation>Gleich hohe Stufen, in die die Werte eingeteilt werden</translation>
    </message>
</context>
<context>
    <name>burin::LayerPanel</name>
    <message>
        <source>Layers of the stock</source>
        <translation>Schichten des Rohteils</translation>
    </message>
    <message>
        <source>What the stock holds</source>
        <translation>Was das Rohteil enthält</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>Neue Schicht</translation>
    </message>
    <message>
        <source>Delete the layer</source>
        <translation>Schicht löschen</translation>
    </message>
    <message>
        <source>Let the one before have the place</source>
        <translation>Der vorigen den Vorrang lassen</translation>
    </message>
    <message>
        <source>Let it have the place before the next</source>
        <translation>Ihr den Vorrang vor der nächsten geben</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Schicht %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>graded</source>
        <translation>abgestuft</translation>
    </message>
    <message>
        <source>%1&#xa0;g</source>
        <translation>%1&#xa0;g</translation>
    </message>
    <message>
        <source>mass not known: the material has no density</source>
        <translation>Masse unbekannt: Der Werkstoff hat keine Dichte</translation>
    </message>
    <message>
        <source>protected</source>
        <translation>geschützt</translation>
    </message>
    <message numerus="yes">
        <source>%1 from %2 to %3 %5 in %n bands: each place is within %4 %5.</source>
        <translation>
            <numerusform>%1 von %2 bis %3 %5 in %n Stufe: Jede Stelle ist auf %4 %5 genau.</numerusform>
            <numerusform>%1 von %2 bis %3 %5 in %n Stufen: Jede Stelle ist auf %4 %5 genau.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stock and material can&apos;t be changed once there are takes.</source>
        <translation>Sobald es Aufnahmen gibt, lassen sich Rohteil und Werkstoff nicht mehr ändern.</translation>
    </message>
    <message>
        <source>There is no layer.</source>
        <translation>Es gibt keine Schicht.</translation>
    </message>
    <message>
        <source>Import a part first.</source>
        <translation>Importieren Sie zuerst ein Teil.</translation>
    </message>
    <message>
        <source>No layer comes before it.</source>
        <translation>Vor ihr kommt keine Schicht.</translation>
    </message>
    <message>
        <source>No layer comes after it.</source>
        <translation>Nach ihr kommt keine Schicht.</translation>
    </message>
    <message>
        <source>Embed the part: then each material is listed with volume and mass.</source>
        <translation>Betten Sie das Teil ein: Dann wird jeder Werkstoff mit Volumen und Masse aufgeführt.</translation>
    </message>
    <message>
        <source>Free carving: there is no part, so nothing pushes the tool back.</source>
        <translation>Freies Schnitzen: Es gibt kein Teil, also hält nichts das Werkzeug zurück.</translation>
    </message>
</context>
<context>
    <name>burin::LibraryDialog</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Add from a file…</source>
        <translation>Aus einer Datei hinzufügen …</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window (Esc)</source>
        <translation>Dieses Fenster schließen (Esc)</translation>
    </message>
    <message>
        <source>own</source>
        <translation>eigen</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>in Gebrauch</translation>
    </message>
    <message>
        <source>Changed, and not saved yet.</source>
        <translation>Geändert und noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Nothing is changed.</source>
        <translation>Nichts ist geändert.</translation>
    </message>
    <message>
        <source>Keep the changed values (Ctrl+S)</source>
        <translation>Die geänderten Werte behalten (Strg+S)</translation>
    </message>
    <message>
        <source>Discard the changes (Ctrl+R)</source>
        <translation>Die Änderungen verwerfen (Strg+R)</translation>
    </message>
    <message>
        <source>Discard the changes of “%1”?</source>
        <translation>Die Änderungen an „%1“ verwerfen?</translation>
    </message>
    <message>
        <source>They are not saved. This can&apos;t be undone.</source>
        <translation>Sie sind nicht gespeichert. Das kann nicht rückgängig gemacht werden.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>“%1” was deleted; Undo brings it back.</source>
        <translation>„%1“ wurde gelöscht; „Rückgängig“ bringt es zurück.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Show those that contain all of these words (Ctrl+F)</source>
        <translation>Zeigt die, die alle diese Wörter enthalten (Strg+F)</translation>
    </message>
</context>
<context>
    <name>burin::LoadChart</name>
    <message>
        <source>Cutting force over the machining time</source>
        <translation>Schnittkraft über der Bearbeitungszeit</translation>
    </message>
    <message>
        <source>Peak %1 N</source>
        <translation>Spitze %1 N</translation>
    </message>
    <message>
        <source>Force, peak %1 N</source>
        <translation>Kraft, Spitze %1 N</translation>
    </message>
    <message>
        <source>Cutting force over the machining time without tool changes, which are dotted lines; click to go to the line that is cut at that time</source>
        <translation>Schnittkraft über der Bearbeitungszeit ohne Werkzeugwechsel, die gepunktete Linien sind; ein Klick führt zur Zeile, die dann gefräst wird</translation>
    </message>
</context>
<context>
    <name>burin::MachineDialog</name>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (Kopie)</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Maschinen</translation>
    </message>
    <message>
        <source>Copy this machine to one of your own and change that</source>
        <translation>Diese Maschine als eigene kopieren und die Kopie ändern</translation>
    </message>
    <message>
        <source>Add a machine file to your own machines</source>
        <translation>Eine Maschinendatei zu den eigenen Maschinen hinzufügen</translation>
    </message>
    <message>
        <source>Use for this project</source>
        <translation>Für dieses Projekt verwenden</translation>
    </message>
    <message>
        <source>typical</source>
        <translation>typisch</translation>
    </message>
    <message>
        <source>Typical values of its class, which can&apos;t be changed. Copy the machine and enter the values of your own.</source>
        <translation>Typische Werte ihrer Klasse, die nicht geändert werden können. Kopieren Sie die Maschine und geben Sie die Werte Ihrer eigenen ein.</translation>
    </message>
    <message>
        <source>Your own machine.</source>
        <translation>Ihre eigene Maschine.</translation>
    </message>
    <message>
        <source>The machines that Burin is shipped with can&apos;t be deleted.</source>
        <translation>Die mitgelieferten Maschinen können nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>Delete this machine; Undo brings it back (Del in the list)</source>
        <translation>Diese Maschine löschen; Rückgängig holt sie zurück (Entf in der Liste)</translation>
    </message>
    <message>
        <source>The programs are for this machine.</source>
        <translation>Die Programme sind für diese Maschine.</translation>
    </message>
    <message>
        <source>Make the programs of this project for this machine (Ctrl+Return)</source>
        <translation>Die Programme dieses Projekts für diese Maschine machen (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>There is a machine with the ID “%1” already; give the one in the file another ID.</source>
        <translation>Es gibt schon eine Maschine mit der ID „%1“; geben Sie der in der Datei eine andere ID.</translation>
    </message>
</context>
<context>
    <name>burin::MachineForm</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>NC dialect that the machine&apos;s control reads</source>
        <translation>NC-Dialekt, den die Steuerung der Maschine liest</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Verfahrweg</translation>
    </message>
    <message>
        <source>Travel X, Y, Z</source>
        <translation>Verfahrweg X, Y, Z</translation>
    </message>
    <message>
        <source>Tool change height</source>
        <translation>Werkzeugwechselhöhe</translation>
    </message>
    <message>
        <source>Height above program zero that is always free; below the travel of Z</source>
        <translation>Höhe über dem Programmnullpunkt, die immer frei ist; unter dem Verfahrweg von Z</translation>
    </message>
    <message>
        <source>Tool change time</source>
        <translation>Werkzeugwechselzeit</translation>
    </message>
    <message>
        <source>From chip to chip</source>
        <translation>Von Span zu Span</translation>
    </message>
    <message>
        <source>Feeds and rapids</source>
        <translation>Vorschub und Eilgang</translation>
    </message>
    <message>
        <source>Greatest feed</source>
        <translation>Größter Vorschub</translation>
    </message>
    <message>
        <source>While it cuts</source>
        <translation>Beim Schneiden</translation>
    </message>
    <message>
        <source>Rapid feed</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Of the fastest axis</source>
        <translation>Der schnellsten Achse</translation>
    </message>
    <message>
        <source>Greatest rate X, Y, Z</source>
        <translation>Größte Geschwindigkeit X, Y, Z</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>Eilgänge</translation>
    </message>
    <message>
        <source>Straight, all axes arrive together</source>
        <translation>Gerade, alle Achsen kommen gleichzeitig an</translation>
    </message>
    <message>
        <source>Each axis at its own rate (with bends)</source>
        <translation>Jede Achse mit eigener Geschwindigkeit (mit Knicken)</translation>
    </message>
    <message>
        <source>Straight, the tip at the rapid feed</source>
        <translation>Gerade, die Spitze im Eilgang</translation>
    </message>
    <message>
        <source>Accelerations</source>
        <translation>Beschleunigungen</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Acceleration X, Y, Z</source>
        <translation>Beschleunigung X, Y, Z</translation>
    </message>
    <message>
        <source>Of each axis</source>
        <translation>Jeder Achse</translation>
    </message>
    <message>
        <source>Jerk X, Y, Z</source>
        <translation>Ruck X, Y, Z</translation>
    </message>
    <message>
        <source>Limit of each axis</source>
        <translation>Grenze jeder Achse</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>Kleinste Drehzahl</translation>
    </message>
    <message>
        <source>At most the highest speed</source>
        <translation>Höchstens die größte Drehzahl</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Größte Drehzahl</translation>
    </message>
    <message>
        <source>Above 0</source>
        <translation>Über 0</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlung</translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation>Nicht angegeben</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Mist</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>Flood</source>
        <translation>Flut</translation>
    </message>
    <message>
        <source>Mist and flood</source>
        <translation>Nebel und Flut</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Exact stop</source>
        <translation>Genauhalt</translation>
    </message>
    <message>
        <source>As an arc within the tolerance</source>
        <translation>Als Bogen innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Blended within the tolerance</source>
        <translation>Innerhalb der Toleranz verschliffen</translation>
    </message>
    <message>
        <source>Tolerance of corners</source>
        <translation>Toleranz der Ecken</translation>
    </message>
    <message>
        <source>Decimal places</source>
        <translation>Nachkommastellen</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>Largest sweep</source>
        <translation>Größter Winkel</translation>
    </message>
    <message>
        <source>Of one block; 360° is a full circle</source>
        <translation>Eines Satzes; 360° ist ein Vollkreis</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>Kleinster Radius</translation>
    </message>
    <message>
        <source>Below the largest radius</source>
        <translation>Unter dem größten Radius</translation>
    </message>
    <message>
        <source>Largest radius</source>
        <translation>Größter Radius</translation>
    </message>
    <message>
        <source>Larger arcs are written as lines</source>
        <translation>Größere Bögen werden als Geraden geschrieben</translation>
    </message>
    <message>
        <source>Difference of the radii</source>
        <translation>Unterschied der Radien</translation>
    </message>
    <message>
        <source>Allowed between start and end of an arc</source>
        <translation>Zulässig zwischen Anfang und Ende eines Bogens</translation>
    </message>
    <message>
        <source>Torque over speed</source>
        <translation>Drehmoment über Drehzahl</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Parkposition</translation>
    </message>
    <message>
        <source>Home X, Y, Z</source>
        <translation>Parkposition X, Y, Z</translation>
    </message>
    <message>
        <source>At a machine position</source>
        <translation>An einer Maschinenposition</translation>
    </message>
    <message>
        <source>In machine coordinates, no farther from machine zero than the travel. Z is moved first, straight from above the work, so it has to be the top of the travel</source>
        <translation>In Maschinenkoordinaten, vom Maschinennullpunkt höchstens um den Verfahrweg entfernt. Z wird zuerst verfahren, gerade von der Stelle über dem Werkstück, muss also das obere Ende des Verfahrwegs sein</translation>
    </message>
    <message>
        <source>Continuous torque of the spindle. Between two points the power follows a straight line; without points: not stated</source>
        <translation>Dauerdrehmoment der Spindel. Zwischen zwei Punkten folgt die Leistung einer Geraden; ohne Punkte: nicht angegeben</translation>
    </message>
    <message>
        <source>Name in the list of machines</source>
        <translation>Name in der Liste der Maschinen</translation>
    </message>
    <message>
        <source>Source of the values that have none of their own</source>
        <translation>Quelle der Werte, die keine eigene haben</translation>
    </message>
    <message>
        <source>Travel of each axis</source>
        <translation>Verfahrweg jeder Achse</translation>
    </message>
    <message>
        <source>Parking position of the spindle for a tool change and at the end of a program (G53), if the dialect supports it</source>
        <translation>Parkposition der Spindel für einen Werkzeugwechsel und am Ende eines Programms (G53), wenn der Dialekt sie unterstützt</translation>
    </message>
    <message>
        <source>Maximum feed of each axis; at most the rapid feed, which applies to axes without a value</source>
        <translation>Größter Vorschub jeder Achse; höchstens der Eilgang, der für Achsen ohne Wert gilt</translation>
    </message>
    <message>
        <source>Motion of several axes in a rapid</source>
        <translation>Bewegung mehrerer Achsen im Eilgang</translation>
    </message>
    <message>
        <source>For axes without a value of their own</source>
        <translation>Für Achsen ohne eigenen Wert</translation>
    </message>
    <message>
        <source>Continuous power of the spindle</source>
        <translation>Dauerleistung der Spindel</translation>
    </message>
    <message>
        <source>Coolant that the machine can switch on</source>
        <translation>Kühlung, die die Maschine einschalten kann</translation>
    </message>
    <message>
        <source>Motion from one block to the next</source>
        <translation>Bewegung von einem Satz zum nächsten</translation>
    </message>
    <message>
        <source>Largest distance of the motion from a corner; above 0 unless the machine stops there</source>
        <translation>Größter Abstand der Bewegung von einer Ecke; über 0, wenn die Maschine dort nicht anhält</translation>
    </message>
    <message>
        <source>Blocks per second</source>
        <translation>Sätze je Sekunde</translation>
    </message>
    <message>
        <source>Maximum that the control executes</source>
        <translation>Höchstzahl, die die Steuerung ausführt</translation>
    </message>
    <message>
        <source>Decimal places of a coordinate in mm</source>
        <translation>Nachkommastellen einer Koordinate in mm</translation>
    </message>
    <message>
        <source>Characters per line</source>
        <translation>Zeichen je Zeile</translation>
    </message>
    <message>
        <source>Maximum that the control reads</source>
        <translation>Höchstwert, den die Steuerung liest</translation>
    </message>
    <message>
        <source>as stated in the machine&apos;s source</source>
        <translation>wie in der Quelle der Maschine angegeben</translation>
    </message>
</context>
<context>
    <name>burin::MainWindow</name>
    <message>
        <source>Delete this work?</source>
        <translation>Diese Arbeit löschen?</translation>
    </message>
    <message>
        <source>It was never saved. This can&apos;t be undone.</source>
        <translation>Sie wurde nie gespeichert. Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>%1[*] — Burin</source>
        <translation>%1[*] — Burin</translation>
    </message>
    <message>
        <source>Burin</source>
        <translation>Burin</translation>
    </message>
    <message>
        <source>The program was written to “%1”.</source>
        <translation>Das Programm steht in „%1“.</translation>
    </message>
    <message>
        <source>The folder can&apos;t be written, so this project is open for reading only; save it elsewhere to change it.</source>
        <translation>Der Ordner ist schreibgeschützt, das Projekt ist deshalb nur zum Lesen geöffnet; speichern Sie es anderswo, um es zu ändern.</translation>
    </message>
    <message>
        <source>The battery of “%1” is down to %2; charge it soon.</source>
        <translation>Der Akku von „%1“ hat noch %2; laden Sie ihn bald.</translation>
    </message>
    <message>
        <source>Burin ended before this work was saved; everything that was entered and recorded is restored.</source>
        <translation>Burin endete, bevor diese Arbeit gespeichert war; alles, was eingegeben und aufgezeichnet wurde, ist wiederhergestellt.</translation>
    </message>
    <message>
        <source>Mouse in the view</source>
        <translation>Maus in der Ansicht</translation>
    </message>
    <message>
        <source>In mill mode</source>
        <translation>Im Fräsmodus</translation>
    </message>
    <message>
        <source>On the path</source>
        <translation>Auf der Bahn</translation>
    </message>
    <message>
        <source>Drag to make the panel wider or narrower</source>
        <translation>Ziehen, um das Bedienfeld breiter oder schmaler zu machen</translation>
    </message>
    <message>
        <source>Esc: back to the project</source>
        <translation>Esc: zurück zum Projekt</translation>
    </message>
    <message>
        <source>The rest of the program from line %1 on passed its check and was written to “%2”.</source>
        <translation>Der Rest des Programms ab Zeile %1 hat die Prüfung bestanden und steht in „%2“.</translation>
    </message>
    <message>
        <source>Older unsaved work no longer belongs to this file; it was moved to “%1”.</source>
        <translation>Ältere, nicht gespeicherte Arbeit gehört nicht mehr zu dieser Datei; sie wurde nach „%1“ verschoben.</translation>
    </message>
    <message>
        <source>An earlier version of Burin saved this project; the previous file is kept as “%1”.</source>
        <translation>Dieses Projekt wurde mit einer früheren Fassung von Burin gespeichert; die bisherige Datei bleibt als „%1“ erhalten.</translation>
    </message>
    <message>
        <source>The workpiece was written to “%1”.</source>
        <translation>Das Werkstück wurde in „%1“ geschrieben.</translation>
    </message>
    <message>
        <source>“%1” gives no unit of length; it was read in mm.</source>
        <translation>„%1“ nennt keine Längeneinheit; es wurde in mm gelesen.</translation>
    </message>
    <message>
        <source>The tool “%1” is in the library. Its profile is at most %2 mm wider than what its flutes sweep, and never narrower.</source>
        <translation>Das Werkzeug „%1“ ist in der Bibliothek. Sein Profil ist höchstens %2 mm weiter als das, was seine Schneiden überstreichen, und nie enger.</translation>
    </message>
    <message>
        <source>The stock was rotated by an angle that is not a multiple of 90°. Its faces may be off by up to %1 mm; use smaller voxels to reduce this.</source>
        <translation>Das Rohteil wurde um einen Winkel gedreht, der kein Vielfaches von 90° ist. Seine Flächen können um bis zu %1 mm abweichen; kleinere Voxel verringern das.</translation>
    </message>
    <message>
        <source>The setup sheet was written to “%1”.</source>
        <translation>Das Einrichteblatt steht in „%1“.</translation>
    </message>
    <message>
        <source>The part has not changed.</source>
        <translation>Das Teil hat sich nicht geändert.</translation>
    </message>
    <message>
        <source>Changed bodies: %1.</source>
        <translation>Geänderte Körper: %1.</translation>
    </message>
    <message>
        <source>New bodies: %1.</source>
        <translation>Neue Körper: %1.</translation>
    </message>
    <message>
        <source>Removed bodies: %1.</source>
        <translation>Entfernte Körper: %1.</translation>
    </message>
    <message>
        <source>Stock and program zero stay where they are; check the programs again.</source>
        <translation>Rohteil und Programmnullpunkt bleiben, wo sie sind; prüfen Sie die Programme neu.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Hide the timeline</source>
        <translation>Zeitleiste ausblenden</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>Click an entry to undo or redo everything up to there.</source>
        <translation>Ein Klick auf einen Eintrag macht alles bis dorthin rückgängig oder wiederholt es.</translation>
    </message>
    <message>
        <source>Hide the history</source>
        <translation>Verlauf ausblenden</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Hide the project tree</source>
        <translation>Projektbaum ausblenden</translation>
    </message>
    <message>
        <source>1 dwell was left out.</source>
        <translation>1 Verweilzeit wurde weggelassen.</translation>
    </message>
    <message numerus="yes">
        <source>%n dwells were left out.</source>
        <translation>
            <numerusform>%n Verweilzeit wurde weggelassen.</numerusform>
            <numerusform>%n Verweilzeiten wurden weggelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>1 move was left out: the program does not state where it begins.</source>
        <translation>1 Bewegung wurde weggelassen: Das Programm nennt nicht, wo sie beginnt.</translation>
    </message>
    <message numerus="yes">
        <source>%n moves were left out: the program does not state where they begin.</source>
        <translation>
            <numerusform>%n Bewegung wurde weggelassen: Das Programm nennt nicht, wo sie beginnt.</numerusform>
            <numerusform>%n Bewegungen wurden weggelassen: Das Programm nennt nicht, wo sie beginnen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The picture was written to “%1”.</source>
        <translation>Das Bild wurde in „%1“ geschrieben.</translation>
    </message>
    <message>
        <source>A path was made of %1 of feed moves, with the feeds and speeds of the program. Links replace its rapids.</source>
        <translation>Aus %1 Vorschubbewegungen wurde eine Bahn, mit Vorschüben und Drehzahlen des Programms. Verbindungen ersetzen die Eilgänge.</translation>
    </message>
    <message>
        <source>1 arc was converted to lines within 0.001 mm; “Fit arcs” restores it.</source>
        <translation>1 Bogen wurde innerhalb von 0,001 mm in Geraden zerlegt; „Bögen einpassen“ stellt ihn wieder her.</translation>
    </message>
    <message numerus="yes">
        <source>%n arcs were converted to lines within 0.001 mm; “Fit arcs” restores them.</source>
        <translation>
            <numerusform>%n Bogen wurde innerhalb von 0,001 mm in Geraden zerlegt; „Bögen einpassen“ stellt ihn wieder her.</numerusform>
            <numerusform>%n Bögen wurden innerhalb von 0,001 mm in Geraden zerlegt; „Bögen einpassen“ stellt sie wieder her.</numerusform>
        </translation>
    </message>
    <message>
        <source>The table of faces was written to “%1”.</source>
        <translation>Die Tabelle der Flächen wurde in „%1“ geschrieben.</translation>
    </message>
    <message>
        <source>View of part and workpiece</source>
        <translation>Ansicht von Teil und Werkstück</translation>
    </message>
    <message>
        <source>Placing a fixture</source>
        <translation>Vorrichtung platzieren</translation>
    </message>
    <message>
        <source>The tool “%1” is in the library. It doesn&apos;t turn: its models cut, and their profile keeps them out of the part.</source>
        <translation>Das Werkzeug „%1“ ist in der Bibliothek. Es dreht sich nicht: seine Modelle schneiden, und ihr Profil hält sie vom Teil ab.</translation>
    </message>
    <message>
        <source>Switched to “%1”, where the change was made.</source>
        <translation>Zu „%1“ gewechselt, wo die Änderung gemacht wurde.</translation>
    </message>
    <message>
        <source>The tool “%1” is in the library. It is hollow, %2 mm in diameter and %3 mm deep, and leaves a core there; its outside is at most %4 mm wider than what its flutes sweep.</source>
        <translation>Das Werkzeug „%1“ steht in der Bibliothek. Es ist hohl, %2 mm im Durchmesser und %3 mm tief, und lässt dort einen Kern stehen; außen ist es höchstens %4 mm weiter als das, was seine Schneiden überstreichen.</translation>
    </message>
    <message>
        <source>The trace of the session was written to “%1”.</source>
        <translation>Die Spur der Sitzung wurde in „%1“ geschrieben.</translation>
    </message>
</context>
<context>
    <name>burin::MaterialController</name>
    <message>
        <source>copy of a material</source>
        <translation>Kopie eines Werkstoffs</translation>
    </message>
    <message>
        <source>values of a material</source>
        <translation>Werte eines Werkstoffs</translation>
    </message>
    <message>
        <source>deleting a material</source>
        <translation>Löschen eines Werkstoffs</translation>
    </message>
</context>
<context>
    <name>burin::MaterialDialog</name>
    <message>
        <source>Materials</source>
        <translation>Werkstoffe</translation>
    </message>
    <message>
        <source>Copy this material to one of your own and change that</source>
        <translation>Diesen Werkstoff in einen eigenen kopieren und den ändern</translation>
    </message>
    <message>
        <source>Add a material file, or a material card of FreeCAD (.FCMat)</source>
        <translation>Eine Werkstoffdatei oder eine Werkstoffkarte von FreeCAD (.FCMat) hinzufügen</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Kalibrieren …</translation>
    </message>
    <message>
        <source>Fit K and Kr to measured cutting forces (CSV)</source>
        <translation>K und Kr an gemessene Schnittkräfte anpassen (CSV)</translation>
    </message>
    <message>
        <source>shipped</source>
        <translation>mitgeliefert</translation>
    </message>
    <message>
        <source>Burin is shipped with this material, which can&apos;t be changed. Copy it and change the copy.</source>
        <translation>Dieser Werkstoff wird mit Burin geliefert und kann nicht geändert werden. Kopieren Sie ihn und ändern Sie die Kopie.</translation>
    </message>
    <message>
        <source>Your own material. The open project has recordings and keeps the values that they were made with.</source>
        <translation>Ihr eigener Werkstoff. Das offene Projekt hat Aufzeichnungen und behält die Werte, mit denen sie gemacht wurden.</translation>
    </message>
    <message>
        <source>Your own material.</source>
        <translation>Ihr eigener Werkstoff.</translation>
    </message>
    <message>
        <source>The materials that Burin is shipped with can&apos;t be deleted.</source>
        <translation>Die mitgelieferten Werkstoffe können nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>Delete this material; Undo brings it back (Del in the list)</source>
        <translation>Diesen Werkstoff löschen; Rückgängig bringt ihn zurück (Entf in der Liste)</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (Kopie)</translation>
    </message>
    <message>
        <source>There is a material with the ID “%1” already; give the one in the file another ID.</source>
        <translation>Es gibt schon einen Werkstoff mit der ID „%1“; geben Sie dem in der Datei eine andere ID.</translation>
    </message>
</context>
<context>
    <name>burin::MaterialForm</name>
    <message>
        <source>K: energy to cut a volume; the cutting force comes from it</source>
        <translation>K: Energie, um ein Volumen zu zerspanen; aus ihr kommt die Schnittkraft</translation>
    </message>
    <message>
        <source>Kr: force along the tool axis over that against the feed</source>
        <translation>Kr: Kraft längs der Werkzeugachse durch die gegen den Vorschub</translation>
    </message>
    <message>
        <source>kc1.1 of Kienzle&apos;s law; stands for K together with mc</source>
        <translation>kc1.1 des Kienzle-Gesetzes; steht mit mc zusammen für K</translation>
    </message>
    <message>
        <source>mc of Kienzle&apos;s law</source>
        <translation>mc des Kienzle-Gesetzes</translation>
    </message>
    <message>
        <source>Density; masses come from it</source>
        <translation>Dichte; aus ihr kommen die Massen</translation>
    </message>
    <message>
        <source>Cutting speed with carbide; the spindle speed comes from it</source>
        <translation>Schnittgeschwindigkeit mit Hartmetall; aus ihr kommt die Drehzahl</translation>
    </message>
    <message>
        <source>Plunge feed over feed</source>
        <translation>Eintauchvorschub durch Vorschub</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>In which it is drawn</source>
        <translation>In der er gezeichnet wird</translation>
    </message>
    <message>
        <source>Values of the material</source>
        <translation>Kennwerte des Werkstoffs</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Schätzung</translation>
    </message>
    <message>
        <source>Add a value</source>
        <translation>Wert hinzufügen</translation>
    </message>
    <message>
        <source>Remove the value</source>
        <translation>Wert entfernen</translation>
    </message>
    <message>
        <source>Nobody published this number: calibrate before you trust what depends on it</source>
        <translation>Niemand hat diese Zahl veröffentlicht: Kalibrieren Sie, bevor Sie dem trauen, was von ihr abhängt</translation>
    </message>
    <message>
        <source>A value has no name; enter one, or remove the row.</source>
        <translation>Ein Wert hat keinen Namen; geben Sie einen ein, oder entfernen Sie die Zeile.</translation>
    </message>
    <message>
        <source>“%1” of “%2” is no number; enter one, with a decimal point.</source>
        <translation>„%1“ von „%2“ ist keine Zahl; geben Sie eine ein, mit Dezimalpunkt.</translation>
    </message>
    <message>
        <source>“%1” has no unit; enter one, or 1 where it has none.</source>
        <translation>„%1“ hat keine Einheit; geben Sie eine ein, oder 1, wo er keine hat.</translation>
    </message>
    <message>
        <source>“%1” has no source; enter where the number comes from.</source>
        <translation>„%1“ hat keine Quelle; geben Sie ein, woher die Zahl kommt.</translation>
    </message>
    <message>
        <source>Two values have the same name; rename one of them.</source>
        <translation>Zwei Werte haben denselben Namen; benennen Sie einen um.</translation>
    </message>
    <message>
        <source>Chip load per tooth, as a share of the diameter; the feed follows from it</source>
        <translation>Zahnvorschub als Anteil am Durchmesser; aus ihm folgt der Vorschub</translation>
    </message>
    <message>
        <source>A property of your own, kept with the material</source>
        <translation>Eine eigene Eigenschaft, die mit dem Werkstoff aufbewahrt wird</translation>
    </message>
    <message>
        <source>Name in the list of materials</source>
        <translation>Name in der Liste der Werkstoffe</translation>
    </message>
    <message>
        <source>Add a property of your own</source>
        <translation>Eine eigene Eigenschaft hinzufügen</translation>
    </message>
    <message>
        <source>%1; used instead of the value for all cutters</source>
        <translation>%1; gilt statt des Werts für alle Fräser</translation>
    </message>
</context>
<context>
    <name>burin::MaterialPanel</name>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Its material</source>
        <translation>Sein Werkstoff</translation>
    </message>
    <message>
        <source>Values of the material</source>
        <translation>Kennwerte des Werkstoffs</translation>
    </message>
    <message>
        <source>Source of the selected value</source>
        <translation>Quelle des ausgewählten Kennwerts</translation>
    </message>
    <message>
        <source>Stock and material can&apos;t be changed once there are takes.</source>
        <translation>Sobald es Aufnahmen gibt, lassen sich Rohteil und Werkstoff nicht mehr ändern.</translation>
    </message>
    <message>
        <source>The material can be changed until the first take; the workpiece is kept.</source>
        <translation>Bis zur ersten Aufnahme kann der Werkstoff geändert werden; das Werkstück bleibt erhalten.</translation>
    </message>
    <message>
        <source>Values of %1</source>
        <translation>Kennwerte: %1</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>Schätzwert</translation>
    </message>
    <message>
        <source>1 value is an estimate: calibrate it before you rely on results that depend on it.</source>
        <translation>1 Kennwert ist geschätzt: Kalibrieren Sie ihn, bevor Sie sich auf davon abhängige Werte verlassen.</translation>
    </message>
    <message numerus="yes">
        <source>%n values are estimates: calibrate them before you rely on results that depend on them.</source>
        <translation>
            <numerusform>%n Kennwert ist geschätzt: Kalibrieren Sie ihn, bevor Sie sich auf davon abhängige Werte verlassen.</numerusform>
            <numerusform>%n Kennwerte sind geschätzt: Kalibrieren Sie sie, bevor Sie sich auf davon abhängige Werte verlassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Same as the stock</source>
        <translation>Wie das Rohteil</translation>
    </message>
    <message>
        <source>Material of the stock</source>
        <translation>Werkstoff des Rohteils</translation>
    </message>
    <message>
        <source>Body whose material is shown below</source>
        <translation>Körper, dessen Werkstoff unten gezeigt wird</translation>
    </message>
    <message>
        <source>Material of this body</source>
        <translation>Werkstoff dieses Körpers</translation>
    </message>
</context>
<context>
    <name>burin::MeasureController</name>
    <message>
        <source>Measuring</source>
        <translation>Messung</translation>
    </message>
</context>
<context>
    <name>burin::MeasurePicker</name>
    <message>
        <source>Esc: end measuring</source>
        <translation>Esc: Messen beenden</translation>
    </message>
</context>
<context>
    <name>burin::MeasurePresenter</name>
    <message>
        <source>Click a point on the part to measure its face, then another one for the distance. Esc ends measuring.</source>
        <translation>Klicken Sie einen Punkt auf dem Teil an, um seine Fläche zu messen, dann einen zweiten für den Abstand. Esc beendet das Messen.</translation>
    </message>
    <message>
        <source>Click a point on the workpiece to measure its face and the stock that is left there, then another one for the distance. Esc ends measuring.</source>
        <translation>Klicken Sie einen Punkt auf dem Werkstück an, um seine Fläche und das Restmaterial dort zu messen, dann einen zweiten für den Abstand. Esc beendet das Messen.</translation>
    </message>
</context>
<context>
    <name>burin::Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zu&amp;letzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Mill</source>
        <translation>&amp;Fräsen</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>Bah&amp;n</translation>
    </message>
    <message>
        <source>P&amp;rogram</source>
        <translation>&amp;Programm</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Setup</source>
        <translation>Auf&amp;spannung</translation>
    </message>
</context>
<context>
    <name>burin::MessageStrip</name>
    <message>
        <source>Close this message.</source>
        <translation>Schließt diese Meldung.</translation>
    </message>
</context>
<context>
    <name>burin::MeterPresenter</name>
    <message>
        <source>Virtual operator %1 ×</source>
        <translation>Virtueller Bediener, %1 ×</translation>
    </message>
    <message>
        <source>the spindle&apos;s power</source>
        <translation>die Leistung der Spindel</translation>
    </message>
    <message>
        <source>the spindle&apos;s torque</source>
        <translation>das Drehmoment der Spindel</translation>
    </message>
    <message>
        <source>the tool may break</source>
        <translation>das Werkzeug kann brechen</translation>
    </message>
    <message>
        <source>Plunge feed, because the tool plunges</source>
        <translation>Eintauchvorschub, weil das Werkzeug eintaucht</translation>
    </message>
    <message>
        <source>Thin chip: limited to twice the feed of the cutting data</source>
        <translation>Dünner Span: begrenzt auf das Doppelte des Vorschubs der Schnittdaten</translation>
    </message>
    <message>
        <source>Limited by the strength of the tool or the power of the spindle</source>
        <translation>Begrenzt durch die Festigkeit des Werkzeugs oder die Leistung der Spindel</translation>
    </message>
    <message>
        <source>Limited by the maximum chip load of the tool or the maximum feed of the machine</source>
        <translation>Begrenzt durch den größten Zahnvorschub des Werkzeugs oder den größten Vorschub der Maschine</translation>
    </message>
    <message>
        <source>Limited by the chip load of the cutting data</source>
        <translation>Begrenzt durch den Zahnvorschub der Schnittdaten</translation>
    </message>
</context>
<context>
    <name>burin::Meters</name>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Removal</source>
        <translation>Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Haptic rate</source>
        <translation>Haptiktakt</translation>
    </message>
    <message>
        <source>Work, p99.9</source>
        <translation>Rechenzeit, p99,9</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Verpasst</translation>
    </message>
    <message>
        <source>Ticks that came too late</source>
        <translation>Takte, die zu spät kamen</translation>
    </message>
    <message>
        <source>Stylus</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>Stylus that moves the tool</source>
        <translation>Stift, der das Werkzeug bewegt</translation>
    </message>
    <message>
        <source>%1 N of %2</source>
        <translation>%1 N von %2</translation>
    </message>
    <message>
        <source>Tip of the tool from program zero, in %1</source>
        <translation>Werkzeugspitze ab Programmnullpunkt, in %1</translation>
    </message>
    <message>
        <source>Cutting force, not scaled; next to it the highest so far</source>
        <translation>Schnittkraft, unskaliert; daneben die bisher höchste</translation>
    </message>
    <message>
        <source>Material removed per second</source>
        <translation>Abgetragenes Volumen je Sekunde</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>RealtimeKit</source>
        <translation>RealtimeKit</translation>
    </message>
    <message>
        <source>raised</source>
        <translation>erhöht</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>Interval, p99.9</source>
        <translation>Abstand, p99,9</translation>
    </message>
    <message>
        <source>Withheld</source>
        <translation>Zurückgehalten</translation>
    </message>
    <message>
        <source>Forces that were ready more than 3 ms after the one before, and not sent</source>
        <translation>Kräfte, die mehr als 3 ms nach der vorigen fertig waren und nicht gesendet wurden</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Vorrang</translation>
    </message>
    <message>
        <source>Show the values of the haptic loop</source>
        <translation>Die Werte der Haptikschleife zeigen</translation>
    </message>
    <message>
        <source>Hide the values of the haptic loop</source>
        <translation>Die Werte der Haptikschleife verbergen</translation>
    </message>
    <message>
        <source>%1 N, limit %2 N</source>
        <translation>%1 N, Grenze %2 N</translation>
    </message>
    <message>
        <source>Cutting force at the speed of the hand, not scaled. At the limit the bar turns red: %1</source>
        <translation>Schnittkraft bei der Geschwindigkeit der Hand, nicht skaliert. An der Grenze wird der Balken rot: %1</translation>
    </message>
    <message>
        <source>Ticks per second that are reached</source>
        <translation>Erreichte Takte je Sekunde</translation>
    </message>
    <message>
        <source>Interval between two forces that 999 of 1000 do not exceed</source>
        <translation>Abstand zweier Kräfte, den 999 von 1000 nicht überschreiten</translation>
    </message>
    <message>
        <source>CPU time of a tick that 999 of 1000 do not exceed</source>
        <translation>Rechenzeit eines Takts, die 999 von 1000 nicht überschreiten</translation>
    </message>
    <message>
        <source>Scheduling that the system grants the haptic loop; the rtprio limit or RealtimeKit gives real time</source>
        <translation>Zeitplanung, die das System der Haptikschleife gewährt; die Grenze rtprio oder RealtimeKit gibt Echtzeit</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>Feed and spindle speed for the material under the tool and its engagement, from the cutting data. Feeds of a path are set by its edits</source>
        <translation>Vorschub und Drehzahl für das Material unter dem Werkzeug und seinen Eingriff, aus den Schnittdaten. Vorschübe eines Pfads setzen seine Bearbeitungen</translation>
    </message>
    <message>
        <source>%1, engagement %2°, depth %3. %4</source>
        <translation>%1, Eingriff %2°, Tiefe %3. %4</translation>
    </message>
    <message>
        <source>%1, at the limit</source>
        <translation>%1, an der Grenze</translation>
    </message>
</context>
<context>
    <name>burin::MillController</name>
    <message>
        <source>allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>stroke</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>name of a take</source>
        <translation>Name einer Aufnahme</translation>
    </message>
    <message>
        <source>delete a take</source>
        <translation>Aufnahme löschen</translation>
    </message>
    <message>
        <source>order of takes</source>
        <translation>Reihenfolge der Aufnahmen</translation>
    </message>
    <message>
        <source>copy of a take</source>
        <translation>Kopie einer Aufnahme</translation>
    </message>
    <message>
        <source>take without strokes</source>
        <translation>Aufnahme ohne Züge</translation>
    </message>
</context>
<context>
    <name>burin::MillPanel</name>
    <message>
        <source>Mill</source>
        <translation>Fräsen</translation>
    </message>
    <message>
        <source>How the tool follows the hand</source>
        <translation>Führung des Werkzeugs</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Vorführen</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>There is no stroke to undo.</source>
        <translation>Es gibt keinen Zug, der rückgängig gemacht werden kann.</translation>
    </message>
    <message>
        <source>Strokes from before the project was opened can&apos;t be undone; delete their take instead.</source>
        <translation>Züge aus der Zeit vor dem Öffnen des Projekts lassen sich nicht rückgängig machen; löschen Sie stattdessen ihre Aufnahme.</translation>
    </message>
    <message>
        <source>Undo the last stroke; no other one can be undone</source>
        <translation>Den letzten Zug rückgängig machen; bei weiteren geht es nicht</translation>
    </message>
    <message numerus="yes">
        <source>Undo the last stroke; the last %n strokes can be undone</source>
        <translation>
            <numerusform>Den letzten Zug rückgängig machen; bei %n Zug ist es möglich</numerusform>
            <numerusform>Den letzten Zug rückgängig machen; bei den letzten %n Zügen ist es möglich</numerusform>
        </translation>
    </message>
    <message>
        <source>Redo the stroke that was undone last</source>
        <translation>Den zuletzt rückgängig gemachten Zug wiederherstellen</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Along the part</source>
        <translation>Am Teil entlang</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>Zustellung</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Andruck</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>The tool follows the pointer no faster than this while it cuts</source>
        <translation>Schneller folgt das Werkzeug dem Zeiger beim Schneiden nicht</translation>
    </message>
    <message>
        <source>Embed the part and choose a tool first.</source>
        <translation>Betten Sie zuerst das Teil ein und wählen Sie ein Werkzeug.</translation>
    </message>
    <message>
        <source>Stop milling</source>
        <translation>Fräsen beenden</translation>
    </message>
    <message>
        <source>Stop the recording first.</source>
        <translation>Beenden Sie zuerst die Aufzeichnung.</translation>
    </message>
    <message>
        <source>Stop the virtual operator</source>
        <translation>Den virtuellen Bediener anhalten</translation>
    </message>
    <message>
        <source>The virtual operator mills the part before your eyes</source>
        <translation>Der virtuelle Bediener fräst das Teil vor Ihren Augen</translation>
    </message>
    <message>
        <source>Stop showing</source>
        <translation>Vorführung beenden</translation>
    </message>
    <message>
        <source>A stroke stays at the height of its first point, less the depth of cut</source>
        <translation>Ein Zug bleibt auf der Höhe seines Anfangs, abzüglich der Zustellung</translation>
    </message>
    <message>
        <source>Stylus</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>Stylus that moves the tool</source>
        <translation>Stift, der das Werkzeug bewegt</translation>
    </message>
    <message>
        <source>Nothing is recorded yet. Everything that you mill will be; Show me demonstrates it.</source>
        <translation>Noch ist nichts aufgezeichnet. Alles, was Sie fräsen, wird es; oder lassen Sie es sich vom virtuellen Bediener zeigen.</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>Dragging cuts along the pointer&apos;s trail</source>
        <translation>Ziehen schneidet entlang der Spur des Zeigers</translation>
    </message>
    <message>
        <source>Raster</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Drag a rectangle; it is milled in rows at the step-over (T)</source>
        <translation>Ein Rechteck aufziehen; es wird in Zeilen im Zeilenabstand gefräst (T)</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>Zeilenabstand</translation>
    </message>
    <message>
        <source>Distance between the rows of a raster, and to a stroke repeated beside the last one</source>
        <translation>Zwischen den Zeilen eines Rasters und zu einem Zug, der daneben wiederholt wird</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Tiefer</translation>
    </message>
    <message>
        <source>Repeat the last stroke, lower by the depth of cut (L)</source>
        <translation>Den letzten Zug noch einmal fräsen, um die Zustellung tiefer (L)</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Repeat the last stroke one step-over to the left of its direction (B)</source>
        <translation>Den letzten Zug noch einmal fräsen, einen Zeilenabstand links von seiner Richtung (B)</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Repeat the last stroke one step-over to the right of its direction (Shift+B)</source>
        <translation>Den letzten Zug noch einmal fräsen, einen Zeilenabstand rechts von seiner Richtung (Umschalt+B)</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Stop, recorded %1</source>
        <translation>Stopp, aufgezeichnet %1</translation>
    </message>
    <message>
        <source>Stop milling and end the take</source>
        <translation>Fräsen und Aufnahme beenden</translation>
    </message>
    <message>
        <source>Start milling. Everything that is cut is recorded</source>
        <translation>Mit dem Fräsen beginnen. Alles, was geschnitten wird, wird aufgezeichnet</translation>
    </message>
    <message>
        <source>A stroke is being cut. Wait until it ends, or press Esc to end it.</source>
        <translation>Ein Zug wird gerade gefräst. Warten Sie, bis er endet, oder beenden Sie ihn mit Esc.</translation>
    </message>
    <message>
        <source>Drag in the view to mill. Shift+click mills a straight line from the last end.</source>
        <translation>Zum Fräsen in der Ansicht ziehen. Umschalt+Klick fräst vom letzten Ende aus gerade.</translation>
    </message>
    <message>
        <source>Press Mill, then drag in the view.</source>
        <translation>„Fräsen“ drücken, dann in der Ansicht ziehen.</translation>
    </message>
    <message>
        <source>A stroke presses onto the part; its push-back guides the tool along the surface</source>
        <translation>Ein Zug drückt auf das Teil; die Gegenkraft führt das Werkzeug an der Oberfläche entlang</translation>
    </message>
    <message>
        <source>Depth of the tip below the surface under the pointer</source>
        <translation>Tiefe der Spitze unter der Oberfläche unter dem Zeiger</translation>
    </message>
    <message>
        <source>Depth of the hand in the part, against its push-back</source>
        <translation>Tiefe der Hand im Teil, gegen die Gegenkraft</translation>
    </message>
    <message>
        <source>Sinking speed</source>
        <translation>Sinkgeschwindigkeit</translation>
    </message>
    <message>
        <source>Speed at which the tool sinks at full pressure of the pen</source>
        <translation>Geschwindigkeit, mit der das Werkzeug bei vollem Druck des Stifts sinkt</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Sinking</source>
        <translation>Sinken</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>The pressure sets the depth; at full pressure it is the depth of cut, or the press into the part</source>
        <translation>Der Druck bestimmt die Tiefe; bei vollem Druck ist es die Zustellung oder das Eindrücken in das Teil</translation>
    </message>
    <message>
        <source>The tool sinks from the surface to the depth of cut; it sinks faster the harder the pen presses</source>
        <translation>Das Werkzeug sinkt von der Oberfläche auf die Zustellung, umso schneller, je stärker der Stift drückt</translation>
    </message>
</context>
<context>
    <name>burin::MillPresenter</name>
    <message>
        <source>Import a part first.</source>
        <translation>Importieren Sie zuerst ein Teil.</translation>
    </message>
    <message>
        <source>The part is being embedded.</source>
        <translation>Das Teil wird eingebettet.</translation>
    </message>
    <message>
        <source>Embed the part in its stock first.</source>
        <translation>Betten Sie das Teil zuerst in sein Rohteil ein.</translation>
    </message>
    <message>
        <source>The boundary for the tool is being computed.</source>
        <translation>Die Grenzfläche für das Werkzeug wird berechnet.</translation>
    </message>
    <message>
        <source>The virtual operator is milling; stop it to mill yourself.</source>
        <translation>Der virtuelle Bediener fräst; halten Sie ihn an, um selbst zu fräsen.</translation>
    </message>
    <message>
        <source>%1 (not plugged in)</source>
        <translation>%1 (nicht angeschlossen)</translation>
    </message>
    <message>
        <source>There is no boundary for the tool: choose another tool, or embed again, with larger voxels where memory was short.</source>
        <translation>Für das Werkzeug gibt es keine Grenzfläche: ein anderes Werkzeug wählen oder neu einbetten, mit größeren Voxeln, wo der Speicher nicht reichte.</translation>
    </message>
    <message>
        <source>Strokes are locked to X. Press X to unlock.</source>
        <translation>Züge sind auf X festgelegt. X gibt sie frei.</translation>
    </message>
    <message>
        <source>Strokes are locked to Y. Press Y to unlock.</source>
        <translation>Züge sind auf Y festgelegt. Y gibt sie frei.</translation>
    </message>
    <message>
        <source>Strokes are locked to their direction. Press D to unlock.</source>
        <translation>Züge sind auf ihre Richtung festgelegt. D gibt sie frei.</translation>
    </message>
    <message>
        <source>The tool axis is fixed, so the pen&apos;s tilt has no effect. Choose the axis “free, with the hand” in the step Stock to lean the tool.</source>
        <translation>Die Werkzeugachse ist fest, die Neigung des Stifts hat keine Wirkung. Wählen Sie im Schritt Rohteil die Achse „frei, mit der Hand“, um das Werkzeug zu neigen.</translation>
    </message>
</context>
<context>
    <name>burin::MillTool</name>
    <message>
        <source>Esc: cancel the line</source>
        <translation>Esc: Gerade abbrechen</translation>
    </message>
    <message>
        <source>Esc: cancel the raster</source>
        <translation>Esc: Raster abbrechen</translation>
    </message>
    <message>
        <source>Esc: stop milling</source>
        <translation>Esc: Fräsen beenden</translation>
    </message>
    <message>
        <source>No direction to lock yet. Draw at least 1 mm of a stroke first.</source>
        <translation>Noch gibt es keine Richtung zum Festlegen. Ziehen Sie zuerst mindestens 1 mm eines Zuges.</translation>
    </message>
    <message>
        <source>The raster needs more than a million points along the part. Increase the step-over or draw a smaller rectangle.</source>
        <translation>Das Raster braucht mehr als eine Million Punkte am Teil entlang. Vergrößern Sie den Zeilenabstand oder ziehen Sie ein kleineres Rechteck auf.</translation>
    </message>
    <message>
        <source>A stroke along the part cannot be repeated lower: the part limits its depth.</source>
        <translation>Ein Zug am Teil entlang lässt sich nicht tiefer wiederholen: Das Teil begrenzt seine Tiefe.</translation>
    </message>
    <message>
        <source>The depth of cut is zero. Enter a depth to repeat the stroke lower.</source>
        <translation>Die Zustellung ist null. Geben Sie eine Zustellung ein, um den Zug tiefer zu wiederholen.</translation>
    </message>
    <message>
        <source>The last stroke is vertical, so it cannot be repeated beside itself.</source>
        <translation>Der letzte Zug ist senkrecht und lässt sich deshalb nicht daneben wiederholen.</translation>
    </message>
    <message>
        <source>Esc: stop the tool here and drop what it has not milled yet</source>
        <translation>Esc: Werkzeug hier anhalten und verwerfen, was es noch nicht gefräst hat</translation>
    </message>
</context>
<context>
    <name>burin::ModelController</name>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>%1: preview; the fine mesh is being made</source>
        <translation>%1: Vorschau; das feine Netz wird erstellt</translation>
    </message>
    <message>
        <source>mirrored part</source>
        <translation>gespiegeltes Teil</translation>
    </message>
    <message>
        <source>colour of bodies</source>
        <translation>Farbe von Körpern</translation>
    </message>
</context>
<context>
    <name>burin::Notice</name>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
</context>
<context>
    <name>burin::ObstacleCard</name>
    <message>
        <source>waits until the tool is out</source>
        <translation>wartet, bis das Werkzeug frei ist</translation>
    </message>
    <message>
        <source>holds the tool</source>
        <translation>hält das Werkzeug</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance that every point of the tool keeps from it</source>
        <translation>Abstand, den jeder Punkt des Werkzeugs davon hält</translation>
    </message>
    <message>
        <source>Whether it keeps the tool out</source>
        <translation>Ob es das Werkzeug fernhält</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>Vorrichtung</translation>
    </message>
    <message>
        <source>Keep-out volume</source>
        <translation>Sperrraum</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>The corner with the lowest coordinates, from program zero</source>
        <translation>Die Ecke mit den kleinsten Koordinaten, vom Programmnullpunkt aus</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Length of its edges</source>
        <translation>Länge der Kanten</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Grundfläche</translation>
    </message>
    <message>
        <source>The middle of its lower face, from program zero</source>
        <translation>Die Mitte der unteren Fläche, vom Programmnullpunkt aus</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Of the cylinder</source>
        <translation>Des Zylinders</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Stop the recording first.</source>
        <translation>Beenden Sie zuerst die Aufzeichnung.</translation>
    </message>
    <message>
        <source>%1 X, Y, Z, in %2</source>
        <translation>%1 X, Y, Z in %2</translation>
    </message>
    <message>
        <source>A fixture is a solid object; a keep-out volume has to stay clear of the tool</source>
        <translation>Eine Vorrichtung ist ein fester Körper; ein Sperrraum muss vom Werkzeug frei bleiben</translation>
    </message>
    <message>
        <source>Change its sizes and its position</source>
        <translation>Ihre Maße und ihre Lage ändern</translation>
    </message>
    <message>
        <source>From the library: %1</source>
        <translation>Aus der Bibliothek: %1</translation>
    </message>
    <message>
        <source>From a file, %1 triangles</source>
        <translation>Aus einer Datei, %1 Dreiecke</translation>
    </message>
    <message>
        <source>Move it in the view, with the mouse or the keys</source>
        <translation>In der Ansicht verschieben, mit der Maus oder den Tasten</translation>
    </message>
</context>
<context>
    <name>burin::ObstacleMovePresenter</name>
    <message>
        <source>Drag the handles, click the stock or the table, or use the arrow keys, Page up and down; R rotates it. Enter keeps the new position, Esc the old one.</source>
        <translation>Ziehen Sie die Griffe, klicken Sie auf Rohteil oder Tisch, oder nehmen Sie Pfeiltasten, Bild auf und ab; R dreht. Eingabe behält die neue Lage, Esc die alte.</translation>
    </message>
    <message>
        <source>Drag the arrows, click the stock or the table, or use the arrow keys, Page up and down. R rotates it by 90°: the edges of a box stay parallel to the axes. Enter keeps the new position, Esc the old one.</source>
        <translation>Ziehen Sie die Pfeile, klicken Sie auf Rohteil oder Tisch, oder nehmen Sie Pfeiltasten, Bild auf und ab. R dreht um 90°: Die Kanten eines Quaders bleiben parallel zu den Achsen. Eingabe behält die neue Lage, Esc die alte.</translation>
    </message>
</context>
<context>
    <name>burin::PartPanel</name>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Import a part…</source>
        <translation>Teil importieren…</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Import another part…</source>
        <translation>Anderes Teil importieren…</translation>
    </message>
    <message>
        <source>A part is being read.</source>
        <translation>Ein Teil wird eingelesen.</translation>
    </message>
    <message>
        <source>The part is being read…</source>
        <translation>Das Teil wird eingelesen…</translation>
    </message>
    <message>
        <source>1 open edge</source>
        <translation>1 offene Kante</translation>
    </message>
    <message numerus="yes">
        <source>%n open edges</source>
        <translation>
            <numerusform>%n offene Kante</numerusform>
            <numerusform>%n offene Kanten</numerusform>
        </translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 Fläche</translation>
    </message>
    <message numerus="yes">
        <source>%n faces</source>
        <translation>
            <numerusform>%n Fläche</numerusform>
            <numerusform>%n Flächen</numerusform>
        </translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Healed</source>
        <translation>Repariert</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Zweifelhaft</translation>
    </message>
    <message>
        <source>Import notes</source>
        <translation>Hinweise zum Import</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>This is a preview. The fine mesh, which is milled to, is being made…</source>
        <translation>Dies ist eine Vorschau. Das feine Netz, nach dem gefräst wird, wird erstellt …</translation>
    </message>
    <message>
        <source>Role of the selected body</source>
        <translation>Rolle des gewählten Körpers</translation>
    </message>
    <message>
        <source>The file states no unit. Choosing another one reads it again.</source>
        <translation>Die Datei gibt keine Einheit an. Eine andere zu wählen liest sie neu.</translation>
    </message>
    <message>
        <source>Read a CAD file (STEP, IGES, BREP) or a mesh (STL, 3MF, OBJ, PLY, AMF, OFF)</source>
        <translation>Eine CAD-Datei (STEP, IGES, BREP) oder ein Netz (STL, 3MF, OBJ, PLY, AMF, OFF) lesen</translation>
    </message>
    <message>
        <source>The CAD solid that is to be made. STEP keeps the exact surfaces, a mesh (STL, 3MF, OBJ) has only triangles.</source>
        <translation>Der CAD-Körper, der entstehen soll. STEP enthält die genauen Flächen, ein Netz (STL, 3MF, OBJ) nur Dreiecke.</translation>
    </message>
    <message>
        <source>Size as stated</source>
        <translation>Größe laut Datei</translation>
    </message>
    <message>
        <source>Choosing another unit than the stated one reads the file again: the part gets another size.</source>
        <translation>Eine andere als die angegebene Einheit zu wählen liest die Datei neu: Das Teil bekommt eine andere Größe.</translation>
    </message>
    <message>
        <source>Not imported</source>
        <translation>Nicht importiert</translation>
    </message>
</context>
<context>
    <name>burin::PassController</name>
    <message>
        <source>Computing the pass</source>
        <translation>Der Durchgang wird berechnet</translation>
    </message>
    <message>
        <source>Reading the program</source>
        <translation>Programm wird gelesen</translation>
    </message>
</context>
<context>
    <name>burin::PassDialog</name>
    <message>
        <source>Compute a pass</source>
        <translation>Durchgang berechnen</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Nichts ändern</translation>
    </message>
    <message>
        <source>whole part</source>
        <translation>ganzes Teil</translation>
    </message>
    <message>
        <source>from a drawing…</source>
        <translation>aus einer Zeichnung…</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>strokes of take %1</source>
        <translation>Züge der Aufnahme %1</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Unit of the drawing</source>
        <translation>Einheit der Zeichnung</translation>
    </message>
    <message>
        <source>Enter the depth of the lines.</source>
        <translation>Geben Sie die Tiefe der Linien ein.</translation>
    </message>
    <message>
        <source>Compute the pass in the background; it can be cancelled in the status line</source>
        <translation>Den Durchgang im Hintergrund berechnen; in der Statuszeile lässt er sich abbrechen</translation>
    </message>
    <message>
        <source>What the rows follow, or what is engraved: strokes of a recording or curves of a drawing</source>
        <translation>Dem die Zeilen folgen, oder was graviert wird: Züge einer Aufnahme oder Kurven einer Zeichnung</translation>
    </message>
    <message>
        <source>as stated in the file</source>
        <translation>wie in der Datei angegeben</translation>
    </message>
    <message>
        <source>Unit of the coordinates; not every drawing states it</source>
        <translation>Einheit der Koordinaten; nicht jede Zeichnung nennt sie</translation>
    </message>
    <message>
        <source>Choose the strokes or the drawing to engrave.</source>
        <translation>Wählen Sie die Züge oder die Zeichnung, die graviert werden.</translation>
    </message>
    <message>
        <source>Choose the strokes or the drawing that the rows follow.</source>
        <translation>Wählen Sie die Züge oder die Zeichnung, denen die Zeilen folgen.</translation>
    </message>
    <message>
        <source>painted area</source>
        <translation>gemalter Bereich</translation>
    </message>
    <message>
        <source>Where the tool may go: what was painted on the part, or the closed curves of a DXF or SVG drawing, in the coordinates of the setup</source>
        <translation>Wohin das Werkzeug darf: was auf das Teil gemalt wurde, oder die geschlossenen Kurven einer DXF- oder SVG-Zeichnung, in den Koordinaten der Aufspannung</translation>
    </message>
    <message>
        <source>Area on the part</source>
        <translation>Bereich auf dem Teil</translation>
    </message>
    <message>
        <source>The area limits where the tool touches the part, not where its tip goes</source>
        <translation>Der Bereich begrenzt, wo das Werkzeug das Teil berührt, nicht, wo seine Spitze verläuft</translation>
    </message>
    <message>
        <source>Paint the area of the pocket, or choose a drawing with its outline.</source>
        <translation>Malen Sie den Bereich der Tasche, oder wählen Sie eine Zeichnung mit ihrem Umriss.</translation>
    </message>
    <message>
        <source>Paint an area, or choose a drawing with the outline to follow.</source>
        <translation>Malen Sie einen Bereich, oder wählen Sie eine Zeichnung mit dem Umriss, dem gefolgt wird.</translation>
    </message>
    <message>
        <source>Change a pass</source>
        <translation>Durchgang ändern</translation>
    </message>
    <message>
        <source>area of this pass</source>
        <translation>Bereich dieses Durchgangs</translation>
    </message>
    <message>
        <source>lines of this pass</source>
        <translation>Linien dieses Durchgangs</translation>
    </message>
    <message>
        <source>Computes moves of %1 for the stock that the earlier paths leave, and adds them to the path of this tool. You can edit, check and undo them like recorded ones.</source>
        <translation>Berechnet Bewegungen von %1 für das Rohteil, wie die früheren Bahnen es lassen, und fügt sie zur Bahn dieses Werkzeugs hinzu. Sie lassen sich bearbeiten, prüfen und zurücknehmen wie aufgenommene.</translation>
    </message>
    <message>
        <source>Computes this pass of %1 again for the stock that is left before it. The pass keeps its position in the path.</source>
        <translation>Berechnet diesen Durchgang von %1 noch einmal für das Rohteil, das vor ihm übrig ist. Seine Stelle in der Bahn bleibt.</translation>
    </message>
    <message>
        <source>The part has no round upright holes.</source>
        <translation>Das Teil hat keine runden senkrechten Bohrungen.</translation>
    </message>
    <message>
        <source>Upright holes of the part: %1</source>
        <translation>Senkrechte Bohrungen des Teils: %1</translation>
    </message>
    <message>
        <source>Pick holes…</source>
        <translation>Bohrungen wählen…</translation>
    </message>
    <message>
        <source>All that fit</source>
        <translation>Alle passenden</translation>
    </message>
    <message>
        <source>Choose a thread, or enter its pitch.</source>
        <translation>Wählen Sie ein Gewinde, oder geben Sie seine Steigung ein.</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Vorführen</translation>
    </message>
    <message>
        <source>Plays in the view how this pass is made: the stroke that leads it, the directions, then its rows one after the other. Changes nothing; Esc stops it</source>
        <translation>Spielt in der Ansicht ab, wie dieser Durchgang entsteht: der Zug, der ihn führt, die Richtungen, dann seine Zeilen nacheinander. Ändert nichts; Esc beendet es</translation>
    </message>
    <message>
        <source>Stop showing</source>
        <translation>Vorführung beenden</translation>
    </message>
    <message>
        <source>Picked holes or studs</source>
        <translation>Gewählte Bohrungen oder Zapfen</translation>
    </message>
    <message>
        <source>The holes or studs of this pass, in the coordinates of the setup; Del removes one</source>
        <translation>Die Bohrungen oder Zapfen dieses Durchgangs, in den Koordinaten der Aufspannung; Entf entfernt eine Wahl</translation>
    </message>
    <message>
        <source>Click holes of the part in the view, or studs for an external thread; a second click removes one</source>
        <translation>Bohrungen des Teils in der Ansicht anklicken, oder Zapfen für ein Außengewinde; ein zweiter Klick entfernt eine Wahl</translation>
    </message>
    <message>
        <source>Clear the selection: the pass uses every hole or stud of the part that fits</source>
        <translation>Die Auswahl aufheben: Der Durchgang nimmt jede passende Bohrung oder jeden passenden Zapfen des Teils</translation>
    </message>
    <message>
        <source>The part has no round upright studs.</source>
        <translation>Das Teil hat keine runden senkrechten Zapfen.</translation>
    </message>
    <message>
        <source>Upright studs of the part: %1</source>
        <translation>Senkrechte Zapfen des Teils: %1</translation>
    </message>
    <message>
        <source>Enter the diameter of the thread, or pick its holes or studs.</source>
        <translation>Geben Sie den Durchmesser des Gewindes ein, oder wählen Sie seine Bohrungen oder Zapfen.</translation>
    </message>
</context>
<context>
    <name>burin::PassForm</name>
    <message>
        <source>Pass</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>What the pass does</source>
        <translation>Was der Durchgang tut</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Stock that stays on the part</source>
        <translation>Rohteil, das auf dem Teil bleibt</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>Zeilenabstand</translation>
    </message>
    <message>
        <source>Distance between rows or loops, or between the heights of a waterline</source>
        <translation>Abstand der Zeilen oder Schleifen, oder der Höhen von Höhenlinien</translation>
    </message>
    <message>
        <source>Scallop height</source>
        <translation>Rauhtiefe</translation>
    </message>
    <message>
        <source>Largest height of the ridges between rows; replaces the step-over. 0: not used</source>
        <translation>Größte Höhe der Grate zwischen Zeilen; ersetzt den Zeilenabstand. 0: nicht verwendet</translation>
    </message>
    <message>
        <source>Depth of a level</source>
        <translation>Tiefe einer Ebene</translation>
    </message>
    <message>
        <source>Largest depth of a level. Default: what material, tool and spindle can take</source>
        <translation>Größte Tiefe einer Ebene. Vorgabe: was Material, Werkzeug und Spindel vertragen</translation>
    </message>
    <message>
        <source>Depth of a peck</source>
        <translation>Tiefe eines Hubes</translation>
    </message>
    <message>
        <source>The drill comes up for its chips after each peck. 0: in one go up to three diameters, one diameter at a time in deeper holes</source>
        <translation>Nach jedem Hub kommt der Bohrer hoch und räumt die Späne aus. 0: bis drei Durchmesser in einem Zug, in tieferen Bohrungen je ein Durchmesser</translation>
    </message>
    <message>
        <source>Steps on slopes</source>
        <translation>Stufen auf Schrägen</translation>
    </message>
    <message>
        <source>Largest height of the steps that the levels leave on slopes</source>
        <translation>Größte Höhe der Stufen, die die Ebenen auf Schrägen lassen</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Depth of the lines below the top of the stock</source>
        <translation>Tiefe der Linien unter der Oberkante des Rohteils</translation>
    </message>
    <message>
        <source>Depth of the tip below the top of the stock. 0: to the bottom of each hole of the part</source>
        <translation>Tiefe der Spitze unter der Oberkante des Rohteils. 0: bis zum Grund jeder Bohrung des Teils</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Angle between the rows and X</source>
        <translation>Winkel zwischen den Zeilen und X</translation>
    </message>
    <message>
        <source>Steeper than</source>
        <translation>Steiler als</translation>
    </message>
    <message>
        <source>Only where the part is at least this steep</source>
        <translation>Nur wo das Teil mindestens so steil ist</translation>
    </message>
    <message>
        <source>Flatter than</source>
        <translation>Flacher als</translation>
    </message>
    <message>
        <source>Only where the part is at most this steep</source>
        <translation>Nur wo das Teil höchstens so steil ist</translation>
    </message>
    <message>
        <source>From height</source>
        <translation>Ab Höhe</translation>
    </message>
    <message>
        <source>Height at which the pass begins, in the coordinates of the setup</source>
        <translation>Höhe, in der der Durchgang beginnt, in den Koordinaten der Aufspannung</translation>
    </message>
    <message>
        <source>Down to height</source>
        <translation>Bis Höhe</translation>
    </message>
    <message>
        <source>Lowest height of the tip, in the coordinates of the setup</source>
        <translation>Tiefste Höhe der Spitze, in den Koordinaten der Aufspannung</translation>
    </message>
    <message>
        <source>Holding tabs</source>
        <translation>Haltestege</translation>
    </message>
    <message>
        <source>How many bridges stay on each outline</source>
        <translation>Wie viele Stege an jedem Umriss bleiben</translation>
    </message>
    <message>
        <source>Width of a tab</source>
        <translation>Breite eines Stegs</translation>
    </message>
    <message>
        <source>Along the outline</source>
        <translation>Entlang des Umrisses</translation>
    </message>
    <message>
        <source>Height of a tab</source>
        <translation>Höhe eines Stegs</translation>
    </message>
    <message>
        <source>Above the lowest level of the pass</source>
        <translation>Über der untersten Ebene des Durchgangs</translation>
    </message>
    <message>
        <source>Only where stock is left</source>
        <translation>Nur wo Rohteil übrig ist</translation>
    </message>
    <message>
        <source>Skips rows that would touch no stock</source>
        <translation>Überspringt Zeilen, die kein Rohteil berühren würden</translation>
    </message>
    <message>
        <source>All rows in one direction</source>
        <translation>Alle Zeilen in eine Richtung</translation>
    </message>
    <message>
        <source>The tool returns through the air after each row</source>
        <translation>Das Werkzeug kehrt nach jeder Zeile durch die Luft zurück</translation>
    </message>
    <message>
        <source>Inside the outline</source>
        <translation>Innen am Umriss</translation>
    </message>
    <message>
        <source>The cutter follows the outline of the area on its inside</source>
        <translation>Der Fräser folgt dem Umriss des Bereichs auf dessen Innenseite</translation>
    </message>
    <message>
        <source>Dogbones</source>
        <translation>Eckfreistiche</translation>
    </message>
    <message>
        <source>Cuts into the inner corners of the area, so that a part with square corners fits</source>
        <translation>Schneidet in die Innenecken des Bereichs, damit ein Teil mit scharfen Ecken hineinpasst</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>Distance between neighbouring crests of the thread; 25.4 mm divided by the threads per inch</source>
        <translation>Abstand benachbarter Gewindespitzen; 25,4 mm geteilt durch die Gänge je Zoll</translation>
    </message>
    <message>
        <source>Major diameter</source>
        <translation>Nenndurchmesser</translation>
    </message>
    <message>
        <source>other thread</source>
        <translation>anderes Gewinde</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>Metric thread of coarse pitch, ISO 261</source>
        <translation>Metrisches Regelgewinde, ISO 261</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Spring pass</source>
        <translation>Leerschnitt</translation>
    </message>
    <message>
        <source>Follows the thread once more at full depth</source>
        <translation>Folgt dem Gewinde noch einmal in voller Tiefe</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>Linksgewinde</translation>
    </message>
    <message>
        <source>Left-handed instead of right-handed thread</source>
        <translation>Linksgewinde statt Rechtsgewinde</translation>
    </message>
    <message>
        <source>Conventional milling</source>
        <translation>Gegenlauf</translation>
    </message>
    <message>
        <source>Number of passes along the thread, each deeper than the one before</source>
        <translation>Anzahl der Durchgänge entlang des Gewindes, jeder tiefer als der vorige</translation>
    </message>
    <message>
        <source>Hand strokes</source>
        <translation>Züge der Hand</translation>
    </message>
    <message>
        <source>What the rows do where strokes of the hand, earlier in this path, have finished the part. Keep off: cut nothing there. Blend: go on over the border by the overlap, without a step. Extend: the rows of a flow continue these strokes sideways</source>
        <translation>Was die Zeilen tun, wo Züge der Hand weiter vorn in dieser Bahn das Teil fertig bearbeitet haben. Fernbleiben: dort nichts schneiden. Übergehen: um die Überlappung über den Rand hinausgehen, ohne Absatz. Fortsetzen: Die Zeilen eines Flusses setzen diese Züge seitlich fort</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>How far rows go on over the border of what the hand has finished</source>
        <translation>Wie weit Zeilen über den Rand dessen hinausgehen, was die Hand fertig bearbeitet hat</translation>
    </message>
    <message>
        <source>Finished within</source>
        <translation>Fertig innerhalb</translation>
    </message>
    <message>
        <source>Largest height that the hand may have left on what counts as finished</source>
        <translation>Größte Höhe, die die Hand auf dem stehen gelassen haben darf, was als fertig gilt</translation>
    </message>
    <message>
        <source>ignore</source>
        <translation>nicht beachten</translation>
    </message>
    <message>
        <source>keep off</source>
        <translation>fernbleiben</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>übergehen</translation>
    </message>
    <message>
        <source>extend</source>
        <translation>fortsetzen</translation>
    </message>
    <message>
        <source>Of the thread. The part&apos;s holes must be modelled with this diameter, its studs with the minor diameter that the mill cuts. 0: as each picked hole or stud has it</source>
        <translation>Des Gewindes. Die Bohrungen des Teils müssen mit diesem Durchmesser modelliert sein, seine Zapfen mit dem Kerndurchmesser, den der Fräser schneidet. 0: wie jede gewählte Bohrung oder jeder gewählte Zapfen ihn hat</translation>
    </message>
    <message>
        <source>Length of the thread below the top of its hole or stud. 0: as far as each hole is open and drilled, or as the tool has room around the stud</source>
        <translation>Länge des Gewindes unter der Oberkante seiner Bohrung oder seines Zapfens. 0: so weit jede Bohrung offen und vorgebohrt ist, oder so weit das Werkzeug um den Zapfen Platz hat</translation>
    </message>
    <message>
        <source>External thread</source>
        <translation>Außengewinde</translation>
    </message>
    <message>
        <source>On round studs of the part instead of in its holes; picking holes or studs in the view sets it</source>
        <translation>Auf runden Zapfen des Teils statt in seinen Bohrungen; das Wählen von Bohrungen oder Zapfen in der Ansicht stellt es ein</translation>
    </message>
    <message>
        <source>Conventional instead of climb milling: internal right-hand threads are cut from the top down, external ones from the bottom up</source>
        <translation>Gegenlauf statt Gleichlauf: Rechtsgewinde werden innen von oben nach unten geschnitten, außen von unten nach oben</translation>
    </message>
</context>
<context>
    <name>burin::PassMeasurer</name>
    <message>
        <source>Measuring the passes</source>
        <translation>Durchgänge werden gemessen</translation>
    </message>
</context>
<context>
    <name>burin::PassPreviewer</name>
    <message>
        <source>Preparing the preview</source>
        <translation>Vorschau wird vorbereitet</translation>
    </message>
    <message>
        <source>Computing the preview</source>
        <translation>Vorschau wird berechnet</translation>
    </message>
</context>
<context>
    <name>burin::PassRefresher</name>
    <message>
        <source>Looking for passes that are out of date</source>
        <translation>Veraltete Durchgänge werden gesucht</translation>
    </message>
    <message>
        <source>Computing the passes that are out of date</source>
        <translation>Veraltete Durchgänge werden berechnet</translation>
    </message>
</context>
<context>
    <name>burin::PathColours</name>
    <message>
        <source>Kind of move</source>
        <translation>Art der Bewegung</translation>
    </message>
</context>
<context>
    <name>burin::PathComparer</name>
    <message>
        <source>Comparing paths</source>
        <translation>Bahnen vergleichen</translation>
    </message>
</context>
<context>
    <name>burin::PathController</name>
    <message>
        <source>change of an edit</source>
        <translation>Änderung einer Bearbeitung</translation>
    </message>
    <message>
        <source>new edit</source>
        <translation>neue Bearbeitung</translation>
    </message>
    <message>
        <source>point of the path</source>
        <translation>Punkt der Bahn</translation>
    </message>
    <message>
        <source>drawn stroke</source>
        <translation>gezeichneter Zug</translation>
    </message>
    <message>
        <source>deletion of an edit</source>
        <translation>Löschen einer Bearbeitung</translation>
    </message>
    <message>
        <source>order of edits</source>
        <translation>Reihenfolge der Bearbeitungen</translation>
    </message>
    <message>
        <source>new path</source>
        <translation>neue Bahn</translation>
    </message>
    <message>
        <source>computed pass</source>
        <translation>Berechneter Durchgang</translation>
    </message>
    <message>
        <source>deletion of a pass</source>
        <translation>Löschen eines Durchgangs</translation>
    </message>
    <message>
        <source>order of passes</source>
        <translation>Reihenfolge der Durchgänge</translation>
    </message>
    <message>
        <source>path of a program</source>
        <translation>Bahn eines Programms</translation>
    </message>
    <message>
        <source>take in the path</source>
        <translation>Aufnahme in die Bahn</translation>
    </message>
    <message>
        <source>take out of the path</source>
        <translation>Aufnahme aus der Bahn</translation>
    </message>
    <message>
        <source>inserted point</source>
        <translation>eingefügter Punkt</translation>
    </message>
    <message>
        <source>passes computed again</source>
        <translation>neu berechnete Durchgänge</translation>
    </message>
</context>
<context>
    <name>burin::PathHand</name>
    <message>
        <source>Esc: cancel</source>
        <translation>Esc: abbrechen</translation>
    </message>
    <message>
        <source>Esc: cancel drawing</source>
        <translation>Esc: Zeichnen abbrechen</translation>
    </message>
    <message>
        <source>Esc: clear the selection</source>
        <translation>Esc: Auswahl aufheben</translation>
    </message>
</context>
<context>
    <name>burin::PathPanel</name>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Cutting length</source>
        <translation>Schnittweg</translation>
    </message>
    <message>
        <source>Error of all edits</source>
        <translation>Abweichung insgesamt</translation>
    </message>
    <message>
        <source>Edits, in order</source>
        <translation>Bearbeitungen der Reihe nach</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Show the path in the view</source>
        <translation>Die Bahn in der Ansicht zeigen</translation>
    </message>
    <message>
        <source>New path from the takes</source>
        <translation>Neue Bahn aus den Aufnahmen</translation>
    </message>
    <message>
        <source>Update path</source>
        <translation>Bahn aktualisieren</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>Es wird noch gerechnet.</translation>
    </message>
    <message>
        <source>The path is up to date.</source>
        <translation>Die Bahn ist aktuell.</translation>
    </message>
    <message>
        <source>Apply the edits again</source>
        <translation>Die Bearbeitungen neu anwenden</translation>
    </message>
    <message>
        <source>The edits are being applied…</source>
        <translation>Die Bearbeitungen werden angewendet…</translation>
    </message>
    <message>
        <source>Takes or edits changed: update the path.</source>
        <translation>Aufnahmen oder Bearbeitungen haben sich geändert: Aktualisieren Sie die Bahn.</translation>
    </message>
    <message>
        <source>Largest deviation of the path from the recording</source>
        <translation>Größte Abweichung der Bahn von der Aufnahme</translation>
    </message>
    <message>
        <source>The workpiece is being made; then the edits are applied…</source>
        <translation>Das Werkstück entsteht; danach werden die Bearbeitungen angewendet…</translation>
    </message>
    <message>
        <source>Add an edit</source>
        <translation>Bearbeitung hinzufügen</translation>
    </message>
    <message>
        <source>Adds an edit, at the position that the order of edits allows</source>
        <translation>Fügt eine Bearbeitung an der Stelle hinzu, die die Reihenfolge erlaubt</translation>
    </message>
    <message>
        <source>Climb / conventional</source>
        <translation>Gleichlauf / Gegenlauf</translation>
    </message>
    <message>
        <source>The path of %1, which is milled before, can&apos;t be made. Its stock counts as not removed here; load that tool to see why.</source>
        <translation>Die Bahn von %1, die vorher gefräst wird, lässt sich nicht erstellen. Hier gilt ihr Material als noch vorhanden; wechseln Sie dieses Werkzeug ein, um den Grund zu sehen.</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Züge</translation>
    </message>
    <message>
        <source>Order and position</source>
        <translation>Reihenfolge und Lage</translation>
    </message>
    <message>
        <source>Drawn by hand</source>
        <translation>Von Hand gezeichnet</translation>
    </message>
    <message>
        <source>Smoother, fewer moves</source>
        <translation>Glätten und ausdünnen</translation>
    </message>
    <message>
        <source>Against the part</source>
        <translation>Gegen das Teil</translation>
    </message>
    <message>
        <source>Leads and links</source>
        <translation>An-, Abfahrten und Verbindungen</translation>
    </message>
    <message>
        <source>Feeds and speed</source>
        <translation>Vorschübe und Drehzahl</translation>
    </message>
    <message>
        <source>Make a path of all takes, one for each tool, with the standard edits</source>
        <translation>Eine Bahn aus allen Aufnahmen machen, für jedes Werkzeug eine, mit den üblichen Bearbeitungen</translation>
    </message>
    <message>
        <source>Loads the tool whose path is shown and edited, one of those that have milled</source>
        <translation>Wechselt das Werkzeug ein, dessen Bahn gezeigt und bearbeitet wird; zur Wahl stehen die, die gefräst haben</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>With a spindle that rotates clockwise; conventional cuts are pink in the view. Other moves cut on both sides, or from above. Reverse changes the direction of strokes</source>
        <translation>Bei rechtsdrehender Spindel; Gegenlauf ist in der Ansicht rosa. Andere Bewegungen schneiden auf beiden Seiten oder von oben. Umkehren ändert die Richtung von Zügen</translation>
    </message>
    <message>
        <source>Takes and passes</source>
        <translation>Aufnahmen und Durchgänge</translation>
    </message>
    <message>
        <source>Compute a pass…</source>
        <translation>Durchgang berechnen…</translation>
    </message>
    <message>
        <source>Record a take first, or compute a pass.</source>
        <translation>Zeichnen Sie zuerst etwas auf, oder berechnen Sie einen Durchgang.</translation>
    </message>
    <message>
        <source>%1 has not milled yet. Choose a tool that has, record a take, or compute a pass.</source>
        <translation>%1 hat noch nicht gefräst. Wählen Sie eines, das gefräst hat, zeichnen Sie etwas auf, oder berechnen Sie einen Durchgang.</translation>
    </message>
    <message>
        <source>Delete this pass</source>
        <translation>Diesen Durchgang löschen</translation>
    </message>
    <message>
        <source>Wait until the workpiece is ready and no pass is being computed.</source>
        <translation>Warten Sie, bis das Werkstück bereit ist und kein Durchgang berechnet wird.</translation>
    </message>
    <message>
        <source>Change this pass and compute it again</source>
        <translation>Diesen Durchgang ändern und neu berechnen</translation>
    </message>
    <message>
        <source>%1 of the pass were skipped: too much stock is in the way of the tool. Rough it first, or use a longer tool.</source>
        <translation>%1 des Durchgangs wurden ausgelassen: zu viel Rohteil ist dem Werkzeug im Weg. Zuerst schruppen oder ein längeres Werkzeug verwenden.</translation>
    </message>
    <message>
        <source>%1 of the pass were skipped: fixtures or keep-out volumes are in the way.</source>
        <translation>%1 des Durchgangs wurden ausgelassen: Spannmittel oder Sperrräume sind im Weg.</translation>
    </message>
    <message>
        <source>Measure the passes</source>
        <translation>Durchgänge messen</translation>
    </message>
    <message>
        <source>Wait until the path is up to date and measured.</source>
        <translation>Warten Sie, bis die Bahn aktuell und gemessen ist.</translation>
    </message>
    <message>
        <source>Length, time, share of air and engagement of each pass, and the stock that it leaves</source>
        <translation>Länge, Zeit, Luftanteil und Eingriff jedes Durchgangs und das Material, das er übrig lässt</translation>
    </message>
    <message>
        <source>Mill this pass before the one above</source>
        <translation>Diesen Durchgang vor dem darüber fräsen</translation>
    </message>
    <message>
        <source>Compute roughing, finishing, a pocket, a profile, drilling, threads or engraving with the loaded tool</source>
        <translation>Schruppen, Schlichten, eine Tasche, eine Kontur, Bohren, Gewinde oder Gravieren mit dem geladenen Werkzeug berechnen</translation>
    </message>
    <message>
        <source>The loaded tool doesn&apos;t turn: it has no passes.</source>
        <translation>Das geladene Werkzeug dreht sich nicht: Es hat keine Durchgänge.</translation>
    </message>
    <message>
        <source>Compute outdated passes again</source>
        <translation>Veraltete Durchgänge neu berechnen</translation>
    </message>
    <message>
        <source>Compute those passes again whose strokes have changed; all others stay as they are</source>
        <translation>Berechnet die Durchgänge neu, deren Züge sich geändert haben; alle anderen bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Out of date: hand strokes that this pass depends on have changed.</source>
        <translation>Veraltet: Züge der Hand, von denen dieser Durchgang abhängt, haben sich geändert.</translation>
    </message>
</context>
<context>
    <name>burin::PathPresenter</name>
    <message>
        <source>Preview: nothing is left to do there.</source>
        <translation>Vorschau: Dort ist nichts mehr zu tun.</translation>
    </message>
    <message>
        <source>Preview: about %1 of cutting, %2 without links.</source>
        <translation>Vorschau: etwa %1 im Schnitt, %2 ohne Verbindungen.</translation>
    </message>
    <message>
        <source>One row in %1 is drawn.</source>
        <translation>Eine von %1 Bahnen ist gezeichnet.</translation>
    </message>
    <message>
        <source>%1 in %2, %3 % in air; engagement within %4° for 95 % of the cut, at most %5°.</source>
        <translation>%1 in %2, %3 % in der Luft; Eingriff auf 95 % des Schnitts bis %4°, höchstens %5°.</translation>
    </message>
    <message>
        <source>Stock left on 99 % of the reachable part: at most %1 (most: %2).</source>
        <translation>Auf 99 % des erreichbaren Teils bleibt höchstens %1 Material (größter Wert: %2).</translation>
    </message>
    <message>
        <source>%1 are skipped: already finished by hand strokes.</source>
        <translation>%1 werden ausgelassen: von Zügen der Hand bereits fertig bearbeitet.</translation>
    </message>
</context>
<context>
    <name>burin::PathScenePresenter</name>
    <message>
        <source>&amp;Insert a point here</source>
        <translation>Hier einen Punkt &amp;einfügen</translation>
    </message>
    <message>
        <source>Insert a point into the path here. Drag it to move it; the stroke follows it smoothly.</source>
        <translation>Hier einen Punkt in die Bahn einfügen. Ziehen Sie ihn, um ihn zu verschieben; der Zug folgt ihm glatt.</translation>
    </message>
    <message>
        <source>Show this &amp;moment</source>
        <translation>Diesen &amp;Zeitpunkt zeigen</translation>
    </message>
    <message>
        <source>Go to the time on the timeline at which this point was milled.</source>
        <translation>Auf der Zeitleiste zu der Zeit gehen, zu der dieser Punkt gefräst wurde.</translation>
    </message>
    <message>
        <source>Computed point</source>
        <translation>Berechneter Punkt</translation>
    </message>
    <message>
        <source>Esc: leave the point where it was</source>
        <translation>Esc: den Punkt lassen, wo er war</translation>
    </message>
    <message>
        <source>Esc: put the stylus down</source>
        <translation>Esc: den Stift weglegen</translation>
    </message>
</context>
<context>
    <name>burin::PathValuer</name>
    <message>
        <source>Colouring the path</source>
        <translation>Bahn wird gefärbt</translation>
    </message>
</context>
<context>
    <name>burin::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Colours of the window.</source>
        <translation>Farben des Fensters.</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Takes effect at the next start.</source>
        <translation>Gilt ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>A new language takes effect at the next start.</source>
        <translation>Eine andere Sprache gilt ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The unit in which lengths are shown. Files always hold millimetres.</source>
        <translation>Die Einheit, in der Längen angezeigt werden. Dateien enthalten immer Millimeter.</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Close this window.</source>
        <translation>Dieses Fenster schließen.</translation>
    </message>
</context>
<context>
    <name>burin::PresetTable</name>
    <message>
        <source>Add a preset</source>
        <translation>Vorgabe hinzufügen</translation>
    </message>
    <message>
        <source>Feeds and speeds for one material, or for any</source>
        <translation>Schnittwerte für einen Werkstoff oder für jeden</translation>
    </message>
    <message>
        <source>any material</source>
        <translation>jeder Werkstoff</translation>
    </message>
    <message>
        <source>%1 (not available)</source>
        <translation>%1 (nicht vorhanden)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Material of the stock that the preset is for</source>
        <translation>Werkstoff des Rohteils, für den die Vorgabe gilt</translation>
    </message>
    <message>
        <source>by material</source>
        <translation>nach Werkstoff</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>mist</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>flood</source>
        <translation>Schwall</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlung</translation>
    </message>
    <message>
        <source>Coolant that paths with this preset use</source>
        <translation>Kühlmittel, das Bahnen mit dieser Vorgabe verwenden</translation>
    </message>
    <message>
        <source>Prefer preset %1 to the one before it</source>
        <translation>Vorgabe %1 der davor vorziehen</translation>
    </message>
    <message>
        <source>Delete preset %1</source>
        <translation>Vorgabe %1 löschen</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>0: by the feed per tooth</source>
        <translation>0: nach dem Vorschub je Zahn</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>Vorschub je Zahn</translation>
    </message>
    <message>
        <source>0: by the feed</source>
        <translation>0: nach dem Vorschub</translation>
    </message>
    <message>
        <source>Plunge feed</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>0: the share of the feed that the material states</source>
        <translation>0: der Anteil am Vorschub, den der Werkstoff angibt</translation>
    </message>
    <message>
        <source>Step-down</source>
        <translation>Zustellung</translation>
    </message>
    <message>
        <source>Depth of a level, at most the deepest cut. 0: what material, tool and spindle can take</source>
        <translation>Tiefe einer Ebene, höchstens der tiefste Schnitt. 0: was Werkstoff, Werkzeug und Spindel aushalten</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>Zeilenabstand</translation>
    </message>
    <message>
        <source>Between the loops of a level, at most half the diameter. 0: a share of the diameter</source>
        <translation>Zwischen den Umläufen einer Ebene, höchstens der halbe Durchmesser. 0: ein Anteil des Durchmessers</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Name of the preset, different from those of the tool&apos;s other presets</source>
        <translation>Name der Vorgabe, verschieden von denen der anderen Vorgaben des Werkzeugs</translation>
    </message>
    <message>
        <source>Speed of the spindle at which the feed applies</source>
        <translation>Spindeldrehzahl, bei der der Vorschub gilt</translation>
    </message>
</context>
<context>
    <name>burin::ProgramController</name>
    <message>
        <source>Posting and checking</source>
        <translation>Programm wird ausgegeben und geprüft</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>text of the program</source>
        <translation>Text des Programms</translation>
    </message>
    <message>
        <source>Making and checking the rest of the program</source>
        <translation>Rest des Programms erstellen und prüfen</translation>
    </message>
</context>
<context>
    <name>burin::ProgramDock</name>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Put text and findings back into the panel</source>
        <translation>Text und Befunde zurück in das Bedienfeld setzen</translation>
    </message>
</context>
<context>
    <name>burin::ProgramEditor</name>
    <message>
        <source>Check the edited text</source>
        <translation>Bearbeiteten Text prüfen</translation>
    </message>
    <message>
        <source>Findings of the check</source>
        <translation>Befunde der Prüfung</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>Es wird noch gerechnet.</translation>
    </message>
    <message>
        <source>Read the edited text back and mill it again on a fresh workpiece</source>
        <translation>Den bearbeiteten Text zurücklesen und auf einem frischen Werkstück noch einmal fräsen</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
</context>
<context>
    <name>burin::ProgramPanel</name>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Post and check</source>
        <translation>Ausgeben und prüfen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Gouge tolerance</source>
        <translation>Toleranz am Teil</translation>
    </message>
    <message>
        <source>Deepest gouge that passes the check</source>
        <translation>Tiefste Konturverletzung, die noch zugelassen wird</translation>
    </message>
    <message>
        <source>Deepest gouge</source>
        <translation>Tiefste Konturverletzung</translation>
    </message>
    <message>
        <source>On the part</source>
        <translation>Am Teil</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Abgetragen</translation>
    </message>
    <message>
        <source>Machining time</source>
        <translation>Bearbeitungszeit</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Sätze</translation>
    </message>
    <message>
        <source>Post the path first.</source>
        <translation>Geben Sie zuerst die Bahn aus.</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>Es wird noch gerechnet.</translation>
    </message>
    <message>
        <source>The program did not pass its check.</source>
        <translation>Das Programm hat die Prüfung nicht bestanden.</translation>
    </message>
    <message>
        <source>Not passed: 1 finding.</source>
        <translation>Nicht bestanden: 1 Befund.</translation>
    </message>
    <message numerus="yes">
        <source>Not passed: %n findings.</source>
        <translation>
            <numerusform>Nicht bestanden: %n Befund.</numerusform>
            <numerusform>Nicht bestanden: %n Befunde.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program is being posted and checked…</source>
        <translation>Das Programm wird ausgegeben und geprüft…</translation>
    </message>
    <message>
        <source>Make a path first.</source>
        <translation>Machen Sie zuerst eine Bahn.</translation>
    </message>
    <message>
        <source>Passed: gouge %1 (limit %2), no collision, all limits kept.</source>
        <translation>Bestanden: Konturverletzung %1 (Grenze %2), keine Kollision, alle Grenzen eingehalten.</translation>
    </message>
    <message>
        <source>Judged on the exact surfaces at the worst points</source>
        <translation>An den schlechtesten Punkten auf den genauen Flächen beurteilt</translation>
    </message>
    <message>
        <source>Judged on the fine mesh</source>
        <translation>Am feinen Netz beurteilt</translation>
    </message>
    <message>
        <source>Write the program, read it back and mill it again on a fresh workpiece</source>
        <translation>Das Programm schreiben, zurücklesen und an einem frischen Werkstück nachfräsen</translation>
    </message>
    <message>
        <source>Write the program to a file for the machine</source>
        <translation>Das Programm für die Maschine in eine Datei schreiben</translation>
    </message>
    <message>
        <source>Excess, mean / max</source>
        <translation>Restmaterial, mittel / max.</translation>
    </message>
    <message>
        <source>Override the check…</source>
        <translation>Prüfung übergehen…</translation>
    </message>
    <message>
        <source>Give a reason that goes into the program&apos;s header; then it can be exported</source>
        <translation>Einen Grund nennen, der im Kopf des Programms steht; dann lässt es sich exportieren</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Its feeds, speeds and travel limit the program</source>
        <translation>Ihre Vorschübe, Drehzahlen und Verfahrwege begrenzen das Programm</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>NC dialect that the machine&apos;s control reads</source>
        <translation>NC-Dialekt, den die Steuerung der Maschine liest</translation>
    </message>
    <message>
        <source>The text was edited: check it first.</source>
        <translation>Der Text wurde bearbeitet: Prüfen Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>The reason for exporting it is stated in its header.</source>
        <translation>Der Grund für den Export steht in seinem Kopf.</translation>
    </message>
    <message>
        <source>mm (G21)</source>
        <translation>mm (G21)</translation>
    </message>
    <message>
        <source>inch (G20)</source>
        <translation>Zoll (G20)</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Lengths and feeds in the program&apos;s text</source>
        <translation>Längen und Vorschübe im Text des Programms</translation>
    </message>
    <message>
        <source>Tools of the program</source>
        <translation>Werkzeuge des Programms</translation>
    </message>
    <message>
        <source>Whether the program contains the path of this tool</source>
        <translation>Ob das Programm die Bahn dieses Werkzeugs enthält</translation>
    </message>
    <message>
        <source>The takes of %1 have no path and are not in the program. Make a new path to include them.</source>
        <translation>Die Aufnahmen von %1 haben keine Bahn und sind nicht im Programm. Machen Sie eine neue Bahn, damit sie hineinkommen.</translation>
    </message>
    <message>
        <source>Takes or edits changed: update the path first.</source>
        <translation>Aufnahmen oder Bearbeitungen haben sich geändert: Aktualisieren Sie zuerst die Bahn.</translation>
    </message>
    <message>
        <source>The program is not checked yet: post and check it.</source>
        <translation>Das Programm ist noch nicht geprüft: Geben Sie es aus und prüfen Sie es.</translation>
    </message>
    <message>
        <source>The path or its check&apos;s inputs have changed. Post and check again.</source>
        <translation>Die Bahn oder das, womit sie geprüft wurde, hat sich seither geändert: Geben Sie sie neu aus und prüfen Sie sie.</translation>
    </message>
    <message>
        <source>Out of date: passed its check before the last changes.</source>
        <translation>Nicht mehr gültig: bestanden, bevor etwas geändert wurde.</translation>
    </message>
    <message>
        <source>Out of date: failed its check before the last changes.</source>
        <translation>Nicht mehr gültig: nicht bestanden, bevor etwas geändert wurde.</translation>
    </message>
    <message>
        <source>On the part: the share of the cutting moves over the part in which the cutter is within %1 of its surface. Close to 100 % for finishing, low for roughing.</source>
        <translation>Am Teil: der Anteil der Schnittbewegungen über dem Teil, bei denen der Fräser höchstens %1 von der Oberfläche entfernt ist. Beim Schlichten nahe 100 %, beim Schruppen niedrig.</translation>
    </message>
    <message>
        <source>no path</source>
        <translation>keine Bahn</translation>
    </message>
    <message>
        <source>Post and check again.</source>
        <translation>Geben Sie es neu aus und prüfen Sie es.</translation>
    </message>
    <message>
        <source>Machines…</source>
        <translation>Maschinen …</translation>
    </message>
    <message>
        <source>Look at the machines; copy, change and delete your own</source>
        <translation>Die Maschinen ansehen; eigene kopieren, ändern und löschen</translation>
    </message>
    <message>
        <source>The project&apos;s machine “%1” is not on this computer; “%2” is used in its place.</source>
        <translation>Die Maschine „%1“ des Projekts ist nicht auf diesem Rechner; stattdessen gilt „%2“.</translation>
    </message>
    <message>
        <source>Typical values, not those of your machine: copy it and enter yours.</source>
        <translation>Typische Werte, nicht die Ihrer Maschine: kopieren Sie sie und geben Sie Ihre ein.</translation>
    </message>
    <message>
        <source>Your own machine.</source>
        <translation>Ihre eigene Maschine.</translation>
    </message>
    <message>
        <source>With accelerations, corners, dwells and 1 tool change; %1 at the programmed feeds alone</source>
        <translation>Mit Beschleunigungen, Ecken, Verweilzeiten und 1 Werkzeugwechsel; %1 allein mit den programmierten Vorschüben</translation>
    </message>
    <message numerus="yes">
        <source>With accelerations, corners, dwells and %n tool changes; %1 at the programmed feeds alone</source>
        <translation>
            <numerusform>Mit Beschleunigungen, Ecken, Verweilzeiten und %n Werkzeugwechsel; %1 allein mit den programmierten Vorschüben</numerusform>
            <numerusform>Mit Beschleunigungen, Ecken, Verweilzeiten und %n Werkzeugwechseln; %1 allein mit den programmierten Vorschüben</numerusform>
        </translation>
    </message>
    <message>
        <source>Excess tolerance</source>
        <translation>Aufmaßtoleranz</translation>
    </message>
    <message>
        <source>Largest difference allowed between the stock left on the part and what the paths leave, and largest excess at blended corners; 0: not judged</source>
        <translation>Größter zulässiger Unterschied zwischen dem verbleibenden Aufmaß und dem, was die Bahnen stehen lassen, und größtes Aufmaß an verschliffenen Ecken; 0: wird nicht beurteilt</translation>
    </message>
    <message numerus="yes">
        <source>Without moves whose start the program does not state (approach, return): %n</source>
        <translation>
            <numerusform>Ohne Bewegungen, deren Anfang das Programm nicht angibt (Anfahrt, Rückkehr): %n</numerusform>
            <numerusform>Ohne Bewegungen, deren Anfang das Programm nicht angibt (Anfahrt, Rückkehr): %n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>burin::ProgramScenePresenter</name>
    <message>
        <source>rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>waits %1 s</source>
        <translation>wartet %1 s</translation>
    </message>
    <message>
        <source>feed %1 %2/min</source>
        <translation>Vorschub %1 %2/min</translation>
    </message>
    <message>
        <source>spindle %1/min</source>
        <translation>Spindel %1/min</translation>
    </message>
    <message>
        <source>spindle off</source>
        <translation>Spindel aus</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>the hand: %1</source>
        <translation>die Hand: %1</translation>
    </message>
    <message>
        <source>%1 N, peak %2 N</source>
        <translation>%1 N, Spitze %2 N</translation>
    </message>
    <message>
        <source>peak %1 W</source>
        <translation>Spitze %1 W</translation>
    </message>
</context>
<context>
    <name>burin::ProgramText</name>
    <message>
        <source>Edit the program&apos;s text</source>
        <translation>Den Text des Programms bearbeiten</translation>
    </message>
    <message>
        <source>Previous match (Shift+Enter)</source>
        <translation>Voriger Treffer (Umschalt+Eingabe)</translation>
    </message>
    <message>
        <source>Next match (Enter)</source>
        <translation>Nächster Treffer (Eingabe)</translation>
    </message>
    <message>
        <source>Find in the program</source>
        <translation>Im Programm suchen</translation>
    </message>
    <message>
        <source>Text to find, upper or lower case; Enter goes to the next match, Shift+Enter to the previous one</source>
        <translation>Text, groß oder klein; Eingabe geht zum nächsten Treffer, Umschalt+Eingabe zum vorigen</translation>
    </message>
    <message>
        <source>Text of the program</source>
        <translation>Text des Programms</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Number of matches</source>
        <translation>Anzahl der Treffer</translation>
    </message>
    <message>
        <source>The text can&apos;t be changed yet: press this button to edit it</source>
        <translation>Der Text ist noch gesperrt: Diese Schaltfläche macht ihn bearbeitbar</translation>
    </message>
</context>
<context>
    <name>burin::ProgramView</name>
    <message>
        <source>Click a line&apos;s number to stop a play there</source>
        <translation>Ein Klick auf die Nummer einer Zeile hält das Abspielen dort an</translation>
    </message>
</context>
<context>
    <name>burin::ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
</context>
<context>
    <name>burin::QuantityField</name>
    <message>
        <source>%1 is out of range (%2 to %3). The value stays at %4.</source>
        <translation>%1 liegt außerhalb des Bereichs: %2 bis %3 ist möglich. Der Wert ist weiterhin %4.</translation>
    </message>
</context>
<context>
    <name>burin::RoleLabels</name>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einlage</translation>
    </message>
    <message>
        <source>Protected insert</source>
        <translation>Geschützte Einlage</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>Vorrichtung</translation>
    </message>
    <message>
        <source>Ignored</source>
        <translation>Unbeachtet</translation>
    </message>
    <message>
        <source>A part and a protected insert are not cut; an insert is cut and has a material of its own; a fixture holds the stock; stock is what the part is cut from</source>
        <translation>Teil und geschützte Einlage werden nicht geschnitten; eine Einlage wird geschnitten und hat ihren eigenen Werkstoff; eine Vorrichtung hält das Rohteil; das Rohteil ist, woraus das Teil gefräst wird</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Bodies of the model</source>
        <translation>Körper des Modells</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>Aus einer Datei</translation>
    </message>
</context>
<context>
    <name>burin::ScoreController</name>
    <message>
        <source>Scoring</source>
        <translation>Bewertung</translation>
    </message>
</context>
<context>
    <name>burin::ScoreDialog</name>
    <message>
        <source>Score</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>The take that is scored</source>
        <translation>Die Aufnahme, die bewertet wird</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>The take to compare it with, such as a teacher&apos;s; it may be switched off</source>
        <translation>Die Aufnahme, mit der sie verglichen wird, etwa die eines Ausbilders; sie darf ausgeschaltet sein</translation>
    </message>
    <message>
        <source>Draw the reference on the timeline</source>
        <translation>Referenz auf der Zeitleiste zeichnen</translation>
    </message>
    <message>
        <source>Its curves are drawn as thin lines behind those of the take, from the take&apos;s start</source>
        <translation>Ihre Kurven werden als dünne Linien hinter denen der Aufnahme gezeichnet, ab deren Beginn</translation>
    </message>
    <message>
        <source>Progress of the scoring.</source>
        <translation>Fortschritt der Bewertung.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop scoring</source>
        <translation>Die Bewertung abbrechen</translation>
    </message>
    <message>
        <source>Scoring was cancelled; choose a take to start it again.</source>
        <translation>Die Bewertung wurde abgebrochen; wählen Sie eine Aufnahme, um sie neu zu beginnen.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>No reference</source>
        <translation>Keine Referenz</translation>
    </message>
</context>
<context>
    <name>burin::SegmentTable</name>
    <message>
        <source>Add a segment</source>
        <translation>Abschnitt hinzufügen</translation>
    </message>
    <message>
        <source>On top, as wide as the one below</source>
        <translation>Oben darauf, so weit wie der darunter</translation>
    </message>
    <message>
        <source>Segment %1, diameter below</source>
        <translation>Abschnitt %1, Durchmesser unten</translation>
    </message>
    <message>
        <source>Segment %1, diameter above</source>
        <translation>Abschnitt %1, Durchmesser oben</translation>
    </message>
    <message>
        <source>Segment %1, length</source>
        <translation>Abschnitt %1, Länge</translation>
    </message>
    <message>
        <source>Delete segment %1</source>
        <translation>Abschnitt %1 löschen</translation>
    </message>
</context>
<context>
    <name>burin::SelectionCard</name>
    <message>
        <source>Clear the selection (Esc in the view)</source>
        <translation>Auswahl aufheben (Esc in der Ansicht)</translation>
    </message>
    <message>
        <source>Draw instead</source>
        <translation>Stattdessen zeichnen</translation>
    </message>
    <message>
        <source>Click a point of the path in the view to select it; Shift+click selects everything up to it</source>
        <translation>Einen Punkt der Bahn in der Ansicht anklicken, um ihn auszuwählen; Umschalt+Klick wählt alles bis dorthin aus</translation>
    </message>
    <message>
        <source>on its level</source>
        <translation>auf seiner Höhe</translation>
    </message>
    <message>
        <source>Z, the tool&apos;s axis</source>
        <translation>Z, die Werkzeugachse</translation>
    </message>
    <message>
        <source>the part&apos;s surface</source>
        <translation>die Oberfläche des Teils</translation>
    </message>
    <message>
        <source>Drag along</source>
        <translation>Ziehen entlang</translation>
    </message>
    <message>
        <source>How a dragged point of the path moves</source>
        <translation>Wie sich ein gezogener Punkt der Bahn bewegt</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>Ausgewählt: %1</translation>
    </message>
    <message>
        <source>No part of the path is selected</source>
        <translation>Von der Bahn ist nichts ausgewählt</translation>
    </message>
    <message>
        <source>Select part of the path in the view first.</source>
        <translation>Wählen Sie zuerst einen Abschnitt der Bahn in der Ansicht aus.</translation>
    </message>
    <message>
        <source>Draw a stroke in the view that replaces the selected part of the path, at its height</source>
        <translation>Einen Zug in der Ansicht zeichnen, der den ausgewählten Abschnitt der Bahn auf seiner Höhe ersetzt</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>Gleichlauf</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>Gegenlauf</translation>
    </message>
    <message>
        <source>Draw it in the view; Esc cancels</source>
        <translation>Zeichnen Sie ihn in der Ansicht; Esc bricht ab</translation>
    </message>
    <message>
        <source>Timeline: not in this path</source>
        <translation>Zeitleiste: nicht in dieser Bahn</translation>
    </message>
    <message>
        <source>The path has no point that was milled at %1</source>
        <translation>Die Bahn hat keinen Punkt, der zu dieser Zeit gefräst wurde: %1</translation>
    </message>
    <message>
        <source>Timeline: X %1, Y %2, Z %3</source>
        <translation>Zeitleiste: X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Point of the path at the time on the timeline, from program zero: %1</source>
        <translation>Punkt der Bahn zur Zeit auf der Zeitleiste, ab Programmnullpunkt: %1</translation>
    </message>
    <message>
        <source>Edit with the stylus</source>
        <translation>Mit dem Stift bearbeiten</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Distance from the tool&apos;s tip within which a device takes the nearest point of the path</source>
        <translation>Abstand von der Werkzeugspitze, in dem ein Gerät den nächsten Punkt der Bahn greift</translation>
    </message>
    <message>
        <source>Move points of the path with the chosen stylus, and feel part and fixtures meanwhile</source>
        <translation>Punkte der Bahn mit dem gewählten Stift verschieben und dabei Teil und Vorrichtungen fühlen</translation>
    </message>
</context>
<context>
    <name>burin::SetupController</name>
    <message>
        <source>voxel size</source>
        <translation>Voxelgröße</translation>
    </message>
    <message>
        <source>stock margin</source>
        <translation>Zugabe am Rohteil</translation>
    </message>
    <message>
        <source>stock material</source>
        <translation>Werkstoff des Rohteils</translation>
    </message>
    <message>
        <source>material of a body</source>
        <translation>Werkstoff eines Körpers</translation>
    </message>
    <message>
        <source>free carving</source>
        <translation>freies Schnitzen</translation>
    </message>
    <message>
        <source>shape of the stock</source>
        <translation>Form des Rohteils</translation>
    </message>
    <message>
        <source>role of a body</source>
        <translation>Rolle eines Körpers</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Reading the stock from %1</source>
        <translation>Das Rohteil wird aus %1 gelesen</translation>
    </message>
    <message>
        <source>Rotating the stock</source>
        <translation>Rohteil wird gedreht</translation>
    </message>
    <message>
        <source>placement of the part</source>
        <translation>Lage des Teils</translation>
    </message>
    <message>
        <source>program zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>Examining the face</source>
        <translation>Die Fläche wird untersucht</translation>
    </message>
    <message>
        <source>role of bodies</source>
        <translation>Rolle von Körpern</translation>
    </message>
</context>
<context>
    <name>burin::SetupPanel</name>
    <message>
        <source>Placement</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>The current setup. Each setup has its own stock, fixtures, recordings, paths and programs</source>
        <translation>Die aktuelle Aufspannung. Jede hat ihr eigenes Rohteil, ihre Spannmittel, Aufnahmen, Bahnen und Programme</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of this setup, shown in lists and in the file name of its program</source>
        <translation>Name dieser Aufspannung, in Listen und im Dateinamen ihres Programms</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen …</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Update the stock</source>
        <translation>Rohteil aktualisieren</translation>
    </message>
    <message>
        <source>Face down</source>
        <translation>Fläche nach unten</translation>
    </message>
    <message>
        <source>Face up</source>
        <translation>Fläche nach oben</translation>
    </message>
    <message>
        <source>Along X</source>
        <translation>Entlang X</translation>
    </message>
    <message>
        <source>Along Y</source>
        <translation>Entlang Y</translation>
    </message>
    <message>
        <source>90° %1</source>
        <translation>90° %1</translation>
    </message>
    <message>
        <source>Rotation axis</source>
        <translation>Drehachse</translation>
    </message>
    <message>
        <source>Axis of the rotation below; it passes through the centre of the part</source>
        <translation>Achse der Drehung darunter; sie geht durch die Mitte des Teils</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>Drehen um</translation>
    </message>
    <message>
        <source>Rotates the part by this angle. Positive: counter-clockwise, seen from the tip of the axis</source>
        <translation>Dreht das Teil um diesen Winkel. Positiv: gegen den Uhrzeigersinn, von der Spitze der Achse gesehen</translation>
    </message>
    <message>
        <source>Lower corner %1</source>
        <translation>Untere Ecke %1</translation>
    </message>
    <message>
        <source>Lower corner of the part&apos;s bounding box. A new value moves the part</source>
        <translation>Untere Ecke der Hülle des Teils. Ein neuer Wert verschiebt das Teil</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>Spiegeln %1</translation>
    </message>
    <message>
        <source>Import a part first.</source>
        <translation>Importieren Sie zuerst ein Teil.</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>Es wird noch gerechnet.</translation>
    </message>
    <message>
        <source>Embed the part first: the next setup starts with the workpiece of this one.</source>
        <translation>Betten Sie zuerst das Teil ein: Die nächste Aufspannung beginnt mit dem Werkstück dieser.</translation>
    </message>
    <message>
        <source>Add a setup for another side of the part. Its stock is the workpiece that this setup leaves</source>
        <translation>Fügt eine Aufspannung für eine andere Seite des Teils hinzu. Ihr Rohteil ist das Werkstück, das diese übrig lässt</translation>
    </message>
    <message>
        <source>A job needs at least one setup.</source>
        <translation>Ein Auftrag braucht mindestens eine Aufspannung.</translation>
    </message>
    <message>
        <source>Delete this setup. Only a setup without recordings, paths and programs can be deleted</source>
        <translation>Diese Aufspannung löschen. Nur eine ohne Aufnahmen, Bahnen und Programme kann gelöscht werden</translation>
    </message>
    <message>
        <source>The setup that this stock comes from has changed. The stock is not up to date.</source>
        <translation>Die Aufspannung, aus der dieses Rohteil stammt, hat sich geändert. Das Rohteil ist nicht aktuell.</translation>
    </message>
    <message>
        <source>Delete the recordings of this setup first.</source>
        <translation>Löschen Sie zuerst die Aufnahmen dieser Aufspannung.</translation>
    </message>
    <message>
        <source>Replay the setup that this stock comes from, and use its workpiece</source>
        <translation>Die Aufspannung, aus der dieses Rohteil stammt, nachfräsen und ihr Werkstück verwenden</translation>
    </message>
    <message>
        <source>This setup has recordings. Add a setup to rotate the part.</source>
        <translation>Diese Aufspannung hat Aufnahmen. Fügen Sie eine Aufspannung hinzu, um das Teil zu drehen.</translation>
    </message>
    <message>
        <source>Click a face: the part is rotated so that it points down. A cylinder or cone: so that its axis is vertical</source>
        <translation>Klicken Sie auf eine Fläche: Das Teil wird so gedreht, dass sie nach unten zeigt. Zylinder oder Kegel: dass die Achse senkrecht steht</translation>
    </message>
    <message>
        <source>Click a face: the part is rotated so that it points up. A cylinder or cone: so that its axis is vertical</source>
        <translation>Klicken Sie auf eine Fläche: Das Teil wird so gedreht, dass sie nach oben zeigt. Zylinder oder Kegel: dass die Achse senkrecht steht</translation>
    </message>
    <message>
        <source>Click a face: the part is rotated so that it points along X. A cylinder or cone: so that its axis is parallel to X</source>
        <translation>Klicken Sie auf eine Fläche: Das Teil wird so gedreht, dass sie entlang X zeigt. Zylinder oder Kegel: dass die Achse parallel zu X ist</translation>
    </message>
    <message>
        <source>Click a face: the part is rotated so that it points along Y. A cylinder or cone: so that its axis is parallel to Y</source>
        <translation>Klicken Sie auf eine Fläche: Das Teil wird so gedreht, dass sie entlang Y zeigt. Zylinder oder Kegel: dass die Achse parallel zu Y ist</translation>
    </message>
    <message>
        <source>Click a face of the part in the view.</source>
        <translation>Klicken Sie in der Ansicht auf eine Fläche des Teils.</translation>
    </message>
    <message>
        <source>Rotate the part by 90° about %1, through its centre</source>
        <translation>Das Teil um 90° um %1 drehen, durch seine Mitte</translation>
    </message>
    <message>
        <source>A part with several setups can&apos;t be mirrored.</source>
        <translation>Ein Teil mit mehreren Aufspannungen kann nicht gespiegelt werden.</translation>
    </message>
    <message>
        <source>Mirror the part across %1. It is then another part than the one in the file</source>
        <translation>Spiegelt das Teil an %1. Es ist dann ein anderes Teil als das der Datei</translation>
    </message>
</context>
<context>
    <name>burin::SetupsController</name>
    <message>
        <source>Preparing the stock</source>
        <translation>Rohteil wird vorbereitet</translation>
    </message>
    <message>
        <source>Setup %1</source>
        <translation>Aufspannung %1</translation>
    </message>
    <message>
        <source>further setup</source>
        <translation>weitere Aufspannung</translation>
    </message>
    <message>
        <source>name of a setup</source>
        <translation>Name einer Aufspannung</translation>
    </message>
    <message>
        <source>deletion of a setup</source>
        <translation>Löschen einer Aufspannung</translation>
    </message>
    <message>
        <source>stock of another setup</source>
        <translation>Rohteil aus einer anderen Aufspannung</translation>
    </message>
</context>
<context>
    <name>burin::SetupsPresenter</name>
    <message>
        <source>Setup %1</source>
        <translation>Aufspannung %1</translation>
    </message>
    <message>
        <source>This face is curved and has no direction. Click a plane, a cylinder or a cone.</source>
        <translation>Diese Fläche ist gekrümmt und hat keine Richtung. Klicken Sie auf eine Ebene, einen Zylinder oder einen Kegel.</translation>
    </message>
</context>
<context>
    <name>burin::SheetController</name>
    <message>
        <source>Preparing the setup sheet</source>
        <translation>Das Einrichteblatt wird vorbereitet</translation>
    </message>
</context>
<context>
    <name>burin::SheetText</name>
    <message>
        <source>Project %1, %2</source>
        <translation>Projekt %1, %2</translation>
    </message>
    <message>
        <source>Setup sheet: %1</source>
        <translation>Einrichteblatt: %1</translation>
    </message>
    <message>
        <source>Setup sheet: %1, setup %2</source>
        <translation>Einrichteblatt: %1, Aufspannung %2</translation>
    </message>
    <message>
        <source>There is no checked program for this setup yet.</source>
        <translation>Für diese Aufspannung gibt es noch kein geprüftes Programm.</translation>
    </message>
    <message>
        <source>The setup has changed since the program was checked. Check it again.</source>
        <translation>Die Aufspannung hat sich seit der Prüfung des Programms geändert. Prüfen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The program failed its check and was exported with a reason. See below.</source>
        <translation>Das Programm hat die Prüfung nicht bestanden und wurde mit einer Begründung exportiert. Siehe unten.</translation>
    </message>
    <message>
        <source>The program failed its check. Do not run it.</source>
        <translation>Das Programm hat die Prüfung nicht bestanden. Nicht ausführen.</translation>
    </message>
    <message>
        <source>Stock with the part, as clamped</source>
        <translation>Rohteil mit dem Teil, wie gespannt</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Machine and zero</source>
        <translation>Maschine und Nullpunkt</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Units of the program</source>
        <translation>Einheit des Programms</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>Program zero</source>
        <translation>Nullpunkt des Programms</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Round bar</source>
        <translation>Rundstab</translation>
    </message>
    <message>
        <source>diameter %1, length %2</source>
        <translation>Durchmesser %1, Länge %2</translation>
    </message>
    <message>
        <source>Comes from</source>
        <translation>Stammt aus</translation>
    </message>
    <message>
        <source>setup %1</source>
        <translation>Aufspannung %1</translation>
    </message>
    <message>
        <source>, %1 g</source>
        <translation>, %1 g</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Fixtures and keep-out volumes</source>
        <translation>Vorrichtungen und Sperrräume</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>Vorrichtung</translation>
    </message>
    <message>
        <source>keep out</source>
        <translation>Sperrraum</translation>
    </message>
    <message>
        <source>%1, off</source>
        <translation>%1, aus</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>Noch keine.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>Schneide</translation>
    </message>
    <message>
        <source>Stick-out</source>
        <translation>Auskragung</translation>
    </message>
    <message>
        <source>Speed, 1/min</source>
        <translation>Drehzahl, 1/min</translation>
    </message>
    <message>
        <source>Feed, in/min</source>
        <translation>Vorschub, in/min</translation>
    </message>
    <message>
        <source>Feed, mm/min</source>
        <translation>Vorschub, mm/min</translation>
    </message>
    <message>
        <source>Lowest Z, %1</source>
        <translation>Tiefstes Z, %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed, exported with a reason</source>
        <translation>nicht bestanden, mit Begründung exportiert</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>%1 (tolerance %2)</source>
        <translation>%1 (Toleranz %2)</translation>
    </message>
    <message>
        <source>Machining time</source>
        <translation>Bearbeitungszeit</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Sätze</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>The check found nothing.</source>
        <translation>Die Prüfung hat nichts gefunden.</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>flutes %1</source>
        <translation>Schneiden %1</translation>
    </message>
    <message>
        <source>stick-out %1</source>
        <translation>Auskragung %1</translation>
    </message>
    <message>
        <source>Maximum gouge</source>
        <translation>Größte Konturverletzung</translation>
    </message>
    <message>
        <source>From zero to the stock: left, front, bottom</source>
        <translation>Von Null zum Rohteil: links, vorn, unten</translation>
    </message>
    <message>
        <source>From zero to the stock: right, back, top</source>
        <translation>Von Null zum Rohteil: rechts, hinten, oben</translation>
    </message>
</context>
<context>
    <name>burin::ShortcutDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>&amp;Assign</source>
        <translation>&amp;Zuweisen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Re&amp;set</source>
        <translation>Zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Show only actions whose name, tooltip or shortcut contains this.</source>
        <translation>Nur Befehle zeigen, deren Name, Hinweis oder Tastenkürzel dies enthält.</translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation>Befehle und ihre Tastenkürzel</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Neues Tastenkürzel</translation>
    </message>
    <message>
        <source>Click here and press the new shortcut.</source>
        <translation>Hier klicken und das neue Tastenkürzel drücken.</translation>
    </message>
    <message>
        <source>Assign this shortcut to the selected action.</source>
        <translation>Dieses Tastenkürzel dem gewählten Befehl zuweisen.</translation>
    </message>
    <message>
        <source>Remove the shortcut of the selected action.</source>
        <translation>Das Tastenkürzel des gewählten Befehls entfernen.</translation>
    </message>
    <message>
        <source>Reset the shortcut of the selected action to its default.</source>
        <translation>Das Tastenkürzel des gewählten Befehls auf die Vorgabe zurücksetzen.</translation>
    </message>
    <message>
        <source>Reset the shortcuts of all actions to their defaults.</source>
        <translation>Die Tastenkürzel aller Befehle auf die Vorgabe zurücksetzen.</translation>
    </message>
    <message>
        <source>“%1” has this shortcut and would lose it.</source>
        <translation>„%1“ hat dieses Tastenkürzel und würde es verlieren.</translation>
    </message>
</context>
<context>
    <name>burin::ShowMe</name>
    <message>
        <source>Planning the strokes</source>
        <translation>Züge werden geplant</translation>
    </message>
</context>
<context>
    <name>burin::StatusLine</name>
    <message>
        <source>Stylus that moves the tool.</source>
        <translation>Stift, der das Werkzeug bewegt.</translation>
    </message>
    <message>
        <source>Position of the tool tip, in the coordinates of the program.</source>
        <translation>Position der Werkzeugspitze, in den Koordinaten des Programms.</translation>
    </message>
    <message>
        <source>Whether all changes are saved in the project file.</source>
        <translation>Ob alle Änderungen in der Projektdatei gespeichert sind.</translation>
    </message>
    <message>
        <source>Work in the background.</source>
        <translation>Arbeit im Hintergrund.</translation>
    </message>
    <message>
        <source>Progress of the work in the background.</source>
        <translation>Fortschritt der Arbeit im Hintergrund.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the work in the background.</source>
        <translation>Bricht die Arbeit im Hintergrund ab.</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Wird abgebrochen</translation>
    </message>
    <message>
        <source>Haptic loop: ticks per second; interval between two forces and computing time of a tick, neither of which 999 of 1000 exceed; ticks missed.</source>
        <translation>Haptikschleife: Takte je Sekunde; Abstand zweier Kräfte und Rechenzeit eines Takts, die 999 von 1000 nicht überschreiten; verpasste Takte.</translation>
    </message>
    <message>
        <source>Everything that is cut is recorded in this take.</source>
        <translation>Alles, was geschnitten wird, kommt in diese Aufnahme.</translation>
    </message>
    <message>
        <source>Effect of the Escape key.</source>
        <translation>Wirkung der Esc-Taste.</translation>
    </message>
    <message>
        <source>Voxels of the workpiece, the memory reserved for it, and a hash of it: the same recordings and settings give the same hash.</source>
        <translation>Voxel des Werkstücks, der dafür reservierte Speicher und sein Prüfwert: Gleiche Aufnahmen und Einstellungen ergeben denselben.</translation>
    </message>
</context>
<context>
    <name>burin::StatusPresenter</name>
    <message>
        <source>Read only</source>
        <translation>Nur lesen</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Noch nicht gespeichert</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Saved just now</source>
        <translation>Gerade gespeichert</translation>
    </message>
    <message>
        <source>Saved at %1</source>
        <translation>Um %1 gespeichert</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels · %4 MB</source>
        <translation>%1 × %2 × %3 Voxel · %4 MB</translation>
    </message>
    <message>
        <source>Saved 1 minute ago</source>
        <translation>Vor 1 Minute gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>Saved %n minutes ago</source>
        <translation>
            <numerusform>Vor %n Minute gespeichert</numerusform>
            <numerusform>Vor %n Minuten gespeichert</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Hz · p99.9 %2 ms, work %3 µs · %4 missed</source>
        <translation>%1 Hz · p99,9 %2 ms, Arbeit %3 µs · %4 verpasst</translation>
    </message>
    <message>
        <source>battery %1</source>
        <translation>Akku %1</translation>
    </message>
    <message>
        <source>motors %1</source>
        <translation>Motoren %1</translation>
    </message>
    <message>
        <source>● Recording %1</source>
        <translation>● Aufnahme %1</translation>
    </message>
    <message>
        <source>hash %1</source>
        <translation>Prüfwert %1</translation>
    </message>
</context>
<context>
    <name>burin::StepBar</name>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Mill</source>
        <translation>Fräsen</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
</context>
<context>
    <name>burin::StepButton</name>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>can be done</source>
        <translation>möglich</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>beanstandet</translation>
    </message>
</context>
<context>
    <name>burin::StockPanel</name>
    <message>
        <source>Margin, sides</source>
        <translation>Zugabe seitlich</translation>
    </message>
    <message>
        <source>Stock beside the part, on all four sides</source>
        <translation>Material neben dem Teil, auf allen vier Seiten</translation>
    </message>
    <message>
        <source>Margin, top</source>
        <translation>Zugabe oben</translation>
    </message>
    <message>
        <source>Stock above the part</source>
        <translation>Material über dem Teil</translation>
    </message>
    <message>
        <source>Margin, bottom</source>
        <translation>Zugabe unten</translation>
    </message>
    <message>
        <source>Stock below the part</source>
        <translation>Material unter dem Teil</translation>
    </message>
    <message>
        <source>Stock size</source>
        <translation>Rohteilgröße</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>Voxelgröße</translation>
    </message>
    <message>
        <source>Smaller voxels show finer detail and take more memory</source>
        <translation>Kleinere Voxel zeigen feinere Einzelheiten und brauchen mehr Speicher</translation>
    </message>
    <message>
        <source>Embed the part</source>
        <translation>Teil einbetten</translation>
    </message>
    <message>
        <source>%1&#xa0;million</source>
        <translation>%1&#xa0;Mio.</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels = %4, %5&#xa0;MB</source>
        <translation>%1 × %2 × %3 Voxel = %4, %5&#xa0;MB</translation>
    </message>
    <message>
        <source>Import a part first.</source>
        <translation>Importieren Sie zuerst ein Teil.</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>Es wird noch gerechnet.</translation>
    </message>
    <message>
        <source>Stock and material can&apos;t be changed once there are takes.</source>
        <translation>Sobald es Aufnahmen gibt, lassen sich Rohteil und Werkstoff nicht mehr ändern.</translation>
    </message>
    <message>
        <source>The margins of the sides differ: %1 to %2. An entry sets all four.</source>
        <translation>Die seitlichen Zugaben sind verschieden: %1 bis %2. Eine Eingabe setzt alle vier.</translation>
    </message>
    <message>
        <source>Embedded</source>
        <translation>Eingebettet</translation>
    </message>
    <message>
        <source>Embed the part in its stock; this makes the workpiece</source>
        <translation>Das Teil in sein Rohteil einbetten; so entsteht das Werkstück</translation>
    </message>
    <message>
        <source>The workpiece matches these settings.</source>
        <translation>Das Werkstück entspricht diesen Einstellungen.</translation>
    </message>
    <message>
        <source>The workpiece matches these settings; after a change of stock or voxels it has to be embedded again.</source>
        <translation>Das Werkstück entspricht diesen Einstellungen; nach einer Änderung von Rohteil oder Voxeln muss es neu eingebettet werden.</translation>
    </message>
    <message>
        <source>Embedding has 1 finding. See the end of this page.</source>
        <translation>Das Einbetten hat 1 Befund. Er steht am Ende dieser Seite.</translation>
    </message>
    <message numerus="yes">
        <source>Embedding has %n findings. See the end of this page.</source>
        <translation>
            <numerusform>Das Einbetten hat %n Befund. Er steht am Ende dieser Seite.</numerusform>
            <numerusform>Das Einbetten hat %n Befunde. Sie stehen am Ende dieser Seite.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
</context>
<context>
    <name>burin::StockShapeFields</name>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Direction that the axis of the cylinder lies in</source>
        <translation>Richtung, in der die Achse des Zylinders liegt</translation>
    </message>
    <message>
        <source>On: the stock is where it is stated, whatever the part. Off: it lies around the part, with margins</source>
        <translation>Ein: Das Rohteil liegt, wo es angegeben ist, unabhängig vom Teil. Aus: Es liegt um das Teil, mit Zugaben</translation>
    </message>
    <message>
        <source>On: no part is needed. Where there is none nothing pushes the tool back</source>
        <translation>Ein: Ein Teil ist nicht nötig. Wo keines ist, hält nichts das Werkzeug zurück</translation>
    </message>
    <message>
        <source>In the model&apos;s frame</source>
        <translation>Im Koordinatensystem des Modells</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>Bis %1</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>Von %1</translation>
    </message>
    <message>
        <source>Middle of its end, %1</source>
        <translation>Mitte der Stirnseite, %1</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Another direction</source>
        <translation>Andere Richtung</translation>
    </message>
    <message>
        <source>At a stated place</source>
        <translation>An angegebener Stelle</translation>
    </message>
    <message>
        <source>Free carving</source>
        <translation>Freies Schnitzen</translation>
    </message>
    <message>
        <source>A box, a round bar, the bodies of the model whose role is stock, or what a file holds</source>
        <translation>Ein Quader, ein Rundstab, die Körper des Modells mit der Rolle Rohteil, oder was eine Datei enthält</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Read the stock from another volume file, voxel array (a scan) or model</source>
        <translation>Das Rohteil aus einer anderen Volumendatei, einem anderen Voxelfeld (einem Scan) oder Modell lesen</translation>
    </message>
</context>
<context>
    <name>burin::StockSolidController</name>
    <message>
        <source>Preparing the stock for fixtures</source>
        <translation>Rohteil wird für Vorrichtungen vorbereitet</translation>
    </message>
    <message>
        <source>Fitting the fixture to the stock</source>
        <translation>Die Vorrichtung wird an das Rohteil angepasst</translation>
    </message>
</context>
<context>
    <name>burin::StylusController</name>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Connecting %1</source>
        <translation>%1 wird verbunden</translation>
    </message>
</context>
<context>
    <name>burin::StylusEditPresenter</name>
    <message>
        <source>Drag a point of the path: the tool goes with it, along part, fixtures and travel.</source>
        <translation>Ziehen Sie einen Punkt der Bahn: Das Werkzeug geht mit ihm, an Teil, Vorrichtungen und Verfahrweg entlang.</translation>
    </message>
    <message>
        <source>Move the tool to the path, hold the device&apos;s first button to take the nearest point within reach, and let go where it is to be.</source>
        <translation>Bewegen Sie das Werkzeug zur Bahn, greifen Sie mit der ersten Taste des Geräts den nächsten Punkt in Reichweite, und lassen Sie die Taste los, wo er hin soll.</translation>
    </message>
    <message>
        <source>Wait until the path is up to date.</source>
        <translation>Warten Sie, bis die Bahn aktuell ist.</translation>
    </message>
    <message>
        <source>The point is moved by %1</source>
        <translation>Der Punkt wird um %1 verschoben</translation>
    </message>
    <message>
        <source>Drag a point of the path in the view</source>
        <translation>Ziehen Sie einen Punkt der Bahn in der Ansicht</translation>
    </message>
    <message>
        <source>A point is in reach, at %1</source>
        <translation>Ein Punkt ist in Reichweite, im Abstand %1</translation>
    </message>
    <message>
        <source>No point is in reach</source>
        <translation>Kein Punkt ist in Reichweite</translation>
    </message>
    <message>
        <source>Leave mill mode first.</source>
        <translation>Verlassen Sie zuerst den Fräsmodus.</translation>
    </message>
    <message>
        <source>Wait until the workpiece and the boundary are ready.</source>
        <translation>Warten Sie, bis das Werkstück und die Grenze bereit sind.</translation>
    </message>
    <message>
        <source>Make a path first.</source>
        <translation>Erzeugen Sie zuerst eine Bahn.</translation>
    </message>
</context>
<context>
    <name>burin::StylusEditor</name>
    <message>
        <source>“%1” has no button that could take a point of the path. Choose another device, or drag the point with the mouse.</source>
        <translation>„%1“ hat keine Taste, die einen Punkt der Bahn greifen könnte. Wählen Sie ein anderes Gerät, oder ziehen Sie den Punkt mit der Maus.</translation>
    </message>
</context>
<context>
    <name>burin::SurroundingsController</name>
    <message>
        <source>Keep-out %1</source>
        <translation>Sperrraum %1</translation>
    </message>
    <message>
        <source>Fixture %1</source>
        <translation>Vorrichtung %1</translation>
    </message>
    <message>
        <source>new fixture</source>
        <translation>neue Vorrichtung</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>Vorrichtung</translation>
    </message>
    <message>
        <source>fixture deleted</source>
        <translation>Vorrichtung gelöscht</translation>
    </message>
    <message>
        <source>fixture on</source>
        <translation>Vorrichtung ein</translation>
    </message>
    <message>
        <source>fixture off</source>
        <translation>Vorrichtung aus</translation>
    </message>
    <message>
        <source>tool axis</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>machine&apos;s travel</source>
        <translation>Verfahrweg der Maschine</translation>
    </message>
    <message>
        <source>fixture renamed</source>
        <translation>Vorrichtung umbenannt</translation>
    </message>
    <message>
        <source>fixture moved</source>
        <translation>Vorrichtung verschoben</translation>
    </message>
</context>
<context>
    <name>burin::SurroundingsPanel</name>
    <message>
        <source>Fixtures and keep-out volumes</source>
        <translation>Vorrichtungen und Sperrräume</translation>
    </message>
    <message>
        <source>There is no fixture yet. The tool keeps clear of fixtures and keep-out volumes, and the hand feels them.</source>
        <translation>Noch gibt es keine Vorrichtung. Das Werkzeug hält Abstand von Vorrichtungen und Sperrräumen, und die Hand fühlt sie.</translation>
    </message>
    <message>
        <source>Machine&apos;s travel</source>
        <translation>Verfahrweg der Maschine</translation>
    </message>
    <message>
        <source>Kind of fixture or keep-out volume to add</source>
        <translation>Art der Vorrichtung oder des Sperrraums, der hinzukommt</translation>
    </message>
    <message>
        <source>Fixture: box</source>
        <translation>Vorrichtung: Quader</translation>
    </message>
    <message>
        <source>Fixture: cylinder</source>
        <translation>Vorrichtung: Zylinder</translation>
    </message>
    <message>
        <source>Fixture from a file…</source>
        <translation>Vorrichtung aus Datei…</translation>
    </message>
    <message>
        <source>Keep out: box</source>
        <translation>Sperrraum: Quader</translation>
    </message>
    <message>
        <source>Keep out: cylinder</source>
        <translation>Sperrraum: Zylinder</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>fixed, Z</source>
        <translation>fest, Z</translation>
    </message>
    <message>
        <source>chosen, 3+2</source>
        <translation>gewählt, 3+2</translation>
    </message>
    <message>
        <source>free, with the hand</source>
        <translation>frei, mit der Hand</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Whether the tool axis is fixed, chosen or free</source>
        <translation>Ob die Werkzeugachse fest, gewählt oder frei ist</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Angle between the tool axis and Z</source>
        <translation>Winkel zwischen Werkzeugachse und Z</translation>
    </message>
    <message>
        <source>Towards</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Where the holder leans to: 0° is X, 90° is Y</source>
        <translation>Wohin sich der Halter neigt: 0° ist X, 90° ist Y</translation>
    </message>
    <message>
        <source>Along the view</source>
        <translation>In Blickrichtung</translation>
    </message>
    <message>
        <source>Stop the recording first.</source>
        <translation>Beenden Sie zuerst die Aufzeichnung.</translation>
    </message>
    <message>
        <source>Sets the tool axis to the view direction (3+2 milling)</source>
        <translation>Setzt die Werkzeugachse in die Blickrichtung (3+2-Fräsen)</translation>
    </message>
    <message>
        <source>Import a part first.</source>
        <translation>Importieren Sie zuerst ein Teil.</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>Es wird noch gerechnet.</translation>
    </message>
    <message>
        <source>The machine&apos;s travel limits a vertical tool only.</source>
        <translation>Der Verfahrweg begrenzt nur ein senkrechtes Werkzeug.</translation>
    </message>
    <message>
        <source>The tool tip stays within the travel of the machine&apos;s axes</source>
        <translation>Die Werkzeugspitze bleibt im Verfahrweg der Achsen der Maschine</translation>
    </message>
    <message>
        <source>Puts it next to the stock, or at the coordinates of its file. An STL file has the unit of the part&apos;s STL file, else mm.</source>
        <translation>Stellt es neben das Rohteil oder an die Koordinaten seiner Datei. Eine STL-Datei hat die Einheit der STL-Datei des Teils, sonst mm.</translation>
    </message>
    <message>
        <source>Kind to add</source>
        <translation>Art des Neuen</translation>
    </message>
    <message>
        <source>Fixture from the library…</source>
        <translation>Vorrichtung aus Bibliothek…</translation>
    </message>
</context>
<context>
    <name>burin::TakeDeviations</name>
    <message>
        <source>Computing the deviation of the takes</source>
        <translation>Abweichung der Aufnahmen wird berechnet</translation>
    </message>
</context>
<context>
    <name>burin::TakeList</name>
    <message>
        <source>1 stroke</source>
        <translation>1 Zug</translation>
    </message>
    <message>
        <source>being replayed</source>
        <translation>wird wiederholt</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n Zug</numerusform>
            <numerusform>%n Züge</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Messpunkte</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>wird aufgenommen</translation>
    </message>
    <message>
        <source>Delete this take</source>
        <translation>Diese Aufnahme löschen</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
</context>
<context>
    <name>burin::TargetController</name>
    <message>
        <source>machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>units of the program</source>
        <translation>Einheit des Programms</translation>
    </message>
    <message>
        <source>copy of a machine</source>
        <translation>Kopie einer Maschine</translation>
    </message>
    <message>
        <source>values of a machine</source>
        <translation>Werte einer Maschine</translation>
    </message>
    <message>
        <source>deleting a machine</source>
        <translation>Löschen einer Maschine</translation>
    </message>
</context>
<context>
    <name>burin::TimeController</name>
    <message>
        <source>switch on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>switch off</source>
        <translation>Ausschalten</translation>
    </message>
    <message>
        <source>punch in</source>
        <translation>Einstieg</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>delete a marker</source>
        <translation>Marke löschen</translation>
    </message>
    <message>
        <source>Reading the program&apos;s time</source>
        <translation>Zeit des Programms wird gelesen</translation>
    </message>
    <message>
        <source>Computing the workpiece at that time</source>
        <translation>Werkstück zu dieser Zeit wird berechnet</translation>
    </message>
    <message>
        <source>Storing the workpiece</source>
        <translation>Werkstück wird abgelegt</translation>
    </message>
</context>
<context>
    <name>burin::TimePresenter</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung läuft</translation>
    </message>
</context>
<context>
    <name>burin::TimelinePanel</name>
    <message>
        <source>Cutting force on the tool.</source>
        <translation>Schnittkraft am Werkzeug.</translation>
    </message>
    <message>
        <source>Volume removed per time.</source>
        <translation>Abgetragenes Volumen je Zeit.</translation>
    </message>
    <message>
        <source>Z of the tip in the setup&apos;s coordinates.</source>
        <translation>Z der Spitze in den Koordinaten der Aufspannung.</translation>
    </message>
    <message>
        <source>¼ ×</source>
        <translation>¼ ×</translation>
    </message>
    <message>
        <source>½ ×</source>
        <translation>½ ×</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>Reading the takes…</source>
        <translation>Aufnahmen werden gelesen …</translation>
    </message>
    <message>
        <source>Distance by which the part, a fixture or a guide held the hand back.</source>
        <translation>Strecke, um die Teil, Spannmittel oder Führung die Hand zurückhielten.</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Abspielgeschwindigkeit</translation>
    </message>
    <message>
        <source>Playback speed, as a multiple of real time.</source>
        <translation>Abspielgeschwindigkeit als Vielfaches der Echtzeit.</translation>
    </message>
    <message>
        <source>Speed of the tool tip.</source>
        <translation>Geschwindigkeit der Werkzeugspitze.</translation>
    </message>
    <message>
        <source>Cross-section of the cut: volume removed per distance moved.</source>
        <translation>Querschnitt des Schnitts: abgetragenes Volumen je Weg.</translation>
    </message>
    <message>
        <source>Select the curves to draw.</source>
        <translation>Wählt die Kurven, die gezeichnet werden.</translation>
    </message>
    <message>
        <source>Distance of the tool from the part; negative: the tool is in the part. Distances above 5 mm are drawn as 5 mm.</source>
        <translation>Abstand des Werkzeugs vom Teil; negativ: Das Werkzeug ist im Teil. Abstände über 5 mm werden als 5 mm gezeichnet.</translation>
    </message>
</context>
<context>
    <name>burin::TimelineView</name>
    <message>
        <source>Timeline of the takes</source>
        <translation>Zeitleiste der Aufnahmen</translation>
    </message>
    <message>
        <source>Left and right arrow keys move through the time, Space plays, plus and minus zoom.</source>
        <translation>Pfeiltasten nach links und rechts gehen durch die Zeit, die Leertaste spielt ab, Plus und Minus zoomen.</translation>
    </message>
    <message>
        <source>Takes appear here once something was milled.</source>
        <translation>Hier erscheinen Aufnahmen, sobald etwas gefräst wurde.</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The program&apos;s time is being read.</source>
        <translation>Die Zeit des Programms wird gelesen.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Click or drag to go to that time. Mouse wheel: zoom; with Shift: scroll.</source>
        <translation>Klicken oder ziehen: zu dieser Zeit gehen. Mausrad: zoomen; mit Umschalt: verschieben.</translation>
    </message>
    <message>
        <source>%1: %2, reference: %3</source>
        <translation>%1: %2, Referenz: %3</translation>
    </message>
    <message>
        <source>The selected point was computed: no take has it</source>
        <translation>Der gewählte Punkt ist berechnet: keine Aufnahme enthält ihn</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>lowest and highest value</comment>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>burin::ToolController</name>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Making a tool of %1</source>
        <translation>Aus %1 wird ein Werkzeug gemacht</translation>
    </message>
    <message>
        <source>new tool</source>
        <translation>neues Werkzeug</translation>
    </message>
    <message>
        <source>copy of a tool</source>
        <translation>Kopie eines Werkzeugs</translation>
    </message>
    <message>
        <source>values of a tool</source>
        <translation>Werte eines Werkzeugs</translation>
    </message>
    <message>
        <source>deleting a tool</source>
        <translation>Löschen eines Werkzeugs</translation>
    </message>
    <message>
        <source>import of tools</source>
        <translation>Import von Werkzeugen</translation>
    </message>
    <message>
        <source>new tool library</source>
        <translation>neue Werkzeugbibliothek</translation>
    </message>
    <message>
        <source>moving a tool to another library</source>
        <translation>Verschieben eines Werkzeugs in eine andere Bibliothek</translation>
    </message>
    <message>
        <source>name of a tool library</source>
        <translation>Name einer Werkzeugbibliothek</translation>
    </message>
    <message>
        <source>deleting a tool library</source>
        <translation>Löschen einer Werkzeugbibliothek</translation>
    </message>
</context>
<context>
    <name>burin::ToolDialog</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>shipped</source>
        <translation>mitgeliefert</translation>
    </message>
    <message>
        <source>Copy this tool to one of your own and change that</source>
        <translation>Dieses Werkzeug in ein eigenes kopieren und das ändern</translation>
    </message>
    <message>
        <source>Delete this tool; Undo brings it back (Del in the list)</source>
        <translation>Dieses Werkzeug löschen; Rückgängig bringt es zurück (Entf in der Liste)</translation>
    </message>
    <message>
        <source>The tools that Burin is shipped with can&apos;t be deleted.</source>
        <translation>Die mitgelieferten Werkzeuge können nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>There is a tool with the ID “%1” already; give the one in the file another ID.</source>
        <translation>Es gibt schon ein Werkzeug mit der ID „%1“; geben Sie dem in der Datei eine andere ID.</translation>
    </message>
    <message>
        <source>The open project has recordings with this tool and keeps the values that they were made with.</source>
        <translation>Das offene Projekt hat Aufzeichnungen mit diesem Werkzeug und behält die Werte, mit denen sie gemacht wurden.</translation>
    </message>
    <message>
        <source>Burin is shipped with this tool, which can&apos;t be changed. Copy it and enter the values of your own.</source>
        <translation>Dieses Werkzeug wird mit Burin geliefert und kann nicht geändert werden. Kopieren Sie es und geben Sie die Werte Ihres eigenen ein.</translation>
    </message>
    <message>
        <source>Your own tool.</source>
        <translation>Ihr eigenes Werkzeug.</translation>
    </message>
    <message>
        <source>It is in the spindle.</source>
        <translation>Es ist in der Spindel.</translation>
    </message>
    <message>
        <source>Mill with this tool (Ctrl+Return)</source>
        <translation>Mit diesem Werkzeug fräsen (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (Kopie)</translation>
    </message>
    <message>
        <source>Add a tool file, or a tool bit of FreeCAD (.fctb)</source>
        <translation>Eine Werkzeugdatei oder ein Werkzeug-Bit von FreeCAD (.fctb) hinzufügen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Written to “%1”.</source>
        <translation>Nach „%1“ geschrieben.</translation>
    </message>
    <message>
        <source>Load into the spindle</source>
        <translation>In die Spindel einsetzen</translation>
    </message>
    <message>
        <source>A recording is running; end it first.</source>
        <translation>Eine Aufzeichnung läuft; beenden Sie sie zuerst.</translation>
    </message>
    <message>
        <source>Check the stick-out, holder and limits of each tool; other programs may not store them.</source>
        <translation>Prüfen Sie Auskragung, Halter und Grenzen jedes Werkzeugs; andere Programme speichern sie oft nicht.</translation>
    </message>
    <message>
        <source>Move or copy to…</source>
        <translation>Verschieben oder kopieren…</translation>
    </message>
    <message>
        <source>Put this tool, or a copy of it, into another library</source>
        <translation>Dieses Werkzeug oder eine Kopie davon in eine andere Bibliothek legen</translation>
    </message>
    <message>
        <source>Write this tool for FreeCAD (.fctb), or the listed library for FreeCAD (.fctl), LinuxCNC (.tbl), Fusion (.tools) or CAMotics (.ctbl)</source>
        <translation>Dieses Werkzeug für FreeCAD (.fctb) schreiben oder die aufgelistete Bibliothek für FreeCAD (.fctl), LinuxCNC (.tbl), Fusion (.tools) oder CAMotics (.ctbl)</translation>
    </message>
    <message>
        <source>This library is empty. Copy or move tools into it, or add them from a file.</source>
        <translation>Diese Bibliothek ist leer. Kopieren oder verschieben Sie Werkzeuge hinein, oder fügen Sie welche aus einer Datei hinzu.</translation>
    </message>
    <message>
        <source>A preset has no name; enter one.</source>
        <translation>Eine Vorgabe hat keinen Namen; geben Sie einen ein.</translation>
    </message>
    <message>
        <source>Two presets are called “%1”; rename one of them.</source>
        <translation>Zwei Vorgaben heißen „%1“; benennen Sie eine davon um.</translation>
    </message>
    <message>
        <source>The preset “%1” needs a speed, and a feed or a feed per tooth.</source>
        <translation>Die Vorgabe „%1“ braucht eine Drehzahl und einen Vorschub oder Vorschub je Zahn.</translation>
    </message>
    <message>
        <source>Your own tool, in the library “%1”.</source>
        <translation>Ihr eigenes Werkzeug, in der Bibliothek „%1“.</translation>
    </message>
    <message>
        <source>Move to “%1”</source>
        <translation>Nach „%1“ verschieben</translation>
    </message>
    <message>
        <source>Copy to “%1”</source>
        <translation>Nach „%1“ kopieren</translation>
    </message>
    <message>
        <source>Copy to a new library…</source>
        <translation>In eine neue Bibliothek kopieren…</translation>
    </message>
    <message>
        <source>This library is empty: there is nothing to export.</source>
        <translation>Diese Bibliothek ist leer: Es gibt nichts zu exportieren.</translation>
    </message>
    <message numerus="yes">
        <source>%n tools were added to the library “%1”.</source>
        <translation>
            <numerusform>%n Werkzeug wurde der Bibliothek „%1“ hinzugefügt.</numerusform>
            <numerusform>%n Werkzeuge wurden der Bibliothek „%1“ hinzugefügt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>burin::ToolDrawing</name>
    <message>
        <source>Drawing of the tool, to scale</source>
        <translation>Maßstäbliche Zeichnung des Werkzeugs</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Flutes %1</source>
        <translation>Schneiden %1</translation>
    </message>
    <message>
        <source>Stick-out %1</source>
        <translation>Auskragung %1</translation>
    </message>
    <message>
        <source>Overall %1</source>
        <translation>Gesamt %1</translation>
    </message>
</context>
<context>
    <name>burin::ToolForm</name>
    <message>
        <source>as stated in the tool&apos;s source</source>
        <translation>wie in der Quelle des Werkzeugs angegeben</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name in the list of tools</source>
        <translation>Name in der Liste der Werkzeuge</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>T in programs</source>
        <translation>T in Programmen</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Source of the values that have none of their own</source>
        <translation>Quelle der Werte, die keine eigene haben</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>What the flutes sweep</source>
        <translation>Was die Schneiden überstreichen</translation>
    </message>
    <message>
        <source>Ball end</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Flat end</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Bull nose</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>Tapered</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Tapered ball</source>
        <translation>Kegel mit Kugel</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Chamfer</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Lollipop</source>
        <translation>Lollipop</translation>
    </message>
    <message>
        <source>Profile of lines and arcs</source>
        <translation>Profil aus Linien und Bögen</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Of the flutes where they are widest</source>
        <translation>Der Schneiden, wo sie am weitesten sind</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Of the rounded edge, or of the ball at the tip</source>
        <translation>Der gerundeten Kante oder der Kugel an der Spitze</translation>
    </message>
    <message>
        <source>Tip diameter</source>
        <translation>Durchmesser der Spitze</translation>
    </message>
    <message>
        <source>Of the flat at the tip, before its edge is rounded</source>
        <translation>Der Fläche an der Spitze, bevor ihre Kante gerundet wird</translation>
    </message>
    <message>
        <source>Between axis and cone: half of a point angle</source>
        <translation>Zwischen Achse und Kegel: die Hälfte eines Spitzenwinkels</translation>
    </message>
    <message>
        <source>Length of the flutes</source>
        <translation>Länge der Schneiden</translation>
    </message>
    <message>
        <source>From the tip</source>
        <translation>Von der Spitze an</translation>
    </message>
    <message>
        <source>Number of flutes</source>
        <translation>Zahl der Schneiden</translation>
    </message>
    <message>
        <source>Cuts at its centre</source>
        <translation>Schneidet in der Mitte</translation>
    </message>
    <message>
        <source>May plunge straight down</source>
        <translation>Darf senkrecht eintauchen</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>Shank diameter</source>
        <translation>Schaftdurchmesser</translation>
    </message>
    <message>
        <source>Between flutes and holder</source>
        <translation>Zwischen Schneiden und Halter</translation>
    </message>
    <message>
        <source>Stick-out</source>
        <translation>Auskragung</translation>
    </message>
    <message>
        <source>From the tip to the face of the holder</source>
        <translation>Von der Spitze bis zur Stirn des Halters</translation>
    </message>
    <message>
        <source>As entered below</source>
        <translation>Wie unten eingegeben</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>Take over the segments of a holder of the library</source>
        <translation>Die Abschnitte eines Halters aus der Bibliothek übernehmen</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>From the face upwards: diameter below, diameter above, length</source>
        <translation>Von der Stirn nach oben: Durchmesser unten, Durchmesser oben, Länge</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>Größte Zustellung</translation>
    </message>
    <message>
        <source>Along the axis; at most the length of the flutes</source>
        <translation>Längs der Achse; höchstens die Länge der Schneiden</translation>
    </message>
    <message>
        <source>Across the axis</source>
        <translation>Quer zur Achse</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Größte Drehzahl</translation>
    </message>
    <message>
        <source>Of the spindle, by the tool&apos;s maker</source>
        <translation>Der Spindel, nach dem Hersteller des Werkzeugs</translation>
    </message>
    <message>
        <source>Modulus of elasticity</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Of what shank and flutes are made of</source>
        <translation>Dessen, woraus Schaft und Schneiden sind</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Festigkeit</translation>
    </message>
    <message>
        <source>Stress at which it breaks when it is bent</source>
        <translation>Spannung, bei der es bricht, wenn es gebogen wird</translation>
    </message>
    <message>
        <source>entered by the user</source>
        <translation>vom Benutzer eingegeben</translation>
    </message>
    <message>
        <source>Angle per side</source>
        <translation>Winkel je Seite</translation>
    </message>
    <message>
        <source>Teeth that cut in one revolution</source>
        <translation>Zähne, die in einer Umdrehung schneiden</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Greatest width of cut</source>
        <translation>Größte Schnittbreite</translation>
    </message>
    <message>
        <source>Greatest chip thickness</source>
        <translation>Größte Spandicke</translation>
    </message>
    <message>
        <source>Per tooth</source>
        <translation>Je Zahn</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Of a tool that doesn&apos;t turn, about its axis: from X of the setup to X of its models, counterclockwise seen from above</source>
        <translation>Eines Werkzeugs, das sich nicht dreht, um seine Achse: von X der Aufspannung zu X seiner Modelle, von oben gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Feeds and speeds</source>
        <translation>Schnittwerte</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Feeds and speeds of your own. The first preset for the stock&apos;s material is used, without one the first for any material, without one the values that the material states</source>
        <translation>Eigene Schnittwerte. Verwendet wird die erste Vorgabe für den Werkstoff des Rohteils, ohne eine solche die erste für jeden Werkstoff, sonst die Werte des Werkstoffs</translation>
    </message>
</context>
<context>
    <name>burin::ToolLibraryBar</name>
    <message>
        <source>All tools</source>
        <translation>Alle Werkzeuge</translation>
    </message>
    <message>
        <source>Starter library</source>
        <translation>Mitgelieferte Bibliothek</translation>
    </message>
    <message>
        <source>My tools</source>
        <translation>Meine Werkzeuge</translation>
    </message>
    <message>
        <source>Tool library</source>
        <translation>Werkzeugbibliothek</translation>
    </message>
    <message>
        <source>The tool library whose tools are listed</source>
        <translation>Die Werkzeugbibliothek, deren Werkzeuge aufgelistet sind</translation>
    </message>
    <message>
        <source>New tool library</source>
        <translation>Neue Werkzeugbibliothek</translation>
    </message>
    <message>
        <source>Rename this library</source>
        <translation>Diese Bibliothek umbenennen</translation>
    </message>
    <message>
        <source>Delete this library and its tools</source>
        <translation>Diese Bibliothek und ihre Werkzeuge löschen</translation>
    </message>
    <message>
        <source>Choose a library that you have named yourself.</source>
        <translation>Wählen Sie eine Bibliothek, die Sie selbst benannt haben.</translation>
    </message>
    <message>
        <source>Rename the tool library</source>
        <translation>Werkzeugbibliothek umbenennen</translation>
    </message>
    <message>
        <source>Delete the empty library “%1”?</source>
        <translation>Die leere Bibliothek „%1“ löschen?</translation>
    </message>
    <message>
        <source>Delete the library “%1” and its tool?</source>
        <translation>Die Bibliothek „%1“ und ihr Werkzeug löschen?</translation>
    </message>
    <message numerus="yes">
        <source>Delete the library “%1” and its %n tools?</source>
        <translation>
            <numerusform>Die Bibliothek „%1“ und ihr %n Werkzeug löschen?</numerusform>
            <numerusform>Die Bibliothek „%1“ und ihre %n Werkzeuge löschen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo brings them back. Projects keep the tools that they use.</source>
        <translation>Rückgängig bringt sie zurück. Projekte behalten die Werkzeuge, die sie verwenden.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>burin::ToolPanel</name>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Choose the tool to mill with</source>
        <translation>Das Werkzeug zum Fräsen wählen</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Stick-out</source>
        <translation>Auskragung</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>Größte Zustellung</translation>
    </message>
    <message>
        <source>In this stock</source>
        <translation>In diesem Werkstoff</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Plunge feed</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>%1, %2 long</source>
        <translation>%1, %2 lang</translation>
    </message>
    <message>
        <source>Feed and speed come from values that are estimates.</source>
        <translation>Vorschub und Drehzahl beruhen auf geschätzten Kennwerten.</translation>
    </message>
    <message>
        <source>The tool can&apos;t be changed while recording.</source>
        <translation>Während der Aufzeichnung lässt sich das Werkzeug nicht wechseln.</translation>
    </message>
    <message>
        <source>The boundary for this tool is being computed…</source>
        <translation>Die Grenzfläche für dieses Werkzeug wird berechnet…</translation>
    </message>
    <message>
        <source>Source of the dimensions</source>
        <translation>Quelle der Abmessungen</translation>
    </message>
    <message>
        <source>milled</source>
        <translation>gefräst</translation>
    </message>
    <message>
        <source>1 take was milled with this tool</source>
        <translation>1 Aufnahme wurde mit diesem Werkzeug gefräst</translation>
    </message>
    <message numerus="yes">
        <source>%n takes were milled with this tool</source>
        <translation>
            <numerusform>%n Aufnahme wurde mit diesem Werkzeug gefräst</numerusform>
            <numerusform>%n Aufnahmen wurden mit diesem Werkzeug gefräst</numerusform>
        </translation>
    </message>
    <message>
        <source>By the preset “%1” of this tool.</source>
        <translation>Nach der Vorgabe „%1“ dieses Werkzeugs.</translation>
    </message>
    <message>
        <source>By the preset “%1” of this tool; the plunge feed by the material.</source>
        <translation>Nach der Vorgabe „%1“ dieses Werkzeugs; der Eintauchvorschub nach dem Werkstoff.</translation>
    </message>
    <message>
        <source>This tool doesn&apos;t turn: it cuts what its model sweeps, upright and in a fixed direction. It has no feeds, passes or programs.</source>
        <translation>Dieses Werkzeug dreht sich nicht: Es schneidet, was sein Modell überstreicht, aufrecht und in fester Richtung. Es hat keine Vorschübe, Durchgänge oder Programme.</translation>
    </message>
</context>
<context>
    <name>burin::ToolShapeDialog</name>
    <message>
        <source>Tool from models</source>
        <translation>Werkzeug aus Modellen</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>The same of the shank; without it the new tool has the shank of the other</source>
        <translation>Dasselbe für den Schaft; ohne hat das neue Werkzeug den Schaft des anderen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What the tool is called</source>
        <translation>Wie das Werkzeug heißt</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>T in programs</source>
        <translation>T in Programmen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Make the tool</source>
        <translation>Werkzeug machen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Choose a model of the flutes first.</source>
        <translation>Wählen Sie zuerst ein Modell der Schneiden.</translation>
    </message>
    <message>
        <source>Give the tool a name first.</source>
        <translation>Geben Sie dem Werkzeug zuerst einen Namen.</translation>
    </message>
    <message>
        <source>Unit of the files</source>
        <translation>Einheit der Dateien</translation>
    </message>
    <message>
        <source>An STL file states no unit</source>
        <translation>Eine STL-Datei nennt keine Einheit</translation>
    </message>
    <message>
        <source>How much wider than the model the profile of the tool may be; it is never narrower</source>
        <translation>Wie viel weiter als das Modell das Profil des Werkzeugs sein darf; es ist nie enger</translation>
    </message>
    <message>
        <source>Add the tool to your own and load it into the spindle; Undo takes it back</source>
        <translation>Das Werkzeug zu Ihren eigenen nehmen und in die Spindel einsetzen; Rückgängig nimmt es zurück</translation>
    </message>
    <message>
        <source>One or more closed bodies: STEP, IGES, BREP, or a mesh</source>
        <translation>Ein oder mehrere geschlossene Körper: STEP, IGES, BREP oder ein Netz</translation>
    </message>
    <message>
        <source>Turns with the spindle</source>
        <translation>Dreht sich mit der Spindel</translation>
    </message>
    <message>
        <source>Doesn&apos;t turn: scraper, planing blade</source>
        <translation>Dreht sich nicht: Schaber, Hobelmesser</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>About the axis: from X of the setup to X of the models, counterclockwise seen from above</source>
        <translation>Um die Achse: von X der Aufspannung zu X der Modelle, von oben gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>A tool that turns cuts what its flutes sweep with the spindle; one that doesn&apos;t turn cuts what its models sweep. Models have their axis along +Z, through the origin, towards the holder; their lowest point becomes the tip. Teeth, limits and holder are those of “%1”.</source>
        <translation>Ein drehendes Werkzeug schneidet, was seine Schneiden mit der Spindel überstreichen; eines, das nicht dreht, was seine Modelle überstreichen. Die Achse der Modelle liegt längs +Z, durch den Ursprung, zum Halter hin; ihr tiefster Punkt wird die Spitze. Zähne, Grenzen und Halter sind die von „%1“.</translation>
    </message>
    <message>
        <source>A tool that doesn&apos;t turn cuts what its models sweep; their profile only keeps them out of the part</source>
        <translation>Ein Werkzeug, das sich nicht dreht, schneidet, was seine Modelle überstreichen; ihr Profil hält sie nur vom Teil ab</translation>
    </message>
</context>
<context>
    <name>burin::TorqueTable</name>
    <message>
        <source>Torque at that speed</source>
        <translation>Drehmoment bei dieser Drehzahl</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Speed of point %1</source>
        <translation>Drehzahl von Punkt %1</translation>
    </message>
    <message>
        <source>Torque of point %1</source>
        <translation>Drehmoment von Punkt %1</translation>
    </message>
    <message>
        <source>Delete point %1</source>
        <translation>Punkt %1 löschen</translation>
    </message>
    <message>
        <source>There is a point at %1 already. The value stays.</source>
        <translation>Bei %1 gibt es schon einen Punkt. Der Wert bleibt.</translation>
    </message>
    <message>
        <source>There is a point at %1 already; change that one.</source>
        <translation>Bei %1 gibt es schon einen Punkt; ändern Sie diesen.</translation>
    </message>
    <message>
        <source>Enter a speed and a torque above 0.</source>
        <translation>Geben Sie eine Drehzahl und ein Drehmoment über 0 ein.</translation>
    </message>
    <message>
        <source>Speed of a new point</source>
        <translation>Drehzahl eines neuen Punkts</translation>
    </message>
    <message>
        <source>Add this point to the curve (Enter in the torque field)</source>
        <translation>Diesen Punkt zur Kurve hinzufügen (Eingabetaste im Feld des Drehmoments)</translation>
    </message>
</context>
<context>
    <name>burin::TreePresenter</name>
    <message>
        <source>Setups</source>
        <translation>Aufspannungen</translation>
    </message>
    <message>
        <source>Double click: work in this setup.</source>
        <translation>Doppelklick: in dieser Aufspannung arbeiten.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Fixtures and keep-out volumes</source>
        <translation>Vorrichtungen und Sperrräume</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>Vorrichtung</translation>
    </message>
    <message>
        <source>keep-out</source>
        <translation>Sperrraum</translation>
    </message>
    <message>
        <source>Tick: the tool keeps clear of it.</source>
        <translation>Häkchen: Das Werkzeug hält Abstand davon.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Double click: load this tool.</source>
        <translation>Doppelklick: dieses Werkzeug einsetzen.</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 Schritt</translation>
    </message>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>Double click: load its tool and edit it.</source>
        <translation>Doppelklick: ihr Werkzeug einsetzen und sie bearbeiten.</translation>
    </message>
    <message>
        <source>Right click: order and delete passes.</source>
        <translation>Rechtsklick: Durchgänge ordnen und löschen.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>overridden</source>
        <translation>trotz Befund freigegeben</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>Double click: show its text and findings.</source>
        <translation>Doppelklick: Text und Befunde zeigen.</translation>
    </message>
    <message>
        <source>&amp;Work in it</source>
        <translation>&amp;Darin arbeiten</translation>
    </message>
    <message>
        <source>Switch to this setup.</source>
        <translation>Zu dieser Aufspannung wechseln.</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>Rename the setup.</source>
        <translation>Die Aufspannung umbenennen.</translation>
    </message>
    <message>
        <source>Rename the setup</source>
        <translation>Aufspannung umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the setup, if nothing was recorded in it.</source>
        <translation>Die Aufspannung löschen, wenn in ihr nichts aufgenommen wurde.</translation>
    </message>
    <message>
        <source>Delete it from the setup.</source>
        <translation>Aus der Aufspannung löschen.</translation>
    </message>
    <message>
        <source>Mill it &amp;earlier</source>
        <translation>&amp;Früher fräsen</translation>
    </message>
    <message>
        <source>Mill this pass before the one above.</source>
        <translation>Diesen Durchgang vor dem darüber fräsen.</translation>
    </message>
    <message>
        <source>Delete this pass.</source>
        <translation>Diesen Durchgang löschen.</translation>
    </message>
    <message>
        <source>Drag: move it. Right click: switch it off and on, move, duplicate, rename or delete it.</source>
        <translation>Ziehen: verschieben. Rechtsklick: aus- und einschalten, verschieben, duplizieren, umbenennen oder löschen.</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>Ä&amp;ndern…</translation>
    </message>
    <message>
        <source>Change its sizes and its position.</source>
        <translation>Ihre Maße und ihre Lage ändern.</translation>
    </message>
    <message>
        <source>Rename it.</source>
        <translation>Umbenennen.</translation>
    </message>
    <message>
        <source>Rename the fixture</source>
        <translation>Vorrichtung umbenennen</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>Move it in the view, with the mouse or the keys.</source>
        <translation>Verschiebt sie in der Ansicht, mit der Maus oder den Tasten.</translation>
    </message>
</context>
<context>
    <name>burin::ValueForm</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1, or 0: not stated</source>
        <translation>%1, oder 0: nicht angegeben</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Where this value comes from, e.g. the nameplate or a measurement</source>
        <translation>Woher dieser Wert stammt, z. B. vom Typenschild oder einer Messung</translation>
    </message>
    <message>
        <source>entered by the user</source>
        <translation>vom Benutzer eingegeben</translation>
    </message>
</context>
<context>
    <name>burin::ViewBar</name>
    <message>
        <source>Transparency</source>
        <translation>Transparenz</translation>
    </message>
    <message>
        <source>Transparency of the workpiece.</source>
        <translation>Transparenz des Werkstücks.</translation>
    </message>
    <message>
        <source>Normal of the section plane</source>
        <translation>Normale der Schnittebene</translation>
    </message>
    <message>
        <source>Axis perpendicular to the section plane.</source>
        <translation>Die Achse, zu der die Schnittebene senkrecht steht.</translation>
    </message>
    <message>
        <source>Moves the section plane along its normal.</source>
        <translation>Verschiebt die Schnittebene entlang ihrer Normalen.</translation>
    </message>
    <message>
        <source>Position of the section plane</source>
        <translation>Position der Schnittebene</translation>
    </message>
    <message>
        <source>Position of the section plane along its normal.</source>
        <translation>Position der Schnittebene entlang ihrer Normalen.</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Colours of the path</source>
        <translation>Farben der Bahn</translation>
    </message>
    <message>
        <source>What the colours of the path show.</source>
        <translation>Was die Farben der Bahn zeigen.</translation>
    </message>
</context>
<context>
    <name>burin::ViewDevice</name>
    <message>
        <source>Connecting the device that moves the view</source>
        <translation>Das Gerät, das die Ansicht bewegt, wird verbunden</translation>
    </message>
</context>
<context>
    <name>burin::ViewDock</name>
    <message>
        <source>Make it a window of its own, or put it back next to the view</source>
        <translation>Zu einem eigenen Fenster machen oder wieder neben die Ansicht setzen</translation>
    </message>
</context>
<context>
    <name>burin::Viewport</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 in</source>
        <translation>%1 in</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.2 or later; this computer offers none. A driver of the graphics card may be missing.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.2 oder neuer; dieser Rechner bietet keines. Vielleicht fehlt ein Treiber der Grafikkarte.</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.2 or later; this computer offers %1.%2. A newer driver of the graphics card may help.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.2 oder neuer; dieser Rechner bietet %1.%2. Vielleicht hilft ein neuerer Treiber der Grafikkarte.</translation>
    </message>
    <message>
        <source>Part at %1</source>
        <translation>Teil bei %1</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>%1 tief</translation>
    </message>
    <message>
        <source>Excess stock, %1</source>
        <translation>Restmaterial, %1</translation>
    </message>
</context>
<context>
    <name>burin::WelcomePage</name>
    <message>
        <source>Burin</source>
        <translation>Burin</translation>
    </message>
    <message>
        <source>Mill the part by hand; the machine repeats what your hand did.</source>
        <translation>Fräsen Sie das Teil von Hand; die Maschine wiederholt, was Ihre Hand tat.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Open a part…</source>
        <translation>Teil öffnen…</translation>
    </message>
    <message>
        <source>Try the sample part</source>
        <translation>Mit dem Beispielteil probieren</translation>
    </message>
    <message>
        <source>Import the part that Burin is shipped with.</source>
        <translation>Importiert das Teil, das Burin mitbringt.</translation>
    </message>
    <message>
        <source>A computer mouse, 110 mm long, ready to be milled.</source>
        <translation>Eine Computermaus, 110 mm lang, bereit zum Fräsen.</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Vorführen</translation>
    </message>
    <message>
        <source>Watch a virtual operator mill the sample part.</source>
        <translation>Ein virtueller Bediener fräst das Beispielteil.</translation>
    </message>
    <message>
        <source>A virtual operator mills the sample part before your eyes, eight times as fast as a hand.</source>
        <translation>Ein virtueller Bediener fräst das Beispielteil vor Ihren Augen, achtmal so schnell wie eine Hand.</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>Open a .burin file.</source>
        <translation>Öffnet eine .burin-Datei.</translation>
    </message>
    <message>
        <source>Go on with a project that was saved.</source>
        <translation>Mit einem gespeicherten Projekt weiterarbeiten.</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Burin ended before this work was saved. Nothing of it is lost.</source>
        <translation>Burin endete, bevor diese Arbeit gespeichert war. Nichts davon ist verloren.</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Zuletzt verwendete Projekte</translation>
    </message>
    <message>
        <source>Projects that you save are listed here.</source>
        <translation>Gespeicherte Projekte stehen hier.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Go on with this work.</source>
        <translation>Mit dieser Arbeit weitermachen.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete this work for good.</source>
        <translation>Löscht diese Arbeit endgültig.</translation>
    </message>
    <message>
        <source>The sample part, milled.</source>
        <translation>Das Beispielteil, gefräst.</translation>
    </message>
    <message>
        <source>Return to the project (Esc)</source>
        <translation>Zurück zum Projekt (Esc)</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Zurück zu %1</translation>
    </message>
    <message>
        <source>Read a part from a CAD file (STEP, IGES, BREP) or a mesh (STL, 3MF, OBJ, PLY, AMF, OFF).</source>
        <translation>Liest ein Teil aus einer CAD-Datei (STEP, IGES, BREP) oder einem Netz (STL, 3MF, OBJ, PLY, AMF, OFF).</translation>
    </message>
    <message>
        <source>STEP, IGES, BREP, or a mesh (STL, 3MF, OBJ …). Dropping a file on the window does the same.</source>
        <translation>STEP, IGES, BREP oder ein Netz (STL, 3MF, OBJ …). Eine Datei auf das Fenster zu ziehen bewirkt dasselbe.</translation>
    </message>
    <message>
        <source>First job</source>
        <translation>Erster Auftrag</translation>
    </message>
    <message>
        <source>Start a guide through a complete job, step by step.</source>
        <translation>Schritt für Schritt durch einen ganzen Auftrag geführt werden.</translation>
    </message>
    <message>
        <source>From the sample part to a checked program: Burin shows what to press next.</source>
        <translation>Vom Beispielteil zum geprüften Programm: Burin zeigt, was als Nächstes zu drücken ist.</translation>
    </message>
</context>
<context>
    <name>burin::Workbench</name>
    <message>
        <source>unit of the part</source>
        <translation>Einheit des Teils</translation>
    </message>
    <message>
        <source>updated part</source>
        <translation>aktualisiertes Teil</translation>
    </message>
    <message>
        <source>import of a part</source>
        <translation>Import eines Teils</translation>
    </message>
</context>
<context>
    <name>burin::WorkpieceController</name>
    <message>
        <source>Embedding the part</source>
        <translation>Teil wird eingebettet</translation>
    </message>
    <message>
        <source>Computing the boundary for %1</source>
        <translation>Grenzfläche für %1 wird berechnet</translation>
    </message>
    <message>
        <source>Computing the boundary around the tool</source>
        <translation>Grenzfläche rund um das Werkzeug wird berechnet</translation>
    </message>
    <message>
        <source>Exporting the workpiece</source>
        <translation>Werkstück wird exportiert</translation>
    </message>
    <message>
        <source>Milling the takes again</source>
        <translation>Aufnahmen werden neu gefräst</translation>
    </message>
    <message>
        <source>Computing the surface of the stock</source>
        <translation>Die Oberfläche des Rohteils wird berechnet</translation>
    </message>
</context>
<context>
    <name>burin::WorkpieceKeeper</name>
    <message>
        <source>Storing the workpiece</source>
        <translation>Werkstück wird abgelegt</translation>
    </message>
</context>
<context>
    <name>burin::WorkpiecePicker</name>
    <message>
        <source>Esc: end measuring</source>
        <translation>Esc: Messen beenden</translation>
    </message>
</context>
<context>
    <name>burin::ZeroLabels</name>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>at stated coordinates</source>
        <translation>an angegebenen Koordinaten</translation>
    </message>
    <message>
        <source>on the stock: X %1, Y %2, Z %3</source>
        <translation>am Rohteil: X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>on the part: X %1, Y %2, Z %3</source>
        <translation>am Teil: X %1, Y %2, Z %3</translation>
    </message>
</context>
<context>
    <name>burin::ZeroPanel</name>
    <message>
        <source>Program zero</source>
        <translation>Nullpunkt des Programms</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>The control stores program zero in this work offset; the program calls it</source>
        <translation>Die Steuerung speichert den Nullpunkt in dieser Nullpunktverschiebung; das Programm ruft sie auf</translation>
    </message>
    <message>
        <source>stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <source>Zero on</source>
        <translation>Null am</translation>
    </message>
    <message>
        <source>Program zero in the frame of the setup</source>
        <translation>Nullpunkt im Koordinatensystem der Aufspannung</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>In der Ansicht anklicken</translation>
    </message>
    <message>
        <source>Click a vertex, the middle of an edge or a circle of the part, or a corner of the stock: program zero is placed there</source>
        <translation>Klicken Sie auf einen Eckpunkt, eine Kantenmitte oder einen Kreis des Teils oder auf eine Ecke des Rohteils: dort liegt dann der Nullpunkt</translation>
    </message>
    <message>
        <source>Click a vertex, an edge or a circle of the part, or a corner of the stock.</source>
        <translation>Klicken Sie auf einen Eckpunkt, eine Kante oder einen Kreis des Teils oder auf eine Ecke des Rohteils.</translation>
    </message>
    <message>
        <source>A point of the bounding box of the stock or the part, or coordinates</source>
        <translation>Ein Punkt des umschließenden Quaders von Rohteil oder Teil, oder Koordinaten</translation>
    </message>
    <message>
        <source>Position on the bounding box along %1</source>
        <translation>Lage am umschließenden Quader auf %1</translation>
    </message>
</context>
<context>
    <name>burin::ZeroPicker</name>
    <message>
        <source>Esc: cancel picking program zero</source>
        <translation>Esc: Anklicken des Nullpunkts abbrechen</translation>
    </message>
</context>
<context>
    <name>burin::ZeroPresenter</name>
    <message>
        <source>The tool does not touch the part. Hold it against a face of the part.</source>
        <translation>Das Werkzeug berührt das Teil nicht. Halten Sie es an eine Fläche des Teils.</translation>
    </message>
    <message>
        <source>Touching off needs a vertical tool and a face that is parallel to two axes.</source>
        <translation>Antasten braucht ein senkrechtes Werkzeug und eine Fläche, die zu zwei Achsen parallel ist.</translation>
    </message>
    <message>
        <source>The tool touches nothing. Hold it against a face of the part, or of the stock after “Stop the tool at the stock”.</source>
        <translation>Das Werkzeug berührt nichts. Halten Sie es an eine Fläche des Teils oder, nach „Werkzeug am Rohteil aufhalten“, des Rohteils.</translation>
    </message>
    <message>
        <source>The tool doesn&apos;t touch a side of the stock squarely. Hold it against a side that is parallel to two axes, and against nothing else.</source>
        <translation>Das Werkzeug berührt keine Seite des Rohteils senkrecht. Halten Sie es gegen eine Seite, die zu zwei Achsen parallel ist, und gegen nichts anderes.</translation>
    </message>
    <message>
        <source>Zero along %1 is set to the touched side, which is known to within %2.</source>
        <translation>Der Nullpunkt entlang %1 liegt auf der angetasteten Seite, die auf %2 genau bekannt ist.</translation>
    </message>
</context>
</TS>
