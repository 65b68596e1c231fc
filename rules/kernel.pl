:- module(sg_kernel, []).

:- if(\+ predicate_property(sg_kernel_drawing:raster_dots(_,_,_,_), foreign)).
:- use_foreign_library(foreign(sanggwan)).
:- endif.

:- reexport([ kernel/world,        % its rules, triangles, tolerances, trees
              kernel/file,         % meshes and solids in files
              kernel/work,         % a polygon that lines enter
              kernel/penetration,  % cut sets
              kernel/boolean,      % operands, arrangements, solids under way
              kernel/drawing,      % views, outlines, scenes, strokes, dots
              kernel/pattern       % laying flat, unrolling, nesting
            ]).

/** <module> The kernels: every foreign predicate that is not of the store.

The door to c_kernels/. What a predicate does is documented in the module of its
topic in kernel/, which is also the module that its glue file registers it in;
rules import all of them from here. Those modules are declarations: they import
no rule.
*/
