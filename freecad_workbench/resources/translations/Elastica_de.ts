<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
 <name>Elastica</name>
 <message><source>Select a sketch with a spline, or an edge of an object, first.</source><translation>Bitte zuerst eine Skizze mit einem Spline oder eine Kante auswählen.</translation></message>
 <message><source>Select a strip first.</source><translation>Bitte zuerst einen Streifen auswählen.</translation></message>
 <message><source>Select two strips or more first.</source><translation>Bitte zuerst zwei oder mehr Streifen auswählen.</translation></message>
 <message><source>Download and install into FreeCAD's own folder?</source><translation>Herunterladen und in FreeCADs eigenen Ordner installieren?</translation></message>
 <message><source>All optional libraries are installed.</source><translation>Alle optionalen Bibliotheken sind installiert.</translation></message>
 <message><source>Select a sketch with a spline first.</source><translation>Bitte zuerst eine Skizze mit einem Spline auswählen.</translation></message>
 <message><source>The nearest curve is</source><translation>Die nächste Kurve ist</translation></message>
 <message><source>away</source><translation>entfernt</translation></message>
 <message><source>stays</source><translation>bleibt</translation></message>
 <message><source>does not stay</source><translation>bleibt nicht</translation></message>
 <message><source>bent further</source><translation>weiter gebogen</translation></message>
 <message><source>largest move</source><translation>größte Verschiebung</translation></message>
 <message><source>margin</source><translation>Reserve</translation></message>
 <message><source>Save the coupon</source><translation>Probestreifen speichern</translation></message>
 <message><source>type the readings first: overhang = droop, in mm, such as 120 = 14.5, 150 = 31</source><translation>zuerst Messwerte eingeben: Überhang = Durchhang in mm, etwa 120 = 14.5, 150 = 31</translation></message>
 <message><source>Longest overhang of the coupon</source><translation>Größter Überhang des Probestreifens</translation></message>
 <message><source>wrote</source><translation>geschrieben:</translation></message>
 <message><source>kept as</source><translation>behalten als</translation></message>
 <message><source>Folder for the files</source><translation>Ordner für die Dateien</translation></message>
 <message><source>choose a folder for the files</source><translation>bitte einen Ordner für die Dateien wählen</translation></message>
 <message><source>tick what is to be made</source><translation>bitte ankreuzen, was erzeugt werden soll</translation></message>
 <message><source>Joints</source><translation>Verbindungen</translation></message>
 <message><source>no curve was found: change the limits</source><translation>keine Kurve gefunden: Grenzen ändern</translation></message>
 <message><source>Largest distance</source><translation>Größter Abstand</translation></message>
 <message><source>nearest</source><translation>nächste</translation></message>
 <message><source>Held away by</source><translation>Abgehalten durch</translation></message>
 <message><source>Built-in sheets stay: keep yours under another name.</source><translation>Eingebaute Platten bleiben: Ihre bitte unter anderem Namen behalten.</translation></message>
 <message><source>least radius</source><translation>kleinster Radius</translation></message>
 <message><source>elasto-gravity length</source><translation>elasto-gravitative Länge</translation></message>
 <message><source>Length</source><translation>Länge</translation></message>
 <message><source>Narrowest place</source><translation>Schmalste Stelle</translation></message>
 <message><source>Stiffness ratio</source><translation>Steifigkeitsverhältnis</translation></message>
 <message><source>Largest strain</source><translation>Größte Dehnung</translation></message>
 <message><source>Stability margin</source><translation>Stabilitätsreserve</translation></message>
 <message><source>Mass</source><translation>Masse</translation></message>
 <message><source>Ranges are those of the sheet.</source><translation>Die Bereiche sind die der Platte.</translation></message>
 <message><source>deviation</source><translation>Abweichung</translation></message>
 <message><source>worst</source><translation>größte</translation></message>
 <message><source>Stopped.</source><translation>Angehalten.</translation></message>
 <message><source>Bending varied strips</source><translation>Abgewandelte Streifen werden gebogen</translation></message>
 <message><source>stiffness range</source><translation>Steifigkeit</translation></message>
 <message><source>weight</source><translation>Gewicht</translation></message>
 <message><source>end angles</source><translation>Endwinkel</translation></message>
 <message><source>plasticity</source><translation>Plastizität</translation></message>
 <message><source>thickness</source><translation>Dicke</translation></message>
 <message><source>kerf</source><translation>Schnittfuge</translation></message>
 <message><source>combined</source><translation>zusammen</translation></message>
 <message><source>writes DXF files</source><translation>schreibt DXF-Dateien</translation></message>
 <message><source>finds the best widths faster</source><translation>findet die besten Breiten schneller</translation></message>
 <message><source>Cutting</source><translation>Schneide</translation></message>
 <message><source>Making curves</source><translation>Erzeuge Kurven</translation></message>
 <message><source>Open lines</source><translation>Offene Linien</translation></message>
 <message><source>Closed ones</source><translation>Geschlossene</translation></message>
 <message><source>the planes miss the object</source><translation>die Ebenen treffen das Objekt nicht</translation></message>
 <message><source>Cancel</source><translation>Abbrechen</translation></message>
 <message><source>Constraints on the drawn curve that OK takes away</source><translation>Bedingungen an der gezeichneten Kurve, die mit OK entfallen</translation></message>
 <message><source>Move or turn an end: type numbers, or drag one of the handles in the view.</source><translation>Ein Ende verschieben oder drehen: Zahlen eingeben oder an einem der Griffe in der Ansicht ziehen.</translation></message>
 <message><source>Making the blocks</source><translation>Erzeuge die Blöcke</translation></message>
 <message><source>Putting the model together</source><translation>Setze das Modell zusammen</translation></message>
 <message><source>Cutting the mesh</source><translation>Schneide das Netz</translation></message>
 <message><source>Bending the strip</source><translation>Biege den Streifen</translation></message>
 <message><source>Searching the nearest curve</source><translation>Suche die nächste Kurve</translation></message>
 <message><source>what this panel works on was deleted: press Cancel</source><translation>was dieses Bedienfeld bearbeitet, wurde gelöscht: Abbrechen drücken</translation></message>
 <message><source>the path was deleted: choose another one</source><translation>der Pfad wurde gelöscht: einen anderen wählen</translation></message>
 <message><source>Writing files</source><translation>Schreibe Dateien</translation></message>
 <message><source>tick the box for it</source><translation>das Kästchen dafür ankreuzen</translation></message>
