/* The folders of the house, from the lowest up: a file imports only from its
   own folder, from folders before it, and from what stands beside them.
*/
:- module(sg_folders, [folder/3, folders/2]).

%!  folder(?Top, ?Name, ?What) is nondet.
%
%   Top/Name holds What. Top is rules or c_kernels; the order is the way of the
%   data.

folder(rules, polygon, 'polygons in the plane').
folder(rules, primitive, 'primitives, where they stand').
folder(rules, csg, 'the CSG tree, its leaves').
folder(rules, penetration, 'where segments meet').
folder(rules, gluing, 'regions of space, cycles').
folder(rules, solid, 'Boolean operations, glue').
folder(rules, model, 'models and meshes in files').
folder(rules, picture, 'views, outlines, hidden lines').
folder(rules, shading, 'what is seen, line by line').
folder(rules, sheet, 'the picture on paper').
folder(rules, drawing, 'how lines look, files of drawings').
folder(rules, development, 'laid flat, face by face').
folder(rules, unrolling, 'round parts, unrolled').
folder(rules, unfolding, 'from a model to its patterns').
folder(rules, pattern, 'patterns on paper').
folder(rules, problem, 'problem sheets for a class').
folder(rules, message, 'what people read').
folder(rules, explanation, 'why something is there').
folder(rules, studio, 'sessions, the studio').
folder(rules, batch, 'many jobs, in processes').
folder(rules, command, 'the command line').
folder(c_kernels, number, 'exact signs and points').
folder(c_kernels, rows, 'rows as arrays: sort, hash, join').
folder(c_kernels, polygon, 'planes, triangles, one polygon').
folder(c_kernels, join, 'trees of boxes, what overlaps').
folder(c_kernels, penetration, 'cut sets, chains, contacts').
folder(c_kernels, solid, 'arrangements, merged faces').
folder(c_kernels, gluing, 'regions of space, sphere maps').
folder(c_kernels, model, 'meshes in files, the census').
folder(c_kernels, picture, 'scenes, outlines, hidden lines').
folder(c_kernels, shading, 'scan lines from CSG trees').
folder(c_kernels, drawing, 'strokes, travel, dots').
folder(c_kernels, development, 'faces, joints, islands, seams').
folder(c_kernels, unrolling, 'cylinders and cones unrolled').
folder(c_kernels, pattern, 'nesting').

%!  folders(+Top, -Names) is det.
%
%   Names of the folders of Top, the lowest first.

folders(Top, Names) :-
    findall(Name, folder(Top, Name, _), Names).
