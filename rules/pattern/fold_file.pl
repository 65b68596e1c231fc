:- module(sg_fold_file,
          [ write_fold/3                % +File, +Ds, +Options
          ]).
:- use_module('../near', [is_rounding/2]).
:- use_module('../output', [writing/3]).
:- use_module('../store', [e/5, from_v/4, joint/6, p/3, t/6, v/5]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), 
              [append/2, member/2, nth0/3, reverse/2, select/3]).
:- use_module(library(option), [option/2, option/3]).
/** <module> FOLD: a pattern for programs that fold.

FOLD 1.2 is JSON: the crease pattern, its vertices in the plane, and, as a
second frame, the same folded up, its vertices where they are in the model.
Coordinates are in units of the model. An edge is

  - `B`: a side that is cut
  - `M`, `V`: a fold away from the reader or towards the reader
  - `F`: a fold of 0 degrees, or a penetration line inside a face: a line that
    is there, and not folded
  - `J`: no line at all; FOLD has no faces with holes, such a face is written as
    its triangles

Custom fields say what things are in the model and in its pattern:
`sanggwan:edges_edge` and `sanggwan:edges_joint` (0: none),
`sanggwan:faces_polygon`, `sanggwan:faces_segment`.

Faces are counter-clockwise as they are seen in the plane; this side is the
outside of the model, or, on request, its inside: then the pattern is a mirror
image, mountains are valleys, and the normals of the folded form look inwards.

@see https://github.com/edemaine/fold/blob/main/doc/spec.md
*/

:- set_prolog_flag(optimise, true).

%!  write_fold(+File, +Ds, +Options) is det.
%
%   Write the patterns Ds to File. Options: title(Text); unit(U) and
%   inside(Bool), as for pattern_drawing/3.

write_fold(File, Ds, Options) :-
    writing(File, text, fold_written(Ds, Options)).

fold_written(Ds, Options, Out) :-
    findall(D-W, ( member(D, Ds), v(D, W, _, _, _) ), Vertices0),
    sort(Vertices0, Vertices),
    findall(Vertex-I, nth0(I, Vertices, Vertex), Numbers0),
    list_to_assoc(Numbers0, Numbers),
    (   option(inside(true), Options)
    ->  From = inside
    ;   From = outside
    ),
    findall(Face, ( member(D, Ds), seen_face(From, D, Face) ), Faces),
    findall(Edge, ( member(D, Ds), seen_edge(From, D, Edge) ), Edges0),
    findall(Edge, inner_edge(Faces, Edge), Edges1),
    sort(1, @<, Edges1, Edges2),
    sort(1, @<, Edges0, Own),
    other_edges(Edges2, Own, Joins),
    append([Own,Joins], Edges),
    option(title(Title), Options, ''),
    option(unit(Unit), Options, mm),
    frame_attributes(Joins, Attributes),
    head(Out, Title, Unit, Attributes),
    members(Out, vertices_coords, Vertices, flat_point(From)),
    write_edges(Out, Edges, Numbers),
    write_faces(Out, Faces, Numbers),
    folded_frame(Out, Vertices, Attributes).

%   What the specification asks for where there are edges that are no lines.

frame_attributes(Joins, Attributes) :-
    (   Joins == []
    ->  Attributes = ''
    ;   Attributes = ', "joins"'
    ).

head(Out, Title, Unit, Attributes) :-
    text_to_string(Title, String),
    json_string(String, Text),
    fold_unit(Unit, FoldUnit),
    format(Out, '{~n"file_spec": 1.2,~n"file_creator": "Sanggwan",~n', []),
    (   String == ""
    ->  true
    ;   format(Out, '"file_title": ~w,~n', [Text])
    ),
    format(Out, '"file_classes": ["singleModel"],~n\c
                 "frame_classes": ["creasePattern"],~n\c
                 "frame_attributes": ["2D"~w],~n"frame_unit": "~w",~n',
           [Attributes,FoldUnit]).

fold_unit(mm, mm) :- !.
fold_unit(cm, cm) :- !.
fold_unit(m, m) :- !.
fold_unit(inch, in) :- !.
fold_unit(_, unit).

json_string(String, Text) :-
    string_codes(String, Codes),
    foldl(json_code, Codes, Parts, ['"']),
    atomic_list_concat(['"'|Parts], Text).

json_code(Code, [Part|Parts], Parts) :-
    (   memberchk(Code, [0'", 0'\\])
    ->  format(atom(Part), '\\~c', [Code])
    ;   Code < 32
    ->  format(atom(Part), '\\u~|~`0t~16r~4+', [Code])
    ;   char_code(Part, Code)
    ).

:- meta_predicate members(+, +, +, 2).

%   A field with a value for each item.

members(Out, Name, Items, Value) :-
    format(Out, '"~w": [', [Name]),
    foldl(written_member(Out, Value), Items, '\n', _),
    format(Out, '~n],~n', []).

:- meta_predicate written_member(+, 2, +, +, -).

written_member(Out, Value, Item, Before, ',\n') :-
    call(Value, Item, Text),
    format(Out, '~w~w', [Before,Text]).

flat_point(From, D-W, Text) :-
    v(D, W, X0, Y, _),
    !,
    (   From == inside
    ->  X is 0.0-X0
    ;   X = X0
    ),
    format(atom(Text), '[~w,~w]', [X,Y]).


                /*******************************
                *        FACES, EDGES          *
                *******************************/

%   face(D, P, Ws): a loop of vertices, counter-clockwise as it is seen.

seen_face(outside, D, Face) :-
    fold_face(D, Face).
seen_face(inside, D, face(D,P,Ws)) :-
    fold_face(D, face(D,P,Ws0)),
    reverse(Ws0, Ws).