</context>
<context>
 <name>ElasticaBend</name>
 <message><source>Bend forward</source><translation>Weiter biegen</translation></message>
 <message><source>Start of the strip</source><translation>Anfang des Streifens</translation></message>
 <message><source>Move x</source><translation>Verschiebung x</translation></message>
 <message><source>Move y</source><translation>Verschiebung y</translation></message>
 <message><source>Turn</source><translation>Drehung</translation></message>
 <message><source>End of the strip</source><translation>Ende des Streifens</translation></message>
 <message><source>Play</source><translation>Abspielen</translation></message>
</context>
<context>
 <name>ElasticaCheck</name>
 <message><source>Check curve</source><translation>Kurve prüfen</translation></message>
</context>
<context>
 <name>ElasticaCoupon</name>
 <message><source>Coupon and calibrate</source><translation>Probestreifen und Eichung</translation></message>
 <message><source>Coupon</source><translation>Probestreifen</translation></message>
 <message><source>Sheet</source><translation>Platte</translation></message>
 <message><source>Make the coupon</source><translation>Probestreifen erzeugen</translation></message>
 <message><source>Write its cutting file</source><translation>Schneiddatei schreiben</translation></message>
 <message><source>Readings</source><translation>Messwerte</translation></message>
 <message><source>Overhang = droop, mm</source><translation>Überhang = Durchhang, mm</translation></message>
 <message><source>120 = 14.5, 150 = 31</source><translation>120 = 14.5, 150 = 31</translation></message>
 <message><source>Reading error</source><translation>Ablesefehler</translation></message>
 <message><source>Name of the sheet</source><translation>Name der Platte</translation></message>
 <message><source>Keep the sheet</source><translation>Platte behalten</translation></message>
