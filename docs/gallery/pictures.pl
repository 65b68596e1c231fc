% The pictures of the gallery, in order: `make demo` draws them and writes
% docs/gallery/index.html (tools/gallery.pl).
%
%   picture(Name, Title, Caption, Words)
%
% The command is `sanggwan draw` with Words and `-o Name.svg`, or `sanggwan
% unfold` if Words begin with that; of
%
%   sheets(Name, Title, Caption, Words, Numbers)
%
% it is `sanggwan problems` with Words and `-o Name`, of
%
%   scan_line(Name, Title, Caption, Words, Y)
%
% `sanggwan render` with Words and `--scan-line Y=Name.svg`.
%
% The figures are those of H.-C. Chae, Drawing of Penetrating Lines Using
% Personal Computer, KSME Journal 12(1), 1988; sizes are chosen, for the paper
% does not give them. Others follow them.

picture(fig08, 'Figure 8',
        'A cone and a straight line that goes through it.',
        ['facts/figures/fig08.pl']).
picture(fig09a, 'Figure 9 (a)',
        'Four squares that go through one another, hidden lines removed.',
        ['facts/figures/fig09.pl', '--hidden', removed]).
picture(fig09b, 'Figure 9 (b)',
        'The same, hidden lines dashed.',
        ['facts/figures/fig09.pl']).
picture(fig10, 'Figure 10',
        'Two pyramids.',
        ['facts/figures/fig10.pl']).
picture(fig11a, 'Figure 11 (a)',
        'Two cones with axes at right angles.',
        ['facts/figures/fig11.pl']).
picture(fig11b, 'Figure 11 (b)',
        'The penetration lines on one of the cones.',
        ['facts/figures/fig11.pl', '--segment', '1']).
picture(fig12a, 'Figure 12 (a)',
        'A cylinder through a cone.',
        ['facts/figures/fig12.pl']).
picture(fig12b, 'Figure 12 (b)',
        'The penetration lines on the cone.',
        ['facts/figures/fig12.pl', '--segment', '1']).
picture(fig13, 'Figure 13',
        'Two equal cylinders whose axes meet: the lines lie in two planes.',
        ['facts/figures/fig13.pl']).
picture(fig14a, 'Figure 14 (a)',
        'Two cylinders whose axes do not meet.',
        ['facts/figures/fig14.pl']).
picture(fig14b, 'Figure 14 (b)',
        'The penetration lines on one of the cylinders.',
        ['facts/figures/fig14.pl', '--segment', '1']).

% The figures of K.-H. Park and C.-M. Kyung, Design and Display of Solids Using
% CSG and Boundary Representation, 1989, each shaded straight from its trees and
% beside it in outline, in the same frame. Sizes are chosen; the solids of
% figures 6 to 8 are like theirs.

picture(csg01_shaded, '1989, figure 1',
        'How two polygons may meet: from border to border of the blue one, \c
         inside it, from its border to its inside.',
        [render, 'facts/figures/csg01.pl', '--size', '1120x440']).
picture(csg01, '1989, figure 1, in outline',
        'The segments of intersection are red.',
        ['facts/figures/csg01.pl', '--hidden', removed,
         '--size', '280x110']).
picture(csg02_shaded, '1989, figure 2',
        'How a polygon is divided: two segments that end inside it wait; a \c
         third one links them; there are two polygons.',
        [render, 'facts/figures/csg02.pl', '--size', '1120x440']).
picture(csg02, '1989, figure 2, in outline',
        'The same.',
        ['facts/figures/csg02.pl', '--hidden', removed,
         '--size', '280x110']).
picture(csg03_shaded, '1989, figure 3',
        'Two boxes, and the L that they make.',
        [render, 'facts/figures/csg03.pl', '--size', '840x592']).
picture(csg03, '1989, figure 3 (a) and (c)',
        'In outline: faces in one plane are made one.',
        ['facts/figures/csg03.pl', '--hidden', removed]).
picture(csg03_apart, '1989, figure 3 (a) and (b)',
        'By a rule that keeps faces of different boxes apart: docs/rules.md.',
        ['facts/figures/csg03.pl', '--hidden', removed,
         '--rules', 'docs/faces_rules.pl']).
