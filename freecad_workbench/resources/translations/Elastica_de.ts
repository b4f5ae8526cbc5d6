<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Largest distance by which smoothing may move the curve; 0 removes only steps and corners, within 0.1 mm</source>
        <translation>Größter Abstand, um den das Glätten die Kurve bewegen darf; 0 entfernt nur Stufen und Ecken, innerhalb von 0,1 mm</translation>
    </message>
    <message>
        <source>Stop dragged poles where the strip can be made</source>
        <translation>Gezogene Pole dort anhalten, wo der Streifen machbar ist</translation>
    </message>
    <message>
        <source>Expected deviation of a real strip from its design, due to the model, its uncertainty and the sheet</source>
        <translation>Erwartete Abweichung eines wirklichen Streifens von seinem Entwurf, durch Modell, dessen Unsicherheit und Platte</translation>
    </message>
    <message>
        <source>Deviation of the strip as made and held, with its causes</source>
        <translation>Abweichung des Streifens, wie er gemacht und gehalten ist, mit ihren Ursachen</translation>
    </message>
    <message>
        <source>Largest deviation of the strip, as made and held, from its design</source>
        <translation>Größte Abweichung des Streifens, wie er gemacht und gehalten ist, von seinem Entwurf</translation>
    </message>
    <message>
        <source>The strips, in the order of assembly</source>
        <translation>Die Streifen in der Reihenfolge des Zusammenbaus</translation>
    </message>
    <message>
        <source>Later features that the cut parts do not contain</source>
        <translation>Spätere Formelemente, die in den Schnittteilen fehlen</translation>
    </message>
    <message>
        <source>Cut slots where strips cross</source>
        <translation>Schlitze, wo Streifen sich kreuzen</translation>
    </message>
    <message>
        <source>Direction from which later strips are pushed on; zero for any direction</source>
        <translation>Richtung, aus der spätere Streifen aufgeschoben werden; null für beliebig</translation>
    </message>
    <message>
        <source>Number of joints of two slots</source>
        <translation>Anzahl der Verbindungen aus zwei Schlitzen</translation>
    </message>
    <message>
        <source>Messages of the last recompute</source>
        <translation>Meldungen der letzten Berechnung</translation>
    </message>
    <message>
        <source>Collisions of strips outside their slots, known a moment after the other results</source>
        <translation>Kollisionen von Streifen außerhalb ihrer Schlitze, kurz nach den anderen Ergebnissen bekannt</translation>
    </message>
    <message>
        <source>Strip of this flat part</source>
        <translation>Streifen dieses flachen Teils</translation>
    </message>
    <message>
        <source>Layer of a laminated strip: base or backing</source>
        <translation>Schicht eines laminierten Streifens: Grundschicht oder Verstärkung</translation>
    </message>
    <message>
        <source>Model whose slots the part gets; none for a single strip</source>
        <translation>Modell, dessen Schlitze das Teil erhält; keines für einen einzelnen Streifen</translation>
    </message>
    <message>
        <source>Sketch, or edges of an object, that the strip follows</source>
        <translation>Skizze oder Kanten eines Objekts, denen der Streifen folgt</translation>
    </message>
    <message>
        <source>Shape of the feature: the strip as bent or as cut</source>
        <translation>Form des Elements: der Streifen gebogen oder wie geschnitten</translation>
    </message>
    <message>
        <source>Material the strip is cut from</source>
        <translation>Material, aus dem der Streifen geschnitten wird</translation>
    </message>
    <message>
        <source>Full name of the sheet</source>
        <translation>Voller Name der Platte</translation>
    </message>
    <message>
        <source>Thickness of the sheet; measure yours</source>
        <translation>Dicke der Platte; messen Sie Ihre</translation>
    </message>
    <message>
        <source>Data of the sheet, so that the file opens on every computer</source>
        <translation>Daten der Platte, damit die Datei auf jedem Rechner lesbar ist</translation>
    </message>
    <message>
        <source>Compensate anticlastic bending in the widths if the sheet's Poisson ratio is known</source>
        <translation>Querkrümmung durch die Breiten ausgleichen, wenn die Querdehnzahl der Platte bekannt ist</translation>
    </message>
    <message>
        <source>Compensate slots, narrow tabs and holes in the widths</source>
        <translation>Schlitze, schmale Laschen und Löcher durch die Breiten ausgleichen</translation>
    </message>
    <message>
        <source>Largest total width of ligaments or backing; 0 for the largest that fits</source>
        <translation>Größte Gesamtbreite von Stegen oder Verstärkung; 0 für die größte passende</translation>
    </message>
    <message>
        <source>Style: plain, perforated or laminated</source>
        <translation>Bauart: schlicht, gelocht oder laminiert</translation>
    </message>
    <message>
        <source>Sheet of the backing of a laminated strip</source>
        <translation>Platte der Verstärkung eines laminierten Streifens</translation>
    </message>
    <message>
        <source>Data of the backing's sheet</source>
        <translation>Daten der Platte der Verstärkung</translation>
    </message>
    <message>
        <source>Support at the start of the curve</source>
        <translation>Lager am Anfang der Kurve</translation>
    </message>
    <message>
        <source>Support at the end of the curve</source>
        <translation>Lager am Ende der Kurve</translation>
    </message>
    <message>
        <source>Include the strip's own weight</source>
        <translation>Eigengewicht des Streifens berücksichtigen</translation>
    </message>
    <message>
        <source>Direction of gravity in space</source>
        <translation>Richtung der Schwerkraft im Raum</translation>
    </message>
    <message>
        <source>Elasto-gravity length; 0 for the value of the sheet</source>
        <translation>Elasto-Gravitationslänge; 0 für den Wert der Platte</translation>
    </message>
    <message>
        <source>All weight in newtons: alpha = 0.001, own = true</source>
        <translation>Alles Gewicht in Newton: alpha = 0.001, own = true</translation>
    </message>
    <message>
        <source>Curvature of the strip before bending, 1/mm</source>
        <translation>Krümmung des Streifens vor dem Biegen, 1/mm</translation>
    </message>
    <message>
        <source>Curvature before bending that varies along the strip: stations = [0, 300], curvatures = [0, 0.01]</source>
        <translation>Vorkrümmung, die sich entlang des Streifens ändert: stations = [0, 300], curvatures = [0, 0.01]</translation>
    </message>
    <message>
        <source>Follow the curve exactly, or the nearest one within limits</source>
        <translation>Der Kurve genau folgen oder der nächstgelegenen innerhalb von Grenzen</translation>
    </message>
    <message>
        <source>Least stability margin. A strip is stable above 0, and safely stable from 5.</source>
        <translation>Kleinste Stabilitätsreserve. Über 0 ist ein Streifen stabil, ab 5 sicher stabil.</translation>
    </message>
    <message>
        <source>Largest strain in percent; 0 for the limit of the sheet</source>
        <translation>Größte Dehnung in Prozent; 0 für die Grenze der Platte</translation>
    </message>
    <message>
        <source>Apply the strain limit</source>
        <translation>Dehnungsgrenze anwenden</translation>
    </message>
    <message>
        <source>Largest length; 0 for no limits</source>
        <translation>Größte Länge; 0 für keine Grenzen</translation>
    </message>
    <message>
        <source>Largest width, which bounds the ratio; 0 for none</source>
        <translation>Größte Breite, die das Verhältnis begrenzt; 0 für keine</translation>
    </message>
    <message>
        <source>Ends that keep their position</source>
        <translation>Enden, die ihre Lage behalten</translation>
    </message>
    <message>
        <source>Keep the tangents of both ends</source>
        <translation>Die Tangenten beider Enden behalten</translation>
    </message>
    <message>
        <source>Keep inflections on the curve's inflection line</source>
        <translation>Wendepunkte auf der Wendelinie der Kurve halten</translation>
    </message>
    <message>
        <source>Two points of another line: x, y, x, y</source>
        <translation>Zwei Punkte einer anderen Linie: x, y, x, y</translation>
    </message>
    <message>
        <source>Length of the tab at the start</source>
        <translation>Länge der Lasche am Anfang</translation>
    </message>
    <message>
        <source>Length of the tab at the end</source>
        <translation>Länge der Lasche am Ende</translation>
    </message>
    <message>
        <source>Rounding of the tabs' corners</source>
        <translation>Rundung der Laschenecken</translation>
    </message>
    <message>
        <source>Diameter of a hole in the middle of each tab; 0 for none</source>
        <translation>Durchmesser eines Lochs mitten in jeder Lasche; 0 für keines</translation>
    </message>
    <message>
        <source>The first tab in full: length = 12, chamfer = 2</source>
        <translation>Die erste Lasche ganz: length = 12, chamfer = 2</translation>
    </message>
    <message>
        <source>The last tab in full</source>
        <translation>Die letzte Lasche ganz</translation>
    </message>
    <message>
        <source>Number of copies to cut</source>
        <translation>Anzahl der zu schneidenden Stücke</translation>
    </message>
    <message>
        <source>Verdict on the strip and its curve</source>
        <translation>Urteil über den Streifen und seine Kurve</translation>
    </message>
    <message>
        <source>Reasons and remarks</source>
        <translation>Gründe und Hinweise</translation>
    </message>
    <message>
        <source>Results that make the strip fail</source>
        <translation>Ergebnisse, an denen der Streifen versagt</translation>
    </message>
    <message>
        <source>Largest stiffness over least stiffness</source>
        <translation>Größte durch kleinste Steifigkeit</translation>
    </message>
    <message>
        <source>Stability margin; positive means stable</source>
        <translation>Stabilitätsreserve; positiv heißt stabil</translation>
    </message>
    <message>
        <source>Place along the strip where stability is lost; 0 for a stable strip</source>
        <translation>Stelle entlang des Streifens, an der die Stabilität verloren geht; 0 bei einem stabilen Streifen</translation>
    </message>
    <message>
        <source>Largest strain, in percent of the sheet's limit</source>
        <translation>Größte Dehnung in Prozent der Grenze der Platte</translation>
    </message>
    <message>
        <source>Largest strain of the skin, in percent</source>
        <translation>Größte Dehnung der Außenhaut in Prozent</translation>
    </message>
    <message>
        <source>Largest distance from the drawn curve</source>
        <translation>Größter Abstand von der gezeichneten Kurve</translation>
    </message>
    <message>
        <source>Length of the free part along the curve</source>
        <translation>Länge des freien Teils entlang der Kurve</translation>
    </message>
    <message>
        <source>Width of the narrowest place</source>
        <translation>Breite der schmalsten Stelle</translation>
    </message>
    <message>
        <source>Mass in grams</source>
        <translation>Masse in Gramm</translation>
    </message>
    <message>
        <source>Hidden because its recompute failed</source>
        <translation>Ausgeblendet, weil die Berechnung fehlschlug</translation>
    </message>
    <message>
        <source>Shown because the recompute of its model failed</source>
        <translation>Eingeblendet, weil die Berechnung seines Modells fehlschlug</translation>
    </message>
    <message>
        <source>Identifies the request from which the shape was made</source>
        <translation>Kennung der Anforderung, aus der die Form entstand</translation>
    </message>
    <message>
        <source>Objects with which the curve moves</source>
        <translation>Objekte, mit denen sich die Kurve bewegt</translation>
    </message>
    <message>
        <source>Model or strips whose tabs go through the plate</source>
        <translation>Modell oder Streifen, deren Laschen durch die Platte gehen</translation>
    </message>
    <message>
        <source>Sheet of the plate</source>
        <translation>Material der Platte</translation>
    </message>
    <message>
        <source>Data of the sheet</source>
        <translation>Daten der Platte</translation>
    </message>
    <message>
        <source>Model or strips whose ends are held</source>
        <translation>Modell oder Streifen, deren Enden gehalten werden</translation>
    </message>
    <message>
        <source>Strips, models and base plates to be cut</source>
        <translation>Streifen, Modelle und Grundplatten zum Schneiden</translation>
    </message>
    <message>
        <source>Width of a sheet, along its grain</source>
        <translation>Breite einer Platte, entlang der Faser</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>Höhe einer Platte</translation>
    </message>
    <message>
        <source>Smallest distance between parts, and from the edge</source>
        <translation>Kleinster Abstand zwischen Teilen und vom Rand</translation>
    </message>
    <message>
        <source>Number of sheets</source>
        <translation>Anzahl der Platten</translation>
    </message>
    <message>
        <source>Show live feedback while this sketch is open</source>
        <translation>Sofortige Rückmeldung zeigen, während diese Skizze offen ist</translation>
    </message>
    <message>
        <source>Angle over which half planes are spread</source>
        <translation>Winkel, über den Halbebenen verteilt sind</translation>
    </message>
    <message>
        <source>Bodies, surfaces and meshes that are cut</source>
        <translation>Körper, Flächen und Netze, die geschnitten werden</translation>
    </message>
    <message>
        <source>Largest distance of a curve from the section</source>
        <translation>Größter Abstand einer Kurve vom Schnitt</translation>
    </message>
    <message>
        <source>Largest displacement of the curve</source>
        <translation>Größte Verschiebung der Kurve</translation>
    </message>
    <message>
        <source>Displacement of the end along x</source>
        <translation>Verschiebung des Endes entlang x</translation>
    </message>
    <message>
        <source>Displacement of the end along y</source>
        <translation>Verschiebung des Endes entlang y</translation>
    </message>
    <message>
        <source>Rotation of the end</source>
        <translation>Drehung des Endes</translation>
    </message>
    <message>
        <source>Displacement of the start along x</source>
        <translation>Verschiebung des Anfangs entlang x</translation>
    </message>
    <message>
        <source>Displacement of the start along y</source>
        <translation>Verschiebung des Anfangs entlang y</translation>
    </message>
    <message>
        <source>Rotation of the start</source>
        <translation>Drehung des Anfangs</translation>
    </message>
    <message>
        <source>Number of curves</source>
        <translation>Anzahl der Kurven</translation>
    </message>
    <message>
        <source>Number of planes</source>
        <translation>Anzahl der Ebenen</translation>
    </message>
    <message>
        <source>Arrangement of the planes</source>
        <translation>Anordnung der Ebenen</translation>
    </message>
    <message>
        <source>Sketch, wire or edges perpendicular to the planes</source>
        <translation>Skizze, Draht oder Kanten senkrecht zu den Ebenen</translation>
    </message>
    <message>
        <source>Point on the axis of half planes: x</source>
        <translation>Punkt auf der Achse der Halbebenen: x</translation>
    </message>
    <message>
        <source>Point on the axis of half planes: y</source>
        <translation>Punkt auf der Achse der Halbebenen: y</translation>
    </message>
    <message>
        <source>Point on the axis of half planes: z</source>
        <translation>Punkt auf der Achse der Halbebenen: z</translation>
    </message>
    <message>
        <source>Strip to bend</source>
        <translation>Zu biegender Streifen</translation>
    </message>
    <message>
        <source>Shortest wavelength that is kept; 0 keeps all waves</source>
        <translation>Kürzeste Wellenlänge, die erhalten bleibt; 0 behält alle Wellen</translation>
    </message>
    <message>
        <source>Treatment of closed lines</source>
        <translation>Behandlung geschlossener Linien</translation>
    </message>
    <message>
        <source>Axis perpendicular to the planes, or common to the half planes</source>
        <translation>Achse senkrecht zu den Ebenen oder gemeinsame Achse der Halbebenen</translation>
    </message>
    <message>
        <source>Sideways stability margin; positive means stable, 0 undecided</source>
        <translation>Seitliche Stabilitätsreserve; positiv heißt stabil, 0 offen</translation>
    </message>
    <message>
        <source>Sideways stability</source>
        <translation>Seitliche Stabilität</translation>
    </message>
    <message>
        <source>Model or strips whose tabs go through the rings</source>
        <translation>Modell oder Streifen, deren Laschen durch die Ringe gehen</translation>
    </message>
    <message>
        <source>Sheet of the rings</source>
        <translation>Platte für die Ringe</translation>
    </message>
    <message>
        <source>Ends of the strips that have a ring</source>
        <translation>Enden der Streifen, die einen Ring haben</translation>
    </message>
    <message>
        <source>Distance between two rings that hold inclined tabs at their angle; 0 for one ring at each end</source>
        <translation>Abstand zweier Ringe, die schräge Laschen in ihrem Winkel halten; 0 für einen Ring an jedem Ende</translation>
    </message>
    <message>
        <source>Masses and forces on the strip: at = 90, mass = 3, or at = 90, force = [0, -1] (mm, g, N)</source>
        <translation>Massen und Kräfte am Streifen: at = 90, mass = 3, oder at = 90, force = [0, -1] (mm, g, N)</translation>
    </message>
    <message>
        <source>Sketch or edges with the first state</source>
        <translation>Skizze oder Kanten mit dem ersten Zustand</translation>
    </message>
    <message>
        <source>Sketch or edges with the second state</source>
        <translation>Skizze oder Kanten mit dem zweiten Zustand</translation>
    </message>
    <message>
        <source>What the feature shows</source>
        <translation>Was das Objekt zeigt</translation>
    </message>
    <message>
        <source>Material the part is cut from</source>
        <translation>Material, aus dem das Teil geschnitten wird</translation>
    </message>
    <message>
        <source>Verdict on the part and its curves</source>
        <translation>Urteil über das Teil und seine Kurven</translation>
    </message>
    <message>
        <source>True if the part snaps between its states in the same clamps</source>
        <translation>Wahr, wenn das Teil in denselben Einspannungen zwischen seinen Zuständen umschnappt</translation>
    </message>
    <message>
        <source>Largest force between the states, N</source>
        <translation>Größte Kraft zwischen den Zuständen, N</translation>
    </message>
    <message>
        <source>Travel of the pushed point at which the part snaps; 0 for none</source>
        <translation>Weg der gedrückten Stelle, bei dem das Teil umschnappt; 0 für keinen</translation>
    </message>
    <message>
        <source>Length between the pads along the curve</source>
        <translation>Länge zwischen den Endstücken, entlang der Kurve</translation>
    </message>
    <message>
        <source>Least thickness in the plane</source>
        <translation>Kleinste Dicke in der Ebene</translation>
    </message>
    <message>
        <source>Largest thickness in the plane</source>
        <translation>Größte Dicke in der Ebene</translation>
    </message>
    <message>
        <source>Largest gap between ends of edges that is closed</source>
        <translation>Größte Lücke zwischen den Enden von Kanten, die geschlossen wird</translation>
    </message>
    <message>
        <source>Messages in all languages</source>
        <translation>Meldungen in allen Sprachen</translation>
    </message>
    <message>
        <source>Keep the curve as drawn, if it is not smoothed</source>
        <translation>Kurve wie gezeichnet lassen, wenn sie nicht geglättet wird</translation>
    </message>
    <message>
        <source>Apply the least stability margin</source>
        <translation>Die kleinste Stabilitätsreserve anwenden</translation>
    </message>
    <message>
        <source>Smallest length; applies together with the largest length</source>
        <translation>Kleinste Länge; gilt zusammen mit der größten Länge</translation>
    </message>
    <message>
        <source>Ends whose tangents are kept</source>
        <translation>Enden, deren Tangenten erhalten bleiben</translation>
    </message>
    <message>
        <source>Length of the curve to which the places of rails, ties and loads refer; 0 for the present length</source>
        <translation>Länge der Kurve, auf die sich die Stellen von Schienen, Schnüren und Lasten beziehen; 0 für die jetzige Länge</translation>
    </message>
    <message>
        <source>Sources in the same container; they enter and leave containers together with the feature</source>
        <translation>Quellen im selben Container; sie werden zusammen mit dem Feature in andere Container verschoben</translation>
    </message>
    <message>
        <source>Lengths and ends of the edges when they were chosen</source>
        <translation>Längen und Enden der Kanten, als sie gewählt wurden</translation>
    </message>