</context>
<context>
 <name>ElasticaExport</name>
 <message><source>Export cutting files</source><translation>Schneiddateien exportieren</translation></message>
 <message><source>Files</source><translation>Dateien</translation></message>
 <message><source>DXF</source><translation>DXF</translation></message>
 <message><source>SVG</source><translation>SVG</translation></message>
 <message><source>STEP, flat and bent</source><translation>STEP, flach und gebogen</translation></message>
 <message><source>Cut list (CSV)</source><translation>Stückliste (CSV)</translation></message>
 <message><source>Nest on sheets</source><translation>Auf Platten schachteln</translation></message>
 <message><source>Sheet width</source><translation>Plattenbreite</translation></message>
 <message><source>Sheet height</source><translation>Plattenhöhe</translation></message>
 <message><source>How</source><translation>Wie</translation></message>
 <message><source>Curves</source><translation>Kurven</translation></message>
 <message><source>DXF version</source><translation>DXF-Version</translation></message>
 <message><source>Kerf</source><translation>Schnittfuge</translation></message>
 <message><source>Tolerance of arcs and polylines</source><translation>Toleranz von Bögen und Polylinien</translation></message>
 <message><source>Where</source><translation>Wohin</translation></message>
 <message><source>Folder</source><translation>Ordner</translation></message>
 <message><source>Browse...</source><translation>Durchsuchen ...</translation></message>
 <message><source>Overwrite files that exist</source><translation>Vorhandene Dateien überschreiben</translation></message>
</context>
<context>
 <name>ElasticaFixtures</name>
 <message><source>End fixtures and base plate</source><translation>Endhalter und Grundplatte</translation></message>
 <message><source>Printed blocks</source><translation>Gedruckte Halter</translation></message>
 <message><source>Make blocks for the ends</source><translation>Halter für die Enden erzeugen</translation></message>
 <message><source>Room around the tab</source><translation>Spiel um die Lasche</translation></message>
 <message><source>Wall</source><translation>Wand</translation></message>
 <message><source>Foot</source><translation>Fuß</translation></message>
 <message><source>Screw holes</source><translation>Schraubenlöcher</translation></message>
 <message><source>Base plate</source><translation>Grundplatte</translation></message>
 <message><source>Make a slotted plate</source><translation>Geschlitzte Platte erzeugen</translation></message>
 <message><source>Sheet</source><translation>Platte</translation></message>
 <message><source>Height of its upper face</source><translation>Höhe der Oberseite</translation></message>
 <message><source>Room beside the tab</source><translation>Spiel neben der Lasche</translation></message>
 <message><source>Clearance of slots</source><translation>Spiel der Schlitze</translation></message>
 <message><source>Border</source><translation>Rand</translation></message>
</context>
<context>
 <name>ElasticaModel</name>
 <message><source>Interlock strips</source><translation>Streifen verzahnen</translation></message>
 <message><source>Slots</source><translation>Schlitze</translation></message>
 <message><source>Cut slots where strips cross</source><translation>Schlitze, wo Streifen sich kreuzen</translation></message>
 <message><source>Clearance</source><translation>Spiel</translation></message>
 <message><source>Width</source><translation>Breite</translation></message>
 <message><source>Inner ends</source><translation>Innere Enden</translation></message>
</context>
<context>
 <name>ElasticaNearest</name>
 <message><source>Nearest curve</source><translation>Nächste Kurve</translation></message>
 <message><source>Limits</source><translation>Grenzen</translation></message>
 <message><source>Sheet</source><translation>Platte</translation></message>
 <message><source>Largest stiffness ratio</source><translation>Größtes Steifigkeitsverhältnis</translation></message>
 <message><source>Must stay by itself</source><translation>Muss von selbst stehen bleiben</translation></message>
 <message><source>Least stability margin</source><translation>Kleinste Stabilitätsreserve</translation></message>
 <message><source>Keep within the sheet's strain</source><translation>Dehnung der Platte einhalten</translation></message>
 <message><source>Keep</source><translation>Beibehalten</translation></message>
 <message><source>End points</source><translation>Endpunkte</translation></message>
 <message><source>End tangents</source><translation>Endtangenten</translation></message>
 <message><source>Length</source><translation>Länge</translation></message>
 <message><source>Replace the spline in the sketch</source><translation>Spline in der Skizze ersetzen</translation></message>
