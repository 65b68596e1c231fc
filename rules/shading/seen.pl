:- module(sg_seen,
          [ slice/3,                    % +Scene, +Y, -Slice
            slice_candidate/4,          % +Scene, +Y, -Slice, -Candidate
            depth_at/3,                 % +Depth, +X, -Z
            met/4,                      % +Scene, +X, +Y, -Groups
            root_faces/6,               % +Scene, +Root, +Mets, +In0, +In,
                                        % -Faces
            seen_at/4,                  % +Scene, +X, +Y, -Seen
            seen_layers/4,              % +Scene, +X, +Y, -Layers
            met_layers/4,               % +Scene, +X, +Y, -Layers
            line_spans/3,               % +Scene, +Y, -Spans
            seen_side/5                 % +Scene, +X, +Y, -Depth, -Normal
          ]).
:- use_module('../kernel',
              [shading_point/6, shading_slices/3, shading_spans/3]).
:- use_module(group_owner, [group_owner/5, owners_asked/2]).
:- use_module(shading_scene,
              [ scene_handle/2, scene_place/2, scene_root/2, scene_tolerance/2,
                seen_through/2
              ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists),
              [append/2, append/3, member/2, nth1/3, reverse/2]).
:- use_module(library(ordsets), [ord_symdiff/3]).
/** <module> What is seen at a point of a shaded picture: the definition.

The plane of a scan line cuts *slices* out of the faces of the leaves. A line of
sight meets slices one behind the other; those nearer to one another than the
tolerance of the scene are one *group*, for there the faces are flush. Before
the first group it is in no leaf; at each slice it enters or leaves one. A root
is seen at the first group after which its tree is true, whatever it was in
between: so no face that lies in another one needs an answer of its own.

The kernel (c_kernels/shading) says it of spans, where the same is seen. Groups
are its only difference to classifying the middle of a slice as in, on or out,
as the paper does: on and on would need to know on which side.

@see row CB-7
*/

%!  slice(+Scene, +Y, -Slice) is nondet.
%
%   Slice is slice(R, S, F, Sense, X1, X2, Depth): on the line Y, in dots,
%   face F of leaf S of root R is between X1 and X2, in dots. Sense is 1 where
%   the line of sight enters the leaf, -1 where it leaves. Depth is
%   line(X0, A, B), arc(Sign, X0, A, B, E, F, G) or, of a torus, ring(Root,
%   Roots, X0, Z0, Size, Low, High, Forms), as of shading_slices/3.
%
%   @error domain_error(scan_line, Y)

slice(Scene, Y, Slice) :-
    placed_slice(Scene, Y, _, Slice).

%!  slice_candidate(+Scene, +Y, -Slice, -Candidate) is nondet.
%
%   As slice/3; Candidate is `true` if Slice may be seen: where the line of
%   sight enters a leaf that adds, or leaves one that takes away; else `false`.
%
%   @error domain_error(scan_line, Y)

slice_candidate(Scene, Y, Slice, Candidate) :-
    placed_slice(Scene, Y, Place, Slice),
    arg(4, Slice, Sense),
    sign_of(Scene, Place, Sign),
    (   Sense*Sign > 0
    ->  Candidate = true
    ;   Candidate = false
    ).

placed_slice(Scene, Y, Place, slice(R,S,F,Sense,X1,X2,Depth)) :-
    placed_slices(Scene, Y, Slices),
    member(slice(Place,F,Sense,N1,N2,Depth), Slices),
    scene_place(Scene, place(Place,R,S)),
    X1 is N1/256.0,
    X2 is N2/256.0.

placed_slices(Scene, Y, Slices) :-
    scene_handle(Scene, Handle),
    shading_slices(Handle, Y, Slices).

%!  met(+Scene, +X, +Y, -Groups) is det.
%
%   Groups are what the line of sight through (X, Y), in dots, meets: each
%   group(Z, Slices), by the depth Z of the first of its Slices,
%   met(Place, F, Sense), Place being that of a leaf in the scene. X is any
%   number.
%
%   @error domain_error(scan_line, Y)

met(Scene, X, Y, Groups) :-
    placed_slices(Scene, Y, Slices),
    findall(Z-met(Place,F,Sense),
            ( member(slice(Place,F,Sense,X1,X2,Depth), Slices),
              X1 =< 256*X, 256*X < X2,
              depth_at(Depth, X, Z) ),
            All0),
    msort(All0, All),
    scene_tolerance(Scene, Tolerance),
    grouped(All, Tolerance, Groups).

%!  depth_at(+Depth, +X, -Z) is det.
%
%   Z is how deep a slice of this Depth is at X, both in dots.

depth_at(line(X0,A,B), X, Z) :-
    Z is A + B*(X-X0).