</context>
<context>
    <name>Elastica</name>
    <message>
        <source>en</source>
        <translation>de</translation>
    </message>
    <message>
        <source>Pull the ends and the tangents by their handles; the curve is drawn on release</source>
        <translation>Enden und Tangenten an ihren Griffen ziehen; die Kurve wird beim Loslassen gezeichnet</translation>
    </message>
    <message>
        <source>Length between the clamps</source>
        <translation>Länge zwischen den Klemmen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Save the coupon</source>
        <translation>Probestreifen speichern</translation>
    </message>
    <message>
        <source>type the readings first: overhang = droop, in mm, such as 120 = 14.5; 150 = 31</source>
        <translation>zuerst Messwerte eingeben: Überhang = Durchhang in mm, etwa 120 = 14.5; 150 = 31</translation>
    </message>
    <message>
        <source>Longest overhang of the coupon</source>
        <translation>Größter Überhang des Probestreifens</translation>
    </message>
    <message>
        <source>wrote</source>
        <translation>geschrieben:</translation>
    </message>
    <message>
        <source>kept as</source>
        <translation>behalten als</translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation>Ordner für die Dateien</translation>
    </message>
    <message>
        <source>DXF files are of version R12 here, curves as arcs: the library ezdxf is missing.</source>
        <translation>DXF-Dateien sind hier von der Version R12, Kurven als Bögen: die Bibliothek ezdxf fehlt.</translation>
    </message>
    <message>
        <source>The files do not contain {later}, which was added after {strip}. Add it to the strip (slots, tabs, holes), or draw it in the files.</source>
        <translation>Die Dateien enthalten {later} nicht, das nach {strip} hinzugefügt wurde. Ergänzen Sie es im Streifen (Schlitze, Laschen, Löcher), oder zeichnen Sie es in die Dateien.</translation>
    </message>
    <message>
        <source>choose a folder for the files</source>
        <translation>bitte einen Ordner für die Dateien wählen</translation>
    </message>
    <message>
        <source>exists already: choose another folder, or tick the box that overwrites</source>
        <translation>gibt es schon: einen anderen Ordner wählen oder das Überschreiben ankreuzen</translation>
    </message>
    <message>
        <source>Enter the full path of the folder, or press Browse.</source>
        <translation>Geben Sie den vollständigen Pfad des Ordners an, oder drücken Sie Durchsuchen.</translation>
    </message>
    <message>
        <source>Ranges are those of the sheet.</source>
        <translation>Die Bereiche sind die der Platte.</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>größte</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>The edited object was deleted. Press Cancel.</source>
        <translation>Das bearbeitete Objekt wurde gelöscht. Drücken Sie Abbrechen.</translation>
    </message>
    <message>
        <source>Use the nearest curve</source>
        <translation>Die nächstgelegene Kurve nehmen</translation>
    </message>
    <message>
        <source>Pick another curve</source>
        <translation>Andere Kurve wählen</translation>
    </message>
    <message>
        <source>Then click a sketch or an edge, in the view or in the tree</source>
        <translation>Dann eine Skizze oder Kante anklicken, in der Ansicht oder im Baum</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Move or turn an end: type numbers, or drag one of the handles in the view.</source>
        <translation>Ein Ende verschieben oder drehen: Zahlen eingeben oder an einem der Griffe in der Ansicht ziehen.</translation>
    </message>
    <message>
        <source>strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>bent further</source>
        <translation>weiter gebogen</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Flat part</source>
        <translation>Flaches Teil</translation>
    </message>
    <message>
        <source>End fixtures</source>
        <translation>Endhalter</translation>
    </message>
    <message>
        <source>Base plate</source>
        <translation>Grundplatte</translation>
    </message>
    <message>
        <source>Nest on sheets</source>
        <translation>Auf Platten schachteln</translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation>Steifigkeitsverhältnis</translation>
    </message>
    <message>
        <source>Sheet and width</source>
        <translation>Platte und Breite</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Bauart</translation>
    </message>
    <message>
        <source>Nearest curve</source>
        <translation>Nächstgelegene Kurve</translation>
    </message>
    <message>
        <source>Ends and weight</source>
        <translation>Enden und Gewicht</translation>
    </message>
    <message>
        <source>Slots</source>
        <translation>Schlitze</translation>
    </message>
    <message>
        <source>Printed blocks</source>
        <translation>Gedruckte Halter</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Platten</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Largest width</source>
        <translation>Größte Breite</translation>
    </message>
    <message>
        <source>Least width</source>
        <translation>Kleinste Breite</translation>
    </message>
    <message>
        <source>Outer width</source>
        <translation>Außenbreite</translation>
    </message>
    <message>
        <source>Columns of holes</source>
        <translation>Spalten von Löchern</translation>
    </message>
    <message>
        <source>Rows of holes (0 = automatic)</source>
        <translation>Lochreihen (0 = automatisch)</translation>
    </message>
    <message>
        <source>Backing</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Shape shown</source>
        <translation>Gezeigte Form</translation>
    </message>
    <message>
        <source>Follow the curve</source>
        <translation>Der Kurve folgen</translation>
    </message>
    <message>
        <source>Largest stiffness ratio</source>
        <translation>Größtes Steifigkeitsverhältnis</translation>
    </message>
    <message>
        <source>Least stability margin</source>
        <translation>Kleinste Stabilitätsreserve</translation>
    </message>
    <message>
        <source>Largest strain, % (0 = sheet)</source>
        <translation>Größte Dehnung, % (0 = Platte)</translation>
    </message>
    <message>
        <source>Keep end tangents</source>
        <translation>Endtangenten behalten</translation>
    </message>
    <message>
        <source>Keep the length</source>
        <translation>Länge beibehalten</translation>
    </message>
    <message>
        <source>Start is held</source>
        <translation>Anfang ist gehalten</translation>
    </message>
    <message>
        <source>End is held</source>
        <translation>Ende ist gehalten</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>Eigengewicht</translation>
    </message>
    <message>
        <source>Tab at the start</source>
        <translation>Lasche am Anfang</translation>
    </message>
    <message>
        <source>Tab at the end</source>
        <translation>Lasche am Ende</translation>
    </message>
    <message>
        <source>Rounding of tabs</source>
        <translation>Rundung der Laschen</translation>
    </message>
    <message>
        <source>Hole in tabs</source>
        <translation>Loch in Laschen</translation>
    </message>
    <message>
        <source>Engraved text</source>
        <translation>Gravierter Text</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Cut slots where strips cross</source>
        <translation>Schlitze, wo Streifen sich kreuzen</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Spiel</translation>
    </message>
    <message>
        <source>Width of slots</source>
        <translation>Breite der Schlitze</translation>
    </message>
    <message>
        <source>Inner ends of slots</source>
        <translation>Innere Enden der Schlitze</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Foot (0 = none)</source>
        <translation>Fuß (0 = keiner)</translation>
    </message>
    <message>
        <source>Height of the foot</source>
        <translation>Höhe des Fußes</translation>
    </message>
    <message>
        <source>Screw holes (0 = none)</source>
        <translation>Schraubenlöcher (0 = keine)</translation>
    </message>
    <message>
        <source>Play beside tabs</source>
        <translation>Spiel neben Laschen</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Sheet width</source>
        <translation>Plattenbreite</translation>
    </message>
    <message>
        <source>Sheet height</source>
        <translation>Plattenhöhe</translation>
    </message>
    <message>
        <source>Distance between parts</source>
        <translation>Abstand zwischen Teilen</translation>
    </message>
    <message>
        <source>Built-in sheets stay: keep yours under another name.</source>
        <translation>Eingebaute Platten bleiben: Ihre bitte unter anderem Namen behalten.</translation>
    </message>
    <message>
        <source>least radius</source>
        <translation>kleinster Radius</translation>
    </message>
    <message>
        <source>elasto-gravity length</source>
        <translation>Elasto-Gravitationslänge</translation>
    </message>
    <message>
        <source>Constraints on the drawn curve that OK takes away</source>
        <translation>Bedingungen an der gezeichneten Kurve, die mit OK entfallen</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>nächstgelegene</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Written to</source>
        <translation>Geschrieben nach</translation>
    </message>
    <message>
        <source>curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>stiffness range</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>thickness along the strip</source>
        <translation>Dicke entlang des Streifens</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>end angles</source>
        <translation>Endwinkel</translation>
    </message>
    <message>
        <source>plasticity</source>
        <translation>Plastizität</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>kerf</source>
        <translation>Schnittfuge</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>zusammen</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Steifigkeitsverhältnis</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>Stabilitätsreserve</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>keep-out</source>
        <translation>Sperrbereich</translation>
    </message>
    <message>
        <source>stiffness bounds</source>
        <translation>Steifigkeitsgrenzen</translation>
    </message>
    <message>
        <source>end position</source>
        <translation>Ort des Endes</translation>
    </message>
    <message>
        <source>end tangent</source>
        <translation>Tangente am Ende</translation>
    </message>
    <message>
        <source>start position</source>
        <translation>Ort des Anfangs</translation>
    </message>
    <message>
        <source>start tangent</source>
        <translation>Tangente am Anfang</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>inflection line</source>
        <translation>Wendelinie</translation>
    </message>
    <message>
        <source>symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>the strip laid flat</source>
        <translation>der Streifen flach gelegt</translation>
    </message>
    <message>
        <source>can</source>
        <translation>geht</translation>
    </message>
    <message>
        <source>no curve yet</source>
        <translation>noch keine Kurve</translation>
    </message>
    <message>
        <source>Select a sketch with a spline, or an edge of an object, first.</source>
        <translation>Bitte zuerst eine Skizze mit einem Spline oder eine Kante auswählen.</translation>
    </message>
    <message>
        <source>Select a sketch with a spline first.</source>
        <translation>Bitte zuerst eine Skizze mit einem Spline auswählen.</translation>
    </message>
    <message>
        <source>Select a strip first.</source>
        <translation>Bitte zuerst einen Streifen auswählen.</translation>
    </message>
    <message>
        <source>Select two strips or more first.</source>
        <translation>Bitte zuerst zwei oder mehr Streifen auswählen.</translation>
    </message>
    <message>
        <source>The selected lines are pieces of a polyline, as FreeCAD reads it from a file: draw a B-spline through their ends (workbench Draft) and select that.</source>
        <translation>Die ausgewählten Linien sind Stücke eines Linienzugs, wie FreeCAD ihn aus einer Datei liest: einen B-Spline durch ihre Enden zeichnen (Arbeitsbereich Draft) und diesen auswählen.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis at x</source>
        <translation>Achse bei x</translation>
    </message>
    <message>
        <source>Axis at y</source>
        <translation>Achse bei y</translation>
    </message>
    <message>
        <source>Axis at z</source>
        <translation>Achse bei z</translation>
    </message>
    <message>
        <source>Closed lines</source>
        <translation>Geschlossene Linien</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Draw it into the sketch</source>
        <translation>In die Skizze zeichnen</translation>
    </message>
    <message>
        <source>Escape stops it</source>
        <translation>Escape bricht ab</translation>
    </message>
    <message>
        <source>Writing files</source>
        <translation>Dateien werden geschrieben</translation>
    </message>
    <message>
        <source>Searching for changes that help</source>
        <translation>Passende Änderungen werden gesucht</translation>
    </message>
    <message>
        <source>Keep it possible</source>
        <translation>Machbar bleiben</translation>
    </message>
    <message>
        <source>A dragged pole returns to the last position where the strip can be made</source>
        <translation>Ein gezogener Pol kehrt an die letzte Stelle zurück, an der der Streifen machbar ist</translation>
    </message>
    <message>
        <source>The cutting files show {strip} without {later}, a later feature of its body. Use the slots, tabs and holes of the strip instead, or draw the change in the files.</source>
        <translation>Die Schneiddateien zeigen {strip} ohne {later}, ein späteres Merkmal des Körpers. Schlitze, Laschen und Löcher des Streifens verwenden oder die Änderung in die Dateien zeichnen.</translation>
    </message>
    <message>
        <source>Searching the nearest curve</source>
        <translation>Die nächstgelegene Kurve wird gesucht</translation>
    </message>
    <message>
        <source>Putting the model together</source>
        <translation>Das Modell wird zusammengesetzt</translation>
    </message>
    <message>
        <source>Making the blocks</source>
        <translation>Die Halter werden gemacht</translation>
    </message>
    <message>
        <source>Looking for strips that meet</source>
        <translation>Streifen, die sich treffen, werden gesucht</translation>
    </message>
    <message>
        <source>Cutting the mesh</source>
        <translation>Das Netz wird geschnitten</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Es wird geschnitten</translation>
    </message>
    <message>
        <source>Bending the strip</source>
        <translation>Der Streifen wird gebogen</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Beibehalten</translation>
    </message>
    <message>
        <source>Keep the ends</source>
        <translation>Enden beibehalten</translation>
    </message>
    <message>
        <source>Keep the symmetry</source>
        <translation>Symmetrie beibehalten</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Must not break</source>
        <translation>Darf nicht brechen</translation>
    </message>
    <message>
        <source>Must be stable</source>
        <translation>Muss stabil sein</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Section into curves</source>
        <translation>Schnitt in Kurven</translation>
    </message>
    <message>
        <source>Keep the curve as drawn</source>
        <translation>Kurve wie gezeichnet</translation>
    </message>
    <message>
        <source>Smooth the curve by</source>
        <translation>Kurve glätten um</translation>
    </message>
    <message>
        <source>Smooth waves below</source>
        <translation>Wellen glätten unter</translation>
    </message>
    <message>
        <source>Spread over</source>
        <translation>Verteilt über</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>sketch</source>
        <translation>Skizze</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallel</translation>
    </message>
    <message>
        <source>about an axis</source>
        <translation>um eine Achse</translation>
    </message>
    <message>
        <source>along a path</source>
        <translation>entlang eines Pfades</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weglassen</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>links und rechts</translation>
    </message>
    <message>
        <source>above and below</source>
        <translation>oben und unten</translation>
    </message>
    <message>
        <source>Bent</source>
        <translation>gebogen</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>flach</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>schlicht</translation>
    </message>
    <message>
        <source>Perforated</source>
        <translation>gelocht</translation>
    </message>
    <message>
        <source>Laminated</source>
        <translation>laminiert</translation>
    </message>
    <message>
        <source>Exactly</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>nächstgelegene Kurve</translation>
    </message>
    <message>
        <source>clamped</source>
        <translation>eingespannt</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>gelenkig</translation>
    </message>
    <message>
        <source>slide-x</source>
        <translation>gleitet in x</translation>
    </message>
    <message>
        <source>slide-y</source>
        <translation>gleitet in y</translation>
    </message>
    <message>
        <source>roller-x</source>
        <translation>drehbar gleitend in x</translation>
    </message>
    <message>
        <source>roller-y</source>
        <translation>drehbar gleitend in y</translation>
    </message>
    <message>
        <source>guided</source>
        <translation>geführt</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>bezier</source>
        <translation>Bézier</translation>
    </message>
    <message>
        <source>polyline</source>
        <translation>Polylinie</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>Spiegelung</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>wie im Artikel</translation>
    </message>
    <message>
        <source>square</source>
        <translation>eckig</translation>
    </message>
    <message>
        <source>round</source>
        <translation>rund</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Grundschicht</translation>
    </message>
    <message>
        <source>hull</source>
        <translation>Hülle</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Make a sketch to edit</source>
        <translation>Skizze zum Bearbeiten machen</translation>
    </message>
    <message>
        <source>Make sketches to edit</source>
        <translation>Skizzen zum Bearbeiten machen</translation>
    </message>
    <message>
        <source>Replaces this feature by objects that no longer follow its source</source>
        <translation>Ersetzt dieses Element durch Objekte, die der Quelle nicht mehr folgen</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>flach</translation>
    </message>
    <message>
        <source>backing</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>inflection on the line</source>
        <translation>Wendepunkt auf der Linie</translation>
    </message>
    <message>
        <source>inflection off it</source>
        <translation>Wendepunkt daneben</translation>
    </message>
    <message>
        <source>nearest curve</source>
        <translation>nächstgelegene Kurve</translation>
    </message>
    <message>
        <source>above the sheet's limit</source>
        <translation>über der Grenze der Platte</translation>
    </message>
    <message>
        <source>the line must not meet the curve here</source>
        <translation>hier darf die Linie die Kurve nicht treffen</translation>
    </message>
    <message>
        <source>Select blocks, a plate or rings.</source>
        <translation>Wählen Sie Halter, eine Platte oder Ringe.</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>Ends held</source>
        <translation>Gehaltene Enden</translation>
    </message>
    <message>
        <source>Gap (0 = one ring)</source>
        <translation>Abstand (0 = ein Ring)</translation>
    </message>
    <message>
        <source>Rail (bar on one side)</source>
        <translation>Schiene (Stange auf einer Seite)</translation>
    </message>
    <message>
        <source>Slot (two bars)</source>
        <translation>Schlitz (zwei Stangen)</translation>
    </message>
    <message>
        <source>Pin (the strip turns)</source>
        <translation>Stift (der Streifen dreht sich)</translation>
    </message>
    <message>
        <source>Tie (cord)</source>
        <translation>Schnur</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Hung mass</source>
        <translation>Angehängte Masse</translation>
    </message>
    <message>
        <source>Click the other end of the cord.</source>
        <translation>Auf das andere Ende der Schnur klicken.</translation>
    </message>
    <message>
        <source>Click the place on the sketch or on the strip.</source>
        <translation>Auf die Stelle an der Skizze oder am Streifen klicken.</translation>
    </message>
    <message>
        <source>thrust line</source>
        <translation>Stützlinie</translation>
    </message>
    <message>
        <source>cord</source>
        <translation>Schnur</translation>
    </message>
    <message>
        <source>rail, pin, tie or load</source>
        <translation>Schiene, Stift, Schnur oder Last</translation>
    </message>
    <message>
        <source>Two-state part</source>
        <translation>Teil mit zwei Zuständen</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>First state</source>
        <translation>Erster Zustand</translation>
    </message>
    <message>
        <source>Second state</source>
        <translation>Zweiter Zustand</translation>
    </message>
    <message>
        <source>As cut</source>
        <translation>Wie geschnitten</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>two states</source>
        <translation>zwei Zustände</translation>
    </message>
    <message>
        <source>Searching the part with two states</source>
        <translation>Das Teil mit zwei Zuständen wird gesucht</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Radius at the pads</source>
        <translation>Radius an den Endstücken</translation>
    </message>
    <message>
        <source>State without forces</source>
        <translation>Zustand ohne Kräfte</translation>
    </message>
    <message>
        <source>Thinnest place (0 = automatic)</source>
        <translation>Dünnste Stelle (0 = automatisch)</translation>
    </message>
    <message>
        <source>Equal lengths: keep</source>
        <translation>Gleiche Länge: behalten</translation>
    </message>
    <message>
        <source>Largest thickness or least ratio</source>
        <translation>Größte Dicke oder kleinstes Verhältnis</translation>
    </message>
    <message>
        <source>Holes in pads</source>
        <translation>Löcher in den Endstücken</translation>
    </message>
    <message>
        <source>Holes from the ends of pads</source>
        <translation>Löcher vom Ende der Endstücke</translation>
    </message>
    <message>
        <source>Length of pads</source>
        <translation>Länge der Endstücke</translation>
    </message>
    <message>
        <source>Width of pads</source>
        <translation>Breite der Endstücke</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>Gedruckt</translation>
    </message>
    <message>
        <source>Pushed at (0 = middle)</source>
        <translation>Gedrückt bei (0 = Mitte)</translation>
    </message>
    <message>
        <source>ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>first</source>
        <translation>erster</translation>
    </message>
    <message>
        <source>second</source>
        <translation>zweiter</translation>
    </message>
    <message>
        <source>Every selected strip has its flat part.</source>
        <translation>Jeder gewählte Streifen hat sein flaches Teil.</translation>
    </message>
    <message>
        <source>First draw a single curve.</source>
        <translation>Zuerst eine einzige Kurve zeichnen.</translation>
    </message>
    <message>
        <source>First use the nearest curve.</source>
        <translation>Zuerst die nächstgelegene Kurve nehmen.</translation>
    </message>
    <message>
        <source>First make the strip possible.</source>
        <translation>Zuerst den Streifen machbar machen.</translation>
    </message>
    <message>
        <source>Make it anyway</source>
        <translation>Trotzdem herstellen</translation>
    </message>
    <message>
        <source>Height of its upper face</source>
        <translation>Höhe der Oberseite</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Loch</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Schnittfuge</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Kerben</translation>
    </message>
    <message>
        <source>Nearest curve to sketch</source>
        <translation>Nächstgelegene Kurve zur Skizze</translation>
    </message>
    <message>
        <source>Follow the curve: Nearest</source>
        <translation>Der Kurve folgen: nächstgelegene Kurve</translation>
    </message>
    <message>
        <source>flat outline</source>
        <translation>flacher Umriss</translation>
    </message>
    <message>
        <source>backing outline</source>
        <translation>Umriss der Verstärkung</translation>
    </message>
    <message>
        <source>Every selected strip has its outline.</source>
        <translation>Jeder gewählte Streifen hat seinen Umriss.</translation>
    </message>
