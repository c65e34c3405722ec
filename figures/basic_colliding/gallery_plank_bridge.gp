# A bridge of planks: the boxes were projected and put in order by the library.
tall = 400
@PAGE
load stem.'_boxes.gp'
