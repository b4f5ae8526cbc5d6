<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>What is off in sheet, cut and clamps, rad and mm: thickness_wave = 0.01, grain = 0.035, clamps = 0.0087, kerf = 0.05</source>
        <translation>Was an Platte, Schnitt und Einspannung nicht stimmt, rad und mm: thickness_wave = 0.01, grain = 0.035, clamps = 0.0087, kerf = 0.05</translation>
    </message>
    <message>
        <source>How far a real strip strays from its design, by the model, what that leaves open, and its sheet</source>
        <translation>Wie weit ein wirklicher Streifen von seinem Entwurf abweicht: laut Modell, durch das, was es offen lässt, und durch die Platte</translation>
    </message>
    <message>
        <source>Taper: kind = "thickness", limits = [3, 8], width = 20; or "rod", "tube"</source>
        <translation>Verjüngung: kind = "thickness", limits = [3, 8], width = 20; oder "rod", "tube"</translation>
    </message>
    <message>
        <source>How it strays as made and held, and by what</source>
        <translation>Wie er, gemacht und gehalten, abweicht und wodurch</translation>
    </message>
    <message>
        <source>Largest distance of the strip, as it is made and held, from its design</source>
        <translation>Größter Abstand des Streifens, wie er gemacht und gehalten ist, von seinem Entwurf</translation>
    </message>
    <message>
        <source>The strips, in the order of assembly</source>
        <translation>Die Streifen in der Reihenfolge des Zusammenbaus</translation>
    </message>
    <message>
        <source>Features that follow what is cut, and are left out</source>
        <translation>Formelemente, die auf das folgen, was geschnitten wird, und ausgelassen sind</translation>
    </message>
    <message>
        <source>Cut slots where strips cross</source>
        <translation>Schlitze, wo Streifen sich kreuzen</translation>
    </message>
    <message>
        <source>Added to the width of every slot</source>
        <translation>Zuschlag zur Breite jedes Schlitzes</translation>
    </message>
    <message>
        <source>Slots as the angle asks for, or as in the paper</source>
        <translation>Schlitze, wie der Winkel sie verlangt, oder wie im Artikel</translation>
    </message>
    <message>
        <source>Inner ends of the slots</source>
        <translation>Innere Enden der Schlitze</translation>
    </message>
    <message>
        <source>Later strips are pushed on from here; zero leaves it open</source>
        <translation>Spätere Streifen werden von hier aufgeschoben; null lässt es offen</translation>
    </message>
    <message>
        <source>How many slots fit into each other</source>
        <translation>Wie viele Schlitze ineinander passen</translation>
    </message>
    <message>
        <source>What was found on the way</source>
        <translation>Was unterwegs gefunden wurde</translation>
    </message>
    <message>
        <source>Strips that run into each other where no slot lets them, found a moment after the rest</source>
        <translation>Streifen, die ineinander laufen, wo kein Schlitz sie lässt; einen Augenblick nach dem Übrigen gefunden</translation>
    </message>
    <message>
        <source>The strip whose flat part this is</source>
        <translation>Der Streifen, dessen flaches Teil dies ist</translation>
    </message>
    <message>
        <source>Of a laminated strip the base, or the backing</source>
        <translation>Vom laminierten Streifen die Grundlage oder die Auflage</translation>
    </message>
    <message>
        <source>The model whose slots it gets; none for a strip by itself</source>
        <translation>Das Modell, dessen Schlitze es bekommt; keines für einen einzelnen Streifen</translation>
    </message>
    <message>
        <source>Sketch, or edges of an object, that the strip follows</source>
        <translation>Skizze oder Kanten eines Objekts, denen der Streifen folgt</translation>
    </message>
    <message>
        <source>What the shape is: the strip as bent, or as cut</source>
        <translation>Was die Form ist: der Streifen gebogen oder wie geschnitten</translation>
    </message>
    <message>
        <source>Material the strip is cut from</source>
        <translation>Material, aus dem der Streifen geschnitten wird</translation>
    </message>
    <message>
        <source>Thickness of the sheet; measure yours</source>
        <translation>Dicke der Platte; messen Sie Ihre</translation>
    </message>
    <message>
        <source>The sheet's numbers, so that the file opens anywhere</source>
        <translation>Die Zahlen der Platte, damit sich die Datei überall öffnet</translation>
    </message>
    <message>
        <source>Width of the widest place; 0 leaves it to MinWidth</source>
        <translation>Breite der breitesten Stelle; 0 überlässt es MinWidth</translation>
    </message>
    <message>
        <source>Width of the narrowest place, or a limit for it; 0 for none</source>
        <translation>Breite der schmalsten Stelle oder eine Grenze dafür; 0 für keine</translation>
    </message>
    <message>
        <source>Narrowest strip, tab or tongue that the workshop can make; 0 for what the sheet takes</source>
        <translation>Schmalster Streifen, schmalste Lasche oder Zunge, die die Werkstatt machen kann; 0 für was die Platte verträgt</translation>
    </message>
    <message>
        <source>Creep factor of the sheet in the long run; 0 leaves creep out</source>
        <translation>Kriechzahl der Platte auf Dauer; 0 lässt das Kriechen weg</translation>
    </message>
    <message>
        <source>Where a closed strip is joined, along its curve; 0 chooses</source>
        <translation>Wo ein geschlossener Streifen verbunden ist, entlang seiner Kurve; 0 wählt</translation>
    </message>
    <message>
        <source>Make up for anticlastic bending in the widths, where the sheet's Poisson ratio is known</source>
        <translation>Querkrümmung in den Breiten ausgleichen, wo die Querdehnzahl der Platte bekannt ist</translation>
    </message>
    <message>
        <source>Make up for slots, narrow tabs and holes in the widths</source>
        <translation>Schlitze, schmale Laschen und Löcher in den Breiten ausgleichen</translation>
    </message>
    <message>
        <source>Make a strip that cannot be cut or handled, and say so</source>
        <translation>Einen Streifen machen, der sich nicht schneiden oder anfassen lässt, und es sagen</translation>
    </message>
    <message>
        <source>Most of ligaments or backing, summed across; 0 for what fits</source>
        <translation>Höchstens so viel Steg oder Auflage, quer summiert; 0 für was passt</translation>
    </message>
    <message>
        <source>How stiffness becomes material</source>
        <translation>Wie aus Steifigkeit Material wird</translation>
    </message>
    <message>
        <source>Width of the outline, perforated or laminated</source>
        <translation>Breite des Umrisses, gelocht oder laminiert</translation>
    </message>
    <message>
        <source>Holes side by side in a perforated strip</source>
        <translation>Löcher nebeneinander in einem gelochten Streifen</translation>
    </message>
    <message>
        <source>Holes one after the other; 0 chooses</source>
        <translation>Löcher hintereinander; 0 wählt</translation>
    </message>
    <message>
        <source>Largest share of the width that holes take</source>
        <translation>Größter Anteil der Breite, den Löcher nehmen</translation>
    </message>
    <message>
        <source>Narrowest ligament between holes</source>
        <translation>Schmalster Steg zwischen Löchern</translation>
    </message>
    <message>
        <source>Widest place of the narrowest hole</source>
        <translation>Breiteste Stelle des schmalsten Lochs</translation>
    </message>
    <message>
        <source>Rounding of the holes' corners</source>
        <translation>Rundung der Lochecken</translation>
    </message>
    <message>
        <source>What the sides of holes are made of</source>
        <translation>Woraus die Seiten der Löcher bestehen</translation>
    </message>
    <message>
        <source>Sheet that is glued on in a laminated strip</source>
        <translation>Platte, die beim laminierten Streifen aufgeklebt wird</translation>
    </message>
    <message>
        <source>The backing's numbers</source>
        <translation>Die Zahlen der Auflage</translation>
    </message>
    <message>
        <source>Narrowest backing of a laminated strip</source>
        <translation>Schmalste Auflage eines laminierten Streifens</translation>
    </message>
    <message>
        <source>Holes in the tabs that align the layers; 0 for none</source>
        <translation>Löcher in den Laschen, die die Lagen ausrichten; 0 für keine</translation>
    </message>
    <message>
        <source>What holds the start of the curve</source>
        <translation>Was den Anfang der Kurve hält</translation>
    </message>
    <message>
        <source>What holds the end of the curve</source>
        <translation>Was das Ende der Kurve hält</translation>
    </message>
    <message>
        <source>Does the strip carry its own weight?</source>
        <translation>Trägt der Streifen sein eigenes Gewicht?</translation>
    </message>
    <message>
        <source>Direction in space in which things fall</source>
        <translation>Richtung im Raum, in die Dinge fallen</translation>
    </message>
    <message>
        <source>Elasto-gravity length; 0 takes the sheet's</source>
        <translation>Elasto-Gravitationslänge; 0 nimmt die der Platte</translation>
    </message>
    <message>
        <source>Masses hung on the strip: at = 90, mass = 3 (mm, g)</source>
        <translation>Angehängte Massen: at = 90, mass = 3 (mm, g)</translation>
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
        <source>Instead of it along the strip: stations = [0, 300], curvatures = [0, 0.01]</source>
        <translation>Stattdessen entlang des Streifens: stations = [0, 300], curvatures = [0, 0.01]</translation>
    </message>
    <message>
        <source>Nodes of the rod; 0 chooses</source>
        <translation>Knoten des Stabs; 0 wählt</translation>
    </message>
    <message>
        <source>Follow the curve exactly, or the nearest one within limits</source>
        <translation>Der Kurve genau folgen oder der nächsten innerhalb von Grenzen</translation>
    </message>
    <message>
        <source>Largest stiffness ratio; 0 for none</source>
        <translation>Größtes Steifigkeitsverhältnis; 0 für keines</translation>
    </message>
    <message>
        <source>Least stability margin; 5 is safely stable</source>
        <translation>Kleinste Stabilitätsreserve; 5 ist sicher stabil</translation>
    </message>
    <message>
        <source>Largest strain in percent; 0 takes the sheet's</source>
        <translation>Größte Dehnung in Prozent; 0 nimmt die der Platte</translation>
    </message>
    <message>
        <source>Does MarginLimit count?</source>
        <translation>Zählt MarginLimit?</translation>
    </message>
    <message>
        <source>Does the strain limit count?</source>
        <translation>Zählt die Dehnungsgrenze?</translation>
    </message>
    <message>
        <source>Largest curvature, 1/mm; 0 for none</source>
        <translation>Größte Krümmung, 1/mm; 0 für keine</translation>
    </message>
    <message>
        <source>Least length; counts with MostLength</source>
        <translation>Kleinste Länge; zählt mit MostLength</translation>
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
        <source>Ground and boxes: point = [0, 0], normal = [0, 1]</source>
        <translation>Boden und Kästen: point = [0, 0], normal = [0, 1]</translation>
    </message>
    <message>
        <source>Along the strip: lower = 1.5, upper = [2, 3, 2]</source>
        <translation>Entlang des Streifens: lower = 1.5, upper = [2, 3, 2]</translation>
    </message>
    <message>
        <source>Which ends stay where they are</source>
        <translation>Welche Enden bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>Keep the tangents of both ends</source>
        <translation>Die Tangenten beider Enden behalten</translation>
    </message>
    <message>
        <source>Whose tangents KeepTangents keeps</source>
        <translation>Wessen Tangenten KeepTangents behält</translation>
    </message>
    <message>
        <source>Keep the length</source>
        <translation>Länge beibehalten</translation>
    </message>
    <message>
        <source>Mirror image or half turn that stays</source>
        <translation>Spiegelbild oder halbe Drehung, die bleibt</translation>
    </message>
    <message>
        <source>Places along the curve that it still passes, mm</source>
        <translation>Stellen entlang der Kurve, durch die sie weiter geht, mm</translation>
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
        <source>Slots: at = 40, width = 1.2, side = 'lower'</source>
        <translation>Schlitze: at = 40, width = 1.2, side = 'lower'</translation>
    </message>
    <message>
        <source>Text engraved on the strip</source>
        <translation>Text, der auf den Streifen graviert wird</translation>
    </message>
    <message>
        <source>How many of it are cut</source>
        <translation>Wie viele davon geschnitten werden</translation>
    </message>
    <message>
        <source>Can a flat strip take the curve?</source>
        <translation>Kann ein flacher Streifen die Kurve annehmen?</translation>
    </message>
    <message>
        <source>Why not, and what else to know</source>
        <translation>Warum nicht, und was sonst zu wissen ist</translation>
    </message>
    <message>
        <source>Largest stiffness over least stiffness</source>
        <translation>Größte durch kleinste Steifigkeit</translation>
    </message>
    <message>
        <source>Stability margin; positive means that it stays</source>
        <translation>Stabilitätsreserve; positiv heißt, dass er bleibt</translation>
    </message>
    <message>
        <source>Where along the strip stability is lost; 0 where it is not</source>
        <translation>Wo am Streifen die Stabilität verloren geht; 0, wo nicht</translation>
    </message>
    <message>
        <source>Largest strain, in percent of what the sheet bears</source>
        <translation>Größte Dehnung in Prozent dessen, was die Platte erträgt</translation>
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
        <source>Hidden until it can be made again</source>
        <translation>Verborgen, bis es sich wieder herstellen lässt</translation>
    </message>
    <message>
        <source>Shown until its model can be made again</source>
        <translation>Sichtbar, bis sich das Modell wieder herstellen lässt</translation>
    </message>
    <message>
        <source>Tells the request that the shape was made from</source>
        <translation>Sagt, aus welcher Anfrage die Form entstand</translation>
    </message>
    <message>
        <source>What the curve moves with</source>
        <translation>Womit sich die Kurve bewegt</translation>
    </message>
    <message>
        <source>A model, or strips, whose tabs go through it</source>
        <translation>Ein Modell oder Streifen, deren Laschen hindurchgehen</translation>
    </message>
    <message>
        <source>What the plate is cut from</source>
        <translation>Woraus die Platte geschnitten wird</translation>
    </message>
    <message>
        <source>The sheet's numbers</source>
        <translation>Die Zahlen der Platte</translation>
    </message>
    <message>
        <source>Room beside a tab on either side</source>
        <translation>Luft neben einer Lasche auf jeder Seite</translation>
    </message>
    <message>
        <source>Added to the width of the slots</source>
        <translation>Zuschlag zur Breite der Schlitze</translation>
    </message>
    <message>
        <source>Least distance of slots from the edge</source>
        <translation>Kleinster Abstand der Schlitze vom Rand</translation>
    </message>
    <message>
        <source>The outline around all slots</source>
        <translation>Der Umriss um alle Schlitze</translation>
    </message>
    <message>
        <source>A model, or strips, whose ends are held</source>
        <translation>Ein Modell oder Streifen, deren Enden gehalten werden</translation>
    </message>
    <message>
        <source>Room around the tab</source>
        <translation>Spiel um die Lasche</translation>
    </message>
    <message>
        <source>Least thickness around the pocket</source>
        <translation>Kleinste Wandstärke um die Tasche</translation>
    </message>
    <message>
        <source>How far the foot sticks out on either side; 0 for none</source>
        <translation>Wie weit der Fuß auf jeder Seite vorsteht; 0 für keinen</translation>
    </message>
    <message>
        <source>Height of the foot</source>
        <translation>Höhe des Fußes</translation>
    </message>
    <message>
        <source>Diameter of the screw holes in the foot; 0 for none</source>
        <translation>Durchmesser der Schraubenlöcher im Fuß; 0 für keine</translation>
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
        <source>Least distance between parts and from the edge</source>
        <translation>Kleinster Abstand zwischen Teilen und vom Rand</translation>
    </message>
    <message>
        <source>How many sheets are needed</source>
        <translation>Wie viele Platten gebraucht werden</translation>
    </message>
    <message>
        <source>Show live feedback while this sketch is open</source>
        <translation>Sofortige Rückmeldung zeigen, während diese Skizze offen ist</translation>
    </message>
    <message>
        <source>Angle that half planes are spread over</source>
        <translation>Winkel, über den Halbebenen verteilt sind</translation>
    </message>
    <message>
        <source>Bodies, surfaces and meshes that are cut</source>
        <translation>Körper, Flächen und Netze, die geschnitten werden</translation>
    </message>
    <message>
        <source>How far a curve may be from the section</source>
        <translation>Wie weit eine Kurve vom Schnitt abweichen darf</translation>
    </message>
    <message>
        <source>How far the curve may be moved to smooth its curvature; 0 follows it as drawn</source>
        <translation>Wie weit die Kurve bewegt werden darf, um ihre Krümmung zu glätten; 0 folgt ihr wie gezeichnet</translation>
    </message>
    <message>
        <source>How far the curve moves at most</source>
        <translation>Wie weit die Kurve sich höchstens bewegt</translation>
    </message>
    <message>
        <source>How far the end is moved along x</source>
        <translation>Wie weit das Ende entlang x verschoben ist</translation>
    </message>
    <message>
        <source>How far the end is moved along y</source>
        <translation>Wie weit das Ende entlang y verschoben ist</translation>
    </message>
    <message>
        <source>How far the end is turned</source>
        <translation>Wie weit das Ende gedreht ist</translation>
    </message>
    <message>
        <source>How far the start is moved along x</source>
        <translation>Wie weit der Anfang entlang x verschoben ist</translation>
    </message>
    <message>
        <source>How far the start is moved along y</source>
        <translation>Wie weit der Anfang entlang y verschoben ist</translation>
    </message>
    <message>
        <source>How far the start is turned</source>
        <translation>Wie weit der Anfang gedreht ist</translation>
    </message>
    <message>
        <source>How many curves there are</source>
        <translation>Wie viele Kurven es sind</translation>
    </message>
    <message>
        <source>How many planes there are</source>
        <translation>Wie viele Ebenen es sind</translation>
    </message>
    <message>
        <source>How the planes stand to each other</source>
        <translation>Wie die Ebenen zueinander stehen</translation>
    </message>
    <message>
        <source>Sketch, wire or edges that planes stand across</source>
        <translation>Skizze, Draht oder Kanten, zu denen die Ebenen quer stehen</translation>
    </message>
    <message>
        <source>The axis of half planes passes here: x</source>
        <translation>Hier geht die Achse der Halbebenen durch: x</translation>
    </message>
    <message>
        <source>The axis of half planes passes here: y</source>
        <translation>Hier geht die Achse der Halbebenen durch: y</translation>
    </message>
    <message>
        <source>The axis of half planes passes here: z</source>
        <translation>Hier geht die Achse der Halbebenen durch: z</translation>
    </message>
    <message>
        <source>The strip that is bent further</source>
        <translation>Der Streifen, der weiter gebogen wird</translation>
    </message>
    <message>
        <source>Waves shorter than this are smoothed away; 0 keeps them</source>
        <translation>Kürzere Wellen als diese werden geglättet; 0 behält sie</translation>
    </message>
    <message>
        <source>What becomes of closed lines</source>
        <translation>Was aus geschlossenen Linien wird</translation>
    </message>
    <message>
        <source>What planes stand across, or half planes about</source>
        <translation>Wozu die Ebenen quer stehen, oder worum Halbebenen</translation>
    </message>
    <message>
        <source>Margin against tipping over sideways, positive where it stays in its plane; 0 where undecided</source>
        <translation>Reserve gegen seitliches Kippen, positiv, wo er in seiner Ebene bleibt; 0, wo es offen ist</translation>
    </message>
    <message>
        <source>Does it stay in the plane of its curve?</source>
        <translation>Bleibt er in der Ebene seiner Kurve?</translation>
    </message>