</context>
<context>
    <name>ElasticaBend</name>
    <message>
        <source>Bend forward</source>
        <translation>Weiter biegen</translation>
    </message>
    <message>
        <source>Start of the strip</source>
        <translation>Anfang des Streifens</translation>
    </message>
    <message>
        <source>Move x</source>
        <translation>Verschiebung x</translation>
    </message>
    <message>
        <source>Move y</source>
        <translation>Verschiebung y</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>End of the strip</source>
        <translation>Ende des Streifens</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Displacement of the start along x</source>
        <translation>Verschiebung des Anfangs entlang x</translation>
    </message>
    <message>
        <source>Displacement of the start along y</source>
        <translation>Verschiebung des Anfangs entlang y</translation>
    </message>
    <message>
        <source>Rotation of the start, degrees</source>
        <translation>Drehung des Anfangs in Grad</translation>
    </message>
    <message>
        <source>Displacement of the end along x</source>
        <translation>Verschiebung des Endes entlang x</translation>
    </message>
    <message>
        <source>Displacement of the end along y</source>
        <translation>Verschiebung des Endes entlang y</translation>
    </message>
    <message>
        <source>Rotation of the end, degrees</source>
        <translation>Drehung des Endes in Grad</translation>
    </message>
    <message>
        <source>Show the path from rest in small steps</source>
        <translation>Zeigt den Weg aus der Ruhelage in kleinen Schritten</translation>
    </message>