picture(csg04_shaded, '1989, figure 4',
        'Two plates, their union, what they have in common, and the first \c
         without the second.',
        [render, 'facts/figures/csg04.pl', '--size', '1120x320']).
picture(csg04, '1989, figure 4, in outline',
        'The same.',
        ['facts/figures/csg04.pl', '--hidden', removed, '--size', '280x80']).
picture(csg05_shaded, '1989, figure 5',
        'A box without another one: the orange walls are what was its back.',
        [render, 'facts/figures/csg05.pl', '--size', '840x592']).
picture(csg05, '1989, figure 5, in outline',
        'The same.',
        ['facts/figures/csg05.pl']).
scan_line(csg05_line, '1989, figure 5, one scan line from above',
          'The eye is below. Of all slices the light ones are never seen; the \c
           wider ones may be, fronts of the box and backs of what is taken \c
           away; red is what is seen.',
          ['facts/figures/csg05.pl', '--size', '840x592'], 330).
picture(csg06_shaded, '1989, figure 6',
        'A free-form surface, a cylinder, a sphere and a box.',
        [render, 'facts/figures/csg06.pl', '--size', '840x592']).
picture(csg06, '1989, figure 6, in outline',
        'The same.',
        ['facts/figures/csg06.pl', '--hidden', removed]).
picture(solid_outline, '1989, figure 7',
        'A solid of boxes, cylinders, a cone and spheres, in outline.',
        ['facts/shaded_block.pl', '--hidden', removed]).
picture(solid_shaded, '1989, figure 8',
        'The same scan line by scan line, straight from its tree.',
        [render, 'facts/shaded_block.pl', '--size', '840x592']).
picture(solid_256, '1989, figure 8, as on the screen of 1989',
        'In 256 colours, one scan line to a dot.',
        [render, 'facts/shaded_block.pl', '--size', '840x592',
         '--palette', '256', '--smooth', '1']).
picture(machined, 'A tee, what tools made in orange',
        'Rules say which faces those are, how light a side is, and in how \c
         many steps: see docs/rules.md.',
        [render,'facts/pipe_tee.pl','--rules','docs/machined_rules.pl',
         '--size','630x444']).
picture(inlay, 'A board with inlays',
        'Where an inlay is flush with the board, a rule says that the inlay \c
         is seen: see docs/rules.md.',
        [render,'docs/inlay.pl','--rules','docs/inlay_rules.pl',
         '--size','630x444']).
picture(die_shaded, 'A die, shaded',
        'Each leaf in a colour of its own: a sphere cuts the box, others the \c
         pits.',
        [render, 'facts/gallery/die.pl', '--colours', leaf,
         '--size', '840x592']).
picture(bracket_shaded, 'A bracket, shaded',
        'By leaves, with cold and warm tints.',
        [render, 'facts/bracket.pl', '--colours', leaf, '--shade', gooch,
         '--size', '840x592']).

% What rules can change: docs/rules.md.

picture(pipes, 'Pipes',
        'Three pipes and the two brackets that carry them; everything is cut.',
        ['facts/pipes.pl']).
picture(pipes_rules, 'Pipes, by other rules',
        'The same by a rule file: pipes do not cut brackets.',
        ['facts/pipes.pl', '--rules', 'docs/pipes_rules.pl']).

picture(glass, 'Pipes, brackets of glass',
        'The same by one more rule file: the brackets hide nothing.',
        ['facts/pipes.pl', '--rules', 'docs/pipes_rules.pl',
         '--rules', 'docs/glass_rules.pl']).

% Parameters: docs/model_files.md.

picture(family, 'A family of tees',
        'One file for all sizes: here a branch of 88.9, leaning by 30 degrees.',
        ['facts/family.pl', '--set', 'branch=88.9', '--set', 'lean=30']).

% A CSG tree: docs/model_files.md.

picture(pipe_tee, 'Pipe tee',
        'Pipes and flanges united, bores and bolt holes taken out of them.',
        ['facts/pipe_tee.pl']).

% The primitives: docs/model_files.md.

picture(primitives, 'Primitives',
        'Every primitive, the last a net of 32 Bezier patches.',
        ['facts/primitives.pl', '--size', '280x200']).