</context>
<context>
    <name>Elastica</name>
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
        <source>Held deviation</source>
        <translation>Abweichung gehalten</translation>
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
        <source>{strip} is followed by {later}, which these files leave out: make it in the strip itself (slots, tabs, holes), or draw it into the files</source>
        <translation>Auf {strip} folgt {later}, was diese Dateien auslassen: im Streifen selbst anlegen (Schlitze, Laschen, Löcher) oder in die Dateien einzeichnen</translation>
    </message>
    <message>
        <source>{strip} is followed by {later}, which the nest leaves out: make it in the strip itself (slots, tabs, holes), or draw it into the cutting files</source>
        <translation>Auf {strip} folgt {later}, was die Schachtelung auslässt: im Streifen selbst anlegen (Schlitze, Laschen, Löcher) oder in die Schneiddateien einzeichnen</translation>
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
        <source>write the whole path of the folder, or press Browse</source>
        <translation>bitte den ganzen Pfad des Ordners schreiben oder Durchsuchen drücken</translation>
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
        <source>what this panel works on was deleted: press Cancel</source>
        <translation>was dieses Bedienfeld bearbeitet, wurde gelöscht: Abbrechen drücken</translation>
    </message>
    <message>
        <source>tick what is to be made</source>
        <translation>bitte ankreuzen, was erzeugt werden soll</translation>
    </message>
    <message>
        <source>Use the nearest curve</source>
        <translation>Die nächste Kurve nehmen</translation>
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
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Narrowest place</source>
        <translation>Schmalste Stelle</translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation>Steifigkeitsverhältnis</translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>Stability margin</source>
        <translation>Stabilitätsreserve</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
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
        <translation>Nächste Kurve</translation>
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
        <source>Rows of holes (0 = chosen)</source>
        <translation>Reihen von Löchern (0 = gewählt)</translation>
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
        <source>Carries its weight</source>
        <translation>Trägt sein Gewicht</translation>
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
        <translation>Lage</translation>
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
        <translation>Luft neben Laschen</translation>
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
        <translation>elasto-gravitative Länge</translation>
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
        <translation>nächste</translation>
    </message>
    <message>
        <source>Held away by</source>
        <translation>Abgehalten durch</translation>
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
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>Stabilität</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>keep-out</source>
        <translation>Sperrgebiet</translation>
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
        <source>inflections on their line</source>
        <translation>Wendepunkte auf ihrer Linie</translation>
    </message>
    <message>
        <source>can</source>
        <translation>geht</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>kann nicht gemacht werden</translation>
    </message>
    <message>
        <source>too short for its width</source>
        <translation>zu kurz für seine Breite</translation>
    </message>
    <message>
        <source>cannot</source>
        <translation>geht nicht</translation>
    </message>
    <message>
        <source>would break</source>
        <translation>würde brechen</translation>
    </message>
    <message>
        <source>beyond its limit</source>
        <translation>über der Grenze</translation>
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
        <source>Searching the nearest curve</source>
        <translation>Die nächste Kurve wird gesucht</translation>
    </message>
    <message>
        <source>Putting the model together</source>
        <translation>Das Modell wird zusammengesetzt</translation>
    </message>
    <message>
        <source>Making the blocks</source>
        <translation>Die Blöcke werden gemacht</translation>
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
        <source>How many</source>
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
        <source>Must stay in its shape</source>
        <translation>Muss in seiner Form bleiben</translation>
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
        <translation>nächste Kurve</translation>
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
        <translation>Grundlage</translation>
    </message>
    <message>
        <source>hull</source>
        <translation>Hülle</translation>
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
        <source>Takes this feature's place and follows nothing any more</source>
        <translation>Tritt an die Stelle dieses Features und folgt nichts mehr</translation>
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
        <source>Sideways margin</source>
        <translation>Reserve seitlich</translation>
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
        <source>How far the start is moved along x</source>
        <translation>Wie weit der Anfang entlang x verschoben wird</translation>
    </message>
    <message>
        <source>How far the start is moved along y</source>
        <translation>Wie weit der Anfang entlang y verschoben wird</translation>
    </message>
    <message>
        <source>How far the start is turned, degrees</source>
        <translation>Um wie viel Grad der Anfang gedreht wird</translation>
    </message>
    <message>
        <source>How far the end is moved along x</source>
        <translation>Wie weit das Ende entlang x verschoben wird</translation>
    </message>
    <message>
        <source>How far the end is moved along y</source>
        <translation>Wie weit das Ende entlang y verschoben wird</translation>
    </message>
    <message>
        <source>How far the end is turned, degrees</source>
        <translation>Um wie viel Grad das Ende gedreht wird</translation>
    </message>
    <message>
        <source>Show the way from rest in small steps</source>
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
        <translation>Probestreifen und Eichung</translation>
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
        <source>How far a reading may be off</source>
        <translation>Wie weit eine Ablesung daneben liegen kann</translation>
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
        <source>Width that the cut takes away; outlines are set off by half of it</source>
        <translation>Breite, die der Schnitt wegnimmt; Umrisse werden um die Hälfte versetzt</translation>
    </message>
    <message>
        <source>How far arcs and lines may be from the spline</source>
        <translation>Wie weit Bögen und Linien vom Spline abweichen dürfen</translation>
    </message>
    <message>
        <source>Where the files go; asked for where it is empty</source>
        <translation>Wohin die Dateien kommen; wird gefragt, wenn es leer ist</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Den Ordner wählen</translation>
    </message>
    <message>
        <source>Without this nothing that exists is changed</source>
        <translation>Ohne dies wird nichts Vorhandenes geändert</translation>
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
        <translation>Blöcke zum Drucken, mit einer Tasche für jede Lasche</translation>
    </message>
    <message>
        <source>Room around a tab in its pocket</source>
        <translation>Luft um eine Lasche in ihrer Tasche</translation>
    </message>
    <message>
        <source>Least thickness around the pocket</source>
        <translation>Kleinste Dicke um die Tasche</translation>
    </message>
    <message>
        <source>How far the foot sticks out on either side; 0 for none</source>
        <translation>Wie weit der Fuß auf jeder Seite vorsteht; 0 für keinen</translation>
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
        <source>What the plate is cut from</source>
        <translation>Woraus die Platte geschnitten wird</translation>
    </message>
    <message>
        <source>Where the upper face of the plate lies, along z</source>
        <translation>Wo die Oberseite der Platte liegt, entlang z</translation>
    </message>
    <message>
        <source>Room beside a tab on either side</source>
        <translation>Luft neben einer Lasche auf jeder Seite</translation>
    </message>
    <message>
        <source>Added to the width of the slots</source>
        <translation>Zuschlag zur Breite der Schlitze</translation>
    </message>
    <message>
        <source>Least distance of slots from the edge</source>
        <translation>Kleinster Abstand der Schlitze vom Rand</translation>
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
        <translation>Die nächste biegbare Kurve zeigen</translation>
    </message>
    <message>
        <source>Sheet that new strips are made of; a name of the sheet library</source>
        <translation>Platte, aus der neue Streifen sind; ein Name der Plattenbibliothek</translation>
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
        <source>Width that the cut takes away; outlines are set off by half of it</source>
        <translation>Breite, die der Schnitt wegnimmt; Umrisse werden um die Hälfte versetzt</translation>
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
        <source>How far arcs and lines may be from the spline</source>
        <translation>Wie weit Bögen und Linien vom Spline abweichen dürfen</translation>
    </message>
    <message>
        <source>In sketches that strips follow, and in those made from this workbench</source>
        <translation>In Skizzen, denen Streifen folgen, und in denen aus dieser Werkbank</translation>
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
    <name>ElasticaSentences</name>
    <message>
        <source>bent, the backing lies inside at the start (the end at x = 0 of the cutting files), on the other side of the bend beyond each inflection: INSIDE AT START is engraved on both sheets</source>
        <translation>gebogen liegt die Verstärkung am Anfang innen (das Ende bei x = 0 der Schneiddateien), nach jedem Wendepunkt auf der anderen Seite der Biegung: INSIDE AT START ist in beide Platten graviert</translation>
    </message>
    <message>
        <source>bent, the backing lies outside at the start (the end at x = 0 of the cutting files), on the other side of the bend beyond each inflection: OUTSIDE AT START is engraved on both sheets</source>
        <translation>gebogen liegt die Verstärkung am Anfang außen (das Ende bei x = 0 der Schneiddateien), nach jedem Wendepunkt auf der anderen Seite der Biegung: OUTSIDE AT START ist in beide Platten graviert</translation>
    </message>
    <message>
        <source>bent, the backing lies inside: INSIDE is engraved on both sheets, on the faces that look there</source>
        <translation>gebogen liegt die Verstärkung innen: INSIDE ist in beide Platten graviert, auf den Flächen, die dorthin zeigen</translation>
    </message>
    <message>
        <source>bent, the backing lies outside: OUTSIDE is engraved on both sheets, on the faces that look there</source>
        <translation>gebogen liegt die Verstärkung außen: OUTSIDE ist in beide Platten graviert, auf den Flächen, die dorthin zeigen</translation>
    </message>
    <message>
        <source>loads hang where gravity pulls in the plane of the curve: give gravity=True or a direction in that plane, or leave loads out</source>
        <translation>Lasten hängen, wo die Schwerkraft in der Ebene der Kurve zieht: Gravity setzen, mit GravityDirection in dieser Ebene, oder die Lasten weglassen</translation>
    </message>
    <message>
        <source>a laminate that carries its weight follows its curve exactly, from flat sheets: leave out limits, keep and natural_curvature, or gravity</source>
        <translation>ein Laminat, das sein Gewicht trägt, folgt seiner Kurve genau, aus flachen Platten: Follow auf Exactly und NaturalCurvature auf 0 setzen, oder die Schwerkraft weglassen</translation>
    </message>
    <message>
        <source>samples are of a strip that follows its curve exactly: leave limits and keep out, or samples</source>
        <translation>Stützstellen (Samples) hat ein Streifen, der seiner Kurve genau folgt: Follow auf Exactly setzen, oder Samples weglassen</translation>
    </message>
    <message>
        <source>a strip with loads hung on it follows its curve exactly: leave limits and keep out, or the loads</source>
        <translation>ein Streifen, an dem Lasten hängen, folgt seiner Kurve genau: Follow auf Exactly setzen, oder die Lasten weglassen</translation>
    </message>
    <message>
        <source>%1: %2 cannot be read: write keys and values, such as %3</source>
        <translation>%1: %2 ist nicht zu lesen: Schlüssel und Werte schreiben, wie %3</translation>
    </message>
    <message>
        <source>a point mass is %1: it can't be negative, in g</source>
        <translation>eine Punktmasse ist %1: sie kann nicht negativ sein, in g</translation>
    </message>
    <message>
        <source>Least%1 is %2 mm and Most%3 is %4 mm: give both, the least above 0 and not above the most</source>
        <translation>Least%1 ist %2 mm und Most%3 ist %4 mm: beide angeben, das kleinste über 0 und nicht über dem größten</translation>
    </message>
    <message>
        <source>sheet %1: thickness is %2; it must be positive, in mm</source>
        <translation>Platte %1: die Dicke ist %2; sie muss positiv sein, in mm</translation>
    </message>
    <message>
        <source>samples is %1: it must be a whole number, %2 or more</source>
        <translation>Samples ist %1: es muss eine ganze Zahl ab %2 sein</translation>
    </message>
    <message>
        <source>creep is %1: it must be 0 or more; plywood indoors has %2 (Eurocode 5)</source>
        <translation>Creep ist %1: es muss 0 oder mehr sein; Sperrholz in Innenräumen hat %2 (Eurocode 5)</translation>
    </message>
    <message>
        <source>the width of the base is %1: it must be positive, in mm</source>
        <translation>die Breite der Grundlage ist %1: sie muss positiv sein, in mm</translation>
    </message>
    <message>
        <source>deeper</source>
        <translation>tiefer</translation>
    </message>
    <message>
        <source>shallower or narrower</source>
        <translation>flacher oder schmaler</translation>
    </message>
    <message>
        <source>%1 is %2: use one of %3</source>
        <translation>%1 ist %2: eines von diesen nehmen: %3</translation>
    </message>
    <message>
        <source>tab length is %1: it must be 0 mm or more</source>
        <translation>die Länge der Lasche ist %1: sie muss 0 mm oder mehr sein</translation>
    </message>
    <message>
        <source>tab length is %1: use 0 for no tab, or %2 mm or more</source>
        <translation>die Länge der Lasche ist %1: 0 für keine Lasche nehmen, sonst %2 mm oder mehr</translation>
    </message>
    <message>
        <source>glued leaves go in steps, so no stack follows a drawn curve exactly: give limits or keep, such as keep=Keep(), or call nearest_rod, and the nearest stack is found</source>
        <translation>Geklebte Blätter gehen in Stufen, darum folgt kein Stapel einer gezeichneten Kurve genau: Gib Grenzen oder was bleiben soll (wie keep=Keep()) an, oder rufe nearest_rod auf, dann wird der nächste Stapel gefunden</translation>
    </message>
    <message>
        <source>the blank is %1 mm long before it is bent, the curve %2 mm: give its curvature along the length of the curve</source>
        <translation>der Rohling ist vor dem Biegen %1 mm lang, die Kurve %2 mm: seine Krümmung über die Länge der Kurve angeben</translation>
    </message>
    <message>
        <source>a rest curvature is given at two or more stations, one curvature each: begin at 0 mm, go on to the length of the strip, and name a station twice at most, for a step between the ends</source>
        <translation>eine Krümmung vor dem Biegen wird an zwei oder mehr Stellen angegeben, je eine Krümmung: bei 0 mm beginnen, bis zur Länge des Streifens gehen und eine Stelle höchstens zweimal nennen, für einen Sprung zwischen den Enden</translation>
    </message>
    <message>
        <source>the blank has a corner at %1 mm: round it, a strip has none</source>
        <translation>der Rohling hat bei %1 mm eine Ecke: abrunden, ein Streifen hat keine</translation>
    </message>
    <message>
        <source>the law is of %1, the strip of %2: give both the same sheet</source>
        <translation>das Gesetz ist aus %1, der Streifen aus %2: beiden dasselbe Material geben</translation>
    </message>
    <message>
        <source>a law says what the section is and how large: leave out style, slots, max_width and min_width, and give tabs a length only, or leave out law</source>
        <translation>ein Gesetz sagt, was der Querschnitt ist und wie groß: style, slots, max_width und min_width weglassen und den Laschen nur eine Länge geben, oder law weglassen</translation>
    </message>
    <message>
        <source>The curve is on the border of what a strip can take: near %1 mm the stiffness would have to be more than %2 times that of other places. Move the curve farther from the line through its inflections, or bend it more clearly there.</source>
        <translation>Die Kurve liegt an der Grenze dessen, was ein Streifen annehmen kann: bei %1 mm müsste die Steifigkeit mehr als das %2-Fache anderer Stellen sein. Rücken Sie die Kurve weiter von der Geraden durch ihre Wendepunkte ab, oder biegen Sie sie dort deutlicher.</translation>
    </message>
    <message>
        <source>Rods of another shape are as near, but for 2 % (%1 of them): look at `ties`, and draw the curve closer to the one you mean.</source>
        <translation>Stäbe anderer Form sind bis auf 2 % ebenso nah (%1 davon): siehe `ties`, und zeichnen Sie die Kurve näher an dem, den Sie meinen.</translation>
    </message>
    <message>
        <source>strain %1 % is more than %2 % of what the sheet bears: creep is not linear there, and more than said; use a thinner sheet or a gentler curve</source>
        <translation>Die Dehnung von %1 % ist mehr als %2 % dessen, was die Platte verträgt: dort kriecht sie nicht mehr linear und mehr als gesagt; nehmen Sie eine dünnere Platte oder eine sanftere Kurve</translation>
    </message>
    <message>
        <source>with a creep factor of %1 it will not stay in the long run: it snaps into another shape; use a stiffer sheet or support it</source>
        <translation>mit einer Kriechzahl von %1 bleibt er auf Dauer nicht so: er schnappt in eine andere Form um; nehmen Sie eine steifere Platte oder stützen Sie ihn</translation>
    </message>
    <message>
        <source>section is %1: give a law with limits, such as ThicknessLaw(sheet, 3, 8, width=20)</source>
        <translation>Querschnitt ist %1: ein Gesetz mit Grenzen angeben, etwa ThicknessLaw(sheet, 3, 8, width=20)</translation>
    </message>
    <message>
        <source>compensate is %1: give True for all that widths can make up for, False for nothing, or leave it out</source>
        <translation>Ausgleich (compensate) ist %1: True für alles, was Breiten ausgleichen können, False für nichts angeben, oder weglassen</translation>
    </message>
    <message>
        <source>, its widths made for anticlastic bending,</source>
        <translation>, mit Breiten, die die Querkrümmung ausgleichen,</translation>
    </message>
    <message>
        <source>%1: poisson_ratio is given twice; leave out %2, now that it is known</source>
        <translation>%1: poisson_ratio ist doppelt angegeben; %2 weglassen, da sie nun bekannt ist</translation>
    </message>
    <message>
        <source>ignore_limits must be True or False, got %1</source>
        <translation>ignore_limits muss True oder False sein, nicht %1</translation>
    </message>
    <message>
        <source>, without its correction</source>
        <translation>, ohne seinen Ausgleich</translation>
    </message>
    <message>
        <source>; each cause alone%1: %2</source>
        <translation>; jede Ursache für sich%1: %2</translation>
    </message>
    <message>
        <source>side is %1: give 1 for left of the way from start to end, -1 for right</source>
        <translation>Seite ist %1: 1 für links des Weges vom Anfang zum Ende, -1 für rechts angeben</translation>
    </message>
    <message>
        <source>a strip of %1 mm does not bend between ends %2 mm apart: make it longer, and the ends two places</source>
        <translation>ein Streifen von %1 mm biegt sich nicht zwischen Enden im Abstand von %2 mm: länger machen, und die Enden an zwei Orte</translation>
    </message>
    <message>
        <source>bulges to the right</source>
        <translation>wölbt sich rechts</translation>
    </message>
    <message>
        <source>bulges to the left</source>
        <translation>wölbt sich links</translation>
    </message>
    <message>
        <source>the strip is straight</source>
        <translation>der Streifen ist gerade</translation>
    </message>
    <message>
        <source>the strip's free end goes %1, with %2 inflections (mode %3)</source>
        <translation>das freie Ende des Streifens geht %1, mit %2 Wendepunkten (Mode %3)</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>a strip whose end is free turns about its start: give the angle of a clamp there</source>
        <translation>ein Streifen mit freiem Ende dreht sich um seinen Anfang: dort den Winkel einer Einspannung angeben</translation>
    </message>
    <message>
        <source>a force moves a free end, and this one is held: give None for the end, or no force</source>
        <translation>eine Kraft bewegt ein freies Ende, und dieses ist gehalten: für das Ende None angeben, oder keine Kraft</translation>
    </message>
    <message>
        <source>the strip %1 of its chord, with %2 inflections (mode %3)</source>
        <translation>der Streifen %1 seiner Sehne, mit %2 Wendepunkten (Mode %3)</translation>
    </message>
    <message>
        <source>it takes no shape near its design: hold it nearer to its curve</source>
        <translation>er nimmt keine Form nahe seinem Entwurf an: näher an seiner Kurve halten</translation>
    </message>
    <message>
        <source>the curve is open: only a closed one can begin anywhere</source>
        <translation>die Kurve ist offen: nur eine geschlossene kann irgendwo beginnen</translation>
    </message>
    <message>
        <source>the curve cannot begin at %1 mm: it is %2 mm long; give a place along it</source>
        <translation>die Kurve kann nicht bei %1 mm beginnen: sie ist %2 mm lang; eine Stelle auf ihr angeben</translation>
    </message>
    <message>
        <source>the curve is closed with a corner of %1 degrees at %2: a strip bends without kinks; round it, or leave a gap between its ends%3</source>
        <translation>die Kurve schließt sich mit einer Ecke von %1 Grad bei %2: ein Streifen biegt sich ohne Knick; sie abrunden oder eine Lücke zwischen den Enden lassen%3</translation>
    </message>
    <message>
        <source>The curve is closed and begins where it is not bent, so places are counted from %1, %2 mm after its start.</source>
        <translation>Die Kurve ist geschlossen und beginnt, wo sie nicht gebogen ist; Stellen zählen daher ab %1, %2 mm nach ihrem Anfang.</translation>
    </message>
    <message>
        <source>a closed strip is of one sheet of even thickness, which its lap can join: take a plain or perforated strip, or leave a gap between its ends</source>
        <translation>ein geschlossener Streifen ist aus einer Platte gleicher Dicke, die seine Überlappung verbinden kann: einen einfachen oder gelochten Streifen nehmen oder eine Lücke zwischen den Enden lassen</translation>
    </message>
    <message>
        <source>its ends are %1 and %2 mm wide where it closes: choose another joint, leave out gravity, or make the curvature continuous there</source>
        <translation>seine Enden sind %1 und %2 mm breit, wo er sich schließt: eine andere Verbindungsstelle wählen, die Schwerkraft weglassen oder die Krümmung dort stetig machen</translation>
    </message>
    <message>
        <source>glue its tab of %1 mm, bent as drawn, behind its start</source>
        <translation>seine Lasche von %1 mm, gebogen wie gezeichnet, hinter den Anfang kleben</translation>
    </message>
    <message>
        <source>join its ends butt to butt</source>
        <translation>seine Enden stumpf verbinden</translation>
    </message>
    <message>
        <source>closed: %1 at %2, where it is %3 mm wide; the joint carries %4 N mm and %5 N</source>
        <translation>geschlossen: %1 bei %2, wo er %3 mm breit ist; die Verbindung trägt %4 N mm und %5 N</translation>
    </message>
    <message>
        <source>joint is %1 mm, but the curve is open and begins at its own end: leave joint out, or close the curve</source>
        <translation>die Verbindungsstelle ist %1 mm, aber die Kurve ist offen und beginnt an ihrem eigenen Ende: die Verbindungsstelle weglassen oder die Kurve schließen</translation>
    </message>
    <message>
        <source>joint is %1: give a place along the curve, 0 to %2 mm, or none</source>
        <translation>die Verbindungsstelle ist %1: eine Stelle entlang der Kurve angeben, 0 bis %2 mm, oder keine</translation>
    </message>
    <message>
        <source>lap joint</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>plates</source>
        <translation>Platten über den Stößen</translation>
    </message>
    <message>
        <source>steps of width</source>
        <translation>Stufen der Breite</translation>
    </message>
    <message>
        <source>anticlastic bending</source>
        <translation>Querkrümmung</translation>
    </message>
    <message>
        <source>leaning ligaments</source>
        <translation>schräge Stege</translation>
    </message>
    <message>
        <source>narrow tabs</source>
        <translation>schmale Laschen</translation>
    </message>
    <message>
        <source>slots</source>
        <translation>Schlitze</translation>
    </message>
    <message>
        <source>%1 mm by %2</source>
        <translation>%1 mm durch %2</translation>
    </message>
    <message>
        <source>as made and held%1 the strip strays about %2 mm from its design, %3 % of its length%4: the model says %5 mm and leaves %6 mm open, and sheet, cut and clamps add %7 mm%8</source>
        <translation>so wie er gemacht und gehalten ist%1, weicht der Streifen etwa %2 mm von seinem Entwurf ab, %3 % seiner Länge%4: Das Modell sagt %5 mm und lässt %6 mm offen, und Platte, Schnitt und Einspannung tragen %7 mm bei%8</translation>
    </message>
    <message>
        <source>, most of it from the sheet</source>
        <translation>, das meiste davon durch die Platte</translation>
    </message>
    <message>
        <source>, most of it as modelled</source>
        <translation>, das meiste davon laut Modell</translation>
    </message>
    <message>
        <source>, most of it left open by the model</source>
        <translation>, das meiste davon lässt das Modell offen</translation>
    </message>
    <message>
        <source>Friction in the pockets is not counted</source>
        <translation>Reibung in den Taschen ist nicht gerechnet</translation>
    </message>
    <message>
        <source>its widths do not make up for how it is made, since it would then be %1; give it tabs as wide as its ends, or shallower slots</source>
        <translation>Die Breiten gleichen nicht aus, wie er gemacht ist, denn dann wäre er %1; geben Sie ihm Laschen, so breit wie seine Enden, oder flachere Schlitze</translation>
    </message>
    <message>
        <source>Every line through the inflection at %1 mm meets the curve again or touches it there (the curve is in the way %2): wind the curve less, or support the strip between.</source>
        <translation>Jede Gerade durch den Wendepunkt bei %1 mm trifft die Kurve noch einmal oder berührt sie dort (die Kurve ist %2 im Weg): die Kurve weniger winden oder den Streifen dazwischen stützen.</translation>
    </message>
    <message>
        <source>%1%2 %3, where the moment would vanish or change sign and the curvature does not: move the curve off the line there, or support the strip between there and the inflections beside it.</source>
        <translation>%1%2 %3; dort müsste das Moment verschwinden oder das Vorzeichen wechseln, die Krümmung tut es nicht: die Kurve dort von der Geraden wegziehen oder den Streifen zwischen dort und den Wendepunkten daneben stützen.</translation>
    </message>
    <message>
        <source>Its inflections do not lie on one %1line: those %2 are %3 mm off the nearest one%4. Move them onto one line, or support the strip between them.</source>
        <translation>Die Wendepunkte liegen nicht auf einer %1Geraden: die %2 sind %3 mm neben der nächsten%4. Auf eine Gerade ziehen oder den Streifen dazwischen stützen.</translation>
    </message>
    <message>
        <source>the line through its inflections</source>
        <translation>die Gerade durch die Wendepunkte</translation>
    </message>
    <message>
        <source>the %1line that the supports ask for</source>
        <translation>die %1Gerade, die die Lager verlangen</translation>
    </message>
    <message>
        <source>(at most %1 mm is put right without asking)</source>
        <translation>(höchstens %1 mm werden ungefragt berichtigt)</translation>
    </message>
    <message>
        <source>undecided at this precision: the curve turns by %1 degrees at %2, %3 along it, and the digits of the file alone can turn its handle of %4 mm by %5: save it with more decimals, or make the node smooth with longer handles</source>
        <translation>bei dieser Genauigkeit unentschieden: die Kurve dreht um %1 Grad bei %2, %3 entlang ihr, und schon die Stellen der Datei können ihren Griff von %4 mm um %5 drehen: mit mehr Nachkommastellen speichern oder den Knoten glatt machen, mit längeren Griffen</translation>
    </message>
    <message>
        <source>The piece from %1 to %2 mm %3 and joined to a bent one, so the stiffness would have to go to 0 at the joint</source>
        <translation>Das Stück von %1 bis %2 mm %3 und stößt an ein gebogenes; dort müsste die Steifigkeit null werden</translation>
    </message>
    <message>
        <source>The curve crosses itself (at %1 mm): two parts of the strip must pass side by side there.</source>
        <translation>Die Kurve kreuzt sich selbst (bei %1 mm): zwei Teile des Streifens müssen dort nebeneinander vorbei.</translation>
    </message>
    <message>
        <source>less the natural %1</source>
        <translation>weniger die eigene %1</translation>
    </message>
    <message>
        <source>The %1 (at %2 mm) is free to turn, so the curve must have no curvature there; it has %3 1/mm%4: clamp this end, or let the curvature run out to zero.</source>
        <translation>%1 (bei %2 mm) kann sich frei drehen, die Kurve darf dort also keine Krümmung haben; sie hat %3 1/mm%4: dieses Ende einspannen oder die Krümmung auf null auslaufen lassen.</translation>
    </message>
    <message>
        <source>The width of the strip steps %1, where the curvature jumps: smooth = 0.1, or --smooth 0.1, makes it a fair curve of degree 4 within 0.1 mm.</source>
        <translation>Die Breite des Streifens springt %1, wo die Krümmung springt: die Eigenschaft Smooth = 0.1 macht daraus eine glatte Kurve vierten Grades innerhalb von 0.1 mm.</translation>
    </message>
    <message>
        <source>smooth = 0.1, or --smooth 0.1, makes it a fair curve of degree 4 within 0.1 mm</source>
        <translation>die Eigenschaft Smooth = 0.1 macht daraus eine glatte Kurve vierten Grades innerhalb von 0.1 mm</translation>
    </message>
    <message>
        <source>do not repeat the knot there</source>
        <translation>den Knoten dort nicht wiederholen</translation>
    </message>
    <message>
        <source>The width of the strip has a kink %1, where the slope of the curvature jumps: %2.</source>
        <translation>Die Breite des Streifens hat einen Knick %1, wo die Änderung der Krümmung springt: %2.</translation>
    </message>
    <message>
        <source>crosses the curve %1</source>
        <translation>kreuzt die Kurve %1</translation>
    </message>
    <message>
        <source>touches the curve %1</source>
        <translation>berührt die Kurve %1</translation>
    </message>
    <message>
        <source>is tangent to the curve in the inflection %1</source>
        <translation>berührt die Kurve im Wendepunkt %1</translation>
    </message>
    <message>
        <source>no small move of the control points brings the inflections onto one line</source>
        <translation>keine kleine Bewegung der Kontrollpunkte bringt die Wendepunkte auf eine Gerade</translation>
    </message>
    <message>
        <source>A flat strip cannot take this curve of %1 mm.</source>
        <translation>Ein flacher Streifen kann diese Kurve von %1 mm nicht annehmen.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>A strip of any width takes this curve of %1 mm: it is not bent.</source>
        <translation>Ein Streifen jeder Breite nimmt diese Kurve von %1 mm an: sie ist nicht gebogen.</translation>
    </message>
    <message>
        <source>A flat strip can take this curve of %1 mm; it has %2, %3.</source>
        <translation>Ein flacher Streifen kann diese Kurve von %1 mm annehmen; sie hat %2, %3.</translation>
    </message>
    <message>
        <source>A flat strip can take this curve of %1 mm; it has no inflections.</source>
        <translation>Ein flacher Streifen kann diese Kurve von %1 mm annehmen; sie hat keine Wendepunkte.</translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked cannot take this curve of %1 mm.</source>
        <translation>Ein wie verlangt vorgebogener Streifen kann diese Kurve von %1 mm nicht annehmen.</translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked has this curve of %1 mm already.</source>
        <translation>Ein wie verlangt vorgebogener Streifen hat diese Kurve von %1 mm bereits.</translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked can take this curve of %1 mm; its bending does not change sign.</source>
        <translation>Ein wie verlangt vorgebogener Streifen kann diese Kurve von %1 mm annehmen; seine Biegung wechselt das Vorzeichen nicht.</translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked can take this curve of %1 mm; its bending changes sign %2.</source>
        <translation>Ein wie verlangt vorgebogener Streifen kann diese Kurve von %1 mm annehmen; seine Biegung wechselt das Vorzeichen %2.</translation>
    </message>
    <message>
        <source>Under its weight an unbent strip sags, unless it is upright: draw the shape it may hang in.</source>
        <translation>Unter seinem Gewicht hängt ein ungebogener Streifen durch, außer er steht senkrecht: die Form zeichnen, in der er hängen darf.</translation>
    </message>
    <message>
        <source>a weight in newtons needs gravity too: pass gravity=Gravity(...) for its direction</source>
        <translation>ein Gewicht in Newton braucht auch die Schwerkraft: Gravity einschalten</translation>
    </message>
    <message>
        <source>The curve was moved by at most %1 mm to bring its inflections onto one line.</source>
        <translation>Die Kurve wurde um höchstens %1 mm bewegt, um ihre Wendepunkte auf eine Gerade zu bringen.</translation>
    </message>
    <message>
        <source>The curve was moved by at most %1 mm to take the last bend out of its ends.</source>
        <translation>Die Kurve wurde um höchstens %1 mm bewegt, damit ihre Enden gar nicht mehr gebogen sind.</translation>
    </message>
    <message>
        <source>The weight is far too much for the stiffness (a gravity length of %1 mm on a curve of %2 mm): use a lighter or stiffer sheet, or look at the units (200 gsm card: 96 mm).</source>
        <translation>Das Gewicht ist viel zu groß für die Steifigkeit (eine Schwerelänge von %1 mm bei einer Kurve von %2 mm): leichteres oder steiferes Material nehmen oder die Einheiten prüfen (Karton 200 g/m²: 96 mm).</translation>
    </message>
    <message>
        <source>point mass of %1 g at %2 mm does not lie on the curve of %3 mm</source>
        <translation>die Punktmasse von %1 g bei %2 mm liegt nicht auf der Kurve von %3 mm</translation>
    </message>
    <message>
        <source>in balance but it will not stay: it snaps into another shape</source>
        <translation>im Gleichgewicht, aber er bleibt nicht so: er schnappt in eine andere Form</translation>
    </message>
    <message>
        <source>it stays, but a push, a loose clamp or a cut that is off may make it snap</source>
        <translation>er bleibt, aber ein Stoß, eine lose Klemme oder ein ungenauer Schnitt kann ihn schnappen lassen</translation>
    </message>
    <message>
        <source>it stays, and comes back when pushed</source>
        <translation>er bleibt und kommt zurück, wenn man ihn stößt</translation>
    </message>
    <message>
        <source>the rod snaps %1 of the way from its present shape; here it comes to rest</source>
        <translation>der Stab schnappt nach %1 des Weges von seiner jetzigen Form; hier kommt er zur Ruhe</translation>
    </message>
    <message>
        <source>no rest shape found: %1 of the way from the present shape was possible; move the ends in smaller steps, or give a guess nearer to the answer</source>
        <translation>keine Ruhelage gefunden: %1 des Weges von der jetzigen Form war möglich; die Enden in kleineren Schritten bewegen</translation>
    </message>
    <message>
        <source>the ends are %1 mm apart, but the rod is only %2 mm long: bring them closer or use a longer rod</source>
        <translation>die Enden sind %1 mm auseinander, der Stab ist aber nur %2 mm lang: sie näher zusammenbringen oder einen längeren Stab nehmen</translation>
    </message>
    <message>
        <source>the ends are as far apart as the rod is long (%1 mm), so it must be straight, which its end angles or its weight do not allow: bring the ends closer together</source>
        <translation>die Enden sind so weit auseinander, wie der Stab lang ist (%1 mm); er müsste gerade sein, was seine Endwinkel oder sein Gewicht nicht zulassen: die Enden näher zusammenbringen</translation>
    </message>
    <message>
        <source>a force along %1 does nothing: both ends hold %2; free one end along %3</source>
        <translation>eine Kraft entlang %1 bewirkt nichts: beide Enden halten %2; ein Ende entlang %3 freigeben</translation>
    </message>
    <message>
        <source>both ends turn freely: give the moments of both, (start, end)</source>
        <translation>beide Enden drehen frei: die Momente beider geben (Anfang, Ende)</translation>
    </message>
    <message>
        <source>a moment at the %1 does nothing: its support holds the angle; free the angle there</source>
        <translation>ein Moment an %1 bewirkt nichts: das Lager hält den Winkel; ihn dort freigeben</translation>
    </message>
    <message>
        <source>the slot for %1%2 is %3 mm wide for a tab of %4 mm, which it cannot hold</source>
        <translation>der Schlitz für %1%2 ist %3 mm breit für eine Lasche von %4 mm, die er nicht halten kann</translation>
    </message>
    <message>
        <source>end the strips steeper to the plate, take a thinner plate, or hold them by end fixtures</source>
        <translation>die Streifen steiler auf die Platte treffen lassen, eine dünnere Platte nehmen oder sie mit Endhaltern halten</translation>
    </message>
    <message>
        <source>beside the tab of %1 the strip would stand %2 mm deep in the plate</source>
        <translation>neben der Lasche von %1 stünde der Streifen %2 mm tief in der Platte</translation>
    </message>
    <message>
        <source>give it a tab as wide as the strip, or set the plate so much lower</source>
        <translation>ihm eine Lasche geben, die so breit ist wie der Streifen, oder die Platte um so viel tiefer legen</translation>
    </message>
    <message>
        <source>make it wider (max_width), or ask for the nearest curve with a smaller ratio</source>
        <translation>ihn breiter machen (MaxWidth) oder die nächste Kurve mit kleinerem Verhältnis nehmen</translation>
    </message>
    <message>
        <source>ligaments down to %1 mm are allowed, %2 mm are needed</source>
        <translation>Stege bis hinab zu %1 mm sind erlaubt, %2 mm sind nötig</translation>
    </message>
    <message>
        <source>%1 mm long and %2 mm wide: too slender to handle</source>
        <translation>%1 mm lang und %2 mm breit: zu schlank, um es zu handhaben</translation>
    </message>
    <message>
        <source>(and %1 more)</source>
        <translation>(und %1 weitere)</translation>
    </message>
    <message>
        <source>only %1 mm wide %2%3, %4 mm are needed in %5</source>
        <translation>nur %1 mm breit %2%3, in %5 sind %4 mm nötig</translation>
    </message>
    <message>
        <source>(and %1 more places)</source>
        <translation>(und an %1 weiteren Stellen)</translation>
    </message>
    <message>
        <source>at %1 mm along it</source>
        <translation>bei %1 mm entlang</translation>
    </message>
    <message>
        <source>at (%1, %2) mm</source>
        <translation>bei (%1, %2) mm</translation>
    </message>
    <message>
        <source>ask for wider ligaments, or fewer columns</source>
        <translation>breitere Stege verlangen oder weniger Spalten</translation>
    </message>
    <message>
        <source>make it wider, or split it</source>
        <translation>es breiter machen oder zerteilen</translation>
    </message>
    <message>
        <source>leave more room between the slots: a larger ring or plate, fewer or narrower strips, a wider border</source>
        <translation>zwischen den Schlitzen mehr Platz lassen: ein größerer Ring oder eine größere Platte, weniger oder schmalere Streifen, ein breiterer Rand</translation>
    </message>
    <message>
        <source>%1 x %2 mm is larger than the stock of %3 mm in %4</source>
        <translation>%1 x %2 mm ist größer als das Rohmaterial von %3 mm in %4</translation>
    </message>
    <message>
        <source>name a larger stock, split it, or scale the curve</source>
        <translation>größeres Rohmaterial nennen, zerteilen oder die Kurve verkleinern</translation>
    </message>
    <message>
        <source>the stock is %1: give the two sides of the sheet in mm</source>
        <translation>das Rohmaterial ist %1: die beiden Seiten der Platte in mm angeben</translation>
    </message>
    <message>
        <source>%1 is %2: give a positive width in mm</source>
        <translation>%1 ist %2: eine positive Breite in mm angeben</translation>
    </message>
    <message>
        <source>the laminate cannot be as soft as it should at %1 mm (base %2 mm, K %3) and as stiff at %4 mm (base %5 mm, K %6):</source>
        <translation>das Laminat kann bei %1 mm nicht so weich (Grundlage %2 mm, K %3) und bei %4 mm nicht so steif sein, wie es sollte (Grundlage %5 mm, K %6):</translation>
    </message>
    <message>
        <source>narrow the base at %1 mm</source>
        <translation>die Grundlage bei %1 mm schmaler machen</translation>
    </message>
    <message>
        <source>widen it at %1 mm</source>
        <translation>sie bei %1 mm breiter machen</translation>
    </message>
    <message>
        <source>the width of the base</source>
        <translation>die Breite der Grundlage</translation>
    </message>
    <message>
        <source>make the backing %1 times as thick as the base or more (now %2 times)</source>
        <translation>die Verstärkung %1-mal so dick wie die Grundlage machen oder dicker (jetzt %2-mal)</translation>
    </message>
    <message>
        <source>dots are %1 mm across: give a diameter, 0 for none</source>
        <translation>die Punkte sind %1 mm groß: einen Durchmesser angeben, 0 für keine</translation>
    </message>
    <message>
        <source>the base is %1 mm wide at %2 mm, narrower than the least backing of %3 mm: widen it there</source>
        <translation>die Grundlage ist bei %2 mm %1 mm breit, schmaler als die kleinste Verstärkung von %3 mm: sie dort breiter machen</translation>
    </message>
    <message>
        <source>a backing of at least %1 mm at %2 mm is wider than max_width %3 mm at %4 mm: raise max_width</source>
        <translation>eine Verstärkung von mindestens %1 mm bei %2 mm ist breiter als MaxWidth %3 mm bei %4 mm: MaxWidth erhöhen</translation>
    </message>
    <message>
        <source>choose other widths (%1)</source>
        <translation>andere Breiten wählen (%1)</translation>
    </message>
    <message>
        <source>%1, when holes still fit at %2 mm: %3</source>
        <translation>%1, wenn bei %2 mm noch Löcher hineinpassen: %3</translation>
    </message>
    <message>
        <source>ligaments would be %1 mm wide at %2 mm, below %3 mm</source>
        <translation>Stege wären bei %2 mm %1 mm breit, unter %3 mm</translation>
    </message>
    <message>
        <source>the width of the outline</source>
        <translation>die Breite des Umrisses</translation>
    </message>
    <message>
        <source>make the outline %1 mm or more wide there (now %2 mm)</source>
        <translation>den Umriss dort %1 mm oder breiter machen (jetzt %2 mm)</translation>
    </message>
    <message>
        <source>holes would take %1 % of the width at %2 mm, more than %3 %</source>
        <translation>Löcher nähmen bei %2 mm %1 % der Breite ein, mehr als %3 %</translation>
    </message>
    <message>
        <source>hole_ratio is %1: it must lie between 0 and 1</source>
        <translation>HoleRatio ist %1: es muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>sides are "spline" or "arc", not %1</source>
        <translation>Seiten sind "spline" oder "arc", nicht %1</translation>
    </message>
    <message>
        <source>the outline is %1 mm wide at %2 mm: %3 ligaments of %4 mm and %5 columns of holes need more than %6 mm; widen it or use fewer columns</source>
        <translation>der Umriss ist bei %2 mm %1 mm breit: %3 Stege von %4 mm und %5 Lochspalten brauchen mehr als %6 mm; ihn verbreitern oder weniger Spalten nehmen</translation>
    </message>
    <message>
        <source>use a thinner or softer sheet</source>
        <translation>dünneres oder weicheres Material nehmen</translation>
    </message>
    <message>
        <source>%1: the ligaments need %2 mm in all where they are widest, not %3 mm; %4</source>
        <translation>%1: die Stege brauchen an der breitesten Stelle insgesamt %2 mm, nicht %3 mm; %4</translation>
    </message>
    <message>
        <source>the ligaments are %1 mm in all at the narrowest place, below min_width %2 mm: widen the outline or lower the stiffness ratio</source>
        <translation>die Stege sind an der schmalsten Stelle insgesamt %1 mm breit, unter MinWidth %2 mm: den Umriss verbreitern oder das Steifigkeitsverhältnis senken</translation>
    </message>
    <message>
        <source>allow a hole_ratio of %1</source>
        <translation>HoleRatio %1 erlauben</translation>
    </message>
    <message>
        <source>lower the stiffness ratio from %1 to %2</source>
        <translation>das Steifigkeitsverhältnis von %1 auf %2 senken</translation>
    </message>
    <message>
        <source>%1 is %2: a perforated strip has a whole number of them, from 1</source>
        <translation>%1 ist %2: ein gelochter Streifen hat eine ganze Zahl davon, ab 1</translation>
    </message>
    <message>
        <source>the slots leave %1 % of the stiffness at %2 mm and move the shape by %3 mm</source>
        <translation>die Schlitze lassen bei %2 mm %1 % der Steifigkeit und bewegen die Form um %3 mm</translation>
    </message>
    <message>
        <source>%1 mm long, %2 to %3 mm wide</source>
        <translation>%1 mm lang, %2 bis %3 mm breit</translation>
    </message>
    <message>
        <source>a strip needs max_width or min_width (mm): the rod only fixes how widths compare</source>
        <translation>ein Streifen braucht MaxWidth oder MinWidth (mm): der Stab legt nur das Verhältnis der Breiten fest</translation>
    </message>
    <message>
        <source>the narrowest place is %1 mm, below min_width %2 mm: the ratio is %3, so max_width must be %4 mm or more</source>
        <translation>die schmalste Stelle ist %1 mm breit, unter MinWidth %2 mm: das Verhältnis ist %3, MaxWidth muss also %4 mm oder mehr sein</translation>
    </message>
    <message>
        <source>%1 is given over %2 mm, the strip is %3 mm long</source>
        <translation>%1 ist über %2 mm gegeben, der Streifen ist %3 mm lang</translation>
    </message>
    <message>
        <source>a T-slot needs positive sizes in mm: depth, screw, nut = (width, height), wall</source>
        <translation>ein T-Schlitz braucht positive Maße in mm: Tiefe, Schraube, Mutter = (Breite, Höhe), Wand</translation>
    </message>
    <message>
        <source>a nut of %1 mm is held by nothing in a slot of %2 mm: make it wider</source>
        <translation>eine Mutter von %1 mm wird in einem Schlitz von %2 mm von nichts gehalten: sie breiter machen</translation>
    </message>
    <message>
        <source>a T-slot of %1 mm ends before its nut is in, at %2 mm: make it deeper</source>
        <translation>ein T-Schlitz von %1 mm endet, bevor die Mutter bei %2 mm darin ist: ihn tiefer machen</translation>
    </message>
    <message>
        <source>a T-slot of %1 mm does not fit a tab of %2 mm: lengthen the tab</source>
        <translation>ein T-Schlitz von %1 mm passt nicht in eine Lasche von %2 mm: die Lasche verlängern</translation>
    </message>
    <message>
        <source>tab corners of %1 mm do not fit a tab of %2 by %3 mm: make them smaller</source>
        <translation>Laschenecken von %1 mm passen nicht an eine Lasche von %2 mal %3 mm: sie kleiner machen</translation>
    </message>
    <message>
        <source>a taper of %1 mm leaves nothing of a tab %2 mm wide: make it smaller</source>
        <translation>eine Verjüngung von %1 mm lässt von einer %2 mm breiten Lasche nichts übrig: sie kleiner machen</translation>
    </message>
    <message>
        <source>the nut of a T-slot, %1 mm, is wider than the tab's outer edge of %2 mm: make the tab wider</source>
        <translation>die Mutter eines T-Schlitzes, %1 mm, ist breiter als die Außenkante der Lasche von %2 mm: die Lasche breiter machen</translation>
    </message>
    <message>
        <source>holes of %1 mm and %2 mm, %3 and %4 mm into the tab, meet: move one of them</source>
        <translation>Löcher von %1 mm und %2 mm, %3 und %4 mm in der Lasche, treffen sich: eines davon verschieben</translation>
    </message>
    <message>
        <source>a %1 mm hole %2 mm into the tab does not fit its length of %3 mm: move it or lengthen the tab</source>
        <translation>ein Loch von %1 mm, %2 mm tief in der Lasche, passt nicht in ihre Länge von %3 mm: es verschieben oder die Lasche verlängern</translation>
    </message>
    <message>
        <source>a %1 mm hole %2 mm off the centre line breaks the edge of a %3 mm wide tab: make it smaller or the tab wider</source>
        <translation>ein Loch von %1 mm, %2 mm neben der Mittellinie, durchbricht den Rand einer %3 mm breiten Lasche: es kleiner oder die Lasche breiter machen</translation>
    </message>
    <message>
        <source>a %1 mm hole %2 mm into the tab meets its T-slot: move it aside</source>
        <translation>ein Loch von %1 mm, %2 mm tief in der Lasche, trifft ihren T-Schlitz: es zur Seite rücken</translation>
    </message>
    <message>
        <source>gravity %1 is a direction in space: give frame, the plane of the curve, or two numbers, the direction in the drawing</source>
        <translation>die Schwerkraft %1 ist eine Richtung im Raum: die Ebene der Kurve angeben</translation>
    </message>
    <message>
        <source>%1 To make it all the same, set ignore_limits (--ignore-limits).</source>
        <translation>%1 Um es trotzdem zu machen, Anyway setzen.</translation>
    </message>
    <message>
        <source>what is hung on the rod bends it nowhere (a held end carries it, or its mass is 0): hang it between the ends, or leave it out</source>
        <translation>was am Stab hängt, biegt ihn nirgends (ein gehaltenes Ende trägt es, oder seine Masse ist 0): es zwischen die Enden hängen oder weglassen</translation>
    </message>
    <message>
        <source>a laminate that carries its weight must stand upright and weigh what its sheets do: turn its plane, give gravity=True or the base sheet's gravity, or leave gravity out</source>
        <translation>ein Laminat, das sein Gewicht trägt, muss aufrecht stehen und wiegen, was seine Platten wiegen: seine Ebene drehen oder die Schwerkraft weglassen</translation>
    </message>
    <message>
        <source>%1 is %2 mm, outside the limit width of %3 to %4 mm: change one of them, or leave the limit out</source>
        <translation>%1 ist %2 mm, außerhalb der Grenzen von %3 bis %4 mm für die Breite: eines davon ändern oder die Grenzen weglassen</translation>
    </message>
    <message>
        <source>min_width is %1 mm, more than max_width, %2 mm: give the larger one as max_width</source>
        <translation>MinWidth ist %1 mm, mehr als MaxWidth mit %2 mm: das größere Maß als MaxWidth angeben</translation>
    </message>
    <message>
        <source>max_width is %1 mm, but %2 needs %3 mm at its narrowest: widen the strip, take another sheet, or allow less with shop=Shop(least_width=...)</source>
        <translation>MaxWidth ist %1 mm, aber %2 braucht an der schmalsten Stelle %3 mm: den Streifen breiter machen, anderes Material nehmen oder LeastWidth senken</translation>
    </message>
    <message>
        <source>slot at %1 mm</source>
        <translation>Schlitz bei %1 mm</translation>
    </message>
    <message>
        <source>a bent slot needs four points or more along its centre line</source>
        <translation>ein gebogener Schlitz braucht vier Punkte oder mehr auf seiner Mittellinie</translation>
    </message>
    <message>
        <source>%1: the slots at %2 mm and %3 mm meet: move them apart, or make them narrower or shallower</source>
        <translation>%1: die Schlitze bei %2 mm und %3 mm treffen sich: sie auseinanderrücken oder schmaler oder flacher machen</translation>
    </message>
    <message>
        <source>does not open at the edge</source>
        <translation>öffnet sich nicht am Rand</translation>
    </message>
    <message>
        <source>cuts through to another edge</source>
        <translation>geht durch bis zu einem anderen Rand</translation>
    </message>
    <message>
        <source>%1: the slot at %2 mm %3: make it %4 or move it</source>
        <translation>%1: der Schlitz bei %2 mm %3: ihn %4 machen oder verschieben</translation>
    </message>
    <message>
        <source>%1: the slot at %2 mm is not on the strip, which goes from %3 to %4 mm with its tabs: move it</source>
        <translation>%1: der Schlitz bei %2 mm liegt nicht auf dem Streifen, der mit seinen Laschen von %3 bis %4 mm geht: ihn verschieben</translation>
    </message>
    <message>
        <source>%1: the slot at %2 mm meets a hole at %3: move one of them</source>
        <translation>%1: der Schlitz bei %2 mm trifft ein Loch bei %3: eines von beiden verschieben</translation>
    </message>
    <message>
        <source>assembly: %1; push each strip onto those before it</source>
        <translation>Zusammenbau: %1; jeden Streifen auf die vorherigen schieben</translation>
    </message>
    <message>
        <source>%1 and %2 touch along a line at %3 mm of %4 instead of crossing: move them apart or turn one of them</source>
        <translation>%1 und %2 berühren sich entlang einer Linie bei %3 mm von %4, statt sich zu kreuzen: sie auseinanderrücken oder einen drehen</translation>
    </message>
    <message>
        <source>no two strips cross: interlocking cut no slot</source>
        <translation>keine zwei Streifen kreuzen sich: es wurden keine Schlitze geschnitten</translation>
    </message>
    <message>
        <source>; %1 must be threaded in, being held from both edges</source>
        <translation>; %1 muss eingefädelt werden, weil beide Ränder ihn halten</translation>
    </message>
    <message>
        <source>%1 and %2 cross at %3 degrees at %4 mm of %5: the slots are up to %6 mm wide; a larger angle would hold better</source>
        <translation>%1 und %2 kreuzen sich unter %3 Grad bei %4 mm von %5: die Schlitze sind bis zu %6 mm breit; ein größerer Winkel hielte besser</translation>
    </message>
    <message>
        <source>%1: the slots open its outline</source>
        <translation>%1: die Schlitze öffnen seinen Umriss</translation>
    </message>
    <message>
        <source>%1 and %2 cross at %3 mm of %4, but one of them ends before the crossing comes to its edge, so that no slot can open there: shorten, move or turn one of them</source>
        <translation>%1 und %2 kreuzen sich bei %3 mm von %4, aber einer endet, bevor die Kreuzung an seinen Rand kommt; dort kann sich kein Schlitz öffnen: einen kürzen, verschieben oder drehen</translation>
    </message>
    <message>
        <source>a clearance of %1 mm is larger than %2 is wide at %3 mm: make it smaller</source>
        <translation>ein Spiel von %1 mm ist größer, als %2 bei %3 mm breit ist: es kleiner machen</translation>
    </message>
    <message>
        <source>the model %1 has no strips</source>
        <translation>das Modell %1 hat keine Streifen</translation>
    </message>
    <message>
        <source>the model %1 has %2, made for its strips where they are: repeat the strips without rings</source>
        <translation>das Modell %1 hat %2, gemacht für seine Streifen, wo sie sind: die Streifen ohne Ringe wiederholen</translation>
    </message>
    <message>
        <source>%1: no tab of the model goes down through the plate, their tips are %2 to %3 mm above its upper face: move the plate to where the strips end, give the strips longer tabs, or hold ends that come from below by rings</source>
        <translation>%1: keine Lasche des Modells geht nach unten durch die Platte, ihre Spitzen sind %2 bis %3 mm über deren Oberseite: die Platte dahin rücken, wo die Streifen enden, ihnen längere Laschen geben, oder Enden, die von unten kommen, mit Ringen halten</translation>
    </message>
    <message>
        <source>%1: there is no strip for it to hold: name other strips or ends</source>
        <translation>%1: es gibt keinen Streifen, den sie halten könnte: andere Streifen oder Enden nennen</translation>
    </message>
    <message>
        <source>%1: the tab of %2 leans to %3 degrees from the plate: at %4 degrees or less a slot cannot hold it; use a fixture there</source>
        <translation>%1: die Lasche von %2 steht %3 Grad zur Platte: bei %4 Grad oder weniger hält kein Schlitz; dort einen Halter nehmen</translation>
    </message>
    <message>
        <source>%1: the slots of %2 and %3 come closer than %4 mm near (%5, %6): give the strips narrower tabs or move them apart</source>
        <translation>%1: die Schlitze von %2 und %3 kommen sich näher als %4 mm bei (%5, %6): den Streifen schmalere Laschen geben oder sie auseinanderrücken</translation>
    </message>
    <message>
        <source>%1: a screw of %2 mm does not fit a foot of %3 by %4 mm: make the foot longer or the screw thinner</source>
        <translation>%1: eine Schraube von %2 mm passt nicht in einen Fuß von %3 mal %4 mm: den Fuß länger oder die Schraube dünner machen</translation>
    </message>
    <message>
        <source>%1: the plane of the strip leans %2 degrees to the floor: leave the floor out, and the block stands square to its tab</source>
        <translation>%1: die Ebene des Streifens neigt sich %2 Grad zum Boden: den Boden weglassen, dann steht der Block rechtwinklig zur Lasche</translation>
    </message>
    <message>
        <source>%1: the block reaches %2 mm below the floor: lower the floor or shorten the tab</source>
        <translation>%1: der Block reicht %2 mm unter den Boden: den Boden senken oder die Lasche kürzen</translation>
    </message>
    <message>
        <source>a strip has the ends "start" and "end", not %1</source>
        <translation>ein Streifen hat die Enden "start" und "end", nicht %1</translation>
    </message>
    <message>
        <source>every piece fits the sheet</source>
        <translation>jedes Stück passt auf die Platte</translation>
    </message>
    <message>
        <source>the kerf is %1: it must be a finite number of mm, 0 for none</source>
        <translation>die Schnittfuge ist %1: sie muss eine endliche Zahl in mm sein, 0 für keine</translation>
    </message>
    <message>
        <source>the kerf is %1 mm, wider than the cut of any tool: give the width of the cut in mm, such as 0.15 for a laser</source>
        <translation>die Schnittfuge ist %1 mm, breiter als der Schnitt jedes Werkzeugs: die Breite des Schnitts in mm angeben, etwa 0,15 für einen Laser</translation>
    </message>
    <message>
        <source>a kerf of %1 mm is too wide for a loop on %2: %3</source>
        <translation>eine Schnittfuge von %1 mm ist zu breit für eine Kontur auf %2: %3</translation>
    </message>
    <message>
        <source>with a kerf of %1 mm two cut loops meet at %2: move them apart there or use a smaller kerf</source>
        <translation>mit einer Schnittfuge von %1 mm treffen sich zwei Schnittkonturen bei %2: sie dort auseinanderrücken oder eine kleinere Schnittfuge nehmen</translation>
    </message>
    <message>
        <source>%1: %2 by %3 mm is larger than a sheet of %4 by %5 mm with a margin of %6 mm%7: use a larger sheet or make the part in pieces</source>
        <translation>%1: %2 mal %3 mm ist größer als eine Platte von %4 mal %5 mm mit einem Rand von %6 mm%7: eine größere Platte nehmen oder das Teil zerteilen</translation>
    </message>
    <message>
        <source>with the grain %1 it</source>
        <translation>mit der Faser %1</translation>
    </message>
    <message>
        <source>the edge has no length: draw a curve for the strip to follow</source>
        <translation>die Kante hat keine Länge: eine Kurve zeichnen, der der Streifen folgt</translation>
    </message>
    <message>
        <source>no edge was given: give at least one edge or wire for the strip to follow</source>
        <translation>es wurde keine Kante gegeben: mindestens eine Kante oder einen Draht angeben, dem der Streifen folgt</translation>
    </message>
    <message>
        <source>the edges make %1 separate chains, the nearest %2 mm apart at %3: make their ends meet, or leave out what the strip is not to follow, in a sketch as construction geometry</source>
        <translation>die Kanten bilden %1 getrennte Ketten, die nächsten %2 mm auseinander bei %3: ihre Enden zusammenführen, oder weglassen, wem der Streifen nicht folgen soll, in einer Skizze als Hilfsgeometrie</translation>
    </message>
    <message>
        <source>two edges end %1 mm apart at %2: make their ends meet there, in a sketch by a coincident constraint</source>
        <translation>zwei Kanten enden %1 mm auseinander bei %2: ihre Enden dort zusammenführen, in einer Skizze mit der Randbedingung Koinzident</translation>
    </message>
    <message>
        <source>three edges or more meet at %1: a strip goes on in one way, so give only the edges that it is to follow</source>
        <translation>drei oder mehr Kanten treffen sich bei %1: ein Streifen geht nur auf einem Weg weiter, also nur die Kanten angeben, denen er folgen soll</translation>
    </message>
    <message>
        <source>the curve lies up to %1 mm off the plane that is given for it: give the one in which it is drawn, or none</source>
        <translation>die Kurve liegt bis zu %1 mm neben der Ebene, die für sie angegeben ist: die Ebene nehmen, in der sie gezeichnet ist, oder keine</translation>
    </message>
    <message>
        <source>edges meet at a corner of %1 degrees at (%2, %3, %4) mm: make them tangent or round the corner</source>
        <translation>Kanten treffen sich in einer Ecke von %1 Grad bei (%2, %3, %4) mm: sie tangential machen oder die Ecke runden</translation>
    </message>
    <message>
        <source>the margin is %1: it must be a number of mm, 0 or more</source>
        <translation>der Rand ist %1: er muss eine Zahl in mm sein, 0 oder mehr</translation>
    </message>
    <message>
        <source>sheet size is %1: give its width and height, two numbers of mm</source>
        <translation>Plattengröße ist %1: Breite und Höhe angeben, zwei Zahlen in mm</translation>
    </message>
    <message>
        <source>the edges are a polyline of %1 straight pieces, with corners between them: draw a spline through its points for the strip to follow</source>
        <translation>die Kanten sind ein Linienzug aus %1 geraden Stücken, mit Ecken dazwischen: einen Spline durch seine Punkte zeichnen, dem der Streifen folgt</translation>
    </message>
    <message>
        <source>a spline of degree %1 has %2 control points; it needs %3: draw it anew</source>
        <translation>ein Spline vom Grad %1 hat %2 Kontrollpunkte; er braucht %3: ihn neu zeichnen</translation>
    </message>
    <message>
        <source>a spline of degree %1 with %2 control points has %3 knots; it needs %4, never decreasing: export it anew, or draw it anew</source>
        <translation>ein Spline vom Grad %1 mit %2 Kontrollpunkten hat %3 Knoten; er braucht %4, nie fallend: neu exportieren oder neu zeichnen</translation>
    </message>
    <message>
        <source>all knots of a spline are %1; its parameter must run over an interval: draw it anew</source>
        <translation>alle Knoten eines Splines sind %1; sein Parameter muss ein Intervall durchlaufen: ihn neu zeichnen</translation>
    </message>
    <message>
        <source>%1 is a folder: give the name of a file in it</source>
        <translation>%1 ist ein Ordner: den Namen einer Datei darin angeben</translation>
    </message>
    <message>
        <source>%1 can't be written: there is no folder %2; create it first</source>
        <translation>%1 kann nicht geschrieben werden: es gibt keinen Ordner %2; ihn zuerst anlegen</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name, or allow it to be overwritten (--force, or force=True)</source>
        <translation>%1 gibt es schon: einen anderen Namen wählen oder das Überschreiben erlauben</translation>
    </message>
    <message>
        <source>%1 can't be written: no permission to change that file; choose another name</source>
        <translation>%1 kann nicht geschrieben werden: keine Erlaubnis, diese Datei zu ändern; einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>%1 can't be written: %2; choose another place</source>
        <translation>%1 kann nicht geschrieben werden: %2; einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>%1 can't be changed: %2; allow it to be written</source>
        <translation>%1 kann nicht geändert werden: %2; das Schreiben erlauben</translation>
    </message>
    <message>
        <source>All limits are met, and no nearer rod was found.</source>
        <translation>Alle Grenzen sind eingehalten, und es wurde kein näherer Stab gefunden.</translation>
    </message>
    <message>
        <source>All limits are met, but the search was stopped before it settled: a nearer rod may exist.</source>
        <translation>Alle Grenzen sind eingehalten, aber die Suche wurde vorher beendet: es kann einen näheren Stab geben.</translation>
    </message>
    <message>
        <source>All limits are met, but only by a rod that no longer looks like the drawn curve: relax what binds.</source>
        <translation>Alle Grenzen sind eingehalten, aber nur von einem Stab, der der gezeichneten Kurve nicht mehr ähnelt: lockern, was bindet.</translation>
    </message>
    <message>
        <source>The limits cannot be met together near this curve: this is the best rod found, relax what binds.</source>
        <translation>Die Grenzen sind nahe dieser Kurve nicht zusammen einzuhalten: dies ist der beste gefundene Stab; lockern, was bindet.</translation>
    </message>
    <message>
        <source>No rod was computed for this curve: see the message.</source>
        <translation>Für diese Kurve wurde kein Stab berechnet: siehe die Meldung.</translation>
    </message>
    <message>
        <source>The rod leaves the drawn curve by %1 mm at most.</source>
        <translation>Der Stab verlässt die gezeichnete Kurve um höchstens %1 mm.</translation>
    </message>
    <message>
        <source>there is no rod for this curve: %1</source>
        <translation>zu dieser Kurve gibt es keinen Stab: %1</translation>
    </message>
    <message>
        <source>%1 costs %2 %3</source>
        <translation>%1 kostet %2 %3</translation>
    </message>
    <message>
        <source>all limits are met, %1 mm from the drawn curve at most.</source>
        <translation>alle Grenzen sind eingehalten, höchstens %1 mm von der gezeichneten Kurve.</translation>
    </message>
    <message>
        <source>the ratio of the widths</source>
        <translation>das Verhältnis der Breiten</translation>
    </message>
    <message>
        <source>the sheet's strain limit</source>
        <translation>die Dehngrenze der Platte</translation>
    </message>
    <message>
        <source>The stability margin of %1 is missed: this rod has %2.</source>
        <translation>Die Stabilitätsreserve von %1 wird verfehlt: dieser Stab hat %2.</translation>
    </message>
    <message>
        <source>No single one of the limits that bind is to blame: relax several.</source>
        <translation>Keine der bindenden Grenzen allein ist schuld: mehrere lockern.</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%1 statt %2</translation>
    </message>
    <message>
        <source>%1 instead of %2 mm</source>
        <translation>%1 statt %2 mm</translation>
    </message>
    <message>
        <source>the range of lengths</source>
        <translation>der Bereich der Längen</translation>
    </message>
    <message>
        <source>the %1 end's angle</source>
        <translation>der Winkel an %1</translation>
    </message>
    <message>
        <source>Free %1: that saves %2 %3.</source>
        <translation>%1 freigeben: das spart %2 %3.</translation>
    </message>
    <message>
        <source>; %1 would cost %2 mm</source>
        <translation>; %1 würde %2 mm kosten</translation>
    </message>
    <message>
        <source>%1 of %2 costs %3 %4 per unit (its multiplier: true of small changes).</source>
        <translation>%1 von %2 kostet %3 %4 je Einheit (der Multiplikator: gilt für kleine Änderungen).</translation>
    </message>
    <message>
        <source>%1 at %2: %3</source>
        <translation>%1 bei %2: %3</translation>
    </message>
    <message>
        <source>split it at its corners</source>
        <translation>ihn an seinen Ecken teilen</translation>
    </message>
    <message>
        <source>(%1, %2, %3) mm</source>
        <translation>(%1, %2, %3) mm</translation>
    </message>
    <message>
        <source>no smooth curve stays within the tolerance of %1 mm: the section turns by %2 degrees at %3; %4, or smooth it</source>
        <translation>keine glatte Kurve bleibt innerhalb der Toleranz von %1 mm: der Schnitt dreht um %2 Grad bei %3; %4 oder ihn glätten</translation>
    </message>
    <message>
        <source>%1: the curve lies %2 mm off the section at %3, more than the tolerance of %4 mm: %5</source>
        <translation>%1: die Kurve liegt bei %3 %2 mm neben dem Schnitt, mehr als die Toleranz von %4 mm: %5</translation>
    </message>
    <message>
        <source>%1, from (%2, %3, %4) mm</source>
        <translation>%1, ab (%2, %3, %4) mm</translation>
    </message>
    <message>
        <source>and at %1 more places</source>
        <translation>und an %1 weiteren Stellen</translation>
    </message>
    <message>
        <source>%1 mm along the curve%2 it turns by less than %3 degrees between inflections; no smoothing that moves it by less than %4 mm takes that away</source>
        <translation>%1 mm entlang der Kurve%2 dreht sie zwischen Wendepunkten um weniger als %3 Grad; keine Glättung, die sie um weniger als %4 mm bewegt, nimmt das weg</translation>
    </message>
    <message>
        <source>every section is a closed line, and a strip has two ends: choose under Closed lines how they are divided</source>
        <translation>jeder Schnitt ist eine geschlossene Linie, und ein Streifen hat zwei Enden: unter Geschlossene Linien wählen, wie sie geteilt werden</translation>
    </message>
    <message>
        <source>readings %1 mm</source>
        <translation>Messwerte %1 mm</translation>
    </message>
    <message>
        <source>elasto-gravity length %1 +- %2 mm</source>
        <translation>elasto-gravitative Länge %1 +- %2 mm</translation>
    </message>
    <message>
        <source>the section is closed (it passes (%1, %2, %3) mm): a strip has two ends, so %4</source>
        <translation>der Schnitt ist geschlossen (er geht durch (%1, %2, %3) mm): ein Streifen hat zwei Enden; %4</translation>
    </message>
    <message>
        <source>split it at a spine or at two points</source>
        <translation>ihn halbieren (Geschlossene Linien)</translation>
    </message>
    <message>
        <source>the points to smooth are all the same</source>
        <translation>die zu glättenden Punkte sind alle gleich</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>%1: %2: it is kept</source>
        <translation>%1: %2: es bleibt</translation>
    </message>
    <message>
        <source>%1 at %2: the plane %3</source>
        <translation>%1 bei %2: die Ebene %3</translation>
    </message>
    <message>
        <source>%1 is split twice at one place, or at its very end: move the points</source>
        <translation>%1 wird zweimal an einer Stelle oder ganz am Ende geteilt: die Punkte verschieben</translation>
    </message>
    <message>
        <source>%1: choose from its lines</source>
        <translation>%1: aus seinen Linien wählen</translation>
    </message>
    <message>
        <source>%1 falls into %2 lines, starting at %3</source>
        <translation>%1 zerfällt in %2 Linien, sie beginnen bei %3</translation>
    </message>
    <message>
        <source>smooth is %1: a curve is made fair within 0 (not at all) to %2 mm</source>
        <translation>Smooth ist %1: eine Kurve wird innerhalb von 0 (gar nicht) bis %2 mm geglättet</translation>
    </message>
    <message>
        <source>The digits of the file turn its tangents where pieces meet: put right, %1 mm at most.</source>
        <translation>Die Stellen der Datei verdrehen die Tangenten, wo Stücke sich treffen: berichtigt, höchstens %1 mm.</translation>
    </message>
    <message>
        <source>as drawn no strip takes it</source>
        <translation>wie gezeichnet nimmt sie kein Streifen an</translation>
    </message>
    <message>
        <source>the stiffness ratio as drawn was %1</source>
        <translation>das Steifigkeitsverhältnis war wie gezeichnet %1</translation>
    </message>
    <message>
        <source>The curvature jumped where pieces meet: made fair, %1 mm from the drawn curve at most; %2 (smooth = 0, or --smooth 0, takes it as drawn, a larger number makes it fairer).</source>
        <translation>Die Krümmung sprang, wo Stücke sich treffen: geglättet, höchstens %1 mm von der gezeichneten Kurve; %2 (Smooth = 0 oder --smooth 0 nimmt sie wie gezeichnet, eine größere Zahl glättet mehr).</translation>
    </message>
    <message>
        <source>nothing was changed; take fewer planes, or try again</source>
        <translation>nichts wurde geändert; weniger Ebenen nehmen oder es noch einmal versuchen</translation>
    </message>
    <message>
        <source>select a body, a surface or a mesh to cut</source>
        <translation>einen Körper, eine Fläche oder ein Netz zum Schneiden wählen</translation>
    </message>
    <message>
        <source>choose a family, an axis (X, Y or Z) and one plane or more</source>
        <translation>eine Schar, eine Achse (X, Y oder Z) und eine Ebene oder mehr wählen</translation>
    </message>
    <message>
        <source>has construction geometry and points only</source>
        <translation>hat nur Hilfsgeometrie und Punkte</translation>
    </message>
    <message>
        <source>has external geometry only</source>
        <translation>hat nur externe Geometrie</translation>
    </message>
    <message>
        <source>the curve is missing: choose a sketch or an edge in the property Curve</source>
        <translation>die Kurve fehlt: in der Eigenschaft Curve eine Skizze oder Kante wählen</translation>
    </message>
    <message>
        <source>%1 %2: draw a spline in it</source>
        <translation>%1 %2: einen Spline darin zeichnen</translation>
    </message>
    <message>
        <source>%1 is not plane</source>
        <translation>%1 ist nicht eben</translation>
    </message>
    <message>
        <source>%1 has no shape: choose a sketch, an edge or a wire</source>
        <translation>%1 hat keine Form: eine Skizze, eine Kante oder einen Draht wählen</translation>
    </message>
    <message>
        <source>%1 has many edges: choose the ones that the strip is to follow</source>
        <translation>%1 hat viele Kanten: die wählen, denen der Streifen folgen soll</translation>
    </message>
    <message>
        <source>%1 has no %2 any more: choose the curve anew</source>
        <translation>%1 hat kein %2 mehr: die Kurve neu wählen</translation>
    </message>
    <message>
        <source>there is nothing to write: choose kinds of files</source>
        <translation>es gibt nichts zu schreiben: Arten von Dateien wählen</translation>
    </message>
    <message>
        <source>%1 is no sketch: nothing can be drawn into it</source>
        <translation>%1 ist keine Skizze: darin kann nichts gezeichnet werden</translation>
    </message>
    <message>
        <source>there is nothing to cut: choose a body, a surface or a mesh in the property Sources</source>
        <translation>es gibt nichts zu schneiden: in der Eigenschaft Sources einen Körper, eine Fläche oder ein Netz wählen</translation>
    </message>
    <message>
        <source>the strip is missing: choose one in the property Strip</source>
        <translation>der Streifen fehlt: einen in der Eigenschaft Strip wählen</translation>
    </message>
    <message>
        <source>the planes miss the object: move them, or take more</source>
        <translation>die Ebenen verfehlen das Objekt: sie verschieben oder mehr nehmen</translation>
    </message>
    <message>
        <source>no strip here has a tab to be held: give the strips tabs</source>
        <translation>kein Streifen hat hier eine Lasche, die zu halten wäre: den Streifen Laschen geben</translation>
    </message>
    <message>
        <source>%1 does not belong to %2: choose its model, or none</source>
        <translation>%1 gehört nicht zu %2: sein Modell wählen, oder keines</translation>
    </message>
    <message>
        <source>%1 is not laminated: it has no backing; choose the layer Base</source>
        <translation>%1 ist nicht laminiert: es hat keine Verstärkung; die Schicht Base wählen</translation>
    </message>
    <message>
        <source>the model has no strips: choose some in the property Strips</source>
        <translation>das Modell hat keine Streifen: in der Eigenschaft Strips welche wählen</translation>
    </message>
    <message>
        <source>%1 makes its copies of %2 part of one body, and leaves out those that do not touch it: delete it, and repeat the strip by an array of the workbench Draft</source>
        <translation>%1 macht seine Kopien von %2 zu Teilen eines einzigen Körpers und lässt die weg, die ihn nicht berühren: %1 löschen und den Streifen durch eine Anordnung des Arbeitsbereichs Draft wiederholen</translation>
    </message>
    <message>
        <source>%1 is scaled, and a strip of another size bends otherwise: set its Scale to 1</source>
        <translation>%1 ist skaliert, und ein Streifen anderer Größe biegt sich anders: Scale auf 1 setzen</translation>
    </message>
    <message>
        <source>a curve is %1 mm large; %2 to %3 mm are read: check the unit (--unit), or leave it out</source>
        <translation>eine Kurve ist %1 mm groß; %2 bis %3 mm werden gelesen: die Einheit prüfen oder sie weglassen</translation>
    </message>
    <message>
        <source>a coordinate is %1 mm; they must be finite and at most %2 mm: check the unit, or export it anew</source>
        <translation>eine Koordinate ist %1 mm; sie müssen endlich und höchstens %2 mm sein: die Einheit prüfen oder neu exportieren</translation>
    </message>
    <message>
        <source>%1 is no strip: a model is made of strips</source>
        <translation>%1 ist kein Streifen: ein Modell besteht aus Streifen</translation>
    </message>
    <message>
        <source>there is nothing to cut: select strips, models or base plates</source>
        <translation>es gibt nichts zu schneiden: Streifen, Modelle oder Grundplatten auswählen</translation>
    </message>
    <message>
        <source>%1 links to %2 in %3, which is missing: put that file back or open it, and recompute the document</source>
        <translation>%1 verweist auf %2 in %3, das fehlt: die Datei zurücklegen oder öffnen und das Dokument neu berechnen</translation>
    </message>
    <message>
        <source>%1 links to what was deleted: choose another object in its property LinkedObject, or delete the link</source>
        <translation>%1 verweist auf etwas, das gelöscht wurde: in der Eigenschaft LinkedObject ein anderes Objekt wählen oder den Verweis löschen</translation>
    </message>
    <message>
        <source>%1 reads %2, which is missing: put that file back, or name another in its property FileName, and recompute the document</source>
        <translation>%1 liest %2, und diese Datei fehlt: sie zurücklegen oder in der Eigenschaft FileName eine andere nennen und das Dokument neu berechnen</translation>
    </message>
    <message>
        <source>the formula of %1 cannot be computed (%2): mend it, or take it away</source>
        <translation>die Formel von %1 lässt sich nicht berechnen (%2): sie berichtigen oder entfernen</translation>
    </message>
    <message>
        <source>%1 has the formula %2, which gives %3: it takes 0 to %4, or a name such as %5; mend the formula, or take it away</source>
        <translation>%1 hat die Formel %2, die %3 ergibt: möglich sind 0 bis %4 oder ein Name wie %5; die Formel berichtigen oder entfernen</translation>
    </message>
    <message>
        <source>%1 cannot be made (%2): mend it first</source>
        <translation>%1 lässt sich nicht erzeugen (%2): zuerst das beheben</translation>
    </message>
    <message>
        <source>a curve %1 mm from this one</source>
        <translation>eine Kurve %1 mm von dieser</translation>
    </message>
    <message>
        <source>A flat strip cannot take this curve.</source>
        <translation>Ein flacher Streifen kann diese Kurve nicht annehmen.</translation>
    </message>
    <message>
        <source>There is no strip.</source>
        <translation>Es gibt keinen Streifen.</translation>
    </message>
    <message>
        <source>(conjugate point at %1 mm)</source>
        <translation>(konjugierter Punkt bei %1 mm)</translation>
    </message>
    <message>
        <source>it does not stay in this shape: the stability margin is %1%2</source>
        <translation>er bleibt nicht in dieser Form: die Stabilitätsreserve ist %1%2</translation>
    </message>
    <message>
        <source>A flat strip takes %1%2.</source>
        <translation>Ein flacher Streifen nimmt %1 an%2.</translation>
    </message>
    <message>
        <source>the thickness of the sheet is %1 mm, less than any foil's: is its unit right?</source>
        <translation>die Dicke der Platte ist %1 mm, weniger als jede Folie: stimmt die Einheit?</translation>
    </message>
    <message>
        <source>%1 samples are asked for: %2 are the most, 0 chooses</source>
        <translation>%1 Stützstellen sind verlangt: %2 sind das Höchste, 0 wählt selbst</translation>
    </message>
    <message>
        <source>the direction of gravity is zero: give a vector such as (0, 0, -1)</source>
        <translation>die Richtung der Schwerkraft ist null: einen Vektor wie (0, 0, -1) angeben</translation>
    </message>
    <message>
        <source>%1 is %2 mm, more than a kilometre: is its unit right?</source>
        <translation>%1 ist %2 mm, mehr als ein Kilometer: stimmt die Einheit?</translation>
    </message>
    <message>
        <source>the length of the curve</source>
        <translation>die Länge der Kurve</translation>
    </message>
    <message>
        <source>recompute to try again</source>
        <translation>neu berechnen, um es noch einmal zu versuchen</translation>
    </message>
    <message>
        <source>%1: stopped; change the curve or the limits to try again</source>
        <translation>%1: abgebrochen; die Kurve oder die Grenzen ändern, um es noch einmal zu versuchen</translation>
    </message>
    <message>
        <source>FreeCAD's kernel cannot make this shape (%1): change the curve, the widths or the holes</source>
        <translation>FreeCADs Kern kann diese Form nicht bilden (%1): die Kurve, die Breiten oder die Löcher ändern</translation>
    </message>
    <message>
        <source>%1 is not installed in this FreeCAD: strips need numpy and scipy</source>
        <translation>%1 ist in diesem FreeCAD nicht installiert: Streifen brauchen numpy und scipy</translation>
    </message>
    <message>
        <source>there is no sheet called %1 here: choose another one, or add it to the sheet library</source>
        <translation>hier gibt es keine Platte namens %1: eine andere wählen oder sie in die Plattenbibliothek aufnehmen</translation>
    </message>
    <message>
        <source>the sheet %1 kept in this document cannot be read: choose another one</source>
        <translation>die in diesem Dokument bewahrte Platte %1 ist nicht lesbar: eine andere wählen</translation>
    </message>
    <message>
        <source>%1 holds no sketch for a strip: draw a spline in a sketch of its own, or select the edge that the strip is to follow</source>
        <translation>%1 enthält keine Skizze für einen Streifen: einen Spline in eine eigene Skizze zeichnen oder die Kante auswählen, der der Streifen folgen soll</translation>
    </message>
    <message>
        <source>%1 holds several sketches (%2): select the one that the strip is to follow</source>
        <translation>%1 enthält mehrere Skizzen (%2): die auswählen, der der Streifen folgen soll</translation>
    </message>
    <message>
        <source>A flat strip takes this curve: %1 wide, stiffness ratio %2, strain %3 % of what the sheet bears.</source>
        <translation>Ein flacher Streifen nimmt diese Kurve an: %1 breit, Steifigkeitsverhältnis %2, Dehnung %3 % dessen, was die Platte erträgt.</translation>
    </message>
    <message>
        <source>A strip bent beforehand takes this curve: %1 wide, stiffness ratio %2, strain %3 % of what the sheet bears.</source>
        <translation>Ein vorgebogener Streifen nimmt diese Kurve an: %1 breit, Steifigkeitsverhältnis %2, Dehnung %3 % dessen, was die Platte erträgt.</translation>
    </message>
    <message>
        <source>%1 is no reading: write overhang = droop in mm, such as 120 = 14.5; 150 = 31</source>
        <translation>%1 ist keine Messung: Überhang = Durchhang in mm schreiben, etwa 120 = 14.5; 150 = 31</translation>
    </message>
    <message>
        <source>Nearest curve to sketch</source>
        <translation>Nächste Kurve zur Skizze</translation>
    </message>
    <message>
        <source>there is no curve: draw a spline for the strip to follow</source>
        <translation>es gibt keine Kurve: einen Spline zeichnen, dem der Streifen folgt</translation>
    </message>
    <message>
        <source>an edge runs on to infinity: trim it</source>
        <translation>eine Kante läuft ins Unendliche: sie trimmen</translation>
    </message>
    <message>
        <source>the shape cannot pass through a temporary file (%1): make that folder writable, with room in it</source>
        <translation>die Form kann nicht durch eine temporäre Datei gehen (%1): diesen Ordner beschreibbar machen, mit Platz darin</translation>
    </message>
    <message>
        <source>an edge is degenerate: it has no curve in space; choose another edge</source>
        <translation>eine Kante ist entartet: sie hat keine Kurve im Raum; eine andere Kante wählen</translation>
    </message>
    <message>
        <source>%1 inflection</source>
        <translation>%1 Wendepunkt</translation>
    </message>
    <message>
        <source>%1 inflections</source>
        <translation>%1 Wendepunkte</translation>
    </message>
    <message>
        <source>at %1 mm</source>
        <translation>bei %1 mm</translation>
    </message>
    <message>
        <source>at %1 and %2 mm</source>
        <translation>bei %1 und %2 mm</translation>
    </message>
    <message>
        <source>The line through its inflections crosses the curve %1, where the moment would vanish or change sign and the curvature does not: move the curve off the line there, or support the strip between there and the inflections beside it.</source>
        <translation>Die Gerade durch die Wendepunkte kreuzt die Kurve %1; dort müsste das Moment verschwinden oder das Vorzeichen wechseln, die Krümmung tut es nicht: die Kurve dort von der Geraden wegziehen oder den Streifen zwischen dort und den Wendepunkten daneben stützen.</translation>
    </message>
    <message>
        <source>The line through its inflections touches the curve %1, where the moment would vanish or change sign and the curvature does not: move the curve off the line there, or support the strip between there and the inflections beside it.</source>
        <translation>Die Gerade durch die Wendepunkte berührt die Kurve %1; dort müsste das Moment verschwinden oder das Vorzeichen wechseln, die Krümmung tut es nicht: die Kurve dort von der Geraden wegziehen oder den Streifen zwischen dort und den Wendepunkten daneben stützen.</translation>
    </message>
    <message>
        <source>between %1 and %2 mm</source>
        <translation>zwischen %1 und %2 mm</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>is straight</source>
        <translation>ist gerade</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>%1 edges in all</source>
        <translation>%1 Kanten insgesamt</translation>
    </message>
    <message>
        <source>%1 has %2 chains of edges: choose the edges of one as the path</source>
        <translation>%1 hat %2 Kantenketten: die Kanten einer davon als Pfad wählen</translation>
    </message>
    <message>
        <source>choose a path: a sketch or a wire that the planes stand across</source>
        <translation>einen Pfad wählen: eine Skizze oder einen Draht, zu dem die Ebenen quer stehen</translation>
    </message>
    <message>
        <source>%1 mm along the path</source>
        <translation>%1 mm entlang des Pfades</translation>
    </message>
    <message>
        <source>smoothing took waves shorter than %1 mm away; a shorter wavelength stays nearer</source>
        <translation>das Glätten hat Wellen unter %1 mm weggenommen; eine kürzere Wellenlänge bleibt näher</translation>
    </message>
    <message>
        <source>no smooth curve came nearer; smooth the section first, with a wavelength</source>
        <translation>keine glatte Kurve kam näher; zuerst den Schnitt mit einer Wellenlänge glätten</translation>
    </message>
    <message>
        <source>section %1</source>
        <translation>Schnitt %1</translation>
    </message>
    <message>
        <source>the nearest curve</source>
        <translation>die nächste Kurve</translation>
    </message>
    <message>
        <source>can</source>
        <translation>geht</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>the curve has a corner %1%2, of %3 degrees: a strip bends without kinks; round it, or draw two curves%4</source>
        <translation>die Kurve hat eine Ecke %1%2, von %3 Grad: ein Streifen biegt sich ohne Knicke; sie runden oder zwei Kurven zeichnen%4</translation>
    </message>
    <message>
        <source>, or take it out within %1 mm (smooth = %2, --smooth %3)</source>
        <translation>, oder sie innerhalb von %1 mm herausnehmen (smooth = %2, --smooth %3)</translation>
    </message>
    <message>
        <source>Its corners, of %1 degrees at most, were rounded within that.</source>
        <translation>Ihre Ecken, höchstens %1 Grad, wurden innerhalb dessen gerundet.</translation>
    </message>
    <message>
        <source>it is %1 mm wide and %2 mm long: what is wider than long bends as a plate, not as a strip; give a smaller max_width, and look at its unit</source>
        <translation>er ist %1 mm breit und %2 mm lang: was breiter als lang ist, biegt sich als Platte, nicht als Streifen; ein kleineres max_width angeben und auf seine Einheit achten</translation>
    </message>
    <message>
        <source>No force can act between its ends, so the moment is constant and the curve must bend one way only; it has %1, %2: hold both ends in x or in y.</source>
        <translation>Zwischen den Enden kann keine Kraft wirken, das Moment ist also konstant und die Kurve darf sich nur nach einer Seite biegen; sie hat %1, %2: beide Enden in x oder in y halten.</translation>
    </message>
    <message>
        <source>The bending is reversed by a jump of the curvature %1, where the stiffness would have to go to 0: support the strip there, or let the curvature pass through zero smoothly (smooth = 0.1, or --smooth 0.1, does that within 0.1 mm).</source>
        <translation>Die Biegung kehrt sich durch einen Sprung der Krümmung %1 um, wo die Steifigkeit null werden müsste: den Streifen dort stützen oder die Krümmung glatt durch null gehen lassen (die Eigenschaft Smooth = 0.1 tut das innerhalb von 0.1 mm).</translation>
    </message>
    <message>
        <source>%1, whatever supports the strip there: bend the piece a little.</source>
        <translation>%1, was auch immer den Streifen dort stützt: das Stück ein wenig biegen.</translation>
    </message>
    <message>
        <source>%1: support the strip %2, or bend the piece a little.</source>
        <translation>%1: den Streifen %2 stützen oder das Stück ein wenig biegen.</translation>
    </message>
    <message>
        <source>%1 rows are %2 mm long each: diamonds with bridges of %3 mm between their tips need more than %4 mm; use fewer rows</source>
        <translation>%1 Reihen sind je %2 mm lang: Rauten mit Brücken von %3 mm zwischen den Spitzen brauchen mehr als %4 mm; weniger Reihen nehmen</translation>
    </message>
    <message>
        <source>the rod's bending stiffness of %1 N mm2 asks for a backing wider than fits at %2 mm, where %3 N mm2 is the most: use thicker or stiffer sheets, or widen the base</source>
        <translation>die Biegesteifigkeit des Stabs von %1 N mm2 verlangt eine breitere Verstärkung, als bei %2 mm passt, wo %3 N mm2 das Höchste ist: dickere oder steifere Platten nehmen oder die Grundlage verbreitern</translation>
    </message>
    <message>
        <source>the rod's bending stiffness of %1 N mm2 leaves a backing narrower than %2 mm at %3 mm, where %4 N mm2 is the least: use thinner sheets, or narrow the base</source>
        <translation>die Biegesteifigkeit des Stabs von %1 N mm2 lässt eine Verstärkung schmaler als %2 mm bei %3 mm, wo %4 N mm2 das Kleinste ist: dünnere Platten nehmen oder die Grundlage schmaler machen</translation>
    </message>
    <message>
        <source>ligaments lean %1 degrees off the strip at %2 mm: use fewer rows, %3 mm long or longer</source>
        <translation>Stege stehen bei %2 mm um %1 Grad schräg zum Streifen: weniger Reihen nehmen, %3 mm lang oder länger</translation>
    </message>
    <message>
        <source>the rod's bending stiffness asks for %1 mm of material at %2 mm, %3 mm fit: widen the outline or raise max_width</source>
        <translation>die Biegesteifigkeit des Stabs verlangt bei %2 mm %1 mm Material, %3 mm passen: den Umriss verbreitern oder MaterialWidth erhöhen</translation>
    </message>
    <message>
        <source>the rod's bending stiffness asks for a width of %1 mm, above max_width %2 mm: choose a thicker or stiffer sheet</source>
        <translation>die Biegesteifigkeit des Stabs verlangt eine Breite von %1 mm, mehr als MaxWidth %2 mm: dickeres oder steiferes Material wählen</translation>
    </message>
    <message>
        <source>a curve leaves its plane by %1 mm (its z runs over %2 mm): a strip bends in one plane only; project the curve onto a plane first</source>
        <translation>eine Kurve verlässt ihre Ebene um %1 mm (ihr z läuft über %2 mm): ein Streifen biegt sich nur in einer Ebene; die Kurve vorher auf eine Ebene projizieren</translation>
    </message>
    <message>
        <source>bends between false inflections were smoothed away</source>
        <translation>Biegungen zwischen falschen Wendepunkten wurden weggeglättet</translation>
    </message>
    <message>
        <source>The strip would be %1 mm wide and %2 mm long: a strip bends as computed where it is %3 times as long as wide; draw a longer curve, or make the strip narrower.</source>
        <translation>Der Streifen wäre %1 mm breit und %2 mm lang: er biegt sich wie berechnet, wo er %3-mal so lang wie breit ist; eine längere Kurve zeichnen oder den Streifen schmaler machen.</translation>
    </message>
    <message>
        <source>a corner radius of %1 mm does not fit the hole at %2: make it smaller</source>
        <translation>ein Eckenradius von %1 mm passt nicht an das Loch bei %2: ihn kleiner machen</translation>
    </message>
    <message>
        <source>a corner radius of %1 mm leaves %2 % too much material at the tips at %3 mm: %4 mm or less keeps it within %5 %</source>
        <translation>ein Eckenradius von %1 mm lässt an den Spitzen bei %3 mm %2 % zu viel Material: %4 mm oder weniger hält es innerhalb von %5 %</translation>
    </message>
    <message>
        <source>strain %1 % at %2 mm is beyond the %3 % that %4 bears: its radius there is %5 mm, the least advisable %6 mm; %7; use a thinner sheet or a gentler curve</source>
        <translation>die Dehnung von %1 % bei %2 mm ist mehr als die %3 %, die %4 erträgt: der Radius ist dort %5 mm, der kleinste ratsame %6 mm; %7; dünneres Material oder eine sanftere Kurve nehmen</translation>
    </message>
    <message>
        <source>strain %1 % at %2 mm is beyond the %3 % that %4 bears: its radius there is %5 mm, the least advisable %6 mm; %7; use a thinner sheet or a gentler curve.</source>
        <translation>die Dehnung von %1 % bei %2 mm ist mehr als die %3 %, die %4 erträgt: der Radius ist dort %5 mm, der kleinste ratsame %6 mm; %7; dünneres Material oder eine sanftere Kurve nehmen.</translation>
    </message>
    <message>
        <source>it may crack there, or keep a bend</source>
        <translation>er kann dort reißen oder gebogen bleiben</translation>
    </message>
    <message>
        <source>it creeps there and keeps a part of its bend</source>
        <translation>er kriecht dort und bleibt zum Teil gebogen</translation>
    </message>
    <message>
        <source>it keeps a bend from there</source>
        <translation>er bleibt dort gebogen</translation>
    </message>
    <message>
        <source>it may crack there</source>
        <translation>er kann dort reißen</translation>
    </message>
    <message>
        <source>a tab has either a corner radius or a chamfer, not both</source>
        <translation>eine Lasche hat entweder einen Eckenradius oder eine Fase, nicht beides</translation>
    </message>
    <message>
        <source>a tab that tapers has neither corner radius nor chamfer</source>
        <translation>eine Lasche, die sich verjüngt, hat weder Eckenradius noch Fase</translation>
    </message>
    <message>
        <source>Missed: the %1, by %2 mm.</source>
        <translation>Verfehlt: %1, um %2 mm.</translation>
    </message>
    <message>
        <source>Missed: the %1, by %2 degrees.</source>
        <translation>Verfehlt: %1, um %2 Grad.</translation>
    </message>
    <message>
        <source>Missed: the %1.</source>
        <translation>Verfehlt: %1.</translation>
    </message>
    <message>
        <source>The least radius of %1 mm is missed: this rod has %2 mm.</source>
        <translation>Der kleinste Radius von %1 mm wird verfehlt: dieser Stab hat %2 mm.</translation>
    </message>
    <message>
        <source>a least radius of %1 instead of %2 mm</source>
        <translation>einen kleinsten Radius von %1 statt %2 mm</translation>
    </message>
    <message>
        <source>%1 bends with a radius of %2 mm at %3, a corner to any strip: %4, or smooth it</source>
        <translation>%1 biegt sich bei %3 mit einem Radius von %2 mm, für jeden Streifen eine Ecke: %4 oder ihn glätten</translation>
    </message>
    <message>
        <source>It would break at %1 mm: its radius there is %2 mm, the sheet bears %3 mm; use a thinner sheet or a gentler curve.</source>
        <translation>Er würde bei %1 mm brechen: der Radius ist dort %2 mm, die Platte erträgt %3 mm; dünneres Material oder eine sanftere Kurve nehmen.</translation>
    </message>
    <message>
        <source>It is strained beyond its limit at %1 mm: its radius there is %2 mm, the sheet bears %3 mm; %4; use a thinner sheet or a gentler curve.</source>
        <translation>Er ist bei %1 mm über seine Grenze gedehnt: der Radius ist dort %2 mm, die Platte erträgt %3 mm; %4; dünneres Material oder eine sanftere Kurve nehmen.</translation>
    </message>
    <message>
        <source>The curvature runs out to zero %1 without a clear change of sign, where the stiffness would have to be infinite or zero, whatever supports the strip: bend the curve a little more there, or reverse its bending at a clear rate.</source>
        <translation>Die Krümmung läuft %1 auf null aus, ohne ihr Vorzeichen klar zu wechseln; die Steifigkeit müsste dort unendlich oder null sein, was auch immer den Streifen stützt: die Kurve dort etwas mehr biegen oder ihre Biegung deutlich umkehren.</translation>
    </message>
    <message>
        <source>The line through its inflections %1</source>
        <translation>Die Gerade durch die Wendepunkte %1</translation>
    </message>
    <message>
        <source>A flat strip would break on this curve.</source>
        <translation>Ein flacher Streifen würde an dieser Kurve brechen.</translation>
    </message>
    <message>
        <source>A flat strip takes this curve.</source>
        <translation>Ein flacher Streifen nimmt diese Kurve an.</translation>
    </message>
    <message>
        <source>A flat strip takes a curve %1 mm from this one.</source>
        <translation>Ein flacher Streifen nimmt eine Kurve an, die %1 mm von dieser entfernt ist.</translation>
    </message>
    <message>
        <source>A strip bent beforehand takes this curve.</source>
        <translation>Ein vorgebogener Streifen nimmt diese Kurve an.</translation>
    </message>
    <message>
        <source>A strip bent beforehand cannot take this curve.</source>
        <translation>Ein vorgebogener Streifen kann diese Kurve nicht annehmen.</translation>
    </message>
    <message>
        <source>A strip bent beforehand would break on this curve.</source>
        <translation>Ein vorgebogener Streifen würde auf dieser Kurve brechen.</translation>
    </message>
    <message>
        <source>A strip bent beforehand takes a curve %1 mm from this one.</source>
        <translation>Ein vorgebogener Streifen nimmt eine Kurve an, die %1 mm von dieser entfernt ist.</translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm all along, the way it stands bent at %2 mm: its widths count on that</source>
        <translation>vor dem Einbau auf ganzer Länge auf einen Radius von %1 mm biegen, in der Richtung, in der er bei %2 mm gebogen steht: seine Breiten rechnen damit</translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm all along, the other way than it stands bent at %2 mm: its widths count on that</source>
        <translation>vor dem Einbau auf ganzer Länge auf einen Radius von %1 mm biegen, entgegen der Richtung, in der er bei %2 mm gebogen steht: seine Breiten rechnen damit</translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm at %2 mm, its sharpest, the way it stands bent there: its widths count on that; `blank` in the report has its curvature along the strip</source>
        <translation>vor dem Einbau biegen, am stärksten bei %2 mm auf einen Radius von %1 mm, in der Richtung, in der er dort gebogen steht: seine Breiten rechnen damit; die Eigenschaft Blank hat die Krümmung entlang des Streifens</translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm at %2 mm, its sharpest, the other way than it stands bent there: its widths count on that; `blank` in the report has its curvature along the strip</source>
        <translation>vor dem Einbau biegen, am stärksten bei %2 mm auf einen Radius von %1 mm, entgegen der Richtung, in der er dort gebogen steht: seine Breiten rechnen damit; die Eigenschaft Blank hat die Krümmung entlang des Streifens</translation>
    </message>
    <message>
        <source>bend it beforehand to %1, %2 it stands bent %3: its widths count on that%4</source>
        <translation>vor dem Einbau auf %1 biegen, %2 er %3 gebogen steht: seine Breiten rechnen damit%4</translation>
    </message>
    <message>
        <source>a radius of %1 mm</source>
        <translation>einen Radius von %1 mm</translation>
    </message>
    <message>
        <source>%1 %2, its sharpest</source>
        <translation>%1 (%2, am stärksten)</translation>
    </message>
    <message>
        <source>the other way than</source>
        <translation>entgegen der Richtung, in der</translation>
    </message>
    <message>
        <source>; `blank` in the report has its curvature along the strip</source>
        <translation>; die Eigenschaft Blank hat die Krümmung entlang des Streifens</translation>
    </message>
    <message>
        <source>There are remarks.</source>
        <translation>Es gibt Anmerkungen.</translation>
    </message>
    <message>
        <source>A flat strip cannot take this curve</source>
        <translation>Ein flacher Streifen kann diese Kurve nicht annehmen</translation>
    </message>
    <message>
        <source>The nearest curve is %1 mm away.</source>
        <translation>Die nächste Kurve ist %1 mm entfernt.</translation>
    </message>
    <message>
        <source>It moves by %1 mm at most</source>
        <translation>Er bewegt sich um höchstens %1 mm</translation>
    </message>
    <message>
        <source>%1 and %2; its stability margin is %3.</source>
        <translation>%1 und %2; seine Stabilitätsreserve ist %3.</translation>
    </message>
    <message>
        <source>does not stay</source>
        <translation>bleibt nicht</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>bleibt</translation>
    </message>
    <message>
        <source>the slot of %1</source>
        <translation>der Schlitz von %1</translation>
    </message>
    <message>
        <source>only %1 mm %2%3%4, %5 mm are needed in %6</source>
        <translation>nur %1 mm %2%3%4, in %6 sind %5 mm nötig</translation>
    </message>
    <message>
        <source>%1: a wall of %2 mm is too thin to print: make it %3 mm or more</source>
        <translation>%1: eine Wand von %2 mm ist zum Drucken zu dünn: sie %3 mm oder dicker machen</translation>
    </message>
    <message>
        <source>%1: the slots of %2 and %3 run into each other near (%4, %5): give the strips narrower tabs or move them apart</source>
        <translation>%1: die Schlitze von %2 und %3 laufen bei (%4, %5) ineinander: den Streifen schmalere Laschen geben oder sie auseinanderrücken</translation>
    </message>
    <message>
        <source>fit of the drawing</source>
        <translation>Ausgleich der Zeichnung</translation>
    </message>
    <message>
        <source>%1 %2 pieces at %3 mm, joined by plates of %4 mm, which are stiffer and move the shape by %5 mm</source>
        <translation>%1 %2 Stücke bei %3 mm, mit Laschen von %4 mm verbunden, die steifer sind und die Form um %5 mm bewegen</translation>
    </message>
    <message>
        <source>%1: a lap of %2 mm: give a length above 0 and below a third of %3 mm</source>
        <translation>%1: eine Überlappung von %2 mm: eine Länge über 0 und unter einem Drittel von %3 mm angeben</translation>
    </message>
    <message>
        <source>%1: strips of a law are not cut in pieces, for their plates would have to taper too: take a larger stock, or a strip of one sheet</source>
        <translation>%1: Streifen nach einem Gesetz werden nicht in Stücke geteilt, denn ihre Laschen müssten sich auch verjüngen: größeres Rohmaterial oder einen Streifen aus einer Platte nehmen</translation>
    </message>
    <message>
        <source>%1 pieces: %2, joined by plates of %3 mm on the free face of each layer, which are stiffer and move the shape by %4 mm</source>
        <translation>%1 Stücke: %2, mit Laschen von %3 mm auf der freien Seite jeder Lage verbunden, die steifer sind und die Form um %4 mm bewegen</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1 bei %2 mm</translation>
    </message>
    <message>
        <source>%1 %2 pieces at %3 mm, joined by plates of %4 mm, without the %5 holes that lie under them; they are stiffer and move the shape by %6 mm</source>
        <translation>%1 %2 Stücke bei %3 mm, mit Laschen von %4 mm verbunden, ohne die %5 Löcher, die unter ihnen liegen; sie sind steifer und bewegen die Form um %6 mm</translation>
    </message>
    <message>
        <source>%1: there is no room for %2 joints of %3 mm between its slots: take a shorter lap or a larger stock</source>
        <translation>%1: zwischen den Schlitzen ist kein Platz für %2 Stöße von %3 mm: eine kürzere Überlappung oder größeres Rohmaterial nehmen</translation>
    </message>
    <message>
        <source>it bends to a radius of %1 mm at %2 mm, but plywood of %3 mm bends to %4 mm at least %5 the face grain (%6); use a thinner sheet or a gentler curve</source>
        <translation>er biegt sich bei %2 mm auf einen Radius von %1 mm, Sperrholz von %3 mm aber nur bis %4 mm, %5 zur Faser der Deckschicht (%6); dünneres Material oder eine sanftere Kurve nehmen</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 bis %2 mm</translation>
    </message>
    <message>
        <source>%1 mm long, %2</source>
        <translation>%1 mm lang, %2</translation>
    </message>
    <message>
        <source>give a smaller max_width, or name a larger stock</source>
        <translation>kleinere größte Breite (max_width) angeben oder größeres Rohmaterial nennen</translation>
    </message>
    <message>
        <source>name a larger stock, join a strip of pieces by plates (lap), or scale the curve</source>
        <translation>größeres Rohmaterial nennen, einen Streifen aus Stücken mit Laschen verbinden oder die Kurve verkleinern</translation>
    </message>
    <message>
        <source>the grain runs along x, the side of %1 mm</source>
        <translation>die Faser läuft entlang x, der Seite von %1 mm</translation>
    </message>
    <message>
        <source>sideways margin %1 (%2): %3</source>
        <translation>seitliche Reserve %1 (%2): %3</translation>
    </message>
    <message>
        <source>sideways %1: %2</source>
        <translation>seitlich %1: %2</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>low</source>
        <translation>gering</translation>
    </message>
    <message>
        <source>ample</source>
        <translation>reichlich</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>it tips over sideways or twists out of its plane: guide it at the sides, or make it wider</source>
        <translation>er kippt zur Seite oder dreht sich aus seiner Ebene: führen Sie ihn seitlich, oder machen Sie ihn breiter</translation>
    </message>
    <message>
        <source>it stays in its plane, but a push from the side may tip it: guide it at the sides</source>
        <translation>er bleibt in seiner Ebene, aber ein Stoß von der Seite kann ihn kippen: führen Sie ihn seitlich</translation>
    </message>
    <message>
        <source>it stays in its plane</source>
        <translation>er bleibt in seiner Ebene</translation>
    </message>
    <message>
        <source>too wide for its length and bend to be judged as a rod: try it out</source>
        <translation>zu breit für seine Länge und Biegung, um als Stab beurteilt zu werden: probieren Sie es aus</translation>
    </message>
    <message>
        <source>its holes leave open whether it tips over sideways: guide it at the sides, or try it out</source>
        <translation>seine Löcher lassen offen, ob er zur Seite kippt: führen Sie ihn seitlich, oder probieren Sie es aus</translation>
    </message>
    <message>
        <source>%1 leaves its tabs no play: they bend a little between its edges</source>
        <translation>%1 lässt den Laschen kein Spiel: sie biegen sich ein wenig zwischen den Kanten</translation>
    </message>
    <message>
        <source>%1 leaves its tabs %2 mm across and %3 to %4 degrees</source>
        <translation>%1 lässt den Laschen %2 mm quer und %3 bis %4 Grad</translation>
    </message>
    <message>
        <source>slot of %1</source>
        <translation>Schlitz von %1</translation>
    </message>
    <message>
        <source>pocket</source>
        <translation>Tasche</translation>
    </message>
    <message>
        <source>%1 at %2 mm also runs %3 mm deep into %4 at %5 mm, beside the slots that join them, near (%6, %7, %8) mm%9: turn or shift one of them, or make them narrower there</source>
        <translation>%1 läuft bei %2 mm außerdem %3 mm tief in %4 bei %5 mm, neben den Schlitzen, die beide verbinden, nahe (%6, %7, %8) mm%9: einen der beiden drehen oder verschieben, oder sie dort schmaler machen</translation>
    </message>
    <message>
        <source>%1 at %2 mm lies in the thickness of %3 at %4 mm%5: place them apart, or make them narrower there</source>
        <translation>%1 liegt bei %2 mm in der Dicke von %3 bei %4 mm%5: sie auseinanderrücken, oder sie dort schmaler machen</translation>
    </message>
    <message>
        <source>%1 at %2 mm runs through %3 at %4 mm%5: slot them (interlock), place them apart, or make them narrower there</source>
        <translation>%1 läuft bei %2 mm durch %3 bei %4 mm%5: sie schlitzen (Interlock), auseinanderrücken, oder dort schmaler machen</translation>
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
        <source>Keep as my sheet</source>
        <translation>Als meine Platte behalten</translation>
    </message>
    <message>
        <source>Remove my sheet</source>
        <translation>Meine Platte entfernen</translation>
    </message>
    <message>
        <source>All sheets that are known, yours first</source>
        <translation>Alle bekannten Platten, Ihre zuerst</translation>
    </message>
    <message>
        <source>Name under which your sheet is kept</source>
        <translation>Name, unter dem Ihre Platte bewahrt wird</translation>
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
        <source>Width that your machine cuts away</source>
        <translation>Breite, die Ihre Maschine wegschneidet</translation>
    </message>
    <message>
        <source>How much it narrows while it is stretched, a share</source>
        <translation>Wie stark sie beim Dehnen schmaler wird, als Anteil</translation>
    </message>
    <message>
        <source>Where the numbers come from</source>
        <translation>Woher die Zahlen stammen</translation>
    </message>
    <message>
        <source>Adds these numbers to your library under the name above</source>
        <translation>Nimmt diese Zahlen unter obigem Namen in Ihre Bibliothek auf</translation>
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
        <source>Bends for each cause</source>
        <translation>Biegungen je Ursache</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>How many varied strips are bent</source>
        <translation>Wie viele veränderte Streifen gebogen werden</translation>
    </message>
    <message>
        <source>Bends them all; Escape stops it</source>
        <translation>Biegt sie alle; Escape bricht ab</translation>
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
        <source>Draw the curve that a strip of given length takes between two clamps into the open sketch; pull its ends</source>
        <translation>In die offene Skizze die Kurve zeichnen, die ein Streifen gegebener Länge zwischen zwei Klemmen annimmt, und an ihren Enden ziehen</translation>
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
        <source>Say whether a flat strip can take the selected curve, and if not why and where</source>
        <translation>Sagt, ob ein flacher Streifen die gewählte Kurve annehmen kann, und wenn nicht, warum und wo</translation>
    </message>