</context>
<context>
 <name>ElasticaPreferences</name>
 <message><source>General</source><translation>Allgemein</translation></message>
 <message><source>New strips</source><translation>Neue Streifen</translation></message>
 <message><source>Sheet</source><translation>Platte</translation></message>
 <message><source>Largest width</source><translation>Größte Breite</translation></message>
 <message><source>Tab length</source><translation>Laschenlänge</translation></message>
 <message><source>Cutting files</source><translation>Schneiddateien</translation></message>
 <message><source>Kerf</source><translation>Schnittfuge</translation></message>
 <message><source>Clearance of slots</source><translation>Spiel der Schlitze</translation></message>
 <message><source>DXF version</source><translation>DXF-Version</translation></message>
 <message><source>Curves</source><translation>Kurven</translation></message>
 <message><source>Tolerance of arcs and polylines</source><translation>Toleranz von Bögen und Polylinien</translation></message>
 <message><source>While a sketch is edited</source><translation>Beim Bearbeiten einer Skizze</translation></message>
 <message><source>Show curvature, inflections and their line</source><translation>Krümmung, Wendepunkte und ihre Gerade zeigen</translation></message>
 <message><source>Show the nearest curve that can be bent</source><translation>Die nächste biegbare Kurve zeigen</translation></message>
 <message><source>Lengths</source><translation>Längen</translation></message>
 <message><source>Shown in</source><translation>Angezeigt in</translation></message>
 <message><source>Unit of all lengths in panels, sentences and the sketch's overlay; files are always in mm</source><translation>Einheit aller Längen in Bedienfeldern, Sätzen und der Anzeige über der Skizze; Dateien sind immer in mm</translation></message>
 <message><source>as FreeCAD</source><translation>wie FreeCAD</translation></message>
 <message><source>inch</source><translation>Zoll</translation></message>
</context>
<context>
 <name>ElasticaSection</name>
 <message><source>Section into curves</source><translation>In Kurven schneiden</translation></message>
 <message><source>Planes</source><translation>Ebenen</translation></message>
 <message><source>Tolerance of the curves</source><translation>Toleranz der Kurven</translation></message>
 <message><source>Family</source><translation>Art</translation></message>
 <message><source>parallel</source><translation>parallel</translation></message>
 <message><source>about an axis</source><translation>um eine Achse</translation></message>
 <message><source>along a path</source><translation>entlang eines Pfads</translation></message>
 <message><source>Across</source><translation>Quer zu</translation></message>
 <message><source>Path</source><translation>Pfad</translation></message>
 <message><source>Number of planes</source><translation>Anzahl der Ebenen</translation></message>
 <message><source>Axis through x</source><translation>Achse durch x</translation></message>
 <message><source>y</source><translation>y</translation></message>
 <message><source>z</source><translation>z</translation></message>
 <message><source>Sweep</source><translation>Winkelbereich</translation></message>
 <message><source>Curves</source><translation>Kurven</translation></message>
 <message><source>Closed sections</source><translation>Geschlossene Schnitte</translation></message>
 <message><source>are left out</source><translation>weglassen</translation></message>
 <message><source>are split left and right</source><translation>links und rechts teilen</translation></message>
 <message><source>are split above and below</source><translation>oben und unten teilen</translation></message>
 <message><source>Take out waves shorter than</source><translation>Wellen glätten, die kürzer sind als</translation></message>
</context>
<context>
 <name>ElasticaSheets</name>
 <message><source>Sheet library</source><translation>Plattenbibliothek</translation></message>
 <message><source>Sheet</source><translation>Platte</translation></message>
 <message><source>Name</source><translation>Name</translation></message>
 <message><source>Thickness</source><translation>Dicke</translation></message>
 <message><source>Young's modulus</source><translation>Elastizitätsmodul</translation></message>
 <message><source>Density</source><translation>Dichte</translation></message>
 <message><source>Largest strain</source><translation>Größte Dehnung</translation></message>
 <message><source>Kerf</source><translation>Schnittfuge</translation></message>
 <message><source>Poisson's ratio</source><translation>Querdehnzahl</translation></message>
 <message><source>Source</source><translation>Quelle</translation></message>
 <message><source>Keep as my sheet</source><translation>Als meine Platte behalten</translation></message>
 <message><source>Remove my sheet</source><translation>Meine Platte entfernen</translation></message>