</context>
<context>
    <name>ElasticaCheck</name>
    <message>
        <source>Check curve</source>
        <translation>Kurve prüfen</translation>
    </message>
</context>
<context>
    <name>ElasticaCoupon</name>
    <message>
        <source>Coupon and calibrate</source>
        <translation>Probestreifen und Kalibrierung</translation>
    </message>
    <message>
        <source>Coupon</source>
        <translation>Probestreifen</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Make the coupon</source>
        <translation>Probestreifen erzeugen</translation>
    </message>
    <message>
        <source>Write its cutting file</source>
        <translation>Schneiddatei schreiben</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Overhang = droop, mm</source>
        <translation>Überhang = Durchhang, mm</translation>
    </message>
    <message>
        <source>120 = 14.5; 150 = 31</source>
        <translation>120 = 14,5; 150 = 31</translation>
    </message>
    <message>
        <source>Reading error</source>
        <translation>Ablesefehler</translation>
    </message>
    <message>
        <source>Name of the sheet</source>
        <translation>Name der Platte</translation>
    </message>
    <message>
        <source>Keep the sheet</source>
        <translation>Platte behalten</translation>
    </message>
    <message>
        <source>Sheet to be measured</source>
        <translation>Platte, die vermessen wird</translation>
    </message>
    <message>
        <source>Adds the test strip to the document</source>
        <translation>Fügt den Probestreifen ins Dokument ein</translation>
    </message>
    <message>
        <source>Asks for a DXF or SVG file and writes the test strip into it</source>
        <translation>Fragt nach einer DXF- oder SVG-Datei und schreibt den Probestreifen hinein</translation>
    </message>
    <message>
        <source>Overhang = droop, in mm, one pair for each measurement</source>
        <translation>Überhang = Durchhang in mm, ein Paar je Messung</translation>
    </message>
    <message>
        <source>Uncertainty of a reading</source>
        <translation>Unsicherheit einer Ablesung</translation>
    </message>
    <message>
        <source>Name of the calibrated sheet in your library</source>
        <translation>Name der kalibrierten Platte in Ihrer Bibliothek</translation>
    </message>
    <message>
        <source>Adds the calibrated sheet to your library</source>
        <translation>Nimmt die kalibrierte Platte in Ihre Bibliothek auf</translation>
    </message>