</context>
<context>
    <name>Elastica_Coupon</name>
    <message>
        <source>Coupon and calibrate</source>
        <translation>Probestreifen und Eichung</translation>
    </message>
    <message>
        <source>Make a test strip to hang over an edge, and turn its measured droop into a sheet of your own</source>
        <translation>Einen Probestreifen erzeugen, über eine Kante hängen und aus dem gemessenen Durchhang eine eigene Platte machen</translation>
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
        <source>Make printed blocks that hold the ends of the selected strips or model, or one slotted base plate</source>
        <translation>Gedruckte Halter für die Enden der gewählten Streifen oder des Modells erzeugen, oder eine geschlitzte Grundplatte</translation>
    </message>
</context>
<context>
    <name>Elastica_Interlock</name>
    <message>
        <source>Interlock selected strips</source>
        <translation>Gewählte Streifen verzahnen</translation>
    </message>
    <message>
        <source>Put the selected strips together to a model and cut slots where they cross</source>
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
        <source>Give the selected strips an even width and glue narrower strips on that make them stiff enough</source>
        <translation>Den gewählten Streifen eine gleichmäßige Breite geben und schmalere aufkleben, die sie steif genug machen</translation>
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
        <translation>Nächste Kurve zur Skizze</translation>
    </message>
    <message>
        <source>Find the curve nearest to the selected sketch that can be bent within limits</source>
        <translation>Die der Skizze nächste Kurve finden, die sich innerhalb der Grenzen biegen lässt</translation>
    </message>
