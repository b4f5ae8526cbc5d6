<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Largest distance by which smoothing may move the curve; 0 removes only steps and corners, within 0.1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop dragged poles where the strip can be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is off in sheet, cut and clamps, rad and mm: thickness_wave = 0.01, grain = 0.035, clamps = 0.0087, kerf = 0.05</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected deviation of a real strip from its design, due to the model, its uncertainty and the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation of the strip as made and held, with its causes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest deviation of the strip, as made and held, from its design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The strips, in the order of assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later features that the cut parts do not contain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut slots where strips cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction from which later strips are pushed on; zero for any direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of joints of two slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages of the last recompute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collisions of strips outside their slots, known a moment after the other results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strip of this flat part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer of a laminated strip: base or backing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model whose slots the part gets; none for a single strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sketch, or edges of an object, that the strip follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape of the feature: the strip as bent or as cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material the strip is cut from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full name of the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of the sheet; measure yours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data of the sheet, so that the file opens on every computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compensate anticlastic bending in the widths if the sheet's Poisson ratio is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compensate slots, narrow tabs and holes in the widths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest total width of ligaments or backing; 0 for the largest that fits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style: plain, perforated or laminated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet of the backing of a laminated strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data of the backing's sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support at the start of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support at the end of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Include the strip's own weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of gravity in space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elasto-gravity length; 0 for the value of the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All weight in newtons: alpha = 0.001, own = true</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curvature of the strip before bending, 1/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curvature before bending that varies along the strip: stations = [0, 300], curvatures = [0, 0.01]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the curve exactly, or the nearest one within limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least stability margin. A strip is stable above 0, and safely stable from 5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain in percent; 0 for the limit of the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply the strain limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest length; 0 for no limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest width, which bounds the ratio; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends that keep their position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the tangents of both ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep inflections on the curve's inflection line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two points of another line: x, y, x, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the tab at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the tab at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounding of the tabs' corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of a hole in the middle of each tab; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first tab in full: length = 12, chamfer = 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last tab in full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of copies to cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict on the strip and its curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reasons and remarks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results that make the strip fail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest stiffness over least stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stability margin; positive means stable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place along the strip where stability is lost; 0 for a stable strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain, in percent of the sheet's limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain of the skin, in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance from the drawn curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the free part along the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the narrowest place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass in grams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden because its recompute failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown because the recompute of its model failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Identifies the request from which the shape was made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects with which the curve moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model or strips whose tabs go through the plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet of the plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data of the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model or strips whose ends are held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strips, models and base plates to be cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of a sheet, along its grain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest distance between parts, and from the edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show live feedback while this sketch is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle over which half planes are spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bodies, surfaces and meshes that are cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of a curve from the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest displacement of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement of the end along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement of the end along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation of the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement of the start along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement of the start along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation of the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrangement of the planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sketch, wire or edges perpendicular to the planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point on the axis of half planes: x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point on the axis of half planes: y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point on the axis of half planes: z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strip to bend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest wavelength that is kept; 0 keeps all waves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Treatment of closed lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis perpendicular to the planes, or common to the half planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sideways stability margin; positive means stable, 0 undecided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sideways stability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model or strips whose tabs go through the rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet of the rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends of the strips that have a ring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between two rings that hold inclined tabs at their angle; 0 for one ring at each end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Masses and forces on the strip: at = 90, mass = 3, or at = 90, force = [0, -1] (mm, g, N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sketch or edges with the first state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sketch or edges with the second state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the feature shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material the part is cut from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict on the part and its curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>True if the part snaps between its states in the same clamps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest force between the states, N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travel of the pushed point at which the part snaps; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length between the pads along the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least thickness in the plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest thickness in the plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest gap between ends of edges that is closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages in all languages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the curve as drawn, if it is not smoothed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply the least stability margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest length; applies together with the largest length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends whose tangents are kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the curve to which the places of rails, ties and loads refer; 0 for the present length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sources in the same container; they enter and leave containers together with the feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lengths and ends of the edges when they were chosen</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica</name>
    <message>
        <source>en</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pull the ends and the tangents by their handles; the curve is drawn on release</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length between the clamps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the coupon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type the readings first: overhang = droop, in mm, such as 120 = 14.5; 150 = 31</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest overhang of the coupon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrote</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DXF files are of version R12 here, curves as arcs: the library ezdxf is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The files do not contain {later}, which was added after {strip}. Add it to the strip (slots, tabs, holes), or draw it in the files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a folder for the files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exists already: choose another folder, or tick the box that overwrites</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter the full path of the folder, or press Browse.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ranges are those of the sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edited object was deleted. Press Cancel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the nearest curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick another curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then click a sketch or an edge, in the view or in the tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move or turn an end: type numbers, or drag one of the handles in the view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bent further</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nest on sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet and width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends and weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Printed blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns of holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows of holes (0 = automatic)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest stiffness ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least stability margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain, % (0 = sheet)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep end tangents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounding of tabs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hole in tabs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engraved text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut slots where strips cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inner ends of slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot (0 = none)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screw holes (0 = none)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play beside tabs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built-in sheets stay: keep yours under another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elasto-gravity length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Constraints on the drawn curve that OK takes away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nearest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stiffness range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickness along the strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plasticity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kerf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>combined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keep-out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stiffness bounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end tangent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start tangent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inflection line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>symmetry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the strip laid flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no curve yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a sketch with a spline, or an edge of an object, first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a sketch with a spline first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a strip first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select two strips or more first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected lines are pieces of a polyline, as FreeCAD reads it from a file: draw a B-spline through their ends (workbench Draft) and select that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis at x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis at y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis at z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closed lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw it into the sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Escape stops it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching for changes that help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep it possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A dragged pole returns to the last position where the strip can be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cutting files show {strip} without {later}, a later feature of its body. Use the slots, tabs and holes of the strip instead, or draw the change in the files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching the nearest curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Putting the model together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for strips that meet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting the mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bending the strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the symmetry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Must not break</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Must be stable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section into curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the curve as drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth the curve by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth waves below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about an axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left and right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above and below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perforated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laminated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exactly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clamped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pinned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slide-x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slide-y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roller-x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roller-y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bezier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>polyline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hull</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a sketch to edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make sketches to edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaces this feature by objects that no longer follow its source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>backing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inflection on the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inflection off it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nearest curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above the sheet's limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line must not meet the curve here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select blocks, a plate or rings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap (0 = one ring)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail (bar on one side)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slot (two bars)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin (the strip turns)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tie (cord)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hung mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the other end of the cord.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the place on the sketch or on the strip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thrust line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cord</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rail, pin, tie or load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-state part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two states</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching the part with two states</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius at the pads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State without forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thinnest place (0 = automatic)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equal lengths: keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest thickness or least ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holes in pads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holes from the ends of pads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of pads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of pads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pushed at (0 = middle)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every selected strip has its flat part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First draw a single curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First use the nearest curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First make the strip possible.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of its upper face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest curve to sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the curve: Nearest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flat outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>backing outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every selected strip has its outline.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaBend</name>
    <message>
        <source>Bend forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of the strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End of the strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement of the start along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement of the start along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation of the start, degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement of the end along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement of the end along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation of the end, degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the path from rest in small steps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaCheck</name>
    <message>
        <source>Check curve</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaCoupon</name>
    <message>
        <source>Coupon and calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coupon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the coupon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write its cutting file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overhang = droop, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>120 = 14.5; 150 = 31</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet to be measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds the test strip to the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for a DXF or SVG file and writes the test strip into it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overhang = droop, in mm, one pair for each measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of a reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the calibrated sheet in your library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds the calibrated sheet to your library</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaExport</name>
    <message>
        <source>Export cutting files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DXF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STEP, flat and bent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut list (CSV)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nest on sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DXF version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance of arcs and polylines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overwrite files that exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One drawing for each part, for lasers and cutters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same drawings for programs that draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solids for other CAD programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A table of all parts with sizes and numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All parts together on sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of a sheet, along its grain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Splines as drawn, or arcs or lines for machines that take nothing else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The oldest version that your program reads is the safest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width removed by the cut; outlines are offset by half of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of arcs and lines from the spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machines that cut every line would cut the tabs off at their guide lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guide lines and names of mating strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of the files; an empty field opens a dialog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If this is off, existing files are not changed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaFixtures</name>
    <message>
        <source>End fixtures and base plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Printed blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make blocks for the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room around the tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screw holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a slotted plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of its upper face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room beside the tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clearance of slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blocks to be printed, with a pocket for every tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room around a tab in its pocket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least thickness around the pocket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the foot on either side; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of the screw holes in the foot; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One plate with a slot for every tab that goes through it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet of the plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the upper face of the plate along z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room beside a tab on either side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added to the width of the slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least distance of the slots for strips from the edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One ring with a slot for every tab at the start of the strips, and one for the ends, such as below and above a lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a ring for each end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet of the rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap between two rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between two rings that hold inclined tabs at their angle; 0 for one ring at each end</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaPreferences</name>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clearance of slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DXF version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance of arcs and polylines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While a sketch is edited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show curvature, inflections and their line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the nearest curve that can be bent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet that new strips are made of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the widest place of new strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the tabs of new strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width removed by the cut; outlines are offset by half of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added to the width of slots in new models and plates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The oldest version that your program reads is the safest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Splines as drawn, or arcs or lines for machines that take nothing else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of arcs and lines from the spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In sketches that strips follow, and in those made from this workbench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While the mouse rests, where a curve is refused</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaProjective</name>
    <message>
        <source>Projective edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handles (x, y)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1, lower left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2, lower right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3, upper right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4, upper left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the handles back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First corner of the box, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First corner of the box, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second corner of the box, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second corner of the box, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Third corner of the box, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Third corner of the box, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fourth corner of the box, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fourth corner of the box, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the box around the drawn curve</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaSheets</name>
    <message>
        <source>Sheet library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear modulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness against shear in the sheet's plane, which keeps a strip from tipping sideways; plywood has far less than the estimate E / (2 (1 + ν)), which an empty field takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove my sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All known sheets, your own first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of your sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As measured with a caliper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness of the material along the strip; a coupon measures it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass for volume; it counts where a strip carries its weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain of the skin before the sheet breaks or stays bent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width removed by the cut of your machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transverse contraction as a fraction of the stretch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source of the data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes this sheet out of your library</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaTolerance</name>
    <message>
        <source>Tolerance study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strips for each cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of varied strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computes all strips; Escape stops it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Bend</name>
    <message>
        <source>Bend forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move or turn the ends of the selected strip and watch it take its new rest shape</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Between</name>
    <message>
        <source>Draw a strip of given length between two clamps, as a curve in the open sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve of given length</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Check</name>
    <message>
        <source>Check curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check whether a flat strip can take the selected curve; if not, show why and where</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Coupon</name>
    <message>
        <source>Coupon and calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a test strip to hang over an edge, and turn its measured droop into a sheet of your own</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Edit</name>
    <message>
        <source>Edit strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change sheet, widths and ends of all selected strips at once</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Export</name>
    <message>
        <source>Export cutting files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write DXF, SVG and STEP files, nest and cut list of the selected strips, models and base plates</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Fixtures</name>
    <message>
        <source>End fixtures and base plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make printed blocks, a slotted base plate or rings that hold the ends of the selected strips or model</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Interlock</name>
    <message>
        <source>Interlock selected strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Combine the selected strips into a model, and cut slots where they cross</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Laminate</name>
    <message>
        <source>Laminate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rebuild the selected strips as two glued layers: a base of even width and a narrower backing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Live</name>
    <message>
        <source>Live feedback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show over the open sketch whether a flat strip can take its curve, while it is drawn and dragged</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Nearest</name>
    <message>
        <source>Nearest curve to sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find the curve nearest to the selected sketch that can be bent within limits</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Nest</name>
    <message>
        <source>Nest on sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrange all cut parts of the selected strips, models and base plates on sheets</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Perforate</name>
    <message>
        <source>Perforate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the selected strips an even width, with holes that set their stiffness</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Projective</name>
    <message>
        <source>Projective edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pull the selected sketch's curve by four handles; if a strip can take the drawn curve, it can take the changed curve</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Section</name>
    <message>
        <source>Section into curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the selected body, surface or mesh by planes into smooth curves that strips can follow</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Sheets</name>
    <message>
        <source>Sheet library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the known sheets with their sources, and store your own sheets</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Strip</name>
    <message>
        <source>Strip from sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the strip that bends into the selected spline: the bent part and the linked flat part</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Tolerance</name>
    <message>
        <source>Tolerance study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute the deviation of the bent strip when sheet, cut and clamps vary within their ranges</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Elastica</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat strips that bend into drawn curves</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Example</name>
    <message>
        <source>Open an example</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open an example arch with its strip and its flat part, to try changes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Rails</name>
    <message>
        <source>Rails, ties and loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the selected strip between its ends by rails, pins and cords, and load it with forces and masses</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ElasticaRails</name>
    <message>
        <source>Rails, ties and loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of the element or load to add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place it on the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then click the sketch or the strip in the view; for a tie, click both places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elements and loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose an element or load to change or remove it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place along the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance along the curve from its start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the other end of the tie from the start of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of a hole in the strip for a cord or screw; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of a notch in each edge of the strip, for two cords; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep this point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the point in space when the curve changes, instead of the distance along the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes the chosen element or load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force along the x axis of the sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force along the y axis of the sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hung mass; it needs the own weight of the strip</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Flexure</name>
    <message>
        <source>Two-state part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a part that rests in both selected curves, such as a clip that snaps, and the plate that holds it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Flat</name>
    <message>
        <source>Flat part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the missing flat parts of the selected strips, for example of copied strips</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica_Outline</name>
    <message>
        <source>Flat outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the outlines of the selected strips as plane faces, for pockets, tool paths and FreeCAD's own DXF files</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