</context>
<context>
    <name>ElasticaExport</name>
    <message>
        <source>Export cutting files</source>
        <translation>Schneiddateien exportieren</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>DXF</source>
        <translation>DXF</translation>
    </message>
    <message>
        <source>SVG</source>
        <translation>SVG</translation>
    </message>
    <message>
        <source>STEP, flat and bent</source>
        <translation>STEP, flach und gebogen</translation>
    </message>
    <message>
        <source>Cut list (CSV)</source>
        <translation>Stückliste (CSV)</translation>
    </message>
    <message>
        <source>Nest on sheets</source>
        <translation>Auf Platten schachteln</translation>
    </message>
    <message>
        <source>Sheet width</source>
        <translation>Plattenbreite</translation>
    </message>
    <message>
        <source>Sheet height</source>
        <translation>Plattenhöhe</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>DXF version</source>
        <translation>DXF-Version</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Schnittfuge</translation>
    </message>
    <message>
        <source>Tolerance of arcs and polylines</source>
        <translation>Toleranz von Bögen und Polylinien</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wohin</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Durchsuchen ...</translation>
    </message>
    <message>
        <source>Overwrite files that exist</source>
        <translation>Vorhandene Dateien überschreiben</translation>
    </message>
    <message>
        <source>One drawing for each part, for lasers and cutters</source>
        <translation>Eine Zeichnung je Teil, für Laser und Schneidplotter</translation>
    </message>
    <message>
        <source>The same drawings for programs that draw</source>
        <translation>Dieselben Zeichnungen für Zeichenprogramme</translation>
    </message>
    <message>
        <source>Solids for other CAD programs</source>
        <translation>Körper für andere CAD-Programme</translation>
    </message>
    <message>
        <source>A table of all parts with sizes and numbers</source>
        <translation>Eine Tabelle aller Teile mit Maßen und Stückzahlen</translation>
    </message>
    <message>
        <source>All parts together on sheets</source>
        <translation>Alle Teile zusammen auf Platten</translation>
    </message>
    <message>
        <source>Width of a sheet, along its grain</source>
        <translation>Breite einer Platte, entlang der Faser</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>Höhe einer Platte</translation>
    </message>
    <message>
        <source>Splines as drawn, or arcs or lines for machines that take nothing else</source>
        <translation>Splines wie gezeichnet, oder Bögen oder Linien für Maschinen, die nur das nehmen</translation>
    </message>
    <message>
        <source>The oldest version that your program reads is the safest</source>
        <translation>Die älteste Version, die Ihr Programm liest, ist die sicherste</translation>
    </message>
    <message>
        <source>Width removed by the cut; outlines are offset by half of it</source>
        <translation>Breite, die der Schnitt entfernt; Umrisse werden um die Hälfte versetzt</translation>
    </message>
    <message>
        <source>Largest distance of arcs and lines from the spline</source>
        <translation>Größter Abstand der Bögen und Geraden vom Spline</translation>
    </message>
    <message>
        <source>Machines that cut every line would cut the tabs off at their guide lines</source>
        <translation>Maschinen, die jede Linie schneiden, würden die Laschen an ihren Hilfslinien abschneiden</translation>
    </message>
    <message>
        <source>Guide lines and names of mating strips</source>
        <translation>Hilfslinien und Namen der Gegenstreifen</translation>
    </message>
    <message>
        <source>Folder of the files; an empty field opens a dialog</source>
        <translation>Ordner der Dateien; ein leeres Feld öffnet einen Dialog</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Den Ordner wählen</translation>
    </message>
    <message>
        <source>If this is off, existing files are not changed</source>
        <translation>Ist dies aus, werden vorhandene Dateien nicht geändert</translation>
    </message>