depth_at(arc(Sign,X0,A,B,E,F,G), X, Z) :-
    T is X-X0,
    Z is A + B*T + Sign*sqrt(max(0.0, (E*T+F)*T+G)).
depth_at(ring(Root,Count,X0,Z0,Size,Low,High,Forms), X, Z) :-
    T is min(High, max(Low, float(X-X0)/Size)),
    ring_quartic(Forms, T, Quartic),
    real_roots(Quartic, Roots0),
    all_roots(Roots0, Count, Quartic, Roots),
    nth1(Root, Roots, Z1),
    Z is Z0 + Size*Z1.

%   ring_quartic(Forms, T, Quartic): A*A - 4*B*W by powers of Z, from 0 on.

ring_quartic(Forms, T, [C0,C1,C2,C3,C4]) :-
    Forms = [A1,A2,A3,A4,A5,A6,B1,B2,B3,B4,B5,B6,W1,W2,W3,W4,W5,W6],
    along([A1,A2,A3,A4,A5,A6], T, A0-A-AA),
    along([B1,B2,B3,B4,B5,B6], T, B0-B-BB),
    along([W1,W2,W3,W4,W5,W6], T, W0-W-WW),
    C0 is A0*A0 - 4*B0*W0,
    C1 is 2*A0*A - 4*(B0*W+B*W0),
    C2 is 2*A0*AA + A*A - 4*(B0*WW+B*W+BB*W0),
    C3 is 2*A*AA - 4*(B*WW+BB*W),
    C4 is AA*AA - 4*BB*WW.

along([TT,TZ,ZZ,T1,Z1,One], T, F0-F1-ZZ) :-
    F0 is (TT*T+T1)*T+One,
    F1 is TZ*T+Z1.

%   real_roots(Polynomial, Roots): where it changes its sign, ascending: between
%   the roots of its derivative, and ends beyond which there are none.

real_roots([C0,C1], [Root]) :-
    !,
    Root is -C0/C1.
real_roots(Polynomial, Roots) :-
    derivative(Polynomial, Slope),
    real_roots(Slope, Turns),
    append([[-8.0],Turns,[8.0]], Stops),
    findall(Root,
            ( append(_, [Low,High|_], Stops),
              value_at(Polynomial, Low, F), value_at(Polynomial, High, G),
              F*G < 0,
              halved(Polynomial, Low, High, F, Root) ),
            Roots).

derivative([_|Cs], Slope) :-
    findall(D, ( nth1(K, Cs, C), D is K*C ), Slope).

value_at([], _, 0.0).
value_at([C|Cs], Z, F) :-
    value_at(Cs, Z, F0),
    F is F0*Z + C.

halved(Polynomial, Low, High, F, Root) :-
    Middle is (Low+High)/2,
    (   ( Middle =< Low ; Middle >= High )
    ->  Root = Middle
    ;   value_at(Polynomial, Middle, G),
        (   F*G > 0
        ->  halved(Polynomial, Middle, High, G, Root)
        ;   halved(Polynomial, Low, Middle, F, Root)
        )
    ).

%   all_roots(Roots0, Count, Quartic, Roots): Roots are Count. Where two are one
%   and rounding left none, that is where the quartic turns, nearest to 0.

all_roots(Roots0, Count, Quartic, Roots) :-
    length(Roots0, Found),
    (   Found >= Count
    ->  Roots = Roots0
    ;   derivative(Quartic, Slope),
        real_roots(Slope, Turns),
        aggregate_all(min(Off,Z),
                      ( member(Z, Turns), value_at(Quartic, Z, F),
                        Off is abs(F) ),
                      min(_,Turn)),
        msort([Turn,Turn|Roots0], Roots1),
        all_roots(Roots1, Count, Quartic, Roots)
    ).

grouped([], _, []).
grouped([Z-Met|All], Tolerance, [group(Z,[Met|Mets])|Groups]) :-
    with_first(All, Z, Tolerance, Mets, Rest),
    grouped(Rest, Tolerance, Groups).

with_first([Z1-Met|All], Z, Tolerance, [Met|Mets], Rest) :-
    Z1-Z =< Tolerance,
    !,
    with_first(All, Z, Tolerance, Mets, Rest).
with_first(Rest, _, _, [], Rest).

%!  seen_at(+Scene, +X, +Y, -Seen) is semidet.
%
%   Seen is seen(R, S, F): face F of leaf S of root R is seen at (X, Y), in
%   dots. Fails where nothing is. X is any number.
%
%   @error domain_error(scan_line, Y)

