<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>pointclay</name>
    <message>
        <source> (%1 to %2)</source>
        <translation> (%1 bis %2)</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>%1
%2 × %3</source>
        <translation>%1
%2 × %3</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>%1  hidden</source>
        <translation>%1  ausgeblendet</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2 %</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 + %2</source>
        <translation>%1 + %2</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 did not come to its end</source>
        <translation>%1 kam nicht bis zum Ende</translation>
    </message>
    <message>
        <source>%1 is neither a model nor an image</source>
        <translation>%1 ist weder ein Modell noch ein Bild</translation>
    </message>
    <message>
        <source>%1 is neither a model nor an image; File &gt; Open says what can be read.</source>
        <translation>%1 ist weder ein Modell noch ein Bild; Datei &gt; Öffnen sagt, was gelesen werden kann.</translation>
    </message>
    <message>
        <source>%1 is shown; the menu has the others.</source>
        <translation>%1 ist zu sehen; die übrigen stehen im Menü.</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>%1 late ticks</source>
        <translation>%1 verspätete Takte</translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation>%1 Meldungen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2: done</source>
        <translation>%1 von %2: getan</translation>
    </message>
    <message>
        <source>%1 points; double click to rename</source>
        <translation>%1 Punkte; Doppelklick zum Umbenennen</translation>
    </message>
    <message>
        <source>%1 results copied, a line each.</source>
        <translation>%1 Ergebnisse kopiert, je eine Zeile.</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>%1 surfels</source>
        <translation>%1 Surfels</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>%1 vertices, made in %2 s. Boundary loops: orange where the surface ends at its limit, red at folds, where it is undefined</source>
        <translation>%1 Ecken, berechnet in %2 s. Randschleifen: orange, wo die Fläche an ihrer Grenze endet, rot an Falten, wo sie nicht bestimmt ist</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 – Esc stops it</source>
        <translation>%1 – Esc bricht ab</translation>
    </message>
    <message>
        <source>%1, no priority</source>
        <translation>%1, ohne Vorrang</translation>
    </message>
    <message>
        <source>%1. Save often: a crash would lose what is not saved.</source>
        <translation>%1. Oft speichern: Ein Absturz würde kosten, was nicht gespeichert ist.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2. %3.</source>
        <translation>%1: %2. %3.</translation>
    </message>
    <message>
        <source>%1[*] – Pointclay</source>
        <translation>%1[*] – Pointclay</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>%1…[*] – Pointclay</source>
        <translation>%1…[*] – Pointclay</translation>
    </message>
    <message>
        <source>&amp;About Pointclay…</source>
        <translation>Über Pointclay…</translation>
    </message>
    <message>
        <source>&amp;Add Model…</source>
        <translation>Modell hinzufügen…</translation>
    </message>
    <message>
        <source>&amp;Around the Model</source>
        <translation>Rund um das Modell</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>&amp;Blur</source>
        <translation>Weichzeichnen</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>Aufheben</translation>
    </message>
    <message>
        <source>&amp;Clipping</source>
        <translation>Schnittebenen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>&amp;Export Image…</source>
        <translation>Bild exportieren…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Find an Action…</source>
        <translation>Aktion suchen…</translation>
    </message>
    <message>
        <source>&amp;Fly</source>
        <translation>Fliegen</translation>
    </message>
    <message>
        <source>&amp;Further</source>
        <translation>Weiteres</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>Erweitern</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>S&amp;päter</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>&amp;Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>Navigation</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Keine Taste</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>Orthografisch</translation>
    </message>
    <message>
        <source>&amp;Pie of These</source>
        <translation>Als Tortenmenü</translation>
    </message>
    <message>
        <source>&amp;Pivot Under the Pointer</source>
        <translation>Drehpunkt unter den Zeiger</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Reset all</source>
        <translation>Alle &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Run Session…</source>
        <translation>Sitzung ausführen…</translation>
    </message>
    <message>
        <source>&amp;Sampling</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>&amp;Save View…</source>
        <translation>Ansicht speichern…</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Aus&amp;wählen</translation>
    </message>
    <message>
        <source>&amp;Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>&amp;Sharpen</source>
        <translation>Schärfen</translation>
    </message>
    <message>
        <source>&amp;Shortcuts…</source>
        <translation>Tastenkürzel…</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>&amp;Trim</source>
        <translation>Zuschneiden</translation>
    </message>
    <message>
        <source>&amp;True Surface</source>
        <translation>Wahre Oberfläche</translation>
    </message>
    <message>
        <source>&amp;Turn the Up Axis</source>
        <translation>Hochachse weiterdrehen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>(automatic)</source>
        <translation>(automatisch)</translation>
    </message>
    <message>
        <source>(left out)</source>
        <translation>(ausgelassen)</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(keine)</translation>
    </message>
    <message>
        <source>+</source>
        <translation>+</translation>
    </message>
    <message>
        <source>, %1 at folds</source>
        <translation>, %1 an Falten</translation>
    </message>
    <message>
        <source>, %1 boundary loops</source>
        <translation>, %1 Randschleifen</translation>
    </message>
    <message>
        <source>, 1 boundary loop</source>
        <translation>, 1 Randschleife</translation>
    </message>
    <message>
        <source>, light %1 %</source>
        <translation>, Licht %1 %</translation>
    </message>
    <message>
        <source>1 / model units</source>
        <translation>1 / Modelleinheiten</translation>
    </message>
    <message>
        <source>1 doubles what stands out of the smooth surface</source>
        <translation>1 verdoppelt, was aus der glatten Fläche hervorsteht</translation>
    </message>
    <message>
        <source>1 px: normals within 2° and depths within a fifth of the spacing; 0.5 px: half of that. Coarser is faster.</source>
        <translation>1 px: Normalen auf 2° und Tiefen auf ein Fünftel des Punktabstands genau; 0.5 px: auf die Hälfte davon. Gröber ist schneller.</translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 Schritt</translation>
    </message>
    <message>
        <source>16 numbers by row, a rigid motion from the file's coordinates to the scene's; duplicate: of the scene's</source>
        <translation>16 Zahlen zeilenweise, eine starre Bewegung von den Koordinaten der Datei zu denen der Szene; duplicate: der Szene</translation>
    </message>
    <message>
        <source>16 numbers by row, an affine map of the file's coordinates</source>
        <translation>16 Zahlen zeilenweise, eine affine Abbildung der Koordinaten der Datei</translation>
    </message>
    <message>
        <source>1: this colour, less: on the way to it</source>
        <translation>1: diese Farbe, weniger: auf dem Weg zu ihr</translation>
    </message>
    <message>
        <source>3D Manufacturing Format</source>
        <translation>3D Manufacturing Format</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>3D-Maus</translation>
    </message>
    <message>
        <source>3D mouse: view</source>
        <translation>3D-Maus: Ansicht</translation>
    </message>
    <message>
        <source>; Esc goes back to sculpting; beside the model nothing is picked.</source>
        <translation>; Esc führt zurück zum Modellieren; neben dem Modell wird nichts gewählt.</translation>
    </message>
    <message>
        <source>; beside the model or with the right button: turn the view; middle button: pan; wheel: zoom.</source>
        <translation>; neben dem Modell oder mit der rechten Taste: Ansicht drehen; mittlere Taste: verschieben; Rad: zoomen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pointclay %1&lt;/b&gt;&lt;br&gt;Sculpts and edits point-set surfaces.</source>
        <translation>&lt;b&gt;Pointclay %1&lt;/b&gt;&lt;br&gt;Modelliert und bearbeitet Flächen aus Punkten.</translation>
    </message>
    <message>
        <source>A ball in the middle of the picture follows the pointer; outside the ball, the view rolls</source>
        <translation>Eine Kugel in der Bildmitte folgt dem Zeiger; außerhalb der Kugel rollt die Ansicht</translation>
    </message>
    <message>
        <source>A ball of clay, evenly sampled</source>
        <translation>Eine Kugel aus Ton, gleichmäßig abgetastet</translation>
    </message>
    <message>
        <source>A block with rounded edges, to start sculpting from</source>
        <translation>Ein Block mit runden Kanten, um daraus zu modellieren</translation>
    </message>
    <message>
        <source>A command: resample spacing=0.01, or a line of JSON</source>
        <translation>Ein Befehl: resample spacing=0.01, oder eine Zeile JSON</translation>
    </message>
    <message>
        <source>A complex: Sierpinski's triangle, patches that meet in corners only</source>
        <translation>Ein Komplex: Sierpinskis Dreieck, dessen Stücke sich nur in Ecken treffen</translation>
    </message>
    <message>
        <source>A complex: an eighth of a ball, sharp where its faces meet</source>
        <translation>Ein Komplex: ein Achtel einer Kugel, scharf, wo ihre Flächen sich treffen</translation>
    </message>
    <message>
        <source>A complex: eight triangles about an apex, smooth from one to the next</source>
        <translation>Ein Komplex: acht Dreiecke um eine Spitze, glatt vom einen zum nächsten</translation>
    </message>
    <message>
        <source>A complex: one open patch between four edges</source>
        <translation>Ein Komplex: ein offenes Flächenstück zwischen vier Kanten</translation>
    </message>
    <message>
        <source>A complex: round faces between straight, sharp edges</source>
        <translation>Ein Komplex: runde Flächen zwischen geraden, scharfen Kanten</translation>
    </message>
    <message>
        <source>A complex: twenty faces of a ball that share planes along their edges</source>
        <translation>Ein Komplex: zwanzig Flächen einer Kugel, die entlang ihrer Kanten gemeinsame Ebenen haben</translation>
    </message>
    <message>
        <source>A complex: twenty flat faces, sharp edges and corners</source>
        <translation>Ein Komplex: zwanzig ebene Flächen, scharfe Kanten und Ecken</translation>
    </message>
    <message>
        <source>A copy of the active model in the same place</source>
        <translation>Eine Kopie des aktiven Modells am selben Ort</translation>
    </message>
    <message>
        <source>A curve in space with a radius per point: a wound wire</source>
        <translation>Eine Raumkurve mit einem Radius je Punkt: ein gewickelter Draht</translation>
    </message>
    <message>
        <source>A dab at every sample of the pointer: the faster it moves, the farther apart.</source>
        <translation>Ein Tupfer je Abtastung des Zeigers: je schneller er sich bewegt, desto weiter auseinander.</translation>
    </message>
    <message>
        <source>A ground below the model receives both</source>
        <translation>Ein Boden unter dem Modell empfängt beides</translation>
    </message>
    <message>
        <source>A harder border</source>
        <translation>Ein härterer Rand</translation>
    </message>
    <message>
        <source>A large soft lamp from the upper left, a weak fill light, a rim light</source>
        <translation>Eine große weiche Lampe von links oben, ein schwaches Fülllicht, ein Randlicht</translation>
    </message>
    <message>
        <source>A length in model units, true at the depth that the view turns about</source>
        <translation>Eine Länge in Modelleinheiten, wahr in der Tiefe, um die sich die Ansicht dreht</translation>
    </message>
    <message>
        <source>A mirror of warm metal: reflects the lamps, the room and the model itself</source>
        <translation>Ein Spiegel aus warmem Metall: zeigt die Lampen, den Raum und das Modell selbst</translation>
    </message>
    <message>
        <source>A model to open, samples, what was open lately</source>
        <translation>Ein Modell zum Öffnen, Beispiele, zuletzt Geöffnetes</translation>
    </message>
    <message>
        <source>A new layer on top of all others; strokes then act on it</source>
        <translation>Eine neue Ebene über allen anderen; Striche wirken dann auf sie</translation>
    </message>
    <message>
        <source>A number that the surfels carry by name: intensity, classification, thickness, ...</source>
        <translation>Eine Zahl, die die Surfels unter einem Namen tragen: Intensität, Klassifizierung, Dicke, ...</translation>
    </message>
    <message>
        <source>A ring</source>
        <translation>Ein Ring</translation>
    </message>
    <message>
        <source>A sample</source>
        <translation>Ein Beispiel</translation>
    </message>
    <message>
        <source>A second device, at spacenavd, moves the view meanwhile</source>
        <translation>Ein zweites Gerät, an spacenavd, bewegt unterdessen die Ansicht</translation>
    </message>
    <message>
        <source>A softer border</source>
        <translation>Ein weicherer Rand</translation>
    </message>
    <message>
        <source>A strip with half a turn: one side, one rim</source>
        <translation>Ein Band mit einer halben Drehung: eine Seite, ein Rand</translation>
    </message>
    <message>
        <source>A tap, and an anchored stamp, are as strong as a stroke that goes over the place; the window asks for it.</source>
        <translation>Ein Antippen und ein verankerter Stempel sind so stark wie ein Strich über die Stelle; das Fenster verlangt es.</translation>
    </message>
    <message>
        <source>A trefoil knot</source>
        <translation>Ein Kleeblattknoten</translation>
    </message>
    <message>
        <source>ASPRS LAS</source>
        <translation>ASPRS LAS</translation>
    </message>
    <message>
        <source>ASTM E57</source>
        <translation>ASTM E57</translation>
    </message>
    <message>
        <source>About %1 points; now there are %2.</source>
        <translation>Etwa %1 Punkte; jetzt sind es %2.</translation>
    </message>
    <message>
        <source>About Pointclay</source>
        <translation>Über Pointclay</translation>
    </message>
    <message>
        <source>Above the layer that is above it now</source>
        <translation>Über die Ebene, die jetzt darüber liegt</translation>
    </message>
    <message>
        <source>Accumulate</source>
        <translation>Anhäufen</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add Model</source>
        <translation>Modell hinzufügen</translation>
    </message>
    <message>
        <source>Add a shape</source>
        <translation>Grundkörper hinzufügen</translation>
    </message>
    <message>
        <source>Add a tube</source>
        <translation>Rohr hinzufügen</translation>
    </message>
    <message>
        <source>Add the other model's points</source>
        <translation>Punkte des anderen Modells dazunehmen</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen…</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>All is free</source>
        <translation>Alles ist frei</translation>
    </message>
    <message>
        <source>All models of the scene: which is active, shown, locked</source>
        <translation>Alle Modelle der Szene: welches aktiv, sichtbar, gesperrt ist</translation>
    </message>
    <message>
        <source>All models that are shown and not locked go into the active one</source>
        <translation>Alle sichtbaren, nicht gesperrten Modelle gehen im aktiven auf</translation>
    </message>
    <message>
        <source>All of these around the pointer: move towards one, and click or let the key go</source>
        <translation>All dies rund um den Zeiger: in eine Richtung fahren und klicken oder die Taste loslassen</translation>
    </message>
    <message>
        <source>All other models of the scene</source>
        <translation>Alle anderen Modelle der Szene</translation>
    </message>
    <message>
        <source>All results to the clipboard, a line each</source>
        <translation>Alle Ergebnisse in die Zwischenablage, je eine Zeile</translation>
    </message>
    <message>
        <source>All steps by name: click one to go there</source>
        <translation>Alle Schritte mit Namen: ein Klick geht dorthin</translation>
    </message>
    <message>
        <source>All that was told at last</source>
        <translation>Alles, was zuletzt gemeldet wurde</translation>
    </message>
    <message>
        <source>Along the Surface</source>
        <translation>Entlang der Fläche</translation>
    </message>
    <message>
        <source>Ambient Occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Another key for any action of the menus</source>
        <translation>Eine andere Taste für jede Aktion der Menüs</translation>
    </message>
    <message>
        <source>Another mesh is being written; wait for it, or stop it with Esc.</source>
        <translation>Ein anderes Netz wird gerade geschrieben; abwarten oder mit Esc abbrechen.</translation>
    </message>
    <message>
        <source>Another place</source>
        <translation>Eine andere Stelle</translation>
    </message>
    <message>
        <source>Antialiasing: draws four pixels for each</source>
        <translation>Kantenglättung: zeichnet vier Pixel für einen</translation>
    </message>
    <message>
        <source>Applied to</source>
        <translation>Angewandt auf</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>As Shaded</source>
        <translation>Wie schattiert</translation>
    </message>
    <message>
        <source>As in SculptGL</source>
        <translation>Wie in SculptGL</translation>
    </message>
    <message>
        <source>As in ZBrush</source>
        <translation>Wie in ZBrush</translation>
    </message>
    <message>
        <source>As the Desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Asks again at the next start</source>
        <translation>Fragt beim nächsten Start wieder</translation>
    </message>
    <message>
        <source>At the second of three places</source>
        <translation>An der zweiten von drei Stellen</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Attribut</translation>
    </message>
    <message>
        <source>Attribute S&amp;hown</source>
        <translation>Gezeigtes Attribut</translation>
    </message>
    <message>
        <source>Auto-smooth</source>
        <translation>Auto-Glätten</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Axes across which every dab is mirrored: "x" for the plane x = 0, "y", "z".</source>
        <translation>Achsen, über die jeder Tupfer gespiegelt wird: "x" für die Ebene x = 0, "y", "z".</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis of the model that an upright stamp takes for upwards; the window writes the model's own.</source>
        <translation>Achse des Modells, die für einen aufrechten Stempel oben ist; das Fenster schreibt die des Modells.</translation>
    </message>
    <message>
        <source>Axis through the origin that the copies are turned about.</source>
        <translation>Achse durch den Ursprung, um die die Kopien gedreht werden.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Beginnt bei</translation>
    </message>
    <message>
        <source>Below all layers</source>
        <translation>Grundfläche</translation>
    </message>
    <message>
        <source>Below the layer that is below it now</source>
        <translation>Unter die Ebene, die jetzt darunter liegt</translation>
    </message>
    <message>
        <source>Beside the last one, with the next number in its name; work goes on in it</source>
        <translation>Neben die letzte, mit der nächsten Zahl im Namen; die Arbeit geht in ihr weiter</translation>
    </message>
    <message>
        <source>Between Faces</source>
        <translation>Zwischen Flächen</translation>
    </message>
    <message>
        <source>Blend colours</source>
        <translation>Farben angleichen</translation>
    </message>
    <message>
        <source>Block of clay</source>
        <translation>Block aus Ton</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Bridge loops</source>
        <translation>Schleifen überbrücken</translation>
    </message>
    <message>
        <source>Brightness, contrast and white balance of colours.</source>
        <translation>Helligkeit, Kontrast und Weißabgleich der Farben.</translation>
    </message>
    <message>
        <source>Brings the surface back to what it was when the active layer began; inverted, away from it.</source>
        <translation>Führt die Fläche dahin zurück, wo sie am Anfang der aktiven Ebene war; umgekehrt davon weg.</translation>
    </message>
    <message>
        <source>Bronze</source>
        <translation>Bronze</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Brush radius</source>
        <translation>Pinselradius</translation>
    </message>
    <message>
        <source>Builds up towards a plane above the surface, hollows first; inverted, cuts down.</source>
        <translation>Baut bis zu einer Ebene über der Fläche auf, Vertiefungen zuerst; umgekehrt trägt er ab.</translation>
    </message>
    <message>
        <source>Bulged icosahedron</source>
        <translation>Gewölbtes Ikosaeder</translation>
    </message>
    <message>
        <source>By half the brush's radius along the surface</source>
        <translation>Um den halben Pinselradius entlang der Fläche</translation>
    </message>
    <message>
        <source>C&amp;lean Up</source>
        <translation>Bereinigen</translation>
    </message>
    <message>
        <source>Cancelled; the model is unchanged.</source>
        <translation>Abgebrochen; das Modell ist unverändert.</translation>
    </message>
    <message>
        <source>Cancelled; what was done before stays.</source>
        <translation>Abgebrochen; was vorher getan wurde, bleibt.</translation>
    </message>
    <message>
        <source>Carried</source>
        <translation>Getragener Teil</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>Change mask</source>
        <translation>Maske ändern</translation>
    </message>
    <message>
        <source>Change selection</source>
        <translation>Auswahl ändern</translation>
    </message>
    <message>
        <source>Changes how the points define their surface; options left out stay as they are.</source>
        <translation>Ändert, wie die Punkte ihre Fläche bestimmen; ausgelassene Optionen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Choose a PNG or JPEG image to press in: white has full effect, black none.</source>
        <translation>Ein Bild, PNG oder JPEG, zum Eindrücken wählen: Weiß wirkt voll, Schwarz gar nicht.</translation>
    </message>
    <message>
        <source>Choose by</source>
        <translation>Auswählen nach</translation>
    </message>
    <message>
        <source>Choose parts of the model with the pointer, for commands to work on</source>
        <translation>Teile des Modells mit dem Zeiger auswählen, auf die Befehle wirken</translation>
    </message>
    <message>
        <source>Choose what to measure, then click on the model.</source>
        <translation>Wählen, was gemessen werden soll, dann auf das Modell klicken.</translation>
    </message>
    <message>
        <source>Choose where to copy from</source>
        <translation>Wählen, woher kopiert wird</translation>
    </message>
    <message>
        <source>Chooses surfels for other commands to work on; what is selected is saved with the model.</source>
        <translation>Wählt Surfels aus, auf die andere Befehle wirken; die Auswahl wird mit dem Modell gespeichert.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Chosen one by one</source>
        <translation>Einzeln gewählt</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>Scan bereinigen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Click %1 places on the model</source>
        <translation>%1 Stellen auf dem Modell anklicken</translation>
    </message>
    <message>
        <source>Click a number</source>
        <translation>Klick auf eine Zahl</translation>
    </message>
    <message>
        <source>Click a place on the model; Esc goes back to sculpting.</source>
        <translation>Eine Stelle auf dem Modell anklicken; Esc führt zurück zum Modellieren.</translation>
    </message>
    <message>
        <source>Click an axis to look along it, again for the other side; drag to turn the view</source>
        <translation>Klick auf eine Achse: Blick entlang dieser, noch ein Klick: von der anderen Seite; Ziehen dreht die Ansicht</translation>
    </message>
    <message>
        <source>Click one place on the model</source>
        <translation>Eine Stelle auf dem Modell anklicken</translation>
    </message>
    <message>
        <source>Click places on the model, one after the other; Esc ends it.</source>
        <translation>Stellen auf dem Modell anklicken, eine nach der anderen; Esc beendet es.</translation>
    </message>
    <message>
        <source>Click the corners; Enter or a double click closes it, Backspace takes one back</source>
        <translation>Die Ecken anklicken; Eingabe oder Doppelklick schließt, Rücktaste nimmt eine zurück</translation>
    </message>
    <message>
        <source>Click three corners at least, then press Enter.</source>
        <translation>Mindestens drei Ecken anklicken, dann Eingabe drücken.</translation>
    </message>
    <message>
        <source>Click to add a point, drag to move it, right-click to remove it.</source>
        <translation>Klick fügt einen Punkt hinzu, Ziehen bewegt ihn, Rechtsklick entfernt ihn.</translation>
    </message>
    <message>
        <source>Click: all around that place up to where the surface bends sharply</source>
        <translation>Klick: alles um die Stelle bis dahin, wo die Fläche scharf abknickt</translation>
    </message>
    <message>
        <source>Click: all of about the colour there</source>
        <translation>Klick: alles von etwa der Farbe dort</translation>
    </message>
    <message>
        <source>Click: all that hangs together with that place</source>
        <translation>Klick: alles, was mit der Stelle zusammenhängt</translation>
    </message>
    <message>
        <source>Click: all whose normals are within 30 degrees of the one there</source>
        <translation>Klick: alles, dessen Normalen um weniger als 30 Grad von der dortigen abweichen</translation>
    </message>
    <message>
        <source>Click: what lies within the brush's radius</source>
        <translation>Klick: was im Pinselradius liegt</translation>
    </message>
    <message>
        <source>Clipping</source>
        <translation>Schnittebenen</translation>
    </message>
    <message>
        <source>Close folds</source>
        <translation>Falten schließen</translation>
    </message>
    <message>
        <source>Close the cut</source>
        <translation>Schnitt verschließen</translation>
    </message>
    <message>
        <source>Closes the holes of an open surface with points as dense as those around; loops that touch themselves are named and stay.</source>
        <translation>Schließt die Löcher einer offenen Fläche mit Punkten so dicht wie ringsum; Schleifen, die sich selbst berühren, werden genannt und bleiben.</translation>
    </message>
    <message>
        <source>Co&amp;mpare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Wendel</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour Legend</source>
        <translation>Farblegende</translation>
    </message>
    <message>
        <source>Colour to paint when inverted.</source>
        <translation>Farbe, die umgekehrt gemalt wird.</translation>
    </message>
    <message>
        <source>Colour to paint, as 65536 red + 256 green + blue.</source>
        <translation>Farbe, die gemalt wird, als 65536 Rot + 256 Grün + Blau.</translation>
    </message>
    <message>
        <source>Colour, Unlit</source>
        <translation>Farbe, ohne Licht</translation>
    </message>
    <message>
        <source>Colours of the surfels as they are, without any light</source>
        <translation>Farben der Surfels, wie sie sind, ohne jedes Licht</translation>
    </message>
    <message>
        <source>Colours of the surfels in plain light</source>
        <translation>Farben der Surfels in schlichtem Licht</translation>
    </message>
    <message>
        <source>Colours the surface; inverted, with the second colour.</source>
        <translation>Färbt die Fläche; umgekehrt mit der zweiten Farbe.</translation>
    </message>
    <message>
        <source>Column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>Columns of a text</source>
        <translation>Spalten eines Textes</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Spalten der Datei</translation>
    </message>
    <message>
        <source>Combine solids</source>
        <translation>Körper verknüpfen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Commands so far</source>
        <translation>Befehle bisher</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Zusammenhängend</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>Cool dark grey, lighter towards the floor</source>
        <translation>Kühles Dunkelgrau, zum Boden hin heller</translation>
    </message>
    <message>
        <source>Copies from %1. Ctrl+click for another place.</source>
        <translation>Kopiert von %1. Strg+Klick für eine andere Stelle.</translation>
    </message>
    <message>
        <source>Copies of every dab, turned evenly about an axis, in addition to its mirror images; 1: none.</source>
        <translation>Kopien jedes Tupfers, gleichmäßig um eine Achse gedreht, zusätzlich zu seinen Spiegelbildern; 1: keine.</translation>
    </message>
    <message>
        <source>Copies the relief of another place; inverted, its negative.</source>
        <translation>Kopiert das Relief einer anderen Stelle; umgekehrt dessen Negativ.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Could not add %1</source>
        <translation>%1 konnte nicht hinzugefügt werden</translation>
    </message>
    <message>
        <source>Could not make %1</source>
        <translation>%1 konnte nicht erzeugt werden</translation>
    </message>
    <message>
        <source>Could not open %1</source>
        <translation>%1 konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Could not recover the lost work</source>
        <translation>Die verlorene Arbeit konnte nicht wiederhergestellt werden</translation>
    </message>
    <message>
        <source>Could not save %1</source>
        <translation>%1 konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Could not save the session</source>
        <translation>Die Sitzung konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Could not write %1</source>
        <translation>%1 konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>Falz</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>Falze</translation>
    </message>
    <message>
        <source>Ctrl + click with Clone</source>
        <translation>Strg + Klick mit Klonen</translation>
    </message>
    <message>
        <source>Ctrl + left button, eraser of a pen</source>
        <translation>Strg + linke Taste, Radierer eines Stifts</translation>
    </message>
    <message>
        <source>Ctrl does it while held.</source>
        <translation>Strg tut es, solange es gehalten wird.</translation>
    </message>
    <message>
        <source>Ctrl+Z goes a step back, Ctrl+Shift+Z forward. Ctrl+H lists all steps, by name.</source>
        <translation>Strg+Z geht einen Schritt zurück, Strg+Umschalt+Z vor. Strg+H zeigt alle Schritte mit Namen.</translation>
    </message>
    <message>
        <source>Ctrl+click on the model: where to copy from.</source>
        <translation>Strg+Klick auf das Modell: woher kopiert wird.</translation>
    </message>
    <message>
        <source>Curvature across ridges: red along all that stands out</source>
        <translation>Krümmung quer zu Graten: rot entlang allem, was hervorsteht</translation>
    </message>
    <message>
        <source>Curvature across valleys: blue along grooves and folds</source>
        <translation>Krümmung quer zu Tälern: blau entlang Rillen und Falten</translation>
    </message>
    <message>
        <source>Curved fits</source>
        <translation>Gekrümmte Ausgleichsflächen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Cut straight through the model along an outline, and close it</source>
        <translation>Entlang eines Umrisses gerade durch das Modell schneiden und es verschließen</translation>
    </message>
    <message>
        <source>Cut the model across the current direction of view</source>
        <translation>Das Modell quer zur jetzigen Blickrichtung schneiden</translation>
    </message>
    <message>
        <source>Cut the model across x</source>
        <translation>Das Modell quer zu x schneiden</translation>
    </message>
    <message>
        <source>Cut the model across y</source>
        <translation>Das Modell quer zu y schneiden</translation>
    </message>
    <message>
        <source>Cut the model across z</source>
        <translation>Das Modell quer zu z schneiden</translation>
    </message>
    <message>
        <source>Cut the model open with planes and see the curves where they meet the surface</source>
        <translation>Das Modell mit Ebenen aufschneiden und die Kurven sehen, in denen sie die Fläche treffen</translation>
    </message>
    <message>
        <source>Cuts a groove and draws its lips together; inverted, a ridge.</source>
        <translation>Schneidet eine Rille und zieht ihre Lippen zusammen; umgekehrt einen Grat.</translation>
    </message>
    <message>
        <source>Cuts a groove with a sharp bottom; inverted, raises a sharp ridge.</source>
        <translation>Schneidet eine Rille mit scharfem Grund; umgekehrt einen scharfen Grat.</translation>
    </message>
    <message>
        <source>Cuts the model by a plane and keeps one side.</source>
        <translation>Schneidet das Modell mit einer Ebene und behält eine Seite.</translation>
    </message>
    <message>
        <source>Dab %1</source>
        <translation>Tupfer %1</translation>
    </message>
    <message>
        <source>Dabs along the straight line from press to release.</source>
        <translation>Tupfer entlang der Geraden vom Drücken bis zum Loslassen.</translation>
    </message>
    <message>
        <source>Dabs build on each other; off: they work on the surface as the stroke found it, and do not pile up.</source>
        <translation>Tupfer bauen aufeinander auf; aus: Sie wirken auf die Fläche, die der Strich vorfand, und häufen sich nicht.</translation>
    </message>
    <message>
        <source>Dabs evenly along the surface.</source>
        <translation>Tupfer gleichmäßig entlang der Fläche.</translation>
    </message>
    <message>
        <source>Dabs evenly in time, also while the pointer rests.</source>
        <translation>Tupfer gleichmäßig in der Zeit, auch während der Zeiger ruht.</translation>
    </message>
    <message>
        <source>Dabs per second of the method airbrush, also while the pointer rests.</source>
        <translation>Tupfer pro Sekunde mit der Methode Airbrush, auch während der Zeiger ruht.</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Dark on light, for bright rooms</source>
        <translation>Dunkel auf Hell, für helle Räume</translation>
    </message>
    <message>
        <source>Dark or light as the desktop was when the program started</source>
        <translation>Dunkel oder hell, wie der Desktop beim Start des Programms war</translation>
    </message>
    <message>
        <source>Darkens grooves and what lies behind an edge</source>
        <translation>Dunkelt Rillen ab und was hinter einer Kante liegt</translation>
    </message>
    <message>
        <source>Darkens where nearby surface blocks the ambient light</source>
        <translation>Dunkelt ab, wo nahe Flächen das Umgebungslicht verdecken</translation>
    </message>
    <message>
        <source>Delaunay</source>
        <translation>Delaunay</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Deletes surfels under the brush.</source>
        <translation>Löscht Surfels unter dem Pinsel.</translation>
    </message>
    <message>
        <source>Deletes what is left; it cannot come back</source>
        <translation>Löscht, was übrig ist; es kommt nicht wieder</translation>
    </message>
    <message>
        <source>Denoise</source>
        <translation>Entrauschen</translation>
    </message>
    <message>
        <source>Deutsch</source>
        <translation>Deutsch</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Direction of the normals as seen from the eye</source>
        <translation>Richtung der Normalen, vom Auge aus gesehen</translation>
    </message>
    <message>
        <source>Directions of View</source>
        <translation>Blickrichtungen</translation>
    </message>
    <message>
        <source>Directions of view</source>
        <translation>Blickrichtungen im Bild</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance allowed</source>
        <translation>Erlaubter Abstand</translation>
    </message>
    <message>
        <source>Distance between dabs along the stroke.</source>
        <translation>Abstand der Tupfer entlang des Strichs.</translation>
    </message>
    <message>
        <source>Distance between neighbouring surfels</source>
        <translation>Abstand benachbarter Surfels</translation>
    </message>
    <message>
        <source>Distance from a shape</source>
        <translation>Abstand von einer Form</translation>
    </message>
    <message>
        <source>Distance from the model as it was opened or last saved: red where it was raised, blue where it was lowered</source>
        <translation>Abstand vom Modell, wie es geöffnet oder zuletzt gespeichert wurde: rot, wo es erhöht, blau, wo es vertieft wurde</translation>
    </message>
    <message>
        <source>Distances, angles and thickness between places that you click</source>
        <translation>Abstände, Winkel und Wandstärken zwischen angeklickten Stellen</translation>
    </message>
    <message>
        <source>Does the opposite: pushes in, carves.</source>
        <translation>Tut das Gegenteil: drückt ein, trägt ab.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Done to it: %1.</source>
        <translation>Daran getan: %1.</translation>
    </message>
    <message>
        <source>Double-click with these</source>
        <translation>Doppelklick mit diesen</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, the square to scale; Ctrl goes by steps.</source>
        <translation>Pfeil ziehen: verschieben, Ring: drehen, Quadrat: skalieren; Strg geht in Schritten.</translation>
    </message>
    <message>
        <source>Drag beside the model, or anywhere with the right button. The wheel zooms, the middle button pans; Home shows all of it again.</source>
        <translation>Neben dem Modell ziehen, oder überall mit der rechten Taste. Das Rad zoomt, die mittlere Taste verschiebt; Pos1 zeigt wieder alles.</translation>
    </message>
    <message>
        <source>Drag over the model. Ctrl held digs where it would raise.</source>
        <translation>Über das Modell ziehen. Mit Strg wird vertieft statt erhöht.</translation>
    </message>
    <message>
        <source>Drag to look around from where you are; F4 flies</source>
        <translation>Ziehen: sich vom Standort aus umsehen; F4 fliegt</translation>
    </message>
    <message>
        <source>Drag to turn the view about the model's upright axis; up stays up</source>
        <translation>Ziehen dreht die Ansicht um die Hochachse des Modells; oben bleibt oben</translation>
    </message>
    <message>
        <source>Drag to turn the view about the picture's own axes, across the poles</source>
        <translation>Ziehen dreht die Ansicht um die Achsen des Bildes, auch über die Pole</translation>
    </message>
    <message>
        <source>Drag: %1, with Ctrl the other way, with Shift %2</source>
        <translation>Ziehen: %1, mit Strg umgekehrt, mit Umschalt %2</translation>
    </message>
    <message>
        <source>Drag: %1; Ctrl+click: where to copy from</source>
        <translation>Ziehen: %1; Strg+Klick: woher kopiert wird</translation>
    </message>
    <message>
        <source>Drags colours in the direction of the stroke.</source>
        <translation>Zieht Farben in Richtung des Strichs.</translation>
    </message>
    <message>
        <source>Draw the curves where the planes meet the surface</source>
        <translation>Die Kurven zeichnen, in denen die Ebenen die Fläche treffen</translation>
    </message>
    <message>
        <source>Draw the mesh over the picture</source>
        <translation>Das Netz über das Bild zeichnen</translation>
    </message>
    <message>
        <source>Drawn by: %1</source>
        <translation>Gezeichnet von: %1</translation>
    </message>
    <message>
        <source>Drawn by: %1 (%2).&lt;br&gt;Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Gezeichnet von: %1 (%2).&lt;br&gt;Freie Software unter der GNU General Public License, Version 3 oder neuer.</translation>
    </message>
    <message>
        <source>Draws a part of the model out, with walls that close the step, or puts a wall along a boundary loop.</source>
        <translation>Zieht einen Teil des Modells heraus, mit Wänden, die die Stufe schließen, oder setzt eine Wand entlang einer Randschleife.</translation>
    </message>
    <message>
        <source>Draws the surface to its mean plane from both sides; inverted, deepens relief.</source>
        <translation>Zieht die Fläche von beiden Seiten zu ihrer mittleren Ebene; umgekehrt vertieft das Relief.</translation>
    </message>
    <message>
        <source>Draws the surface together under the brush; inverted, spreads it.</source>
        <translation>Zieht die Fläche unter dem Pinsel zusammen; umgekehrt auseinander.</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Drills a round hole, through the model or to a depth.</source>
        <translation>Bohrt ein rundes Loch, durch das Modell oder bis zu einer Tiefe.</translation>
    </message>
    <message>
        <source>Drop small parts</source>
        <translation>Ohne Kleinteile</translation>
    </message>
    <message>
        <source>Drop to choose a model in %1</source>
        <translation>Loslassen, um in %1 ein Modell zu wählen</translation>
    </message>
    <message>
        <source>Drop to open %1</source>
        <translation>Loslassen, um %1 zu öffnen</translation>
    </message>
    <message>
        <source>Drop to open %1 models</source>
        <translation>Loslassen, um %1 Modelle zu öffnen</translation>
    </message>
    <message>
        <source>Drop to press %1 in with the brush</source>
        <translation>Loslassen, um %1 mit dem Pinsel einzudrücken</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Edge tolerance (RIMLS)</source>
        <translation>Kantentoleranz (RIMLS)</translation>
    </message>
    <message>
        <source>Edge-preserving (RIMLS)</source>
        <translation>Kantenerhaltend (RIMLS)</translation>
    </message>
    <message>
        <source>Edges that stay sharp give way under the brush, by its strength and falloff; off: they are kept.</source>
        <translation>Kanten, die scharf bleiben, geben unter dem Pinsel nach Stärke und Abnahme nach; aus: Sie bleiben.</translation>
    </message>
    <message>
        <source>Edit &amp;Keys…</source>
        <translation>Tasten anpassen…</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Ends of open surfaces</source>
        <translation>Enden offener Flächen</translation>
    </message>
    <message>
        <source>English</source>
        <translation>English</translation>
    </message>
    <message>
        <source>English where it is neither</source>
        <translation>Englisch, wo es keine von beiden ist</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Esc does the same</source>
        <translation>Esc tut dasselbe</translation>
    </message>
    <message>
        <source>Estimate normals</source>
        <translation>Normalen schätzen</translation>
    </message>
    <message>
        <source>Evens out all that the stroke touches, to the spacing that the supports at each place are made for; off: keeps the existing sampling, and mends what the stroke stretches or squeezes.</source>
        <translation>Gleicht alles aus, was der Strich berührt, auf den Abstand, für den die Stützradien dort gemacht sind; aus: behält die Abtastung und bessert nur, was der Strich dehnt oder staucht.</translation>
    </message>
    <message>
        <source>Evens out relief under the brush and keeps the shape's size.</source>
        <translation>Gleicht Relief unter dem Pinsel aus und behält die Größe der Form.</translation>
    </message>
    <message>
        <source>Evens the spacing of the surfels and leaves the surface where it is.</source>
        <translation>Gleicht den Abstand der Surfels aus und lässt die Fläche, wo sie ist.</translation>
    </message>
    <message>
        <source>Every action as a line of a session, and a field that takes such lines</source>
        <translation>Jede Aktion als Zeile einer Sitzung, und ein Feld, das solche Zeilen annimmt</translation>
    </message>
    <message>
        <source>Every action of every menu, by a few letters of its name</source>
        <translation>Jede Aktion jedes Menüs, nach ein paar Buchstaben ihres Namens</translation>
    </message>
    <message>
        <source>Every dab is made on both sides of the plane %1 = 0.</source>
        <translation>Jeder Tupfer wirkt auf beiden Seiten der Ebene %1 = 0.</translation>
    </message>
    <message>
        <source>Every dab is made on both sides of these planes</source>
        <translation>Jeder Tupfer wirkt auf beiden Seiten dieser Ebenen</translation>
    </message>
    <message>
        <source>Executes the commands of a session file, line by line</source>
        <translation>Führt die Befehle einer Sitzungsdatei aus, Zeile für Zeile</translation>
    </message>
    <message>
        <source>Export &amp;Mesh…</source>
        <translation>Netz exportieren…</translation>
    </message>
    <message>
        <source>Export Image</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Extrude</source>
        <translation>Extrudieren</translation>
    </message>
    <message>
        <source>Eye-Dome Lighting</source>
        <translation>Augenhöhlenlicht (EDL)</translation>
    </message>
    <message>
        <source>F3 finds any action by a few letters. Shift+F1 lists the keys, F1 opens the manual. The line below says what the pointer does now.</source>
        <translation>F3 findet jede Aktion nach ein paar Buchstaben. Umschalt+F1 zeigt die Tasten, F1 das Handbuch. Die Zeile unten sagt, was der Zeiger jetzt tut.</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Gleiche Richtung</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Fade edges</source>
        <translation>Kanten abschwächen</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>Abnahme</translation>
    </message>
    <message>
        <source>Falloff curve</source>
        <translation>Abnahmekurve</translation>
    </message>
    <message>
        <source>Farther along the surface, by half the brush</source>
        <translation>Weiter entlang der Fläche, um den halben Pinsel</translation>
    </message>
    <message>
        <source>Fast; triangles follow a grid</source>
        <translation>Schnell; die Dreiecke folgen einem Gitter</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Feel the model with a haptic device, a mouse or a simulated hand, and sculpt by touch</source>
        <translation>Das Modell mit einem haptischen Gerät, einer Maus oder einer simulierten Hand ertasten und mit Gefühl modellieren</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File of the other model</source>
        <translation>Datei des anderen Modells</translation>
    </message>
    <message>
        <source>File to move onto</source>
        <translation>Datei, auf die bewegt wird</translation>
    </message>
    <message>
        <source>Files of models to move</source>
        <translation>Dateien der bewegten Modelle</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Fill small holes where thin parts leave the surface undefined</source>
        <translation>Kleine Löcher füllen, wo dünne Teile die Fläche unbestimmt lassen</translation>
    </message>
    <message>
        <source>Fills what is selected with a colour; soft selections shade into what is around.</source>
        <translation>Füllt Ausgewähltes mit einer Farbe; weiche Auswahlen gehen in das Umliegende über.</translation>
    </message>
    <message>
        <source>Find an Action</source>
        <translation>Aktion suchen</translation>
    </message>
    <message>
        <source>Find in the manual</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Find shapes</source>
        <translation>Formen finden</translation>
    </message>
    <message>
        <source>Find them in the points</source>
        <translation>In den Punkten suchen</translation>
    </message>
    <message>
        <source>Finds planes, spheres, cylinders and the like, largest first, and numbers their points in the attribute &quot;shape&quot;.</source>
        <translation>Findet Ebenen, Kugeln, Zylinder und dergleichen, die größten zuerst, und nummeriert ihre Punkte im Attribut „shape“.</translation>
    </message>
    <message>
        <source>First Ctrl+click on the model to choose where to copy from.</source>
        <translation>Zuerst mit Strg+Klick auf das Modell wählen, woher kopiert wird.</translation>
    </message>
    <message>
        <source>First steps, every tool, every command</source>
        <translation>Erste Schritte, jedes Werkzeug, jeder Befehl</translation>
    </message>
    <message>
        <source>Fit spheres rather than planes (APSS)</source>
        <translation>Kugeln statt Ebenen anpassen (APSS)</translation>
    </message>
    <message>
        <source>Flip normals</source>
        <translation>Normalen umdrehen</translation>
    </message>
    <message>
        <source>Flying at %1 units per second</source>
        <translation>Flug mit %1 Einheiten pro Sekunde</translation>
    </message>
    <message>
        <source>Flying: W A S D and Q E to move, Shift to go faster, pointer to look, wheel to set the speed, Esc to land.</source>
        <translation>Flug: W A S D und Q E bewegen, Umschalt beschleunigt, der Zeiger lenkt den Blick, das Rad stellt das Tempo ein, Esc landet.</translation>
    </message>
    <message>
        <source>Follow the curvature within</source>
        <translation>Der Krümmung folgen auf</translation>
    </message>
    <message>
        <source>Follow the stroke</source>
        <translation>Dem Strich folgen</translation>
    </message>
    <message>
        <source>For print</source>
        <translation>Für den Druck</translation>
    </message>
    <message>
        <source>For the falloff custom: weight over distance in radii.</source>
        <translation>Für die eigene Abnahme: Gewicht über dem Abstand in Radien.</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>Frame &amp;All</source>
        <translation>Alles ins Bild</translation>
    </message>
    <message>
        <source>Frame &amp;Selection</source>
        <translation>Auswahl ins Bild</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>From &amp;Hollows</source>
        <translation>Aus Vertiefungen</translation>
    </message>
    <message>
        <source>From Mask</source>
        <translation>Aus Maske</translation>
    </message>
    <message>
        <source>From Se&amp;lection</source>
        <translation>Aus Auswahl</translation>
    </message>
    <message>
        <source>From a place straight through to the other side</source>
        <translation>Von einer Stelle gerade hindurch zur anderen Seite</translation>
    </message>
    <message>
        <source>From the next start on</source>
        <translation>Vom nächsten Start an</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Front faces</source>
        <translation>Nur Vorderseiten</translation>
    </message>
    <message>
        <source>Full tap</source>
        <translation>Volles Antippen</translation>
    </message>
    <message>
        <source>Gasket</source>
        <translation>Dichtung</translation>
    </message>
    <message>
        <source>Gaussian Curvature</source>
        <translation>Gaußsche Krümmung</translation>
    </message>
    <message>
        <source>Give the layer another name</source>
        <translation>Der Ebene einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Gives the model an inner wall and leaves it empty within; drill a hole to let out what is in there.</source>
        <translation>Gibt dem Modell eine innere Wand und lässt es darin leer; ein gebohrtes Loch lässt den Inhalt heraus.</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Graded</source>
        <translation>Abgestuft</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Körnung</translation>
    </message>
    <message>
        <source>Greatest thickness of the layer that one stroke lays.</source>
        <translation>Größte Dicke der Schicht, die ein Strich legt.</translation>
    </message>
    <message>
        <source>Grey image (PNG, JPEG) that the brush presses in: white has full effect, black none.</source>
        <translation>Graubild (PNG, JPEG), das der Pinsel eindrückt: Weiß wirkt voll, Schwarz gar nicht.</translation>
    </message>
    <message>
        <source>Grey in three white lights, the plainest look</source>
        <translation>Grau in drei weißen Lichtern, das schlichteste Aussehen</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Ground Grid</source>
        <translation>Bodengitter</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Erweitern</translation>
    </message>
    <message>
        <source>Haply Inverse3</source>
        <translation>Haply Inverse3</translation>
    </message>
    <message>
        <source>Header</source>
        <translation>Kopfleiste</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height of the plane above the mean of the surface under the brush.</source>
        <translation>Höhe der Ebene über dem Mittel der Fläche unter dem Pinsel.</translation>
    </message>
    <message>
        <source>Hel&amp;p</source>
        <translation>Hi&amp;lfe</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hide Rest</source>
        <translation>Rest ausblenden</translation>
    </message>
    <message>
        <source>Hide all that is not selected</source>
        <translation>Alles ausblenden, was nicht ausgewählt ist</translation>
    </message>
    <message>
        <source>Hide what is selected: tools and rays pass it by, nothing of it is lost</source>
        <translation>Ausgewähltes ausblenden: Werkzeuge und Strahlen gehen daran vorbei, nichts davon geht verloren</translation>
    </message>
    <message>
        <source>Hides a part of the model: it is not seen, and tools and rays pass it by. What is hidden is no longer selected; it is saved, meshed, measured and cut as before.</source>
        <translation>Blendet einen Teil des Modells aus: Er ist nicht zu sehen, und Werkzeuge und Strahlen gehen daran vorbei. Ausgeblendetes ist nicht mehr ausgewählt; gespeichert, vernetzt, gemessen und geschnitten wird es wie zuvor.</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Hold F and move, or type a number</source>
        <translation>F halten und bewegen, oder eine Zahl eingeben</translation>
    </message>
    <message>
        <source>Hold Shift and drag: whatever the tool, Shift smooths.</source>
        <translation>Umschalt halten und ziehen: Mit jedem Werkzeug glättet Umschalt.</translation>
    </message>
    <message>
        <source>Hold Shift+F and move, or type a number</source>
        <translation>Umschalt+F halten und bewegen, oder eine Zahl eingeben</translation>
    </message>
    <message>
        <source>Hold the button and draw a rectangle</source>
        <translation>Die Taste halten und ein Rechteck aufziehen</translation>
    </message>
    <message>
        <source>Hold the button and draw around what is wanted</source>
        <translation>Die Taste halten und um das Gewünschte herum zeichnen</translation>
    </message>
    <message>
        <source>Hold the button and draw around what is wanted.</source>
        <translation>Die Taste halten und um das Gewünschte herum zeichnen.</translation>
    </message>
    <message>
        <source>Holds what was touched first and carries it with the pointer.</source>
        <translation>Hält, was zuerst berührt wurde, und trägt es mit dem Zeiger.</translation>
    </message>
    <message>
        <source>Holes and &amp;Cuts</source>
        <translation>Löcher und Schnitte</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Aushöhlen</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>How a dab fades from its centre to its rim.</source>
        <translation>Wie ein Tupfer von der Mitte zum Rand abfällt.</translation>
    </message>
    <message>
        <source>How clay resists while the tool works on it</source>
        <translation>Wie sehr der Ton sich sträubt, während das Werkzeug ihn bearbeitet</translation>
    </message>
    <message>
        <source>How far the hand goes from the picture's lower edge to its upper</source>
        <translation>Wie weit die Hand vom unteren bis zum oberen Bildrand geht</translation>
    </message>
    <message>
        <source>How far the points' centroid lies from the surface, in supports: large at rims and where samples are uneven</source>
        <translation>Wie weit der Schwerpunkt der Punkte von der Fläche liegt, in Stützradien: groß an Rändern und wo ungleichmäßig abgetastet ist</translation>
    </message>
    <message>
        <source>How it joins what is selected</source>
        <translation>Wie es sich mit der Auswahl verbindet</translation>
    </message>
    <message>
        <source>How it joins what is selected; Shift held adds, Ctrl subtracts, both keep what is common</source>
        <translation>Wie es sich mit der Auswahl verbindet; Umschalt fügt hinzu, Strg zieht ab, beide behalten das Gemeinsame</translation>
    </message>
    <message>
        <source>How much each dab does  (Shift+F)</source>
        <translation>Wie viel jeder Tupfer tut  (Umschalt+F)</translation>
    </message>
    <message>
        <source>How much each dab does; each tool has its own default.</source>
        <translation>Wie viel jeder Tupfer tut; jedes Werkzeug hat seine Vorgabe.</translation>
    </message>
    <message>
        <source>How much of what the layer holds is shown; below 0 the other way</source>
        <translation>Wie viel vom Inhalt der Ebene gezeigt wird; unter 0 umgekehrt</translation>
    </message>
    <message>
        <source>How much the horn thins (or, below 0, swells) on its way.</source>
        <translation>Wie sehr sich das Horn auf seinem Weg verjüngt (unter 0: verdickt).</translation>
    </message>
    <message>
        <source>How much the sides are drawn together.</source>
        <translation>Wie sehr die Seiten zusammengezogen werden.</translation>
    </message>
    <message>
        <source>How much the surface spreads as it rises.</source>
        <translation>Wie sehr sich die Fläche beim Anheben ausbreitet.</translation>
    </message>
    <message>
        <source>How samples become dabs: evenly along the surface, one each, evenly in time, one sized by dragging, evenly along a straight line; ignored by tools that hold what they touched first.</source>
        <translation>Wie aus Abtastungen Tupfer werden: gleichmäßig entlang der Fläche, je einer, gleichmäßig in der Zeit, einer mit gezogener Größe, gleichmäßig entlang einer Geraden; Werkzeuge, die das zuerst Berührte halten, beachten es nicht.</translation>
    </message>
    <message>
        <source>How sharp an edge the stroke leaves along its way, one that later strokes keep; 0: none, the line is as round as points make it.</source>
        <translation>Wie scharf eine Kante ist, die der Strich auf seinem Weg hinterlässt und die spätere Striche behalten; 0: keine, die Linie ist so rund, wie Punkte sie machen.</translation>
    </message>
    <message>
        <source>How the way of the pointer becomes dabs; each tool keeps its own</source>
        <translation>Wie aus dem Weg des Zeigers Tupfer werden; jedes Werkzeug behält seine Art</translation>
    </message>
    <message>
        <source>Icosahedron</source>
        <translation>Ikosaeder</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg);;All files (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Inflate</source>
        <translation>Aufblasen</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Into the layer below it, or the surface below all layers</source>
        <translation>In die Ebene darunter, oder in die Fläche unter allen Ebenen</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Invert the tool</source>
        <translation>Das Werkzeug umkehren</translation>
    </message>
    <message>
        <source>Inverts what is selected, lets it grow or shrink along the surface, smooths it, or takes it from the mask.</source>
        <translation>Kehrt die Auswahl um, lässt sie entlang der Fläche wachsen oder schrumpfen, glättet sie oder nimmt sie aus der Maske.</translation>
    </message>
    <message>
        <source>Inverts, clears, softens or hardens the mask that protects from tools, or makes one from the shape.</source>
        <translation>Kehrt die Maske, die vor Werkzeugen schützt, um, hebt sie auf, macht sie weicher oder härter, oder macht eine aus der Form.</translation>
    </message>
    <message>
        <source>Its radius, in radii of the brush</source>
        <translation>Ihr Radius, in Radien des Pinsels</translation>
    </message>
    <message>
        <source>Jade</source>
        <translation>Jade</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Vereinigen</translation>
    </message>
    <message>
        <source>Joins a ball, box, cylinder, cone, torus or capsule to the model, or takes it away.</source>
        <translation>Fügt dem Modell eine Kugel, einen Quader, Zylinder, Kegel, Torus oder eine Kapsel hinzu oder nimmt sie weg.</translation>
    </message>
    <message>
        <source>Joins a tube along a curve to the model, or takes it away: a handle, a channel.</source>
        <translation>Fügt dem Modell ein Rohr entlang einer Kurve hinzu oder nimmt es weg: einen Griff, einen Kanal.</translation>
    </message>
    <message>
        <source>Joins two boundary loops by a sheet that goes on from the surface at both, with points as dense as there.</source>
        <translation>Verbindet zwei Randschleifen durch eine Fläche, die an beiden glatt anschließt, mit Punkten so dicht wie dort.</translation>
    </message>
    <message>
        <source>Just Sculpt</source>
        <translation>Gleich modellieren</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keep near sheets apart</source>
        <translation>Nahe Schichten getrennt halten</translation>
    </message>
    <message>
        <source>Keep strokes apart in layers, of which more or less is shown</source>
        <translation>Striche getrennt in Ebenen halten, von denen mehr oder weniger gezeigt wird</translation>
    </message>
    <message>
        <source>Keep the surface where it is</source>
        <translation>Die Fläche lassen, wo sie ist</translation>
    </message>
    <message>
        <source>Keep volume</source>
        <translation>Volumen behalten</translation>
    </message>
    <message>
        <source>Keeps some of the points, each where it is, as many as can stand so far apart; masked ones stay.</source>
        <translation>Behält einige der Punkte, jeden, wo er ist, so viele, wie so weit auseinander stehen können; maskierte bleiben.</translation>
    </message>
    <message>
        <source>Keeps strokes apart in layers, of which more or less is shown at any time; strokes go into the active one.</source>
        <translation>Hält Striche getrennt in Ebenen, von denen jederzeit mehr oder weniger gezeigt wird; Striche gehen in die aktive.</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>Key, fill and back light, harder than the studio</source>
        <translation>Führungs-, Füll- und Gegenlicht, härter als im Studio</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Keys of all actions at once</source>
        <translation>Die Tasten aller Aktionen auf einmal</translation>
    </message>
    <message>
        <source>Knot</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Known distance</source>
        <translation>Bekannter Abstand</translation>
    </message>
    <message>
        <source>LASzip LAZ</source>
        <translation>LASzip LAZ</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Largest Curvature k1</source>
        <translation>Größte Krümmung k1</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Layer Strength</source>
        <translation>Ebenenstärke</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Lays flat strips with a square tip along the stroke; inverted, cuts them out.</source>
        <translation>Legt flache Streifen mit eckiger Spitze entlang des Strichs; umgekehrt schneidet sie aus.</translation>
    </message>
    <message>
        <source>Le&amp;ft-handed</source>
        <translation>Für Linkshänder</translation>
    </message>
    <message>
        <source>Least step in depth</source>
        <translation>Kleinster Tiefensprung</translation>
    </message>
    <message>
        <source>Leave out parts of fewer than 200 triangles</source>
        <translation>Teile mit weniger als 200 Dreiecken weglassen</translation>
    </message>
    <message>
        <source>Leaves alone what faces away from the viewer.</source>
        <translation>Lässt in Ruhe, was vom Betrachter abgewandt ist.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Left button beside the model</source>
        <translation>Linke Taste neben dem Modell</translation>
    </message>
    <message>
        <source>Left button on the model</source>
        <translation>Linke Taste auf dem Modell</translation>
    </message>
    <message>
        <source>Leica PTX</source>
        <translation>Leica PTX</translation>
    </message>
    <message>
        <source>Length of the rope on which the brush follows the pointer, so that a trembling hand draws a smooth line; 0: none.</source>
        <translation>Länge der Schnur, an der der Pinsel dem Zeiger folgt, damit eine zitternde Hand eine glatte Linie zeichnet; 0: keine.</translation>
    </message>
    <message>
        <source>Less far along the surface, by half the brush</source>
        <translation>Weniger weit entlang der Fläche, um den halben Pinsel</translation>
    </message>
    <message>
        <source>Lets the sampling follow the deformation: gaps fill, crowds merge.</source>
        <translation>Lässt die Abtastung der Verformung folgen: Lücken füllen sich, Gedränge vereinigt sich.</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Tonwerte</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Light %1 %</source>
        <translation>Licht %1 %</translation>
    </message>
    <message>
        <source>Light from the whole sky, hardly any shadow</source>
        <translation>Licht vom ganzen Himmel, kaum Schatten</translation>
    </message>
    <message>
        <source>Light on dark: the model is the brightest thing there</source>
        <translation>Hell auf Dunkel: Das Modell ist das Hellste</translation>
    </message>
    <message>
        <source>Light shines through: shows large forms rather than small ones</source>
        <translation>Licht scheint hindurch: zeigt eher große als kleine Formen</translation>
    </message>
    <message>
        <source>Lights around the model</source>
        <translation>Lichter um das Modell</translation>
    </message>
    <message>
        <source>Limit of outliers</source>
        <translation>Grenze für Ausreißer</translation>
    </message>
    <message>
        <source>Line through places</source>
        <translation>Linie durch Stellen</translation>
    </message>
    <message>
        <source>Lines along sharp edges</source>
        <translation>Linien entlang scharfer Kanten</translation>
    </message>
    <message>
        <source>Lines along the edges that the model keeps sharp</source>
        <translation>Linien entlang der Kanten, die das Modell scharf hält</translation>
    </message>
    <message>
        <source>Lines at round coordinates below the model</source>
        <translation>Linien bei runden Koordinaten unter dem Modell</translation>
    </message>
    <message>
        <source>Lines that would become outlines if the eye moved a little</source>
        <translation>Linien, die zu Umrissen würden, wenn das Auge sich etwas bewegte</translation>
    </message>
    <message>
        <source>Lines where the surface ends in front of something farther away</source>
        <translation>Linien, wo die Fläche vor etwas Entfernterem endet</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Longest distance</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>Longest hole</source>
        <translation>Längstes Loch</translation>
    </message>
    <message>
        <source>Longest loop</source>
        <translation>Längste Schleife</translation>
    </message>
    <message>
        <source>Look Around</source>
        <translation>Umsehen</translation>
    </message>
    <message>
        <source>Look for their places everywhere</source>
        <translation>Ihren Ort überall suchen</translation>
    </message>
    <message>
        <source>Looking at what is left…</source>
        <translation>Wird angesehen…</translation>
    </message>
    <message>
        <source>Lower corner</source>
        <translation>Untere Ecke</translation>
    </message>
    <message>
        <source>M&amp;odel</source>
        <translation>M&amp;odell</translation>
    </message>
    <message>
        <source>Magnify</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Makes a sample model by code.</source>
        <translation>Erzeugt ein Beispielmodell durch Code.</translation>
    </message>
    <message>
        <source>Makes a solid shell of what is selected, and takes out the rest.</source>
        <translation>Macht aus Ausgewähltem eine feste Schale und entfernt den Rest.</translation>
    </message>
    <message>
        <source>Makes edges that stay sharp, where the points have them or along a line; or makes them smooth again.</source>
        <translation>Macht Kanten, die scharf bleiben, wo die Punkte sie haben oder entlang einer Linie; oder macht sie wieder glatt.</translation>
    </message>
    <message>
        <source>Makes normals anew from the positions, on the side of those that there are.</source>
        <translation>Macht Normalen neu aus den Positionen, auf der Seite der vorhandenen.</translation>
    </message>
    <message>
        <source>Makes one solid of parts that were pushed into each other: what lies inside of another part goes.</source>
        <translation>Macht aus ineinander geschobenen Teilen einen Körper: Was in einem anderen Teil liegt, verschwindet.</translation>
    </message>
    <message>
        <source>Makes scans that were taken in different light alike in colour.</source>
        <translation>Gleicht die Farben von Scans an, die in verschiedenem Licht aufgenommen wurden.</translation>
    </message>
    <message>
        <source>Makes the model symmetric: one side and its mirror image, welded at a plane.</source>
        <translation>Macht das Modell symmetrisch: eine Seite und ihr Spiegelbild, an einer Ebene verschweißt.</translation>
    </message>
    <message>
        <source>Makes the same surface with fewer points, placed where the shape needs them and fitted to it.</source>
        <translation>Macht dieselbe Fläche mit weniger Punkten, die liegen, wo die Form sie braucht, und an sie angepasst sind.</translation>
    </message>
    <message>
        <source>Makes the sampling finer where it is too coarse for detail; inverted, coarser.</source>
        <translation>Macht die Abtastung feiner, wo sie für Einzelheiten zu grob ist; umgekehrt gröber.</translation>
    </message>
    <message>
        <source>Making %1</source>
        <translation>%1 wird erzeugt</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Marching cubes</source>
        <translation>Marching Cubes</translation>
    </message>
    <message>
        <source>Mas&amp;k</source>
        <translation>Mas&amp;ke</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maskieren</translation>
    </message>
    <message>
        <source>Masks hollows as wide as half the brush</source>
        <translation>Maskiert Vertiefungen, so breit wie der halbe Pinsel</translation>
    </message>
    <message>
        <source>Masks what is selected</source>
        <translation>Maskiert, was ausgewählt ist</translation>
    </message>
    <message>
        <source>Material of the surface</source>
        <translation>Material der Oberfläche</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>Matte clay lit by the lamps; painted models keep their colours</source>
        <translation>Matter Ton im Licht der Lampen; bemalte Modelle behalten ihre Farben</translation>
    </message>
    <message>
        <source>Mean Curvature</source>
        <translation>Mittlere Krümmung</translation>
    </message>
    <message>
        <source>Meas&amp;ure</source>
        <translation>M&amp;essen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessenes</translation>
    </message>
    <message>
        <source>Measures at every point: its distance to another model, or how thick the model is there.</source>
        <translation>Misst an jedem Punkt: seinen Abstand zu einem anderen Modell, oder wie dick das Modell dort ist.</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Messung läuft…</translation>
    </message>
    <message>
        <source>Memory for history</source>
        <translation>Speicher für den Verlauf</translation>
    </message>
    <message>
        <source>Memory that steps back may hold; the oldest are forgotten first</source>
        <translation>Speicher, den die Schritte zurück belegen dürfen; die ältesten werden zuerst vergessen</translation>
    </message>
    <message>
        <source>Memory used by the model + by its history</source>
        <translation>Speicher für das Modell + für seinen Verlauf</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Verschmelzen</translation>
    </message>
    <message>
        <source>Merge duplicates</source>
        <translation>Doppelte vereinigen</translation>
    </message>
    <message>
        <source>Merge parts</source>
        <translation>Teile verschmelzen</translation>
    </message>
    <message>
        <source>Merges points that stand in one place; the first of them stays.</source>
        <translation>Vereinigt Punkte am selben Ort; der erste von ihnen bleibt.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Mittlere Taste</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Mirror at %1 = 0</source>
        <translation>Spiegelung an %1 = 0</translation>
    </message>
    <message>
        <source>Mixed pixels at edges in depth</source>
        <translation>Mischpixel an Tiefensprüngen</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <translation>Modelle (%1)</translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation>Maus oder Stift</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Verschieben um</translation>
    </message>
    <message>
        <source>Move with W A S D, Q and E, look with the pointer; Esc lands</source>
        <translation>Mit W A S D, Q und E fliegen, mit dem Zeiger blicken; Esc landet</translation>
    </message>
    <message>
        <source>Moves points away from the surface of wider supports: relief stands out more; masked ones stay.</source>
        <translation>Bewegt Punkte weg von der Fläche größerer Stützradien: Relief tritt stärker hervor; maskierte bleiben.</translation>
    </message>
    <message>
        <source>Moves points onto the surface of wider supports, without shrinking; masked ones stay.</source>
        <translation>Bewegt Punkte auf die Fläche größerer Stützradien, ohne zu schrumpfen; maskierte bleiben.</translation>
    </message>
    <message>
        <source>Moves points onto the surface that they and their neighbours mean, without shrinking it; masked ones stay.</source>
        <translation>Bewegt Punkte auf die Fläche, die sie und ihre Nachbarn meinen, ohne sie zu schrumpfen; maskierte bleiben.</translation>
    </message>
    <message>
        <source>Moves the model onto another scan of the same thing, or others onto it: one model with an attribute "scan" that tells whose a point was.</source>
        <translation>Bewegt das Modell auf einen anderen Scan desselben Gegenstands, oder andere auf dieses: ein Modell mit einem Attribut "scan", das sagt, woher ein Punkt stammt.</translation>
    </message>
    <message>
        <source>Moves the surface along its normals by a length; masked points stay.</source>
        <translation>Bewegt die Fläche entlang ihrer Normalen um eine Länge; maskierte Punkte bleiben.</translation>
    </message>
    <message>
        <source>Moves, turns, scales and mirrors with numbers; soft selections give way in the measure of the selection.</source>
        <translation>Verschiebt, dreht, skaliert und spiegelt mit Zahlen; weiche Auswahlen geben im Maß der Auswahl nach.</translation>
    </message>
    <message>
        <source>Möbius strip</source>
        <translation>Möbiusband</translation>
    </message>
    <message>
        <source>Name (replaces a saved view of the same name):</source>
        <translation>Name (ersetzt eine gespeicherte Ansicht gleichen Namens):</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Nearly black, for slides</source>
        <translation>Fast schwarz, für Folien</translation>
    </message>
    <message>
        <source>Neighbours in a support</source>
        <translation>Nachbarn je Stützradius</translation>
    </message>
    <message>
        <source>Neutral clay in studio light; protected places are darker</source>
        <translation>Neutraler Ton im Studiolicht; geschützte Stellen sind dunkler</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>No other lost work was found.</source>
        <translation>Es wurde keine weitere verlorene Arbeit gefunden.</translation>
    </message>
    <message>
        <source>No pressure left, full pressure right.</source>
        <translation>Links kein Druck, rechts voller Druck.</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Noise to take out</source>
        <translation>Zu entfernendes Rauschen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Normal from</source>
        <translation>Normale aus</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Normals from</source>
        <translation>Normalen aus</translation>
    </message>
    <message>
        <source>Not readable: %1</source>
        <translation>Nicht lesbar: %1</translation>
    </message>
    <message>
        <source>Nothing is named so; try another word.</source>
        <translation>Nichts heißt so; ein anderes Wort versuchen.</translation>
    </message>
    <message>
        <source>Number asked for</source>
        <translation>Gefragte Zahl</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Anzahl der Punkte</translation>
    </message>
    <message>
        <source>Number of surfels in the model</source>
        <translation>Anzahl der Surfels im Modell</translation>
    </message>
    <message>
        <source>Object file</source>
        <translation>Objektdatei</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>Octant</source>
        <translation>Oktant</translation>
    </message>
    <message>
        <source>Of the clay; a device's own limit goes before</source>
        <translation>Des Tons; die Grenze eines Geräts geht vor</translation>
    </message>
    <message>
        <source>Off-Centre Value</source>
        <translation>Außermittigkeit</translation>
    </message>
    <message>
        <source>One dab where you press; drag for its size and turn.</source>
        <translation>Ein Tupfer, wo gedrückt wird; Ziehen bestimmt Größe und Drehung.</translation>
    </message>
    <message>
        <source>One grey that favours no colour</source>
        <translation>Ein Grau, das keine Farbe bevorzugt</translation>
    </message>
    <message>
        <source>One place</source>
        <translation>Eine Stelle</translation>
    </message>
    <message>
        <source>One result copied.</source>
        <translation>Ein Ergebnis kopiert.</translation>
    </message>
    <message>
        <source>One small strong light in a blue sky: shadows with sharp edges</source>
        <translation>Ein kleines starkes Licht in blauem Himmel: Schatten mit scharfen Rändern</translation>
    </message>
    <message>
        <source>Only what is seen</source>
        <translation>Nur Sichtbares</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open &amp;With…</source>
        <translation>Öffnen mit…</translation>
    </message>
    <message>
        <source>Open Model</source>
        <translation>Modell öffnen</translation>
    </message>
    <message>
        <source>Open a Model…</source>
        <translation>Modell öffnen…</translation>
    </message>
    <message>
        <source>Open in &amp;Browser</source>
        <translation>Im &amp;Browser öffnen</translation>
    </message>
    <message>
        <source>Open lately</source>
        <translation>Zuletzt offen</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Opens a model and estimates what the file lacks.</source>
        <translation>Öffnet ein Modell und schätzt, was der Datei fehlt.</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Umkreisen</translation>
    </message>
    <message>
        <source>Orient normals</source>
        <translation>Normalen orientieren</translation>
    </message>
    <message>
        <source>Other model of the scene</source>
        <translation>Anderes Modell der Szene</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Outlines take only what is seen; else through everything</source>
        <translation>Umrisse erfassen nur, was zu sehen ist; sonst alles hindurch</translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation>Bedeckter Himmel</translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation>Überlagerungen</translation>
    </message>
    <message>
        <source>Pan the view</source>
        <translation>Ansicht verschieben</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Parallel projection: no perspective</source>
        <translation>Parallelprojektion: ohne Perspektive</translation>
    </message>
    <message>
        <source>Part of the brush that moves as one piece.</source>
        <translation>Teil des Pinsels, der sich als Ganzes bewegt.</translation>
    </message>
    <message>
        <source>Part to keep</source>
        <translation>Anteil, der bleibt</translation>
    </message>
    <message>
        <source>Parts protected from tools, in blue</source>
        <translation>Vor Werkzeugen geschützte Teile, in Blau</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Stück</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Kneifen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Place that is grey</source>
        <translation>Stelle, die grau ist</translation>
    </message>
    <message>
        <source>Place that stays</source>
        <translation>Stelle, die bleibt</translation>
    </message>
    <message>
        <source>Plain Grey</source>
        <translation>Schlichtes Grau</translation>
    </message>
    <message>
        <source>Plane from</source>
        <translation>Ebene aus</translation>
    </message>
    <message>
        <source>Plane offset</source>
        <translation>Ebenenversatz</translation>
    </message>
    <message>
        <source>Plateau</source>
        <translation>Plateau</translation>
    </message>
    <message>
        <source>Point Cloud Library</source>
        <translation>Point Cloud Library</translation>
    </message>
    <message>
        <source>Pointclay</source>
        <translation>Pointclay</translation>
    </message>
    <message>
        <source>Pointclay, as in Blender</source>
        <translation>Pointclay, wie in Blender</translation>
    </message>
    <message>
        <source>Points as text</source>
        <translation>Punkte als Text</translation>
    </message>
    <message>
        <source>Points come and go without a trace in this shading; View &gt; Shading &gt; %1 shows how dense they are.</source>
        <translation>Punkte kommen und gehen in dieser Schattierung spurlos; Ansicht &gt; Schattierung &gt; %1 zeigt, wie dicht sie liegen.</translation>
    </message>
    <message>
        <source>Points of a shape, at least</source>
        <translation>Punkte einer Form, mindestens</translation>
    </message>
    <message>
        <source>Points to fade out over</source>
        <translation>Punkte, über die es ausläuft</translation>
    </message>
    <message>
        <source>Poisson ratio of the material: at 0.5 it keeps its volume.</source>
        <translation>Querkontraktionszahl des Materials: Bei 0.5 behält es sein Volumen.</translation>
    </message>
    <message>
        <source>Polished metal: reflections show how the surface bends</source>
        <translation>Poliertes Metall: Spiegelungen zeigen, wie die Fläche sich krümmt</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygon</translation>
    </message>
    <message>
        <source>Polygon file</source>
        <translation>Polygondatei</translation>
    </message>
    <message>
        <source>Porcelain</source>
        <translation>Porzellan</translation>
    </message>
    <message>
        <source>Portable Network Graphics (*.png)</source>
        <translation>Portable Network Graphics (*.png)</translation>
    </message>
    <message>
        <source>Position of the plane; moving it cuts</source>
        <translation>Lage der Ebene; sie zu bewegen schneidet</translation>
    </message>
    <message>
        <source>Press B, choose Lasso and draw around a part: it turns orange, and commands work on it alone. Esc goes back to sculpting.</source>
        <translation>B drücken, Lasso wählen und einen Teil umfahren: Er wird orange, und Befehle wirken nur auf ihn. Esc führt zurück zum Modellieren.</translation>
    </message>
    <message>
        <source>Press F, move the pointer, click. Shift+F does the same for the strength.</source>
        <translation>F drücken, Zeiger bewegen, klicken. Umschalt+F tut dasselbe mit der Stärke.</translation>
    </message>
    <message>
        <source>Press F6: rays find the surface that the points define, and it grows out of the splats. F6 again goes back.</source>
        <translation>F6 drücken: Strahlen finden die Fläche, die die Punkte bestimmen, und sie wächst aus den Splats. F6 noch einmal geht zurück.</translation>
    </message>
    <message>
        <source>Pressing makes the chosen tool work, the harder the stronger; tools that grab hold what is pressed until the hand rests</source>
        <translation>Drücken lässt das gewählte Werkzeug wirken, je fester, desto stärker; greifende Werkzeuge halten das Gedrückte, bis die Hand ruht</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Preview: %1, %2 %</source>
        <translation>Vorschau: %1, %2 %</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Protect what is selected from tools</source>
        <translation>Ausgewähltes vor Werkzeugen schützen</translation>
    </message>
    <message>
        <source>Protects what it is painted on from all other tools; inverted, frees it.</source>
        <translation>Schützt, worauf sie gemalt ist, vor allen anderen Werkzeugen; umgekehrt gibt sie es frei.</translation>
    </message>
    <message>
        <source>Pulls a piece of the surface out into a horn that follows the pointer.</source>
        <translation>Zieht ein Stück der Fläche zu einem Horn heraus, das dem Zeiger folgt.</translation>
    </message>
    <message>
        <source>Pulls the surface as if it were part of an elastic solid.</source>
        <translation>Zieht die Fläche, als gehörte sie zu einem elastischen Körper.</translation>
    </message>
    <message>
        <source>Pushes the surface along itself, in the direction of the stroke.</source>
        <translation>Schiebt die Fläche in sich, in Richtung des Strichs.</translation>
    </message>
    <message>
        <source>Pushes the surface out under the brush; inverted, in.</source>
        <translation>Drückt die Fläche unter dem Pinsel heraus; umgekehrt hinein.</translation>
    </message>
    <message>
        <source>Put the models of a file beside these</source>
        <translation>Die Modelle einer Datei neben diese stellen</translation>
    </message>
    <message>
        <source>Puts a copy of what is selected elsewhere, moved as by "transform"; the copy is then selected.</source>
        <translation>Setzt eine Kopie des Ausgewählten woandershin, bewegt wie mit "transform"; danach ist die Kopie ausgewählt.</translation>
    </message>
    <message>
        <source>Puts several models beside each other in one scene; one of them is active, and all other commands and tools work on that one, in the coordinates of its own file, wherever its pose puts it; "apply" makes these the scene's.</source>
        <translation>Stellt mehrere Modelle nebeneinander in eine Szene; eines ist aktiv, und alle anderen Befehle und Werkzeuge wirken auf dieses, in den Koordinaten seiner Datei, wohin seine Lage es auch stellt; "apply" macht daraus die der Szene.</translation>
    </message>
    <message>
        <source>Puts the model and another one together as solids: union, difference or intersection.</source>
        <translation>Verknüpft das Modell und ein anderes als Körper: Vereinigung, Differenz oder Schnitt.</translation>
    </message>
    <message>
        <source>Puts the models of a file beside what is open</source>
        <translation>Stellt die Modelle einer Datei neben das, was offen ist</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius %1</source>
        <translation>Radius %1</translation>
    </message>
    <message>
        <source>Radius %1_</source>
        <translation>Radius %1_</translation>
    </message>
    <message>
        <source>Radius of the area whose mean normal gives tools their direction.</source>
        <translation>Radius des Bereichs, dessen mittlere Normale Werkzeugen ihre Richtung gibt.</translation>
    </message>
    <message>
        <source>Radius of the area whose mean position gives tools' planes their place.</source>
        <translation>Radius des Bereichs, dessen mittlere Position den Ebenen der Werkzeuge ihren Ort gibt.</translation>
    </message>
    <message>
        <source>Radius of the brush  (F)</source>
        <translation>Radius des Pinsels  (F)</translation>
    </message>
    <message>
        <source>Radius of the brush.</source>
        <translation>Radius des Pinsels.</translation>
    </message>
    <message>
        <source>Radius of the brush. [ and ] change it too, or F: move, then click.</source>
        <translation>Radius des Pinsels. Auch [ und ] ändern ihn, oder F: bewegen, dann klicken.</translation>
    </message>
    <message>
        <source>Radius over pen pressure, as a fraction of the full radius.</source>
        <translation>Radius über dem Stiftdruck, als Teil des vollen Radius.</translation>
    </message>
    <message>
        <source>Raises a ball by pushing out and spreading; inverted, a dent.</source>
        <translation>Hebt durch Herausdrücken und Ausbreiten eine Kugel; umgekehrt eine Delle.</translation>
    </message>
    <message>
        <source>Raises and lowers the surface by smooth noise; masked points stay.</source>
        <translation>Hebt und senkt die Fläche durch glattes Rauschen; maskierte Punkte bleiben.</translation>
    </message>
    <message>
        <source>Raises hollows to the mean plane; inverted, scrapes bumps down to it.</source>
        <translation>Hebt Vertiefungen zur mittleren Ebene; umgekehrt schabt Buckel zu ihr ab.</translation>
    </message>
    <message>
        <source>Raises the surface by a limited height, however often the stroke passes; inverted, lowers it.</source>
        <translation>Hebt die Fläche um eine begrenzte Höhe, wie oft der Strich auch darüber geht; umgekehrt senkt sie.</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Raw points of a figure: several views, noise, holes, no normals</source>
        <translation>Rohe Punkte einer Figur: mehrere Ansichten, Rauschen, Löcher, keine Normalen</translation>
    </message>
    <message>
        <source>Rays find the surface itself wherever the view rests; it grows out of the splats; glass, metal and shadows are in its bar</source>
        <translation>Strahlen finden die Fläche selbst, wo die Ansicht ruht; sie wächst aus den Splats; Glas, Metall und Schatten stehen in ihrer Leiste</translation>
    </message>
    <message>
        <source>Re&amp;cover Lost Work…</source>
        <translation>Verlorene Arbeit wiederherstellen…</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Recover lost work?</source>
        <translation>Verlorene Arbeit wiederherstellen?</translation>
    </message>
    <message numerus="yes">
        <source>Recovered %1 but for %n step(s), which %2 still holds. Save it to keep it.</source>
        <translation>
            <numerusform>%1 wiederhergestellt bis auf %n Schritt, der noch in %2 steht. Speichern, um es zu behalten.</numerusform>
            <numerusform>%1 wiederhergestellt bis auf %n Schritte, die noch in %2 stehen. Speichern, um es zu behalten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recovered %1. Save it to keep it.</source>
        <translation>%1 wiederhergestellt. Speichern, um es zu behalten.</translation>
    </message>
    <message>
        <source>Recovered %1: %2. Save it to keep it.</source>
        <translation>%1 wiederhergestellt: %2. Speichern, um es zu behalten.</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Red Wax</source>
        <translation>Rotes Wachs</translation>
    </message>
    <message>
        <source>Red on bumps and in bowls, blue on saddles, grey where the surface could be unrolled</source>
        <translation>Rot auf Buckeln und in Schalen, blau auf Sätteln, grau, wo die Fläche sich abwickeln ließe</translation>
    </message>
    <message>
        <source>Red where the surface bulges, blue where it is hollow</source>
        <translation>Rot, wo die Fläche sich wölbt, blau, wo sie hohl ist</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>%1 wiederholen</translation>
    </message>
    <message>
        <source>Reduce</source>
        <translation>Reduzieren</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Refracts and reflects; deep parts are darker and greener. Where there is no inside, a thin pane</source>
        <translation>Bricht und spiegelt; tiefe Teile sind dunkler und grüner. Wo kein Inneres ist, eine dünne Scheibe</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove mixed pixels</source>
        <translation>Mischpixel entfernen</translation>
    </message>
    <message>
        <source>Remove outliers</source>
        <translation>Ausreißer entfernen</translation>
    </message>
    <message>
        <source>Remove the stamp.</source>
        <translation>Den Stempel entfernen.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Rename Layer</source>
        <translation>Ebene umbenennen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Replaying what was done, %1 %</source>
        <translation>Das Getane wird wiederholt, %1 %</translation>
    </message>
    <message>
        <source>Resample</source>
        <translation>Neu abtasten</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Right button, Alt + left button</source>
        <translation>Rechte Taste, Alt + linke Taste</translation>
    </message>
    <message>
        <source>Rounded icosahedron</source>
        <translation>Gerundetes Ikosaeder</translation>
    </message>
    <message>
        <source>Rows and columns of a range scan</source>
        <translation>Zeilen und Spalten eines Scans</translation>
    </message>
    <message>
        <source>Run Session</source>
        <translation>Sitzung ausführen</translation>
    </message>
    <message>
        <source>Running %1</source>
        <translation>%1 wird ausgeführt</translation>
    </message>
    <message>
        <source>S&amp;hape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>S&amp;olids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Sa&amp;ved Views</source>
        <translation>Gespeicherte Ansichten</translation>
    </message>
    <message>
        <source>Same &amp;shape as the view</source>
        <translation>&amp;Seitenverhältnis der Ansicht</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Beispiel</translation>
    </message>
    <message>
        <source>Samples the surface of a reduced model densely and evenly, as it is, with supports of the usual size.</source>
        <translation>Tastet die Fläche eines reduzierten Modells dicht und gleichmäßig ab, wie sie ist, mit Stützradien üblicher Größe.</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Save Model</source>
        <translation>Modell speichern</translation>
    </message>
    <message>
        <source>Save Next &amp;Version</source>
        <translation>Nächste Version speichern</translation>
    </message>
    <message>
        <source>Save Sessio&amp;n…</source>
        <translation>Sitzung speichern…</translation>
    </message>
    <message>
        <source>Save Session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Save View</source>
        <translation>Ansicht speichern</translation>
    </message>
    <message>
        <source>Save a Cop&amp;y…</source>
        <translation>Kopie speichern…</translation>
    </message>
    <message>
        <source>Save a Copy</source>
        <translation>Kopie speichern</translation>
    </message>
    <message>
        <source>Save your work, and close what you do not need.</source>
        <translation>Die Arbeit speichern und schließen, was nicht gebraucht wird.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Saved a copy, %1</source>
        <translation>Kopie gespeichert, %1</translation>
    </message>
    <message>
        <source>Says which axis of the model is upwards: views, turntables and the ground follow, no surfel moves.</source>
        <translation>Sagt, welche Achse des Modells nach oben zeigt: Ansichten, Drehteller und Boden folgen, kein Surfel bewegt sich.</translation>
    </message>
    <message>
        <source>Scale Bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Scale of its unit</source>
        <translation>Maßstab der Einheit</translation>
    </message>
    <message>
        <source>Scales the whole model about its middle so that a known distance is right.</source>
        <translation>Skaliert das ganze Modell um seine Mitte, sodass ein bekannter Abstand stimmt.</translation>
    </message>
    <message>
        <source>Scanner at x, y, z</source>
        <translation>Scanner bei x, y, z</translation>
    </message>
    <message>
        <source>Scans and meshes; or drop a file anywhere on the window</source>
        <translation>Scans und Netze; oder eine Datei irgendwo auf das Fenster ziehen</translation>
    </message>
    <message>
        <source>Scans told apart by</source>
        <translation>Scans unterschieden nach</translation>
    </message>
    <message>
        <source>Scene, a file for each model (%1)</source>
        <translation>Szene, je Modell eine Datei (%1)</translation>
    </message>
    <message>
        <source>Scrapes bumps down to the mean plane; inverted, fills hollows up to it.</source>
        <translation>Schabt Buckel zur mittleren Ebene ab; umgekehrt füllt Vertiefungen zu ihr auf.</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Screen: the brush keeps its size in pixels. Model: it keeps its size on the model.</source>
        <translation>Bild: Der Pinsel behält seine Größe in Pixeln. Modell: Er behält seine Größe auf dem Modell.</translation>
    </message>
    <message>
        <source>Sculpt</source>
        <translation>Modellieren</translation>
    </message>
    <message>
        <source>Sculpt the clay behind this card: click beside it. Or begin with</source>
        <translation>Den Ton hinter dieser Karte formen: daneben klicken. Oder anfangen mit</translation>
    </message>
    <message>
        <source>Sculpt with the chosen tool; pen pressure counts</source>
        <translation>Mit dem gewählten Werkzeug modellieren; der Stiftdruck zählt</translation>
    </message>
    <message>
        <source>Sculptor's wax: deep shadows and a soft gloss show the form of details</source>
        <translation>Bildhauerwachs: tiefe Schatten und weicher Glanz zeigen die Form von Einzelheiten</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Second colour</source>
        <translation>Zweite Farbe</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Select and Measure bars (B, Shift+M)</source>
        <translation>Leisten für Auswahl und Messen (B, Umschalt+M)</translation>
    </message>
    <message>
        <source>Select everything</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Nichts auswählen</translation>
    </message>
    <message>
        <source>Select what is not selected, and the other way round</source>
        <translation>Auswählen, was nicht ausgewählt ist, und umgekehrt</translation>
    </message>
    <message>
        <source>Select what is protected from tools</source>
        <translation>Auswählen, was vor Werkzeugen geschützt ist</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Sessions (*.jsonl)</source>
        <translation>Sitzungen (*.jsonl)</translation>
    </message>
    <message>
        <source>Set unit</source>
        <translation>Einheit setzen</translation>
    </message>
    <message>
        <source>Sh&amp;rink</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Shadows cast by the lights</source>
        <translation>Schatten, die die Lichter werfen</translation>
    </message>
    <message>
        <source>Shadows where little of the sky can be seen</source>
        <translation>Schatten, wo wenig vom Himmel zu sehen ist</translation>
    </message>
    <message>
        <source>Shapes to look for</source>
        <translation>Gesuchte Formen</translation>
    </message>
    <message>
        <source>Sharp Edges</source>
        <translation>Scharfe Kanten</translation>
    </message>
    <message>
        <source>Sharp seams</source>
        <translation>Scharfe Nähte</translation>
    </message>
    <message>
        <source>Sharpen</source>
        <translation>Schärfen</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Schale</translation>
    </message>
    <message>
        <source>Shift + left button</source>
        <translation>Umschalt + linke Taste</translation>
    </message>
    <message>
        <source>Shift adds, Ctrl subtracts, Esc goes back to sculpting.</source>
        <translation>Umschalt fügt hinzu, Strg zieht ab, Esc führt zurück zum Modellieren.</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Shortest distance</source>
        <translation>Kleinster Abstand</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Alles einblenden</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles einblenden</translation>
    </message>
    <message>
        <source>Show all that is hidden</source>
        <translation>Alles einblenden, was ausgeblendet ist</translation>
    </message>
    <message>
        <source>Show the &amp;Bar</source>
        <translation>Leiste zeigen</translation>
    </message>
    <message>
        <source>Show the other side</source>
        <translation>Die andere Seite zeigen</translation>
    </message>
    <message>
        <source>Show what the layer holds</source>
        <translation>Zeigen, was die Ebene enthält</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Shown in its colours from now on. View &gt; Shading has the others.</source>
        <translation>Von jetzt an in seinen Farben. Ansicht &gt; Schattierung hat die übrigen.</translation>
    </message>
    <message>
        <source>Shown with its mask from now on. View &gt; Shading has the others.</source>
        <translation>Von jetzt an mit seiner Maske. Ansicht &gt; Schattierung hat die übrigen.</translation>
    </message>
    <message>
        <source>Shows all that is hidden of the model.</source>
        <translation>Blendet alles Ausgeblendete des Modells ein.</translation>
    </message>
    <message>
        <source>Error in colours</source>
        <translation>Fehler in Farben</translation>
    </message>
    <message>
        <source>Colours the model by how far each of its points is from the surface that would come</source>
        <translation>Färbt das Modell danach, wie weit jeder seiner Punkte von der Fläche liegt, die daraus würde</translation>
    </message>
    <message>
        <source>Shows in the picture what the command would make of the model, without doing it</source>
        <translation>Zeigt im Bild, was der Befehl aus dem Modell machen würde, ohne es zu tun</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Side to keep</source>
        <translation>Seite, die bleibt</translation>
    </message>
    <message>
        <source>Simulated hand</source>
        <translation>Simulierte Hand</translation>
    </message>
    <message>
        <source>Simulated scan</source>
        <translation>Simulierter Scan</translation>
    </message>
    <message>
        <source>Size of the brush</source>
        <translation>Größe des Pinsels</translation>
    </message>
    <message>
        <source>Size of the triangles, in typical distances between surfels</source>
        <translation>Größe der Dreiecke, in üblichen Punktabständen</translation>
    </message>
    <message>
        <source>Size of what is held; the rest of the brush gives way.</source>
        <translation>Größe dessen, was gehalten wird; der Rest des Pinsels gibt nach.</translation>
    </message>
    <message>
        <source>Slower; every angle at least 25°</source>
        <translation>Langsamer; jeder Winkel mindestens 25°</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Smallest Curvature k2</source>
        <translation>Kleinste Krümmung k2</translation>
    </message>
    <message>
        <source>Smallest support for curvature</source>
        <translation>Kleinster Stützradius für die Krümmung</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Smooth &amp;outlines</source>
        <translation>&amp;Glatte Umrisse</translation>
    </message>
    <message>
        <source>Snap to edges</source>
        <translation>An Kanten einrasten</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Something went wrong</source>
        <translation>Etwas ging schief</translation>
    </message>
    <message>
        <source>Source x</source>
        <translation>Quelle x</translation>
    </message>
    <message>
        <source>Source y</source>
        <translation>Quelle y</translation>
    </message>
    <message>
        <source>Source z</source>
        <translation>Quelle z</translation>
    </message>
    <message>
        <source>Spaces the points evenly on the surface that they define now.</source>
        <translation>Verteilt die Punkte gleichmäßig auf der Fläche, die sie jetzt bestimmen.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Spacing %1</source>
        <translation>Abstand %1</translation>
    </message>
    <message>
        <source>Spacing that the stroke leaves, as a fraction of what it found.</source>
        <translation>Abstand, den der Strich hinterlässt, als Teil des vorgefundenen.</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Sphere fits (APSS)</source>
        <translation>Kugelausgleich (APSS)</translation>
    </message>
    <message>
        <source>Splats, as in the window</source>
        <translation>Splats, wie im Fenster</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Abspalten</translation>
    </message>
    <message>
        <source>Split by</source>
        <translation>Aufteilen nach</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Stabiliser</source>
        <translation>Stabilisator</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>Stempel</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Start &amp;Card</source>
        <translation>Startkarte</translation>
    </message>
    <message>
        <source>Stereolithography</source>
        <translation>Stereolithografie</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Stop; the model stays as it is  (Esc)</source>
        <translation>Abbrechen; das Modell bleibt, wie es ist  (Esc)</translation>
    </message>
    <message>
        <source>Straight from one place to another</source>
        <translation>Gerade von einer Stelle zur anderen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Strength %1</source>
        <translation>Stärke %1</translation>
    </message>
    <message>
        <source>Strength %1_</source>
        <translation>Stärke %1_</translation>
    </message>
    <message>
        <source>Strength of smoothing after every dab.</source>
        <translation>Stärke des Glättens nach jedem Tupfer.</translation>
    </message>
    <message>
        <source>Strength over pen pressure.</source>
        <translation>Stärke über dem Stiftdruck.</translation>
    </message>
    <message>
        <source>Stretch along x, y, z</source>
        <translation>Strecken entlang x, y, z</translation>
    </message>
    <message>
        <source>Stripes of equal slope: they break where the surface has an edge and kink where its curvature jumps</source>
        <translation>Streifen gleicher Neigung: Sie brechen, wo die Fläche eine Kante hat, und knicken, wo ihre Krümmung springt</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Strich</translation>
    </message>
    <message>
        <source>Stronger</source>
        <translation>Stärker</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>Abziehen</translation>
    </message>
    <message>
        <source>Suggestive Contours</source>
        <translation>Suggestive Konturen</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>Support radius</source>
        <translation>Stützradius</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Surface to %1 px, %2</source>
        <translation>Fläche auf %1 px, %2</translation>
    </message>
    <message>
        <source>Surface to %1 px…</source>
        <translation>Fläche auf %1 px…</translation>
    </message>
    <message>
        <source>Surface …</source>
        <translation>Fläche …</translation>
    </message>
    <message>
        <source>Swells the surface along its own normals; inverted, shrinks it.</source>
        <translation>Bläht die Fläche entlang ihrer eigenen Normalen auf; umgekehrt schrumpft sie.</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Symmetry %1</source>
        <translation>Symmetrie %1</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Take back the stroke in progress; stop long work</source>
        <translation>Den laufenden Strich zurücknehmen; lange Arbeit abbrechen</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Take out all that is not selected</source>
        <translation>Alles entfernen, was nicht ausgewählt ist</translation>
    </message>
    <message>
        <source>Take out what is selected</source>
        <translation>Ausgewähltes entfernen</translation>
    </message>
    <message>
        <source>Take the Tour</source>
        <translation>Zum Rundgang</translation>
    </message>
    <message>
        <source>Taken from: %1</source>
        <translation>Vergeben an: %1</translation>
    </message>
    <message>
        <source>Takes out all that is not selected; what stays keeps every bit.</source>
        <translation>Entfernt alles, was nicht ausgewählt ist; was bleibt, behält jedes Bit.</translation>
    </message>
    <message>
        <source>Takes out of a scan what is not the model, in this order: duplicates, mixed pixels, outliers, noise; thins it, and makes its normals anew.</source>
        <translation>Entfernt aus einem Scan, was nicht das Modell ist, in dieser Reihenfolge: Doppelte, Mischpixel, Ausreißer, Rauschen; dünnt ihn aus und macht seine Normalen neu.</translation>
    </message>
    <message>
        <source>Takes out points that a scanner measured half on the near and half on the far side of an edge: veils along the line of sight between two surfaces; masked ones stay.</source>
        <translation>Entfernt Punkte, die ein Scanner halb auf der nahen und halb auf der fernen Seite einer Kante maß: Schleier längs der Sichtlinie zwischen zwei Flächen; maskierte bleiben.</translation>
    </message>
    <message>
        <source>Takes out points that are not of the model; masked ones stay. Which way normals look that opening estimated is guessed again.</source>
        <translation>Entfernt Punkte, die nicht zum Modell gehören; maskierte bleiben. Wohin beim Öffnen geschätzte Normalen zeigen, wird neu bestimmt.</translation>
    </message>
    <message>
        <source>Takes out what is selected; what stays keeps every bit.</source>
        <translation>Entfernt Ausgewähltes; was bleibt, behält jedes Bit.</translation>
    </message>
    <message>
        <source>Takes the results off the picture</source>
        <translation>Nimmt die Ergebnisse aus dem Bild</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Verjüngung</translation>
    </message>
    <message>
        <source>Texture: how much harder light places push than dark ones</source>
        <translation>Textur: um wie viel härter helle Stellen drücken als dunkle</translation>
    </message>
    <message>
        <source>Texture: how much harder ridges push than hollows</source>
        <translation>Textur: um wie viel härter Erhebungen drücken als Vertiefungen</translation>
    </message>
    <message>
        <source>The active model goes out of the scene</source>
        <translation>Das aktive Modell verlässt die Szene</translation>
    </message>
    <message>
        <source>The angle between the surface's normals at two places</source>
        <translation>Der Winkel zwischen den Normalen der Fläche an zwei Stellen</translation>
    </message>
    <message>
        <source>The ball sticks below this part of the normal force, and slides above</source>
        <translation>Unter diesem Teil der Normalkraft haftet die Kugel, darüber gleitet sie</translation>
    </message>
    <message>
        <source>The brush presses %1 in from now on.</source>
        <translation>Der Pinsel drückt von jetzt an %1 ein.</translation>
    </message>
    <message>
        <source>The coordinates of a place on the surface</source>
        <translation>Die Koordinaten einer Stelle auf der Fläche</translation>
    </message>
    <message>
        <source>The device moves a ball over the model and gets its force; Esc ends it</source>
        <translation>Das Gerät bewegt eine Kugel über das Modell und erhält ihre Kraft; Esc beendet es</translation>
    </message>
    <message>
        <source>The first points span %1 by %2 by %3 units.</source>
        <translation>Die ersten Punkte reichen über %1 mal %2 mal %3 Einheiten.</translation>
    </message>
    <message>
        <source>The force on the hand over the last seconds; darker where the tool worked</source>
        <translation>Die Kraft auf die Hand in den letzten Sekunden; dunkler, wo das Werkzeug wirkte</translation>
    </message>
    <message>
        <source>The layer goes with what was sculpted on it</source>
        <translation>Die Ebene verschwindet mit allem, was auf ihr modelliert wurde</translation>
    </message>
    <message>
        <source>The layer that strokes act on; the uppermost stands first</source>
        <translation>Die Ebene, auf die Striche wirken; die oberste steht zuerst</translation>
    </message>
    <message>
        <source>The manual is not beside this program. It is made with it (the target "desktop") and installed by cmake --install.</source>
        <translation>Das Handbuch liegt nicht bei diesem Programm. Es entsteht mit ihm (Ziel „desktop“), und cmake --install installiert es.</translation>
    </message>
    <message>
        <source>The model has changes that are not saved. Save them first?</source>
        <translation>Das Modell hat Änderungen, die nicht gespeichert sind. Vorher speichern?</translation>
    </message>
    <message>
        <source>The model's axes in the corner of the picture, to click and to drag</source>
        <translation>Die Achsen des Modells in der Bildecke, zum Klicken und Ziehen</translation>
    </message>
    <message>
        <source>The next axis upwards: y, z, -y, -z, x, -x; it is kept with the model</source>
        <translation>Die nächste Achse nach oben: y, z, -y, -z, x, -x; sie bleibt beim Modell</translation>
    </message>
    <message>
        <source>The other way: digs instead of builds, as with Ctrl</source>
        <translation>Umgekehrt: vertieft statt aufzubauen, wie mit Strg</translation>
    </message>
    <message>
        <source>The points sample</source>
        <translation>Die Punkte bilden ab</translation>
    </message>
    <message>
        <source>The pressure of a pen multiplies it. Hold Shift+F and move.</source>
        <translation>Der Druck eines Stifts vervielfacht sie. Umschalt+F halten und bewegen.</translation>
    </message>
    <message>
        <source>The program ended without saving %1 (%2, last changed %3).</source>
        <translation>Das Programm endete, ohne %1 zu speichern (%2, zuletzt geändert %3).</translation>
    </message>
    <message>
        <source>The shading as displayed, with shadows and occlusion on it</source>
        <translation>Die angezeigte Schattierung, mit Schatten und Verdeckung</translation>
    </message>
    <message>
        <source>The shortest way on the surface from one place to another</source>
        <translation>Der kürzeste Weg auf der Fläche von einer Stelle zur anderen</translation>
    </message>
    <message>
        <source>The stamp's upper edge leads along the stroke; off: the stamp stands upright in the view.</source>
        <translation>Die Oberkante des Stempels führt den Strich an; aus: Der Stempel steht aufrecht in der Ansicht.</translation>
    </message>
    <message>
        <source>The stroke keeps to edges that stay sharp, and to their corners, where one is so near; 0: to none.</source>
        <translation>Der Strich hält sich an scharfe Kanten und ihre Ecken, wo eine so nahe ist; 0: an keine.</translation>
    </message>
    <message>
        <source>The surface is not there. Click on the model.</source>
        <translation>Dort ist keine Fläche. Auf das Modell klicken.</translation>
    </message>
    <message>
        <source>The surface itself</source>
        <translation>Die Fläche selbst</translation>
    </message>
    <message>
        <source>The surfels' own</source>
        <translation>Von den Surfels selbst</translation>
    </message>
    <message>
        <source>The true surface, ray by ray</source>
        <translation>Die wahre Oberfläche, Strahl für Strahl</translation>
    </message>
    <message>
        <source>The true surface: accuracy reached, and time since the view came to rest</source>
        <translation>Die wahre Oberfläche: erreichte Genauigkeit, und Zeit, seit die Ansicht ruht</translation>
    </message>
    <message>
        <source>The view now turns about the middle of the picture.</source>
        <translation>Die Ansicht dreht sich jetzt um die Bildmitte.</translation>
    </message>
    <message>
        <source>The view now turns about this place.</source>
        <translation>Die Ansicht dreht sich jetzt um diese Stelle.</translation>
    </message>
    <message>
        <source>The window speaks it from the next start on.</source>
        <translation>Das Fenster spricht sie vom nächsten Start an.</translation>
    </message>
    <message>
        <source>Then a click on the model is the place</source>
        <translation>Danach ist ein Klick auf das Modell die Stelle</translation>
    </message>
    <message>
        <source>Then each click on the model is one place more</source>
        <translation>Danach ist jeder Klick auf das Modell eine Stelle mehr</translation>
    </message>
    <message>
        <source>There is no model to select from. Open one, or make one with File &gt; New.</source>
        <translation>Es gibt kein Modell, aus dem ausgewählt werden kann. Eines öffnen oder mit Datei &gt; Neu erzeugen.</translation>
    </message>
    <message>
        <source>There is no model to trim. Open one, or make one with File &gt; New.</source>
        <translation>Es gibt kein Modell zum Zuschneiden. Eines öffnen oder mit Datei &gt; Neu erzeugen.</translation>
    </message>
    <message>
        <source>There is no picture of it.</source>
        <translation>Es gibt kein Bild davon.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; the model is unchanged.</source>
        <translation>Dafür reicht der Speicher nicht; das Modell ist unverändert.</translation>
    </message>
    <message>
        <source>There is nothing to copy: nothing was measured yet.</source>
        <translation>Es gibt nichts zu kopieren: Noch wurde nichts gemessen.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Ausdünnen</translation>
    </message>
    <message>
        <source>Thin to distance</source>
        <translation>Ausdünnen auf Abstand</translation>
    </message>
    <message>
        <source>This model carries no numbers by name.</source>
        <translation>Dieses Modell trägt keine Zahlen mit Namen.</translation>
    </message>
    <message>
        <source>This model carries none</source>
        <translation>Dieses Modell trägt keine</translation>
    </message>
    <message>
        <source>This tool's options as they were at first; radius and symmetry stay.</source>
        <translation>Die Optionen dieses Werkzeugs wie am Anfang; Radius und Symmetrie bleiben.</translation>
    </message>
    <message>
        <source>Three Lamps</source>
        <translation>Drei Lampen</translation>
    </message>
    <message>
        <source>Through the points</source>
        <translation>Durch die Punkte</translation>
    </message>
    <message>
        <source>Time taken by the last dab, resampling included</source>
        <translation>Zeit für den letzten Tupfer samt Neuabtastung</translation>
    </message>
    <message>
        <source>Time to draw the last picture; %1</source>
        <translation>Zeit zum Zeichnen des letzten Bildes; %1</translation>
    </message>
    <message>
        <source>Tool strength</source>
        <translation>Stärke des Werkzeugs</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Tools now work on “%1”.</source>
        <translation>Werkzeuge wirken jetzt auf „%1“.</translation>
    </message>
    <message>
        <source>Tools on the right, panels on the left</source>
        <translation>Werkzeuge rechts, Leisten links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>Touc&amp;h</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Trace the seams</source>
        <translation>Nähte verfolgen</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>Transformieren</translation>
    </message>
    <message>
        <source>Triangulates the surface and previews the mesh over the picture</source>
        <translation>Vernetzt die Fläche und zeigt das Netz über dem Bild</translation>
    </message>
    <message>
        <source>Trim by %1</source>
        <translation>Mit %1 zuschneiden</translation>
    </message>
    <message>
        <source>True Surface</source>
        <translation>Wahre Oberfläche</translation>
    </message>
    <message>
        <source>Turn about that point of the surface; beside the model, about the middle of the view</source>
        <translation>Um diese Stelle der Fläche drehen; neben dem Modell um die Mitte der Ansicht</translation>
    </message>
    <message>
        <source>Turn about the axis</source>
        <translation>Um die Achse drehen</translation>
    </message>
    <message>
        <source>Turn about the place under the pointer; beside the model, about the middle of the view</source>
        <translation>Um die Stelle unter dem Zeiger drehen; neben dem Modell um die Mitte der Ansicht</translation>
    </message>
    <message>
        <source>Turn the model</source>
        <translation>Modell drehen</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>Turn the view, on the model too</source>
        <translation>Ansicht drehen, auch auf dem Modell</translation>
    </message>
    <message>
        <source>Turns inside out: normals point to the other side.</source>
        <translation>Stülpt um: Normalen zeigen zur anderen Seite.</translation>
    </message>
    <message>
        <source>Turns normals over until they agree which side is outside.</source>
        <translation>Wendet Normalen, bis sie sich einig sind, welche Seite außen ist.</translation>
    </message>
    <message>
        <source>Turns the stamp to the left.</source>
        <translation>Dreht den Stempel nach links.</translation>
    </message>
    <message>
        <source>Turns the surface as the pointer turns about the first contact.</source>
        <translation>Dreht die Fläche, wie der Zeiger sich um die erste Berührung dreht.</translation>
    </message>
    <message>
        <source>Turns the whole model onto the axes, or moves it onto the ground or the origin.</source>
        <translation>Dreht das ganze Modell auf die Achsen, oder stellt es auf den Boden oder in den Ursprung.</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Two minutes with your own hands</source>
        <translation>Zwei Minuten mit eigenen Händen</translation>
    </message>
    <message>
        <source>Two minutes with your own hands; also in the Help menu</source>
        <translation>Zwei Minuten mit eigenen Händen; auch im Menü Hilfe</translation>
    </message>
    <message>
        <source>Type a value; drag to change it, with Shift in fine steps</source>
        <translation>Einen Wert eingeben; Ziehen ändert ihn, mit Umschalt in feinen Schritten</translation>
    </message>
    <message>
        <source>Typical distance between neighbouring surfels, in model units</source>
        <translation>Üblicher Abstand benachbarter Surfels, in Modelleinheiten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>%1 rückgängig</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Hochachse</translation>
    </message>
    <message>
        <source>Upper corner</source>
        <translation>Obere Ecke</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Aufrecht</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Nach oben zeigt</translation>
    </message>
    <message>
        <source>VRPN</source>
        <translation>VRPN</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Zähigkeit</translation>
    </message>
    <message>
        <source>Visible Only</source>
        <translation>Nur Sichtbares</translation>
    </message>
    <message>
        <source>W A S D, Q E, Shift, wheel</source>
        <translation>W A S D, Q E, Umschalt, Rad</translation>
    </message>
    <message>
        <source>Waiting for the work in progress; Esc stops it.</source>
        <translation>Die laufende Arbeit wird abgewartet; Esc bricht sie ab.</translation>
    </message>
    <message>
        <source>Warm drawing paper, for lines and soft shadows</source>
        <translation>Warmes Zeichenpapier, für Linien und weiche Schatten</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>Way through places</source>
        <translation>Weg durch Stellen</translation>
    </message>
    <message>
        <source>Weaker</source>
        <translation>Schwächer</translation>
    </message>
    <message>
        <source>Weighted planes (WLS)</source>
        <translation>Gewichtete Ebenen (WLS)</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>What Is S&amp;elected</source>
        <translation>Ausgewähltes</translation>
    </message>
    <message>
        <source>What has no room here</source>
        <translation>Was hier keinen Platz hat</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was soll getan werden?</translation>
    </message>
    <message>
        <source>What is masked becomes free, and the other way round</source>
        <translation>Maskiertes wird frei, und umgekehrt</translation>
    </message>
    <message>
        <source>What is selected becomes a model of its own</source>
        <translation>Ausgewähltes wird ein eigenes Modell</translation>
    </message>
    <message>
        <source>What is selected, in orange</source>
        <translation>Ausgewähltes, in Orange</translation>
    </message>
    <message>
        <source>What is selected; else what is not masked; else what is under the brush</source>
        <translation>Ausgewähltes; sonst, was nicht maskiert ist; sonst, was unter dem Pinsel liegt</translation>
    </message>
    <message>
        <source>What lies behind goes; Shift keeps it and nothing else; Esc goes back to sculpting.</source>
        <translation>Was dahinter liegt, verschwindet; Umschalt behält nur dies; Esc führt zurück zum Modellieren.</translation>
    </message>
    <message>
        <source>What the hand holds; a device that is not there yet is waited for</source>
        <translation>Was die Hand hält; auf ein Gerät, das noch nicht da ist, wird gewartet</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Where everything is</source>
        <translation>Wo alles ist</translation>
    </message>
    <message>
        <source>Where the coordinate axes point: x red, y green, z blue</source>
        <translation>Wohin die Koordinatenachsen zeigen: x rot, y grün, z blau</translation>
    </message>
    <message>
        <source>Where to copy from, relative to the stroke's first contact.</source>
        <translation>Woher kopiert wird, relativ zur ersten Berührung des Strichs.</translation>
    </message>
    <message>
        <source>Which colour means which value, for shadings that measure</source>
        <translation>Welche Farbe welchen Wert bedeutet, für messende Schattierungen</translation>
    </message>
    <message>
        <source>While a button of theirs is down the left button picks; Shift adds, Ctrl subtracts, Esc goes back to sculpting</source>
        <translation>Solange einer ihrer Knöpfe gedrückt ist, wählt die linke Taste; Umschalt fügt hinzu, Strg zieht ab, Esc führt zurück zum Modellieren</translation>
    </message>
    <message>
        <source>While flying: move, down and up, faster, set the speed; Esc lands</source>
        <translation>Im Flug: bewegen, ab und auf, schneller, Tempo einstellen; Esc landet</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>White and glossy: highlights show the smallest dents</source>
        <translation>Weiß und glänzend: Glanzlichter zeigen die kleinsten Dellen</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Weißabgleich</translation>
    </message>
    <message>
        <source>With a say in what is made of it: columns of a text, unit, upwards, thinning, sampling of faces, sharp edges, the surface</source>
        <translation>Mit Mitsprache, was daraus wird: Spalten eines Textes, Einheit, Oben, Ausdünnen, Abtasten von Flächen, scharfe Kanten, die Fläche</translation>
    </message>
    <message>
        <source>With every tool.</source>
        <translation>Mit jedem Werkzeug.</translation>
    </message>
    <message>
        <source>Without shrinking</source>
        <translation>Ohne Schrumpfen</translation>
    </message>
    <message>
        <source>Work goes on in the file that is open</source>
        <translation>Die Arbeit geht in der offenen Datei weiter</translation>
    </message>
    <message>
        <source>Works only on what can be reached along the surface within the brush, not on the far side of a thin sheet.</source>
        <translation>Wirkt nur auf das, was im Pinsel entlang der Fläche erreichbar ist, nicht auf die Rückseite einer dünnen Schicht.</translation>
    </message>
    <message>
        <source>Writes all that was done since the model was opened, as a session to run again</source>
        <translation>Schreibt alles, was seit dem Öffnen des Modells getan wurde, als Sitzung zum Wiederholen</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Wrote %1; only a .ply keeps everything</source>
        <translation>%1 geschrieben; nur .ply behält alles</translation>
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
        <source>Zebra</source>
        <translation>Zebra</translation>
    </message>
    <message>
        <source>Zoom towards the pointer</source>
        <translation>Zum Zeiger zoomen</translation>
    </message>
    <message>
        <source>[[x,y,z],...], places on the surface: the line through them becomes a crease; closed where it ends at its beginning</source>
        <translation>[[x,y,z],...], Stellen auf der Fläche: Die Linie durch sie wird ein Falz; geschlossen, wo sie an ihrem Anfang endet</translation>
    </message>
    <message>
        <source>[[x,y,z],...], places that its middle goes through; closed where the last is the first</source>
        <translation>[[x,y,z],...], Stellen, durch die seine Mitte geht; geschlossen, wo die letzte die erste ist</translation>
    </message>
    <message>
        <source>[[x,y],...], a lasso: what it goes round, by the even-odd rule</source>
        <translation>[[x,y],...], ein Lasso: was es umläuft, nach der Gerade-Ungerade-Regel</translation>
    </message>
    <message>
        <source>[from,to] along the view from the eye; all unless told</source>
        <translation>[von,bis] entlang des Blicks vom Auge; ohne Angabe alles</translation>
    </message>
    <message>
        <source>[low,high] that the colours span; most of the numbers unless told</source>
        <translation>[klein,groß], was die Farben umspannen; ohne Angabe die meisten Zahlen</translation>
    </message>
    <message>
        <source>[nx,ny,nz,d]: at the plane nx*x + ny*y + nz*z = d</source>
        <translation>[nx,ny,nz,d]: an der Ebene nx*x + ny*y + nz*z = d</translation>
    </message>
    <message>
        <source>[nx,ny,nz,d]: what lies where nx*x + ny*y + nz*z &gt;= d</source>
        <translation>[nx,ny,nz,d]: was liegt, wo nx*x + ny*y + nz*z &gt;= d</translation>
    </message>
    <message>
        <source>[red,green,blue] from 0 to 255</source>
        <translation>[rot,grün,blau] von 0 bis 255</translation>
    </message>
    <message>
        <source>[width,height], size of the picture; 1280,720 unless told</source>
        <translation>[Breite,Höhe], Größe des Bildes; ohne Angabe 1280,720</translation>
    </message>
    <message>
        <source>[x,y,z] of the scene that turning leaves; the model's middle unless told</source>
        <translation>[x,y,z] der Szene, das beim Drehen bleibt; ohne Angabe die Mitte des Modells</translation>
    </message>
    <message>
        <source>[x,y,z] that normals point in</source>
        <translation>[x,y,z], wohin Normalen zeigen</translation>
    </message>
    <message>
        <source>[x,y,z] that turning and scaling leave where it is; the middle unless told</source>
        <translation>[x,y,z], das beim Drehen und Skalieren bleibt; ohne Angabe die Mitte</translation>
    </message>
    <message>
        <source>[x,y,z] to move by, last</source>
        <translation>[x,y,z], um das verschoben wird, zuletzt</translation>
    </message>
    <message>
        <source>[x,y,z] to scale by along each axis; negative numbers mirror</source>
        <translation>[x,y,z], um das je Achse skaliert wird; negative Zahlen spiegeln</translation>
    </message>
    <message>
        <source>[x,y,z] to turn about</source>
        <translation>[x,y,z], um das gedreht wird</translation>
    </message>
    <message>
        <source>[x,y,z], a place on the model</source>
        <translation>[x,y,z], eine Stelle auf dem Modell</translation>
    </message>
    <message>
        <source>[x,y,z], another</source>
        <translation>[x,y,z], eine andere</translation>
    </message>
    <message>
        <source>[x,y,z], direction that is upwards in the picture; the model's unless told</source>
        <translation>[x,y,z], Richtung, die im Bild oben ist; ohne Angabe die des Modells</translation>
    </message>
    <message>
        <source>[x,y,z], its upper corner</source>
        <translation>[x,y,z], ihre obere Ecke</translation>
    </message>
    <message>
        <source>[x,y,z], place of the camera of a view</source>
        <translation>[x,y,z], Ort der Kamera einer Ansicht</translation>
    </message>
    <message>
        <source>[x,y,z], place that the camera looks at</source>
        <translation>[x,y,z], Ort, auf den die Kamera blickt</translation>
    </message>
    <message>
        <source>[x,y,z], the box's lower corner</source>
        <translation>[x,y,z], die untere Ecke des Quaders</translation>
    </message>
    <message>
        <source>[x,y,z]: the ball's centre; where a piece begins, else from what is selected; the loop nearest to it</source>
        <translation>[x,y,z]: Mittelpunkt der Kugel; wo ein Stück beginnt, sonst aus der Auswahl; die nächste Schleife dazu</translation>
    </message>
    <message>
        <source>[x,y,z]: what stands there becomes grey, in place of the mean</source>
        <translation>[x,y,z]: was dort steht, wird grau, statt des Mittels</translation>
    </message>
    <message>
        <source>[x0,y0,x1,y1], two opposite corners, from the upper left corner of the picture</source>
        <translation>[x0,y0,x1,y1], zwei gegenüberliegende Ecken, von der linken oberen Bildecke</translation>
    </message>
    <message>
        <source>a centripetal Catmull-Rom curve through the places; off: straight lines, with round joints</source>
        <translation>eine zentripetale Catmull-Rom-Kurve durch die Stellen; aus: gerade Strecken mit runden Gelenken</translation>
    </message>
    <message>
        <source>a mass that muscles pull along a trajectory and forces push off it</source>
        <translation>eine Masse, die Muskeln entlang einer Bahn ziehen und Kräfte davon abbringen</translation>
    </message>
    <message>
        <source>a new model</source>
        <translation>ein neues Modell</translation>
    </message>
    <message>
        <source>a piece ends where the larger principal curvature is above this</source>
        <translation>ein Stück endet, wo die größere Hauptkrümmung hierüber liegt</translation>
    </message>
    <message>
        <source>a place on the drill's axis, before the model, as x,y,z</source>
        <translation>eine Stelle auf der Achse des Bohrers, vor dem Modell, als x,y,z</translation>
    </message>
    <message>
        <source>a support radius per point that holds about this many neighbours</source>
        <translation>ein Stützradius je Punkt, in dem etwa so viele Nachbarn liegen</translation>
    </message>
    <message>
        <source>a tracker with a force device at a VRPN server, NAME@HOST:PORT</source>
        <translation>ein Tracker mit Kraftgerät an einem VRPN-Server, NAME@HOST:PORT</translation>
    </message>
    <message>
        <source>about %1 triangles</source>
        <translation>etwa %1 Dreiecke</translation>
    </message>
    <message>
        <source>about how many; each sample has its own default</source>
        <translation>etwa wie viele; jedes Beispiel hat seine Vorgabe</translation>
    </message>
    <message>
        <source>above 0 the distance follows the curvature: the square root of tolerance over curvature, within the two limits; neighbouring distances differ by at most a tenth</source>
        <translation>über 0 folgt der Abstand der Krümmung: Wurzel aus Toleranz durch Krümmung, innerhalb der beiden Grenzen; benachbarte Abstände unterscheiden sich höchstens um ein Zehntel</translation>
    </message>
    <message>
        <source>above 1 makes middle tones brighter, below 1 darker</source>
        <translation>über 1 werden mittlere Töne heller, unter 1 dunkler</translation>
    </message>
    <message>
        <source>add new layer strength</source>
        <translation>neue Ebene hinzufügen Stärke</translation>
    </message>
    <message>
        <source>add the points of the model that this one was moved onto</source>
        <translation>die Punkte des Modells dazunehmen, auf das dieses bewegt wurde</translation>
    </message>
    <message>
        <source>add, duplicate, move: [x,y,z] of the scene to turn about</source>
        <translation>add, duplicate, move: [x,y,z] der Szene, um das gedreht wird</translation>
    </message>
    <message>
        <source>add, duplicate, move: [x,y,z] to move by, last</source>
        <translation>add, duplicate, move: [x,y,z], um das verschoben wird, zuletzt</translation>
    </message>
    <message>
        <source>add: a new one on top, which keeps the shape for the tool morph; merge: into the one below; base: strokes go below all layers; move: to another place; mask: hide it in parts</source>
        <translation>Hinzufügen: eine neue ganz oben, die die Form für das Werkzeug Morphen behält; Verschmelzen: mit der darunter; Grundfläche: Striche gehen unter alle Ebenen; Verschieben: an eine andere Stelle; Maske: in Teilen ausblenden</translation>
    </message>
    <message>
        <source>add: a sample in place of a file, NAME[:COUNT[:SEED]]</source>
        <translation>Hinzufügen: ein Beispiel statt einer Datei, NAME[:ANZAHL[:SAAT]]</translation>
    </message>
    <message>
        <source>add: file to open, in any readable format</source>
        <translation>Hinzufügen: Datei, die geöffnet wird, in jedem lesbaren Format</translation>
    </message>
    <message>
        <source>add: the models of a file; activate: commands and tools work on it; move: turn and move it; place: where its file's origin and axes come to stand; apply: put its place into its points; split: what is selected becomes a model; join: all that is shown, or the one of that name, goes into the active one</source>
        <translation>Hinzufügen: die Modelle einer Datei; Aktivieren: Befehle und Werkzeuge wirken darauf; Verschieben: drehen und bewegen; Platzieren: wohin Ursprung und Achsen seiner Datei kommen; Anwenden: seine Lage in die Punkte übernehmen; Aufteilen: Ausgewähltes wird ein Modell; Verbinden: alles Sichtbare, oder das mit diesem Namen, geht im aktiven auf</translation>
    </message>
    <message>
        <source>align icp scans</source>
        <translation>ausrichten icp Scans</translation>
    </message>
    <message>
        <source>another model: how far each point is from its surface, &gt; 0 on the side of its normals, goes into the attribute "deviation"</source>
        <translation>ein anderes Modell: wie weit jeder Punkt von dessen Fläche liegt, &gt; 0 auf der Seite ihrer Normalen, kommt in das Attribut "deviation"</translation>
    </message>
    <message>
        <source>another number, another noise</source>
        <translation>eine andere Zahl, ein anderes Rauschen</translation>
    </message>
    <message>
        <source>as few as keep the model's points this near to the surface, in the root mean square</source>
        <translation>so wenige, wie die Punkte des Modells im quadratischen Mittel so nahe an der Fläche halten</translation>
    </message>
    <message>
        <source>as numbers with commas between them: ball radius; box three edges; cylinder radius,height; cone radius,height; torus radius,tube; capsule radius,length between its balls</source>
        <translation>als Zahlen mit Kommas dazwischen: Kugel Radius; Quader drei Kanten; Zylinder Radius,Höhe; Kegel Radius,Höhe; Torus Radius,Rohr; Kapsel Radius,Länge zwischen ihren Kugeln</translation>
    </message>
    <message>
        <source>at spacenavd, which speaks for 3Dconnexion's devices; /run/spnav.sock or as given</source>
        <translation>an spacenavd, das für Geräte von 3Dconnexion spricht; /run/spnav.sock oder wie angegeben</translation>
    </message>
    <message>
        <source>at the Haply Inverse service</source>
        <translation>am Dienst Haply Inverse</translation>
    </message>
    <message>
        <source>attribute that tells which scan a point is of: scan of E57 and PTX, part of joined models</source>
        <translation>Attribut, das sagt, zu welchem Scan ein Punkt gehört: scan bei E57 und PTX, part bei vereinten Modellen</translation>
    </message>
    <message>
        <source>axes: turn its principal axes onto x, y and z, by as little as that takes; ground: its lowest point to height 0; centre: its middle above the origin</source>
        <translation>Achsen: seine Hauptachsen auf x, y und z drehen, so wenig wie möglich; Boden: sein tiefster Punkt auf Höhe 0; Mitte: seine Mitte über den Ursprung</translation>
    </message>
    <message>
        <source>ball, box, plane: parts of space; view: an outline in a picture; range: what they carry; piece: what hangs together; rim: boundaries</source>
        <translation>Kugel, Quader, Ebene: Teile des Raums; Ansicht: ein Umriss in einem Bild; Bereich: was sie tragen; Stück: was zusammenhängt; Rand: Ränder</translation>
    </message>
    <message>
        <source>beams apart</source>
        <translation>Strahlabstände</translation>
    </message>
    <message>
        <source>blur, sharpen, cavity: radius that means are taken over; grow, shrink: how far, along the surface</source>
        <translation>Weichzeichnen, Schärfen, Vertiefungen: Radius, über den gemittelt wird; Erweitern, Verkleinern: wie weit, entlang der Fläche</translation>
    </message>
    <message>
        <source>blur, sharpen: radius that means are taken over; grow, shrink: how far, along the surface</source>
        <translation>Weichzeichnen, Schärfen: Radius, über den gemittelt wird; Erweitern, Verkleinern: wie weit, entlang der Fläche</translation>
    </message>
    <message>
        <source>boolean subtract add union difference intersection</source>
        <translation>boolesch abziehen vereinigen Vereinigung Differenz Schnittmenge</translation>
    </message>
    <message>
        <source>border: what lies at the edge of it; copy: select as the mask has it</source>
        <translation>Rand: was an ihrem Rand liegt; Kopieren: auswählen, wie die Maske es hat</translation>
    </message>
    <message>
        <source>bore subtract</source>
        <translation>Bohrung abziehen</translation>
    </message>
    <message>
        <source>by which it is enlarged first</source>
        <translation>um den es zuerst vergrößert wird</translation>
    </message>
    <message>
        <source>by which it is turned before, about x, then y, then z, as x,y,z</source>
        <translation>um das es zuvor gedreht wird, um x, dann y, dann z, als x,y,z</translation>
    </message>
    <message>
        <source>by which its axis, z, is turned, about x, then y, then z, as x,y,z</source>
        <translation>um das seine Achse, z, gedreht wird, um x, dann y, dann z, als x,y,z</translation>
    </message>
    <message>
        <source>by which normals may differ from a shape's</source>
        <translation>um den Normalen von denen einer Form abweichen dürfen</translation>
    </message>
    <message>
        <source>cavity: mask hollows; curvature: mask what is curved; copy: mask what is selected</source>
        <translation>Vertiefungen: Hohles maskieren; Krümmung: Gekrümmtes maskieren; Kopieren: Ausgewähltes maskieren</translation>
    </message>
    <message>
        <source>close repair watertight</source>
        <translation>schließen reparieren wasserdicht</translation>
    </message>
    <message>
        <source>close what was cut, as dense as the model is beside it</source>
        <translation>verschließen, was geschnitten wurde, so dicht wie das Modell daneben</translation>
    </message>
    <message>
        <source>colour the points by one of them</source>
        <translation>die Punkte nach einem davon färben</translation>
    </message>
    <message>
        <source>colours the points by shape; grey are those of none</source>
        <translation>färbt die Punkte nach ihrer Form; grau sind die ohne eine</translation>
    </message>
    <message>
        <source>curvature from which they are masked fully</source>
        <translation>Krümmung, ab der sie ganz maskiert sind</translation>
    </message>
    <message>
        <source>curvature up to which surfels stay free; 0 unless told</source>
        <translation>Krümmung, bis zu der Surfels frei bleiben; ohne Angabe 0</translation>
    </message>
    <message>
        <source>cuts the seam flat, between where a ball of this radius touches both sides; on planes at right angles it takes as much of each</source>
        <translation>schneidet die Naht flach, zwischen den Stellen, wo eine Kugel dieses Radius beide Seiten berührt; bei Ebenen im rechten Winkel nimmt es von jeder gleich viel</translation>
    </message>
    <message>
        <source>decimate simplify fewer</source>
        <translation>dezimieren vereinfachen weniger</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>distance between neighbouring points to reach</source>
        <translation>gewünschter Abstand benachbarter Punkte</translation>
    </message>
    <message>
        <source>distance between neighbouring points to reach; with a tolerance alone: the median that there is</source>
        <translation>gewünschter Abstand benachbarter Punkte; mit einer Toleranz allein: der vorhandene Median</translation>
    </message>
    <message>
        <source>distance from the colour that still counts; 32 unless told</source>
        <translation>Abstand von der Farbe, der noch zählt; ohne Angabe 32</translation>
    </message>
    <message>
        <source>edges of the faces stay sharp where the normals on both sides differ by more than this, in pictures, meshes, measures, queries and strokes; off rounds them all; 40 by default</source>
        <translation>Kanten der Flächen bleiben scharf, wo die Normalen beider Seiten um mehr als dies abweichen, in Bildern, Netzen, Maßen, Abfragen und Strichen; off rundet alle; Vorgabe 40</translation>
    </message>
    <message>
        <source>edges stay sharp; else they are round over about a support</source>
        <translation>Kanten bleiben scharf; sonst sind sie über etwa einen Stützradius gerundet</translation>
    </message>
    <message>
        <source>file to open, in any readable format</source>
        <translation>Datei, die geöffnet wird, in jedem lesbaren Format</translation>
    </message>
    <message>
        <source>find creases in the points, in place of those that are there; give this or along</source>
        <translation>Falze in den Punkten suchen, statt der vorhandenen; dies oder die Linie angeben</translation>
    </message>
    <message>
        <source>flat: as little surface as there can be, in a plane with a sharp edge where a plane cut the model off; smooth: tangent planes and curvature around go on into the hole; detail: as smooth, with the relief of what is around</source>
        <translation>Flach: so wenig Fläche wie möglich, in einer Ebene mit scharfer Kante, wo eine Ebene das Modell abgeschnitten hat; Glatt: Tangentialebenen und Krümmung ringsum gehen in das Loch weiter; Einzelheiten: ebenso glatt, mit dem Relief ringsum</translation>
    </message>
    <message>
        <source>glTF</source>
        <translation>glTF</translation>
    </message>
    <message>
        <source>goes where a trajectory says and feels nothing</source>
        <translation>geht, wohin eine Bahn sagt, und fühlt nichts</translation>
    </message>
    <message>
        <source>greatest value of it</source>
        <translation>größter Wert davon</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>how a point's weight falls off with distance</source>
        <translation>wie das Gewicht eines Punkts mit dem Abstand abfällt</translation>
    </message>
    <message>
        <source>how far from a rim; the last rows of surfels unless told</source>
        <translation>wie weit von einem Rand; ohne Angabe die letzten Reihen von Surfels</translation>
    </message>
    <message>
        <source>how far from a shape a point of it may be; of each point its own unless told, from noise and spacing there</source>
        <translation>wie weit ein Punkt von seiner Form entfernt sein darf; sonst für jeden Punkt aus Rauschen und Abstand an seiner Stelle</translation>
    </message>
    <message>
        <source>how far normals may differ on one side of an edge, for the frame rimls</source>
        <translation>wie sehr Normalen auf einer Seite einer Kante abweichen dürfen, für die Methode rimls</translation>
    </message>
    <message>
        <source>how far outwards; below 0 inwards, until sides meet</source>
        <translation>wie weit nach außen; unter 0 nach innen, bis Seiten sich treffen</translation>
    </message>
    <message>
        <source>how far; below 0 the other way</source>
        <translation>wie weit; unter 0 umgekehrt</translation>
    </message>
    <message>
        <source>how many times as wide as the points' supports: detail smaller than this is meant</source>
        <translation>wievielmal so weit wie die Stützradien der Punkte: Kleinere Einzelheiten sind gemeint</translation>
    </message>
    <message>
        <source>how many to keep; give this, ratio or error</source>
        <translation>wie viele bleiben; dies, den Anteil oder den Fehler angeben</translation>
    </message>
    <message>
        <source>how much of what the layer holds is shown; below 0 the other way</source>
        <translation>wie viel vom Inhalt der Ebene gezeigt wird; unter 0 umgekehrt</translation>
    </message>
    <message>
        <source>how thick the model is under each point, straight inwards, goes into the attribute "thickness"</source>
        <translation>wie dick das Modell unter jedem Punkt ist, gerade nach innen, kommt in das Attribut "thickness"</translation>
    </message>
    <message>
        <source>how this joins what was selected</source>
        <translation>wie sich dies mit der bisherigen Auswahl verbindet</translation>
    </message>
    <message>
        <source>in: it grows behind the surface; out: before it</source>
        <translation>Nach innen: Sie wächst hinter der Fläche; nach außen: davor</translation>
    </message>
    <message>
        <source>label the points on both sides of seams as cells, so that seams are sharp</source>
        <translation>die Punkte auf beiden Seiten der Nähte als Zellen kennzeichnen, damit Nähte scharf sind</translation>
    </message>
    <message>
        <source>least value of it</source>
        <translation>kleinster Wert davon</translation>
    </message>
    <message>
        <source>level that becomes black; auto: half a percent are darker</source>
        <translation>Wert, der schwarz wird; auto: ein halbes Prozent ist dunkler</translation>
    </message>
    <message>
        <source>level that becomes white; auto: half a percent are brighter</source>
        <translation>Wert, der weiß wird; auto: ein halbes Prozent ist heller</translation>
    </message>
    <message>
        <source>longest distance, where it follows the curvature</source>
        <translation>größter Abstand, wo er der Krümmung folgt</translation>
    </message>
    <message>
        <source>look for their places everywhere, by what the surfaces look like; otherwise they begin where they are</source>
        <translation>ihren Ort überall suchen, danach, wie die Flächen aussehen; sonst beginnen sie, wo sie sind</translation>
    </message>
    <message>
        <source>loops longer than this stay open</source>
        <translation>Schleifen, die länger sind, bleiben offen</translation>
    </message>
    <message>
        <source>loops up to this length</source>
        <translation>Schleifen bis zu dieser Länge</translation>
    </message>
    <message>
        <source>mask: hide the layer where the model is masked, where it is selected, or nowhere</source>
        <translation>Maske: die Ebene ausblenden, wo das Modell maskiert ist, wo es ausgewählt ist, oder nirgends</translation>
    </message>
    <message>
        <source>merge points that stand in one place</source>
        <translation>Punkte am selben Ort vereinigen</translation>
    </message>
    <message>
        <source>model units</source>
        <translation>Modelleinheiten</translation>
    </message>
    <message>
        <source>model units that one unit of the file is long: .001 opens millimetres as metres; 1 by default</source>
        <translation>Modelleinheiten, die eine Einheit der Datei lang ist: .001 öffnet Millimeter als Meter; sonst 1</translation>
    </message>
    <message>
        <source>models that are moved onto this one and added to it</source>
        <translation>Modelle, die auf dieses bewegt und ihm hinzugefügt werden</translation>
    </message>
    <message>
        <source>most that the surface is raised or lowered by</source>
        <translation>höchstens so weit wird die Fläche gehoben oder gesenkt</translation>
    </message>
    <message>
        <source>move rotate scale translate</source>
        <translation>bewegen verschieben drehen skalieren</translation>
    </message>
    <message>
        <source>move: 1 is the lowest</source>
        <translation>Verschieben: 1 ist die unterste</translation>
    </message>
    <message>
        <source>new units</source>
        <translation>neue Einheiten</translation>
    </message>
    <message>
        <source>noise to take out, as its standard deviation across the surface; auto: as found at each place</source>
        <translation>zu entfernendes Rauschen, als Standardabweichung quer zur Fläche; auto: wie an jeder Stelle gefunden</translation>
    </message>
    <message>
        <source>normals: from the direction, 30 unless told; piece: between neighbours, where it ends at creases</source>
        <translation>Normalen: von der Richtung, ohne Angabe 30; Stück: zwischen Nachbarn, wo es an Falzen endet</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>number of points to reach, within a few percent, instead of a spacing</source>
        <translation>gewünschte Anzahl der Punkte, auf wenige Prozent, statt eines Abstands</translation>
    </message>
    <message>
        <source>number of samples on the faces, within a percent, small bodies denser than large ones; by default what the shapes need, at least 100,000</source>
        <translation>Anzahl der Abtastungen auf den Flächen, auf ein Prozent, kleine Körper dichter als große; ohne Angabe, was die Formen brauchen, mindestens 100,000</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>of its bottom below where the axis meets the model; 0: right through</source>
        <translation>seines Grundes unter der Stelle, wo die Achse das Modell trifft; 0: ganz hindurch</translation>
    </message>
    <message>
        <source>of its middle, as x,y,z</source>
        <translation>seiner Mitte, als x,y,z</translation>
    </message>
    <message>
        <source>of its points; by default as the model's nearest</source>
        <translation>seiner Punkte; ohne Angabe wie die nächsten des Modells</translation>
    </message>
    <message>
        <source>of its points; by default as the model's nearest to its beginning, 0.4 radii at most</source>
        <translation>seiner Punkte; ohne Angabe wie die des Modells nahe seinem Anfang, höchstens 0.4 Radien</translation>
    </message>
    <message>
        <source>of supports; auto takes ellipsoids where they bring the surface clearly nearer</source>
        <translation>der Stützradien; auto nimmt Ellipsoide, wo sie die Fläche deutlich näher bringen</translation>
    </message>
    <message>
        <source>of the ball</source>
        <translation>der Kugel</translation>
    </message>
    <message>
        <source>of the crease, 0 (smooth: creases that are there go) to 1</source>
        <translation>des Falzes, 0 (glatt: vorhandene Falze verschwinden) bis 1</translation>
    </message>
    <message>
        <source>of the drill, as x,y,z</source>
        <translation>des Bohrers, als x,y,z</translation>
    </message>
    <message>
        <source>of the hole</source>
        <translation>des Lochs</translation>
    </message>
    <message>
        <source>of the shell</source>
        <translation>der Schale</translation>
    </message>
    <message>
        <source>of the tube, whose ends are round</source>
        <translation>des Rohrs, dessen Enden rund sind</translation>
    </message>
    <message>
        <source>of the walls</source>
        <translation>der Wände</translation>
    </message>
    <message>
        <source>off-centre limit beyond which an open surface ends</source>
        <translation>Grenze der Außermittigkeit, hinter der eine offene Fläche endet</translation>
    </message>
    <message>
        <source>one support radius for all points; for the gaussian the scale H in exp(-s^2/H^2)</source>
        <translation>ein Stützradius für alle Punkte; für die Gaußfunktion der Maßstab H in exp(-s^2/H^2)</translation>
    </message>
    <message>
        <source>only what the camera sees, by the exact surface; else through everything</source>
        <translation>nur, was die Kamera sieht, nach der genauen Fläche; sonst durch alles hindurch</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>optional</translation>
    </message>
    <message>
        <source>over the picture, with the wheel or the pen's pressure for the depth</source>
        <translation>über dem Bild, mit dem Rad oder dem Stiftdruck für die Tiefe</translation>
    </message>
    <message>
        <source>parallel rays: height of the picture</source>
        <translation>parallele Strahlen: Höhe des Bildes</translation>
    </message>
    <message>
        <source>part of the way to the smooth surface</source>
        <translation>Teil des Wegs zur glatten Fläche</translation>
    </message>
    <message>
        <source>per s</source>
        <translation>pro s</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>plane: of the nearest points; jet: of a curved fit to them; grid: from the rows and columns of a range scan; viewpoint: plane, looking to the scanner</source>
        <translation>Ebene: der nächsten Punkte; Gekrümmt: einer gekrümmten Anpassung an sie; Gitter: aus Zeilen und Spalten eines Scans; Standpunkt: Ebene, zum Scanner blickend</translation>
    </message>
    <message>
        <source>points of a shape; a hundredth of all unless told</source>
        <translation>Punkte einer Form; sonst ein Hundertstel von allen</translation>
    </message>
    <message>
        <source>points over which what still differs fades out; 0: brightness of whole scans alone</source>
        <translation>Punkte, über die ausläuft, was noch verschieden ist; 0: nur die Helligkeit ganzer Scans</translation>
    </message>
    <message>
        <source>primitive boolean subtract union difference</source>
        <translation>Grundkörper boolesch abziehen Vereinigung Differenz</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>radii</source>
        <translation>Radien</translation>
    </message>
    <message>
        <source>radius of a ball that rolls along the seam and rounds it</source>
        <translation>Radius einer Kugel, die entlang der Naht rollt und sie rundet</translation>
    </message>
    <message>
        <source>raise and tilt the new points until their surface is the one before, so that nothing wears off</source>
        <translation>die neuen Punkte heben und neigen, bis ihre Fläche die vorige ist, damit sich nichts abnutzt</translation>
    </message>
    <message>
        <source>remesh even spacing</source>
        <translation>remesh gleichmäßig Abstand</translation>
    </message>
    <message>
        <source>rename, duplicate, split: the new name</source>
        <translation>Umbenennen, Duplizieren, Aufteilen: der neue Name</translation>
    </message>
    <message>
        <source>rename: the new name</source>
        <translation>Umbenennen: der neue Name</translation>
    </message>
    <message>
        <source>rgb</source>
        <translation>rgb</translation>
    </message>
    <message>
        <source>samples of the faces get labels of cells that meet in the sharp edges; off only keeps their normals apart, and edges are rounded over about a support; by default as far as there are edges to keep</source>
        <translation>Abtastungen der Flächen werden als Zellen gekennzeichnet, die sich in den scharfen Kanten treffen; off trennt nur ihre Normalen, und Kanten sind über etwa einen Stützradius gerundet; ohne Angabe, soweit es Kanten zu halten gibt</translation>
    </message>
    <message>
        <source>screenshot picture render png</source>
        <translation>Bildschirmfoto Bild rendern png</translation>
    </message>
    <message>
        <source>second pass that keeps nearby sheets apart</source>
        <translation>zweiter Durchgang, der nahe Schichten getrennt hält</translation>
    </message>
    <message>
        <source>selection: what is selected moves away, and walls close the step; loop: a wall along a boundary loop</source>
        <translation>Auswahl: Ausgewähltes bewegt sich weg, und Wände schließen die Stufe; Schleife: eine Wand entlang einer Randschleife</translation>
    </message>
    <message>
        <source>selection: what is selected; rest: what is not; mask: what is masked; swap: what is shown, and what is hidden is shown</source>
        <translation>Auswahl: was ausgewählt ist; Rest: was nicht; Maske: was maskiert ist; Tauschen: was zu sehen ist, und Ausgeblendetes kommt zurück</translation>
    </message>
    <message>
        <source>selects among random variants</source>
        <translation>wählt unter zufälligen Varianten</translation>
    </message>
    <message>
        <source>sharpen: 1 doubles the difference to the mean; cavity: 1 masks a hollow as wide as the length fully</source>
        <translation>Schärfen: 1 verdoppelt den Unterschied zum Mittel; Vertiefungen: 1 maskiert eine Vertiefung so breit wie die Länge ganz</translation>
    </message>
    <message>
        <source>sharpen: by how much; 1 doubles the difference to the mean</source>
        <translation>Schärfen: um wie viel; 1 verdoppelt den Unterschied zum Mittel</translation>
    </message>
    <message>
        <source>shortest distance, where it follows the curvature</source>
        <translation>kleinster Abstand, wo er der Krümmung folgt</translation>
    </message>
    <message>
        <source>slice halve</source>
        <translation>schneiden halbieren</translation>
    </message>
    <message>
        <source>smallest support radius on which curvature is measured, for supports from neighbours</source>
        <translation>kleinster Stützradius, auf dem Krümmung gemessen wird, für Stützradien aus Nachbarn</translation>
    </message>
    <message>
        <source>spacing of samples on the faces, of all bodies alike; by default it follows from sample_count and from what each body needs</source>
        <translation>Abstand der Abtastungen auf den Flächen, für alle Körper gleich; ohne Angabe folgt er aus sample_count und daraus, was jeder Körper braucht</translation>
    </message>
    <message>
        <source>spacings</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>split: an attribute, such as scan, each value of which becomes a model; the selection unless told</source>
        <translation>Aufteilen: ein Attribut, etwa scan, von dem jeder Wert ein Modell wird; ohne Angabe die Auswahl</translation>
    </message>
    <message>
        <source>statistical: farther from their neighbours than these are from theirs; radius: with too few others around; islands: in small pieces apart; surface: off the surface that their neighbours make</source>
        <translation>Statistisch: weiter von ihren Nachbarn als diese von den ihren; Radius: mit zu wenigen anderen ringsum; Inseln: in kleinen Stücken abseits; Fläche: neben der Fläche, die ihre Nachbarn bilden</translation>
    </message>
    <message>
        <source>steps in depth count from so many distances between neighbouring beams on</source>
        <translation>Tiefensprünge zählen ab so vielen Abständen benachbarter Strahlen</translation>
    </message>
    <message>
        <source>stl obj triangles wireframe convert print</source>
        <translation>stl obj Dreiecke Drahtgitter umwandeln drucken</translation>
    </message>
    <message>
        <source>strays floaters specks</source>
        <translation>Ausreißer Streupunkte Flecken</translation>
    </message>
    <message>
        <source>surfels</source>
        <translation>Surfels</translation>
    </message>
    <message>
        <source>symmetric form that does not erode the model</source>
        <translation>symmetrische Form, die das Modell nicht abträgt</translation>
    </message>
    <message>
        <source>take out mixed pixels: half on the near, half on the far side of an edge in depth</source>
        <translation>Mischpixel entfernen: halb auf der nahen, halb auf der fernen Seite eines Tiefensprungs</translation>
    </message>
    <message>
        <source>takes out a cast: what is changed becomes grey in the mean</source>
        <translation>nimmt einen Farbstich heraus: was geändert wird, wird im Mittel grau</translation>
    </message>
    <message>
        <source>takes what is hidden, too</source>
        <translation>nimmt auch Ausgeblendetes</translation>
    </message>
    <message>
        <source>the axis that is upwards</source>
        <translation>die Achse, die nach oben zeigt</translation>
    </message>
    <message>
        <source>the axis that is upwards; by default the file tells, or the shape</source>
        <translation>die Achse, die nach oben zeigt; sonst sagt es die Datei oder die Form</translation>
    </message>
    <message>
        <source>the model that this one is moved onto; give this or moving</source>
        <translation>das Modell, auf das dieses bewegt wird; dies oder die bewegten angeben</translation>
    </message>
    <message>
        <source>the other model: a file; give this, sample or model</source>
        <translation>das andere Modell: eine Datei; dies, ein Beispiel oder ein Modell der Szene angeben</translation>
    </message>
    <message>
        <source>the other model: a sample, NAME[:COUNT[:SEED]]</source>
        <translation>das andere Modell: ein Beispiel, NAME[:ANZAHL[:SAAT]]</translation>
    </message>
    <message>
        <source>the other model: one of the scene, where it stands; it is hidden afterwards</source>
        <translation>das andere Modell: eines der Szene, wo es steht; danach ist es ausgeblendet</translation>
    </message>
    <message>
        <source>the other models of the scene, as far as they are shown and not locked, come to lie on the active one: their poses change</source>
        <translation>die anderen Modelle der Szene, soweit sichtbar und nicht gesperrt, kommen auf dem aktiven zu liegen: Ihre Lagen ändern sich</translation>
    </message>
    <message>
        <source>the part of them to keep, below 1</source>
        <translation>der Teil von ihnen, der bleibt, unter 1</translation>
    </message>
    <message>
        <source>the points where nx*x + ny*y + nz*z = d, as nx,ny,nz,d</source>
        <translation>die Punkte, wo nx*x + ny*y + nz*z = d, als nx,ny,nz,d</translation>
    </message>
    <message>
        <source>thin points to those that are no closer than this to each other; LAS while it is read, however large it is</source>
        <translation>auf Punkte ausdünnen, die einander nicht näher sind als so; LAS beim Lesen, so groß es auch ist</translation>
    </message>
    <message>
        <source>thin to points that are no closer than this to each other</source>
        <translation>ausdünnen auf Punkte, die einander nicht näher sind als dies</translation>
    </message>
    <message>
        <source>to scale by, first</source>
        <translation>um den skaliert wird, zuerst</translation>
    </message>
    <message>
        <source>to turn by, right-handed</source>
        <translation>um den gedreht wird, rechtshändig</translation>
    </message>
    <message>
        <source>trace the curves where both surfaces cross, and tell their number and length</source>
        <translation>die Kurven verfolgen, in denen beide Flächen sich kreuzen, und ihre Zahl und Länge nennen</translation>
    </message>
    <message>
        <source>tree: neighbours agree, the outermost look outwards; viewpoint: to the scanner; global: each piece in agreement with all others</source>
        <translation>Baum: Nachbarn stimmen überein, die äußersten zeigen nach außen; Standpunkt: zum Scanner; Global: jedes Stück in Übereinstimmung mit allen anderen</translation>
    </message>
    <message>
        <source>two boundary loops by number, 0,1: longest first, from 0; may be left out where there are just two</source>
        <translation>zwei Randschleifen nach ihrer Nummer, 0,1: die längste zuerst, ab 0; entbehrlich, wo es gerade zwei gibt</translation>
    </message>
    <message>
        <source>union joins it, difference takes it away, intersection keeps what is in it</source>
        <translation>Vereinigung fügt es hinzu, Differenz nimmt es weg, Schnitt behält, was darin ist</translation>
    </message>
    <message>
        <source>union: what is in either; difference: in this one and not in the other; intersection: in both</source>
        <translation>Vereinigung: was in einem von beiden ist; Differenz: in diesem und nicht im anderen; Schnitt: in beiden</translation>
    </message>
    <message>
        <source>vertical angle of view; 35 unless told</source>
        <translation>senkrechter Blickwinkel; ohne Angabe 35</translation>
    </message>
    <message>
        <source>waiting for the device</source>
        <translation>wartet auf das Gerät</translation>
    </message>
    <message>
        <source>weights that make the surface pass through the points</source>
        <translation>Gewichte, mit denen die Fläche durch die Punkte geht</translation>
    </message>
    <message>
        <source>what is changed; auto: what is selected, all where nothing is</source>
        <translation>was geändert wird; auto: das Ausgewählte, sonst alles</translation>
    </message>
    <message>
        <source>what is still no outlier; statistical and surface: standard deviations (4), radius: others around (6), islands: points of a piece (the square root of the largest piece's)</source>
        <translation>was noch kein Ausreißer ist; Statistisch und Fläche: Standardabweichungen (4), Radius: andere ringsum (6), Inseln: Punkte eines Stücks (Wurzel der Punktzahl des größten)</translation>
    </message>
    <message>
        <source>what the columns of a text file are, each by a name, such as x,y,z,-,red,green,blue; - leaves one out; by default the file tells</source>
        <translation>was die Spalten einer Textdatei sind, jede mit einem Namen, etwa x,y,z,-,red,green,blue; - lässt eine aus; sonst sagt es die Datei</translation>
    </message>
    <message>
        <source>what the frame apss fits: 1 spheres, 0 planes</source>
        <translation>was die Methode apss anpasst: 1 Kugeln, 0 Ebenen</translation>
    </message>
    <message>
        <source>what the points sample; a complex: patches, curves and corners that are glued to each other, as the file tells</source>
        <translation>was die Punkte abbilden; ein Komplex: Flächenstücke, Kurven und Ecken, die aneinanderhängen, wie die Datei sagt</translation>
    </message>
    <message>
        <source>what their distance is known to be</source>
        <translation>wie groß ihr Abstand bekanntlich ist</translation>
    </message>
    <message>
        <source>what to do with a file's faces: sample their surface, or keep the vertices; auto (the default) keeps the vertices of dense, even meshes and samples all others</source>
        <translation>was mit den Flächen einer Datei geschieht: ihre Oberfläche abtasten oder die Ecken behalten; auto (die Vorgabe) behält die Ecken dichter, gleichmäßiger Netze und tastet alle anderen ab</translation>
    </message>
    <message>
        <source>what to join or take away</source>
        <translation>was hinzugefügt oder weggenommen wird</translation>
    </message>
    <message>
        <source>what to make</source>
        <translation>was gemacht wird</translation>
    </message>
    <message>
        <source>where the normal of the local plane comes from</source>
        <translation>woher die Normale der örtlichen Ebene kommt</translation>
    </message>
    <message>
        <source>where the other one's origin comes to stand, as x,y,z</source>
        <translation>wohin der Ursprung des anderen kommt, als x,y,z</translation>
    </message>
    <message>
        <source>where the scanner stood: [x,y,z] in the file's coordinates; the origin unless told, for mixed pixels what the file tells</source>
        <translation>wo der Scanner stand: [x,y,z] in den Koordinaten der Datei; ohne Angabe der Ursprung, für Mischpixel das, was die Datei sagt</translation>
    </message>
    <message>
        <source>where the scanner stood: [x,y,z] in the file's coordinates; what the file tells unless told</source>
        <translation>wo der Scanner stand: [x,y,z] in den Koordinaten der Datei; ohne Angabe das, was die Datei sagt</translation>
    </message>
    <message>
        <source>where to: x,y,z; a selection goes along its mean normal unless told, a wall along its loop stands across the surface</source>
        <translation>wohin: x,y,z; ohne Angabe geht eine Auswahl entlang ihrer mittleren Normale, eine Wand an ihrer Schleife steht quer zur Fläche</translation>
    </message>
    <message>
        <source>where what moves runs through the model: what is inside of each other goes, and both are one solid, or a hole goes through</source>
        <translation>wo das Bewegte durch das Modell läuft: Was ineinander liegt, verschwindet, und beide sind ein Körper, oder ein Loch geht hindurch</translation>
    </message>
    <message>
        <source>which boundary loop: longest first, from 0, as boundary lists them; may be left out where there is one</source>
        <translation>welche Randschleife: die längste zuerst, ab 0, wie boundary sie nennt; entbehrlich, wo es eine gibt</translation>
    </message>
    <message>
        <source>which boundary loops: all, all but the longest, or one by its number (longest first, from 0)</source>
        <translation>welche Randschleifen: alle, alle bis auf die längste, oder eine nach ihrer Nummer (die längste zuerst, ab 0)</translation>
    </message>
    <message>
        <source>which layer, the active one unless told; add: what the new one is called</source>
        <translation>welche Ebene, ohne Angabe die aktive; Hinzufügen: wie die neue heißt</translation>
    </message>
    <message>
        <source>which model, the active one unless told; add: what the new one is called</source>
        <translation>welches Modell, ohne Angabe das aktive; Hinzufügen: wie das neue heißt</translation>
    </message>
    <message>
        <source>which shapes to look for</source>
        <translation>nach welchen Formen gesucht wird</translation>
    </message>
    <message>
        <source>which side is kept and mirrored; above is where the plane's normal points to</source>
        <translation>welche Seite bleibt und gespiegelt wird; Darüber ist, wohin die Normale der Ebene zeigt</translation>
    </message>
    <message>
        <source>which side stays; above is where the plane's normal points to</source>
        <translation>welche Seite bleibt; Darüber ist, wohin die Normale der Ebene zeigt</translation>
    </message>
    <message>
        <source>width of bumps</source>
        <translation>Breite der Buckel</translation>
    </message>
    <message>
        <source>with detect: normals that differ by more than this are parted by a crease</source>
        <translation>beim Suchen: Normalen, die um mehr als dies abweichen, werden durch einen Falz getrennt</translation>
    </message>
    <message>
        <source>x, y, z, normal-x, ..., support, mask, red, ..., hue, saturation, brightness, curvature-most, -least, -mean, -gauss, or an attribute's name</source>
        <translation>x, y, z, normal-x, ..., support, mask, red, ..., hue, saturation, brightness, curvature-most, -least, -mean, -gauss, oder der Name eines Attributs</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>… and %1 more.</source>
        <translation>… und %1 weitere.</translation>
    </message>
    <message>
        <source>⇄</source>
        <translation>⇄</translation>
    </message>
    <message>
        <source>−</source>
        <translation>−</translation>
    </message>
</context>
<context>
    <name>choice</name>
    <message>
        <source>-x</source>
        <translation>-x</translation>
    </message>
    <message>
        <source>-y</source>
        <translation>-y</translation>
    </message>
    <message>
        <source>-z</source>
        <translation>-z</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Darüber</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>Aktivieren</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Apss</source>
        <translation>Kugelausgleich (APSS)</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Grundfläche</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Darunter</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Weichzeichnen</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Bulged</source>
        <translation>Gewölbtes Ikosaeder</translation>
    </message>
    <message>
        <source>Capsule</source>
        <translation>Kapsel</translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>Vertiefungen</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Centroid gradient</source>
        <translation>Gradient des Schwerpunkts</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Block aus Ton</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Wendel</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Complex</source>
        <translation>Komplex</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation>Kovarianz</translation>
    </message>
    <message>
        <source>Covariance at centroid</source>
        <translation>Kovarianz am Schwerpunkt</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Ellipsoids</source>
        <translation>Ellipsoide</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Gasket</source>
        <translation>Dichtung</translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation>Gaußfunktion</translation>
    </message>
    <message>
        <source>Global</source>
        <translation>Global</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Hyperplanes</source>
        <translation>Hyperebenen</translation>
    </message>
    <message>
        <source>Icosahedron</source>
        <translation>Ikosaeder</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Nach innen</translation>
    </message>
    <message>
        <source>Intersection</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Jet</source>
        <translation>Gekrümmt</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Knot</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Largest kept</source>
        <translation>Alle bis auf das größte</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Moebius</source>
        <translation>Möbiusband</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Octant</source>
        <translation>Oktant</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Nach außen</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Stück</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Platzieren</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Rimls</source>
        <translation>Kantenerhaltend (RIMLS)</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Gerundetes Ikosaeder</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Sharpen</source>
        <translation>Schärfen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Spheres</source>
        <translation>Kugeln</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Aufteilen</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Statistical</source>
        <translation>Statistisch</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Baum</translation>
    </message>
    <message>
        <source>Union</source>
        <translation>Vereinigung</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Viewpoint</source>
        <translation>Standpunkt</translation>
    </message>
    <message>
        <source>Wendland</source>
        <translation>Wendland</translation>
    </message>
    <message>
        <source>Wendland c4</source>
        <translation>Wendland C4</translation>
    </message>
</context>
<context>
    <name>falloff</name>
    <message>
        <source>Constant</source>
        <translation>Konstant</translation>
    </message>
    <message>
        <source>Custom curve</source>
        <translation>Eigene Kurve</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Wurzel</translation>
    </message>
    <message>
        <source>Sharp</source>
        <translation>Spitz</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
</context>
<context>
    <name>legend</name>
    <message>
        <source>Deviation (length)</source>
        <translation>Abweichung (Länge)</translation>
    </message>
    <message>
        <source>Gaussian curvature (1/length^2)</source>
        <translation>Gaußsche Krümmung (1/Länge^2)</translation>
    </message>
    <message>
        <source>Largest curvature k1 (1/length)</source>
        <translation>Größte Krümmung k1 (1/Länge)</translation>
    </message>
    <message>
        <source>Mean curvature (1/length)</source>
        <translation>Mittlere Krümmung (1/Länge)</translation>
    </message>
    <message>
        <source>Off-centre value (supports)</source>
        <translation>Außermittigkeit (Stützradien)</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Ausgewählt</translation>
    </message>
    <message>
        <source>Smallest curvature k2 (1/length)</source>
        <translation>Kleinste Krümmung k2 (1/Länge)</translation>
    </message>
    <message>
        <source>Spacing (length)</source>
        <translation>Abstand (Länge)</translation>
    </message>
</context>
<context>
    <name>message</name>
    <message>
        <source>%1 hidden surfel changed as well: this works on the whole model.</source>
        <translation>Auch %1 ausgeblendetes Surfel änderte sich: Dies wirkt auf das ganze Modell.</translation>
    </message>
    <message>
        <source>%1 hidden surfels changed as well: this works on the whole model.</source>
        <translation>Auch %1 ausgeblendete Surfels änderten sich: Dies wirkt auf das ganze Modell.</translation>
    </message>
    <message>
        <source>%1 models are one of %2 surfels.</source>
        <translation>%1 Modelle sind eines aus %2 Surfels.</translation>
    </message>
    <message>
        <source>%1 of %2 boundary loops filled with %3 points</source>
        <translation>%1 von %2 Randschleifen mit %3 Punkten gefüllt</translation>
    </message>
    <message>
        <source>%1 of %2 surfels are hidden.</source>
        <translation>%1 von %2 Surfels sind ausgeblendet.</translation>
    </message>
    <message>
        <source>%1 of %2 surfels are selected.</source>
        <translation>%1 von %2 Surfels sind ausgewählt.</translation>
    </message>
    <message>
        <source>%1 points are at a new crease, %2 at one that is as sharp as asked now</source>
        <translation>%1 Punkte liegen an einem neuen Falz, %2 an einem, der jetzt so scharf ist wie gewünscht</translation>
    </message>
    <message>
        <source>%1 points went, %2 came.</source>
        <translation>%1 Punkte gingen, %2 kamen.</translation>
    </message>
    <message>
        <source>%1 points were moved, and walls of %2 points were added.</source>
        <translation>%1 Punkte wurden verschoben und Wände aus %2 Punkten hinzugefügt.</translation>
    </message>
    <message>
        <source>%1 points were moved, and walls of %2 points were added; its edges are sharp.</source>
        <translation>%1 Punkte wurden verschoben und Wände aus %2 Punkten hinzugefügt; die Kanten sind scharf.</translation>
    </message>
    <message>
        <source>%1 points were thinned to %2 while they were read.</source>
        <translation>%1 Punkte wurden beim Lesen auf %2 ausgedünnt.</translation>
    </message>
    <message>
        <source>%1 smooth patches meet in creases, %2 pairs of them</source>
        <translation>%1 glatte Flächenstücke treffen sich in Falzen, in %2 Paaren</translation>
    </message>
    <message>
        <source>%1 surfels were taken out, %2 are left.</source>
        <translation>%1 Surfels wurden entfernt, %2 bleiben.</translation>
    </message>
    <message>
        <source>%1 surfels were taken out, %2 that were hidden are left.</source>
        <translation>%1 Surfels wurden entfernt, %2 ausgeblendete bleiben.</translation>
    </message>
    <message>
        <source>%1 triangles sampled to %2 surfels, spacing %3; --faces vertices keeps the %4 vertices.</source>
        <translation>%1 Dreiecke zu %2 Surfels abgetastet, Abstand %3; --faces vertices behält die %4 Ecken.</translation>
    </message>
    <message>
        <source>%1, %2 and %3 were taken for x, y and z.</source>
        <translation>%1, %2 und %3 wurden als x, y und z genommen.</translation>
    </message>
    <message>
        <source>Found %1 edge with more than two faces.</source>
        <translation>%1 Kante mit mehr als zwei Flächen gefunden.</translation>
    </message>
    <message>
        <source>Found %1 edges with more than two faces.</source>
        <translation>%1 Kanten mit mehr als zwei Flächen gefunden.</translation>
    </message>
    <message>
        <source>Found %1 shape with %2 of %3 points; the attribute shape has their numbers, for select by range and colours.</source>
        <translation>%1 Form mit %2 von %3 Punkten gefunden; das Attribut shape enthält ihre Nummern, für die Auswahl nach Bereich und Farben.</translation>
    </message>
    <message>
        <source>Found %1 shapes with %2 of %3 points; the attribute shape has their numbers, for select by range and colours.</source>
        <translation>%1 Formen mit %2 von %3 Punkten gefunden; das Attribut shape enthält ihre Nummern, für die Auswahl nach Bereich und Farben.</translation>
    </message>
    <message>
        <source>Left out %1 repeated triangle.</source>
        <translation>%1 doppeltes Dreieck weggelassen.</translation>
    </message>
    <message>
        <source>Left out %1 repeated triangles.</source>
        <translation>%1 doppelte Dreiecke weggelassen.</translation>
    </message>
    <message>
        <source>Left out %1 triangle inside of the solid.</source>
        <translation>%1 Dreieck im Inneren des Körpers weggelassen.</translation>
    </message>
    <message>
        <source>Left out %1 triangles inside of the solid.</source>
        <translation>%1 Dreiecke im Inneren des Körpers weggelassen.</translation>
    </message>
    <message>
        <source>Left out %1 vertices of no face; --faces vertices keeps them.</source>
        <translation>%1 Ecken ohne Fläche weggelassen; --faces vertices behält sie.</translation>
    </message>
    <message>
        <source>Left out %1 vertex of no face; --faces vertices keeps it.</source>
        <translation>%1 Ecke ohne Fläche weggelassen; --faces vertices behält sie.</translation>
    </message>
    <message>
        <source>One of both is sampled far more coarsely than the other: it got %1 more points beside the seam.</source>
        <translation>Eines von beiden ist viel gröber abgetastet als das andere: Es erhielt neben der Naht %1 weitere Punkte.</translation>
    </message>
    <message>
        <source>Only %1 points are left, too few to tell a shape: sample the parts more finely before.</source>
        <translation>Nur %1 Punkte bleiben, zu wenige für eine Form: die Teile vorher feiner abtasten.</translation>
    </message>
    <message>
        <source>Opened as points: %1 vertices of %2 have no face; --faces sample opens the faces alone.</source>
        <translation>Als Punkte geöffnet: %1 Ecken von %2 haben keine Fläche; --faces sample öffnet nur die Flächen.</translation>
    </message>
    <message>
        <source>Denoise: noise of %1 as told, points moved by %2 (rms), %3 at most.</source>
        <translation>Entrauschen: Rauschen von %1 vorgegeben, Punkte um %2 (rms) verschoben, höchstens um %3.</translation>
    </message>
    <message>
        <source>Denoise: noise of %1 found, points moved by %2 (rms), %3 at most.</source>
        <translation>Entrauschen: Rauschen von %1 gefunden, Punkte um %2 (rms) verschoben, höchstens um %3.</translation>
    </message>
    <message>
        <source>Duplicates: %1 of %2 points stood in the place of others and were merged with them.</source>
        <translation>Doppelte: %1 von %2 Punkten standen am Ort anderer und wurden mit ihnen vereinigt.</translation>
    </message>
    <message>
        <source>A part of the model is gone as a whole.</source>
        <translation>Ein Teil des Modells ist ganz verschwunden.</translation>
    </message>
    <message>
        <source>%1 parts of the model are gone as a whole.</source>
        <translation>%1 Teile des Modells sind ganz verschwunden.</translation>
    </message>
    <message>
        <source>A part of the other one left no trace: it does not meet the model's surface.</source>
        <translation>Ein Teil des anderen hat keine Spur hinterlassen: Er trifft die Fläche des Modells nicht.</translation>
    </message>
    <message>
        <source>%1 parts of the other one left no trace: they do not meet the model's surface.</source>
        <translation>%1 Teile des anderen haben keine Spur hinterlassen: Sie treffen die Fläche des Modells nicht.</translation>
    </message>
    <message>
        <source>It does not meet the model's surface: what came is a part of its own.</source>
        <translation>Es trifft die Fläche des Modells nicht: Was kam, ist ein Teil für sich.</translation>
    </message>
    <message>
        <source>Mixed pixels: %1 of %2 points removed, %3 %, seen from the file's %4 viewpoints.</source>
        <translation>Mischpixel: %1 von %2 Punkten entfernt, %3 %, von den %4 Standpunkten der Datei gesehen.</translation>
    </message>
    <message>
        <source>Mixed pixels: %1 of %2 points removed, %3 %, seen from the file's viewpoint.</source>
        <translation>Mischpixel: %1 von %2 Punkten entfernt, %3 %, vom Standpunkt der Datei gesehen.</translation>
    </message>
    <message>
        <source>Mixed pixels: %1 of %2 points removed, %3 %, seen from the viewpoint told.</source>
        <translation>Mischpixel: %1 von %2 Punkten entfernt, %3 %, vom angegebenen Standpunkt gesehen.</translation>
    </message>
    <message>
        <source>Outliers (islands): %1 of %2 points removed, %3 %.</source>
        <translation>Ausreißer (Inseln): %1 von %2 Punkten entfernt, %3 %.</translation>
    </message>
    <message>
        <source>Outliers (radius): %1 of %2 points removed, %3 %.</source>
        <translation>Ausreißer (Radius): %1 von %2 Punkten entfernt, %3 %.</translation>
    </message>
    <message>
        <source>Outliers (statistical): %1 of %2 points removed, %3 %.</source>
        <translation>Ausreißer (statistisch): %1 von %2 Punkten entfernt, %3 %.</translation>
    </message>
    <message>
        <source>Outliers (surface): %1 of %2 points removed, %3 %.</source>
        <translation>Ausreißer (Fläche): %1 von %2 Punkten entfernt, %3 %.</translation>
    </message>
    <message>
        <source>Reversed %1 triangle that faced the other way.</source>
        <translation>%1 Dreieck umgedreht, das andersherum lag.</translation>
    </message>
    <message>
        <source>Reversed %1 triangles that faced the other way.</source>
        <translation>%1 Dreiecke umgedreht, die andersherum lagen.</translation>
    </message>
    <message>
        <source>Rounded %1 of %2 sharp edges, which look like noise; with creases on, all stay sharp.</source>
        <translation>%1 von %2 scharfen Kanten gerundet, die wie Rauschen aussehen; mit Falzen bleiben alle scharf.</translation>
    </message>
    <message>
        <source>The %1 scans were put together at their poses; the attribute 'scan' tells them apart.</source>
        <translation>Die %1 Scans wurden an ihren Lagen zusammengesetzt; das Attribut 'scan' unterscheidet sie.</translation>
    </message>
    <message>
        <source>The faces are too broken to take normals from.</source>
        <translation>Die Flächen sind zu zerbrochen, um ihnen Normalen zu entnehmen.</translation>
    </message>
    <message>
        <source>The normals looked inwards, and were turned: the surface is closed.</source>
        <translation>Die Normalen zeigten nach innen und wurden gewendet: Die Fläche ist geschlossen.</translation>
    </message>
    <message>
        <source>The shell has %1 surfels.</source>
        <translation>Die Schale hat %1 Surfels.</translation>
    </message>
    <message>
        <source>The surface has no such boundary.</source>
        <translation>Die Fläche hat keinen solchen Rand.</translation>
    </message>
    <message>
        <source>Thin: %1 of %2 points removed, %3 left that are no closer than %4.</source>
        <translation>Ausdünnen: %1 von %2 Punkten entfernt, %3 bleiben, die nicht näher als %4 liegen.</translation>
    </message>
    <message>
        <source>Turned %1 closed piece that was inside out.</source>
        <translation>%1 geschlossenes Stück gewendet, dessen Innenseite außen war.</translation>
    </message>
    <message>
        <source>Turned %1 closed pieces that were inside out.</source>
        <translation>%1 geschlossene Stücke gewendet, deren Innenseite außen war.</translation>
    </message>
    <message>
        <source>Turned normals of closed faces that looked inwards.</source>
        <translation>Normalen geschlossener Flächen, die nach innen zeigten, wurden gewendet.</translation>
    </message>
    <message>
        <source>a stroke of %1 sample met the model and changed nothing</source>
        <translation>Ein Strich aus %1 Abtastung traf das Modell und änderte nichts</translation>
    </message>
    <message>
        <source>a stroke of %1 sample missed the model</source>
        <translation>Ein Strich aus %1 Abtastung verfehlte das Modell</translation>
    </message>
    <message>
        <source>a stroke of %1 samples met the model and changed nothing</source>
        <translation>Ein Strich aus %1 Abtastungen traf das Modell und änderte nichts</translation>
    </message>
    <message>
        <source>a stroke of %1 samples missed the model</source>
        <translation>Ein Strich aus %1 Abtastungen verfehlte das Modell</translation>
    </message>
    <message>
        <source>along x %1, y %2, z %3</source>
        <translation>entlang x %1, y %2, z %3</translation>
    </message>
    <message>
        <source>boundary loop %1 of length %2 about %3 %4 %5 is filled flat: no smooth surface stays near it and clear of the rest</source>
        <translation>Randschleife %1 der Länge %2 bei %3 %4 %5 ist flach gefüllt: Keine glatte Fläche bleibt in ihrer Nähe und berührt sonst nichts</translation>
    </message>
    <message>
        <source>boundary loop %1 of length %2 about %3 %4 %5 is filled smoothly: there is too little around it to follow in relief</source>
        <translation>Randschleife %1 der Länge %2 bei %3 %4 %5 ist glatt gefüllt: Um sie ist zu wenig Relief, dem zu folgen wäre</translation>
    </message>
    <message>
        <source>boundary loop %1 of length %2 about %3 %4 %5 was left: it does not close</source>
        <translation>Randschleife %1 der Länge %2 bei %3 %4 %5 blieb offen: Sie schließt sich nicht</translation>
    </message>
    <message>
        <source>boundary loop %1 of length %2 about %3 %4 %5 was left: it touches itself or another one</source>
        <translation>Randschleife %1 der Länge %2 bei %3 %4 %5 blieb offen: Sie berührt sich selbst oder eine andere</translation>
    </message>
    <message>
        <source>boundary loop %1 of length %2 about %3 %4 %5 was left: what would fill it runs into the model or itself</source>
        <translation>Randschleife %1 der Länge %2 bei %3 %4 %5 blieb offen: Was sie füllen würde, stößt an das Modell oder an sich selbst</translation>
    </message>
    <message>
        <source>boundary loop %1 of length %2 about %3 %4 %5 was left: what lies around it in its plane could not be filled</source>
        <translation>Randschleife %1 der Länge %2 bei %3 %4 %5 blieb offen: Was in ihrer Ebene um sie liegt, konnte nicht gefüllt werden</translation>
    </message>
    <message>
        <source>boundary loops %1 and %2 are bridged with %3 points</source>
        <translation>Randschleifen %1 und %2 sind mit %3 Punkten überbrückt</translation>
    </message>
    <message>
        <source>its sides lean by %1°</source>
        <translation>ihre Seiten neigen sich um %1°</translation>
    </message>
    <message>
        <source>no creases were found</source>
        <translation>Es wurden keine Falze gefunden</translation>
    </message>
    <message>
        <source>nothing is masked; mask what is to be hidden first</source>
        <translation>Nichts ist maskiert; zuerst maskieren, was ausgeblendet werden soll</translation>
    </message>
    <message>
        <source>nothing is opposite</source>
        <translation>gegenüber ist nichts</translation>
    </message>
    <message>
        <source>nothing is selected; select something first</source>
        <translation>Nichts ist ausgewählt; zuerst etwas auswählen</translation>
    </message>
    <message>
        <source>resampling stopped after %1 rounds, before the last points came to rest</source>
        <translation>Die Neuabtastung hielt nach %1 Runden an, bevor die letzten Punkte ruhten</translation>
    </message>
    <message>
        <source>straight %1</source>
        <translation>gerade %1</translation>
    </message>
    <message>
        <source>there are no creases to make smooth</source>
        <translation>Es gibt keine Falze zum Glätten</translation>
    </message>
    <message>
        <source>There is nothing to redo: the model is as it was.</source>
        <translation>Es gibt nichts zu wiederholen: Das Modell ist, wie es war.</translation>
    </message>
    <message>
        <source>There is nothing to undo: the model is as it was.</source>
        <translation>Es gibt nichts zurückzunehmen: Das Modell ist, wie es war.</translation>
    </message>
    <message>
        <source>The model is open where it was cut, at %1 %2 %3: there inside and outside are a guess, and the cap has an end of its own.</source>
        <translation>Das Modell ist offen, wo es geschnitten wurde, bei %1 %2 %3: Dort sind innen und außen geraten, und der Deckel hat ein eigenes Ende.</translation>
    </message>
    <message>
        <source>There is nothing to fill: the surface is closed, or its boundary limit is none; give it a limit, %1 for example, if it has holes.</source>
        <translation>Es gibt nichts zu füllen: Die Fläche ist geschlossen, oder ihre Randgrenze ist keine; geben Sie ihr eine Grenze, etwa %1, wenn sie Löcher hat.</translation>
    </message>
</context>
<context>
    <name>option</name>
    <message>
        <source>-x</source>
        <translation>-x</translation>
    </message>
    <message>
        <source>-y</source>
        <translation>-y</translation>
    </message>
    <message>
        <source>-z</source>
        <translation>-z</translation>
    </message>
    <message>
        <source>Airbrush</source>
        <translation>Airbrush</translation>
    </message>
    <message>
        <source>Anchored</source>
        <translation>Verankert</translation>
    </message>
    <message>
        <source>Dots</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>X axis</source>
        <translation>x-Achse</translation>
    </message>
    <message>
        <source>Y axis</source>
        <translation>y-Achse</translation>
    </message>
    <message>
        <source>Z axis</source>
        <translation>z-Achse</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
</context>
<context>
    <name>parameter</name>
    <message>
        <source>Amplitude</source>
        <translation>Ausschlag</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Chamfer</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Duplicates</source>
        <translation>Doppelte</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erlaubter Abstand</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Auge</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Fillet</source>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>Fov</source>
        <translation>Blickwinkel</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Hash</source>
        <translation>Prüfsumme</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendetes</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Schleifen</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Verknüpfung</translation>
    </message>
    <message>
        <source>Orient</source>
        <translation>Orientieren</translation>
    </message>
    <message>
        <source>Ortho</source>
        <translation>Bildhöhe (parallel)</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Sample count</source>
        <translation>Anzahl der Abtastungen</translation>
    </message>
    <message>
        <source>Sample spacing</source>
        <translation>Abstand der Abtastungen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Zufallszahl</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Sharp</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Schärfe</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Blickziel</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
</context>
<context>
    <name>progress</name>
    <message>
        <source>Aligning</source>
        <translation>Richtet aus</translation>
    </message>
    <message>
        <source>Averaging</source>
        <translation>Mittelt</translation>
    </message>
    <message>
        <source>Blending colours</source>
        <translation>Gleicht Farben an</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Prüft</translation>
    </message>
    <message>
        <source>Choosing the range</source>
        <translation>Wählt den Bereich</translation>
    </message>
    <message>
        <source>Coarsening</source>
        <translation>Vergröbert</translation>
    </message>
    <message>
        <source>Comparing with the surface</source>
        <translation>Vergleicht mit der Fläche</translation>
    </message>
    <message>
        <source>Completing normals</source>
        <translation>Ergänzt Normalen</translation>
    </message>
    <message>
        <source>Describing</source>
        <translation>Beschreibt</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnet</translation>
    </message>
    <message>
        <source>Drawing the curve as a tube</source>
        <translation>Zeichnet die Kurve als Rohr</translation>
    </message>
    <message>
        <source>Drawing the image</source>
        <translation>Zeichnet das Bild</translation>
    </message>
    <message>
        <source>Drawing the mesh</source>
        <translation>Zeichnet das Netz</translation>
    </message>
    <message>
        <source>Estimating normals</source>
        <translation>Schätzt Normalen</translation>
    </message>
    <message>
        <source>Filling</source>
        <translation>Füllt</translation>
    </message>
    <message>
        <source>Finding normals beside edges</source>
        <translation>Findet Normalen neben Kanten</translation>
    </message>
    <message>
        <source>Finding the boundary</source>
        <translation>Findet den Rand</translation>
    </message>
    <message>
        <source>Finishing</source>
        <translation>Schließt ab</translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation>Passt an</translation>
    </message>
    <message>
        <source>Flipping</source>
        <translation>Dreht um</translation>
    </message>
    <message>
        <source>Following boundaries</source>
        <translation>Verfolgt Ränder</translation>
    </message>
    <message>
        <source>Following seams</source>
        <translation>Verfolgt Nähte</translation>
    </message>
    <message>
        <source>Following the section</source>
        <translation>Verfolgt den Schnitt</translation>
    </message>
    <message>
        <source>Following the surface</source>
        <translation>Folgt der Fläche</translation>
    </message>
    <message>
        <source>Grading</source>
        <translation>Stuft ab</translation>
    </message>
    <message>
        <source>Grading supports</source>
        <translation>Stuft Stützradien ab</translation>
    </message>
    <message>
        <source>Growing the inner wall</source>
        <translation>Lässt die innere Wand wachsen</translation>
    </message>
    <message>
        <source>Hashing</source>
        <translation>Bildet die Prüfsumme</translation>
    </message>
    <message>
        <source>Indexing points</source>
        <translation>Ordnet Punkte</translation>
    </message>
    <message>
        <source>Joining</source>
        <translation>Verbindet</translation>
    </message>
    <message>
        <source>Judging the orientation</source>
        <translation>Beurteilt die Orientierung</translation>
    </message>
    <message>
        <source>Laying out places</source>
        <translation>Legt Stellen aus</translation>
    </message>
    <message>
        <source>Linking neighbours</source>
        <translation>Verknüpft Nachbarn</translation>
    </message>
    <message>
        <source>Looking at neighbours</source>
        <translation>Betrachtet Nachbarn</translation>
    </message>
    <message>
        <source>Looking at the surfels</source>
        <translation>Betrachtet die Surfels</translation>
    </message>
    <message>
        <source>Looking for boundaries</source>
        <translation>Sucht Ränder</translation>
    </message>
    <message>
        <source>Looking for creases</source>
        <translation>Sucht Falze</translation>
    </message>
    <message>
        <source>Looking for duplicates</source>
        <translation>Sucht Doppelte</translation>
    </message>
    <message>
        <source>Looking for folds</source>
        <translation>Sucht Falten</translation>
    </message>
    <message>
        <source>Looking for gaps</source>
        <translation>Sucht Lücken</translation>
    </message>
    <message>
        <source>Looking for hollows</source>
        <translation>Sucht Vertiefungen</translation>
    </message>
    <message>
        <source>Looking for intersections</source>
        <translation>Sucht Schnittpunkte</translation>
    </message>
    <message>
        <source>Looking for islands</source>
        <translation>Sucht Inseln</translation>
    </message>
    <message>
        <source>Looking for its place</source>
        <translation>Sucht seinen Ort</translation>
    </message>
    <message>
        <source>Looking for mixed pixels</source>
        <translation>Sucht Mischpixel</translation>
    </message>
    <message>
        <source>Looking for neighbours</source>
        <translation>Sucht Nachbarn</translation>
    </message>
    <message>
        <source>Looking for room</source>
        <translation>Sucht Platz</translation>
    </message>
    <message>
        <source>Looking for shapes</source>
        <translation>Sucht Formen</translation>
    </message>
    <message>
        <source>Looking for swarms</source>
        <translation>Sucht Schwärme</translation>
    </message>
    <message>
        <source>Looking for the section</source>
        <translation>Sucht den Schnitt</translation>
    </message>
    <message>
        <source>Looking for ways</source>
        <translation>Sucht Wege</translation>
    </message>
    <message>
        <source>Looking for what is in the way</source>
        <translation>Sucht, was im Weg ist</translation>
    </message>
    <message>
        <source>Looking for what lies inside</source>
        <translation>Sucht, was innen liegt</translation>
    </message>
    <message>
        <source>Measuring area</source>
        <translation>Misst die Fläche</translation>
    </message>
    <message>
        <source>Measuring areas</source>
        <translation>Misst Flächen</translation>
    </message>
    <message>
        <source>Measuring curvature</source>
        <translation>Misst Krümmung</translation>
    </message>
    <message>
        <source>Measuring distances</source>
        <translation>Misst Abstände</translation>
    </message>
    <message>
        <source>Measuring errors</source>
        <translation>Misst Fehler</translation>
    </message>
    <message>
        <source>Measuring faces</source>
        <translation>Misst Flächen</translation>
    </message>
    <message>
        <source>Measuring noise</source>
        <translation>Misst Rauschen</translation>
    </message>
    <message>
        <source>Measuring spacing</source>
        <translation>Misst Punktabstände</translation>
    </message>
    <message>
        <source>Measuring the surface</source>
        <translation>Misst die Fläche</translation>
    </message>
    <message>
        <source>Measuring thickness</source>
        <translation>Misst die Dicke</translation>
    </message>
    <message>
        <source>Measuring vertices</source>
        <translation>Misst Ecken</translation>
    </message>
    <message>
        <source>Measuring walls</source>
        <translation>Misst Wände</translation>
    </message>
    <message>
        <source>Mirroring</source>
        <translation>Spiegelt</translation>
    </message>
    <message>
        <source>Orienting normals</source>
        <translation>Orientiert Normalen</translation>
    </message>
    <message>
        <source>Parting faces</source>
        <translation>Trennt Flächen</translation>
    </message>
    <message>
        <source>Placing samples</source>
        <translation>Setzt Abtastungen</translation>
    </message>
    <message>
        <source>Raising the surface</source>
        <translation>Hebt die Fläche</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Liest</translation>
    </message>
    <message>
        <source>Resampling</source>
        <translation>Tastet neu ab</translation>
    </message>
    <message>
        <source>Sampling faces</source>
        <translation>Tastet Flächen ab</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattiert</translation>
    </message>
    <message>
        <source>Shaping</source>
        <translation>Formt</translation>
    </message>
    <message>
        <source>Sharpening</source>
        <translation>Schärft</translation>
    </message>
    <message>
        <source>Sharpening edges</source>
        <translation>Schärft Kanten</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättet</translation>
    </message>
    <message>
        <source>Sorting points</source>
        <translation>Sortiert Punkte</translation>
    </message>
    <message>
        <source>Spreading</source>
        <translation>Verteilt</translation>
    </message>
    <message>
        <source>Straightening a way</source>
        <translation>Begradigt einen Weg</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Strich</translation>
    </message>
    <message>
        <source>Taking noise out</source>
        <translation>Entfernt Rauschen</translation>
    </message>
    <message>
        <source>Telling inside from outside</source>
        <translation>Unterscheidet innen und außen</translation>
    </message>
    <message>
        <source>Thinning</source>
        <translation>Dünnt aus</translation>
    </message>
    <message>
        <source>Touching</source>
        <translation>Tastet</translation>
    </message>
    <message>
        <source>Triangulating</source>
        <translation>Vernetzt</translation>
    </message>
    <message>
        <source>Unpacking</source>
        <translation>Entpackt</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Prüft nach</translation>
    </message>
    <message>
        <source>Walking</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Welding</source>
        <translation>Verschweißt</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreibt</translation>
    </message>
    <message>
        <source>Writing the image</source>
        <translation>Schreibt das Bild</translation>
    </message>
    <message>
        <source>casting ambient occlusion</source>
        <translation>wirft Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>casting rays</source>
        <translation>wirft Strahlen</translation>
    </message>
    <message>
        <source>casting shadows</source>
        <translation>wirft Schatten</translation>
    </message>
    <message>
        <source>cutting cubes</source>
        <translation>schneidet Würfel</translation>
    </message>
    <message>
        <source>filling cubes</source>
        <translation>füllt Würfel</translation>
    </message>
    <message>
        <source>finding creases</source>
        <translation>findet Falze</translation>
    </message>
    <message>
        <source>finding where light falls</source>
        <translation>findet, wohin Licht fällt</translation>
    </message>
    <message>
        <source>following light</source>
        <translation>verfolgt Licht</translation>
    </message>
    <message>
        <source>indexing</source>
        <translation>ordnet</translation>
    </message>
    <message>
        <source>joining cubes</source>
        <translation>verbindet Würfel</translation>
    </message>
    <message>
        <source>looking for parts</source>
        <translation>sucht Teile</translation>
    </message>
    <message>
        <source>looking for the model</source>
        <translation>sucht das Modell</translation>
    </message>
    <message>
        <source>orienting triangles</source>
        <translation>orientiert Dreiecke</translation>
    </message>
    <message>
        <source>shaping triangles</source>
        <translation>formt Dreiecke</translation>
    </message>
    <message>
        <source>shaping triangles beside creases</source>
        <translation>formt Dreiecke neben Falzen</translation>
    </message>
    <message>
        <source>smoothing edges</source>
        <translation>glättet Kanten</translation>
    </message>
    <message>
        <source>tracing boundaries</source>
        <translation>verfolgt Ränder</translation>
    </message>
    <message>
        <source>untangling triangles</source>
        <translation>entwirrt Dreiecke</translation>
    </message>
</context>
<context>
    <name>step</name>
    <message>
        <source>Activate model</source>
        <translation>Modell aktivieren</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Add model</source>
        <translation>Modell hinzufügen</translation>
    </message>
    <message>
        <source>Apply pose</source>
        <translation>Lage anwenden</translation>
    </message>
    <message>
        <source>Blob</source>
        <translation>Klumpen</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Clay Strips</source>
        <translation>Tonstreifen</translation>
    </message>
    <message>
        <source>Clone</source>
        <translation>Klonen</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>Falz</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Draw Sharp</source>
        <translation>Scharf zeichnen</translation>
    </message>
    <message>
        <source>Duplicate model</source>
        <translation>Modell duplizieren</translation>
    </message>
    <message>
        <source>Elastic Grab</source>
        <translation>Elastisch greifen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Find creases</source>
        <translation>Falze suchen</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Abflachen</translation>
    </message>
    <message>
        <source>Grab</source>
        <translation>Greifen</translation>
    </message>
    <message>
        <source>Inflate</source>
        <translation>Aufblasen</translation>
    </message>
    <message>
        <source>Join models</source>
        <translation>Modelle verbinden</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Mask layer</source>
        <translation>Ebene maskieren</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>Morphen</translation>
    </message>
    <message>
        <source>Nudge</source>
        <translation>Schubsen</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Kneifen</translation>
    </message>
    <message>
        <source>Relax</source>
        <translation>Entspannen</translation>
    </message>
    <message>
        <source>Remove model</source>
        <translation>Modell entfernen</translation>
    </message>
    <message>
        <source>Rename model</source>
        <translation>Modell umbenennen</translation>
    </message>
    <message>
        <source>Scrape</source>
        <translation>Schaben</translation>
    </message>
    <message>
        <source>Smear</source>
        <translation>Verschmieren</translation>
    </message>
    <message>
        <source>Smooth creases</source>
        <translation>Falze glätten</translation>
    </message>
    <message>
        <source>Snake Hook</source>
        <translation>Schlangenhaken</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Aufteilen</translation>
    </message>
    <message>
        <source>Split off</source>
        <translation>Abspalten</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehen</translation>
    </message>
</context>
<context>
    <name>tool</name>
    <message>
        <source>Blob</source>
        <translation>Klumpen</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Clay Strips</source>
        <translation>Tonstreifen</translation>
    </message>
    <message>
        <source>Clone</source>
        <translation>Klonen</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>Falz</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Draw Sharp</source>
        <translation>Scharf zeichnen</translation>
    </message>
    <message>
        <source>Elastic Grab</source>
        <translation>Elastisch greifen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Abflachen</translation>
    </message>
    <message>
        <source>Grab</source>
        <translation>Greifen</translation>
    </message>
    <message>
        <source>Inflate</source>
        <translation>Aufblasen</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>Morphen</translation>
    </message>
    <message>
        <source>Nudge</source>
        <translation>Schubsen</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Kneifen</translation>
    </message>
    <message>
        <source>Relax</source>
        <translation>Entspannen</translation>
    </message>
    <message>
        <source>Scrape</source>
        <translation>Schaben</translation>
    </message>
    <message>
        <source>Smear</source>
        <translation>Verschmieren</translation>
    </message>
    <message>
        <source>Snake Hook</source>
        <translation>Schlangenhaken</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehen</translation>
    </message>
</context>
<context>
    <name>ui::LayerBar</name>
    <message>
        <source>Add</source>
        <translation>Neue Ebene</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Vereinen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
</context>
<context>
    <name>ui::SelectBar</name>
    <message>
        <source>Grow</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Weniger</translation>
    </message>
</context>
<context>
    <name>view</name>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
</context>
</TS>
