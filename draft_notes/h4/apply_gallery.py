# Adds the new scenes to the gallery: python3 apply_gallery.py ROOT  (ROOT = the project, or a copy of it)
import sys, os
root = sys.argv[1]
shots = [
 # scene, title, view, movable, lowest, tolerance, reason, fixed
 ("slide", "A box slides on the ground", "{0.6, 0.5, 1.0}", 1, "0", "0", "the scene", 0),
 ("slope", "A box on a slope", "{0.3, 0.4, 1.0}", 1, "-0.25", "1e-15", "half its width down a slope of 30 degrees", 1),
 ("sled", "A stack on a sled", "{0.5, 0.5, 1.0}", 3, "0", "0", "the scene", 0),
 ("rocking_block", "A block rocks from edge to edge", "{0.4, 0.3, 1.0}", 1, "0", "1e-15", "it stands on an edge", 0),
 ("seesaw", "A loaded see-saw", "{0.4, 0.4, 1.0}", 3, "0.5", "1e-15", "the height of the pivot", 1),
 ("leaning", "Planks lean on blocks", "{0.8, 0.5, 1.0}", 6, "0", "1e-15", "blocks and planks stand on the ground", 0),
 ("table", "A table on free legs", "{0.5, 0.4, 1.0}", 6, "0", "1e-15", "the legs stand on the ground", 0),
 ("toss", "A cube is tossed like measured ones", "{0.5, 0.5, 1.0}", 1, None, "1e-6", "the scene, drawn from its seed", 0),
]
LOWEST_TOSS = os.environ.get("LOWEST_TOSS", "0.060152")
p = root + "/chapters/basic_colliding/picture_figures.cpp"
s = open(p).read()
s = s.replace("std::array<Shot, 14> kShots", "std::array<Shot, 22> kShots")
lines = "".join('    {"%s", "%s", "", 0.0, %s},\n' % (n, t, v) for n, t, v, *_ in shots)
anchor = '    {"cage", "Cubes in a cage'
assert anchor in s and '"rocking_block"' not in s
s = s.replace(anchor, lines + anchor)
open(p, "w").write(s)
for n, t, v, m, low, tol, why, fixed in shots:
    g = root + "/figures/basic_colliding/gallery_%s.gp" % n
    word = n.replace("_", " ").capitalize()
    open(g, "w").write("# %s: the boxes were projected and put in order by the library.\ntall = 400\n@PAGE\nload stem.'_boxes.gp'\n" % word)
p = root + "/chapters/basic_colliding/expected.csv"
s = open(p).read()
add = ""
for n, t, v, m, low, tol, why, fixed in shots:
    low = LOWEST_TOSS if low is None else low
    add += 'gallery_%s,"movable boxes",-,%d,0,"the scene"\n' % (n, m)
    add += 'gallery_%s,"lowest point of these",m,%s,%s,"%s"\n' % (n, low, tol, why)
    add += 'gallery_%s,"rings of boxes drawn wrongly",-,0,0,"every ring is mended"\n' % n
i = s.index('gallery_cage,"movable boxes"')
open(p, "w").write(s[:i] + add + s[i:])
p = root + "/verification/basic_colliding/picture_experiments_test.cpp"
s = open(p).read()
old = '''                         : figure.name == "gallery_crate_off_table" ? 1.0
                                                                    : 0.0;'''
assert old in s
s = s.replace(old, '''                         : figure.name == "gallery_crate_off_table" ? 1.0
                         : figure.name == "gallery_seesaw"          ? 1.0
                         : figure.name == "gallery_slope"           ? 1.0
                                                                    : 0.0;''')
s = s.replace("// another name of one of the others", "// a figure of the thesis, or another name of one of the others")
open(p, "w").write(s)