fold_face(D, face(D,P,Ws)) :-
    p(D, P, Es),
    (   polygon_loop(D, Es, Loop)
    ->  Ws = Loop
    ;   t(D, P, _, W1, W2, W3),
        Ws = [W1,W2,W3]
    ).

polygon_loop(D, Es, [W|Ws]) :-
    findall(A-B, ( member(E, Es), e(D, E, A, B, _) ), Steps),
    Steps = [W-Next|Rest],
    loop_on(Rest, Next, W, Ws).

%   All edges in one loop that goes through each vertex once.

loop_on([], W, W, []) :-
    !.
loop_on(Steps, W, Start, [W|Ws]) :-
    W \== Start,
    select(W-Next, Steps, Rest),
    !,
    \+ memberchk(W-_, Rest),
    loop_on(Rest, Next, Start, Ws).

%   edge(D,Low,High)-as(Assignment, Angle, E, J): in FOLD an angle above zero is
%   a valley, and one that is not folded has the angle 0.

seen_edge(outside, D, Edge) :-
    fold_edge(D, Edge).
seen_edge(inside, D, Ends-as(Assignment,Angle,E,J)) :-
    fold_edge(D, Ends-as(Assignment0,Angle0,E,J)),
    turned_assignment(Assignment0, Assignment),
    Angle is -Angle0.

turned_assignment('M', 'V') :- !.
turned_assignment('V', 'M') :- !.
turned_assignment(Assignment, Assignment).


fold_edge(D, Edge) :-
    fold_joints(D, Joints),
    p(D, _, Es),
    member(E, Es),
    assigned_edge(D, E, Joints, Edge).

fold_joints(D, Joints) :-
    findall(E1-(J1-(Kind-Angle1)),
            ( joint(D, J1, Ea, Eb, Kind, Angle1), member(E1, [Ea,Eb]) ),
            Joints0),
    sort(1, @<, Joints0, Joints1),
    list_to_assoc(Joints1, Joints).

assigned_edge(D, E, Joints, edge(D,Low,High)-as(Assignment,Angle,E,J)) :-
    e(D, E, W1, W2, Et),
    (   get_assoc(E, Joints, J-(Kind-Bend))
    ->  assigned(Kind, Bend, Assignment, Angle)
    ;   Et =:= 1,
        J = 0,
        Assignment = 'B',
        Angle = 0
    ),
    msort([W1,W2], [Low,High]).

assigned(seam, _, 'B', 0).
assigned(line, _, 'F', 0).
assigned(fold, Bend, Assignment, Angle) :-
    (   is_rounding(Bend, 1.0)
    ->  Assignment = 'F',
        Angle = 0
    ;   Angle is -Bend,
        (   Bend > 0
        ->  Assignment = 'M'
        ;   Assignment = 'V'
        )
    ).

inner_edge(Faces, edge(D,Low,High)-as('J',0,0,0)) :-
    member(face(D,_,[W1,W2,W3]), Faces),
    member(A-B, [W1-W2,W2-W3,W3-W1]),
    msort([A,B], [Low,High]).

other_edges(Edges, Own, Others) :-
    list_to_assoc(Own, Known),
    findall(Key-As,
            ( member(Key-As, Edges), \+ get_assoc(Key, Known, _) ),
            Others).

write_edges(Out, Edges, Numbers) :-
    members(Out, edges_vertices, Edges, edge_vertices(Numbers)),
    members(Out, edges_assignment, Edges, edge_assignment),
    members(Out, edges_foldAngle, Edges, edge_angle),
    members(Out, 'sanggwan:edges_edge', Edges, edge_number),
    members(Out, 'sanggwan:edges_joint', Edges, edge_joint).

edge_vertices(Numbers, edge(D,A,B)-_, Text) :-
    get_assoc(D-A, Numbers, I),
    get_assoc(D-B, Numbers, J),
    format(atom(Text), '[~d,~d]', [I,J]).

edge_assignment(_-as(Assignment,_,_,_), Text) :-
    format(atom(Text), '"~w"', [Assignment]).

edge_angle(_-as(_,Angle,_,_), Angle).

edge_number(_-as(_,_,E,_), E).

edge_joint(_-as(_,_,_,J), J).

write_faces(Out, Faces, Numbers) :-
    members(Out, faces_vertices, Faces, face_vertices(Numbers)),
    members(Out, 'sanggwan:faces_polygon', Faces, face_polygon),
    members(Out, 'sanggwan:faces_segment', Faces, face_segment).

face_vertices(Numbers, face(D,_,Ws), Text) :-
    findall(I, ( member(W, Ws), get_assoc(D-W, Numbers, I) ), Is),
    atomic_list_concat(Is, ',', Inner),
    format(atom(Text), '[~w]', [Inner]).

face_polygon(face(_,P,_), P).

face_segment(face(D,_,_), D).


                /*******************************
                *           FOLDED             *
                *******************************/

%   The second frame, if all vertices of the pattern are vertices of the model.

folded_frame(Out, Vertices, Attributes) :-
    (   maplist(model_point, Vertices, Points)
    ->  format(Out, '"file_frames": [{~n"frame_classes": ["foldedForm"],~n\c
                     "frame_attributes": ["3D"~w],~n"frame_parent": 0,~n\c
                     "frame_inherit": true,~n"vertices_coords": [',
               [Attributes]),
        foldl(written_member(Out, =), Points, '\n', _),
        format(Out, '~n]~n}]~n}~n', [])
    ;   format(Out, '"file_frames": []~n}~n', [])
    ).

model_point(D-W, Text) :-
    from_v(D, W, S, V),
    v(S, V, X, Y, Z),
    !,
    format(atom(Text), '[~w,~w,~w]', [X,Y,Z]).