</context>
<context>
    <name>Elastica_Nest</name>
    <message>
        <source>Nest on sheets</source>
        <translation>Auf Platten schachteln</translation>
    </message>
    <message>
        <source>Lay everything that must be cut for the selected strips, models and base plates on sheets</source>
        <translation>Alles, was für die gewählten Streifen, Modelle und Grundplatten zu schneiden ist, auf Platten legen</translation>
    </message>
</context>
<context>
    <name>Elastica_Perforate</name>
    <message>
        <source>Perforate</source>
        <translation>Lochen</translation>
    </message>
    <message>
        <source>Give the selected strips an even width and let holes make them as soft as they must be</source>
        <translation>Den gewählten Streifen eine gleichmäßige Breite geben und sie durch Löcher so weich machen wie nötig</translation>
    </message>
</context>
<context>
    <name>Elastica_Projective</name>
    <message>
        <source>Projective edit</source>
        <translation>Projektiv bearbeiten</translation>
    </message>
    <message>
        <source>Pull the selected sketch's curve by four handles: lines stay lines, a curve that can be bent stays one</source>
        <translation>Zieht die Kurve der gewählten Skizze an vier Griffen: Geraden bleiben gerade, eine biegbare Kurve bleibt biegbar</translation>
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
        <source>Look at the sheets that are known, with their sources, and keep your own</source>
        <translation>Bekannte Platten mit ihren Quellen ansehen und eigene behalten</translation>
    </message>
</context>
<context>
    <name>Elastica_Strip</name>
    <message>
        <source>Strip from sketch</source>
        <translation>Streifen aus Skizze</translation>
    </message>
    <message>
        <source>Make the flat strip that bends into the selected spline: the bent part and, linked to it, the flat one</source>
        <translation>Den flachen Streifen erzeugen, der sich in den gewählten Spline biegt: das gebogene Teil und, damit verknüpft, das flache</translation>
    </message>
</context>
<context>
    <name>Elastica_Tolerance</name>
    <message>
        <source>Tolerance study</source>
        <translation>Toleranzstudie</translation>
    </message>
    <message>
        <source>Find how far the bent strip strays when sheet, cut and clamps vary within their ranges</source>
        <translation>Ermitteln, wie weit der gebogene Streifen abweicht, wenn Platte, Schnitt und Klemmen in ihren Bereichen schwanken</translation>
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
</TS>
