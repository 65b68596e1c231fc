:- module(sg_shading_scene,
          [ shaded_model/2,             % +Roots, -Model
            shaded_model/3,             % +Roots, +Matrix, -Model
            shaded_eye/3,               % +Model, +View, -Eye
            shaded_box/3,               % +Model, +Eye, -Box
            shaded_scene/5,             % +Model, +Eye, +Place, +Size, -Scene
            seen_through/2,             % +Roots, -Pairs
            shading_scene/2,            % +Size, -Scene
            is_shaded/1,                % +S
            as_its_term/2,              % +S, +Term
            part_facts/3,               % +Number, +Parts, -Facts
            without_picture/2,          % +Model, -Scene
            named_face/3,               % +F, +Faces, -Face
            scene_opened/4,             % +Frame, +Facts, +Roots, -Handle
            scene_handle/2,             % +Scene, -Handle
            scene_tolerance/2,          % +Scene, -Tolerance
            other_sight/4,              % +Scene0, +Handle, +Tolerance, -Scene
            scene_depth/2,              % +Scene, -Plane
            scene_model/2,              % +Scene, -Model
            scene_scale/2,              % +Scene, -Scale
            depth_tolerance/3,          % +Matrix, +Facts, -Tolerance
            facts_dots/5,               % +Eye, +Place, +Size, +Facts, -Box
            scene_size/2,               % +Scene, -Size
            scene_root/2,               % +Scene, -Root
            scene_place/2,              % +Scene, ?Place
            scene_leaf/2                % +Scene, ?Leaf
          ]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module('../csg/csg_matrix',
              [ identity_matrix/1, steps_matrix/2, matrix_plane/3,
                matrix_product/3
              ]).
:- use_module('../csg/csg_term',
              [check_node_term/1, csg_error/1, is_node_term/1, node_parts/4]).
:- use_module('../csg/operand_name', [fault_named/2]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module('../kernel',
              [ kept_leaves/2, shading_ask_owners/1, shading_box/3,
                shading_let_through/2,
                shading_open/4, shading_size/3 ]).
:- use_module('../limits', [limit_value/2]).
:- use_module('../picture/hidden_lines', [may_hide/2]).
:- use_module('../picture/view', [current_view/4]).
:- use_module('../primitive/primitive',
              [is_primitive/1, primitive_kind/2, primitive_shape/4]).
:- use_module('../solid/operand', [checked_operand/1]).
:- use_module('../store', [p/3, v/5, segment/3]).
:- use_module(shading_eye, [eye_axes/3, eye_rows/3]).
:- use_module(shading_half, [half_leaf/3]).
:- use_module(shading_leaf, [known_leaf/4]).
:- use_module(library(apply), [foldl/4, include/3, maplist/3]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists),
              [append/2, append/3, member/2, nth1/3, reverse/2, same_length/2]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> What a shaded picture is made from: roots, leaves, an eye.

A model is model(Leaves, Facts, Roots): what a kernel makes a scene from (see
kernel/shading.pl), and Leaves for people, in order of Number, each a

    leaf(Number, Root, S, Term, Faces)

S is the segment of a leaf, 0 if it is a term that no segment has; Term is the
primitive that it is, where it stands, or `rows`; Faces are F-What, what the
face F is as in face_of/3, with `curved(Part)` for all of a smooth surface; of
rows they are [], and face F is polygon F.

No boundary is evaluated, and no leaf on a known quadric gets facets. Nothing
is written into the world but triangles of polygons that lack them.

@see rows CB-7, CB-8
*/

%!  shaded_model(+Roots:list, -Model) is det.
%!  shaded_model(+Roots:list, +Matrix, -Model) is det.
%
%   Model is what the segments Roots show, from their terms; each is one root of
%   the picture, in this order. Matrix (csg_matrix.pl) places all of it.
%
%   @error error(model_error(What), nodes(Ns)) as of complete_tree/1;
%          geometry_error(operand(S, Faults)): the rows of S are not closed, and
%          it is below a difference or an intersection

shaded_model(Roots, Model) :-
    identity_matrix(Identity),
    shaded_model(Roots, Identity, Model).

shaded_model(Roots, Matrix, model(Leaves, Facts, RootFacts)) :-
    foldl(root_added(Matrix), Roots, built(1, 1, [], [], []),
          built(_, _, Leaves0, Facts0, Roots0)),
    maplist(reverse, [Leaves0,Facts0,Roots0], [Leaves,Facts,RootFacts]).

%   Built is built(Number, Place, Leaves, Facts, Roots): the next numbers of a
%   leaf and of a fact, and what is there, the last first.

root_added(Matrix, S, Built0, Built) :-
    in_tree(S, S, Matrix, [], Nodes, [], Built0,
            built(Number, Place, Leaves, Facts, Roots)),
    Built = built(Number, Place, Leaves, Facts, [root(S,Nodes)|Roots]).

in_tree(S, Root, Matrix, Above, Nodes0, Nodes, Built0, Built) :-
    in_tree(S, at(Root,Matrix,Above,any), Nodes0, Nodes, Built0, Built).

%   in_tree(What, At, Nodes0, Nodes, Built0, Built): What, a segment or a term,
%   is the nodes between Nodes0 and Nodes. At is at(Root, Matrix, Above,
%   Wanted): placed by Matrix, below the segments Above, the nearest first.
%   Wanted is `any`, or solid(Name): below an operation Name, in which an open
%   surface has no part.

in_tree(S, At, Nodes0, Nodes, Built0, Built) :-
    integer(S),
    !,
    At = at(_, _, Above, _),
    (   memberchk(S, Above),
        append(Between, [S|_], Above)
    ->  reverse([S|Between], Down),
        node_error(Above, csg(cycle([S|Down])))
    ;   segment(S, Kind, Term)
    ->  segment_in_tree(S, Kind, Term, At, Nodes0, Nodes, Built0, Built)
    ;   Above = [Parent|_],
        node_error(Above, csg(missing(Parent, S)))
    ).
in_tree(Term, At, Nodes0, Nodes, Built0, Built) :-
    (   is_node_term(Term)
    ->  node_in_tree(Term, At, Nodes0, Nodes, Built0, Built)
    ;   primitive_kind(Term, Kind),
        right_kind(Kind, Term, At),
        leaf_added(0, Term, At, Nodes0, Nodes, Built0, Built)
    ).

segment_in_tree(S, _, Term, At, Nodes0, Nodes, Built0, Built) :-
    is_node_term(Term),
    !,
    At = at(Root, Matrix, Above, Wanted),
    catch(check_node_term(Term), error(model_error(What), _),
          node_error([S|Above], What)),
    node_in_tree(Term, at(Root,Matrix,[S|Above],Wanted), Nodes0, Nodes, Built0,
                 Built).
segment_in_tree(S, Kind, Term, At, Nodes0, Nodes, Built0, Built) :-
    right_kind(Kind, S, At),
    (   as_its_term(S, Term)
    ->  leaf_added(S, Term, At, Nodes0, Nodes, Built0, Built)
    ;   (   Kind == solid,
            At = at(_, _, _, solid(_))
        ->  checked_operand(S)          % what is open has no inside
        ;   true
        ),
        leaf_added(S, rows, At, Nodes0, Nodes, Built0, Built)
    ).

%   right_kind(Kind, Leaf, At): a solid may be anywhere, a surface only where it
%   is united, a curve in no tree.

right_kind(Kind, Leaf, at(_, _, Above, Wanted)) :-
    (   Kind == solid
    ->  true
    ;   Above = [Parent|_],
        Kind == curve
    ->  node_error(Above, csg(curve(Parent, Leaf)))
    ;   Kind == surface,
        Wanted = solid(Name),
        Above = [Parent|_]
    ->  node_error(Above, csg(surface(Parent, Leaf, Name)))
    ;   true
    ).

%!  as_its_term(+S, +Term) is semidet.
%
%   True when segment S is still what the primitive Term made. Who edits rows by
%   hand wants to see them.

as_its_term(S, Term) :-
    is_primitive(Term),
    (   kept_leaves([S], [Kind]),
        Kind \== other
    ->  true
    ;   \+ v(S, _, _, _, _)
    ->  true
    ;   catch(primitive_shape(Term, _, Points, Chains),
              error(model_error(_), _), fail),
        findall(V-point(X,Y,Z), v(S, V, X, Y, Z), Vertices0),
        sort(Vertices0, Vertices),
        pairs_values(Vertices, Points),
        findall(P, p(S, P, _), Ps),
        same_length(Ps, Chains)
    ).

node_error(Nodes, What0) :-
    fault_named(What0, What),
    throw(error(model_error(What), nodes(Nodes))).


                /*******************************
                *             NODES            *
                *******************************/

node_in_tree(Term, at(Root,Matrix0,Above,Wanted), Nodes0, Nodes, Built0,
             Built) :-
    node_parts(Term, Operation, Operands, Steps),
    steps_matrix(Steps, Placement),
    matrix_product(Matrix0, Placement, Matrix),
    wanted_by(Operation, Wanted, Wanted1),
    operation_in_tree(Operation, Operands, at(Root,Matrix,Above,Wanted1),
                      Nodes0, Nodes, Built0, Built).

wanted_by(Operation, Wanted0, Wanted) :-
    (   memberchk(Operation, [same,union,join,glue])
    ->  Wanted = Wanted0
    ;   functor(Operation, Name, _),
        Wanted = solid(Name)
    ).

operation_in_tree(same, [Operand], At, Nodes0, Nodes, Built0, Built) :-
    !,
    operand_in_tree(At, Operand, Nodes0-Built0, Nodes-Built).
operation_in_tree(split(Plane0, Side), [Operand], At, Nodes0, Nodes, Built0,
                  Built) :-
    !,
    At = at(_, Matrix, _, _),
    matrix_plane(Matrix, Plane0, Plane),
    Nodes0 = [node(intersection,2)|Nodes1],
    operand_in_tree(At, Operand, Nodes1-Built0, Nodes2-Built1),
    half_added(Plane, Side, At, Nodes2, Nodes, Built0, Built1, Built).
operation_in_tree(split(Side), Operands, At, Nodes0, Nodes, Built0, Built) :-
    !,
    split_operation(Side, Operands, Operation),
    Nodes0 = [node(Operation,2)|Nodes1],
    foldl(operand_in_tree(At), Operands, Nodes1-Built0, Nodes-Built).
operation_in_tree(glue, Operands0, At, Nodes0, Nodes, Built0, Built) :-
    !,
    include(glued_solid, Operands0, Operands),
    operation_in_tree(union, Operands, At, Nodes0, Nodes, Built0, Built).
operation_in_tree(Operation0, Operands, At, Nodes0, Nodes, Built0, Built) :-
    (   Operation0 == join
    ->  Operation = union
    ;   Operation = Operation0
    ),
    length(Operands, Count),
    Nodes0 = [node(Operation,Count)|Nodes1],
    foldl(operand_in_tree(At), Operands, Nodes1-Built0, Nodes-Built).

operand_in_tree(At, Operand, Nodes0-Built0, Nodes-Built) :-
    in_tree(Operand, At, Nodes0, Nodes, Built0, Built).

%   glued_solid(Operand): of what a glue holds, solids are shaded; sheets and
%   wires are not, which is told.

glued_solid(Operand) :-
    operand_kind(Operand, S, Kind),
    (   Kind == solid
    ->  true
    ;   print_message(warning, sanggwan(not_shaded(S, glued(Kind)))),
        fail
    ).

operand_kind(S, S, Kind) :-
    integer(S),
    !,
    segment(S, Kind0, Term),
    (   is_node_term(Term)
    ->  Kind = solid
    ;   Kind = Kind0
    ).
operand_kind(Term, S, Kind) :-
    is_node_term(Term),
    !,
    node_parts(Term, Operation, Operands, _),
    (   Operation == same
    ->  Operands = [Operand],
        operand_kind(Operand, S, Kind)
    ;   Kind = solid
    ).
operand_kind(Term, Term, Kind) :-
    primitive_kind(Term, Kind).

split_operation(inside, _, intersection) :-
    !.
split_operation(outside, _, difference) :-
    !.
split_operation(Side, _, _) :-
    csg_error(side(Side, [inside,outside])).


                /*******************************
                *            LEAVES            *
                *******************************/

leaf_added(S, Term, at(Root,Matrix,Above,_), Nodes0, Nodes,
           built(Number, Place0, Leaves, Facts0, Roots),
           built(Next, Place, [leaf(Number,Root,S,Placed,Faces)|Leaves], Facts,
                 Roots)) :-
    few_leaves(Number, Root, Above),
    known_leaf(S, Term, Matrix, leaf(Placed,Parts,Shape,Faces)),
    shape_nodes(Shape, Place0, Nodes0, Nodes),
    foldl(part_added(Number), Parts, Place0-Facts0, Place-Facts),
    Next is Number+1.

few_leaves(Number, Root, Above) :-
    limit_value(nodes, Most),
    (   Number =< Most
    ->  true
    ;   Above == []                     % many roots
    ->  true
    ;   node_error([Root], csg(too_many(Root, Number)))
    ).

%   shape_nodes(Shape, Place, Nodes0, Nodes): Shape is `leaf`, the next part; or
%   `without`, it without the one behind it.

shape_nodes(leaf, Place, [node(leaf,Place)|Nodes], Nodes).
shape_nodes(without, Place,
            [node(difference,2),node(leaf,Place),node(leaf,Inner)|Nodes],
            Nodes) :-
    Inner is Place+1.

part_added(Number, Part0, Place0-Facts, Place-[Part|Facts]) :-
    part_fact(Part0, Number, Part),
    Place is Place0+1.

%!  part_facts(+Number, +Parts, -Facts) is det.
%
%   Facts, for the kernel, are the Parts (known_leaf/4) of leaf Number.

part_facts(_, [], []).
part_facts(Number, [Part|Parts], [Fact|Facts]) :-
    part_fact(Part, Number, Fact),
    part_facts(Number, Parts, Facts).

part_fact(flat(Points,Surfaces,Polygons), Number,
          flat(Number,Points,Surfaces,Polygons)).
part_fact(round(Pieces), Number, round(Number,Pieces)).
part_fact(ring(Frame,K,Face), Number, ring(Number,Frame,K,Face)).
part_fact(net(Patches), Number, net(Number,Patches)).
part_fact(rows(S,Map), Number, rows(Number,S,Map)).

%   half_added(Plane, Side, At, Nodes0, Nodes, Before, Built0, Built): the part
%   of all that lies on a Side of Plane, as far as the operand between Before
%   and Built0 reaches: a leaf with the one face 1.

half_added(plane(A,B,C,D), Side, at(Root,_,_,_), Nodes0, Nodes, Before,
           Built0, Built) :-
    Before = built(_, _, _, Facts0, _),
    Built0 = built(_, _, _, Facts1, _),
    append(New, Facts0, Facts1),
    (   Side == below
    ->  Half = plane(A,B,C,D)
    ;   maplist(negative, [A,B,C,D], [A1,B1,C1,D1]),
        Half = plane(A1,B1,C1,D1)
    ),
    facts_box(New, Box),
    half_leaf(Half, Box, What),
    (   What == all
    ->  Nodes0 = [node(intersection,0)|Nodes],
        Built = Built0
    ;   What == none
    ->  Nodes0 = [node(union,0)|Nodes],
        Built = Built0
    ;   Built0 = built(Number, Place, Leaves, _, Roots),
        Next is Number+1,
        NextPlace is Place+1,
        Nodes0 = [node(leaf,Place)|Nodes],
        part_fact(What, Number, Fact),
        Built = built(Next, NextPlace,
                      [leaf(Number,Root,0,Half,[1-cut])|Leaves],
                      [Fact|Facts1], Roots)
    ).

negative(X, Y) :-
    Y is -X.

facts_box(Facts, Box) :-
    identity_rows(Matrix),
    (   shading_box(frame(Matrix,1,1,0.0), Facts, Box0)
    ->  Box = Box0
    ;   Box = box(0.0,0.0,0.0,0.0,0.0,0.0)
    ).

identity_rows([ 1.0,0.0,0.0,0.0, 0.0,1.0,0.0,0.0, 0.0,0.0,1.0,0.0,
                0.0,0.0,0.0,1.0 ]).


                /*******************************
                *             EYES             *
                *******************************/

%!  shaded_eye(+Model, +View, -Eye) is det.
%
%   Eye is eye(Theta, Phi, Rho, Kind, Nearest) for View = view(Theta, Phi, Rho,
%   Kind) as current_view/4 has it. Nearest is how far the nearest point of
%   Model is from the eye along its line of sight: what is there is shown in its
%   own size. Parallel: 1.0.
%
%   @error geometry_error(eye_in_model(Nearest))

shaded_eye(Model, view(Theta,Phi,Rho,Kind), Eye) :-
    Eye = eye(Theta,Phi,Rho,Kind,Nearest),
    (   Kind == parallel
    ->  Nearest = 1.0
    ;   Model = model(_, Facts, _),
        eye_rows(eye(Theta,Phi,Rho,parallel,1.0), place(1.0,0.0,0.0), Matrix),
        shading_box(frame(Matrix,1,1,0.0), Facts, box(_,_,Z,_,_,_))
    ->  Nearest is Z+Rho,
        (   Nearest > 0.0
        ->  true
        ;   throw(error(geometry_error(eye_in_model(Nearest)), _))
        )
    ;   Nearest = 1.0
    ).

%!  shaded_box(+Model, +Eye, -Box) is semidet.
%
%   Box is b(X1,Y1,X2,Y2), in the axes of screen/5 (Y up): where Model is in the
%   picture. Fails if it has no faces.

shaded_box(model(_, Facts, _), Eye, b(X1,Y1,X2,Y2)) :-
    eye_rows(Eye, place(1.0,0.0,0.0), Matrix),
    shading_box(frame(Matrix,1,1,0.0), Facts, box(X1,Y3,_,X2,Y4,_)),
    Y1 is -Y4,
    Y2 is -Y3.

%!  shaded_scene(+Model, +Eye, +Place, +Size, -Scene) is det.
%
%   Scene is the picture of Model for Eye, of Size = Width-Height dots. Eye may
%   also be at(Eye1, Point): Eye1 looks at that [X,Y,Z], not at the origin; or
%   rolled(Eye1, Cos, Sin): the picture is turned clockwise by that angle.
%   Place is
%   place(Scale, Left, Top): dots to a unit of the picture, and which of its X
%   and Y the upper left corner has. A scene is scene(Handle, Model, Sight),
%   Handle for the kernel (kernel/shading.pl). It does not follow later changes.

shaded_scene(Model, Eye, Place, Width-Height,
             scene(Handle,Model,sight(Tolerance,Depth,Scale))) :-
    Place = place(Scale,_,_),
    Model = model(_, Facts, Roots),
    eye_rows(Eye, Place, Matrix),
    depth_tolerance(Matrix, Facts, Tolerance),
    eye_depth(Eye, Depth),
    scene_opened(frame(Matrix,Width,Height,Tolerance), Facts, Roots, Handle),
    findall(R, member(root(R,_), Roots), Rs),
    seen_through(Rs, Pairs),
    (   Pairs == []
    ->  true
    ;   shading_let_through(Handle, Pairs)
    ).

%!  seen_through(+Roots:list, -Pairs:list) is det.
%
%   Pairs are Front-Behind, of Roots: what may_hide/2 says that Front does not
%   hide. Each pair is asked once.

seen_through(Roots, Pairs) :-
    (   decision_is_default(may_hide/2)
    ->  Pairs = []
    ;   findall(Front-Behind,
                ( member(Front, Roots), member(Behind, Roots),
                  Front =\= Behind, \+ may_hide(Front, Behind) ),
                Pairs)
    ).

%!  scene_opened(+Frame, +Facts, +Roots, -Handle) is det.
%
%   shading_open/4; if a rule says which one of faces that lie in one another is
%   seen, Handle notes what it has to be asked (group_owner.pl).

scene_opened(Frame, Facts, Roots, Handle) :-
    shading_open(Frame, Facts, Roots, Handle),
    (   decision_is_default(owner/3)
    ->  true
    ;   shading_ask_owners(Handle)
    ).

%!  is_shaded(+S) is semidet.
%
%   Segment S is one that a shaded picture shows: a solid, a surface, or a glue
%   with its operands. The rows of a glue alone do not say which of its faces
%   are sheets. An open surface counts as a leaf that the line of sight enters,
%   from either side, and never leaves: right for what is seen first.

is_shaded(S) :-
    segment(S, Kind, Term),
    (   memberchk(Kind, [solid,surface])
    ->  true
    ;   Kind == cells,
        is_node_term(Term)
    ).

%!  shading_scene(+Size, -Scene) is semidet.
%
%   Scene is the picture of the roots of the current world in its view, as large
%   as it fits into Size = Width-Height dots; there slice/3, met/4 and seen_at/4
%   say what is where. Fails if there is nothing to see.

shading_scene(Width-Height, Scene) :-
    must_be(positive_integer, Width),
    must_be(positive_integer, Height),
    findall(S, ( root_segment(S), is_shaded(S) ), Roots),
    shaded_model(Roots, Model),
    current_view(Theta, Phi, Rho, Kind),
    shaded_eye(Model, view(Theta,Phi,Rho,Kind), Eye),
    shaded_box(Model, Eye, b(X1,Y1,X2,Y2)),
    Scale is min(Width/max(X2-X1, 1.0e-300), Height/max(Y2-Y1, 1.0e-300)),
    Left is (X1+X2-Width/Scale)/2.0,
    Top is (Y1+Y2+Height/Scale)/2.0,
    shaded_scene(Model, Eye, place(Scale,Left,Top), Width-Height, Scene).

%!  without_picture(+Model, -Scene) is det.
%
%   Scene has the roots and leaves of Model, and no picture.

without_picture(Model, scene(none,Model,none)).

%!  scene_handle(+Scene, -Handle) is det.
%!  scene_tolerance(+Scene, -Tolerance) is det.
%
%   Tolerance, in dots: slices nearer in depth are in one place.

%!  other_sight(+Scene0, +Handle, +Tolerance, -Scene) is det.
%
%   Scene is another picture, Handle for the kernel, of the model of Scene0.

other_sight(scene(_, Model, _), Handle, Tolerance,
            scene(Handle,Model,sight(Tolerance,none,none))).

scene_handle(scene(Handle, _, _), Handle).
scene_tolerance(scene(_, _, sight(Tolerance,_,_)), Tolerance).

%!  scene_depth(+Scene, -Plane) is det.
%
%   Plane is [A, B, C, D]: a point of the model is A*X + B*Y + C*Z + D from the
%   eye the way that it looks, in a parallel picture from the origin.

scene_depth(scene(_, _, sight(_,Plane,_)), Plane).

%!  scene_model(+Scene, -Model) is det.
%!  scene_scale(+Scene, -Scale) is det.
%
%   What Scene is the picture of, and how many dots are a unit of the picture.

scene_model(scene(_, Model, _), Model).
scene_scale(scene(_, _, sight(_,_,Scale)), Scale).

eye_depth(Eye, [A,B,C,D]) :-
    eye_axes(Eye, eye(_,_,Rho,Kind,_), [_,_,[A,B,C,D0]]),
    (   Kind == central
    ->  D is D0+Rho
    ;   D = D0
    ).

%!  scene_size(+Scene, -Size) is det.
%
%   Size is Width-Height, in dots.

scene_size(scene(Handle, _, _), Width-Height) :-
    shading_size(Handle, Width, Height).

%!  scene_root(+Scene, -Root) is nondet.
%
%   Root is root(R, Nodes) of the kernel: segment R, and its tree.
%
%   @error instantiation_error: of what is no scene, each root would be one

scene_root(scene(_, model(_, _, Roots), _), Root) :-
    must_be(list, Roots),
    member(Root, Roots).

%!  scene_place(+Scene, ?Place) is nondet.
%
%   Place is place(I, R, Number): the I-th leaf of the kernel is one of leaf
%   Number, of root R.

scene_place(scene(_, model(Leaves, Facts, _), _), place(I,R,Number)) :-
    nth1(I, Facts, Fact),
    arg(1, Fact, Number),
    memberchk(leaf(Number,R0,_,_,_), Leaves),
    R = R0.

%!  scene_leaf(+Scene, ?Leaf) is nondet.
%
%   Leaf is leaf(Number, Root, S, Term, Faces), by Number.

scene_leaf(scene(_, model(Leaves, _, _), _), Leaf) :-
    member(Leaf, Leaves).

%!  named_face(+F, +Faces, -Face) is det.
%
%   The face F of a leaf(Number, Root, S, Term, Faces) is Face.

named_face(F, Faces, Face) :-
    (   memberchk(F-Face0, Faces)
    ->  Face = Face0
    ;   Face = polygon(F)
    ).

%!  facts_dots(+Eye, +Place, +Size, +Facts, -Box) is semidet.
%
%   What Facts are in the picture of shaded_scene/5 is in Box = b(X1,Y1,X2,Y2),
%   in dots. Fails if they have no faces.

facts_dots(Eye, Place, Width-Height, Facts, b(X1,Y1,X2,Y2)) :-
    eye_rows(Eye, Place, Matrix),
    shading_box(frame(Matrix,Width,Height,0.0), Facts, box(X1,Y1,_,X2,Y2,_)).

%!  depth_tolerance(+Matrix, +Facts, -Tolerance) is det.
%
%   Tolerance, in dots, is 2^-44 of the farthest place, as resolve.h; but no
%   less than what is rounded.

depth_tolerance(Matrix, Facts, Tolerance) :-
    (   shading_box(frame(Matrix,1,1,0.0), Facts, Box)
    ->  Box =.. [_|Numbers],
        foldl(larger, Numbers, 1.0, Farthest)
    ;   Farthest = 1.0
    ),
    Tolerance is Farthest*2.0** -40.

larger(X, Most0, Most) :-
    Most is max(abs(X), Most0).