</context>
<context>
    <name>ElasticaFixtures</name>
    <message>
        <source>End fixtures and base plate</source>
        <translation>Endhalter und Grundplatte</translation>
    </message>
    <message>
        <source>Printed blocks</source>
        <translation>Gedruckte Halter</translation>
    </message>
    <message>
        <source>Make blocks for the ends</source>
        <translation>Halter für die Enden erzeugen</translation>
    </message>
    <message>
        <source>Room around the tab</source>
        <translation>Spiel um die Lasche</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Screw holes</source>
        <translation>Schraubenlöcher</translation>
    </message>
    <message>
        <source>Base plate</source>
        <translation>Grundplatte</translation>
    </message>
    <message>
        <source>Make a slotted plate</source>
        <translation>Geschlitzte Platte erzeugen</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Height of its upper face</source>
        <translation>Höhe der Oberseite</translation>
    </message>
    <message>
        <source>Room beside the tab</source>
        <translation>Spiel neben der Lasche</translation>
    </message>
    <message>
        <source>Clearance of slots</source>
        <translation>Spiel der Schlitze</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Blocks to be printed, with a pocket for every tab</source>
        <translation>Halter zum Drucken, mit einer Tasche für jede Lasche</translation>
    </message>
    <message>
        <source>Room around a tab in its pocket</source>
        <translation>Spiel um eine Lasche in ihrer Tasche</translation>
    </message>
    <message>
        <source>Least thickness around the pocket</source>
        <translation>Kleinste Dicke um die Tasche</translation>
    </message>
    <message>
        <source>Width of the foot on either side; 0 for none</source>
        <translation>Breite des Fußes auf jeder Seite; 0 für keinen</translation>
    </message>
    <message>
        <source>Diameter of the screw holes in the foot; 0 for none</source>
        <translation>Durchmesser der Schraubenlöcher im Fuß; 0 für keine</translation>
    </message>
    <message>
        <source>One plate with a slot for every tab that goes through it</source>
        <translation>Eine Platte mit einem Schlitz für jede Lasche, die hindurchgeht</translation>
    </message>
    <message>
        <source>Sheet of the plate</source>
        <translation>Material der Platte</translation>
    </message>
    <message>
        <source>Position of the upper face of the plate along z</source>
        <translation>Lage der Plattenoberseite entlang z</translation>
    </message>
    <message>
        <source>Room beside a tab on either side</source>
        <translation>Spiel neben einer Lasche auf jeder Seite</translation>
    </message>
    <message>
        <source>Added to the width of the slots</source>
        <translation>Zuschlag zur Breite der Schlitze</translation>
    </message>
    <message>
        <source>Least distance of the slots for strips from the edge</source>
        <translation>Kleinster Abstand der Schlitze für Streifen vom Rand</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>One ring with a slot for every tab at the start of the strips, and one for the ends, such as below and above a lamp</source>
        <translation>Ein Ring mit einem Schlitz für jede Lasche am Anfang der Streifen und einer für ihre Enden, etwa unter und über einer Lampe</translation>
    </message>
    <message>
        <source>Make a ring for each end</source>
        <translation>Für jedes Ende einen Ring erzeugen</translation>
    </message>
    <message>
        <source>Sheet of the rings</source>
        <translation>Platte für die Ringe</translation>
    </message>
    <message>
        <source>Gap between two rings</source>
        <translation>Abstand zweier Ringe</translation>
    </message>
    <message>
        <source>Distance between two rings that hold inclined tabs at their angle; 0 for one ring at each end</source>
        <translation>Abstand zweier Ringe, die schräge Laschen in ihrem Winkel halten; 0 für einen Ring an jedem Ende</translation>
    </message>
</context>
<context>
    <name>ElasticaPreferences</name>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>New strips</source>
        <translation>Neue Streifen</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Largest width</source>
        <translation>Größte Breite</translation>
    </message>
    <message>
        <source>Tab length</source>
        <translation>Laschenlänge</translation>
    </message>
    <message>
        <source>Cutting files</source>
        <translation>Schneiddateien</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Schnittfuge</translation>
    </message>
    <message>
        <source>Clearance of slots</source>
        <translation>Spiel der Schlitze</translation>
    </message>
    <message>
        <source>DXF version</source>
        <translation>DXF-Version</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Tolerance of arcs and polylines</source>
        <translation>Toleranz von Bögen und Polylinien</translation>
    </message>
    <message>
        <source>While a sketch is edited</source>
        <translation>Beim Bearbeiten einer Skizze</translation>
    </message>
    <message>
        <source>Show curvature, inflections and their line</source>
        <translation>Krümmung, Wendepunkte und ihre Gerade zeigen</translation>
    </message>
    <message>
        <source>Show the nearest curve that can be bent</source>
        <translation>Die nächstgelegene biegbare Kurve zeigen</translation>
    </message>
    <message>
        <source>Sheet that new strips are made of</source>
        <translation>Platte, aus der neue Streifen sind</translation>
    </message>
    <message>
        <source>Width of the widest place of new strips</source>
        <translation>Breite der breitesten Stelle neuer Streifen</translation>
    </message>
    <message>
        <source>Length of the tabs of new strips</source>
        <translation>Länge der Laschen neuer Streifen</translation>
    </message>
    <message>
        <source>Width removed by the cut; outlines are offset by half of it</source>
        <translation>Breite, die der Schnitt entfernt; Umrisse werden um die Hälfte versetzt</translation>
    </message>
    <message>
        <source>Added to the width of slots in new models and plates</source>
        <translation>Zuschlag zur Breite der Schlitze neuer Modelle und Platten</translation>
    </message>
    <message>
        <source>The oldest version that your program reads is the safest</source>
        <translation>Die älteste Version, die Ihr Programm liest, ist die sicherste</translation>
    </message>
    <message>
        <source>Splines as drawn, or arcs or lines for machines that take nothing else</source>
        <translation>Splines wie gezeichnet, oder Bögen oder Linien für Maschinen, die nur das nehmen</translation>
    </message>
    <message>
        <source>Largest distance of arcs and lines from the spline</source>
        <translation>Größter Abstand der Bögen und Geraden vom Spline</translation>
    </message>
    <message>
        <source>In sketches that strips follow, and in those made from this workbench</source>
        <translation>In Skizzen, denen Streifen folgen, und in denen aus diesem Arbeitsbereich</translation>
    </message>
    <message>
        <source>While the mouse rests, where a curve is refused</source>
        <translation>Wenn die Maus ruht, wo eine Kurve abgelehnt wird</translation>
    </message>
