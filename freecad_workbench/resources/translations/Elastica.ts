<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>What is off in sheet, cut and clamps, rad and mm: thickness_wave = 0.01, grain = 0.035, clamps = 0.0087, kerf = 0.05</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far a real strip strays from its design, by the model, what that leaves open, and its sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it strays as made and held, and by what</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of the strip, as it is made and held, from its design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The strips, in the order of assembly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Features that follow what is cut, and are left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut slots where strips cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added to the width of every slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slots as the angle asks for, or as in the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inner ends of the slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later strips are pushed on from here; zero leaves it open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many slots fit into each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was found on the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strips that run into each other where no slot lets them, found a moment after the rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The strip whose flat part this is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of a laminated strip the base, or the backing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model whose slots it gets; none for a strip by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sketch, or edges of an object, that the strip follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the shape is: the strip as bent, or as cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material the strip is cut from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of the sheet; measure yours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sheet's numbers, so that the file opens anywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the widest place; 0 leaves it to MinWidth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the narrowest place, or a limit for it; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Narrowest strip, tab or tongue that the workshop can make; 0 for what the sheet takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Creep factor of the sheet in the long run; 0 leaves creep out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where a closed strip is joined, along its curve; 0 chooses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make up for anticlastic bending in the widths, where the sheet's Poisson ratio is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make up for slots, narrow tabs and holes in the widths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a strip that cannot be cut or handled, and say so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most of ligaments or backing, summed across; 0 for what fits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How stiffness becomes material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the outline, perforated or laminated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holes side by side in a perforated strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holes one after the other; 0 chooses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest share of the width that holes take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Narrowest ligament between holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Widest place of the narrowest hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounding of the holes' corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the sides of holes are made of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet that is glued on in a laminated strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The backing's numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Narrowest backing of a laminated strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holes in the tabs that align the layers; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What holds the start of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What holds the end of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does the strip carry its own weight?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction in space in which things fall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elasto-gravity length; 0 takes the sheet's</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Masses hung on the strip: at = 90, mass = 3 (mm, g)</source>
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
        <source>Instead of it along the strip: stations = [0, 300], curvatures = [0, 0.01]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nodes of the rod; 0 chooses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the curve exactly, or the nearest one within limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest stiffness ratio; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least stability margin; 5 is safely stable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain in percent; 0 takes the sheet's</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does MarginLimit count?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does the strain limit count?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest curvature, 1/mm; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least length; counts with MostLength</source>
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
        <source>Ground and boxes: point = [0, 0], normal = [0, 1]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the strip: lower = 1.5, upper = [2, 3, 2]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which ends stay where they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the tangents of both ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose tangents KeepTangents keeps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror image or half turn that stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places along the curve that it still passes, mm</source>
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
        <source>Slots: at = 40, width = 1.2, side = 'lower'</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text engraved on the strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many of it are cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Can a flat strip take the curve?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why not, and what else to know</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest stiffness over least stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stability margin; positive means that it stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where along the strip stability is lost; 0 where it is not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain, in percent of what the sheet bears</source>
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
        <source>Hidden until it can be made again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown until its model can be made again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tells the request that the shape was made from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the curve moves with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A model, or strips, whose tabs go through it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the plate is cut from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sheet's numbers</source>
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
        <source>Least distance of slots from the edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline around all slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A model, or strips, whose ends are held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room around the tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least thickness around the pocket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the foot sticks out on either side; 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of the screw holes in the foot; 0 for none</source>
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
        <source>Least distance between parts and from the edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many sheets are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show live feedback while this sketch is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle that half planes are spread over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bodies, surfaces and meshes that are cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far a curve may be from the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the curve may be moved to smooth its curvature; 0 follows it as drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the curve moves at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the end is moved along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the end is moved along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the end is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the start is moved along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the start is moved along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the start is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many curves there are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many planes there are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the planes stand to each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sketch, wire or edges that planes stand across</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The axis of half planes passes here: x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The axis of half planes passes here: y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The axis of half planes passes here: z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The strip that is bent further</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waves shorter than this are smoothed away; 0 keeps them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What becomes of closed lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What planes stand across, or half planes about</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Margin against tipping over sideways, positive where it stays in its plane; 0 where undecided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does it stay in the plane of its curve?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Elastica</name>
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
        <source>Held deviation</source>
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
        <source>{strip} is followed by {later}, which these files leave out: make it in the strip itself (slots, tabs, holes), or draw it into the files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{strip} is followed by {later}, which the nest leaves out: make it in the strip itself (slots, tabs, holes), or draw it into the cutting files</source>
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
        <source>write the whole path of the folder, or press Browse</source>
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
        <source>what this panel works on was deleted: press Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tick what is to be made</source>
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
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Narrowest place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stability margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass</source>
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
        <source>Rows of holes (0 = chosen)</source>
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
        <source>Carries its weight</source>
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
        <source>Held away by</source>
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
        <source>inflections on their line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too short for its width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>would break</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond its limit</source>
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
        <source>How many</source>
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
        <source>Must stay in its shape</source>
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
        <source>Takes this feature's place and follows nothing any more</source>
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
        <source>Sideways margin</source>
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
        <source>How far the start is moved along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the start is moved along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the start is turned, degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the end is moved along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the end is moved along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the end is turned, degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the way from rest in small steps</source>
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
        <source>How far a reading may be off</source>
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
        <source>Width that the cut takes away; outlines are set off by half of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far arcs and lines may be from the spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the files go; asked for where it is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without this nothing that exists is changed</source>
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
        <source>How far the foot sticks out on either side; 0 for none</source>
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
        <source>What the plate is cut from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the upper face of the plate lies, along z</source>
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
        <source>Least distance of slots from the edge</source>
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
        <source>Sheet that new strips are made of; a name of the sheet library</source>
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
        <source>Width that the cut takes away; outlines are set off by half of it</source>
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
        <source>How far arcs and lines may be from the spline</source>
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
    <name>ElasticaSentences</name>
    <message>
        <source>bent, the backing lies inside at the start (the end at x = 0 of the cutting files), on the other side of the bend beyond each inflection: INSIDE AT START is engraved on both sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bent, the backing lies outside at the start (the end at x = 0 of the cutting files), on the other side of the bend beyond each inflection: OUTSIDE AT START is engraved on both sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bent, the backing lies inside: INSIDE is engraved on both sheets, on the faces that look there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bent, the backing lies outside: OUTSIDE is engraved on both sheets, on the faces that look there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loads hang where gravity pulls in the plane of the curve: give gravity=True or a direction in that plane, or leave loads out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a laminate that carries its weight follows its curve exactly, from flat sheets: leave out limits, keep and natural_curvature, or gravity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples are of a strip that follows its curve exactly: leave limits and keep out, or samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a strip with loads hung on it follows its curve exactly: leave limits and keep out, or the loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 cannot be read: write keys and values, such as %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point mass is %1: it can't be negative, in g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least%1 is %2 mm and Most%3 is %4 mm: give both, the least above 0 and not above the most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sheet %1: thickness is %2; it must be positive, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples is %1: it must be a whole number, %2 or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>creep is %1: it must be 0 or more; plywood indoors has %2 (Eurocode 5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the width of the base is %1: it must be positive, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deeper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shallower or narrower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2: use one of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tab length is %1: it must be 0 mm or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tab length is %1: use 0 for no tab, or %2 mm or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>glued leaves go in steps, so no stack follows a drawn curve exactly: give limits or keep, such as keep=Keep(), or call nearest_rod, and the nearest stack is found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the blank is %1 mm long before it is bent, the curve %2 mm: give its curvature along the length of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a rest curvature is given at two or more stations, one curvature each: begin at 0 mm, go on to the length of the strip, and name a station twice at most, for a step between the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the blank has a corner at %1 mm: round it, a strip has none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve is on the border of what a strip can take: near %1 mm the stiffness would have to be more than %2 times that of other places. Move the curve farther from the line through its inflections, or bend it more clearly there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rods of another shape are as near, but for 2 % (%1 of them): look at `ties`, and draw the curve closer to the one you mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strain %1 % is more than %2 % of what the sheet bears: creep is not linear there, and more than said; use a thinner sheet or a gentler curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with a creep factor of %1 it will not stay in the long run: it snaps into another shape; use a stiffer sheet or support it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section is %1: give a law with limits, such as ThicknessLaw(sheet, 3, 8, width=20)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compensate is %1: give True for all that widths can make up for, False for nothing, or leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, its widths made for anticlastic bending,</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: poisson_ratio is given twice; leave out %2, now that it is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignore_limits must be True or False, got %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, without its correction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; each cause alone%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>side is %1: give 1 for left of the way from start to end, -1 for right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a strip of %1 mm does not bend between ends %2 mm apart: make it longer, and the ends two places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bulges to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bulges to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the strip is straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the strip's free end goes %1, with %2 inflections (mode %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a strip whose end is free turns about its start: give the angle of a clamp there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a force moves a free end, and this one is held: give None for the end, or no force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the strip %1 of its chord, with %2 inflections (mode %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it takes no shape near its design: hold it nearer to its curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the curve is open: only a closed one can begin anywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the curve cannot begin at %1 mm: it is %2 mm long; give a place along it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the curve is closed with a corner of %1 degrees at %2: a strip bends without kinks; round it, or leave a gap between its ends%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve is closed and begins where it is not bent, so places are counted from %1, %2 mm after its start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a closed strip is of one sheet of even thickness, which its lap can join: take a plain or perforated strip, or leave a gap between its ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its ends are %1 and %2 mm wide where it closes: choose another joint, leave out gravity, or make the curvature continuous there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>glue its tab of %1 mm, bent as drawn, behind its start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>join its ends butt to butt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed: %1 at %2, where it is %3 mm wide; the joint carries %4 N mm and %5 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joint is %1 mm, but the curve is open and begins at its own end: leave joint out, or close the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joint is %1: give a place along the curve, 0 to %2 mm, or none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lap joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps of width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>anticlastic bending</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leaning ligaments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>narrow tabs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as made and held%1 the strip strays about %2 mm from its design, %3 % of its length%4: the model says %5 mm and leaves %6 mm open, and sheet, cut and clamps add %7 mm%8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, most of it from the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, most of it as modelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, most of it left open by the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction in the pockets is not counted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its widths do not make up for how it is made, since it would then be %1; give it tabs as wide as its ends, or shallower slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every line through the inflection at %1 mm meets the curve again or touches it there (the curve is in the way %2): wind the curve less, or support the strip between.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1%2 %3, where the moment would vanish or change sign and the curvature does not: move the curve off the line there, or support the strip between there and the inflections beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its inflections do not lie on one %1line: those %2 are %3 mm off the nearest one%4. Move them onto one line, or support the strip between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line through its inflections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1line that the supports ask for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(at most %1 mm is put right without asking)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undecided at this precision: the curve turns by %1 degrees at %2, %3 along it, and the digits of the file alone can turn its handle of %4 mm by %5: save it with more decimals, or make the node smooth with longer handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The piece from %1 to %2 mm %3 and joined to a bent one, so the stiffness would have to go to 0 at the joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve crosses itself (at %1 mm): two parts of the strip must pass side by side there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less the natural %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 (at %2 mm) is free to turn, so the curve must have no curvature there; it has %3 1/mm%4: clamp this end, or let the curvature run out to zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The width of the strip steps %1, where the curvature jumps: smooth = 0.1, or --smooth 0.1, makes it a fair curve of degree 4 within 0.1 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smooth = 0.1, or --smooth 0.1, makes it a fair curve of degree 4 within 0.1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>do not repeat the knot there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The width of the strip has a kink %1, where the slope of the curvature jumps: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crosses the curve %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>touches the curve %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is tangent to the curve in the inflection %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no small move of the control points brings the inflections onto one line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip cannot take this curve of %1 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip of any width takes this curve of %1 mm: it is not bent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip can take this curve of %1 mm; it has %2, %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip can take this curve of %1 mm; it has no inflections.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked cannot take this curve of %1 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked has this curve of %1 mm already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked can take this curve of %1 mm; its bending does not change sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked can take this curve of %1 mm; its bending changes sign %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under its weight an unbent strip sags, unless it is upright: draw the shape it may hang in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a weight in newtons needs gravity too: pass gravity=Gravity(...) for its direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve was moved by at most %1 mm to bring its inflections onto one line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curve was moved by at most %1 mm to take the last bend out of its ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The weight is far too much for the stiffness (a gravity length of %1 mm on a curve of %2 mm): use a lighter or stiffer sheet, or look at the units (200 gsm card: 96 mm).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point mass of %1 g at %2 mm does not lie on the curve of %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in balance but it will not stay: it snaps into another shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it stays, but a push, a loose clamp or a cut that is off may make it snap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it stays, and comes back when pushed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rod snaps %1 of the way from its present shape; here it comes to rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no rest shape found: %1 of the way from the present shape was possible; move the ends in smaller steps, or give a guess nearer to the answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the ends are %1 mm apart, but the rod is only %2 mm long: bring them closer or use a longer rod</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the ends are as far apart as the rod is long (%1 mm), so it must be straight, which its end angles or its weight do not allow: bring the ends closer together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a force along %1 does nothing: both ends hold %2; free one end along %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both ends turn freely: give the moments of both, (start, end)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a moment at the %1 does nothing: its support holds the angle; free the angle there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the slot for %1%2 is %3 mm wide for a tab of %4 mm, which it cannot hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end the strips steeper to the plate, take a thinner plate, or hold them by end fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside the tab of %1 the strip would stand %2 mm deep in the plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give it a tab as wide as the strip, or set the plate so much lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>make it wider (max_width), or ask for the nearest curve with a smaller ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ligaments down to %1 mm are allowed, %2 mm are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm long and %2 mm wide: too slender to handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(and %1 more)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only %1 mm wide %2%3, %4 mm are needed in %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(and %1 more places)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 mm along it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at (%1, %2) mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ask for wider ligaments, or fewer columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>make it wider, or split it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave more room between the slots: a larger ring or plate, fewer or narrower strips, a wider border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 x %2 mm is larger than the stock of %3 mm in %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name a larger stock, split it, or scale the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stock is %1: give the two sides of the sheet in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2: give a positive width in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the laminate cannot be as soft as it should at %1 mm (base %2 mm, K %3) and as stiff at %4 mm (base %5 mm, K %6):</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>narrow the base at %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>widen it at %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the width of the base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>make the backing %1 times as thick as the base or more (now %2 times)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dots are %1 mm across: give a diameter, 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the base is %1 mm wide at %2 mm, narrower than the least backing of %3 mm: widen it there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a backing of at least %1 mm at %2 mm is wider than max_width %3 mm at %4 mm: raise max_width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose other widths (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, when holes still fit at %2 mm: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ligaments would be %1 mm wide at %2 mm, below %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the width of the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>make the outline %1 mm or more wide there (now %2 mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holes would take %1 % of the width at %2 mm, more than %3 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hole_ratio is %1: it must lie between 0 and 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sides are "spline" or "arc", not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the outline is %1 mm wide at %2 mm: %3 ligaments of %4 mm and %5 columns of holes need more than %6 mm; widen it or use fewer columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>use a thinner or softer sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the ligaments need %2 mm in all where they are widest, not %3 mm; %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the ligaments are %1 mm in all at the narrowest place, below min_width %2 mm: widen the outline or lower the stiffness ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>allow a hole_ratio of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lower the stiffness ratio from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2: a perforated strip has a whole number of them, from 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the slots leave %1 % of the stiffness at %2 mm and move the shape by %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm long, %2 to %3 mm wide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a strip needs max_width or min_width (mm): the rod only fixes how widths compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the narrowest place is %1 mm, below min_width %2 mm: the ratio is %3, so max_width must be %4 mm or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is given over %2 mm, the strip is %3 mm long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a T-slot needs positive sizes in mm: depth, screw, nut = (width, height), wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a nut of %1 mm is held by nothing in a slot of %2 mm: make it wider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a T-slot of %1 mm ends before its nut is in, at %2 mm: make it deeper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a T-slot of %1 mm does not fit a tab of %2 mm: lengthen the tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tab corners of %1 mm do not fit a tab of %2 by %3 mm: make them smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a taper of %1 mm leaves nothing of a tab %2 mm wide: make it smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the nut of a T-slot, %1 mm, is wider than the tab's outer edge of %2 mm: make the tab wider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holes of %1 mm and %2 mm, %3 and %4 mm into the tab, meet: move one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a %1 mm hole %2 mm into the tab does not fit its length of %3 mm: move it or lengthen the tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a %1 mm hole %2 mm off the centre line breaks the edge of a %3 mm wide tab: make it smaller or the tab wider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a %1 mm hole %2 mm into the tab meets its T-slot: move it aside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gravity %1 is a direction in space: give frame, the plane of the curve, or two numbers, the direction in the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 To make it all the same, set ignore_limits (--ignore-limits).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what is hung on the rod bends it nowhere (a held end carries it, or its mass is 0): hang it between the ends, or leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a laminate that carries its weight must stand upright and weigh what its sheets do: turn its plane, give gravity=True or the base sheet's gravity, or leave gravity out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min_width is %1 mm, more than max_width, %2 mm: give the larger one as max_width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max_width is %1 mm, but %2 needs %3 mm at its narrowest: widen the strip, take another sheet, or allow less with shop=Shop(least_width=...)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slot at %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a bent slot needs four points or more along its centre line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the slots at %2 mm and %3 mm meet: move them apart, or make them narrower or shallower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not open at the edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cuts through to another edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the slot at %2 mm %3: make it %4 or move it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the slot at %2 mm is not on the strip, which goes from %3 to %4 mm with its tabs: move it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the slot at %2 mm meets a hole at %3: move one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>assembly: %1; push each strip onto those before it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 touch along a line at %3 mm of %4 instead of crossing: move them apart or turn one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no two strips cross: interlocking cut no slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 must be threaded in, being held from both edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 cross at %3 degrees at %4 mm of %5: the slots are up to %6 mm wide; a larger angle would hold better</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the slots open its outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 cross at %3 mm of %4, but one of them ends before the crossing comes to its edge, so that no slot can open there: shorten, move or turn one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a clearance of %1 mm is larger than %2 is wide at %3 mm: make it smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the model %1 has no strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the model %1 has %2, made for its strips where they are: repeat the strips without rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no tab of the model goes down through the plate, their tips are %2 to %3 mm above its upper face: move the plate to where the strips end, give the strips longer tabs, or hold ends that come from below by rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: there is no strip for it to hold: name other strips or ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the tab of %2 leans to %3 degrees from the plate: at %4 degrees or less a slot cannot hold it; use a fixture there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the slots of %2 and %3 come closer than %4 mm near (%5, %6): give the strips narrower tabs or move them apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a screw of %2 mm does not fit a foot of %3 by %4 mm: make the foot longer or the screw thinner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the plane of the strip leans %2 degrees to the floor: leave the floor out, and the block stands square to its tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the block reaches %2 mm below the floor: lower the floor or shorten the tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a strip has the ends "start" and "end", not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every piece fits the sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the kerf is %1: it must be a finite number of mm, 0 for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the kerf is %1 mm, wider than the cut of any tool: give the width of the cut in mm, such as 0.15 for a laser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a kerf of %1 mm is too wide for a loop on %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with a kerf of %1 mm two cut loops meet at %2: move them apart there or use a smaller kerf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 by %3 mm is larger than a sheet of %4 by %5 mm with a margin of %6 mm%7: use a larger sheet or make the part in pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the grain %1 it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edge has no length: draw a curve for the strip to follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no edge was given: give at least one edge or wire for the strip to follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edges make %1 separate chains, the nearest %2 mm apart at %3: make their ends meet, or leave out what the strip is not to follow, in a sketch as construction geometry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two edges end %1 mm apart at %2: make their ends meet there, in a sketch by a coincident constraint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three edges or more meet at %1: a strip goes on in one way, so give only the edges that it is to follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the curve lies up to %1 mm off the plane that is given for it: give the one in which it is drawn, or none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edges meet at a corner of %1 degrees at (%2, %3, %4) mm: make them tangent or round the corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the margin is %1: it must be a number of mm, 0 or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sheet size is %1: give its width and height, two numbers of mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edges are a polyline of %1 straight pieces, with corners between them: draw a spline through its points for the strip to follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a spline of degree %1 has %2 control points; it needs %3: draw it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a spline of degree %1 with %2 control points has %3 knots; it needs %4, never decreasing: export it anew, or draw it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all knots of a spline are %1; its parameter must run over an interval: draw it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a folder: give the name of a file in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can't be written: there is no folder %2; create it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 exists already: choose another name, or allow it to be overwritten (--force, or force=True)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can't be written: no permission to change that file; choose another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can't be written: %2; choose another place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can't be changed: %2; allow it to be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All limits are met, and no nearer rod was found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All limits are met, but the search was stopped before it settled: a nearer rod may exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All limits are met, but only by a rod that no longer looks like the drawn curve: relax what binds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The limits cannot be met together near this curve: this is the best rod found, relax what binds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No rod was computed for this curve: see the message.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rod leaves the drawn curve by %1 mm at most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no rod for this curve: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 costs %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all limits are met, %1 mm from the drawn curve at most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the ratio of the widths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sheet's strain limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stability margin of %1 is missed: this rod has %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No single one of the limits that bind is to blame: relax several.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 instead of %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the range of lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 end's angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free %1: that saves %2 %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 would cost %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 costs %3 %4 per unit (its multiplier: true of small changes).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>split it at its corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(%1, %2, %3) mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no smooth curve stays within the tolerance of %1 mm: the section turns by %2 degrees at %3; %4, or smooth it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the curve lies %2 mm off the section at %3, more than the tolerance of %4 mm: %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, from (%2, %3, %4) mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and at %1 more places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm along the curve%2 it turns by less than %3 degrees between inflections; no smoothing that moves it by less than %4 mm takes that away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every section is a closed line, and a strip has two ends: choose under Closed lines how they are divided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elasto-gravity length %1 +- %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the section is closed (it passes (%1, %2, %3) mm): a strip has two ends, so %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>split it at a spine or at two points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points to smooth are all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2: it is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2: the plane %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is split twice at one place, or at its very end: move the points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: choose from its lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 falls into %2 lines, starting at %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smooth is %1: a curve is made fair within 0 (not at all) to %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The digits of the file turn its tangents where pieces meet: put right, %1 mm at most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as drawn no strip takes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stiffness ratio as drawn was %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curvature jumped where pieces meet: made fair, %1 mm from the drawn curve at most; %2 (smooth = 0, or --smooth 0, takes it as drawn, a larger number makes it fairer).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was changed; take fewer planes, or try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select a body, a surface or a mesh to cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a family, an axis (X, Y or Z) and one plane or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has construction geometry and points only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has external geometry only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the curve is missing: choose a sketch or an edge in the property Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2: draw a spline in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no shape: choose a sketch, an edge or a wire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has many edges: choose the ones that the strip is to follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no %2 any more: choose the curve anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is nothing to write: choose kinds of files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no sketch: nothing can be drawn into it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is nothing to cut: choose a body, a surface or a mesh in the property Sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the strip is missing: choose one in the property Strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the planes miss the object: move them, or take more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no strip here has a tab to be held: give the strips tabs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not belong to %2: choose its model, or none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not laminated: it has no backing; choose the layer Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the model has no strips: choose some in the property Strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 makes its copies of %2 part of one body, and leaves out those that do not touch it: delete it, and repeat the strip by an array of the workbench Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is scaled, and a strip of another size bends otherwise: set its Scale to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a curve is %1 mm large; %2 to %3 mm are read: check the unit (--unit), or leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a coordinate is %1 mm; they must be finite and at most %2 mm: check the unit, or export it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no strip: a model is made of strips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is nothing to cut: select strips, models or base plates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 links to %2 in %3, which is missing: put that file back or open it, and recompute the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 links to what was deleted: choose another object in its property LinkedObject, or delete the link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 reads %2, which is missing: put that file back, or name another in its property FileName, and recompute the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the formula of %1 cannot be computed (%2): mend it, or take it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has the formula %2, which gives %3: it takes 0 to %4, or a name such as %5; mend the formula, or take it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be made (%2): mend it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a curve %1 mm from this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip cannot take this curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no strip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(conjugate point at %1 mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it does not stay in this shape: the stability margin is %1%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip takes %1%2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the thickness of the sheet is %1 mm, less than any foil's: is its unit right?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples are asked for: %2 are the most, 0 chooses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the direction of gravity is zero: give a vector such as (0, 0, -1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2 mm, more than a kilometre: is its unit right?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the length of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recompute to try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: stopped; change the curve or the limits to try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD's kernel cannot make this shape (%1): change the curve, the widths or the holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not installed in this FreeCAD: strips need numpy and scipy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no sheet called %1 here: choose another one, or add it to the sheet library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sheet %1 kept in this document cannot be read: choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds no sketch for a strip: draw a spline in a sketch of its own, or select the edge that the strip is to follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds several sketches (%2): select the one that the strip is to follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip takes this curve: %1 wide, stiffness ratio %2, strain %3 % of what the sheet bears.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip bent beforehand takes this curve: %1 wide, stiffness ratio %2, strain %3 % of what the sheet bears.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no reading: write overhang = droop in mm, such as 120 = 14.5; 150 = 31</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest curve to sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no curve: draw a spline for the strip to follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an edge runs on to infinity: trim it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the shape cannot pass through a temporary file (%1): make that folder writable, with room in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an edge is degenerate: it has no curve in space; choose another edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 inflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 inflections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 and %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line through its inflections crosses the curve %1, where the moment would vanish or change sign and the curvature does not: move the curve off the line there, or support the strip between there and the inflections beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line through its inflections touches the curve %1, where the moment would vanish or change sign and the curvature does not: move the curve off the line there, or support the strip between there and the inflections beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between %1 and %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 edges in all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has %2 chains of edges: choose the edges of one as the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a path: a sketch or a wire that the planes stand across</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm along the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smoothing took waves shorter than %1 mm away; a shorter wavelength stays nearer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no smooth curve came nearer; smooth the section first, with a wavelength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the nearest curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the curve has a corner %1%2, of %3 degrees: a strip bends without kinks; round it, or draw two curves%4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, or take it out within %1 mm (smooth = %2, --smooth %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its corners, of %1 degrees at most, were rounded within that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is %1 mm wide and %2 mm long: what is wider than long bends as a plate, not as a strip; give a smaller max_width, and look at its unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No force can act between its ends, so the moment is constant and the curve must bend one way only; it has %1, %2: hold both ends in x or in y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bending is reversed by a jump of the curvature %1, where the stiffness would have to go to 0: support the strip there, or let the curvature pass through zero smoothly (smooth = 0.1, or --smooth 0.1, does that within 0.1 mm).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, whatever supports the strip there: bend the piece a little.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: support the strip %2, or bend the piece a little.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rows are %2 mm long each: diamonds with bridges of %3 mm between their tips need more than %4 mm; use fewer rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rod's bending stiffness of %1 N mm2 asks for a backing wider than fits at %2 mm, where %3 N mm2 is the most: use thicker or stiffer sheets, or widen the base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rod's bending stiffness of %1 N mm2 leaves a backing narrower than %2 mm at %3 mm, where %4 N mm2 is the least: use thinner sheets, or narrow the base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ligaments lean %1 degrees off the strip at %2 mm: use fewer rows, %3 mm long or longer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rod's bending stiffness asks for %1 mm of material at %2 mm, %3 mm fit: widen the outline or raise max_width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rod's bending stiffness asks for a width of %1 mm, above max_width %2 mm: choose a thicker or stiffer sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a curve leaves its plane by %1 mm (its z runs over %2 mm): a strip bends in one plane only; project the curve onto a plane first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bends between false inflections were smoothed away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The strip would be %1 mm wide and %2 mm long: a strip bends as computed where it is %3 times as long as wide; draw a longer curve, or make the strip narrower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a corner radius of %1 mm does not fit the hole at %2: make it smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a corner radius of %1 mm leaves %2 % too much material at the tips at %3 mm: %4 mm or less keeps it within %5 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strain %1 % at %2 mm is beyond the %3 % that %4 bears: its radius there is %5 mm, the least advisable %6 mm; %7; use a thinner sheet or a gentler curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strain %1 % at %2 mm is beyond the %3 % that %4 bears: its radius there is %5 mm, the least advisable %6 mm; %7; use a thinner sheet or a gentler curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it may crack there, or keep a bend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it creeps there and keeps a part of its bend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it keeps a bend from there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it may crack there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a tab has either a corner radius or a chamfer, not both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a tab that tapers has neither corner radius nor chamfer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missed: the %1, by %2 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missed: the %1, by %2 degrees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missed: the %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The least radius of %1 mm is missed: this rod has %2 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a least radius of %1 instead of %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bends with a radius of %2 mm at %3, a corner to any strip: %4, or smooth it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It would break at %1 mm: its radius there is %2 mm, the sheet bears %3 mm; use a thinner sheet or a gentler curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is strained beyond its limit at %1 mm: its radius there is %2 mm, the sheet bears %3 mm; %4; use a thinner sheet or a gentler curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The curvature runs out to zero %1 without a clear change of sign, where the stiffness would have to be infinite or zero, whatever supports the strip: bend the curve a little more there, or reverse its bending at a clear rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line through its inflections %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip would break on this curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip takes this curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip takes a curve %1 mm from this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip bent beforehand takes this curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip bent beforehand cannot take this curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip bent beforehand would break on this curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip bent beforehand takes a curve %1 mm from this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm all along, the way it stands bent at %2 mm: its widths count on that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm all along, the other way than it stands bent at %2 mm: its widths count on that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm at %2 mm, its sharpest, the way it stands bent there: its widths count on that; `blank` in the report has its curvature along the strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm at %2 mm, its sharpest, the other way than it stands bent there: its widths count on that; `blank` in the report has its curvature along the strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bend it beforehand to %1, %2 it stands bent %3: its widths count on that%4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a radius of %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2, its sharpest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other way than</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; `blank` in the report has its curvature along the strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are remarks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flat strip cannot take this curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nearest curve is %1 mm away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It moves by %1 mm at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2; its stability margin is %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the slot of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only %1 mm %2%3%4, %5 mm are needed in %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a wall of %2 mm is too thin to print: make it %3 mm or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the slots of %2 and %3 run into each other near (%4, %5): give the strips narrower tabs or move them apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fit of the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 pieces at %3 mm, joined by plates of %4 mm, which are stiffer and move the shape by %5 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a lap of %2 mm: give a length above 0 and below a third of %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: strips of a law are not cut in pieces, for their plates would have to taper too: take a larger stock, or a strip of one sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 pieces: %2, joined by plates of %3 mm on the free face of each layer, which are stiffer and move the shape by %4 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 pieces at %3 mm, joined by plates of %4 mm, without the %5 holes that lie under them; they are stiffer and move the shape by %6 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: there is no room for %2 joints of %3 mm between its slots: take a shorter lap or a larger stock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it bends to a radius of %1 mm at %2 mm, but plywood of %3 mm bends to %4 mm at least %5 the face grain (%6); use a thinner sheet or a gentler curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm long, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a smaller max_width, or name a larger stock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name a larger stock, join a strip of pieces by plates (lap), or scale the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the grain runs along x, the side of %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sideways margin %1 (%2): %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sideways %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unstable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undecided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it tips over sideways or twists out of its plane: guide it at the sides, or make it wider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it stays in its plane, but a push from the side may tip it: guide it at the sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it stays in its plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too wide for its length and bend to be judged as a rod: try it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its holes leave open whether it tips over sideways: guide it at the sides, or try it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 leaves its tabs no play: they bend a little between its edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 leaves its tabs %2 mm across and %3 to %4 degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slot of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pocket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2 mm also runs %3 mm deep into %4 at %5 mm, beside the slots that join them, near (%6, %7, %8) mm%9: turn or shift one of them, or make them narrower there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2 mm lies in the thickness of %3 at %4 mm%5: place them apart, or make them narrower there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2 mm runs through %3 at %4 mm%5: slot them (interlock), place them apart, or make them narrower there</source>
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
        <source>Keep as my sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove my sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All sheets that are known, yours first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name under which your sheet is kept</source>
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
        <source>Width that your machine cuts away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much it narrows while it is stretched, a share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the numbers come from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds these numbers to your library under the name above</source>
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
        <source>Bends for each cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many varied strips are bent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bends them all; Escape stops it</source>
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
        <source>Draw the curve that a strip of given length takes between two clamps into the open sketch; pull its ends</source>
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
        <source>Say whether a flat strip can take the selected curve, and if not why and where</source>
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
        <source>Make printed blocks that hold the ends of the selected strips or model, or one slotted base plate</source>
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
        <source>Put the selected strips together to a model and cut slots where they cross</source>
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
        <source>Give the selected strips an even width and glue narrower strips on that make them stiff enough</source>
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
        <source>Lay everything that must be cut for the selected strips, models and base plates on sheets</source>
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
        <source>Give the selected strips an even width and let holes make them as soft as they must be</source>
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
        <source>Pull the selected sketch's curve by four handles: lines stay lines, a curve that can be bent stays one</source>
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
        <source>Look at the sheets that are known, with their sources, and keep your own</source>
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
        <source>Make the flat strip that bends into the selected spline: the bent part and, linked to it, the flat one</source>
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
        <source>Find how far the bent strip strays when sheet, cut and clamps vary within their ranges</source>
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
</TS>
