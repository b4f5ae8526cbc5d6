"""Commands as somebody types them who tries every option once, and the files that they name."""

DRAWN = {
    "arch.txt": "3 6\n0 0\n20 40\n70 70\n130 70\n180 40\n200 0\n",
    "wave.txt": "3 7\n0 0\n30 30\n70 40\n110 0\n150 -40\n190 -30\n220 0\n",
    "points.csv": "x,y\n" + "".join(f"{x},{0.004 * x * (200 - x):.3f}\n" for x in range(0, 201, 10)),
    "corners.svg": '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 200" width="300mm" height="200mm">'
    '<path id="a" d="M 10 90 C 40 30 90 30 120 90 C 150 40 190 40 230 95"/>'
    '<path id="b" d="M 20 180 C 60 110 140 110 200 180"/></svg>',
    "ring.svg": '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 200" width="300mm" height="200mm">'
    '<ellipse cx="120" cy="80" rx="100" ry="60"/></svg>',
    "shallow.svg": '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 200" width="300mm" height="200mm">'
    '<path d="M 0 50 C 100 50.2 200 50.2 300 50"/></svg>',
    "metres.svg": '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 0.2 0.1" width="200mm" height="100mm">'
    '<path d="M 0.01 0.02 C 0.03 0.06 0.06 0.06 0.09 0.03"/></svg>',
    "long.txt": "3 4\n0 0\n3000 1500\n6000 1500\n9000 0\n",
    "felt.toml": "[sheets.felt]\nthickness_mm = 1\nyoungs_modulus_MPa = 20\ndensity_kg_m3 = 200\n"
    'max_strain = 0.05\nsource = "measured"\n',
}  # fmt: skip

ARCH = "strip arch.txt --sheet birch-plywood-0.8 --max-width 30 -o out "
WAVE = "strip wave.txt --sheet pom-0.5 --max-width 24 -o out "
CARD = "strip arch.txt --sheet card-200gsm -o out "