picture(smooth, 'Smooth bodies',
        'Outlines inside the triangles: cusps, and what they hide themselves.',
        ['facts/smooth.pl', '--view', '301,62', '--size', '260x200']).

% Sheets: docs/drawings.md.

picture(sheet_bracket, 'A drawing of a bracket',
        'Third-angle projection at a true scale, with a section through the \c
         bearing; the title block is filled in from facts of the model, in \c
         Korean.',
        ['facts/bracket.pl', '--sheet', 'A3', '--section', y,
         '--language', ko]).
picture(sheet_tee, 'A drawing of the pipe tee',
        'First-angle projection, cut open by three planes, one of them askew.',
        ['facts/pipe_tee.pl', '--sheet', 'A2', '--unit', cm,
         '--angle', first, '--section', 'y=0', '--section', 'x=1.35',
         '--section', '1,1,0,0']).
picture(sheet_cylinders, 'Six sides of two cylinders',
        'The cylinders of figure 14 from all sides and in dimetric projection.',
        ['facts/figures/fig14.pl', '--sheet', 'A3', '--scale', fit,
         '--views', 'front,top,right,left,bottom,back,dimetric']).
picture(sheet_lines, 'Penetration lines alone',
        'What the pattern maker wants of figure 12, three sides of it.',
        ['facts/figures/fig12.pl', '--sheet', 'A4-landscape',
         '--views', 'front,top,right', '--lines', penetration]).
picture(sheet_cubes, 'Two parts in one place',
        'A section through two parts that have not been united: each has its \c
         own hatching, so one sees where they are in each other.',
        ['facts/two_cubes.pl', '--sheet', 'A4', '--unit', cm,
         '--views', 'front,top,isometric', '--section', 'x=0.7']).

% Styles: docs/drawings.md.

picture(blueprint, 'Blueprint',
        'The same pipe tee by another style.',
        ['facts/pipe_tee.pl', '--style', 'facts/styles/blueprint.pl']).
picture(ghost, 'Ghost',
        'One of two cylinders is only hinted at, in chain lines.',
        ['facts/figures/fig13.pl', '--style', 'facts/styles/ghost.pl']).

% For the workshop, the class room and the pen plotter.

picture(saddle, 'Saddle',
        'A branch pipe meets a header askew and off its axis.',
        ['facts/gallery/saddle.pl']).
picture(saddle_line, 'The line of the saddle',
        'Along it the branch is cut, and the hole in the header; from above.',
        ['facts/gallery/saddle.pl', '--lines', penetration,
         '--view', top]).
picture(elbow, 'Bend of gores',
        'Straight pipes cut by planes through the centre of the bend.',
        ['facts/gallery/elbow.pl']).
picture(cyclone, 'Cyclone',
        'Five sheet metal parts united; each seam is a penetration line.',
        ['facts/gallery/cyclone.pl', '--size', '148x210']).
picture(nut, 'Nut',
        'Cones round its corners: hyperbolas on the six sides.',
        ['facts/gallery/nut.pl']).
picture(conic_sections, 'Conic sections',
        'Planes that cut a cone in an ellipse, a parabola and a hyperbola.',
        ['facts/gallery/conic_sections.pl', '--size', '297x140']).
picture(three_cylinders, 'Three cylinders',
        'What three equal cylinders at right angles have in common.',
        ['facts/gallery/three_cylinders.pl']).
picture(die, 'Die',
        'A cube in a sphere, and twenty-one pips taken out of it.',
        ['facts/gallery/die.pl', '--hidden', removed]).
picture(stars, 'Star bodies',
        'Two tetrahedra; a cube and an octahedron: nothing is united.',
        ['facts/gallery/stars.pl']).
picture(roofs, 'Roofs',
        'A house, its wing, a dormer and a chimney, as one solid.',
        ['facts/gallery/roofs.pl']).
picture(stairs, 'Winding stairs',
        'In central projection, from where somebody stands.',
        ['facts/gallery/stairs.pl', '--projection', central,
         '--eye', '2,-3.2,1.7', '--target', '0,0,1.7',
         '--hidden', removed, '--size', '148x210']).
picture(rings, 'Borromean rings',
        'Smooth rings take their outlines inside the triangles.',
        ['facts/gallery/rings.pl']).
