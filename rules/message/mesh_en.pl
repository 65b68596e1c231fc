:- module(sg_mesh_en,
          [ mesh_en//1,                 % +Fault
            simplify_en//1              % +What
          ]).
/** <module> What is wrong with a mesh file, in English.

mesh_ko.pl has the same heads in Korean.
*/

%!  simplify_en(+What)// is det.
%
%   The notice sanggwan(simplify(What)).

simplify_en(made(Left, Before)) -->
    [ 'simplified: of ~D triangles there are now ~D'-[Before, Left] ].
simplify_en(not_fewer(Faces, Left)) -->
    [ '--faces ~D: no fewer than ~D triangles can be had'-[Faces, Left], nl,
      '  Each closed part needs four at least, and each hole three more.' ].
simplify_en(meets_itself(S, Name)) -->
    [ 'segment ~d (~p) goes through itself since it was simplified'-[S, Name],
      nl, '  Take a larger --faces; check says where it does.' ].

%!  mesh_en(+Fault)// is semidet.
%
%   The message for model_error(mesh(Fault)).

mesh_en(empty_file) -->
    [ 'the file is empty', nl,
      '  Get the whole file; perhaps the program that wrote it failed.' ].
mesh_en(no_faces) -->
    [ 'the mesh has neither a polygon nor a curve', nl,
      '  Export the model again, with its faces.' ].
mesh_en(unknown_format) -->
    [ 'this looks like no mesh: neither STL, OFF, OBJ nor PLY', nl,
      '  Give the file the ending of its format.' ].
mesh_en(unsupported(Text)) -->
    [ '~w is a kind of this format that is not read'-[Text], nl,
      '  Save it in plain text form.' ].
mesh_en(expected(Wanted, '')) -->
    [ 'nothing stands where ~w should come'-[Wanted], nl,
      '  Complete the line; if the file ends here, get the whole file.' ].
mesh_en(expected(Wanted, Text)) -->
    { Text \== '' },
    [ 'here stands ~w, where ~w should come'-[Text, Wanted], nl,
      '  Correct the line; is the file in the format of its ending?' ].
mesh_en(bad_number(Text)) -->
    [ 'this is no number: ~w'-[Text], nl,
      '  Write coordinates such as -12.5 or 1e-3, with a point.' ].
mesh_en(not_finite(Text)) -->
    [ 'a coordinate is ~w; it must be a finite number'-[Text], nl,
      '  Repair the model in the program that made it.' ].
mesh_en(no_float32) -->
    [ 'a coordinate is too large for STL, whose numbers go up to 3.4e38', nl,
      '  Write .off, .obj or .ply, or choose other units.' ].
mesh_en(crosses_itself(S, P)) -->
    [ 'segment ~d: polygon ~d crosses itself, so it would be missing'-[S, P],
      nl, '  Correct it in the model.' ].
mesh_en(too_far(Text)) -->
    [ 'the coordinate ~w is beyond 1.0e90'-[Text], nl,
      '  Choose other units: nothing can be computed at this size.' ].
mesh_en(bad_index(Index, Lowest, Highest)) -->
    { Lowest =< Highest },
    [ 'there is no vertex ~d; there are ~d to ~d'-[Index, Lowest, Highest],
      nl,
      '  Correct the number, or add the vertex.' ].
mesh_en(bad_index(Index, Lowest, Highest)) -->
    { Lowest > Highest },
    [ 'there is no vertex ~d; there are none so far'-[Index], nl,
      '  Give the vertices first.' ].
mesh_en(bad_count(What, Text)) -->
    [ 'the number of ~w cannot be ~q'-[What, Text], nl,
      '  Write a whole number, 0 or more.' ].
mesh_en(truncated(What, Present, Needed)) -->
    [ 'too short: ~D ~w are promised, at most ~D are there'-
      [Needed, What, Present], nl,
      '  The file is cut off: get the whole file.' ].
mesh_en(short_face(Corners)) -->
    [ 'a face or line with too few corners: ~d'-[Corners], nl,
      '  A face needs three corners, a line two: correct or remove it.' ].
mesh_en(too_large) -->
    [ 'more than 2,147,483,647 vertices or edges', nl,
      '  Part the model into several files.' ].
mesh_en(no_property(Property, Element)) -->
    [ 'element ~w needs one property ~w'-[Element, Property], nl,
      '  Export the model again as plain PLY.' ].