LINES = (
    ARCH + "--kerf 0.15 --set cut.curves=arc --set cut.holding.width=0.4",
    ARCH + "--kerf sheet --set cut.curves=polyline --set cut.tolerance=0.1 --set cut.version=R12",
    ARCH + "--set files.glb=true",
    ARCH + "--gravity --set 'loads = [{ at = 60, mass = 5 }]' --set creep=0.8 --json",
    ARCH + "--gravity --set gravity.length=150 --set gravity.direction=[0.6,-0.8]",
    ARCH + "--gravity --set gravity=[0,-1,-1] --set x_axis=[1,0,0] --set y_axis=[0,1,0] --set origin=[5,6,7]",
    ARCH + "--set 'loads = { alpha = 0.0001, masses = [{at = 40, mass = 0.001}] }'",
    ARCH + "--compensate "
    "--set 'slots = [{ at = 60, width = 1, depth = 6 }, { at = 90, width = 1, side = \"lower\" }]'",
    ARCH + "--set 'slots = [{ at = 60, width = 1, depth = 6, lean = 0.3, relief = \"round\" }]' --tab 18 "
    "--set ends.corner_radius=2",
    ARCH + "--set 'slots = [{ at = 4, width = 9, depth = 40 }]'",
    ARCH + "--set 'ends = [{ length = 18, width = 12, holes = [{at = 9, diameter = 3.2}] }, { length = 0 }]'",
    ARCH + "--set 'ends = [{ length = 12, taper = 4 }, { length = 22, t_slot = {depth = 14} }]'",
    ARCH + "--start pinned --end slide-x --nearest --stable",
    ARCH + "--natural-curvature 0.002",
    ARCH + "--natural-curvature 'stations = [0, 80, 165.991], curvatures = [0, -0.004, 0]'",
    ARCH + "--min-width 8 --nearest",
    ARCH + "--ratio 1.2 --keep-tangents --keep-length",
    ARCH + "--ratio 1.3 --set keep.tangents=[true,false] --keep-ends start",
    ARCH + "--set limits.strain=0.003 --set keep.symmetry=mirror",
    ARCH + "--keep-strain --set keep.points=[80] -v",
    ARCH + "--set limits.curvature=0.01 --set limits.length=[200,320]",
    ARCH + "--set limits.width=[12,30] --set 'limits.keep_out = [{ point = [0, 60], normal = [0, -1] }]'",
    ARCH + "--nearest --set 'limits.keep_out = [{ lower = [90, 50], upper = [110, 70] }]'",
    ARCH + "--nearest --set 'limits.stiffness_bounds = { lower = 1, upper = [2, 3, 2] }'",
    ARCH + "--set shop.stock=[200,100] --set shop.lap=40",
    ARCH + "--units inch --tab 0.5in",
    ARCH + "--set shop.least_width=60",
    ARCH + "--set files.strict=true --thickness 2.5",
    WAVE + "--nearest --ratio 3 --set keep.line=true",
    WAVE + "--nearest --ratio 4 --set keep.line=[[0,0],[220,0]]",
    WAVE + "--ratio 3 --set keep.symmetry=turn --margin 2",
    WAVE + "--ratio 3 --gravity --keep-ends none",
    WAVE,
    CARD + "--style perforated --outer-width 40 --set style.columns=2 --set style.rows=12 "
    "--set style.sides=arc --set style.corner_radius=0.3",
    CARD + "--style perforated --outer-width 40 --set style.hole_ratio=0.7 --set style.least_ligament=1 "
    "--set style.least_hole=1.5",
    CARD + "--style laminated --outer-width 30 --set style.backing=card-200gsm --set style.least_backing=2 "
    "--set style.dots=2",
    CARD + "--style laminated --outer-width 30 --set style.backing=card-200gsm --ratio 4",
    "strip arch.txt --sheet pom-1 -o out --set 'section = { kind = \"thickness\", limits = [1, 4], width = 20 }'",
    "strip arch.txt --sheet pom-1 -o out --set 'section = { kind = \"rod\", limits = [2, 5] }'",
    "strip arch.txt --sheet pom-1 -o out --set 'section = { kind = \"tube\", limits = [2, 6], bore = 0.7 }'",
    "strip arch.txt --sheet pom-1 -o out --nearest --set 'section = { kind = \"leaves\", leaves = 4, width = 20 }'",
    "strip long.txt --sheet birch-plywood-4 --max-width 90 -o out --set shop.lap=80 "
    "--set shop.stock=[1525,800] --ignore-limits",
    "strip corners.svg --set curve.split_corners=true --sheet card-200gsm --max-width 15 -o out --all --force",
    "strip corners.svg --curve b --sheet card-200gsm --max-width 15 -o out --set smooth=0.5",
    "strip ring.svg --sheet card-200gsm --max-width 15 -o out --set seam_position=40",
    "strip points.csv --sheet felt.toml:felt --max-width 15 -o out --set samples=101",
    "strip points.csv --sheet felt.toml:wool --max-width 15 -o out",
    "strip nothing.txt --sheet card-200gsm --max-width 15 -o out",
    "strip arch.txt --sheet card-200 --max-width 15 -o out",
    "check wave.txt", "check arch.txt --json", "check corners.svg", "check ring.svg", "check long.txt -v",
    "bend arch.txt --to 180 0 --steps 6 --sheet birch-plywood-0.8 --max-width 30 -o out",
    "bend arch.txt --to 190 20 --end-angle -90 --gravity --sheet pom-0.5 --max-width 20 -o out",
    "bend wave.txt --nearest --to 200 10 --hold-end pinned --sheet pom-0.5 --max-width 20 -o out",
    "bend --straight 150 --to 90 0 --side right --steps 8 --sheet pom-0.5 --max-width 10 -o out",
    "bend --straight 150 --to 170 0 --sheet pom-0.5 --max-width 10 -o out",
    "reshape arch.txt --top-right 240 110 -o out", "reshape wave.txt --top-left -20 60 -o out",
    "coupon --sheet birch-plywood-0.8 -o out",
    "coupon --sheet birch-plywood-0.8 --measured 300 38 --measured 300 41 --measured 200 9 --name mine -o out",
    "sheets", "sheets felt.toml", "sheets pom-0.5",
    "batten --sheet pom-1 --length 900 --camber 10 --at 40 --stock 25 8 --least 3 -o out",
    "batten --sheet pom-1 --length 900 --camber 12 --at 45 --rod 12 --lying up -o out",
    "batten --sheet pom-1 --length 900 --camber 10 --at 40 --stock 25 8 --least 3 --weight -o out",
    "batten --sheet pom-1 --length 900 --camber 10 --at 40 --stock 25 8 --least 3 --leaves 4 -o out",
    "batten --sheet pom-1 --length 900 --camber 10 --at 40 --stock 25 8 --least 3 --full 30 -o out",
    "bow arch.txt --rod 4 -o out", "bow arch.txt --rod 2:4 --sheet pom-1 --nearest --shorter 7 -o out",
    "bow arch.txt --sheet pom-1 --max-width 20 -o out", "bow ring.svg --rod 4 -o out",
    "strip shallow.svg --sheet pom-1 --max-width 20 -o out --end pinned",
    "strip metres.svg --sheet pom-1 --max-width 20 -o out",
    "strip wave.txt --sheet birch-plywood-0.8 --max-width 60 -o out --gravity --nearest",
    CARD + "--style perforated --outer-width 40 --set style.corner_radius=0.6 --set style.rows=5 "
    "--set style.columns=1 --max-width 14",
)  # fmt: skip