</context>
<context>
    <name>ElasticaProjective</name>
    <message>
        <source>Projective edit</source>
        <translation>Projektiv bearbeiten</translation>
    </message>
    <message>
        <source>Handles (x, y)</source>
        <translation>Griffe (x, y)</translation>
    </message>
    <message>
        <source>1, lower left</source>
        <translation>1, unten links</translation>
    </message>
    <message>
        <source>2, lower right</source>
        <translation>2, unten rechts</translation>
    </message>
    <message>
        <source>3, upper right</source>
        <translation>3, oben rechts</translation>
    </message>
    <message>
        <source>4, upper left</source>
        <translation>4, oben links</translation>
    </message>
    <message>
        <source>Put the handles back</source>
        <translation>Griffe zurücksetzen</translation>
    </message>
    <message>
        <source>First corner of the box, x</source>
        <translation>Erste Ecke des Kastens, x</translation>
    </message>
    <message>
        <source>First corner of the box, y</source>
        <translation>Erste Ecke des Kastens, y</translation>
    </message>
    <message>
        <source>Second corner of the box, x</source>
        <translation>Zweite Ecke des Kastens, x</translation>
    </message>
    <message>
        <source>Second corner of the box, y</source>
        <translation>Zweite Ecke des Kastens, y</translation>
    </message>
    <message>
        <source>Third corner of the box, x</source>
        <translation>Dritte Ecke des Kastens, x</translation>
    </message>
    <message>
        <source>Third corner of the box, y</source>
        <translation>Dritte Ecke des Kastens, y</translation>
    </message>
    <message>
        <source>Fourth corner of the box, x</source>
        <translation>Vierte Ecke des Kastens, x</translation>
    </message>
    <message>
        <source>Fourth corner of the box, y</source>
        <translation>Vierte Ecke des Kastens, y</translation>
    </message>
    <message>
        <source>Back to the box around the drawn curve</source>
        <translation>Zurück zum Kasten um die gezeichnete Kurve</translation>
    </message>
</context>
<context>
    <name>ElasticaSheets</name>
    <message>
        <source>Sheet library</source>
        <translation>Plattenbibliothek</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Schnittfuge</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>Querdehnzahl</translation>
    </message>
    <message>
        <source>Shear modulus</source>
        <translation>Schubmodul</translation>
    </message>
    <message>
        <source>Stiffness against shear in the sheet's plane, which keeps a strip from tipping sideways; plywood has far less than the estimate E / (2 (1 + ν)), which an empty field takes</source>
        <translation>Steifigkeit gegen Schub in der Ebene der Platte; sie hält einen Streifen davon ab, zur Seite zu kippen. Sperrholz hat weit weniger als die Schätzung E / (2 (1 + ν)), die ein leeres Feld nimmt</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Remove my sheet</source>
        <translation>Meine Platte entfernen</translation>
    </message>
    <message>
        <source>All known sheets, your own first</source>
        <translation>Alle bekannten Platten, eigene zuerst</translation>
    </message>
    <message>
        <source>Name of your sheet</source>
        <translation>Name Ihrer Platte</translation>
    </message>
    <message>
        <source>As measured with a caliper</source>
        <translation>Mit dem Messschieber gemessen</translation>
    </message>
    <message>
        <source>Stiffness of the material along the strip; a coupon measures it</source>
        <translation>Steifigkeit des Materials entlang des Streifens; ein Probestreifen misst sie</translation>
    </message>
    <message>
        <source>Mass for volume; it counts where a strip carries its weight</source>
        <translation>Masse je Volumen; zählt, wo ein Streifen sein Gewicht trägt</translation>
    </message>
    <message>
        <source>Largest strain of the skin before the sheet breaks or stays bent</source>
        <translation>Größte Dehnung der Außenhaut, bevor die Platte bricht oder gebogen bleibt</translation>
    </message>
    <message>
        <source>Width removed by the cut of your machine</source>
        <translation>Breite, die der Schnitt Ihrer Maschine entfernt</translation>
    </message>
    <message>
        <source>Transverse contraction as a fraction of the stretch</source>
        <translation>Querkontraktion als Anteil der Dehnung</translation>
    </message>
    <message>
        <source>Source of the data</source>
        <translation>Quelle der Daten</translation>
    </message>
    <message>
        <source>Takes this sheet out of your library</source>
        <translation>Nimmt diese Platte aus Ihrer Bibliothek</translation>
    </message>
</context>
<context>
    <name>ElasticaTolerance</name>
    <message>
        <source>Tolerance study</source>
        <translation>Toleranzstudie</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Strips for each cause</source>
        <translation>Streifen je Ursache</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Number of varied strips</source>
        <translation>Anzahl der variierten Streifen</translation>
    </message>
    <message>
        <source>Computes all strips; Escape stops it</source>
        <translation>Berechnet alle Streifen; Escape bricht ab</translation>
    </message>
</context>
<context>
    <name>Elastica_Bend</name>
    <message>
        <source>Bend forward</source>
        <translation>Weiter biegen</translation>
    </message>
    <message>
        <source>Move or turn the ends of the selected strip and watch it take its new rest shape</source>
        <translation>Enden des gewählten Streifens bewegen oder drehen und zusehen, wie er seine neue Ruhelage einnimmt</translation>
    </message>
</context>
<context>
    <name>Elastica_Between</name>
    <message>
        <source>Draw a strip of given length between two clamps, as a curve in the open sketch</source>
        <translation>Einen Streifen gegebener Länge zwischen zwei Klemmen zeichnen, als Kurve in der offenen Skizze</translation>
    </message>
    <message>
        <source>Curve of given length</source>
        <translation>Kurve gegebener Länge</translation>
    </message>
</context>
<context>
    <name>Elastica_Check</name>
    <message>
        <source>Check curve</source>
        <translation>Kurve prüfen</translation>
    </message>
    <message>
        <source>Check whether a flat strip can take the selected curve; if not, show why and where</source>
        <translation>Prüfen, ob ein flacher Streifen die gewählte Kurve annehmen kann; falls nicht, Gründe und Stellen zeigen</translation>
    </message>
</context>
<context>
    <name>Elastica_Coupon</name>
    <message>
        <source>Coupon and calibrate</source>
        <translation>Probestreifen und Kalibrierung</translation>
    </message>
    <message>
        <source>Make a test strip to hang over an edge, and turn its measured droop into a sheet of your own</source>
        <translation>Einen Probestreifen erzeugen, über eine Kante hängen und aus dem gemessenen Durchhang eine eigene Platte machen</translation>
    </message>
</context>
<context>
    <name>Elastica_Edit</name>
    <message>
        <source>Edit strips</source>
        <translation>Streifen bearbeiten</translation>
    </message>
    <message>
        <source>Change sheet, widths and ends of all selected strips at once</source>
        <translation>Platte, Breiten und Enden aller gewählten Streifen auf einmal ändern</translation>
    </message>
</context>
<context>
    <name>Elastica_Export</name>
    <message>
        <source>Export cutting files</source>
        <translation>Schneiddateien exportieren</translation>
    </message>
    <message>
        <source>Write DXF, SVG and STEP files, nest and cut list of the selected strips, models and base plates</source>
        <translation>DXF-, SVG- und STEP-Dateien, Schachtelung und Stückliste der gewählten Streifen, Modelle und Grundplatten schreiben</translation>
    </message>
</context>
<context>
    <name>Elastica_Fixtures</name>
    <message>
        <source>End fixtures and base plate</source>
        <translation>Endhalter und Grundplatte</translation>
    </message>
    <message>
        <source>Make printed blocks, a slotted base plate or rings that hold the ends of the selected strips or model</source>
        <translation>Gedruckte Halter, eine geschlitzte Grundplatte oder Ringe erzeugen, die die Enden der gewählten Streifen oder des Modells halten</translation>
    </message>
</context>
<context>
    <name>Elastica_Interlock</name>
    <message>
        <source>Interlock selected strips</source>
        <translation>Gewählte Streifen verzahnen</translation>
    </message>
    <message>
        <source>Combine the selected strips into a model, and cut slots where they cross</source>
        <translation>Die gewählten Streifen zu einem Modell verbinden und Schlitze schneiden, wo sie sich kreuzen</translation>
    </message>
</context>
<context>
    <name>Elastica_Laminate</name>
    <message>
        <source>Laminate</source>
        <translation>Laminieren</translation>
    </message>
    <message>
        <source>Rebuild the selected strips as two glued layers: a base of even width and a narrower backing</source>
        <translation>Die gewählten Streifen aus zwei verleimten Schichten neu aufbauen: einer Grundschicht gleichmäßiger Breite und einer schmaleren Verstärkung</translation>
    </message>
