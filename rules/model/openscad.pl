:- module(sg_openscad,
          [ read_csg/2,                 % +File, -Term
            term_looks/2                % +Term, -Looks
          ]).
:- use_module('../limits', [within_limit/3]).
:- use_module(openscad_argument, [openscad_argument/4, openscad_error/2]).
:- use_module(openscad_extrusion, [linear_extruded/3, rotate_extruded/3]).
:- use_module(openscad_leaf, [openscad_leaf/2, leaf_made/2]).
:- use_module(openscad_text, [read_openscad/2]).
:- use_module('../primitive/placing', [step_motion/2]).
:- use_module('../polygon/region', [region_moved/3]).
:- use_module(library(apply),
              [exclude/3, foldl/4, foldl/5, maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> OpenSCAD .csg files: what they mean.

A file becomes one term of the CSG tree: union/1, difference/1, intersection/1
of at(Steps, Operand), operations and primitives, the same polyhedra as
OpenSCAD makes (openscad_leaf.pl). A node is one of

    nothing             an empty group, a cube of size 0
    solid(Term)
    plane(Region)       square, circle, polygon and what is made of them
                        (region.pl); linear_extrude and rotate_extrude make
                        solids of it

The outermost colour of a solid is its name, colour(rgb(R,G,B)), or, of what is
see-through, colour(rgb(R,G,B),A), from which term_looks/2 has it; convexity is
passed over. A solid with the modifier `#` is half see-through: without a colour
its name is opacity(0.5). What has `*` or `%` is not part of the model, and
where a node has `!` it is all of it.

Errors are error(model_error(openscad(What)), location(File, Line, Column)),
with What as in openscad_text.pl and openscad_argument.pl, or

    unsupported(Name, Names)   OpenSCAD has it, this reader has not
    unknown(Name, Names)       nobody has it; Names are those that are known
    flat                       the model is a drawing in the plane
    mixed(Name)                solids and plane figures under one node
    flat_extrusion(Name)       an extrusion of solids
    nothing                    there is nothing in the model
*/

%!  read_csg(+File, -Term) is det.
%
%   Term is the model in the .csg File of OpenSCAD (`-`: standard input), as an
%   operand of the CSG tree.
%
%   @error model_error(openscad(What)), see above;
%   model_error(limit(nodes, Leaves, Most))

read_csg(File, Term) :-
    read_openscad(File, Nodes0),
    place_of(Nodes0, File, Place),
    model_nodes(Nodes0, Nodes),
    foldl(node_leaves, Nodes, 0, Leaves),
    within_limit(nodes, Leaves, location(File, 0, 0)),
    united(node([], group, [], Nodes, Place), Meaning),
    (   Meaning = solid(Term0)
    ->  Term = Term0
    ;   Meaning = plane(_)
    ->  openscad_error(flat, Place)
    ;   openscad_error(nothing, location(File, 0, 0))
    ).

place_of([node(_, _, _, _, Place)|_], _, Place) :-
    !.
place_of([], File, location(File, 0, 0)).

%   model_nodes(Nodes0, Nodes): those that are part of the model.

model_nodes(Nodes0, Nodes) :-
    (   root_node(Nodes0, Root)
    ->  Nodes = [Root]
    ;   Nodes = Nodes0
    ).

%   root_node(Nodes, Root): the first with `!`, outside what `*` takes away.

root_node(Nodes, Root) :-
    member(Node, Nodes),
    Node = node(Modifiers, _, _, Children, _),
    \+ memberchk(*, Modifiers),
    (   memberchk(!, Modifiers)
    ->  Root = Node
    ;   root_node(Children, Root)
    ),
    !.

%   node_leaves(Node, Count0, Count): Count is Count0 and how many leaves Node
%   has, as written; what is extruded is one.

node_leaves(Node, Count0, Count) :-
    (   is_no_part(Node)
    ->  Count = Count0
    ;   Node = node(_, Name, _, Children, _),
        is_inner(Name)
    ->  foldl(node_leaves, Children, Count0, Count)
    ;   Count is Count0+1
    ).

is_inner(Name) :-
    inner_node(Name, Goal),
    Goal \= extruded(_).

is_no_part(node(Modifiers, _, _, _, _)) :-
    \+ memberchk(!, Modifiers),
    ( memberchk(*, Modifiers) ; memberchk('%', Modifiers) ),
    !.


                /*******************************
                *           THE TREE           *
                *******************************/

%   meaning(Node, Meaning)

meaning(Node, Meaning) :-
    plain_meaning(Node, Meaning0),
    (   Node = node(Modifiers, _, _, _, _),
        memberchk(#, Modifiers),
        Meaning0 = solid(Term0)
    ->  highlighted(Term0, Term),
        Meaning = solid(Term)
    ;   Meaning = Meaning0
    ).

highlighted(Term0, Term) :-
    (   Term0 = named(Name, Inner),
        name_looks(Name, Looks)
    ->  (   memberchk(colour(Colour), Looks)
        ->  Term = named(colour(Colour,0.5), Inner)
        ;   Term = Term0
        )
    ;   Term = named(opacity(0.5), Term0)
    ).

plain_meaning(Node, Meaning) :-
    Node = node(_, Name, _, _, Place),
    (   openscad_leaf(Name, _)
    ->  leaf_made(Node, Meaning)
    ;   inner_node(Name, Goal)
    ->  call(Goal, Node, Meaning)
    ;   findall(Known, known_node(Known), Names),
        (   other_node(Name)
        ->  openscad_error(unsupported(Name, Names), Place)
        ;   openscad_error(unknown(Name, Names), Place)
        )
    ).

inner_node(group, united).
inner_node(union, united).
inner_node(color, coloured).
inner_node(render, united).
inner_node(difference, subtracted).
inner_node(intersection, intersected).
inner_node(multmatrix, moved).
inner_node(linear_extrude, extruded(linear_extruded)).
inner_node(rotate_extrude, extruded(rotate_extruded)).

known_node(Name) :-
    inner_node(Name, _).
known_node(Name) :-
    openscad_leaf(Name, _).

%   other_node(Name): what else OpenSCAD writes.

other_node(Name) :-
    memberchk(Name, [ text, offset, minkowski, hull, import, surface,
                      projection, resize, glide, subdiv, cgaladv, fill,
                      roof, skin, textmetrics ]).

%   operands(Node, Meanings): those of the children, all solid or all plane,
%   except those that are `nothing`.

operands(node(_, Name, _, Children0, _), Meanings) :-
    exclude(is_no_part, Children0, Children),
    maplist(meaning, Children, Meanings),
    foldl(same_dimension(Name), Children, Meanings, nothing, _).

same_dimension(Name, node(_, _, _, _, Place), Meaning, Before, After) :-
    (   Meaning == nothing
    ->  After = Before
    ;   Before == nothing
    ->  After = Meaning
    ;   functor(Meaning, Dimension, 1),
        functor(Before, Dimension, 1)
    ->  After = Before
    ;   openscad_error(mixed(Name), Place)
    ).

united(Node, Meaning) :-
    operands(Node, Meanings0),
    exclude(==(nothing), Meanings0, Meanings),
    joined(Meanings, Meaning).

joined([], nothing).
joined([Meaning], Meaning) :-
    !.
joined(Meanings, Meaning) :-
    operation(union, Meanings, Meaning).

%   coloured(Node, Meaning): colours within a colour do not count.

coloured(Node, Meaning) :-
    united(Node, Meaning0),
    (   Meaning0 = solid(Term0),
        node_colour(Node, Colour)
    ->  coloured_term(Term0, Colour, Term),
        Meaning = solid(Term)
    ;   Meaning = Meaning0
    ).

coloured_term(Term0, Colour0, named(Colour,Term)) :-
    uncoloured(Term0, Term1),
    (   Term1 = named(opacity(A), Term)
    ->  arg(1, Colour0, RGB),
        Colour = colour(RGB,A)
    ;   Term = Term1,
        Colour = Colour0
    ).

%   node_colour(Node, Colour): fails of one that OpenSCAD does not know, which
%   it writes as numbers below 0.

node_colour(node(_, _, Arguments, _, _), Colour) :-
    memberchk(1-[R0,G0,B0|Alpha], Arguments),
    maplist(colour_byte, [R0,G0,B0], [R,G,B]),
    (   Alpha = [A],
        number(A),
        A >= 0,
        A < 1
    ->  Colour = colour(rgb(R,G,B),A)
    ;   Colour = colour(rgb(R,G,B))
    ).

colour_byte(Part, Byte) :-
    number(Part),
    Part >= 0,
    Byte is min(255, round(Part*255)).

uncoloured(named(opacity(A), Term0), named(opacity(A), Term)) :-
    !,
    uncoloured(Term0, Term).
uncoloured(named(Name, Term0), Term) :-
    name_looks(Name, _),
    !,
    uncoloured(Term0, Term).
uncoloured(at(Steps, Term0), at(Steps, Term)) :-
    !,
    uncoloured(Term0, Term).
uncoloured(Term0, Term) :-
    compound(Term0),
    Term0 =.. [Operation,Operands0],
    memberchk(Operation, [union,difference,intersection]),
    !,
    maplist(uncoloured, Operands0, Operands),
    Term =.. [Operation,Operands].
uncoloured(Term, Term).

%!  term_looks(+Term, -Looks) is semidet.
%
%   Looks are the properties of look/2 that a solid of read_csg/2 has, an
%   operand or its name for all.

term_looks(named(Name, Term), Looks) :-
    (   name_looks(Name, Looks0)
    ->  Looks = Looks0
    ;   term_looks(Term, Looks)
    ).
term_looks(at(_, Term), Looks) :-
    term_looks(Term, Looks).

name_looks(colour(Colour), [colour(Colour)]).
name_looks(colour(Colour,A), [colour(Colour),opacity(A)]).
name_looks(opacity(A), [opacity(A)]).

subtracted(Node, Meaning) :-
    operands(Node, Meanings0),
    (   Meanings0 = [First|Rest0],
        First \== nothing
    ->  exclude(==(nothing), Rest0, Rest),
        (   Rest == []
        ->  Meaning = First
        ;   operation(difference, [First|Rest], Meaning)
        )
    ;   Meaning = nothing
    ).

intersected(Node, Meaning) :-
    operands(Node, Meanings),
    (   memberchk(nothing, Meanings)
    ->  Meaning = nothing
    ;   Meanings = [_, _|_]
    ->  operation(intersection, Meanings, Meaning)
    ;   joined(Meanings, Meaning)
    ).

operation(Operation, Meanings, Meaning) :-
    Meanings = [First|_],
    functor(First, Dimension, 1),
    maplist(arg(1), Meanings, Operands),
    Term =.. [Operation, Operands],
    Meaning =.. [Dimension, Term].

extruded(Maker, Node, Meaning) :-
    united(Node, Inner),
    (   Inner = plane(Region)
    ->  call(Maker, Node, Region, Terms),
        maplist(as_solid, Terms, Solids),
        joined(Solids, Meaning)
    ;   Inner == nothing
    ->  Meaning = nothing
    ;   Node = node(_, Name, _, _, Place),
        openscad_error(flat_extrusion(Name), Place)
    ).

as_solid(Term, solid(Term)).


                /*******************************
                *            PLACING           *
                *******************************/

%   moved(Node, Meaning): a matrix that makes things flat leaves nothing.

moved(Node, Meaning) :-
    united(Node, Inner),
    openscad_argument(Node, 1, matrix, Matrix),
    (   Inner = solid(Term)
    ->  solid_moved(Matrix, Term, Meaning)
    ;   Inner = plane(Region)
    ->  plane_moved(Matrix, Region, Meaning)
    ;   Meaning = nothing
    ).

solid_moved([R1, R2, R3], Term, Meaning) :-
    (   linear_part([R1, R2, R3], [[A, 0, 0], [0, B, 0], [0, 0, C]]),
        A =:= 1, B =:= 1, C =:= 1
    ->  last_column([R1, R2, R3], [X, Y, Z]),
        (   X =:= 0, Y =:= 0, Z =:= 0
        ->  Meaning = solid(Term)
        ;   step_added(translate(X, Y, Z), Term, Meaning)
        )
    ;   step_added(matrix([R1, R2, R3]), Term, Meaning)
    ).

linear_part([], []).
linear_part([[A, B, C, _]|Rows], [[A, B, C]|Linear]) :-
    linear_part(Rows, Linear).

last_column([[_, _, _, X], [_, _, _, Y], [_, _, _, Z]], [X, Y, Z]).

step_added(Step, Term, Meaning) :-
    (   step_motion(Step, _)
    ->  (   Term = at(Steps0, Inner)
        ->  append(Steps0, [Step], Steps),
            Meaning = solid(at(Steps, Inner))
        ;   Meaning = solid(at([Step], Term))
        )
    ;   Meaning = nothing
    ).

plane_moved([[A, B, _, C], [D, E, _, F], _], Region, Meaning) :-
    (   rational(A)*rational(E) =:= rational(B)*rational(D)
    ->  Meaning = nothing
    ;   region_moved([[A, B, C], [D, E, F]], Region, Moved),
        Meaning = plane(Moved)
    ).