seen_at(Scene, X, Y, Seen) :-
    roots_through(Scene, Pairs),
    (   Pairs == []
    ->  met(Scene, X, Y, Groups),
        first_seen(Groups, Scene, [], Seen)
    ;   seen_layers(Scene, X, Y, [layer(_,R,S,F)|_]),
        Seen = seen(R,S,F)
    ).

%   roots_through(Scene, Pairs): Front-Behind, roots that hide others not.

roots_through(Scene, Pairs) :-
    findall(R, scene_root(Scene, root(R,_)), Roots),
    seen_through(Roots, Pairs).

%   first_seen(Groups, Scene, In, Seen): In are the places of the leaves that
%   the line of sight is in, ascending.

first_seen([group(_,Mets)|Groups], Scene, In0, Seen) :-
    foldl(toggled, Mets, In0, In),
    (   scene_root(Scene, root(R,Nodes)),
        holds(Nodes, [], In)
    ->  group_face(Scene, root(R,Nodes), Mets, In0, In, S-F),
        Seen = seen(R,S,F)
    ;   first_seen(Groups, Scene, In, Seen)
    ).

toggled(met(Place,_,_), In0, In) :-
    ord_symdiff(In0, [Place], In).

%   holds(Nodes0, Nodes, In): the expression between Nodes0 and Nodes, each node
%   before its operands, is true inside the leaves In.

holds(Nodes0, Nodes, In) :-
    value(Nodes0, Nodes, In, true).

value([node(leaf,Place)|Nodes], Nodes, In, Value) :-
    !,
    (   memberchk(Place, In)
    ->  Value = true
    ;   Value = false
    ).
value([node(Operation,Count)|Nodes0], Nodes, In, Value) :-
    values(Count, Nodes0, Nodes, In, Values),
    operation_value(Operation, Values, Value).

values(0, Nodes, Nodes, _, []) :-
    !.
values(Count, Nodes0, Nodes, In, [Value|Values]) :-
    value(Nodes0, Nodes1, In, Value),
    Fewer is Count-1,
    values(Fewer, Nodes1, Nodes, In, Values).

operation_value(union, Values, Value) :-
    (   memberchk(true, Values)
    ->  Value = true
    ;   Value = false
    ).
operation_value(intersection, Values, Value) :-
    (   memberchk(false, Values)
    ->  Value = false
    ;   Value = true
    ).
operation_value(difference, [First|Others], Value) :-
    (   First == true,
        \+ memberchk(true, Others)
    ->  Value = true
    ;   Value = false
    ).

%   group_face(Scene, root(R,Nodes), Mets, In0, In, S-F): of root_faces/6 the
%   one that is seen.

group_face(Scene, Root, Mets, In0, In, S-F) :-
    root_faces(Scene, Root, Mets, In0, In, Faces),
    Root = root(R,_),
    group_owner(Scene, R, Faces, S, F).

%!  root_faces(+Scene, +Root, +Mets, +In0, +In, -Faces) is det.
%
%   Root = root(R, Nodes) begins or ends where the line of sight meets the group
%   Mets, being in the leaves at the places In0 before it and in In after it.
%   Faces, each Leaf-F, ascending, are those of R there: of leaves whose change
%   goes up to the root. Where a leaf is entered that is taken away there, its
%   face is none of R.

root_faces(Scene, root(R,Nodes), Mets, In0, In, Faces) :-
    changing(Nodes, [], In0, In, Places),
    findall(Leaf-F1,
            ( member(met(Place,F1,_), Mets),
              memberchk(Place, Places),
              scene_place(Scene, place(Place,R,Leaf)) ),
            Faces0),
    sort(Faces0, Faces).

%   changing(Nodes0, Nodes, In0, In, Places): Places are the leaves between
%   Nodes0 and Nodes that change with all nodes above them there; none if the
%   first one of these does not.

changing(Nodes0, Nodes, In0, In, Places) :-
    value(Nodes0, Nodes, In0, Before),
    value(Nodes0, Nodes, In, After),
    (   Before == After
    ->  Places = []
    ;   Nodes0 = [node(leaf,Place)|_]
    ->  Places = [Place]
    ;   Nodes0 = [node(_,Count)|Nodes1],
        operands_changing(Count, Nodes1, Nodes, In0, In, Places)
    ).

operands_changing(0, Nodes, Nodes, _, _, []) :-
    !.
operands_changing(Count, Nodes0, Nodes, In0, In, Places) :-
    changing(Nodes0, Nodes1, In0, In, Places0),
    Fewer is Count-1,
    operands_changing(Fewer, Nodes1, Nodes, In0, In, Places1),
    append(Places0, Places1, Places).

%   sign_of(Scene, Place, Sign): -1 of a leaf under an odd number of right-hand
%   sides of differences, else 1.