</context>
<context>
    <name>Elastica_Live</name>
    <message>
        <source>Live feedback</source>
        <translation>Sofortige Rückmeldung</translation>
    </message>
    <message>
        <source>Show over the open sketch whether a flat strip can take its curve, while it is drawn and dragged</source>
        <translation>Über der offenen Skizze zeigen, ob ein flacher Streifen ihre Kurve annehmen kann, während sie gezeichnet und gezogen wird</translation>
    </message>
</context>
<context>
    <name>Elastica_Nearest</name>
    <message>
        <source>Nearest curve to sketch</source>
        <translation>Nächstgelegene Kurve zur Skizze</translation>
    </message>
    <message>
        <source>Find the curve nearest to the selected sketch that can be bent within limits</source>
        <translation>Die der Skizze nächstgelegene Kurve finden, die sich innerhalb der Grenzen biegen lässt</translation>
    </message>
</context>
<context>
    <name>Elastica_Nest</name>
    <message>
        <source>Nest on sheets</source>
        <translation>Auf Platten schachteln</translation>
    </message>
    <message>
        <source>Arrange all cut parts of the selected strips, models and base plates on sheets</source>
        <translation>Alle Schnittteile der gewählten Streifen, Modelle und Grundplatten auf Platten schachteln</translation>
    </message>
</context>
<context>
    <name>Elastica_Perforate</name>
    <message>
        <source>Perforate</source>
        <translation>Lochen</translation>
    </message>
    <message>
        <source>Give the selected strips an even width, with holes that set their stiffness</source>
        <translation>Den gewählten Streifen gleichmäßige Breite geben, mit Löchern für die Steifigkeit</translation>
    </message>
</context>
<context>
    <name>Elastica_Projective</name>
    <message>
        <source>Projective edit</source>
        <translation>Projektiv bearbeiten</translation>
    </message>
    <message>
        <source>Pull the selected sketch's curve by four handles; if a strip can take the drawn curve, it can take the changed curve</source>
        <translation>Zieht die Kurve der gewählten Skizze an vier Griffen; kann ein Streifen die Kurve vorher annehmen, so kann er es auch nachher</translation>
    </message>
</context>
<context>
    <name>Elastica_Section</name>
    <message>
        <source>Section into curves</source>
        <translation>In Kurven schneiden</translation>
    </message>
    <message>
        <source>Cut the selected body, surface or mesh by planes into smooth curves that strips can follow</source>
        <translation>Schneidet den gewählten Körper, die Fläche oder das Netz mit Ebenen in glatte Kurven, denen Streifen folgen können</translation>
    </message>
</context>
<context>
    <name>Elastica_Sheets</name>
    <message>
        <source>Sheet library</source>
        <translation>Plattenbibliothek</translation>
    </message>
    <message>
        <source>Show the known sheets with their sources, and store your own sheets</source>
        <translation>Bekannte Platten mit ihren Quellen zeigen und eigene Platten speichern</translation>
    </message>
</context>
<context>
    <name>Elastica_Strip</name>
    <message>
        <source>Strip from sketch</source>
        <translation>Streifen aus Skizze</translation>
    </message>
    <message>
        <source>Make the strip that bends into the selected spline: the bent part and the linked flat part</source>
        <translation>Den Streifen erzeugen, der sich in den gewählten Spline biegt: das gebogene Teil und das damit verknüpfte flache</translation>
    </message>
</context>
<context>
    <name>Elastica_Tolerance</name>
    <message>
        <source>Tolerance study</source>
        <translation>Toleranzstudie</translation>
    </message>
    <message>
        <source>Compute the deviation of the bent strip when sheet, cut and clamps vary within their ranges</source>
        <translation>Abweichung des gebogenen Streifens berechnen, wenn Platte, Schnitt und Klemmen in ihren Bereichen schwanken</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Elastica</source>
        <translation>Elastica</translation>
    </message>
    <message>
        <source>Flat strips that bend into drawn curves</source>
        <translation>Flache Streifen, die sich in gezeichnete Kurven biegen</translation>
    </message>
</context>
<context>
    <name>Elastica_Example</name>
    <message>
        <source>Open an example</source>
        <translation>Ein Beispiel öffnen</translation>
    </message>
    <message>
        <source>Open an example arch with its strip and its flat part, to try changes</source>
        <translation>Einen Beispielbogen mit Streifen und flachem Teil öffnen, um Änderungen auszuprobieren</translation>
    </message>
</context>
<context>
    <name>Elastica_Rails</name>
    <message>
        <source>Rails, ties and loads</source>
        <translation>Schienen, Schnüre und Lasten</translation>
    </message>
    <message>
        <source>Hold the selected strip between its ends by rails, pins and cords, and load it with forces and masses</source>
        <translation>Den gewählten Streifen zwischen seinen Enden mit Schienen, Stiften und Schnüren halten und mit Kräften und Massen belasten</translation>
    </message>
</context>
<context>
    <name>ElasticaRails</name>
    <message>
        <source>Rails, ties and loads</source>
        <translation>Schienen, Schnüre und Lasten</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Kind of the element or load to add</source>
        <translation>Art des Elements oder der Last, die hinzugefügt wird</translation>
    </message>
    <message>
        <source>Place it on the curve</source>
        <translation>Auf die Kurve setzen</translation>
    </message>
    <message>
        <source>Then click the sketch or the strip in the view; for a tie, click both places</source>
        <translation>Dann in der Ansicht auf die Skizze oder den Streifen klicken; für eine Schnur auf beide Stellen</translation>
    </message>
    <message>
        <source>Elements and loads</source>
        <translation>Elemente und Lasten</translation>
    </message>
    <message>
        <source>Choose an element or load to change or remove it</source>
        <translation>Ein Element oder eine Last wählen, um sie zu ändern oder zu entfernen</translation>
    </message>
    <message>
        <source>Place along the curve</source>
        <translation>Stelle entlang der Kurve</translation>
    </message>
    <message>
        <source>Distance along the curve from its start</source>
        <translation>Abstand vom Anfang, entlang der Kurve</translation>
    </message>
    <message>
        <source>Other place</source>
        <translation>Andere Stelle</translation>
    </message>
    <message>
        <source>Distance of the other end of the tie from the start of the curve</source>
        <translation>Abstand des anderen Endes der Schnur vom Anfang der Kurve</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Loch</translation>
    </message>
    <message>
        <source>Diameter of a hole in the strip for a cord or screw; 0 for none</source>
        <translation>Durchmesser eines Lochs im Streifen für eine Schnur oder Schraube; 0 für keines</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Kerben</translation>
    </message>
    <message>
        <source>Width of a notch in each edge of the strip, for two cords; 0 for none</source>
        <translation>Breite einer Kerbe in jeder Kante des Streifens, für zwei Schnüre; 0 für keine</translation>
    </message>
    <message>
        <source>Keep this point</source>
        <translation>Diesen Punkt behalten</translation>
    </message>
    <message>
        <source>Keep the point in space when the curve changes, instead of the distance along the curve</source>
        <translation>Den Punkt im Raum behalten, wenn sich die Kurve ändert, statt des Abstands entlang der Kurve</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen element or load</source>
        <translation>Entfernt das gewählte Element oder die Last</translation>
    </message>
    <message>
        <source>Force along x</source>
        <translation>Kraft entlang x</translation>
    </message>
    <message>
        <source>Force along y</source>
        <translation>Kraft entlang y</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Force along the x axis of the sketch</source>
        <translation>Kraft entlang der x-Achse der Skizze</translation>
    </message>
    <message>
        <source>Force along the y axis of the sketch</source>
        <translation>Kraft entlang der y-Achse der Skizze</translation>
    </message>
    <message>
        <source>Hung mass; it needs the own weight of the strip</source>
        <translation>Angehängte Masse; sie braucht das Eigengewicht des Streifens</translation>
    </message>
</context>
<context>
    <name>Elastica_Flexure</name>
    <message>
        <source>Two-state part</source>
        <translation>Teil mit zwei Zuständen</translation>
    </message>
    <message>
        <source>Make a part that rests in both selected curves, such as a clip that snaps, and the plate that holds it</source>
        <translation>Ein Teil machen, das in beiden gewählten Kurven ruht, etwa eine Klammer, die umschnappt, und die Platte, die es hält</translation>
    </message>
</context>
<context>
    <name>Elastica_Flat</name>
    <message>
        <source>Flat part</source>
        <translation>Flaches Teil</translation>
    </message>
    <message>
        <source>Make the missing flat parts of the selected strips, for example of copied strips</source>
        <translation>Die fehlenden flachen Teile der gewählten Streifen erstellen, etwa von kopierten Streifen</translation>
    </message>
</context>
<context>
    <name>Elastica_Outline</name>
    <message>
        <source>Flat outline</source>
        <translation>Flacher Umriss</translation>
    </message>
    <message>
        <source>Make the outlines of the selected strips as plane faces, for pockets, tool paths and FreeCAD's own DXF files</source>
        <translation>Die Umrisse der gewählten Streifen als ebene Flächen erstellen, für Taschen, Werkzeugwege und FreeCADs eigene DXF-Dateien</translation>
    </message>
</context>
</TS>