picture(vase, 'Vase',
        'All edges that are seen, none twice: for a pen plotter.',
        ['facts/gallery/vase.pl', '--lines', all, '--hidden', removed,
         '--size', '148x210']).
picture(column, 'Column',
        'A star prism that turns and grows thin.',
        ['facts/gallery/column.pl', '--hidden', removed,
         '--size', '148x210']).

% Patterns: docs/command_line.md. Cut along full lines, fold along dashed ones.

picture(pattern_saddle, 'Saddle and hole',
        'The branch pipe and the header, each trimmed by the other: what the \c
         fitter cuts.',
        [unfold,'facts/patterns/saddle.pl','--trim',outside]).
picture(pattern_transition, 'From square to round',
        'Four flat triangles and four quarters of oblique cones, unrolled as \c
         they truly are, with the table of true lengths.',
        [unfold,'facts/patterns/transition.pl','--true','--generators','16']).
picture(pattern_elbow, 'The gores of a bend',
        'Two ends and two gores; where parts meet, their faces go away.',
        [unfold,'facts/patterns/elbow.pl','--trim',outside]).
picture(pattern_house, 'A house of cardboard',
        'Laid out from the floor, with tabs to glue.',
        [unfold,'facts/patterns/house.pl','--tabs','7']).
picture(pattern_bird, 'A bird of paper',
        'Two balls and two cones, in 160 triangles instead of 4,234.',
        [unfold,'facts/patterns/bird.pl','--faces','160','--tabs','6']).
picture(pattern_lock_seam, 'Lock seams',
        'A tray and a duct of sheet metal with allowances for lock seams.',
        [unfold,'facts/patterns/sheet_metal.pl','--lock-seam','6']).
picture(pattern_kerf, 'Room for the cut',
        'A hood with its outline 2 mm outside and its hole 2 mm inside of \c
         where they are to be, for a cut 4 mm wide; folds stay.',
        [unfold,'facts/patterns/hood.pl','--kerf','4','--no-numbers']).
picture(pattern_mirror, 'Both hands',
        'The hood and its mirror image: both are folded away from the reader.',
        [unfold,'facts/patterns/hood.pl','--mirror']).

% The figures of H.-C. Chae and I.-S. Chung, Constructing the Development of
% Solids by Personal Computer, KSME Journal, 1989: docs/unfolding.md.

picture(unfolded_09, 'Development, figure 9',
        'A hexahedron; the seam is as short as can be.',
        [unfold,'facts/patterns/fig09.pl']).
picture(unfolded_10, 'Development, figure 10',
        'An oblique cone.',
        [unfold,'facts/patterns/fig10.pl','--no-numbers']).
picture(unfolded_11, 'Development, figure 11',
        'An oblique cylinder on an ellipse.',
        [unfold,'facts/patterns/fig11.pl','--no-numbers']).
picture(unfolded_12, 'Development, figure 12',
        'A hollow cylinder: in the paper its pattern lay on itself, here it \c
         is in two pieces. The inner wall is folded the other way.',
        [unfold,'facts/patterns/fig12.pl','--no-numbers']).
picture(unfolded_13, 'Development, figure 13',
        'A sphere whose edges along the meridians are the longer ones.',
        [unfold,'facts/patterns/fig13.pl','--no-numbers']).
picture(unfolded_14, 'Development, figure 14',
        'A sphere whose edges along the equator are the longer ones.',
        [unfold,'facts/patterns/fig14.pl','--no-numbers']).
picture(unfolded_15a, 'Development, figure 15, the upright cylinder',
        'Two equal cylinders of 40 facets cross at right angles; what is \c
         inside the other one is taken away.',
        [unfold,'facts/patterns/fig15.pl','--trim',outside,
         '--only',upright,'--no-numbers']).
picture(unfolded_15b, 'Development, figure 15, the lying cylinder',
        'The other one of the two.',
        [unfold,'facts/patterns/fig15.pl','--trim',outside,
         '--only',lying,'--no-numbers']).

% Figures of S.-H. Park, A Study on Geometrical Glue Operation between
% Non-manifold Models, 1996: docs/gluing.md.

picture(glue_materials, '1996, figure 1',
        'Cells of two materials, a sheet through both, and a line: one model, \c
         in which what coincides is there once.',
        ['facts/figures/glue_materials.pl']).