sign_of(Scene, Place, Sign) :-
    scene_root(Scene, root(_,Nodes)),
    signed(Nodes, _, 1, Place, Found),
    nonvar(Found),
    !,
    Sign = Found.

%   signed(Nodes0, Nodes, Sign0, Place, Sign): leaf Place is between them.

signed([node(leaf,Place0)|Nodes], Nodes, Sign0, Place, Sign) :-
    !,
    (   Place0 =:= Place
    ->  Sign = Sign0
    ;   true
    ).
signed([node(Operation,Count)|Nodes0], Nodes, Sign0, Place, Sign) :-
    operands_signed(Count, first(Operation), Nodes0, Nodes, Sign0, Place, Sign).

operands_signed(0, _, Nodes, Nodes, _, _, _) :-
    !.
operands_signed(Count, Which, Nodes0, Nodes, Sign0, Place, Sign) :-
    (   Which == other(difference)
    ->  Sign1 is -Sign0
    ;   Sign1 = Sign0
    ),
    signed(Nodes0, Nodes1, Sign1, Place, Sign),
    Fewer is Count-1,
    arg(1, Which, Operation),
    operands_signed(Fewer, other(Operation), Nodes1, Nodes, Sign0, Place, Sign).

%!  seen_layers(+Scene, +X, +Y, -Layers) is det.
%
%   Layers are what would be seen at (X, Y), in dots, if all were see-through,
%   the nearest first, as of met_layers/4; but a layer counts as nearer than
%   those directly before it whose roots do not hide its own (may_hide/2).
%
%   @error domain_error(scan_line, Y)

seen_layers(Scene, X, Y, Layers) :-
    met_layers(Scene, X, Y, Layers0),
    roots_through(Scene, Pairs),
    (   Pairs == []
    ->  Layers = Layers0
    ;   foldl(let_through(Pairs), Layers0, [], Backwards),
        reverse(Backwards, Layers)
    ).

%   let_through(Pairs, Layer, Before0, Before): the last one first.

let_through(Pairs, Layer, [Last|Before0], [Last|Before]) :-
    arg(2, Last, Front),
    arg(2, Layer, Behind),
    memberchk(Front-Behind, Pairs),
    !,
    let_through(Pairs, Layer, Before0, Before).
let_through(_, Layer, Before, [Layer|Before]).

%!  met_layers(+Scene, +X, +Y, -Layers) is det.
%
%   Layers are layer(Z, R, S, F), by depth, where the root R begins, or ends, at
%   a group of the depth Z on the line of sight through (X, Y), in dots. Of one
%   group what ends is nearer than what begins.
%
%   @error domain_error(scan_line, Y)

met_layers(Scene, X, Y, Layers) :-
    met(Scene, X, Y, Groups),
    findall(root(R,Nodes), scene_root(Scene, root(R,Nodes)), Roots),
    layers(Groups, Scene, Roots, [], Layers).

layers([], _, _, _, []).
layers([group(Z,Mets)|Groups], Scene, Roots, In0, Layers) :-
    foldl(toggled, Mets, In0, In),
    findall(Root,
            ( member(Way, [-1,1]), member(Root, Roots), Root = root(_,Nodes),
              change(Way, Nodes, In0, In) ),
            Changed),
    findall(layer(Z,R,S,F),
            ( member(Root, Changed), Root = root(R,_),
              group_face(Scene, Root, Mets, In0, In, S-F) ),
            New),
    append(New, Layers1, Layers),
    layers(Groups, Scene, Roots, In, Layers1).

change(Way, Nodes, In0, In) :-
    (   holds(Nodes, [], In0)
    ->  Way =:= -1,
        \+ holds(Nodes, [], In)
    ;   Way =:= 1,
        holds(Nodes, [], In)
    ).

%!  line_spans(+Scene, +Y, -Spans) is det.
%
%   Spans are span(X1, X2, R, S, F), from left to right: between X1 and X2, in
%   1/256 dot, face F of leaf S of root R is seen on the line Y, in dots. What
%   seen_at/4 says of points the kernel says of spans.
%
%   @error domain_error(scan_line, Y)

line_spans(Scene, Y, Spans) :-
    scene_handle(Scene, Handle),
    owners_asked(Scene, shading_spans(Handle, Y, Spans)).

%!  seen_side(+Scene, +X, +Y, -Depth, -Normal) is semidet.
%
%   What is seen at (X, Y), in dots, is Depth dots deep, counted from the origin
%   of the model, and looks along the unit vector Normal = vector(X, Y, Z).
%   Fails where nothing is.
%
%   @error domain_error(scan_line, Y)

seen_side(Scene, X, Y, Depth, Normal) :-
    scene_handle(Scene, Handle),
    owners_asked(Scene, shading_point(Handle, X, Y, _, Depth, Normal)).
