:- module(sg_kernel, []).

:- if(\+ predicate_property(sg_kernel_drawing:raster_dots(_,_,_,_), foreign)).
:- use_foreign_library(foreign(sanggwan)).
:- endif.

/** <module> The kernels: every foreign predicate that is not of the store.

The door to c_kernels/. What a predicate does is documented in the module of
its topic in kernel/, which is also the module that C registers it in; rules
import all of them from here. Those modules are declarations: they import no
rule. Where all arguments of a mode have types, the glue is made from it
(c_kernels/doors.def).
*/

%   export_doors: the module being loaded exports what C registered in it, if
%   its name does not begin with $.

:- public export_doors/0.

export_doors :-
    prolog_load_context(module, Module),
    forall(( current_predicate(_, Module:Head),
             predicate_property(Module:Head, foreign),
             \+ predicate_property(Module:Head, imported_from(_))
           ),
           ( functor(Head, Name, Arity),
             (   sub_atom(Name, 0, _, _, $)
             ->  true
             ;   Module:export(Name/Arity)
             )
           )).

:- reexport([ kernel/world,        % its rules, triangles, tolerances, trees
              kernel/file,         % meshes and solids in files
              kernel/work,         % a polygon that lines enter
              kernel/penetration,  % cut sets
              kernel/boolean,      % operands, arrangements, solids under way
              kernel/gluing,       % regions of space
              kernel/shading,      % scan lines straight from CSG trees
              kernel/image,        % shaded pictures in dots
              kernel/drawing,      % views, outlines, scenes, strokes, dots
              kernel/pattern       % laying flat, unrolling, nesting
            ]).