picture(glue_exploded, '1996, figure 1, exploded',
        'Its four cells apart: what is between two of them is one face.',
        ['facts/figures/glue_materials.pl','--explode','0.5',
         '--hidden',removed]).
picture(glue_section, '1996, figure 1, cut open',
        'Each cell is cut as a solid; neighbours are hatched differently.',
        ['facts/figures/glue_materials.pl','--sheet','A4',
         '--views',isometric,'--section','y=0.3','--section','z=1']).
picture(glue_cycles, '1996, figure 2',
        'The three cycles: three disks at a vertex, three pages round an \c
         edge, the two loops of a face with a hole.',
        ['facts/figures/glue_cycles.pl']).
picture(glue_structure, '1996, figure 3',
        'What a model is made of, by dimension, the cycles between, and where \c
         it is. The paper stores the cycles; here they are asked.',
        ['facts/figures/glue_structure.pl','--view',top]).
picture(glue_vertex, '1996, figure 4',
        'Vertex glue: three pyramids with one apex, one in another, a wire. \c
         The formulas that the paper prints here are mended in docs/rules.md.',
        ['facts/figures/glue_vertex.pl']).
picture(glue_relations, '1996, figure 5',
        'How disks at a vertex lie to each other: A apart, B together all of \c
         space, C and D one in the other, E and F crossing. What the paper \c
         prints of it is mended in docs/rules.md.',
        ['facts/figures/glue_relations.pl','--view',top]).
picture(glue_crossing, '1996, figure 5, where one plane fails',
        'Seen in the plane z = 0 one pyramid is inside the other, in the \c
         plane y = 0 the other way round: they cross, and are cut first.',
        ['facts/figures/glue_crossing.pl']).
picture(glue_edge, '1996, figure 6',
        'Edge glue: five pages have the middle of an edge in common.',
        ['facts/figures/glue_edge.pl','--hidden',removed]).
picture(glue_face, '1996, figure 7',
        'Face glue: the square between two boxes is one face, with a box on \c
         either side.',
        ['facts/figures/glue_face.pl']).
picture(glue_mixed, '1996, figure 8',
        'Mixed glue: an apex on an edge, one in the middle of a face, and an \c
         edge in the middle of it.',
        ['facts/figures/glue_mixed.pl']).

% Fittings: docs/fittings.md.
picture(fitting_elbow, 'Elbow',
        'Four pieces of plate of 4 mm that meet in mitres; sizes are those of \c
         the order, no angle is computed by hand.',
        [unfold,'facts/fittings/elbow.pl','--generators','12']).
picture(fitting_tee, 'Tee',
        'A branch set on a header, both of plate; the hole is marked outside.',
        [unfold,'facts/fittings/tee.pl','--generators','12']).
picture(fitting_wye, 'Wye',
        'A stem and two legs of one diameter.',
        [unfold,'facts/fittings/wye.pl','--generators','12']).
picture(fitting_offset, 'Offset',
        'Three pieces of pipe that go on beside where it was.',
        [unfold,'facts/fittings/offset.pl','--generators','12']).
picture(fitting_reducer, 'Reducer',
        'A part of a cone, in the layer that keeps its length.',
        [unfold,'facts/fittings/reducer.pl','--generators','12']).
picture(fitting_square_to_round, 'Square to round',
        'A duct to a pipe, in plate of 2 mm.',
        [unfold,'facts/fittings/square_to_round.pl']).
picture(fitting_hopper, 'Hopper',
        'Bent of one plate; the bends have taken off what they need.',
        [unfold,'facts/fittings/hopper.pl']).
picture(fitting_cyclone, 'Cyclone in plate',
        'Barrel, cone, dust pipe, inlet and outlet.',
        [unfold,'facts/fittings/cyclone.pl','--generators','12']).

% Problem sheets: docs/problems.md.
sheets(problems, 'Problem sheets',
       'The fourteen problems of a first collection, four variants of each: \c
        question, answer and key. The command makes their patterns, too.',
       ['facts/problems/collection.pl'],
       [fig08,fig09,fig10,fig11,fig12,fig13,fig14,
        dev09,dev10,dev11,dev12,dev13,dev14,dev15]).