</context>
<context>
 <name>ElasticaStrip</name>
 <message><source>Strip</source><translation>Streifen</translation></message>
 <message><source>Sheet and width</source><translation>Platte und Breite</translation></message>
 <message><source>Sheet</source><translation>Platte</translation></message>
 <message><source>Thickness</source><translation>Dicke</translation></message>
 <message><source>Largest width</source><translation>Größte Breite</translation></message>
 <message><source>Least width</source><translation>Kleinste Breite</translation></message>
 <message><source>Mechanics</source><translation>Mechanik</translation></message>
 <message><source>Start</source><translation>Anfang</translation></message>
 <message><source>End</source><translation>Ende</translation></message>
 <message><source>Carries its own weight</source><translation>Trägt sein Eigengewicht</translation></message>
 <message><source>Style</source><translation>Bauart</translation></message>
 <message><source>Outer width</source><translation>Außenbreite</translation></message>
 <message><source>Holes side by side</source><translation>Löcher nebeneinander</translation></message>
 <message><source>Rows of holes (0: chosen)</source><translation>Lochreihen (0: gewählt)</translation></message>
 <message><source>Backing</source><translation>Rückseite</translation></message>
 <message><source>Nearest curve</source><translation>Nächste Kurve</translation></message>
 <message><source>Follow</source><translation>Folgt</translation></message>
 <message><source>Largest stiffness ratio</source><translation>Größtes Steifigkeitsverhältnis</translation></message>
 <message><source>Least stability margin</source><translation>Kleinste Stabilitätsreserve</translation></message>
 <message><source>Largest strain, % (0: the sheet's)</source><translation>Größte Dehnung, % (0: die der Platte)</translation></message>
 <message><source>Keep the end tangents</source><translation>Endtangenten beibehalten</translation></message>
 <message><source>Keep the length</source><translation>Länge beibehalten</translation></message>
 <message><source>Ends and text</source><translation>Enden und Text</translation></message>
 <message><source>Tab at the start</source><translation>Lasche am Anfang</translation></message>
 <message><source>Tab at the end</source><translation>Lasche am Ende</translation></message>
 <message><source>Corner radius</source><translation>Eckenradius</translation></message>
 <message><source>Hole in the tabs</source><translation>Loch in den Laschen</translation></message>
 <message><source>Engraved text</source><translation>Gravierter Text</translation></message>
 <message><source>Quantity</source><translation>Anzahl</translation></message>
 <message><source>Shape</source><translation>Gestalt</translation></message>
</context>
<context>
 <name>ElasticaTolerance</name>
 <message><source>Tolerance study</source><translation>Toleranzstudie</translation></message>
 <message><source>Study</source><translation>Studie</translation></message>
 <message><source>Bends for each cause</source><translation>Biegungen je Ursache</translation></message>
 <message><source>Run</source><translation>Starten</translation></message>
</context>
<context>
 <name>Elastica_Bend</name>
 <message><source>Bend forward</source><translation>Weiter biegen</translation></message>
 <message><source>Move or turn the ends of the selected strip and watch it take its new rest shape</source><translation>Enden des gewählten Streifens bewegen oder drehen und zusehen, wie er seine neue Ruhelage einnimmt</translation></message>
</context>
<context>
 <name>Elastica_Check</name>
 <message><source>Check curve</source><translation>Kurve prüfen</translation></message>
 <message><source>Say whether a flat strip can take the selected curve, and if not why and where</source><translation>Sagt, ob ein flacher Streifen die gewählte Kurve annehmen kann, und wenn nicht, warum und wo</translation></message>
</context>
<context>
 <name>Elastica_Coupon</name>
 <message><source>Coupon and calibrate</source><translation>Probestreifen und Eichung</translation></message>
 <message><source>Make a test strip to hang over an edge, and turn its measured droop into a sheet of your own</source><translation>Einen Probestreifen erzeugen, über eine Kante hängen und aus dem gemessenen Durchhang eine eigene Platte machen</translation></message>
</context>
<context>
 <name>Elastica_Export</name>
 <message><source>Export cutting files</source><translation>Schneiddateien exportieren</translation></message>
 <message><source>Write DXF, SVG and STEP files, nest and cut list of the selected strips, models and base plates</source><translation>DXF-, SVG- und STEP-Dateien, Schachtelung und Stückliste der gewählten Streifen, Modelle und Grundplatten schreiben</translation></message>
</context>
<context>
 <name>Elastica_Fixtures</name>
 <message><source>End fixtures and base plate</source><translation>Endhalter und Grundplatte</translation></message>
 <message><source>Make printed blocks that hold the ends of the selected strips or model, or one slotted base plate</source><translation>Gedruckte Halter für die Enden der gewählten Streifen oder des Modells erzeugen, oder eine geschlitzte Grundplatte</translation></message>
</context>
<context>
 <name>Elastica_Interlock</name>
 <message><source>Interlock selected strips</source><translation>Gewählte Streifen verzahnen</translation></message>
 <message><source>Put the selected strips together to a model and cut slots where they cross</source><translation>Die gewählten Streifen zu einem Modell verbinden und Schlitze schneiden, wo sie sich kreuzen</translation></message>
</context>
<context>
 <name>Elastica_Laminate</name>
 <message><source>Laminate</source><translation>Laminieren</translation></message>
 <message><source>Give the selected strips an even width and glue narrower strips on that make them stiff enough</source><translation>Den gewählten Streifen eine gleichmäßige Breite geben und schmalere aufkleben, die sie steif genug machen</translation></message>
</context>
<context>
 <name>Elastica_Libraries</name>
 <message><source>Install missing libraries</source><translation>Fehlende Bibliotheken installieren</translation></message>
 <message><source>Install the optional libraries that FreeCAD does not bring: ezdxf (DXF files), highspy (faster)</source><translation>Die Bibliotheken installieren, die FreeCAD nicht mitbringt: ezdxf (DXF-Dateien), highspy (schneller)</translation></message>
</context>
<context>
 <name>Elastica_Nearest</name>
 <message><source>Nearest curve to sketch</source><translation>Nächste Kurve zur Skizze</translation></message>
 <message><source>Find the curve nearest to the selected sketch that can be bent within limits</source><translation>Die der Skizze nächste Kurve finden, die sich innerhalb der Grenzen biegen lässt</translation></message>
</context>
<context>
 <name>Elastica_Nest</name>
 <message><source>Nest on sheets</source><translation>Auf Platten schachteln</translation></message>
 <message><source>Lay everything that must be cut for the selected strips, models and base plates on sheets</source><translation>Alles, was für die gewählten Streifen, Modelle und Grundplatten zu schneiden ist, auf Platten legen</translation></message>
</context>
<context>
 <name>Elastica_Perforate</name>
 <message><source>Perforate</source><translation>Lochen</translation></message>
 <message><source>Give the selected strips an even width and let holes make them as soft as they must be</source><translation>Den gewählten Streifen eine gleichmäßige Breite geben und sie durch Löcher so weich machen wie nötig</translation></message>
</context>
<context>
 <name>Elastica_Section</name>
 <message><source>Section into curves</source><translation>In Kurven schneiden</translation></message>
 <message><source>Cut the selected body, surface or mesh by planes into smooth curves that strips can follow</source><translation>Schneidet den gewählten Körper, die Fläche oder das Netz mit Ebenen in glatte Kurven, denen Streifen folgen können</translation></message>
</context>
<context>
 <name>Elastica_Sheets</name>
 <message><source>Sheet library</source><translation>Plattenbibliothek</translation></message>
 <message><source>Look at the sheets that are known, with their sources, and keep your own</source><translation>Bekannte Platten mit ihren Quellen ansehen und eigene behalten</translation></message>
</context>
<context>
 <name>Elastica_Strip</name>
 <message><source>Strip from sketch</source><translation>Streifen aus Skizze</translation></message>
 <message><source>Make the flat strip that bends into the selected spline: the bent part and, linked to it, the flat one</source><translation>Den flachen Streifen erzeugen, der sich in den gewählten Spline biegt: das gebogene Teil und, damit verknüpft, das flache</translation></message>
</context>
<context>
 <name>Elastica_Tolerance</name>
 <message><source>Tolerance study</source><translation>Toleranzstudie</translation></message>
 <message><source>Find how far the bent strip strays when sheet, cut and clamps vary within their ranges</source><translation>Ermitteln, wie weit der gebogene Streifen abweicht, wenn Platte, Schnitt und Klemmen in ihren Bereichen schwanken</translation></message>
</context>
<context>
 <name>Elastica_Projective</name>
 <message><source>Projective edit</source><translation>Projektiv bearbeiten</translation></message>
 <message><source>Pull the selected sketch's curve by four handles: lines stay lines, a curve that can be bent stays one</source><translation>Zieht die Kurve der gewählten Skizze an vier Griffen: Geraden bleiben gerade, eine biegbare Kurve bleibt biegbar</translation></message>
</context>
<context>
 <name>ElasticaProjective</name>
 <message><source>Projective edit</source><translation>Projektiv bearbeiten</translation></message>
 <message><source>Put the handles back</source><translation>Griffe zurücksetzen</translation></message>
 <message><source>Handles (x, y)</source><translation>Griffe (x, y)</translation></message>
 <message><source>1, lower left</source><translation>1, unten links</translation></message>
 <message><source>2, lower right</source><translation>2, unten rechts</translation></message>
 <message><source>3, upper right</source><translation>3, oben rechts</translation></message>
 <message><source>4, upper left</source><translation>4, oben links</translation></message>
</context>
</TS>
